//! Models as simplicial complexes, and sets of simplices as models.

use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_complexes::cell_mesh::CellShape;
use coface_complexes::simplicial::{Simplex, SimplexSet, SimplicialComplex};
use coface_geometry::Positions;
use coface_io::{Model, ModelParts, Structure, placed};

/// The simplicial complex of a model: its facets, triangles, tetrahedra, segments and vertices with all their faces.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] if a polygon is no triangle or a cell no tetrahedron, and for halfedge permutations and
/// chain complexes, whose cells are not told by their vertices; else those of [`SimplicialComplex::from_facets`].
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_io::{Model, Structure};
/// use coface_answers::simplicial_complex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let facets = RaggedArray::from_lists([vec![0, 1, 2], vec![2, 3]]);
/// let complex = simplicial_complex(&Model::from_structure(Structure::Facets(facets)))?;
/// assert_eq!(complex.f_vector(), [4, 4, 1]);
/// # Ok(()) }
/// ```
pub fn simplicial_complex(model: &Model) -> Result<SimplicialComplex, Error> {
    match model.structure() {
        Some(Structure::Facets(facets)) => return SimplicialComplex::from_facets(facets.iter()),
        Some(Structure::Halfedges { .. }) => {
            return Err(Error::invalid("the faces of halfedge permutations need not be simplices")
                .with_cure("give the surface as a mesh of triangles or a facet list"));
        }
        Some(Structure::Chains(_)) => {
            return Err(Error::invalid("the cells of a chain complex are not told by their vertices")
                .with_cure("give a facet list, or a mesh of triangles or tetrahedra"));
        }
        Some(Structure::Gluings(_)) => {
            return Err(Error::invalid("the faces of a gluing table need not be told by their vertices")
                .with_cure("give a facet list, or a mesh of triangles or tetrahedra"));
        }
        Some(Structure::Volume(_)) => {
            return Err(Error::invalid("voxels are cubes, not simplices")
                .with_cure("ask for homology, or take triangles of its boundary"));
        }
        None => {}
    }
    require_triangles(model.polygons().iter().map(<[u32]>::len), model.positions())?;
    require_tetrahedra(model.shapes())?;
    let mut facets = Vec::new();
    facets.extend(model.cells().iter());
    facets.extend(model.polygons().iter());
    facets.extend(model.lines().iter().flat_map(|line| line.windows(2)));
    let vertices: Vec<[u32; 1]> = (0..model.vertex_count() as u32).map(|vertex| [vertex]).collect();
    facets.extend(vertices.iter().map(|vertex| &vertex[..]));
    SimplicialComplex::from_facets(facets)
}

/// What simplices have around them in a complex.
///
/// # Examples
/// ```
/// use coface_answers::Neighborhood;
/// use coface_complexes::simplicial::{Simplex, SimplexSet, SimplicialComplex};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
/// let vertex: SimplexSet = [Simplex::from([0])].into_iter().collect();
/// assert_eq!(Neighborhood::Star.found(&triangle, &vertex)?.f_vector(), [1, 2, 1]);
/// assert_eq!(Neighborhood::Closure.found(&triangle, &vertex)?.f_vector(), [1]);
/// assert_eq!(Neighborhood::Link.found(&triangle, &vertex)?.f_vector(), [2, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Neighborhood {
    /// All simplices that have one of them as a face.
    Star,
    /// They and all their faces.
    Closure,
    /// The closure of the star minus the star of the closure.
    Link,
}

impl Neighborhood {
    /// The word for it, which is that of the verb.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::Neighborhood::Link.name(), "link");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Star => "star",
            Self::Closure => "closure",
            Self::Link => "link",
        }
    }

    /// What these simplices of a complex have around them.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if one of them is not in the complex.
    ///
    /// # Complexity
    /// That of [`SimplicialComplex::star`], [`closure`](SimplicialComplex::closure) and [`link`](SimplicialComplex::link).
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_complexes::simplicial::{Simplex, SimplexSet, SimplicialComplex};
    /// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// let edge: SimplexSet = [Simplex::from([0, 1])].into_iter().collect();
    /// let link = coface_answers::Neighborhood::Link.found(&triangle, &edge)?;
    /// assert!(link.contains(&Simplex::from([2])) && link.f_vector() == [1]);
    /// # Ok(()) }
    /// ```
    pub fn found(self, complex: &SimplicialComplex, simplices: &SimplexSet) -> Result<SimplexSet, Error> {
        Ok(match self {
            Self::Star => complex.star(simplices)?,
            Self::Closure => SimplexSet::from(&complex.closure(simplices)?),
            Self::Link => SimplexSet::from(&complex.link(simplices)?),
        })
    }
}

/// Facets with more vertices have too many faces to make all of them for a skeleton.
const LARGE: usize = 16;

