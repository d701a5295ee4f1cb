//! The diagram of an image, from the part of all blocks.

use super::super::diagram::{ImageDiagram, ImagePair};
use super::super::forest::Forest;
use super::part::{ImagePart, Name, OUTSIDE_NAME, owner};
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Error, Field, Odd, SpreadMap};
use rayon::prelude::*;
use std::collections::BinaryHeap;

/// No cell: of a place that is free.
const NONE: u32 = u32::MAX;

/// A class of the grid: degree, the number of the critical cell that makes it and of the one that ends it, if any.
type Class = (usize, u32, Option<u32>);

impl ImagePart {
    /// The diagram of the image: that of [`ImageFiltration::persistence`](crate::ImageFiltration::persistence), bit for bit.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless this is the part of all blocks; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for
    /// parts that are not of one image.
    ///
    /// # Complexity
    /// Near-linear in the critical cells but for the degrees strictly between 0 and the last one, whose boundaries are reduced: cubic at worst.
    ///
    /// # Examples
    /// See [`ImageBlocks`](crate::ImageBlocks).
    pub fn diagram(&self) -> Result<ImageDiagram, Error> {
        if self.blocks != (0..self.cut.count()) {
            return Err(Error::invalid(format!(
                "a part of blocks {:?} of {} has no diagram of the image",
                self.blocks,
                self.cut.count()
            ))
            .with_cure("merge the parts of all blocks first"));
        }
        let classes = match self.cut.prime() {
            2 => Pairing::classes(&Binary, self),
            prime => Pairing::classes(&Odd::new(prime), self),
        }?;
        let (is_falling, shape) = (self.cut.is_falling(), self.cut.shape().to_vec());
        Ok(ImageDiagram { prime: self.cut.prime(), is_falling, shape, pairs: self.pairs(&classes) })
    }

    /// The classes as those of the image, off the diagonal.
    fn pairs(&self, classes: &[Class]) -> Vec<ImagePair> {
        let _steps = stage("sorting pairs", 0);
        let axes = self.axes();
        let is_dual = self.cut.is_dual();
        let mut pairs = Vec::new();
        for &(below, birth, death) in classes {
            let cell = |degree: usize, number: u32| {
                let cells = &self.critical[degree];
                (cells.keys[number as usize], owner(cells.names[number as usize]))
            };
            let (first, last) = (cell(below, birth), death.map(|death| cell(below + 1, death)));
            let (degree, birth, death) = match (is_dual, last) {
                (false, death) => (below, first, death),
                (true, None) => (axes - below, first, None),
                (true, Some(last)) => (axes - below - 1, last, Some(first)),
            };
            // Rising with the order in which cells enter.
            let moment = |(key, voxel): (u64, u64)| if is_dual { (!key, !voxel) } else { (key, voxel) };
            let pair = ImagePair {
                degree,
                birth: self.cut.value(birth.0),
                death: death.map(|death| self.cut.value(death.0)),
                birth_voxel: birth.1 as usize,
                death_voxel: death.map(|death| death.1 as usize),
            };
            if pair.death != Some(pair.birth) {
                pairs.push((degree, moment(birth), death.map(moment), pair));
            }
        }
        pairs.par_sort_by_key(|&(degree, birth, death, _)| (degree, birth, death));
        pairs.into_iter().map(|(.., pair)| pair).collect()
    }
}

/// The critical cells while they are paired.
struct Pairing<'a, F> {
    field: &'a F,
    part: &'a ImagePart,
    /// For each degree, for each critical cell, whether it has a partner.
    is_paired: Vec<Vec<bool>>,
    classes: Vec<Class>,
}

/// A fault of parts that are not of one image.
fn unknown() -> Error {
    Error::parse("a boundary has a cell that is not critical, so the parts are not of one image")
        .with_cure("make the parts again")
}

impl<'a, F: Field> Pairing<'a, F> {
    fn classes(field: &'a F, part: &'a ImagePart) -> Result<Vec<Class>, Error> {
        let axes = part.axes();
        let is_paired = part.critical.iter().map(|cells| vec![false; cells.len()]).collect();
        let mut pairing = Self { field, part, is_paired, classes: Vec::new() };
        pairing.join_vertices()?;
        if axes > 1 {
            pairing.join_top_cells()?;
        }
        for degree in (2..axes).rev() {
            pairing.reduce(degree)?;
        }
        for (degree, is_paired) in pairing.is_paired.iter().enumerate() {
            let left = (0..).zip(is_paired).filter(|&(_, &is_paired)| !is_paired);
            pairing.classes.extend(left.map(|(number, _)| (degree, number, None)));
        }
        Ok(pairing.classes)
    }

    fn pair(&mut self, degree: usize, birth: u32, death: u32) {
        self.is_paired[degree][birth as usize] = true;
        self.is_paired[degree + 1][death as usize] = true;
        self.classes.push((degree, birth, Some(death)));
    }

