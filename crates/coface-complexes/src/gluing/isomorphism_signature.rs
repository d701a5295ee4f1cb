//! Isomorphism signatures: short texts that name gluing tables up to the naming of their simplices and vertices.
//!
//! The format is that of the program Regina. A character stands for a number: `a` to `z` for 0 to 25, `A` to `Z` for 26
//! to 51, `0` to `9` for 52 to 61, `+` for 62, `-` for 63; several characters for one number have its low digits to the
//! base 64 first. The signature of a connected table of n simplices is
//! * n; from 63 on, `-`, the number k of characters of a number of simplices, and n in k of them (below 63, k is 1);
//! * the **types** of facets, three to a character with the factors 1, 4 and 16: simplices in order and their facets in
//!   order, without those that an earlier gluing reached: 0 for boundary, 1 for a gluing to the next simplex not met
//!   yet (vertex k to vertex k), 2 for a gluing to a simplex met before;
//! * for each gluing of type 2 its simplex, in k characters;
//! * for each gluing of type 2 the number of its permutation among all in lexicographic order, in as many characters as
//!   the last of them needs (one up to dimension 3, two for dimension 4).
//!
//! Signatures of the **second generation**, which Regina writes from version 7.5 on, are read too. Behind n they are a row of bits, six to a
//! character and the lowest first, and so are their numbers:
//! * two bits that are set, which no type of a facet has, and a bit that says whether all permutations are odd;
//! * for each facet that is no gluing to a new simplex and was not reached by an earlier gluing, its simplex, or n for boundary, in as
//!   many bits as n takes;
//! * a bit for each facet that was not reached, the last facet first: 0 for a gluing to the next simplex not met yet, which exchanges
//!   vertices 0 and 1;
//! * for each gluing to a simplex met before the number of its permutation, in as many bits as the last of them takes, and one less if all are
//!   odd: half of the number then. Of each two permutations in lexicographic order the even one comes first.
//!
//! Each choice of a first simplex and of the order of its vertices gives such a text; the signature is the first of them
//! in the order of ASCII. That of a table in several parts has those of the parts, sorted, one after the other.

use crate::gluing::table::GluingTable;
use coface_algebra::UnionFind;
use coface_algebra::{Error, ErrorKind};
use std::cmp::Ordering;

const NONE: u32 = u32::MAX;

/// The highest dimension for which signatures are made: all orders of the vertices are tried.
const DIMENSION_LIMIT: usize = 8;

const DIGITS: &[u8; 64] = b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-";

/// Symmetries are used below so many starts.
const START_LIMIT: usize = 1 << 28;

/// From here on the number of simplices takes more than one character.
const MANY: usize = 63;

/// Boundary, gluing to a new simplex, gluing to a known one.
const BOUNDARY: u8 = 0;
const FRESH: u8 = 1;
const KNOWN: u8 = 2;

/// The number of permutations of so many things.
pub(super) fn factorial(count: usize) -> u64 {
    (1..=count as u64).product()
}

/// How many characters the number of a permutation takes.
fn permutation_width(vertex_count: usize) -> usize {
    let last = factorial(vertex_count) - 1;
    (64 - last.leading_zeros() as usize).div_ceil(6).max(1)
}

/// How many characters a number of simplices takes, up to this count.
fn number_width(count: usize) -> usize {
    if count < MANY { 1 } else { (usize::BITS - count.leading_zeros()).div_ceil(6) as usize }
}

fn push_number(text: &mut Vec<u8>, mut number: u64, width: usize) {
    for _ in 0..width {
        text.push(DIGITS[(number & 63) as usize]);
        number >>= 6;
    }
}

/// The place of a permutation among all of its length in lexicographic order.
fn rank(images: &[u8]) -> u64 {
    let count = images.len();
    let smaller_later = |i: usize| images[i + 1..].iter().filter(|&&later| later < images[i]).count() as u64;
    (0..count).map(|i| smaller_later(i) * factorial(count - 1 - i)).sum()
}

/// The permutation at a place among all of its length in lexicographic order.
pub(super) fn unrank(count: usize, mut place: u64) -> Vec<u32> {
    let mut left: Vec<u32> = (0..count as u32).collect();
    (0..count)
        .map(|i| {
            let step = factorial(count - 1 - i);
            let image = left.remove((place / step) as usize);
            place %= step;
            image
        })
        .collect()
}

fn check_dimension(dimension: usize) -> Result<(), Error> {
    if (2..=DIMENSION_LIMIT).contains(&dimension) {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::UnsupportedFormat,
        format!("isomorphism signatures are of dimension 2 to {DIMENSION_LIMIT}, not {dimension}"),
    )
    .with_cure("write the gluing table as JSON"))
}

