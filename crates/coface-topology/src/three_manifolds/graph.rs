//! Graph manifolds: fibered pieces that are glued along tori on which the fibers do not agree, and bundles of tori.

use super::SeifertSpace;
use coface_algebra::{SparseMatrix, invariant_factors};
use std::fmt;

/// A matrix by its rows.
pub(super) type Matrix = [[i64; 2]; 2];

/// A Seifert fibered space with boundary: its base, the number of tori in its boundary, and the invariants of its exceptional fibers.
///
/// On each boundary torus h is a fiber and o the boundary of the section: the sum of all o and of the q of all fibers is 0, and
/// $\alpha\, q + \beta\, h = 0$ for each fiber.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Piece {
    pub(super) is_orientable: bool,
    pub(super) genus: usize,
    pub(super) boundary_count: usize,
    pub(super) fibers: Vec<(i64, i64)>,
}

impl Piece {
    /// With 0 < β < α for all fibers, none with α = 1, and what was taken off: o was o + times h.
    fn normal(mut self) -> (Self, i64) {
        let mut times = 0;
        for fiber in &mut self.fibers {
            times += fiber.1.div_euclid(fiber.0);
            fiber.1 = fiber.1.rem_euclid(fiber.0);
        }
        self.fibers.retain(|fiber| fiber.0 > 1);
        self.fibers.sort_unstable();
        (self, times)
    }

    fn mirrored(mut self) -> Self {
        for fiber in &mut self.fibers {
            fiber.1 = -fiber.1;
        }
        self
    }

    /// Over a Moebius band without exceptional fibers: over a disk with two fibers 2 as well, with fiber and section exchanged.
    fn is_twisted_interval_bundle(&self) -> bool {
        !self.is_orientable && self.genus == 1 && self.boundary_count == 1 && self.fibers.is_empty()
    }

    /// The same with fibers (2, 1) and (2, 1) over a disk: the fiber over a Moebius band is o - h, and its o is -h.
    fn is_over_moebius_band(&self) -> bool {
        self.is_orientable && self.genus == 0 && self.boundary_count == 1 && self.fibers == [(2, 1), (2, 1)]
    }

    /// A solid torus, or a torus times an interval.
    fn is_filling(&self) -> bool {
        self.is_orientable && self.genus == 0 && self.fibers.len() + self.boundary_count <= 2
    }
}

impl fmt::Display for Piece {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let base = match (self.is_orientable, self.genus, self.boundary_count) {
            (true, 0, 1) => "D".to_owned(),
            (true, 0, 2) => "A".to_owned(),
            (false, 1, 1) => "M/n2".to_owned(),
            (true, genus, count) => format!("Or, g={genus} + {}", punctures(count)),
            (false, genus, count) => format!("Non-or, g={genus} + {}/n2", punctures(count)),
        };
        write!(f, "SFS [{base}:")?;
        for (alpha, beta) in &self.fibers {
            write!(f, " ({alpha},{beta})")?;
        }
        f.write_str("]")
    }
}

/// A key by which small entries come first, and of these positive ones.
fn size_and_signs(matrix: Matrix) -> (i64, Matrix) {
    let size = matrix.as_flattened().iter().map(|entry| entry.abs()).sum();
    (size, matrix.map(|row| row.map(|entry| -entry)))
}

fn punctures(count: usize) -> String {
    if count == 1 { "1 puncture".to_owned() } else { format!("{count} punctures") }
}

/// A closed orientable 3-manifold of one or two Seifert fibered pieces, glued along one torus on which the fibers do not agree; up to orientation.
///
/// The rows of the matrix are the fiber and the section's boundary at the second side of the torus, by those at the first side.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct GraphSpace {
    pieces: Vec<Piece>,
    matrix: Matrix,
}

impl GraphSpace {
    /// The fiber h' and the section's boundary o' at the second side of the torus by those at the first side, a row each: $h' = a\, h + b\, o$ and
    /// $o' = c\, h + d\, o$. The determinant is -1, and b is not 0.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// use coface_topology::{SpaceName, named_space};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = GluingTable::from_isomorphism_signature("hLALMkbcceffggemkbtibj", 3)?;
    /// let Some(space) = named_space(&table, &table.faces()?, 0)? else { return Ok(()) };
    /// let SpaceName::Graph(graph) = space.name() else { return Ok(()) };
    /// let [[a, b], [c, d]] = graph.matrix();
    /// assert_eq!((a * d - b * c, graph.piece_count()), (-1, 2));
    /// assert_eq!(graph.fibers(0), [(2, 1), (2, 1)]);
    /// # Ok(()) }
    /// ```
    pub fn matrix(&self) -> [[i64; 2]; 2] {
        self.matrix
    }

