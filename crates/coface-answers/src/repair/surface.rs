//! A surface of whatever polygons a file holds: merged, cleaned, split, turned and, on request, closed.

use super::outwards::faces_to_turn;
use super::polygons_of::PolygonsOf;
use super::splitting::{RepairRequest, repaired_polygons_model};
use super::weld::classes_of;
use coface_algebra::{Error, ErrorKind, FaceId, RaggedArray, Sign, VertexId};
use coface_complexes::surface::{BoundaryLoop, FacesAtEdge, MeshRepair, PolygonMesh};
use coface_geometry::Positions;
use coface_io::{CellData, Group, GroupKind, Model, ModelParts, placed};
use std::collections::BTreeSet;

/// Holes with more corners than this are filled by a fan around a new vertex; smaller ones by the triangles of least area.
const MOST_CORNERS: usize = 96;

/// How a surface is made of a model.
///
/// # Examples
/// ```
/// use coface_answers::SurfaceRepairRequest;
/// let request = SurfaceRepairRequest::new().tolerance(1e-6).closed(true);
/// assert_ne!(request, SurfaceRepairRequest::new());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceRepairRequest {
    tolerance: f64,
    closed: bool,
}

impl SurfaceRepairRequest {
    /// Vertices are merged where their positions are equal, and holes stay.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SurfaceRepairRequest;
    /// assert_eq!(SurfaceRepairRequest::new(), SurfaceRepairRequest::default());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Merges vertices within this distance of each other, in the unit of the positions, as [`welded`](crate::welded) does.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SurfaceRepairRequest;
    /// assert_ne!(SurfaceRepairRequest::new().tolerance(1e-6), SurfaceRepairRequest::new());
    /// ```
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Whether holes are filled.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SurfaceRepairRequest;
    /// assert_ne!(SurfaceRepairRequest::new().closed(true), SurfaceRepairRequest::new());
    /// ```
    #[must_use]
    pub fn closed(mut self, closed: bool) -> Self {
        self.closed = closed;
        self
    }
}

/// What was done to make a surface of a model.
#[derive(Clone, Debug)]
pub struct SurfaceRepair {
    merged_count: usize,
    unused_count: usize,
    collapsed_count: usize,
    duplicate_count: usize,
    loose_line_count: usize,
    mesh: MeshRepair,
    hole_count: usize,
    added_face_count: usize,
}

impl SurfaceRepair {
    /// How many vertices became another one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// assert_eq!(done.merged_count(), 9 - 4);
    /// # Ok(()) }
    /// ```
    pub fn merged_count(&self) -> usize {
        self.merged_count
    }

    /// How many vertices were in no face, and were left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// assert_eq!(done.unused_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn unused_count(&self) -> usize {
        self.unused_count
    }

    /// How many polygons had fewer than three corners once vertices were merged, or met themselves, and were left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// assert_eq!(done.collapsed_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn collapsed_count(&self) -> usize {
        self.collapsed_count
    }

    /// How many polygons had the corners of an earlier one, and were left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// assert_eq!(done.duplicate_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn duplicate_count(&self) -> usize {
        self.duplicate_count
    }

    /// How many lines were no sides of faces, and were left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// assert_eq!(done.loose_line_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn loose_line_count(&self) -> usize {
        self.loose_line_count
    }

    /// What was split and turned, by the vertices and faces after merging.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// // The first and the third look inwards.
    /// assert_eq!(done.mesh().faces_turned().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn mesh(&self) -> &MeshRepair {
        &self.mesh
    }

    /// How many holes were filled.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// assert_eq!(done.hole_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn hole_count(&self) -> usize {
        self.hole_count
    }

    /// How many triangles fill them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceRepairRequest, repaired_surface};
    /// // Three sides of a tetrahedron, each with vertices of its own.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n\
    ///             f 1 2 3\nf 4 5 6\nf 7 8 9\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
    /// assert_eq!(done.added_face_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn added_face_count(&self) -> usize {
        self.added_face_count
    }
}

