//! Formulas: italic letters, upright signs and digits, indices and exponents.

use super::letters;

/// How letters stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Face {
    Upright,
    Italic,
    Bold,
}

/// Letters of one face and size beside each other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    pub(super) text: String,
    pub(super) face: Face,
    /// For a formula of size 1, as are places.
    pub(super) size: f64,
    /// Where it begins: to the right of the beginning of the formula, and above its baseline.
    pub(super) at: [f64; 2],
}

/// A formula in a line. Its letters have the widths of Times, which PDF readers have; in other faces they stand at the same places.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Formula {
    pub(super) runs: Vec<Run>,
    pub(super) width: f64,
}

/// The size of indices and exponents, how far they are below and above the baseline, and the gap before them.
const SCRIPT: f64 = 0.7;
const BELOW: f64 = 0.22;
const ABOVE: f64 = 0.4;
const GAP: f64 = 0.04;

impl Formula {
    /// With upright signs and digits after what is there.
    pub(crate) fn upright(mut self, text: &str) -> Self {
        self.push(text, Face::Upright, 1.0, 0.0);
        self
    }

    /// With italic letters.
    pub(crate) fn italic(mut self, text: &str) -> Self {
        self.push(text, Face::Italic, 1.0, 0.0);
        self
    }

    /// With bold letters.
    pub(crate) fn bold(mut self, text: &str) -> Self {
        self.push(text, Face::Bold, 1.0, 0.0);
        self
    }

    /// With an index and an exponent, one above the other; either may be empty. Their hyphens are signs.
    pub(crate) fn scripts(mut self, index: &str, exponent: &str) -> Self {
        let start = self.width + GAP;
        let mut end = self.width;
        for (text, above) in [(index, -BELOW), (exponent, ABOVE)] {
            if !text.is_empty() {
                self.width = start;
                self.push(&text.replace('-', "\u{2212}"), Face::Upright, SCRIPT, above);
                end = end.max(self.width);
            }
        }
        self.width = end;
        self
    }

    /// With room for so much of its size.
    pub(crate) fn space(mut self, width: f64) -> Self {
        self.width += width;
        self
    }

    fn push(&mut self, text: &str, face: Face, size: f64, above: f64) {
        if text.is_empty() {
            return;
        }
        self.runs.push(Run { text: text.to_owned(), face, size, at: [self.width, above] });
        self.width += size * text.chars().map(|letter| width(face, letter)).sum::<f64>();
    }

    /// The strokes of the formula at size 1, second coordinates going up from the baseline, each with its width.
    pub(super) fn strokes(&self) -> Vec<(f64, Vec<[f64; 2]>)> {
        let mut all = Vec::new();
        for run in &self.runs {
            let mut left = run.at[0];
            for letter in run.text.chars() {
                let wide = width(run.face, letter);
                // Letters of strokes have one width; here each has that of its face.
                let stretch = wide / letters::width(" ");
                let slant = if run.face == Face::Italic { 0.2 } else { 0.0 };
                let pen = run.size * if run.face == Face::Bold { 0.13 } else { 0.075 };
                for stroke in letters::strokes(letter.encode_utf8(&mut [0; 4])) {
                    let point = |[x, y]: [f64; 2]| {
                        [left + run.size * (stretch * x + slant * y), run.at[1] + run.size * y]
                    };
                    all.push((pen, stroke.into_iter().map(point).collect()));
                }
                left += run.size * wide;
            }
        }
        all
    }
}

/// The width of a letter of size 1.
pub(super) fn width(face: Face, letter: char) -> f64 {
    let widths = match face {
        Face::Upright => &ROMAN,
        Face::Italic => &ITALIC,
        Face::Bold => &BOLD,
    };
    let own = (letter as usize).checked_sub(' ' as usize).and_then(|place| widths.get(place));
    1e-3 * f64::from(own.copied().unwrap_or_else(|| symbol(letter).map_or(600, |(_, width)| width)))
}