    /// The number of pieces: one that is glued to itself, or two.
    ///
    /// # Examples
    /// See [`Self::matrix`].
    pub fn piece_count(&self) -> usize {
        self.pieces.len()
    }

    /// The invariants $(\alpha, \beta)$ of the exceptional fibers of a piece, with 0 < β < α.
    ///
    /// # Panics
    /// If there is no such piece.
    ///
    /// # Examples
    /// See [`Self::matrix`].
    pub fn fibers(&self, piece: usize) -> &[(i64, i64)] {
        &self.pieces[piece].fibers
    }

    /// The space of one piece with two boundary tori, or of two with one each, in its least form. `None` if a piece is no piece of its own, or the fibers
    /// agree.
    pub(super) fn new(pieces: Vec<Piece>, matrix: Matrix) -> Option<Self> {
        let mut forms = Vec::new();
        let [[a, b], [c, d]] = matrix;
        let mirror = [[a, -b], [-c, d]];
        let mirrored: Vec<Piece> = pieces.iter().cloned().map(Piece::mirrored).collect();
        for (pieces, matrix) in [(pieces, matrix), (mirrored, mirror)] {
            let form = Self { pieces, matrix }.normal();
            if form.pieces.iter().any(Piece::is_filling) || form.matrix[0][1] == 0 {
                return None;
            }
            for form in [form.turned(), form] {
                let signs: &[i64] = if form.pieces.len() == 2 { &[1, -1] } else { &[1] };
                for sign in signs {
                    let matrix = form.matrix.map(|row| row.map(|entry| sign * entry));
                    forms.push(Self { pieces: form.pieces.clone(), matrix });
                }
            }
        }
        forms.into_iter().min_by_key(|form| (form.pieces.clone(), size_and_signs(form.matrix)))
    }

    /// Fibers between 0 and 1, with what is left in the matrix.
    fn normal(self) -> Self {
        let Self { pieces, mut matrix } = self;
        let count = pieces.len();
        let mut normal = Vec::with_capacity(count);
        for (at, piece) in pieces.into_iter().enumerate() {
            let (mut piece, mut times) = piece.normal();
            if count == 2 && piece.is_twisted_interval_bundle() {
                // Fibers (2, 1) and (2, -1) over a disk: its fiber is -o, and its o is h.
                matrix = match at {
                    0 => matrix.map(|[h, o]| [-o, h]),
                    _ => [[-matrix[1][0], -matrix[1][1]], matrix[0]],
                };
                let disk =
                    Piece { is_orientable: true, genus: 0, boundary_count: 1, fibers: vec![(2, 1), (2, -1)] };
                (piece, times) = disk.normal();
            }
            // Of one piece all goes to the first side.
            if at == 0 {
                matrix = matrix.map(|[h, o]| [h + times * o, o]);
            } else {
                matrix[1] = [matrix[1][0] - times * matrix[0][0], matrix[1][1] - times * matrix[0][1]];
            }
            normal.push(piece);
        }
        if count == 1 && matrix[0][1] != 0 {
            // The section may turn along the piece: o + k h at one side and o - k h at the other.
            let middle = -(matrix[0][0] + matrix[1][1]).div_euclid(2 * matrix[0][1]);
            let turned = |k: i64| {
                let [[a, b], [c, d]] = matrix.map(|[h, o]| [h + k * o, o]);
                [[a, b], [c + k * a, d + k * b]]
            };
            let least = (middle - 1..=middle + 1).map(turned).min_by_key(|matrix| size_and_signs(*matrix));
            matrix = least.unwrap_or(matrix);
        }
        Self { pieces: normal, matrix }
    }

    /// Seen from the other side of the torus: the inverse, whose determinant is -1.
    fn turned(&self) -> Self {
        let [[a, b], [c, d]] = self.matrix;
        Self { pieces: self.pieces.iter().rev().cloned().collect(), matrix: [[-d, b], [c, -a]] }
    }

