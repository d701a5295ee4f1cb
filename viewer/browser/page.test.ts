import { readFileSync, writeFileSync } from "node:fs";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { answer, close, coface, difference, faultsOfAccess, file, open, picture, pixels, pixelsOf, settle, slide, start, stop } from "./harness";

const ORANGE = "#d55e00";
/** Selections and links have colors that no layer has. */
const VIOLET = "#7a2cf5";
const LIME = "#76b900";

/** A cube of side 2 as six squares. */
function cube(low: number): string {
  const corners = [...Array(8).keys()].map((i) => [0, 1, 2].map((axis) => low + 2 * ((i >> axis) & 1)).join(" "));
  const faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "2 4 8 6", "4 3 7 8", "3 1 5 7"];
  return [...corners.map((corner) => `v ${corner}`), ...faces.map((face) => `f ${face}`)].join("\n") + "\n";
}

beforeAll(async () => {
  coface("generate", "genus", "-o", "two.obj");
  answer("generators.json", "homology", "two.obj", "--generators");
  coface("view", "two.obj", "--with", "generators.json", "-o", "two.html");
  await start();
});
afterAll(stop);

describe("a surface of genus 2 with its generators", () => {
  it("opens from disk without a network", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    expect(await page.title()).toBe("two.obj");
    expect(await page.locator("h1").first().textContent()).toBe("two.obj");
    const report = await page.locator("#panel dl").last().innerText();
    expect(report).toContain("double torus");
    expect(report).toMatch(/H1\s+Z\^4/);
    expect(await page.locator("[data-layer^='H1 generator']").count()).toBe(4);
    await close(opened);
  });

  it("shows and hides a generator in its color", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    await page.getByRole("button", { name: "none", exact: true }).first().click();
    expect(await pixels(page, ORANGE)).toBe(0);
    await page.locator("[data-layer='H1 generator 1']").check();
    const seen = await pixels(page, ORANGE);
    expect(seen).toBeGreaterThan(150);
    // Zoomed to, it is larger.
    await page.getByTitle("look at H1 generator 1").click();
    expect(await pixels(page, ORANGE)).toBeGreaterThan(seen);
    await page.locator("[data-layer='H1 generator 1']").uncheck();
    expect(await pixels(page, ORANGE)).toBe(0);
    await close(opened);
  });

  it("says to the page that it stands in which cells are selected", async () => {
    file("frame.html", `<!doctype html><title>frame</title><iframe src="two.html" width="900" height="600"></iframe><pre id="told"></pre>
      <script>window.addEventListener("message", (event) => { document.querySelector("#told").textContent = JSON.stringify(event.data); })</script>`);
    const opened = await open("frame.html", "", {}, false);
    const { page } = opened;
    const inner = page.frameLocator("iframe");
    await inner.getByRole("button", { name: "vertex", exact: true }).click();
    await inner.getByLabel("its number").fill("7");
    await inner.getByLabel("its number").press("Enter");
    await page.locator("#told:not(:empty)").waitFor();
    expect(await page.locator("#told").textContent()).toBe('{"coface":"selection","cells":[{"dimension":0,"vertices":[7]}]}');
    await close(opened);
  });

  it("tells the link of a vertex as the program does", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    await page.getByRole("button", { name: "vertex", exact: true }).click();
    const frame = (await page.locator("#canvas").boundingBox())!;
    await page.mouse.click(frame.x + frame.width * 0.5, frame.y + frame.height * 0.5);
    await page.getByRole("button", { name: "selection", exact: true }).click();
    const selected = (await page.locator("[data-cells='selection']").textContent())!;
    const vertex = /^\{(\d+)\}$/.exec(selected)?.[1];
    expect(vertex, selected).toBeDefined();
    for (const [word, verb] of [["link", "link"], ["star", "star"], ["closure", "closure"]]) {
      await page.getByRole("button", { name: word, exact: true }).click();
      const text = (await page.locator(`[data-cells='${word}']`).textContent())!;
      const shown = [...text.matchAll(/\{([^}]*)\}/g)].map((match) => match[1].split(", ").map(Number));
      const told = answer("told.json", verb, "two.obj", "--simplices", vertex!).simplices as number[][];
      const sorted = (cells: number[][]) => cells.map((cell) => JSON.stringify(cell)).sort();
      expect(sorted(shown)).toEqual(sorted(told));
      expect(shown.length).toBeGreaterThan(0);
    }
    await page.getByRole("button", { name: "link", exact: true }).click();
    expect(await pixels(page, LIME)).toBeGreaterThan(50);
    await close(opened);
  });

  it("finds a vertex by its number and says where it is", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    const report = answer("two.json", "info", "two.obj");
    const [vertices, , faces] = report.f_vector as number[];
    const count = (n: number) => n.toLocaleString("en");
    expect(await page.locator("#panel dl").last().innerText()).toContain(`${count(vertices)} vertices, `);
    await page.getByLabel("its number").fill("7");
    await page.keyboard.press("Enter");
    const facts = page.locator("[data-facts='0:7']");
    expect(await facts.innerText()).toMatch(/^vertex 7 at \(\S+, \S+, \S+\)\nin \d+ edges, \d+ faces$/);
    // What is said is what the file has.
    const place = readFileSync(file("two.obj"), "utf8").split("\n").filter((line) => line.startsWith("v "))[7].split(" ").slice(1).map(Number);
    const said = /\((.*)\)/.exec(await facts.innerText())![1].split(", ").map(Number);
    said.forEach((x, axis) => expect(x).toBeCloseTo(place[axis], 4));
    expect(await pixels(page, VIOLET)).toBeGreaterThan(20);
    await page.getByLabel("what to find").selectOption("face");
    await page.getByLabel("its number").fill(String(faces));
    await page.getByRole("button", { name: "go", exact: true }).click();
    expect(await page.locator("#neighborhood [role='status']").innerText()).toBe(`no such face; there are ${count(faces)} faces, counted from 0`);
    await close(opened);
  });

  it("has names for all controls and colors that can be read", async () => {
    for (const colorScheme of ["light", "dark"] as const) {
      const opened = await open("two.html", "", { colorScheme, viewport: { width: 1280, height: 800 } });
      await opened.page.getByLabel("its number").fill("3");
      await opened.page.keyboard.press("Enter");
      expect(await faultsOfAccess(opened.page)).toEqual([]);
      await opened.page.setViewportSize({ width: 390, height: 844 });
      await settle(opened.page);
      expect(await faultsOfAccess(opened.page)).toEqual([]);
      await close(opened);
    }
  });

  it("turns around the axis that is up", async () => {
    coface("convert", "two.obj", "-o", "two.stl");
    coface("view", "two.stl", "-o", "stl.html");
    const opened = await open("stl.html");
    const { page } = opened;
    // Files of machines have z up.
    const z = await picture(page);
    await page.getByRole("button", { name: "z up", exact: true }).click();
    expect((await picture(page)) === z).toBe(false);
    await page.keyboard.press("u");
    expect(await difference(page, z)).toBeLessThan(0.01);
    await close(opened);
  });

  it("draws lines behind the model faintly, and cuts them with it", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    await page.getByRole("button", { name: "none", exact: true }).first().click();
    const bare = await picture(page);
    await page.locator("[data-layer='H1 generator 1']").check();
    // More changes than what is drawn in full color.
    const size = await page.evaluate(() => document.querySelector("canvas")!.width * document.querySelector("canvas")!.height);
    expect((await difference(page, bare)) * size).toBeGreaterThan(await pixels(page, ORANGE));
    await slide(page, "clip", 0);
    expect(await pixels(page, ORANGE)).toBe(0);
    await close(opened);
  });

  it("has the report and a picture without a script, and pictures without WebGL", async () => {
    const plain = await open("two.html", "", { javaScriptEnabled: false }, false);
    expect(await plain.page.locator("article").innerText()).toContain("double torus");
    expect(await plain.page.locator("article figure svg path, article figure img").count()).toBeGreaterThan(0);
    await close(plain);
    const opened = await open("two.html", "", {}, true, () => {
      const original = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
        return kind.startsWith("webgl") ? null : (original as (kind: string, ...rest: unknown[]) => RenderingContext | null).call(this, kind, ...rest);
      } as typeof original;
    });
    const { page } = opened;
    expect(await page.locator("#stills polygon").count()).toBe(100);
    // What the model hides of its loops is faint.
    expect(await page.locator("#stills line[stroke-opacity]").count()).toBeGreaterThan(0);
    const first = await page.locator("#stills").innerHTML();
    await page.keyboard.press("ArrowLeft");
    await settle(page);
    expect((await page.locator("#stills").innerHTML()) === first).toBe(false);
    expect(await page.locator("#panel dl").last().innerText()).toContain("double torus");
    await close(opened);
  });

  it("saves its picture as PNG and SVG", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    await page.getByRole("button", { name: "none", exact: true }).first().click();
    await page.locator("[data-layer='H1 generator 1']").check();
    const [png] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("p")]);
    expect(png.suggestedFilename()).toBe("two.obj.png");
    await png.saveAs(file("saved.png"));
    expect(await pixelsOf(page, file("saved.png"), ORANGE)).toBe(await pixels(page, ORANGE));
    expect(await pixelsOf(page, file("saved.png"), "#ffffff")).toBeGreaterThan(10000);
    const [svg] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("s")]);
    await svg.saveAs(file("saved.svg"));
    const text = readFileSync(file("saved.svg"), "utf8");
    // The generator has four edges, each once more for what the model hides of it; of the triangles all are written.
    expect(text.match(new RegExp(`<line[^>]*stroke="${ORANGE}"`, "g"))?.length).toBe(8);
    expect(text.match(/<polygon/g)?.length).toBe(100);
    await close(opened);
  });

  it("comes back from a link", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    await page.getByRole("button", { name: "none", exact: true }).first().click();
    await page.locator("[data-layer='H1 generator 3']").check();
    for (const key of ["ArrowLeft", "ArrowLeft", "ArrowUp", "+", "c", "[", "[", "d"]) await page.keyboard.press(key);
    const frame = (await page.locator("#canvas").boundingBox())!;
    await page.mouse.click(frame.x + frame.width * 0.5, frame.y + frame.height * 0.5);
    await page.keyboard.press("2");
    await page.keyboard.press("l");
    // The page itself knows its address at once; the driver is told of it later.
    const fragment = await page.evaluate(() => location.hash);
    expect(fragment.length).toBeGreaterThan(20);
    const again = await open("two.html", fragment);
    expect(await again.page.locator("[data-layer='H1 generator 3']").isChecked()).toBe(true);
    expect(await again.page.locator("[data-layer='H1 generator 1']").isChecked()).toBe(false);
    const cells = (from: typeof page) => from.locator("[data-cells='star']").textContent();
    expect(await cells(again.page)).toBe(await cells(page));
    expect(await difference(again.page, await picture(page))).toBeLessThan(0.01);
    await close(again);
    // What an address says that does not fit is left out.
    const odd = await open("two.html", "#select=0:99999|3:0,1,2,3|x&camera=1,2&on=nothing&clip=7&axis=9");
    expect(await odd.page.locator("[data-cells]").count()).toBe(0);
    await close(odd);
    await close(opened);
  });

  it("listens to keys", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    await page.keyboard.press("?");
    expect(await page.locator("dialog.help dt").count()).toBeGreaterThan(10);
    await page.keyboard.press("Escape");
    await page.locator("dialog").waitFor({ state: "detached" });
    const first = await picture(page);
    await page.keyboard.press("e");
    expect((await picture(page)) === first).toBe(false);
    await page.keyboard.press("e");
    await page.keyboard.press("ArrowRight");
    expect((await picture(page)) === first).toBe(false);
    await page.keyboard.press("r");
    await page.keyboard.press("n");
    expect(await page.locator("[data-layer]:checked").count()).toBe(1);
    await page.keyboard.press("r");
    await page.keyboard.press("d");
    expect(await pixels(page, "#15181c")).toBeGreaterThan(1000);
    await close(opened);
  });

  it("follows what the system says about light and dark", async () => {
    const opened = await open("two.html", "", { colorScheme: "dark" });
    expect(await pixels(opened.page, "#15181c")).toBeGreaterThan(10000);
    await close(opened);
  });

  it("is for fingers and telephones", async () => {
    const opened = await open("two.html", "", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    const { page } = opened;
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    const frame = (await page.locator("#canvas").boundingBox())!;
    expect(frame.height).toBeGreaterThan(300);
    const first = await picture(page);
    const [x, y] = [frame.x + frame.width / 2, frame.y + frame.height / 2];
    const session = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", places: number[][]) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
    // Two fingers that go apart look nearer.
    await touch("touchStart", [[x - 20, y], [x + 20, y]]);
    for (let step = 1; step <= 8; step++) await touch("touchMove", [[x - 20 - 6 * step, y], [x + 20 + 6 * step, y]]);
    await touch("touchEnd", []);
    const nearer = await picture(page);
    expect(nearer === first).toBe(false);
    expect(await page.locator("[data-cells]").count()).toBe(0);
    // One finger turns.
    await touch("touchStart", [[x, y]]);
    for (let step = 1; step <= 8; step++) await touch("touchMove", [[x + 8 * step, y]]);
    await touch("touchEnd", []);
    expect((await picture(page)) === nearer).toBe(false);
    // A tap selects.
    await page.keyboard.press("r");
    await page.touchscreen.tap(frame.x + frame.width * 0.5, y);
    await settle(page);
    expect(await page.locator("[data-cells]").count()).toBe(1);
    await close(opened);
  });
});

