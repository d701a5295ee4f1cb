//! Certificates of arrangements and Booleans in space. What is proved here is checked before it is given.

use super::solid_request::surface_alone;
use super::{SceneArrangement, SolidBoolean};
use crate::homology::certificate::{Input, Number, checked, number};
use coface_algebra::{Error, ErrorKind, FaceId, Integer, RaggedArray, Sign, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface_geometry::Positions;
use coface_geometry::predicates::SpatialPoint;
use serde::{Serialize, Serializer};

/// A certificate, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<A> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    rule: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    formula: Option<String>,
    answer: A,
    proof: Proof,
}

#[derive(Serialize)]
struct Proof {
    /// The vertices: x, y and z are quotients of the first three integers and the fourth.
    vertices: Vec<[Number; 4]>,
    /// For each polygon of the inputs its corners and what fills it.
    polygons: Vec<Filled>,
    /// For each bounded cell a triangle that has it behind.
    #[serde(skip_serializing_if = "Option::is_none")]
    cells: Option<Vec<[u32; 3]>>,
}

/// A triangle that is whole, or the corners of a polygon and the triangles that fill it.
enum Filled {
    Whole([u32; 3]),
    Cut(Vec<u32>, Vec<[u32; 3]>),
}

impl Serialize for Filled {
    fn serialize<S: Serializer>(&self, target: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Whole(corners) => corners.serialize(target),
            Self::Cut(corners, pieces) => {
                let lists = pieces.iter().map(|piece| &piece[..]);
                target.collect_seq(std::iter::once(&corners[..]).chain(lists))
            }
        }
    }
}

impl SolidBoolean<'_> {
    /// A certificate of the Boolean of files, from their names and bytes, each of which is one solid: that the result is what the formula says of
    /// what the inputs wind around, whether it has an end, and its volume. [`coface_check_space::check`] derives them without any code of this
    /// library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] if the checker does not read a file as this library does: it reads plain OFF and OBJ, whose polygons are flat;
    /// [`ErrorKind::InvalidInput`] if vertices were moved, so that the result is not that of the files.
    ///
    /// # Complexity
    /// That of the arrangement of all polygons, and of $O(n \log n)$ decisions about n triangles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = &b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"[..];
    /// let solid = coface_io::read(text, coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid.obj", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// let certificate = same.certificate(&[("solid.obj", text)])?;
    /// let verdict = coface_check_space::check(certificate.as_bytes(), &[text]).expect("the proof holds");
    /// assert!(verdict.proved().contains(&"measure = 1, the volume, to one part in 10^12".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        if self.arrangement.surface.is_some() {
            return Err(surface_alone());
        }
        let answer = self.answer()?;
        let is_moved = answer.joined.is_some();
        let proof = proof_of(self.arrangement, is_moved, false, inputs)?;
        certified("solids", self.request.rule, Some(self.request.formula.to_postfix()), answer, proof, inputs)
    }
}

impl SceneArrangement {
    /// A certificate of the arrangement of files, from their names and bytes, each of which is one input: the bounded cells, their volumes and voids, and the
    /// inputs around them. [`coface_check_space::check`] derives them without any code of this library, as `docs/certificates.md` says. It has
    /// been checked.
    ///
    /// # Errors
    /// As [`SolidBoolean::certificate`]; surfaces may be open.
    ///
    /// # Complexity
    /// That of the arrangement of all polygons, and of $O(n \log n)$ decisions about n triangles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = &b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"[..];
    /// let solid = coface_io::read(text, coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid.obj", &solid)], &SpatialRequest::default())?;
    /// let certificate = arranged.certificate(Default::default(), &[("solid.obj", text)])?;
    /// let verdict = coface_check_space::check(certificate.as_bytes(), &[text]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[1], "1 bounded cell");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, rule: InsideRule, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let answer = self.answer(rule)?;
        let proof = proof_of(self, answer.joined.is_some(), true, inputs)?;
        certified("space", rule, None, answer, proof, inputs)
    }
}

/// The proof of the arrangement of files, with cells if these are wanted.
fn proof_of(
    arranged: &SceneArrangement,
    is_moved: bool,
    has_cells: bool,
    inputs: &[(&str, &[u8])],
) -> Result<Proof, Error> {
    if is_moved {
        return Err(refused(
            "vertices were moved, so that the result is not that of the files; keep exact coordinates with --exact",
        ));
    }
    if arranged.scene().names().len() != inputs.len() {
        return Err(refused("the solids are parts of files"));
    }
    Proof::of(inputs, has_cells)
}

fn certified<A: Serialize>(
    kind: &'static str,
    rule: InsideRule,
    formula: Option<String>,
    answer: A,
    proof: Proof,
    inputs: &[(&str, &[u8])],
) -> Result<String, Error> {
    let certificate = Certificate {
        coface_certificate: coface_check::VERSION,
        coface: env!("CARGO_PKG_VERSION"),
        kind,
        inputs: Input::list(inputs),
        rule: super::boolean::rule_word(rule),
        formula,
        answer,
        proof,
    };
    checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
}