    /// Two pieces whose fibers agree, those seen over a Moebius band without fibers of their own: what the sections miss is a fiber (1, b).
    fn seifert_space(&self, views: [bool; 2], matrix: Matrix) -> Option<SeifertSpace> {
        let mut fibers = vec![(1, -matrix[0][0] * matrix[1][0])];
        let (mut is_orientable, mut handles, mut cross_caps) = (true, 0, 0);
        for (piece, is_over_band) in self.pieces.iter().zip(views) {
            match (is_over_band, piece.is_orientable) {
                (true, _) => cross_caps += 1,
                (false, true) => handles += piece.genus,
                (false, false) => cross_caps += piece.genus,
            }
            is_orientable &= piece.is_orientable && !is_over_band;
            if !is_over_band {
                fibers.extend(&piece.fibers);
            }
        }
        let genus = if is_orientable { handles } else { cross_caps + 2 * handles };
        SeifertSpace::new(is_orientable, genus, &fibers)
    }

    /// The torsion and the rank of the first homology.
    pub(super) fn first_homology(&self) -> Option<(Vec<String>, usize)> {
        let mut group = Presentation::default();
        let sides: Vec<[usize; 2]> = self.pieces.iter().flat_map(|piece| group.add(piece)).collect();
        let &[[fiber, section], [other_fiber, other_section]] = &sides[..] else { return None };
        // One piece that is glued to itself: the walk through the torus is a generator of its own.
        group.generators += 2 - self.pieces.len();
        for (generator, [h, o]) in [other_fiber, other_section].into_iter().zip(self.matrix) {
            group.relate(&[(fiber, h), (section, o), (generator, -1)]);
        }
        group.group()
    }
}

impl fmt::Display for GraphSpace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [[a, b], [c, d]] = self.matrix;
        match &self.pieces[..] {
            [piece] => write!(f, "{piece} / [ {a},{b} | {c},{d} ]"),
            [one, two, ..] => write!(f, "{one} U/m {two}, m = [ {a},{b} | {c},{d} ]"),
            [] => Ok(()),
        }
    }
}

/// An abelian group by generators and relations.
#[derive(Default)]
struct Presentation {
    generators: usize,
    relations: usize,
    entries: Vec<(usize, usize, i64)>,
}

impl Presentation {
    fn generator(&mut self) -> usize {
        self.generators += 1;
        self.generators - 1
    }

    fn relate(&mut self, terms: &[(usize, i64)]) {
        self.entries.extend(
            terms
                .iter()
                .filter(|term| term.1 != 0)
                .map(|&(generator, times)| (generator, self.relations, times)),
        );
        self.relations += 1;
    }

    /// Adds the first homology of a piece: the fiber and the section's boundary on each torus.
    fn add(&mut self, piece: &Piece) -> Vec<[usize; 2]> {
        let fiber = self.generator();
        let mut section = Vec::new();
        for &(alpha, beta) in &piece.fibers {
            let around = self.generator();
            self.relate(&[(around, alpha), (fiber, beta)]);
            section.push((around, 1));
        }
        let sides: Vec<[usize; 2]> = (0..piece.boundary_count).map(|_| [fiber, self.generator()]).collect();
        section.extend(sides.iter().map(|side| (side[1], 1)));
        if piece.is_orientable {
            self.generators += 2 * piece.genus;
        } else {
            section.extend((0..piece.genus).map(|cross_cap| (self.generators + cross_cap, 2)));
            self.generators += piece.genus;
            self.relate(&[(fiber, 2)]);
        }
        self.relate(&section);
        sides
    }

    fn group(self) -> Option<(Vec<String>, usize)> {
        // The same place twice is one entry with the sum.
        let mut entries = self.entries;
        entries.sort_unstable();
        let mut sums: Vec<(usize, usize, i64)> = Vec::with_capacity(entries.len());
        for (row, column, value) in entries {
            match sums.last_mut() {
                Some(last) if (last.0, last.1) == (row, column) => last.2 += value,
                _ => sums.push((row, column, value)),
            }
        }
        sums.retain(|entry| entry.2 != 0);
        let matrix = SparseMatrix::from_entries(self.generators, self.relations, sums).ok()?;
        let factors = invariant_factors(&matrix);
        let rank = self.generators - factors.len();
        Some((factors.iter().map(ToString::to_string).filter(|factor| factor != "1").collect(), rank))
    }
}

/// The bundle of tori over the circle with a monodromy of trace above 2 or below -2, up to orientation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TorusBundle {
    monodromy: Matrix,
}

