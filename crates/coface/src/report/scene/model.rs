//! The scene of a model.

use super::shading::shaded;
use super::{Layer, Pane, layout};
use crate::algebra::RaggedArray;
use crate::io::{Model, Structure};
use crate::report::triangulated;
use crate::{Error, ErrorKind, VertexId};
use serde_json::Value;

/// What a picture shows: a model, and layers over it.
///
/// # Examples
/// ```
/// use coface::io::{self, Format};
/// use coface::report::Scene;
/// # fn main() -> Result<(), coface::Error> {
/// let square = io::read(&b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"[..], Format::Obj)?;
/// let scene = Scene::of("square", &square)?;
/// assert_eq!((scene.polygons().len(), scene.triangles().len()), (1, 2));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Scene {
    pub(super) title: String,
    pub(super) report: Value,
    pub(super) dimension: usize,
    pub(super) origin: [f64; 3],
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) polygons: RaggedArray,
    pub(super) simplices: RaggedArray,
    /// The polygons around each 3-cell.
    pub(super) cells: RaggedArray,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) polygon_of_triangle: Vec<u32>,
    /// The 3-cell of each triangle; empty without 3-cells.
    pub(super) cell_of_triangle: Vec<u32>,
    pub(super) layers: Vec<Layer>,
    pub(super) panes: Vec<Pane>,
}

impl Scene {
    /// The scene of a model. Coordinates beyond the third are left out; complexes without positions are laid out.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for models without cells that could be seen; those of [`triangulated`].
    pub fn of(title: &str, model: &Model) -> Result<Self, Error> {
        let subdivided;
        let model = match model.structure() {
            Some(Structure::Halfedges { .. } | Structure::Gluings(_)) => {
                subdivided = triangulated(model)?.0;
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
        let mut parts = Parts::default();
        parts.add(model);
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
                layout::laid_out(count, &edges_of(&parts.polygons, &parts.simplices))
            }
        };
        let mut scene = Self {
            title: title.to_owned(),
            report: Value::Null,
            dimension: if model.positions().dimension() == 2 { 2 } else { 3 },
            origin: middle(&positions),
            positions,
            polygons: parts.polygons,
            simplices: parts.simplices,
            cells: parts.cells,
            triangles: Vec::new(),
            polygon_of_triangle: Vec::new(),
            cell_of_triangle: Vec::new(),
            layers: Vec::new(),
            panes: Vec::new(),
        };
        scene.shade();
        Ok(scene)
    }

    /// The same with a report beside it, as JSON; its witness becomes a layer.
    pub fn with_report(mut self, report: Value) -> Self {
        if let Some(witness) = report["manifold"]["witness"].as_object() {
            let mut layer = Layer::new("witness", "not a manifold");
            layer.detail = witness.get("message").and_then(Value::as_str).unwrap_or_default().to_owned();
            layer.is_on = true;
            for cell in witness.get("cells").and_then(Value::as_array).into_iter().flatten() {
                layer.push_simplex(&super::results::vertices(cell));
            }
            self.push_layer(layer);
        }
        self.report = report;
        self
    }

    /// Adds a layer, if there is something to be seen of it and its points are there.
    pub fn push_layer(&mut self, layer: Layer) {
        let count = layer.positions.as_ref().unwrap_or(&self.positions).len();
        if !layer.is_empty() && layer.last_point().is_none_or(|last| (last as usize) < count) {
            self.layers.push(layer);
        }
    }

    /// The positions of the vertices.
    pub fn positions(&self) -> &[[f64; 3]] {
        &self.positions
    }

    /// The polygons, those around 3-cells included, by the vertices around them.
    pub fn polygons(&self) -> &RaggedArray {
        &self.polygons
    }

