//! The scene of a model.

use super::hidden::{Hidden, drawable};
use super::numbering::Numbering;
use super::parts::{Parts, common_width};
use super::pixels::model_of_pixels;
use super::regions::region_layers;
use super::shading::shaded;
use super::{Layer, Pane, SceneReport, layout};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_answers::answer::{InfoAnswer, Remark, RemarkCode};
use coface_answers::triangulated;
use coface_io::{Model, Structure};

/// What a picture shows: a model, and layers over it.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_pictures::Scene;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = io::read(&b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"[..], Format::Obj)?;
/// let scene = Scene::of("square", &square)?;
/// assert_eq!((scene.polygons().len(), scene.triangles().len()), (1, 2));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Scene {
    pub(super) title: String,
    pub(super) report: Option<SceneReport>,
    pub(super) dimension: usize,
    pub(super) origin: [f64; 3],
    pub(super) positions: Vec<[f64; 3]>,
    /// Texture coordinates of the vertices; empty if there are none.
    pub(super) texture: Vec<[f64; 2]>,
    pub(super) parts: Parts,
    pub(super) hidden: Hidden,
    pub(super) numbering: Numbering,
    /// What is drawn instead of the model, or was invented for it.
    pub(super) assumed: Option<Remark>,
    /// What is known of each 3-cell, or of each polygon where there are none; else empty.
    pub(super) notes: Vec<String>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) polygon_of_triangle: Vec<u32>,
    /// The 3-cell of each triangle; empty without 3-cells.
    pub(super) cell_of_triangle: Vec<u32>,
    pub(super) layers: Vec<Layer>,
    pub(super) panes: Vec<Pane>,
    /// Whether the model is drawn pale, as the ground for its layers.
    pub(super) is_pale: bool,
    /// Whether no triangle of the model is drawn: they would hide its layers.
    pub(super) has_wires_only: bool,
}

impl Scene {
    /// The scene of a model. Coordinates beyond the third are left out; complexes without positions are laid out. Vertices with a
    /// coordinate that is not finite are left out with the cells at them, as [`Self::remarks`] say.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for models without cells that could be seen; [`ErrorKind::InvalidInput`] if no vertex has
    /// finite coordinates; [`ErrorKind::TooLarge`] for facets with more than $2^{22}$ edges; those of [`triangulated`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!((scene.polygons().len(), scene.triangles().len()), (1, 2));
    /// # Ok(()) }
    /// ```
    pub fn of(title: &str, model: &Model) -> Result<Self, Error> {
        let subdivided;
        let mut assumed = None;
        let model = match model.structure() {
            Some(Structure::Halfedges { .. } | Structure::Gluings(_)) => {
                subdivided = triangulated(model)?.0;
                &subdivided
            }
            Some(Structure::Volume(volume)) if volume.shape().len() == 2 => {
                subdivided = model_of_pixels(volume, [volume.shape()[0], volume.shape()[1]])?;
                let count = subdivided.polygons().len();
                let message = format!("drawn: the {count} pixels of the image that are set, as squares");
                assumed = Some(Remark::new(RemarkCode::DrawnInstead, message).at(count, []));
                &subdivided
            }
            Some(Structure::Volume(_)) => {
                let (positions, squares) = model.voxel_surface()?.unwrap_or_default();
                let message = format!("drawn: the {} squares around the voxels of the volume", squares.len());
                assumed = Some(Remark::new(RemarkCode::DrawnInstead, message).at(squares.len(), []));
                subdivided = Model::from_polygons(positions, squares)?;
                &subdivided
            }
            Some(Structure::Chains(_)) if model.positions().is_empty() => {
                return Err(Error::new(
                    ErrorKind::UnsupportedFormat,
                    "a chain complex has no cells that could be seen",
                )
                .with_cure("show the model that it was made from"));
            }
            _ => model,
        };
        let placed;
        let (model, hidden) = match model.partial_positions() {
            Some(partial) => {
                let (drawn, hidden) = drawable(model, partial)?;
                placed = drawn;
                (&placed, hidden)
            }
            None => (model, Hidden::default()),
        };
        let mut parts = Parts::default();
        parts.add(model)?;
        let numbering = match model.structure() {
            Some(Structure::Facets(_)) if model.positions().is_empty() => {
                Numbering::compact([&mut parts.polygons, &mut parts.simplices])
            }
            _ => Numbering::default(),
        };
        let positions = match model.positions() {
            positions if !positions.is_empty() => {
                let at = |vertex: usize| {
                    let point = positions.point(VertexId::new(vertex));
                    [0, 1, 2].map(|axis| point.get(axis).copied().unwrap_or(0.0))
                };
                (0..model.vertex_count()).map(at).collect()
            }
            _ => {
                let count = parts.vertex_count(model);
                let message = "the model has no positions: its vertices were placed so that edges are about equally long";
                assumed = Some(Remark::new(RemarkCode::PositionsInvented, message).at(count, []));
                layout::laid_out(count, &parts.edges())
            }
        };
        let mut scene = Self { hidden, numbering, assumed, ..Self::flat(title, positions, parts) };
        scene.dimension = if model.positions().dimension() == 2 { 2 } else { 3 };
        if let Some([s, t]) = model.texture_coordinates() {
            scene.texture = (0..s.len()).map(|row| [s, t].map(|data| data.real_row(row)[0])).collect();
        }
        scene.shade();
        for layer in region_layers(model, &scene.positions) {
            scene.add_layer(layer);
        }
        Ok(scene)
    }