/// A surface made of the polygons of a model: vertices are merged, polygons that collapse or repeat an earlier one are left out, edges in
/// three or more faces and pinched vertices are split, faces are turned to agree where they can, and holes are filled if that is asked.
/// A facet list of dimension 2 stays one. The result is a manifold without loose edges and points; it is closed if that is asked.
///
/// A hole of up to 96 corners is filled with the triangles of least area that use no edge that is there already; larger ones, those
/// for which there are no such triangles, and those without positions by a fan around a new vertex in their middle. Data and groups
/// follow; a new face has the data of the face beside the first edge of its hole.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for models with 3-cells and structures that are no facet list of dimension 2;
/// [`ErrorKind::InvalidInput`] for a tolerance that is negative or not a number; [`ErrorKind::TooLarge`] beyond 32 bits.
///
/// # Complexity
/// Nearly linear, and $O(h^3)$ for each hole of h corners up to 96.
///
/// # Examples
/// A tetrahedron without a face, whose corners are written once for each face, becomes closed.
/// ```
/// use coface_answers::{SurfaceRepairRequest, repaired_surface};
/// use coface_io::{Format, read};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 4 5 6\nf 7 8 9\n";
/// let model = read(text.as_bytes(), Format::Obj)?;
/// let (closed, done) = repaired_surface(&model, &SurfaceRepairRequest::new().closed(true))?;
/// assert_eq!((closed.vertex_count(), closed.polygons().len()), (4, 4));
/// assert_eq!((done.merged_count(), done.hole_count(), done.added_face_count()), (5, 1, 1));
/// # Ok(()) }
/// ```
pub fn repaired_surface(
    model: &Model,
    request: &SurfaceRepairRequest,
) -> Result<(Model, SurfaceRepair), Error> {
    let PolygonsOf { model: polygons, labels } = PolygonsOf::new(model)?;
    let cleaned = Cleaned::new(polygons, request.tolerance)?;
    let (kept, counts) = (cleaned.kept, cleaned.counts);
    let splitting = RepairRequest {
        split_edges: Some(FacesAtEdge::CoherentPairs),
        split_vertices: true,
        orient_parts: true,
        ..RepairRequest::default()
    };
    let (mut made, mut mesh) = repaired_polygons_model(cleaned.model, splitting)?;
    let (mut hole_count, mut added_face_count) = (0, 0);
    if request.closed {
        let holes = Holes::new(&made, mesh.mesh());
        (hole_count, added_face_count) = (holes.count, holes.triangles.len());
        made = turned_outwards(holes.fill(made)?, &mut mesh)?;
    }
    check(&made, request.closed)?;
    let sources: Vec<usize> = kept.iter().map(|&vertex| vertex as usize).collect();
    let made = PolygonsOf { model: made, labels }.into_given(&sources);
    let [merged_count, unused_count, collapsed_count, duplicate_count, loose_line_count] = counts;
    let repair = SurfaceRepair {
        merged_count,
        unused_count,
        collapsed_count,
        duplicate_count,
        loose_line_count,
        mesh,
        hole_count,
        added_face_count,
    };
    Ok((made, repair))
}

/// The model with closed parts that look outwards now that their holes are filled.
fn turned_outwards(model: Model, repair: &mut MeshRepair) -> Result<Model, Error> {
    let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[])?;
    let faces = faces_to_turn(&mesh, model.positions());
    if faces.is_empty() {
        return Ok(model);
    }
    let own: Vec<FaceId> =
        faces.iter().copied().filter(|face| face.index() < repair.mesh().face_count()).collect();
    repair.turn(&own);
    let mut polygons = model.polygons().clone();
    for face in faces {
        let start = polygons.start(face.index());
        let count = polygons.list(face.index()).len();
        polygons.items_mut()[start + 1..start + count].reverse();
    }
    Ok(ModelParts { polygons, ..model.into_parts() }.into_model())
}

