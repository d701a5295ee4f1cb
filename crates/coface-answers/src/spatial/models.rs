//! Arrangements and results as models and provenance.

use super::boolean::{EXTERIOR, refuse_unbounded};
use super::{SceneArrangement, SolidBoolean};
use crate::answer::{SolidBooleanProvenance, SpatialArrangementProvenance};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error};
use coface_algebra::{Sign, SparseMatrix};
use coface_arrange::boolean::SelectionMesh;
use coface_arrange::spatial::{BallComplex, BallRules, ExactPolygons};
use coface_complexes::surface::PolygonMesh;
use coface_io::{CellData, Group, GroupKind, GroupRole, Model};
use std::collections::BTreeMap;

/// Where a face has the exterior, in data on polygons.
pub(super) const NO_CELL: i64 = -1;

impl SceneArrangement {
    /// All faces as a mesh: each polygon with the data `cell_back` and `cell_front`, the cells on its two sides (-1 for the exterior),
    /// `input` and `polygon`, the first model that it is from and its number there; with `groups` in a group for each
    /// cell, and for each
    /// input if parts of models are inputs.
    ///
    /// Faces with holes or slits are cut into triangles, all faces if `triangles`.
    ///
    /// # Errors
    /// Those of [`Model::check`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.to_mesh(false, false)?.polygons().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn to_mesh(&self, triangles: bool, groups: bool) -> Result<Model, Error> {
        let faces: Vec<(CellId, Sign)> =
            (0..self.complex().cell_count(2)).map(|face| (CellId::new(face), Sign::Plus)).collect();
        let mesh = self.mesh_of(&faces, triangles)?;
        let sides = self.sides_of_faces();
        let mut model =
            Model::from_polygons(mesh.positions(self.arranged.drawn_positions())?, mesh.polygons().clone())?;
        for data in self.source_data(&mesh)?.into_iter().chain(cell_data(&mesh, &sides, i64::from)?) {
            model = model.with_data(data)?;
        }
        if !groups {
            return Ok(model);
        }
        let mut members = vec![Vec::new(); self.complex().cell_count(3)];
        for (polygon, (face, _)) in mesh.facets().iter().enumerate() {
            let [back, front] = sides[face.index()];
            for cell in [back, front] {
                if let Some(members) = members.get_mut(cell as usize) {
                    members.push(polygon as u32);
                }
            }
        }
        for (cell, members) in members.into_iter().enumerate() {
            model = model.with_group(Group::new(format!("cell_{cell}"), GroupKind::Polygons, members))?;
        }
        if !self.scene.has_parts() {
            return Ok(model);
        }
        let mut members = vec![Vec::new(); self.scene.names().len()];
        for (polygon, (face, _)) in mesh.facets().iter().enumerate() {
            for input in self.inputs_of_face(*face) {
                members[input].push(polygon as u32);
            }
        }
        for (name, members) in group_names(self.scene.names()).into_iter().zip(members) {
            let group = Group::new(name, GroupKind::Polygons, members).with_role(GroupRole::Object);
            model = model.with_group(group)?;
        }
        Ok(model)
    }

    /// Vertices, edges, faces and bounded cells with positions, refined until each is a ball, with what each is a piece of. If `triangles`,
    /// all faces are cut into triangles.
    ///
    /// # Errors
    /// Those of [`coface_arrange::spatial::SpatialArrangement::ball_complex`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert!(arranged.to_chains(false)?.structure().is_some());
    /// # Ok(()) }
    /// ```
    pub fn to_chains(&self, triangles: bool) -> Result<Model, Error> {
        let cells: Vec<Option<u32>> = (0..self.complex().cell_count(3) as u32).map(Some).collect();
        model_of(self.arranged.balls(&cells, BallRules::new().keep_faces(true).triangles(triangles))?)
    }

    /// The faces as polygons that lose nothing, for [`Model::with_exact_polygons`]: what the rounded coordinates of
    /// [`Self::to_chains`] say nearly. Faces that two cells share, and those of none, are marked.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.exact_polygons().parts().len(), 4);
    /// let again = arranged.to_chains(false)?.with_exact_polygons(arranged.exact_polygons().into());
    /// let again = SceneArrangement::of([("again", &again)], &SpatialRequest::default())?;
    /// assert_eq!(again.volumes(), [1.0]);
    /// # Ok(()) }
    /// ```
    pub fn exact_polygons(&self) -> ExactPolygons {
        let is_open = self.complex().cell_count(3) == 0;
        let (mut surface, mut walls) = (Vec::new(), Vec::new());
        for (face, &[back, front]) in self.sides_of_faces().iter().enumerate() {
            let face = CellId::new(face);
            match [back, front].map(|cell| cell != EXTERIOR) {
                [true, false] => surface.push((face, Sign::Plus)),
                [false, true] => surface.push((face, Sign::Minus)),
                _ if is_open => surface.push((face, Sign::Plus)),
                _ => walls.push(face),
            }
        }
        self.arranged.exact_polygons(&surface, &walls)
    }

    /// The chain complex of [`Self::to_chains`].
    ///
    /// # Errors
    /// As there.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.chain_complex()?.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        let cells: Vec<Option<u32>> = (0..self.complex().cell_count(3) as u32).map(Some).collect();
        Ok(self.arranged.balls(&cells, BallRules::new().keep_faces(true))?.into_parts().0)
    }

    /// For each face of the arrangement its sources: the model, the polygon in it, and 1 or -1 where the polygon runs with the face
    /// or against it; polygons of volumes run outward.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.provenance().faces.len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn provenance(&self) -> SpatialArrangementProvenance {
        let faces = (0..self.complex().cell_count(2)).map(|face| self.sources(CellId::new(face), Sign::Plus));
        SpatialArrangementProvenance {
            files: self.scene.names().to_vec(),
            faces: faces.collect(),
            vertices: None,
            edges: None,
        }
    }

    /// The sources of a face that is run through in this direction, as `[model, polygon, sign]`.
    fn sources(&self, face: CellId, direction: Sign) -> Vec<[i64; 3]> {
        let source = |(polygon, sign): (u32, Sign)| {
            let at = polygon as usize;
            let sign = sign.times(direction);
            let input = i64::from(self.scene.input_of_polygon()[at]);
            [input, i64::from(self.scene.source_of_polygon()[at]), i64::from(sign.to_i32())]
        };
        self.arranged.polygons_of_face(face).into_iter().map(source).collect()
    }

    /// The first source of each polygon as data.
    fn source_data(&self, mesh: &SelectionMesh) -> Result<[CellData; 2], Error> {
        let first = |face: CellId| {
            self.arranged.polygons_of_face(face).first().map(|&(polygon, _)| {
                let at = polygon as usize;
                [self.scene.input_of_polygon()[at], self.scene.source_of_polygon()[at]].map(i64::from)
            })
        };
        input_data(mesh, first)
    }
}