impl Proof {
    /// The arrangement of the polygons as the checker reads them, so that nothing has to be translated.
    fn of(inputs: &[(&str, &[u8])], has_cells: bool) -> Result<Self, Error> {
        let bytes: Vec<&[u8]> = inputs.iter().map(|(_, bytes)| *bytes).collect();
        let corners = coface_check_space::corners(&bytes).map_err(|fault| refused(&fault.to_string()))?;
        let flat = corners.iter().flatten().flatten().copied().collect();
        let mut next = 0u32;
        let lists = corners.iter().map(|polygon| {
            let first = next;
            next += polygon.len() as u32;
            (first..next).collect::<Vec<u32>>()
        });
        let lists = RaggedArray::from_lists(lists);
        let polygons = SpatialPolygons::from_polygons(Positions::from_flat(3, flat)?, lists.clone())?;
        let space = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
        let cut = space.fine_triangles();
        let mut names = Names { of_vertex: vec![None; cut.positions().len()], vertices: Vec::new() };
        let mut pieces: Vec<Vec<[u32; 3]>> = vec![Vec::new(); lists.len()];
        let drawn = space.drawn_triangles()?;
        let mut cells = vec![None; space.fine().cell_count()];
        let same_face = drawn.face_of_triangle.iter().zip(&drawn.triangles).collect::<Vec<_>>();
        for own in same_face.chunk_by(|a, b| a.0 == b.0) {
            for side in [Sign::Plus, Sign::Minus] {
                if let Some(cell) = space.cell_at(FaceId::from_u32(*own[0].0), side) {
                    let [a, b, c] = *own[0].1;
                    let behind = if side == Sign::Plus { [a, b, c] } else { [a, c, b] };
                    cells[cell.index()].get_or_insert(behind);
                }
            }
            for (polygon, sign) in space.polygons_of_face(FaceId::from_u32(*own[0].0)) {
                for &(_, &[a, b, c]) in own {
                    let piece = if sign == Sign::Plus { [a, b, c] } else { [a, c, b] };
                    pieces[polygon as usize].push(piece.map(|vertex| names.of(vertex, |v| cut.point(v))));
                }
            }
        }
        let filled = lists.iter().zip(pieces).map(|(list, pieces)| {
            let vertex = |&point: &u32| names.of(cut.vertex_of_point()[point as usize], |v| cut.point(v));
            let corners: Vec<u32> = list.iter().map(vertex).collect();
            match (&corners[..], &pieces[..]) {
                (&[a, b, c], [piece]) if [[a, b, c], [b, c, a], [c, a, b]].contains(piece) => {
                    Filled::Whole([a, b, c])
                }
                _ => Filled::Cut(corners, pieces),
            }
        });
        let polygons = filled.collect();
        let behind = |cell: &Option<[u32; 3]>| {
            let corners = cell.expect("a cell has a face");
            corners.map(|vertex| names.of_vertex[vertex as usize].expect("triangles have been named"))
        };
        let cells = has_cells.then(|| cells.iter().map(behind).collect());
        Ok(Self { vertices: names.vertices, polygons, cells })
    }
}

/// The vertices that are used, in the order in which they are met.
struct Names {
    of_vertex: Vec<Option<u32>>,
    vertices: Vec<[Number; 4]>,
}

impl Names {
    fn of(&mut self, vertex: u32, point: impl Fn(VertexId) -> SpatialPoint) -> u32 {
        *self.of_vertex[vertex as usize].get_or_insert_with(|| {
            self.vertices.push(over_one_denominator(&point(VertexId::from_u32(vertex))));
            self.vertices.len() as u32 - 1
        })
    }
}

/// Three coordinates as quotients of integers by the last one, the least common multiple of their denominators.
fn over_one_denominator(point: &SpatialPoint) -> [Number; 4] {
    let coordinates = point.to_rational();
    let common = coordinates.iter().fold(Integer::from(1), |common, coordinate| {
        let below = coordinate.denominator();
        let shared = common.gcd(&below);
        &common * &below.exact_quotient(&shared).expect("it divides both")
    });
    let [x, y, z] = coordinates.map(|coordinate| {
        let factor = common.exact_quotient(&coordinate.denominator()).expect("it is a multiple");
        number(&(&coordinate.numerator() * &factor))
    });
    [x, y, z, number(&common)]
}

fn refused(why: &str) -> Error {
    Error::new(
        ErrorKind::UnsupportedFormat,
        format!(
            "no certificate: {why}; leave --certificate out, or give closed surfaces as plain OFF or OBJ"
        ),
    )
}
