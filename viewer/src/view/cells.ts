/** Sets of cells as layers. */

import type { CellSet, Complex } from "../complex/complex";
import type { Layer, Scene } from "../scene/document";

export function layerOfCells(name: string, cells: CellSet, complex: Complex, model: Scene): Layer {
  const points: number[] = [];
  const starts = [0];
  const lines: number[] = [];
  const triangles: number[] = [];
  const polygons = new Map<string, number[]>();
  for (const cell of cells.list()) {
    if (cell.dimension === 0) points.push(cell.vertices[0]);
    if (cell.dimension === 1) {
      lines.push(...cell.vertices);
      starts.push(lines.length);
    }
    if (cell.dimension === 2 && cell.vertices.length === 3) triangles.push(...cell.vertices);
    if (cell.dimension === 2 && cell.vertices.length > 3) polygons.set(cell.vertices.join(","), cell.vertices);
  }
  if (polygons.size > 0) {
    for (let t = 0; 3 * t < model.triangles.length; t++) {
      const polygon = model.polygonOfTriangle[t];
      if (polygons.has(complex.polygonCell(polygon).vertices.join(","))) triangles.push(...model.triangles.subarray(3 * t, 3 * t + 3));
    }
  }
  return {
    name,
    group: "neighborhood",
    detail: "",
    color: null,
    on: true,
    positions: model.positions,
    lines: { starts: Uint32Array.from(starts), items: Uint32Array.from(lines) },
    points: Uint32Array.from(points),
    triangles: Uint32Array.from(triangles),
    labels: [],
  };
}
