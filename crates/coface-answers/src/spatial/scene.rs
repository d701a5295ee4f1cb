//! Models as polygons in space.

use super::enclosed::volume_sign;
use super::mouths::Mouths;
use crate::RegionSource;
use crate::answer::{Place, Remark, RemarkCode, remarks_of_file};
use crate::parts::{Part, closed_objects, parts_of};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind, FaceId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_arrange::spatial::{ExactPolygons, NonPlanar, SpatialPolygons, closed_walks};
use coface_complexes::cell_mesh::CellMesh;
use coface_geometry::Positions;
use coface_io::{Format, GroupKind, Model, StatedSurfaces, Structure};
use std::collections::BTreeMap;
use std::sync::Arc;

/// One or more models as polygons in space, each model a chain of its polygons.
///
/// A surface is the sum of its polygons. A volume mesh, or a chain complex with cells of degree 3, is the sum of the boundaries of its
/// cells, each turned so that it runs outward: faces between two cells, the **walls**, cancel in it. Its polygons run outward, as often
/// as they are in the sum. Lines, points, and polygons beside the cells of a volume mesh are left out, and counted in the
/// remarks.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::SpatialScene;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
/// let tetrahedron = io::read(text.as_bytes(), Format::Obj)?;
/// let scene = SpatialScene::of([("a", &tetrahedron)], true)?;
/// assert_eq!((scene.polygon_count(), scene.is_wall(3)), (4, false));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SpatialScene {
    /// Those of the inputs: of models, or of parts of them.
    pub(super) names: Vec<String>,
    /// What makes an input.
    pub(super) source: RegionSource,
    /// The names of the models.
    pub(super) files: Vec<String>,
    /// The model that each input is of, and what its file calls it there.
    pub(super) parts: Vec<(u32, Option<String>)>,
    pub(super) flat: Vec<f64>,
    /// The first point of each model.
    pub(super) point_starts: Vec<u32>,
    pub(super) walks: RaggedArray,
    pub(super) polygon_of_walk: Vec<u32>,
    pub(super) input_of_polygon: Vec<u32>,
    pub(super) source_of_polygon: Vec<u32>,
    pub(super) is_wall: Vec<bool>,
    pub(super) remarks: Vec<Remark>,
    /// The polygons that are known exactly, each lot with the number of its first polygon.
    pub(super) exact: Vec<(u32, Arc<ExactPolygons>)>,
    /// The first polygon that is a patch, once mouths are closed.
    pub(super) first_patch: Option<usize>,
    /// What was open of each input and is closed by patches.
    pub(super) mouths: Vec<Option<Mouths>>,
    /// For each polygon of each file the surface that it is a part of with others; empty for files that state none.
    pub(super) surfaces: Vec<Vec<u32>>,
}

