//! Periodic axes of a single voxel: circles that an image is multiplied by.
//!
//! Along such an axis a voxel meets itself: there is one vertex, and one edge from it to it. A cell of the image lies there once at the vertex and once along the edge,
//! and enters with the same voxel both times. So the filtered complex is that of the image without the axis, times a circle whose boundaries are zero, and by the
//! formula of Künneth each class is there twice: once in its degree and once in the next one.

use super::diagram::ImagePair;

/// The axes of an image that are periodic and have a single voxel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Circles {
    axes: Vec<usize>,
}

impl Circles {
    pub(super) fn new(shape: &[usize], is_periodic: &[bool]) -> Self {
        let is_circle = |&axis: &usize| shape[axis] == 1 && is_periodic[axis];
        Self { axes: (0..shape.len()).filter(is_circle).collect() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.axes.is_empty()
    }

    pub(super) fn contains(&self, axis: usize) -> bool {
        self.axes.contains(&axis)
    }

    /// The sets of these axes along which cells are multiplied by edges, the empty one first.
    pub(super) fn choices(&self) -> impl Iterator<Item = Vec<usize>> {
        (0..1usize << self.axes.len()).map(|choice| {
            let chosen = self.axes.iter().enumerate().filter(|(place, _)| choice >> place & 1 == 1);
            chosen.map(|(_, &axis)| axis).collect()
        })
    }

    /// How much the degrees of the classes of the image without these axes rise, an entry for each class that one of them becomes.
    pub(super) fn rises(&self) -> Vec<usize> {
        self.choices().map(|choice| choice.len()).collect()
    }

    /// The pairs of the image from those of the image without these axes.
    pub(super) fn multiplied(&self, pairs: Vec<ImagePair>) -> Vec<ImagePair> {
        if self.is_empty() {
            return pairs;
        }
        let rises = self.rises();
        let of_pair = |pair: &ImagePair| {
            let pair = *pair;
            rises.iter().map(move |rise| ImagePair { degree: pair.degree + rise, ..pair })
        };
        pairs.iter().flat_map(of_pair).collect()
    }
}
