/** The page: the scene that the program wrote into it, the window, the panel, and what keys and clicks do. */

import * as THREE from "three";
import { CellSet, Complex, keyOf, type Cell } from "./complex/complex";
import { button, download, element, toggle } from "./panel/elements";
import { layersElement } from "./panel/layers";
import { NEIGHBORHOODS, NeighborhoodPanel, neighborhoodOf, type Neighborhood } from "./panel/neighborhood";
import { paneElement } from "./panel/panes";
import { reportElement } from "./panel/report";
import { readScene, type Scene, type SceneText } from "./scene/document";
import { fromFragment, toFragment, type ViewState } from "./state/fragment";
import { layerOfCells } from "./view/cells";
import { DrawnLayer } from "./view/layers";
import { ALARM, colorOf, NEIGHBORHOOD, type Theme } from "./view/palette";
import { pick } from "./view/picking";
import { Stage } from "./view/stage";
import { Surface } from "./view/surface";
import { svgText } from "./view/svg";

class Page {
  private readonly stage: Stage;
  private readonly surface: Surface;
  private readonly complex: Complex;
  private readonly colors: string[];
  private readonly drawn: DrawnLayer[];
  private readonly canvas = document.querySelector<HTMLCanvasElement>("#canvas")!;
  private readonly labels = document.querySelector<HTMLElement>("#labels")!;
  private readonly neighborhoodPanel: NeighborhoodPanel;
  private selection = new CellSet();
  private shown: Neighborhood = "link";
  private marks: DrawnLayer[] = [];
  private theme: Theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  private clip = 1;
  private explode = 0;

  constructor(private readonly model: Scene) {
    document.title = model.title;
    const sphere = boundsOf(model);
    this.stage = new Stage(this.canvas, model.dimension === 2, sphere.center, sphere.radius);
    this.surface = new Surface(model, this.stage);
    this.complex = new Complex(model.positions.length / 3, model.polygons, model.simplices, model.cells);
    let next = 0;
    this.colors = model.layers.map((layer) => {
      if (layer.group === "witness") return ALARM;
      return colorOf(layer.color ?? next++);
    });
    this.drawn = model.layers.map((layer, i) => new DrawnLayer(this.stage, layer, this.colors[i]));
    for (const layer of this.drawn) this.stage.scene.add(layer.object);
    this.neighborhoodPanel = new NeighborhoodPanel(this.complex, (word) => {
      this.shown = word;
      this.drawNeighborhood();
    });
    this.restore(fromFragment(location.hash));
    this.fillPanel();
    this.setTheme(this.theme);
    this.listen();
    this.drawNeighborhood();
  }

  private fillPanel(): void {
    const panel = document.querySelector<HTMLElement>("#panel")!;
    const view = element(
      "div",
      { class: "row" },
      button("reset", "look at everything (R)", () => this.stage.reset()),
      toggle("edges", "edges (E)", this.surface.edges.visible, (isOn) => this.showEdges(isOn)),
      toggle("dark", "light or dark (D)", this.theme === "dark", (isOn) => this.setTheme(isOn ? "dark" : "light")),
      button("PNG", "save the picture (P)", () => void this.savePng()),
      button("SVG", "save the picture as SVG", () => this.saveSvg()),
      button("link", "copy a link to this view (L)", () => this.share()),
    );
    const clip = element("input", { type: "range", min: "0", max: "1", step: "0.005", value: String(this.clip), id: "clip" });
    clip.addEventListener("input", () => this.setClip(Number(clip.value)));
    const explode = element("input", { type: "range", min: "0", max: "1", step: "0.01", value: String(this.explode), id: "explode" });
    explode.addEventListener("input", () => this.setExplode(Number(explode.value)));
    panel.replaceChildren(
      element("h1", {}, this.model.title),
      view,
      element("div", { class: "row" }, element("label", { for: "clip" }, "cut"), clip),
      this.model.cells.starts.length > 1
        ? element("div", { class: "row" }, element("label", { for: "explode" }, "take apart"), explode)
        : "",
      this.neighborhoodPanel.root,
      layersElement(this.model.layers, this.colors, {
        show: (index, isOn) => this.showLayer(index, isOn),
        zoom: (index) => {
          const { center, radius } = this.drawn[index].sphere;
          this.stage.look(center, radius);
        },
      }),
      ...this.model.panes.map(paneElement),
      this.model.report ? reportElement(this.model.report) : "",
    );
  }

