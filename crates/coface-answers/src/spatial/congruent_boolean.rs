//! Boolean combinations of the models of a scene that is arranged by congruence.

use super::boolean::{
    boundary_manifold, check_formula, facets_of, part_counts, pinches, refuse_exterior, regions, rule_word,
    sides_of_faces,
};
use super::facts::input_answers;
use super::models::{group_names, input_data};
use super::{CongruentScene, SolidRequest};
use crate::answer::{InsideMethod, SolidBooleanAnswer, SolidBooleanProvenance};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, Sign, SparseMatrix, VertexId};
use coface_arrange::boolean::{CellSelection, SelectionBoundary, SelectionMesh};
use coface_complexes::surface::PolygonMesh;
use coface_geometry::{Positions, Sum, polygon_area};
use coface_io::{Group, GroupKind, Model};

/// The solid that a formula of inputs describes, of cells that were glued within a tolerance.
///
/// The second method for [`SolidBoolean`](super::SolidBoolean), in rounded numbers: for solids that meet only nearly.
///
/// # Examples
/// Two tetrahedra whose common face is written twice, a millionth apart, are one solid:
/// ```
/// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
/// use coface_arrange::boolean::BooleanFormula;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let read = |text: &str| coface_io::read(text.as_bytes(), coface_io::Format::Obj);
/// let up = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")?;
/// let down = read("v 0 0 -1e-6\nv 1 0 0\nv 0 1 0\nv 0 0 -12\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n")?;
/// let scene = CongruentScene::of_scene(SpatialScene::of([("up", &up), ("down", &down)], false)?, 1e-4)?;
/// let union = CongruentBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(2)))?;
/// let answer = union.answer()?;
/// assert_eq!((answer.f_vector, answer.solids), ([5, 9, 6], 1));
/// assert!((answer.measure.unwrap_or(0.0) - 3.0).abs() < 1e-5);
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct CongruentBoolean<'a> {
    arrangement: &'a CongruentScene,
    request: SolidRequest,
    selection: CellSelection,
    boundary: SelectionBoundary,
    surface: SelectionMesh,
    regions: Vec<u32>,
}

impl<'a> CongruentBoolean<'a> {
    /// Combines the inputs of an arrangement. Faces in one plane stay as they are, whatever the request says of them.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for a formula with an input that is not there, where pinches are to be split, and where a face
    /// cannot be cut into triangles; [`coface_algebra::ErrorKind::NotACycle`] naming an input that is open beyond the tolerance.
    ///
    /// # Complexity
    /// Linear in the cells times the length of the formula, and that of cutting faces into triangles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = CongruentScene::of_scene(SpatialScene::of([("solid", &solid)], false)?, 1e-9)?;
    /// let same = CongruentBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(1)))?;
    /// assert_eq!(same.answer()?.measure, Some(1.0));
    /// # Ok(()) }
    /// ```
    pub fn of(arrangement: &'a CongruentScene, request: &SolidRequest) -> Result<Self, Error> {
        check_formula(&request.formula, arrangement.scene().names().len())?;
        if request.split_pinches {
            return Err(Error::invalid("pinches of cells that are glued cannot be split")
                .with_cure("ask for it without congruence, or leave it out"));
        }
        let membership =
            arrangement.membership(request.rule, request.open, |input| request.formula.names(input))?;
        let complex = arrangement.complex();
        let selection =
            CellSelection::by_membership(complex.cell_count(3), &request.formula, |cell, input| {
                membership.is_inside(cell, input)
            });
        let boundary = selection.boundary(&with_cells(complex)?)?;
        let surface = mesh_of(arrangement, boundary.facets(), request.triangles)?;
        let regions = regions(&selection, &sides_of_faces(complex), complex.cell_count(3));
        Ok(Self { arrangement, request: request.clone(), selection, boundary, surface, regions })
    }

    /// Whether the result is pinched at edges or vertices, where parts of it touch.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // Two tetrahedra on a common edge.
    /// let read = |text: &str| coface_io::read(text.as_bytes(), coface_io::Format::Obj);
    /// let up = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")?;
    /// let down = read("v 0 0 0\nv 1 0 0\nv 0 -1 0\nv 0 0 -6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")?;
    /// let scene = CongruentScene::of_scene(SpatialScene::of([("up", &up), ("down", &down)], false)?, 1e-4)?;
    /// let union = CongruentBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(2)))?;
    /// assert!(union.is_pinched());
    /// # Ok(()) }
    /// ```
    pub fn is_pinched(&self) -> bool {
        !self.boundary.pinched_ridges().is_empty() || !self.boundary.pinched_vertices().is_empty()
    }

