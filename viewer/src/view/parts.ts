/** Parts of a model that can be taken apart: its 3-cells, or its faces in the plane. */

import * as THREE from "three";
import type { Ragged } from "../complex/complex";
import { polygonOf, type Layer, type Scene } from "../scene/document";
import { eachSide } from "./edges";
import { colorOf } from "./palette";

/** Up to so many parts have colors of their own, in part. */
const MOST_TINTS = 200;
const TINT = 0.4;

/** More faces than this are not taken apart. */
const MOST_FACES = 50000;

export class Parts {
  /** Three numbers a part. */
  private readonly middles: Float32Array;
  private readonly uniforms: Record<string, THREE.IUniform>;
  private partsOfVertices: Uint32Array[] | null = null;

  private constructor(
    private readonly model: Scene,
    center: THREE.Vector3,
    readonly areCells: boolean,
    /** One more than there are cells, for what is in none. */
    readonly count: number,
  ) {
    this.middles = this.middlesOfParts(center);
    this.uniforms = {
      share: { value: 0 },
      center: { value: center.clone() },
      plane: { value: new THREE.Vector4(0, 0, 0, 1e30) },
    };
  }

  /** The parts of a model, if it has any. */
  static of(model: Scene, center: THREE.Vector3): Parts | null {
    const cellCount = model.cells.starts.length - 1;
    if (cellCount > 0) return new Parts(model, center, true, cellCount + 1);
    const faceCount = model.polygons.starts.length - 1;
    const isDrawing = model.dimension === 2 && faceCount > 1 && faceCount <= MOST_FACES;
    return isDrawing ? new Parts(model, center, false, faceCount) : null;
  }

  /** Whether parts are told apart by colors: two or more, but not too many. */
  get areTinted(): boolean {
    const count = this.areCells ? this.count - 1 : this.count;
    return count > 1 && count <= MOST_TINTS;
  }

  partOfTriangle(triangle: number): number {
    return this.areCells ? Math.min(this.model.cellOfTriangle[triangle], this.count - 1) : polygonOf(this.model, triangle);
  }

  get share(): number {
    return this.uniforms.share.value as number;
  }

  setShare(share: number): void {
    this.uniforms.share.value = share;
  }

  /** Leaves out the cells whose middle is beyond a place on an axis. */
  setPlane(axis: number, place: number): void {
    const plane = this.uniforms.plane.value as THREE.Vector4;
    plane.set(axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0, this.areCells ? place : 1e30);
  }

  offset(part: number): THREE.Vector3 {
    const middle = new THREE.Vector3().fromArray(this.middles, 3 * part);
    return middle.sub(this.uniforms.center.value as THREE.Vector3).multiplyScalar(this.share);
  }

  /** The parts that have all of these vertices. */
  around(vertices: ArrayLike<number>): number[] {
    const lists = (this.partsOfVertices ??= this.listsOfVertices());
    let found = Array.from(lists[vertices[0]] ?? []);
    for (let i = 1; i < vertices.length; i++) found = found.filter((part) => lists[vertices[i]].includes(part));
    return found;
  }

  isShown(part: number): boolean {
    const plane = this.uniforms.plane.value as THREE.Vector4;
    const middle = new THREE.Vector3().fromArray(this.middles, 3 * part);
    return plane.x * middle.x + plane.y * middle.y + plane.z * middle.z <= plane.w;
  }

