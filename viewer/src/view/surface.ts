/**
 * The model: shaded triangles, the sides of polygons, loose edges and vertices.
 *
 * A model without parts to take apart shares its vertices between triangles. With parts (3-cells; faces in the plane) each triangle has
 * corners of its own, which know the middle of their part: parts are moved and left out by the graphics processor.
 */

import * as THREE from "three";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Scene } from "../scene/document";
import { polygonOf } from "../scene/document";
import { coarseTriangles } from "./coarse";
import { loneEdges, sideEdges } from "./edges";
import { Parts } from "./parts";
import { THEMES, type Theme } from "./palette";
import { TrianglePicker } from "./picker";
import type { Stage } from "./stage";

/** With more edges than this, they are not drawn at first. */
const EDGES_UP_TO = 150000;

/** Fewer triangles than this are drawn whole while the picture moves. */
const COARSE_FROM = 200000;

/** A place on the model. */
export interface Hit {
  triangle: number;
  /** How far the part of the triangle is moved. */
  offset: THREE.Vector3;
}

export class Surface {
  readonly parts: Parts | null;
  private readonly material: THREE.MeshLambertMaterial;
  private readonly edgeMaterial: THREE.LineBasicMaterial;
  private readonly pointMaterial: THREE.PointsMaterial;
  private readonly curves: THREE.Object3D | null;
  private readonly picker: TrianglePicker;
  private edges: THREE.LineSegments | null = null;
  private points: THREE.Points | null = null;

  constructor(
    private readonly model: Scene,
    private readonly stage: Stage,
  ) {
    this.parts = Parts.of(model, stage.center);
    if (this.parts?.areCells) stage.planes = [];
    const { planes } = stage;
    this.material = new THREE.MeshLambertMaterial({
      side: THREE.DoubleSide,
      flatShading: true,
      vertexColors: this.parts?.areTinted ?? false,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
      clippingPlanes: planes,
    });
    this.edgeMaterial = new THREE.LineBasicMaterial({ transparent: true, opacity: 0.55, clippingPlanes: planes });
    this.pointMaterial = new THREE.PointsMaterial({ size: 6, sizeAttenuation: false, clippingPlanes: planes });
    let geometry = new THREE.BufferGeometry();
    if (this.parts) {
      geometry = this.parts.triangleGeometry();
      this.parts.move(this.material);
      this.parts.move(this.edgeMaterial);
    } else {
      geometry.setAttribute("position", new THREE.BufferAttribute(model.positions, 3));
      geometry.setIndex(new THREE.BufferAttribute(model.triangles, 1));
    }
    const mesh = new THREE.Mesh(geometry, this.material);
    mesh.frustumCulled = false;
    stage.scene.add(mesh);
    if (!this.parts && model.triangles.length > 3 * COARSE_FROM) this.drawCoarse(mesh);
    this.picker = new TrianglePicker(model, stage.clip, this.parts);
    this.curves = this.drawCurves();
    if (this.sideCount <= EDGES_UP_TO) this.showEdges(true);
    const isBare = model.triangles.length === 0 && !this.curves && model.layers.length === 0;
    if (isBare) this.showVertices(true);
  }

  private get sideCount(): number {
    return Math.max(this.model.polygons.items.length, this.model.triangles.length) / 2;
  }

  get hasEdges(): boolean {
    return this.edges?.visible ?? false;
  }

  get hasVertices(): boolean {
    return this.points?.visible ?? false;
  }

  /** The sides of polygons; found when they are shown for the first time. */
  showEdges(isOn: boolean): void {
    if (isOn && !this.edges && this.model.polygons.starts.length > 1) {
      const geometry = this.parts ? this.parts.edgeGeometry() : indexed(this.model.positions, sideEdges(this.model));
      this.edges = new THREE.LineSegments(geometry, this.edgeMaterial);
      this.edges.frustumCulled = false;
      this.stage.scene.add(this.edges);
    }
    if (this.edges) this.edges.visible = isOn;
    this.stage.draw();
  }

