/**
 * Which triangle a ray meets first. Triangles that stand together in the file are in one box; the boxes are made with the first click, so
 * that a click on a million triangles looks at a few thousand boxes and at the triangles of those that it meets.
 */

import * as THREE from "three";
import type { Scene } from "../scene/document";
import type { Parts } from "./parts";

/** So many triangles have a box. */
const BLOCK = 128;

export class TrianglePicker {
  private boxes: Float32Array | null = null;

  constructor(
    private readonly model: Scene,
    private readonly clip: THREE.Plane,
    private readonly parts: Parts | null,
  ) {}

  /** The nearest triangle that is seen along a ray. */
  pick({ origin, direction }: THREE.Ray): number | null {
    const { triangles } = this.model;
    const count = triangles.length / 3;
    // Boxes are of what is in its place; cells that are taken apart are looked at one by one.
    const boxes = this.parts ? null : (this.boxes ??= this.blocks());
    let best: number | null = null;
    let nearest = Infinity;
    const from = origin.toArray();
    const along = direction.toArray();
    const moved: [number, number, number] = [0, 0, 0];
    let part = -1;
    let isShown = true;
    for (let block = 0; block * BLOCK < count; block++) {
      if (boxes && !meetsBox(from, along, boxes, 6 * block)) continue;
      for (let t = block * BLOCK; t < Math.min((block + 1) * BLOCK, count); t++) {
        if (this.parts && this.parts.partOfTriangle(t) !== part) {
          part = this.parts.partOfTriangle(t);
          isShown = !this.parts.areCells || this.parts.isShown(part);
          const offset = this.parts.offset(part);
          for (let axis = 0; axis < 3; axis++) moved[axis] = from[axis] - offset.getComponent(axis);
        }
        if (!isShown) continue;
        const distance = this.distance(t, this.parts ? moved : from, along);
        if (distance >= nearest) continue;
        const { normal, constant } = this.clip;
        const place = (axis: number) => (this.parts ? moved : from)[axis] + distance * along[axis];
        const isCut = normal.x * place(0) + normal.y * place(1) + normal.z * place(2) + constant < 0;
        if (isCut && !this.parts?.areCells) continue;
        nearest = distance;
        best = t;
      }
    }
    return best;
  }

  /** How far along a ray a triangle is: T. Moeller and B. Trumbore, Fast, minimum storage ray-triangle intersection (1997). */
  private distance(triangle: number, from: ArrayLike<number>, along: ArrayLike<number>): number {
    const { positions: p, triangles } = this.model;
    const a = 3 * triangles[3 * triangle];
    const b = 3 * triangles[3 * triangle + 1];
    const c = 3 * triangles[3 * triangle + 2];
    const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const [hx, hy, hz] = [along[1] * vz - along[2] * vy, along[2] * vx - along[0] * vz, along[0] * vy - along[1] * vx];
    const volume = ux * hx + uy * hy + uz * hz;
    if (volume === 0) return Infinity;
    const [sx, sy, sz] = [from[0] - p[a], from[1] - p[a + 1], from[2] - p[a + 2]];
    const first = (sx * hx + sy * hy + sz * hz) / volume;
    if (first < 0 || first > 1) return Infinity;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const second = (along[0] * qx + along[1] * qy + along[2] * qz) / volume;
    if (second < 0 || first + second > 1) return Infinity;
    const distance = (vx * qx + vy * qy + vz * qz) / volume;
    return distance > 0 ? distance : Infinity;
  }

  /** Lower and upper corners of boxes around blocks of triangles. */
  private blocks(): Float32Array {
    const { positions, triangles } = this.model;
    const boxes = new Float32Array(6 * Math.ceil(triangles.length / (3 * BLOCK)));
    for (let block = 0; 6 * block < boxes.length; block++) {
      boxes.fill(Infinity, 6 * block, 6 * block + 3).fill(-Infinity, 6 * block + 3, 6 * block + 6);
      for (let i = 3 * BLOCK * block; i < Math.min(3 * BLOCK * (block + 1), triangles.length); i++) {
        for (let axis = 0; axis < 3; axis++) {
          const x = positions[3 * triangles[i] + axis];
          if (x < boxes[6 * block + axis]) boxes[6 * block + axis] = x;
          if (x > boxes[6 * block + 3 + axis]) boxes[6 * block + 3 + axis] = x;
        }
      }
    }
    return boxes;
  }
}

/** Whether a ray meets a box. */
function meetsBox(from: ArrayLike<number>, along: ArrayLike<number>, boxes: Float32Array, at: number): boolean {
  let [enter, leave] = [0, Infinity];
  for (let axis = 0; axis < 3; axis++) {
    const low = (boxes[at + axis] - from[axis]) / along[axis];
    const high = (boxes[at + 3 + axis] - from[axis]) / along[axis];
    if (along[axis] === 0) {
      if (from[axis] < boxes[at + axis] || from[axis] > boxes[at + 3 + axis]) return false;
      continue;
    }
    enter = Math.max(enter, Math.min(low, high));
    leave = Math.min(leave, Math.max(low, high));
  }
  return enter <= leave;
}
