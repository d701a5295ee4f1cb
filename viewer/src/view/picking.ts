/** Which cell is meant by a click: the vertex or edge of the face under it that is near, or the face. */

import * as THREE from "three";
import type { Cell, Complex } from "../complex/complex";
import type { Scene } from "../scene/document";
import type { Stage } from "./stage";
import type { Surface } from "./surface";

/** How near in pixels a click must come to a vertex or an edge to mean it. */
const NEAR = 9;

export function pick(x: number, y: number, model: Scene, complex: Complex, surface: Surface, stage: Stage): Cell | null {
  const hit = surface.pick(x, y);
  const window = (vertex: number) => {
    const at = stage.project(surface.vertex(vertex));
    return new THREE.Vector2(at.x, at.y);
  };
  const mouse = new THREE.Vector2(x, y);
  if (!hit) return pickLoose(mouse, model, window);
  const polygon = model.polygonOfTriangle[hit.triangle];
  const walk = complex.polygon(polygon);
  const corners = walk.map(window);
  let best = -1;
  let distance = NEAR;
  corners.forEach((corner, i) => {
    if (corner.distanceTo(mouse) < distance) {
      distance = corner.distanceTo(mouse);
      best = i;
    }
  });
  if (best >= 0) return complex.vertexCell(walk[best]);
  distance = NEAR * 0.7;
  corners.forEach((corner, i) => {
    const next = corners[(i + 1) % corners.length];
    const to = distanceToSegment(mouse, corner, next);
    if (to < distance) {
      distance = to;
      best = i;
    }
  });
  if (best >= 0) {
    const ends = [walk[best], walk[(best + 1) % walk.length]].sort((a, b) => a - b);
    return { dimension: 1, vertices: ends };
  }
  return complex.polygonCell(polygon);
}

/** A vertex of the model near the mouse where there is no face. */
function pickLoose(mouse: THREE.Vector2, model: Scene, window: (vertex: number) => THREE.Vector2): Cell | null {
  let best = -1;
  let distance = NEAR;
  const count = model.positions.length / 3;
  // Few models without faces are large; those are not searched.
  if (count > 200000) return null;
  for (let vertex = 0; vertex < count; vertex++) {
    const to = window(vertex).distanceTo(mouse);
    if (to < distance) {
      distance = to;
      best = vertex;
    }
  }
  return best >= 0 ? { dimension: 0, vertices: [best] } : null;
}

function distanceToSegment(point: THREE.Vector2, a: THREE.Vector2, b: THREE.Vector2): number {
  const along = b.clone().sub(a);
  const length = along.lengthSq();
  const share = length > 0 ? Math.min(Math.max(point.clone().sub(a).dot(along) / length, 0), 1) : 0;
  return a.clone().addScaledVector(along, share).distanceTo(point);
}
