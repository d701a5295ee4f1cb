/**
 * A cell complex by its top cells: what a click needs to know about stars, closures, links and boundaries.
 *
 * A cell is a sorted list of vertices with a dimension. Simplices have all their subsets as faces; polygons have their sides. Only
 * the neighborhood of what is asked about is ever listed, so a click costs the same on a million triangles.
 */

/** Lists one after the other in one array. */
export interface Ragged {
  /** Where each list begins, and where the last ends. */
  starts: Uint32Array;
  items: Uint32Array;
}

const NO_LISTS: Ragged = { starts: new Uint32Array(1), items: new Uint32Array(0) };

/** A cell: its vertices rising, and its dimension. */
export interface Cell {
  dimension: number;
  vertices: number[];
}

/** Cells without repetition. */
export class CellSet {
  private readonly cells = new Map<string, Cell>();

  static of(cells: Iterable<Cell>): CellSet {
    const set = new CellSet();
    for (const cell of cells) set.add(cell);
    return set;
  }

  add(cell: Cell): void {
    this.cells.set(keyOf(cell), cell);
  }

  has(cell: Cell): boolean {
    return this.cells.has(keyOf(cell));
  }

  get size(): number {
    return this.cells.size;
  }

  /** By dimension, then by vertices. */
  list(): Cell[] {
    return [...this.cells.values()].sort(compareCells);
  }

  /** The number of cells of each dimension from 0 to the highest. */
  counts(): number[] {
    const counts: number[] = [];
    for (const { dimension } of this.cells.values()) {
      while (counts.length <= dimension) counts.push(0);
      counts[dimension] += 1;
    }
    return counts;
  }

  /** The cells that are not in another set. */
  without(other: CellSet): CellSet {
    return CellSet.of(this.list().filter((cell) => !other.has(cell)));
  }
}

/** What cells of a dimension are called. */
const NAMES = ["vertex", "edge", "face", "cell"];
const PLURALS = ["vertices", "edges", "faces", "cells"];

/** A number of cells with their name: 1,152 vertices. */
export function countText(count: number, dimension: number): string {
  const name = dimension > 3 ? `cells of dimension ${dimension}` : (count === 1 ? NAMES : PLURALS)[dimension];
  return `${count.toLocaleString("en")} ${name}`;
}

/** Numbers of cells of each dimension from 0 on with their names; those that are none are left out. */
export function countsText(counts: number[]): string {
  return counts.map((count, dimension) => (count > 0 ? countText(count, dimension) : "")).filter(Boolean).join(", ");
}

export function keyOf(cell: Cell): string {
  return `${cell.dimension}:${cell.vertices.join(",")}`;
}

function compareCells(a: Cell, b: Cell): number {
  if (a.dimension !== b.dimension) return a.dimension - b.dimension;
  for (let i = 0; i < Math.min(a.vertices.length, b.vertices.length); i++) {
    if (a.vertices[i] !== b.vertices[i]) return a.vertices[i] - b.vertices[i];
  }
  return a.vertices.length - b.vertices.length;
}

/** Polygons as walks of vertices, simplices of any dimension, or both. */
export class Complex {
  /** For each vertex the top cells that contain it. */
  private readonly around: Ragged;
  /** For each polygon the 3-cells that it bounds. */
  private readonly cellsOfPolygon: Ragged;
  /** For each polygon its rims. */
  private readonly rimsOfPolygon = new Map<number, number[]>();

  /**
   * @param vertexCount the number of vertices
   * @param polygons the vertices around each polygon
   * @param simplices the vertices of each further top cell, a simplex
   * @param cells the polygons around each 3-cell
   * @param signs for each of these whether the cell has it with a minus; empty where that is not known
   * @param rims walks around polygons beyond the first
   * @param polygonsOfRims the polygon of each rim
   */
  constructor(
    readonly vertexCount: number,
    readonly polygons: Ragged,
    readonly simplices: Ragged,
    readonly cells: Ragged = NO_LISTS,
    readonly signs: Uint32Array = new Uint32Array(0),
    readonly rims: Ragged = NO_LISTS,
    polygonsOfRims: Uint32Array = new Uint32Array(0),
  ) {
    polygonsOfRims.forEach((polygon, rim) => {
      this.rimsOfPolygon.set(polygon, [...(this.rimsOfPolygon.get(polygon) ?? []), rim]);
    });
    this.around = transpose(vertexCount, [polygons, simplices], { lists: rims, numbers: polygonsOfRims });
    this.cellsOfPolygon = transpose(polygons.starts.length - 1, [cells]);
  }

