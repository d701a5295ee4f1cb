//! Colors.

/// A color as red, green and blue from 0 to 1.
pub(crate) type Color = [f32; 3];

/// Colors that can be told apart with any sort of color vision: those of M. Okabe and K. Ito (2008) without black and yellow.
const PALETTE: [u32; PALETTE_LENGTH] = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9];

/// So many colors can be told apart.
pub(super) const PALETTE_LENGTH: usize = 6;

/// For what is wrong.
pub(super) const ALARM: Color = of(0xd0021b);

/// For numbers of cells, dark and light backgrounds alike.
pub(super) const NEUTRAL: Color = of(0x8a5a00);

/// For the vertices of a complex that lies under other things, dark and light backgrounds alike.
pub(super) const FAINT: Color = of(0x8b959f);

/// The colors of a picture.
pub(super) struct Theme {
    pub(super) background: Color,
    pub(super) surface: Color,
    pub(super) edge: Color,
    /// For edges under other things.
    pub(super) pale: Color,
    /// For lines and points that lie on no surface, and for texts.
    pub(super) ink: Color,
}

pub(super) const LIGHT: Theme = Theme {
    background: of(0xffffff),
    surface: of(0xd9dee4),
    edge: of(0x5c6670),
    pale: of(0xa3acb5),
    ink: of(0x22272d),
};
pub(super) const DARK: Theme = Theme {
    background: of(0x15181c),
    surface: of(0x7d8792),
    edge: of(0x2b3138),
    pale: of(0x4c555e),
    ink: of(0xe4e8ec),
};

/// A color by its number as in style sheets.
pub(crate) const fn of(rgb: u32) -> Color {
    [(rgb >> 16 & 255) as f32 / 255.0, (rgb >> 8 & 255) as f32 / 255.0, (rgb & 255) as f32 / 255.0]
}

/// A color by its bytes.
pub(super) fn color_of_bytes(bytes: [u8; 3]) -> Color {
    bytes.map(|byte| f32::from(byte) / 255.0)
}

/// The color of a place in the palette, or of a number of [`Layer::rgb`](crate::Layer::rgb).
pub(super) fn color(place: usize) -> Color {
    if place >> 24 == 1 {
        return of((place & 0xff_ffff) as u32);
    }
    of(PALETTE[place % PALETTE.len()])
}

/// So much of a color, and the rest of another one.
pub(crate) fn mixed(color: Color, other: Color, share: f32) -> Color {
    [0, 1, 2].map(|part| share * color[part] + (1.0 - share) * other[part])
}

/// The color of one of many things side by side: those of the palette, then others whose hues are far from each other.
pub(crate) fn color_of_many(place: usize) -> Color {
    if place < PALETTE_LENGTH {
        return color(place);
    }
    // Hues go on by the golden section of the circle; each is as dark as the palette.
    let hue = (0.07 + 0.618_034 * (place - PALETTE_LENGTH) as f64).fract();
    let part = |shift: f64| {
        let distance = ((hue + shift).fract() - 0.5).abs() * 6.0 - 1.0;
        (0.12 + 0.62 * distance.clamp(0.0, 1.0)) as f32
    };
    [part(0.0), part(2.0 / 3.0), part(1.0 / 3.0)]
}

/// The color of a place in the palette of pictures, as red, green and blue: one that can be told from its neighbors with any sort
/// of color vision. The palette begins again after six.
///
/// # Examples
/// ```
/// use coface_pictures::palette_color;
/// assert_eq!(palette_color(0), [0, 114, 178]);
/// assert_eq!(palette_color(6), palette_color(0));
/// ```
pub fn palette_color(place: usize) -> [u8; 3] {
    let [_, red, green, blue] = PALETTE[place % PALETTE.len()].to_be_bytes();
    [red, green, blue]
}

/// One number, the parts in bytes.
pub(super) fn packed(color: Color) -> u32 {
    color.iter().fold(0, |number, part| number << 8 | (part.clamp(0.0, 1.0) * 255.0).round() as u32)
}

/// A color as in style sheets.
pub(super) fn hex(color: Color) -> String {
    format!("#{:06x}", packed(color))
}
