/** Two sets with curved boundaries: knots are dragged, kinks are clicked, and their Booleans follow. */

import { button, element } from "../../src/panel/elements";
import { drawn, file, handle, latest, text, type Hands, type Point, type Table } from "./table";

interface Curve {
  points: Point[];
  kinks: number[];
}

interface Sample {
  curve: number;
  point: Point;
}

interface SetAnswer {
  area: number | null;
  betti_open: number[];
  curves: { parent: number | null; sign: number }[];
  empty: boolean;
}

const OPERATIONS = ["meet", "join", "difference", "xor"];

export const SPLINES: Table = {
  title: "curved sets",
  about: "drag the knots of two sets, click a knot to make it a kink: their Booleans, Betti numbers and Hasse forest",
  open(place: HTMLElement, hands: Hands): () => void {
    const sets: Curve[] = [
      { points: [[5, 4], [3, 6], [1.5, 4], [3, 2]], kinks: [] },
      { points: [[8.5, 4], [6, 6.5], [4, 4], [6, 2]], kinks: [2] },
    ];
    let operation = "join";
    const svg = drawn("svg", { viewBox: "0 0 10 8", role: "img", "aria-label": "two sets and what they make" }) as SVGSVGElement;
    const [result, outlines, handles] = [drawn("g", {}), drawn("g", {}), drawn("g", {})];
    svg.append(result, outlines, handles);
    const facts = element("p", { class: "facts", "aria-live": "polite" });
    const textOf = (set: Curve) => JSON.stringify({ order: 4, curves: [set] });
    const sampled = async (name: string, files: [string, Uint8Array][]): Promise<string> => {
      const outcome = await hands.run(["yin", "sample", name, "--per-piece", "12", "--json"], files);
      if (outcome.status !== 0) return "";
      const curves: Point[][] = [];
      for (const { curve, point } of (JSON.parse(text(outcome)) as { samples: Sample[] }).samples) (curves[curve] ??= []).push(point);
      return curves.map((points) => `M${points.map((point) => point.join(" ")).join("L")}Z`).join("");
    };
    const compute = latest(async () => {
      const files = sets.map((set, i) => file(`${"ab"[i]}.json`, textOf(set)));
      const paths: string[] = [];
      for (const name of ["a.json", "b.json"]) paths.push(await sampled(name, files));
      outlines.replaceChildren(...paths.map((d, i) => drawn("path", { d, fill: "none", stroke: ["#0072b2", "#d55e00"][i], "stroke-width": 0.04 })));
      const outcome = await hands.run(["yin", operation, "a.json", "b.json", "-o", "r.json", "--json"], files);
      result.replaceChildren();
      if (outcome.status !== 0) {
        facts.textContent = outcome.stderr;
        return;
      }
      const answer = JSON.parse(text(outcome)) as SetAnswer;
      if (!answer.empty) {
        const made = outcome.files.get("r.json")!;
        result.append(drawn("path", { d: await sampled("r.json", [["r.json", made]]), fill: "#009e73", "fill-opacity": 0.35, "fill-rule": "evenodd" }));
      }
      const [components, holes] = answer.betti_open;
      const forest = answer.curves.map(({ parent, sign }, i) => `${sign > 0 ? "+" : "-"}${i}${parent === null ? "" : ` in ${parent}`}`).join(", ");
      facts.textContent = answer.empty
        ? `a ${operation} b is empty`
        : `a ${operation} b: ${components} component${components === 1 ? "" : "s"}, ${holes} hole${holes === 1 ? "" : "s"}, area ${answer.area?.toPrecision(8)}; curves ${forest}`;
    });
    const grips = () => {
      handles.replaceChildren(
        ...sets.flatMap((set, i) =>
          set.points.map((point, k) => {
            const isKink = set.kinks.includes(k);
            const onMove = (moved: Point) => {
              set.points[k] = moved;
              compute();
            };
            const onClick = () => {
              set.kinks = isKink ? set.kinks.filter((kink) => kink !== k) : [...set.kinks, k].sort((x, y) => x - y);
              grips();
              compute();
            };
            const found = handle(svg, point, `${isKink ? "kink" : "knot"} ${k} of set ${"ab"[i]}`, isKink ? 0.16 : 0.11, onMove, onClick);
            found.setAttribute("fill", ["#0072b2", "#d55e00"][i]);
            return found;
          }),
        ),
      );
    };
    const row = element("div", { class: "row" });
    const buttons = OPERATIONS.map((name) => {
      const found = button(name, `a ${name} b`, () => {
        operation = name;
        for (const other of buttons) other.setAttribute("aria-pressed", String(other === found));
        compute();
      });
      found.setAttribute("aria-pressed", String(name === operation));
      return found;
    });
    const keep = button("keep as models", "take both sets among the models", () => sets.forEach((set, i) => hands.keep(`set-${"ab"[i]}.yin.json`, textOf(set))));
    row.append(...buttons, keep);
    place.append(row, svg, facts);
    grips();
    compute();
    return () => place.replaceChildren();
  },
};
