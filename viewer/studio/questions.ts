/** What can be asked of a model: in plain words, as words of the program, and as Python. */

export interface Question {
  /** The question in plain words. */
  title: string;
  /** What the answer says. */
  about: string;
  /** How many models it is about: the one that is chosen, and others if there are more. */
  models: 1 | 2;
  /** The words of the program, for the names of the models. */
  words: (...names: string[]) => string[];
  /** The same in Python, where `x` (and `y`) are the models that were read; the package does not have everything. */
  python?: string;
  /** The answer can be shown over the model. */
  isLayer?: boolean;
  /** The answer is a new model of this name. */
  makes?: string;
}

export const QUESTIONS: Question[] = [
  {
    title: "What is it, and what is wrong with it?",
    about: "counts, pieces, manifold or not, boundary, genus, homology, and every fault with its place",
    models: 1,
    words: (x) => ["info", x],
    python: "print(x.report())",
  },
  {
    title: "How many pieces, loops and cavities?",
    about: "integral homology with torsion, and short cycles that generate it",
    models: 1,
    words: (x) => ["homology", x, "--generators"],
    python: "print(coface.homology(x, generators=True))",
    isLayer: true,
  },
  {
    title: "Which loops are there, up to deformation?",
    about: "the fundamental group of each component, and its name where one is proved",
    models: 1,
    words: (x) => ["pi1", x],
    python: "print(coface.pi1(x))",
  },
  {
    title: "Loops that generate this group",
    about: "closed paths on the edges",
    models: 1,
    words: (x) => ["loops", x],
    python: "print([group.loops for group in coface.pi1(x)])",
    isLayer: true,
  },
  {
    title: "Cut it open to a disk",
    about: "the cut graph: which edges are in the tree, in the cotree, and in neither",
    models: 1,
    words: (x) => ["cut", x, "--roles"],
    python: "print(coface.cut(x))",
    isLayer: true,
  },
  {
    title: "Unroll it: the universal cover",
    about: "as many copies as there is room for",
    models: 1,
    words: (x) => ["cover", x, "--copies", "25"],
    python: "print(coface.cover(x, copies=25))",
    isLayer: true,
  },
  {
    title: "Numbers on edges that sum to zero around each face",
    about: "a basis of the first cohomology",
    models: 1,
    words: (x) => ["cocycles", x],
    python: "print(coface.cohomology(x, generators=True))",
    isLayer: true,
  },
  {
    title: "What is born and dies with growing height?",
    about: "persistent homology of the last coordinate, or of the numbers of the vertices where there are none",
    models: 1,
    words: (x) => ["persistence", x],
    python: "print(coface.persistence(x, x.vertices[:, -1]))",
    isLayer: true,
  },
  {
    title: "Cut the plane or space into cells",
    about: "the arrangement of all lines or faces of the model",
    models: 1,
    words: (x) => ["arrange", x, "-o", "cells.json"],
    python: "print(coface.arrange(x))",
    makes: "cells.json",
  },
  ...(["union", "intersection", "difference", "xor"] as const).map((operation): Question => ({
    title: { union: "Unite two", intersection: "What two have in common", difference: "The first without the second", xor: "What is in one of two only" }[operation],
    about: "exactly; of regions in the plane, or of solids",
    models: 2,
    words: (x, y) => ["boolean", operation, x, y, "-o", `${operation}.json`],
    python: `print(coface.boolean("${operation}", x, y))`,
    makes: `${operation}.json`,
  })),
  {
    title: "Its area, holes and curves",
    about: "of a set with curved boundaries: which curves lie in which",
    models: 1,
    words: (x) => ["yin", "info", x],
    python: "print(coface.YinSet.read(path))",
  },
  {
    title: "Its dual mesh",
    about: "a vertex for each face, a face for each vertex",
    models: 1,
    words: (x) => ["convert", x, "--dual", "-o", "dual.obj"],
    makes: "dual.obj",
  },
];

/** A word as a shell reads it. */
export function quoted(word: string): string {
  return /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;
}

export function commandOf(words: string[]): string {
  return ["coface", ...words].map(quoted).join(" ");
}

export function pythonOf({ python }: Question, names: string[]): string | null {
  if (python === undefined) return null;
  const read = names.map((name, i) => `${"xy"[i]} = coface.read(${JSON.stringify(name)})\n`);
  const text = python.replace("path", JSON.stringify(names[0]));
  return `import coface\n\n${python.includes("path") ? "" : read.join("")}${text}\n`;
}

/** The words that a line has, as a shell cuts it: by blanks, with quotes. Null where a quote does not end. */
export function wordsOf(line: string): string[] | null {
  const words: string[] = [];
  let word: string | null = null;
  let quote: string | null = null;
  for (const character of line) {
    if (quote !== null) {
      if (character === quote) quote = null;
      else word += character;
    } else if (character === "'" || character === '"') {
      quote = character;
      word ??= "";
    } else if (/\s/.test(character)) {
      if (word !== null) words.push(word);
      word = null;
    } else word = (word ?? "") + character;
  }
  if (quote !== null) return null;
  if (word !== null) words.push(word);
  return words[0] === "coface" ? words.slice(1) : words;
}