/// The code and the width of a sign in the font Symbol (Adobe Font Metrics).
pub(super) fn symbol(letter: char) -> Option<(u8, u16)> {
    Some(match letter {
        '\u{2212}' => (0x2d, 549),
        '\u{2295}' => (0xc5, 768),
        '\u{2202}' => (0xb6, 494),
        '\u{2245}' => (0x40, 549),
        '\u{2192}' => (0xae, 987),
        '\u{d7}' => (0xb4, 549),
        '\u{2217}' => (0x2a, 500),
        _ => return None,
    })
}

/// Widths of the letters from the blank to the tilde in Times, in thousandths of its size (Adobe Font Metrics).
const ROMAN: [u16; 95] = [
    250, 333, 408, 500, 500, 833, 778, 180, 333, 333, 500, 564, 250, 333, 250, 278, 500, 500, 500, 500, 500,
    500, 500, 500, 500, 500, 278, 278, 564, 564, 564, 444, 921, 722, 667, 667, 722, 611, 556, 722, 722, 333,
    389, 722, 611, 889, 722, 722, 556, 722, 667, 556, 611, 722, 722, 944, 722, 722, 611, 333, 278, 333, 469,
    500, 333, 444, 500, 444, 500, 444, 333, 500, 500, 278, 278, 500, 278, 778, 500, 500, 500, 500, 333, 389,
    278, 500, 500, 722, 500, 500, 444, 480, 200, 480, 541,
];
const ITALIC: [u16; 95] = [
    250, 333, 420, 500, 500, 833, 778, 214, 333, 333, 500, 675, 250, 333, 250, 278, 500, 500, 500, 500, 500,
    500, 500, 500, 500, 500, 333, 333, 675, 675, 675, 500, 920, 611, 611, 667, 722, 611, 611, 722, 722, 333,
    444, 667, 556, 833, 667, 722, 611, 722, 611, 500, 556, 722, 611, 833, 611, 556, 556, 389, 278, 389, 422,
    500, 333, 500, 500, 444, 500, 444, 278, 500, 500, 278, 278, 444, 278, 722, 500, 500, 500, 500, 389, 389,
    278, 500, 444, 667, 444, 444, 389, 400, 275, 400, 541,
];
const BOLD: [u16; 95] = [
    250, 333, 555, 500, 500, 1000, 833, 278, 333, 333, 500, 570, 250, 333, 250, 278, 500, 500, 500, 500, 500,
    500, 500, 500, 500, 500, 333, 333, 570, 570, 570, 500, 930, 722, 667, 722, 722, 667, 611, 778, 778, 389,
    500, 778, 667, 944, 722, 778, 611, 778, 722, 556, 667, 722, 722, 1000, 722, 722, 667, 333, 278, 333, 581,
    500, 333, 500, 556, 444, 556, 444, 333, 500, 556, 278, 333, 556, 278, 833, 556, 500, 556, 556, 444, 389,
    333, 556, 500, 722, 500, 500, 444, 394, 220, 394, 520,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_and_an_exponent_begin_at_one_place() {
        let formula = Formula::default().italic("a").scripts("12", "-1").upright("b");
        let [letter, index, exponent, next] = &formula.runs[..] else { panic!("four runs") };
        assert_eq!((letter.at, letter.size), ([0.0, 0.0], 1.0));
        assert_eq!(index.at[0], exponent.at[0]);
        assert!(index.at[1] < 0.0 && exponent.at[1] > 0.0);
        assert_eq!(exponent.text, "\u{2212}1");
        let longer = 0.7 * (width(Face::Upright, '\u{2212}') + 0.5);
        assert!((next.at[0] - index.at[0] - longer).abs() < 1e-12);
    }

    #[test]
    fn strokes_are_within_the_width() {
        let formula = Formula::default().italic("H").scripts("2", "").upright("(K, L) \u{2245} ").bold("Z");
        let end = formula.width + 0.15;
        let strokes = formula.strokes();
        assert!(strokes.iter().flat_map(|(_, line)| line).all(|&[x, _]| (-0.1..end).contains(&x)));
        assert!(strokes.len() > 12);
    }
}
