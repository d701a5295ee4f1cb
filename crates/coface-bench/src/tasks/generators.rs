//! Integral homology with generators on the original cells.

use super::homology::{ask_model, group_to_text};
use super::{Clock, SOLIDS, SURFACES, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::algebra::Integer;
use coface::algebra::chains::ChainComplex;
use coface::complexes::simplicial::FrozenComplex;
use coface::topology::{Generator, generators};
use std::path::Path;

/// Complexes of higher dimension, random ones, and some with large torsion.
const COMPLEXES: &[&str] = &[
    "t4_6",
    "t4_8",
    "t4_10",
    "t4_12",
    "grid4_6",
    "grid4_8",
    "grid4_10",
    "lm_100x4000",
    "lm_200x10000",
    "sum_31",
    "sum_50",
];

pub(super) const SURFACE: Task = Task {
    name: "generators",
    about: "integral homology with short generators in all degrees, from the loaded model",
    extension: "raw",
    inputs: SURFACES,
    work: Work::Inside(of_model),
};

pub(super) const SOLID: Task = Task { name: "generators-solid", inputs: SOLIDS, ..SURFACE };

pub(super) const COMPLEX: Task = Task {
    name: "generators-complex",
    about: "the same from lists of simplices of any dimension",
    inputs: COMPLEXES,
    work: Work::Inside(of_lists),
    ..SURFACE
};

fn of_model(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    Ok(to_text(&ask_model(path, clock, generators)?))
}

fn of_lists(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let lists = Mesh::read_raw(path)?.lists;
    let (found, _complex) = clock.time(lists.len(), || {
        let complex: ChainComplex = FrozenComplex::from_facets(&lists)?.chain_complex()?;
        Ok::<_, Error>((generators(&complex), complex))
    })?;
    Ok(to_text(&found))
}

/// The groups, and the total length of the generators of each degree.
fn to_text(generators: &[Vec<Generator>]) -> String {
    let mut text = "betti".to_owned();
    for degree in generators {
        let orders: Vec<&Integer> = degree.iter().filter_map(Generator::order).collect();
        text += &group_to_text(degree.len() - orders.len(), orders);
    }
    text += " length";
    for degree in generators {
        let mut length = Integer::ZERO;
        degree.iter().for_each(|generator| length += &generator.length());
        text += &format!(" {length}");
    }
    text
}
