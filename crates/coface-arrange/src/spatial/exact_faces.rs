//! The faces of an arrangement as polygons that lose nothing.

use super::cutting::CutTriangles;
use super::exact_polygons::{ExactPart, ExactPolygons};
use super::wanted_parts::walks;
use super::{SpatialArrangement, SpatialPredicates};
use coface_algebra::{FaceId, RaggedArray, Sign, UnionFind, VertexId};
use coface_geometry::predicates::{PointDefinition, are_coplanar, plane_axis};
use std::collections::HashMap;

const NONE: u32 = u32::MAX;

impl SpatialArrangement {
    /// Some faces as exact polygons: `surface` has those that are sides of a solid, plus where they run as the face does;
    /// `others` has the rest. Faces beside each other in one plane become one polygon where nothing else ends at their edges.
    ///
    /// The parts are cut out of the triangles that the polygons of the input were, so that their numbers do not grow
    /// however often a result is cut again. A vertex stays where it is a corner of some polygon.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Complexity
    /// $O(k \log k)$ for k sides of fine faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// let faces: Vec<_> = (0..4).map(|face| (FaceId::new(face), Sign::Plus)).collect();
    /// assert_eq!(tetrahedron.exact_polygons(&faces, &[]).parts().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn exact_polygons(&self, surface: &[(FaceId, Sign)], others: &[FaceId]) -> ExactPolygons {
        let mut fine = self.fine_faces_of(surface);
        for (&face, origin) in others.iter().zip(surface.len() as u32..) {
            // All of one triangle run alike.
            fine.extend(self.fine_faces(face).map(|(fine, _)| FineFace {
                face: fine,
                sign: Sign::Plus,
                is_shared: true,
                origin,
            }));
        }
        fine.sort_unstable_by_key(|fine| fine.face);
        let exporter = Exporter { cut: &self.cut, fine: &fine };
        let (classes, is_shared) = exporter.classes();
        exporter.polygons(&classes, is_shared)
    }

    /// Sides of solids as exact polygons that are not put together, plus where they run as the face does; with the place in
    /// `surface` that each is from. A face of pieces in several planes is a polygon for each of them.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Complexity
    /// $O(k \log k)$ for k sides of fine faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 1., 1., 0.])?;
    /// let two = RaggedArray::from_lists([[0, 1, 2], [1, 3, 2]]);
    /// let square = SpatialArrangement::new(&SpatialPolygons::from_polygons(corners, two)?, &SpatialOptions::new())?;
    /// let faces = [(FaceId::new(1), Sign::Plus), (FaceId::new(0), Sign::Plus)];
    /// assert_eq!(square.exact_faces(&faces).1, [1, 0]);
    /// // Both are in one plane and have a side in common.
    /// assert_eq!(square.exact_polygons(&faces, &[]).shared().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn exact_faces(&self, surface: &[(FaceId, Sign)]) -> (ExactPolygons, Vec<u32>) {
        let mut fine = self.fine_faces_of(surface);
        fine.sort_unstable_by_key(|fine| fine.face);
        let exporter = Exporter { cut: &self.cut, fine: &fine };
        let (classes, origins) = exporter.classes_of_origins(surface.len());
        (exporter.polygons(&classes, vec![false; origins.len()]), origins)
    }

    /// The fine faces of sides of solids.
    fn fine_faces_of(&self, surface: &[(FaceId, Sign)]) -> Vec<FineFace> {
        let mut found = Vec::new();
        for (&(face, sign), origin) in surface.iter().zip(0..) {
            found.extend(self.fine_faces(face).map(|(fine, own)| FineFace {
                face: fine,
                sign: sign.times(own),
                is_shared: false,
                origin,
            }));
        }
        found
    }
}

#[derive(Clone, Copy)]
struct FineFace {
    face: FaceId,
    /// Plus where the polygon runs as the fine face does.
    sign: Sign,
    is_shared: bool,
    /// The place of its face among those that are asked for.
    origin: u32,
}

struct Exporter<'a> {
    cut: &'a CutTriangles,
    fine: &'a [FineFace],
}

/// The directed sides of a part, and the fine face that its triangle is known by.
struct Outline {
    polygon: u32,
    sample: usize,
    sides: Vec<[u32; 2]>,
}

