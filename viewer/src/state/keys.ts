/** What keys do. */

export interface KeyActions {
  turn(around: number, over: number): void;
  zoom(factor: number): void;
  reset(): void;
  edges(): void;
  vertices(): void;
  theme(): void;
  png(): void;
  svg(): void;
  share(): void;
  help(): void;
  clear(): void;
  /** Draws the neighborhood of this number. */
  neighborhood(number: number): void;
  nextPick(): void;
  nextLayer(step: number): void;
  clip(step: number): void;
  nextAxis(): void;
  up(): void;
  explode(step: number): void;
}

export function listenToKeys(actions: KeyActions): void {
  window.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement | null;
    // What is typed into a field is no command.
    if (target instanceof HTMLInputElement && target.type !== "range" && target.type !== "checkbox") return;
    if (target instanceof HTMLSelectElement) return;
    const isRange = target instanceof HTMLInputElement && target.type === "range" && event.key.startsWith("Arrow");
    if (event.ctrlKey || event.metaKey || event.altKey || isRange || document.querySelector("dialog[open]")) return;
    const step = event.shiftKey ? 0.02 : 0.12;
    const known: Record<string, () => void> = {
      r: () => actions.reset(),
      e: () => actions.edges(),
      v: () => actions.vertices(),
      d: () => actions.theme(),
      p: () => actions.png(),
      s: () => actions.svg(),
      l: () => actions.share(),
      m: () => actions.nextPick(),
      n: () => actions.nextLayer(event.shiftKey ? -1 : 1),
      c: () => actions.nextAxis(),
      u: () => actions.up(),
      "?": () => actions.help(),
      "[": () => actions.clip(-0.05),
      "]": () => actions.clip(0.05),
      ",": () => actions.explode(-0.1),
      ".": () => actions.explode(0.1),
      escape: () => actions.clear(),
      arrowleft: () => actions.turn(step, 0),
      arrowright: () => actions.turn(-step, 0),
      arrowup: () => actions.turn(0, step),
      arrowdown: () => actions.turn(0, -step),
      "+": () => actions.zoom(0.85),
      "=": () => actions.zoom(0.85),
      "-": () => actions.zoom(1 / 0.85),
    };
    const number = Number(event.key);
    if (number >= 1 && number <= 5) known[event.key] = () => actions.neighborhood(number - 1);
    const action = known[event.key.toLowerCase()];
    if (action) {
      action();
      event.preventDefault();
    }
  });
}
