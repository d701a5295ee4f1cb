/** Tables whose picture is the page that the program writes: pulled covers, and solids that are moved. */

import { element } from "../../src/panel/elements";
import type { Outcome } from "../system";
import { file, latest, text, type Hands, type Table } from "./table";

function range(name: string, least: number, most: number, step: number, value: number, onInput: () => void): HTMLInputElement {
  const found = element("input", { type: "range", min: String(least), max: String(most), step: String(step), value: String(value), "aria-label": name });
  found.addEventListener("input", onInput);
  return found;
}

interface Solid {
  measure: number;
  area: number;
  f_vector: number[];
  components: number;
}

function summary({ measure, area, f_vector, components }: Solid): string {
  const [vertices = 0, edges = 0, faces = 0] = f_vector;
  return `volume ${measure}, area ${area}\n${vertices} vertices, ${edges} edges, ${faces} faces in ${components} component${components === 1 ? "" : "s"}; V - E + F = ${vertices - edges + faces}`;
}

/** Shows the page of a run in a frame, or why there is none. */
function show(frame: HTMLIFrameElement, facts: HTMLElement, outcome: Outcome): void {
  const page = outcome.files.get("page.html");
  if (outcome.status === 0 && page) frame.srcdoc = new TextDecoder().decode(page);
  else facts.textContent = outcome.stderr;
}

export const COVER: Table = {
  title: "pull a cover",
  about: "the universal cover of a surface, as many copies as are asked for",
  open(place: HTMLElement, hands: Hands): () => void {
    const surfaces: Record<string, string[]> = {
      torus: ["generate", "torus-grid", "--shape", "6,6"],
      "two handles": ["generate", "genus", "--genus", "2"],
      "Klein bottle": ["generate", "small-klein"],
      annulus: ["generate", "strip", "--vertices", "12"],
    };
    const choice = element("select", { "aria-label": "surface" }, ...Object.keys(surfaces).map((name) => element("option", {}, name)));
    const facts = element("pre", { class: "facts", "aria-live": "polite" });
    const frame = element("iframe", { title: "the cover" });
    const compute = latest(async () => {
      const made = await hands.run([...surfaces[choice.value], "-o", "surface.json"], []);
      const cover = await hands.run(["cover", "surface.json", "--copies", copies.value, "-o", "cover.json"], made.files);
      facts.textContent = cover.status === 0 ? text(cover) : cover.stderr || made.stderr;
      if (cover.status === 0) show(frame, facts, await hands.run(["view", "surface.json", "--with", "cover.json", "-o", "page.html"], cover.files));
    });
    const copies = range("copies", 1, 60, 1, 9, compute);
    choice.addEventListener("change", compute);
    place.append(element("div", { class: "row" }, choice, element("label", { class: "row", style: "flex: 1" }, "copies ", copies)), frame, facts);
    compute();
    return () => place.replaceChildren();
  },
};

export const SOLIDS: Table = {
  title: "two solids",
  about: "move a ball through a box: their Boolean, exactly",
  open(place: HTMLElement, hands: Hands): () => void {
    const operation = element("select", { "aria-label": "operation" }, ...["difference", "union", "intersection", "xor"].map((name) => element("option", {}, name)));
    const facts = element("pre", { class: "facts", "aria-live": "polite" });
    const frame = element("iframe", { title: "the result" });
    const compute = latest(async () => {
      const at = sliders.map(({ value }) => Number(value));
      const scene = (parts: unknown[]) => file("scene.json", JSON.stringify({ assembly: parts }));
      const box = await hands.run(["generate", "box", "--boundary", "-o", "box.off", "-q"], []);
      const ball = await hands.run(["generate", "assembly", "scene.json", "-o", "ball.off", "-q"], [scene([{ translate: at }, { shape: "sphere", radius: 0.45 }])]);
      const files = new Map([...box.files, ...ball.files]);
      const result = await hands.run(["boolean", operation.value, "box.off", "ball.off", "-o", "result.off", "--json"], files);
      facts.textContent = result.status === 0 ? summary(JSON.parse(text(result)) as Solid) : result.stderr || ball.stderr || box.stderr;
      if (result.status === 0) show(frame, facts, await hands.run(["view", "result.off", "--no-report", "-o", "page.html"], result.files));
    });
    const sliders = ["x", "y", "z"].map((axis) => range(`the ball's ${axis}`, -0.6, 1.6, 0.05, 1, compute));
    operation.addEventListener("change", compute);
    const labels = sliders.map((slider, i) => element("label", { class: "row", style: "flex: 1" }, `${"xyz"[i]} `, slider));
    place.append(element("div", { class: "row" }, operation, ...labels), frame, facts);
    compute();
    return () => place.replaceChildren();
  },
};
