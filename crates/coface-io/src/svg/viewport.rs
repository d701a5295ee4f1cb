//! Lengths with units, and the boxes that percentages are of.

use super::transformation::Transformation;
use roxmltree::Node;

/// What a percentage is of.
#[derive(Clone, Copy)]
pub(super) enum Extent {
    Width,
    Height,
    /// The diagonal of a square box of the same area, as SVG says it: the root of half the sum of both squares.
    Diagonal,
}

/// The box that the coordinates of elements are in, and the size of letters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Viewport {
    /// Width and height in the unit of the user; `None` where the drawing does not say them.
    size: Option<[f64; 2]>,
    /// The size of letters in the unit of the user.
    letter: f64,
}

/// The size of letters where nothing is said.
const LETTER: f64 = 16.0;

impl Viewport {
    /// That of the outermost element, of letters of this size.
    pub(super) fn of_root(root: Node<'_, '_>, letters: Option<&str>) -> Result<Self, String> {
        let plain = Self { size: None, letter: LETTER }.within(letters);
        let size = match view_box(root)? {
            Some([_, _, width, height]) => Some([width, height]),
            None => {
                let side =
                    |name: &str| root.attribute(name).and_then(|text| plain.parsed(text, Extent::Width));
                side("width").zip(side("height")).map(|(width, height)| [width, height])
            }
        };
        Ok(Self { size, ..plain })
    }

    /// The same with the size of letters that an element says.
    pub(super) fn within(self, letters: Option<&str>) -> Self {
        let Some(text) = letters else { return self };
        // Of the letters around it; words such as `medium` or `larger` change nothing here.
        let letter = match text.strip_suffix('%') {
            Some(percent) => percent.trim().parse().ok().map(|percent: f64| percent / 100.0 * self.letter),
            None => self.parsed(text, Extent::Width),
        };
        Self { letter: letter.filter(|letter| *letter > 0.0).unwrap_or(self.letter), ..self }
    }

    /// The length in an attribute, in the unit of the user. Absent attributes and `auto` are `None`.
    pub(super) fn length(&self, node: Node<'_, '_>, name: &str, of: Extent) -> Result<Option<f64>, String> {
        let text = node.attribute(name).map(str::trim).filter(|text| !matches!(*text, "" | "auto"));
        let Some(text) = text else { return Ok(None) };
        match self.parsed(text, of) {
            Some(length) => Ok(Some(length)),
            None if text.ends_with('%') && self.size.is_none() => Err(format!(
                "{name}=\"{text}\" is of the size of the drawing, and <svg> says none: neither viewBox nor width and height"
            )),
            None => Err(format!("{name}=\"{text}\" is no length")),
        }
    }

    /// The same letters in a box of this size.
    pub(super) fn of_box(self, size: [f64; 2]) -> Self {
        Self { size: Some(size), ..self }
    }

    /// What tells it from others.
    pub(super) fn bits(&self) -> [Option<u64>; 3] {
        let [width, height] = self.size.map_or([None; 2], |size| size.map(|side| Some(side.to_bits())));
        [width, height, Some(self.letter.to_bits())]
    }

    pub(super) fn parsed(&self, text: &str, of: Extent) -> Option<f64> {
        let text = text.trim();
        let unit_at = text.rfind(|c: char| !c.is_ascii_alphabetic() && c != '%').map_or(0, |last| last + 1);
        // The exponent of a number ends in a digit.
        let (number, unit) = text.split_at(unit_at);
        let number: f64 = number.trim().parse().ok().filter(|number: &f64| number.is_finite())?;
        // An inch has 96 units, whatever the medium is.
        let scale = match unit.to_ascii_lowercase().as_str() {
            "" | "px" => 1.0,
            "in" => 96.0,
            "cm" => 96.0 / 2.54,
            "mm" => 96.0 / 25.4,
            "q" => 96.0 / 101.6,
            "pt" => 96.0 / 72.0,
            "pc" => 16.0,
            "em" | "ic" => self.letter,
            "rem" => LETTER,
            // Without the letters themselves half of their size is what CSS takes.
            "ex" | "ch" => 0.5 * self.letter,
            "%" => {
                let [width, height] = self.size?;
                let whole = match of {
                    Extent::Width => width,
                    Extent::Height => height,
                    Extent::Diagonal => (0.5 * (width * width + height * height)).sqrt(),
                };
                whole / 100.0
            }
            "vw" => self.size?[0] / 100.0,
            "vh" => self.size?[1] / 100.0,
            "vmin" => self.size?[0].min(self.size?[1]) / 100.0,
            "vmax" => self.size?[0].max(self.size?[1]) / 100.0,
            _ => return None,
        };
        Some(number * scale).filter(|length| length.is_finite())
    }

