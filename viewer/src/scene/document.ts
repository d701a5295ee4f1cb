/**
 * What the program puts into the page: one JSON document. Arrays of numbers are base64 of little-endian bytes.
 */

import type { Ragged } from "../complex/complex";

export interface RaggedText {
  starts: string;
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
  /** What `coface info --json` says. */
  report: Record<string, unknown> | null;
  /** The number of coordinates that matter, 2 or 3. */
  dimension: 2 | 3;
  /** What was taken from all positions before they were rounded to 32 bits. */
  origin: [number, number, number];
  positions: string;
  polygons: RaggedText;
  simplices: RaggedText;
  /** The polygons around each 3-cell. */
  cells: RaggedText;
  /** What is shaded: three vertices each, the polygon of each, and where there are 3-cells the cell of each. */
  triangles: { items: string; polygons: string; cells: string };
  layers: LayerText[];
  panes: PaneText[];
}

export interface Layer {
  name: string;
  group: string;
  detail: string;
  color: number | null;
  on: boolean;
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
  report: Record<string, unknown> | null;
  dimension: 2 | 3;
  origin: [number, number, number];
  positions: Float32Array;
  polygons: Ragged;
  simplices: Ragged;
  cells: Ragged;
  triangles: Uint32Array;
  polygonOfTriangle: Uint32Array;
  cellOfTriangle: Uint32Array;
  layers: Layer[];
  panes: Pane[];
}

const NO_LISTS: Ragged = { starts: new Uint32Array(1), items: new Uint32Array(0) };

function bytes(text: string): ArrayBuffer {
  const raw = atob(text);
  const found = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) found[i] = raw.charCodeAt(i);
  return found.buffer;
}

const numbers = (text?: string) => (text ? new Uint32Array(bytes(text)) : new Uint32Array(0));
const reals = (text: string) => new Float32Array(bytes(text));
const lists = (text?: RaggedText): Ragged =>
  text ? { starts: numbers(text.starts), items: numbers(text.items) } : NO_LISTS;

function readLayer(text: LayerText, positions: Float32Array): Layer {
  return {
    name: text.name,
    group: text.group,
    detail: text.detail ?? "",
    color: text.color ?? null,
    on: text.on ?? false,
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
  return {
    title: text.title,
    report: text.report,
    dimension: text.dimension,
    origin: text.origin,
    positions,
    polygons: lists(text.polygons),
    simplices: lists(text.simplices),
    cells: lists(text.cells),
    triangles: numbers(text.triangles.items),
    polygonOfTriangle: numbers(text.triangles.polygons),
    cellOfTriangle: numbers(text.triangles.cells),
    layers: text.layers.map((layer) => readLayer(layer, positions)),
    panes: text.panes.map((pane) => {
      const flat = lifted(reals(pane.positions));
      return { name: pane.name, axes: pane.axes ?? null, layers: pane.layers.map((l) => readLayer(l, flat)) };
    }),
  };
}
