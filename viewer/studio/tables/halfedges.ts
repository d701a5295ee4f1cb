/** A mesh whose edges are flipped, split and collapsed by a click, with the permutations of its halfedges beside it. */

import { button, element } from "../../src/panel/elements";
import { drawn, file, text, type Hands, type Point, type Table } from "./table";

const START = `v 1 1 0
v 5 0.6 0
v 9 1 0
v 1.4 4 0
v 5 3.6 0
v 8.6 4.2 0
v 3 7 0
v 7 7 0
f 1 2 5
f 1 5 4
f 2 3 5
f 3 6 5
f 4 5 7
f 5 8 7
f 5 6 8
`;

const EDITS = ["flip", "split", "collapse", "remove-edge"];

/** The vertices and faces of an OBJ that the program wrote. */
function meshOf(obj: string): { vertices: Point[]; faces: number[][] } {
  const vertices: Point[] = [];
  const faces: number[][] = [];
  for (const line of obj.split("\n")) {
    const [kind, ...words] = line.trim().split(/\s+/);
    if (kind === "v") vertices.push([Number(words[0]), Number(words[1])]);
    if (kind === "f") faces.push(words.map((word) => parseInt(word) - 1));
  }
  return { vertices, faces };
}

export const HALFEDGES: Table = {
  title: "halfedges",
  about: "click an edge to flip, split or collapse it: the permutations of its halfedges follow",
  open(place: HTMLElement, hands: Hands): () => void {
    const states = [START];
    let edit = "flip";
    const svg = drawn("svg", { viewBox: "0 0 10 8", role: "img", "aria-label": "a mesh" }) as SVGSVGElement;
    const said = element("p", { role: "status" });
    const facts = element("pre", { class: "facts", "aria-live": "polite" });
    const apply = async (from: number, to: number) => {
      const outcome = await hands.run(["edit", "mesh.obj", `--${edit}`, `${from} ${to}`, "-o", "edited.obj"], [file("mesh.obj", states[states.length - 1])]);
      if (outcome.status === 0) states.push(new TextDecoder().decode(outcome.files.get("edited.obj")));
      said.textContent = outcome.status === 0 ? `${edit} ${from} ${to}` : outcome.stderr;
      await draw();
    };
    const draw = async () => {
      const mesh = states[states.length - 1];
      const { vertices, faces } = meshOf(mesh);
      svg.replaceChildren(...faces.map((face) => drawn("polygon", { points: face.map((v) => vertices[v].join(",")).join(" "), fill: "var(--fill)" })));
      const seen = new Set<string>();
      for (const face of faces) {
        face.forEach((from, i) => {
          const to = face[(i + 1) % face.length];
          const key = `${Math.min(from, to)} ${Math.max(from, to)}`;
          if (seen.has(key)) return;
          seen.add(key);
          const [[x1, y1], [x2, y2]] = [vertices[from], vertices[to]];
          const line = drawn("line", { x1, y1, x2, y2, stroke: "var(--accent)", "stroke-width": 0.06 });
          const wide = drawn("line", { x1, y1, x2, y2, stroke: "transparent", "stroke-width": 0.4, tabindex: 0, role: "button", "aria-label": `edge ${key}`, style: "cursor: pointer" });
          wide.addEventListener("click", () => void apply(from, to));
          wide.addEventListener("keydown", (event) => {
            if (event.key === "Enter") void apply(from, to);
          });
          svg.append(line, wide);
        });
      }
      vertices.forEach(([x, y], i) => svg.append(drawn("text", { x: x + 0.08, y: y - 0.1, style: "font-size: 0.3px" }, `v${i}`)));
      const written = await hands.run(["convert", "mesh.obj", "-o", "mesh.halfedges.json", "-q"], [file("mesh.obj", mesh)]);
      const report = written.status === 0 ? await hands.run(["info", "mesh.halfedges.json", "-q"], written.files) : written;
      facts.textContent = report.status === 0 ? text(report) : report.stderr;
    };
    const row = element("div", { class: "row" });
    const buttons = EDITS.map((name) => {
      const found = button(name, `a click on an edge: ${name}`, () => {
        edit = name;
        for (const other of buttons) other.setAttribute("aria-pressed", String(other === found));
      });
      found.setAttribute("aria-pressed", String(name === edit));
      return found;
    });
    row.append(
      ...buttons,
      button("undo", "take the last edit back", () => {
        if (states.length > 1) states.pop();
        void draw();
      }),
      button("keep as a model", "take the mesh among the models", () => hands.keep("mesh.obj", states[states.length - 1])),
    );
    place.append(row, said, svg, facts);
    void draw();
    return () => place.replaceChildren();
  },
};
