/** Segments that are drawn by hand, and the cells that they cut the plane into. */

import { button, element } from "../../src/panel/elements";
import { drawn, file, handle, latest, pointOf, text, type Hands, type Point, type Table } from "./table";

const COLORS = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442", "#999999"];

interface Feature {
  properties: { face?: number };
  geometry: { type: string; coordinates: Point[][] };
}

export const SEGMENTS: Table = {
  title: "segments to cells",
  about: "draw segments by dragging: the cells of their arrangement",
  open(place: HTMLElement, hands: Hands): () => void {
    const segments: [Point, Point][] = [
      [[1, 2], [9, 2]],
      [[1, 6], [9, 6]],
      [[3, 1], [3, 7]],
      [[7, 1], [7, 7]],
      [[2, 7], [8, 1]],
    ];
    const svg = drawn("svg", { viewBox: "0 0 10 8", role: "img", "aria-label": "segments and their cells" }) as SVGSVGElement;
    const [cells, lines, handles] = [drawn("g", {}), drawn("g", {}), drawn("g", {})];
    svg.append(cells, lines, handles);
    const facts = element("p", { class: "facts", "aria-live": "polite" });
    const drawing = () => `${segments.map(([[a, b], [c, d]]) => `LINESTRING(${a} ${b},${c} ${d})`).join("\n")}\n`;
    const compute = latest(async () => {
      const outcome = await hands.run(["arrange", "drawing.wkt", "-o", "cells.geojson", "--json"], [file("drawing.wkt", drawing())]);
      cells.replaceChildren();
      if (outcome.status !== 0) {
        facts.textContent = outcome.stderr;
        return;
      }
      const answer = JSON.parse(text(outcome)) as { f_vector: number[]; components: number; euler_characteristic: number };
      const { features } = JSON.parse(new TextDecoder().decode(outcome.files.get("cells.geojson")!)) as { features: Feature[] };
      for (const { properties, geometry } of features) {
        if (geometry.type !== "Polygon") continue;
        const path = geometry.coordinates.map((ring) => `M${ring.map((point) => point.join(" ")).join("L")}Z`).join("");
        cells.append(drawn("path", { d: path, "fill-rule": "evenodd", "fill-opacity": 0.35, fill: COLORS[(properties.face ?? 0) % COLORS.length] }));
      }
      const [vertices, edges = 0, faces = 0] = answer.f_vector;
      facts.textContent = `${vertices} vertices, ${edges} edges, ${faces} bounded cells in ${answer.components} piece${answer.components === 1 ? "" : "s"}; Euler characteristic ${answer.euler_characteristic}: ${vertices} - ${edges} + ${faces}`;
    });
    const draw = () => {
      lines.replaceChildren(
        ...segments.map(([a, b]) => drawn("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], stroke: "var(--text)", "stroke-width": 0.05 })),
      );
    };
    const grips = () => {
      handles.replaceChildren(
        ...segments.flatMap((segment, i) =>
          segment.map((point, k) =>
            handle(svg, point, `end ${k} of segment ${i}`, 0.12, (moved) => {
              segment[k] = moved;
              draw();
              compute();
            }),
          ),
        ),
      );
    };
    const all = () => {
      draw();
      grips();
      compute();
    };
    svg.addEventListener("pointerdown", (event) => {
      const start = pointOf(svg, event);
      segments.push([start, start]);
      svg.setPointerCapture(event.pointerId);
      const move = (moved: PointerEvent) => {
        segments[segments.length - 1][1] = pointOf(svg, moved);
        draw();
        compute();
      };
      svg.addEventListener("pointermove", move);
      svg.addEventListener(
        "pointerup",
        () => {
          svg.removeEventListener("pointermove", move);
          const [from, to] = segments[segments.length - 1];
          if (Math.hypot(from[0] - to[0], from[1] - to[1]) < 0.1) segments.pop();
          all();
        },
        { once: true },
      );
    });
    const row = element(
      "div",
      { class: "row" },
      button("remove the last", "take the last segment away", () => {
        segments.pop();
        all();
      }),
      button("keep as a model", "take the drawing among the models", () => hands.keep("drawing.wkt", drawing())),
    );
    place.append(row, svg, facts);
    all();
    return () => place.replaceChildren();
  },
};