impl GluingTable {
    /// The isomorphism signature: two tables have the same if and only if they are the same up to the naming of simplices
    /// and vertices. It is the one that Regina gives; a table without simplices has `a`.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] unless the dimension is 2 to 8.
    ///
    /// # Complexity
    /// $O(d^2 n)$ for each choice of a start that is followed to its end, among $(d + 1)!\, n$ for n simplices of dimension
    /// d. Most choices end early, and those that a symmetry of the table takes to an earlier one are left out.
    ///
    /// # References
    /// B. A. Burton, *The Pachner graph and the simplification of 3-sphere triangulations* (2011), section 3.2.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The complement of the figure-eight knot, of two ideal tetrahedra.
    /// let table = GluingTable::from_isomorphism_signature("cPcbbbiht", 3)?;
    /// assert_eq!(table.isomorphism_signature()?, "cPcbbbiht");
    /// # Ok(()) }
    /// ```
    pub fn isomorphism_signature(&self) -> Result<String, Error> {
        check_dimension(self.dimension())?;
        let parts = self.components().members();
        let orders: Vec<Vec<u8>> = (0..factorial(self.dimension() + 1))
            .map(|place| unrank(self.dimension() + 1, place).iter().map(|&image| image as u8).collect())
            .collect();
        let mut labeling = Labeling::new(self);
        let mut texts: Vec<Vec<u8>> = Vec::with_capacity(parts.len());
        for part in parts {
            let part: Vec<u32> = part.into_iter().map(|simplex| simplex.to_u32()).collect();
            texts.extend(labeling.least_text(&part, &orders));
        }
        texts.sort_unstable();
        if texts.is_empty() {
            return Ok("a".to_owned());
        }
        Ok(texts.concat().into_iter().map(char::from).collect())
    }

    /// The table that an isomorphism signature of this dimension describes; also one that is not the first of all texts
    /// for its table. The signature does not tell the dimension. Signatures of the second generation are read too; none are written.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`] naming the character, counted from 1, that has no meaning or no place;
    /// [`ErrorKind::UnsupportedFormat`] unless the dimension is 2 to 8; [`ErrorKind::TooLarge`] as [`Self::unglued`].
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The lens space L(5, 1).
    /// let lens = GluingTable::from_isomorphism_signature("cMcabbjxr", 3)?;
    /// assert_eq!((lens.simplex_count(), lens.is_closed()), (2, true));
    /// let error = GluingTable::from_isomorphism_signature("cMc*bbjxr", 3).unwrap_err();
    /// assert!(error.message().contains("character 4"));
    /// # Ok(()) }
    /// ```
    pub fn from_isomorphism_signature(signature: &str, dimension: usize) -> Result<Self, Error> {
        check_dimension(dimension)?;
        let mut text = Text::new(signature)?;
        let mut gluings = Vec::new();
        let mut total = 0;
        loop {
            total += text.component(dimension, total, &mut gluings)?;
            if text.at == text.digits.len() {
                break;
            }
        }
        let mut table = Self::unglued(dimension, total)?;
        for (place, simplex, facet, neighbor, images) in gluings {
            table.glue(simplex, facet, neighbor, &images).map_err(|error| {
                text.fault(place, &format!("means a gluing that cannot be: {}", error.message()))
            })?;
        }
        Ok(table)
    }
}

/// Names given to the simplices of one component, and to their vertices, from a start.
struct Labeling<'a> {
    table: &'a GluingTable,
    width: usize,
    /// The new number of each simplex, or [`NONE`]; only simplices of `met` have one.
    numbers: Vec<u32>,
    /// The simplices in their new order.
    met: Vec<u32>,
    /// For each simplex the new number of each vertex ...
    names: Vec<u8>,
    /// ... and the vertex of each new number.
    vertices: Vec<u8>,
    /// The simplices and permutations of the gluings to known simplices.
    targets: Vec<(u32, u64)>,
}

impl<'a> Labeling<'a> {
    fn new(table: &'a GluingTable) -> Self {
        let width = table.dimension() + 1;
        let (count, slots) = (table.simplex_count(), table.simplex_count() * width);
        Self {
            table,
            width,
            numbers: vec![NONE; count],
            met: Vec::new(),
            names: vec![0; slots],
            vertices: vec![0; slots],
            targets: Vec::new(),
        }
    }

    /// Gives a simplex the next number, and its vertices these names.
    fn meet(&mut self, simplex: usize, names: impl Iterator<Item = (usize, u8)>) {
        self.numbers[simplex] = self.met.len() as u32;
        self.met.push(simplex as u32);
        for (vertex, name) in names {
            self.names[simplex * self.width + vertex] = name;
            self.vertices[simplex * self.width + name as usize] = vertex as u8;
        }
    }

