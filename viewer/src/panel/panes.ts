/** Flat pictures beside the model, as SVG in the panel. */

import type { Pane } from "../scene/document";
import { element } from "./elements";
import { colorOf } from "../view/palette";

const SVG = "http://www.w3.org/2000/svg";

function svgElement(tag: string, attributes: Record<string, string>, text = ""): SVGElement {
  const found = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) found.setAttribute(name, value);
  found.textContent = text;
  return found;
}

export function paneElement(pane: Pane): HTMLElement {
  const section = element("section", { "data-pane": pane.name }, element("h2", {}, pane.name));
  const positions = pane.layers[0]?.positions ?? new Float32Array();
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    left = Math.min(left, positions[i]);
    right = Math.max(right, positions[i]);
    bottom = Math.min(bottom, positions[i + 1]);
    top = Math.max(top, positions[i + 1]);
  }
  const size = Math.max(right - left, top - bottom, 1e-30);
  const x = (point: number) => (4 + (92 * (positions[3 * point] - left)) / size).toFixed(3);
  const y = (point: number) => (96 - (92 * (positions[3 * point + 1] - bottom)) / size).toFixed(3);
  const svg = svgElement("svg", { viewBox: "0 0 100 100", class: "pane", role: "img", "aria-label": pane.name });
  pane.layers.forEach((layer, place) => {
    const color = colorOf(layer.color ?? place);
    const group = svgElement("g", { "data-layer": layer.name });
    for (let t = 0; t + 2 < layer.triangles.length; t += 3) {
      const points = [0, 1, 2].map((i) => `${x(layer.triangles[t + i])},${y(layer.triangles[t + i])}`).join(" ");
      group.append(svgElement("polygon", { points, fill: color, "fill-opacity": "0.35" }));
    }
    for (let line = 0; line + 1 < layer.lines.starts.length; line++) {
      const list = Array.from(layer.lines.items.subarray(layer.lines.starts[line], layer.lines.starts[line + 1]));
      const points = list.map((p) => `${x(p)},${y(p)}`).join(" ");
      group.append(svgElement("polyline", { points, fill: "none", stroke: color, "stroke-width": "0.5" }));
    }
    for (const point of layer.points) group.append(svgElement("circle", { cx: x(point), cy: y(point), r: "1.1", fill: color }));
    for (const { point, text } of layer.labels) {
      group.append(svgElement("text", { x: x(point), y: y(point), "font-size": "3", fill: "currentColor" }, text));
    }
    svg.append(group);
  });
  section.append(svg);
  if (pane.axes) section.append(element("p", { class: "detail" }, `${pane.axes[0]} to the right, ${pane.axes[1]} up`));
  return section;
}