  /** Triangles with corners of their own, in the order of the model. */
  triangleGeometry(): THREE.BufferGeometry {
    const { triangles } = this.model;
    const geometry = this.geometry(triangles, (corner) => this.partOfTriangle(Math.floor(corner / 3)));
    if (this.areTinted) {
      const colors = new Float32Array(3 * triangles.length);
      const color = new THREE.Color();
      for (let i = 0; i < triangles.length; i++) {
        color.set(colorOf(this.partOfTriangle(Math.floor(i / 3)))).lerp(new THREE.Color(1, 1, 1), 1 - TINT);
        color.toArray(colors, 3 * i);
      }
      geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3));
    }
    return geometry;
  }

  /** The sides of each part. */
  edgeGeometry(): THREE.BufferGeometry {
    const { cells, polygons } = this.model;
    const ends: number[] = [];
    const parts: number[] = [];
    const sidesOf = this.sidesOfPolygons();
    const add = (polygon: number, part: number, known: Set<number> | null) => {
      for (const [a, b] of sidesOf[polygon]) {
        const key = Math.min(a, b) * 4294967296 + Math.max(a, b);
        if (known?.has(key)) continue;
        known?.add(key);
        ends.push(a, b);
        parts.push(part);
      }
    };
    if (this.areCells) {
      const isFree = new Uint8Array(polygons.starts.length - 1).fill(1);
      for (let cell = 0; cell + 1 < cells.starts.length; cell++) {
        const known = new Set<number>();
        for (let i = cells.starts[cell]; i < cells.starts[cell + 1]; i++) {
          isFree[cells.items[i]] = 0;
          add(cells.items[i], cell, known);
        }
      }
      isFree.forEach((free, polygon) => free && add(polygon, this.count - 1, null));
    } else {
      for (let polygon = 0; polygon < this.count; polygon++) add(polygon, polygon, null);
    }
    return this.geometry(Uint32Array.from(ends), (end) => parts[Math.floor(end / 2)]);
  }

  /** Lets a material move parts and leave them out. */
  move(material: THREE.Material): void {
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      shader.vertexShader = `${HEAD}${shader.vertexShader}`
        .replace("#include <begin_vertex>", `#include <begin_vertex>\n${MOVE}`)
        .replace("#include <project_vertex>", `#include <project_vertex>\n${LEAVE_OUT}`);
    };
  }

  private geometry(vertices: Uint32Array, partOf: (place: number) => number): THREE.BufferGeometry {
    const places = new Float32Array(3 * vertices.length);
    const middles = new Float32Array(3 * vertices.length);
    for (let i = 0; i < vertices.length; i++) {
      const part = partOf(i);
      for (let axis = 0; axis < 3; axis++) {
        places[3 * i + axis] = this.model.positions[3 * vertices[i] + axis];
        middles[3 * i + axis] = this.middles[3 * part + axis];
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
    geometry.setAttribute("middle", new THREE.BufferAttribute(middles, 3));
    return geometry;
  }

  /** For each vertex the parts that it is a corner of, each once. */
  private listsOfVertices(): Uint32Array[] {
    const { cells, polygons, rims, polygonsOfRims, positions } = this.model;
    const partsOfPolygons: number[][] = Array.from({ length: polygons.starts.length - 1 }, (_, polygon) => (this.areCells ? [] : [polygon]));
    for (let cell = 0; this.areCells && cell + 1 < cells.starts.length; cell++) {
      for (let i = cells.starts[cell]; i < cells.starts[cell + 1]; i++) partsOfPolygons[cells.items[i]].push(cell);
    }
    const found: Set<number>[] = Array.from({ length: positions.length / 3 }, () => new Set());
    const add = (walks: Ragged, polygonOfWalk: (walk: number) => number) => {
      for (let walk = 0; walk + 1 < walks.starts.length; walk++) {
        const parts = partsOfPolygons[polygonOfWalk(walk)];
        for (let i = walks.starts[walk]; i < walks.starts[walk + 1]; i++) for (const part of parts) found[walks.items[i]].add(part);
      }
    };
    add(polygons, (walk) => walk);
    add(rims, (rim) => polygonsOfRims[rim]);
    return found.map((parts) => Uint32Array.from(parts));
  }

  private sidesOfPolygons(): [number, number][][] {
    const { polygons, rims, polygonsOfRims } = this.model;
    const sides: [number, number][][] = Array.from({ length: polygons.starts.length - 1 }, () => []);
    const collect = (walks: Ragged, polygonOfWalk: (walk: number) => number) =>
      eachSide(walks, (a, b, walk) => sides[polygonOfWalk(walk)].push([a, b]));
    collect(polygons, (walk) => walk);
    collect(rims, (rim) => polygonsOfRims[rim]);
    return sides;
  }

  /** The middle of the corners of the triangles of each part; what is in no cell stays where it is. */
  private middlesOfParts(center: THREE.Vector3): Float32Array {
    const { triangles, positions } = this.model;
    const sums = new Float64Array(4 * this.count);
    for (let i = 0; i < triangles.length; i++) {
      const part = this.partOfTriangle(Math.floor(i / 3));
      for (let axis = 0; axis < 3; axis++) sums[4 * part + axis] += positions[3 * triangles[i] + axis];
      sums[4 * part + 3] += 1;
    }
    const middles = new Float32Array(3 * this.count);
    for (let part = 0; part < this.count; part++) {
      const isFixed = sums[4 * part + 3] === 0 || (this.areCells && part === this.count - 1);
      for (let axis = 0; axis < 3; axis++) {
        middles[3 * part + axis] = isFixed ? center.getComponent(axis) : sums[4 * part + axis] / sums[4 * part + 3];
      }
    }
    return middles;
  }
}

const STILL = [new THREE.Vector3()];

/**
 * Where the points of a layer are seen that belong together: a side or a corner that parts have in common comes apart with them, and each
 * part keeps its own. What has points of its own stays where it is.
 */
export function offsetsOf(parts: Parts | null, layer: Layer, points: ArrayLike<number>): THREE.Vector3[] {
  if (!parts || layer.own || parts.share === 0) return STILL;
  const around = parts.around(points);
  return around.length === 0 ? STILL : around.filter((part) => parts.isShown(part)).map((part) => parts.offset(part));
}

const HEAD = "attribute vec3 middle;\nuniform float share;\nuniform vec3 center;\nuniform vec4 plane;\n";
const MOVE = "transformed += share * (middle - center);";
const LEAVE_OUT = "if (dot(plane.xyz, middle) > plane.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);";
