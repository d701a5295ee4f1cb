/** A function over the square with hills that are dragged: its persistence diagram, and what is there below a level. */

import { button, element } from "../../src/panel/elements";
import { drawn, file, handle, latest, text, type Hands, type Point, type Table } from "./table";

interface Pair {
  birth: number;
  death: number | null;
  degree: number;
}

/** Vertices a side of the square. */
const SIDE = 21;
const COLORS = ["#0072b2", "#d55e00"];

export const FILTRATION: Table = {
  title: "levels and persistence",
  about: "drag the dips of a landscape and move the level: pieces and holes are born and die",
  open(place: HTMLElement, hands: Hands): () => void {
    const dips: Point[] = [[2, 2], [6, 2.4], [4, 6]];
    let level = -0.3;
    let pairs: Pair[] = [];
    const grid = Array.from({ length: SIDE * SIDE }, (_, i): Point => [(8 * (i % SIDE)) / (SIDE - 1), (8 * Math.floor(i / SIDE)) / (SIDE - 1)]);
    const triangles: number[][] = [];
    for (let y = 0; y + 1 < SIDE; y++) {
      for (let x = 0; x + 1 < SIDE; x++) {
        const v = y * SIDE + x;
        triangles.push([v, v + 1, v + SIDE + 1], [v, v + SIDE + 1, v + SIDE]);
      }
    }
    const valueAt = ([x, y]: Point) => -dips.reduce((sum, [a, b]) => sum + Math.exp(-((x - a) ** 2 + (y - b) ** 2) / 1.8), 0);
    const mesh = `OFF\n${grid.length} ${triangles.length} 0\n${grid.map((point) => `${point.join(" ")} 0`).join("\n")}\n${triangles.map((triangle) => `3 ${triangle.join(" ")}`).join("\n")}\n`;
    let values = grid.map(valueAt);
    const svg = drawn("svg", { viewBox: "-0.4 -0.4 18 8.8", role: "img", "aria-label": "a landscape and its persistence diagram" }) as SVGSVGElement;
    const [below, diagram, handles] = [drawn("g", {}), drawn("g", {}), drawn("g", {})];
    svg.append(below, diagram, handles);
    const facts = element("p", { class: "facts", "aria-live": "polite" });
    const slider = element("input", { type: "range", min: "-1.5", max: "0.02", step: "0.01", value: String(level), "aria-label": "level" });
    /** The place of a value along the sides of the diagram. */
    const along = (value: number) => 8 * ((value + 1.6) / 1.6);
    const draw = () => {
      const inside = triangles.filter((triangle) => triangle.every((v) => values[v] <= level));
      below.replaceChildren(
        drawn("rect", { x: 0, y: 0, width: 8, height: 8, fill: "none", stroke: "var(--line)", "stroke-width": 0.04 }),
        drawn("path", { d: inside.map((triangle) => `M${triangle.map((v) => grid[v].join(" ")).join("L")}Z`).join(""), fill: "#56b4e9" }),
        ...grid.flatMap(([x, y], v) => (values[v] <= level ? [drawn("circle", { cx: x, cy: y, r: 0.05, fill: "var(--text)" })] : [])),
      );
      const [left, top] = [9.2, 8];
      diagram.replaceChildren(
        drawn("path", { d: `M${left} 0V8H${left + 8}M${left} 8L${left + 8} 0`, fill: "none", stroke: "var(--faint)", "stroke-width": 0.03 }),
        drawn("path", { d: `M${left + along(level)} 8V${top - along(level)}H${left}`, fill: "none", stroke: "var(--text)", "stroke-width": 0.03, "stroke-dasharray": 0.1 }),
        ...pairs.map(({ birth, death, degree }) => drawn("circle", { cx: left + along(birth), cy: death === null ? 0 : top - along(death), r: 0.14, fill: COLORS[degree] ?? "#999" })),
      );
      const alive = (degree: number) => pairs.filter((pair) => pair.degree === degree && pair.birth <= level && (pair.death === null || pair.death > level)).length;
      facts.textContent = `at level ${level.toFixed(2)}: ${alive(0)} piece${alive(0) === 1 ? "" : "s"}, ${alive(1)} hole${alive(1) === 1 ? "" : "s"}; ${pairs.length} pairs in all (blue: pieces, red: holes)`;
    };
    const compute = latest(async () => {
      values = grid.map(valueAt);
      draw();
      const files = [file("square.off", mesh), file("values.txt", `${values.join("\n")}\n`)];
      const outcome = await hands.run(["persistence", "square.off", "--function", "values.txt", "--json"], files);
      if (outcome.status !== 0) {
        facts.textContent = outcome.stderr;
        return;
      }
      pairs = (JSON.parse(text(outcome)) as { diagram: Pair[] }).diagram;
      draw();
    });
    dips.forEach((dip, i) => {
      const onMove = (moved: Point) => {
        dips[i] = moved;
        compute();
      };
      handles.append(handle(svg, dip, `dip ${i}`, 0.2, onMove));
    });
    slider.addEventListener("input", () => {
      level = Number(slider.value);
      draw();
    });
    const keep = button("keep as a model", "take the square, with its values as heights, among the models", () => {
      const heights = grid.map((point, v) => `${point.join(" ")} ${values[v]}`).join("\n");
      hands.keep("landscape.off", `OFF\n${grid.length} ${triangles.length} 0\n${heights}\n${triangles.map((triangle) => `3 ${triangle.join(" ")}`).join("\n")}\n`);
    });
    place.append(element("div", { class: "row" }, element("label", { class: "row", style: "flex: 1" }, "level ", slider), keep), svg, facts);
    compute();
    return () => place.replaceChildren();
  },
};
