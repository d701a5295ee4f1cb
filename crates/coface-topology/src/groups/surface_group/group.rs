//! The fundamental group of a surface.

use super::canonical_system::CanonicalSystem;
use super::klein_bottle::KleinBottle;
use super::polygon_scheme::PolygonScheme;
use super::quad_system::QuadSystem;
use crate::groups::fundamental::Presentation;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{Sign, Word};

/// The fundamental group of a surface, closed or with boundary, with normal forms.
///
/// # Examples
/// ```
/// use coface_algebra::Word;
/// use coface_topology::SurfaceGroup;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let klein = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, -2]))?;
/// assert_eq!(klein.name().to_string(), "Klein bottle group");
/// let (a, b) = (Word::from_letters([1]), Word::from_letters([2]));
/// assert!(!klein.are_equal(&a.times(&b), &b.times(&a)));
/// assert!(klein.are_equal(&a.times(&b), &b.times(&a.inverse())));
/// assert!(klein.are_conjugate(&a, &a.inverse()));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceGroup {
    generator_count: usize,
    relator: Option<Word>,
    /// Whether each generator is a loop that reverses the orientation; nothing known of free groups.
    one_sided: Vec<bool>,
    pub(super) kind: Kind,
}

/// How elements are put in normal form.
#[derive(Clone, Debug)]
pub(super) enum Kind {
    /// Without relator.
    Free,
    /// `x1^2`
    ProjectivePlane,
    Torus,
    KleinBottle(KleinBottle),
    /// Euler characteristic below 0.
    Hyperbolic(PolygonScheme, QuadSystem),
}

impl SurfaceGroup {
    /// The free group of this rank: of a surface with boundary, or for rank 0 of a disk or sphere.
    ///
    /// # Panics
    /// If the rank is beyond 2^31 - 1.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::SurfaceGroup;
    /// assert_eq!(SurfaceGroup::free(2).name().to_string(), "Free(2)");
    /// assert_eq!(SurfaceGroup::free(0).order(), Some(1));
    /// ```
    pub fn free(rank: usize) -> Self {
        assert!(i32::try_from(rank).is_ok(), "letters have 32 bits");
        Self { generator_count: rank, relator: None, one_sided: Vec::new(), kind: Kind::Free }
    }

    /// The group of the closed surface with this polygon scheme. The empty word is the sphere.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if a generator up to the highest letter does not occur exactly twice, or if the
    /// corners of the polygon are several vertices of the surface. Then the group of the presentation is a free
    /// product of the surface's group and a free group.
    ///
    /// # Complexity
    /// Linear; quadratic for the Klein bottle, whose words have four letters.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let octagon = SurfaceGroup::closed(&Word::from_letters([1, 2, 3, 4, -1, -2, -3, -4]))?;
    /// assert_eq!((octagon.is_orientable(), octagon.euler_characteristic()), (true, -2));
    /// let error = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, 2])).unwrap_err();
    /// assert!(error.message().contains("2 vertices"));
    /// # Ok(()) }
    /// ```
    pub fn closed(relator: &Word) -> Result<Self, Error> {
        let generator_count = relator.highest_letter();
        if generator_count == 0 {
            return Ok(Self::free(0));
        }
        let scheme = PolygonScheme::new(generator_count, relator)?;
        let one_sided = (1..=generator_count as i32).map(|letter| {
            let [a, b] = scheme.corners_of_letter(letter);
            scheme.signs()[a as usize] != scheme.signs()[b as usize]
        });
        let one_sided = one_sided.collect();
        let kind = match (generator_count, scheme.is_orientable()) {
            (1, _) => Kind::ProjectivePlane,
            (2, true) => Kind::Torus,
            (2, false) => Kind::KleinBottle(KleinBottle::new(&scheme)),
            _ => {
                let quads = QuadSystem::new(&scheme);
                Kind::Hyperbolic(scheme, quads)
            }
        };
        Ok(Self { generator_count, relator: Some(relator.clone()), one_sided, kind })
    }

