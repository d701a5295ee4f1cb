//! The diagram of an image, from the part of all blocks.

use super::super::diagram::{ImageDiagram, ImagePair};
use super::cancelling::unknown;
use super::part::{Chains, ImagePart, owner};
use coface_algebra::Error;
use coface_algebra::progress::stage;
use rayon::prelude::*;

/// A cell by the key and the number of the voxel that owns it.
type End = (u64, u64);

impl ImagePart {
    /// The diagram of the image: that of [`ImageFiltration::persistence`](crate::ImageFiltration::persistence), bit for bit.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless this is the part of all blocks; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for
    /// parts that are not of one image.
    ///
    /// # Complexity
    /// That of sorting the pairs, which were found as parts were made and merged.
    ///
    /// # Examples
    /// See [`ImageBlocks`](crate::ImageBlocks).
    pub fn diagram(&self) -> Result<ImageDiagram, Error> {
        if self.blocks != (0..self.cut.count()) {
            return Err(Error::invalid(format!(
                "a part of blocks {:?} of {} has no diagram of the image",
                self.blocks,
                self.cut.count()
            ))
            .with_cure("merge the parts of all blocks first"));
        }
        // Nothing lies outside, so what is left has no boundary.
        let mut couples = self.edges.iter().chain(&self.facets);
        let mut chains = self.boundaries.iter().map(Chains::all_names);
        if couples.any(|[a, b]| a != b) || chains.any(|names| !names.is_empty()) || !self.layer.is_empty() {
            return Err(unknown());
        }
        let (is_falling, shape) = (self.cut.is_falling(), self.cut.shape().to_vec());
        Ok(ImageDiagram { prime: self.cut.prime(), is_falling, shape, pairs: self.image_pairs() })
    }

    /// The classes as those of the image, off the diagonal.
    fn image_pairs(&self) -> Vec<ImagePair> {
        let _steps = stage("sorting pairs", 0);
        let axes = self.axes();
        let is_dual = self.cut.is_dual();
        let pair = |below: usize, first: End, last: Option<End>| {
            let (degree, birth, death) = match (is_dual, last) {
                (false, death) => (below, first, death),
                (true, None) => (axes - below, first, None),
                (true, Some(last)) => (axes - below - 1, last, Some(first)),
            };
            ImagePair {
                degree,
                birth: self.cut.value(birth.0),
                death: death.map(|death| self.cut.value(death.0)),
                birth_voxel: birth.1 as usize,
                death_voxel: death.map(|death| death.1 as usize),
            }
        };
        let mut pairs = Vec::new();
        for (degree, list) in self.pairs.iter().enumerate() {
            pairs.extend(list.iter().map(|&[a, b, c, d]| pair(degree, (a, b), Some((c, d)))));
        }
        for (degree, cells) in self.critical.iter().enumerate() {
            let cells = cells.keys.iter().zip(&cells.names);
            pairs.extend(cells.map(|(&key, &name)| pair(degree, (key, owner(name)), None)));
        }
        let mut pairs = self.cut.circles().multiplied(pairs);
        // Rising with the order in which cells enter.
        let moment = |value: f64, voxel: usize| {
            let (key, voxel) = (self.cut.key(value), voxel as u64);
            if is_dual { (!key, !voxel) } else { (key, voxel) }
        };
        let death =
            |pair: &ImagePair| pair.death.zip(pair.death_voxel).map(|(value, voxel)| moment(value, voxel));
        pairs.par_sort_by_key(|pair| (pair.degree, moment(pair.birth, pair.birth_voxel), death(pair)));
        pairs
    }
}
