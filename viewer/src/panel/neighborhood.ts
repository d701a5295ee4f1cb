/** What a click on a simplex shows: its star, closure, link and boundary, with their cells. */

import { CellSet, countsText, countText, keyOf, type Cell, type Complex } from "../complex/complex";
import type { Scene } from "../scene/document";
import { PICKS, type Pick } from "../view/picking";
import { button, element, toggle } from "./elements";

export const NEIGHBORHOODS = ["selection", "star", "closure", "link", "boundary"] as const;
export type Neighborhood = (typeof NEIGHBORHOODS)[number];

/** The dimensions of what is found by its number. */
const DIMENSIONS = { vertex: 0, face: 2, cell: 3 };

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

/** What is known of a cell: its name, where it is and what it lies in; of a top cell its note, and its boundary as a chain. */
export function cellFacts(cell: Cell, complex: Complex, model: Scene): string[] {
  if (cell.dimension < 2) return smallCellFacts(cell, complex, model);
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

/** Of a vertex its number, its place and its cofaces; of an edge its ends, its length and its cofaces. */
function smallCellFacts(cell: Cell, complex: Complex, model: Scene): string[] {
  const { origin, positions, dimension } = model;
  const place = (vertex: number) => [0, 1, 2].slice(0, dimension).map((axis) => positions[3 * vertex + axis] + origin[axis]);
  const number = (vertex: number) => model.vertexNumbers[vertex] ?? vertex;
  const around = complex.star(CellSet.of([cell])).counts();
  around[cell.dimension] = 0;
  const inside = countsText(around);
  const within = inside ? `in ${inside}` : "in no other cell";
  if (cell.dimension === 0) {
    const [vertex] = cell.vertices;
    const at = place(vertex).map((x) => String(Number(x.toPrecision(7))));
    return [`vertex ${number(vertex)} at (${at.join(", ")})`, within];
  }
  const [a, b] = cell.vertices;
  const [from, to] = [place(a), place(b)];
  const length = Math.hypot(...from.map((x, axis) => x - to[axis]));
  return [`edge from vertex ${number(a)} to vertex ${number(b)}, length ${Number(length.toPrecision(6))}`, within];
}

export interface NeighborhoodActions {
  /** Draws what a word means. */
  choose(word: Neighborhood): void;
  /** Says what clicks mean. */
  pick(what: Pick): void;
  /** Selects a cell and looks at it. */
  find(cell: Cell): void;
}

export class NeighborhoodPanel {
  readonly root = element("section", { id: "neighborhood" });

  private readonly finder: HTMLFormElement;

  constructor(
    private readonly complex: Complex,
    private readonly model: Scene,
    private readonly actions: NeighborhoodActions,
  ) {
    this.finder = this.finderElement();
  }

  /** A field for the number of a vertex, a face or a cell. */
  private finderElement(): HTMLFormElement {
    const counts = { vertex: this.complex.vertexCount, face: this.complex.polygonCount, cell: this.model.cells.starts.length - 1 };
    const words = (Object.keys(counts) as (keyof typeof counts)[]).filter((word) => counts[word] > 0);
    const kind = element("select", { "aria-label": "what to find" }, ...words.map((word) => element("option", {}, word)));
    const field = element("input", { inputmode: "numeric", size: "7", "aria-label": "its number", placeholder: "number" });
    const answer = element("span", { class: "detail", role: "status" });
    const form = element("form", { class: "row" }, element("span", { class: "detail" }, "find"), kind, field, button("go", "select it and look at it", () => form.requestSubmit()), answer);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const word = kind.value as keyof typeof counts;
      const cell = this.numbered(word, Number(field.value.trim() || NaN));
      answer.textContent = cell ? "" : `no such ${word}; there are ${countText(counts[word], DIMENSIONS[word])}, counted from 0`;
      if (cell) this.actions.find(cell);
    });
    return form;
  }

  /** The cell with a number, as the model counts: from 0. */
  private numbered(word: "vertex" | "face" | "cell", number: number): Cell | null {
    if (!Number.isInteger(number) || number < 0) return null;
    const { vertexNumbers, cells } = this.model;
    const vertex = vertexNumbers.length > 0 ? vertexNumbers.indexOf(number) : number;
    if (word === "vertex") return vertex >= 0 && vertex < this.complex.vertexCount ? this.complex.vertexCell(vertex) : null;
    if (word === "face") return number < this.complex.polygonCount ? this.complex.polygonCell(number) : null;
    return number + 1 < cells.starts.length ? this.complex.solidCell(number) : null;
  }

  update(selection: CellSet, shown: Neighborhood, what: Pick): void {
    const picks = element("div", { class: "row" }, element("span", { class: "detail" }, "a click means"));
    const words = PICKS.filter((word) => word !== "cell" || this.model.cells.starts.length > 1);
    for (const word of words) picks.append(toggle(word, `clicks select: ${word}`, word === what, () => this.actions.pick(word)));
    this.root.replaceChildren(element("h2", {}, "neighborhood"), picks, this.finder);
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
        element("dd", { "data-count": word }, cells ? countsText(cells.counts()) || "empty" : "of no pure set"),
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
