/** A session: the models that are there, and the steps that were done; it can be undone, saved and shared. */

/** One run of the program. */
export interface Step {
  words: string[];
  /** The title of the question, if it was one of those in the page. */
  question: string | null;
  /** The model that was asked about. */
  about: string | null;
  status: number;
  text: string;
  remarks: string;
  /** The files that it wrote or replaced: what was there before, null for nothing. */
  before: [string, Uint8Array | null][];
  /** The file that is shown over the model. */
  layer: string | null;
}

/** What a file or a link of a session holds: texts as they are, other bytes as base64. */
interface Saved {
  coface: 1;
  files: [string, string, "text" | "base64"][];
  steps: Omit<Step, "before">[];
  chosen: string | null;
}

export class Session {
  readonly files = new Map<string, Uint8Array>();
  /** Files that are answers, not models. */
  readonly layers = new Set<string>();
  readonly steps: Step[] = [];
  chosen: string | null = null;

  /** A name that is not taken: torus.off, torus-2.off, .. */
  freeName(name: string): string {
    const clean = name.replaceAll(/[^\w.-]+/g, "_").replace(/^[-.]+/, "") || "model";
    const dot = clean.indexOf(".") < 0 ? clean.length : clean.indexOf(".");
    let found = clean;
    for (let count = 2; this.files.has(found); count++) found = `${clean.slice(0, dot)}-${count}${clean.slice(dot)}`;
    return found;
  }

  models(): string[] {
    return [...this.files.keys()].filter((name) => !this.layers.has(name));
  }

  add(name: string, bytes: Uint8Array): string {
    const free = this.freeName(name);
    this.files.set(free, bytes);
    this.chosen = free;
    return free;
  }

  remove(name: string): void {
    this.files.delete(name);
    this.layers.delete(name);
    if (this.chosen === name) this.chosen = this.models().at(-1) ?? null;
  }

  /** Takes the last step back, with the files that it made. */
  undo(): Step | null {
    const step = this.steps.pop() ?? null;
    for (const [name, bytes] of step?.before ?? []) {
      if (bytes) this.files.set(name, bytes);
      else this.remove(name);
    }
    if (step?.about && this.files.has(step.about)) this.chosen = step.about;
    return step;
  }

  /** The layers over a model: the answers of the steps about it. */
  layersOf(model: string): string[] {
    return this.steps.filter((step) => step.about === model && step.layer !== null && this.files.has(step.layer)).map((step) => step.layer!);
  }

  toText(): string {
    const files = [...this.files].map(([name, bytes]): Saved["files"][number] => {
      try {
        return [name, new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes), "text"];
      } catch {
        return [name, btoa(charactersOf(bytes)), "base64"];
      }
    });
    const steps = this.steps.map(({ before: _, ...step }) => step);
    return JSON.stringify({ coface: 1, files, steps, chosen: this.chosen } satisfies Saved);
  }

  static of(text: string): Session {
    const saved = JSON.parse(text) as Saved;
    if (saved.coface !== 1 || !Array.isArray(saved.files) || !Array.isArray(saved.steps)) throw new Error("this is no saved session of the studio");
    const session = new Session();
    for (const [name, content, kind] of saved.files) {
      const bytes = kind === "base64" ? Uint8Array.from(atob(content), (character) => character.charCodeAt(0)) : new TextEncoder().encode(content);
      session.files.set(name, bytes);
    }
    for (const step of saved.steps) {
      session.steps.push({ ...step, before: [] });
      if (step.layer !== null) session.layers.add(step.layer);
    }
    session.chosen = saved.chosen !== null && session.files.has(saved.chosen) ? saved.chosen : (session.models()[0] ?? null);
    return session;
  }
}

/** Bytes as characters, as functions for base64 want them. */
function charactersOf(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
}

/** A text as part of a link: packed by gzip, as base64 of addresses. */
export async function toFragment(text: string): Promise<string> {
  const packed = new Blob([text]).stream().pipeThrough(new CompressionStream("gzip"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  return btoa(charactersOf(bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export async function fromFragment(fragment: string): Promise<string> {
  const characters = atob(fragment.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(characters, (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
}
