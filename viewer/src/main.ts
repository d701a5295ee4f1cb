/** The page: the scene that the program wrote into it, the window, the panel, and what keys and clicks do. */

import * as THREE from "three";
import { CellSet, Complex, keyOf, type Cell } from "./complex/complex";
import { button, download, element, toggle } from "./panel/elements";
import { showHelp } from "./panel/help";
import { LayersPanel } from "./panel/layers";
import { NEIGHBORHOODS, NeighborhoodPanel, neighborhoodOf, type Neighborhood } from "./panel/neighborhood";
import { paneElement } from "./panel/panes";
import { reportElement } from "./panel/report";
import { readScene, type Layer, type Scene, type SceneText } from "./scene/document";
import { fromFragment, toFragment, type ViewState } from "./state/fragment";
import { listenToKeys } from "./state/keys";
import { layerOfCells, TrianglesOfPolygons } from "./view/cells";
import { DrawnLayer } from "./view/layers";
import { offsetsOf } from "./view/parts";
import { ALARM, colorOf, NEIGHBORHOOD, type Theme } from "./view/palette";
import { pick, PICKS, type Pick } from "./view/picking";
import { Stage } from "./view/stage";
import { Surface } from "./view/surface";
import { svgText } from "./view/svg";

const AXES = ["x", "y", "z"];

/** Whether there can be a link to the page: within another page it has no address of its own. */
const HAS_ADDRESS = location.protocol !== "about:";

/** So many texts are written into the window at most. */
const MOST_LABELS = 400;

class Page {
  private readonly stage: Stage;
  private readonly surface: Surface;
  private readonly complex: Complex;
  private readonly shaded: TrianglesOfPolygons;
  private readonly colors: string[];
  private readonly drawn: DrawnLayer[];
  private readonly canvas = document.querySelector<HTMLCanvasElement>("#canvas")!;
  private readonly labels = document.querySelector<HTMLElement>("#labels")!;
  private readonly neighborhoodPanel: NeighborhoodPanel;
  private readonly layersPanel: LayersPanel;
  private readonly controls: Record<"edges" | "vertices" | "theme" | "axis" | "up", HTMLButtonElement>;
  private readonly sliders: Record<"clip" | "explode", HTMLInputElement>;
  private selection = new CellSet();
  /** The part that the last cell was picked on. */
  private part: number | null = null;
  private shown: Neighborhood = "link";
  private what: Pick = "nearest";
  private marks: { drawn: DrawnLayer; moves: boolean }[] = [];
  private theme: Theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  private clip = 1;
  private axis = 0;
  private explode = 0;
  private current = -1;

  constructor(private readonly model: Scene) {
    document.title = model.title;
    const { center, radius } = boundsOf(model);
    this.stage = new Stage(this.canvas, model.dimension === 2, center, radius);
    this.surface = new Surface(model, this.stage);
    const { positions, polygons, simplices, cells, signs, rims, polygonsOfRims } = model;
    this.complex = new Complex(positions.length / 3, polygons, simplices, cells, signs, rims, polygonsOfRims);
    this.shaded = new TrianglesOfPolygons(model);
    let next = 0;
    this.colors = model.layers.map((layer) => (layer.group === "witness" ? ALARM : colorOf(layer.color ?? next++)));
    this.drawn = model.layers.map((layer, i) => new DrawnLayer(this.stage, layer, this.colors[i], 4, i, this.surface.parts));
    for (const layer of this.drawn) this.stage.scene.add(layer.object);
    this.neighborhoodPanel = new NeighborhoodPanel(this.complex, model, {
      choose: (word) => this.showNeighborhood(word),
      pick: (what) => this.setPick(what),
      find: (cell) => this.find(cell),
    });
    this.layersPanel = new LayersPanel(model.layers, this.colors, {
      show: (index, isOn) => this.showLayer(index, isOn),
      zoom: (index) => this.zoomTo(index),
    });
    this.controls = {
      edges: toggle("edges", "edges (E)", false, (isOn) => this.surface.showEdges(isOn)),
      vertices: toggle("vertices", "vertices (V)", false, (isOn) => this.surface.showVertices(isOn)),
      theme: toggle("dark", "light or dark (D)", false, (isOn) => this.setTheme(isOn ? "dark" : "light")),
      axis: button("x", "the axis that the cutting plane is across (C)", () => this.setAxis((this.axis + 1) % 3)),
      up: button("y up", "which axis is up: y or z (U)", () => this.setUpZ(!this.stage.isUpZ)),
    };
    this.sliders = {
      clip: slider("clip", "0.005", (share) => this.setClip(share)),
      explode: slider("explode", "0.01", (share) => this.setExplode(share)),
    };
    this.fillPanel();
    this.setUpZ(isUpZ(model.title));
    if (!this.stage.hasRenderer) this.drawStills();
    this.restore(fromFragment(location.hash));
    this.listen();
  }