    /// The volume; `None` if the exterior is in the result.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = CongruentScene::of_scene(SpatialScene::of([("solid", &solid)], false)?, 1e-9)?;
    /// let outside = SolidRequest::of(BooleanFormula::parse("!a", &[])?);
    /// assert_eq!(CongruentBoolean::of(&scene, &outside)?.volume(), None);
    /// # Ok(()) }
    /// ```
    pub fn volume(&self) -> Option<f64> {
        if self.selection.has_exterior() {
            return None;
        }
        let mut sum = Sum::default();
        self.selection.cells().for_each(|cell| sum.add(self.arrangement.volumes()[cell.index()]));
        Some(sum.value())
    }

    /// The combination as an answer, with what congruence did under `congruence`.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] for more corners of polygons than fit.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = CongruentScene::of_scene(SpatialScene::of([("solid", &solid)], false)?, 1e-9)?;
    /// let same = CongruentBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(1)))?;
    /// assert!(same.answer()?.congruence.is_some());
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> Result<SolidBooleanAnswer, Error> {
        let complex = self.arrangement.complex();
        let positions = self.surface.positions(self.arrangement.positions())?;
        let mesh = self.mesh()?;
        let survey = mesh.survey();
        let manifold = boundary_manifold(&mesh, survey.verdict(), &positions);
        let faces: Vec<CellId> = self.boundary.facets().iter().map(|facet| facet.0).collect();
        let edges = facets_of(complex, 2, &faces);
        let vertices = facets_of(complex, 1, &edges);
        let f_vector = match self.request.triangles {
            true => [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()],
            false => [vertices.len(), edges.len(), faces.len()],
        };
        let facets = self.surface.facets().chunk_by(|x, y| x.0 == y.0);
        let [solids, voids] = part_counts(&self.selection, &self.regions);
        let mut files = input_answers(self.arrangement.scene(), self.arrangement.inputs());
        files.iter_mut().for_each(|file| {
            file.inside_by = Some(if file.coherent { InsideMethod::Winding } else { InsideMethod::Parity });
        });
        let crossings = self.arrangement.crossings()?;
        let remarks = self.arrangement.remarks(&files, self.request.rule, &crossings);
        let surface = survey.surface();
        Ok(SolidBooleanAnswer {
            dimension: 3,
            measure: self.volume(),
            f_vector,
            components: survey.components().count(),
            closed: survey.verdict().boundary_edge_count() == 0,
            manifold,
            euler_characteristic: mesh.euler_characteristic(),
            genus: surface.map(|surface| surface.genus()),
            area: polygon_area(&positions, self.surface.polygons()),
            solids,
            voids,
            cells: self.selection.cells().count(),
            unbounded: self.selection.has_exterior(),
            triangles: self.request.triangles,
            faces_cut: match self.request.triangles {
                true => 0,
                false => facets.filter(|own| own.len() > 1).count(),
            },
            walls: if self.request.keep_walls { self.boundary.walls().len() } else { 0 },
            pinches: pinches(complex, self.arrangement.positions(), &self.boundary),
            rule: rule_word(self.request.rule).to_owned(),
            files,
            rounding: self.arrangement.rounding(crossings)?,
            joined: Some(self.arrangement.joined()?),
            congruence: Some(self.arrangement.pieces()),
            remarks,
        })
    }