    /// The group of a presentation without relators, or with one in which each generator occurs exactly twice. Empty
    /// relators do not count.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for other presentations, with what is wrong.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Presentation, SurfaceGroup};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = Presentation::new(1, vec![Word::from_letters([1, 1])])?;
    /// assert_eq!(SurfaceGroup::from_presentation(&plane)?.order(), Some(2));
    /// let cyclic = Presentation::new(1, vec![Word::from_letters([1, 1, 1])])?;
    /// assert!(SurfaceGroup::from_presentation(&cyclic).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_presentation(presentation: &Presentation) -> Result<Self, Error> {
        let mut relators = presentation.relators().iter().filter(|relator| !relator.is_empty());
        let (first, second) = (relators.next(), relators.next());
        match (first, second) {
            (None, _) => Ok(Self::free(presentation.generator_count())),
            (Some(relator), None) if relator.highest_letter() == presentation.generator_count() => {
                Self::closed(relator)
            }
            (Some(relator), None) => Err(Error::new(
                ErrorKind::InvalidInput,
                format!(
                    "the generator x{} does not occur in the relator {relator}",
                    presentation.generator_count()
                ),
            )
            .with_cure(
                "a free factor beside a closed surface is no surface group; treat the factors one by one",
            )),
            (Some(_), Some(_)) => Err(Error::new(
                ErrorKind::InvalidInput,
                format!("{presentation} has several relators; a surface group needs one or none"),
            )
            .with_cure("simplify the presentation, or take the relator of a polygon with one vertex")),
        }
    }

    /// The number of generators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert_eq!(torus.generator_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn generator_count(&self) -> usize {
        self.generator_count
    }

    /// The relator; none for free groups.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert_eq!(torus.relator().map(|relator| relator.len()), Some(4));
    /// assert_eq!(SurfaceGroup::free(2).relator(), None);
    /// # Ok(()) }
    /// ```
    pub fn relator(&self) -> Option<&Word> {
        self.relator.as_ref()
    }

    /// The generators and the relator.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert_eq!(torus.presentation().abelianization().to_string(), "Z^2");
    /// # Ok(()) }
    /// ```
    pub fn presentation(&self) -> Presentation {
        Presentation::new(self.generator_count, self.relator.iter().cloned().collect())
            .expect("the relator has no other letters")
    }

    /// Whether this is the group of an orientable closed surface. Free groups belong to orientable and to
    /// non-orientable surfaces with boundary; they count as orientable here.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert!(torus.is_orientable());
    /// # Ok(()) }
    /// ```
    pub fn is_orientable(&self) -> bool {
        !self.one_sided.contains(&true)
    }

    /// A canonical system of loops at the level of words; `None` for a free group, which has no relator.
    ///
    /// # Complexity
    /// $O(n^2)$ time and space for n generators if the surface is orientable. Otherwise handles beside crosscaps may
    /// make words of $O(n^2)$ letters.
    ///
    /// # References
    /// H. Seifert, W. Threlfall, *Lehrbuch der Topologie* (1934), section 38; G. Vegter, C. K. Yap, *Computational
    /// complexity of combinatorial surfaces* (1990); F. Lazarus, M. Pocchiola, G. Vegter, A. Verroust, *Computing a
    /// canonical polygonal schema of an orientable triangulated surface* (2001). Here each cut is made such that the
    /// relator remains the same word of the free group, and images come from the corners of the polygon.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// let system = torus.canonical_system().expect("it is closed");
    /// assert_eq!(system.relator().letters(), [1, 2, -1, -2]);
    /// assert_eq!(SurfaceGroup::free(2).canonical_system(), None);
    /// # Ok(()) }
    /// ```
    pub fn canonical_system(&self) -> Option<CanonicalSystem> {
        match (&self.kind, self.relator()) {
            (Kind::Hyperbolic(scheme, _), _) => Some(CanonicalSystem::of_scheme(scheme)),
            (_, Some(relator)) => {
                let scheme = PolygonScheme::new(self.generator_count(), relator);
                Some(CanonicalSystem::of_scheme(&scheme.expect("the group was made from this scheme")))
            }
            (_, None) => None,
        }
    }

    /// The Euler characteristic of the presentation complex: a vertex, an edge for each generator, a face for the
    /// relator. It is that of the surface, except for the sphere.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert_eq!(torus.euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        1 - self.generator_count as i64 + i64::from(self.relator.is_some())
    }

    /// The number of elements, if it is finite: 1 or 2.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = SurfaceGroup::closed(&Word::from_letters([1, 1]))?;
    /// assert_eq!(plane.order(), Some(2));
    /// assert_eq!(SurfaceGroup::free(1).order(), None);
    /// # Ok(()) }
    /// ```
    pub fn order(&self) -> Option<usize> {
        match self.kind {
            Kind::Free if self.generator_count == 0 => Some(1),
            Kind::ProjectivePlane => Some(2),
            _ => None,
        }
    }

    /// The corners of the relator's polygon clockwise around the vertex, with the orientation of the polygon there
    /// relative to that at corner 0, for surfaces of negative Euler characteristic.
    pub(crate) fn corners_around_vertex(&self) -> Option<Vec<(u32, Sign)>> {
        let Kind::Hyperbolic(scheme, _) = &self.kind else { return None };
        let corners = scheme.rotation().iter().rev();
        Some(corners.map(|&corner| (corner, scheme.signs()[corner as usize])).collect())
    }

    /// Whether a word is the unit: its loops are contractible.
    ///
    /// # Panics
    /// If the word has a letter that is no generator.
    ///
    /// # Complexity
    /// Linear in the word.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let genus_2 = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2, 3, 4, -3, -4]))?;
    /// assert!(genus_2.is_trivial(&Word::from_letters([-3, -4, 1, 2, -1, -2, 3, 4])));
    /// assert!(!genus_2.is_trivial(&Word::from_letters([1, 2, -1, -2])));
    /// # Ok(()) }
    /// ```
    pub fn is_trivial(&self, word: &Word) -> bool {
        self.normal_form(word).is_identity()
    }

    /// Whether two words are one element: loops with a common base point that are homotopic.
    ///
    /// # Panics
    /// If a word has a letter that is no generator.
    ///
    /// # Complexity
    /// Linear in the words.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// let (a, b) = (Word::from_letters([1]), Word::from_letters([2]));
    /// assert!(torus.are_equal(&a.times(&b), &b.times(&a)));
    /// # Ok(()) }
    /// ```
    pub fn are_equal(&self, a: &Word, b: &Word) -> bool {
        self.is_trivial(&a.times(&b.inverse()))
    }

    /// Whether the orientation is preserved or reversed along the loop of a word. Always plus in a free group, of which
    /// the surface is not known.
    ///
    /// # Panics
    /// If the word has a letter that is no generator.
    ///
    /// # Examples
    /// In the Klein bottle of `x1 x2 x1 x2^-1` the loop x2 turns x1 around:
    /// ```
    /// use coface_algebra::{Sign, Word};
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, -2]))?;
    /// assert_eq!(klein.orientation_character(&Word::from_letters([1])), Sign::Plus);
    /// assert_eq!(klein.orientation_character(&Word::from_letters([2])), Sign::Minus);
    /// # Ok(()) }
    /// ```
    pub fn orientation_character(&self, word: &Word) -> Sign {
        assert!(word.highest_letter() <= self.generator_count, "letters are generators of the group");
        if self.relator.is_none() {
            return Sign::Plus;
        }
        let letters = word.letters().iter();
        let reversals = letters.filter(|letter| self.one_sided[letter.unsigned_abs() as usize - 1]).count();
        Sign::power_of_minus_one(reversals)
    }
}
