/**
 * The state of the view in the fragment of the address, so that a link shows what is seen.
 */

export interface ViewState {
  /** Where the camera is and what it looks at. */
  camera: number[];
  target: number[];
  /** The names of the layers that are on, with their groups. */
  on: string[];
  /** The selected cells: dimension:vertices. */
  selection: string[];
  neighborhood: string;
  theme: string;
  edges: boolean;
  /** How far cells are moved apart, and where the cutting plane is, from 0 to 1. */
  explode: number;
  clip: number;
  /** Which way the cutting plane looks, 0 to 2. */
  axis: number;
  zoom: number;
  /** The axis that is up. */
  up: string;
}

export function toFragment(state: ViewState): string {
  const part = (numbers: number[]) => numbers.map((x) => Number(x.toPrecision(6))).join(",");
  const query = new URLSearchParams();
  query.set("camera", part(state.camera));
  query.set("target", part(state.target));
  query.set("on", state.on.join("|"));
  if (state.selection.length) query.set("select", state.selection.join("|"));
  query.set("show", state.neighborhood);
  query.set("theme", state.theme);
  query.set("edges", state.edges ? "1" : "0");
  if (state.explode) query.set("explode", String(state.explode));
  if (state.clip < 1) query.set("clip", String(state.clip));
  if (state.axis) query.set("axis", String(state.axis));
  query.set("up", state.up);
  if (state.zoom !== 1) query.set("zoom", String(Number(state.zoom.toPrecision(6))));
  return query.toString();
}

export function fromFragment(fragment: string): Partial<ViewState> {
  const query = new URLSearchParams(fragment.replace(/^#/, ""));
  const found: Partial<ViewState> = {};
  const numbers = (key: string) => {
    const list = (query.get(key) ?? "").split(",").map(Number);
    return list.length === 3 && list.every(Number.isFinite) ? list : undefined;
  };
  const list = (key: string) => {
    const text = query.get(key);
    return text === null ? undefined : text.split("|").filter((part) => part.length > 0);
  };
  found.camera = numbers("camera");
  found.target = numbers("target");
  found.on = list("on");
  found.selection = list("select");
  found.neighborhood = query.get("show") ?? undefined;
  found.theme = query.get("theme") ?? undefined;
  const edges = query.get("edges");
  found.edges = edges === null ? undefined : edges === "1";
  const share = (key: string) => {
    const value = Number(query.get(key) ?? NaN);
    return value >= 0 && value <= 1 ? value : undefined;
  };
  found.explode = share("explode");
  found.clip = share("clip");
  const axis = Number(query.get("axis") ?? NaN);
  if ([0, 1, 2].includes(axis)) found.axis = axis;
  const zoom = Number(query.get("zoom") ?? NaN);
  if (zoom > 0 && Number.isFinite(zoom)) found.zoom = zoom;
  const up = query.get("up");
  if (up === "y" || up === "z") found.up = up;
  for (const key of Object.keys(found) as (keyof ViewState)[]) if (found[key] === undefined) delete found[key];
  return found;
}