    /// An `svg` or a `symbol` inside. `None` if it has no extent and draws nothing.
    ///
    /// Width and height are those of the element that uses it, if it says some.
    pub(super) fn inner(
        self,
        node: Node<'_, '_>,
        user: Option<Node<'_, '_>>,
    ) -> Result<Option<Inner>, String> {
        let side = |name: &str, of: Extent| -> Result<Option<f64>, String> {
            let of_user = user.map_or(Ok(None), |user| self.length(user, name, of))?;
            of_user.map_or_else(|| self.length(node, name, of), |length| Ok(Some(length)))
        };
        let at = |name: &str, of: Extent| match node.tag_name().name() {
            "svg" => self.length(node, name, of).map(Option::unwrap_or_default),
            _ => Ok(0.0),
        };
        let corner = [at("x", Extent::Width)?, at("y", Extent::Height)?];
        let sides = [side("width", Extent::Width)?, side("height", Extent::Height)?];
        let whole = self.size.map_or([None; 2], |size| size.map(Some));
        let size = [sides[0].or(whole[0]), sides[1].or(whole[1])];
        let moved = Transformation { e: corner[0], f: corner[1], ..Transformation::IDENTITY };
        let size = match size {
            [Some(width), Some(height)] => [width, height],
            // Without a size nothing is scaled.
            _ => {
                let size = view_box(node)?.map(|[_, _, width, height]| [width, height]);
                return Ok(Some(Inner { map: moved, viewport: Self { size, ..self }, clip: None }));
            }
        };
        let clip = Some([corner, [corner[0] + size[0], corner[1] + size[1]]]);
        if size.iter().any(|side| *side <= 0.0) {
            return Ok(None);
        }
        let Some([left, top, width, height]) = view_box(node)? else {
            return Ok(Some(Inner { map: moved, viewport: Self { size: Some(size), ..self }, clip }));
        };
        if width <= 0.0 || height <= 0.0 {
            return Ok(None);
        }
        let mut scale = [size[0] / width, size[1] / height];
        let alignment = node.attribute("preserveAspectRatio").unwrap_or("xMidYMid meet").trim();
        let mut free = [0.0; 2];
        if !alignment.starts_with("none") {
            let both = match alignment.ends_with("slice") {
                true => scale[0].max(scale[1]),
                false => scale[0].min(scale[1]),
            };
            scale = [both; 2];
            let part = |least: &str, most: &str| match alignment {
                text if text.contains(least) => 0.0,
                text if text.contains(most) => 1.0,
                _ => 0.5,
            };
            free = [
                part("xMin", "xMax") * (size[0] - both * width),
                part("YMin", "YMax") * (size[1] - both * height),
            ];
        }
        let map = Transformation {
            a: scale[0],
            d: scale[1],
            e: corner[0] + free[0] - scale[0] * left,
            f: corner[1] + free[1] - scale[1] * top,
            ..Transformation::IDENTITY
        };
        Ok(Some(Inner { map, viewport: Self { size: Some([width, height]), ..self }, clip }))
    }
}

/// What an `svg` or a `symbol` is inside of another drawing.
pub(super) struct Inner {
    /// From its coordinates to those around it.
    pub(super) map: Transformation,
    /// Its own box.
    pub(super) viewport: Viewport,
    /// The lower and the upper corner of what is seen of it, in the coordinates around it.
    pub(super) clip: Option<[[f64; 2]; 2]>,
}

/// The left and the upper end of a box, its width and its height.
fn view_box(node: Node<'_, '_>) -> Result<Option<[f64; 4]>, String> {
    let Some(text) = node.attribute("viewBox") else { return Ok(None) };
    let words = text.split(|c: char| c == ',' || c.is_ascii_whitespace()).filter(|word| !word.is_empty());
    let numbers: Option<Vec<f64>> =
        words.map(|word| word.parse().ok().filter(|number: &f64| number.is_finite())).collect();
    match numbers.as_deref() {
        Some(&[left, top, width, height]) => Ok(Some([left, top, width, height])),
        _ => Err(format!("viewBox=\"{text}\" are not four numbers")),
    }
}
