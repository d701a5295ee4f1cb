//! The report on gluing tables.

use super::polygons::counted;
use super::report::{Answer, BoundaryPart, Report, Skin, Witness};
use super::{Problem, ProblemKind};
use crate::answer::{Remark, RemarkCode};
use crate::producer::{Cells, Producer};
use coface_algebra::CellId;
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_complexes::gluing::{FaceClasses, GluingTable, GluingWitness};
use coface_complexes::surface::{GeneralizedMap, SurfaceComponent, SurfaceType};
use coface_topology::{GroupName, NamedSpace, gluing_manifold_verdict, homology, named_space};

/// The report on a table with its face classes.
///
/// # Errors
/// [`coface_algebra::ErrorKind::TooLarge`] for a subdivision or boundary matrices beyond their limits.
pub(crate) fn report(table: &GluingTable, faces: &FaceClasses) -> Result<Report, Error> {
    let chains = faces.chain_complex()?;
    let mut problems = Vec::new();
    let verdict = gluing_manifold_verdict(table, faces)?;
    let witness = verdict.witness().map(|found| witness(found, faces));
    if let (Some(false), Some(found), Some(witness)) = (verdict.to_bool(), verdict.witness(), &witness) {
        problems.push(problem(found, witness, faces));
    }
    let orientation = table.orientation();
    if let Some(cycle) = orientation.odd_cycle() {
        problems.push(one_sided(table, faces, cycle.cells()));
    }
    let components = table.components().count();
    let is_surface = table.dimension() == 2 && components > 0;
    let loops = if is_surface { Some(boundary_loops(table, faces)?) } else { None };
    // A table of triangles is a surface unless a side is glued to itself backwards.
    let surfaces = match is_surface {
        true => GeneralizedMap::new(faces.two_skeleton()?).map_or(Vec::new(), |map| map.surface_components()),
        false => Vec::new(),
    };
    let surface = match &surfaces[..] {
        [only] => only.surface(),
        _ => None,
    };
    let space = space_of(table, faces)?;
    let mut remarks = match faces.has_folds() {
        true => vec![Remark::new(
            RemarkCode::SubdivisionCounted,
            "homology is that of the barycentric subdivision, because face classes are identified with themselves",
        )],
        false => Vec::new(),
    };
    if table.dimension() == 3 && table.is_closed() {
        remarks.extend(no_name_looked_for(table.simplex_count()));
    }
    remarks.extend(orientations_open(space.as_ref()));
    Ok(Report {
        f_vector: faces.class_counts(),
        shapes: shapes(table),
        components,
        euler_characteristic: chains.euler_characteristic(),
        manifold: Answer::of(verdict.to_bool()),
        closed: Some(verdict.is_closed()),
        witness,
        boundary_loops: loops,
        skin: if table.dimension() == 3 && !table.is_closed() { Some(skin(table)?) } else { None },
        orientable: orientation.is_orientable().filter(|_| components > 0),
        surface_type: surface,
        name: SurfaceComponent::names(&surfaces).or(space.as_ref().map(|space| space.name().to_string())),
        name_proof: space.as_ref().map(NamedSpace::proof),
        surfaces,
        homology: homology(&chains).groups().to_vec(),
        problems,
        remarks,
        ..Report::of_nothing()
    })
}

/// Larger tables are not looked at for the name of their 3-manifold.
pub(super) const NAMED_SIMPLICES: usize = 500;

/// How often moves are tried where a triangulation does not show what it is.
const ATTEMPTS: usize = 60;

/// That the name of a closed 3-manifold of so many tetrahedra was not looked for, if it was not.
pub(super) fn no_name_looked_for(count: usize) -> Option<Remark> {
    let message = format!(
        "the name of the space is looked for up to {NAMED_SIMPLICES} tetrahedra, and this has {count}; a simplified triangulation may have one"
    );
    (count > NAMED_SIMPLICES).then(|| Remark::new(RemarkCode::SearchEnded, message))
}

/// That a name is of several spaces, if it is.
pub(crate) fn orientations_open(space: Option<&NamedSpace>) -> Option<Remark> {
    let name = space?.name();
    let message = format!(
        "{name} is written of all sums of these spaces and their mirror images; which of them this is, is not said"
    );
    name.leaves_orientations_open().then(|| Remark::new(RemarkCode::SummandOrientations, message))
}

/// Which 3-manifold a table is, where that is proved.
///
/// # Errors
/// Those of [`named_space`].
pub(crate) fn space_of(table: &GluingTable, faces: &FaceClasses) -> Result<Option<NamedSpace>, Error> {
    if table.simplex_count() > NAMED_SIMPLICES { Ok(None) } else { named_space(table, faces, ATTEMPTS) }
}

