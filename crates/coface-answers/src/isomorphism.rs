//! Whether two models are the same triangulation under other names.

use crate::answer::IsomorphicAnswer;
use crate::polygon_isomorphism::polygon_isomorphism;
use coface_algebra::{Error, ErrorKind, RaggedArray};
use coface_complexes::cell_mesh::CellShape;
use coface_complexes::gluing::{FaceClasses, GluingTable};
use coface_io::{Model, Structure};

/// The signatures of larger tables are not looked for.
const MOST_SIMPLICES: usize = 2000;

/// Whether two triangulations are the same but for the names of simplices and vertices, with the names in the second.
///
/// Models are gluing tables, lists of facets of one dimension, meshes of triangles or tetrahedra, or two surfaces of polygons, which are
/// compared polygon by polygon; these have no signatures.
///
/// # Errors
/// Those of [`GluingTable::from_simplices`]; [`ErrorKind::UnsupportedFormat`] for other models, and for simplices that touch
/// in faces below their facets only, which gluings do not tell.
///
/// # Examples
/// ```
/// use coface_answers::isomorphic;
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let read = |text: &str| coface_io::read(text.as_bytes(), Format::Json);
/// let (a, b) = (read("[[0,1,2],[1,2,3]]")?, read("[[7,5,9],[5,9,6]]")?);
/// let answer = isomorphic(["a", "b"], [&a, &b])?;
/// assert!(answer.isomorphic && answer.simplices.is_some());
/// # Ok(()) }
/// ```
pub fn isomorphic(names: [&str; 2], models: [&Model; 2]) -> Result<IsomorphicAnswer, Error> {
    let polygons = models.map(|model| {
        let is_surface =
            model.structure().is_none() && model.cells().is_empty() && !model.polygons().is_empty();
        is_surface.then(|| model.polygons())
    });
    if let [Some(a), Some(b)] = polygons
        && [a, b].iter().any(|own| own.iter().any(|polygon| polygon.len() != 3))
    {
        return polygon_isomorphism(names, [a, b]);
    }
    let table = |at: usize| table_of(models[at]).map_err(|error| error.in_file(names[at]));
    let (a, b) = (table(0)?, table(1)?);
    let found = a.isomorphism(&b);
    let signature = |table: &GluingTable| {
        let is_small = table.simplex_count() <= MOST_SIMPLICES;
        if is_small { table.isomorphism_signature().ok() } else { None }
    };
    Ok(IsomorphicAnswer {
        files: names.map(str::to_owned),
        isomorphic: found.is_some(),
        difference: if found.is_some() { None } else { Some(difference(&a, &b)?) },
        simplices: found.as_ref().map(|found| found.simplices().images().to_vec()),
        vertices: found
            .as_ref()
            .map(|found| found.vertices().iter().map(|images| images.images().to_vec()).collect()),
        signatures: [signature(&a), signature(&b)],
        remarks: Vec::new(),
    })
}

/// The first thing in which two triangulations differ that are not the same: what names do not change.
fn difference(a: &GluingTable, b: &GluingTable) -> Result<String, Error> {
    let numbers = |what: &str, a: usize, b: usize| (a != b).then(|| format!("{a} and {b} {what}"));
    if a.dimension() != b.dimension() {
        return Ok(format!("dimensions {} and {}", a.dimension(), b.dimension()));
    }
    let (faces_a, faces_b) = (a.faces()?, b.faces()?);
    let counts = numbers("simplices", a.simplex_count(), b.simplex_count())
        .or_else(|| numbers("components", a.components().count(), b.components().count()))
        .or_else(|| numbers("facets in the boundary", a.boundary_facets().count(), b.boundary_facets().count()))
        .or_else(|| {
            let mut pairs = faces_a.class_counts().into_iter().zip(faces_b.class_counts()).enumerate();
            pairs.find_map(|(degree, (a, b))| numbers(&format!("faces of degree {degree}"), a, b))
        })
        .or_else(|| {
            let is_orientable = |table: &GluingTable| table.orientation().odd_cycle().is_none();
            (is_orientable(a) != is_orientable(b)).then(|| "one can be oriented, the other cannot".to_owned())
        })
        .or_else(|| {
            (0..a.dimension().saturating_sub(1)).find_map(|degree| {
                let (a, b) = (degrees(a, &faces_a, degree), degrees(b, &faces_b, degree));
                let (x, y) = a.iter().zip(&b).find(|(x, y)| x != y)?;
                Some(format!(
                    "in how many simplices the faces of degree {degree} lie, from the fewest: first {x} and {y}"
                ))
            })
        });
    Ok(counts.unwrap_or_else(|| {
        "no image of the first simplex of a component can be continued, with any order of its vertices"
            .to_owned()
    }))
}

/// In how many simplices each face of a degree lies, counted with its copies, rising.
fn degrees(table: &GluingTable, faces: &FaceClasses, degree: usize) -> Vec<usize> {
    let mut counts = vec![0; faces.class_counts().get(degree).copied().unwrap_or(0)];
    for simplex in 0..table.simplex_count() {
        let sets = 1..1_u32 << (table.dimension() + 1);
        for set in sets.filter(|set| set.count_ones() as usize == degree + 1) {
            counts[faces.of_face(simplex, set).0] += 1;
        }
    }
    counts.sort_unstable();
    counts
}

/// A triangulation as a gluing table.
pub(crate) fn table_of(model: &Model) -> Result<GluingTable, Error> {
    let lists = match model.structure() {
        Some(Structure::Gluings(table)) => return Ok(table.clone()),
        Some(Structure::Facets(facets)) => facets.clone(),
        None if !model.cells().is_empty()
            && model.shapes().iter().all(|&shape| shape == CellShape::Tetrahedron) =>
        {
            model.cells().clone()
        }
        None if model.cells().is_empty()
            && !model.polygons().is_empty()
            && model.polygons().iter().all(|polygon| polygon.len() == 3) =>
        {
            model.polygons().clone()
        }
        _ => {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "the model is no gluing table, list of facets, or mesh of simplices",
            )
            .with_cure(
                "give triangles, tetrahedra or facets; halfedges become facets by coface convert INPUT --triangulate -o OUT.json",
            ));
        }
    };
    let sorted: Vec<Vec<u32>> = lists
        .iter()
        .map(|simplex| {
            let mut simplex = simplex.to_vec();
            simplex.sort_unstable();
            simplex
        })
        .collect();
    let lists = RaggedArray::from_lists(&sorted);
    let table = GluingTable::from_simplices(&lists)?;
    let mut vertices: Vec<u32> = lists.items().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let classes = table.faces()?.class_counts().first().copied().unwrap_or(0);
    if classes != vertices.len() {
        return Err(Error::new(
            ErrorKind::UnsupportedFormat,
            format!(
                "simplices touch in faces below their facets: {} vertices would be {classes} in the gluing table",
                vertices.len()
            ),
        )
        .with_cure("split such vertices first"));
    }
    Ok(table)
}
