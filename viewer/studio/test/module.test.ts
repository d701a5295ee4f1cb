/** The program in a page answers what the program answers. */

import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { EXAMPLES } from "../examples";
import { run, type Outcome } from "../system";

const program = process.env.COFACE_PROGRAM!;
const data = join(import.meta.dirname, "../../../data");
const folder = mkdtempSync(join(tmpdir(), "coface-studio-"));
let module: WebAssembly.Module;

beforeAll(async () => {
  module = await WebAssembly.compile(readFileSync(process.env.COFACE_MODULE!));
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const printed = (outcome: Outcome) => new TextDecoder().decode(outcome.stdout);

/** What the program prints in the folder, on both outputs, and its status. */
function native(words: string[]): { status: number | null; stdout: string; stderr: string } {
  const { status, stdout, stderr } = spawnSync(program, words, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
  return { status, stdout, stderr };
}

async function expectSame(words: string[], files: [string, Uint8Array][]): Promise<void> {
  for (const [name, bytes] of files) writeFileSync(join(folder, name), bytes);
  const outcome = await run(module, { words, files });
  expect({ status: outcome.status, stdout: printed(outcome), stderr: outcome.stderr }).toEqual(native(words));
}

const shipped = readdirSync(data).filter((name) => /\.(obj|off|mesh|msh|vtk)$/.test(name));

describe.each(shipped)("%s", (name) => {
  const files: [string, Uint8Array][] = [[name, readFileSync(join(data, name))]];
  test.each([["info"], ["info", "--json"], ["homology", "--generators", "--json"], ["pi1"], ["boundary", "--json"]])("%s %s", async (...words) => {
    await expectSame([words[0], name, ...words.slice(1)], files);
  });
});

describe("examples", () => {
  const all = EXAMPLES.flatMap(({ examples }) => examples);
  test("are thirty", () => expect(all.length).toBeGreaterThanOrEqual(30));
  test.each(all.map((example) => [example.title, example] as const))("%s", async (_, { name, from }) => {
    let files: [string, Uint8Array][];
    if (typeof from === "string") files = [[name, new TextEncoder().encode(from)]];
    else {
      const made = await run(module, { words: from, files: [] });
      expect(made.status, made.stderr).toBe(0);
      files = [...made.files];
      execFileSync(program, from, { cwd: folder, stdio: "ignore" });
      expect(Buffer.from(made.files.get(name)!).equals(readFileSync(join(folder, name)))).toBe(true);
    }
    await expectSame(["info", name, "--json"], files);
  });
});

describe("wrong input", () => {
  test.each([
    ["a face beyond the vertices", "bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"],
    ["no model", "bad.json", "{}"],
    ["an empty file", "empty.off", ""],
  ])("%s", async (_, name, text) => {
    await expectSame(["info", name], [[name, new TextEncoder().encode(text)]]);
  });
  test("unknown words", () => expectSame(["homolgy", "x.off"], []));
  test("a file that is not there", () => expectSame(["info", "nowhere.off"], []));
});

test("files that are written are replaced as a whole, and none is left over", async () => {
  const first = await run(module, { words: ["generate", "torus", "-o", "t.off"], files: [] });
  const second = await run(module, { words: ["convert", "t.off", "-o", "t.obj"], files: first.files });
  const third = await run(module, { words: ["convert", "t.obj", "-o", "t.off"], files: second.files });
  expect([...third.files.keys()].sort()).toEqual(["t.obj", "t.off"]);
});