impl SpatialScene {
    /// The polygons of these models, one after the other; `walls` says whether faces between cells of one model are among them. Of a volume of
    /// voxels they are the squares around those that are set.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the file of a model with points or lines only or without positions in space, and what
    /// [`CellMesh::new`] says of its cells; [`ErrorKind::UnsupportedFormat`] for structures without faces in space.
    ///
    /// # Complexity
    /// Linear, and that of [`CellMesh::new`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert_eq!(scene.polygon_count(), 4 + 4);
    /// # Ok(()) }
    /// ```
    pub fn of<'a>(
        models: impl IntoIterator<Item = (&'a str, &'a Model)>,
        walls: bool,
    ) -> Result<Self, Error> {
        Self::with_inputs(models, RegionSource::Models, walls)
    }

    /// The same where each object, group, feature or component of a model is an input. Those have the names that their
    /// files give them; components,
    /// and names that several files have, are behind the name of the file and `#`. What is in no object or group of
    /// its file is one more
    /// input.
    ///
    /// # Errors
    /// As [`Self::of`]; [`ErrorKind::InvalidInput`] naming a file without such parts.
    ///
    /// # Complexity
    /// Linear, and that of [`CellMesh::new`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{RegionSource, SpatialScene};
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nv 0 0 -6\n\
    ///     o up\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\no down\nf 1 2 3\nf 2 1 5\nf 3 2 5\nf 1 3 5\n";
    /// let both = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = SpatialScene::with_inputs([("both.obj", &both)], RegionSource::Objects, true)?;
    /// assert_eq!(scene.names(), ["up", "down"]);
    /// assert_eq!(scene.input_of_polygon(), [0, 0, 0, 0, 1, 1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn with_inputs<'a>(
        models: impl IntoIterator<Item = (&'a str, &'a Model)>,
        source: RegionSource,
        walls: bool,
    ) -> Result<Self, Error> {
        let mut scene = Self {
            names: Vec::new(),
            source,
            files: Vec::new(),
            parts: Vec::new(),
            flat: Vec::new(),
            point_starts: Vec::new(),
            walks: RaggedArray::new(),
            polygon_of_walk: Vec::new(),
            input_of_polygon: Vec::new(),
            source_of_polygon: Vec::new(),
            is_wall: Vec::new(),
            remarks: Vec::new(),
            exact: Vec::new(),
            first_patch: None,
            mouths: Vec::new(),
            surfaces: Vec::new(),
        };
        let models: Vec<(&str, &Model)> = models.into_iter().collect();
        scene.flat.reserve(models.iter().map(|(_, model)| model.positions().as_flat().len()).sum());
        for (name, model) in models {
            scene.add(name, model, walls).map_err(|error| error.in_file(name))?;
            scene.surfaces.push(surfaces_of(model));
            scene.files.push(name.to_owned());
            scene.remarks.extend(remarks_of_file(name, model));
        }
        if u32::try_from(scene.walks.item_count()).is_err() {
            return Err(too_large());
        }
        scene.tell_names_apart();
        Ok(scene)
    }

    /// The same where nobody said what an input is. Models are, unless they are fewer than `count` and their objects
    /// are enough: then
    /// objects are. A remark says so, or names the models whose closed objects are one input.
    ///
    /// # Errors
    /// As [`Self::of`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SpatialScene;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nv 0 0 -6\n\
    ///     o up\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\no down\nf 1 2 3\nf 2 1 5\nf 3 2 5\nf 1 3 5\n";
    /// let both = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = |count| SpatialScene::of_at_least(count, [("both.obj", &both)], true);
    /// assert_eq!((scene(1)?.names().len(), scene(2)?.names().len()), (1, 2));
    /// assert_eq!(scene(1)?.remarks().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn of_at_least<'a>(
        count: usize,
        models: impl IntoIterator<Item = (&'a str, &'a Model)>,
        walls: bool,
    ) -> Result<Self, Error> {
        let models: Vec<(&str, &Model)> = models.into_iter().collect();
        let objects: Vec<Option<usize>> = models.iter().map(|(_, model)| closed_objects(model)).collect();
        let in_all = objects.iter().try_fold(0, |sum, &count| Some(sum + count?));
        let of_objects = models.len() < count && in_all.is_some_and(|in_all| in_all >= count);
        let source = if of_objects { RegionSource::Objects } else { RegionSource::Models };
        let mut scene = Self::with_inputs(models.iter().copied(), source, walls)?;
        for ((name, _), count) in models.iter().zip(objects) {
            let Some(count) = count else { continue };
            let message = match of_objects {
                true => format!(
                    "{name}: each of its {count} objects is an input, as if --inputs objects were given"
                ),
                false => format!(
                    "{name} has {count} objects and is one input; --inputs objects makes each an input"
                ),
            };
            scene
                .remarks
                .push(Remark::new(RemarkCode::ObjectsInFile, message).at(count, [Place::file(*name)]));
        }
        Ok(scene)
    }

    /// Puts the name of the file in front of names that several files have.
    fn tell_names_apart(&mut self) {
        let mut file_of_name: BTreeMap<&str, Option<u32>> = BTreeMap::new();
        for (name, &(file, _)) in self.names.iter().zip(&self.parts) {
            let known = file_of_name.entry(name).or_insert(Some(file));
            *known = known.filter(|&known| known == file);
        }
        let is_shared: Vec<bool> = self.names.iter().map(|name| file_of_name[&name[..]].is_none()).collect();
        for ((name, (file, part)), is_shared) in self.names.iter_mut().zip(&self.parts).zip(is_shared) {
            if is_shared && part.is_some() {
                *name = format!("{}#{name}", self.files[*file as usize]);
            }
        }
    }

    fn add(&mut self, name: &str, model: &Model, walls: bool) -> Result<(), Error> {
        if let Some(exact) = model.exact_polygons() {
            if self.source == RegionSource::Models {
                return self.add_exact(name, exact, walls);
            }
            let message = format!("{name}: its points are rounded, since its parts are inputs of their own");
            self.remarks.push(Remark::new(RemarkCode::PointsRounded, message).at(1, [Place::file(name)]));
        }
        if let Some(coarse) = model.coarse()? {
            return self.add(name, &coarse, walls);
        }
        if let Some((positions, squares)) = model.voxel_surface()? {
            return self.add(name, &Model::from_polygons(positions, squares)?, walls);
        }
        model.require_finite()?;
        if let Some(count @ 1..) = model.stated_surfaces().map(StatedSurfaces::incomplete_count) {
            let surfaces = if count == 1 {
                "surface has holes that cross or touch its"
            } else {
                "surfaces have holes that cross or touch their"
            };
            let fault = format!("{count} {surfaces} rings, or have less than three vertices");
            return Err(Error::invalid(fault)
                .with_cure("mend these holes: the report on the file names them")
                .in_file(name));
        }
        if model.is_empty() {
            self.add_nothing(name);
            return Ok(());
        }
        let dimension = model.positions().dimension();
        if dimension != 3 {
            let fault = match dimension {
                0 => "the vertices have no positions".to_owned(),
                _ => format!("the positions have {dimension} coordinates, not three"),
            };
            return Err(Error::invalid(fault).with_cure("give points in space"));
        }
        let corners = self.walks.item_count() + model.polygons().item_count();
        let vertices = self.flat.len() / 3 + model.positions().len();
        if u32::try_from(corners).is_err() || vertices >= 1 << 31 {
            return Err(too_large());
        }
        let first = (self.flat.len() / 3) as u32;
        self.point_starts.push(first);
        let before = self.is_wall.len();
        let (lines, points, polygons) = (model.lines().len(), model.points().len(), model.polygons().len());
        match model.structure() {
            Some(Structure::Chains(complex)) => self.add_complex(name, model, complex, first, walls)?,
            Some(_) => {
                return Err(Error::new(
                    ErrorKind::UnsupportedFormat,
                    "facet lists, halfedges and gluings have no polygons in space",
                )
                .with_cure("give a mesh or a chain complex with positions"));
            }
            None if model.cells().is_empty() && self.source == RegionSource::Models => {
                let numbers = before as u32..(before + polygons) as u32;
                self.walks.append_moved(model.polygons(), first);
                self.polygon_of_walk.extend(numbers);
                self.input_of_polygon.resize(before + polygons, self.names.len() as u32);
                self.source_of_polygon.extend(0..polygons as u32);
                self.is_wall.resize(before + polygons, false);
                self.end_input(name, None);
            }
            None if model.cells().is_empty() => {
                let list = (model.polygons(), GroupKind::Polygons);
                for part in self.parts_of(name, model, list)? {
                    for &polygon in &part.members {
                        self.push(polygon as usize, 1, first, &[model.polygons().list(polygon as usize)]);
                    }
                    self.end_input(name, part.name);
                }
            }
            None => {
                let used = self.add_volume(name, model, first, walls)?;
                self.remark(name, polygons - used, "polygon", "that no cell has is left out");
            }
        }
        self.remark(name, lines, "line", "is left out: only polygons cut space");
        self.remark(name, points, "point", "is left out: only polygons cut space");
        if self.is_wall.len() == before {
            return Err(Error::invalid("there is no polygon")
                .with_cure("give polygons or 3-cells; lines are arranged in the plane"));
        }
        self.flat.extend_from_slice(model.positions().as_flat());
        Ok(())
    }

    /// Adds an empty model, as a difference may be: the empty set.
    fn add_nothing(&mut self, name: &str) {
        self.point_starts.push((self.flat.len() / 3) as u32);
        self.end_input(name, None);
        let message = format!("{name} is empty: it is taken as the empty set");
        self.remarks.push(Remark::new(RemarkCode::EmptyInput, message).at(1, [Place::file(name)]));
    }

    /// Adds polygons that are known exactly. Walks around them are on rounded points.
    fn add_exact(&mut self, name: &str, exact: &Arc<ExactPolygons>, walls: bool) -> Result<(), Error> {
        let wanted: Vec<bool> = exact.shared().iter().map(|&is_wall| walls || !is_wall).collect();
        let exact = if wanted.contains(&false) { Arc::new(exact.with(&wanted)) } else { Arc::clone(exact) };
        let rounded = SpatialPolygons::from_exact(Arc::clone(&exact))?;
        let points = rounded.positions();
        if u32::try_from(self.walks.item_count() + rounded.walks().item_count()).is_err()
            || self.flat.len() / 3 + points.len() >= 1 << 31
        {
            return Err(too_large());
        }
        if exact.shared().is_empty() {
            self.add_nothing(name);
            return Ok(());
        }
        let first = (self.flat.len() / 3) as u32;
        self.point_starts.push(first);
        self.flat.extend_from_slice(points.as_flat());
        self.exact.push((self.is_wall.len() as u32, Arc::clone(&exact)));
        let walks_of_polygon =
            RaggedArray::grouped(exact.shared().len(), rounded.polygon_of_walk().iter().copied());
        for (polygon, &is_wall) in exact.shared().iter().enumerate() {
            let own = walks_of_polygon.list(polygon).iter().map(|&walk| rounded.walks().list(walk as usize));
            self.push(polygon, i32::from(!is_wall), first, &own);
        }
        self.end_input(name, None);
        Ok(())
    }

    /// The parts of a model that are inputs; none if there are none, or if models are inputs.
    fn parts_of(
        &mut self,
        name: &str,
        model: &Model,
        elements: (&RaggedArray, GroupKind),
    ) -> Result<Vec<Part>, Error> {
        if elements.0.is_empty() {
            // The caller says that there is nothing.
            return Ok(Vec::new());
        }
        let (parts, remarks) = parts_of(name, model, self.source, elements)?;
        self.remarks.extend(remarks);
        Ok(parts)
    }

    /// The polygons that were added since the last one are an input of the model that is being read.
    fn end_input(&mut self, file: &str, part: Option<String>) {
        let number = self.files.len() as u32;
        let own = self.parts.len() - self.parts.partition_point(|part| part.0 < number);
        self.names.push(match (&part, self.source) {
            (Some(part), _) => part.clone(),
            (None, RegionSource::Components) => format!("{file}#{own}"),
            (None, _) => file.to_owned(),
        });
        self.parts.push((number, part));
    }

    /// Whether an input is a part of a model that has a name there: some of its polygons may be of other parts as well.
    pub(super) fn is_named_part(&self, input: usize) -> bool {
        self.parts[input].1.is_some() || self.file(input).1.contains('#')
    }

    /// The number and the name of the model that an input is of.
    fn file(&self, input: usize) -> (usize, &str) {
        let file = self.parts[input].0 as usize;
        (file, &self.files[file])
    }

    /// What an input is called in messages: its file, and the object or group in it.
    pub(super) fn label(&self, input: usize) -> String {
        let file = self.file(input).1;
        match &self.parts[input].1 {
            Some(part) => {
                format!("{file}: {} \"{}\"", self.source.word().trim_end_matches('s'), part.escape_debug())
            }
            None if self.source == RegionSource::Components => self.names[input].clone(),
            None => file.to_owned(),
        }
    }

    fn remark(&mut self, name: &str, count: usize, what: &str, fate: &str) {
        let message = match count {
            0 => return,
            1 => format!("{name}: one {what} {fate}"),
            _ => format!("{name}: {count} {what}s: each {fate}"),
        };
        self.remarks.push(Remark::new(RemarkCode::CellsLeftOut, message).at(count, [Place::file(name)]));
    }

    /// Adds a polygon of the model that is being read, as often as it is in the sum, or as a wall: vertex 0 of the model has the number
    /// `first`.
    fn push<'b>(
        &mut self,
        source: usize,
        multiplicity: i32,
        first: u32,
        walks: &(impl IntoIterator<Item = &'b [u32]> + Clone),
    ) {
        let mut moved = Vec::new();
        for _ in 0..multiplicity.unsigned_abs().max(1) {
            let polygon = self.is_wall.len() as u32;
            for walk in walks.clone() {
                moved.clear();
                moved.extend(walk.iter().map(|&vertex| first + vertex));
                if multiplicity < 0 {
                    moved.reverse();
                }
                self.walks.push(&moved);
                self.polygon_of_walk.push(polygon);
            }
            self.input_of_polygon.push(self.names.len() as u32);
            self.source_of_polygon.push(source as u32);
            self.is_wall.push(multiplicity == 0);
        }
    }

    /// Adds the faces of the cells of a volume mesh; the number of polygons of the file that are among all faces.
    fn add_volume(&mut self, name: &str, model: &Model, first: u32, walls: bool) -> Result<usize, Error> {
        let (shapes, cells) = (model.shapes().to_vec(), model.cells().clone());
        let mesh = CellMesh::new(model.vertex_count(), shapes, cells, model.polygons(), &[])?;
        let mut multiplicities = vec![0; mesh.face_count()];
        for part in self.parts_of(name, model, (model.cells(), GroupKind::Cells))? {
            let mut touched = Vec::new();
            for cell in part.members.into_iter().map(CellId::from_u32) {
                let faces =
                    || mesh.faces_of_cell(cell).map(|(face, sign)| (sign, mesh.skeleton().face(face)));
                let outward = volume_sign(model.positions(), faces);
                for (face, sign) in mesh.faces_of_cell(cell) {
                    multiplicities[face.index()] += outward * sign.to_i32();
                    touched.push(face.to_u32());
                }
            }
            self.push_faces(&mut multiplicities, touched, walls, first, |face| {
                [mesh.skeleton().face(FaceId::new(face))]
            });
            self.end_input(name, part.name);
        }
        let sides =
            (0..model.polygons().len()).filter(|&i| mesh.cells_of_face(mesh.face_of_polygon(i).0).len() > 0);
        Ok(sides.count())
    }

    /// Adds faces of cells, as often as they are in a sum, or as shared faces; the sum is zero afterwards.
    fn push_faces<'b, I: IntoIterator<Item = &'b [u32]> + Clone>(
        &mut self,
        multiplicities: &mut [i32],
        mut touched: Vec<u32>,
        walls: bool,
        first: u32,
        face_walks: impl Fn(usize) -> I,
    ) {
        touched.sort_unstable();
        touched.dedup();
        for face in touched.into_iter().map(|face| face as usize) {
            let multiplicity = std::mem::take(&mut multiplicities[face]);
            if walls || multiplicity != 0 {
                self.push(face, multiplicity, first, &face_walks(face));
            }
        }
    }

    /// Adds the cells of degree 2 of a chain complex.
    fn add_complex(
        &mut self,
        name: &str,
        model: &Model,
        complex: &ChainComplex,
        first: u32,
        walls: bool,
    ) -> Result<(), Error> {
        let positions = model.positions();
        let (Some(edges), Some(faces)) = (complex.boundary_matrix(1), complex.boundary_matrix(2)) else {
            return Ok(());
        };
        let mut ends = Vec::with_capacity(edges.column_count());
        for (edge, column) in edges.columns().enumerate() {
            ends.push(match (column.rows(), column.entries()) {
                (&[a, b], [-1, 1]) => [a, b],
                (&[a, b], [1, -1]) => [b, a],
                _ => {
                    return Err(Error::invalid(format!(
                        "the boundary of edge e{edge} is not a vertex minus a vertex"
                    )));
                }
            });
        }
        let mut walks = Vec::with_capacity(faces.column_count());
        let mut sides = Vec::new();
        for (face, column) in faces.columns().enumerate() {
            sides.clear();
            for (edge, entry) in column.iter() {
                sides.push(match entry {
                    1 => ends[edge],
                    -1 => [ends[edge][1], ends[edge][0]],
                    _ => {
                        return Err(Error::invalid(format!(
                            "face f{face} has the coefficient {entry} on edge e{edge}; only 1 and -1 are sides"
                        )));
                    }
                });
            }
            walks.push(closed_walks(&mut sides));
        }
        if self.source != RegionSource::Models {
            return self.add_parts_of_complex(
                name,
                model,
                (&walks, complex.boundary_matrix(3)),
                first,
                walls,
            );
        }
        let mut multiplicities = vec![1; walks.len()];
        if let Some(cells) = complex.boundary_matrix(3).filter(|cells| cells.column_count() > 0) {
            multiplicities.fill(0);
            for column in cells.columns() {
                let faces = || {
                    column.iter().flat_map(|(face, entry)| {
                        let sign = Sign::power_of_minus_one(usize::from(entry < 0));
                        walks[face].iter().map(move |walk| (sign, walk))
                    })
                };
                let outward = volume_sign(positions, faces);
                for (face, entry) in column.iter() {
                    multiplicities[face] += outward * entry;
                }
            }
        }
        for (face, walks) in walks.iter().enumerate() {
            if !walks.is_empty() && (walls || multiplicities[face] != 0) {
                self.push(face, multiplicities[face], first, &(0..walks.len()).map(|walk| walks.list(walk)));
            }
        }
        self.end_input(name, None);
        Ok(())
    }

    /// Adds the components of a chain complex, by the walks around its faces and its cells of degree 3.
    fn add_parts_of_complex(
        &mut self,
        name: &str,
        model: &Model,
        (face_walks, cells): (&[RaggedArray], Option<&SparseMatrix>),
        first: u32,
        walls: bool,
    ) -> Result<(), Error> {
        let lists = |face: usize| (0..face_walks[face].len()).map(move |walk| face_walks[face].list(walk));
        let Some(cells) = cells.filter(|cells| cells.column_count() > 0) else {
            let corners = RaggedArray::from_lists(face_walks.iter().map(RaggedArray::items));
            for part in self.parts_of(name, model, (&corners, GroupKind::Polygons))? {
                for face in part.members.into_iter().map(|face| face as usize) {
                    if !face_walks[face].is_empty() {
                        self.push(face, 1, first, &lists(face));
                    }
                }
                self.end_input(name, part.name);
            }
            return Ok(());
        };
        let mut corners = RaggedArray::new();
        for column in cells.columns() {
            corners.push(
                &column
                    .rows()
                    .iter()
                    .flat_map(|&face| face_walks[face as usize].items())
                    .copied()
                    .collect::<Vec<u32>>(),
            );
        }
        let mut multiplicities = vec![0; face_walks.len()];
        for part in self.parts_of(name, model, (&corners, GroupKind::Cells))? {
            let mut touched = Vec::new();
            for column in part.members.into_iter().map(|cell| cells.column(cell as usize)) {
                let faces = || {
                    column.iter().flat_map(|(face, entry)| {
                        let sign = Sign::power_of_minus_one(usize::from(entry < 0));
                        lists(face).map(move |walk| (sign, walk))
                    })
                };
                let outward = volume_sign(model.positions(), faces);
                for (face, entry) in column.iter().filter(|&(face, _)| !face_walks[face].is_empty()) {
                    multiplicities[face] += outward * entry;
                    touched.push(face as u32);
                }
            }
            self.push_faces(&mut multiplicities, touched, walls, first, lists);
            self.end_input(name, part.name);
        }
        Ok(())
    }

    /// The names of the inputs: of the models, or of their parts.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert_eq!(scene.names(), ["a", "b"]);
    /// # Ok(()) }
    /// ```
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The name of the model that an input is of.
    ///
    /// # Panics
    /// If there is no such input.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{RegionSource, SpatialScene};
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\no peak\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = SpatialScene::with_inputs([("a.obj", &solid)], RegionSource::Objects, true)?;
    /// assert_eq!((&scene.names()[0][..], scene.file_of_input(0)), ("peak", "a.obj"));
    /// # Ok(()) }
    /// ```
    pub fn file_of_input(&self, input: usize) -> &str {
        self.file(input).1
    }

    /// Whether parts of models are inputs.
    pub(super) fn has_parts(&self) -> bool {
        self.source != RegionSource::Models
    }

    /// That a file of this format has no names of inputs, where parts of models are inputs and it keeps none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{RegionSource, SpatialScene};
    /// use coface_io::Format;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\no peak\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), Format::Obj)?;
    /// let scene = SpatialScene::with_inputs([("a.obj", &solid)], RegionSource::Objects, true)?;
    /// assert!(scene.name_loss(Format::Off).is_some() && scene.name_loss(Format::Obj).is_none());
    /// # Ok(()) }
    /// ```
    pub fn name_loss(&self, format: Format) -> Option<Remark> {
        let keeps_names = matches!(format, Format::Obj | Format::Msh | Format::Medit);
        if keeps_names || !self.has_parts() {
            return None;
        }
        let (title, count) = (format.title(), self.names.len());
        let message = format!("a file of {title} does not keep the names of inputs: {count} left out");
        Some(Remark::new(RemarkCode::FormatKeepsLess, message).at(count, []))
    }

    /// What makes an input.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{RegionSource, SpatialScene};
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// assert_eq!(SpatialScene::of([("a", &solid)], true)?.source(), RegionSource::Models);
    /// # Ok(()) }
    /// ```
    pub fn source(&self) -> RegionSource {
        self.source
    }

    /// The number of polygons of all models.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert_eq!(scene.polygon_count(), 8);
    /// # Ok(()) }
    /// ```
    pub fn polygon_count(&self) -> usize {
        self.is_wall.len()
    }

    /// The polygons as input of an arrangement. The walls of model i are input i + n there, for n models.
    ///
    /// # Errors
    /// None for models that were read.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert_eq!(scene.polygons()?.polygon_count(), 8);
    /// # Ok(()) }
    /// ```
    pub fn polygons(&self) -> Result<SpatialPolygons, Error> {
        let count = self.names.len() as u32;
        let inputs = self.input_of_polygon.iter().zip(&self.is_wall);
        let inputs = inputs.map(|(&input, &is_wall)| if is_wall { input + count } else { input });
        let ((walks, polygon_of_walk), (positions, inputs)) = rayon::join(
            || (self.walks.clone(), self.polygon_of_walk.clone()),
            || (self.positions(), inputs.collect()),
        );
        let mut polygons = SpatialPolygons::new(positions?, walks, polygon_of_walk)?.with_inputs(inputs)?;
        if self.surfaces.iter().any(|own| !own.is_empty()) {
            let surface = |polygon: usize| {
                let file = self.file(self.input_of_polygon[polygon] as usize).0;
                let source = self.source_of_polygon[polygon] as usize;
                let own = self.surfaces[file].get(source).filter(|_| polygon < self.own_polygon_count());
                own.copied().unwrap_or(u32::MAX)
            };
            polygons = polygons.with_surfaces((0..self.polygon_count()).map(surface).collect())?;
        }
        self.exact
            .iter()
            .try_fold(polygons, |polygons, (first, own)| polygons.with_exact(*first, Arc::clone(own)))
    }

    /// Verifies that the polygons of each model are polygons, naming file and polygon.
    ///
    /// # Errors
    /// Those of [`SpatialPolygons::check`].
    pub(super) fn check(&self, non_planar: NonPlanar) -> Result<(), Error> {
        let own =
            self.polygon_of_walk.partition_point(|&polygon| (polygon as usize) < self.own_polygon_count());
        let walks_of_input = RaggedArray::grouped(
            self.names.len(),
            self.polygon_of_walk[..own].iter().map(|&polygon| self.input_of_polygon[polygon as usize]),
        );
        for (input, walks) in walks_of_input.iter().enumerate() {
            let Some(&walk) = walks.first() else { continue };
            // Points are numbered as in the file, polygons of this input from 0.
            let file = self.file(input).0;
            let point = self.point_starts[file];
            let end = self.point_starts.get(file + 1).filter(|&&next| next > point);
            let end = end.map_or(self.flat.len(), |&next| 3 * next as usize);
            let positions = Positions::from_flat(3, self.flat[3 * point as usize..end].to_vec())?;
            let lists = walks
                .iter()
                .map(|&walk| self.walks.list(walk as usize).iter().map(|v| v - point).collect::<Vec<u32>>());
            let start = self.polygon_of_walk[walk as usize];
            let polygons = walks.iter().map(|&walk| self.polygon_of_walk[walk as usize] - start).collect();
            SpatialPolygons::new(positions, RaggedArray::from_lists(lists), polygons)?
                .check(non_planar)
                .map_err(|error| error.in_file(self.label(input)))?;
        }
        Ok(())
    }

    /// The points of all models, one model after the other.
    ///
    /// # Errors
    /// None for models that were read.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert_eq!(scene.positions()?.len(), 8);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> Result<Positions, Error> {
        Positions::from_flat(3, self.flat.clone())
    }

    /// The model that each polygon is from.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert_eq!(scene.input_of_polygon(), [0, 0, 0, 0, 1, 1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn input_of_polygon(&self) -> &[u32] {
        &self.input_of_polygon
    }

    /// The number that each polygon has in its model: of the polygon in a surface, of the face of the cells in a volume.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert_eq!(scene.source_of_polygon(), [0, 1, 2, 3, 0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn source_of_polygon(&self) -> &[u32] {
        &self.source_of_polygon
    }

    /// Whether a polygon is a face between two cells of its model.
    ///
    /// # Panics
    /// If there is no such polygon.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert!((0..8).all(|polygon| !scene.is_wall(polygon)));
    /// # Ok(()) }
    /// ```
    pub fn is_wall(&self, polygon: usize) -> bool {
        self.is_wall[polygon]
    }

    /// The corners of a polygon, numbered as in its model.
    pub(super) fn corners(&self, polygon: u32) -> Vec<u32> {
        let walks = self.polygon_of_walk.partition_point(|&other| other < polygon);
        let own = (walks..self.walks.len()).take_while(|&walk| self.polygon_of_walk[walk] == polygon);
        let first = self.point_starts[self.file(self.input_of_polygon[polygon as usize] as usize).0];
        own.flat_map(|walk| self.walks.list(walk)).map(|vertex| vertex - first).collect()
    }

    /// What was assumed of the models, and what was left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert!(scene.remarks().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Whether all polygons are triangles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("a", &solid), ("b", &solid)], true)?;
    /// assert!(scene.is_triangulated());
    /// # Ok(()) }
    /// ```
    pub fn is_triangulated(&self) -> bool {
        self.walks.uniform_width() == Some(3) && self.walks.len() == self.is_wall.len()
    }

    /// The number of polygons that are no patches.
    pub(super) fn own_polygon_count(&self) -> usize {
        self.first_patch.unwrap_or_else(|| self.polygon_count())
    }

    /// The number of edges along which an input was open before its mouths were closed.
    pub(super) fn mouth_edges(&self, input: usize) -> Option<usize> {
        self.mouths.get(input)?.map(|mouths| mouths.edges)
    }
}

/// The surface of each polygon of a model that states surfaces with holes, for those that became several polygons.
fn surfaces_of(model: &Model) -> Vec<u32> {
    let Some(stated) = model.stated_surfaces() else { return Vec::new() };
    let mut surfaces = vec![u32::MAX; model.polygons().len()];
    let count = stated.faces().face_count();
    for face in 0..count {
        let start = stated.polygon_of_face(face) as usize;
        let end = if face + 1 < count { stated.polygon_of_face(face + 1) as usize } else { surfaces.len() };
        if start + 1 < end && end <= surfaces.len() {
            surfaces[start..end].fill(face as u32);
        }
    }
    surfaces
}

fn too_large() -> Error {
    Error::new(ErrorKind::TooLarge, "2^31 or more vertices, or 2^32 or more corners")
}