/// A bound on the steps of a reduction: each makes entries smaller.
const STEPS: usize = 10_000;

fn product(one: Matrix, two: Matrix) -> Matrix {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| one[row][0] * two[0][column] + one[row][1] * two[1][column])
    })
}

impl TorusBundle {
    /// The bundle with this monodromy: the least of its conjugates by matrices of determinant 1 or -1, and of those of its inverse, that have no entries
    /// of different signs. `None` for other traces and determinants than those that are meant.
    pub(super) fn new(monodromy: Matrix) -> Option<Self> {
        let [[a, b], [c, d]] = monodromy;
        if a * d - b * c != 1 || (a + d).abs() <= 2 {
            return None;
        }
        let sign = (a + d).signum();
        let word = word_of(monodromy.map(|row| row.map(|entry| sign * entry)))?;
        let reversed: Vec<bool> = word.iter().rev().copied().collect();
        let swapped = |word: &[bool]| -> Vec<bool> { word.iter().map(|letter| !letter).collect() };
        let all = [swapped(&word), swapped(&reversed), word, reversed];
        let least = all
            .iter()
            .flat_map(|word| (0..word.len()).map(|by| [&word[by..], &word[..by]].concat()))
            .min()?;
        let right = [[1, 1], [0, 1]];
        let left = [[1, 0], [1, 1]];
        let matrix = least
            .iter()
            .fold([[1, 0], [0, 1]], |matrix, &is_left| product(matrix, if is_left { left } else { right }));
        Some(Self { monodromy: matrix.map(|row| row.map(|entry| sign * entry)) })
    }

    /// What the walk around the circle makes of two loops of the torus, by rows.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// use coface_topology::{SpaceName, named_space};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = GluingTable::from_isomorphism_signature("hvLPQkcedfgfggnnkqqeiw", 3)?;
    /// let Some(space) = named_space(&table, &table.faces()?, 0)? else { return Ok(()) };
    /// let SpaceName::TorusBundle(bundle) = space.name() else { return Ok(()) };
    /// assert_eq!(bundle.monodromy(), [[2, 1], [1, 1]]);
    /// # Ok(()) }
    /// ```
    pub fn monodromy(&self) -> [[i64; 2]; 2] {
        self.monodromy
    }

    /// The torsion and the rank of the first homology.
    pub(super) fn first_homology(&self) -> Option<(Vec<String>, usize)> {
        let mut group = Presentation::default();
        let loops = [group.generator(), group.generator()];
        group.generator();
        for (own, row) in loops.into_iter().zip(self.monodromy) {
            group.relate(&[(loops[0], row[0]), (loops[1], row[1]), (own, -1)]);
        }
        group.group()
    }
}

/// The word in R = [1 1; 0 1] (false) and L = [1 0; 1 1] (true) of a matrix of trace above 2 that is conjugate to it.
fn word_of(matrix: Matrix) -> Option<Vec<bool>> {
    let size = |matrix: &Matrix| matrix.as_flattened().iter().map(|entry| entry.abs()).sum::<i64>();
    let conjugates = |matrix: Matrix| {
        [[[1, 1], [0, 1]], [[1, -1], [0, 1]], [[1, 0], [1, 1]], [[1, 0], [-1, 1]]].map(|by: Matrix| {
            let [[a, b], [c, d]] = by;
            product(product(by, matrix), [[d, -b], [-c, a]])
        })
    };
    let mut at = matrix;
    for _ in 0..STEPS {
        if at.as_flattened().iter().all(|&entry| entry >= 0) {
            let mut word = Vec::new();
            while at != [[1, 0], [0, 1]] {
                let [one, two] = at;
                let is_left = !(one[0] >= two[0] && one[1] >= two[1]);
                word.push(is_left);
                at = if is_left {
                    [one, [two[0] - one[0], two[1] - one[1]]]
                } else {
                    [[one[0] - two[0], one[1] - two[1]], two]
                };
                if word.len() > STEPS || at.as_flattened().iter().any(|&entry| entry < 0) {
                    return None;
                }
            }
            return Some(word);
        }
        let [[a, b], [c, d]] = at;
        // Entries off the diagonal of one sign: both are made positive by a reflection, which exchanges the two kinds of orientation.
        if a >= 0 && d >= 0 && b <= 0 && c <= 0 {
            at = [[a, -b], [-c, d]];
            continue;
        }
        at = conjugates(at).into_iter().min_by_key(size)?;
    }
    None
}

