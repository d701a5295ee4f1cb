//! What is known of a set, as JSON.

use super::PlanarSet;
use coface_algebra::Error;
use coface_yin::{Assumption, Combination, PieceSource, UncertifiedDecision, YinSet};
use serde_json::{Value, json};

/// The part of the largest extent of a set that its perimeter is known to.
const PRECISION: f64 = 1e-13;

impl PlanarSet {
    /// The box around all curves; none without curves.
    pub fn bounding_box(&self) -> Option<[[f64; 2]; 2]> {
        let boxes = (0..self.set.curve_count()).map(|curve| self.set.curve(curve).bounding_box());
        boxes.reduce(|[low, high], [lower, higher]| {
            [
                [0, 1].map(|axis| f64::min(low[axis], lower[axis])),
                [0, 1].map(|axis| f64::max(high[axis], higher[axis])),
            ]
        })
    }

    /// The set as one JSON object.
    ///
    /// * `empty`, `plane`, `bounded`; `area`, `null` if the set is unbounded; `perimeter`, the length of all curves; `order`;
    /// * `curve_counts`: the positive and the negative curves, and one more for the atom that is unbounded, as the papers on Yin sets
    ///   count; `betti_open` and `betti_closed`: components and holes of the set and of its closure;
    /// * `curves`: for each `sign` (1 counterclockwise, -1 clockwise), `area` with that sign, `length`, `knots`, `kinks`, `vertices` (the
    ///   names of the kinks), `parent` (the curve directly around it, or `null`), `depth` and `name`;
    /// * `atoms`: the curves of each component, the positive one first, if it has one; `kinks`, how many; `bounding_box`, `null` without curves.
    ///
    /// # Errors
    /// Those of [`YinSet::betti_open`].
    pub fn to_json(&self) -> Result<Value, Error> {
        let set = &self.set;
        let frame = self.bounding_box();
        let extent = frame.map_or(0.0, |[low, high]| (high[0] - low[0]).max(high[1] - low[1]));
        let tolerance = (PRECISION * extent).max(f64::MIN_POSITIVE);
        let mut kinks = set.kinks().iter().peekable();
        let mut perimeter = 0.0;
        let mut curves = Vec::with_capacity(set.curve_count());
        for number in 0..set.curve_count() {
            let curve = set.curve(number);
            let (mut own, mut vertices) = (Vec::new(), Vec::new());
            while let Some((knot, vertex)) = kinks.next_if(|(knot, _)| knot.curve as usize == number) {
                own.push(knot.knot);
                vertices.push(vertex.to_u32());
            }
            let area = curve.signed_area();
            let length = curve.length(tolerance);
            perimeter += length;
            curves.push(json!({
                "sign": if area < 0.0 { -1 } else { 1 },
                "area": area,
                "length": length,
                "knots": curve.piece_count(),
                "kinks": own,
                "vertices": vertices,
                "parent": set.forest().parent(number),
                "depth": set.forest().depth(number),
                "name": self.names.get(number).cloned().flatten(),
            }));
        }
        let atoms: Vec<Value> = set.atoms().iter().map(|atom| atom.curves().collect()).collect();
        Ok(json!({
            "empty": set.is_empty(),
            "plane": set.is_plane(),
            "bounded": set.is_bounded(),
            "area": set.area(),
            "perimeter": perimeter,
            "curve_counts": set.curve_counts(),
            "betti_open": set.betti_open()?,
            "betti_closed": set.betti_closed()?,
            "curves": curves,
            "order": set.order().value(),
            "atoms": atoms,
            "kinks": set.kinks().len(),
            "bounding_box": frame,
        }))
    }

    /// Where the pieces of the boundary of a combination come from: `sources` has for each curve a list of
    /// `[operand, curve, piece, from, to]`, one for each piece: the part of a piece of an operand by parameters in the unit interval, which
    /// fall where the result runs against its source.
    pub fn provenance_to_json(combination: &Combination) -> Value {
        let set: &YinSet = combination.set();
        let mut sources = combination.sources().iter();
        let lists: Vec<Value> = (0..set.curve_count())
            .map(|curve| sources.by_ref().take(set.curve(curve).piece_count()).map(source_to_json).collect())
            .collect();
        json!({ "sources": lists })
    }

    /// A decision that was taken without proof: `point`, `pieces` as in [`Self::provenance_to_json`], and what was `assumed`.
    pub fn decision_to_json(decision: &UncertifiedDecision) -> Value {
        json!({
            "point": decision.point,
            "pieces": decision.pieces.iter().map(source_to_json).collect::<Vec<_>>(),
            "assumed": match decision.assumption {
                Assumption::SamePoint => "the same point",
                Assumption::SameArc => "the same arc",
                Assumption::ArcOrder => "the order of arcs at a point",
                Assumption::SmallCurve => "a curve too small to be kept",
            },
        })
    }
}

fn source_to_json(source: &PieceSource) -> Value {
    let [from, to] = source.range;
    json!([source.operand, source.curve, source.piece, from, to])
}
