//! The elements up to a length.

use super::{NormalForm, SurfaceGroup};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{Integer, Word};
use std::collections::HashMap;

/// No element of the ball.
const NONE: u32 = u32::MAX;

/// The first elements of a surface group in the shortlex order of some generators, with the products by letters that
/// stay among them.
///
/// Elements are ordered by their shortlex words: shorter words first, words of equal length by their first different
/// letter in the order +1, -1, +2, -2, .... Element 0 is the unit.
///
/// # Examples
/// ```
/// use coface_topology::{Ball, SurfaceGroup};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ball = Ball::new(&SurfaceGroup::free(2), 2, 1000)?;
/// assert_eq!((ball.len(), ball.sphere_sizes()), (17, vec![1, 4, 12]));
/// assert_eq!(ball.word(5).to_string(), "x1^2");
/// assert_eq!(ball.neighbor(5, -1), Some(1));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Ball {
    generator_count: usize,
    elements: Vec<NormalForm>,
    /// The element before the last letter, and that letter; 0 for the unit.
    parents: Vec<u32>,
    letters: Vec<i32>,
    /// Where the elements of each length start.
    starts: Vec<usize>,
    /// For each element the products with +1, -1, +2, -2, ....
    neighbors: Vec<u32>,
    numbers: HashMap<NormalForm, u32>,
}

/// The column of a letter.
fn column(letter: i32) -> usize {
    2 * (letter.unsigned_abs() as usize - 1) + usize::from(letter < 0)
}

