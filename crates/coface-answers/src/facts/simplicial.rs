//! The report on simplices of any dimension.

use super::gluings::{self, NAMED_SIMPLICES, no_name_looked_for};
use super::polygons::{counted, isolated_vertices};
use super::report::{Answer, Report, Witness};
use super::{Problem, ProblemKind};
use coface_algebra::Error;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{RaggedArray, UnionFind};
use coface_complexes::gluing::GluingTable;
use coface_complexes::simplicial::{FaultyCells, FrozenComplex, LinkFault, ManifoldWitness, orientability};
use coface_topology::{NamedSpace, homology, manifold_verdict};

/// The report on a complex of dimension 3 or more.
///
/// # Errors
/// [`coface_algebra::ErrorKind::TooLarge`] for boundary matrices beyond 32 bits.
pub(crate) fn report(complex: &FrozenComplex, budget: u64) -> Result<Report, Error> {
    let chains = complex.chain_complex()?;
    let dimension = complex.dimension().unwrap_or(0);
    let isolated = isolated(complex);
    let mut problems = Vec::new();
    let (manifold, closed, witness) = manifold(complex, &chains, budget, &mut problems)?;
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
    let space = if dimension == 3 && manifold == Answer::Yes { space_of(complex)? } else { None };
    let is_closed_space = dimension == 3 && manifold == Answer::Yes && closed;
    let unnamed = is_closed_space.then(|| no_name_looked_for(complex.f_vector()[3])).flatten();
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
        name: space.as_ref().map(|space| space.name().to_string()),
        name_proof: space.as_ref().map(NamedSpace::proof),
        homology: homology(&chains).groups().to_vec(),
        problems,
        remarks: unnamed.into_iter().chain(gluings::orientations_open(space.as_ref())).collect(),
        ..Report::of_nothing()
    })
}

/// Which 3-manifold a complex is, where that is proved and it is one.
pub(super) fn space_of(complex: &FrozenComplex) -> Result<Option<NamedSpace>, Error> {
    if complex.dimension() != Some(3) || complex.f_vector().get(3).copied().unwrap_or(0) > NAMED_SIMPLICES {
        return Ok(None);
    }
    let tetrahedra = RaggedArray::uniform(4, complex.flat(3).to_vec())?;
    // Three tetrahedra on a triangle are no gluing, and tetrahedra that meet in less than a triangle are not glued.
    let Ok(table) = GluingTable::from_simplices(&tetrahedra) else { return Ok(None) };
    let faces = table.faces()?;
    let is_all = faces.class_counts() == complex.f_vector();
    if is_all { gluings::space_of(&table, &faces) } else { Ok(None) }
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

/// The verdict, whether the complex is closed, and the witness; adds every place where it is no manifold to the problems.
fn manifold(
    complex: &FrozenComplex,
    chains: &ChainComplex,
    budget: u64,
    problems: &mut Vec<Problem>,
) -> Result<(Answer, bool, Option<Witness>), Error> {
    let verdict = manifold_verdict(complex, chains, budget)?;
    let (answer, closed) = (Answer::of(verdict.to_bool()), verdict.is_closed());
    let Some(found) = verdict.witness() else { return Ok((answer, closed, None)) };
    let mut witness = witness(found);
    if found.fault() == LinkFault::NotPure && pure_part_is_manifold(complex, budget)? {
        witness.message += "; without such simplices it is a manifold";
    }
    if answer == Answer::No {
        let faults = complex.manifold_faults(chains);
        let is_listed = faults.iter().any(|group| group.fault() == found.fault());
        for group in &faults {
            problems.extend(problem_of(complex, group, found, &witness.message));
        }
        if !is_listed {
            let mut message = witness.message.clone();
            if found.count() > 1 {
                message += &format!(" (the first of {})", found.count());
            }
            let cells = RaggedArray::from_lists(witness.cells.iter().take(1));
            let kind = kind_of(found.fault(), witness.cells[0].len() - 1);
            problems.push(Problem::new(kind, message, cells, RaggedArray::new(), "cell"));
        }
    }
    Ok((answer, closed, Some(witness)))
}

/// Whether the simplices of the top dimension, with their faces, are a manifold.
fn pure_part_is_manifold(complex: &FrozenComplex, budget: u64) -> Result<bool, Error> {
    let dimension = complex.dimension().unwrap_or(0);
    let facets = RaggedArray::uniform(dimension + 1, complex.flat(dimension).to_vec())?;
    let part = FrozenComplex::from_facets(&facets)?;
    Ok(manifold_verdict(&part, &part.chain_complex()?, budget)?.is_manifold())
}

fn kind_of(fault: LinkFault, dimension: usize) -> ProblemKind {
    match (fault, dimension) {
        (LinkFault::NotPure, _) => ProblemKind::LooseCell,
        (LinkFault::BranchingRidge, _) => ProblemKind::NonManifoldRidge,
        (_, 0) => ProblemKind::NonManifoldVertex,
        _ => ProblemKind::NonManifoldEdge,
    }
}

/// All cells with one fault. Vertices that are facets are listed as isolated vertices, not here.
fn problem_of(
    complex: &FrozenComplex,
    group: &FaultyCells,
    found: &ManifoldWitness,
    message: &str,
) -> Option<Problem> {
    let (fault, dimension, count) = (group.fault(), group.dimension(), group.cells().len());
    if (fault, dimension) == (LinkFault::NotPure, 0) {
        return None;
    }
    let named = |&cell: &u32| complex.numbers(dimension, cell as usize);
    let is_first = fault == found.fault() && found.cells()[0].numbers() == named(&group.cells()[0]);
    let top = complex.dimension().unwrap_or(0);
    let what = match dimension {
        0 => counted(count, "vertex", "vertices"),
        1 => counted(count, "edge", "edges"),
        2 => counted(count, "triangle", "triangles"),
        _ => format!("{} of dimension {dimension}", counted(count, "simplex", "simplices")),
    };
    let is = if count == 1 { "is" } else { "are" };
    let message = match fault {
        _ if is_first && count == 1 => message.to_owned(),
        _ if is_first => format!("{message} (the first of {count})"),
        LinkFault::NotPure => format!("{what} {is} in no simplex of dimension {top}"),
        LinkFault::BranchingRidge => {
            format!("{what} {is} in three or more simplices of dimension {top}; a manifold allows two")
        }
        LinkFault::LinkNotConnected => {
            format!("{what} {is} not surrounded by a single fan or ring of simplices of dimension {top}")
        }
        _ => format!(
            "around {what}, simplices form no ball: the link is a surface other than the sphere and the disk"
        ),
    };
    let cells = RaggedArray::from_lists(group.cells().iter().map(named));
    Some(Problem::new(kind_of(fault, dimension), message, cells, RaggedArray::new(), "cell"))
}

fn witness(found: &ManifoldWitness) -> Witness {
    Witness {
        kind: found.fault().as_str(),
        cells: found.cells().iter().map(|simplex| simplex.numbers().to_vec()).collect(),
        message: found.message().to_owned(),
    }
}