  /** Without WebGL the window has a still picture, which follows the camera and what is switched on. */
  private drawStills(): void {
    const still = element("div", { id: "stills" });
    this.canvas.after(still);
    this.say("this browser has no WebGL: still pictures are drawn instead", 6000);
    this.stage.onDraw(() => {
      still.innerHTML = this.pictureText();
    });
  }

  private fillPanel(): void {
    const panel = document.querySelector<HTMLElement>("#panel")!;
    const { edges, vertices, theme, axis, up } = this.controls;
    const isFlat = this.model.dimension === 2;
    const hasFaces = this.model.polygons.starts.length > 1;
    const view = element(
      "div",
      { class: "row" },
      button("reset", "look at everything (R)", () => this.stage.reset()),
      hasFaces ? edges : "",
      vertices,
      theme,
      isFlat ? "" : up,
      button("PNG", "save the picture as PNG (P)", () => void this.savePng()),
      button("SVG", "save the picture as SVG (S)", () => this.saveSvg()),
      HAS_ADDRESS ? button("share", "copy a link to this view (L)", () => this.share()) : "",
      button("?", "what keys do (?)", showHelp),
    );
    const told = element(
      "div",
      { id: "told" },
      element("h1", {}, this.model.title),
      ...this.model.remarks.map((remark) => element("p", { class: "detail", "data-remark": "" }, remark)),
      view,
      isFlat ? "" : element("div", { class: "row" }, element("label", { for: "clip" }, "cut across"), axis, this.sliders.clip),
      this.surface.parts
        ? element("div", { class: "row" }, element("label", { for: "explode" }, "take apart"), this.sliders.explode)
        : "",
      this.neighborhoodPanel.root,
      this.layersPanel.root,
      this.model.report ? reportElement(this.model.report) : "",
    );
    panel.replaceChildren(told);
    if (this.model.panes.length > 0) panel.prepend(element("div", { id: "pictures" }, ...this.model.panes.map(paneElement)));
  }

