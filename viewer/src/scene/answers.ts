/**
 * The answers of the verbs: what the program prints with --json.
 *
 * Made of docs/answers.schema.json by `cargo xtask types --write`.
 */

/** A column of the table of faces: a key of the properties of features of an input. */
export interface AttributeColumn {
  /** The input whose features have the key, numbered from 0. */
  input: number;
  /** The key. */
  key: string;
  /** The name of the column. */
  name: string;
}

/** A table of reports. */
export interface BatchAnswer {
  /** The numbers of rows that are errors, by kind. */
  errors: Record<string, number>;
  /** The number of rows: of files, of models in files, or of lines of lists of signatures. */
  files: number;
  /** The file that was written. */
  output: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The number of rows taken from an earlier run that was cut short. */
  resumed: number;
}

/** A block of rows or columns of a matrix. */
export interface BlockAnswer {
  /** What its cells are. */
  name: string;
  /** The number of its cells. */
  size: number;
}

/** Vertices of one block that became one. */
export interface BlockMergeAnswer {
  /** The block. */
  block: number;
  /** The class. */
  class: number;
  /** The smallest distance of two of them, in the unit of the models. */
  distance: number;
  /** The name of the file of the first vertex. */
  file?: string | null;
  /** The vertices, by their numbers in their models. */
  vertices: number[];
}

/** Whether the boundary of a result is a manifold, with a witness if it is not. */
export interface BoundaryManifold {
  /** Whether the boundary is closed. */
  closed: boolean;
  /** The verdict. */
  verdict: BoundaryVerdict;
  /** A place where it is no manifold; null if it is one. */
  witness?: BoundaryWitness | null;
}

/** The boundary of a volume. */
export interface BoundarySurface {
  /** The number of its connected components. */
  components: number;
  /** Its vertices minus its edges plus its faces. */
  euler_characteristic: number;
  /** The number of its faces. */
  faces: number;
  /** Whether it is a surface. */
  manifold: boolean;
  /** The surface in words: `sphere`, `2 tori`; `null` where it is none. */
  name?: string | null;
}

/** Whether a boundary is a manifold. */
export type BoundaryVerdict = "yes" | "no";

/** A place where a boundary is no manifold. */
export interface BoundaryWitness {
  /** The cells, each by its vertices. */
  cells: number[][];
  /** A word for programs: what sort of witness this is. */
  kind: string;
  /** One sentence for people. */
  message: string;
  /** For each cell the positions of its vertices; in space only. */
  points?: number[][][] | null;
}

/** Arcs as straight lines. */
export interface BufferArcsAnswer {
  /** The distance. */
  distance: number;
  /** How far the flattened arcs are from the true ones at most: corners are on the true arcs. */
  error: number;
  /** The least number of sides that a whole circle has. */
  sides: number;
}

/**
 * An edge or a halfedge: by its number, or by the vertices that it goes from and to.
 *
 * # Examples
 * ```
 * use coface_answers::CellName;
 * # fn main() -> Result<(), coface_algebra::Error> {
 * assert_eq!("7".parse::<CellName>()?, CellName::Number(7));
 * assert_eq!("3 5".parse::<CellName>()?, CellName::Ends([3, 5]));
 * assert!("3 5 6".parse::<CellName>().is_err());
 * # Ok(()) }
 * ```
 */
export type CellName = number | [number, number];

/** How many cells have a shape. */
export interface CellsOfShape {
  /** How many cells have it. */
  count: number;
  /** The shape, such as `triangle`. */
  shape: string;
}

/** A triangulation looked up in a census. */
export interface CensusAnswer {
  /** The file. */
  file: string;
  /** The line with the triangulation; null if none of those that were tried is there. */
  found?: CensusLine | null;
  /** The number of different triangulations in it. */
  triangulation_count: number;
}

/** A line of a census. */
export interface CensusLine {
  /** Its number, from 1. */
  line: number;
  /** The name beside it: what the file says, not what is proved. */
  name?: string | null;
  /** The isomorphism signature as it is written there. */
  signature: string;
}

