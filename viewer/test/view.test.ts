import * as THREE from "three";
import { describe, expect, it } from "vitest";
import type { Scene } from "../src/scene/document";
import { coarseTriangles } from "../src/view/coarse";
import { loneEdges, sideEdges } from "../src/view/edges";
import { offsetsOf, Parts } from "../src/view/parts";
import { colorOf, PALETTE } from "../src/view/palette";
import { TrianglePicker } from "../src/view/picker";

/** A square of n by n squares in the plane z = 0, of two triangles each, and an edge on a side of it that goes beyond. */
function grid(n: number): Scene {
  const positions: number[] = [];
  for (let j = 0; j <= n; j++) for (let i = 0; i <= n; i++) positions.push(i, j, 0);
  const triangles: number[] = [];
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const a = i + (n + 1) * j;
      triangles.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  }
  const items = Uint32Array.from(triangles);
  const starts = Uint32Array.from({ length: triangles.length / 3 + 1 }, (_, i) => 3 * i);
  const none = { starts: new Uint32Array(1), items: new Uint32Array(0) };
  const simplices = { starts: Uint32Array.from([0, 2, 4]), items: Uint32Array.from([0, 1, 0, 2 * n + 2]) };
  return {
    vertexNumbers: new Uint32Array(0),
    title: "grid", report: null, dimension: 3, origin: [0, 0, 0], positions: Float32Array.from(positions), polygons: { starts, items },
    rims: none, polygonsOfRims: new Uint32Array(0), simplices, cells: none, signs: new Uint32Array(0), notes: [], triangles: items,
    polygonOfTriangle: null, cellOfTriangle: new Uint32Array(0), remarks: [], layers: [], panes: [],
  };
}

describe("what is drawn", () => {
  it("has each edge once, and those in no polygon apart", () => {
    expect(sideEdges(grid(3)).length / 2).toBe(2 * 12 + 9);
    expect([...loneEdges(grid(3))]).toEqual([0, 8]);
  });

  it("is coarse while it moves", () => {
    const model = grid(300);
    const coarse = coarseTriangles(model);
    expect(coarse.length).toBeLessThan(model.triangles.length / 10);
    const { positions } = model;
    let area = 0;
    for (let t = 0; t < coarse.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((i) => new THREE.Vector3().fromArray(positions, 3 * coarse[t + i]));
      area += b.sub(a).cross(c.sub(a)).length() / 2;
    }
    expect(area / 90000).toBeGreaterThan(0.9);
  });

  it("comes apart with its parts", () => {
    // Two squares of two triangles each, in the plane: vertices 0 1 2 below 3 4 5.
    const model: Scene = { ...grid(2), dimension: 2, simplices: { starts: new Uint32Array(1), items: new Uint32Array(0) } };
    const center = new THREE.Vector3(1, 1, 0);
    const parts = Parts.of(model, center)!;
    const layer = { name: "", group: "", detail: "", color: null, on: true, arrows: false, own: false, positions: model.positions,
      lines: { starts: new Uint32Array(1), items: new Uint32Array(0) }, points: new Uint32Array(0), triangles: new Uint32Array(0), labels: [] };
    const at = (points: number[]) => offsetsOf(parts, layer, points).map((offset) => offset.toArray().map((x) => Number(x.toFixed(6))));
    expect(at([0, 1])).toEqual([[0, 0, 0]]);
    parts.setShare(1);
    // A side of the rim goes with its triangle, a side within with both, a corner with all that have it.
    expect(at([0, 1])).toEqual([[-0.333333, -0.666667, 0]]);
    expect(at([0, 4])).toHaveLength(2);
    expect(at([4])).toHaveLength(6);
    expect(at([0, 1, 4])).toEqual([[-0.333333, -0.666667, 0]]);
    // What has points of its own stays, and what is on no part.
    expect(offsetsOf(parts, { ...layer, own: true }, [0, 1])[0].length()).toBe(0);
    expect(at([0, 8])).toEqual([[0, 0, 0]]);
  });

  it("is found by rays", () => {
    const model = grid(40);
    const picker = new TrianglePicker(model, new THREE.Plane(new THREE.Vector3(-1, 0, 0), 20), null);
    const down = (x: number, y: number) => picker.pick(new THREE.Ray(new THREE.Vector3(x, y, 5), new THREE.Vector3(0, 0, -1)));
    for (const [i, j] of [[0, 0], [7, 3], [19, 39]]) {
      expect(down(i + 0.7, j + 0.2)).toBe(2 * (i + 40 * j));
      expect(down(i + 0.2, j + 0.7)).toBe(2 * (i + 40 * j) + 1);
    }
    // Beyond the cutting plane, beside the model, and behind.
    expect(down(20.5, 3.2)).toBeNull();
    expect(down(-1, 3)).toBeNull();
    expect(picker.pick(new THREE.Ray(new THREE.Vector3(1, 1, -5), new THREE.Vector3(0, 0, -1)))).toBeNull();
  });
});

describe("colors", () => {
  it("are places in the palette, or stand for themselves", () => {
    expect(colorOf(PALETTE.length + 1)).toBe(PALETTE[1]);
    expect(colorOf(0x100ff80)).toBe("#00ff80");
    expect(colorOf(0x1000000)).toBe("#000000");
  });
});
