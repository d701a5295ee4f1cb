/** What a click on a simplex tells: its star, closure, link and boundary, with their cells. */

import { CellSet, type Cell, type Complex } from "../complex/complex";
import { element, toggle } from "./elements";

export const NEIGHBORHOODS = ["selection", "star", "closure", "link", "boundary"] as const;
export type Neighborhood = (typeof NEIGHBORHOODS)[number];

/** The cells that a word means for a selection; null where it means nothing. */
export function neighborhoodOf(complex: Complex, selection: CellSet, word: Neighborhood): CellSet | null {
  switch (word) {
    case "selection":
      return selection;
    case "star":
      return complex.star(selection);
    case "closure":
      return complex.closure(selection);
    case "link":
      return complex.link(selection);
    case "boundary":
      return complex.boundary(selection);
  }
}

export function cellText(cell: Cell): string {
  return `{${cell.vertices.join(", ")}}`;
}

/** The part of the panel; `choose` is called with the word to be drawn. */
export class NeighborhoodPanel {
  readonly root = element("section", { id: "neighborhood" });

  constructor(
    private readonly complex: Complex,
    private readonly choose: (word: Neighborhood) => void,
  ) {
    this.update(new CellSet(), "link");
  }

  update(selection: CellSet, shown: Neighborhood): void {
    this.root.replaceChildren(element("h2", {}, "neighborhood"));
    if (selection.size === 0) {
      this.root.append(element("p", { class: "detail" }, "Click a vertex, an edge or a face; with Shift, several."));
      return;
    }
    const row = element("div", { class: "row" });
    for (const word of NEIGHBORHOODS) row.append(toggle(word, `draw the ${word}`, word === shown, () => this.choose(word)));
    const list = element("dl");
    for (const word of NEIGHBORHOODS) {
      const cells = neighborhoodOf(this.complex, selection, word);
      list.append(
        element("dt", {}, word),
        element("dd", { "data-count": word }, cells ? cells.counts().join(", ") || "empty" : "of no pure set"),
      );
    }
    const cells = neighborhoodOf(this.complex, selection, shown)?.list() ?? [];
    const most = 400;
    const text = cells.slice(0, most).map(cellText).join(" ") + (cells.length > most ? " ..." : "");
    this.root.append(row, list, element("div", { class: "cells", "data-cells": shown }, text));
  }
}
