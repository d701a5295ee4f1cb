//! Drawings: the segments of all inputs, and the rings that bound the region of each.

use crate::{geojson, wkt};
use coface_check::Fault;

/// A closed walk of segments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ring {
    pub(crate) polygon: u32,
    pub(crate) is_hole: bool,
}

/// A polygon of an input.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polygon {
    /// The input that it is of.
    pub(crate) region: u32,
    /// Whether it is made of lines without directions, of which parities count.
    pub(crate) is_of_lines: bool,
}

/// The segments of all inputs in their order, with the ring that each is of.
///
/// # Examples
/// ```
/// let drawing = coface_check_plane::Drawing::read(&[b"POLYGON ((0 0, 2 0, 0 2, 0 0))", b"0,0,1,1"]).expect("two drawings");
/// assert_eq!(drawing.segments().len(), 4);
/// assert_eq!(drawing.segments()[3], [[0.0, 0.0], [1.0, 1.0]]);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    segments: Vec<[[f64; 2]; 2]>,
    rings_of_segments: Vec<Option<u32>>,
    pub(crate) rings: Vec<Ring>,
    pub(crate) polygons: Vec<Polygon>,
    pub(crate) region_count: usize,
}

impl Drawing {
    /// The drawing of inputs: WKT, GeoJSON, or lines of four numbers separated by commas or blanks, each the ends of a segment. A segment
    /// whose ends are equal is one too. Each input is one region. Rings of polygons are closed where they are not. Segments without polygons
    /// in lines of numbers bound what they enclose an odd number of times, if no end of them is loose.
    ///
    /// # Errors
    /// A [`Fault`] for another format, or a coordinate that is not finite.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// See [`Drawing`].
    pub fn read(inputs: &[&[u8]]) -> Result<Self, Fault> {
        let step = "input";
        let mut drawing = Self::default();
        for input in inputs {
            let text = std::str::from_utf8(input).map_err(|_| Fault::new(step, "this is no text"))?;
            let text = text.trim_start_matches('\u{feff}').trim();
            drawing.region_count += 1;
            match text.chars().next() {
                None => {}
                Some('{') => geojson::read(text, &mut drawing)?,
                Some(first) if first.is_ascii_alphabetic() => wkt::read(text, &mut drawing)?,
                Some(_) => drawing.read_lines(text)?,
            }
        }
        let far = drawing.segments.iter().flatten().flatten().any(|x| !x.is_finite());
        if far { Err(Fault::new(step, "a coordinate is not finite")) } else { Ok(drawing) }
    }

    /// The ends of the segments.
    ///
    /// # Examples
    /// See [`Drawing`].
    pub fn segments(&self) -> &[[[f64; 2]; 2]] {
        &self.segments
    }

    /// The ring that a segment is of.
    pub(crate) fn ring_of(&self, segment: usize) -> Option<u32> {
        self.rings_of_segments[segment]
    }

    /// A line through these points.
    pub(crate) fn line(&mut self, points: &[[f64; 2]]) {
        self.path(points, None);
    }

    /// A polygon: its outer ring, then its holes.
    pub(crate) fn polygon(&mut self, rings: &[Vec<[f64; 2]>]) {
        if rings.iter().all(Vec::is_empty) {
            return;
        }
        self.polygons.push(Polygon { region: self.region_count as u32 - 1, is_of_lines: false });
        for (i, ring) in rings.iter().enumerate() {
            self.rings.push(Ring { polygon: self.polygons.len() as u32 - 1, is_hole: i > 0 });
            let mut closed = ring.clone();
            if closed.first() != closed.last() {
                closed.extend(ring.first());
            }
            self.path(&closed, Some(self.rings.len() as u32 - 1));
        }
    }

    fn path(&mut self, points: &[[f64; 2]], ring: Option<u32>) {
        for ends in points.windows(2) {
            self.segments.push([ends[0], ends[1]]);
            self.rings_of_segments.push(ring);
        }
    }

    fn read_lines(&mut self, text: &str) -> Result<(), Fault> {
        let first = self.segments.len();
        for (number, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let words = line.split(|letter: char| letter == ',' || letter.is_whitespace());
            let numbers: Result<Vec<f64>, _> =
                words.filter(|word| !word.is_empty()).map(str::parse).collect();
            match numbers.as_deref() {
                Ok([a, b, c, d]) => self.line(&[[*a, *b], [*c, *d]]),
                _ => return Err(Fault::new("input", format!("line {} is not four numbers", number + 1))),
            }
        }
        // Zeros of both signs are equal.
        let place = |point: &[f64; 2]| point.map(|x| (x + 0.0).to_bits());
        let mut ends: Vec<[u64; 2]> = self.segments[first..].iter().flatten().map(place).collect();
        ends.sort_unstable();
        if !ends.is_empty() && ends.chunk_by(|a, b| a == b).all(|same| same.len() % 2 == 0) {
            self.polygons.push(Polygon { region: self.region_count as u32 - 1, is_of_lines: true });
            self.rings.push(Ring { polygon: self.polygons.len() as u32 - 1, is_hole: false });
            self.rings_of_segments[first..].fill(Some(self.rings.len() as u32 - 1));
        }
        Ok(())
    }
}
