//! Handle loops and tunnel loops of closed surfaces in space, and surfaces without their short handles.

mod cutting;
mod filling;
mod patch;
#[cfg(test)]
mod tests;
mod triangle_surface;

pub use filling::FillHandlesRequest;

use crate::answer::{ClosedPath, HandleAnswer, HandlesAnswer, LoopKind};
use coface_algebra::Error;
use coface_complexes::surface::linking_terms;
use coface_io::Model;
use coface_topology::{HandleKind, ShortestCycle, handle_pairs};
use triangle_surface::TriangleSurface;

/// How many vertices searches may reach in all.
const MOST_REACHED: usize = 40_000_000;

/// A request for the handles of closed surfaces in space.
///
/// # Examples
/// ```
/// use coface_answers::HandlesRequest;
/// assert_ne!(HandlesRequest::new().shorter_than(Some(2.0)), HandlesRequest::new());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HandlesRequest {
    shorter_than: Option<f64>,
}

impl HandlesRequest {
    /// Asks for all handles.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::HandlesRequest;
    /// assert_eq!(HandlesRequest::new(), HandlesRequest::default());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Lists only handles whose shorter loop is shorter than this, in the unit of the positions.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::HandlesRequest;
    /// assert_ne!(HandlesRequest::new().shorter_than(Some(2.0)), HandlesRequest::new());
    /// ```
    #[must_use]
    pub fn shorter_than(mut self, length: Option<f64>) -> Self {
        self.shorter_than = length;
        self
    }

    /// The handles of a model, each by a short handle loop and a short tunnel loop. Faces with more than three corners are cut into triangles
    /// first, so loops may run over diagonals of them.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] for models that are no polygons; [`coface_algebra::ErrorKind::InvalidInput`] without three
    /// coordinates a vertex, for a surface that meets itself, and for a length that is negative or not a number;
    /// [`coface_algebra::ErrorKind::NonManifold`] for what is no closed orientable surface.
    ///
    /// # Complexity
    /// That of [`handle_pairs`], and $O(n \log n)$ for the triangles that meet.
    ///
    /// # References
    /// Those of [`handle_pairs`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::HandlesRequest;
    /// use coface_complexes::shapes;
    /// use coface_io::Model;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (positions, triangles) = shapes::csaszar_torus()?.into_parts();
    /// let torus = Model::from_polygons(positions, triangles)?;
    /// let answer = HandlesRequest::new().found(&torus, "torus")?;
    /// assert_eq!((answer.genus, answer.handles.len()), (1, 1));
    /// assert!(answer.handles[0].length <= answer.handles[0].tunnel.length);
    /// # Ok(()) }
    /// ```
    pub fn found(&self, model: &Model, file: &str) -> Result<HandlesAnswer, Error> {
        if self.shorter_than.is_some_and(|length| length.is_nan() || length < 0.0) {
            return Err(Error::invalid("a length is negative or not a number")
                .with_cure("give a length that is not negative"));
        }
        let surface = TriangleSurface::of(model)?;
        let map = surface.map()?;
        let positions = surface.positions();
        let lengths = surface.lengths(&map)?;
        let linking = |edges: &[_]| linking_terms(&map, &positions, edges);
        let pairs = handle_pairs(&map, Some(&lengths), &linking, MOST_REACHED)?;
        let path = |cycle: &ShortestCycle| {
            let vertices: Vec<u32> =
                cycle.walk().vertices(map.skeleton()).into_iter().map(|vertex| vertex.to_u32()).collect();
            path_of(&vertices[..vertices.len() - 1], cycle.length(), |vertex| surface.number_of(vertex))
        };
        let is_listed = |length: f64| self.shorter_than.is_none_or(|most| length < most);
        let listed = pairs.iter().filter(|pair| is_listed(pair.length()));
        let handles = listed.map(|pair| HandleAnswer {
            component: pair.component(),
            shorter: kind_of(pair.shorter()),
            length: pair.length(),
            handle: path(pair.handle()),
            tunnel: path(pair.tunnel()),
        });
        Ok(HandlesAnswer {
            file: file.to_owned(),
            genus: pairs.len(),
            shorter_than: self.shorter_than,
            handles: handles.collect(),
            remarks: surface.remarks(),
        })
    }
}

fn kind_of(kind: HandleKind) -> LoopKind {
    match kind {
        HandleKind::Handle => LoopKind::Handle,
        HandleKind::Tunnel => LoopKind::Tunnel,
    }
}

/// A closed path through some vertices and back to the first one.
fn path_of(vertices: &[u32], length: f64, number: impl Fn(u32) -> u32) -> ClosedPath {
    let closed = vertices.iter().chain(vertices.first());
    ClosedPath { length, vertices: closed.map(|&vertex| number(vertex)).collect() }
}