impl Exporter<'_> {
    /// The sides of a fine face from vertex to vertex, with their edges, in the direction of its polygon.
    fn sides(&self, fine: &FineFace) -> impl Iterator<Item = (u32, [u32; 2])> + '_ {
        let turned = u32::from(fine.sign == Sign::Minus);
        let complex = self.cut.complex();
        let sides = complex.packed_sides().list(fine.face.index()).iter();
        sides.map(move |&side| (side >> 1, complex.side_ends(side ^ turned)))
    }

    /// The number of the polygon of each fine face, and for each polygon whether cells share it.
    fn classes(&self) -> (Vec<u32>, Vec<bool>) {
        let mut at_edges: Vec<(u32, [u32; 2], u32)> = Vec::new();
        for (number, fine) in (0..).zip(self.fine) {
            at_edges.extend(self.sides(fine).map(|(edge, ends)| (edge, ends, number)));
        }
        at_edges.sort_unstable();
        let mut classes = UnionFind::new(self.fine.len());
        for at in at_edges.chunk_by(|x, y| x.0 == y.0) {
            let &[(_, [a, b], f), (_, ends, g)] = at else { continue };
            let [own, other] = [f, g].map(|number| &self.fine[number as usize]);
            if ends == [b, a] && own.is_shared == other.is_shared && self.is_one_plane(own.face, other.face) {
                classes.unite(f, g);
            }
        }
        let numbers = classes.class_numbers();
        let mut is_shared = vec![false; classes.class_count()];
        for (&class, fine) in numbers.iter().zip(self.fine) {
            is_shared[class as usize] = fine.is_shared;
        }
        (numbers, is_shared)
    }

    /// The number of the polygon of each fine face where faces stay apart, and the place that each polygon is from.
    fn classes_of_origins(&self, count: usize) -> (Vec<u32>, Vec<u32>) {
        let mut origins = Vec::with_capacity(count);
        // For each place its polygons, each by one of its fine faces.
        let mut known: Vec<Vec<(u32, FaceId)>> = vec![Vec::new(); count];
        let mut classes = Vec::with_capacity(self.fine.len());
        for fine in self.fine {
            let own = &mut known[fine.origin as usize];
            let known = own.iter().find(|(_, sample)| self.is_one_plane(*sample, fine.face));
            let class = known.map_or(origins.len() as u32, |&(class, _)| class);
            if class as usize == origins.len() {
                origins.push(fine.origin);
                own.push((class, fine.face));
            }
            classes.push(class);
        }
        (classes, origins)
    }

    fn is_one_plane(&self, f: FaceId, g: FaceId) -> bool {
        self.cut.sheet_of_face(f) == self.cut.sheet_of_face(g)
            || are_coplanar(self.cut.plane(f), self.cut.plane(g))
    }

    /// The sides around the fine faces of each polygon that are cut out of one triangle: those between two of them are
    /// left out.
    fn outlines(&self, classes: &[u32]) -> Vec<Outline> {
        let key = |number: u32| {
            let fine = &self.fine[number as usize];
            (classes[number as usize], self.cut.sheet_of_face(fine.face))
        };
        let mut order: Vec<u32> = (0..self.fine.len() as u32).collect();
        order.sort_by_key(|&number| key(number));
        let mut outlines = Vec::new();
        for own in order.chunk_by(|&x, &y| key(x) == key(y)) {
            let mut all: Vec<[u32; 2]> = Vec::new();
            own.iter()
                .for_each(|&number| all.extend(self.sides(&self.fine[number as usize]).map(|side| side.1)));
            all.sort_unstable();
            let sides = all.iter().copied().filter(|&[a, b]| all.binary_search(&[b, a]).is_err()).collect();
            outlines.push(Outline { polygon: classes[own[0] as usize], sample: own[0] as usize, sides });
        }
        outlines
    }

    /// Whether each vertex is a corner of a part, or one at which outlines meet.
    fn corners(&self, outlines: &[Outline]) -> Vec<bool> {
        let predicates = self.cut.predicates();
        let mut is_corner = vec![false; self.cut.complex().vertex_count()];
        for outline in outlines {
            // Sides are sorted by where they begin.
            let axis = plane_axis(self.cut.plane(self.fine[outline.sample].face)).0;
            let mut back: Vec<[u32; 2]> = outline.sides.iter().map(|&[a, b]| [b, a]).collect();
            back.sort_unstable();
            for (&[vertex, next], &[end, before]) in outline.sides.iter().zip(&back) {
                let is_straight = || predicates.normal_sign(axis, [before, vertex, next]).is_eq();
                is_corner[vertex as usize] |= vertex != end || !is_straight();
            }
            for pair in outline.sides.windows(2).filter(|pair| pair[0][0] == pair[1][0]) {
                is_corner[pair[0][0] as usize] = true;
            }
        }
        is_corner
    }

    fn polygons(&self, classes: &[u32], is_shared: Vec<bool>) -> ExactPolygons {
        let outlines = self.outlines(classes);
        let is_corner = self.corners(&outlines);
        let mut numbers = Numbers::default();
        let mut number_of_vertex = vec![NONE; self.cut.complex().vertex_count()];
        let mut vertices = RaggedArray::new();
        let mut parts = Vec::with_capacity(outlines.len());
        for outline in &outlines {
            let fine = &self.fine[outline.sample];
            let mut corners = self.cut.plane(fine.face).map(|point| numbers.of(point));
            if fine.sign == Sign::Minus {
                corners.swap(1, 2);
            }
            let mut walks = walks(&outline.sides, &is_corner);
            for vertex in walks.iter_mut().flatten() {
                let number = &mut number_of_vertex[*vertex as usize];
                if *number == NONE {
                    *number = vertices.len() as u32;
                    vertices.push(
                        &numbers.of_definition(self.cut.point(VertexId::from_u32(*vertex)).definition()),
                    );
                }
                *vertex = *number;
            }
            parts.push(ExactPart { polygon: outline.polygon, triangle: corners, walks });
        }
        ExactPolygons::from_trusted_parts(numbers.points, vertices, parts, is_shared)
    }
}

/// Numbers of points, by their first use.
#[derive(Default)]
struct Numbers {
    points: Vec<[f64; 3]>,
    known: HashMap<[u64; 3], u32>,
}

impl Numbers {
    fn of(&mut self, point: [f64; 3]) -> u32 {
        *self.known.entry(point.map(f64::to_bits)).or_insert_with(|| {
            self.points.push(point);
            self.points.len() as u32 - 1
        })
    }

    fn of_definition(&mut self, definition: PointDefinition) -> Vec<u32> {
        let points: Vec<[f64; 3]> = match definition {
            PointDefinition::Given(point) => vec![point],
            PointDefinition::LineAndPlane(line, plane) => [&line[..], &plane[..]].concat(),
            PointDefinition::Planes(planes) => planes.concat(),
            PointDefinition::Lines(lines) => lines.concat(),
        };
        points.into_iter().map(|point| self.of(point)).collect()
    }
}