impl SolidBoolean<'_> {
    /// The surface of the result as a mesh, walls behind it if they are kept. Each polygon has the data `input` and `polygon`, the
    /// first model that it is from and its number there, and is in a group named by that model; with walls also `cell_back` and
    /// `cell_front`, the selected cells on its two sides, or -1.
    ///
    /// # Errors
    /// Those of [`Model::check`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.to_mesh()?.polygons().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn to_mesh(&self) -> Result<Model, Error> {
        let mesh = self.mesh_with_walls()?;
        let arrangement = self.arrangement;
        let positions = mesh.positions(arrangement.arranged.drawn_positions())?;
        let mut model = Model::from_polygons(positions, mesh.polygons().clone())?;
        let [inputs, polygons] = arrangement.source_data(&mesh)?;
        let names = arrangement.scene().names();
        let mut members = vec![Vec::new(); names.len()];
        for polygon in 0..mesh.polygons().len() {
            let input = inputs.integer_row(polygon).and_then(|row| usize::try_from(row[0]).ok());
            if let Some(members) = input.and_then(|input| members.get_mut(input)) {
                members.push(polygon as u32);
            }
        }
        for (name, members) in group_names(names).into_iter().zip(members) {
            model = model.with_group(Group::new(name, GroupKind::Polygons, members))?;
        }
        model = model.with_data(inputs)?.with_data(polygons)?;
        if self.request.keep_walls {
            let kept = |cell: u32| match self.selection.contains(CellId::from_u32(cell)) {
                true => i64::from(cell),
                false => NO_CELL,
            };
            for data in cell_data(&mesh, &self.sides, kept)? {
                model = model.with_data(data)?;
            }
        }
        Ok(model)
    }

    /// The result as a chain complex with positions. Its cells of degree 3 are the solids, or the selected cells if walls are kept; their
    /// boundaries run outward. Faces, solids and cells are refined until each is a ball, with what each is a piece of; but not if
    /// pinches are split.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the exterior is in the result.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert!(same.to_chains()?.structure().is_some());
    /// # Ok(()) }
    /// ```
    pub fn to_chains(&self) -> Result<Model, Error> {
        refuse_unbounded(self)?;
        if self.request.split_pinches {
            return self.chains_of_mesh();
        }
        let mut numbers: Vec<Option<u32>> = vec![None; self.sides.len().max(self.regions.len())];
        let mut count = 0;
        let mut parts = vec![None; self.arrangement.complex().cell_count(3)];
        for cell in self.selection.cells() {
            let part =
                if self.request.keep_walls { cell.index() } else { self.regions[cell.index()] as usize };
            parts[cell.index()] = Some(*numbers[part].get_or_insert_with(|| {
                count += 1;
                count - 1
            }));
        }
        model_of(self.arrangement.arranged.balls(&parts, BallRules::new().triangles(self.request.triangles))?)
    }

    /// The polygons around the result as they are before coordinates are rounded, for [`Model::with_exact_polygons`]:
    /// an input that the next operation takes as it is. Shared faces are there if they are kept.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the exterior is in the result.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let result = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::union(1)))?;
    /// assert_eq!(result.exact_polygons()?.shared(), [false; 4]);
    /// # Ok(()) }
    /// ```
    pub fn exact_polygons(&self) -> Result<ExactPolygons, Error> {
        refuse_unbounded(self)?;
        let walls = if self.request.keep_walls { self.boundary.walls() } else { &[] };
        Ok(self.arrangement.arranged.exact_polygons(self.boundary.facets(), walls))
    }

    fn chains_of_mesh(&self) -> Result<Model, Error> {
        let mesh = self.mesh_with_walls()?;
        let polygons = PolygonMesh::new(mesh.vertex_sources().len(), mesh.polygons().clone(), &[])?;
        let mut boundaries: Vec<SparseMatrix> =
            polygons.chain_complex()?.boundary_matrices().iter().take(2).cloned().collect();
        boundaries.push(self.cells_on(mesh.facets())?);
        Model::from_chains(
            ChainComplex::new(boundaries)?,
            mesh.positions(self.arrangement.arranged.drawn_positions())?,
        )
    }

    /// For each polygon of [`Self::to_mesh`] its sources: the model, the polygon in it, and 1 or -1 where the polygon of the result runs
    /// as the model has it, or against it.
    ///
    /// # Errors
    /// None for arrangements that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.provenance()?.files, ["solid"]);
    /// # Ok(()) }
    /// ```
    pub fn provenance(&self) -> Result<SolidBooleanProvenance, Error> {
        let files = self.arrangement.scene().names().to_vec();
        let sources = |&(face, sign): &(CellId, Sign)| self.arrangement.sources(face, sign);
        let polygons = match &self.merged_facets {
            None => self.mesh_with_walls()?.facets().iter().map(sources).collect(),
            Some(facets) => facets
                .iter()
                .map(|own| {
                    let mut all: Vec<[i64; 3]> = own.iter().flat_map(sources).collect();
                    all.sort_unstable();
                    all.dedup();
                    all
                })
                .collect(),
        };
        Ok(SolidBooleanProvenance { files, polygons })
    }

    fn mesh_with_walls(&self) -> Result<SelectionMesh, Error> {
        if !self.request.keep_walls {
            return Ok(self.surface.clone());
        }
        let walls = self.boundary.walls().iter().map(|&wall| (wall, Sign::Plus));
        let faces: Vec<(CellId, Sign)> = self.boundary.facets().iter().copied().chain(walls).collect();
        self.arrangement.mesh_of(&faces, self.request.triangles)
    }

    /// The boundary matrix of solids, or of selected cells with walls, on polygons that are part of these faces in these directions.
    fn cells_on(&self, faces: &[(CellId, Sign)]) -> Result<SparseMatrix, Error> {
        let mut numbers = vec![None; self.sides.len().max(self.regions.len())];
        let mut count = 0;
        for cell in self.selection.cells() {
            let part =
                if self.request.keep_walls { cell.index() } else { self.regions[cell.index()] as usize };
            if numbers[part].is_none() {
                numbers[part] = Some(count);
                count += 1;
            }
        }
        let column = |cell: u32| {
            let cell = CellId::from_u32(cell);
            let is_in = cell.to_u32() != u32::MAX && self.selection.contains(cell);
            let part = is_in.then(|| match self.request.keep_walls {
                true => cell.index(),
                false => self.regions[cell.index()] as usize,
            });
            part.and_then(|part| numbers[part])
        };
        let mut entries = Vec::new();
        for (row, &(face, direction)) in faces.iter().enumerate() {
            let [back, front] = self.sides[face.index()];
            for (cell, sign) in [(back, 1i64), (front, -1)] {
                if let Some(column) = column(cell) {
                    entries.push((row, column, sign * i64::from(direction.to_i32())));
                }
            }
        }
        SparseMatrix::from_entries(faces.len(), count, entries)
    }
}

