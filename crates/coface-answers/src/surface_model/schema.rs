//! Polygons whose sides are glued by letters.

use super::SurfaceModel;
use crate::answer::SchemaAnswer;
use coface_algebra::{Error, ErrorKind, UnionFind};
use coface_complexes::surface::SurfaceType;
use std::fmt;
use std::str::FromStr;

/// A word has at most so many sides.
const MOST_SIDES: usize = 1000;

/// A polygon with a letter at each side: sides of one letter are glued, so that the directions in which their letters run agree. Sides are counted
/// counterclockwise, and side i runs from corner i to the next.
///
/// As a text it is a word such as `a b a^-1 b^-1`: a letter, digits as its index (`a1`, `a_1`, `a_{12}`), and an exponent (`^-1`, `^{-1}`, `'`,
/// `^2` for two sides). A capital is the inverse of its small letter. Blanks are not needed: `abAB`.
///
/// # Examples
/// ```
/// use coface_answers::PolygonSchema;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus: PolygonSchema = "a b a^-1 b^-1".parse()?;
/// assert_eq!(torus.surface().map(|surface| surface.to_string()).as_deref(), Some("torus"));
/// assert_eq!(torus.corner_classes(), [0, 0, 0, 0]);
/// let sphere: PolygonSchema = "aA".parse()?;
/// assert_eq!((sphere.to_string().as_str(), sphere.corner_classes()), ("a a^-1", vec![0, 1]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PolygonSchema {
    names: Vec<String>,
    sides: Vec<i32>,
}

impl PolygonSchema {
    /// The canonical polygon of a surface: `a1 b1 a1^-1 b1^-1 ..` of handles, `c1 c1 c2 c2 ..` of cross-caps, `e1 d1 e1^-1 ..` of boundary loops,
    /// `s1 s1^-1` of a sphere, `d1` of a disk, as coface cut --canonical has them.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PolygonSchema;
    /// use coface_complexes::surface::SurfaceType;
    /// let klein = PolygonSchema::canonical(SurfaceType::non_orientable(2, 0));
    /// assert_eq!(klein.to_string(), "c1 c1 c2 c2");
    /// let pierced = PolygonSchema::canonical(SurfaceType::orientable(1, 1));
    /// assert_eq!(pierced.to_string(), "a1 b1 a1^-1 b1^-1 e1 d1 e1^-1");
    /// ```
    pub fn canonical(surface: SurfaceType) -> Self {
        let mut schema = Self { names: Vec::new(), sides: Vec::new() };
        let boundaries = surface.boundary_count();
        for i in 1..=surface.genus() {
            if surface.is_orientable() {
                let [a, b] = ['a', 'b'].map(|letter| schema.named(format!("{letter}{i}")));
                schema.sides.extend([a, b, -a, -b]);
            } else {
                let c = schema.named(format!("c{i}"));
                schema.sides.extend([c, c]);
            }
        }
        if schema.sides.is_empty() && boundaries < 2 {
            if boundaries == 0 {
                let slit = schema.named("s1".to_owned());
                schema.sides.extend([slit, -slit]);
            } else {
                let rim = schema.named("d1".to_owned());
                schema.sides.push(rim);
            }
            return schema;
        }
        for i in 1..=boundaries {
            let [path, rim] = ['e', 'd'].map(|letter| schema.named(format!("{letter}{i}")));
            schema.sides.extend([path, rim, -path]);
        }
        schema
    }

    /// The number of a letter, counted from 1.
    fn named(&mut self, name: String) -> i32 {
        let place = self.names.iter().position(|known| *known == name).unwrap_or_else(|| {
            self.names.push(name);
            self.names.len() - 1
        });
        place as i32 + 1
    }

    /// The letters, in the order in which they are met.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let schema: coface_answers::PolygonSchema = "x_1 y X1 y".parse()?;
    /// assert_eq!(schema.names(), ["x1", "y"]);
    /// # Ok(()) }
    /// ```
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The sides: i for letter i, counted from 1, -i where it runs backwards.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let schema: coface_answers::PolygonSchema = "a b^2 a'".parse()?;
    /// assert_eq!(schema.sides(), [1, 2, 2, -1]);
    /// # Ok(()) }
    /// ```
    pub fn sides(&self) -> &[i32] {
        &self.sides
    }

