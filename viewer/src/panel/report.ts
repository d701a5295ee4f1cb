/** The report of `coface info` as a list of terms. */

import { countsText } from "../complex/complex";
import type { HomologyGroup } from "../scene/answers";
import type { Report } from "../scene/document";
import { element } from "./elements";

/** Z^2 + Z/3, or 0. */
export function groupText({ betti, torsion }: Pick<HomologyGroup, "betti" | "torsion">): string {
  const parts = torsion.map((m) => `Z/${m}`);
  if (betti === 1) parts.unshift("Z");
  if (betti > 1) parts.unshift(`Z^${betti}`);
  return parts.length > 0 ? parts.join(" + ") : "0";
}

function yesNo(value: unknown): string | null {
  return value === null || value === undefined ? null : value ? "yes" : "no";
}

export function reportElement(report: Report): HTMLElement {
  const list = element("dl");
  const say = (term: string, text: string | null | undefined) => {
    if (text !== null && text !== undefined && text !== "") list.append(element("dt", {}, term), element("dd", {}, text));
  };
  const number = (value: unknown) =>
    typeof value === "number" ? (Number.isInteger(value) ? String(value) : value.toPrecision(7)) : null;
  say("name", report.name);
  say("cells", report.f_vector && countsText(report.f_vector));
  say("components", number(report.components));
  say("Euler characteristic", number(report.euler_characteristic));
  const manifold = report.manifold;
  if (manifold) {
    const closed = manifold.verdict === "yes" ? (manifold.closed ? ", closed" : ", with boundary") : "";
    say("manifold", `${manifold.verdict}${closed}`);
    say("because", manifold.witness?.message);
  }
  say("boundary loops", number(report.boundary_loops));
  say("orientable", yesNo(report.orientable));
  say("genus", number(report.genus));
  for (const group of report.homology ?? []) say(`H${group.degree}`, groupText(group));
  for (const [key, word] of [["order", "order"], ["perimeter", "perimeter"], ["kinks", "kinks"]] as const) say(word, number(report[key]));
  say("bounded", yesNo(report.bounded));
  for (const [key, word] of [["betti_open", "components, holes"], ["betti_closed", "of the closure"], ["curve_counts", "curves +, -"]] as const) {
    say(word, report[key]?.join(", "));
  }
  say("area", number(report.area));
  say("signed volume", number(report.signed_volume));
  const section = element("section", {}, element("h2", {}, "report"), list);
  for (const warning of report.warnings ?? []) {
    section.append(element("p", { class: "warning" }, warning));
  }
  return section;
}
