//! Canonical systems of loops.

use super::polygon_scheme::PolygonScheme;
use coface_algebra::Word;

/// Generators $a_1, b_1, a_2, b_2, \dots$ with the relator $a_1 b_1 a_1^{-1} b_1^{-1} a_2 b_2 a_2^{-1} b_2^{-1}
/// \dots$ of an orientable closed surface, or $c_1, c_2, \dots$ with $c_1^2 c_2^2 \cdots$ of a non-orientable one,
/// and the isomorphism with the group they were taken from.
///
/// # Examples
/// The octagon with opposite sides glued is the surface of genus 2:
/// ```
/// use coface_algebra::Word;
/// use coface_topology::SurfaceGroup;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let octagon = Word::from_letters([1, 2, 3, 4, -1, -2, -3, -4]);
/// let system = SurfaceGroup::closed(&octagon)?.canonical_system().expect("it is closed");
/// let [a, b, c, d] = system.generators() else { panic!("genus 2") };
/// assert_eq!(a.commutator(b).times(&c.commutator(d)), octagon);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CanonicalSystem {
    is_orientable: bool,
    generators: Vec<Word>,
    images: Vec<Word>,
}

impl CanonicalSystem {
    /// Whether the relator is a product of commutators; else it is one of squares.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, -2]))?;
    /// let system = klein.canonical_system().expect("it is closed");
    /// assert!(!system.is_orientable());
    /// # Ok(()) }
    /// ```
    pub fn is_orientable(&self) -> bool {
        self.is_orientable
    }

    /// The canonical generators as words of the given ones. The product of their commutators or squares is, as a word
    /// of the free group, the given relator.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, -2]))?;
    /// let system = klein.canonical_system().expect("it is closed");
    /// // The product of the squares of the two crosscaps is the relator.
    /// let [c, d] = system.generators() else { panic!("two crosscaps") };
    /// assert_eq!(c.times(c).times(d).times(d).letters(), [1, 2, 1, -2]);
    /// # Ok(()) }
    /// ```
    pub fn generators(&self) -> &[Word] {
        &self.generators
    }

    /// The given generators as words of the canonical ones, equal in the group.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, -2]))?;
    /// let system = klein.canonical_system().expect("it is closed");
    /// assert_eq!(system.images().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn images(&self) -> &[Word] {
        &self.images
    }

    /// The relator in canonical generators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, -2]))?;
    /// let system = klein.canonical_system().expect("it is closed");
    /// assert_eq!(system.relator().letters(), [1, 1, 2, 2]);
    /// # Ok(()) }
    /// ```
    pub fn relator(&self) -> Word {
        let count = self.generators.len() as i32;
        if self.is_orientable {
            Word::from_letters((1..count).step_by(2).flat_map(|a| [a, a + 1, -a, -a - 1]))
        } else {
            Word::from_letters((1..=count).flat_map(|c| [c, c]))
        }
    }

    /// The canonical system of a polygon with one vertex.
    pub(super) fn of_scheme(scheme: &PolygonScheme) -> Self {
        let mut cutting = Cutting::new(scheme);
        while cutting.cut_crosscap() {}
        while cutting.cut_handle() {}
        let images = cutting.images(scheme);
        let handles = cutting.generators.split_off(cutting.crosscap_count);
        if cutting.crosscap_count == 0 {
            Self { is_orientable: true, generators: handles, images }
        } else {
            turn_handles_into_crosscaps(cutting.generators, &handles, &images)
        }
    }
}

/// Where the corners of the polygon go when a crosscap or a handle is cut out: corner i of the old polygon is reached
/// by `words[kind]` in canonical letters, then from the start of the new polygon to its corner.
struct Cut {
    words: Vec<Word>,
    /// The kind and the new corner of each old corner.
    corners: Vec<(u8, u32)>,
}

/// A polygon from which crosscaps and handles are cut. Always the given relator is, in the free group, the product of
/// their squares and commutators and of what is left.
struct Cutting {
    rest: Vec<i32>,
    /// For each letter the place of its mate in the rest.
    mates: Vec<usize>,
    crosscap_count: usize,
    generators: Vec<Word>,
    cuts: Vec<Cut>,
}