describe("other models", () => {
  it("takes cells of an arrangement apart and tells their chains", async () => {
    file("a.obj", cube(0));
    file("b.obj", cube(1));
    answer("facts.json", "arrange", "a.obj", "b.obj", "-o", "cells.json");
    coface("view", "cells.json", "--with", "facts.json", "-o", "cells.html");
    const opened = await open("cells.html");
    const { page } = opened;
    const whole = await pixels(page, "#ffffff");
    await slide(page, "explode", 1);
    expect(await pixels(page, "#ffffff")).not.toBe(whole);
    await page.getByRole("button", { name: "cell", exact: true }).click();
    const frame = (await page.locator("#canvas").boundingBox())!;
    // Somewhere there is a cell to be clicked.
    let facts = "";
    for (let i = 1; i < 10 && !facts; i++) {
      await page.mouse.click(frame.x + (frame.width * i) / 10, frame.y + frame.height * 0.5);
      facts = await page.evaluate(() => (document.querySelector("[data-facts]") as HTMLElement | null)?.innerText ?? "");
    }
    expect(facts).toMatch(/cell \d\n/);
    expect(facts).toMatch(/volume [17], inside/);
    expect(facts).toMatch(/boundary: [+-]f\d+ [+-]f\d+/);
    expect(await pixels(page, VIOLET)).toBeGreaterThan(0);
    await slide(page, "explode", 0);
    await page.keyboard.press("Escape");
    expect(await pixels(page, "#ffffff")).toBe(whole);
    // The plane leaves cells out, at last all of them.
    await slide(page, "clip", 0.4);
    expect(await pixels(page, "#ffffff")).toBeGreaterThan(whole);
    await slide(page, "clip", 0);
    const size = await page.evaluate(() => document.querySelector("canvas")!.width * document.querySelector("canvas")!.height);
    expect(await pixels(page, "#ffffff")).toBe(size);
    await close(opened);
  });

  it("cuts and takes apart tetrahedra", async () => {
    coface("generate", "ball", "-o", "ball.mesh");
    coface("view", "ball.mesh", "-o", "ball.html");
    const opened = await open("ball.html");
    const { page } = opened;
    const whole = await picture(page);
    await slide(page, "clip", 0.5);
    const half = await picture(page);
    expect(half === whole).toBe(false);
    await slide(page, "explode", 0.5);
    expect((await picture(page)) === half).toBe(false);
    await close(opened);
  });

  it("cuts a surface by a plane", async () => {
    const opened = await open("two.html");
    const { page } = opened;
    const whole = await pixels(page, "#ffffff");
    await slide(page, "clip", 0.5);
    expect(await pixels(page, "#ffffff")).toBeGreaterThan(1.2 * whole);
    await close(opened);
  });

  it("has the domain and the cover beside the surface", async () => {
    coface("cut", "two.obj", "--simplify", "-o", "cut.json");
    coface("cover", "two.obj", "--radius", "1", "-o", "cover.json");
    coface("view", "two.obj", "--with", "cut.json", "--with", "cover.json", "-o", "cut.html");
    const opened = await open("cut.html");
    const { page } = opened;
    const swatch = await page.locator("li", { hasText: "handle 2" }).locator(".swatch").evaluate((box) => (box as HTMLElement).style.background);
    const side = await page.locator("[data-pane='fundamental domain'] [data-layer='seam 2'] path").first().getAttribute("stroke");
    expect(side).toBe(ORANGE);
    expect(swatch).toBe("rgb(213, 94, 0)");
    const words = await page.locator("[data-pane^='universal cover'] text").allTextContents();
    expect(words).toContain("1");
    expect(words.some((word) => word.includes("\u207b\u00b9"))).toBe(true);
    await page.getByTitle("see the fundamental domain in the whole window").click();
    expect(await page.locator("dialog svg").count()).toBe(1);
    await page.keyboard.press("Escape");
    await page.locator("dialog").waitFor({ state: "detached" });
    await close(opened);
  });

  it("shows a Yin set with its splines, kinks and knots", async () => {
    const curves = [
      { points: [[0, 0], [4, 0], [5, 2], [4, 4], [0, 4]], kinks: [0, 4] },
      { points: [[1, 1], [1, 3], [3, 3], [3, 1]], kinks: [] },
    ];
    file("set.json", JSON.stringify({ order: 4, curves }));
    coface("view", "set.json", "-o", "set.html");
    const opened = await open("set.html");
    const { page } = opened;
    expect(await page.locator("#labels span").allTextContents()).toEqual(["v0", "v1"]);
    expect(await page.locator("[data-pane='Hasse forest'] circle").count()).toBe(3);
    const shown = await picture(page);
    await page.locator("[data-layer='control points']").check();
    expect((await picture(page)) === shown).toBe(false);
    expect(await page.locator("#panel").innerText()).toContain("perimeter");
    await close(opened);
  });

  it("shows volumes by their boundary and says what it invents", async () => {
    // One voxel of 1, as NumPy writes it.
    const header = "{'descr': '|u1', 'fortran_order': False, 'shape': (1, 1, 1), }".padEnd(117) + "\n";
    writeFileSync(file("voxel.npy"), Buffer.concat([Buffer.from([0x93]), Buffer.from("NUMPY\x01\x00"), Buffer.from([118, 0]), Buffer.from(header), Buffer.from([1])]));
    coface("view", "voxel.npy", "-o", "voxel.html");
    const voxel = await open("voxel.html");
    expect(await voxel.page.locator("[data-remark]").allTextContents()).toEqual(["drawn: the 6 squares around the voxels of the volume"]);
    await close(voxel);
    file("facets.json", "[[0,1,2],[2,3]]");
    coface("view", "facets.json", "-o", "facets.html");
    const facets = await open("facets.html");
    expect(await facets.page.locator("[data-remark]").innerText()).toContain("no positions");
    // Controls that do nothing in the plane are not there.
    file("square.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))");
    coface("view", "square.wkt", "-o", "square.html");
    const square = await open("square.html");
    expect(await square.page.locator("#clip").count()).toBe(0);
    expect(await facets.page.locator("#clip").count()).toBe(1);
    await close(facets);
    await close(square);
  });

  it("marks what is wrong in red", async () => {
    file("book.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
    coface("view", "book.obj", "-o", "book.html");
    const opened = await open("book.html");
    expect(await pixels(opened.page, "#d0021b")).toBeGreaterThan(50);
    await close(opened);
  });

  it("draws persistence diagrams", async () => {
    answer("diagram.json", "persistence", "two.obj");
    coface("view", "two.obj", "--with", "diagram.json", "-o", "diagram.html");
    const opened = await open("diagram.html");
    expect(await opened.page.locator("[data-pane='persistence diagram'] circle").count()).toBeGreaterThan(3);
    await close(opened);
  });

  it("is not ended by a name", async () => {
    const name = "</script><script>document.title='no'</script><!--";
    file("odd.json", JSON.stringify({ order: 2, curves: [{ points: [[0, 0], [1, 0], [0, 1]], name }] }));
    coface("view", "odd.json", "-o", "odd.html");
    const opened = await open("odd.html");
    expect(await opened.page.title()).toBe("odd.json");
    expect(await opened.page.locator("#panel").innerText()).toContain(name);
    await close(opened);
  });
});
