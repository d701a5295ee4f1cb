//! Certificates of arrangements and Booleans in the plane. What is proved here is checked before it is given.

use super::{DrawingArrangement, RegionBoolean};
use crate::homology::certificate::{Input, Number, checked, number};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, Integer, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_arrange::planar::PlanarArrangement;
use coface_geometry::Positions;
use serde::Serialize;

/// A certificate, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<A> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    rule: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    formula: Option<String>,
    answer: A,
    proof: Proof,
}

#[derive(Serialize)]
struct Proof {
    /// The vertices in lexicographic order: x and y are quotients of the first two integers and the third.
    vertices: Vec<[Number; 3]>,
    /// For each segment of the inputs the vertices along it, from its start to its end.
    chains: Vec<Vec<u32>>,
    /// For each bounded face the ends of a halfedge that has it on its left.
    #[serde(skip_serializing_if = "Option::is_none")]
    faces: Option<Vec<[u32; 2]>>,
}

impl DrawingArrangement {
    /// A certificate of the arrangement of files, from their names and bytes, each of which is one region: counts, faces with their areas, and
    /// what contains them. [`coface_check_plane::check`] derives them without any code of this library, as `docs/certificates.md` says. It has
    /// been checked.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] if the checker does not read a file as this library does: it reads WKT and GeoJSON of two coordinates, and
    /// lines of four numbers; [`ErrorKind::InvalidInput`] if vertices were moved, so that the complex is not that of the files.
    ///
    /// # Complexity
    /// That of the arrangement, and of $O(n \log n)$ decisions in integers.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let text = &b"0,0,2,2\n0,2,2,0\n"[..];
    /// let model = coface_io::read(text, coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("cross.lines", &model)], RegionSource::Models)?;
    /// let cross = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// let certificate = cross.certificate(&[("cross.lines", text)])?;
    /// let verdict = coface_check_plane::check(certificate.as_bytes(), &[text]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[0], "an arrangement of 2 segments in 5 vertices, 4 edges and 0 bounded faces");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let answer = self.answer()?;
        if answer.snap_rounds.is_some() || answer.joined.is_some() || self.remark_of_movement().is_some() {
            return Err(moved());
        }
        let (plane, count) = arrangement(inputs)?;
        let mut proof = Proof::of(&plane, count);
        proof.faces = Some(faces(&plane));
        certified("arrangement", self.rule, None, answer, proof, inputs)
    }
}

impl RegionBoolean {
    /// A certificate of the Boolean of files, from their names and bytes, each of which is one region: area, components, holes and pinches of
    /// the result. [`coface_check_plane::check`] derives them without any code of this library. It has been checked.
    ///
    /// # Errors
    /// As [`DrawingArrangement::certificate`].
    ///
    /// # Complexity
    /// That of the arrangement of all segments, and of $O(n \log n)$ decisions in integers.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let texts = [&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], &b"POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))"[..]];
    /// let [a, b] = [coface_io::read(texts[0], coface_io::Format::Wkt)?, coface_io::read(texts[1], coface_io::Format::Wkt)?];
    /// let drawing = PlanarDrawing::new([("a.wkt", &a), ("b.wkt", &b)], RegionSource::Models)?;
    /// let both = RegionBoolean::new(drawing, &BooleanFormula::union(2), &BooleanRequest::default())?;
    /// let certificate = both.certificate(&[("a.wkt", texts[0]), ("b.wkt", texts[1])])?;
    /// let verdict = coface_check_plane::check(certificate.as_bytes(), &texts).expect("the proof holds");
    /// assert!(verdict.proved().contains(&"the result is (0 | 1) of the inputs, numbered from 0".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let answer = self.answer();
        if answer.snap_rounds.is_some() || answer.joined.is_some() || self.movement().is_some() {
            return Err(moved());
        }
        let formula = self.formula.as_ref().ok_or_else(|| refused("the result is of no formula"))?;
        let (plane, count) = arrangement(inputs)?;
        let proof = Proof::of(&plane, count);
        certified("boolean", self.rule, Some(formula.to_postfix()), answer, proof, inputs)
    }
}