    /// The first text in the order of ASCII, from all starts in one component.
    fn least_text(&mut self, part: &[u32], orders: &[Vec<u8>]) -> Option<Vec<u8>> {
        let mut starts = Starts::new(part, orders);
        let mut best: Option<(Vec<u8>, Names)> = None;
        for (place, &simplex) in part.iter().enumerate() {
            for (rank, order) in orders.iter().enumerate() {
                if !starts.is_new(place * orders.len() + rank) {
                    continue;
                }
                let Some(text) = self.text(part.len(), simplex, order, best.as_ref().map(|best| &best.0[..]))
                else {
                    continue;
                };
                match &best {
                    Some((least, names)) if *least == text => {
                        starts.unite_along(names, &self.names_in_order());
                    }
                    _ => best = Some((text, self.names_in_order())),
                }
            }
        }
        best.map(|best| best.0)
    }

    /// The simplices in their new order with their vertices in the new order.
    fn names_in_order(&self) -> Names {
        let of = |&simplex: &u32| {
            let at = simplex as usize * self.width;
            self.vertices[at..at + self.width].iter().copied()
        };
        Names { simplices: self.met.clone(), vertices: self.met.iter().flat_map(of).collect() }
    }

    /// The text from this start, if it is the best one so far or before it.
    fn text(&mut self, count: usize, start: u32, order: &[u8], best: Option<&[u8]>) -> Option<Vec<u8>> {
        for simplex in self.met.drain(..) {
            self.numbers[simplex as usize] = NONE;
        }
        self.targets.clear();
        self.meet(start as usize, order.iter().enumerate().map(|(vertex, &name)| (vertex, name)));
        let simplex_width = number_width(count);
        let mut text = Vec::new();
        if count < MANY {
            push_number(&mut text, count as u64, 1);
        } else {
            push_number(&mut text, MANY as u64, 1);
            push_number(&mut text, simplex_width as u64, 1);
            push_number(&mut text, count as u64, simplex_width);
        }
        let mut order = if best.is_some() { Ordering::Equal } else { Ordering::Less };
        let (mut packed, mut filled) = (0_u8, 0);
        for new in 0..count {
            for facet in 0..self.width {
                let Some(kind) = self.facet(new, facet) else { continue };
                packed |= kind << (2 * filled);
                filled += 1;
                if filled == 3 {
                    text.push(DIGITS[packed as usize]);
                    (packed, filled) = (0, 0);
                    if let (Ordering::Equal, Some(best)) = (order, best) {
                        order = text[text.len() - 1].cmp(&best[text.len() - 1]);
                        if order == Ordering::Greater {
                            return None;
                        }
                    }
                }
            }
        }
        if filled > 0 {
            text.push(DIGITS[packed as usize]);
        }
        for &(simplex, _) in &self.targets {
            push_number(&mut text, u64::from(simplex), simplex_width);
        }
        let width = permutation_width(self.width);
        for &(_, permutation) in &self.targets {
            push_number(&mut text, permutation, width);
        }
        (order == Ordering::Less || best.is_none_or(|best| text.as_slice() <= best)).then_some(text)
    }

    /// The type of a facet by its new names, unless an earlier gluing reached it.
    fn facet(&mut self, new: usize, facet: usize) -> Option<u8> {
        let (table, width) = (self.table, self.width);
        let simplex = self.met[new] as usize;
        let vertex = self.vertices[simplex * width + facet] as usize;
        let Some((other, images)) = table.neighbor(simplex, vertex) else { return Some(BOUNDARY) };
        if self.numbers[other] == NONE {
            let names: Vec<(usize, u8)> =
                (0..width).map(|v| (images[v] as usize, self.names[simplex * width + v])).collect();
            self.meet(other, names.into_iter());
            return Some(FRESH);
        }
        let partner = self.names[other * width + images[vertex] as usize] as usize;
        if (self.numbers[other] as usize, partner) < (new, facet) {
            return None;
        }
        let permutation: Vec<u8> = (0..width)
            .map(|name| {
                let v = self.vertices[simplex * width + name] as usize;
                self.names[other * width + images[v] as usize]
            })
            .collect();
        self.targets.push((self.numbers[other], rank(&permutation)));
        Some(KNOWN)
    }
}

/// The simplices of a component in some order, each with its vertices in some order.
struct Names {
    simplices: Vec<u32>,
    vertices: Vec<u8>,
}

