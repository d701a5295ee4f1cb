/** The picture as SVG: what faces the camera, from back to front, and the layers that are on. */

import * as THREE from "three";
import type { Layer, Scene } from "../scene/document";
import type { Stage } from "./stage";
import { THEMES, type Theme } from "./palette";

/** More triangles than this are not written: the file would be of no use. */
export const MOST_TRIANGLES = 200000;

export function svgText(
  model: Scene,
  layers: { layer: Layer; color: string }[],
  stage: Stage,
  theme: Theme,
  size: { width: number; height: number },
  showsEdges: boolean,
): string {
  const colors = THEMES[theme];
  const place = (positions: Float32Array, point: number) =>
    stage.project(new THREE.Vector3().fromArray(positions, 3 * point));
  const number = (x: number) => x.toFixed(2);
  const parts: string[] = [];
  const count = model.triangles.length / 3;
  if (count <= MOST_TRIANGLES) {
    const light = new THREE.Vector3(0.3, 0.5, 1).normalize();
    const base = new THREE.Color(colors.surface);
    const faces: { depth: number; text: string }[] = [];
    for (let t = 0; t < count; t++) {
      const [a, b, c] = [0, 1, 2].map((i) => place(model.positions, model.triangles[3 * t + i]));
      if (Math.abs(a.z) > 1) continue;
      const normal = new THREE.Vector3(b.x - a.x, a.y - b.y, 0).cross(new THREE.Vector3(c.x - a.x, a.y - c.y, 0));
      const world = [0, 1, 2].map((i) => new THREE.Vector3().fromArray(model.positions, 3 * model.triangles[3 * t + i]));
      const slope = world[1].sub(world[0]).cross(world[2].sub(world[0])).normalize();
      slope.transformDirection(stage.camera.matrixWorldInverse);
      if (normal.z < 0) slope.negate();
      const shade = 0.45 + 0.55 * Math.max(Math.abs(slope.dot(light)), 0);
      const fill = `#${base.clone().multiplyScalar(shade).getHexString()}`;
      const corners = [a, b, c].map((p) => `${number(p.x)},${number(p.y)}`).join(" ");
      const stroke = showsEdges ? colors.edge : fill;
      const text = `<polygon points="${corners}" fill="${fill}" stroke="${stroke}" stroke-width="0.5" stroke-linejoin="round"/>`;
      faces.push({ depth: a.z + b.z + c.z, text });
    }
    faces.sort((p, q) => q.depth - p.depth);
    parts.push(...faces.map((face) => face.text));
  }
  for (const { layer, color } of layers) {
    for (let line = 0; line + 1 < layer.lines.starts.length; line++) {
      const points = Array.from(layer.lines.items.subarray(layer.lines.starts[line], layer.lines.starts[line + 1]));
      const text = points.map((p) => place(layer.positions, p)).map((p) => `${number(p.x)},${number(p.y)}`).join(" ");
      parts.push(`<polyline points="${text}" fill="none" stroke="${color}" stroke-width="3" stroke-linecap="round"/>`);
    }
    for (const point of layer.points) {
      const at = place(layer.positions, point);
      parts.push(`<circle cx="${number(at.x)}" cy="${number(at.y)}" r="4" fill="${color}"/>`);
    }
  }
  const { width, height } = size;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">
<rect width="100%" height="100%" fill="${colors.background}"/>
${parts.join("\n")}
</svg>
`;
}
