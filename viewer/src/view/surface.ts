/** The model: shaded triangles, the sides of polygons, loose edges and points. */

import * as THREE from "three";
import type { Scene } from "../scene/document";
import type { Stage } from "./stage";
import { THEMES, type Theme } from "./palette";

export class Surface {
  readonly mesh: THREE.Mesh;
  readonly edges: THREE.LineSegments;
  private readonly material: THREE.MeshLambertMaterial;
  private readonly edgeMaterial: THREE.LineBasicMaterial;
  /** The middle of the 3-cell of each triangle, three numbers each; empty without 3-cells. */
  private readonly middles: Float32Array;
  private readonly corners: Float32Array;
  private readonly clip = new THREE.Plane(new THREE.Vector3(-1, 0, 0), 0);

  constructor(
    private readonly model: Scene,
    private readonly stage: Stage,
  ) {
    const geometry = new THREE.BufferGeometry();
    // Triangles have corners of their own, so that each is flat and can move with its cell.
    const corners = new Float32Array(3 * model.triangles.length);
    for (let i = 0; i < model.triangles.length; i++) {
      for (let axis = 0; axis < 3; axis++) corners[3 * i + axis] = model.positions[3 * model.triangles[i] + axis];
    }
    this.corners = corners;
    this.middles = middlesOfCells(model, corners);
    geometry.setAttribute("position", new THREE.BufferAttribute(corners.slice(), 3));
    geometry.computeVertexNormals();
    this.material = new THREE.MeshLambertMaterial({
      side: THREE.DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
      clippingPlanes: [this.clip],
    });
    this.mesh = new THREE.Mesh(geometry, this.material);
    this.edgeMaterial = new THREE.LineBasicMaterial({ transparent: true, opacity: 0.55, clippingPlanes: [this.clip] });
    this.edges = new THREE.LineSegments(sides(model), this.edgeMaterial);
    stage.scene.add(this.mesh, this.edges);
    this.setClip(1);
  }

  setTheme(theme: Theme): void {
    this.material.color.set(THEMES[theme].surface);
    this.edgeMaterial.color.set(THEMES[theme].edge);
  }

  /** Shows the part of the model on one side of a plane: all of it at 1, nothing at 0. */
  setClip(share: number): void {
    const x = this.stage.center.x + (2 * share - 1) * this.stage.radius * 1.0001;
    this.clip.constant = share >= 1 ? Infinity : x;
    if (share >= 1) this.clip.constant = 1e30;
    this.stage.draw();
  }

  /** Moves 3-cells away from the middle: not at all at 0, to twice their distance at 1. */
  setExplode(share: number): void {
    if (this.middles.length === 0) return;
    const attribute = this.mesh.geometry.getAttribute("position") as THREE.BufferAttribute;
    const places = attribute.array as Float32Array;
    const center = this.stage.center.toArray();
    for (let i = 0; i < places.length; i++) {
      const axis = i % 3;
      places[i] = this.corners[i] + share * (this.middles[3 * Math.floor(i / 9) + axis] - center[axis]);
    }
    attribute.needsUpdate = true;
    this.mesh.geometry.computeBoundingSphere();
    this.edges.visible = share === 0;
    this.stage.draw();
  }

  /** The triangle under a place in the window, and the place on it. */
  pick(x: number, y: number): { triangle: number; point: THREE.Vector3 } | null {
    if (!this.mesh.visible) return null;
    const hits = this.stage.ray(x, y).intersectObject(this.mesh, false);
    const hit = hits.find((found) => this.clip.distanceToPoint(found.point) >= 0);
    return hit && hit.faceIndex != null ? { triangle: hit.faceIndex, point: hit.point } : null;
  }

  vertex(index: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.model.positions, 3 * index);
  }
}

/** For each triangle the middle of the corners of its 3-cell. */
function middlesOfCells(model: Scene, corners: Float32Array): Float32Array {
  const { cellOfTriangle } = model;
  if (cellOfTriangle.length === 0) return new Float32Array();
  const count = model.cells.starts.length - 1;
  const sums = new Float64Array(4 * count);
  cellOfTriangle.forEach((cell, triangle) => {
    if (cell >= count) return;
    for (let i = 0; i < 9; i++) sums[4 * cell + (i % 3)] += corners[9 * triangle + i];
    sums[4 * cell + 3] += 3;
  });
  const middles = new Float32Array(3 * cellOfTriangle.length);
  cellOfTriangle.forEach((cell, triangle) => {
    if (cell >= count) return;
    for (let axis = 0; axis < 3; axis++) middles[3 * triangle + axis] = sums[4 * cell + axis] / sums[4 * cell + 3];
  });
  return middles;
}

/** The sides of polygons, each once, and the edges that are in none. */
function sides(model: Scene): THREE.BufferGeometry {
  const { polygons, simplices } = model;
  const pairs: number[] = [];
  for (let p = 0; p + 1 < polygons.starts.length; p++) {
    const [start, end] = [polygons.starts[p], polygons.starts[p + 1]];
    for (let i = start; i < end; i++) pairs.push(polygons.items[i], polygons.items[i + 1 === end ? start : i + 1]);
  }
  for (let s = 0; s + 1 < simplices.starts.length; s++) {
    const [start, end] = [simplices.starts[s], simplices.starts[s + 1]];
    for (let i = start; i < end; i++) for (let j = i + 1; j < end; j++) pairs.push(simplices.items[i], simplices.items[j]);
  }
  // Numbers of pairs as one number, sorted: exact below 2^53.
  const count = Math.max(model.positions.length / 3, 1);
  const keys = new Float64Array(pairs.length / 2);
  for (let i = 0; i < keys.length; i++) {
    const [a, b] = [pairs[2 * i], pairs[2 * i + 1]];
    keys[i] = Math.min(a, b) * count + Math.max(a, b);
  }
  keys.sort();
  const items: number[] = [];
  for (let i = 0; i < keys.length; i++) {
    if (i > 0 && keys[i] === keys[i - 1]) continue;
    items.push(Math.floor(keys[i] / count), keys[i] % count);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(model.positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(items), 1));
  return geometry;
}