  private listen(): void {
    let pressed: { x: number; y: number } | null = null;
    this.canvas.addEventListener("pointerdown", (event) => (pressed = { x: event.clientX, y: event.clientY }));
    this.canvas.addEventListener("pointerup", (event) => {
      const moved = pressed ? Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) : Infinity;
      pressed = null;
      if (moved < 5 && event.button === 0) {
        const frame = this.canvas.getBoundingClientRect();
        const cell = pick(event.clientX - frame.left, event.clientY - frame.top, this.model, this.complex, this.surface, this.stage);
        this.select(cell, event.shiftKey);
      }
    });
    window.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.target instanceof HTMLInputElement) return;
      const step = event.shiftKey ? 0.02 : 0.12;
      const actions: Record<string, () => void> = {
        r: () => this.stage.reset(),
        e: () => document.querySelector<HTMLElement>("#panel button[title^='edges']")?.click(),
        d: () => document.querySelector<HTMLElement>("#panel button[title^='light']")?.click(),
        p: () => void this.savePng(),
        l: () => this.share(),
        escape: () => this.select(null, false),
        arrowleft: () => this.turn(step, 0),
        arrowright: () => this.turn(-step, 0),
        arrowup: () => this.turn(0, step),
        arrowdown: () => this.turn(0, -step),
        "+": () => this.zoomBy(0.85),
        "-": () => this.zoomBy(1 / 0.85),
      };
      NEIGHBORHOODS.forEach((word, i) => {
        actions[String(i + 1)] = () => {
          this.shown = word;
          this.drawNeighborhood();
        };
      });
      const action = actions[event.key.toLowerCase()];
      if (action) {
        action();
        event.preventDefault();
      }
    });
    this.stage.onDraw(() => this.placeLabels());
  }

  private turn(around: number, over: number): void {
    const { camera, controls } = this.stage;
    if (this.model.dimension === 2) {
      const step = this.stage.radius * 0.5;
      const move = new THREE.Vector3(-around * step, over * step, 0);
      camera.position.add(move);
      controls.target.add(move);
    } else {
      const place = new THREE.Spherical().setFromVector3(camera.position.clone().sub(controls.target));
      place.theta += around;
      place.phi = Math.min(Math.max(place.phi - over, 0.01), Math.PI - 0.01);
      camera.position.copy(controls.target).add(new THREE.Vector3().setFromSpherical(place));
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
  }

  private drawNeighborhood(): void {
    for (const mark of this.marks) mark.dispose();
    this.marks = [];
    const show = (word: Neighborhood, width: number) => {
      const cells = neighborhoodOf(this.complex, this.selection, word);
      if (!cells || cells.size === 0) return;
      const mark = new DrawnLayer(this.stage, layerOfCells(word, cells, this.complex, this.model), NEIGHBORHOOD[word], width);
      this.marks.push(mark);
      this.stage.scene.add(mark.object);
    };
    if (this.shown !== "selection") show(this.shown, 4);
    show("selection", 5);
    this.neighborhoodPanel.update(this.selection, this.shown);
    this.stage.draw();
  }

  private showLayer(index: number, isOn: boolean): void {
    this.model.layers[index].on = isOn;
    this.drawn[index].object.visible = isOn;
    this.stage.draw();
  }

  private showEdges(isOn: boolean): void {
    this.surface.edges.visible = isOn;
    this.stage.draw();
  }

  private setTheme(theme: Theme): void {
    this.theme = theme;
    document.body.classList.toggle("dark", theme === "dark");
    this.surface.setTheme(theme);
    this.stage.setTheme(theme);
  }

  private setClip(share: number): void {
    this.clip = share;
    this.surface.setClip(share);
  }

  private setExplode(share: number): void {
    this.explode = share;
    this.surface.setExplode(share);
  }

  private placeLabels(): void {
    const wanted = this.model.layers.flatMap((layer) =>
      layer.on ? layer.labels.map((label) => ({ text: label.text, at: new THREE.Vector3().fromArray(layer.positions, 3 * label.point) })) : [],
    );
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

  private async savePng(): Promise<void> {
    download(`${this.model.title}.png`, await this.stage.png());
  }

  private saveSvg(): void {
    const layers = this.model.layers.map((layer, i) => ({ layer, color: this.colors[i] })).filter(({ layer }) => layer.on);
    const size = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    const text = svgText(this.model, layers, this.stage, this.theme, size, this.surface.edges.visible);
    download(`${this.model.title}.svg`, new Blob([text], { type: "image/svg+xml" }));
  }

  private state(): ViewState {
    return {
      camera: this.stage.camera.position.toArray(),
      target: this.stage.controls.target.toArray(),
      on: this.model.layers.filter((layer) => layer.on).map((layer) => `${layer.group}/${layer.name}`),
      selection: this.selection.list().map((cell) => cell.vertices.join(",")),
      neighborhood: this.shown,
      theme: this.theme,
      edges: this.surface.edges.visible,
      explode: this.explode,
      clip: this.clip,
    };
  }

  private share(): void {
    location.hash = toFragment(this.state());
    void navigator.clipboard?.writeText(location.href).catch(() => undefined);
  }

  private restore(state: Partial<ViewState>): void {
    if (state.on) {
      const on = new Set(state.on);
      this.model.layers.forEach((layer, i) => {
        layer.on = on.has(`${layer.group}/${layer.name}`);
        this.drawn[i].object.visible = layer.on;
      });
    }
    if (state.camera && state.target) {
      this.stage.camera.position.fromArray(state.camera);
      this.stage.controls.target.fromArray(state.target);
      this.stage.controls.update();
    }
    if (state.theme === "light" || state.theme === "dark") this.theme = state.theme;
    if (state.edges !== undefined) this.surface.edges.visible = state.edges;
    if (state.clip !== undefined) this.setClip(state.clip);
    if (state.explode) this.setExplode(state.explode);
    const word = NEIGHBORHOODS.find((known) => known === state.neighborhood);
    if (word) this.shown = word;
    const count = this.complex.vertexCount;
    const cells = (state.selection ?? []).map((text) => text.split(",").map(Number));
    this.selection = CellSet.of(
      cells
        .filter((vertices) => vertices.every((v) => Number.isInteger(v) && v >= 0 && v < count))
        .map((vertices) => ({ dimension: Math.min(vertices.length - 1, 2), vertices })),
    );
  }
}

function boundsOf(model: Scene): THREE.Sphere {
  const box = new THREE.Box3();
  const point = new THREE.Vector3();
  const all = [model.positions, ...model.layers.map((layer) => layer.positions)];
  for (const positions of new Set(all)) {
    for (let i = 0; i < positions.length; i += 3) box.expandByPoint(point.fromArray(positions, i));
  }
  if (box.isEmpty()) return new THREE.Sphere(new THREE.Vector3(), 1);
  const sphere = box.getBoundingSphere(new THREE.Sphere());
  if (sphere.radius === 0) sphere.radius = 1;
  return sphere;
}

const text = document.querySelector("#scene")?.textContent ?? "null";
const scene = JSON.parse(text) as SceneText | null;
if (scene) {
  new Page(readScene(scene));
} else {
  document.querySelector("#panel")?.append("This page has no scene: write one with coface view.");
}
