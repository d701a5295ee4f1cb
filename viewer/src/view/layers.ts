/** Layers: generators, cuts, loops, witnesses, neighborhoods, drawn over the model. */

import * as THREE from "three";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Layer } from "../scene/document";
import { offsetsOf, type Parts } from "./parts";
import { HIDDEN } from "./palette";
import type { Stage } from "./stage";

/** So many arrowheads are on one line at most. */
const HEADS = 24;

/** A layer in the window. What it is drawn with is made when it is shown for the first time. */
export class DrawnLayer {
  readonly object = new THREE.Group();
  private isMade = false;

  constructor(
    private readonly stage: Stage,
    private readonly layer: Layer,
    private readonly color: string,
    private readonly width = 4,
    /** Among layers at one place in the plane, the higher one is seen. */
    private readonly order = 1,
    /** What it comes apart with. */
    private readonly parts: Parts | null = null,
  ) {
    this.show(layer.on);
  }

  show(isOn: boolean): void {
    if (isOn && !this.isMade) {
      this.isMade = true;
      this.make();
    }
    this.object.visible = isOn;
  }

  /** A ball around everything in it. */
  get sphere(): THREE.Sphere {
    const { layer } = this;
    const used = [...layer.lines.items, ...layer.points, ...layer.triangles];
    return new THREE.Sphere().setFromPoints(used.flatMap((point) => offsetsOf(this.parts, layer, [point]).map((offset) => this.at(point).add(offset))));
  }

  /** Follows the parts of the model, which have moved. */
  rearrange(): void {
    if (!this.isMade || this.layer.own) return;
    this.clear();
    this.isMade = this.object.visible;
    if (this.isMade) this.make();
  }

  private make(): void {
    const { layer } = this;
    if (layer.triangles.length > 0) this.object.add(this.triangles());
    if (layer.lines.items.length > 0) {
      this.object.add(this.lines());
      if (layer.arrows) this.object.add(this.heads());
    }
    if (layer.points.length > 0) this.object.add(this.points());
  }

  /** Whether each line is one arrow. */
  private get isOfArrows(): boolean {
    const { starts, items } = this.layer.lines;
    return this.layer.own && starts.length > 2 && items.length === 2 * (starts.length - 1);
  }

  private at(point: number, place = new THREE.Vector3()): THREE.Vector3 {
    return place.fromArray(this.layer.positions, 3 * point);
  }

  private lines(): THREE.Object3D {
    const { starts, items } = this.layer.lines;
    const places: number[] = [];
    const place = new THREE.Vector3();
    for (let line = 0; line + 1 < starts.length; line++) {
      for (let i = starts[line]; i + 1 < starts[line + 1]; i++) {
        for (const offset of offsetsOf(this.parts, this.layer, [items[i], items[i + 1]])) {
          for (const point of [items[i], items[i + 1]]) places.push(...this.at(point, place).add(offset).toArray());
        }
      }
    }
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(places);
    // Lines that are arrows leave room for their heads.
    const material = this.stage.lineMaterial(this.color, this.layer.arrows && this.isOfArrows ? 1.5 : this.width);
    // Lines on the surface are drawn in front of it.
    material.polygonOffset = true;
    material.polygonOffsetFactor = -2;
    material.polygonOffsetUnits = -8;
    material.depthTest = !this.stage.isFlat;
    // In the plane everything is drawn in the order of the layers, as what is transparent is.
    material.transparent = this.stage.isFlat;
    const lines = new LineSegments2(geometry, material);
    lines.renderOrder = this.stage.isFlat ? 100 + this.order : 0;
    if (this.stage.isFlat) return lines;
    // What the model hides is faint.
    const faint = this.stage.lineMaterial(this.color, 0.6 * this.width);
    faint.transparent = true;
    faint.opacity = HIDDEN;
    faint.depthFunc = THREE.GreaterDepth;
    faint.depthWrite = false;
    const both = new THREE.Group();
    both.add(lines, new LineSegments2(geometry, faint));
    return both;
  }