    /// The surface as polygons, those with holes or slits as triangles, with the data `input` and `polygon` and a group for each input;
    /// with shared faces if these are kept.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] where a face cannot be cut into triangles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = CongruentScene::of_scene(SpatialScene::of([("solid", &solid)], false)?, 1e-9)?;
    /// let same = CongruentBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(1)))?;
    /// assert_eq!(same.to_mesh()?.polygons().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn to_mesh(&self) -> Result<Model, Error> {
        let mesh = mesh_of(self.arrangement, &self.faces(), self.request.triangles)?;
        let positions = mesh.positions(self.arrangement.positions())?;
        let mut model = Model::from_polygons(positions, mesh.polygons().clone())?;
        let names = self.arrangement.scene().names();
        let mut members = vec![Vec::new(); names.len()];
        let first =
            |face: CellId| self.arrangement.sources(face, Sign::Plus).first().map(|&[a, b, _]| [a, b]);
        for (polygon, &(face, _)) in mesh.facets().iter().enumerate() {
            let input = first(face).and_then(|[input, _]| usize::try_from(input).ok());
            if let Some(members) = input.and_then(|input| members.get_mut(input)) {
                members.push(polygon as u32);
            }
        }
        for (name, members) in group_names(names).into_iter().zip(members) {
            model = model.with_group(Group::new(name, GroupKind::Polygons, members))?;
        }
        for data in input_data(&mesh, first)? {
            model = model.with_data(data)?;
        }
        Ok(model)
    }

    /// The cells of the result with the vertices, edges and faces around them, shared faces too, each cell once; a remark says so where cells are no
    /// balls.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the exterior is in the result.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = CongruentScene::of_scene(SpatialScene::of([("solid", &solid)], false)?, 1e-9)?;
    /// let same = CongruentBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(1)))?;
    /// assert!(same.to_chains()?.structure().is_some());
    /// # Ok(()) }
    /// ```
    pub fn to_chains(&self) -> Result<Model, Error> {
        refuse_exterior(&self.selection)?;
        let complex = self.arrangement.complex();
        let cells: Vec<CellId> = self.selection.cells().collect();
        let faces = facets_of(complex, 3, &cells);
        let edges = facets_of(complex, 2, &faces);
        let vertices = facets_of(complex, 1, &edges);
        let boundaries = vec![
            restricted(complex, 1, &vertices, &edges)?,
            restricted(complex, 2, &edges, &faces)?,
            restricted(complex, 3, &faces, &cells)?,
        ];
        let at = |vertex: &CellId| self.arrangement.positions().point(VertexId::from_u32(vertex.to_u32()));
        let positions = Positions::from_flat(3, vertices.iter().flat_map(at).copied().collect())?;
        Ok(Model::from_chains(ChainComplex::new(boundaries)?, positions)?.with_remark_on_cells())
    }

    /// Where each polygon of [`Self::to_mesh`] comes from, as in [`CongruentScene::provenance`].
    ///
    /// # Errors
    /// Those of [`Self::to_mesh`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentBoolean, CongruentScene, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = CongruentScene::of_scene(SpatialScene::of([("solid", &solid)], false)?, 1e-9)?;
    /// let same = CongruentBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(1)))?;
    /// assert_eq!(same.provenance()?.polygons.len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn provenance(&self) -> Result<SolidBooleanProvenance, Error> {
        let mesh = mesh_of(self.arrangement, &self.faces(), self.request.triangles)?;
        let polygons = mesh.facets().iter().map(|&(face, sign)| self.arrangement.sources(face, sign));
        let files = self.arrangement.scene().names().to_vec();
        Ok(SolidBooleanProvenance { files, polygons: polygons.collect() })
    }

    /// The faces of the surface, and the shared faces if these are kept.
    fn faces(&self) -> Vec<(CellId, Sign)> {
        let walls = if self.request.keep_walls { self.boundary.walls() } else { &[] };
        let walls = walls.iter().map(|&wall| (wall, Sign::Plus));
        self.boundary.facets().iter().copied().chain(walls).collect()
    }

    fn mesh(&self) -> Result<PolygonMesh, Error> {
        PolygonMesh::new(self.surface.vertex_sources().len(), self.surface.polygons().clone(), &[])
    }
}

/// The same complex; with no cells where it has no degree 3.
fn with_cells(complex: &ChainComplex) -> Result<ChainComplex, Error> {
    if complex.degree_count() == 4 {
        return Ok(complex.clone());
    }
    let mut boundaries = complex.boundary_matrices().to_vec();
    while boundaries.len() < 3 {
        let rows = match boundaries.last() {
            Some(last) => last.column_count(),
            None => complex.cell_count(0),
        };
        boundaries.push(SparseMatrix::from_entries(rows, 0, [])?);
    }
    ChainComplex::new(boundaries)
}

/// The columns of these cells in the rows of these facets of them.
fn restricted(
    complex: &ChainComplex,
    degree: usize,
    facets: &[CellId],
    cells: &[CellId],
) -> Result<SparseMatrix, Error> {
    let matrix = complex.boundary_matrix(degree);
    let columns = cells.iter().enumerate().flat_map(|(column, cell)| {
        let own = matrix.into_iter().flat_map(|matrix| matrix.column(cell.index()).iter());
        own.filter_map(move |(row, entry)| {
            Some((facets.binary_search(&CellId::new(row)).ok()?, column, i64::from(entry)))
        })
    });
    SparseMatrix::from_entries(facets.len(), cells.len(), columns.collect::<Vec<_>>())
}

/// Faces as polygons, or as triangles where they are no simple polygons or that is asked for.
fn mesh_of(
    arrangement: &CongruentScene,
    facets: &[(CellId, Sign)],
    triangles: bool,
) -> Result<SelectionMesh, Error> {
    let mut pieces: Vec<((CellId, Sign), Vec<u32>)> = Vec::new();
    for &facet in facets {
        pieces.extend(arrangement.pieces_of(facet.0, triangles)?.into_iter().map(|piece| (facet, piece)));
    }
    Ok(SelectionMesh::of_pieces(pieces.iter().map(|(facet, polygon)| (*facet, &polygon[..]))))
}