  private listen(): void {
    let pressed: { x: number; y: number } | null = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      // A second finger is no tap.
      pressed = event.isPrimary ? { x: event.clientX, y: event.clientY } : null;
    });
    this.canvas.addEventListener("pointerup", (event) => {
      const moved = pressed ? Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) : Infinity;
      pressed = null;
      if (moved < 6 && event.button === 0) this.click(event);
    });
    listenToKeys({
      turn: (around, over) => this.turn(around, over),
      zoom: (factor) => this.zoomBy(factor),
      reset: () => this.stage.reset(),
      edges: () => this.controls.edges.click(),
      vertices: () => this.controls.vertices.click(),
      theme: () => this.controls.theme.click(),
      png: () => void this.savePng(),
      svg: () => this.saveSvg(),
      share: () => this.share(),
      help: showHelp,
      clear: () => this.select(null, false),
      neighborhood: (number) => this.showNeighborhood(NEIGHBORHOODS[number]),
      nextPick: () => this.setPick(PICKS[(PICKS.indexOf(this.what) + 1) % PICKS.length]),
      nextLayer: (step) => this.nextLayer(step),
      clip: (step) => this.setClip(this.clip + step),
      nextAxis: () => this.setAxis((this.axis + 1) % 3),
      up: () => this.setUpZ(!this.stage.isUpZ),
      explode: (step) => this.setExplode(this.explode + step),
    });
    window.addEventListener("hashchange", () => this.restore(fromFragment(location.hash)));
    this.stage.onDraw(() => this.placeLabels());
  }

  private click(event: PointerEvent): void {
    const frame = this.canvas.getBoundingClientRect();
    const what = event.altKey ? "cell" : this.what;
    const [x, y] = [event.clientX - frame.left, event.clientY - frame.top];
    const picked = pick(x, y, what, this.model, this.complex, this.surface, this.stage);
    this.part = picked?.part ?? null;
    this.select(picked?.cell ?? null, event.shiftKey);
  }

  private turn(around: number, over: number): void {
    const { camera, controls } = this.stage;
    if (this.model.dimension === 2) {
      const step = (this.stage.radius * 0.5) / camera.zoom;
      const move = new THREE.Vector3(-around * step, over * step, 0);
      camera.position.add(move);
      controls.target.add(move);
    } else {
      this.stage.turn(around, over);
    }
    controls.update();
    this.stage.draw();
  }

  private zoomBy(factor: number): void {
    const { camera, controls } = this.stage;
    if (camera instanceof THREE.OrthographicCamera) {
      camera.zoom /= factor;
      camera.updateProjectionMatrix();
    } else {
      camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    }
    controls.update();
    this.stage.draw();
  }

  private select(cell: Cell | null, isAdded: boolean): void {
    const cells = isAdded ? this.selection.list() : [];
    if (cell) {
      const known = cells.findIndex((other) => keyOf(other) === keyOf(cell));
      if (known >= 0) cells.splice(known, 1);
      else cells.push(cell);
    }
    this.selection = CellSet.of(cells);
    this.drawNeighborhood();
    this.report();
  }

  /** Says to the page that this one stands in, such as a notebook, which cells are selected: their vertices by the numbers of the model. */
  private report(): void {
    if (window.parent === window) return;
    const number = (vertex: number) => this.model.vertexNumbers[vertex] ?? vertex;
    const cells = this.selection.list().map(({ dimension, vertices }) => ({ dimension, vertices: vertices.map(number) }));
    window.parent.postMessage({ coface: "selection", cells }, "*");
  }

  /** Selects a cell that was found by its number, and looks at it. */
  private find(cell: Cell): void {
    this.part = null;
    this.select(cell, false);
    const places = cell.vertices.map((vertex) => this.surface.vertex(vertex));
    const { center, radius } = new THREE.Sphere().setFromPoints(places);
    this.stage.look(center, radius);
  }

  private setPick(what: Pick): void {
    this.what = what === "cell" && this.model.cells.starts.length === 1 ? "nearest" : what;
    this.neighborhoodPanel.update(this.selection, this.shown, this.what);
  }

  private showNeighborhood(word: Neighborhood): void {
    this.shown = word;
    this.drawNeighborhood();
  }

  private drawNeighborhood(): void {
    for (const { drawn } of this.marks) drawn.dispose();
    this.marks = [];
    const show = (word: Neighborhood, width: number) => {
      const cells = neighborhoodOf(this.complex, this.selection, word);
      if (!cells || cells.size === 0) return;
      const layer = layerOfCells(word, cells, this.complex, this.model, this.shaded);
      // What is selected stays on the part that it was picked on; what is around it comes apart.
      const moves = word === "selection";
      const parts = moves ? null : this.surface.parts;
      const drawn = new DrawnLayer(this.stage, layer, NEIGHBORHOOD[word], width, 1000 + this.marks.length, parts);
      this.marks.push({ drawn, moves });
      this.stage.scene.add(drawn.object);
    };
    if (this.shown !== "selection") show(this.shown, 4);
    show("selection", 5);
    this.moveMarks();
    this.neighborhoodPanel.update(this.selection, this.shown, this.what);
    this.stage.draw();
  }

  /** Lets what is drawn over the model follow its parts. */
  private followParts(): void {
    for (const layer of [...this.drawn, ...this.marks.filter(({ moves }) => !moves).map(({ drawn }) => drawn)]) layer.rearrange();
    this.moveMarks();
    this.stage.draw();
  }

  private moveMarks(): void {
    const offset = this.part === null ? new THREE.Vector3() : this.surface.offsetOfPart(this.part);
    for (const { drawn, moves } of this.marks) if (moves) drawn.object.position.copy(offset);
  }

  private showLayer(index: number, isOn: boolean): void {
    this.model.layers[index].on = isOn;
    this.drawn[index].show(isOn);
    this.stage.draw();
  }

  private zoomTo(index: number): void {
    const { center, radius } = this.drawn[index].sphere;
    this.stage.look(center, radius);
  }

  /** Shows the next layer alone. */
  private nextLayer(step: number): void {
    const count = this.model.layers.length;
    if (count === 0) return;
    this.current = (this.current + step + count + (this.current < 0 && step < 0 ? 1 : 0)) % count;
    for (let i = 0; i < count; i++) this.layersPanel.set(i, i === this.current);
    this.zoomTo(this.current);
  }

  private setTheme(theme: Theme): void {
    this.theme = theme;
    document.body.classList.toggle("dark", theme === "dark");
    this.controls.theme.setAttribute("aria-pressed", String(theme === "dark"));
    this.surface.setTheme(theme);
    this.stage.setTheme(theme);
  }

  private setUpZ(isUpZ: boolean): void {
    this.stage.setUpZ(isUpZ);
    this.controls.up.textContent = this.stage.isUpZ ? "z up" : "y up";
  }

  private setClip(share: number): void {
    this.clip = Math.min(Math.max(share, 0), 1);
    this.sliders.clip.value = String(this.clip);
    this.surface.setClip(this.clip, this.axis);
    if (this.explode > 0) this.followParts();
  }

  private setAxis(axis: number): void {
    this.axis = axis;
    this.controls.axis.textContent = AXES[axis];
    this.surface.setClip(this.clip, axis);
    if (this.explode > 0) this.followParts();
  }

  private setExplode(share: number): void {
    this.explode = Math.min(Math.max(share, 0), 1);
    this.sliders.explode.value = String(this.explode);
    this.surface.setExplode(this.explode);
    this.followParts();
  }

  private placeLabels(): void {
    const wanted = this.model.layers
      .flatMap((layer) =>
        layer.on ? layer.labels.map((label) => ({ text: label.text, at: this.placeOf(layer, label.point) })) : [],
      )
      .slice(0, MOST_LABELS);
    while (this.labels.childElementCount > wanted.length) this.labels.lastElementChild?.remove();
    while (this.labels.childElementCount < wanted.length) this.labels.append(element("span"));
    wanted.forEach(({ text, at }, i) => {
      const label = this.labels.children[i] as HTMLElement;
      const place = this.stage.project(at);
      label.textContent = text;
      label.style.left = `${place.x}px`;
      label.style.top = `${place.y}px`;
    });
  }

  /** Where a point of a layer is seen, on the first of the parts that have it. */
  private placeOf(layer: Layer, point: number): THREE.Vector3 {
    const place = new THREE.Vector3().fromArray(layer.positions, 3 * point);
    const offset = offsetsOf(this.surface.parts, layer, [point])[0];
    return offset ? place.add(offset) : place;
  }

  private async savePng(): Promise<void> {
    if (!this.stage.hasRenderer) {
      this.say("without WebGL the picture is saved as SVG");
      this.saveSvg();
      return;
    }
    download(`${this.model.title}.png`, await this.stage.png());
  }

  private saveSvg(): void {
    download(`${this.model.title}.svg`, new Blob([this.pictureText()], { type: "image/svg+xml" }));
  }

  /** The picture as SVG. */
  private pictureText(): string {
    const layers = this.model.layers.map((layer, i) => ({ layer, color: this.colors[i] })).filter(({ layer }) => layer.on);
    const size = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    return svgText(this.model, layers, this.stage, this.surface, this.theme, size);
  }

  private state(): ViewState {
    return {
      camera: this.stage.camera.position.toArray(),
      target: this.stage.controls.target.toArray(),
      on: this.model.layers.filter((layer) => layer.on).map((layer) => `${layer.group}/${layer.name}`),
      selection: this.selection.list().map(keyOf),
      neighborhood: this.shown,
      theme: this.theme,
      edges: this.surface.hasEdges,
      explode: this.explode,
      clip: this.clip,
      axis: this.axis,
      zoom: this.stage.camera.zoom,
      up: this.stage.isUpZ ? "z" : "y",
    };
  }

  private share(): void {
    if (!HAS_ADDRESS) return;
    history.replaceState(null, "", `#${toFragment(this.state())}`);
    const copied = navigator.clipboard?.writeText(location.href) ?? Promise.reject(new Error("no clipboard"));
    copied.then(
      () => this.say("the link is copied"),
      () => this.say("the link is in the address bar"),
    );
  }

  /** Says something in the window for a while, in milliseconds. */
  private say(text: string, time = 1800): void {
    const message = document.querySelector<HTMLElement>("#message")!;
    message.textContent = text;
    message.classList.add("seen");
    setTimeout(() => message.classList.remove("seen"), time);
  }

  private restore(state: Partial<ViewState>): void {
    if (state.on) {
      const on = new Set(state.on);
      this.model.layers.forEach((layer, i) => {
        layer.on = on.has(`${layer.group}/${layer.name}`);
        this.drawn[i].show(layer.on);
      });
      this.layersPanel.update();
    }
    if (state.up) this.setUpZ(state.up === "z");
    if (state.camera && state.target) {
      this.stage.camera.position.fromArray(state.camera);
      this.stage.controls.target.fromArray(state.target);
      this.stage.camera.zoom = state.zoom ?? 1;
      this.stage.camera.updateProjectionMatrix();
      this.stage.controls.update();
    }
    if (state.edges !== undefined) this.surface.showEdges(state.edges);
    this.controls.edges.setAttribute("aria-pressed", String(this.surface.hasEdges));
    this.controls.vertices.setAttribute("aria-pressed", String(this.surface.hasVertices));
    this.setTheme(state.theme === "light" || state.theme === "dark" ? state.theme : this.theme);
    this.setAxis(state.axis ?? this.axis);
    this.setClip(state.clip ?? this.clip);
    this.setExplode(state.explode ?? this.explode);
    this.shown = NEIGHBORHOODS.find((known) => known === state.neighborhood) ?? this.shown;
    const cells = (state.selection ?? []).map((text) => {
      const [dimension, vertices] = text.split(":");
      return { dimension: Number(dimension), vertices: (vertices ?? "").split(",").map(Number) };
    });
    // An address may have been written for another model, or by hand.
    this.selection = CellSet.of(cells.filter((cell) => this.complex.has(cell)));
    this.drawNeighborhood();
  }
}