/// The fundamental group of a closed 3-manifold that has a name, with that name: where a presentation does not say which group it is.
///
/// # Errors
/// Those of [`named_space`].
///
/// # Complexity
/// That of [`named_space`], with 60 attempts; nothing is looked at beyond 500 tetrahedra.
///
/// # Examples
/// ```
/// use coface_answers::{Producer, group_of_space};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let table = coface_io::read(&b"kLAMzMzkbccdefghijjemkihhqqhxj"[..], coface_io::Format::Isosig)?;
/// let Some((group, space)) = group_of_space(&Producer::of(table)?)? else { return Ok(()) };
/// assert_eq!(space.name().to_string(), "SFS [S2: (2,1) (2,1) (37,-11)]");
/// assert_eq!(group.order().as_deref(), Some("3848"));
/// # Ok(()) }
/// ```
pub fn group_of_space(producer: &Producer) -> Result<Option<(GroupName, NamedSpace)>, Error> {
    let space = match &producer.cells {
        Cells::Gluings(gluings) => space_of(&gluings.0, &gluings.1)?,
        Cells::Simplices(complex) => super::simplicial::space_of(complex)?,
        _ => None,
    };
    Ok(space.and_then(|space| Some((space.name().fundamental_group()?, space))))
}

fn shapes(table: &GluingTable) -> Vec<(&'static str, usize)> {
    let name = match table.dimension() {
        1 => "edge",
        2 => "triangle",
        3 => "tetrahedron",
        _ => "simplex",
    };
    let count = table.simplex_count();
    if count == 0 { Vec::new() } else { vec![(name, count)] }
}

/// The connected surface with these numbers.
fn surface_type(euler_characteristic: i64, is_orientable: bool, boundary_count: usize) -> SurfaceType {
    let crosscaps = usize::try_from(2 - euler_characteristic - boundary_count as i64)
        .expect("a connected surface has at most the Euler characteristic of a sphere with its holes");
    match is_orientable {
        true => SurfaceType::orientable(crosscaps / 2, boundary_count),
        false => SurfaceType::non_orientable(crosscaps, boundary_count),
    }
}

/// The loops of the boundary of a surface, by its vertex classes in order.
fn boundary_loops(table: &GluingTable, faces: &FaceClasses) -> Result<Vec<BoundaryPart>, Error> {
    let (rim, sides) = table.boundary_table()?;
    let mut is_met = vec![false; sides.len()];
    let mut loops = Vec::new();
    for first in 0..sides.len() {
        if is_met[first] {
            continue;
        }
        let mut vertices = Vec::new();
        // Along each side from its end `from`.
        let (mut at, mut from) = (first, 0);
        while !is_met[at] {
            is_met[at] = true;
            let (triangle, side) = sides[at];
            let corner = if from >= side { from + 1 } else { from };
            vertices.push(faces.class(triangle, &[corner])?.0.to_u32());
            // The facet opposite to an end is the other end.
            let (next, images) = rim.neighbor(at, from).expect("a boundary has no boundary");
            (at, from) = (next, images[1 - from] as usize);
        }
        let walks = vec![vertices.iter().chain(vertices.first()).copied().collect()];
        loops.push(BoundaryPart { edge_count: vertices.len(), vertices, walks, is_simple: true });
    }
    Ok(loops)
}

/// The boundary surface of a table of tetrahedra: it is closed, and a surface before its vertices are identified.
fn skin(table: &GluingTable) -> Result<Skin, Error> {
    let (boundary, triangles) = table.boundary_table()?;
    let components = boundary.components().count();
    let euler_characteristic = boundary.faces()?.alternating_count();
    let is_orientable = boundary.orientation().odd_cycle().is_none();
    let name = (components == 1).then(|| surface_type(euler_characteristic, is_orientable, 0).to_string());
    Ok(Skin { face_count: triangles.len(), components, euler_characteristic, is_manifold: true, name })
}

fn witness(found: &GluingWitness, faces: &FaceClasses) -> Witness {
    Witness {
        kind: found.fault().as_str(),
        cells: found.classes().iter().take(1).map(|&class| faces.vertices(found.degree(), class)).collect(),
        message: found.message().to_owned(),
    }
}

fn problem(found: &GluingWitness, witness: &Witness, faces: &FaceClasses) -> Problem {
    let kind = match found.degree() {
        0 => ProblemKind::NonManifoldVertex,
        _ => ProblemKind::NonManifoldEdge,
    };
    let mut message = witness.message.clone();
    if found.classes().len() > 1 {
        message += &format!(" (the first of {})", found.classes().len());
    }
    let cells =
        RaggedArray::from_lists(found.classes().iter().map(|&class| faces.vertices(found.degree(), class)));
    Problem::new(kind, message, cells, RaggedArray::new(), "cell")
}

/// A closed chain of simplices without orientation, each by its vertices and number.
fn one_sided(table: &GluingTable, faces: &FaceClasses, chain: &[CellId]) -> Problem {
    let message = format!(
        "no orientation can be chosen: a closed chain of {} comes back reversed",
        counted(chain.len(), "simplex", "simplices")
    );
    let cells =
        RaggedArray::from_lists(chain.iter().map(|simplex| faces.vertices(table.dimension(), *simplex)));
    let tops = RaggedArray::from_lists(chain.iter().map(|simplex| [simplex.to_u32()]));
    Problem::new(ProblemKind::OneSidedChain, message, cells, tops, "cell")
}
