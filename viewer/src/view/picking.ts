/** Which cell is meant by a click: the vertex or edge of the face under it that is near, the face, or the 3-cell. */

import * as THREE from "three";
import type { Cell, Complex } from "../complex/complex";
import type { Scene } from "../scene/document";
import { loneEdges } from "./edges";
import type { Stage } from "./stage";
import type { Surface } from "./surface";

/** How near in pixels a click must come to a vertex or an edge to mean it. */
const NEAR = 9;

/** What clicks mean: whatever is near, or cells of one dimension. */
export const PICKS = ["nearest", "vertex", "edge", "face", "cell"] as const;
export type Pick = (typeof PICKS)[number];

/** A cell, and how far it is seen from where it is. */
export interface Picked {
  cell: Cell;
  /** The part that it was picked on; null if it is not moved. */
  part: number | null;
}

export function pick(
  x: number,
  y: number,
  what: Pick,
  model: Scene,
  complex: Complex,
  surface: Surface,
  stage: Stage,
): Picked | null {
  const mouse = new THREE.Vector2(x, y);
  const hit = surface.pick(x, y);
  if (!hit) {
    const cell = pickLoose(mouse, model, stage);
    return cell && { cell, part: null };
  }
  const part = surface.parts?.partOfTriangle(hit.triangle) ?? null;
  const polygon = surface.polygon(hit.triangle);
  const window = (vertex: number) => {
    const at = stage.project(surface.vertex(vertex).add(hit.offset));
    return new THREE.Vector2(at.x, at.y);
  };
  const solid = model.cells.starts.length > 1 ? model.cellOfTriangle[hit.triangle] : Infinity;
  if (what === "cell" && solid + 1 < model.cells.starts.length) return { cell: complex.solidCell(solid), part };
  if (what === "face" || what === "cell") return { cell: complex.polygonCell(polygon), part };
  const walks = complex.walks(polygon).map((walk) => walk.map((vertex) => ({ vertex, at: window(vertex) })));
  let cell: Cell | null = null;
  let distance = what === "vertex" ? Infinity : NEAR;
  if (what !== "edge") {
    for (const { vertex, at } of walks.flat()) {
      if (at.distanceTo(mouse) < distance) {
        distance = at.distanceTo(mouse);
        cell = complex.vertexCell(vertex);
      }
    }
    if (cell) return { cell, part };
  }
  distance = what === "edge" ? Infinity : NEAR * 0.7;
  for (const walk of walks) {
    walk.forEach(({ vertex, at }, i) => {
      const next = walk[(i + 1) % walk.length];
      const to = distanceToSegment(mouse, at, next.at);
      if (to < distance) {
        distance = to;
        cell = { dimension: 1, vertices: [vertex, next.vertex].sort((a, b) => a - b) };
      }
    });
  }
  return { cell: cell ?? complex.polygonCell(polygon), part };
}

/** A vertex or an edge in no face, near the mouse where there is no face. */
function pickLoose(mouse: THREE.Vector2, model: Scene, stage: Stage): Cell | null {
  const count = model.positions.length / 3;
  // Few models without faces are large; those are not searched.
  if (count > 200000) return null;
  const places = new Float32Array(2 * count);
  const point = new THREE.Vector3();
  let best: Cell | null = null;
  let distance = NEAR;
  const at = (vertex: number) => new THREE.Vector2().fromArray(places, 2 * vertex);
  for (let vertex = 0; vertex < count; vertex++) {
    const place = stage.project(point.fromArray(model.positions, 3 * vertex));
    places[2 * vertex] = place.x;
    places[2 * vertex + 1] = place.y;
    const to = Math.hypot(place.x - mouse.x, place.y - mouse.y);
    if (to < distance) {
      distance = to;
      best = { dimension: 0, vertices: [vertex] };
    }
  }
  if (best) return best;
  const edges = loneEdges(model);
  for (let i = 0; i < edges.length; i += 2) {
    const to = distanceToSegment(mouse, at(edges[i]), at(edges[i + 1]));
    if (to < distance) {
      distance = to;
      best = { dimension: 1, vertices: [edges[i], edges[i + 1]] };
    }
  }
  return best;
}

function distanceToSegment(point: THREE.Vector2, a: THREE.Vector2, b: THREE.Vector2): number {
  const along = b.clone().sub(a);
  const length = along.lengthSq();
  const share = length > 0 ? Math.min(Math.max(point.clone().sub(a).dot(along) / length, 0), 1) : 0;
  return a.clone().addScaledVector(along, share).distanceTo(point);
}
