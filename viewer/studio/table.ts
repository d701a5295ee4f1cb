/** An answer in JSON as a table that opens. */

import { element } from "../src/panel/elements";

/** So many entries of a list are shown. */
const MOST = 40;

export function tableOf(value: unknown): HTMLElement {
  if (Array.isArray(value)) return listOf(value);
  if (value !== null && typeof value === "object") {
    const list = element("dl");
    for (const [key, inner] of Object.entries(value)) list.append(element("dt", {}, key.replaceAll("_", " ")), element("dd", {}, entryOf(inner)));
    return list;
  }
  return element("span", {}, value === null ? "none" : typeof value === "boolean" ? (value ? "yes" : "no") : String(value));
}

function listOf(values: unknown[]): HTMLElement {
  if (values.length === 0) return element("span", {}, "none");
  if (values.every((value) => typeof value !== "object" || value === null)) {
    const rest = values.length > MOST ? ` .. (${values.length.toLocaleString("en")} in all)` : "";
    return element("span", {}, values.slice(0, MOST).map(String).join(", ") + rest);
  }
  const list = element("ol", { start: "0" });
  for (const value of values.slice(0, MOST)) list.append(element("li", {}, entryOf(value)));
  if (values.length > MOST) list.append(element("li", {}, `.. ${values.length.toLocaleString("en")} in all`));
  return list;
}

/** Large things are closed at first. */
function entryOf(value: unknown): HTMLElement {
  if (JSON.stringify(value).length <= 120) return tableOf(value);
  const size = Array.isArray(value) ? `${value.length.toLocaleString("en")} entries` : "more";
  const inner = element("details", {}, element("summary", {}, size));
  inner.addEventListener("toggle", () => inner.childElementCount === 1 && inner.append(tableOf(value)));
  return inner;
}