    /// A scene in the plane without shading.
    pub(super) fn flat(title: &str, positions: Vec<[f64; 3]>, parts: Parts) -> Self {
        Self {
            title: title.to_owned(),
            report: None,
            dimension: 2,
            origin: middle(&positions),
            positions,
            texture: Vec::new(),
            parts,
            hidden: Hidden::default(),
            numbering: Numbering::default(),
            assumed: None,
            notes: Vec::new(),
            triangles: Vec::new(),
            polygon_of_triangle: Vec::new(),
            cell_of_triangle: Vec::new(),
            layers: Vec::new(),
            panes: Vec::new(),
            is_pale: false,
            has_wires_only: false,
        }
    }

    /// The same with a report beside it; its witness and its problems become layers.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// let report = coface_answers::Report::of(square)?;
    /// assert!(scene.with_report(&report.answer(10)).document().report.is_some());
    /// # Ok(()) }
    /// ```
    pub fn with_report(mut self, report: &InfoAnswer) -> Self {
        // Cells of a volume are no cells of its boundary.
        if self.assumed.as_ref().is_none_or(|remark| remark.code != RemarkCode::DrawnInstead) {
            self.mark_problems(report);
        }
        self.report = Some(SceneReport::Model(Box::new(report.clone())));
        self
    }

    /// Layers of what is wrong.
    fn mark_problems(&mut self, report: &InfoAnswer) {
        let marks = report
            .problems
            .iter()
            .filter(|problem| !problem.cells.is_empty() && problem.points.is_empty())
            .map(|problem| (problem.kind.replace('_', " "), problem.count, &problem.message, &problem.cells));
        let mut found: Vec<(String, usize, &String, &Vec<Vec<u32>>)> = marks.collect();
        // The witness is one of the places of such a problem.
        if let Some(witness) = &report.manifold.witness
            && !found.iter().any(|mark| mark.0.starts_with("nonmanifold"))
        {
            found.push(("no manifold".to_owned(), 1, &witness.message, &witness.cells));
        }
        for (name, count, message, cells) in found {
            let mut layer = Layer::new("witness", name);
            layer.detail = if count > 1 { format!("{count}: {message}") } else { message.clone() };
            layer.is_on = true;
            for vertices in cells {
                if self.parts.cells.is_empty() && vertices.len() > 3 {
                    layer.push_fan(vertices);
                } else {
                    layer.push_simplex(vertices);
                }
            }
            self.push_layer(layer);
        }
    }

    /// Adds a layer, if there is something to be seen of it and its points are there; without what is at vertices that are left out. Its
    /// vertices have the numbers of the model.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Layer, Scene};
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let mut scene = Scene::of("square", &square)?;
    /// let mut layer = Layer::new("notes", "diagonal");
    /// layer.push_simplex(&[0, 2]);
    /// scene.push_layer(layer);
    /// assert_eq!(scene.layers()[0].name, "diagonal");
    /// # Ok(()) }
    /// ```
    pub fn push_layer(&mut self, layer: Layer) {
        self.add_layer(self.numbering.of_layer(layer));
    }

    /// The same for a layer whose vertices have the numbers of the scene.
    pub(super) fn add_layer(&mut self, layer: Layer) {
        let layer = self.hidden.seen_of(layer);
        let count = layer.positions.as_ref().unwrap_or(&self.positions).len();
        if !layer.is_empty() && layer.last_point().is_none_or(|last| (last as usize) < count) {
            self.layers.push(layer);
        }
    }

    /// Whether there are 3-cells.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert!(!scene.has_cells(), "a polygon is no 3-cell");
    /// # Ok(()) }
    /// ```
    pub fn has_cells(&self) -> bool {
        !self.parts.cells.is_empty()
    }

    /// What the scene leaves out of the model, shows instead of it, or invents for it.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// use coface_pictures::Scene;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 nan 1\nf 1 2 3\nf 1 2 4\n";
    /// let scene = Scene::of("two", &coface_io::read(text.as_bytes(), Format::Obj)?)?;
    /// assert_eq!((scene.polygons().len(), scene.remarks()[0].count), (1, 1));
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> Vec<Remark> {
        [self.assumed.clone(), self.hidden.remark(), self.parts.remark()].into_iter().flatten().collect()
    }

