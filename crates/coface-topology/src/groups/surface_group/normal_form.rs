//! Normal forms of elements.

use super::SurfaceGroup;
use super::group::Kind;
use super::klein_bottle;
use super::quad_system::{Hub, QuadSystem};
use super::walk::Walk;
use coface_algebra::{Sign, Word};

/// An element of a [`SurfaceGroup`]: the same for all words that are equal there.
///
/// It can be compared, sorted and hashed; the order has no further meaning. What it holds depends on the group: the
/// reduced word of a free group, exponents for torus, Klein bottle and projective plane, and in all other groups the
/// rightmost shortest walk in the system of quads.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NormalForm(pub(super) Form);

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Form {
    /// The reduced word of a free group.
    Letters(Box<[i32]>),
    /// The parity of the projective plane, the exponents of the torus, the exponents i and j of $a^i t^j$ on the Klein
    /// bottle.
    Exponents([i64; 2]),
    /// The edges of a walk that starts and ends at the vertex.
    Walk(Box<[u32]>),
}

impl NormalForm {
    /// Whether this is the unit.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert!(torus.normal_form(&Word::from_letters([1, 2, -1, -2])).is_identity());
    /// # Ok(()) }
    /// ```
    pub fn is_identity(&self) -> bool {
        match &self.0 {
            Form::Letters(letters) => letters.is_empty(),
            Form::Exponents(exponents) => *exponents == [0, 0],
            Form::Walk(edges) => edges.is_empty(),
        }
    }
}

impl NormalForm {
    /// The exponents of an element on the surfaces of Euler characteristic 0: the number of times that the one
    /// generator of a free group occurs, else those of the normal form.
    pub(crate) fn exponents(&self) -> Option<[i64; 2]> {
        match &self.0 {
            Form::Letters(letters) => Some([letters.iter().map(|&letter| i64::from(letter)).sum(), 0]),
            Form::Exponents(exponents) => Some(*exponents),
            Form::Walk(_) => None,
        }
    }
}

/// The edges of the rightmost shortest walk from the vertex that is homotopic to this one.
fn rightmost(quads: &QuadSystem, edges: impl IntoIterator<Item = u32>) -> Form {
    let mut walk = Walk::new(quads, Hub::Vertex, Sign::Plus);
    for edge in edges {
        walk.push(edge);
    }
    Form::Walk(walk.edges().into())
}

impl SurfaceGroup {
    /// The unit.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert!(torus.identity().is_identity());
    /// # Ok(()) }
    /// ```
    pub fn identity(&self) -> NormalForm {
        NormalForm(match &self.kind {
            Kind::Free => Form::Letters(Box::default()),
            Kind::ProjectivePlane | Kind::Torus | Kind::KleinBottle(_) => Form::Exponents([0, 0]),
            Kind::Hyperbolic(..) => Form::Walk(Box::default()),
        })
    }

    /// The element that a word is.
    ///
    /// # Panics
    /// If the word has a letter that is no generator.
    ///
    /// # Complexity
    /// Linear in the word.
    ///
    /// # References
    /// F. Lazarus, J. Rivaud, *On the homotopy test on surfaces* (2012), section 3; J. Erickson, K. Whittlesey,
    /// *Transforming curves on surfaces redux* (2013), section 3. They treat orientable surfaces; here a walk carries
    /// the orientation of the universal cover along, which makes turns meaningful on all of them.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let genus_2 = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2, 3, 4, -3, -4]))?;
    /// let one = genus_2.normal_form(&Word::from_letters([1, 2, -1, -2]));
    /// assert_eq!(one, genus_2.normal_form(&Word::from_letters([4, 3, -4, -3])));
    /// assert_ne!(one, genus_2.identity());
    /// # Ok(()) }
    /// ```
    pub fn normal_form(&self, word: &Word) -> NormalForm {
        self.times_word(&self.identity(), word)
    }

    /// The product of an element and a word, the element first.
    ///
    /// # Panics
    /// If the word has a letter that is no generator, or the element is of another kind of group.
    ///
    /// # Complexity
    /// Linear in the element and the word.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// let (a, b) = (Word::from_letters([1]), Word::from_letters([2]));
    /// let ab = torus.times_word(&torus.normal_form(&a), &b);
    /// assert_eq!(ab, torus.normal_form(&a.times(&b)));
    /// # Ok(()) }
    /// ```
    pub fn times_word(&self, element: &NormalForm, word: &Word) -> NormalForm {
        assert!(word.highest_letter() <= self.generator_count(), "letters are generators of the group");
        NormalForm(match (&self.kind, &element.0) {
            (Kind::Free, Form::Letters(letters)) => {
                let product = Word::from_letters(letters.iter().chain(word.letters()).copied());
                Form::Letters(product.letters().into())
            }
            (Kind::ProjectivePlane, Form::Exponents([i, _])) => {
                Form::Exponents([(i + word.len() as i64) % 2, 0])
            }
            (Kind::Torus, Form::Exponents([i, j])) => {
                let sums = word.exponent_sums(2);
                Form::Exponents([i + sums[0], j + sums[1]])
            }
            (Kind::KleinBottle(bottle), Form::Exponents(exponents)) => {
                let letters = word.letters().iter().map(|&letter| bottle.letter(letter));
                Form::Exponents(letters.fold(*exponents, klein_bottle::product))
            }
            (Kind::Hyperbolic(scheme, quads), Form::Walk(edges)) => {
                let more = word.letters().iter().flat_map(|&letter| scheme.corners_of_letter(letter));
                rightmost(quads, edges.iter().copied().chain(more))
            }
            _ => unreachable!("normal forms belong to one kind of group"),
        })
    }