  showVertices(isOn: boolean): void {
    if (isOn && !this.points) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(this.model.positions, 3));
      this.points = new THREE.Points(geometry, this.pointMaterial);
      this.points.frustumCulled = false;
      this.stage.scene.add(this.points);
    }
    if (this.points) this.points.visible = isOn;
    this.stage.draw();
  }

  setTheme(theme: Theme): void {
    this.material.color.set(THEMES[theme].surface);
    this.edgeMaterial.color.set(THEMES[theme].edge);
    this.pointMaterial.color.set(THEMES[theme].text);
    this.curves?.traverse((part) => {
      if (part instanceof LineSegments2) part.material.color.set(THEMES[theme].curve);
    });
  }

  /** Shows the part of the model on one side of a plane across an axis, 0 to 2: all of it at 1, nothing at 0. 3-cells are left out whole. */
  setClip(share: number, axis: number): void {
    const normal = new THREE.Vector3().setComponent(axis, -1);
    const place = this.stage.center.getComponent(axis) + (2 * share - 1) * this.stage.radius * 1.0001;
    this.stage.clip.set(normal, share >= 1 ? 1e30 : place);
    this.parts?.setPlane(axis, share >= 1 ? 1e30 : place);
    this.stage.draw();
  }

  /** Moves parts away from the middle: not at all at 0, to twice their distance at 1. */
  setExplode(share: number): void {
    this.parts?.setShare(share);
    this.stage.draw();
  }

  /** The triangle that is seen at a place in the window. */
  pick(x: number, y: number): Hit | null {
    const triangle = this.model.triangles.length > 0 ? this.picker.pick(this.stage.ray(x, y)) : null;
    return triangle === null ? null : { triangle, offset: this.offset(triangle) };
  }

  /** How far the part of a triangle is moved. */
  offset(triangle: number): THREE.Vector3 {
    return this.parts ? this.parts.offset(this.parts.partOfTriangle(triangle)) : new THREE.Vector3();
  }

  /** How far a cell is moved that is a part. */
  offsetOfPart(part: number): THREE.Vector3 {
    return this.parts ? this.parts.offset(part) : new THREE.Vector3();
  }

  /** Whether a triangle is seen, as far as the cutting plane is asked. */
  isShown(triangle: number): boolean {
    if (this.parts?.areCells) return this.parts.isShown(this.parts.partOfTriangle(triangle));
    const corner = new THREE.Vector3();
    return [0, 1, 2].some((i) => this.stage.clip.distanceToPoint(this.corner(triangle, i, corner)) >= 0);
  }

  /** A corner of a triangle where it is seen. */
  corner(triangle: number, corner: number, place = new THREE.Vector3()): THREE.Vector3 {
    return place.fromArray(this.model.positions, 3 * this.model.triangles[3 * triangle + corner]).add(this.offset(triangle));
  }

  vertex(index: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.model.positions, 3 * index);
  }

  polygon(triangle: number): number {
    return polygonOf(this.model, triangle);
  }

  /** Draws fewer triangles while a picture moves that takes long. */
  private drawCoarse(mesh: THREE.Mesh): void {
    let coarse: THREE.Mesh | null = null;
    this.stage.onHurry((isHurried) => {
      if (isHurried && !coarse) {
        coarse = new THREE.Mesh(indexed(this.model.positions, coarseTriangles(this.model)), this.material);
        coarse.frustumCulled = false;
        this.stage.scene.add(coarse);
      }
      if (coarse) coarse.visible = isHurried;
      mesh.visible = !isHurried;
    });
  }

  /** Edges in no polygon are curves: thick lines. */
  private drawCurves(): THREE.Object3D | null {
    const edges = loneEdges(this.model);
    if (edges.length === 0) return null;
    if (edges.length > 2 * EDGES_UP_TO) {
      const lines = new THREE.LineSegments(indexed(this.model.positions, edges), this.edgeMaterial);
      this.stage.scene.add(lines);
      return lines;
    }
    const places = new Float32Array(3 * edges.length);
    edges.forEach((vertex, i) => places.set(this.model.positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(places);
    const lines = new LineSegments2(geometry, this.stage.lineMaterial("#000000", 2));
    this.stage.scene.add(lines);
    return lines;
  }
}

function indexed(positions: Float32Array, items: Uint32Array): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(items, 1));
  return geometry;
}
