/** The picture as SVG: what faces the camera and the layers that are on, from back to front. */

import * as THREE from "three";
import type { Layer, Scene } from "../scene/document";
import { loneEdges } from "./edges";
import { offsetsOf } from "./parts";
import type { Stage } from "./stage";
import type { Surface } from "./surface";
import { HIDDEN, THEMES, type Theme } from "./palette";

/** More triangles than this are not written: the file would be of no use. */
export const MOST_TRIANGLES = 200000;

export function svgText(
  model: Scene,
  layers: { layer: Layer; color: string }[],
  stage: Stage,
  surface: Surface,
  theme: Theme,
  size: { width: number; height: number },
): string {
  const colors = THEMES[theme];
  const number = (x: number) => x.toFixed(2);
  // What is drawn with its depth; what is at one depth is drawn as it comes.
  const parts: { depth: number; text: string }[] = [];
  const light = new THREE.Vector3(0.3, 0.5, 1).normalize();
  const addTriangle = (world: THREE.Vector3[], color: string, nearer: number, opacity: string, stroke: string | null) => {
    const [a, b, c] = world.map((place) => stage.project(place));
    if ([a, b, c].some((corner) => Math.abs(corner.z) > 1)) return;
    const slope = world[1].clone().sub(world[0]).cross(world[2].clone().sub(world[0])).normalize();
    slope.transformDirection(stage.camera.matrixWorldInverse);
    const shade = stage.isFlat ? 1 : 0.45 + 0.55 * Math.abs(slope.dot(light));
    const fill = `#${new THREE.Color(color).multiplyScalar(shade).getHexString()}`;
    const corners = [a, b, c].map((p) => `${number(p.x)},${number(p.y)}`).join(" ");
    parts.push({
      depth: (a.z + b.z + c.z) / 3 - nearer,
      text: `<polygon points="${corners}" fill="${fill}"${opacity} stroke="${stroke ?? fill}" stroke-width="0.5" stroke-linejoin="round"/>`,
    });
  };
  const addLine = (from: THREE.Vector3, to: THREE.Vector3, color: string, width: number, nearer: number, hasFaint = false) => {
    const [a, b] = [stage.project(from), stage.project(to)];
    if (Math.abs(a.z) > 1 || Math.abs(b.z) > 1) return;
    const ends = `x1="${number(a.x)}" y1="${number(a.y)}" x2="${number(b.x)}" y2="${number(b.y)}" stroke="${color}"`;
    parts.push({ depth: (a.z + b.z) / 2 - nearer, text: `<line ${ends} stroke-width="${width}" stroke-linecap="round"/>` });
    // What the model hides is faint: over everything, where it does not show on what is seen.
    if (hasFaint) parts.push({ depth: -Infinity, text: `<line ${ends} stroke-width="${0.6 * width}" stroke-opacity="${HIDDEN}"/>` });
  };
  // In the plane everything is at one depth, and layers lie on the model in their order.
  const near = depthOf(stage);
  const count = model.triangles.length / 3;
  if (count <= MOST_TRIANGLES) {
    for (let t = 0; t < count; t++) {
      if (surface.isShown(t)) addTriangle([0, 1, 2].map((i) => surface.corner(t, i)), colors.surface, 0, "", surface.hasEdges ? colors.edge : null);
    }
  }
  const lone = loneEdges(model);
  for (let i = 0; i < lone.length; i += 2) addLine(surface.vertex(lone[i]), surface.vertex(lone[i + 1]), colors.curve, 2, near);
  layers.forEach(({ layer, color }, place) => {
    const at = (point: number) => new THREE.Vector3().fromArray(layer.positions, 3 * point);
    // Once for each of the parts that have all of these points.
    const copies = (points: ArrayLike<number>) =>
      offsetsOf(surface.parts, layer, points).map((offset) => Array.from(points, (point) => at(point).add(offset)));
    const opacity = stage.isFlat ? ' fill-opacity="0.45"' : "";
    for (let t = 0; t + 2 < layer.triangles.length; t += 3) {
      for (const corners of copies(layer.triangles.subarray(t, t + 3))) {
        addTriangle(corners, color, near * (1 + 0.01 * place), opacity, stage.isFlat ? "none" : null);
      }
    }
    for (let line = 0; line + 1 < layer.lines.starts.length; line++) {
      for (let i = layer.lines.starts[line]; i + 1 < layer.lines.starts[line + 1]; i++) {
        for (const [from, to] of copies(layer.lines.items.subarray(i, i + 2))) {
          addLine(from, to, color, 3.5, near * (2 + 0.01 * place), !stage.isFlat);
        }
      }
    }
    for (const point of layer.points) {
      for (const [world] of copies([point])) {
        const place = stage.project(world);
        parts.push({ depth: -Infinity, text: `<circle cx="${number(place.x)}" cy="${number(place.y)}" r="4" fill="${color}"/>` });
      }
    }
    for (const { point, text } of layer.labels) {
      const place = stage.project((copies([point])[0] ?? [at(point)])[0]);
      const plain = text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
      parts.push({
        depth: -Infinity,
        text: `<text x="${number(place.x + 6)}" y="${number(place.y + 4)}" font-family="sans-serif" font-size="12" fill="${colors.text}">${plain}</text>`,
      });
    }
  });
  parts.sort((p, q) => (p.depth === q.depth ? 0 : q.depth - p.depth));
  const { width, height } = size;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">
<rect width="100%" height="100%" fill="${colors.background}"/>
${parts.map((part) => part.text).join("\n")}
</svg>
`;
}

/** A step in depth that puts what lies on a surface before it. */
function depthOf(stage: Stage): number {
  const toEye = stage.camera.position.clone().sub(stage.controls.target).setLength(0.03 * stage.radius);
  const [a, b] = [stage.controls.target.clone(), stage.controls.target.clone().add(toEye)].map((place) => stage.project(place));
  return Math.abs(a.z - b.z);
}