    /// The element of a walk that goes from corner to corner of the polygon of the scheme: each step is given by the
    /// numbers of letters before the corners that it leaves and reaches.
    ///
    /// # Complexity
    /// Linear in the number of steps for the groups of closed surfaces; in that of free groups each step has as many
    /// letters as lie between its corners.
    pub(crate) fn element_of_steps(&self, steps: impl Iterator<Item = [usize; 2]>) -> NormalForm {
        match (&self.kind, &self.relator()) {
            (Kind::Hyperbolic(_, quads), _) => {
                NormalForm(rightmost(quads, steps.flatten().map(|corner| corner as u32 % quads.degree())))
            }
            (_, Some(relator)) => {
                let mut word = Word::new();
                for [from, to] in steps {
                    let (low, high) = (from.min(to), from.max(to));
                    let part = Word::from_letters(relator.letters()[low..high].iter().copied());
                    word.append(&if from <= to { part } else { part.inverse() });
                }
                self.normal_form(&word)
            }
            (_, None) => self.identity(),
        }
    }

    /// The product of two elements.
    ///
    /// # Panics
    /// If an element is of another kind of group.
    ///
    /// # Complexity
    /// Linear in both.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// let (a, b) = (Word::from_letters([1]), Word::from_letters([2]));
    /// let (x, y) = (torus.normal_form(&a), torus.normal_form(&b));
    /// assert_eq!(torus.product(&x, &y), torus.product(&y, &x));
    /// # Ok(()) }
    /// ```
    pub fn product(&self, a: &NormalForm, b: &NormalForm) -> NormalForm {
        NormalForm(match (&self.kind, &a.0, &b.0) {
            (Kind::Free, Form::Letters(a), Form::Letters(b)) => {
                Form::Letters(Word::from_letters(a.iter().chain(b).copied()).letters().into())
            }
            (Kind::ProjectivePlane, Form::Exponents(a), Form::Exponents(b)) => {
                Form::Exponents([(a[0] + b[0]) % 2, 0])
            }
            (Kind::Torus, Form::Exponents(a), Form::Exponents(b)) => {
                Form::Exponents([a[0] + b[0], a[1] + b[1]])
            }
            (Kind::KleinBottle(_), Form::Exponents(a), Form::Exponents(b)) => {
                Form::Exponents(klein_bottle::product(*a, *b))
            }
            (Kind::Hyperbolic(_, quads), Form::Walk(a), Form::Walk(b)) => {
                rightmost(quads, a.iter().chain(b).copied())
            }
            _ => unreachable!("normal forms belong to one kind of group"),
        })
    }

    /// The inverse of an element.
    ///
    /// # Panics
    /// If the element is of another kind of group.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// let (a, b) = (Word::from_letters([1]), Word::from_letters([2]));
    /// let x = torus.normal_form(&a);
    /// assert!(torus.product(&x, &torus.inverse(&x)).is_identity());
    /// # Ok(()) }
    /// ```
    pub fn inverse(&self, element: &NormalForm) -> NormalForm {
        NormalForm(match (&self.kind, &element.0) {
            (Kind::Free, Form::Letters(letters)) => {
                Form::Letters(letters.iter().rev().map(|letter| -letter).collect())
            }
            (Kind::ProjectivePlane, Form::Exponents(own)) => Form::Exponents(*own),
            (Kind::Torus, Form::Exponents([i, j])) => Form::Exponents([-i, -j]),
            (Kind::KleinBottle(_), Form::Exponents(own)) => Form::Exponents(klein_bottle::inverse(*own)),
            (Kind::Hyperbolic(_, quads), Form::Walk(edges)) => rightmost(quads, edges.iter().rev().copied()),
            _ => unreachable!("normal forms belong to one kind of group"),
        })
    }

    /// A word for an element: without detours, yet not always the shortest. The words of a [`super::Ball`] are
    /// shortest.
    ///
    /// # Panics
    /// If the element is of another kind of group.
    ///
    /// # Complexity
    /// Linear in the element times the number of generators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// let element = torus.normal_form(&Word::from_letters([2, 1, 2, -1, 1]));
    /// assert_eq!(torus.word(&element).to_string(), "x1 x2^2");
    /// # Ok(()) }
    /// ```
    pub fn word(&self, element: &NormalForm) -> Word {
        match (&self.kind, &element.0) {
            (Kind::Free, Form::Letters(letters)) => Word::from_letters(letters.iter().copied()),
            (Kind::ProjectivePlane | Kind::Torus, Form::Exponents(exponents)) => {
                let powers = (1..).zip(exponents).flat_map(|(letter, &exponent)| {
                    let letter = if exponent < 0 { -letter } else { letter };
                    std::iter::repeat_n(letter, exponent.unsigned_abs() as usize)
                });
                Word::from_letters(powers)
            }
            (Kind::KleinBottle(bottle), Form::Exponents(exponents)) => bottle.word(*exponents),
            (Kind::Hyperbolic(scheme, _), Form::Walk(edges)) => {
                let mut word = Word::new();
                for chord in edges.chunks_exact(2) {
                    for letter in scheme.letters_between(chord[0], chord[1]) {
                        word.push(letter);
                    }
                }
                scheme.dehn_reduced(&word)
            }
            _ => unreachable!("normal forms belong to one kind of group"),
        }
    }
}
