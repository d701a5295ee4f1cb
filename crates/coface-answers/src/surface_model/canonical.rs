//! Surfaces cut to canonical polygons.

use super::cutting::{CutComponent, CutSeam, SurfaceCut, counted};
use super::{SurfaceModel, edge_lengths, renumbered};
use crate::answer::{RefinedVertex, RefinementAnswer};
use coface_algebra::progress::stage;
use coface_algebra::{Error, VertexId, Word};
use coface_io::{CellData, GroupKind, placed};
use coface_topology::{CanonicalComponent, CanonicalCut, CurveKind, Refinement};
use std::borrow::Cow;

impl SurfaceModel {
    /// Refines the surface and cuts it along canonical curves.
    pub(super) fn cut_canonically(&self, base: Option<VertexId>) -> Result<SurfaceCut<'static>, Error> {
        let cut = CanonicalCut::new(self.map(), base)
            .map_err(|error| renumbered(error, self.numbers.as_deref()))?;
        let _cutting = stage("cutting", 0);
        let surface = self.refined(cut.refinement())?;
        let lengths = edge_lengths(surface.map().skeleton(), &surface.positions);
        let (slice, edges) = (cut.slice(), cut.edges());
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