/// The choices of a first simplex and of the order of its vertices, up to the symmetries that were found.
///
/// Two starts with one text are taken to each other by a symmetry, which takes every start to one with the same text.
struct Starts<'a> {
    orders: &'a [Vec<u8>],
    /// The simplices of the component, rising.
    part: &'a [u32],
    classes: UnionFind,
    /// Whether a start of the class with this representative was tried.
    is_tried: Vec<bool>,
}

impl<'a> Starts<'a> {
    fn new(part: &'a [u32], orders: &'a [Vec<u8>]) -> Self {
        // Beyond the limit of union-find every start is tried.
        let count = part.len().saturating_mul(orders.len());
        let count = if count < START_LIMIT { count } else { 0 };
        Self { orders, part, classes: UnionFind::new(count), is_tried: vec![false; count] }
    }

    /// Whether no start of its class was tried; it is now.
    fn is_new(&mut self, start: usize) -> bool {
        if self.classes.is_empty() {
            return true;
        }
        let class = self.classes.find(start as u32) as usize;
        !std::mem::replace(&mut self.is_tried[class], true)
    }

    /// Unites each start with its image under the symmetry that takes one naming to the other.
    fn unite_along(&mut self, from: &Names, to: &Names) {
        if self.classes.is_empty() {
            return;
        }
        let width = self.orders.first().map_or(1, Vec::len);
        let place =
            |simplex: &u32| self.part.binary_search(simplex).expect("a component is walked within itself");
        let mut images = vec![0; width];
        let mut moved = vec![0; width];
        for (at, (source, target)) in from.simplices.iter().zip(&to.simplices).enumerate() {
            let names = at * width..(at + 1) * width;
            for (&v, &w) in from.vertices[names.clone()].iter().zip(&to.vertices[names]) {
                images[v as usize] = w;
            }
            let (source, target) = (place(source) * self.orders.len(), place(target) * self.orders.len());
            for (start, order) in self.orders.iter().enumerate() {
                for (&image, &name) in images.iter().zip(order) {
                    moved[image as usize] = name;
                }
                let (a, b) = ((source + start) as u32, (target + rank(&moved) as usize) as u32);
                let is_tried =
                    [a, b].map(|start| self.classes.find(start) as usize).iter().any(|&c| self.is_tried[c]);
                if self.classes.unite(a, b) {
                    let class = self.classes.find(a) as usize;
                    self.is_tried[class] = is_tried;
                }
            }
        }
    }
}

/// One gluing read: the place of the character that tells it, simplex, facet, neighbor, vertex map.
pub(super) type ReadGluing = (usize, usize, usize, usize, Vec<u32>);

/// A signature being read.
pub(super) struct Text<'a> {
    characters: Vec<char>,
    pub(super) digits: Vec<u8>,
    pub(super) at: usize,
    signature: &'a str,
}

impl<'a> Text<'a> {
    fn new(signature: &'a str) -> Result<Self, Error> {
        let characters: Vec<char> = signature.chars().collect();
        let mut text = Self { digits: Vec::with_capacity(characters.len()), characters, at: 0, signature };
        for place in 0..text.characters.len() {
            let digit = DIGITS.iter().position(|&digit| char::from(digit) == text.characters[place]);
            let Some(digit) = digit else {
                return Err(text.fault(place, "is none of a-z, A-Z, 0-9, + and -"));
            };
            text.digits.push(digit as u8);
        }
        Ok(text)
    }

    pub(super) fn fault(&self, place: usize, what: &str) -> Error {
        let message = match self.characters.get(place) {
            Some(character) => format!("character {} of the signature, {character:?}, {what}", place + 1),
            None => format!("the signature ends after {} characters: {what}", self.characters.len()),
        };
        let message =
            if self.signature.len() <= 60 { format!("{message} (in {:?})", self.signature) } else { message };
        Error::parse(message).with_cure("copy the whole signature, and check that it is of this dimension")
    }

    /// A number of so many characters.
    fn number(&mut self, width: usize, what: &str) -> Result<u64, Error> {
        let mut number = 0_u64;
        for i in 0..width {
            let Some(&digit) = self.digits.get(self.at) else {
                return Err(self.fault(self.at, &format!("{what} is missing")));
            };
            self.at += 1;
            if digit > 0 && (6 * i >= 64 || u64::from(digit) << (6 * i) >> (6 * i) != u64::from(digit)) {
                return Err(self.fault(self.at - 1, &format!("makes {what} too large")));
            }
            if digit > 0 {
                number |= u64::from(digit) << (6 * i);
            }
        }
        Ok(number)
    }

