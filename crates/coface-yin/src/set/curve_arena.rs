//! Many closed curves of one order, one after the other in flat arrays.

use crate::curve::distance;
use crate::{Carrier, Curve, Order};

/// Closed curves of one order.
#[derive(Clone, Debug)]
pub(crate) struct CurveArena {
    order: Order,
    /// The control points of each curve, its first one again at its end.
    controls: Vec<[f64; 2]>,
    /// The knots of each curve, one more than it has pieces.
    knots: Vec<f64>,
    /// The first piece of each curve in all, and their number.
    starts: Vec<u32>,
    /// The carriers of the pieces of each curve; nothing for the last curves if these have none.
    carriers: Vec<Vec<Carrier>>,
}

impl PartialEq for CurveArena {
    /// As of curves, carriers are not compared.
    fn eq(&self, other: &Self) -> bool {
        self.order == other.order
            && self.starts == other.starts
            && self.controls == other.controls
            && self.knots == other.knots
    }
}

impl CurveArena {
    pub(crate) fn new(order: Order) -> Self {
        Self { order, controls: Vec::new(), knots: Vec::new(), starts: vec![0], carriers: Vec::new() }
    }

    pub(crate) fn order(&self) -> Order {
        self.order
    }

    /// The number of curves.
    pub(crate) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of pieces of all curves.
    pub(crate) fn piece_count(&self) -> usize {
        self.starts[self.len()] as usize
    }

    /// The place of the first piece of a curve among those of all; the number of all after the last curve.
    pub(crate) fn first_piece(&self, curve: usize) -> usize {
        self.starts[curve] as usize
    }

    /// The curve and the piece in it at a place among the pieces of all.
    pub(crate) fn curve_of_piece(&self, piece: usize) -> (usize, usize) {
        let curve = self.starts.partition_point(|&start| start as usize <= piece) - 1;
        (curve, piece - self.starts[curve] as usize)
    }

    pub(crate) fn curve(&self, curve: usize) -> Curve<'_> {
        let [first, end] = [self.first_piece(curve), self.first_piece(curve + 1)];
        let degree = self.order.degree();
        // Each curve has one control point and one knot more than its pieces take.
        let controls = &self.controls[first * degree + curve..=end * degree + curve];
        let carriers = self.carriers.get(curve).map_or(&[][..], Vec::as_slice);
        Curve::borrowed(self.order, controls, &self.knots[first + curve..=end + curve]).carried_by(carriers)
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = Curve<'_>> {
        (0..self.len()).map(|curve| self.curve(curve))
    }

    /// Adds a closed curve of this order.
    pub(crate) fn push(&mut self, curve: &Curve<'_>) {
        debug_assert!(curve.order() == self.order && curve.is_closed());
        self.push_carriers(curve.carriers().to_vec());
        self.controls.extend_from_slice(curve.controls());
        self.knots.extend_from_slice(curve.knots());
        self.starts.push((self.piece_count() + curve.piece_count()) as u32);
    }

    /// Adds the carriers of the curve that is added next.
    fn push_carriers(&mut self, carriers: Vec<Carrier>) {
        if !carriers.is_empty() {
            self.carriers.resize(self.len(), Vec::new());
            self.carriers.push(carriers);
        }
    }

    /// The control points of a curve, the first one again at the end. Its pieces are whole from then on.
    pub(crate) fn controls_mut(&mut self, curve: usize) -> &mut [[f64; 2]] {
        if let Some(carriers) = self.carriers.get_mut(curve) {
            carriers.clear();
        }
        let [first, end] = [self.first_piece(curve), self.first_piece(curve + 1)];
        let degree = self.order.degree();
        &mut self.controls[first * degree + curve..=end * degree + curve]
    }

    /// Room for so many pieces of so many curves.
    pub(crate) fn with_capacity(order: Order, piece_count: usize, curve_count: usize) -> Self {
        let mut starts = Vec::with_capacity(curve_count + 1);
        starts.push(0);
        Self {
            order,
            controls: Vec::with_capacity(piece_count * order.degree() + curve_count),
            knots: Vec::with_capacity(piece_count + curve_count),
            starts,
            carriers: Vec::new(),
        }
    }

    /// The control points of all curves, one after the other, each with its first one again at its end.
    pub(crate) fn controls(&self) -> &[[f64; 2]] {
        &self.controls
    }

    /// Adds the closed polyline through points; the last goes back to the first. Knots rise even where lengths are lost in rounding.
    pub(crate) fn push_polyline(&mut self, points: impl Iterator<Item = [f64; 2]>) {
        debug_assert!(self.order == Order::LINEAR);
        let first = self.controls.len();
        self.controls.extend(points);
        self.controls.push(self.controls[first]);
        let mut knot = 0.0f64;
        self.knots.push(knot);
        let own = &self.controls[first..];
        self.knots.extend(own.windows(2).map(|pair| {
            knot = (knot + distance(pair[0], pair[1])).max(knot.next_up());
            knot
        }));
        self.starts.push((self.piece_count() + self.controls.len() - first - 1) as u32);
    }

    /// Adds a closed curve of this order with another of its knots as the first.
    pub(crate) fn push_turned(&mut self, curve: &Curve<'_>, first: usize) {
        if first == 0 {
            return self.push(curve);
        }
        let count = curve.piece_count();
        if self.order == Order::LINEAR {
            let points = curve.controls();
            return self.push_polyline((first..count).chain(0..first).map(|knot| points[knot]));
        }
        let turned = |piece: u32| (piece as usize + count - first) % count;
        let mut carriers: Vec<Carrier> =
            curve.carriers().iter().map(|own| own.of_piece(turned(own.piece()) as u32)).collect();
        carriers.sort_by_key(Carrier::piece);
        self.push_carriers(carriers);
        let at = first * self.order.degree();
        let (controls, knots) = (curve.controls(), curve.knots());
        self.controls.extend_from_slice(&controls[at..controls.len() - 1]);
        self.controls.extend_from_slice(&controls[..=at]);
        let mut knot = 0.0f64;
        self.knots.push(knot);
        self.knots.extend((first..count).chain(0..first).map(|piece| {
            knot = (knot + (knots[piece + 1] - knots[piece])).max(knot.next_up());
            knot
        }));
        self.starts.push((self.piece_count() + count) as u32);
    }
}
