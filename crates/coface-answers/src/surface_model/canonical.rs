//! Surfaces cut to canonical polygons.

use super::cutting::{CutComponent, CutSeam, SurfaceCut, counted};
use super::{SurfaceModel, edge_lengths, renumbered};
use crate::answer::{RefinedVertex, RefinementAnswer, Remark, RemarkCode};
use crate::text::count;
use coface_algebra::progress::stage;
use coface_algebra::{Error, FaceId, Sign, VertexId, Word};
use coface_complexes::surface::{GeneralizedMap, Slice};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use coface_io::{CellData, GroupKind, placed};
use coface_topology::{CanonicalComponent, CanonicalCut, CurveKind, PolygonPlane, Refinement};
use std::borrow::Cow;
use std::cmp::Ordering;

/// By which weights the vertices of a layout are in balance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LayoutWeights {
    /// All edges pull alike.
    #[default]
    Uniform,
    /// Cotangents on the intrinsic Delaunay triangulation, which keep angles better.
    Cotangent,
}

impl LayoutWeights {
    /// The word for it: `uniform` or `cotangent`.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::LayoutWeights::Cotangent.word(), "cotangent");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Cotangent => "cotangent",
        }
    }
}

/// How canonical polygons are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LayoutRequest {
    /// The plane of the regular polygons.
    pub plane: PolygonPlane,
    /// The weights of edges.
    pub weights: LayoutWeights,
    /// Whether the mesh stays where it is, and the layout becomes its texture coordinates.
    pub as_texture: bool,
}

impl Default for LayoutRequest {
    /// Euclidean, by uniform weights, as the places of the vertices.
    fn default() -> Self {
        Self { plane: PolygonPlane::Euclidean, weights: LayoutWeights::Uniform, as_texture: false }
    }
}

/// Canonical polygons in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedPolygons {
    request: LayoutRequest,
    points: Vec<[f64; 2]>,
    triangle_count: usize,
    turned: usize,
}

impl PlacedPolygons {
    fn new(
        cut: &CanonicalCut,
        slice: &Slice<GeneralizedMap>,
        request: LayoutRequest,
        lengths: Option<&[f64]>,
    ) -> Result<Self, Error> {
        let _laying = stage("laying out", 0);
        let points = cut.layout(slice, request.plane, lengths)?;
        let open = slice.surface();
        let components = open.orientation();
        // How the triangles of each component that run with the first one are turned.
        let mut counts = vec![[0_usize; 2]; cut.components().len()];
        let faces = (0..open.face_count()).map(FaceId::new);
        for face in faces {
            let corners: Vec<[f64; 2]> =
                open.sides_of(face).map(|side| points[open.source(side).index()]).collect();
            let &[p, q, r] = &corners[..] else { continue };
            let is_against = components.signs()[face.index()] == Sign::Minus;
            let turn = match orientation(p, q, r) {
                Ordering::Equal => continue,
                turn => usize::from((turn == Ordering::Greater) != is_against),
            };
            counts[components.component(face)][turn] += 1;
        }
        let triangle_count = open.face_count();
        let well: usize = counts.iter().map(|[left, right]| *left.max(right)).sum();
        Ok(Self { request, points, triangle_count, turned: triangle_count - well })
    }

    /// What was asked for.
    pub(crate) fn request(&self) -> LayoutRequest {
        self.request
    }

    /// The points of the vertices of the cut surface; components lie beside each other, 2.5 apart.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, LayoutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let request = CutRequest { layout: Some(LayoutRequest::default()), ..CutRequest::default() };
    /// let cut = surface.cut_open(&request)?;
    /// let placed = cut.placed().ok_or(coface_algebra::Error::invalid("it was asked for"))?;
    /// // A square in the unit circle.
    /// assert!(placed.points().iter().all(|[x, y]| x.abs() + y.abs() < 1.0 + 1e-12));
    /// # Ok(()) }
    /// ```
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// How many triangles are turned over or flat, decided exactly on the coordinates: as a rule 0, but for triangles too small for
    /// doubles, and those that cotangent weights turn over.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, LayoutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let request = CutRequest { layout: Some(LayoutRequest::default()), ..CutRequest::default() };
    /// let cut = surface.cut_open(&request)?;
    /// let placed = cut.placed().ok_or(coface_algebra::Error::invalid("it was asked for"))?;
    /// assert_eq!(placed.turned(), 0);
    /// # Ok(()) }
    /// ```
    pub fn turned(&self) -> usize {
        self.turned
    }

