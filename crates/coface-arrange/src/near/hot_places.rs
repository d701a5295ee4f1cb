//! Places where faces were found to cross: what is near them is put together within larger distances.

use super::NearChains;
use coface_geometry::{AxisBox, BoxTree};

/// So many times the distance within which features are put together is the distance from a place within which that is done.
const REACHES_AROUND: f64 = 16.0;

/// Balls around places.
#[derive(Clone, Debug)]
pub(crate) struct HotPlaces {
    tree: BoxTree,
}

impl HotPlaces {
    /// Boxes around places that reach so far that features within a distance of what is there are in them.
    pub(crate) fn new(places: &[[f64; 3]], distance: f64) -> Self {
        let margin = REACHES_AROUND * distance;
        let boxes: Vec<AxisBox> =
            places.iter().map(|place| place.map(|x| [x - margin, x + margin])).collect();
        Self { tree: BoxTree::new(&boxes) }
    }

    fn has(&self, point: [f64; 3]) -> bool {
        let mut is_in = false;
        self.tree.visit(&point.map(|x| [x; 2]), |_| is_in = true);
        is_in
    }
}

impl NearChains {
    /// Puts together from now on only what is near these places.
    pub(crate) fn stay_near(&mut self, places: HotPlaces) {
        self.hot = Some(places);
    }

    /// Whether features at a point are put together.
    pub(crate) fn is_hot(&self, point: [f64; 3]) -> bool {
        self.hot.as_ref().is_none_or(|places| places.has(point))
    }
}