/// Nothing but a surface is given back.
fn check(model: &Model, closed: bool) -> Result<(), Error> {
    let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[])?;
    let verdict = mesh.manifold_verdict();
    if !verdict.is_manifold() || closed && !verdict.is_closed() {
        return Err(Error::new(ErrorKind::NonManifold, "the repair did not end in a surface")
            .with_cure("report the file: this must not happen"));
    }
    Ok(())
}

/// A model without what no surface has.
struct Cleaned {
    model: Model,
    /// For each vertex the one of the given model that it was.
    kept: Vec<u32>,
    /// Vertices merged, vertices unused, polygons collapsed, polygons repeated, lines loose.
    counts: [usize; 5],
}

impl Cleaned {
    fn new(model: Model, tolerance: f64) -> Result<Self, Error> {
        let class_of = classes_of(&model, tolerance)?;
        let (dimension, given) = (model.coordinate_count(), model.coordinates().to_vec());
        let parts = model.into_parts();
        let merged = class_of.iter().zip(0u32..).filter(|&(class, vertex)| *class != vertex).count();
        let mut polygons = Vec::with_capacity(parts.polygons.len());
        let mut collapsed = 0;
        for (number, polygon) in (0u32..).zip(parts.polygons.iter()) {
            match merged_corners(polygon, &class_of) {
                Some(corners) => polygons.push((number, corners)),
                None => collapsed += 1,
            }
        }
        let duplicate = remove_duplicates(&mut polygons);
        let mut sides: Vec<[u32; 2]> = polygons.iter().flat_map(|(_, corners)| sides_of(corners)).collect();
        sides.sort_unstable();
        sides.dedup();
        let is_side = |step: &[u32]| sides.binary_search(&sorted([step[0], step[1]])).is_ok();
        let mut lines = Vec::new();
        for (number, line) in (0u32..).zip(parts.lines.iter()) {
            let mut corners: Vec<u32> = line.iter().map(|&vertex| class_of[vertex as usize]).collect();
            corners.dedup();
            if corners.len() > 1 && corners.windows(2).all(is_side) {
                lines.push((number, corners));
            }
        }
        let loose = parts.lines.len() - lines.len();
        let mut number_of = vec![None; parts.vertex_count];
        let mut kept: Vec<u32> = polygons.iter().flat_map(|(_, corners)| corners.iter().copied()).collect();
        kept.sort_unstable();
        kept.dedup();
        for (number, &vertex) in (0u32..).zip(&kept) {
            number_of[vertex as usize] = Some(number);
        }
        let unused = parts.vertex_count - merged - kept.len();
        let renumber = |corners: &[u32]| -> Vec<u32> {
            corners.iter().map(|&vertex| number_of[vertex as usize].expect("a corner is kept")).collect()
        };
        let of_kind = |kind: GroupKind| -> Vec<usize> {
            match kind {
                GroupKind::Vertices => kept.iter().map(|&vertex| vertex as usize).collect(),
                GroupKind::Polygons => polygons.iter().map(|(number, _)| *number as usize).collect(),
                GroupKind::Lines => lines.iter().map(|(number, _)| *number as usize).collect(),
                GroupKind::Cells => Vec::new(),
            }
        };
        let group = |group: &Group| {
            let mut members: Vec<u32> = match group.kind() {
                GroupKind::Vertices => group
                    .members()
                    .iter()
                    .filter_map(|&member| number_of[class_of[member as usize] as usize])
                    .collect(),
                kind => {
                    let kept = of_kind(kind);
                    let place = |&member: &u32| kept.binary_search(&(member as usize)).ok();
                    group.members().iter().filter_map(place).map(|place| place as u32).collect()
                }
            };
            members.sort_unstable();
            members.dedup();
            group.with_members(members)
        };
        let coordinates = kept.iter().flat_map(|&v| &given[v as usize * dimension..][..dimension]);
        let (positions, partial_positions) = placed(dimension, coordinates.copied().collect())?;
        let model = ModelParts {
            vertex_count: kept.len(),
            positions,
            partial_positions,
            polygons: RaggedArray::from_lists(polygons.iter().map(|(_, corners)| renumber(corners))),
            lines: RaggedArray::from_lists(lines.iter().map(|(_, corners)| renumber(corners))),
            points: Vec::new(),
            groups: parts.groups.iter().map(group).collect(),
            data: parts.data.iter().map(|data: &CellData| data.taken_from(of_kind(data.kind()))).collect(),
            ..parts
        }
        .into_model();
        Ok(Self { model, kept, counts: [merged, unused, collapsed, duplicate, loose] })
    }
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    if a < b { [a, b] } else { [b, a] }
}

