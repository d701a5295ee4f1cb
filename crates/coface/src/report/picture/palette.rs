//! Colors.

/// A color as red, green and blue from 0 to 1.
pub(super) type Color = [f32; 3];

/// Colors that can be told apart with any sort of color vision: those of M. Okabe and K. Ito (2008) without black and yellow.
const PALETTE: [u32; 6] = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9];

/// For what is wrong.
pub(super) const ALARM: Color = of(0xd0021b);

/// The colors of a picture.
pub(super) struct Theme {
    pub(super) background: Color,
    pub(super) surface: Color,
    pub(super) edge: Color,
}

pub(super) const LIGHT: Theme = Theme { background: of(0xffffff), surface: of(0xd9dee4), edge: of(0x5c6670) };
pub(super) const DARK: Theme = Theme { background: of(0x15181c), surface: of(0x7d8792), edge: of(0x2b3138) };

const fn of(rgb: u32) -> Color {
    [(rgb >> 16 & 255) as f32 / 255.0, (rgb >> 8 & 255) as f32 / 255.0, (rgb & 255) as f32 / 255.0]
}

/// The color of a place in the palette.
pub(super) fn color(place: usize) -> Color {
    of(PALETTE[place % PALETTE.len()])
}

/// A color as in style sheets.
pub(super) fn hex(color: Color) -> String {
    let [r, g, b] = color.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
