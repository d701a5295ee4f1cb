/** Pages made by the program, in a browser that has no network. */

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import axe from "axe-core";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";
import { expect } from "vitest";

const program = needed("COFACE_PROGRAM");
const folder = mkdtempSync(join(tmpdir(), "coface-page-"));

function needed(name: string): string {
  const value = process.env[name];
  if (!value) throw new Error(`the environment variable ${name} is not set; cargo xtask test sets it`);
  return value;
}

/** Where a file of this run is. */
export function file(name: string, text?: string): string {
  const path = join(folder, name);
  if (text !== undefined) writeFileSync(path, text);
  return path;
}

/** Runs the program in the folder of this run: what it prints. */
export function coface(...words: string[]): string {
  return execFileSync(program, [...words, "-q"], { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
}

/** The JSON that the program answers, written to a file too. */
export function answer(name: string, ...words: string[]): Record<string, unknown> {
  const text = coface(...words, "--json");
  file(name, text);
  return JSON.parse(text) as Record<string, unknown>;
}

let browser: Browser | null = null;

export async function start(): Promise<void> {
  browser = await chromium.launch({
    executablePath: needed("CHROMIUM"),
    // Drawn by software: the same picture on every machine. What stands around the picture is drawn without going through the same software
    // twice, which is half of the work.
    args: [
      "--no-sandbox",
      "--use-gl=angle",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
      "--disable-gpu-sandbox",
      "--disable-gpu-rasterization",
      "--disable-gpu-compositing",
    ],
  });
}

export async function stop(): Promise<void> {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
}

/** A page and what it did that it should not. */
export interface Opened {
  page: Page;
  complaints: string[];
  /** Whether another test may go on with it: it was opened as most are. */
  isUsual: boolean;
}

/** Pages that nobody uses. A new page is a new process, and takes longer than what is shown in it. */
const free: Opened[] = [];

/** Opens a page from disk, after some script of the test if there is one. Every request that is not for a file is refused, and noted. */
export async function open(
  name: string,
  fragment = "",
  options: BrowserContextOptions = {},
  hasScript = true,
  before: (() => void) | null = null,
): Promise<Opened> {
  const isUsual = Object.keys(options).length === 0 && hasScript && before === null;
  const opened = (isUsual ? free.pop() : undefined) ?? (await newPage(options, isUsual));
  const { page } = opened;
  if (before) await page.addInitScript(before);
  await page.goto(pathToFileURL(join(folder, name)).href + fragment);
  if (hasScript) await settle(page);
  return opened;
}

async function newPage(options: BrowserContextOptions, isUsual: boolean): Promise<Opened> {
  if (!browser) throw new Error("the browser was not started");
  const context = await browser.newContext({ viewport: { width: 1000, height: 700 }, colorScheme: "light", ...options });
  const page = await context.newPage();
  const complaints: string[] = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !isAboutDriver(message.text())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  await page.route("**/*", (route) => {
    const url = route.request().url();
    if (/^(file|data|blob):/.test(url)) return route.continue();
    complaints.push(`asked for ${url}`);
    return route.abort();
  });
  return { page, complaints, isUsual };
}

/** Reading pixels back is slow, and drivers say so. */
function isAboutDriver(text: string): boolean {
  return text.includes("GPU stall due to ReadPixels") || text.includes("software WebGL");
}

/** What stands in the way of people who cannot see, hear or point, by the rules of WCAG 2 at the levels A and AA. */
export async function faultsOfAccess(page: Page): Promise<string[]> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axe.source);
  return page.evaluate(async () => {
    const { run } = (window as unknown as { axe: typeof import("axe-core") }).axe;
    const { violations } = await run({ runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"], resultTypes: ["violations"] });
    return violations.flatMap((fault) => fault.nodes.map((node) => `${fault.id}: ${node.html.slice(0, 120)} ${node.failureSummary ?? ""}`));
  });
}

/** Closes a page that did nothing wrong. */
export async function close(opened: Opened): Promise<void> {
  const { page, complaints, isUsual } = opened;
  expect(complaints).toEqual([]);
  if (!isUsual) return page.context().close();
  // The next one starts from nothing: without the document, and with the pointer in a corner.
  await page.mouse.move(0, 0);
  await page.goto("about:blank");
  free.push(opened);
}

/** Waits until what was asked for is drawn. */
export async function settle(page: Page): Promise<void> {
  await page.evaluate(() => new Promise<void>((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
}

/** How many pixels of the window have nearly this color. */
export async function pixels(page: Page, color: string): Promise<number> {
  await settle(page);
  return page.evaluate(count, { image: null, color });
}

/** How many pixels of a picture have nearly this color. */
export async function pixelsOf(page: Page, path: string, color: string): Promise<number> {
  return page.evaluate(count, { image: readFileSync(path).toString("base64"), color });
}

async function count({ image, color }: { image: string | null; color: string }): Promise<number> {
  const source = image
    ? await createImageBitmap(await (await fetch(`data:image/png;base64,${image}`)).blob())
    : document.querySelector<HTMLCanvasElement>("#canvas")!;
  const copy = new OffscreenCanvas(source.width, source.height);
  const context = copy.getContext("2d", { willReadFrequently: true })!;
  context.drawImage(source, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  const wanted = [1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16));
  let found = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (wanted.every((value, part) => Math.abs(data[i + part] - value) <= 12)) found += 1;
  }
  return found;
}

/** The picture in the window, to be compared. */
export async function picture(page: Page): Promise<string> {
  await settle(page);
  return page.evaluate(() => document.querySelector<HTMLCanvasElement>("#canvas")!.toDataURL());
}

/** The share of pixels in which the window differs from a picture so that it can be seen. */
export async function difference(page: Page, other: string): Promise<number> {
  await settle(page);
  return page.evaluate(async (other) => {
    const canvas = document.querySelector<HTMLCanvasElement>("#canvas")!;
    const image = await createImageBitmap(await (await fetch(other)).blob());
    const read = (source: CanvasImageSource) => {
      const context = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true })!;
      context.drawImage(source, 0, 0);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    };
    const [a, b] = [read(canvas), read(image)];
    let found = 0;
    for (let i = 0; i < a.length; i += 4) if ([0, 1, 2].some((part) => Math.abs(a[i + part] - b[i + part]) > 48)) found += 1;
    return found / (a.length / 4);
  }, other);
}

/** Moves a slider. */
export async function slide(page: Page, id: string, value: number): Promise<void> {
  await page.locator(`#${id}`).fill(String(value));
  await settle(page);
}

/** A picture as a text that a page can read. */
export function dataOf(path: string): string {
  const kind = path.endsWith(".svg") ? "svg+xml" : "png";
  return `data:image/${kind};base64,${readFileSync(path).toString("base64")}`;
}

/**
 * The share of places at which one picture has something and another has nothing, when both are stretched to the boxes around what they
 * show. `null` is the window.
 */
export async function outlineDifference(page: Page, one: string | null, other: string): Promise<number> {
  await settle(page);
  return page.evaluate(
    async ({ one, other }) => {
      const SIDE = 200;
      const outline = async (source: string | null) => {
        const image = source ? await createImageBitmap(await (await fetch(source)).blob()) : document.querySelector<HTMLCanvasElement>("#canvas")!;
        const { width, height } = image;
        const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        const isThere = (x: number, y: number) => [0, 1, 2].some((part) => data[4 * (y * width + x) + part] < 250);
        let [left, right, top, bottom] = [width, -1, height, -1];
        for (let y = 0; y < height; y++) {
          for (let x = 0; x < width; x++) {
            if (!isThere(x, y)) continue;
            [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
          }
        }
        const found: boolean[] = [];
        for (let j = 0; j < SIDE; j++) {
          for (let i = 0; i < SIDE; i++) {
            found.push(isThere(Math.round(left + ((right - left) * i) / (SIDE - 1)), Math.round(top + ((bottom - top) * j) / (SIDE - 1))));
          }
        }
        return found;
      };
      const [a, b] = [await outline(one), await outline(other)];
      return a.filter((there, i) => there !== b[i]).length / a.length;
    },
    { one, other },
  );
}

/** The mean difference of the parts of pixels, of 255, between a picture of the program and what the browser makes of another. */
export async function meanDifference(page: Page, png: string, svg: string): Promise<number> {
  return page.evaluate(
    async ({ png, svg }) => {
      const bitmap = await createImageBitmap(await (await fetch(png)).blob());
      const image = new Image();
      image.src = svg;
      await image.decode();
      const { width, height } = bitmap;
      const read = (source: CanvasImageSource) => {
        const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
        context.fillStyle = "#ffffff";
        context.fillRect(0, 0, width, height);
        context.drawImage(source, 0, 0, width, height);
        return context.getImageData(0, 0, width, height).data;
      };
      const [a, b] = [read(bitmap), read(image)];
      let sum = 0;
      for (let i = 0; i < a.length; i += 4) for (const part of [0, 1, 2]) sum += Math.abs(a[i + part] - b[i + part]);
      return sum / (0.75 * a.length);
    },
    { png, svg },
  );
}