/// A simplicial complex that has all simplices of a model up to a dimension, and perhaps others: large facets are not made in full.
///
/// # Errors
/// As of [`simplicial_complex`]; [`ErrorKind::TooLarge`] if even the faces up to this dimension are too many.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_io::{Model, Structure};
/// use coface_answers::simplicial_skeleton;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let facets = RaggedArray::from_lists([(0..31).collect::<Vec<u32>>()]);
/// let complex = simplicial_skeleton(&Model::from_structure(Structure::Facets(facets)), 1)?;
/// assert_eq!(complex.f_vector(), [31, 465]);
/// # Ok(()) }
/// ```
pub fn simplicial_skeleton(model: &Model, dimension: usize) -> Result<SimplicialComplex, Error> {
    let Some(Structure::Facets(facets)) = model.structure() else { return simplicial_complex(model) };
    if facets.iter().all(|facet| facet.len() <= LARGE) {
        return simplicial_complex(model);
    }
    let mut complex = SimplicialComplex::new();
    for facet in facets.iter() {
        let simplex = Simplex::from_numbers(facet)?;
        complex.insert_skeleton(&simplex, dimension.min(simplex.dimension()))?;
    }
    Ok(complex)
}

/// That the polygons with these numbers of sides are simplices.
pub(super) fn require_triangles(
    side_counts: impl Iterator<Item = usize>,
    positions: &Positions,
) -> Result<(), Error> {
    let cure = match positions.dimension() {
        3 => "triangulate the model first",
        _ => "give a mesh of triangles, or triangulate the model in space",
    };
    match side_counts.enumerate().find(|&(_, sides)| sides != 3) {
        None => Ok(()),
        Some((i, sides)) => {
            Err(Error::invalid(format!("face f{i} has {sides} sides, so it is no simplex")).with_cure(cure))
        }
    }
}

/// That cells of these shapes are simplices.
pub(super) fn require_tetrahedra(shapes: &[CellShape]) -> Result<(), Error> {
    match shapes.iter().enumerate().find(|&(_, &shape)| shape != CellShape::Tetrahedron) {
        None => Ok(()),
        Some((i, shape)) => {
            let name = shape.name();
            Err(Error::invalid(format!("cell c{i} is a {name}, not a tetrahedron"))
                .with_cure("give a mesh of tetrahedra"))
        }
    }
}

/// A set of simplices of `source` as a model of its own: with the positions of the vertices it uses, renumbered without
/// gaps, where `source` has positions and no simplex is beyond dimension 3; else, and if `as_facets`, as a facet list with
/// the numbers of `source`.
///
/// A triangle is oriented as in `source`, or as a face of its tetrahedron: the boundary of positively oriented
/// tetrahedra looks outward.
///
/// # Errors
/// [`ErrorKind::NotAComplex`] if a face of a member is missing: files hold complexes.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_complexes::simplicial::{Simplex, SimplexSet};
/// let triangle = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
/// let edge: SimplexSet = [[0].into(), [1].into(), Simplex::from([0, 1])].into_iter().collect();
/// let model = coface_answers::model_of_simplices(&edge, &triangle, true)?;
/// assert!(matches!(model.structure(), Some(coface_io::Structure::Facets(facets)) if facets.len() == 1));
/// # Ok(()) }
/// ```
pub fn model_of_simplices(set: &SimplexSet, source: &Model, as_facets: bool) -> Result<Model, Error> {
    if let Some(missing) = set.missing_faces().iter().next() {
        return Err(Error::new(
            ErrorKind::NotAComplex,
            format!(
                "the set is no complex: the face {missing:?} of a member is missing, and files hold complexes"
            ),
        )
        .with_cells([missing.numbers()])
        .with_cure("take its closure, or print the set with --json"));
    }
    let maximal = set.maximal_simplices();
    let dimension = maximal.dimension();
    let width = source.coordinate_count();
    if as_facets || width == 0 || dimension > Some(3) {
        let facets = RaggedArray::from_lists(maximal.iter().map(Simplex::numbers));
        return Ok(Model::from_structure(Structure::Facets(facets)));
    }
    let used: Vec<u32> = set.simplices(0).iter().map(|vertex| vertex.numbers()[0]).collect();
    let renumbered = |vertex: &u32| used.binary_search(vertex).expect("a complex holds its vertices") as u32;
    let lists = |degree: usize| maximal.simplices(degree).iter().map(Simplex::numbers);
    let coordinates = used.iter().flat_map(|&v| &source.coordinates()[v as usize * width..][..width]);
    let (positions, partial_positions) = placed(width, coordinates.copied().collect())?;
    let orientations = Orientations::of(source, dimension);
    let oriented = |simplex: &[u32]| {
        let mut vertices: Vec<u32> = simplex.iter().map(renumbered).collect();
        if orientations.is_odd(simplex) {
            vertices.swap(0, 1);
        }
        vertices
    };
    let empty_if_none = |degree| dimension.is_some_and(|dimension| degree <= dimension);
    let all = |degree: usize| -> Vec<Vec<u32>> {
        if empty_if_none(degree) { lists(degree).map(oriented).collect() } else { Vec::new() }
    };
    let cells = all(3);
    Ok(ModelParts {
        vertex_count: used.len(),
        positions,
        partial_positions,
        points: all(0).iter().map(|vertex| VertexId::from_u32(vertex[0])).collect(),
        lines: RaggedArray::from_lists(all(1)),
        polygons: RaggedArray::from_lists(all(2)),
        shapes: vec![CellShape::Tetrahedron; cells.len()],
        cells: RaggedArray::from_lists(cells),
        ..ModelParts::default()
    }
    .into_model())
}

