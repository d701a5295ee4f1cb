/**
 * What the program puts into the page: one JSON document. Arrays of numbers are base64 of little-endian bytes.
 */

import type { Ragged } from "../complex/complex";
import type { InfoAnswer, YinSetAnswer } from "./answers";

/** What is known of the model: the report on it, or the facts about a set of the plane. */
export type Report = Partial<InfoAnswer & YinSetAnswer>;

/** Lists by where they start, or all of one width. */
export interface RaggedText {
  starts?: string;
  width?: number;
  items: string;
}

/** Something that is drawn and can be switched on and off. */
export interface LayerText {
  name: string;
  /** Layers of one group stand together in the panel: "model", "homology", "boundary", "witness", "cut", ... */
  group: string;
  /** What is said about it beside its name. */
  detail?: string;
  /** A place in the palette; the next free one when absent. */
  color?: number;
  /** Whether it is shown at first. */
  on?: boolean;
  /** Whether lines have arrowheads. */
  arrows?: boolean;
  /** Its own positions (three numbers a point); those of the model when absent. */
  positions?: string;
  /** Polylines, as lists of points. */
  lines?: RaggedText;
  /** Points that get a mark. */
  points?: string;
  /** Triangles, three points each. */
  triangles?: string;
  /** A text at a point. */
  labels?: { point: number; text: string }[];
}

/** A flat picture beside the model: a fundamental domain, a cover, a persistence diagram, a Hasse forest. */
export interface PaneText {
  name: string;
  /** Two numbers a point. */
  positions: string;
  layers: LayerText[];
  /** The names of the axes, for diagrams. */
  axes?: [string, string];
}

export interface SceneText {
  coface_scene: 1;
  title: string;
  /** What `coface info --json` or `coface yin info --json` says. */
  report: Report | null;
  /** The number of coordinates that matter, 2 or 3. */
  dimension: 2 | 3;
  /** What was taken from all positions before they were rounded to 32 bits. */
  origin: [number, number, number];
  positions: string;
  /** The number of each vertex in the model; absent where vertices are numbered as here. */
  vertexNumbers?: string;
  polygons: RaggedText;
  /** Walks around polygons beyond the first, with the polygon of each. */
  rims: RaggedText;
  polygonsOfRims: string;
  simplices: RaggedText;
  /** The polygons around each 3-cell. */
  cells: RaggedText;
  /** For each polygon of each 3-cell whether it has it with a minus; empty where that is not known. */
  signs: string;
  /** What is known of each 3-cell, or of each polygon where there are none. */
  notes: string[];
  /** What is shaded: three vertices each, the polygon of each, and where there are 3-cells the cell of each; null for the polygons. */
  triangles: { items: string; polygons: string; cells: string } | null;
  /** What is not drawn, drawn instead of the model, or invented for it. */
  remarks?: { message: string }[];
  layers: LayerText[];
  panes: PaneText[];
}

export interface Layer {
  name: string;
  group: string;
  detail: string;
  color: number | null;
  on: boolean;
  arrows: boolean;
  /** Whether its points are its own, and no vertices of the model. */
  own: boolean;
  positions: Float32Array;
  lines: Ragged;
  points: Uint32Array;
  triangles: Uint32Array;
  labels: { point: number; text: string }[];
}

export interface Pane {
  name: string;
  axes: [string, string] | null;
  layers: Layer[];
}

export interface Scene {
  title: string;
  report: Report | null;
  dimension: 2 | 3;
  origin: [number, number, number];
  positions: Float32Array;
  /** The number of each vertex in the model; empty where vertices are numbered as here. */
  vertexNumbers: Uint32Array;
  polygons: Ragged;
  rims: Ragged;
  polygonsOfRims: Uint32Array;
  simplices: Ragged;
  cells: Ragged;
  signs: Uint32Array;
  notes: string[];
  triangles: Uint32Array;
  /** null where each polygon is one triangle. */
  polygonOfTriangle: Uint32Array | null;
  cellOfTriangle: Uint32Array;
  remarks: string[];
  layers: Layer[];
  panes: Pane[];
}

const NO_LISTS: Ragged = { starts: new Uint32Array(1), items: new Uint32Array(0) };

function bytes(text: string): ArrayBuffer {
  // Recent engines decode by themselves, much faster.
  const decode = (Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> }).fromBase64;
  if (decode) return decode.call(Uint8Array, text).buffer;
  const raw = atob(text);
  const found = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) found[i] = raw.charCodeAt(i);
  return found.buffer;
}

const numbers = (text?: string) => (text ? new Uint32Array(bytes(text)) : new Uint32Array(0));
const reals = (text: string) => new Float32Array(bytes(text));
function lists(text?: RaggedText): Ragged {
  if (!text) return NO_LISTS;
  const items = numbers(text.items);
  if (text.starts !== undefined) return { starts: numbers(text.starts), items };
  const width = text.width ?? 1;
  const starts = new Uint32Array(items.length / width + 1);
  for (let i = 0; i < starts.length; i++) starts[i] = i * width;
  return { starts, items };
}

function readLayer(text: LayerText, positions: Float32Array): Layer {
  return {
    name: text.name,
    group: text.group,
    detail: text.detail ?? "",
    color: text.color ?? null,
    on: text.on ?? false,
    arrows: text.arrows ?? false,
    own: text.positions !== undefined,
    positions: text.positions ? reals(text.positions) : positions,
    lines: lists(text.lines),
    points: numbers(text.points),
    triangles: numbers(text.triangles),
    labels: text.labels ?? [],
  };
}

/** Two coordinates a point made three. */
function lifted(flat: Float32Array): Float32Array {
  const found = new Float32Array((flat.length / 2) * 3);
  for (let i = 0; 2 * i < flat.length; i++) {
    found[3 * i] = flat[2 * i];
    found[3 * i + 1] = flat[2 * i + 1];
  }
  return found;
}

export function readScene(text: SceneText): Scene {
  if (text.coface_scene !== 1) throw new Error("this page shows scenes of version 1");
  const positions = reals(text.positions);
  const polygons = lists(text.polygons);
  const { triangles } = text;
  return {
    title: text.title,
    report: text.report,
    dimension: text.dimension,
    origin: text.origin,
    positions,
    vertexNumbers: numbers(text.vertexNumbers),
    polygons,
    rims: lists(text.rims),
    polygonsOfRims: numbers(text.polygonsOfRims),
    simplices: lists(text.simplices),
    cells: lists(text.cells),
    signs: numbers(text.signs),
    notes: text.notes,
    triangles: triangles ? numbers(triangles.items) : polygons.items,
    polygonOfTriangle: triangles ? numbers(triangles.polygons) : null,
    cellOfTriangle: triangles ? numbers(triangles.cells) : new Uint32Array(0),
    remarks: (text.remarks ?? []).map((remark) => remark.message),
    layers: text.layers.map((layer) => readLayer(layer, positions)),
    panes: text.panes.map((pane) => {
      const flat = lifted(reals(pane.positions));
      return { name: pane.name, axes: pane.axes ?? null, layers: pane.layers.map((l) => readLayer(l, flat)) };
    }),
  };
}

/** The polygon that a triangle is part of. */
export function polygonOf(scene: Scene, triangle: number): number {
  return scene.polygonOfTriangle ? scene.polygonOfTriangle[triangle] : triangle;
}