fn sides_of(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    (0..corners.len()).map(|i| sorted([corners[i], corners[(i + 1) % corners.len()]]))
}

/// The corners after merging, none twice in a row; `None` if fewer than three are left or the polygon meets itself.
pub(super) fn merged_corners(polygon: &[u32], class_of: &[u32]) -> Option<Vec<u32>> {
    let mut corners: Vec<u32> = polygon.iter().map(|&vertex| class_of[vertex as usize]).collect();
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    let mut different = corners.clone();
    different.sort_unstable();
    different.dedup();
    (corners.len() > 2 && different.len() == corners.len()).then_some(corners)
}

/// Removes polygons with the vertices of an earlier one; gives their number.
fn remove_duplicates(polygons: &mut Vec<(u32, Vec<u32>)>) -> usize {
    let key = |corners: &[u32]| {
        let mut key = corners.to_vec();
        key.sort_unstable();
        key
    };
    let mut keys: Vec<(Vec<u32>, u32)> =
        polygons.iter().map(|(number, corners)| (key(corners), *number)).collect();
    keys.sort_unstable();
    let repeated: BTreeSet<u32> =
        keys.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1).collect();
    polygons.retain(|(number, _)| !repeated.contains(number));
    repeated.len()
}

/// The triangles that fill the holes of a surface.
struct Holes {
    count: usize,
    triangles: Vec<[u32; 3]>,
    /// For each triangle the polygon beside its hole.
    beside: Vec<u32>,
    /// The corners around each new vertex, one in the middle of each hole filled by a fan.
    middles: Vec<Vec<u32>>,
}

impl Holes {
    fn new(model: &Model, mesh: &PolygonMesh) -> Self {
        let mut holes = Self { count: 0, triangles: Vec::new(), beside: Vec::new(), middles: Vec::new() };
        let mut added = BTreeSet::new();
        for part in mesh.boundary_loops() {
            holes.add(model, mesh, &part, &mut added);
        }
        holes
    }

    fn add(
        &mut self,
        model: &Model,
        mesh: &PolygonMesh,
        part: &BoundaryLoop,
        added: &mut BTreeSet<[u32; 2]>,
    ) {
        let mut corners: Vec<u32> = part.vertices().iter().map(|vertex| vertex.to_u32()).collect();
        let edge = part.edges()[0];
        let (face, sign) = mesh.faces_of_edge(edge).next().expect("an edge of the boundary has a face");
        let [a, b] = mesh.edge(edge).map(VertexId::to_u32);
        let [from, to] = if sign == Sign::Plus { [a, b] } else { [b, a] };
        // The face beside the hole runs from one end to the other; what fills the hole runs back.
        let count = corners.len();
        let runs_along = (0..count).any(|i| corners[i] == from && corners[(i + 1) % count] == to);
        if runs_along {
            corners.reverse();
        }
        let is_free = |pair: [u32; 2]| {
            let [a, b] = pair.map(VertexId::from_u32);
            mesh.edge_between(a, b).is_none() && !added.contains(&sorted(pair))
        };
        let is_back_to_back = count == 3 && {
            let mut of_face = mesh.face(face).to_vec();
            let mut of_hole = corners.clone();
            of_face.sort_unstable();
            of_hole.sort_unstable();
            of_face == of_hole
        };
        let triangles = match (count, model.positions()) {
            _ if is_back_to_back => None,
            (3, _) => Some(vec![[corners[0], corners[1], corners[2]]]),
            (4..=MOST_CORNERS, positions) if !positions.is_empty() => {
                least_area(&corners, positions, is_free)
            }
            _ => None,
        };
        let triangles = triangles.unwrap_or_else(|| {
            let middle = (model.vertex_count() + self.middles.len()) as u32;
            self.middles.push(corners.clone());
            (0..count).map(|i| [corners[i], corners[(i + 1) % count], middle]).collect()
        });
        added.extend(triangles.iter().flat_map(|triangle| sides_of(triangle)));
        self.count += 1;
        self.beside.resize(self.triangles.len() + triangles.len(), mesh.polygon_of_face(face) as u32);
        self.triangles.extend(triangles);
    }