    /// Whether the model is drawn pale, and whether by its edges alone.
    pub(crate) fn is_pale(&self) -> [bool; 2] {
        [self.is_pale, self.has_wires_only]
    }

    /// Whether this vertex of the model is left out.
    pub(crate) fn is_hidden(&self, vertex: u32) -> bool {
        self.hidden.has(vertex)
    }

    /// What it is called.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.title(), "square");
    /// # Ok(()) }
    /// ```
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The positions of the vertices. The vertices of a facet list are those that lie in a facet, in the order of their numbers.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.positions().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &[[f64; 3]] {
        &self.positions
    }

    /// Texture coordinates of the vertices, for [`gltf`](crate::gltf); empty if the model has none.
    pub(crate) fn texture(&self) -> &[[f64; 2]] {
        &self.texture
    }

    /// The polygons, those around 3-cells included, by the vertices around them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.polygons().list(0), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn polygons(&self) -> &RaggedArray {
        &self.parts.polygons
    }

    /// Further walks around polygons: their holes.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert!(scene.rims().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn rims(&self) -> &RaggedArray {
        &self.parts.rims
    }

    /// The number of coordinates that matter: 2 for drawings, else 3.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.dimension(), 3, "an OBJ is in space, also where z = 0");
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The sides of polygons and the edges of simplices, rising and each once. $O(n \log n)$.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.edges(), [[0, 1], [0, 3], [1, 2], [2, 3]]);
    /// # Ok(()) }
    /// ```
    pub fn edges(&self) -> Vec<[u32; 2]> {
        self.parts.edges()
    }

    /// What is shaded.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.triangles().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// What is drawn over the model.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert!(scene.layers().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// The pictures beside the model.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert!(scene.panes().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn panes(&self) -> &[Pane] {
        &self.panes
    }

    fn shade(&mut self) {
        let mut rims_of_polygon =
            vec![Vec::new(); if self.parts.rims.is_empty() { 0 } else { self.parts.polygons.len() }];
        for (rim, &polygon) in self.parts.polygon_of_rim.iter().enumerate() {
            rims_of_polygon[polygon as usize].push(rim);
        }
        let at = |&vertex: &u32| self.positions[vertex as usize];
        let shade = |(polygon, walk): (usize, &[u32])| -> Vec<[u32; 3]> {
            let rims = rims_of_polygon.get(polygon).map_or(&[][..], Vec::as_slice);
            let walks = std::iter::once(walk).chain(rims.iter().map(|&rim| self.parts.rims.list(rim)));
            let vertices: Vec<u32> = walks.clone().flatten().copied().collect();
            let corners: Vec<[f64; 3]> = vertices.iter().map(at).collect();
            let lengths: Vec<usize> = walks.map(<[u32]>::len).collect();
            shaded(&corners, &lengths)
                .into_iter()
                .map(|triangle| triangle.map(|i| vertices[i as usize]))
                .collect()
        };
        if self.parts.cells.is_empty()
            && self.parts.rims.is_empty()
            && common_width(&self.parts.polygons) == Some(3)
        {
            self.triangles = self.parts.polygons.iter().map(|walk| [walk[0], walk[1], walk[2]]).collect();
            self.polygon_of_triangle = (0..self.triangles.len() as u32).collect();
            return;
        }
        let shaded_polygons: Vec<Vec<[u32; 3]>> = self.parts.polygons.iter().enumerate().map(shade).collect();
        let mut in_cell = vec![false; self.parts.polygons.len()];
        for (cell, polygons) in self.parts.cells.iter().enumerate() {
            for &polygon in polygons {
                in_cell[polygon as usize] = true;
                for &triangle in &shaded_polygons[polygon as usize] {
                    self.triangles.push(triangle);
                    self.polygon_of_triangle.push(polygon);
                    self.cell_of_triangle.push(cell as u32);
                }
            }
        }
        let has_cells = !self.parts.cells.is_empty();
        for (polygon, triangles) in shaded_polygons.into_iter().enumerate().filter(|(p, _)| !in_cell[*p]) {
            for triangle in triangles {
                self.triangles.push(triangle);
                self.polygon_of_triangle.push(polygon as u32);
                if has_cells {
                    self.cell_of_triangle.push(u32::MAX);
                }
            }
        }
    }
}

/// The middle of the box around points.
fn middle(positions: &[[f64; 3]]) -> [f64; 3] {
    let bounds = |axis: usize| {
        positions
            .iter()
            .map(|point| point[axis])
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    [0, 1, 2].map(|axis| {
        let [low, high] = bounds(axis);
        if low <= high { 0.5 * low + 0.5 * high } else { 0.0 }
    })
}
