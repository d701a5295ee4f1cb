/** The list of layers, by groups, each to be switched on and off and zoomed to. */

import type { Layer } from "../scene/document";
import { button, element } from "./elements";

export interface LayerActions {
  show(layer: number, isOn: boolean): void;
  zoom(layer: number): void;
}

export class LayersPanel {
  readonly root = element("section", { id: "layers" });
  private readonly boxes: HTMLInputElement[] = [];

  constructor(
    private readonly layers: Layer[],
    colors: string[],
    private readonly actions: LayerActions,
  ) {
    for (const group of new Set(layers.map((layer) => layer.group))) {
      const list = element("ul");
      const members: number[] = [];
      layers.forEach((layer, index) => {
        if (layer.group !== group) return;
        members.push(index);
        const box = element("input", { type: "checkbox", id: `layer-${index}`, "data-layer": layer.name });
        box.checked = layer.on;
        box.addEventListener("change", () => actions.show(index, box.checked));
        this.boxes[index] = box;
        list.append(
          element(
            "li",
            {},
            box,
            element("span", { class: "swatch", style: `background:${colors[index]}` }),
            element("label", { for: box.id }, layer.name, " ", element("span", { class: "detail" }, layer.detail)),
            button("zoom", `look at ${layer.name}`, () => {
              this.set(index, true);
              actions.zoom(index);
            }),
          ),
        );
      });
      const heading = element("h2", {}, group);
      if (members.length > 1) {
        heading.append(
          " ",
          button("all", `show all of ${group}`, () => members.forEach((index) => this.set(index, true))),
          button("none", `show nothing of ${group}`, () => members.forEach((index) => this.set(index, false))),
        );
      }
      this.root.append(heading, list);
    }
  }

  /** Switches a layer on or off, as a click on its box does. */
  set(index: number, isOn: boolean): void {
    if (this.layers[index].on === isOn) return;
    this.boxes[index].checked = isOn;
    this.actions.show(index, isOn);
  }

  /** Shows what is on. */
  update(): void {
    this.boxes.forEach((box, index) => (box.checked = this.layers[index].on));
  }
}
