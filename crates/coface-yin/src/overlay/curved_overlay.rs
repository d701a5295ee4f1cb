//! Boundaries laid over each other, and the faces between them.

use super::boundaries::Boundaries;
use super::chains::{Chains, undecided};
use super::departures::Departures;
use super::nesting::Nester;
use super::nodes::Nodes;
use crate::UncertifiedDecision;
use crate::meetings::Meetings;
use crate::set::CurveArena;
use coface_algebra::Error;
use coface_arrange::planar::{Faces, Orbits, RingCells, Windings};
use std::cmp::Ordering;

/// The curves of several arenas laid over each other. A region is what one arena bounds.
pub(crate) struct CurvedOverlay<'a> {
    pub(super) boundaries: Boundaries<'a>,
    pub(super) nodes: Nodes,
    pub(super) cells: RingCells,
    pub(super) report: Vec<UncertifiedDecision>,
}

impl<'a> CurvedOverlay<'a> {
    /// The overlay at the usual resolution.
    ///
    /// # Errors
    /// As [`Self::at_coarseness`].
    pub(crate) fn new(arenas: &[&'a CurveArena]) -> Result<Self, Error> {
        Self::at_coarseness(arenas, 1.0)
    }

    /// The overlay at so many times the usual resolution.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a place at which the resolution does not tell how curves
    /// run, and the pieces there; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for more than 2^28 pieces.
    ///
    /// # Complexity
    /// $O((n + k) \log (n + k))$ for n pieces that meet k times, where boxes of pieces seldom meet otherwise.
    pub(crate) fn at_coarseness(arenas: &[&'a CurveArena], coarseness: f64) -> Result<Self, Error> {
        let boundaries = Boundaries::new(arenas, coarseness)?;
        let mut report = Vec::new();
        let Meetings { points, overlaps, exhausted, depth } = Meetings::of(&boundaries.carriers, coarseness)?;
        if let Some(&pieces) = exhausted.first() {
            let place = boundaries.controls(pieces[0])[0];
            return Err(undecided(
                &boundaries,
                "what pieces have in common that run side by side",
                place,
                pieces,
            ));
        }
        let nodes = Nodes::new(&boundaries, &points, &overlaps, &mut report);
        drop(points);
        let chains = Chains { boundaries: &boundaries, nodes: &nodes };
        let edges = chains.edges(&overlaps, &mut report)?;
        let departures = Departures::new(&chains, &edges);
        let orbits = Orbits::in_order(nodes.points.len(), edges.ends(), |list, scratch| {
            departures.order(list, scratch);
        });
        departures.finish(&mut report)?;
        check_plane(&chains, &orbits, edges.ends())?;
        let nester = Nester { chains: &chains, edges: &edges, orbits: &orbits, depth };
        let nesting = nester.nesting()?;
        let orbits = orbits.with_outer_orbits(nesting.outer_orbits);
        let faces = Faces::new(&orbits, &nesting.below, 0..nesting.below.len());
        let step = |halfedge: u32, list: &mut Vec<(u32, i32)>| {
            for &chain in edges.chains().list(halfedge as usize / 2) {
                let is_along = edges.halfedge_of_chain()[chain as usize] == halfedge;
                let arena = boundaries.arena_of(chains.curve_of(chain));
                list.push((arena, if is_along { 1 } else { -1 }));
            }
        };
        let windings = Windings::new(&orbits, &faces, step)?;
        report.sort_by(|a, b| {
            let key =
                |own: &UncertifiedDecision| own.pieces.map(|part| (part.operand, part.curve, part.piece));
            let place = || a.point.partial_cmp(&b.point).unwrap_or(Ordering::Equal);
            key(a).cmp(&key(b)).then_with(place)
        });
        let found = Self { cells: RingCells::new(edges, orbits, faces, windings), boundaries, nodes, report };
        found.check_windings()?;
        Ok(found)
    }

    pub(super) fn chains(&self) -> Chains<'_> {
        Chains { boundaries: &self.boundaries, nodes: &self.nodes }
    }

    /// The point of a node.
    pub(crate) fn node_point(&self, node: u32) -> [f64; 2] {
        self.nodes.points[node as usize]
    }

    /// The error for an edge at which what was found contradicts itself.
    pub(super) fn contradiction(&self, what: &str, halfedge: u32) -> Error {
        let chains = self.chains();
        let own = self.cells.edges().chains().list(halfedge as usize / 2);
        let pieces = own.iter().map(|&chain| self.nodes.breaks[chain as usize].leave.piece);
        undecided(chains.boundaries, what, self.node_point(self.cells.tail(halfedge)), pieces)
    }

    /// # Errors
    /// If the winding numbers on the sides of an edge do not differ by what runs along it.
    fn check_windings(&self) -> Result<(), Error> {
        let chains = self.chains();
        let mut sum: Vec<(u32, i32)> = Vec::new();
        for edge in 0..self.cells.edges().ends().len() as u32 {
            sum.clear();
            let [left, right] =
                [2 * edge, 2 * edge + 1].map(|h| self.cells.windings().of_face(self.cells.face(h)));
            sum.extend_from_slice(left);
            sum.extend(right.iter().map(|&(region, winding)| (region, -winding)));
            for &chain in self.cells.edges().chains().list(edge as usize) {
                let is_along = self.cells.edges().halfedge_of_chain()[chain as usize].is_multiple_of(2);
                sum.push((self.boundaries.arena_of(chains.curve_of(chain)), if is_along { -1 } else { 1 }));
            }
            sum.sort_unstable();
            let is_zero =
                |own: &[(u32, i32)]| own.iter().map(|&(_, winding)| i64::from(winding)).sum::<i64>() == 0;
            if !sum.chunk_by(|a, b| a.0 == b.0).all(is_zero) {
                return Err(self.contradiction("on which side of a curve the set is", 2 * edge));
            }
        }
        Ok(())
    }

    /// Checks that each region is there once or not at all on each side, as it is where its curves are almost disjoint.
    ///
    /// # Errors
    /// Naming a place where that is not so.
    pub(crate) fn check_regions(&self, is_unbounded: &[bool]) -> Result<(), Error> {
        match self.wrong_halfedge(is_unbounded) {
            None => Ok(()),
            Some(halfedge) => {
                Err(self.contradiction("on which side of the boundary of a set it is", halfedge))
            }
        }
    }

    /// A halfedge with a face on its left around which a region winds as none does whose curves are almost disjoint.
    pub(super) fn wrong_halfedge(&self, is_unbounded: &[bool]) -> Option<u32> {
        (0..self.cells.orbits().halfedge_count() as u32).find(|&halfedge| {
            let around = self.cells.windings().of_face(self.cells.face(halfedge));
            around.iter().any(|&(region, winding)| {
                !(0..=1).contains(&(winding + i32::from(is_unbounded[region as usize])))
            })
        })
    }
}

/// # Errors
/// If the order of edges around nodes has no drawing in the plane: vertices - edges + orbits is not 2 for each component.
fn check_plane(chains: &Chains<'_>, orbits: &Orbits, ends: &[[u32; 2]]) -> Result<(), Error> {
    let mut characteristic = vec![0i64; orbits.lowest_vertices().len()];
    for &component in orbits.component_of() {
        characteristic[component as usize] += 1;
    }
    let component_of = |halfedge: u32| {
        orbits.component_of()[ends[halfedge as usize / 2][halfedge as usize % 2] as usize] as usize
    };
    for edge in 0..ends.len() as u32 {
        characteristic[component_of(2 * edge)] -= 1;
    }
    for orbit in orbits.lists().iter() {
        characteristic[component_of(orbit[0])] += 1;
    }
    let Some(component) = characteristic.iter().position(|&own| own != 2) else { return Ok(()) };
    // A node at which curves meet.
    let node = (0..orbits.component_of().len())
        .find(|&node| {
            orbits.component_of()[node] as usize == component && orbits.rotation().list(node).len() > 2
        })
        .unwrap_or(orbits.lowest_vertices()[component] as usize);
    let pieces = (0..chains.nodes.breaks.len())
        .filter(|&chain| chains.nodes.breaks[chain].node as usize == node)
        .map(|chain| chains.nodes.breaks[chain].leave.piece);
    Err(undecided(chains.boundaries, "how curves cross", chains.nodes.points[node], pieces))
}
