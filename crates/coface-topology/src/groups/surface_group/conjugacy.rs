//! Conjugate elements: closed curves up to free homotopy.

use super::group::Kind;
use super::normal_form::{Form, NormalForm};
use super::quad_system::{Hub, QuadSystem};
use super::walk::Walk;
use super::{SurfaceGroup, klein_bottle};
use coface_algebra::{Sign, Word, least_rotation};

/// The conjugacy class of an element of a [`SurfaceGroup`]: the same for all words that are conjugate there, which
/// are the closed curves that are freely homotopic.
///
/// It can be compared, sorted and hashed; the order has no further meaning.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ConjugacyForm(Class);

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Class {
    /// The least rotation of the cyclically reduced word of a free group.
    Letters(Box<[i32]>),
    /// Exponents as in the normal form.
    Exponents([i64; 2]),
    /// The pairs of edges of a closed walk, of the square for a one-sided curve.
    Walk { is_one_sided: bool, chords: Box<[[u32; 2]]> },
}

impl SurfaceGroup {
    /// The conjugacy class of a word.
    ///
    /// On surfaces of negative Euler characteristic it is the rightmost shortest closed walk in the system of quads:
    /// the least rotation of its edges and, on non-orientable surfaces, the lesser of this and of the leftmost one,
    /// since conjugation by a one-sided loop exchanges the two. One-sided curves are compared by their squares,
    /// because elements without torsion in a hyperbolic group have at most one root.
    ///
    /// # Panics
    /// If the word has a letter that is no generator.
    ///
    /// # Complexity
    /// Linear in the word, as long as few rounds are needed to shorten the closed walk; each costs its length.
    ///
    /// # References
    /// F. Lazarus, J. Rivaud, *On the homotopy test on surfaces* (2012), section 4; J. Erickson, K. Whittlesey,
    /// *Transforming curves on surfaces redux* (2013), section 4.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let genus_2 = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2, 3, 4, -3, -4]))?;
    /// let (a, b) = (Word::from_letters([1, 2, -1, -2]), Word::from_letters([-4, -3, 4, 3]));
    /// assert_eq!(genus_2.conjugacy_form(&a), genus_2.conjugacy_form(&b));
    /// # Ok(()) }
    /// ```
    pub fn conjugacy_form(&self, word: &Word) -> ConjugacyForm {
        self.class_of(self.normal_form(word))
    }

    /// The conjugacy class of an element; see [`Self::conjugacy_form`].
    ///
    /// # Panics
    /// If the element is of another kind of group.
    ///
    /// # Complexity
    /// As for a word as long as the element.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// let free = SurfaceGroup::free(2);
    /// let class = |letters: [i32; 3]| free.class_of(free.normal_form(&Word::from_letters(letters)));
    /// assert_eq!(class([1, 2, -1]), free.conjugacy_form(&Word::from_letters([2])));
    /// ```
    pub fn class_of(&self, element: NormalForm) -> ConjugacyForm {
        ConjugacyForm(match (&self.kind, element.0) {
            (_, Form::Letters(letters)) => {
                let word = Word::from_letters(letters).cyclically_reduced();
                Class::Letters(least_rotation(word.letters().to_vec()).into())
            }
            (Kind::KleinBottle(_), Form::Exponents(exponents)) => {
                Class::Exponents(klein_bottle::least_conjugate(exponents))
            }
            (_, Form::Exponents(exponents)) => Class::Exponents(exponents),
            (Kind::Hyperbolic(_, quads), Form::Walk(edges)) => {
                let sign = edges.iter().fold(Sign::Plus, |sign, &edge| sign.times(quads.sign(edge)));
                let is_one_sided = sign == Sign::Minus;
                let edges = if is_one_sided { [edges.clone(), edges].concat() } else { edges.into_vec() };
                let closed = |orientation| closed_chords(quads, edges.clone(), orientation);
                let rightmost = closed(Sign::Plus);
                let chords =
                    if self.is_orientable() { rightmost } else { rightmost.min(closed(Sign::Minus)) };
                Class::Walk { is_one_sided, chords: chords.into() }
            }
            (_, Form::Walk(_)) => unreachable!("normal forms belong to one kind of group"),
        })
    }

    /// Whether two words are conjugate: closed curves that are freely homotopic, with their directions.
    ///
    /// # Panics
    /// If a word has a letter that is no generator.
    ///
    /// # Complexity
    /// That of [`Self::conjugacy_form`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// let free = SurfaceGroup::free(2);
    /// let (ab, ba) = (Word::from_letters([1, 2]), Word::from_letters([2, 1]));
    /// assert!(free.are_conjugate(&ab, &ba) && !free.are_equal(&ab, &ba));
    /// ```
    pub fn are_conjugate(&self, a: &Word, b: &Word) -> bool {
        self.conjugacy_form(a) == self.conjugacy_form(b)
    }
}

