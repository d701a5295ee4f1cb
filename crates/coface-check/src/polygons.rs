//! Surfaces of polygons in OFF and OBJ: as little of these formats as files need, and a refusal for the rest.

use crate::complex::Column;
use crate::lists::Lists;
use crate::{Complex, Fault, simplices};
use std::collections::{BTreeMap, BTreeSet};

const STEP: &str = "input";

/// Points, polygons by the numbers of their points in order, and edges that the file lists by themselves.
///
/// # Examples
/// ```
/// let text = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 0.5 0\n3 0 1 2\n";
/// let surface = coface_check::Surface::read(text).expect("a triangle");
/// assert_eq!((surface.points[2], &surface.polygons[0][..]), ([0.0, 0.5, 0.0], &[0, 1, 2][..]));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Surface {
    /// The points; NaN stands for what is no number.
    pub points: Vec<[f64; 3]>,
    /// The polygons; those of OFF may name points that are not there.
    pub polygons: Vec<Vec<u32>>,
    /// Edges that are listed by themselves.
    pub edges: Vec<[u32; 2]>,
}

pub(crate) fn read(bytes: &[u8]) -> Result<Complex, Fault> {
    Surface::read(bytes)?.complex(bytes.len())
}

/// The polygons and the edges that a file lists.
pub(crate) fn cells(bytes: &[u8]) -> Result<Vec<Vec<u32>>, Fault> {
    let surface = Surface::read(bytes)?;
    Ok(surface.polygons.into_iter().chain(surface.edges.into_iter().map(|edge| edge.to_vec())).collect())
}

/// The first three words as coordinates.
fn point<'a>(mut words: impl Iterator<Item = &'a str>) -> [f64; 3] {
    [(); 3].map(|()| words.next().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN))
}

/// The lines without comments and blanks at their ends.
fn lines_of(text: &str) -> impl Iterator<Item = &str> {
    text.lines().map(|line| line.split('#').next().unwrap_or("").trim())
}

fn off(text: &str) -> Result<Surface, Fault> {
    let mut lines = lines_of(text).filter(|line| !line.is_empty());
    let mut next = || lines.next().ok_or_else(|| Fault::new(STEP, "the OFF file ends early"));
    let first = next()?;
    let counts = match first.strip_prefix("OFF").map(str::trim) {
        Some("") => next()?,
        Some(rest) => rest,
        None => return Err(Fault::new(STEP, "the OFF file does not start with OFF")),
    };
    let counts = counts.split_whitespace().map(number).collect::<Result<Vec<u32>, _>>()?;
    let [vertex_count, face_count, ..] = counts[..] else {
        return Err(Fault::new(STEP, "the OFF file has no counts"));
    };
    let mut surface = Surface::default();
    for _ in 0..vertex_count {
        let line = next()?;
        if line.split_whitespace().count() != 3 {
            return Err(Fault::new(STEP, format!("{line:.40?} is not three coordinates")));
        }
        surface.points.push(point(line.split_whitespace()));
    }
    for _ in 0..face_count {
        let mut words = next()?.split_whitespace();
        let count = number(words.next().unwrap_or(""))? as usize;
        let polygon = words.by_ref().take(count).map(number).collect::<Result<Vec<u32>, _>>()?;
        if polygon.len() != count {
            return Err(Fault::new(STEP, "a face of the OFF file has fewer vertices than it says"));
        }
        surface.polygons.push(polygon);
    }
    match lines.next() {
        None => Ok(surface),
        Some(line) => Err(Fault::new(STEP, format!("{line:.40?} stands behind the last face"))),
    }
}

fn obj(text: &str) -> Result<Surface, Fault> {
    let mut surface = Surface::default();
    for line in lines_of(text) {
        let mut words = line.split_whitespace();
        let Some(key) = words.next() else { continue };
        let vertex = |word: &str| corner(word, surface.points.len());
        match key {
            _ if line.ends_with('\\') => {
                return Err(Fault::new(STEP, "a line of the OBJ file goes on in the next"));
            }
            "v" => surface.points.push(point(words)),
            "f" => {
                let polygon = words.map(vertex).collect::<Result<_, _>>()?;
                surface.polygons.push(polygon);
            }
            "l" => {
                let line = words.map(vertex).collect::<Result<Vec<u32>, _>>()?;
                surface.edges.extend(line.windows(2).map(|pair| [pair[0], pair[1]]));
            }
            "vt" | "vn" | "g" | "o" | "s" | "usemtl" | "mtllib" => (),
            _ => return Err(Fault::new(STEP, format!("{line:.40?} is no line that the checker knows"))),
        }
    }
    Ok(surface)
}

