import { describe, expect, test } from "vitest";
import { folderOf, HeldFile } from "../studio/files";
import { EXAMPLES } from "../studio/examples";
import { commandOf, pythonOf, QUESTIONS, wordsOf } from "../studio/questions";
import { fromFragment, Session, toFragment } from "../studio/session";
import { sidesOf } from "../studio/tables/polygon";

const bytes = (text: string) => new TextEncoder().encode(text);
const text = (content: Uint8Array) => new TextDecoder().decode(content);

describe("files in memory", () => {
  test("what is given is never changed by a write", () => {
    const given = bytes("abc");
    const file = new HeldFile(given);
    file.write(1, bytes("XYZ"));
    expect([text(file.content()), text(given)]).toEqual(["aXYZ", "abc"]);
  });
  test("a write beyond the end fills with zeros, and shortening forgets", () => {
    const file = new HeldFile();
    file.write(2, bytes("x"));
    expect([...file.content()]).toEqual([0, 0, 120]);
    file.resize(1);
    file.resize(3);
    expect([...file.content()]).toEqual([0, 0, 0]);
  });
  test("paths", () => {
    const root = folderOf([["a/b/c.off", bytes("1")], ["d", bytes("2")]]);
    expect(root.find("./a/b/../b/c.off")?.node?.kind).toBe("file");
    expect(root.find("a/x/c.off")).toBeNull();
    expect(root.find("../../d")?.node?.kind).toBe("file");
    expect([...root.files()].map(([path]) => path)).toEqual(["a/b/c.off", "d"]);
  });
});

describe("sessions", () => {
  test("names are free, and cannot be taken for options", () => {
    const session = new Session();
    expect(session.add("torus.off", bytes("1"))).toBe("torus.off");
    expect(session.add("torus.off", bytes("2"))).toBe("torus-2.off");
    expect(session.add("--json", bytes("3"))).toBe("json");
    expect(session.add("a b/c.obj", bytes("4"))).toBe("a_b_c.obj");
  });
  test("undo brings back what a step replaced", () => {
    const session = new Session();
    session.add("a.off", bytes("old"));
    session.steps.push({ words: [], question: null, about: "a.off", status: 0, text: "", remarks: "", before: [["a.off", bytes("old")], ["b.off", null]], layer: null });
    session.files.set("a.off", bytes("new"));
    session.add("b.off", bytes("made"));
    session.undo();
    expect([text(session.files.get("a.off")!), session.files.has("b.off"), session.chosen]).toEqual(["old", false, "a.off"]);
  });
  test("a link holds texts and other bytes", async () => {
    const session = new Session();
    session.add("a.off", bytes("OFF\n"));
    session.add("b.stl", new Uint8Array([0, 255, 128]));
    const again = Session.of(await fromFragment(await toFragment(session.toText())));
    expect([...again.files]).toEqual([...session.files]);
  });
  test("what is no session is refused", () => {
    expect(() => Session.of("{}")).toThrow("no saved session");
  });
});

describe("questions", () => {
  test("have words that name the models", () => {
    for (const question of QUESTIONS) expect(question.words("x.off", "y.off")).toContain("x.off");
  });
  test("as a command and as Python", () => {
    expect(commandOf(["info", "it's.off"])).toBe(`coface info 'it'\\''s.off'`);
    expect(pythonOf(QUESTIONS[0], ["a.off"])).toBe('import coface\n\nx = coface.read("a.off")\nprint(x.report())\n');
  });
  test("lines are cut as a shell does", () => {
    expect(wordsOf(`coface link t.off --simplices "0 1"`)).toEqual(["link", "t.off", "--simplices", "0 1"]);
    expect(wordsOf("info 'a")).toBeNull();
  });
  test("letters of a polygon", () => {
    expect(sidesOf("a b a^-1 b^-1")?.sides).toEqual([1, 2, -1, -2]);
    expect(sidesOf("abAB")?.sides).toEqual([1, 2, -1, -2]);
    expect(sidesOf("a-b")?.sides).toEqual([-1, 2]);
    expect(sidesOf("a 1")).toBeNull();
  });
});

test("there are forty examples with names of their own", () => {
  const names = EXAMPLES.flatMap(({ examples }) => examples.map(({ name }) => name));
  expect(names.length).toBe(40);
  expect(new Set(names).size).toBe(40);
});