fn certified<A: Serialize>(
    kind: &'static str,
    rule: Option<InsideRule>,
    formula: Option<String>,
    answer: A,
    proof: Proof,
    inputs: &[(&str, &[u8])],
) -> Result<String, Error> {
    let rule = rule.map(|rule| match rule {
        InsideRule::Nonzero => "nonzero",
        InsideRule::Odd => "evenodd",
        InsideRule::Positive => "positive",
    });
    let certificate = Certificate {
        coface_certificate: coface_check::VERSION,
        coface: env!("CARGO_PKG_VERSION"),
        kind,
        inputs: Input::list(inputs),
        rule,
        formula,
        answer,
        proof,
    };
    checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
}

/// The arrangement of the segments as the checker reads them, so that nothing has to be translated, and their number.
fn arrangement(inputs: &[(&str, &[u8])]) -> Result<(PlanarArrangement, usize), Error> {
    let bytes: Vec<&[u8]> = inputs.iter().map(|(_, bytes)| *bytes).collect();
    let drawing = coface_check_plane::Drawing::read(&bytes).map_err(|fault| refused(&fault.to_string()))?;
    let ends = drawing.segments();
    let positions = Positions::from_flat(2, ends.as_flattened().as_flattened().to_vec())?;
    let segments: Vec<[u32; 2]> =
        (0..ends.len() as u32).map(|segment| [2 * segment, 2 * segment + 1]).collect();
    Ok((PlanarArrangement::new(&positions, &segments)?, segments.len()))
}

/// For each bounded face a halfedge that has it on its left.
fn faces(plane: &PlanarArrangement) -> Vec<[u32; 2]> {
    let halfedge = |face: usize| {
        let first = plane.walks(Some(FaceId::new(face))).next().expect("a bounded face has a walk")[0];
        let [low, high] = plane.ends(EdgeId::from_u32(first / 2)).map(VertexId::to_u32);
        if first.is_multiple_of(2) { [low, high] } else { [high, low] }
    };
    (0..plane.face_count()).map(halfedge).collect()
}

impl Proof {
    /// The vertices and the chains; of segments 2i and 2i + 1 are the points.
    fn of(plane: &PlanarArrangement, segment_count: usize) -> Self {
        let vertices = (0..plane.vertex_count()).map(|vertex| {
            let [x, y] = plane.point(VertexId::new(vertex)).to_rational();
            // Over one denominator.
            let (by_x, by_y) = (x.denominator(), y.denominator());
            let common = by_x.gcd(&by_y);
            let part = |whole: &Integer| whole.exact_quotient(&common).expect("it divides both");
            let (of_x, of_y) = (part(&by_y), part(&by_x));
            [&x.numerator() * &of_x, &y.numerator() * &of_y, &by_x * &of_x].map(|integer| number(&integer))
        });
        let vertex = |point: usize| plane.vertex_of_point(point).expect("nothing is pruned").to_u32();
        let chains = (0..segment_count).map(|segment| {
            let [from, to] = [vertex(2 * segment), vertex(2 * segment + 1)];
            let uppers = plane.edges_of_segment(segment).map(|edge| plane.ends(edge)[1].to_u32());
            let mut chain: Vec<u32> = std::iter::once(from.min(to)).chain(uppers).collect();
            if from > to {
                chain.reverse();
            }
            chain
        });
        Self { vertices: vertices.collect(), chains: chains.collect(), faces: None }
    }
}

fn moved() -> Error {
    refused(
        "vertices were moved, so that the result is not that of the files; keep exact coordinates with --exact",
    )
}

fn refused(why: &str) -> Error {
    Error::new(
        ErrorKind::UnsupportedFormat,
        format!(
            "no certificate: {why}; leave --certificate out, or give WKT or GeoJSON of two coordinates, or .lines"
        ),
    )
}
