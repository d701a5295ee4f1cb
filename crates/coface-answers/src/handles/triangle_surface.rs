//! Closed surfaces of triangles in space, of whatever polygons a model holds.

use crate::answer::{HandleCounts, Place, Remark, RemarkCode};
use crate::repair::PolygonsOf;
use coface_algebra::{Error, ErrorKind, RaggedArray, Sign};
use coface_arrange::spatial::checks::meeting_triangles;
use coface_complexes::surface::{GeneralizedMap, PolygonMesh};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use coface_geometry::triangulation::triangulate;
use coface_io::{CellData, Group, GroupKind, Model, ModelParts, placed};

/// The triangles of a model, all turned to agree.
pub(super) struct TriangleSurface {
    given: PolygonsOf,
    pub(super) points: Vec<[f64; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The polygon that each triangle is a part of, or was made beside.
    pub(super) sources: Vec<u32>,
    /// The vertex that each vertex was, or was made of.
    pub(super) vertex_sources: Vec<u32>,
    /// How many polygons were cut into triangles.
    cut: Vec<u32>,
}

impl TriangleSurface {
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for models that are no polygons; [`ErrorKind::InvalidInput`] without three coordinates a vertex, and where
    /// two triangles meet; [`ErrorKind::NonManifold`] for what is no closed orientable surface.
    pub(super) fn of(model: &Model) -> Result<Self, Error> {
        let given = PolygonsOf::new(model).map_err(|error| {
            Error::new(error.kind(), "only surfaces of polygons have handle loops and tunnel loops")
                .with_cure("give polygons with positions in space")
        })?;
        let model = &given.model;
        model.require_finite()?;
        if model.positions().dimension() != 3 {
            return Err(Error::invalid("the model has no positions in space, which decide what is inside")
                .with_cure("give a surface with three coordinates a vertex"));
        }
        let points = model.positions().as_flat().as_chunks::<3>().0.to_vec();
        let (mut triangles, mut sources, mut cut) = (Vec::new(), Vec::new(), Vec::new());
        for (number, polygon) in (0u32..).zip(model.polygons().iter()) {
            match *polygon {
                [a, b, c] => triangles.push([a, b, c]),
                _ => {
                    cut.push(number);
                    triangles.extend(triangles_of(polygon, &points));
                }
            }
            sources.resize(triangles.len(), number);
        }
        let vertex_sources = (0..points.len() as u32).collect();
        let mut surface = Self { given, points, triangles, sources, vertex_sources, cut };
        let map = surface.map().map_err(|error| match error.kind() {
            ErrorKind::NonManifold => error.with_cure("give a surface that touches itself nowhere"),
            _ => error,
        })?;
        surface.turn_to_agree(&map)?;
        surface.check_meetings()?;
        Ok(surface)
    }

    /// The surface by its sides.
    pub(super) fn map(&self) -> Result<GeneralizedMap, Error> {
        let polygons = RaggedArray::from_lists(&self.triangles);
        GeneralizedMap::new(PolygonMesh::new(self.points.len(), polygons, &[])?.two_skeleton()?)
    }

    pub(super) fn positions(&self) -> Positions {
        Positions::from_flat(3, self.points.as_flattened().to_vec()).expect("points are finite")
    }

    /// The number of a vertex in the file; vertices that were added come after all others.
    pub(super) fn number_of(&self, vertex: u32) -> u32 {
        let Some(labels) = &self.given.labels else { return vertex };
        let count = self.given.model.vertex_count() as u32;
        let Some(behind) = vertex.checked_sub(count) else { return labels.of(vertex) };
        labels.of(count - 1).saturating_add(1 + behind)
    }