impl fmt::Display for TorusBundle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [[a, b], [c, d]] = self.monodromy;
        write!(f, "T x I / [ {a},{b} | {c},{d} ]")
    }
}

/// What a fibration shows.
pub(super) enum Fibered {
    /// One fibration of the whole.
    Seifert(SeifertSpace),
    /// Pieces with fibrations of their own.
    Graph(GraphSpace),
    /// A bundle of tori.
    Bundle(TorusBundle),
}

impl Fibered {
    /// Two pieces, with their second fibrations where they have some: one fibration of the whole, if fibers agree in some way, or a graph manifold.
    pub(super) fn of_two(pieces: Vec<Piece>, matrix: Matrix) -> Option<Self> {
        let form = GraphSpace { pieces, matrix }.normal();
        for views in [[false, false], [true, false], [false, true], [true, true]] {
            if form.pieces.iter().zip(views).any(|(piece, view)| view && !piece.is_over_moebius_band()) {
                continue;
            }
            let mut matrix = form.matrix;
            if views[0] {
                matrix = matrix.map(|[h, o]| [o, -h - o]);
            }
            if views[1] {
                let [[a, b], [c, d]] = matrix;
                matrix = [[c - a, d - b], [-a, -b]];
            }
            if matrix[0][1] == 0 {
                return form.seifert_space(views, matrix).map(Self::Seifert);
            }
        }
        GraphSpace::new(form.pieces, form.matrix).map(Self::Graph)
    }