  get polygonCount(): number {
    return this.polygons.starts.length - 1;
  }

  /** The walk around a polygon. */
  polygon(index: number): number[] {
    return Array.from(this.polygons.items.subarray(this.polygons.starts[index], this.polygons.starts[index + 1]));
  }

  /** All walks around a polygon: around itself, and around its holes. */
  walks(index: number): number[][] {
    const { starts, items } = this.rims;
    const rims = this.rimsOfPolygon.get(index) ?? [];
    return [this.polygon(index), ...rims.map((rim) => Array.from(items.subarray(starts[rim], starts[rim + 1])))];
  }

  /** A polygon as a cell. */
  polygonCell(index: number): Cell {
    return { dimension: 2, vertices: rising([...new Set(this.walks(index).flat())]) };
  }

  /** Whether this is a cell of the complex. */
  has(cell: Cell): boolean {
    const first = cell.vertices[0];
    if (!(first >= 0 && first < this.vertexCount)) return false;
    if (cell.dimension === 0) return cell.vertices.length === 1;
    const key = keyOf(cell);
    if (cell.dimension === 3 && this.solid(cell) !== null) return true;
    for (const top of this.topCellsAround(first)) if (this.facesOfTop(top).some((face) => keyOf(face) === key)) return true;
    return false;
  }

  /** The number of a 3-cell that is not a simplex of its own. */
  solid(cell: Cell): number | null {
    const key = keyOf(cell);
    for (const top of this.topCellsAround(cell.vertices[0])) {
      if (top >= this.polygonCount) continue;
      for (const solid of this.cellsAround(top)) if (keyOf(this.solidCell(solid)) === key) return solid;
    }
    return null;
  }

  /** The number of a polygon. */
  polygonNumber(cell: Cell): number | null {
    const key = keyOf(cell);
    for (const top of this.topCellsAround(cell.vertices[0])) {
      if (top < this.polygonCount && keyOf(this.polygonCell(top)) === key) return top;
    }
    return null;
  }

  /** The boundary of a 3-cell as a chain of polygons with signs; without signs where they are not known. */
  chain(solid: number): { polygon: number; sign: string }[] {
    const start = this.cells.starts[solid];
    return this.polygonsOfCell(solid).map((polygon, i) => ({
      polygon,
      sign: this.signs.length === 0 ? "" : this.signs[start + i] ? "-" : "+",
    }));
  }

  vertexCell(vertex: number): Cell {
    return { dimension: 0, vertices: [vertex] };
  }

  /** All cells that have one of these as a face, these included. */
  star(of: CellSet): CellSet {
    const star = new CellSet();
    for (const cell of of.list()) {
      star.add(cell);
      if (cell.dimension === 3) continue;
      for (const top of this.topCellsAround(cell.vertices[0])) {
        const faces = this.facesOfTop(top);
        if (!faces.some((face) => keyOf(face) === keyOf(cell))) continue;
        if (top < this.polygonCount) for (const around of this.cellsAround(top)) star.add(this.solidCell(around));
        const own = new Set(cell.vertices);
        for (const face of faces) {
          if (face.dimension <= cell.dimension) continue;
          const shared = face.vertices.filter((v) => own.has(v)).length;
          if (shared === own.size) star.add(face);
        }
      }
    }
    return star;
  }

  /** These cells and all their faces. */
  closure(of: CellSet): CellSet {
    const closure = new CellSet();
    for (const cell of of.list()) for (const face of this.faces(cell)) closure.add(face);
    return closure;
  }

  /** Closure of the star without the star of the closure. */
  link(of: CellSet): CellSet {
    return this.closure(this.star(of)).without(this.star(this.closure(of)));
  }

