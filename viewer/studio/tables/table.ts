/** A table: something that is moved by hand, and what the program says of it at once. */

import type { Outcome } from "../system";

/** What a table may do. */
export interface Hands {
  run(words: string[], files: Iterable<[string, Uint8Array]>): Promise<Outcome>;
  /** Takes what lies on the table among the models. */
  keep(name: string, text: string): void;
}

export interface Table {
  title: string;
  about: string;
  /** Fills the place; the answer clears it away. */
  open(place: HTMLElement, hands: Hands): () => void;
}

export type Point = [number, number];

const SPACE = "http://www.w3.org/2000/svg";

export function drawn(tag: string, attributes: Record<string, string | number>, ...children: (Node | string)[]): SVGElement {
  const found = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(attributes)) found.setAttribute(name, String(value));
  found.append(...children);
  return found;
}

/** Where the pointer is, in the numbers of the picture. */
export function pointOf(svg: SVGSVGElement, event: PointerEvent): Point {
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
  return [Math.round(place.x * 100) / 100, Math.round(place.y * 100) / 100];
}

/** A point that can be dragged, and moved by the arrow keys. */
export function handle(svg: SVGSVGElement, [x, y]: Point, name: string, radius: number, onMove: (point: Point) => void, onClick: () => void = () => {}): SVGElement {
  const found = drawn("circle", { cx: x, cy: y, r: radius, tabindex: 0, role: "button", "aria-label": name, class: "handle", fill: "var(--accent)", stroke: "var(--text)", "stroke-width": 0.03 });
  let at: Point = [x, y];
  let moved = false;
  const move = (point: Point) => {
    at = point;
    found.setAttribute("cx", String(point[0]));
    found.setAttribute("cy", String(point[1]));
    onMove(point);
  };
  found.addEventListener("pointerdown", (event) => {
    event.stopPropagation();
    moved = false;
    found.setPointerCapture(event.pointerId);
  });
  found.addEventListener("pointermove", (event) => {
    if (!found.hasPointerCapture(event.pointerId)) return;
    moved = true;
    move(pointOf(svg, event));
  });
  found.addEventListener("pointerup", () => {
    if (!moved) onClick();
  });
  found.addEventListener("keydown", (event) => {
    const step: Point | undefined = ({ ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] } as Record<string, Point>)[event.key];
    if (step) {
      event.preventDefault();
      move([Math.round((at[0] + step[0]) * 100) / 100, Math.round((at[1] + step[1]) * 100) / 100]);
    }
    if (event.key === "Enter") onClick();
  });
  return found;
}

/** Runs one after the other, and leaves out all but the last that was asked for meanwhile. */
export function latest(work: () => Promise<void>): () => void {
  let isBusy = false;
  let isAsked = false;
  const go = async () => {
    if (isBusy) {
      isAsked = true;
      return;
    }
    isBusy = true;
    try {
      await work();
    } finally {
      isBusy = false;
    }
    if (isAsked) {
      isAsked = false;
      void go();
    }
  };
  return () => void go();
}

export const text = (outcome: Outcome) => new TextDecoder().decode(outcome.stdout);
export const file = (name: string, content: string): [string, Uint8Array] => [name, new TextEncoder().encode(content)];
