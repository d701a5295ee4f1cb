//! Whether edges meet where they should not.

use super::InterfaceGraph;
use crate::boolean::first_covering;
use crate::set::CurveArena;
use crate::{Curve, YinSet};
use coface_algebra::Error;
use coface_geometry::Sum;
use std::fmt;

/// Edges of an interface that meet otherwise than at their ends, by what that makes of the phases.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct InterfaceFault {
    pub(crate) phases: Vec<u32>,
    pub(crate) point: Option<[f64; 2]>,
    pub(crate) area: Option<f64>,
}

impl InterfaceFault {
    /// The phases that lie over each other at a place, rising; one phase lies over itself, or what is outside of it does.
    pub fn phases(&self) -> &[u32] {
        &self.phases
    }

    /// A point of the place.
    pub fn point(&self) -> Option<[f64; 2]> {
        self.point
    }

    /// The area of all such places; none if it is infinite.
    pub fn area(&self) -> Option<f64> {
        self.area
    }
}

impl fmt::Display for InterfaceFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.phases[..] {
            [phase] => write!(f, "edges around phase {phase} cross")?,
            [first, second, ..] => write!(f, "phases {first} and {second} overlap")?,
            [] => f.write_str("edges cross")?,
        }
        if let Some([x, y]) = self.point {
            write!(f, " at ({x}, {y})")?;
        }
        match self.area {
            Some(area) => write!(f, ", in an area of {area}"),
            None => f.write_str(", in an infinite area"),
        }
    }
}

impl InterfaceFault {
    pub(crate) fn into_error(self) -> Error {
        Error::invalid(self.to_string())
    }
}

impl InterfaceGraph {
    /// Whether edges meet otherwise than at their ends, so that phases overlap or lie on the wrong side of edges: none if the phases
    /// fit together. Edges may touch.
    ///
    /// # Errors
    /// If the edges cannot be laid over each other.
    ///
    /// # Complexity
    /// That of an overlay of the boundaries of all phases.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = |markers: Vec<[f64; 2]>| InterfaceEdge { ends: [0, 0], markers, phases: [Some(0), None] };
    /// let good = edge(vec![[2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    /// let crossed = edge(vec![[2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]);
    /// let fault = |edge| InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?.fault();
    /// assert_eq!(fault(good)?, None);
    /// assert_eq!(fault(crossed)?.map(|fault| fault.area()), Some(Some(1.0)));
    /// # Ok(()) }
    /// ```
    pub fn fault(&self) -> Result<Option<InterfaceFault>, Error> {
        let phases = self.phases();
        let sets =
            phases.iter().map(|&phase| self.unchecked_set(phase)).collect::<Result<Vec<_>, Error>>()?;
        let operands: Vec<&YinSet> = sets.iter().collect();
        let is_unbounded: Vec<bool> = sets.iter().map(|set| !set.is_bounded()).collect();
        let unbounded_count = is_unbounded.iter().filter(|is| **is).count() as i32;
        let is_wrong = |windings: &[(u32, i32)]| {
            let depth = |&(phase, winding): &(u32, i32)| winding + i32::from(is_unbounded[phase as usize]);
            let total = unbounded_count + windings.iter().map(|&(_, winding)| winding).sum::<i32>();
            total > 1 || windings.iter().any(|own| !(0..=1).contains(&depth(own)))
        };
        let Some(found) = first_covering(&operands, is_wrong)? else { return Ok(None) };
        let mut around: Vec<(u32, i32)> = found.windings.clone();
        let known: Vec<u32> = around.iter().map(|&(phase, _)| phase).collect();
        around.extend(
            (0..)
                .zip(&is_unbounded)
                .filter(|(_, is)| **is)
                .map(|(phase, _)| (phase, 0))
                .filter(|(phase, _)| !known.contains(phase)),
        );
        let depth = |&(phase, winding): &(u32, i32)| winding + i32::from(is_unbounded[phase as usize]);
        let mut wrong: Vec<u32> =
            around.iter().filter(|own| !(0..=1).contains(&depth(own))).map(|&(phase, _)| phase).collect();
        if wrong.is_empty() {
            wrong = around.iter().filter(|own| depth(own) == 1).map(|&(phase, _)| phase).collect();
        }
        wrong.sort_unstable();
        let named = wrong.into_iter().map(|number| phases[number as usize]).collect();
        Ok(Some(InterfaceFault { phases: named, point: found.point, area: found.area.map(f64::abs) }))
    }

    /// A phase as a set, without a look at how its curves lie. It is unbounded if they enclose a negative area.
    pub(crate) fn unchecked_set(&self, phase: u32) -> Result<YinSet, Error> {
        self.unchecked_region(Some(phase))
    }

    /// The same, also of what is in no phase.
    pub(crate) fn unchecked_region(&self, phase: Option<u32>) -> Result<YinSet, Error> {
        let mut arena = CurveArena::new(self.order());
        let mut area = Sum::default();
        for walk in self.walks_of(phase) {
            let curve: Curve<'static> = self.walk_curve(&walk)?;
            area.add(curve.signed_area());
            arena.push(&curve);
        }
        let parents = vec![None; arena.len()];
        Ok(YinSet::from_parts(arena, area.value() < 0.0, parents, Vec::new()))
    }
}