impl Ball {
    /// All elements of length at most `radius`.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] before anything is listed if there are more than `most`, with the number that is needed.
    ///
    /// # Complexity
    /// $O(m n r)$ for m elements, n generators and the radius r, and $O(m (n + r))$ space.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// // 1 + 4 + 12 reduced words of at most two letters.
    /// assert_eq!(ball.len(), 17);
    /// assert!(Ball::new(&group, 2, 16).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(group: &SurfaceGroup, radius: usize, most: usize) -> Result<Self, Error> {
        let most = most.min(NONE as usize - 1);
        match group.ball_size(radius, most) {
            Some(count) => Ok(Self::first(group, count)),
            None => Err(too_large(group, radius, most)),
        }
    }

    /// The first elements in shortlex order, so many of them, or all if the group has fewer.
    ///
    /// # Panics
    /// From 2^32 - 1 elements on.
    ///
    /// # Complexity
    /// As [`Self::new`] with the greatest length that occurs.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// let ball = Ball::first(&SurfaceGroup::free(2), 3);
    /// assert_eq!(ball.word(2).to_string(), "x1^-1");
    /// ```
    pub fn first(group: &SurfaceGroup, count: usize) -> Self {
        let letters: Vec<Word> =
            (1..=group.generator_count() as i32).map(|letter| Word::from_letters([letter])).collect();
        Self::of_generators(group, &letters, count)
    }

    /// As [`Self::first`], for words as letters +1, +2, .... They must generate the group.
    ///
    /// # Panics
    /// From 2^32 - 1 elements on, or if a word has a letter that is no generator of the group.
    ///
    /// # Examples
    /// The integers by steps of 2 and 3:
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Ball, SurfaceGroup};
    /// let integers = SurfaceGroup::free(1);
    /// let steps = [2, 3].map(|exponent| Word::from_letters([1]).power(exponent));
    /// let ball = Ball::of_generators(&integers, &steps, 10);
    /// let unit = integers.normal_form(&Word::from_letters([1]));
    /// assert_eq!(ball.word(ball.number(&unit).expect("it is near")).to_string(), "x1^-1 x2");
    /// ```
    pub fn of_generators(group: &SurfaceGroup, generators: &[Word], count: usize) -> Self {
        assert!(count < NONE as usize, "a ball has fewer than 2^32 - 1 elements");
        let width = 2 * generators.len();
        let mut ball = Self {
            generator_count: generators.len(),
            elements: Vec::new(),
            parents: Vec::new(),
            letters: Vec::new(),
            starts: vec![0],
            neighbors: Vec::new(),
            numbers: HashMap::new(),
        };
        if count == 0 {
            return ball;
        }
        ball.insert(group.identity(), 0, 0);
        let forms: Vec<(i32, NormalForm)> = (1..)
            .zip(generators)
            .map(|(letter, word)| (letter, group.normal_form(word)))
            .flat_map(|(letter, form)| {
                let inverse = group.inverse(&form);
                [(letter, form), (-letter, inverse)]
            })
            .collect();
        let (mut at, mut level_end) = (0, 1);
        let steps = stage("finding words", 0);
        while at < ball.elements.len() {
            steps.pass(at);
            if at == level_end {
                ball.starts.push(at);
                level_end = ball.elements.len();
            }
            for (letter, form) in &forms {
                if ball.neighbors[at * width + column(*letter)] != NONE {
                    continue;
                }
                let product = group.product(&ball.elements[at], form);
                let number = match ball.numbers.get(&product) {
                    Some(&number) => number,
                    None if ball.elements.len() < count => ball.insert(product, at as u32, *letter),
                    None => continue,
                };
                ball.neighbors[at * width + column(*letter)] = number;
                ball.neighbors[number as usize * width + column(-letter)] = at as u32;
            }
            at += 1;
        }
        ball
    }

    fn insert(&mut self, element: NormalForm, parent: u32, letter: i32) -> u32 {
        let number = self.elements.len() as u32;
        self.numbers.insert(element.clone(), number);
        self.elements.push(element);
        self.parents.push(parent);
        self.letters.push(letter);
        self.neighbors.resize(self.neighbors.len() + 2 * self.generator_count, NONE);
        number
    }

    /// The number of elements.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert_eq!(ball.len(), 17);
    /// # Ok(()) }
    /// ```
    pub fn len(&self) -> usize {
        self.elements.len()
    }

    /// Whether there is no element.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert!(!ball.is_empty());
    /// # Ok(()) }
    /// ```
    pub fn is_empty(&self) -> bool {
        self.elements.is_empty()
    }

    /// The elements in shortlex order.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert!(ball.elements()[0].is_identity());
    /// # Ok(()) }
    /// ```
    pub fn elements(&self) -> &[NormalForm] {
        &self.elements
    }

    /// The number of an element, if it is here.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert_eq!(ball.number(&group.normal_form(&Word::from_letters([2]))), Some(3));
    /// assert_eq!(ball.number(&group.normal_form(&Word::from_letters([1, 1, 1]))), None);
    /// # Ok(()) }
    /// ```
    pub fn number(&self, element: &NormalForm) -> Option<usize> {
        self.numbers.get(element).map(|&number| number as usize)
    }

    /// The number of elements of each length.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert_eq!(ball.sphere_sizes(), [1, 4, 12]);
    /// # Ok(()) }
    /// ```
    pub fn sphere_sizes(&self) -> Vec<usize> {
        let ends = self.starts[1..].iter().copied().chain([self.len()]);
        let sizes = self.starts.iter().zip(ends).map(|(start, end)| end - start);
        sizes.filter(|&size| size > 0).collect()
    }

    /// The length of an element.
    ///
    /// # Panics
    /// If there is no such element.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert_eq!((ball.length(0), ball.length(4), ball.length(5)), (0, 1, 2));
    /// # Ok(()) }
    /// ```
    pub fn length(&self, element: usize) -> usize {
        assert!(element < self.len(), "element {element} of {}", self.len());
        self.starts.partition_point(|&start| start <= element) - 1
    }

    /// The shortlex word of an element.
    ///
    /// # Panics
    /// If there is no such element.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert_eq!(ball.word(5).to_string(), "x1^2");
    /// # Ok(()) }
    /// ```
    pub fn word(&self, element: usize) -> Word {
        let mut letters = Vec::with_capacity(self.length(element));
        let mut at = element;
        while at != 0 {
            letters.push(self.letters[at]);
            at = self.parents[at] as usize;
        }
        Word::from_letters(letters.into_iter().rev())
    }

    /// The product of an element and a letter, if it is here.
    ///
    /// # Panics
    /// If there is no such element or letter.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Ball, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = SurfaceGroup::free(2);
    /// let ball = Ball::new(&group, 2, 1000)?;
    /// assert_eq!(ball.neighbor(0, 1), Some(1));
    /// assert_eq!(ball.neighbor(5, 1), None, "three letters are too many");
    /// # Ok(()) }
    /// ```
    pub fn neighbor(&self, element: usize, letter: i32) -> Option<usize> {
        let place = column(letter);
        assert!(place < 2 * self.generator_count, "letter {letter} is no generator");
        let neighbor = self.neighbors[element * 2 * self.generator_count + place];
        (neighbor != NONE).then_some(neighbor as usize)
    }
}

/// The refusal of a ball, with the number of its elements when that is not too long to write.
fn too_large(group: &SurfaceGroup, radius: usize, most: usize) -> Error {
    let needed = if radius <= 64 {
        let total = group.sphere_sizes(radius).iter().fold(Integer::ZERO, |sum, size| sum + size.clone());
        total.to_string()
    } else {
        format!("more than {most}")
    };
    Error::new(
        ErrorKind::TooLarge,
        format!("there are {needed} elements up to length {radius} ({}); the limit is {most}", group.name()),
    )
    .with_cure("take a smaller radius")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_is_refused_at_once() {
        let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2])).unwrap();
        let genus_2 = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2, 3, 4, -3, -4])).unwrap();
        let message = |group: &SurfaceGroup, radius| Ball::new(group, radius, 100).unwrap_err().to_string();
        assert_eq!(
            message(&torus, 7),
            "there are 113 elements up to length 7 (Z^2); the limit is 100; take a smaller radius"
        );
        assert!(message(&genus_2, 10).contains(" 369256049 "), "{}", message(&genus_2, 10));
        assert!(message(&genus_2, usize::MAX).contains("more than 100 elements"));
        assert_eq!(Ball::first(&torus, 7).sphere_sizes(), [1, 4, 2]);
        assert!(Ball::first(&torus, 0).is_empty());
        assert_eq!(Ball::first(&SurfaceGroup::free(0), 9).len(), 1);
    }
}
