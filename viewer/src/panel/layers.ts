/** The list of layers, by groups, each to be switched on and off and zoomed to. */

import type { Layer } from "../scene/document";
import { button, element } from "./elements";

export interface LayerActions {
  show(layer: number, isOn: boolean): void;
  zoom(layer: number): void;
}

export function layersElement(layers: Layer[], colors: string[], actions: LayerActions): HTMLElement {
  const section = element("section");
  for (const group of new Set(layers.map((layer) => layer.group))) {
    const list = element("ul");
    layers.forEach((layer, index) => {
      if (layer.group !== group) return;
      const box = element("input", { type: "checkbox", id: `layer-${index}`, "data-layer": layer.name });
      box.checked = layer.on;
      box.addEventListener("change", () => actions.show(index, box.checked));
      list.append(
        element(
          "li",
          {},
          box,
          element("span", { class: "swatch", style: `background:${colors[index]}` }),
          element("label", { for: box.id }, layer.name, " ", element("span", { class: "detail" }, layer.detail)),
          button("zoom", `look at ${layer.name}`, () => {
            if (!box.checked) box.click();
            actions.zoom(index);
          }),
        ),
      );
    });
    section.append(element("h2", {}, group), list);
  }
  return section;
}
