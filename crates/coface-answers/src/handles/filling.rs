//! Handles filled, the shortest first.

use super::cutting::Workpiece;
use super::triangle_surface::TriangleSurface;
use super::{kind_of, path_of};
use crate::answer::{
    FilledHandle, FilledHandlesAnswer, HandleCounts, LeftHandle, LoopKind, Remark, RemarkCode,
};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::surface::linking_terms;
use coface_io::Model;
use coface_topology::short_handle_loops;
use std::collections::BTreeMap;

/// How many vertices the searches of one round may reach in all.
const MOST_REACHED: usize = 30_000_000;
/// The first loops that are looked for are below this many edges of middle length.
const FIRST_EDGES: f64 = 8.0;

/// How handles are filled.
///
/// # Examples
/// ```
/// use coface_answers::FillHandlesRequest;
/// assert_ne!(FillHandlesRequest::new().shorter_than(2.0), FillHandlesRequest::new());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FillHandlesRequest {
    shorter_than: f64,
}

impl Default for FillHandlesRequest {
    fn default() -> Self {
        Self { shorter_than: f64::INFINITY }
    }
}

impl FillHandlesRequest {
    /// Fills all handles.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::FillHandlesRequest;
    /// assert_eq!(FillHandlesRequest::new(), FillHandlesRequest::default());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Fills only handles with a handle loop or tunnel loop shorter than this, in the unit of the positions.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::FillHandlesRequest;
    /// assert_ne!(FillHandlesRequest::new().shorter_than(2.0), FillHandlesRequest::new());
    /// ```
    #[must_use]
    pub fn shorter_than(mut self, length: f64) -> Self {
        self.shorter_than = length;
        self
    }

    /// Cuts a closed surface in space along its short handle loops and tunnel loops and fills both rims of each cut with triangles, until no
    /// such loop is left; gives the surface of triangles that this makes, and what was done.
    ///
    /// The shortest loops come first, of either kind. One rim of a cut keeps the vertices of the loop, the other one is moved a small part of the
    /// way to the neighbors of its vertices. The patches are triangles of least area, without those that meet anything: this is
    /// decided exactly for every triangle that is moved or added. A loop that has no such patches is listed as left. Vertices of the
    /// given surface keep their numbers, and so do its faces if they are triangles.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for models that are no polygons; [`ErrorKind::InvalidInput`] for a length that is negative or not a number,
    /// without three coordinates a vertex, and for a surface that meets itself; [`ErrorKind::NonManifold`] for what is no closed
    /// orientable surface.
    ///
    /// # Complexity
    /// A few rounds, each of the time of [`short_handle_loops`], and $O(k^3)$ for each loop of k edges.
    ///
    /// # References
    /// I. Guskov, Z. Wood, *Topological noise removal* (2001); Z. Wood, H. Hoppe, M. Desbrun, P. Schröder, *Removing excess topology from
    /// isosurfaces* (2004), for filling along short loops; G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995).
    ///
    /// # Examples
    /// A torus becomes a sphere.
    /// ```
    /// use coface_answers::FillHandlesRequest;
    /// use coface_complexes::shapes;
    /// use coface_io::Model;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (positions, triangles) = shapes::csaszar_torus()?.into_parts();
    /// let torus = Model::from_polygons(positions, triangles)?;
    /// let (_, done) = FillHandlesRequest::new().shorter_than(0.1).filled(&torus, "torus")?;
    /// assert_eq!((done.before.genus, done.after.genus), (1, 1));
    /// # Ok(()) }
    /// ```
    pub fn filled(&self, model: &Model, file: &str) -> Result<(Model, FilledHandlesAnswer), Error> {
        if self.shorter_than.is_nan() || self.shorter_than < 0.0 {
            return Err(Error::invalid(format!("{} is no length", self.shorter_than))
                .with_cure("give a length that is not negative"));
        }
        let mut work = Work::new(TriangleSurface::of(model)?)?;
        let before = work.counts.clone();
        work.run(self.shorter_than)?;
        work.surface.check_meetings().map_err(|_| {
            Error::new(ErrorKind::InvalidInput, "the filled surface meets itself")
                .with_cure("please report this model as a fault of coface")
        })?;
        let mut remarks = work.surface.remarks();
        // Where no handle is left, loops that had no patch have become trivial by others that were filled.
        let left: Vec<LeftHandle> =
            if work.counts.genus == 0 { Vec::new() } else { work.left.into_values().collect() };
        if !left.is_empty() {
            let count = crate::text::count(left.len(), "loop");
            let message = format!(
                "on {count} below the length no patch fits that meets no other triangle; the genus is {}",
                work.counts.genus
            );
            remarks.push(Remark::new(RemarkCode::HandlesLeft, message).at(left.len(), []));
        } else if !work.is_complete && work.counts.genus > 0 {
            remarks.push(Remark::new(
                RemarkCode::HandlesLeft,
                "not all loops below the length were looked for, as the surface is too large; fill what was written again",
            ));
        }
        let answer = FilledHandlesAnswer {
            file: file.to_owned(),
            shorter_than: Some(self.shorter_than).filter(|length| length.is_finite()),
            before,
            after: work.counts,
            filled: work.filled,
            left,
            remarks,
        };
        Ok((work.surface.into_model()?, answer))
    }
}

