import { expect, it } from "vitest";
import { fromFragment, toFragment, type ViewState } from "../src/state/fragment";

const state: ViewState = {
  camera: [1, 2.5, -3],
  target: [0, 0, 0.125],
  on: ["homology/H1 generator 0", "model/edges"],
  selection: ["1:0,4"],
  neighborhood: "link",
  theme: "dark",
  edges: true,
  explode: 0.25,
  clip: 0.5,
  axis: 2,
  zoom: 1.5,
  up: "z",
};

it("comes back from the address", () => {
  expect(fromFragment(`#${toFragment(state)}`)).toEqual(state);
});

it("takes nothing from an address that is not its own", () => {
  expect(fromFragment("#camera=1,2&edges")).toEqual({ edges: false });
  expect(fromFragment("")).toEqual({});
});
