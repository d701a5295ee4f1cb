/** Models to begin with: how the program makes them, or their text. */

import beam from "../../data/beam_h5t12.mesh?raw";
import fandisk from "../../data/fandisk_quads.off?raw";
import geometryCentral from "../../data/licenses/geometry-central.txt?raw";
import pmpLibrary from "../../data/licenses/pmp-library.txt?raw";
import sfepy from "../../data/licenses/sfepy.txt?raw";
import band from "../../data/moebius.obj?raw";
import shelf from "../../data/platonic_shelf.obj?raw";
import spot from "../../data/spot.obj?raw";

export interface Example {
  title: string;
  /** The name of the file that it becomes. */
  name: string;
  /** The words of the program that make it; or its text. */
  from: string[] | string;
}

const made = (title: string, name: string, ...words: string[]): Example => ({ title, name, from: ["generate", ...words, "-o", name] });

export const EXAMPLES: { group: string; examples: Example[] }[] = [
  {
    group: "surfaces",
    examples: [
      made("sphere", "sphere.off", "sphere"),
      made("torus", "torus.off", "torus"),
      made("two handles", "genus2.off", "genus", "--genus", "2"),
      made("Moebius band", "moebius.off", "moebius"),
      made("Klein bottle", "klein.off", "klein"),
      made("projective plane, 6 vertices", "rp2.json", "rp2"),
      made("torus of Csaszar, 7 vertices", "csaszar.off", "csaszar"),
      made("ring", "ring.off", "ring"),
      made("cylinder", "cylinder.off", "cylinder"),
      made("pinched torus", "pinched.json", "pinched-torus"),
    ],
  },
  {
    group: "known spaces",
    examples: [
      made("lens space L(7, 2)", "lens.json", "lens", "--p", "7", "--q", "2"),
      made("homology sphere of Poincare", "poincare.json", "poincare"),
      made("hyperbolic space of Weber and Seifert", "weber.json", "weber-seifert"),
      made("complex projective plane", "cp2.json", "cp2"),
      made("K3 surface", "k3.json", "k3"),
      made("3-torus", "torus3.json", "cyclic-torus", "--dimension", "3"),
      made("dunce hat", "dunce.json", "dunce-hat"),
      made("house with two rooms", "house.json", "house"),
      made("Moore space: a disk around a circle, 3 times", "moore.json", "moore", "--order", "3"),
      made("a group: x^2 = y^3", "trefoil.json", "presentation", "--generators", "2", "--relator", "1,1,-2,-2,-2"),
    ],
  },
  {
    group: "real meshes",
    examples: [
      { title: "a cow: closed surface of 5,856 triangles", name: "spot.obj", from: spot },
      { title: "machine part: 764 quadrangles", name: "fandisk_quads.off", from: fandisk },
      { title: "Moebius band of quadrangles", name: "band.obj", from: band },
      { title: "the five Platonic solids on a shelf", name: "platonic_shelf.obj", from: shelf },
      { title: "hexahedra and tetrahedra that do not match", name: "beam_h5t12.mesh", from: beam },
    ],
  },
  {
    group: "solids",
    examples: [
      made("box", "box.off", "box", "--boundary"),
      made("solid torus", "solid-torus.vtk", "solid-torus"),
      made("hollow ball", "hollow-ball.vtk", "hollow-ball"),
      made("grid of cubes", "grid.vtk", "grid", "--shape", "3,3,3"),
    ],
  },
  {
    group: "drawings and curves",
    examples: [
      {
        title: "four lines and a square",
        name: "lines.wkt",
        from: "MULTILINESTRING((0 1,6 1),(0 3,6 3),(2 0,2 4),(4 0,4 4))\nLINESTRING(1 0.5,5 0.5,5 3.5,1 3.5,1 0.5)\n",
      },
      { title: "square with a hole", name: "square.wkt", from: "POLYGON((0 0,6 0,6 6,0 6,0 0),(2 2,2 4,4 4,4 2,2 2))\n" },
      { title: "star that crosses itself", name: "star.wkt", from: "POLYGON((0 3,6 3,1 0,3 5,5 0,0 3))\n" },
      {
        title: "blob with curved sides",
        name: "blob.yin.json",
        from: '{"order":4,"curves":[{"points":[[4,2],[2,3],[1,1],[3,-0.4]]}]}\n',
      },
      {
        title: "triangle with kinks",
        name: "kinks.yin.json",
        from: '{"order":4,"curves":[{"points":[[0,0],[6,2],[2,4]],"kinks":[0,1,2]}]}\n',
      },
      {
        title: "two triangles as halfedges (a boundary with one loop)",
        name: "two-triangles.halfedges.json",
        from: '{"vertices":[[0,0,0],[2,0,0],[2,2,0],[0,2,0]],"next":[1,2,0,4,5,3,7,8,9,6],"twin":[6,9,3,2,8,7,0,5,4,1],"outer":[2]}\n',
      },
    ],
  },
  {
    group: "figures to begin with",
    examples: [
      {
        title: "a complex that is not pure: triangles, an edge, a point",
        name: "mixed.json",
        from: '{"facets":[[0,1,2],[1,2,3],[2,3,4],[4,5],[6]]}\n',
      },
      made("cells of a plan: squares in rows", "cuboids.json", "cuboids", "--shape", "3,2"),
      {
        title: "two squares that overlap, and a wall through both",
        name: "squares.wkt",
        from: "LINESTRING(0 0,4 0,4 4,0 4,0 0)\nLINESTRING(2 1,6 1,6 3,2 3,2 1)\nLINESTRING(-1 2,7 2)\n",
      },
      {
        title: "walls that nearly meet: one tolerance makes them rooms",
        name: "walls.wkt",
        from: "LINESTRING(0 0,4.01 0)\nLINESTRING(4 0.01,4 3)\nLINESTRING(4 3.01,0 3)\nLINESTRING(0.01 3,0 0.01)\nLINESTRING(2 0,2 3)\n",
      },
      {
        title: "ears and a face: curves with kinks where they meet",
        name: "ears.yin.json",
        from: '{"order":4,"curves":[{"points":[[2,0],[1.2,1.4],[1.9,2.1],[1.3,2.9],[0.5,2.3],[0,1.9],[-0.5,2.3],[-1.3,2.9],[-1.9,2.1],[-1.2,1.4],[-2,0],[0,-2]],"kinks":[1,4,6,9]}]}\n',
      },
    ],
  },
];

/** What goes with the meshes of others: whose they are, and their licences. */
export const NOTICES = [
  "The cow is Spot by Keenan Crane, in the public domain (CC0).",
  `The machine part comes from pmp-library:\n\n${pmpLibrary.trim()}`,
  `The Moebius band of quadrangles and the Platonic solids come from geometry-central:\n\n${geometryCentral.trim()}`,
  `The hexahedra and tetrahedra come from sfepy:\n\n${sfepy.trim()}`,
].join("\n\n\n");
