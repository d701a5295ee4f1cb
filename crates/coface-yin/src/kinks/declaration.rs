//! Kinks of curves that stay as they are, with the names that a file gives them.

use super::{Kinks, KnotIndex};
use crate::{EndCondition, YinSet};
use coface_algebra::Error;

impl YinSet {
    /// The same curves with these kinks instead of its own: nothing is fitted. Kinks are named in their order, or as `names` says, in the
    /// order of `knots`; `next_name` is the first that was never used, if that is known.
    #[doc(hidden)]
    pub fn with_declared_kinks(
        mut self,
        knots: &[KnotIndex],
        names: Option<&[u32]>,
        next_name: Option<u32>,
    ) -> Result<Self, Error> {
        let mut named: Vec<(KnotIndex, u32)> = Vec::with_capacity(knots.len());
        for (i, &knot) in knots.iter().enumerate() {
            self.knot_to_vertex(knot)?;
            let count = self.curve(knot.curve as usize).piece_count() as u32;
            let name = names.map_or(0, |names| names[i]);
            named.push((KnotIndex { knot: knot.knot % count, ..knot }, name));
        }
        named.sort_unstable();
        if let Some(pair) = named.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let KnotIndex { curve, knot } = pair[0].0;
            return Err(Error::invalid(format!("kink {knot} of curve {curve} is given twice"))
                .with_cure("give each kink once"));
        }
        if names.is_none() {
            (0..).zip(&mut named).for_each(|(name, own)| own.1 = name);
        }
        let ends = self.kinks().pieces.ends().clone();
        let mut kinks = Kinks::named(named, next_name);
        kinks.pieces.set_ends(&ends);
        *self.kinks_mut() = kinks;
        Ok(self)
    }

    /// Splines that will be fitted end so.
    #[doc(hidden)]
    pub fn set_ends(&mut self, ends: &EndCondition) {
        self.kinks_mut().pieces.set_ends(ends);
    }
}