/// The input and the polygon in it that each polygon comes from first, as data.
pub(super) fn input_data(
    mesh: &SelectionMesh,
    first: impl Fn(CellId) -> Option<[i64; 2]>,
) -> Result<[CellData; 2], Error> {
    let data = |name: &str, which: usize| {
        let values = mesh.facets().iter().map(|&(face, _)| first(face).unwrap_or([NO_CELL; 2])[which]);
        CellData::integers(name, GroupKind::Polygons, 1, values.collect())
    };
    Ok([data("input", 0)?, data("polygon", 1)?])
}

/// Names of groups of the inputs with these names: those that OBJ would not tell apart have the number of the input
/// behind them.
pub(super) fn group_names(names: &[String]) -> Vec<String> {
    let word = |name: &str| name.split_whitespace().collect::<Vec<_>>().join("_");
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    names.iter().for_each(|name| *counts.entry(word(name)).or_default() += 1);
    let name = |(input, name): (usize, &String)| match counts[&word(name)] {
        1 => name.clone(),
        _ => format!("{name}_{input}"),
    };
    names.iter().enumerate().map(name).collect()
}

/// Balls as a model.
fn model_of(balls: BallComplex) -> Result<Model, Error> {
    let (complex, positions, refinement) = balls.into_parts();
    Ok(Model::from_chains(complex, positions)?.with_refinement(refinement)?.with_remark_on_cells())
}

/// The cells on the two sides of each polygon as data, in the direction of the polygon.
fn cell_data(
    mesh: &SelectionMesh,
    sides: &[[u32; 2]],
    number: impl Fn(u32) -> i64,
) -> Result<[CellData; 2], Error> {
    let cell = |&(face, direction): &(CellId, Sign), which: usize| {
        let which = if direction == Sign::Plus { which } else { 1 - which };
        match sides[face.index()][which] {
            u32::MAX => NO_CELL,
            cell => number(cell),
        }
    };
    let data = |name: &str, which: usize| {
        let values = mesh.facets().iter().map(|facet| cell(facet, which)).collect();
        CellData::integers(name, GroupKind::Polygons, 1, values)
    };
    Ok([data("cell_back", 0)?, data("cell_front", 1)?])
}