/// The vertex of a corner such as `3/1/2`, which counts from 1, or from the last vertex down from -1.
fn corner(word: &str, vertex_count: usize) -> Result<u32, Fault> {
    let fault = || Fault::new(STEP, format!("{word:.40?} is no vertex so far"));
    let given: i64 = word.split('/').next().unwrap_or("").parse().map_err(|_| fault())?;
    let position = if given < 0 { vertex_count as i64 + given } else { given - 1 };
    let is_there = (0..vertex_count as i64).contains(&position);
    u32::try_from(position).ok().filter(|_| is_there).ok_or_else(fault)
}

fn number(word: &str) -> Result<u32, Fault> {
    word.parse().map_err(|_| Fault::new(STEP, format!("{word:.40?} is not a number from 0")))
}

impl Surface {
    /// The surface in an OFF or OBJ file.
    ///
    /// # Errors
    /// A [`Fault`] for another file, or lines that the checker does not know.
    ///
    /// # Examples
    /// See [`Surface`].
    pub fn read(bytes: &[u8]) -> Result<Self, Fault> {
        let text =
            std::str::from_utf8(bytes).map_err(|_| Fault::new(STEP, "the checker reads text, not this"))?;
        let first = lines_of(text).find(|line| !line.is_empty());
        if first.is_some_and(|line| line.starts_with("OFF")) { off(text) } else { obj(text) }
    }

    fn complex(self, size: usize) -> Result<Complex, Fault> {
        let mut seen = BTreeSet::new();
        let (mut are_triangles, mut repeated) = (true, None);
        let mut facets = Vec::new();
        for (i, polygon) in self.polygons.iter().enumerate() {
            let mut vertices = polygon.clone();
            vertices.sort_unstable();
            let is_plain = vertices.windows(2).all(|pair| pair[0] < pair[1]);
            if polygon.len() < 3 || !is_plain || vertices.iter().any(|v| *v as usize >= self.points.len()) {
                let message =
                    format!("face {i} has fewer than three vertices, one twice, or one that is not there");
                return Err(Fault::new(STEP, message));
            }
            are_triangles &= polygon.len() == 3;
            if !seen.insert(vertices.clone()) {
                repeated = Some(i);
            }
            facets.push(vertices);
        }
        // Equal triangles are one simplex; whether equal polygons are one cell or two, the file does not say.
        if let Some(i) = repeated.filter(|_| !are_triangles) {
            return Err(Fault::new(STEP, format!("face {i} has the vertices of another face")));
        }
        if self.edges.iter().any(|[a, b]| a == b) {
            return Err(Fault::new(STEP, "an edge has one vertex twice"));
        }
        if are_triangles {
            facets.extend(self.edges.iter().map(|[a, b]| vec![*a.min(b), *a.max(b)]));
            let vertices: Vec<u32> = (0..self.points.len()).filter_map(|v| u32::try_from(v).ok()).collect();
            return simplices::of_facets(&facets, &vertices, size);
        }
        let sides = |polygon: &[u32]| -> Vec<[u32; 2]> {
            let next = polygon.iter().cycle().skip(1);
            polygon.iter().zip(next).map(|(a, b)| [*a, *b]).collect()
        };
        let all = self.polygons.iter().flat_map(|polygon| sides(polygon)).chain(self.edges.iter().copied());
        let mut numbers: BTreeMap<[u32; 2], u32> = all.map(|[a, b]| ([a.min(b), a.max(b)], 0)).collect();
        numbers.values_mut().zip(0..).for_each(|(number, i)| *number = i);
        let edges = numbers.keys().map(|[a, b]| [(*a, -1), (*b, 1)]).collect();
        let faces: Lists<(u32, i64)> = self
            .polygons
            .iter()
            .map(|polygon| {
                let side = |[a, b]: [u32; 2]| (numbers[&[a.min(b), a.max(b)]], if a < b { 1 } else { -1 });
                let mut column: Column = sides(polygon).into_iter().map(side).collect();
                column.sort_unstable();
                column
            })
            .collect();
        let counts = vec![self.points.len(), numbers.len(), faces.len()];
        let vertices = (0..self.points.len() as u32).map(|vertex| [vertex]).collect();
        let polygons = self.polygons.into_iter().collect();
        let names = vec![vertices, numbers.keys().copied().collect(), polygons];
        Ok(Complex::new(counts, vec![edges, faces], Some(names)))
    }
}
