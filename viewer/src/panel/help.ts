/** What keys and fingers do. */

import { button, element } from "./elements";

export const KEYS: [string, string][] = [
  ["drag, one finger", "turn; in the plane, move"],
  ["wheel, two fingers", "zoom; moving two fingers moves"],
  ["click, tap", "select a cell; with Shift, several"],
  ["arrows", "turn, with Shift by little; in the plane, move"],
  ["+ and -", "zoom"],
  ["R", "look at everything"],
  ["E, V", "edges, vertices"],
  ["1 to 5", "selection, star, closure, link, boundary"],
  ["M", "what a click means: nearest, vertex, edge, face, cell"],
  ["N, Shift+N", "show the next or last layer alone, and look at it"],
  ["[ and ]", "move the cutting plane; C turns it"],
  [", and .", "put together and take apart"],
  ["U", "y or z up"],
  ["D", "light or dark"],
  ["P, S", "save the picture as PNG, as SVG"],
  ["L", "a link to this view"],
  ["Escape", "select nothing"],
  ["?", "this help"],
];

export function showHelp(): void {
  if (document.querySelector("dialog.help")) return;
  const list = element("dl");
  for (const [key, what] of KEYS) list.append(element("dt", {}, key), element("dd", {}, what));
  const dialog = element("dialog", { class: "help", "aria-label": "help" }, element("h1", {}, "Keys and fingers"), list);
  dialog.append(element("div", { class: "row" }, button("close", "close (Escape)", () => dialog.close())));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