    /// The number of triangles.
    pub(crate) fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// What is to be said if triangles are turned over.
    pub(crate) fn remark(&self) -> Option<Remark> {
        if self.turned == 0 {
            return None;
        }
        let triangles = count(self.turned, "triangle");
        let why = match self.request.weights {
            LayoutWeights::Uniform => "too small for floating point",
            LayoutWeights::Cotangent => {
                "flipped edges make them so, or they are too small; uniform weights turn none over but for rounding"
            }
        };
        let message =
            format!("{triangles} of {} turned over or flat in the layout: {why}", self.triangle_count);
        Some(Remark::new(RemarkCode::TrianglesTurned, message).at(self.turned, []))
    }

    /// The plane of the polygons: `polygon` or `klein`.
    pub(crate) fn plane_word(&self) -> &'static str {
        match self.request.plane {
            PolygonPlane::Euclidean => "polygon",
            PolygonPlane::Klein => "klein",
        }
    }

    /// The places of the vertices, unless the mesh stays where it is.
    pub(super) fn positions(&self) -> Result<Option<Positions>, Error> {
        if self.request.as_texture {
            return Ok(None);
        }
        Positions::from_flat(3, self.points.iter().flat_map(|&[x, y]| [x, y, 0.0]).collect()).map(Some)
    }

    /// The layout as data `s` and `t` of vertices, between 0 and 1, if the mesh stays where it is.
    pub(super) fn texture_coordinates(&self) -> impl Iterator<Item = Result<CellData, Error>> {
        let width = self.points.iter().map(|point| point[0] + 1.0).fold(2.0, f64::max);
        let names = if self.request.as_texture { &["s", "t"][..] } else { &[] };
        names.iter().enumerate().map(move |(axis, name)| {
            let values = self.points.iter().map(|point| ((point[axis] + 1.0) / width).clamp(0.0, 1.0));
            CellData::reals(*name, GroupKind::Vertices, 1, values.collect())
        })
    }
}

