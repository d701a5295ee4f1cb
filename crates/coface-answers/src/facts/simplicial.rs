//! The report on simplices of any dimension.

use super::polygons::{counted, isolated_vertices};
use super::report::{Answer, Report, Witness};
use super::{Problem, ProblemKind};
use coface_algebra::Error;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{RaggedArray, UnionFind};
use coface_complexes::simplicial::{FrozenComplex, LinkFault, ManifoldWitness, Simplex, orientability};
use coface_topology::homology;

/// The report on a complex of dimension 3 or more.
///
/// # Errors
/// [`coface_algebra::ErrorKind::TooLarge`] for boundary matrices beyond 32 bits.
pub(crate) fn report(complex: &FrozenComplex) -> Result<Report, Error> {
    let chains = complex.chain_complex()?;
    let dimension = complex.dimension().unwrap_or(0);
    let isolated = isolated(complex);
    let mut problems = Vec::new();
    let (manifold, closed, witness) = manifold(complex, &chains, &isolated, &mut problems)?;
    let orientation = orientability(&chains);
    if let Some(cycle) = orientation.odd_cycle() {
        let facets: Vec<Vec<u32>> =
            cycle.cells().iter().map(|&facet| complex.numbers(dimension, facet.index()).to_vec()).collect();
        let message = format!(
            "no orientation can be chosen: a closed chain of {} comes back reversed",
            counted(facets.len(), "facet", "facets")
        );
        let cells = RaggedArray::from_lists(facets);
        problems.push(Problem::new(ProblemKind::OneSidedChain, message, cells, RaggedArray::new(), "cell"));
    }
    let pure = maximal_dimensions_agree(&chains, dimension);
    if !isolated.is_empty() {
        problems.push(isolated_vertices(&isolated));
    }
    Ok(Report {
        f_vector: complex.f_vector(),
        pure: Some(pure),
        components: components(complex),
        euler_characteristic: chains.euler_characteristic(),
        manifold,
        closed: Some(closed),
        witness,
        orientable: orientation.is_orientable(),
        homology: homology(&chains).groups().to_vec(),
        problems,
        ..Report::of_nothing()
    })
}

/// The vertices that lie in no edge.
fn isolated(complex: &FrozenComplex) -> Vec<u32> {
    if complex.dimension() < Some(1) {
        return Vec::new();
    }
    let vertices = complex.flat(0);
    let mut used = vec![false; vertices.len()];
    for vertex in complex.flat(1) {
        used[position(vertices, *vertex)] = true;
    }
    (0..used.len()).filter(|&i| !used[i]).map(|i| vertices[i]).collect()
}

fn components(complex: &FrozenComplex) -> usize {
    let mut partition = UnionFind::new(complex.simplex_count(0));
    if complex.dimension() >= Some(1) {
        let vertices = complex.flat(0);
        for &[a, b] in complex.flat(1).as_chunks::<2>().0 {
            partition.unite(position(vertices, a) as u32, position(vertices, b) as u32);
        }
    }
    partition.class_count()
}

fn position(vertices: &[u32], vertex: u32) -> usize {
    // Without gaps in the numbers, the common case, a vertex is its own position.
    if vertices.get(vertex as usize) == Some(&vertex) {
        return vertex as usize;
    }
    vertices.binary_search(&vertex).expect("a complex holds the vertices of its edges")
}

/// In how many facets each ridge lies.
fn ridge_degrees(chains: &ChainComplex, dimension: usize) -> Vec<u32> {
    let mut degrees = vec![0; chains.cell_count(dimension.saturating_sub(1))];
    if let Some(matrix) = chains.boundary_matrix(dimension) {
        for &row in matrix.rows() {
            degrees[row as usize] += 1;
        }
    }
    degrees
}

/// Whether every simplex below the top dimension is a face of one a dimension higher.
fn maximal_dimensions_agree(chains: &ChainComplex, dimension: usize) -> bool {
    (1..=dimension).all(|degree| !ridge_degrees(chains, degree).contains(&0))
}

/// The answer, whether there is no boundary, and the witness, for the complex without its isolated vertices, which do not count against it.
fn manifold(
    complex: &FrozenComplex,
    chains: &ChainComplex,
    isolated: &[u32],
    problems: &mut Vec<Problem>,
) -> Result<(Answer, bool, Option<Witness>), Error> {
    let verdict = if isolated.is_empty() {
        complex.manifold_verdict_with(chains)
    } else {
        let mut rest = complex.thaw();
        for &vertex in isolated {
            rest.erase(&Simplex::from([vertex]));
        }
        rest.manifold_verdict()?
    };
    let (answer, closed) = (Answer::of(verdict.to_bool()), verdict.is_closed());
    let Some(found) = verdict.witness() else { return Ok((answer, closed, None)) };
    let witness = witness(found);
    if answer == Answer::No {
        let kind = match found.fault() {
            LinkFault::NotPure => ProblemKind::LooseCell,
            LinkFault::BranchingRidge => ProblemKind::NonManifoldRidge,
            _ => match found.cells().first().map(Simplex::dimension) {
                Some(0) => ProblemKind::NonManifoldVertex,
                _ => ProblemKind::NonManifoldEdge,
            },
        };
        let cells = RaggedArray::from_lists(witness.cells.iter().take(1));
        let mut message = witness.message.clone();
        if found.count() > 1 {
            message += &format!(" (the first of {})", found.count());
        }
        problems.push(Problem::new(kind, message, cells, RaggedArray::new(), "cell"));
    }
    Ok((answer, closed, Some(witness)))
}

fn witness(found: &ManifoldWitness) -> Witness {
    Witness {
        kind: found.fault().as_str(),
        cells: found.cells().iter().map(|simplex| simplex.numbers().to_vec()).collect(),
        message: found.message().to_owned(),
    }
}
