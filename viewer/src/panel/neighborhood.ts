/** What a click on a simplex shows: its star, closure, link and boundary, with their cells. */

import { CellSet, keyOf, type Cell, type Complex } from "../complex/complex";
import type { Scene } from "../scene/document";
import { PICKS, type Pick } from "../view/picking";
import { element, toggle } from "./elements";

export const NEIGHBORHOODS = ["selection", "star", "closure", "link", "boundary"] as const;
export type Neighborhood = (typeof NEIGHBORHOODS)[number];

/** So many cells are listed. */
const MOST = 400;

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

/** A cell by the numbers that the model gives its vertices. */
export function cellText(cell: Cell, model: Scene): string {
  const numbers = cell.vertices.map((vertex) => model.vertexNumbers[vertex] ?? vertex);
  return `{${numbers.join(", ")}}`;
}

/** What is known of a top cell: its number, its note, and its boundary as a chain. */
export function cellFacts(cell: Cell, complex: Complex, model: Scene): string[] {
  const solid = cell.dimension === 3 ? complex.solid(cell) : null;
  if (solid !== null) {
    const chain = complex.chain(solid).map(({ polygon, sign }) => `${sign}f${polygon}`);
    return [`cell ${solid}`, model.notes[solid] ?? "", `boundary: ${chain.join(" ")}`].filter(Boolean);
  }
  const polygon = cell.dimension === 2 ? complex.polygonNumber(cell) : null;
  if (polygon === null) return [];
  const note = model.cells.starts.length > 1 ? "" : (model.notes[polygon] ?? "");
  const walks = complex.walks(polygon).map((walk) => [...walk, walk[0]].join(" "));
  return [`face ${polygon}`, note, `around: ${walks.join("; ")}`].filter(Boolean);
}

export interface NeighborhoodActions {
  /** Draws what a word means. */
  choose(word: Neighborhood): void;
  /** Says what clicks mean. */
  pick(what: Pick): void;
}

export class NeighborhoodPanel {
  readonly root = element("section", { id: "neighborhood" });

  constructor(
    private readonly complex: Complex,
    private readonly model: Scene,
    private readonly actions: NeighborhoodActions,
  ) {}

  update(selection: CellSet, shown: Neighborhood, what: Pick): void {
    const picks = element("div", { class: "row" }, element("span", { class: "detail" }, "a click means"));
    const words = PICKS.filter((word) => word !== "cell" || this.model.cells.starts.length > 1);
    for (const word of words) picks.append(toggle(word, `clicks select: ${word}`, word === what, () => this.actions.pick(word)));
    this.root.replaceChildren(element("h2", {}, "neighborhood"), picks);
    if (selection.size === 0) {
      this.root.append(element("p", { class: "detail" }, "Click a vertex, an edge or a face; with Shift, several."));
      return;
    }
    const row = element("div", { class: "row" });
    const list = element("dl");
    let drawn: CellSet | null = null;
    for (const word of NEIGHBORHOODS) {
      const cells = neighborhoodOf(this.complex, selection, word);
      if (word === shown) drawn = cells;
      row.append(toggle(word, `draw the ${word}`, word === shown, () => this.actions.choose(word)));
      list.append(
        element("dt", {}, word),
        element("dd", { "data-count": word }, cells ? cells.counts().join(", ") || "empty" : "of no pure set"),
      );
    }
    const cells = drawn?.list() ?? [];
    const text = cells.slice(0, MOST).map((cell) => cellText(cell, this.model)).join(" ") + (cells.length > MOST ? " ..." : "");
    this.root.append(row, list, element("div", { class: "cells", "data-cells": shown }, text));
    const chosen = selection.list();
    const facts = chosen.length === 1 ? cellFacts(chosen[0], this.complex, this.model) : [];
    if (facts.length) {
      const box = element("div", { class: "cells", "data-facts": keyOf(chosen[0]) });
      for (const fact of facts) box.append(element("div", {}, fact));
      this.root.append(box);
    }
  }
}