    /// The torsion and the rank of the first homology.
    pub(super) fn first_homology(&self) -> Option<(Vec<String>, usize)> {
        match self {
            Self::Seifert(space) => space.first_homology(),
            Self::Graph(space) => space.first_homology(),
            Self::Bundle(space) => space.first_homology(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_manifolds::{SpaceName, named_space};
    use coface_complexes::gluing::GluingTable;

    fn name(signature: &str) -> SpaceName {
        let table = GluingTable::from_isomorphism_signature(signature, 3).unwrap();
        let space = named_space(&table, &table.faces().unwrap(), 100).unwrap();
        space.unwrap_or_else(|| panic!("{signature} has no name")).name().clone()
    }

    fn over_disk(fibers: &[(i64, i64)]) -> Piece {
        Piece { is_orientable: true, genus: 0, boundary_count: 1, fibers: fibers.to_vec() }
    }

    /// As Regina's census writes two pieces (B. A. Burton): with a matrix of determinant 1 the second one is meant with the other orientation.
    fn in_census(one: &[(i64, i64)], two: &[(i64, i64)], matrix: Matrix) -> SpaceName {
        let (one, two) = (over_disk(one), over_disk(two));
        let [[a, b], [c, d]] = matrix;
        let (two, matrix) =
            if a * d - b * c == 1 { (two.mirrored(), [[a, b], [-c, -d]]) } else { (two, matrix) };
        SpaceName::Graph(GraphSpace::new(vec![one, two], matrix).unwrap())
    }

    #[test]
    fn two_pieces_are_those_of_the_census() {
        let (two, three, four) = ((2, 1), (3, 1), (4, 1));
        for (signature, one, other, matrix) in [
            ("hLALMkbcceffggemkbtibj", [two, two], [two, two], [[0, -1], [1, 0]]),
            ("jLAMzLQbccdefhiiiemkexqsmmq", [two, two], [two, two], [[3, 2], [1, 1]]),
            ("jLLALPQacddfghihijkailkwlwn", [two, two], [two, three], [[1, 1], [-1, 0]]),
            ("kLLALPAkbdcdfghihjjdwwscujkkxj", [two, two], [two, four], [[1, 1], [-1, 0]]),
            ("jLALLAQbccefhgihiemkbiwsqkj", [two, two], [three, (3, 2)], [[0, -1], [1, 0]]),
            ("jLLAzAQaceeehghiinkuxntnxkr", [two, three], [two, (3, 2)], [[1, 1], [0, 1]]),
            ("lLLALwMQcccdehgihkjjklnnaqrasrrwn", [two, two], [two, three], [[-2, -1], [3, 1]]),
            ("lLLAwMPPcacddfhhjikjkjkaitnjqphsr", [two, two], [(3, 2), (5, 3)], [[1, 1], [0, -1]]),
            ("lLLAzMLQcbcedeghijkkktsqssjascmet", [two, three], [two, three], [[-3, 4], [-2, 3]]),
            ("lLALALAMcbcbeffihijkkhxjnmxpmndqj", [two, (5, 3)], [two, (7, 4)], [[0, 1], [1, 0]]),
        ] {
            assert_eq!(name(signature), in_census(&one, &other, matrix), "{signature}");
        }
        let text = name("hLALMkbcceffggemkbtibj").to_string();
        assert!(text.starts_with("SFS [D: (2,1) (2,1)] U/m SFS [D: (2,1) (2,1)], m = [ "), "{text}");
    }

    #[test]
    fn pieces_glued_to_themselves_are_those_of_the_census() {
        for (signature, fiber, matrix) in [
            ("kLLLLPQkcddfjijihjipkrkamipoad", (2, 1), [[0, -1], [-1, 3]]),
            ("kLvPLPQkafeghjhijijnqxohhhtpfc", (3, 2), [[0, -1], [-1, 1]]),
            ("lLvzAPAQcccfeijjhkikkqjhqaxmwhmgr", (5, 2), [[0, 1], [1, 0]]),
        ] {
            let piece = Piece { is_orientable: true, genus: 0, boundary_count: 2, fibers: vec![fiber] };
            let expected = GraphSpace::new(vec![piece], matrix).unwrap();
            assert_eq!(name(signature), SpaceName::Graph(expected), "{signature}");
        }
    }

    #[test]
    fn bundles_of_tori_are_those_of_the_census() {
        for (signature, expected) in [
            ("hvLPQkcedfgfggnnkqqeiw", [[2, 1], [1, 1]]),
            ("kLLLAPPkcdgfehijijjhsxaqpiqkjj", [[5, 4], [1, 1]]),
            ("lLLLPwPQccdgehfjkikjkhshqsslpacjc", [[10, 3], [3, 1]]),
        ] {
            assert_eq!(
                name(signature),
                SpaceName::TorusBundle(TorusBundle::new(expected).unwrap()),
                "{signature}"
            );
        }
        assert_eq!(name("hvLPQkcedfgfggnnkqqeiw").to_string(), "T x I / [ 2,1 | 1,1 ]");
    }

    /// The form does not depend on a basis of the torus, nor on the direction of the walk.
    #[test]
    fn conjugate_monodromies_have_one_form() {
        let bundle = |matrix: Matrix| TorusBundle::new(matrix).unwrap();
        for monodromy in [[[2, 1], [1, 1]], [[-7, -3], [-2, -1]], [[10, 3], [3, 1]], [[5, 2], [12, 5]]] {
            let expected = bundle(monodromy);
            let [[a, b], [c, d]] = monodromy;
            assert_eq!(bundle([[d, -b], [-c, a]]), expected, "inverse of {monodromy:?}");
            assert_eq!(bundle([[a, -b], [-c, d]]), expected, "mirror of {monodromy:?}");
            let mut at = monodromy;
            for by in [[[1, 3], [0, 1]], [[1, 0], [-2, 1]], [[0, -1], [1, 0]], [[1, -5], [0, 1]]] {
                let [[a, b], [c, d]] = by;
                at = product(product(by, at), [[d, -b], [-c, a]]);
                assert_eq!(bundle(at), expected, "{at:?} of {monodromy:?}");
            }
        }
        assert_ne!(bundle([[2, 1], [1, 1]]), bundle([[-2, -1], [-1, -1]]));
        assert_eq!(TorusBundle::new([[1, 5], [0, 1]]), None);
        assert_eq!(TorusBundle::new([[0, 1], [1, 0]]), None);
    }

    /// A solid torus is no piece, and neither are pieces whose fibers agree.
    #[test]
    fn what_is_no_graph_manifold_has_no_form() {
        let (one, two) = (over_disk(&[(2, 1), (3, 1)]), over_disk(&[(5, 1)]));
        assert_eq!(GraphSpace::new(vec![one.clone(), two], [[0, 1], [1, 0]]), None);
        assert_eq!(GraphSpace::new(vec![one.clone(), one.clone()], [[1, 0], [3, -1]]), None);
        // Fibers with sum 5/6 on both sides: the order is 6 * 6 * (1 - 25/36).
        let space = GraphSpace::new(vec![one.clone(), one], [[0, 1], [1, 0]]).unwrap();
        assert_eq!(space.first_homology(), Some((vec!["11".to_owned()], 0)));
    }
}