/// Which triangles and tetrahedra a model lists in an odd order of their vertices.
struct Orientations {
    /// Sorted vertices and whether the order was odd, sorted; the first entry of a simplex counts.
    triangles: Vec<([u32; 3], bool)>,
    tetrahedra: Vec<([u32; 4], bool)>,
}

impl Orientations {
    fn of(model: &Model, dimension: Option<usize>) -> Self {
        let (mut triangles, mut tetrahedra) = (Vec::new(), Vec::new());
        if dimension >= Some(2) {
            triangles.extend(model.polygons().iter().filter_map(sorted::<3>));
            for cell in model.cells().iter() {
                let faces = CellShape::Tetrahedron.faces().iter();
                triangles.extend(
                    faces.filter_map(|face| sorted::<3>(&face.iter().map(|&i| cell[i]).collect::<Vec<_>>())),
                );
            }
        }
        if dimension == Some(3) {
            tetrahedra.extend(model.cells().iter().filter_map(sorted::<4>));
        }
        // Stable: what the model lists itself comes before faces of cells.
        triangles.sort_by_key(|entry| entry.0);
        tetrahedra.sort_by_key(|entry| entry.0);
        Self { triangles, tetrahedra }
    }

    fn is_odd(&self, simplex: &[u32]) -> bool {
        fn find<const N: usize>(entries: &[([u32; N], bool)], simplex: &[u32]) -> bool {
            let at = entries.partition_point(|entry| entry.0[..] < *simplex);
            entries.get(at).is_some_and(|entry| entry.0[..] == *simplex && entry.1)
        }
        match simplex.len() {
            3 => find(&self.triangles, simplex),
            4 => find(&self.tetrahedra, simplex),
            _ => false,
        }
    }
}

/// The vertices in order, and whether sorting them took an odd number of exchanges.
fn sorted<const N: usize>(vertices: &[u32]) -> Option<([u32; N], bool)> {
    let mut sorted: [u32; N] = vertices.try_into().ok()?;
    let inversions: usize =
        (0..N).map(|i| sorted[..i].iter().filter(|&&before| before > sorted[i]).count()).sum();
    sorted.sort_unstable();
    Some((sorted, inversions % 2 == 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Report;
    use coface_geometry::Positions;

    fn two_tetrahedra() -> Model {
        let flat = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1., 1., 1., 1., 9., 9., 9.];
        let cells = RaggedArray::from_lists([[0, 1, 2, 3], [1, 4, 2, 3]]);
        Model::from_cells(Positions::from_flat(3, flat).unwrap(), vec![CellShape::Tetrahedron; 2], cells)
            .unwrap()
    }

    #[test]
    fn a_boundary_keeps_positions_and_looks_outward() {
        let source = two_tetrahedra();
        let complex = simplicial_complex(&source).unwrap();
        assert_eq!(complex.f_vector(), [6, 9, 7, 2], "vertex 5 is isolated");
        let set: SimplexSet = [[0, 1, 2, 3], [1, 2, 3, 4]].map(Simplex::from).into_iter().collect();
        let boundary = SimplexSet::from(&set.closure().boundary_complex().unwrap());
        let model = model_of_simplices(&boundary, &source, false).unwrap();
        model.check().unwrap();
        assert_eq!((model.vertex_count(), model.polygons().len()), (5, 6));
        let report = Report::of(model).unwrap();
        assert_eq!(report.is_coherently_oriented(), Some(true));
        let volume = report.signed_volume().unwrap();
        assert!((volume - 0.5).abs() < 1e-12, "{volume}");
    }

    #[test]
    fn facets_keep_their_numbers() {
        let set = SimplexSet::from(&Simplex::from([2, 5, 9])).closure();
        let model = model_of_simplices(&set, &two_tetrahedra(), true).unwrap();
        assert_eq!(model.structure(), Some(&Structure::Facets(RaggedArray::from_lists([[2, 5, 9]]))));
    }

    #[test]
    fn open_sets_and_other_cells_are_refused() {
        let open = SimplexSet::from(Simplex::from([0, 1]));
        let error = model_of_simplices(&open, &two_tetrahedra(), false).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::NotAComplex);
        let flat = Positions::from_flat(2, vec![0.; 8]).unwrap();
        let square = Model::from_polygons(flat, RaggedArray::from_lists([[0, 1, 2, 3]])).unwrap();
        assert!(simplicial_complex(&square).unwrap_err().to_string().starts_with("face f0 has 4 sides"));
    }
}