  private triangles(): THREE.Object3D {
    const { layer, color } = this;
    const corners: number[] = [];
    const place = new THREE.Vector3();
    for (let i = 0; i + 2 < layer.triangles.length; i += 3) {
      const triangle = layer.triangles.subarray(i, i + 3);
      for (const offset of offsetsOf(this.parts, layer, triangle)) {
        for (const point of triangle) corners.push(...this.at(point, place).add(offset).toArray());
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
    const common = { color, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2, clippingPlanes: this.stage.planes };
    const material = this.stage.isFlat
      ? new THREE.MeshBasicMaterial({ ...common, transparent: true, opacity: 0.45, depthTest: false })
      : new THREE.MeshLambertMaterial({ ...common, flatShading: true });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.renderOrder = this.stage.isFlat ? this.order : 0;
    return mesh;
  }

  private points(): THREE.Object3D {
    const { layer, color, width } = this;
    const places: number[] = [];
    const place = new THREE.Vector3();
    for (const point of layer.points) {
      for (const offset of offsetsOf(this.parts, layer, [point])) places.push(...this.at(point, place).add(offset).toArray());
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(places, 3));
    const size = layer.points.length > 1000 ? width : 2.5 * width;
    const marks = new THREE.Points(geometry, new THREE.PointsMaterial({ color, size, sizeAttenuation: false, depthTest: false, transparent: true, clippingPlanes: this.stage.planes }));
    marks.renderOrder = 200 + this.order;
    return marks;
  }

  /** Cones along the lines. */
  private heads(): THREE.Object3D {
    const { starts, items } = this.layer.lines;
    const [from, to] = [new THREE.Vector3(), new THREE.Vector3()];
    const matrices: THREE.Matrix4[] = [];
    const isFull = this.isOfArrows;
    const most = 0.035 * this.stage.radius;
    for (let line = 0; line + 1 < starts.length; line++) {
      const count = starts[line + 1] - starts[line] - 1;
      const step = Math.max(1, Math.ceil(count / HEADS));
      for (let i = Math.floor((step - 1) / 2); i < count; i += step) {
        this.at(items[starts[line] + i], from);
        this.at(items[starts[line] + i + 1], to);
        const along = to.clone().sub(from);
        const length = along.length();
        if (length === 0) continue;
        const size = Math.min(most, 0.5 * length);
        const turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.divideScalar(length));
        // Arrows that stand alone have their heads at their ends.
        const place = from.clone().lerp(to, isFull ? 1 - (0.5 * size) / length : 0.5);
        for (const offset of offsetsOf(this.parts, this.layer, [items[starts[line] + i], items[starts[line] + i + 1]])) {
          matrices.push(new THREE.Matrix4().compose(place.clone().add(offset), turn, new THREE.Vector3(size, size, size)));
        }
      }
    }
    const material = new THREE.MeshBasicMaterial({
      color: this.color,
      depthTest: !this.stage.isFlat,
      transparent: this.stage.isFlat,
      polygonOffset: true,
      polygonOffsetFactor: -3,
      polygonOffsetUnits: -8,
      clippingPlanes: this.stage.planes,
    });
    const heads = new THREE.InstancedMesh(new THREE.ConeGeometry(0.38, 1, 10), material, matrices.length);
    matrices.forEach((matrix, i) => heads.setMatrixAt(i, matrix));
    heads.renderOrder = this.stage.isFlat ? 150 + this.order : 0;
    heads.frustumCulled = false;
    return heads;
  }

  dispose(): void {
    this.object.removeFromParent();
    this.clear();
  }

  private clear(): void {
    this.object.traverse((part) => {
      if (part instanceof THREE.Mesh || part instanceof THREE.Points) {
        part.geometry.dispose();
        const material = part.material as THREE.Material;
        this.stage.forget(material);
        material.dispose();
      }
    });
    this.object.clear();
  }
}
