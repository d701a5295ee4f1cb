/** Layers: generators, cuts, loops, witnesses, neighborhoods, drawn over the model. */

import * as THREE from "three";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Layer } from "../scene/document";
import type { Stage } from "./stage";

/** A layer in the window. */
export class DrawnLayer {
  readonly object = new THREE.Group();
  readonly sphere = new THREE.Sphere();

  constructor(stage: Stage, layer: Layer, color: string, width = 4) {
    const points: THREE.Vector3[] = [];
    const at = (point: number) => {
      const place = new THREE.Vector3().fromArray(layer.positions, 3 * point);
      points.push(place);
      return place;
    };
    const segments: number[] = [];
    for (let line = 0; line + 1 < layer.lines.starts.length; line++) {
      for (let i = layer.lines.starts[line]; i + 1 < layer.lines.starts[line + 1]; i++) {
        segments.push(...at(layer.lines.items[i]).toArray(), ...at(layer.lines.items[i + 1]).toArray());
      }
    }
    if (segments.length > 0) {
      const geometry = new LineSegmentsGeometry();
      geometry.setPositions(segments);
      const material = stage.lineMaterial(color, width);
      // Lines on the surface are drawn in front of it.
      material.polygonOffset = true;
      material.polygonOffsetFactor = -2;
      material.polygonOffsetUnits = -8;
      this.object.add(new LineSegments2(geometry, material));
    }
    if (layer.triangles.length > 0) {
      const corners = new Float32Array(3 * layer.triangles.length);
      layer.triangles.forEach((point, i) => at(point).toArray(corners, 3 * i));
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
      geometry.computeVertexNormals();
      const material = new THREE.MeshLambertMaterial({
        color,
        side: THREE.DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: -1,
        polygonOffsetUnits: -2,
      });
      this.object.add(new THREE.Mesh(geometry, material));
    }
    if (layer.points.length > 0) {
      const places = new Float32Array(3 * layer.points.length);
      layer.points.forEach((point, i) => at(point).toArray(places, 3 * i));
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
      const material = new THREE.PointsMaterial({ color, size: 2.5 * width, sizeAttenuation: false, depthTest: false });
      const marks = new THREE.Points(geometry, material);
      marks.renderOrder = 2;
      this.object.add(marks);
    }
    this.sphere.setFromPoints(points);
    this.object.visible = layer.on;
  }

  dispose(): void {
    this.object.removeFromParent();
    this.object.traverse((part) => {
      if (part instanceof THREE.Mesh || part instanceof THREE.Points) {
        part.geometry.dispose();
        (part.material as THREE.Material).dispose();
      }
    });
  }
}