    /// The number of coordinates that matter: 2 for drawings, else 3.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The sides of polygons and the edges of simplices, rising and each once. $O(n \log n)$.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        edges_of(&self.polygons, &self.simplices)
    }

    /// What is shaded.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// What is drawn over the model.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// The pictures beside the model.
    pub fn panes(&self) -> &[Pane] {
        &self.panes
    }

    fn shade(&mut self) {
        let shaded_polygons: Vec<Vec<[u32; 3]>> = self
            .polygons
            .iter()
            .map(|walk| {
                let corners: Vec<[f64; 3]> = walk.iter().map(|&v| self.positions[v as usize]).collect();
                shaded(&corners).into_iter().map(|triangle| triangle.map(|i| walk[i as usize])).collect()
            })
            .collect();
        let mut in_cell = vec![false; self.polygons.len()];
        for (cell, polygons) in self.cells.iter().enumerate() {
            for &polygon in polygons {
                in_cell[polygon as usize] = true;
                for &triangle in &shaded_polygons[polygon as usize] {
                    self.triangles.push(triangle);
                    self.polygon_of_triangle.push(polygon);
                    self.cell_of_triangle.push(cell as u32);
                }
            }
        }
        let has_cells = !self.cells.is_empty();
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

/// The cells of a model for drawing.
#[derive(Default)]
struct Parts {
    polygons: RaggedArray,
    simplices: RaggedArray,
    cells: RaggedArray,
}

impl Parts {
    fn add(&mut self, model: &Model) {
        for polygon in model.polygons().iter() {
            self.polygons.push(polygon);
        }
        for line in model.lines().iter() {
            line.windows(2).for_each(|edge| self.simplices.push(edge));
        }
        for point in model.points() {
            self.simplices.push(&[point.to_u32()]);
        }
        if let Some(Structure::Facets(facets)) = model.structure() {
            self.add_facets(facets);
        }
        self.add_cells(model);
    }

    /// Facets: triangles are polygons, and so are the triangles of higher simplices, each once.
    fn add_facets(&mut self, facets: &RaggedArray) {
        let mut triangles: Vec<[u32; 3]> = Vec::new();
        for facet in facets.iter() {
            if let &[a, b, c] = facet {
                let mut sorted = [a, b, c];
                sorted.sort_unstable();
                triangles.push(sorted);
                continue;
            }
            self.simplices.push(facet);
            let mut sorted = facet.to_vec();
            sorted.sort_unstable();
            for (i, &a) in sorted.iter().enumerate() {
                for (j, &b) in sorted.iter().enumerate().skip(i + 1) {
                    triangles.extend(sorted.iter().skip(j + 1).map(|&c| [a, b, c]));
                }
            }
        }
        triangles.sort_unstable();
        triangles.dedup();
        triangles.iter().for_each(|triangle| self.polygons.push(triangle));
    }

    /// 3-cells by their polygons; a polygon between two cells, or in the list of polygons too, is one.
    fn add_cells(&mut self, model: &Model) {
        if model.cells().is_empty() {
            return;
        }
        let own = self.polygons.len();
        let mut faces: Vec<(Vec<u32>, u32, Vec<u32>)> = Vec::new();
        let key = |walk: &[u32]| {
            let mut sorted = walk.to_vec();
            sorted.sort_unstable();
            sorted
        };
        faces.extend(self.polygons.iter().map(|walk| (key(walk), u32::MAX, Vec::new())));
        for (cell, (shape, vertices)) in model.shapes().iter().zip(model.cells().iter()).enumerate() {
            for face in shape.faces() {
                let walk: Vec<u32> = face.iter().map(|&i| vertices[i]).collect();
                faces.push((key(&walk), cell as u32, walk));
            }
        }
        let mut order: Vec<u32> = (0..faces.len() as u32).collect();
        order.sort_by(|&a, &b| faces[a as usize].0.cmp(&faces[b as usize].0).then(a.cmp(&b)));
        let mut polygons_of_cell = vec![Vec::new(); model.cells().len()];
        for group in order.chunk_by(|&a, &b| faces[a as usize].0 == faces[b as usize].0) {
            let first = group[0] as usize;
            let polygon = if first < own {
                first as u32
            } else {
                self.polygons.push(&faces[first].2);
                self.polygons.len() as u32 - 1
            };
            for &face in group.iter().filter(|&&face| face as usize >= own) {
                polygons_of_cell[faces[face as usize].1 as usize].push(polygon);
            }
        }
        self.cells = RaggedArray::from_lists(polygons_of_cell);
    }

    fn vertex_count(&self, model: &Model) -> usize {
        let used = self.polygons.items().iter().chain(self.simplices.items());
        used.max().map_or(0, |&last| last as usize + 1).max(model.vertex_count())
    }
}

fn edges_of(polygons: &RaggedArray, simplices: &RaggedArray) -> Vec<[u32; 2]> {
    let mut edges = Vec::new();
    for walk in polygons.iter() {
        edges.extend((0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]));
    }
    for simplex in simplices.iter() {
        for (i, &a) in simplex.iter().enumerate() {
            edges.extend(simplex[i + 1..].iter().map(|&b| [a, b]));
        }
    }
    edges.iter_mut().for_each(|edge| edge.sort_unstable());
    edges.sort_unstable();
    edges.dedup();
    edges
}