/// A closed walk that starts at a hub with an orientation relative to the hub's own, and comes back with the same.
struct ClosedWalk<'a> {
    quads: &'a QuadSystem,
    hub: Hub,
    orientation: Sign,
    edges: Vec<u32>,
}

/// What is to be done to a closed walk whose inner turns are those of a rightmost shortest walk.
enum Step {
    Done,
    /// Start at this vertex of the walk.
    Restart(usize),
    /// Start at this vertex, then move the start along the edge at this turn from the edge that arrives.
    Slide(usize, u32),
}

/// The pairs of edges of the rightmost shortest closed walk, from the least rotation's start.
fn closed_chords(quads: &QuadSystem, edges: Vec<u32>, orientation: Sign) -> Vec<[u32; 2]> {
    let mut walk = ClosedWalk { quads, hub: Hub::Vertex, orientation, edges };
    loop {
        walk.straighten();
        match walk.next_step() {
            Step::Done => break,
            Step::Restart(vertex) => walk.restart(vertex),
            Step::Slide(vertex, turn) => walk.slide(vertex, turn),
        }
    }
    if walk.hub == Hub::Center {
        walk.restart(1);
    }
    least_rotation(walk.edges.chunks_exact(2).map(|chord| [chord[0], chord[1]]).collect())
}

impl ClosedWalk<'_> {
    /// Makes the walk from start to start rightmost and shortest, and takes away what it runs to and fro at its ends.
    fn straighten(&mut self) {
        let mut walk = Walk::new(self.quads, self.hub, self.orientation);
        for &edge in &self.edges {
            walk.push(edge);
        }
        let edges = walk.edges();
        let spur =
            edges.iter().zip(edges.iter().rev()).take(edges.len() / 2).take_while(|(a, b)| a == b).count();
        for &edge in &edges[..spur] {
            self.orientation = self.orientation.times(self.quads.sign(edge));
            self.hub = self.hub.other();
        }
        self.edges = edges[spur..edges.len() - spur].to_vec();
    }

    /// The turn at each vertex, before the edge of the same number.
    fn turns(&self) -> Vec<u32> {
        let (mut hub, mut orientation) = (self.hub, self.orientation);
        let last = self.edges.last().copied().unwrap_or_default();
        let mut before = last;
        let turns = self.edges.iter().map(|&edge| {
            let turn = self.quads.turn(hub, orientation, before, edge);
            (hub, orientation) = (hub.other(), orientation.times(self.quads.sign(edge)));
            before = edge;
            turn
        });
        turns.collect()
    }

    /// The turn at the start is the only one that the walk without closing does not see.
    fn next_step(&self) -> Step {
        let turns = self.turns();
        let length = turns.len();
        let (minus_one, minus_two) = (self.quads.degree() - 1, self.quads.degree() - 2);
        if turns.iter().skip(1).all(|&turn| turn == 2) {
            match turns.first() {
                // A bracket whose two ends are one vertex.
                Some(1) => return Step::Slide(1 % length, 1),
                // The walk along the other side of the quadrangles lies to the right.
                Some(2) => return Step::Slide(0, 1),
                _ => {}
            }
        }
        if turns.first() == Some(&1) {
            return Step::Restart(length / 2);
        }
        let others: Vec<usize> = (0..length).filter(|&vertex| turns[vertex] != minus_two).collect();
        if let &[vertex] = others.as_slice() {
            return if turns[vertex] == minus_one {
                Step::Slide((vertex + 1) % length, minus_one)
            } else {
                Step::Done
            };
        }
        for (i, &first) in others.iter().enumerate() {
            let second = others[(i + 1) % others.len()];
            if turns[first] == minus_one && turns[second] == minus_one {
                // Start outside of the bracket; if it is the whole walk, the two ends are a bracket without middle.
                let start = (second + 1) % length;
                return Step::Restart(if start == first { (first + 1) % length } else { start });
            }
        }
        Step::Done
    }

    fn restart(&mut self, vertex: usize) {
        for &edge in &self.edges[..vertex] {
            self.orientation = self.orientation.times(self.quads.sign(edge));
            self.hub = self.hub.other();
        }
        self.edges.rotate_left(vertex);
    }

    fn slide(&mut self, vertex: usize, turn: u32) {
        self.restart(vertex);
        let arriving = *self.edges.last().expect("a walk without edges is done");
        let edge = self.quads.turned(self.hub, self.orientation, arriving, turn);
        self.orientation = self.orientation.times(self.quads.sign(edge));
        self.hub = self.hub.other();
        self.edges.insert(0, edge);
        self.edges.push(edge);
    }
}