fn word<'a>(parts: impl IntoIterator<Item = &'a [i32]>) -> Word {
    Word::from_letters(parts.into_iter().flatten().copied())
}

impl Cutting {
    fn new(scheme: &PolygonScheme) -> Self {
        let mut cutting = Self {
            rest: scheme.letters().to_vec(),
            mates: Vec::new(),
            crosscap_count: 0,
            generators: Vec::new(),
            cuts: Vec::new(),
        };
        cutting.pair(scheme.generator_count());
        cutting
    }

    /// Finds the mates again.
    fn pair(&mut self, generator_count: usize) {
        let mut first = vec![usize::MAX; generator_count];
        self.mates = vec![0; self.rest.len()];
        for (place, letter) in self.rest.iter().enumerate() {
            let own = &mut first[letter.unsigned_abs() as usize - 1];
            if *own == usize::MAX {
                *own = place;
            } else {
                (self.mates[place], self.mates[*own]) = (*own, place);
            }
        }
    }

    fn is_twisted(&self, place: usize) -> bool {
        self.rest[place] == self.rest[self.mates[place]]
    }

    /// Whether crosscaps remain when the one at this place is cut out: the pairs that it separates change their kind.
    fn stays_twisted(&self, place: usize) -> bool {
        let (i, j) = (place, self.mates[place]);
        (0..self.rest.len()).filter(|&k| k != i && k != j).any(|k| {
            let separates = (i < k && k < j) != (i < self.mates[k] && self.mates[k] < j);
            self.is_twisted(k) != separates
        })
    }

    /// Cuts out a crosscap: for Z b X b T the square of c = Z b X Z^-1, which leaves Z X^-1 T.
    fn cut_crosscap(&mut self) -> bool {
        let mut twisted =
            (0..self.rest.len()).filter(|&place| place < self.mates[place] && self.is_twisted(place));
        // Handles are cheaper before the last crosscap is cut than after it; a few attempts must do.
        let Some(first) =
            twisted.clone().take(4).find(|&place| self.stays_twisted(place)).or_else(|| twisted.next())
        else {
            return false;
        };
        let second = self.mates[first];
        let rest = &self.rest;
        let (z, b, x, t) = (&rest[..first], rest[first], &rest[first + 1..second], &rest[second + 1..]);
        let backwards: Vec<i32> = z.iter().rev().map(|letter| -letter).collect();
        self.generators.push(word([z, &[b], x, &backwards]));
        self.crosscap_count += 1;
        let c = self.generators.len() as i32;
        let end = (first + x.len()) as u32;
        let corners = (0..=first as u32).map(|corner| (0, corner));
        let corners = corners.chain((0..=x.len() as u32).map(|corner| (1, end - corner)));
        let corners = corners.chain((0..=t.len() as u32).map(|corner| (2, end + corner))).collect();
        let words = [&[][..], &[c], &[c, c]].map(|letters| word([letters])).to_vec();
        let left = z.iter().copied().chain(x.iter().rev().map(|letter| -letter)).chain(t.iter().copied());
        self.finish(left.collect(), Cut { words, corners });
        true
    }

    /// Cuts out a handle: for a P b Q a^-1 S b^-1 T the commutator of z = a Q^-1 S^-1 and v = S Q P b S^-1, which
    /// leaves S Q P T.
    fn cut_handle(&mut self) -> bool {
        let rest = &self.rest;
        let Some(&a) = rest.first() else { return false };
        let j = self.mates[0];
        let i = (1..j).find(|&place| self.mates[place] > j).expect("all corners are one vertex");
        let k = self.mates[i];
        let (p, b, q) = (&rest[1..i], rest[i], &rest[i + 1..j]);
        let (s, t) = (&rest[j + 1..k], &rest[k + 1..]);
        let backwards = |part: &[i32]| -> Vec<i32> { part.iter().rev().map(|letter| -letter).collect() };
        let (q_backwards, s_backwards) = (backwards(q), backwards(s));
        self.generators.push(word([&[a], &q_backwards[..], &s_backwards[..]]));
        self.generators.push(word([s, q, p, &[b], &s_backwards]));
        let v = self.generators.len() as i32;
        let z = v - 1;
        let words = [&[][..], &[z], &[z, v], &[z, v, -z], &[z, v, -z, -v]].map(|letters| word([letters]));
        let [before_q, before_p, before_t] = [s.len(), s.len() + q.len(), s.len() + q.len() + p.len()];
        let parts = [(1, before_p, p), (2, before_q, q), (3, 0, s), (4, before_t, t)];
        let corners = parts.into_iter().flat_map(|(kind, before, part)| {
            (0..=part.len()).map(move |corner| (kind, (before + corner) as u32))
        });
        let corners = std::iter::once((0, 0)).chain(corners).collect();
        let left = [s, q, p, t].concat();
        self.finish(left, Cut { words: words.to_vec(), corners });
        true
    }

