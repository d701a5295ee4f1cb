/** A polygon whose sides are glued by letters: which surface it is. */

import { button, element } from "../../src/panel/elements";
import { drawn, latest, text, type Hands, type Table } from "./table";

const COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

/** The sides of a word such as "a b a^-1 b^-1", "abAB" or "a b a' b'": numbers from 1, negative when run backwards; null for no word. */
export function sidesOf(word: string): { sides: number[]; letters: string[] } | null {
  const letters: string[] = [];
  const sides: number[] = [];
  const rest = word.replaceAll(/\s+/g, "").replaceAll(/([a-zA-Z])(\^-1|\^\{-1\}|'|⁻¹)/g, "$1-");
  if (!/^([a-zA-Z]-?)+$/.test(rest)) return null;
  for (const [, letter, sign] of rest.matchAll(/([a-zA-Z])(-?)/g)) {
    const name = letter.toLowerCase();
    if (!letters.includes(name)) letters.push(name);
    const isBack = (letter !== name) !== (sign === "-");
    sides.push((letters.indexOf(name) + 1) * (isBack ? -1 : 1));
  }
  return { sides, letters };
}

export const POLYGON: Table = {
  title: "glue a polygon",
  about: "name the sides of a polygon by letters: the surface, its group and its homology",
  open(place: HTMLElement, hands: Hands): () => void {
    const input = element("input", { "aria-label": "the letters of the sides", value: "a b a^-1 b^-1", spellcheck: "false" });
    const svg = drawn("svg", { viewBox: "-5 -4.4 10 8.8", role: "img", "aria-label": "the polygon" }) as SVGSVGElement;
    const facts = element("pre", { class: "facts", "aria-live": "polite" });
    const relator = () => sidesOf(input.value);
    const words = (sides: number[], letters: string[]) => ["generate", "presentation", "--generators", String(letters.length), "--relator", sides.join(","), "-o", "glued.json"];
    const compute = latest(async () => {
      const found = relator();
      draw();
      if (!found) {
        facts.textContent = "letters, and ^-1 or a capital for a side that runs backwards: a b a^-1 b^-1, or abAB";
        return;
      }
      const made = await hands.run(words(found.sides, found.letters), []);
      if (made.status !== 0) {
        facts.textContent = made.stderr;
        return;
      }
      const glued: [string, Uint8Array][] = [["glued.json", made.files.get("glued.json")!]];
      const report = await hands.run(["info", "glued.json", "-q"], glued);
      const group = await hands.run(["pi1", "glued.json", "-q"], glued);
      facts.textContent = `${text(report)}\n${text(group)}`;
    });
    const draw = () => {
      svg.replaceChildren();
      const found = relator();
      if (!found) return;
      const count = found.sides.length;
      const at = (i: number, radius: number) => {
        const angle = (2 * Math.PI * (i - 0.5)) / count + Math.PI / 2;
        return [radius * Math.cos(angle), -radius * Math.sin(angle)];
      };
      if (count > 2) svg.append(drawn("polygon", { points: found.sides.map((_, i) => at(i, 3.4).join(",")).join(" "), fill: "var(--fill)" }));
      svg.append(drawn("defs", {}, drawn("marker", { id: "arrow", viewBox: "0 0 10 10", refX: 5, refY: 5, markerWidth: 4, markerHeight: 4, orient: "auto-start-reverse" }, drawn("path", { d: "M0 0L10 5L0 10z", fill: "context-stroke" }))));
      found.sides.forEach((side, i) => {
        const ends = count > 2 ? [at(i, 3.4), at(i + 1, 3.4)] : [at(0, 3.4), at(1, 3.4)];
        const [from, to] = side > 0 ? ends : ends.toReversed();
        const bulge = count > 2 ? [0, 0] : [0, i === 0 ? -3 : 3];
        const middle = [(from[0] + to[0]) / 2 + bulge[0] / 2, (from[1] + to[1]) / 2 + bulge[1] / 2];
        const color = COLORS[(Math.abs(side) - 1) % COLORS.length];
        svg.append(drawn("polyline", { points: [from, middle, to].map((point) => point.join(",")).join(" "), fill: "none", stroke: color, "stroke-width": 0.09, "marker-mid": "url(#arrow)" }));
        svg.append(drawn("text", { x: middle[0] * 1.16, y: middle[1] * 1.16, "text-anchor": "middle", style: "font-size: 0.5px" }, found.letters[Math.abs(side) - 1]));
      });
    };
    input.addEventListener("input", compute);
    const presets = ["a b a^-1 b^-1", "a a", "a a^-1", "a b a b^-1", "a b a^-1 b^-1 c d c^-1 d^-1", "a a b b c c", "a a a"];
    const row = element("div", { class: "row" }, input);
    for (const preset of presets) {
      row.append(
        button(preset, "take these letters", () => {
          input.value = preset;
          compute();
        }),
      );
    }
    row.append(
      button("keep as a model", "take the surface among the models", () => {
        const found = relator();
        if (found) void hands.run(words(found.sides, found.letters), []).then(({ files }) => hands.keep("glued.json", new TextDecoder().decode(files.get("glued.json"))));
      }),
    );
    place.append(row, svg, facts);
    compute();
    return () => place.replaceChildren();
  },
};
