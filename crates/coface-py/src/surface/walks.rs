//! Closed walks on surfaces compared, and walks around vertices.

use crate::errors::no_place;
use coface::answers::SurfaceModel;
use coface::complexes::surface::GeneralizedMap;
use coface::topology::{ClosedWalk, SurfaceHomology, SurfaceHomotopy, TreeCotree};
use coface::{Error, HalfedgeId, VertexId};
use pyo3::prelude::*;
use serde::Serialize;

/// What is known of a closed walk among others.
#[derive(Serialize)]
pub(super) struct ComparedWalk {
    contractible: bool,
    bounds: bool,
    class: Vec<i64>,
    component: Option<usize>,
    word: Vec<i32>,
    homotopic: Vec<usize>,
    freely_homotopic: Vec<usize>,
}

/// What these closed walks are, by their vertices.
pub(super) fn compared(surface: &SurfaceModel, lists: &[Vec<u32>]) -> Result<Vec<ComparedWalk>, Error> {
    let map = surface.map();
    let mut closed = Vec::new();
    for list in lists {
        match list[..] {
            [vertex] => closed.push(ClosedWalk::constant(surface.vertex_numbered(vertex)?)),
            _ => closed.push(ClosedWalk::new(map.skeleton(), surface.steps_along(list)?)?),
        }
    }
    let trees = TreeCotree::new(map);
    let homotopy = SurfaceHomotopy::new(map, &trees)?;
    let homology = SurfaceHomology::new(map, &trees);
    let mut answers = Vec::new();
    for (i, walk) in closed.iter().enumerate() {
        let (mut based, mut free) = (Vec::new(), Vec::new());
        for (j, other) in closed.iter().enumerate().filter(|&(j, _)| j != i) {
            if walk.start() == other.start() && homotopy.are_homotopic(walk, other)? {
                based.push(j);
            }
            let together = homotopy.component(walk)? == homotopy.component(other)?;
            if together && homotopy.are_freely_homotopic(walk, other)? {
                free.push(j);
            }
        }
        let class = homology.class_of_walk(walk)?;
        let bounds = class.iter().all(|&x| x == 0);
        answers.push(ComparedWalk {
            contractible: homotopy.is_contractible(walk)?,
            bounds,
            class,
            component: homotopy.component(walk)?,
            word: homotopy.word(walk)?.letters().to_vec(),
            homotopic: based,
            freely_homotopic: free,
        });
    }
    Ok(answers)
}

/// Refuses numbers that no cell has.
pub(super) fn checked(py: Python<'_>, what: &str, number: usize, count: usize) -> PyResult<()> {
    match number < count {
        true => Ok(()),
        false => Err(no_place(
            py,
            format!("there is no {what} {number}"),
            &format!("the surface has {count}; they count from 0"),
        )),
    }
}

/// The sides that start from a vertex, in the order of the faces around it.
pub(super) fn sides_from(map: &GeneralizedMap, vertex: VertexId) -> Vec<usize> {
    let at_vertex = |side: &HalfedgeId| map.source(*side) == vertex;
    let Some(first) = map.sides().find(at_vertex) else { return Vec::new() };
    let flags = map.fan(first.to_u32() << 1);
    let sides = flags.into_iter().filter(|flag| flag & 1 == 0);
    sides.map(|flag| HalfedgeId::from_u32(flag >> 1).index()).collect()
}
