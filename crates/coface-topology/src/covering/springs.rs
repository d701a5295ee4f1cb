//! The edges of a surface as springs between the vertices of its universal cover.

use super::domain::Domain;
use coface_algebra::VertexId;
use coface_algebra::{EdgeId, Error, ErrorKind};
use coface_complexes::surface::GeneralizedMap;

/// An edge of the fundamental domain: vertex `ends[i]`, moved by the element of prefix `prefixes[i]`, at either end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spring {
    pub(super) ends: [u32; 2],
    pub(super) prefixes: [u32; 2],
    pub(super) weight: f64,
}

/// The edges of a component as springs. Its vertices are numbered anew.
///
/// One lift of each vertex is unknown, the one joined to the base by the spanning tree; position i of the domain is
/// at the lift of its vertex moved by the element of the word before it.
#[derive(Clone, Debug)]
pub(super) struct Springs {
    pub(super) springs: Vec<Spring>,
    pub(super) vertex_count: usize,
    /// The vertex at each position.
    pub(super) at_positions: Vec<u32>,
}

impl Springs {
    /// One spring for each edge, with its weight, or the weight 1. Edges on the boundary have half of it, as if the
    /// surface were doubled along the boundary: then vertices glide along the boundary as the reflection wants it.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there are as many weights as edges; [`ErrorKind::InvalidInput`] naming one that is
    /// not positive and finite.
    pub(super) fn new(map: &GeneralizedMap, domain: &Domain, weights: Option<&[f64]>) -> Result<Self, Error> {
        let edge_count = map.f_vector()[1];
        if let Some(weights) = weights {
            if weights.len() != edge_count {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!("{} weights for {edge_count} edges", weights.len()),
                ));
            }
            if let Some(edge) = weights.iter().position(|&weight| !(weight > 0.0 && weight.is_finite())) {
                return Err(Error::invalid(format!(
                    "edge {} has the weight {}",
                    EdgeId::new(edge),
                    weights[edge]
                ))
                .with_cure("give positive finite weights"));
            }
        }
        let weight = |edge: EdgeId| weights.map_or(1.0, |weights| weights[edge.index()]);
        let mut sorted: Vec<VertexId> = domain.vertices.clone();
        sorted.sort_unstable();
        sorted.dedup();
        let number = |vertex: &VertexId| sorted.binary_search(vertex).expect("the vertex is listed") as u32;
        let at_positions: Vec<u32> = domain.vertices.iter().map(number).collect();
        let spring = |positions: [usize; 2], weight: f64| Spring {
            ends: positions.map(|position| at_positions[position]),
            prefixes: positions.map(|position| domain.prefixes[position]),
            weight,
        };
        let outer = domain.sides.iter().enumerate().filter_map(|(position, side)| {
            let ends = [position, domain.after(position)];
            match side.mate {
                // The last side of a component with boundary leads from the last position to the first.
                None => Some(spring(ends, weight(side.edge) / 2.0)),
                Some(mate) => (position < mate as usize).then(|| spring(ends, weight(side.edge))),
            }
        });
        let inner = domain.inner_edges.iter().zip(&domain.inner_ends);
        let inner = inner.map(|(&edge, ends)| spring(ends.map(|end| end as usize), weight(edge)));
        let springs = outer.chain(inner).collect();
        Ok(Self { springs, vertex_count: sorted.len(), at_positions })
    }
}
