/** The edges of a model, each once, as pairs of vertices. */

import type { Scene } from "../scene/document";
import type { Ragged } from "../complex/complex";

/** Calls back with the two ends of each side of these walks. */
export function eachSide(walks: Ragged, visit: (a: number, b: number, walk: number) => void): void {
  const { starts, items } = walks;
  for (let walk = 0; walk + 1 < starts.length; walk++) {
    const [start, end] = [starts[walk], starts[walk + 1]];
    for (let i = start; i < end; i++) visit(items[i], items[i + 1 === end ? start : i + 1], walk);
  }
}

/** The sides of polygons. */
export function sideEdges(model: Scene): Uint32Array {
  const keys = new Float64Array(model.polygons.items.length + model.rims.items.length);
  const base = keyBase(model);
  let next = 0;
  for (const walks of [model.polygons, model.rims]) eachSide(walks, (a, b) => (keys[next++] = keyOfPair(a, b, base)));
  keys.sort();
  return pairsOf(keys, base);
}

/** The edges of simplices that are no sides of polygons. */
export function loneEdges(model: Scene): Uint32Array {
  const { starts, items } = model.simplices;
  const base = keyBase(model);
  const keys: number[] = [];
  for (let s = 0; s + 1 < starts.length; s++) {
    for (let i = starts[s]; i < starts[s + 1]; i++) for (let j = i + 1; j < starts[s + 1]; j++) keys.push(keyOfPair(items[i], items[j], base));
  }
  if (keys.length === 0) return new Uint32Array(0);
  const known = new Set<number>();
  for (const walks of [model.polygons, model.rims]) eachSide(walks, (a, b) => known.add(keyOfPair(a, b, base)));
  return pairsOf(Float64Array.from(keys.filter((key) => !known.has(key))).sort(), base);
}

function keyBase(model: Scene): number {
  return Math.max(model.positions.length / 3, 1);
}

/** A pair as one number: exact below 2^53. */
function keyOfPair(a: number, b: number, base: number): number {
  return a < b ? a * base + b : b * base + a;
}

/** The pairs of sorted keys, each once. */
function pairsOf(keys: Float64Array, base: number): Uint32Array {
  let count = 0;
  for (let i = 0; i < keys.length; i++) if (i === 0 || keys[i] !== keys[i - 1]) count += 1;
  const pairs = new Uint32Array(2 * count);
  let next = 0;
  for (let i = 0; i < keys.length; i++) {
    if (i > 0 && keys[i] === keys[i - 1]) continue;
    pairs[next++] = Math.floor(keys[i] / base);
    pairs[next++] = keys[i] % base;
  }
  return pairs;
}