    /// For each corner the number of its class: corners of one class are glued to one point. Classes are counted as they are met.
    ///
    /// # Complexity
    /// Near linear in the sides.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane as a square.
    /// let schema: coface_answers::PolygonSchema = "a b a b".parse()?;
    /// assert_eq!(schema.corner_classes(), [0, 1, 0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn corner_classes(&self) -> Vec<usize> {
        let count = self.sides.len();
        let mut classes = UnionFind::new(count);
        let mut firsts: Vec<Option<[u32; 2]>> = vec![None; self.names.len()];
        for (place, &side) in self.sides.iter().enumerate() {
            let ends = [place as u32, ((place + 1) % count) as u32];
            let ends = if side > 0 { ends } else { [ends[1], ends[0]] };
            match &mut firsts[side.unsigned_abs() as usize - 1] {
                Some([source, target]) => {
                    classes.unite(*source, ends[0]);
                    classes.unite(*target, ends[1]);
                }
                first => *first = Some(ends),
            }
        }
        let numbers = classes.class_numbers();
        let mut met: Vec<u32> = Vec::new();
        let class = |&number: &u32| {
            met.iter().position(|&known| known == number).unwrap_or_else(|| {
                met.push(number);
                met.len() - 1
            })
        };
        numbers.iter().map(class).collect()
    }

    /// The surface that the glued polygon is; none if a letter is at three sides or more.
    ///
    /// # Complexity
    /// Near linear in the sides.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let band: coface_answers::PolygonSchema = "a b a c".parse()?;
    /// assert_eq!(band.surface().map(|surface| surface.to_string()).as_deref(), Some("Moebius band"));
    /// let dunce_hat: coface_answers::PolygonSchema = "a a a^-1".parse()?;
    /// assert_eq!(dunce_hat.surface(), None);
    /// # Ok(()) }
    /// ```
    pub fn surface(&self) -> Option<SurfaceType> {
        let mut uses = vec![[0usize; 2]; self.names.len()];
        self.sides
            .iter()
            .for_each(|&side| uses[side.unsigned_abs() as usize - 1][usize::from(side < 0)] += 1);
        if uses.iter().any(|[along, against]| along + against > 2) {
            return None;
        }
        let is_orientable = uses.iter().all(|&[along, against]| along < 2 && against < 2);
        let classes = self.corner_classes();
        let class_count = classes.iter().max().map_or(0, |most| most + 1);
        // At a boundary point two boundary sides meet: boundary loops are the classes of points that they connect.
        let mut loops = UnionFind::new(class_count);
        let mut is_on_boundary = vec![false; class_count];
        let count = self.sides.len();
        for (place, &side) in self.sides.iter().enumerate() {
            let [along, against] = uses[side.unsigned_abs() as usize - 1];
            if along + against == 1 {
                let [a, b] = [classes[place], classes[(place + 1) % count]];
                loops.unite(a as u32, b as u32);
                (is_on_boundary[a], is_on_boundary[b]) = (true, true);
            }
        }
        let numbers = loops.class_numbers();
        let mut rims: Vec<u32> =
            (0..class_count).filter(|&class| is_on_boundary[class]).map(|class| numbers[class]).collect();
        rims.sort_unstable();
        rims.dedup();
        let characteristic = class_count as i64 - self.names.len() as i64 + 1;
        let handles = usize::try_from(2 - characteristic - rims.len() as i64).ok()?;
        Some(match is_orientable {
            true => SurfaceType::orientable(handles / 2, rims.len()),
            false => SurfaceType::non_orientable(handles, rims.len()),
        })
    }

    /// The answer as plain data.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let schema: coface_answers::PolygonSchema = "a a".parse()?;
    /// let answer = schema.answer();
    /// assert_eq!((answer.surface.as_deref(), answer.corner_classes), (Some("projective plane"), vec![0, 0]));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> SchemaAnswer {
        SchemaAnswer {
            word: self.to_string(),
            surface: self.surface().map(|surface| surface.to_string()),
            corner_classes: self.corner_classes(),
        }
    }
}

impl SurfaceModel {
    /// The canonical polygon of each component.
    ///
    /// # Complexity
    /// Linear in the sides of the faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = coface_io::read(&b"[[0,1,2],[0,3,1],[1,3,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let schemas = coface_answers::SurfaceModel::of(sphere)?.schemas();
    /// assert_eq!(schemas[0].to_string(), "s1 s1^-1");
    /// # Ok(()) }
    /// ```
    pub fn schemas(&self) -> Vec<PolygonSchema> {
        self.map().surfaces().into_iter().map(PolygonSchema::canonical).collect()
    }
}

impl fmt::Display for PolygonSchema {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, &side) in self.sides.iter().enumerate() {
            let blank = if place > 0 { " " } else { "" };
            let exponent = if side < 0 { "^-1" } else { "" };
            write!(f, "{blank}{}{exponent}", self.names[side.unsigned_abs() as usize - 1])?;
        }
        Ok(())
    }
}

