/** Fewer triangles for a picture that moves: vertices in one cell of a grid become one. */

import type { Scene } from "../scene/document";

/** Cells of the grid along the longest side of the model. */
const CELLS = 72;

/** Triangles between vertices of the model, few enough to be drawn often. */
export function coarseTriangles(model: Scene): Uint32Array {
  const { positions, triangles } = model;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    if (positions[i] < low[i % 3]) low[i % 3] = positions[i];
    if (positions[i] > high[i % 3]) high[i % 3] = positions[i];
  }
  const width = Math.max(...low.map((x, axis) => high[axis] - x)) / CELLS || 1;
  const numbers = new Map<number, number>();
  // For each vertex the number of its cell, and for each cell its first vertex.
  const cellOf = new Uint32Array(positions.length / 3);
  const firsts: number[] = [];
  for (let vertex = 0; vertex < cellOf.length; vertex++) {
    let key = 0;
    for (let axis = 0; axis < 3; axis++) key = key * (CELLS + 1) + Math.floor((positions[3 * vertex + axis] - low[axis]) / width);
    let number = numbers.get(key);
    if (number === undefined) {
      number = firsts.length;
      numbers.set(key, number);
      firsts.push(vertex);
    }
    cellOf[vertex] = number;
  }
  // Three numbers below 2^17 are one below 2^51.
  const base = 131072;
  const isExact = firsts.length <= base;
  const known = new Set<number>();
  const coarse: number[] = [];
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const [a, b, c] = [cellOf[triangles[t]], cellOf[triangles[t + 1]], cellOf[triangles[t + 2]]];
    if (a === b || b === c || c === a) continue;
    const [low, high] = [Math.min(a, b, c), Math.max(a, b, c)];
    const key = (low * base + (a + b + c - low - high)) * base + high;
    if (isExact && known.has(key)) continue;
    known.add(key);
    coarse.push(firsts[a], firsts[b], firsts[c]);
  }
  return Uint32Array.from(coarse);
}
