//! Sets from curves that cross and overlap, by a fill rule.

use crate::Error;
use crate::arrangement::boolean::InsideRule;
use crate::yin::overlay::CurvedOverlay;
use crate::yin::set::CurveArena;
use crate::yin::{Curve, KnotIndex, Order, YinSet};

impl YinSet {
    /// The set of what closed curves of one order, each with its kinks, wind around so often that a rule calls it inside. They may cross
    /// and touch and overlap themselves and each other.
    ///
    /// Polylines are decided exactly; of other curves what is nearer together than the resolution is taken for one.
    pub(crate) fn by_rule(curves: &[(Curve<'_>, Vec<u32>)], rule: InsideRule) -> Result<Self, Error> {
        let order = curves.iter().map(|(curve, _)| curve.order()).max().unwrap_or(Order::LINEAR);
        if order == Order::LINEAR {
            let rings: Vec<&[[f64; 2]]> = curves.iter().map(|(curve, _)| curve.controls()).collect();
            return Self::from_rings(&rings, rule);
        }
        let rings: Vec<Self> = curves
            .iter()
            .map(|(curve, kinks)| {
                let mut arena = CurveArena::new(order);
                arena.push(&curve.raised(order)?);
                let kinks = kinks.iter().map(|&knot| KnotIndex { curve: 0, knot }).collect();
                Ok(Self::from_parts(arena, false, vec![None], kinks))
            })
            .collect::<Result<_, Error>>()?;
        let arenas: Vec<&CurveArena> = rings.iter().map(Self::arena).collect();
        let operands: Vec<&Self> = rings.iter().collect();
        let overlay = CurvedOverlay::new(&arenas)?;
        let is_inside =
            |windings: &[(u32, i32)]| rule.is_inside(windings.iter().map(|&(_, winding)| winding).sum());
        Ok(overlay.select_faces(&operands, is_inside)?.into_set())
    }
}
