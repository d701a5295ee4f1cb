/** The pictures of the README: what a browser makes of them, and the same models in the page. */

import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { close, coface, dataOf, file, meanDifference, open, outlineDifference, pixels, slide, start, stop } from "./harness";

const root = join(import.meta.dirname, "../..");
const commands = readFileSync(join(root, "docs/pictures/commands.txt"), "utf8").trim().split("\n").map((line) => line.split(" ").slice(1));
const kept = (name: string) => join(root, "docs/pictures", name);

/** The command that makes a picture, without the file that it makes. */
function commandOf(name: string): string[] {
  const words = commands.find((words) => words.at(-1) === `docs/pictures/${name}`)!;
  return words.slice(0, -2);
}

beforeAll(async () => {
  mkdirSync(file("data"), { recursive: true });
  mkdirSync(file("docs/pictures"), { recursive: true });
  copyFileSync(join(root, "data/spot.obj"), file("data/spot.obj"));
  for (const name of ["islands.wkt", "plan.wkt"]) copyFileSync(kept(name), file(`docs/pictures/${name}`));
  for (const words of commands) if (words[0] !== "render") coface(...words);
  await start();
});
afterAll(stop);

describe("the pictures of the README in a browser", () => {
  it("are what the program draws, shaded models too", async () => {
    coface("view", "data/spot.obj", "--no-report", "-o", "any.html");
    const opened = await open("any.html");
    for (const name of ["spot.png", "double-torus.png", "klein-bottle.png"]) {
      coface(...commandOf(name), "-o", `${name}.svg`);
      expect(await meanDifference(opened.page, dataOf(kept(name)), dataOf(file(`${name}.svg`))), name).toBeLessThan(3);
    }
    for (const name of ["matrices.svg", "diagram.svg", "forest.svg"]) {
      coface(...commandOf(name), "-o", `${name}.png`);
      expect(await meanDifference(opened.page, dataOf(file(`${name}.png`)), dataOf(kept(name))), name).toBeLessThan(3);
    }
    await close(opened);
  });
});

/** Where the page looks from: far away, as the picture has no perspective, and so much nearer by zooming. */
function lookFrom(direction: number[], away: number, zoom: number): string {
  const length = Math.hypot(...direction);
  return `#camera=${direction.map((x) => (x / length) * away).join(",")}&target=0,0,0&zoom=${zoom}&theme=light`;
}

/** Half the diagonal of the box around a model. */
function radiusOf(name: string): number {
  const rows = readFileSync(file(name), "utf8").split("\n").filter((line) => /^(v )?-?[\d.e+-]+ -?[\d.e+-]+ -?[\d.e+-]+$/.test(line));
  const points = rows.map((line) => line.replace("v ", "").split(" ").map(Number));
  return Math.hypot(...[0, 1, 2].map((axis) => Math.max(...points.map((p) => p[axis])) - Math.min(...points.map((p) => p[axis])))) / 2;
}

describe("the models of the pictures in the page", () => {
  it("have the same outlines from the same place", async () => {
    for (const [model, name, direction] of [
      ["data/spot.obj", "spot.png", [-0.7, 0.35, -1]],
      ["double-torus.obj", "double-torus.png", [0.3, -0.8, 1]],
    ] as const) {
      const with_ = name === "double-torus.png" ? ["--with", "loops.json"] : [];
      coface("view", model, ...with_, "--no-report", "-o", "model.html");
      const away = 60 * radiusOf(model);
      const opened = await open("model.html", lookFrom([...direction], away, 17));
      await slide(opened.page, "clip", 1);
      const share = await outlineDifference(opened.page, null, dataOf(kept(name)));
      expect(share, name).toBeLessThan(0.05);
      // Another direction is another outline.
      const other = await open("model.html", lookFrom([direction[2], direction[0], direction[1]], away, 17));
      expect(await outlineDifference(other.page, null, dataOf(kept(name))), name).toBeGreaterThan(share + 0.02);
      if (name === "double-torus.png") expect(await pixels(opened.page, "#d55e00")).toBeGreaterThan(30);
      await close(other);
      await close(opened);
    }
  });
});