function slider(id: string, step: string, move: (share: number) => void): HTMLInputElement {
  const found = element("input", { type: "range", min: "0", max: "1", step, id });
  found.addEventListener("input", () => move(Number(found.value)));
  return found;
}

/** Whether z is up in files with such a name: maps, scans, machines and finite elements; y is in models made for pictures. */
function isUpZ(title: string): boolean {
  return /\.(stl|msh|mesh|vt[kup]|city\.jsonl?|cfc|npy|nrrd|nii|3mf|xyz)(\.\w+)?$/i.test(title);
}

/** A ball around the box around everything. */
function boundsOf(model: Scene): { center: THREE.Vector3; radius: number } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const positions of new Set([model.positions, ...model.layers.map((layer) => layer.positions)])) {
    for (let i = 0; i < positions.length; i++) {
      const axis = i % 3;
      if (positions[i] < low[axis]) low[axis] = positions[i];
      if (positions[i] > high[axis]) high[axis] = positions[i];
    }
  }
  if (low[0] > high[0]) return { center: new THREE.Vector3(), radius: 1 };
  const center = new THREE.Vector3(...low.map((x, axis) => (x + high[axis]) / 2));
  const radius = Math.hypot(...low.map((x, axis) => high[axis] - x)) / 2;
  return { center, radius: radius > 0 ? radius : 1 };
}

const holder = document.querySelector("#scene");
const scene = JSON.parse(holder?.textContent ?? "null") as SceneText | null;
// The text is not needed any more, and may be long.
holder?.replaceChildren();
if (scene) {
  new Page(readScene(scene));
} else {
  document.querySelector("#panel")?.append("This page has no scene: write one with coface view.");
}