impl SurfaceModel {
    /// Refines the surface and cuts it along canonical curves.
    pub(super) fn cut_canonically(
        &self,
        base: Option<VertexId>,
        layout: Option<LayoutRequest>,
    ) -> Result<SurfaceCut<'static>, Error> {
        let of_file = |error| renumbered(error, self.numbers.as_deref());
        let mut cut = CanonicalCut::new(self.map(), base).map_err(of_file)?;
        if layout.is_some() {
            let _straightening = stage("splitting edges", 0);
            cut = cut.straightened()?;
        }
        let _cutting = stage("cutting", 0);
        let surface = self.refined(cut.refinement())?;
        let lengths = edge_lengths(surface.map().skeleton(), &surface.positions);
        let (slice, edges) = (cut.slice(), cut.edges());
        let placed = layout.map(|request| {
            let wanted = match request.weights {
                LayoutWeights::Uniform => None,
                LayoutWeights::Cotangent => Some(lengths.as_deref().ok_or_else(|| {
                    Error::invalid("the model has no positions, so angles have no cotangents")
                        .with_cure("take uniform weights")
                })?),
            };
            PlacedPolygons::new(&cut, &slice, request, wanted)
        });
        let placed = placed.transpose()?;
        let orientation = surface.map().orientation();
        let mut components = counted(surface.map(), &slice, &edges, cut.components().len(), |face| {
            orientation.component(face)
        });
        let mut seams = Vec::new();
        for (i, (component, found)) in components.iter_mut().zip(cut.components()).enumerate() {
            let first_seam = seams.len();
            for curve in found.curves().iter().filter(|curve| curve.kind() != CurveKind::Boundary) {
                let length = |lengths: &Vec<f64>| {
                    curve.steps().iter().map(|&step| lengths[(step >> 1) as usize]).sum()
                };
                seams.push(CutSeam {
                    kind: curve.kind().to_string(),
                    name: Some(curve.name().to_owned()),
                    is_reversing: curve.kind() == CurveKind::Crosscap,
                    steps: curve.steps().to_vec(),
                    length: lengths.as_ref().map(length),
                    component: i,
                });
            }
            component.seams = (first_seam..seams.len()).collect();
            surface.describe(found, component);
        }
        let refinement = Some(self.what_is_new(&surface, cut.refinement()));
        Ok(SurfaceCut {
            surface: Cow::Owned(surface),
            slice,
            edges,
            seams,
            components,
            is_simplified: false,
            is_long: false,
            roles: None,
            refinement,
            placed,
        })
    }

    /// Fills in what a component is and the words around it.
    fn describe(&self, found: &CanonicalComponent, component: &mut CutComponent) {
        let surface = found.surface();
        let is_closed = surface.boundary_count() == 0;
        (component.surface, component.genus) = (surface.to_string(), surface.genus());
        let start = |step: u32| VertexId::from_u32(self.map.skeleton().edge_ends()[step as usize]);
        // A disk is not cut; it begins where its boundary does.
        let base = found.base().unwrap_or_else(|| start(found.curves()[0].steps()[0]));
        component.base = Some(self.number(base));
        component.generators = (1 - surface.euler_characteristic() + i64::from(is_closed)) as usize;
        let is_seam =
            |letter: &i32| found.curves()[letter.unsigned_abs() as usize - 1].kind() != CurveKind::Boundary;
        component.word = found.word().iter().copied().filter(is_seam).collect();
        component.relator = is_closed.then(|| Word::from_letters(component.word.iter().copied()));
        let names: Vec<String> = (found.word().iter())
            .map(|&letter| {
                let name = found.curves()[letter.unsigned_abs() as usize - 1].name();
                if letter < 0 { format!("{name}^-1") } else { name.to_owned() }
            })
            .collect();
        component.canonical = Some(names.join(" "));
    }

    /// This surface refined. New vertices have the numbers after those of the file and lie where their weights say; of their data reals are
    /// means, and whole numbers are those of the vertex of the greatest weight.
    fn refined(&self, refinement: &Refinement) -> Result<Self, Error> {
        let map = refinement.map().clone();
        let old = self.map.vertex_count();
        let vertices = || (0..map.vertex_count()).map(VertexId::new);
        let (dimension, given) = match &self.partial_positions {
            Some(partial) => (partial.dimension(), partial.as_flat()),
            None => (self.positions.dimension(), self.positions.as_flat()),
        };
        let mean = |vertex: VertexId, axis: usize| -> f64 {
            let weights = refinement.weights(vertex).iter();
            weights.map(|&(under, weight)| weight * given[under.index() * dimension + axis]).sum()
        };
        let points = vertices().flat_map(|vertex| (0..dimension).map(move |axis| (vertex, axis)));
        let (positions, partial_positions) =
            placed(dimension, points.map(|(vertex, axis)| mean(vertex, axis)).collect())?;
        let of_data = self.data.iter().filter(|data| data.kind() == GroupKind::Vertices).map(CellData::len);
        let used = (0..old).map(|vertex| self.number(VertexId::new(vertex)) as usize + 1);
        let first_new = of_data.chain(used).max().unwrap_or(0) as u32;
        let numbers = vertices().map(|vertex| match vertex.index().checked_sub(old) {
            None => self.number(vertex),
            Some(new) => first_new + new as u32,
        });
        let faces = refinement.face_sources().iter().map(|&face| self.polygon(face));
        let mut data = Vec::with_capacity(self.data.len());
        for array in &self.data {
            data.push(if array.kind() == GroupKind::Vertices {
                self.means(array, refinement)?
            } else {
                array.clone()
            });
        }
        Ok(Self {
            positions,
            partial_positions,
            numbers: Some(numbers.collect()),
            polygons: Some(faces.collect()),
            groups: self.groups.clone(),
            data,
            map,
        })
    }

    /// Data of vertices with those of the new vertices after them.
    fn means(&self, data: &CellData, refinement: &Refinement) -> Result<CellData, Error> {
        let new = || (self.map.vertex_count()..refinement.map().vertex_count()).map(VertexId::new);
        if data.is_integral() {
            let nearest = |vertex: VertexId| {
                let weights = refinement.weights(vertex).iter().copied();
                let nearest = weights.reduce(|best, other| if other.1 > best.1 { other } else { best });
                self.number(nearest.expect("every vertex has weights").0) as usize
            };
            return Ok(data.taken_from((0..data.len()).chain(new().map(nearest))));
        }
        let mut values: Vec<f64> = (0..data.len()).flat_map(|row| data.real_row(row)).collect();
        for vertex in new() {
            let first = values.len();
            values.resize(first + data.components(), 0.0);
            for &(under, weight) in refinement.weights(vertex) {
                let row = data.real_row(self.number(under) as usize);
                values[first..].iter_mut().zip(row).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        CellData::reals(data.name(), GroupKind::Vertices, data.components(), values)
    }

    /// The vertices that were added.
    fn what_is_new(&self, surface: &Self, refinement: &Refinement) -> RefinementAnswer {
        let new = (self.map.vertex_count()..surface.map.vertex_count()).map(VertexId::new);
        let vertices = new.map(|vertex| RefinedVertex {
            vertex: surface.number(vertex),
            of: refinement.weights(vertex).iter().map(|&(under, _)| self.number(under)).collect(),
            weights: refinement.weights(vertex).iter().map(|&(_, weight)| weight).collect(),
        });
        RefinementAnswer { f_vector: surface.map.f_vector(), vertices: vertices.collect() }
    }
}