    fn finish(&mut self, rest: Vec<i32>, cut: Cut) {
        self.rest = rest;
        self.cuts.push(cut);
        let highest = self.rest.iter().map(|letter| letter.unsigned_abs()).max().unwrap_or(0);
        self.pair(highest as usize);
    }

    /// The given generators in the letters of the crosscaps and handles: what lies between two corners.
    fn images(&self, scheme: &PolygonScheme) -> Vec<Word> {
        let path_to = |corner: u32| {
            let mut path = Word::new();
            let mut at = corner;
            for cut in &self.cuts {
                let (kind, next) = cut.corners[at as usize];
                path.append(&cut.words[usize::from(kind)]);
                at = next;
            }
            path
        };
        let letters = 1..=scheme.generator_count() as i32;
        let images = letters.map(|letter| {
            let side = scheme.first_side(letter) as u32;
            let along = path_to(side).inverse().times(&path_to(side + 1));
            if scheme.letters()[side as usize] == letter { along } else { along.inverse() }
        });
        images.collect()
    }
}

/// Replaces crosscap and handle, c c x y x^-1 y^-1, by three crosscaps, one handle after the other.
///
/// With r = c x, p = r x^-1 r y r^-1 and q = r y^-1 r^-2 it is p p q q r r; c = p q r, x = r^-1 q^-1 p^-1 r and
/// y = r^-2 q^-1 r. The last r is the c of the next handle.
///
/// Source: W. von Dyck, *Beitraege zur Analysis situs* (1888).
fn turn_handles_into_crosscaps(crosscaps: Vec<Word>, handles: &[Word], images: &[Word]) -> CanonicalSystem {
    let (kept, count) = (crosscaps.len() - 1, (crosscaps.len() + handles.len()) as i32);
    let mut generators = crosscaps;
    for pair in handles.chunks_exact(2) {
        let (x, y) = (&pair[0], &pair[1]);
        let c = generators.pop().expect("there is a crosscap");
        let r = c.times(x);
        let r_inverse = r.inverse();
        let p = r.times(&x.inverse()).times(&r).times(y).times(&r_inverse);
        let q = r.times(&y.inverse()).times(&r_inverse).times(&r_inverse);
        generators.extend([p, q, r]);
    }
    // The crosscap before each handle in the last letters, from the last handle back.
    let letter = |letter: i32| Word::from_letters([letter]);
    let mut crosscap = letter(count);
    let mut handle_images = Vec::with_capacity(handles.len());
    for handle in (0..handles.len() / 2).rev() {
        let p = letter((kept + 2 * handle) as i32 + 1);
        let q = letter((kept + 2 * handle) as i32 + 2);
        let r = crosscap;
        let r_inverse = r.inverse();
        let y = r_inverse.times(&r_inverse).times(&q.inverse()).times(&r);
        let x = r_inverse.times(&q.inverse()).times(&p.inverse()).times(&r);
        crosscap = p.times(&q).times(&r);
        handle_images.extend([y, x]);
    }
    let mut substitution: Vec<Word> = (1..=kept as i32).map(letter).collect();
    substitution.push(crosscap);
    substitution.extend(handle_images.into_iter().rev());
    let images = images.iter().map(|image| image.image(&substitution)).collect();
    CanonicalSystem { is_orientable: false, generators, images }
}
