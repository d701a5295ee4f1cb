//! Cycles of images that are multiplied by circles.

use super::super::filtration::ImageFiltration;
use super::cubes::steps;
use super::{CubeTerms, ImageCycle};
use crate::persistence::image::diagram::ImagePair;

/// The classes of an image that those without its circles become: see [`Circles`](super::super::circles::Circles).
pub(super) struct Multiplied {
    /// The places of cubes along each axis of the image, and the steps between their numbers.
    along: Vec<(u64, u64)>,
    /// Sets of circles along which cubes are multiplied by edges.
    choices: Vec<Vec<usize>>,
}

impl Multiplied {
    pub(super) fn new(image: &ImageFiltration) -> Self {
        let lengths = image.doubled_shape();
        let steps = steps(&lengths);
        let choices = image.circles().choices().collect();
        Self { along: lengths.into_iter().zip(steps).collect(), choices }
    }

    /// What a class of cubes at the vertices of all circles becomes: itself times each choice of edges, by rising numbers of choices.
    pub(super) fn classes(&self, class: ImageCycle, has_signs: bool) -> Vec<ImageCycle> {
        match self.choices.len() {
            1 => vec![class],
            _ => self.choices.iter().map(|choice| self.times(&class, choice, has_signs)).collect(),
        }
    }

    fn times(&self, class: &ImageCycle, choice: &[usize], has_signs: bool) -> ImageCycle {
        let step: u64 = choice.iter().map(|&axis| self.along[axis].1).sum();
        let first = self.is_turned(class.birth_cube, choice);
        let terms = |terms: &CubeTerms| -> CubeTerms {
            let term = |&(cube, x): &(u64, i64)| {
                let is_turned = has_signs && self.is_turned(cube, choice) != first;
                (cube + step, if is_turned { -x } else { x })
            };
            terms.iter().map(term).collect()
        };
        ImageCycle {
            pair: ImagePair { degree: class.pair.degree + choice.len(), ..class.pair },
            birth_cube: class.birth_cube + step,
            death_cube: class.death_cube.map(|cube| cube + step),
            cycle: terms(&class.cycle),
            bounding_chain: class.bounding_chain.as_ref().map(terms),
            cocycle: terms(&class.cocycle),
        }
    }

    /// Whether a cube times the edges, of which the axes come last, is turned when all axes are brought in order.
    fn is_turned(&self, cube: u64, choice: &[usize]) -> bool {
        let spans = |axis: usize| cube / self.along[axis].1 % self.along[axis].0 % 2 == 1;
        let passed =
            choice.iter().map(|&edge| (edge + 1..self.along.len()).filter(|&axis| spans(axis)).count());
        passed.sum::<usize>() % 2 == 1
    }
}
