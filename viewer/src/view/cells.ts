/** Sets of cells as layers. */

import type { CellSet, Complex } from "../complex/complex";
import { polygonOf, type Layer, type Scene } from "../scene/document";

/** The triangles of the polygons of a model: found once, when the first is asked for. */
export class TrianglesOfPolygons {
  private starts: Uint32Array | null = null;
  private items = new Uint32Array(0);

  constructor(private readonly model: Scene) {}

  of(polygon: number): Uint32Array {
    const starts = (this.starts ??= this.sort());
    return this.items.subarray(starts[polygon], starts[polygon + 1]);
  }

  private sort(): Uint32Array {
    const count = this.model.triangles.length / 3;
    const starts = new Uint32Array(this.model.polygons.starts.length);
    for (let t = 0; t < count; t++) starts[polygonOf(this.model, t) + 1] += 1;
    for (let p = 0; p + 1 < starts.length; p++) starts[p + 1] += starts[p];
    const next = starts.slice();
    this.items = new Uint32Array(count);
    for (let t = 0; t < count; t++) this.items[next[polygonOf(this.model, t)]++] = t;
    return starts;
  }
}

export function layerOfCells(name: string, cells: CellSet, complex: Complex, model: Scene, shaded: TrianglesOfPolygons): Layer {
  const points: number[] = [];
  const starts = [0];
  const lines: number[] = [];
  const triangles: number[] = [];
  const addPolygon = (polygon: number) => {
    for (const t of shaded.of(polygon)) triangles.push(...model.triangles.subarray(3 * t, 3 * t + 3));
  };
  for (const cell of cells.list()) {
    if (cell.dimension === 0) points.push(cell.vertices[0]);
    if (cell.dimension === 1) {
      lines.push(...cell.vertices);
      starts.push(lines.length);
    }
    if (cell.dimension === 2) {
      const polygon = cell.vertices.length === 3 ? null : complex.polygonNumber(cell);
      if (polygon !== null) addPolygon(polygon);
      else triangles.push(...cell.vertices.slice(0, 3));
    }
    if (cell.dimension === 3) {
      const solid = complex.solid(cell);
      if (solid !== null) complex.chain(solid).forEach(({ polygon }) => addPolygon(polygon));
    }
  }
  return {
    name,
    group: "neighborhood",
    detail: "",
    color: null,
    on: true,
    arrows: false,
    own: false,
    positions: model.positions,
    lines: { starts: Uint32Array.from(starts), items: Uint32Array.from(lines) },
    points: Uint32Array.from(points),
    triangles: Uint32Array.from(triangles),
    labels: [],
  };
}