/** What a certificate proved. There is no answer where a step fails. */
export interface CheckAnswer {
  /** The name of the certificate. */
  certificate: string;
  /** The names of the inputs. */
  files: string[];
  /** The claims that were derived from the input and agree with the answer. */
  proved: string[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The keys of the answer that were not checked. */
  unchecked: string[];
  /** Whether all steps of the proof hold; always true. */
  verified: boolean;
}

/** A closed path with its length. */
export interface ClosedPath {
  /** The length in the unit of the file, or the number of edges without positions. */
  length: number;
  /** The vertices, by their numbers in the file; the first is repeated at the end. */
  vertices: number[];
}

/** Whether a cochain of degree 1 is closed and exact, with what shows it. */
export interface CochainTestAnswer {
  /** Whether the sum around each face is zero. */
  closed: boolean;
  /** Whether the cochain is the difference of a function on the vertices. */
  exact: boolean;
  /** Of a cochain that is not closed: a face, by its vertices, around which the sum is not zero. */
  face?: number[] | null;
  /** The name of the input. */
  file: string;
  /** The sum along the walk. */
  period?: CochainValue | null;
  /** Of an exact cochain: a function on the vertices whose differences it is. */
  potential?: [CochainValue, number[]][] | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The sum around the face. */
  sum?: CochainValue | null;
  /** Of a closed cochain that is not exact: the vertices of a closed walk on which its sum is not zero. */
  walk?: number[] | null;
}

/** A value of a cochain: exact where all values are integers. */
export type CochainValue = WholeNumber | number;

/** How cocycles are found. */
export type CocycleBasisMethod = "crossing" | "slicing" | "general";

/** A basis of the first cohomology over the integers, dual to loops. */
export interface CocyclesAnswer {
  /** The cocycles, by their values on edges. */
  cocycles: [WholeNumber, number[]][][];
  /** The determinant of the pairing; `null` where it is not square. */
  determinant?: WholeNumber | null;
  /** The edges by their ends, in the order of the values of harmonic forms. */
  edges?: number[][] | null;
  /** The name of the input. */
  file: string;
  /** The harmonic forms in the classes of the cocycles. */
  harmonic?: HarmonicFormAnswer[] | null;
  /** The intersection numbers of the loops with each other; only on closed orientable surfaces. */
  intersection?: LoopIntersections | null;
  /** The loops that the cocycles are measured on. */
  loops: LoopAnswer[];
  /** How the cocycles were found. */
  method: CocycleBasisMethod;
  /** The value of cocycle i on loop j, in row i. */
  pairing: WholeNumber[][];
  /** The rank of the first cohomology: the number of cocycles. */
  rank: number;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The weights of edges that harmonic forms have the least energy for. */
  weights?: EdgeWeights | null;
}

/** The quotient of the chain complexes of models by the vertices within a tolerance. Lists have an entry for each degree. */
export interface CongruenceAnswer {
  /** The first hundred classes with several vertices of one block; null without blocks, and where that is allowed. */
  block_merges?: BlockMergeAnswer[] | null;
  /** The numbers of cells that lost facets without collapsing. */
  changed: number[];
  /** The numbers of classes. */
  classes: number[];
  /** The numbers of cells that collapsed. */
  discarded: number[];
  /** The alternating sum of the numbers of cells of the quotient. */
  euler_characteristic: number;
  /** The numbers of cells of the quotient. */
  f_vector: number[];
  /** The numbers of cells of all inputs. */
  f_vector_before: number[];
  /** The inputs in their order. */
  inputs: CongruenceInput[];
  /** The largest distance of vertices that became one, in the unit of the models. */
  largest_class_diameter: number;
  /** How often vertices of one block became one; null without blocks. */
  merged_within_blocks?: number | null;
  /** Whether the boundary of every boundary is zero, found by multiplying the matrices. */
  products_zero: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The length within which vertices are one, in the unit of the models. */
  tolerance: number;
}

/** One model among the inputs of a congruence. */
export interface CongruenceInput {
  /** The numbers of its cells. */
  f_vector: number[];
  /** The name of the file. */
  file: string;
}

/** What congruence did: the pieces of segments, or of polygons in space, each cut for itself, that were stacked and glued. */
export interface CongruentPieces {
  /** The segments whose ends became one, or the polygons that are nowhere wider than the tolerance: they are left out. */
  collapsed?: number;
  /** In space the numbers of vertices, edges and faces that several pieces became. */
  glued_f_vector?: number[];
  /**
   * The largest distance of two vertices that became one, in the unit of the inputs: far below the tolerance if that was
   * chosen well.
   */
  largest_class_diameter: number;
  /** The numbers of vertices and edges of all segments, or of vertices, edges and faces of all polygons, each cut by itself. */
  stacked_f_vector: number[];
  /** The distance within which vertices became one, in the unit of the inputs. */
  tolerance: number;
}

/** A file written from another one. */
export interface ConvertAnswer {
  /** How much was written. */
  counts: ConvertCounts;
  /** The name of the file that was read. */
  file: string;
  /** Its format; absent for sets of the plane. */
  format?: string | null;
  /** What was repaired of a drawing; absent if no such repair was asked for. */
  map_repair?: MapRepairAnswer | null;
  /** The name of the file that was written. */
  output: string;
  /** Its format. */
  output_format: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What was repaired; absent if no repair was asked for. */
  repair?: MeshRepairAnswer | null;
}

/** How much a file holds. */
export type ConvertCounts = SetCounts | ModelCounts;

/** A part of a universal cover: copies of the surface cut to a disk, one for each element of the fundamental group. */
export interface CoverAnswer {
  /** Whether this is the whole cover. */
  complete: boolean;
  /** The component that is covered, counted from 0. */
  component: number;
  /** The number of components. */
  components: number;
  /** The number of copies. */
  copies: number;
  /** Vertices minus edges plus faces. */
  euler_characteristic: number;
  /** The numbers of vertices, edges and faces. */
  f_vector: number[];
  /** The name of the input; absent for a model that was made in memory. */
  file?: string | null;
  /** The group of deck transformations. */
  group: string;
  /** Where the mesh lies: `flat` or `disk`; `null` over the surface. */
  layout?: string | null;
  /** The edges that letters of the words cross, by their vertices in the file. */
  letters: [number, number][];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The numbers of copies at distance 0, 1, ... of the first. */
  spheres: number[];
  /** The surface below, in words. */
  surface: string;
  /** The word of each copy: i for letter i, counted from 1, -i for its inverse. */
  words: number[][];
}

/** How much of a cell is in a set. */
export type CoverageAnswer = "full" | "cut" | "empty";

/** Cup products of a basis of degree p with one of degree q, in a basis of degree p + q. */
export interface CupProducts {
  /** The degrees p and q. */
  degrees: [number, number];
  /** The basis of degree p. */
  first: [WholeNumber, number[]][][];
  /** The orders of its classes; 0 is infinite. */
  first_orders: WholeNumber[];
  /** The basis of degree q. */
  second: [WholeNumber, number[]][][];
  /** The orders of its classes; 0 is infinite. */
  second_orders: WholeNumber[];
  /** Entry `[i][j]` has the coefficients of the product of class i of the first and class j of the second basis. */
  table: WholeNumber[][][];
  /** The basis of degree p + q. */
  target: [WholeNumber, number[]][][];
  /** The orders of its classes; 0 is infinite. */
  target_orders: WholeNumber[];
}

/** A surface cut open. */
export interface CutAnswer {
  /** The pieces, each with its counts. */
  components: CutPiece[];
  /** The numbers of vertices, edges and faces of all pieces together. */
  f_vector: number[];
  /** The name of the input; absent for a model that was made in memory. */
  file?: string | null;
  /** How the polygons of a canonical cut were drawn; absent unless a layout was asked for. */
  layout?: LayoutAnswer | null;
  /** The path along which the surface was cut; `null` when it was cut to disks. */
  path?: CutPath | null;
  /** Of a canonical cut what was added to the surface; the numbers of vertices in seams are those of the refined surface. */
  refinement?: RefinementAnswer | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What each edge is in the tree-cotree decomposition; absent unless it was asked for. */
  roles?: TreesAnswer | null;
  /** Whether loose ends were left out and seams made short. */
  simplified: boolean;
}

/** A cell of a grid that has some of a set or of its boundary. */
export interface CutCellAnswer {
  /** The area of the set in the cell. */
  area: number;
  /** The column, from 0 at the left. */
  column: number;
  /** How much of the cell is in the set. */
  coverage: CoverageAnswer;
  /** The length of the boundary in the cell. */
  length: number;
  /** The row, from 0 at the bottom. */
  row: number;
}

/** A path along which a surface was cut. */
export interface CutPath {
  /** The number of its edges. */
  edges: number;
  /** `two-sided`, `one-sided` or `open`. */
  kind: string;
}

/** One component after the cut. */
export interface CutPiece {
  /** The vertex where loops start, by its number in the file. */
  base?: number;
  /** The number of edges around it now. */
  boundary_edges: number;
  /**
   * Of a canonical cut the word around the disk by the names of seams and of boundary loops: `a1 b1 a1^-1 b1^-1 ..` of handles,
   * `c1 c1 c2 c2 ..` of cross-caps, `e1 d1 e1^-1 ..` of boundary loops d1, .. to which seams e1, .. lead; `s1 s1^-1` of a sphere, `d1` of a disk.
   */
  canonical?: string | null;
  /** The number of edges along which it was cut. */
  cut_edges: number;
  /** Vertices minus edges plus faces: 1 of a disk. */
  euler_characteristic: number;
  /** The numbers of vertices, edges and faces now. */
  f_vector: [number, number, number];
  /** The number of generators of the fundamental group. */
  generators?: number;
  /** The word of generators around the disk, where there is one: i for generator i, counted from 1, -i for its inverse. */
  relator?: number[] | null;
  /** The seams of the component. */
  seams?: SeamAnswer[];
  /** The surface: before it was cut to a disk, or after it was cut along a path. */
  surface: string;
  /** The seams around the disk: i for the i-th of them, counted from 1, -i backwards. */
  word?: number[];
}

/** The class of a cycle, and whether it bounds. */
export interface CycleClass {
  /** A chain whose boundary is the cycle, or the multiple of it. */
  bounding?: [WholeNumber, number[]][] | null;
  /** Whether the cycle is a boundary. */
  bounds: boolean;
  /** The coefficients of the class in the generators. */
  class: WholeNumber[];
  /** A cocycle that shows that no multiple is a boundary. */
  cocycle?: [WholeNumber, number[]][] | null;
  /** The degree of the cycle. */
  degree: number;
  /** The least m such that m times the cycle is a boundary; `null` if there is none. */
  multiple?: WholeNumber | null;
  /** The orders of the generators; 0 is infinite. */
  orders: WholeNumber[];
  /** The value of the cocycle on the cycle. */
  value?: WholeNumber | null;
}

/** Short closed paths on a surface. */
export interface CyclesAnswer {
  /** The paths; empty if none is of this kind. */
  cycles: ClosedPath[];
  /** The name of the input. */
  file: string;
  /** Which paths they are: `non-contractible`, `non-separating` or `homology-basis`. */
  kind: string;
  /**
   * Of the shortest path of a kind on the whole surface: no path of this kind is shorter than this. It is the length of the path
   * unless the search ended early; `null` if there is no such path, and for other requests.
   */
  lower_bound?: number | null;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** Named numbers on the cells of a model. */
export interface DataAnswer {
  /** How many numbers each of these has. */
  components: number;
  /** The name. */
  name: string;
  /** What the numbers are on. */
  on: string;
  /** The least and the largest number; `null` if there are none. */
  range?: [number | null, number | null] | null;
  /** `integer` or `real`. */
  type: string;
}

/** Polygons that have no area. */
export interface DegeneratePolygons {
  /** How many there are. */
  count: number;
  /** The first hundred of them as pairs: an input and a polygon of it, both from 0. */
  listed: [number, number][];
}

/** How far the classes of one degree are from each other. */
export interface DegreeDistance {
  /** The degree. */
  degree: number;
  /** The distance; `null` if it is infinite: the numbers of classes that never die differ. */
  distance?: number | null;
  /** The numbers of classes that never die in the two inputs. */
  essential: [number, number];
  /** No matching is shorter than this: the value of a solution of the dual problem. `null` if the distance is infinite. */
  lower_bound?: number | null;
  /** Pairs of matched classes, each with its place in its input, from 0; `null` stands for the diagonal. Only if it was asked for. */
  matching?: [number | null, number | null][] | null;
}

/** A function of the value. */
export interface DiagramCurve {
  /** What it is: `degree 1`, `landscape 2 of degree 1`, `euler characteristic`. */
  name: string;
  /** Its numbers, one for each value. */
  numbers: number[];
}

/** A diagram as functions of the value: Betti curves, the Euler characteristic, landscapes, silhouettes. */
export interface DiagramCurvesAnswer {
  /** The curves. */
  curves: DiagramCurve[];
  /** The name of the input. */
  file: string;
  /** `betti`, `euler`, `landscape` or `silhouette`. */
  kind: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The values at which the curves are given. */
  values: number[];
}

/** How far two persistence diagrams are from each other. */
export interface DiagramDistanceAnswer {
  /** The distances by degree. */
  degrees: DegreeDistance[];
  /** The distance of the degrees together: the greatest, or the root of the sum of powers; `null` if it is infinite. */
  distance?: number | null;
  /** The names of the inputs. */
  files: [string, string];
  /** The exponent of the norm that measures a pair; `null` for the greater one of the differences of births and of deaths. */
  internal_p?: number | null;
  /** `bottleneck` or `wasserstein`. */
  metric: string;
  /** The order of a Wasserstein distance; `null` for the bottleneck distance. */
  order?: number | null;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** A persistence image. */
export interface DiagramImageAnswer {
  /** The standard deviation of the normal distribution around each class. */
  bandwidth: number;
  /** The first and the last birth. */
  births: [number, number];
  /** The degree of the classes. */
  degree: number;
  /** The name of the input. */
  file: string;
  /** The first and the last persistence. */
  persistences: [number, number];
  /** The power of the persistence that is the weight of a class. */
  power: number;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The pixels: a row for each range of persistences, from the shortest on, in which births run. */
  rows: number[][];
}

/** Features of maps united by the values of their properties. */
export interface DissolveAnswer {
  /** The dimension of the space: 2. */
  dimension: number;
  /** The numbers of vertices, edges and polygons of all united features. */
  f_vector: [number, number, number];
  /** The united features. */
  groups: DissolvedGroupAnswer[];
  /** The inputs in their order. */
  inputs: DrawingInput[];
  /** The sum of the areas of the united features, in the square of the unit of the inputs. */
  measure: number;
  /** The names of the properties. */
  properties: string[];
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The features that have the same values of the properties. */
export interface DissolvedGroupAnswer {
  /** The number of parts whose inner points are connected. */
  components: number;
  /** How many features were united. A polygon of a feature without any properties counts as one. */
  features: number;
  /** The number of holes of polygons. */
  holes: number;
  /** The area, in the square of the unit of the inputs. */
  measure: number;
  /** The number of polygons. */
  polygons: number;
  /** The values in the order of the properties; null for one that the features do not have. */
  values: unknown[];
}

/** An orientation double cover: every face twice, so that neighbors agree. */
export interface DoubleCoverAnswer {
  /** The number of copies of each face: 2. */
  copies: number;
  /** Vertices minus edges plus faces. */
  euler_characteristic: number;
  /** The numbers of vertices, edges and faces. */
  f_vector: number[];
  /** The name of the input. */
  file: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The components of the cover, in words. */
  surfaces: string[];
  /** The components of the surface below, in words. */
  surfaces_below: string[];
}

/** One drawing among the inputs. */
export interface DrawingInput {
  /** The name of the file. */
  file: string;
  /** The number of polygons it draws. */
  polygons: number;
  /** The number of segments it draws. */
  segments: number;
}

/** One kind of fault of polygons of a drawing. */
export interface DrawnFaultAnswer {
  /** In how many places it is. */
  count: number;
  /** One sentence that says where it is first, and what it means. */
  message: string;
  /** The word for it, such as `ring_crosses_itself`. */
  name: string;
  /** The first places. */
  places: DrawnPlaceAnswer[];
  /** What other programs call it, such as `Self-intersection`; several words can have one. */
  reason: string;
}

/** Where a polygon of a drawing is not valid. */
export interface DrawnPlaceAnswer {
  /** A point of the place, rounded. */
  point: [number, number];
  /** The rings that have the fault, one or two, as pairs: a polygon of the drawing, and a ring of it, 0 for the outer one. */
  rings: [number, number][];
}

/** Whether the polygons with rings of a drawing are valid: those of one geometry together, as OGC's Simple feature access says. */
export interface DrawnPolygonsAnswer {
  /** The number of polygons. */
  count: number;
  /** What is wrong. */
  faults: DrawnFaultAnswer[];
  /** The first fault with its place in the words of other programs, such as `Self-intersection[1 1]`; `null` if there is none. */
  reason?: string | null;
  /** The outer rings that run clockwise and the holes that run counterclockwise: RFC 7946 has them the other way. */
  reversed_rings: number;
  /** Whether all geometries are valid. */
  valid: boolean;
}

/** How an edge of an interface bends. */
export interface EdgeBendAnswer {
  /** The edge. */
  edge: number;
  /** Where its curvature is greatest. */
  greatest: YinBendPlace;
  /** Where its curvature is least: positive where it turns left, one over the unit of the file. */
  least: YinBendPlace;
  /** The phase on its left; null for what is in no phase. */
  left?: number | null;
  /** The phase on its right; null for what is in no phase. */
  right?: number | null;
  /**
   * The knot between its ends at which its direction turns most at once, and by how many degrees, positive to the left; null for an edge
   * of one piece.
   */
  sharpest?: YinBendPlace | null;
}

/** A point of an edge of an interface. */
export interface EdgeSample {
  /** The signed curvature, positive where the edge turns left; null where it stands still. */
  curvature?: number | null;
  /** The edge. */
  edge: number;
  /** The phase on its left; null for what is in no phase. */
  left?: number | null;
  /** The length of the edge from its start, in the unit of the file. */
  length: number;
  /** The parameter in [0, 1] on that piece. */
  parameter: number;
  /** The piece of the edge. */
  piece: number;
  /** The point. */
  point: [number, number];
  /** The phase on its right; null for what is in no phase. */
  right?: number | null;
  /** The direction of the edge, of length one; null where it stands still. */
  tangent?: [number, number] | null;
}

/** The weights of edges in the energy of harmonic forms. */
export type EdgeWeights = "cotangent" | "uniform";

/** A local change of a surface that keeps its homeomorphism type. */
export type Edit = { /** The edge. */ edge: CellName; op: "flip_edge"; } | { /** The edge. */ edge: CellName; op: "flip_edge_back"; } | { /** The edge. */ edge: CellName; op: "split_edge"; } | { op: "remove_vertex"; /** The vertex. */ vertex: number; } | { /** The halfedge at the first corner. */ from: CellName; op: "split_face"; /** The halfedge at the second corner. */ to: CellName; } | { /** The edge. */ edge: CellName; op: "remove_edge"; } | { /** The halfedge at the first corner. */ from: CellName; op: "split_vertex"; /** The halfedge at the second corner. */ to: CellName; } | { /** The edge. */ edge: CellName; op: "contract_edge"; } | { /** The edge. */ edge: CellName; op: "remove_pendant_edge"; } | { /** The edge. */ edge: CellName; op: "collapse_edge"; } | { /** The face. */ face: number; op: "poke_face"; };

/** A surface that was edited. */
export interface EditAnswer {
  /** What was done, each edit with its inverse. */
  edits: EditRecord[];
  /** The numbers of vertices, edges and faces now. */
  f_vector: [number, number, number];
  /** The name of the input. */
  file: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** How many edits of the log were undone. */
  undone: number;
}

/** An edit that was done, and how it is undone. */
export interface EditRecord {
  /** The vertex that was added. */
  added_vertex?: number | null;
  /**
   * The edits that undo it, in their order, by the numbers of cells after it. They bring the same surface back; where a cell
   * had been removed, numbers may be others than before.
   */
  inverse: Edit[];
  /** The vertex that the ends of a collapsed edge are now. */
  kept_vertex?: number | null;
}

/** The Euler characteristic of what has entered, as a function of the value, and along directions. */
export interface EulerAnswer {
  /** The middle of the box of the vertices, from which heights are measured; `null` if they are measured from the origin. */
  center?: number[] | null;
  /** The Euler characteristic of the whole. */
  characteristic: number;
  /** For each direction, or once, a number for each value. */
  curves: number[][];
  /** The directions, each as long as a unit; `null` if cells enter by one function. */
  directions?: number[][] | null;
  /** The name of the input. */
  file: string;
  /** What cells enter by: a coordinate, a file of values, `voxels, t-construction`, or `height along directions`. */
  function: string;
  /** The greatest distance of a vertex from the center, in units of which heights are measured; `null` if they are in the unit of the positions. */
  radius?: number | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** Whether the curves are the integrals of what the characteristic is above its mean over the range of the values. */
  smooth: boolean;
  /** `lower` if values rise, `upper` if they fall. */
  star: string;
  /** The values at which the curves are given. */
  values: number[];
}

/** An input that cannot be served. */
export interface FailedInput {
  /** The message: place, fault and cure. */
  error: string;
  /** The name of the input. */
  file: string;
}

/** A loop along which a surface was cut, and both rims filled. */
export interface FilledHandle {
  /** The number of triangles that fill both rims. */
  added_triangles: number;
  /** The vertices of the other rim, in the order of the first ones, without repetition. */
  added_vertices: number[];
  /** On which side the rims were filled: a handle on the inside, a tunnel on the outside. */
  kind: LoopKind;
  /** The length in the unit of the file, or the number of edges without positions. */
  length: number;
  /** The vertices, by their numbers in the file; the first is repeated at the end. */
  vertices: number[];
}

/** Closed surfaces without their short handles, with what shows it. */
export interface FilledHandlesAnswer {
  /** The surface that was made. No triangles of it have points in common but their common vertices and sides; this was decided exactly. */
  after: HandleCounts;
  /** The surface before, and after. */
  before: HandleCounts;
  /** The name of the input. */
  file: string;
  /** The loops along which the surface was cut and filled, in this order. A later loop may run over vertices that were added before. */
  filled: FilledHandle[];
  /** Loops below the length that could not be filled without triangles that meet others. */
  left: LeftHandle[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** Handles with a loop shorter than this were filled; `null` if all were to be. */
  shorter_than?: number | null;
}

/** A bounded part of the plane that no feature contains. */
export interface GapAnswer {
  /** The area. */
  area: number;
  /** The features around it, numbered from 0. */
  features: number[];
  /** Whether it is so narrow that it is a fault. */
  narrow: boolean;
  /** A corner of it. */
  point: [number, number];
  /** Twice the area by the length of its border: the width of a long narrow one. */
  width: number;
}

/** A model made by rule. */
export interface GenerateAnswer {
  /** The least and the greatest coordinates of all points; null without positions. */
  bounding_box?: [number[], number[]] | null;
  /** Their alternating sum. */
  euler_characteristic: number;
  /** The numbers of cells of each dimension. */
  f_vector: number[];
  /** The file that was written; absent if there is none. */
  output?: string | null;
  /** The format of that file. */
  output_format?: string | null;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** A generator of a homology or cohomology group. */
export interface GeneratorAnswer {
  /** For a cycle of finite order m a chain whose boundary is m times the cycle. */
  bounding?: [WholeNumber, number[]][] | null;
  /** The cycle or cocycle. */
  chain: [WholeNumber, number[]][];
  /** How many cells it runs through, with multiplicity. */
  length: WholeNumber;
  /** The order of its class; 0 is infinite. */
  order: WholeNumber;
}

/** Whether the faces of a model are sound in space. */
export interface GeometryAnswer {
  /** Whether the faces were checked. */
  checked: boolean;
  /** How many faces have no area, or rings that cross: where they meet others was not looked at. */
  faces_left_out: number;
  /** What is wrong, by rising code. */
  faults: GeometryFaultAnswer[];
  /** Why they were not. */
  reason?: string | null;
  /** How many shells touch too many others: how they lie to each other was not looked at. */
  shells_left_out: number;
  /** Whether no faces cross, overlap or contradict each other; `null` if that was not checked. */
  sound_surface?: boolean | null;
  /** Whether the faces bound one valid solid; `null` if that was not checked. */
  valid_solid?: boolean | null;
}

/** One code of faults of faces in space. */
export interface GeometryFaultAnswer {
  /** The code of ISO 19107, from 101 to 405. */
  code: number;
  /** Whether all places are counted. */
  complete: boolean;
  /** In how many places it is. */
  count: number;
  /** One sentence that says how many places have it and what it means. */
  message: string;
  /** The word for it, such as `faces_cross`; several words can have one code. */
  name: string;
  /** `surface` for what is wrong with the surface, `solid` for what only keeps it from bounding one solid. */
  of: string;
  /** The first places. */
  places: GeometryPlace[];
}

/** Where a fault of faces in space is. */
export interface GeometryPlace {
  /** How far a point is from the plane of its face, for faces that are not flat. */
  distance?: number | null;
  /** The faces of the file, from 0. */
  faces: number[];
  /** A point of the place, rounded. */
  point?: [number, number, number] | null;
  /** The vertices that show it. */
  vertices: number[];
}

/** A Cartesian grid. */
export interface GridAnswer {
  /** The numbers of columns and of rows. */
  counts: [number, number];
  /** Its lower left corner. */
  origin: [number, number];
  /** The width and the height of its cells. */
  spacing: [number, number];
}

/** A finitely generated abelian group. */
export interface GroupAnswer {
  /** The rank of the free part. */
  betti: number;
  /** The orders of the cyclic parts, each a divisor of the next. */
  torsion: WholeNumber[];
}

/** What a halfedge of a small surface points to, by the numbers of the file. */
export interface HalfedgePointers {
  /** Its edge. */
  edge: number;
  /** The face on its left. */
  face: number;
  /** The halfedge. */
  halfedge: number;
  /** The next one around its face. */
  next: number;
  /** Whether that is an outer face, which fills a boundary loop. */
  outer: boolean;
  /** The vertex that it leaves. Vertices, edges and faces are numbered by their smallest halfedges. */
  source: number;
  /** The vertex that it goes to. */
  target: number;
  /** The other one of its edge. */
  twin: number;
}

/** A handle: a handle loop and a tunnel loop that cross an odd number of times. */
export interface HandleAnswer {
  /** The component that it is on, from 0 in the order of the first vertices of components. */
  component: number;
  /** The loop that bounds on the inside of its component, but not on the outside. */
  handle: ClosedPath;
  /** The length of the shorter loop, in the unit of the file. */
  length: number;
  /** Which loop is the shorter one. */
  shorter: LoopKind;
  /** The loop that bounds on the outside, but not on the inside. */
  tunnel: ClosedPath;
}

/** The size and the kind of a surface. */
export interface HandleCounts {
  /** Whether it is a manifold without boundary. */
  closed: boolean;
  /** The number of components. */
  components: number;
  /** The Euler characteristic: twice the components less twice the genus. */
  euler_characteristic: number;
  /** The numbers of vertices, edges and triangles. Vertices in no triangle do not count. */
  f_vector: [number, number, number];
  /** The sum of the genera of the components. */
  genus: number;
  /** Whether its triangles agree, or can be turned to agree. */
  orientable: boolean;
}

/** The handles of closed surfaces in space, each by a handle loop and a tunnel loop. */
export interface HandlesAnswer {
  /** The name of the input. */
  file: string;
  /** The sum of the genera of the components: there are as many handles. */
  genus: number;
  /** The handles, that with the shortest loop first. */
  handles: HandleAnswer[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** Only handles whose shorter loop is shorter than this are listed; `null` if all are. */
  shorter_than?: number | null;
}

/** A harmonic cochain. */
export interface HarmonicCochain {
  /** Its values. */
  chain: [number, number[]][];
  /** How far it is from closed: the norm of its coboundary. */
  closed_residual: number;
  /** How far it is from coclosed. */
  coclosed_residual: number;
  /** Its norm. */
  norm: number;
}

/** A harmonic one-form: the cochain of the least energy in its class. */
export interface HarmonicFormAnswer {
  /** The largest sum around a face, which is 0 but for rounding. */
  closed_residual: number;
  /** The largest weighted sum at a vertex, which is 0 but for rounding. */
  coclosed_residual: number;
  /** The values on the edges, in their order. */
  values: number[];
}

/** The norms of a cochain and the parts of its Hodge decomposition. */
export interface HodgeNorms {
  /** Of the cochain. */
  cochain: number;
  /** Of the coexact part. */
  coexact: number;
  /** Of the exact part. */
  exact: number;
  /** Of the harmonic part. */
  harmonic: number;
}

/** The Hodge decomposition of a cochain. */
export interface HodgeParts {
  /** The coexact part. */
  coexact: [number, number[]][];
  /** The degree of the cochain. */
  degree: number;
  /** The exact part. */
  exact: [number, number[]][];
  /** The harmonic part. */
  harmonic: [number, number[]][];
  /** The norms of the cochain and its parts. */
  norms: HodgeNorms;
}

/** Homology or cohomology groups, and what else was asked about them. */
export interface HomologyAnswer {
  /** The ring of coefficients: `Z`, `Q`, `F_2`, ... */
  coefficients: string;
  /** Whether the groups are those of cohomology. */
  cohomology: boolean;
  /** Cup products of two bases. */
  cup?: CupProducts | null;
  /** The classes of the cycles that were given. */
  cycles?: CycleClass[] | null;
  /** The Hodge decomposition of a cochain. */
  decomposition?: HodgeParts | null;
  /** The numbers of cells of degrees 0, 1, ...; only of a complex in parts. */
  f_vector?: number[] | null;
  /** The name of the input. */
  file: string;
  /** For each degree generators of the group. */
  generators?: GeneratorAnswer[][] | null;
  /** For each degree harmonic cochains, dual to the free generators. */
  harmonic?: HarmonicCochain[][] | null;
  /** The groups of degrees 0, 1, ... */
  homology: HomologyGroup[];
  /** The intersection form of a closed oriented manifold of even dimension. */
  intersection_form?: IntersectionFormAnswer | null;
  /** The maps on homology that a simplicial map induces. */
  map?: InducedMaps | null;
  /** The parts that the complex was cut into. */
  parts?: PartsAnswer | null;
  /** The groups of the mesh that was written, one a generator. */
  physical_groups?: PhysicalGroup[] | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The long exact sequence of the pair. */
  sequence?: SequenceAnswer | null;
}

/**
 * A homology or cohomology group of one degree: $\mathbb{Z}^b$ plus a cyclic group for each torsion coefficient.
 *
 * # Examples
 * ```
 * use coface_answers::answer::HomologyGroup;
 * use coface_topology::AbelianGroup;
 * let groups = HomologyGroup::list(&[AbelianGroup::new(1, vec![]), AbelianGroup::new(0, vec![2.into()])]);
 * assert_eq!((groups[1].degree, groups[1].betti, groups[1].torsion.len()), (1, 0, 1));
 * ```
 */
export interface HomologyGroup {
  /** The rank of the free part: the Betti number. Over a field it is the dimension. */
  betti: number;
  /** The degree of the group. */
  degree: number;
  /** The orders of the cyclic parts, each a divisor of the next. */
  torsion: WholeNumber[];
}

/** The number of homomorphisms to a finite group. */
export interface HomomorphismAnswer {
  /** All of them. */
  all: number;
  /** Those onto the whole group. */
  onto: number;
}

/** Closed walks on a surface compared with each other. */
export interface HomotopicAnswer {
  /** The groups that the words of walks are in. */
  components: HomotopicComponent[];
  /** The name of the input. */
  file: string;
  /** All pairs of walks. */
  pairs: WalkPair[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What is known of each walk. */
  walks: WalkAnswer[];
}

/** The group that the words of walks on a component are in. */
export interface HomotopicComponent {
  /** The vertex where loops start and end, by its number in the file. */
  base: number;
  /** The number of generators. */
  generators: number;
  /** The relators: i is generator i, counted from 1, -i its inverse, and the product of the letters is the unit. */
  relators: number[][];
}

/** An operator between the cells of a model: a sparse matrix. */
export interface IncidenceAnswer {
  /** The number of columns. */
  columns: number;
  /** The entries `[row, column, entry]` by rows, counted from 0; absent unless they are asked for. */
  entries?: [number, number, number][] | null;
  /** The number of entries that are not zero. */
  entries_count: number;
  /** The name of the input. */
  file: string;
  /** How often each entry occurs; the keys are the entries as decimal digits. */
  histogram: Record<string, number>;
  /** What the entries are: `shared vertices`, `at least`, `exactly`, `incident` or `signed`. */
  kind: string;
  /** The operator, such as `FE`: rows are faces, columns edges. */
  operator: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The number of rows. */
  rows: number;
}

/** The map of one degree. */
export interface InducedMap {
  /** The cokernel. */
  cokernel: GroupAnswer;
  /** The degree. */
  degree: number;
  /** The kernel. */
  kernel: GroupAnswer;
  /** For each generator of the source the coefficients of its image. */
  matrix: WholeNumber[][];
  /** The orders of the generators of the source; 0 is infinite. */
  source_orders: WholeNumber[];
  /** The orders of the generators of the target; 0 is infinite. */
  target_orders: WholeNumber[];
}

/** The maps on homology that a simplicial map induces. */
export interface InducedMaps {
  /** One map for each degree. */
  degrees: InducedMap[];
  /** The name of the target. */
  target: string;
}

/** The report on one model. A notion that does not apply is `null`. Lengths, areas and volumes are in the unit of the file. */
export interface InfoAnswer {
  /** The area of a surface, in the square of the unit of the file; `null` without positions. */
  area?: number | null;
  /** The number of connected components of the graph of edges with one face; `null` unless the dimension is 2. */
  boundary_loops?: number | null;
  /** The boundary of a volume; `null` for everything else and where there is none. */
  boundary_surface?: BoundarySurface | null;
  /** Whether neighboring top cells agree as the file gives them. */
  coherently_oriented?: boolean | null;
  /** The number of connected components; an isolated vertex is one. */
  components: number;
  /** The named numbers on vertices, lines, polygons and cells. */
  data: DataAnswer[];
  /** The highest degree of a cell; `null` for the empty complex. */
  dimension?: number | null;
  /** The alternating sum of the numbers of cells. */
  euler_characteristic: number;
  /** The numbers of cells of degrees 0, 1, ... up to the dimension. */
  f_vector: number[];
  /** The name of the input; absent for a model that was made in memory. */
  file?: string | null;
  /** The format of the input, such as `off`; absent for a model that was made in memory. */
  format?: string | null;
  /** The genus of a connected surface; of a non-orientable one the number of cross-caps. */
  genus?: number | null;
  /** Whether the faces are sound in space; `null` for what has no faces with coordinates. */
  geometry?: GeometryAnswer | null;
  /** The named sets of vertices, lines, polygons and cells. */
  groups?: NamedGroup[];
  /** Of a surface given by at most 60 halfedges: what each one points to; absent for other models. */
  halfedges?: HalfedgePointers[];
  /** The integral homology of degrees 0, 1, ... up to the dimension. */
  homology: HomologyGroup[];
  /** What sort of thing the model is: `complex`, `surface`, `volume` or `planar`. */
  kind: string;
  /** Whether the model without its isolated vertices is a manifold. */
  manifold: ManifoldAnswer;
  /** Volume, center and inertia of the solid of density 1 that the model encloses. */
  mass?: MassAnswer | null;
  /** The integrals of monomials that were asked for. */
  moments: MomentAnswer[];
  /** The surface in words, such as `torus`, or the 3-manifold, such as `L(8,3)`, where it is proved which one it is, up to orientation (in a sum each summand up to one of its own); else `null`. */
  name?: string | null;
  /** What the name of a 3-manifold rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`; absent without such a name. */
  name_proof?: string | null;
  /** Whether the top cells can be oriented so that neighbors agree; `null` where one of their facets lies in three. */
  orientable?: boolean | null;
  /** Whether the polygons with rings of a drawing are valid; `null` for what has none, and where they were not checked. */
  polygons?: DrawnPolygonsAnswer | null;
  /**
   * What is wrong, and where: with the cells, with the faces in space (more of it under `geometry`), with the polygons of a drawing (more of it
   * under `polygons`).
   */
  problems: ProblemAnswer[];
  /** Whether every cell is a face of a cell of the highest degree; `null` for a chain complex. */
  pure?: boolean | null;
  /** The reference system of the coordinates of a map; absent where the file names none. */
  reference_system?: ReferenceAnswer | null;
  /** The warnings with their codes, counts and first places. */
  remarks: Remark[];
  /** What a repair of the polygons of a drawing would do; absent unless that was asked for. */
  repair?: MapRepairAnswer | null;
  /** The enclosed volume, in the cube of the unit of the file, positive when faces run counterclockwise seen from outside. */
  signed_volume?: number | null;
  /** The center of the area of a surface in space. */
  surface_centroid?: [number, number, number] | null;
  /** The components of a model of polygons, isolated vertices left out. */
  surfaces: SurfaceAnswer[];
  /** How many cells of the highest degree have which shape. */
  top_cells: CellsOfShape[];
  /** What was odd, one sentence each: the reader's remarks, then the first sentence of each problem. */
  warnings: string[];
}

/** The report on one of several inputs, or why there is none. */
export type InfoEntry = InfoAnswer | FailedInput;

/** The reports on several inputs. */
export interface InfoReports {
  /** One entry for each input, in their order. */
  reports: InfoEntry[];
}

/** How the cells inside of a model are found. */
export type InsideMethod = "winding" | "parity" | "closed_mouths";

/** A kink of an interface. */
export interface InterfaceKink {
  /** An edge that begins or ends there. */
  edge: number;
  /** Its knot on that edge. */
  knot: number;
  /** The phases on both sides; null for what is in no phase. */
  phases: [number | null, number | null];
  /** Where it is. */
  point: [number, number];
  /** Its vertex. */
  vertex: number;
}

/** Where a point lies of an interface. */
export interface InterfacePoint {
  /** The distance from the nearest edge; null without edges. */
  distance?: number | null;
  /** The edge that the nearest point is on; null without edges. */
  edge?: number | null;
  /** Whether it lies in a phase, on an edge, or in no phase. */
  location: YinLocation;
  /** The point of the edges that is nearest to it; null without edges. */
  nearest?: [number, number] | null;
  /** The parameter of the nearest point in [0, 1] on that piece; null without edges. */
  parameter?: number | null;
  /** The phase that it lies in; of a point on an edge the phases that meet there, without what is in no phase. */
  phases: number[];
  /** The piece of that edge; null without edges. */
  piece?: number | null;
  /** The point. */
  point: [number, number];
}

/** The intersection form of a closed oriented manifold of even dimension. */
export interface IntersectionFormAnswer {
  /** The basis. */
  basis: [WholeNumber, number[]][][];
  /** The definiteness of a symmetric form. */
  definiteness?: string | null;
  /** The determinant. */
  determinant: WholeNumber;
  /** The values on pairs of the basis. */
  matrix: WholeNumber[][];
  /** The form in words, where it is known. */
  name?: string | null;
  /** `even` or `odd`, of a symmetric form. */
  parity?: string | null;
  /** The rank. */
  rank: number;
  /** The signature of a symmetric form. */
  signature?: number | null;
  /** Whether the form is symmetric; else it is skew. */
  symmetric: boolean;
}

/** Whether two triangulations are the same under other names. */
export interface IsomorphicAnswer {
  /** The first thing found in which they differ and that names do not change; `null` if they are the same. */
  difference?: string | null;
  /** The names of the two inputs. */
  files: [string, string];
  /** Whether they are. */
  isomorphic: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** Their isomorphism signatures; `null` beyond 2,000 simplices and dimension 8. */
  signatures: [string | null, string | null];
  /** For each simplex of the first the one of the second that it is; `null` if they are not the same. */
  simplices?: number[] | null;
  /** For each simplex of the first the places of its vertices in the simplex of the second; vertices of facets are in rising order. */
  vertices?: number[][] | null;
}

/** What was put together because it was nearly one: within a tolerance, or to make rounded coordinates valid. */
export interface JoinedFeatures {
  /**
   * The vertices that became one although they were apart, by their numbers among the points of all inputs, one input after
   * the other.
   */
  classes: number[][];
  /** How many pairs of edges were given a common vertex. */
  crossings: number;
  /** How many times a vertex was put on an edge. */
  edges: number;
  /** How many times a vertex was put on a face. */
  faces: number;
  /** The longest way that a point went, in the unit of the inputs. */
  largest_movement: number;
  /** The number of points that moved. */
  moved: number;
  /** The number of polygons whose planes were replaced by one that fits several. */
  planes: number;
  /** The distance within which features were put together, in the unit of the inputs. */
  tolerance: number;
  /** The number of cells that are not there any more, because they were thinner; none if that was not counted. */
  vanished_cells?: number | null;
  /** How many times a vertex was put to another one. */
  vertices: number;
}

/** The type of a junction. */
export type JunctionKind = "y" | "t" | "x" | "other";

/** A layer over the model. */
export interface LayerAnswer {
  /** What is said about it beside its name. */
  detail: string;
  /** Layers of one group stand together, such as `homology` or `boundary`. */
  group: string;
  /** What it is called. */
  name: string;
}

/** Canonical polygons drawn as regular polygons. */
export interface LayoutAnswer {
  /**
   * `polygon`: in the unit circle of the Euclidean plane; `klein`: in the disk of Klein, where geodesics are straight, so that the corners make
   * one full turn together. Polygons of several components are 2.5 apart.
   */
  plane: string;
  /** Whether the layout is texture coordinates `s` and `t` of the mesh in space, and not its positions. */
  texture: boolean;
  /** The number of triangles. */
  triangles: number;
  /** How many of them are turned over or flat, decided exactly. */
  turned: number;
  /** `uniform`: vertices inside are means of their neighbors; `cotangent`: weighted means, by the cotangents of the intrinsic Delaunay triangulation. */
  weights: string;
}

/** A loop that was not filled. */
export interface LeftHandle {
  /** Where it bounds. */
  kind: LoopKind;
  /** The length in the unit of the file, or the number of edges without positions. */
  length: number;
  /** The vertices, by their numbers in the file; the first is repeated at the end. */
  vertices: number[];
}

/** One level of merging. */
export interface LevelAnswer {
  /** The size of all files, in bytes. */
  bytes: number;
  /** The numbers of critical cells of each degree. */
  critical: number[];
  /** Critical cells for each stratum. */
  critical_per_stratum: number;
  /** The number of parts. */
  parts: number;
  /** The number of strata before the level was reduced. */
  strata: number;
  /** The number of bits of the largest incidence. */
  widest_bits: number;
}

/** A loop that cocycles are measured on. */
export type LoopAnswer = number[] | [WholeNumber, number[]][];

/** The intersection numbers of loops on a closed oriented surface. */
export interface LoopIntersections {
  /** The determinant of the matrix; `null` where it was not computed. */
  determinant?: WholeNumber | null;
  /** How often loop j crosses loop i, from the right to the left as plus, in row i. */
  matrix: number[][];
}

/** Where a loop on a closed surface in space bounds. */
export type LoopKind = "handle" | "tunnel";

/** Loops that generate the fundamental group of each component. */
export interface LoopsAnswer {
  /** The components; that of the base vertex comes first. */
  components: LoopsComponent[];
  /** The name of the input. */
  file: string;
  /** Which loops they are: `any`, `shortest` or `canonical`. */
  kind: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The trees that the loops of a complex of at most 40 edges come from; `null` for larger ones. */
  trees?: TreesAnswer | null;
}

/** The loops of one component. */
export interface LoopsComponent {
  /** The vertex where loops start and end, by its number in the file. */
  base: number;
  /** The loops: loop i is generator i + 1. */
  loops: ClosedPath[];
  /** The group in words; `null` if it is not recognized, which says nothing. */
  name?: string | null;
  /** The relators: i is loop i, counted from 1, -i its inverse, and the product of the letters can be contracted. */
  relators: number[][];
}

/** Whether a model is a manifold, with or without boundary. */
export interface ManifoldAnswer {
  /** Whether there is no boundary. */
  closed?: boolean | null;
  /** `yes`, `no` or `unknown`. */
  verdict: string;
  /** Why the model is no manifold. */
  witness?: WitnessAnswer | null;
}

/** A map that was changed or examined. */
export interface MapAnswer {
  /** How arcs were flattened; of `buffer`. */
  arcs?: BufferArcsAnswer | null;
  /** How much the new map has. */
  counts: MapCounts;
  /** Gaps, overlaps and sides that do not fit; of `coverage`. */
  coverage?: MapCoverageAnswer | null;
  /** The dimension of the space: 2. */
  dimension: number;
  /** The inputs in their order. */
  inputs: DrawingInput[];
  /** What was left out; of `polygonize`. */
  left_out?: PolygonizeAnswer | null;
  /** The sum of the lengths of its lines, which rings are not, in the unit of the inputs. */
  length: number;
  /** The sum of the areas of its polygons, in the square of the unit of the inputs. */
  measure: number;
  /** What was assumed, changed or left out. */
  remarks: Remark[];
  /** What was repaired: of `repair`, and of `buffer` and `clip`, which repair polygons first. */
  repair?: MapRepairAnswer | null;
  /** How much simpler the map is; of `simplify`. */
  simplification?: SimplificationAnswer | null;
  /** What was done: repair, buffer, clip, node, polygonize, simplify or coverage. */
  task: string;
}

/** How much a map has. */
export interface MapCounts {
  /** The number of features, those that draw nothing included. */
  features: number;
  /** The number of their holes. */
  holes: number;
  /** The number of lines, which rings are not. */
  lines: number;
  /** The number of points of their own. */
  points: number;
  /** The number of polygons. */
  polygons: number;
  /** The number of corners of rings and lines, and of points. */
  vertices: number;
}

/** Whether polygons are a coverage. */
export interface MapCoverageAnswer {
  /** The width up to which a gap is a fault; `null` if none is. */
  gap_width?: number | null;
  /** Bounded connected parts of the plane that are in no feature. */
  gaps: GapAnswer[];
  /** How many sides of polygons overlap others, run into them or meet them at no vertex of their own; the new map has these sides. */
  invalid_edges: number;
  /** Connected parts of the plane that are in several features. */
  overlaps: OverlapAnswer[];
  /** Whether polygons do not overlap, common borders have the same vertices on both sides, and no gap is too narrow. */
  valid: boolean;
}

/** Polygons that were made valid. */
export interface MapRepairAnswer {
  /** Their area now. */
  area: number;
  /** The area of those features before, as outer rings minus holes, which other programs state of polygons that are not valid. */
  area_before: number;
  /** The area of what is inside now and not enclosed an odd number of times by the rings of before, or the other way around. */
  area_changed: number;
  /** What was wrong. */
  faults: DrawnFaultAnswer[];
  /** How many features were not valid and are now. */
  features: number;
  /** How far points moved at most so that rounded coordinates are valid. */
  largest_movement: number;
  /** What decided what is inside: structure or linework. */
  method: string;
  /** How many rings of valid polygons were reversed: outer ones run counterclockwise and holes clockwise now (RFC 7946). */
  rings_turned: number;
  /** How many features have no polygon any more. */
  vanished: number;
}

/** Mass properties of a solid of density 1. */
export interface MassAnswer {
  /** The center of mass. */
  centroid: [number | null, number | null, number | null];
  /** The inertia about the center, by rows; a number is `null` beyond the range of floating point. */
  inertia: [[number | null, number | null, number | null], [number | null, number | null, number | null], [number | null, number | null, number | null]];
  /** The volume; `null` beyond the range of floating point. */
  volume?: number | null;
}

/** A boundary matrix in blocks. */
export interface MatrixAnswer {
  /** The blocks of columns in their order. */
  columns: BlockAnswer[];
  /** The degree of the cells of columns; rows are cells of the degree below. */
  degree: number;
  /** The number of entries that are not zero. */
  entries_count: number;
  /** The blocks of rows in their order. */
  rows: BlockAnswer[];
}

/** What was repaired, by the vertices and polygons of the input. */
export interface MeshRepairAnswer {
  /** The new vertices, each with the vertex that it is a copy of. */
  copies: [number, number][];
  /** The edges in more than two faces that were split, each by its ends. */
  edges_split: [number, number][];
  /** The polygons whose direction was reversed. */
  faces_turned: number[];
  /**
   * What else was done to make a surface; absent unless that was asked for. The other lists are then by the vertices and faces after
   * merging and cleaning.
   */
  surface?: SurfaceRepairAnswer | null;
  /** The vertices with several fans of faces that were split. */
  vertices_split: number[];
}

/** How much of a model a file holds. */
export interface ModelCounts {
  /** The number of cells of dimension 3. */
  cells: number;
  /** The number of arrays of data on cells. */
  data: number;
  /** The number of polylines. */
  lines: number;
  /** The number of polygons. */
  polygons: number;
  /** The number of vertices. */
  vertices: number;
}

/** The integrals of a monomial x^a y^b z^c. */
export interface MomentAnswer {
  /** The exponents a, b, c. */
  exponents: [number, number, number];
  /** The integral over the surface, with respect to area. */
  surface?: number | null;
  /** The integral over the enclosed solid. */
  volume?: number | null;
}

/** A named set of vertices, lines, polygons or cells of a model: an object of an OBJ, a solid of an STL, a physical group of Gmsh. */
export interface NamedGroup {
  /** How many members it has. */
  count: number;
  /** The name, or the number, that the file gives it; one of polygons is read alone as `FILE#name`. */
  name: string;
  /** What the members are. */
  of: string;
}

/** A part of the plane that several features contain. */
export interface OverlapAnswer {
  /** The area. */
  area: number;
  /** The features, numbered from 0. */
  features: number[];
  /** A corner of it. */
  point: [number, number];
}

/** How a complex was cut into parts. */
export interface PartsAnswer {
  /** The size of what was sent between levels, in bytes. */
  bytes: number;
  /** The number of parts. */
  count: number;
  /** Critical cells for each stratum of the first level: 1 where all strata are balls. */
  critical_per_stratum: number;
  /** How many neighbors are merged at once. */
  fan_in: number;
  /** The levels, from the shards on. */
  levels: LevelAnswer[];
}

/** Persistent homology of a function on a complex. */
export interface PersistenceAnswer {
  /** The Betti numbers of the whole complex over the field, of points those at the threshold. */
  betti: number[];
  /** The numbers of edges before and after their collapse, if they were collapsed; cells of pairs are among those that are left. */
  collapsed?: [number, number] | null;
  /** The pairs of all degrees. */
  diagram: PersistencePairAnswer[];
  /** The characteristic of the field of coefficients. */
  field: number;
  /** The name of the input. */
  file: string;
  /** The function on the vertices, the file of the values, `vietoris-rips`, `flag complex`, `zigzag`, or `voxels, v-construction` or `voxels, t-construction` of an image. */
  function: string;
  /**
   * The part whose classes are followed in the whole, if there is one: they are born in the part, and die when they bound in the whole. `betti` has the ranks of
   * its homology in that of the whole.
   */
  image_of?: string | null;
  /** The part that homology is taken relative to, if there is one. */
  relative_to?: string | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /**
   * How cells follow from the function: `lower` or `upper`; `null` for given values. Of an image sublevel or superlevel sets; `extended` where
   * both are asked for.
   */
  star?: string | null;
  /** The largest diameter or value of the simplices that were looked at; `null` unless the input is points, distances or a graph. */
  threshold?: number | null;
  /**
   * The primes over whose fields other cells are paired than over the rational numbers: torsion comes or goes along the way. Only if cycles were asked
   * for.
   */
  torsion_primes?: number[] | null;
  /** The names of the vertices by their numbers, of a graph whose vertices have names. */
  vertex_names?: string[] | null;
}

/** A homology class that is born and dies, or stays. */
export interface PersistencePairAnswer {
  /** The value at which it is born. */
  birth: number;
  /** The cell that gives birth to it, by its vertices; of an image the voxel whose value the birth is, by its place along each axis. */
  birth_cell: number[];
  /** The chain of the next degree, there from the death on, whose boundary the cycle is; of a class that dies. */
  bounding_chain?: [WholeNumber, number[]][] | null;
  /** A cocycle of the cells before the death, with the value 1 on the cycle. */
  cocycle?: [WholeNumber, number[]][] | null;
  /** A cycle of the class, there from the birth on. Only if cycles were asked for, as the following ones. */
  cycle?: [WholeNumber, number[]][] | null;
  /** The value at which it dies; `null` if it stays. */
  death?: number | null;
  /** The cell by which it dies, by its vertices; of an image the voxel whose value the death is. */
  death_cell?: number[] | null;
  /** The degree of the class. */
  degree: number;
  /**
   * Of extended persistence `ordinary`, `extended+`, `extended-` or `relative`; of a relative class the degree is that of relative homology. Of a zigzag
   * `closed-open`, `closed-closed`, `open-closed` or `open-open`: whether the class is there at the time of its birth, and at that of its death.
   */
  kind?: string | null;
}

/** What a phase has of a cell. */
export interface PhaseCell {
  /** The area of the phase in the cell. */
  area: number;
  /** The column, from 0 at the left. */
  column: number;
  /** How much of the cell is in the phase. */
  coverage: CoverageAnswer;
  /** The length of its boundary in the cell. */
  length: number;
  /** The number of the phase, from 0, in the order of `"phases"`. */
  phase: number;
  /** The row, from 0 at the bottom. */
  row: number;
}

/** What a phase has of a grid. */
export interface PhaseCells {
  /** The area of the phase in the grid. */
  area: number;
  /** The area of the phase; null if it is infinite. */
  area_of_phase?: number | null;
  /** The number of cells that are partly in the phase. */
  cut: number;
  /** The number of cells outside of the phase. */
  empty: number;
  /** The number of cells inside of the phase. */
  full: number;
  /** The length of its boundary in the grid. */
  length: number;
  /** The name of the phase. */
  name: string;
}

/** How far a phase of one interface is from one of another. */
export interface PhaseComparison {
  /**
   * The greatest distance of the second boundary from the first along the normals of the first, up to twice the Hausdorff distance; null if
   * no normal meets it so near.
   */
  along_normals?: number | null;
  /** An estimate from above of how far that is off. */
  along_normals_error: number;
  /** The area of the first set less that of the second; null if it is infinite. */
  area_signed?: number | null;
  /** How far that is off at most by rounding. */
  area_signed_error: number;
  /** The area of the symmetric difference; null if it is infinite. */
  area_xor?: number | null;
  /** An estimate from above of how far that is off. */
  area_xor_error: number;
  /** The number of components of each set. */
  components: [number, number];
  /** The greatest difference of the curvatures of both boundaries where normals meet, in the inverse of the unit; null if none does. */
  curvature?: number | null;
  /** An estimate from above of how far that is off. */
  curvature_error: number;
  /** The names of the inputs. */
  files: string[];
  /** The Hausdorff distance of the boundaries; null if one set alone has a boundary. */
  hausdorff?: number | null;
  /** An estimate from above of how far that is off. */
  hausdorff_error: number;
  /** The number of holes of each set. */
  holes: [number, number];
  /** The part of the places of the first boundary whose normals do not meet the second one so near. */
  normals_left_out: number;
  /** The numbers of the phases. */
  numbers: [number, number];
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** How many points lie in a phase. */
export interface PhasePoints {
  /** The number of points inside. */
  inside: number;
  /** The name of the phase. */
  name: string;
}

/** A generator as a physical group of a mesh. */
export interface PhysicalGroup {
  /** The degree of the generator: the dimension of the elements. */
  degree: number;
  /** The number of its elements: the cells of the generator, each as often as its coefficient says. */
  elements: number;
  /** The name of the group. */
  name: string;
  /** Its tag. */
  tag?: number | null;
}

/** The fundamental group of each component, by generators and relators. */
export interface Pi1Answer {
  /** The components; that of the base vertex comes first. */
  components: Pi1Component[];
  /** The short closed paths that were asked for. */
  cycles?: ClosedPath[] | null;
  /** The name of the input. */
  file: string;
  /** The walks compared with each other. */
  pairs?: WalkPair[] | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** Whether the presentations were simplified. */
  simplified: boolean;
  /** What is known of each walk that was given. */
  walks?: WalkAnswer[] | null;
}

/** The fundamental group of one component. */
export interface Pi1Component {
  /** The abelianization, which agrees with the first homology. */
  abelianization: GroupAnswer;
  /** The vertex where loops start and end, by its number in the file. */
  base: number;
  /** The number of generators. */
  generators: number;
  /** The numbers of homomorphisms to some finite groups; `null` where they take too long to count. */
  homomorphisms?: Record<string, HomomorphismAnswer | null>;
  /** The lengths of the loops of a surface, in the unit of the file. */
  lengths?: number[] | null;
  /** The group in words, or by a presentation in standard form; `null` if it is not recognized, which says nothing. */
  name?: string | null;
  /** The relators: i is generator i, counted from 1, -i its inverse, and the product of the letters is the unit. */
  relators: number[][];
  /** The closed 3-manifold that the complex is, where the name of the group follows from it; absent where it follows from the presentation. */
  space?: SpaceAnswer | null;
  /** The numbers of subgroups of index 1, 2, ...; `null` if they take too long to count. */
  subgroups?: SubgroupCount[] | null;
  /** Why there is no name; absent with one. */
  unrecognized?: Unrecognized | null;
}

/** The places where a result in space is pinched, by coordinates before pinches are split. */
export interface Pinches {
  /** The number of vertices that were copied to split them. */
  copies: number;
  /** The number of edges in more than two polygons. */
  edge_count: number;
  /** The first hundred such edges by the positions of their ends. */
  edges: number[][][];
  /** Whether pinches were split. */
  split: boolean;
  /** The number of vertices whose polygons are connected in several ways. */
  vertex_count: number;
  /** The first hundred such vertices by their positions. */
  vertices: number[][];
}

/** Where a [`Remark`] applies. The fields that say nothing are `None` and absent from the JSON. */
export interface Place {
  /** A cell by its vertices, numbered from 0 in the order of the file. */
  cell?: number[] | null;
  /** The name of the input. */
  file?: string | null;
  /** The line of the file, counted from 1. */
  line?: number | null;
  /** A point, in the unit of the input. */
  point?: number[] | null;
}

/** The arrangement of drawings in the plane. */
export interface PlanarArrangementAnswer {
  /** The columns of the table of faces, with `--attributes`; absent without. */
  attributes?: AttributeColumn[] | null;
  /** The number of edges with one face on both sides. */
  bridges: number;
  /** The number of connected components of vertices and edges. */
  components: number;
  /** What congruence put together; with `--method congruence` only. */
  congruence?: CongruentPieces | null;
  /** The number of those bridges that are joined to the rest at one end, or at none. */
  dangling_edges: number;
  /** The dimension of the space: 2. */
  dimension: number;
  /** Vertices minus edges plus bounded faces. */
  euler_characteristic: number;
  /** The numbers of vertices, edges and bounded faces. */
  f_vector: [number, number, number];
  /** The number of holes in bounded faces. */
  holes: number;
  /** The inputs in their order. */
  inputs: DrawingInput[];
  /** For each bounded face the inputs (or the regions, if features are inputs) that contain it, numbered from 0, rising. */
  inside: number[][];
  /** What was put together, where that was asked for. */
  joined?: JoinedFeatures | null;
  /** The areas of the bounded faces, in the square of the unit of the inputs. */
  measures: number[];
  /** Whether the boundary of every boundary is zero, found by multiplying the matrices. */
  products_zero: boolean;
  /** The names of the regions in their order. */
  regions: string[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What rounding the coordinates does to the drawing. */
  rounding: PlanarRounding;
  /** How many times coordinates were rounded and everything arranged again; null unless snapping was asked for. */
  snap_rounds?: number | null;
  /** Sentences about what is odd in the inputs. */
  warnings: string[];
}

/** A Boolean combination of regions in the plane. */
export interface PlanarBooleanAnswer {
  /**
   * The numbers of vertices, edges and faces that the inputs cut the plane into; where many regions cover each other,
   * that the sides which are cut do.
   */
  arrangement: [number, number, number];
  /** Whether the boundary is closed: always true. */
  closed: boolean;
  /** The number of parts whose inner points are connected. */
  components: number;
  /** What congruence put together; with `--method congruence` only. */
  congruence?: CongruentPieces | null;
  /** The dimension of the space: 2. */
  dimension: number;
  /** The numbers of vertices, edges and polygons. */
  f_vector: [number, number, number];
  /** The number of holes of polygons. */
  holes: number;
  /** The inputs in their order. */
  inputs: DrawingInput[];
  /** What was put together, where that was asked for. */
  joined?: JoinedFeatures | null;
  /** Whether the boundary is a curve everywhere. */
  manifold: BoundaryManifold;
  /** The area, in the square of the unit of the inputs. */
  measure: number;
  /** The areas of the polygons without their holes. */
  measures: number[];
  /** The number of vertices where more than two edges of the boundary meet. */
  pinches: number;
  /** The number of polygons. */
  polygons: number;
  /** The names of the regions, which are the inputs of the formula. */
  regions: string[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What rounding the coordinates does to the polygons. */
  rounding: PolygonRounding;
  /** How many times coordinates were rounded and everything arranged again; null unless snapping was asked for. */
  snap_rounds?: number | null;
  /** Sentences about what is odd in the inputs. */
  warnings: string[];
}

/** What rounding the coordinates of crossings does to an arrangement in the plane. */
export interface PlanarRounding {
  /** How many vertices were added to edges. */
  bends?: number;
  /** The number of edges that cross others when they are drawn with rounded coordinates. */
  broken_edges: number;
  /** Whether no coordinate was rounded. */
  exact: boolean;
  /** The longest way that a point of an edge went, in the unit of the inputs. */
  largest_movement?: number;
  /** The number of vertices that have the rounded position of another one. */
  merged_vertices: number;
  /** The vertices that became one with others, or went to another place than the nearest. */
  moved?: number;
  /** The number of components that lie in another face. */
  moved_components: number;
  /** How many times the result was rounded and cut again. */
  rounds?: number;
  /** The number of vertices around which the order of the edges changes. */
  turned_vertices: number;
  /** Whether the drawing with rounded coordinates is the same complex. */
  valid: boolean;
  /** The number of faces or polygons that are not there any more, because they were thinner. */
  vanished?: number;
}

/** What rounding the coordinates of crossings does to polygons. */
export interface PolygonRounding {
  /** How many vertices were added to edges. */
  bends?: number;
  /** Whether no coordinate was rounded. */
  exact: boolean;
  /** The longest way that a point of an edge went, in the unit of the inputs. */
  largest_movement?: number;
  /** The vertices that became one with others, or went to another place than the nearest. */
  moved?: number;
  /** How many times the result was rounded and cut again. */
  rounds?: number;
  /** Whether the polygons are valid with rounded coordinates, as one multipolygon of OGC's Simple feature access. */
  valid: boolean;
  /** The number of faces or polygons that are not there any more, because they were thinner. */
  vanished?: number;
}

/** Edges that bound no face. */
export interface PolygonizeAnswer {
  /** The number of other edges with one face on both sides. */
  cut_edges: number;
  /** The number of edges that hang on the rest at one end or at none. */
  dangles: number;
}

/** A fundamental group in a row, by a presentation that was simplified. */
export interface PresentedGroup {
  /** The abelianization. */
  abelianization: GroupAnswer;
  /** The number of generators. */
  generators: number;
  /** The group in words; `null` if it is not recognized, which says nothing. */
  name?: string | null;
  /** The relators: i is generator i, counted from 1, -i its inverse, and the product of the letters is the unit. */
  relators: number[][];
}

/** One sort of fault with its places. */
export interface ProblemAnswer {
  /** The first cells that have it, each by its vertices. */
  cells: number[][];
  /** In how many places it is. */
  count: number;
  /** What sort of fault it is, such as `nonmanifold_edge`. */
  kind: string;
  /** One sentence that says how many places have it and what it means. */
  message: string;
  /** The first places as points, of two or three rounded coordinates each; empty where the cells are the places. */
  points?: number[][];
  /** For each of the cells the top cells that meet there; empty when that says nothing. */
  top_cells: number[][];
}

/** Shards that were reduced to their critical cells. */
export interface ReduceAnswer {
  /** One entry for each shard. */
  reduced: ReducedShard[];
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** What is left of one shard. */
export interface ReducedShard {
  /** The size of the file, in bytes. */
  bytes: number;
  /** The numbers of cells of each degree. */
  cells: number[];
  /** The checksum of the file, in hexadecimal digits. */
  checksum: string;
  /** The numbers of critical cells of each degree. */
  critical: number[];
  /** The file that was written. */
  file: string;
  /** Its level; the shards are level 0. */
  level: number;
  /** Its number in the level. */
  number: number;
  /** Whether it was there already, whole and made of this shard. */
  skipped: boolean;
  /** The number of strata. */
  strata: number;
}

/** The reference system that the file of a map names. */
export interface ReferenceAnswer {
  /** The text of its member `crs` in GeoJSON. */
  crs: string;
  /** Its number, such as 25832 of EPSG; `null` if it has none. */
  srid?: number | null;
}

/** A vertex that was added to a surface, on an edge or in a face. */
export interface RefinedVertex {
  /** The vertices of the file whose convex combination it is: the ends of its edge, or corners of its face. */
  of: number[];
  /** Its number: those of the file come first. */
  vertex: number;
  /** Their weights, which add up to 1. */
  weights: number[];
}

/** A surface that was refined. */
export interface RefinementAnswer {
  /** The numbers of vertices, edges and faces of the refined surface, before it is cut. */
  f_vector: number[];
  /** The new vertices. */
  vertices: RefinedVertex[];
}

/**
 * One thing worth knowing about an answer: what was assumed, changed or left out, how often, and where first.
 *
 * # Examples
 * ```
 * use coface_io::{Place, Remark, RemarkCode};
 * let remark = Remark::new(RemarkCode::IsolatedVertex, "1 vertex is in no cell").at(1, [Place::cell(&[7])]);
 * assert_eq!(remark.places[0].cell.as_deref(), Some(&[7][..]));
 * ```
 */
export interface Remark {
  /** What sort of remark it is, for programs. */
  code: RemarkCode;
  /** How many times it applies. */
  count: number;
  /** The remark for people: one sentence. */
  message: string;
  /** The first places where it applies; empty when it is about the whole input or the request. */
  places: Place[];
}

/** What sort of remark a [`Remark`] is. The word in the JSON is the name in kebab case: `isolated-vertex`. */
export type RemarkCode = "input-reading" | "repeated-vertex" | "collapsed-cell" | "counts-differ" | "partial-file" | "unknown-section" | "missing-end" | "trailing-content" | "fractional-label" | "nonfinite-coordinate" | "format-by-content" | "several-models" | "higher-order" | "single-point" | "heights-assumed" | "reference-assumed" | "heights-left-out" | "elements-left-out" | "curves-flattened" | "arcs-approximated" | "self-crossing-ring" | "unclosed-ring" | "faces-split" | "unknown-key" | "order-raised" | "nonmanifold-ridge" | "nonmanifold-edge" | "nonmanifold-vertex" | "orientation-conflict" | "one-sided-chain" | "duplicate-cell" | "isolated-vertex" | "coincident-vertices" | "loose-cell" | "geometry-fault" | "invalid-polygon" | "cells-not-balls" | "negative-volume" | "subdivision-counted" | "ideal-vertices-cut" | "format-keeps-less" | "step-left-out" | "handles-left" | "search-ended" | "summand-orientations" | "unit-lengths" | "uniform-weights" | "layout-replaced" | "triangles-turned" | "open-input" | "empty-input" | "unnamed-input" | "objects-in-file" | "reversed-input" | "overlapping-input" | "faces-triangulated" | "unbounded-segments" | "drawing-assumption" | "property-missing" | "cells-left-out" | "empty-boundary" | "rounded-invalid" | "points-rounded" | "numbers-rounded" | "colors-as-numbers" | "features-joined" | "tolerance-assumed" | "thin-cells" | "beyond-range" | "data-left-out" | "merged-within-block" | "topology-repaired" | "curves-vanished" | "contacts-kept" | "contact-below-knots" | "decision-uncertified" | "model-repaired" | "vertices-renumbered" | "not-drawn" | "drawn-instead" | "positions-invented" | "earlier-run-ignored" | "input-refused";

/** A still picture. */
export interface RenderAnswer {
  /** The size of the picture in bytes. */
  bytes: number;
  /** The name of the file that is shown. */
  file: string;
  /** The boundary matrix that was drawn in blocks, of a picture of one. */
  matrix?: MatrixAnswer | null;
  /** The file of the picture; null if none was written. */
  picture?: string | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The polygons that were drawn, of a picture of them. */
  schemas?: SchemaAnswer[];
}

/**
 * What a row of `batch` says of a file that could be read, beside its `path`, `bytes`, `seconds` and `error`: what `info` says of it. A
 * row has warnings, but no remarks.
 */
export interface RowAnswer {
  /** The area of a surface, in the square of the unit of the file; `null` without positions. */
  area?: number | null;
  /** The number of connected components of the graph of edges with one face; `null` unless the dimension is 2. */
  boundary_loops?: number | null;
  /** The boundary of a volume; `null` for everything else and where there is none. */
  boundary_surface?: BoundarySurface | null;
  /** Whether neighboring top cells agree as the file gives them. */
  coherently_oriented?: boolean | null;
  /** The number of connected components; an isolated vertex is one. */
  components: number;
  /** The named numbers on vertices, lines, polygons and cells. */
  data: DataAnswer[];
  /** The highest degree of a cell; `null` for the empty complex. */
  dimension?: number | null;
  /** The alternating sum of the numbers of cells. */
  euler_characteristic: number;
  /** The numbers of cells of degrees 0, 1, ... up to the dimension. */
  f_vector: number[];
  /** The name of the file, as the row has it in `path`. */
  file: string;
  /** The format of the file, such as `off`. */
  format: string;
  /** The genus of a connected surface; of a non-orientable one the number of cross-caps. */
  genus?: number | null;
  /** Whether the faces are sound in space; `null` for what has no faces with coordinates. */
  geometry?: GeometryAnswer | null;
  /** The named sets of vertices, lines, polygons and cells. */
  groups: NamedGroup[];
  /** The integral homology of degrees 0, 1, ... up to the dimension. */
  homology: HomologyGroup[];
  /** What sort of thing the model is: `complex`, `surface`, `volume` or `planar`. */
  kind: string;
  /** Whether the model without its isolated vertices is a manifold. */
  manifold: ManifoldAnswer;
  /** Volume, center and inertia of the solid of density 1 that the model encloses. */
  mass?: MassAnswer | null;
  /** The integrals of monomials that were asked for. */
  moments: MomentAnswer[];
  /** The surface in words, such as `torus`, or the 3-manifold, such as `L(8,3)`, where it is proved which one it is, up to orientation (in a sum each summand up to one of its own); else `null`. */
  name?: string | null;
  /** What the name of a 3-manifold rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`; absent without such a name. */
  name_proof?: string | null;
  /** Whether the top cells can be oriented so that neighbors agree; `null` where one of their facets lies in three. */
  orientable?: boolean | null;
  /** Whether the polygons with rings of a drawing are valid; `null` for what has none, and where they were not checked. */
  polygons?: DrawnPolygonsAnswer | null;
  /** What is wrong, and where. */
  problems: ProblemAnswer[];
  /** Whether every cell is a face of a cell of the highest degree; `null` for a chain complex. */
  pure?: boolean | null;
  /** The enclosed volume, in the cube of the unit of the file, positive when faces run counterclockwise seen from outside. */
  signed_volume?: number | null;
  /** The center of the area of a surface in space. */
  surface_centroid?: [number, number, number] | null;
  /** The components of a model of polygons, isolated vertices left out. */
  surfaces: SurfaceAnswer[];
  /** How many cells of the highest degree have which shape. */
  top_cells: CellsOfShape[];
  /** What was odd, one sentence each: the reader's remarks, then the first sentence of each problem. */
  warnings: string[];
}

/** A polygon whose sides are glued by letters. */
export interface SchemaAnswer {
  /** For each corner the number of its class: those of one class are glued to one point. Side i runs from corner i to the next. */
  corner_classes: number[];
  /** The surface that it is glued to; `null` if a letter is at three sides or more. */
  surface?: string | null;
  /** The letters of its sides, counterclockwise: `a b a^-1 b^-1`. */
  word: string;
}

/** A path of edges along which a component was cut. */
export interface SeamAnswer {
  /** The number of its edges. */
  edges: number;
  /** What the disk becomes when it is glued together again at this seam alone: `annulus` or `moebius`. */
  glued?: string;
  /**
   * `handle`: with the others of this kind it opens the handles of an orientable component; `crosscap`: with the others it opens the
   * cross-caps of one that is not orientable; `join`, `slit`.
   */
  kind: string;
  /** Its length in the unit of the file; `null` without positions. */
  length?: number | null;
  /** Its name in the canonical word; absent unless the cut is canonical. */
  name?: string | null;
  /** The number among all seams, counted from 1. */
  number: number;
  /** Its vertices in their order, by their numbers in the file. */
  vertices: number[];
}

/** The long exact sequence of a pair. Columns of maps are images of generators; a map that is not there is `null`. */
export interface SequenceAnswer {
  /** The homology of the complex. */
  complex: HomologyGroup[];
  /** For each degree the map of the pair to the subcomplex, one degree below. */
  connecting: (WholeNumber[][] | null)[];
  /** Whether the sequence was checked to be exact. */
  exact: boolean;
  /** For each degree the map of the subcomplex into the complex. */
  inclusion: (WholeNumber[][] | null)[];
  /** What is known of each map that is there, in the order of the sequence: from the top degree down. */
  maps?: SequenceMap[];
  /** The homology of the pair. */
  pair: HomologyGroup[];
  /** For each degree the map of the complex to the pair. */
  projection: (WholeNumber[][] | null)[];
  /** The homology of the subcomplex. */
  subcomplex: HomologyGroup[];
}

/** A map of a long exact sequence. */
export interface SequenceMap {
  /** The degree of its source. */
  degree: number;
  /** Its image, which is the kernel of the next map. */
  image: GroupAnswer;
  /** Whether its kernel is zero. */
  injective: boolean;
  /** `inclusion`, `projection` or `connecting`. */
  map: string;
  /** The rank of its image. */
  rank: number;
  /** Whether its image is the target. */
  surjective: boolean;
}

/** How much of a set of the plane a file holds. */
export interface SetCounts {
  /** The number of curves. */
  curves: number;
  /** The number of kinks. */
  kinks: number;
}

/** A complex cut into files. */
export interface ShardAnswer {
  /** The size of all shards, in bytes. */
  bytes: number;
  /** How many neighbors are merged at once. */
  fan_in: number;
  /** The name of the input. */
  file: string;
  /** The size of the largest shard, in bytes. */
  largest: number;
  /** The folder of the shards. */
  output: string;
  /** The number of shards. */
  parts: number;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/**
 * What is known of the gluing table of a signature. Ideal vertices are cut off unless they are taken as points: manifold, homology
 * and groups are those of the space with boundary that is left.
 */
export interface SignatureAnswer {
  /** Whether every triangle lies in two tetrahedra. */
  closed: boolean;
  /** The number of connected components. */
  components: number;
  /** The Euler characteristic of the space. */
  euler_characteristic: number;
  /** The numbers of vertices, edges, triangles and tetrahedra of the triangulation. */
  f_vector: number[];
  /** The fundamental group of each component; absent unless it is asked for. */
  groups?: PresentedGroup[] | null;
  /** The integral homology of degrees 0 to 3. */
  homology: HomologyGroup[];
  /** How many vertices have a link that is a closed surface other than the sphere. */
  ideal_vertices: number;
  /** Whether the space is a manifold: `yes`, `no` or `unknown`. */
  manifold: string;
  /** Whether the tetrahedra can be oriented so that neighbors agree. */
  orientable: boolean;
  /** Which 3-manifold the space is, `null` where that is not proved; absent unless it is asked for. */
  space?: SpaceAnswer | null;
  /** Why it is none; `null` for manifolds. */
  witness?: string | null;
}

/** A set of simplices of a complex. */
export interface SimplicesAnswer {
  /** How many simplices of dimension 0, 1, ... there are. */
  f_vector: number[];
  /** The name of the input. */
  file: string;
  /** Whether the set has all faces of its simplices. */
  is_complex: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The simplices, each by its vertices, by rising dimension. */
  simplices: number[][];
}

/** A map with fewer vertices. */
export interface SimplificationAnswer {
  /** How far the vertices that were left out are at most from the border now. */
  largest_distance: number;
  /** How far a border may be from where it was. */
  tolerance: number;
  /** The number of different vertices now. */
  vertices: number;
  /** How many vertices were put in first, where borders met without one. */
  vertices_added: number;
  /** The number of different vertices of rings and lines before. */
  vertices_before: number;
}

/** A triangulated 3-manifold that was simplified by moves. */
export interface SimplifyAnswer {
  /** Where the triangulation now is in the census that was given. */
  census?: CensusAnswer | null;
  /** The same numbers now. */
  f_vector: number[];
  /** The numbers of vertices, edges, triangles and tetrahedra before. */
  f_vector_before: number[];
  /** The name of the input. */
  file: string;
  /** The integral homology, which is that of the input. */
  homology: HomologyGroup[];
  /** The moves in order, each on the triangulation that those before it have made: `3-2 at edge 4`. */
  moves: string[];
  /** Which 3-manifold it is, where that is proved. */
  name?: string | null;
  /** What the name rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`. */
  name_proof?: string | null;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The isomorphism signature of the triangulation now. */
  signature: string;
}

/** A Boolean combination of solids. */
export interface SolidBooleanAnswer {
  /** The area of the surface, in the square of the unit of the inputs; null beyond the range of numbers. */
  area?: number | null;
  /**
   * The number of cells of the arrangement that are selected; where many operands that cover each other were combined some at a
   * time, of the last arrangement, in which most of what is inside is left out.
   */
  cells: number;
  /** Whether the surface is closed. */
  closed: boolean;
  /** The number of connected components of the surface. */
  components: number;
  /** What congruence put together; with `--method congruence` only. */
  congruence?: CongruentPieces | null;
  /** The dimension of the space: 3. */
  dimension: number;
  /** Vertices minus edges plus polygons of the surface. */
  euler_characteristic: number;
  /** The numbers of vertices, edges and polygons of the surface; a face with holes counts once unless faces are cut into triangles. */
  f_vector: [number, number, number];
  /** The number of faces that were cut into triangles because they have holes or slits. */
  faces_cut: number;
  /** The inputs in their order. */
  files: SpatialInput[];
  /** The genus of the surface; null if it is not one connected manifold. */
  genus?: number | null;
  /** What was put together, where that was asked for or needed. */
  joined?: JoinedFeatures | null;
  /** Whether the surface is a manifold. */
  manifold: BoundaryManifold;
  /** The volume, in the cube of the unit of the inputs; null if the exterior is in the result. */
  measure?: number | null;
  /** Where the result is pinched. */
  pinches: Pinches;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What was rounded. */
  rounding: SpatialRounding;
  /** Which winding numbers are inside: `nonzero`, `positive` or `evenodd`. */
  rule: string;
  /** The number of connected parts of the result; cells are connected through faces. */
  solids: number;
  /** Whether faces are cut into triangles. */
  triangles: boolean;
  /** Whether the exterior is in the result. */
  unbounded: boolean;
  /** The number of bounded connected parts of the complement. */
  voids: number;
  /** The number of faces between selected cells that are kept. */
  walls: number;
}

/** Which 3-manifold a space is, up to homeomorphism that may reverse orientation. */
export interface SpaceAnswer {
  /** The name: `S3`, `RP3`, `L(8,3)`, `S2 x S1`, `SFS [S2: (2,1) (3,1) (5,-4)]`, ... */
  name: string;
  /** What the name rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`. */
  proof: string;
}

/** The arrangement of surfaces and solids in space. */
export interface SpatialArrangementAnswer {
  /** The number of connected components of all faces. */
  components: number;
  /** What congruence put together; with `--method congruence` only. */
  congruence?: CongruentPieces | null;
  /** The number of faces with one cell, or the exterior, on both sides. */
  dangling_faces: number;
  /** The polygons without area, which are left out. */
  degenerate_polygons: DegeneratePolygons;
  /** The dimension of the space: 3. */
  dimension: number;
  /** Vertices minus edges plus faces minus bounded cells. */
  euler_characteristic: number;
  /** The numbers of vertices, edges, faces and bounded cells. */
  f_vector: number[];
  /** The inputs in their order. */
  files: SpatialInput[];
  /** The number of holes of faces: walks around faces beyond the first of each. */
  holes: number;
  /** For each face the inputs that have a polygon there, numbered from 0, rising; if parts of files are inputs. */
  inputs_of_faces?: number[][] | null;
  /** For each bounded cell the inputs that contain it, numbered from 0, rising; inputs that are open contain nothing. */
  inside: number[][];
  /** What was put together, where that was asked for or needed. */
  joined?: JoinedFeatures | null;
  /** The volumes of the bounded cells without their voids, in the cube of the unit of the inputs. */
  measures: number[];
  /** Whether the boundary of every boundary is zero, found by multiplying the matrices. */
  products_zero: boolean;
  /** The names of the inputs in their order, if parts of files are inputs. */
  regions?: string[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What was rounded. */
  rounding: SpatialRounding;
  /** The polygons that were split because they are not planar. */
  split_polygons: SplitPolygons;
  /** The number of voids of cells: shells of cells beyond the first of each. */
  voids: number;
}

/** One surface or solid among the inputs. */
export interface SpatialInput {
  /** Whether every edge lies in an even number of its polygons. */
  closed: boolean;
  /** Whether its polygons agree in direction across every edge. */
  coherent: boolean;
  /** The name of the file. */
  file: string;
  /** How cells inside of it were found; in Booleans only. */
  inside_by?: InsideMethod | null;
  /**
   * The name of the object, group, feature or component of the file that is this input, if parts of files are
   * inputs.
   */
  name?: string | null;
  /** The number of cells that it winds around more than once. */
  overlapping_cells: number;
  /** The number of its polygons. */
  polygons: number;
  /** The number of cells that it winds around less than zero times. */
  reversed_cells: number;
  /** The number of edges along which it is open, or its polygons disagree. */
  rim_edges: number;
}

/** What was rounded in space. */
export interface SpatialRounding {
  /** The number of places where faces meet otherwise. */
  crossings: number;
  /** Whether no coordinate was rounded. */
  exact: boolean;
  /** Some of these places, by their coordinates. */
  places: [number, number, number][];
  /** The number of vertices with a rounded coordinate. */
  rounded_vertices: number;
  /** How many times coordinates were rounded and everything arranged again. */
  rounds: number;
  /** The number of cells, or of solids and voids of a result, that rounding made flat or turned inside out. */
  turned?: number;
  /**
   * Whether faces with rounded coordinates meet in common vertices and edges alone, and no cell, or no solid and void of
   * a result, is flat or inside out; decided exactly.
   */
  valid: boolean;
}

/** Polygons that were split into triangles because they are not planar. */
export interface SplitPolygons {
  /** How many there are. */
  count: number;
  /** The largest distance of a vertex from the plane of its polygon, in the unit of the inputs. */
  largest_deviation: number;
}

/** The number of subgroups of one index. */
export interface SubgroupCount {
  /** The number of their conjugacy classes. */
  classes: number;
  /** The index. */
  index: number;
  /** The number of subgroups. */
  subgroups: number;
}

/** The numbers of subgroups of the fundamental group of each component. */
export interface SubgroupsAnswer {
  /** The components; that of the base vertex comes first. */
  components: SubgroupsComponent[];
  /** The name of the input. */
  file: string;
  /** The highest index of subgroups that are counted. */
  highest_index: number;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The numbers of one component. */
export interface SubgroupsComponent {
  /** The abelianization, which agrees with the first homology. */
  abelianization: GroupAnswer;
  /** The vertex where loops start and end, by its number in the file. */
  base: number;
  /** The numbers of homomorphisms to some finite groups; `null` where they take too long to count. */
  homomorphisms?: Record<string, HomomorphismAnswer | null>;
  /** The group in words; `null` if it is not recognized, which says nothing. */
  name?: string | null;
  /** The numbers of subgroups of index 1, 2, ...; `null` if they take too long to count. */
  subgroups?: SubgroupCount[] | null;
}

/** A connected component of a model of polygons. */
export interface SurfaceAnswer {
  /** The number of its boundary loops. */
  boundary_loops: number;
  /** Its vertices minus its edges plus its faces. */
  euler_characteristic: number;
  /** The numbers of its vertices, edges and faces. */
  f_vector: number[];
  /** Its genus, or the number of cross-caps; `null` if it is no surface. */
  genus?: number | null;
  /** The surface in words; `null` if it is none. */
  name?: string | null;
  /** Whether it is orientable; `null` if it is no surface. */
  orientable?: boolean | null;
}

/** What was merged, left out and filled to make a surface. */
export interface SurfaceRepairAnswer {
  /** How many holes were filled. */
  holes_filled: number;
  /** How many lines that were no sides of faces were left out. */
  lines_left_out: number;
  /** How many polygons that collapsed or met themselves were left out. */
  polygons_collapsed: number;
  /** How many polygons that repeated an earlier one were left out. */
  polygons_repeated: number;
  /** How many triangles fill the holes. */
  triangles_added: number;
  /** How many vertices that were in no face were left out. */
  vertices_left_out: number;
  /** How many vertices were merged with another one. */
  vertices_merged: number;
}

/** The edges of a small complex by what they are in a tree-cotree decomposition, each by its vertices. */
export interface TreesAnswer {
  /** The edges that spanning trees of faces cross: what they are as loops follows from the faces. */
  cotree: [number, number][];
  /** The edges in neither: each makes a loop with the tree. Where a presentation was simplified, fewer loops are shown. */
  generators: [number, number][];
  /** The edges of the spanning trees of vertices. */
  tree: [number, number][];
}

/** Why a group has no name. */
export type Unrecognized = "gave_up" | "no_rule";

/** A curve that vanished. */
export interface VanishedAnswer {
  /** Its number at the beginning. */
  curve: number;
  /** When it vanished. */
  time: number;
}

/** A closed edge that vanished. */
export interface VanishedEdgeAnswer {
  /** Its number at the beginning; null for one that a repair has made. */
  edge?: number | null;
  /** When it vanished: the end of the step. */
  time: number;
}

/** A page that shows a model. */
export interface ViewAnswer {
  /** The size of the page, in bytes. */
  bytes: number;
  /** The name of the input. */
  file: string;
  /** The layers that can be shown. */
  layers: LayerAnswer[];
  /** The file of the page; `null` if it was not written. */
  page?: string | null;
  /** The names of the panes beside the model. */
  panes: string[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The number of triangles that are drawn. */
  triangles: number;
}

/** The path of a class. */
export interface VineAnswer {
  /** The degree of the class. */
  degree: number;
  /** Parameters with births and deaths, on lines in between; the death of a class that stays is `null`. */
  points: [number, number, number | null][];
}

/** The paths of the points of a diagram while the function moves. */
export interface VineyardAnswer {
  /** The characteristic of the field of coefficients. */
  field: number;
  /** The name of the input. */
  file: string;
  /** The functions on the vertices, or the files of their values: the parameters 0, 1, 2, ... */
  functions: string[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The paths, by rising degree. */
  vines: VineAnswer[];
}

/** What is known of a closed walk on a surface. */
export interface WalkAnswer {
  /** Whether it is a boundary over the integers. */
  bounds: boolean;
  /** The component that it lies on; `null` at an isolated vertex. */
  component?: number | null;
  /** Whether it can be contracted to a point. */
  contractible: boolean;
  /** Its class in the first homology, by exponent sums of the generators. */
  homology: number[];
  /** The number of its edges. */
  steps: number;
  /** Its word in the generators. */
  word: number[];
}

/** Two walks compared. */
export interface WalkPair {
  /** Whether they are homotopic when the base may move. */
  freely_homotopic: boolean;
  /** Whether they are homologous. */
  homologous: boolean;
  /** Whether they are homotopic with the base fixed; `null` if they start at different vertices. */
  homotopic?: boolean | null;
  /** The numbers of the two walks, counted from 0. */
  walks: [number, number];
}

/**
 * An integer: a JSON number, or beyond 64 bits a string of decimal digits, since JSON readers round such numbers.
 *
 * # Examples
 * ```
 * use coface_algebra::Integer;
 * use coface_answers::answer::WholeNumber;
 * assert_eq!(WholeNumber::from(&Integer::from(-3)), WholeNumber::Number(-3));
 * ```
 */
export type WholeNumber = number | string;

/** Cells that show why a model is no manifold. */
export interface WitnessAnswer {
  /** The cells, each by its vertices. */
  cells: number[][];
  /** What sort of witness this is. */
  kind: string;
  /** One sentence for people. */
  message: string;
}

/** The answer of `yin advect`. */
export interface YinAdvectAnswer {
  /** The number of knots that were added. */
  added: number;
  /** The area, in the square of the unit of the file; null if it is infinite, or beyond the range of numbers, as a remark says then. */
  area?: number | null;
  /** The area at the beginning; null if it is infinite. */
  area_before?: number | null;
  /** The curves of each component, the positive one first, if it has one. */
  atoms: number[][];
  /** The numbers of components and of holes of its closure. */
  betti_closed: [number, number];
  /** The numbers of components and of holes of the set. */
  betti_open: [number, number];
  /** Whether it is bounded. */
  bounded: boolean;
  /** The lower left and the upper right corner of the box around all curves; null without curves. */
  bounding_box?: [[number, number], [number, number]] | null;
  /** The distance at which boundaries are in contact; null if contacts were not looked for. */
  contact_distance?: number | null;
  /** The numbers of positive and of negative curves, and one more for an unbounded component, as the papers on Yin sets count. */
  curve_counts: [number, number];
  /** The curves of the boundary. */
  curves: YinCurve[];
  /** Whether it is the empty set. */
  empty: boolean;
  /** How exactly the times of events are found; null if they were not looked for. */
  event_tolerance?: number | null;
  /** The changes of the topology, by time; null if they were not looked for. */
  events?: YinEventAnswer[] | null;
  /** The name of the file. */
  file: string;
  /** The files of the way, in the order of time. */
  frames: string[];
  /** The number of kinks. */
  kinks: number;
  /** The order of its splines: 2 for polylines, 4 for cubics, 6, 8. */
  order: number;
  /** The length of all curves, in the unit of the file; null beyond the range of numbers, as a remark says then. */
  perimeter?: number | null;
  /** Whether it is the whole plane. */
  plane: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The number of knots that were removed. */
  removed: number;
  /** The steps in which the boundary was cut and pasted. */
  repairs: YinRepairAnswer[];
  /** The order of the Runge-Kutta scheme. */
  scheme: number;
  /** The number of time steps. */
  steps: number;
  /** The time at the end. */
  time: number;
  /** The curves that became too short to be kept. */
  vanished: VanishedAnswer[];
}

/** A place on a curve, and what is known there. */
export interface YinBendPlace {
  /** The parameter in [0, 1] on that piece. */
  parameter: number;
  /** The piece of the curve. */
  piece: number;
  /** The point. */
  point: [number, number];
  /** A curvature, or an angle in degrees. */
  value: number;
}

/** A point of a boundary. */
export interface YinBoundarySample {
  /** The signed curvature, positive where the curve turns left; null where the curve stands still. */
  curvature?: number | null;
  /** The curve. */
  curve: number;
  /** The length of the curve from its beginning, in the unit of the file. */
  length: number;
  /** The parameter in [0, 1) on that piece. */
  parameter: number;
  /** The piece of the curve. */
  piece: number;
  /** The point. */
  point: [number, number];
  /** The direction of the curve, of length one, with the set on its left; null where the curve stands still. */
  tangent?: [number, number] | null;
}

/** The answer of `yin complement`, `meet`, `join`, `difference`, `xor` and `combine`. */
export interface YinCombinationAnswer {
  /** The area, in the square of the unit of the file; null if it is infinite, or beyond the range of numbers, as a remark says then. */
  area?: number | null;
  /** How far the area is off at most. */
  area_error: number;
  /** The curves of each component, the positive one first, if it has one. */
  atoms: number[][];
  /** The numbers of components and of holes of its closure. */
  betti_closed: [number, number];
  /** The numbers of components and of holes of the set. */
  betti_open: [number, number];
  /** Whether it is bounded. */
  bounded: boolean;
  /** The lower left and the upper right corner of the box around all curves; null without curves. */
  bounding_box?: [[number, number], [number, number]] | null;
  /** The numbers of positive and of negative curves, and one more for an unbounded component, as the papers on Yin sets count. */
  curve_counts: [number, number];
  /** The curves of the boundary. */
  curves: YinCurve[];
  /** Whether it is the empty set. */
  empty: boolean;
  /** The names of the inputs. */
  files: string[];
  /** The number of kinks. */
  kinks: number;
  /** The order of its splines: 2 for polylines, 4 for cubics, 6, 8. */
  order: number;
  /** The length of all curves, in the unit of the file; null beyond the range of numbers, as a remark says then. */
  perimeter?: number | null;
  /** Whether it is the whole plane. */
  plane: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What was nearer together than this may have been taken for one, in the unit of the files; 0 for sets of order 2. */
  resolution: number;
  /** The decisions that were taken without proof. */
  uncertified: YinDecision[];
}

/** The answer of `yin compare`. */
export interface YinComparisonAnswer {
  /**
   * The greatest distance of the second boundary from the first along the normals of the first, up to twice the Hausdorff distance; null if
   * no normal meets it so near.
   */
  along_normals?: number | null;
  /** An estimate from above of how far that is off. */
  along_normals_error: number;
  /** The area of the first set less that of the second; null if it is infinite. */
  area_signed?: number | null;
  /** How far that is off at most by rounding. */
  area_signed_error: number;
  /** The area of the symmetric difference; null if it is infinite. */
  area_xor?: number | null;
  /** An estimate from above of how far that is off. */
  area_xor_error: number;
  /** The number of components of each set. */
  components: [number, number];
  /** The greatest difference of the curvatures of both boundaries where normals meet, in the inverse of the unit; null if none does. */
  curvature?: number | null;
  /** An estimate from above of how far that is off. */
  curvature_error: number;
  /** The names of the inputs. */
  files: string[];
  /** The Hausdorff distance of the boundaries; null if one set alone has a boundary. */
  hausdorff?: number | null;
  /** An estimate from above of how far that is off. */
  hausdorff_error: number;
  /** The number of holes of each set. */
  holes: [number, number];
  /** The part of the places of the first boundary whose normals do not meet the second one so near. */
  normals_left_out: number;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The answer of `yin curvature`. */
export interface YinCurvatureAnswer {
  /** How each curve bends. */
  curves: YinCurveBend[];
  /** The name of the file. */
  file: string;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** A curve of a boundary. */
export interface YinCurve {
  /** The area that it encloses, with its sign; null beyond the range of numbers. */
  area?: number | null;
  /** The number of curves around it. */
  depth: number;
  /** The knots that are kinks, numbered from 0. */
  kinks: number[];
  /** The number of its knots. */
  knots: number;
  /** Its length, in the unit of the file; null beyond the range of numbers. */
  length?: number | null;
  /** Its name; null if it has none. */
  name?: string | null;
  /** The curve directly around it; null if there is none. */
  parent?: number | null;
  /** 1 if it runs counterclockwise, -1 if it runs clockwise. */
  sign: number;
  /** The names of these kinks. */
  vertices: number[];
}

/** How a curve bends. */
export interface YinCurveBend {
  /** The curve. */
  curve: number;
  /** Where its curvature is greatest. */
  greatest: YinBendPlace;
  /** Where its curvature is least: positive where it turns left, one over the unit of the file. */
  least: YinBendPlace;
  /** The same among knots that are no kinks; null if all knots are kinks. */
  roughest?: YinBendPlace | null;
  /** The knot at which its direction turns most at once, and by how many degrees, positive to the left. */
  sharpest: YinBendPlace;
}

/** The answer of `yin cut-cells`. */
export interface YinCutCellsAnswer {
  /** The area of the set in the grid. */
  area: number;
  /** The area of the set; null if it is infinite. */
  area_of_set?: number | null;
  /** The cells that have some of the set or of its boundary, row by row; in files only. */
  cells?: CutCellAnswer[] | null;
  /** The number of cells that are partly in the set. */
  cut: number;
  /** The number of cells outside of the set. */
  empty: number;
  /** The name of the file. */
  file: string;
  /** The number of cells inside of the set. */
  full: number;
  /** The grid. */
  grid: GridAnswer;
  /** The length of the boundary in the grid. */
  length: number;
  /** The length of the boundary; null beyond the range of numbers. */
  perimeter_of_set?: number | null;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** A decision of a combination that was taken without proof. */
export interface YinDecision {
  /** What was assumed to be equal, in words. */
  assumed: string;
  /** The two pieces of operands that are so close. */
  pieces: [number, number, number, number, number][];
  /** Where. */
  point: [number, number];
}

/** An edge of an interface. */
export interface YinEdgeAnswer {
  /** The Bernstein control points of its pieces, neighbors sharing the one between them; in files only. */
  controls?: [number, number][] | null;
  /** The vertices at its start and at its end. */
  ends: [number, number];
  /** The parameters of its knots; in files only. */
  knots?: number[] | null;
  /** The phase on its left; null for what is in no phase. */
  left?: number | null;
  /** Its length; null beyond the range of numbers. */
  length?: number | null;
  /** The number of its polynomial pieces. */
  pieces: number;
  /** The phase on its right; null for what is in no phase. */
  right?: number | null;
}

/** A change of the topology of a set that moves, or a contact of its boundary with itself. */
export interface YinEventAnswer {
  /** What there is just after. */
  after: YinEventCounts;
  /** What there was just before. */
  before: YinEventCounts;
  /** What changed. */
  kind: YinEventKind;
  /** Where: the middle of the gap or the neck, the point at which curves cross, or the mean of the knots of a curve that vanishes. */
  place: [number, number];
  /** When it came, as exactly as "event_tolerance" says: the first time at which it is seen. */
  time: number;
  /** What changed, in words. */
  words: string;
}

/** The numbers of components and holes: of positive and negative curves, and one component more for an unbounded set. */
export interface YinEventCounts {
  /** The number of components. */
  components: number;
  /** The number of holes. */
  holes: number;
}

/** A kind of change. */
export type YinEventKind = "components-merge" | "component-splits" | "hole-forms" | "hole-opens" | "holes-merge" | "hole-splits" | "component-vanishes" | "hole-vanishes" | "contact";

/** What is wrong with a boundary. */
export interface YinFaultAnswer {
  /** The curves that it is about, by their numbers in the file; none where it is about all. */
  curves: number[];
  /** What it is. */
  kind: YinFaultKind;
  /** The fault in words. */
  message: string;
  /** Where; null where that is not one point. */
  point?: [number, number] | null;
}

/** A kind of fault of a boundary. */
export type YinFaultKind = "open" | "too_few_pieces" | "zero_length" | "self_meeting" | "crossing" | "overlap" | "orientation" | "mixed_roots" | "other";

/** The answer of `yin info`. */
export interface YinInfoAnswer {
  /** The area, in the square of the unit of the file; null if it is infinite, or beyond the range of numbers, as a remark says then. */
  area?: number | null;
  /** The curves of each component, the positive one first, if it has one. */
  atoms: number[][];
  /** The numbers of components and of holes of its closure. */
  betti_closed: [number, number];
  /** The numbers of components and of holes of the set. */
  betti_open: [number, number];
  /** Whether it is bounded. */
  bounded: boolean;
  /** The lower left and the upper right corner of the box around all curves; null without curves. */
  bounding_box?: [[number, number], [number, number]] | null;
  /** The numbers of positive and of negative curves, and one more for an unbounded component, as the papers on Yin sets count. */
  curve_counts: [number, number];
  /** The curves of the boundary. */
  curves: YinCurve[];
  /** Whether it is the empty set. */
  empty: boolean;
  /** The name of the file. */
  file: string;
  /** The number of kinks. */
  kinks: number;
  /** The order of its splines: 2 for polylines, 4 for cubics, 6, 8. */
  order: number;
  /** The length of all curves, in the unit of the file; null beyond the range of numbers, as a remark says then. */
  perimeter?: number | null;
  /** Whether it is the whole plane. */
  plane: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The answer of `yin advect` for an interface. */
export interface YinInterfaceAdvectAnswer {
  /** The number of knots that were added. */
  added: number;
  /** The areas of the phases at the beginning; null where one is infinite. */
  areas_before: (number | null)[];
  /** The distance at which edges are in contact; null if contacts were not looked for. */
  contact_distance?: number | null;
  /** The edges: arcs between two phases, or between a phase and what is in none. */
  edges: YinEdgeAnswer[];
  /** How exactly times of events are found; null unless they were asked for. */
  event_tolerance?: number | null;
  /** The changes of the topology, by time; null unless they were asked for. */
  events?: YinInterfaceEventAnswer[] | null;
  /** The names of the files. */
  files: string[];
  /** The files of the way, in the order of time. */
  frames: string[];
  /** The vertices at which three or more edges end. */
  junctions: YinJunctionAnswer[];
  /** The length of all edges, each once, in the unit of the coordinates; null beyond the range of numbers. */
  length?: number | null;
  /** The order of the edges. */
  order: number;
  /** The phases, in the order of the sets. */
  phases: YinPhaseAnswer[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The number of knots that were removed. */
  removed: number;
  /** The steps in which edges were cut and pasted. */
  repairs: YinRepairAnswer[];
  /** The order of the Runge-Kutta scheme. */
  scheme: number;
  /**
   * The pairs of edges that go on smoothly into each other at a vertex, each with its direction: 1 as it runs, -1 against that; in files
   * only.
   */
  smooth_pairs?: [[number, number], [number, number]][] | null;
  /** The number of time steps. */
  steps: number;
  /** The time at the end. */
  time: number;
  /** The closed edges that became too short to be kept. */
  vanished: VanishedEdgeAnswer[];
  /** The points at which edges end: junctions, kinks, and one point of each closed edge. */
  vertices: [number, number][];
}

/** The answer of `yin interface`. */
export interface YinInterfaceAnswer {
  /** The edges: arcs between two phases, or between a phase and what is in none. */
  edges: YinEdgeAnswer[];
  /** The names of the files. */
  files: string[];
  /** The vertices at which three or more edges end. */
  junctions: YinJunctionAnswer[];
  /** The length of all edges, each once, in the unit of the coordinates; null beyond the range of numbers. */
  length?: number | null;
  /** The order of the edges. */
  order: number;
  /** The phases, in the order of the sets. */
  phases: YinPhaseAnswer[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /**
   * The pairs of edges that go on smoothly into each other at a vertex, each with its direction: 1 as it runs, -1 against that; in files
   * only.
   */
  smooth_pairs?: [[number, number], [number, number]][] | null;
  /** The points at which edges end: junctions, kinks, and one point of each closed edge. */
  vertices: [number, number][];
}

/** The answer of `yin compare` for two interfaces. */
export interface YinInterfaceComparisonAnswer {
  /**
   * The sum of the areas of the symmetric differences of all phases; null if one is infinite. What went from one phase to another counts
   * twice.
   */
  area_xor?: number | null;
  /** An estimate from above of how far that is off. */
  area_xor_error: number;
  /** The names of the files. */
  files: string[];
  /** The number of junctions of each interface. */
  junctions: [number, number];
  /** The phases of the first interface, each compared with its namesake in the second, or with the one of its number if names differ. */
  phases: PhaseComparison[];
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The answer of `yin curvature` for an interface. */
export interface YinInterfaceCurvatureAnswer {
  /** How each edge bends. */
  edges: EdgeBendAnswer[];
  /** The name of the file. */
  file: string;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The answer of `yin cut-cells` for an interface. */
export interface YinInterfaceCutCellsAnswer {
  /** The area of all phases in the grid. */
  area: number;
  /** What phases have of cells, row by row and then by phases; in files only. */
  cells?: PhaseCell[] | null;
  /** The name of the file. */
  file: string;
  /** The grid. */
  grid: GridAnswer;
  /** The length of the edges in the grid, each once. */
  length: number;
  /** The phases, in their order. */
  phases: PhaseCells[];
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** A change of the topology of an interface that moves. */
export interface YinInterfaceEventAnswer {
  /** What there is of the phase just after; null for junctions and phases that meet, and for contacts. */
  after?: YinEventCounts | null;
  /** What there was of the phase just before; null for junctions and phases that meet, and for contacts. */
  before?: YinEventCounts | null;
  /** What changed. */
  kind: YinInterfaceEventKind;
  /**
   * The phase that changed; of junctions that meet all phases around them, of phases that come together these, and of a contact those beyond the
   * edges and between them.
   */
  phases: number[];
  /**
   * Where: the mean of the knots of an edge that vanishes, the middle of the ends of an edge whose junctions meet, or the place at which
   * edges came to meet.
   */
  place: [number, number];
  /** When it came, as exactly as "event_tolerance" says: the first time at which it is seen. */
  time: number;
  /** What changed, in words. */
  words: string;
}

/** A kind of change of an interface. */
export type YinInterfaceEventKind = "phase-vanishes" | "component-vanishes" | "hole-vanishes" | "junctions-meet" | "phase-merges" | "phase-splits" | "hole-forms" | "hole-opens" | "phases-meet" | "contact";

/** The answer of `yin kinks` for an interface. */
export interface YinInterfaceKinksAnswer {
  /** The edges: arcs between two phases, or between a phase and what is in none. */
  edges: YinEdgeAnswer[];
  /** The names of the files. */
  files: string[];
  /** The vertices at which three or more edges end. */
  junctions: YinJunctionAnswer[];
  /** The kinks: vertices at which two edges end and do not go on smoothly into each other. */
  kink_points: InterfaceKink[];
  /** The length of all edges, each once, in the unit of the coordinates; null beyond the range of numbers. */
  length?: number | null;
  /** The order of the edges. */
  order: number;
  /** The phases, in the order of the sets. */
  phases: YinPhaseAnswer[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /**
   * The pairs of edges that go on smoothly into each other at a vertex, each with its direction: 1 as it runs, -1 against that; in files
   * only.
   */
  smooth_pairs?: [[number, number], [number, number]][] | null;
  /** The points at which edges end: junctions, kinks, and one point of each closed edge. */
  vertices: [number, number][];
}

/** The answer of `yin locate` for an interface. */
export interface YinInterfaceLocateAnswer {
  /** The number of points on edges. */
  boundary: number;
  /** The name of the file. */
  file: string;
  /** The number of points in no phase. */
  outside: number;
  /** For each phase the number of points inside. */
  phases: PhasePoints[];
  /** The points, in the order in which they were given. */
  points: InterfacePoint[];
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The answer of `yin normalize` for an interface. */
export interface YinInterfaceNormalizeAnswer {
  /** The edges: arcs between two phases, or between a phase and what is in none. */
  edges: YinEdgeAnswer[];
  /** The names of the files. */
  files: string[];
  /** The number of vertices at which two edges became one. */
  joined: number;
  /** The vertices at which three or more edges end. */
  junctions: YinJunctionAnswer[];
  /** The length of all edges, each once, in the unit of the coordinates; null beyond the range of numbers. */
  length?: number | null;
  /** The order of the edges. */
  order: number;
  /** The phases, in the order of the sets. */
  phases: YinPhaseAnswer[];
  /** What was assumed or left out. */
  remarks: Remark[];
  /** What was wrong, in words, if edges were cut and pasted; null if nothing was. */
  repaired?: string | null;
  /**
   * The pairs of edges that go on smoothly into each other at a vertex, each with its direction: 1 as it runs, -1 against that; in files
   * only.
   */
  smooth_pairs?: [[number, number], [number, number]][] | null;
  /** The number of knots within straight parts of edges that were left out; 0 above order 2. */
  straightened: number;
  /** The points at which edges end: junctions, kinks, and one point of each closed edge. */
  vertices: [number, number][];
}

/** The answer of `yin sample` for an interface. */
export interface YinInterfaceSampleAnswer {
  /** The name of the file. */
  file: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The points, edge by edge; edges that are not closed give the point at their end too. */
  samples: EdgeSample[];
}

/** A junction of an interface. */
export interface YinJunctionAnswer {
  /** The number of edges that end there. */
  degree: number;
  /** The edges that leave it, counterclockwise. */
  edges: number[];
  /** The type, by degree and smooth pairs. */
  kind: JunctionKind;
  /** For each of these edges the phase on its left; null for what is in no phase. */
  phases: (number | null)[];
  /** Where it is. */
  point: [number, number];
  /** How many pairs of edges go on smoothly into each other. */
  smooth_pairs: number;
  /** Its vertex. */
  vertex: number;
}

/** A kink with its place. */
export interface YinKinkPoint {
  /** The curve that it is on. */
  curve: number;
  /** The knot of that curve. */
  knot: number;
  /** Its position. */
  point: [number, number];
  /** Its name. */
  vertex: number;
}

/** The answer of `yin kinks`. */
export interface YinKinksAnswer {
  /** The area, in the square of the unit of the file; null if it is infinite, or beyond the range of numbers, as a remark says then. */
  area?: number | null;
  /** The curves of each component, the positive one first, if it has one. */
  atoms: number[][];
  /** The numbers of components and of holes of its closure. */
  betti_closed: [number, number];
  /** The numbers of components and of holes of the set. */
  betti_open: [number, number];
  /** Whether it is bounded. */
  bounded: boolean;
  /** The lower left and the upper right corner of the box around all curves; null without curves. */
  bounding_box?: [[number, number], [number, number]] | null;
  /** The kinks as a complex: one simplex for each, with its name. */
  complex: [number][];
  /** The numbers of positive and of negative curves, and one more for an unbounded component, as the papers on Yin sets count. */
  curve_counts: [number, number];
  /** The curves of the boundary. */
  curves: YinCurve[];
  /** Whether it is the empty set. */
  empty: boolean;
  /** The name of the file. */
  file: string;
  /** The kinks with their places. */
  kink_points: YinKinkPoint[];
  /** The number of kinks. */
  kinks: number;
  /** The order of its splines: 2 for polylines, 4 for cubics, 6, 8. */
  order: number;
  /** The length of all curves, in the unit of the file; null beyond the range of numbers, as a remark says then. */
  perimeter?: number | null;
  /** Whether it is the whole plane. */
  plane: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The answer of `yin locate`. */
export interface YinLocateAnswer {
  /** The number of points on the boundary. */
  boundary: number;
  /** The name of the file. */
  file: string;
  /** The number of points inside. */
  inside: number;
  /** The number of points outside. */
  outside: number;
  /** The points, in the order in which they were given. */
  points: YinLocatedPoint[];
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** A point, and the point of a boundary that is nearest to it. */
export interface YinLocatedPoint {
  /** The curve that the nearest point is on; null for a set without boundary. */
  curve?: number | null;
  /** Where it lies. */
  location: YinLocation;
  /** The point of the boundary that is nearest to it; null for a set without boundary. */
  nearest?: [number, number] | null;
  /** The parameter of the nearest point in [0, 1] on that piece; null for a set without boundary. */
  parameter?: number | null;
  /** The piece of that curve; null for a set without boundary. */
  piece?: number | null;
  /** The point. */
  point: [number, number];
  /** The distance from the boundary in the unit of the file, positive inside, negative outside; null for a set without boundary. */
  signed_distance?: number | null;
}

/** Where a point lies of a set. */
export type YinLocation = "inside" | "boundary" | "outside";

/** What phases have in common. */
export interface YinNeighborAnswer {
  /** The number of common edges. */
  edges: number;
  /** Their length; null beyond the range of numbers. */
  length?: number | null;
  /** The number of the other phase; null for what is in no phase. */
  phase?: number | null;
}

/** The answer of `yin normalize`. */
export interface YinNormalizeAnswer {
  /** The area, in the square of the unit of the file; null if it is infinite, or beyond the range of numbers, as a remark says then. */
  area?: number | null;
  /** The curves of each component, the positive one first, if it has one. */
  atoms: number[][];
  /** The numbers of components and of holes of its closure. */
  betti_closed: [number, number];
  /** The numbers of components and of holes of the set. */
  betti_open: [number, number];
  /** Whether it is bounded. */
  bounded: boolean;
  /** The lower left and the upper right corner of the box around all curves; null without curves. */
  bounding_box?: [[number, number], [number, number]] | null;
  /** The numbers of positive and of negative curves, and one more for an unbounded component, as the papers on Yin sets count. */
  curve_counts: [number, number];
  /** The curves of the boundary. */
  curves: YinCurve[];
  /** Whether it is the empty set. */
  empty: boolean;
  /** The name of the file. */
  file: string;
  /** The number of kinks. */
  kinks: number;
  /** The order of its splines: 2 for polylines, 4 for cubics, 6, 8. */
  order: number;
  /** The length of all curves, in the unit of the file; null beyond the range of numbers, as a remark says then. */
  perimeter?: number | null;
  /** Whether it is the whole plane. */
  plane: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** How often curves were laid over each other again because rounding had made them cross. */
  rounds: number;
  /** The number of knots that lay on straight parts and were left out. */
  straightened: number;
}

/** A phase of an interface. */
export interface YinPhaseAnswer {
  /** The area, in the square of the unit of the coordinates; null if it is infinite. */
  area?: number | null;
  /** The number of components. */
  components: number;
  /** The number of holes. */
  holes: number;
  /** The name: of the feature, or of the file. */
  name: string;
  /** What lies on the other side of the boundary; what is in no phase comes first. */
  neighbors: YinNeighborAnswer[];
  /** The length of the boundary; null beyond the range of numbers. */
  perimeter?: number | null;
}

/** A step in which a boundary that met itself was cut and pasted. */
export interface YinRepairAnswer {
  /** What was wrong, in words. */
  fault: string;
  /** The step, counted from the beginning. */
  step: number;
  /** The time. */
  time: number;
}

/** A knot that is no kink, where a curve turns. */
export interface YinRoughKnot {
  /** The curve. */
  curve: number;
  /** By how many degrees, positive to the left. */
  degrees: number;
  /** The knot. */
  knot: number;
  /** The point. */
  point: [number, number];
}

/** The answer of `yin sample`. */
export interface YinSampleAnswer {
  /** The name of the file. */
  file: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The points, curve by curve. */
  samples: YinBoundarySample[];
}

/** The answer of `yin compare --series`. */
export interface YinSeriesAnswer {
  /** The name of the set that the others are compared with. */
  reference: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /** The sets, in their order. */
  rows: YinSeriesRow[];
}

/** How far a set of a series is from the one that it is compared with. */
export interface YinSeriesRow {
  /** The greatest distance of the reference along the normals of the set; null if no normal meets it within twice the Hausdorff distance. */
  along_normals?: number | null;
  /** An estimate from above of how far that is off. */
  along_normals_error: number;
  /** The power of the spacing by which that area has fallen since the row before; null in the first row and at the same spacing. */
  area_rate?: number | null;
  /** The area of the set less that of the reference; null if it is infinite. */
  area_signed?: number | null;
  /** How far that is off at most by rounding. */
  area_signed_error: number;
  /** The area of the symmetric difference; null if it is infinite. */
  area_xor?: number | null;
  /** An estimate from above of how far that is off. */
  area_xor_error: number;
  /** The number of components. */
  components: number;
  /** The greatest difference of curvatures where normals meet; null if none does. */
  curvature?: number | null;
  /** An estimate from above of how far that is off. */
  curvature_error: number;
  /** The power of the spacing by which that difference has fallen since the row before; null in the first row and at the same spacing. */
  curvature_rate?: number | null;
  /** The name of the file. */
  file: string;
  /** The Hausdorff distance of the boundaries; null if one set alone has a boundary. */
  hausdorff?: number | null;
  /** An estimate from above of how far that distance is off. */
  hausdorff_error: number;
  /** The power of the spacing by which that distance has fallen since the row before; null in the first row and at the same spacing. */
  hausdorff_rate?: number | null;
  /** The number of holes. */
  holes: number;
  /** The number of polynomial pieces of the boundary. */
  knots: number;
  /** The mean distance of knots along the boundary; null without a boundary. */
  spacing?: number | null;
}

/** A set of the plane. */
export interface YinSetAnswer {
  /** The area, in the square of the unit of the file; null if it is infinite, or beyond the range of numbers, as a remark says then. */
  area?: number | null;
  /** The curves of each component, the positive one first, if it has one. */
  atoms: number[][];
  /** The numbers of components and of holes of its closure. */
  betti_closed: [number, number];
  /** The numbers of components and of holes of the set. */
  betti_open: [number, number];
  /** Whether it is bounded. */
  bounded: boolean;
  /** The lower left and the upper right corner of the box around all curves; null without curves. */
  bounding_box?: [[number, number], [number, number]] | null;
  /** The numbers of positive and of negative curves, and one more for an unbounded component, as the papers on Yin sets count. */
  curve_counts: [number, number];
  /** The curves of the boundary. */
  curves: YinCurve[];
  /** Whether it is the empty set. */
  empty: boolean;
  /** The number of kinks. */
  kinks: number;
  /** The order of its splines: 2 for polylines, 4 for cubics, 6, 8. */
  order: number;
  /** The length of all curves, in the unit of the file; null beyond the range of numbers, as a remark says then. */
  perimeter?: number | null;
  /** Whether it is the whole plane. */
  plane: boolean;
  /** What was assumed or left out. */
  remarks: Remark[];
}

/** The answer of `yin validate`. */
export interface YinValidationAnswer {
  /** The number of curves of the file. */
  curves: number;
  /** What is wrong: with each curve by itself, or, if nothing is, with all of them together. */
  faults: YinFaultAnswer[];
  /** The name of the file. */
  file: string;
  /** What was assumed or left out. */
  remarks: Remark[];
  /**
   * The knot that is no kink at which a curve turns most, with an angle in degrees: of order 4 and more near zero where curves are
   * smooth. Null for order 2, without such a knot, and where something is wrong.
   */
  roughest?: YinRoughKnot | null;
  /** Whether the curves of the file bound a set. */
  valid: boolean;
}