    /// The numbers of the critical cells of a degree, from this one on, by their names.
    fn numbers(&self, degree: usize, first: u32) -> SpreadMap<Name, u32> {
        self.part.critical[degree].names.iter().copied().zip(first..).collect()
    }

    /// Pairs vertices with edges: an edge that joins two trees ends the younger one. What lies outside is older than all: it is member 0.
    fn join_vertices(&mut self) -> Result<(), Error> {
        let mut members = self.numbers(0, 1);
        members.insert(OUTSIDE_NAME, 0);
        let mut forest = Forest::new((0..members.len() as u32).collect());
        let edges = &self.part.edges;
        let steps = stage("joining components", edges.len());
        for (number, ends) in steps.each((0..).zip(edges)) {
            let [a, b] = ends.map(|end| members.get(&end).copied());
            let (a, b) = (forest.root(a.ok_or_else(unknown)?), forest.root(b.ok_or_else(unknown)?));
            if a != b {
                let (old, young) = (a.min(b), a.max(b));
                forest.hang(young, old);
                self.pair(0, young - 1, number);
            }
        }
        Ok(())
    }

    /// Pairs top cells with their facets, from the last one to enter on: a facet that joins two trees makes the class that the younger one, which enters
    /// first, ends. What lies outside is older than all: it is the last member.
    fn join_top_cells(&mut self) -> Result<(), Error> {
        let degree = self.part.axes();
        let mut members = self.numbers(degree, 0);
        let outside = members.len() as u32;
        members.insert(OUTSIDE_NAME, outside);
        let mut forest = Forest::new((0..=outside).collect());
        let facets = &self.part.facets;
        let steps = stage("joining cavities", facets.len());
        for (number, ends) in steps.each((0..facets.len() as u32).zip(facets).rev()) {
            let [a, b] = ends.map(|end| members.get(&end).copied());
            let (a, b) = (forest.root(a.ok_or_else(unknown)?), forest.root(b.ok_or_else(unknown)?));
            if a != b {
                let (young, old) = (a.min(b), a.max(b));
                forest.hang(young, old);
                self.pair(degree - 1, number, young);
            }
        }
        Ok(())
    }

    /// Pairs the cells of this degree with those of the degree below, by reducing the boundaries of those that are free.
    fn reduce(&mut self, degree: usize) -> Result<(), Error> {
        let numbers = self.numbers(degree - 1, 0);
        let boundaries = &self.part.boundaries[degree - 2];
        let field = self.field;
        let mut killer = vec![NONE; numbers.len()];
        // Sparse columns in one array; the cell that leads a column is its first.
        let (mut starts, mut terms) = (vec![0], Vec::new());
        let mut heap: BinaryHeap<(u32, F::Unit)> = BinaryHeap::new();
        let mut found = Vec::new();
        let is_free = |number: &u32| !self.is_paired[degree][*number as usize];
        let columns: Vec<u32> = (0..boundaries.len() as u32).filter(is_free).collect();
        let steps = stage("pairing critical cells", columns.len());
        for column in steps.each(columns) {
            heap.clear();
            for (name, unit) in boundaries.terms(column as usize) {
                let number = *numbers.get(&name).ok_or_else(unknown)?;
                // A cell that has ended a class leads no column.
                if !self.is_paired[degree - 1][number as usize] {
                    heap.extend(field.unit(unit.cast_signed()).map(|unit| (number, unit)));
                }
            }
            while let Some((pivot, unit)) = taken(field, &mut heap) {
                // One column may take long.
                steps.advance(0);
                let other = killer[pivot as usize];
                if other == NONE {
                    killer[pivot as usize] = (starts.len() - 1) as u32;
                    terms.push((pivot, unit));
                    while let Some(term) = taken(field, &mut heap) {
                        terms.push(term);
                    }
                    starts.push(terms.len());
                    found.push((pivot, column));
                    break;
                }
                let other = &terms[starts[other as usize]..starts[other as usize + 1]];
                let factor = field.eliminator(unit, other[0].1);
                heap.extend(other[1..].iter().map(|&(cell, x)| (cell, field.product(factor, x))));
            }
        }
        for (birth, death) in found {
            self.pair(degree - 1, birth, death);
        }
        Ok(())
    }
}

/// Takes the last cell out of a sum, with its coefficient.
fn taken<F: Field>(field: &F, heap: &mut BinaryHeap<(u32, F::Unit)>) -> Option<(u32, F::Unit)> {
    while let Some((cell, unit)) = heap.pop() {
        let mut total = Some(unit);
        while let Some(&(other, x)) = heap.peek()
            && other == cell
        {
            heap.pop();
            total = match total {
                Some(sum) => field.sum(sum, x),
                None => Some(x),
            };
        }
        if let Some(unit) = total {
            return Some((cell, unit));
        }
    }
    None
}