    /// Reads one connected component, whose simplices are numbered from `first`; gives their number.
    fn component(
        &mut self,
        dimension: usize,
        first: usize,
        gluings: &mut Vec<ReadGluing>,
    ) -> Result<usize, Error> {
        let begin = self.at;
        let (mut count, mut width) = (self.number(1, "the number of simplices")?, 1);
        if count == MANY as u64 {
            width = self.number(1, "the number of characters a number")? as usize;
            count = self.number(width, "the number of simplices")?;
        }
        let facets = dimension + 1;
        // Three facets at most stand in a character, and a gluing stands for two.
        let left = self.digits.len() - self.at;
        if count.saturating_mul(facets as u64) > 6 * left as u64 {
            return Err(self.fault(
                begin,
                &format!("begins a part of {count} simplices, but only {left} characters follow: too few"),
            ));
        }
        let count = count as usize;
        if count == 0 && (first > 0 || left > 0) {
            return Err(self.fault(begin, "begins a part without simplices"));
        }
        if self.digits.get(self.at).is_some_and(|digit| digit & 3 == 3) {
            self.packed_component(count, facets, first, gluings)?;
            return Ok(count);
        }
        let kinds = self.kinds(count, facets)?;
        let known = kinds.iter().filter(|&&(_, kind)| kind == KNOWN).count();
        let mut targets = Vec::with_capacity(known);
        for _ in 0..known {
            let place = self.at;
            let target = self.number(width, "the simplex of a gluing")?;
            if target >= count as u64 {
                return Err(self.fault(place, &format!("names simplex {target}, but there are {count}")));
            }
            targets.push(target as usize);
        }
        let (mut permutations, total) = (Vec::with_capacity(known), factorial(facets));
        for _ in 0..known {
            let place = self.at;
            let permutation = self.number(permutation_width(facets), "the permutation of a gluing")?;
            if permutation >= total {
                return Err(
                    self.fault(place, &format!("names permutation {permutation}, but there are {total}"))
                );
            }
            permutations.push((place, unrank(facets, permutation)));
        }
        self.assemble(count, facets, first, &kinds, targets.into_iter().zip(permutations), gluings)?;
        Ok(count)
    }

    /// The types of facets, each with the place of its character.
    fn kinds(&mut self, count: usize, facets: usize) -> Result<Vec<(usize, u8)>, Error> {
        let (mut kinds, mut reached) = (Vec::new(), 0);
        while reached < count * facets {
            let place = self.at;
            let packed = self.number(1, "the type of a facet")? as u8;
            if packed > 42 {
                return Err(self.fault(place, "stands for no three types of facets"));
            }
            for i in 0..3 {
                let kind = packed >> (2 * i) & 3;
                if kind > KNOWN || reached == count * facets && kind != BOUNDARY {
                    return Err(self.fault(place, "has types of facets that are not there"));
                }
                if reached < count * facets {
                    reached += if kind == BOUNDARY { 1 } else { 2 };
                    kinds.push((place, kind));
                }
            }
            if reached > count * facets {
                return Err(self.fault(place, "glues the last facet to none"));
            }
        }
        Ok(kinds)
    }

    /// The gluings that the types and targets mean.
    fn assemble(
        &self,
        count: usize,
        facets: usize,
        first: usize,
        kinds: &[(usize, u8)],
        mut targets: impl Iterator<Item = (usize, (usize, Vec<u32>))>,
        gluings: &mut Vec<ReadGluing>,
    ) -> Result<(), Error> {
        let mut is_glued = vec![false; count * facets];
        let (mut kinds, mut met) = (kinds.iter(), 1);
        for simplex in 0..count {
            for facet in 0..facets {
                if is_glued[simplex * facets + facet] {
                    continue;
                }
                let Some(&(place, kind)) = kinds.next() else {
                    return Err(self.fault(self.at, "a facet has no type"));
                };
                if simplex >= met {
                    return Err(
                        self.fault(place, &format!("is about simplex {simplex}, which no gluing reaches"))
                    );
                }
                let (place, other, images) = match kind {
                    BOUNDARY => continue,
                    FRESH if met == count => {
                        return Err(
                            self.fault(place, &format!("reaches for a new simplex beyond all {count}"))
                        );
                    }
                    FRESH => {
                        met += 1;
                        (place, met - 1, (0..facets as u32).collect())
                    }
                    _ => {
                        let (other, (place, images)) = targets.next().expect("each known simplex was read");
                        (place, other, images)
                    }
                };
                let partner = images[facet] as usize;
                is_glued[simplex * facets + facet] = true;
                is_glued[other * facets + partner] = true;
                gluings.push((place, first + simplex, facet, first + other, images));
            }
        }
        Ok(())
    }
}