    fn fill(self, model: Model) -> Result<Model, Error> {
        let dimension = model.coordinate_count();
        let mut coordinates = model.coordinates().to_vec();
        for corners in &self.middles {
            // Among corners one of which has no place, the middle has none either.
            for axis in 0..dimension {
                let sum: f64 =
                    corners.iter().map(|&v| model.coordinates()[v as usize * dimension + axis]).sum();
                coordinates.push(sum / corners.len() as f64);
            }
        }
        let (positions, partial_positions) = placed(dimension, coordinates)?;
        let parts = model.into_parts();
        let mut polygons = parts.polygons;
        let polygon_count = polygons.len();
        self.triangles.iter().for_each(|triangle| polygons.push(triangle));
        let data = parts.data.iter().map(|data| match data.kind() {
            GroupKind::Vertices => data.taken_from(
                (0..parts.vertex_count).chain(self.middles.iter().map(|corners| corners[0] as usize)),
            ),
            GroupKind::Polygons => {
                data.taken_from((0..polygon_count).chain(self.beside.iter().map(|&beside| beside as usize)))
            }
            GroupKind::Lines | GroupKind::Cells => data.clone(),
        });
        Ok(ModelParts {
            vertex_count: parts.vertex_count + self.middles.len(),
            positions,
            partial_positions,
            data: data.collect(),
            polygons,
            ..parts
        }
        .into_model())
    }
}

/// The triangles of least total area on a closed polygon in space that use free diagonals only: by the least area on each chain of its
/// corners. `None` if there are none.
fn least_area(
    corners: &[u32],
    positions: &Positions,
    is_free: impl Fn([u32; 2]) -> bool,
) -> Option<Vec<[u32; 3]>> {
    let count = corners.len();
    let point = |i: usize| {
        let mut xyz = [0.0; 3];
        let point = positions.point(VertexId::from_u32(corners[i]));
        xyz.iter_mut().zip(point).for_each(|(to, &from)| *to = from);
        xyz
    };
    let area = |i: usize, j: usize, k: usize| {
        let [a, b, c] = [point(i), point(j), point(k)];
        let (u, v): ([f64; 3], [f64; 3]) =
            (std::array::from_fn(|axis| b[axis] - a[axis]), std::array::from_fn(|axis| c[axis] - a[axis]));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        cross.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0
    };
    // best[i][j]: the least area on the chain from i to j, with the corner of its triangle at the chord.
    let mut best = vec![vec![(0.0f64, 0usize); count]; count];
    for length in 2..count {
        for i in 0..count - length {
            let j = i + length;
            let is_chord = (i, j) != (0, count - 1);
            best[i][j] = (f64::INFINITY, i);
            if is_chord && !is_free([corners[i], corners[j]]) {
                continue;
            }
            for k in i + 1..j {
                let sum = best[i][k].0 + best[k][j].0 + area(i, k, j);
                if sum < best[i][j].0 {
                    best[i][j] = (sum, k);
                }
            }
        }
    }
    if !best[0][count - 1].0.is_finite() {
        return None;
    }
    let mut triangles = Vec::with_capacity(count - 2);
    let mut chains = vec![(0, count - 1)];
    while let Some((i, j)) = chains.pop() {
        if j - i >= 2 {
            let k = best[i][j].1;
            triangles.push([corners[i], corners[k], corners[j]]);
            chains.extend([(i, k), (k, j)]);
        }
    }
    Some(triangles)
}
