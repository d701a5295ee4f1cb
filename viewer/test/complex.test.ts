import { describe, expect, it } from "vitest";
import { CellSet, Complex, countsText, type Ragged } from "../src/complex/complex";

function ragged(lists: number[][]): Ragged {
  const starts = [0];
  for (const list of lists) starts.push(starts[starts.length - 1] + list.length);
  return { starts: Uint32Array.from(starts), items: Uint32Array.from(lists.flat()) };
}

const none = ragged([]);

describe("neighborhoods", () => {
  // Four triangles around vertex 4 in a square.
  const fan = new Complex(5, ragged([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]), none);
  const middle = CellSet.of([fan.vertexCell(4)]);

  it("has the star of an inner vertex", () => {
    expect(fan.star(middle).counts()).toEqual([1, 4, 4]);
    expect(fan.closure(fan.star(middle)).counts()).toEqual([5, 8, 4]);
  });

  it("has a circle as its link", () => {
    const link = fan.link(middle);
    expect(link.counts()).toEqual([4, 4]);
    expect(link.has({ dimension: 1, vertices: [0, 3] })).toBe(true);
  });

  it("has the outside as boundary of all triangles", () => {
    const all = CellSet.of([0, 1, 2, 3].map((i) => fan.polygonCell(i)));
    expect(fan.boundary(all)?.counts()).toEqual([4, 4]);
    expect(fan.boundary(CellSet.of([fan.polygonCell(0), fan.vertexCell(3)]))).toBeNull();
  });

  it("knows the sides of polygons", () => {
    const cube = new Complex(8, ragged([
      [0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7],
    ]), none);
    const corner = CellSet.of([cube.vertexCell(0)]);
    expect(cube.star(corner).counts()).toEqual([1, 3, 3]);
    expect(cube.link(corner).counts()).toEqual([6, 6]);
    expect(cube.closure(CellSet.of([cube.polygonCell(0)])).counts()).toEqual([4, 4, 1]);
  });

  it("knows solids", () => {
    // Two tetrahedra with a common face, by their triangles.
    const solids = new Complex(5, ragged([[0, 1, 2], [0, 1, 3], [1, 2, 3], [0, 2, 3], [1, 2, 4], [1, 3, 4], [2, 3, 4]]), none, ragged([[0, 1, 2, 3], [2, 4, 5, 6]]));
    const corner = CellSet.of([solids.vertexCell(0)]);
    expect(solids.star(corner).counts()).toEqual([1, 3, 3, 1]);
    expect(solids.link(corner).counts()).toEqual([3, 3, 1]);
    expect(solids.star(CellSet.of([solids.polygonCell(2)])).counts()).toEqual([0, 0, 1, 2]);
    expect(solids.boundary(CellSet.of([solids.solidCell(0), solids.solidCell(1)]))?.counts()).toEqual([5, 9, 6]);
  });

  it("knows tetrahedra", () => {
    const two = new Complex(5, none, ragged([[0, 1, 2, 3], [1, 2, 3, 4]]));
    const shared = CellSet.of([{ dimension: 2, vertices: [1, 2, 3] }]);
    expect(two.star(shared).counts()).toEqual([0, 0, 1, 2]);
    expect(two.link(shared).counts()).toEqual([2]);
  });
});

it("names what it counts", () => {
  expect(countsText([1152, 1, 0, 2, 5])).toBe("1,152 vertices, 1 edge, 2 cells, 5 cells of dimension 4");
  expect(countsText([])).toBe("");
});
