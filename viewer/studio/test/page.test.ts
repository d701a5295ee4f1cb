/** The studio in a browser: what is on screen is what the program says. */

import { afterAll, afterEach, beforeAll, beforeEach, expect, test } from "vitest";
import { chromium, type Browser, type Page } from "playwright-core";
import axe from "axe-core";
import { pathToFileURL } from "node:url";
import { sidesOf } from "../tables/polygon";
import { commandOf, wordsOf } from "../questions";

let browser: Browser;
let page: Page;
let complaints: string[];

beforeAll(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM!, args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
});
afterAll(() => browser.close());

beforeEach(async () => {
  complaints = [];
  page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.on("pageerror", (error) => complaints.push(error.message));
  await page.route(/^https?:/, (route) => {
    complaints.push(`asked for ${route.request().url()}`);
    return route.abort();
  });
  await page.goto(pathToFileURL(process.env.COFACE_STUDIO!).href);
  await page.getByRole("button", { name: "open files" }).waitFor();
});
afterEach(async () => {
  await page.close();
  expect(complaints).toEqual([]);
});

const ask = (name: string) => page.getByRole("button", { name }).first().click();

async function example(title: string): Promise<void> {
  const value = await page.getByRole("option", { name: title, exact: true }).first().getAttribute("value");
  await page.locator("#examples").selectOption(value!);
  await page.locator("iframe").waitFor();
}

test("a torus is shown, reported on, and its loops are a layer", async () => {
  await example("torus");
  await ask("What is it, and what is wrong with it?");
  const report = page.locator("article pre").first();
  await expect.poll(() => report.textContent()).toContain("H_1 = Z^2");
  await ask("How many pieces, loops and cavities?");
  await page.locator("article", { hasText: "--generators" }).waitFor();
  const frame = page.frameLocator("iframe");
  await expect.poll(() => frame.locator("#panel").textContent()).toContain("H1");
  // Within the studio the view has no address that could be shared.
  await expect.poll(() => frame.getByRole("button", { name: "PNG" }).count()).toBe(1);
  await expect(frame.getByRole("button", { name: "share" }).count()).resolves.toBe(0);
  await frame.locator("#canvas").press("l");
});

test("a step is undone, and the session is shared by a link", async () => {
  await example("projective plane, 6 vertices");
  await ask("What is it, and what is wrong with it?");
  await expect.poll(() => page.locator("article").count()).toBe(2);
  await page.getByRole("button", { name: "undo" }).click();
  await expect.poll(() => page.locator("article").count()).toBe(1);
  await page.getByRole("button", { name: "share" }).click();
  await expect.poll(() => page.url()).toContain("#");
  const address = page.url();
  await page.goto("about:blank");
  await page.goto(address);
  await expect.poll(() => page.locator("#list").textContent()).toContain("rp2.json");
});

test("two regions have a Boolean", async () => {
  await example("star that crosses itself");
  await example("square with a hole");
  await ask("Unite two");
  await expect.poll(() => page.locator("#list").textContent()).toContain("union.json");
  expect(await page.locator("article.failed").count()).toBe(0);
});

test("any words run, and faults are said", async () => {
  await example("torus");
  await page.locator("#line").fill("link torus.off --simplices 0");
  await page.getByRole("button", { name: "run" }).click();
  await expect.poll(() => page.locator("article").first().textContent()).toContain("link");
  await page.locator("#line").fill("info nowhere.off");
  await page.getByRole("button", { name: "run" }).click();
  await expect.poll(() => page.locator("article.failed").first().textContent()).toContain("nowhere.off");
});

test("segments: a fourth cell where a segment crosses the square", async () => {
  await page.getByRole("button", { name: "segments to cells" }).click();
  const facts = page.locator("#table .facts");
  await expect.poll(() => facts.textContent()).toContain("bounded cells");
  const before = Number(/(\d+) bounded/.exec((await facts.textContent())!)![1]);
  const box = (await page.locator("#table svg").boundingBox())!;
  const scale = Math.min(box.width / 10, box.height / 8);
  const at = (x: number, y: number): [number, number] => [box.x + box.width / 2 + (x - 5) * scale, box.y + box.height / 2 + (y - 4) * scale];
  await page.mouse.move(...at(0.5, 3.1));
  await page.mouse.down();
  await page.mouse.move(...at(9.5, 3.2), { steps: 4 });
  await page.mouse.up();
  await expect.poll(async () => Number(/(\d+) bounded/.exec((await facts.textContent())!)![1])).toBeGreaterThan(before);
});

test("curved sets: two sets that meet are one, and their difference too", async () => {
  await page.getByRole("button", { name: "curved sets" }).click();
  const facts = page.locator("#table .facts");
  await expect.poll(() => facts.textContent()).toContain("a join b: 1 component, 0 holes");
  await page.locator("#table").getByRole("button", { name: "meet" }).click();
  await expect.poll(() => facts.textContent()).toContain("a meet b: 1 component");
});

test("a polygon glued by a a is the projective plane", async () => {
  await page.getByRole("button", { name: "glue a polygon" }).click();
  const facts = page.locator("#table .facts");
  await expect.poll(() => facts.textContent()).toContain("A torus");
  await page.getByLabel("the letters of the sides").fill("a a");
  await expect.poll(() => facts.textContent()).toContain("projective plane");
});

test("an edge is flipped by the keyboard, and the permutations follow", async () => {
  await page.getByRole("button", { name: "halfedges" }).click();
  const facts = page.locator("#table .facts");
  await expect.poll(() => facts.textContent()).toContain("next of twin");
  const before = await facts.textContent();
  await page.getByLabel("edge 1 4").focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => facts.textContent()).not.toBe(before);
  await page.getByLabel("edge 0 2").waitFor({ state: "attached" });
});

test("levels: three dips are three pieces before they meet", async () => {
  await page.getByRole("button", { name: "levels and persistence" }).click();
  const facts = page.locator("#table .facts");
  await page.getByRole("slider", { name: "level" }).fill("-0.8");
  await expect.poll(() => facts.textContent()).toContain("3 pieces, 0 holes");
});

test("solids and covers show the page of the program", async () => {
  await page.getByRole("button", { name: "two solids" }).click();
  await expect.poll(() => page.locator("#table .facts").textContent()).toContain("volume 0.95");
  await page.getByRole("button", { name: "pull a cover" }).click();
  await expect.poll(() => page.locator("#table .facts").textContent()).toContain("copies");
});

test("the page is accessible", async () => {
  await example("torus");
  await page.evaluate(axe.source);
  const found = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: typeof import("axe-core") };
    const { violations } = await axe.run({ exclude: ["iframe"] }, { runOnly: ["wcag2a", "wcag2aa"] });
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(", ")}`);
  });
  expect(found).toEqual([]);
});

test("words and letters are read", () => {
  expect(wordsOf(`coface link torus.off --simplices "0 1"`)).toEqual(["link", "torus.off", "--simplices", "0 1"]);
  expect(wordsOf("a 'b")).toBeNull();
  expect(commandOf(["info", "a b.off"])).toBe("coface info 'a b.off'");
  expect(sidesOf("a b a^-1 B")?.sides).toEqual([1, 2, -1, -2]);
  expect(sidesOf("1")).toBeNull();
});