  /**
   * The closure of the faces that lie in exactly one cell of a pure set, one dimension lower; null for sets that are not pure.
   */
  boundary(of: CellSet): CellSet | null {
    const cells = of.list();
    if (cells.length === 0) return new CellSet();
    const dimension = cells[cells.length - 1].dimension;
    const tops = cells.filter((cell) => cell.dimension === dimension);
    const closure = this.closure(CellSet.of(tops));
    if (cells.some((cell) => !closure.has(cell))) return null;
    const uses = new Map<string, { cell: Cell; count: number }>();
    for (const top of tops) {
      for (const face of this.faces(top)) {
        if (face.dimension !== dimension - 1) continue;
        const use = uses.get(keyOf(face));
        if (use) use.count += 1;
        else uses.set(keyOf(face), { cell: face, count: 1 });
      }
    }
    return this.closure(CellSet.of([...uses.values()].filter((use) => use.count === 1).map((use) => use.cell)));
  }

  /** A 3-cell by its vertices. */
  solidCell(index: number): Cell {
    const polygons = this.polygonsOfCell(index);
    return { dimension: 3, vertices: rising([...new Set(polygons.flatMap((polygon) => this.polygon(polygon)))]) };
  }

  private polygonsOfCell(index: number): number[] {
    return Array.from(this.cells.items.subarray(this.cells.starts[index], this.cells.starts[index + 1]));
  }

  private cellsAround(polygon: number): number[] {
    const { starts, items } = this.cellsOfPolygon;
    return Array.from(items.subarray(starts[polygon], starts[polygon + 1]));
  }

  /** A cell and all its faces. */
  faces(cell: Cell): Cell[] {
    if (cell.dimension === 3) {
      const solid = this.solid(cell);
      if (solid !== null) return [...this.polygonsOfCell(solid).flatMap((polygon) => this.facesOfTop(polygon)), cell];
    }
    if (cell.dimension === 2 && cell.vertices.length > 3) {
      const polygon = this.polygonNumber(cell);
      if (polygon !== null) return this.facesOfTop(polygon);
    }
    return subsets(cell.vertices);
  }

  private *topCellsAround(vertex: number): Generator<number> {
    for (let i = this.around.starts[vertex]; i < this.around.starts[vertex + 1]; i++) yield this.around.items[i];
  }

  private facesOfTop(top: number): Cell[] {
    if (top >= this.polygonCount) {
      const { starts, items } = this.simplices;
      const index = top - this.polygonCount;
      return subsets(rising(Array.from(items.subarray(starts[index], starts[index + 1]))));
    }
    const walks = this.walks(top);
    const sides = walks.flatMap((walk) => walk.map((v, i) => ({ dimension: 1, vertices: rising([v, walk[(i + 1) % walk.length]]) })));
    return [...walks.flat().map((v) => this.vertexCell(v)), ...sides, this.polygonCell(top)];
  }
}

function rising(list: number[]): number[] {
  return [...list].sort((a, b) => a - b);
}

/** All non-empty subsets of rising vertices, as simplices. */
function subsets(vertices: number[]): Cell[] {
  const found: Cell[] = [];
  for (let mask = 1; mask < 1 << vertices.length; mask++) {
    const subset = vertices.filter((_, i) => mask & (1 << i));
    found.push({ dimension: subset.length - 1, vertices: subset });
  }
  return found;
}

/**
 * For each vertex the lists that it is in, over several arrays of lists numbered one after the other; further lists have numbers of
 * their own.
 */
function transpose(vertexCount: number, parts: Ragged[], more?: { lists: Ragged; numbers: Uint32Array }): Ragged {
  const starts = new Uint32Array(vertexCount + 1);
  const all = more ? [...parts, more.lists] : parts;
  for (const { items } of all) for (let i = 0; i < items.length; i++) starts[items[i] + 1] += 1;
  for (let v = 0; v < vertexCount; v++) starts[v + 1] += starts[v];
  const next = starts.slice();
  const items = new Uint32Array(starts[vertexCount]);
  let number = 0;
  for (const part of parts) {
    for (let i = 0; i + 1 < part.starts.length; i++, number++) {
      for (let at = part.starts[i]; at < part.starts[i + 1]; at++) items[next[part.items[at]]++] = number;
    }
  }
  more?.numbers.forEach((own, i) => {
    const { lists } = more;
    for (let at = lists.starts[i]; at < lists.starts[i + 1]; at++) items[next[lists.items[at]]++] = own;
  });
  return { starts, items };
}