impl FromStr for PolygonSchema {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let mut rest = Letters { text, place: 0 };
        let mut schema = Self { names: Vec::new(), sides: Vec::new() };
        while let Some((name, exponent)) = rest.next_letter()? {
            let letter = schema.named(name);
            let times = exponent.unsigned_abs() as usize;
            if schema.sides.len() + times > MOST_SIDES {
                let message = format!("a word of more than {MOST_SIDES} letters");
                return Err(Error::new(ErrorKind::TooLarge, message).with_cure("give a shorter one"));
            }
            schema.sides.extend(std::iter::repeat_n(letter * exponent.signum(), times));
        }
        if schema.sides.is_empty() {
            return Err(fault("a word without letters".to_owned()));
        }
        Ok(schema)
    }
}

fn fault(message: String) -> Error {
    Error::invalid(message).with_cure("write a word as \"a b a^-1 b^-1\", \"abAB\" or \"a1 b1 a1^-1 b1^-1\"")
}

/// What is left to read of a word.
struct Letters<'t> {
    text: &'t str,
    place: usize,
}

impl Letters<'_> {
    fn rest(&self) -> &str {
        &self.text[self.place..]
    }

    /// Goes past this if it is next.
    fn takes(&mut self, words: &str) -> bool {
        let is_next = self.rest().starts_with(words);
        self.place += if is_next { words.len() } else { 0 };
        is_next
    }

    /// The digits that are next.
    fn digits(&mut self) -> &str {
        let start = self.place;
        let length = self.rest().find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest().len());
        self.place += length;
        &self.text[start..start + length]
    }

    fn unexpected(&self) -> Error {
        let found = self.rest().chars().next().map_or("the end".to_owned(), |c| format!("{c:?}"));
        fault(format!("{found} at place {} of the word", self.text[..self.place].chars().count() + 1))
    }

    /// The next letter with its index, and its exponent; none at the end.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] with the place of what cannot be there.
    fn next_letter(&mut self) -> Result<Option<(String, i32)>, Error> {
        let blanks = self.rest().find(|c: char| !c.is_whitespace() && !matches!(c, ',' | '*' | '\u{b7}'));
        self.place += blanks.unwrap_or(self.rest().len());
        let Some(letter) = self.rest().chars().next() else { return Ok(None) };
        if !letter.is_ascii_alphabetic() {
            return Err(self.unexpected());
        }
        self.place += 1;
        let has_mark = self.takes("_");
        let has_brace = has_mark && self.takes("{");
        let index = self.digits().to_owned();
        if (has_mark && index.is_empty()) || (has_brace && !self.takes("}")) {
            return Err(self.unexpected());
        }
        let mut exponent = if letter.is_ascii_uppercase() { -1 } else { 1 };
        if self.takes("'") || self.takes("\u{2032}") || self.takes("\u{207b}\u{b9}") {
            exponent = -exponent;
        } else if self.takes("^") {
            let has_brace = self.takes("{");
            let is_negative = self.takes("-") || self.takes("\u{2212}");
            let number: Option<i32> = self.digits().parse().ok().filter(|&n| n > 0 && n <= MOST_SIDES as i32);
            let Some(number) = number else { return Err(self.unexpected()) };
            if has_brace && !self.takes("}") {
                return Err(self.unexpected());
            }
            exponent *= if is_negative { -number } else { number };
        }
        Ok(Some((format!("{}{index}", letter.to_ascii_lowercase()), exponent)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CutRequest, Report};
    use coface_algebra::RaggedArray;
    use coface_io::{Model, Structure};
    use proptest::prelude::*;

    fn schema(word: &str) -> PolygonSchema {
        word.parse().unwrap()
    }

    #[test]
    fn one_word_has_many_spellings() {
        let usual = schema("a b a^-1 b^-1");
        for word in
            ["abAB", "a b a' b'", "a b a^{-1} b^{-1}", "ab a\u{207b}\u{b9}, b\u{207b}\u{b9}", " a*b*A*B "]
        {
            assert_eq!(schema(word), usual, "{word}");
        }
        for word in ["a1 b2 a1^-1", "a_1b_2A_1", "a_{1} b_{2} a_{1}^{-1}"] {
            assert_eq!(schema(word).to_string(), "a1 b2 a1^-1", "{word}");
        }
        assert_eq!(schema("a^3 B^-2").sides(), [1, 1, 1, 2, 2]);
    }

    #[test]
    fn what_is_no_word_is_named_with_its_place() {
        for (word, message) in [
            ("", "a word without letters"),
            ("a b 3", "'3' at place 5"),
            ("a^", "the end at place 3"),
            ("a^0", "the end at place 4"),
            ("a_ b", "' ' at place 3"),
            ("a_{1 b", "' ' at place 5"),
            ("a^{-1 b", "' ' at place 6"),
            ("a\u{e9}", "'\u{e9}' at place 2"),
            ("a{1}", "'{' at place 2"),
        ] {
            let error = word.parse::<PolygonSchema>().unwrap_err();
            assert!(error.message().contains(message) && error.cure().is_some(), "{word}: {error}");
        }
        assert_eq!("a^999 b^2".parse::<PolygonSchema>().unwrap_err().kind(), ErrorKind::TooLarge);
    }

    #[test]
    fn known_words_are_known_surfaces() {
        for (word, name) in [
            ("a a^-1", "sphere"),
            ("a a", "projective plane"),
            ("a b a b^-1", "Klein bottle"),
            ("a b c a^-1 b^-1 c^-1", "torus"),
            ("a b c d a^-1 b^-1 c^-1 d^-1", "double torus"),
            ("a", "disk"),
            ("a b a^-1 c", "annulus"),
            ("a b a c", "Moebius band"),
            ("a a b b c c", "non-orientable surface with 3 crosscaps"),
        ] {
            assert_eq!(
                schema(word).surface().map(|surface| surface.to_string()).as_deref(),
                Some(name),
                "{word}"
            );
        }
    }

    #[test]
    fn canonical_words_are_those_of_cuts() {
        let model = |facets: &[[u32; 3]]| {
            let facets = RaggedArray::from_lists(facets.iter().map(|facet| facet.to_vec()));
            SurfaceModel::of(Model::from_structure(Structure::Facets(facets))).unwrap()
        };
        let torus: Vec<[u32; 3]> =
            (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).collect();
        let plane = [
            [0, 1, 2],
            [0, 1, 5],
            [0, 2, 4],
            [0, 3, 4],
            [0, 3, 5],
            [1, 2, 3],
            [1, 3, 4],
            [1, 4, 5],
            [2, 3, 5],
            [2, 4, 5],
        ];
        let sphere = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]];
        let two = [[0, 1, 2], [3, 4, 5]];
        let annulus = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];
        for facets in [&torus[..], &torus[1..], &plane, &plane[1..], &sphere, &sphere[1..], &two, &annulus] {
            let surface = model(facets);
            let cut = surface.cut_open(&CutRequest { canonical: true, ..CutRequest::default() }).unwrap();
            let words: Vec<String> =
                cut.components().iter().filter_map(|part| part.canonical.clone()).collect();
            let schemas: Vec<String> = surface.schemas().iter().map(ToString::to_string).collect();
            assert_eq!(schemas, words);
        }
    }

    /// The polygon as a mesh: each side is three edges, and a vertex in the middle is joined to all.
    fn glued(schema: &PolygonSchema) -> Model {
        let classes = schema.corner_classes();
        let first = classes.iter().max().map_or(0, |most| *most as u32 + 1);
        let inner = first + 2 * schema.names().len() as u32;
        let count = schema.sides().len();
        let mut rim = Vec::new();
        for (place, &side) in schema.sides().iter().enumerate() {
            let [a, b] = [0, 1].map(|i| first + 2 * (side.unsigned_abs() - 1) + i);
            rim.extend([classes[place] as u32, if side > 0 { a } else { b }, if side > 0 { b } else { a }]);
        }
        // A ring of vertices of its own between the rim and the middle, so that no two triangles are one.
        let ring = |i: usize| inner + 1 + (i % (3 * count)) as u32;
        let mut facets = Vec::new();
        for i in 0..3 * count {
            let [p, q] = [rim[i], rim[(i + 1) % rim.len()]];
            facets.extend([[p, q, ring(i)], [q, ring(i), ring(i + 1)], [ring(i), ring(i + 1), inner]]);
        }
        Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets)))
    }

    proptest! {
        #[test]
        fn the_surface_of_a_word_is_that_of_the_glued_polygon(
            letters in prop::collection::vec((0usize..6, any::<bool>()), 1..12),
        ) {
            let mut uses = [0; 6];
            let word: Vec<String> = letters
                .into_iter()
                .filter(|&(letter, _)| {
                    uses[letter] += 1;
                    uses[letter] <= 2
                })
                .map(|(letter, is_back)| {
                    let name = ["a", "b", "c", "d", "e", "f"][letter];
                    if is_back { name.to_uppercase() } else { name.to_owned() }
                })
                .collect();
            let schema = schema(&word.concat());
            let report = Report::of(glued(&schema)).unwrap();
            prop_assert_eq!(report.surface_type(), schema.surface(), "{}", schema);
        }
    }
}