    fn turn_to_agree(&mut self, map: &GeneralizedMap) -> Result<(), Error> {
        // A surface with one side cannot be closed to one that has an inside.
        let turned = map.orientation();
        if let Some(edge) = turned.conflicts().iter().flatten().next() {
            let ends = map.skeleton().edge(*edge).map(|end| self.number_of(end.to_u32()));
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!("the faces at edge {} {} cannot be turned to agree: a surface that is not orientable has no inside", ends[0], ends[1]),
            )
            .with_cure("leave --handles out: coface cycles INPUT"));
        }
        if let Some(side) = map.sides().find(|&side| map.mate(side).is_none()) {
            let ends = map.skeleton().edge(map.edge(side)).map(|end| self.number_of(end.to_u32()));
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!("edge {} {} lies in one face only: an open surface has no inside", ends[0], ends[1]),
            )
            .with_cure("close it first: coface convert INPUT --repair closed -o OUT.off"));
        }
        for (triangle, sign) in self.triangles.iter_mut().zip(turned.signs()) {
            if *sign == Sign::Minus {
                triangle.swap(1, 2);
            }
        }
        Ok(())
    }

    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming two triangles that meet.
    pub(super) fn check_meetings(&self) -> Result<(), Error> {
        let found = meeting_triangles(&self.positions(), &self.triangles, &|_| true)?;
        let Some(&[a, b]) = found.first() else { return Ok(()) };
        let [first, second] = [a, b].map(|triangle| {
            self.triangles[triangle as usize].map(|v| self.number_of(v).to_string()).join(" ")
        });
        let message = if a == b {
            format!("the triangle {first} has no area")
        } else {
            format!(
                "the triangles {first} and {second} meet beside their common vertices: a surface that meets itself has no inside"
            )
        };
        Err(Error::invalid(message).with_cure(
            "make it the boundary of a solid first: coface boolean union INPUT --pinches split -o OUT.off",
        ))
    }

    /// The lengths of the edges.
    pub(super) fn lengths(&self, map: &GeneralizedMap) -> Result<Vec<f64>, Error> {
        self.positions().distances(map.skeleton().edge_ends())
    }

    pub(super) fn counts(&self, map: &GeneralizedMap) -> HandleCounts {
        let components = map.surfaces().len();
        let mut is_used = vec![false; self.points.len()];
        self.triangles.as_flattened().iter().for_each(|&vertex| is_used[vertex as usize] = true);
        let vertices = is_used.into_iter().filter(|used| *used).count();
        let [edges, faces] = [map.edge_count(), map.face_count()];
        let euler_characteristic = vertices as i64 - edges as i64 + faces as i64;
        HandleCounts {
            f_vector: [vertices, edges, faces],
            components,
            euler_characteristic,
            genus: ((2 * components as i64 - euler_characteristic) / 2).max(0) as usize,
            closed: map.sides().all(|side| map.mate(side).is_some()),
            orientable: map.orientation().conflicts().iter().all(Option::is_none),
        }
    }

    /// What was done to the polygons of the model.
    pub(super) fn remarks(&self) -> Vec<Remark> {
        if self.cut.is_empty() {
            return Vec::new();
        }
        let count = crate::text::count(self.cut.len(), "face");
        let place = |&polygon: &u32| {
            let corners = self.given.model.polygons().list(polygon as usize);
            Place::cell(&corners.iter().map(|&corner| self.number_of(corner)).collect::<Vec<_>>())
        };
        let message = format!("{count} with more than three corners, cut into triangles");
        vec![
            Remark::new(RemarkCode::FacesTriangulated, message)
                .at(self.cut.len(), self.cut.iter().take(8).map(place)),
        ]
    }

    /// The surface as a model, with the data and groups of the one that was given.
    pub(super) fn into_model(self) -> Result<Model, Error> {
        let Self { given, points, triangles, sources, vertex_sources, .. } = self;
        let PolygonsOf { model, labels } = given;
        let vertex_count = model.vertex_count();
        let (positions, partial_positions) = placed(3, points.into_flattened())?;
        let parts = model.into_parts();
        let data = parts.data.iter().filter_map(|data: &CellData| match data.kind() {
            GroupKind::Vertices => {
                Some(data.taken_from(vertex_sources.iter().map(|&source| source as usize)))
            }
            GroupKind::Polygons => Some(data.taken_from(sources.iter().map(|&source| source as usize))),
            GroupKind::Lines | GroupKind::Cells => None,
        });
        let groups = parts.groups.iter().filter_map(|group: &Group| match group.kind() {
            GroupKind::Vertices => Some(group.clone()),
            GroupKind::Polygons => {
                let is_member = |source: &u32| group.members().binary_search(source).is_ok();
                let members = (0u32..).zip(&sources).filter(|(_, source)| is_member(source));
                Some(Group::new(
                    group.name(),
                    GroupKind::Polygons,
                    members.map(|(number, _)| number).collect(),
                ))
            }
            GroupKind::Lines | GroupKind::Cells => None,
        });
        let model = ModelParts {
            vertex_count: vertex_sources.len(),
            positions,
            partial_positions,
            polygons: RaggedArray::from_lists(&triangles),
            lines: RaggedArray::new(),
            points: Vec::new(),
            groups: groups.collect(),
            data: data.collect(),
            format: parts.format,
            ..ModelParts::default()
        }
        .into_model();
        let sources: Vec<usize> = (0..vertex_count).collect();
        Ok(PolygonsOf { model, labels }.into_given(&sources))
    }
}

/// The triangles of a polygon: of what is seen of it along the axis that it faces most, or a fan where that is not simple.
fn triangles_of(polygon: &[u32], points: &[[f64; 3]]) -> Vec<[u32; 3]> {
    let point = |vertex: u32| points[vertex as usize];
    let mut normal = [0.0; 3];
    for (i, &from) in polygon.iter().enumerate() {
        let (p, q) = (point(from), point(polygon[(i + 1) % polygon.len()]));
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            p[j] * q[k] - p[k] * q[j]
        });
        normal = [normal[0] + x, normal[1] + y, normal[2] + z];
    }
    let axis = (0..3).max_by(|&a, &b| f64::abs(normal[a]).total_cmp(&f64::abs(normal[b]))).unwrap_or(0);
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let is_turned = normal[axis] < 0.0;
    let seen = |vertex: u32| {
        if is_turned { [point(vertex)[k], point(vertex)[j]] } else { [point(vertex)[j], point(vertex)[k]] }
    };
    let compare = |a: u32, b: u32| seen(a).partial_cmp(&seen(b)).expect("coordinates are numbers");
    let turn = |a: u32, b: u32, c: u32| orientation(seen(a), seen(b), seen(c));
    triangulate(&[polygon], compare, turn).unwrap_or_else(|_| {
        (1..polygon.len().max(2) - 1).map(|i| [polygon[0], polygon[i], polygon[i + 1]]).collect()
    })
}
