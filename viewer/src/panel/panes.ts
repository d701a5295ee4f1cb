/** Flat pictures beside the model, as SVG in the panel. */

import type { Layer, Pane } from "../scene/document";
import { button, element } from "./elements";
import { colorOf } from "../view/palette";

const SVG = "http://www.w3.org/2000/svg";

/** The side of a picture in its own unit, and the margin. */
const SIDE = 100;
const MARGIN = 7;

/** Layers of faces and edges that are in the background have no color of their own. */
const QUIET = new Set(["faces", "edges", "sides of copies", "circle at infinity", "directly around", "diagonal"]);

function svgElement(tag: string, attributes: Record<string, string>, text = ""): SVGElement {
  const found = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) found.setAttribute(name, value);
  found.textContent = text;
  return found;
}

export function paneElement(pane: Pane): HTMLElement {
  const svg = paneSvg(pane);
  const enlarge = button("enlarge", `see the ${pane.name} in the whole window`, () => {
    const dialog = element("dialog", { class: "enlarged", "aria-label": pane.name });
    const close = button("close", "close (Escape)", () => dialog.close());
    const copy = svg.cloneNode(true) as SVGElement;
    dialog.append(element("div", { class: "row" }, pane.name, " ", close), copy);
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  });
  const section = element("section", { "data-pane": pane.name }, element("h2", {}, pane.name, " ", enlarge), svg);
  const named = pane.layers.filter((layer) => !QUIET.has(layer.name) && layer.labels.length < layer.points.length);
  if (pane.axes) {
    section.append(element("p", { class: "detail" }, `${pane.axes[0]} to the right, ${pane.axes[1]} up`));
    const legend = element("p", { class: "detail" });
    for (const layer of named) {
      const color = paneColor(layer, pane.layers.indexOf(layer));
      legend.append(element("span", { class: "swatch", style: `background:${color};display:inline-block` }), ` ${layer.name} `);
    }
    section.append(legend);
  }
  return section;
}

function paneColor(layer: Layer, place: number): string {
  return QUIET.has(layer.name) ? "currentColor" : colorOf(layer.color ?? place);
}

export function paneSvg(pane: Pane): SVGElement {
  const positions = pane.layers[0]?.positions ?? new Float32Array();
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    left = Math.min(left, positions[i]);
    right = Math.max(right, positions[i]);
    bottom = Math.min(bottom, positions[i + 1]);
    top = Math.max(top, positions[i + 1]);
  }
  const size = Math.max(right - left, top - bottom, 1e-30);
  const scale = (SIDE - 2 * MARGIN) / size;
  const x = (point: number) => SIDE / 2 + scale * (positions[3 * point] - (left + right) / 2);
  const y = (point: number) => SIDE / 2 - scale * (positions[3 * point + 1] - (bottom + top) / 2);
  const place = (point: number) => `${x(point).toFixed(3)} ${y(point).toFixed(3)}`;
  const svg = svgElement("svg", { viewBox: `0 0 ${SIDE} ${SIDE}`, class: "pane", role: "img", "aria-label": pane.name });
  const written: { x: number; y: number; half: number }[] = [];
  const texts = svgElement("g", { fill: "currentColor", "font-size": "3.4", "text-anchor": "middle" });
  pane.layers.forEach((layer, number) => {
    const color = paneColor(layer, number);
    const group = svgElement("g", { "data-layer": layer.name });
    let path = "";
    for (let t = 0; t + 2 < layer.triangles.length; t += 3) {
      path += `M${place(layer.triangles[t])}L${place(layer.triangles[t + 1])}L${place(layer.triangles[t + 2])}Z`;
    }
    if (path) group.append(svgElement("path", { d: path, fill: color, "fill-opacity": QUIET.has(layer.name) ? "0.08" : "0.28" }));
    path = "";
    const heads: string[] = [];
    for (let line = 0; line + 1 < layer.lines.starts.length; line++) {
      const list = layer.lines.items.subarray(layer.lines.starts[line], layer.lines.starts[line + 1]);
      list.forEach((point, i) => (path += `${i === 0 ? "M" : "L"}${place(point)}`));
      if (layer.arrows && list.length > 1) heads.push(head(list, x, y));
    }
    const lineCount = layer.lines.starts.length - 1;
    // Many edges are faint, so that what is drawn over them can be seen.
    const faint = layer.name === "edges" ? String(Math.min(0.7, Math.max(0.12, 600 / lineCount)).toFixed(2)) : "1";
    const width = QUIET.has(layer.name) ? (layer.name === "edges" ? "0.12" : "0.35") : "0.9";
    if (path) group.append(svgElement("path", { d: path, fill: "none", stroke: color, "stroke-width": width, "stroke-opacity": faint, "stroke-linejoin": "round" }));
    if (heads.length) group.append(svgElement("path", { d: heads.join(""), fill: color }));
    const radius = layer.labels.length ? "2.6" : layer.points.length > 500 ? "0.7" : "1.1";
    for (const point of layer.points) {
      group.append(svgElement("circle", { cx: x(point).toFixed(3), cy: y(point).toFixed(3), r: radius, fill: color, "fill-opacity": layer.labels.length ? "0.35" : "1" }));
    }
    for (const { point, text } of layer.labels) {
      const box = { x: x(point), y: y(point), half: 1 + 0.9 * text.length };
      // A text that would cover another is left out.
      if (written.some((other) => Math.abs(other.x - box.x) < other.half + box.half && Math.abs(other.y - box.y) < 3.4)) continue;
      written.push(box);
      texts.append(svgElement("text", { x: box.x.toFixed(3), y: (box.y + 1.2).toFixed(3) }, text));
    }
    svg.append(group);
  });
  svg.append(texts);
  return svg;
}

/** An arrowhead in the middle of a line. */
function head(line: Uint32Array, x: (point: number) => number, y: (point: number) => number): string {
  let length = 0;
  for (let i = 0; i + 1 < line.length; i++) length += Math.hypot(x(line[i + 1]) - x(line[i]), y(line[i + 1]) - y(line[i]));
  let left = length / 2;
  for (let i = 0; i + 1 < line.length; i++) {
    const [a, b] = [line[i], line[i + 1]];
    const [u, v] = [x(b) - x(a), y(b) - y(a)];
    const step = Math.hypot(u, v);
    if (left > step || step === 0) {
      left -= step;
      continue;
    }
    const [p, q] = [x(a) + (u * left) / step, y(a) + (v * left) / step];
    const size = Math.min(2.2, length / 2);
    const [e, f] = [(u / step) * size, (v / step) * size];
    const corner = (s: number, t: number) => `${(p + s * e - t * f).toFixed(3)} ${(q + s * f + t * e).toFixed(3)}`;
    return `M${corner(0.7, 0)}L${corner(-0.5, 0.5)}L${corner(-0.5, -0.5)}Z`;
  }
  return "";
}