/// A surface on its way.
struct Work {
    surface: TriangleSurface,
    counts: HandleCounts,
    filled: Vec<FilledHandle>,
    /// The loops that could not be filled, by their vertices, rising.
    left: BTreeMap<Vec<u32>, LeftHandle>,
    /// Whether the last round looked for all loops.
    is_complete: bool,
}

/// What a round found.
struct Round {
    filled: usize,
    /// Whether there were as many independent loops as there are.
    has_all: bool,
}

impl Work {
    fn new(surface: TriangleSurface) -> Result<Self, Error> {
        let counts = surface.counts(&surface.map()?);
        Ok(Self { surface, counts, filled: Vec::new(), left: BTreeMap::new(), is_complete: true })
    }

    /// Fills loops, with lengths below a bound that grows to the one that was asked for.
    fn run(&mut self, shorter_than: f64) -> Result<(), Error> {
        let steps = stage("filling handles", self.counts.genus);
        let lengths = self.surface.lengths(&self.surface.map()?)?;
        let total: f64 = lengths.iter().sum();
        let mut below = FIRST_EDGES * total / lengths.len().max(1) as f64;
        loop {
            below = below.min(shorter_than);
            loop {
                if self.counts.genus == 0 {
                    return Ok(());
                }
                let round = self.round(below)?;
                steps.advance(round.filled);
                if round.filled > 0 {
                    continue;
                }
                if round.has_all {
                    return Ok(());
                }
                break;
            }
            if below >= shorter_than || below > total {
                return Ok(());
            }
            below *= 2.0;
        }
    }

    /// Fills loops that are far enough from each other.
    fn round(&mut self, below: f64) -> Result<Round, Error> {
        let map = self.surface.map()?;
        let positions = self.surface.positions();
        let lengths = self.surface.lengths(&map)?;
        let linking = |edges: &[_]| linking_terms(&map, &positions, edges);
        let found = short_handle_loops(&map, Some(&lengths), &linking, below, MOST_REACHED)?;
        self.is_complete = found.is_complete();
        let has_all = found.loops().len() == 2 * self.counts.genus;
        let mut filled = Vec::new();
        let mut piece = Workpiece::new(&mut self.surface);
        for (kind, cycle) in found.loops() {
            let kind = kind_of(*kind);
            let mut vertices: Vec<u32> =
                cycle.walk().vertices(map.skeleton()).into_iter().map(|vertex| vertex.to_u32()).collect();
            vertices.pop();
            let mut key = vertices.clone();
            key.sort_unstable();
            if self.left.contains_key(&key) || piece.is_touched(&vertices) {
                continue;
            }
            match piece.filled(&vertices)? {
                Some(filling) => {
                    piece.apply(&filling);
                    filled.push((kind, filling));
                }
                None => {
                    self.left.insert(
                        key,
                        LeftHandle { kind, path: path_of(&vertices, cycle.length(), |vertex| vertex) },
                    );
                }
            }
        }
        let count = filled.len();
        self.note(filled);
        if count > 0 {
            self.counts = self.surface.counts(&self.surface.map()?);
        }
        Ok(Round { filled: count, has_all })
    }

    fn note(&mut self, fillings: Vec<(LoopKind, super::cutting::Filling)>) {
        let surface = &self.surface;
        let number = |vertex: u32| surface.number_of(vertex);
        for (kind, filling) in fillings {
            let corners = filling.vertices.iter().map(|&vertex| surface.points[vertex as usize]);
            let points: Vec<[f64; 3]> = corners.collect();
            let length = (0..points.len()).map(|i| distance(points[i], points[(i + 1) % points.len()])).sum();
            let first = filling.added[filling.added.len() / 2..].iter().flatten().min().copied().unwrap_or(0);
            let added_vertices = (first..).take(points.len()).map(number).collect();
            self.filled.push(FilledHandle {
                kind,
                path: path_of(&filling.vertices, length, number),
                added_vertices,
                added_triangles: filling.added.len(),
            });
        }
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis])).sum::<f64>().sqrt()
}
