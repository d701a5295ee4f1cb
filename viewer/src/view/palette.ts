/**
 * Colors that can be told apart with any sort of color vision: those of M. Okabe and K. Ito (2008), without black and yellow, which
 * vanish on one of the two backgrounds.
 */
export const PALETTE = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

/** For what is wrong. */
export const ALARM = "#d0021b";

/** What a click selects, and its star, closure, link and boundary: no layer has these colors. */
export const NEIGHBORHOOD = { selection: "#7a2cf5", star: "#f15bb5", closure: "#00bcd4", link: "#76b900", boundary: "#8d6248" };

/** How much is seen of lines behind the model, of 1. */
export const HIDDEN = 0.22;

/** The color of a place in the palette; from 2^24 on a color of its own, as red, green and blue. */
export function colorOf(place: number): string {
  if (place >= 1 << 24) return `#${(place & 0xffffff).toString(16).padStart(6, "0")}`;
  return PALETTE[place % PALETTE.length];
}

/** The colors of the page in light and in dark. */
export const THEMES = {
  light: { background: "#ffffff", surface: "#d9dee4", edge: "#5c6670", curve: "#1b1f23", text: "#1b1f23" },
  dark: { background: "#15181c", surface: "#7d8792", edge: "#2b3138", curve: "#e6e9ec", text: "#e6e9ec" },
};

export type Theme = keyof typeof THEMES;
