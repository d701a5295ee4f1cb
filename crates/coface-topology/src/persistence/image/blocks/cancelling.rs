//! Pairs of a part that no block outside can change are taken out of it.

use super::super::forest::Forest;
use super::part::{Cells, Chains, ImagePart, Name, OUTSIDE_NAME, Rules, owner};
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Error, Field, Odd, SpreadMap};
use std::collections::BinaryHeap;

/// No number.
const NONE: u32 = u32::MAX;

/// When a cell enters, by the voxel that owns it.
type Moment = (u64, u64);

/// A field whose elements are numbers.
pub(super) trait Numbered: Field<Unit: Send + Sync> + Sync {
    fn number(unit: Self::Unit) -> u32;
}

impl Numbered for Binary {
    fn number((): ()) -> u32 {
        1
    }
}

impl Numbered for Odd {
    fn number(unit: u32) -> u32 {
        unit
    }
}

/// A fault of parts that are not of one image.
pub(super) fn unknown() -> Error {
    Error::parse("a boundary has a cell that is not critical, so the parts are not of one image")
        .with_cure("make the parts again")
}

impl ImagePart {
    /// The part without the critical cells that are pairs whatever lies outside; the pairs are listed.
    ///
    /// A cell s and a cell t of the degree above are a pair if s is the last facet of t to enter, and t the first of the cells that s is a facet of. Such pairs are
    /// taken out one after the other, by a step of elimination each: what has s as a facet gets the other facets of t instead. A path that leaves the part comes back
    /// only to cells that have entered before the one at which it left. So what lies outside can change neither the last facet of t if all ends of
    /// t outside enter before s, nor the first coface of s if no rule that leads to s, and that blocks outside ask for, is of a cell that enters before t.
    pub(super) fn cancelled(self) -> Result<Self, Error> {
        let _steps = stage("cancelling pairs", 0);
        match self.cut.prime() {
            2 => Cancelling::new(&Binary, self)?.done(),
            prime => Cancelling::new(&Odd::new(prime), self)?.done(),
        }
    }
}

/// The cells that chains of one degree have, by number as they enter: critical ones of the part, and ends in other blocks.
struct Members {
    numbers: SpreadMap<Name, u32>,
    names: Vec<Name>,
    /// The place among the critical cells of the part; [`NONE`] for an end outside.
    places: Vec<u32>,
}

impl Members {
    /// The cells in a part and the ends in these lists of names. `outside` is the key of what lies outside of the image, which no voxel has.
    fn new(critical: &Cells, lists: &[&[Name]], layer: &[[u64; 2]], outside: u64) -> Result<Self, Error> {
        let mut numbers: SpreadMap<Name, u32> = critical.names.iter().map(|&name| (name, NONE)).collect();
        let mut cells: Vec<(u64, Name, u32)> = (0..)
            .zip(critical.keys.iter().zip(&critical.names))
            .map(|(place, (&key, &name))| (key, name, place))
            .collect();
        for &name in lists.iter().copied().flatten() {
            if numbers.insert(name, NONE).is_some() {
                continue;
            }
            let key = match name {
                OUTSIDE_NAME => outside,
                name => {
                    let place = layer.binary_search_by_key(&owner(name), |&[voxel, _]| voxel);
                    layer[place.map_err(|_| unknown())?][1]
                }
            };
            cells.push((key, name, NONE));
        }
        // The critical cells are sorted already.
        cells.sort();
        for (number, &(_, name, _)) in (0..).zip(&cells) {
            numbers.insert(name, number);
        }
        Ok(Self {
            numbers,
            names: cells.iter().map(|cell| cell.1).collect(),
            places: cells.iter().map(|cell| cell.2).collect(),
        })
    }

    fn len(&self) -> usize {
        self.names.len()
    }

    fn couples(&self, couples: &[[Name; 2]]) -> Vec<[u32; 2]> {
        couples.iter().map(|couple| couple.map(|name| self.numbers[&name])).collect()
    }
}

/// What happens next in the order of entrance: a cell of the part, or a rule that blocks outside ask for.
enum Event {
    Cell(usize),
    Rule(usize),
}

/// Cells and rules in the order of entrance; of one voxel the cells come first. Or all from the last one on.
fn events<'a>(cells: &'a Cells, rules: &'a Cells, is_falling: bool) -> impl Iterator<Item = Event> + 'a {
    let moment = |cells: &Cells, i: usize| -> Moment { (cells.keys[i], owner(cells.names[i])) };
    let (count, rule_count) = (cells.len(), rules.len());
    let at = move |taken: usize, count: usize| if is_falling { count - 1 - taken } else { taken };
    let (mut taken, mut rules_taken) = (0, 0);
    std::iter::from_fn(move || {
        let cell = (taken < count).then(|| at(taken, count));
        let rule = (rules_taken < rule_count).then(|| at(rules_taken, rule_count));
        let is_cell_first = match (cell, rule) {
            (Some(cell), Some(rule)) => {
                let (cell, rule) = (moment(cells, cell), moment(rules, rule));
                if is_falling { cell >= rule } else { cell <= rule }
            }
            (cell, _) => cell.is_some(),
        };
        if is_cell_first {
            taken += 1;
            cell.map(Event::Cell)
        } else {
            rules_taken += 1;
            rule.map(Event::Rule)
        }
    })
}

/// What becomes of a critical cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fate {
    Left,
    /// It makes the class of a pair.
    Birth,
    /// It ends the class of a pair.
    Death,
}

/// Chains that were worked on, over the members of their degree.
struct Reduced<U> {
    members: Members,
    /// Those of the critical cells that are left.
    cells: Vec<Vec<(u32, U)>>,
    rules: Vec<Vec<(u32, U)>>,
}

/// Ends that were worked on, over the members of their degree.
struct Contracted {
    members: Members,
    forest: Forest,
    couples: Vec<[u32; 2]>,
    rules: Vec<u32>,
}

struct Cancelling<'a, F: Field> {
    field: &'a F,
    part: ImagePart,
    /// For each degree what becomes of its critical cells.
    fates: Vec<Vec<Fate>>,
}

impl<'a, F: Numbered> Cancelling<'a, F> {
    fn new(field: &'a F, part: ImagePart) -> Result<Self, Error> {
        let fates = part.critical.iter().map(|cells| vec![Fate::Left; cells.len()]).collect();
        Ok(Self { field, part, fates })
    }

    /// The part without its pairs.
    fn done(mut self) -> Result<ImagePart, Error> {
        let axes = self.part.axes();
        let vertices = self.join(0, 1)?;
        let tops = (axes > 1).then(|| self.join(axes, axes - 1)).transpose()?;
        let mut reduced = Vec::new();
        for degree in (2..axes).rev() {
            reduced.push(self.reduce(degree)?);
        }
        reduced.reverse();
        Ok(self.without_pairs(vertices, tops, reduced))
    }

    fn pair(&mut self, degree: usize, birth: usize, death: usize) {
        self.fates[degree][birth] = Fate::Birth;
        self.fates[degree + 1][death] = Fate::Death;
        let cell = |degree: usize, place: usize| {
            let cells = &self.part.critical[degree];
            (cells.keys[place], owner(cells.names[place]))
        };
        let (birth, death) = (cell(degree, birth), cell(degree + 1, death));
        // Classes that die as they are born are in no diagram.
        if birth.0 != death.0 {
            self.part.pairs[degree].push([birth.0, birth.1, death.0, death.1]);
        }
    }

    /// Takes out vertices with edges that join two trees, or top cells with facets between two trees, from the last facet on. Of two trees that meet the one whose
    /// root is younger goes, if nothing outside can have met it before.
    fn join(&mut self, degree: usize, of_arcs: usize) -> Result<Contracted, Error> {
        let is_dual = degree > of_arcs;
        let part = &self.part;
        let (couples, rules) =
            if is_dual { (&part.facets, &part.top_rules) } else { (&part.edges, &part.rules[0]) };
        let names = rules.chains.all_names();
        // Older than all.
        let outside = if is_dual { u64::MAX } else { 0 };
        let lists = [couples.as_flattened(), names];
        let members = Members::new(&part.critical[degree], &lists, &part.layer, outside)?;
        let couples = members.couples(couples);
        // A rule leads to one end.
        let end = |i: usize| rules.chains.names(i).first().copied().unwrap_or(OUTSIDE_NAME);
        let of_rules =
            (0..rules.cells.len()).map(|i| members.numbers.get(&end(i)).copied().ok_or_else(unknown));
        let rule_ends = of_rules.collect::<Result<Vec<u32>, Error>>()?;
        let mut forest = Forest::new((0..members.len() as u32).collect());
        let mut is_held = vec![false; members.len()];
        let mut found = Vec::new();
        for event in events(&part.critical[of_arcs], &rules.cells, is_dual) {
            match event {
                Event::Cell(arc) if self.fates[of_arcs][arc] != Fate::Left => {}
                Event::Cell(arc) => {
                    let [a, b] = couples[arc].map(|end| forest.root(end));
                    if a == b {
                        continue;
                    }
                    let (old, young) = if (a < b) != is_dual { (a, b) } else { (b, a) };
                    if members.places[young as usize] != NONE && !is_held[young as usize] {
                        forest.hang(young, old);
                        found.push((members.places[young as usize] as usize, arc));
                    } else {
                        is_held[a as usize] = true;
                        is_held[b as usize] = true;
                    }
                }
                Event::Rule(rule) => is_held[forest.root(rule_ends[rule]) as usize] = true,
            }
        }
        for (cell, arc) in found {
            if is_dual {
                self.pair(of_arcs, arc, cell);
            } else {
                self.pair(degree, cell, arc);
            }
        }
        Ok(Contracted { members, forest, couples, rules: rule_ends })
    }

    /// Takes out cells of this degree with facets, by reducing boundaries from the first cell on.
    fn reduce(&mut self, degree: usize) -> Result<Reduced<F::Unit>, Error> {
        let (part, field) = (&self.part, self.field);
        let (columns, rules) = (&part.boundaries[degree - 2], &part.rules[degree - 1]);
        let lists = [columns.all_names(), rules.chains.all_names()];
        let members = Members::new(&part.critical[degree - 1], &lists, &part.layer, 0)?;
        let mut work = Columns {
            field,
            is_gone: members.places.iter().map(|&place| self.is_gone(degree - 1, place)).collect(),
            is_held: members.places.iter().map(|&place| place == NONE).collect(),
            killers: vec![NONE; members.len()],
            starts: vec![0],
            terms: Vec::new(),
            heap: BinaryHeap::new(),
        };
        let mut cells = vec![Vec::new(); columns.len()];
        let mut of_rules = vec![Vec::new(); rules.cells.len()];
        let mut found = Vec::new();
        let steps = stage("pairing critical cells", columns.len());
        for event in events(&part.critical[degree], &rules.cells, false) {
            match event {
                Event::Cell(cell) => {
                    steps.advance(1);
                    if self.fates[degree][cell] != Fate::Left {
                        continue;
                    }
                    work.fill(columns.terms(cell).map(|(name, unit)| (members.numbers[&name], unit)));
                    match work.lead() {
                        None => {}
                        Some((pivot, unit)) if work.is_held[pivot as usize] => {
                            cells[cell] = work.held(Some((pivot, unit)));
                        }
                        Some((pivot, unit)) => {
                            work.kill(pivot, unit);
                            found.push((members.places[pivot as usize] as usize, cell));
                        }
                    }
                }
                Event::Rule(rule) => {
                    work.fill(rules.chains.terms(rule).map(|(name, unit)| (members.numbers[&name], unit)));
                    of_rules[rule] = work.held(None);
                }
            }
        }
        drop(steps);
        for (birth, death) in found {
            self.pair(degree - 1, birth, death);
        }
        Ok(Reduced { members, cells, rules: of_rules })
    }

    /// Whether a critical cell is the end of a pair, so that chains have it no more.
    fn is_gone(&self, degree: usize, place: u32) -> bool {
        place != NONE && self.fates[degree][place as usize] == Fate::Death
    }

    fn without_pairs(
        self,
        mut vertices: Contracted,
        tops: Option<Contracted>,
        reduced: Vec<Reduced<F::Unit>>,
    ) -> ImagePart {
        let (prime, axes) = (self.part.cut.prime(), self.part.axes());
        let is_left = |degree: usize, place: usize| self.fates[degree][place] == Fate::Left;
        let critical = self.part.critical.iter().enumerate().map(|(degree, cells)| {
            let mut left = Cells::default();
            for place in (0..cells.len()).filter(|&place| is_left(degree, place)) {
                left.push(cells.keys[place], cells.names[place]);
            }
            left
        });
        let critical = critical.collect();
        let edges = vertices.couples_left(|edge| is_left(1, edge));
        let mut rules = vec![vertices.rules_left(&self.part.rules[0])];
        let (mut facets, mut top_rules) = (Vec::new(), Rules::default());
        if let Some(mut tops) = tops {
            facets = tops.couples_left(|facet| is_left(axes - 1, facet));
            top_rules = tops.rules_left(&self.part.top_rules);
        }
        let mut boundaries = Vec::new();
        for (degree, found) in (2..).zip(reduced) {
            let names = |terms: &[(u32, F::Unit)]| -> Vec<(Name, u32)> {
                let members = &found.members;
                // Those that ended classes of the degree below were found later.
                let terms =
                    terms.iter().filter(|term| !self.is_gone(degree - 1, members.places[term.0 as usize]));
                terms.map(|&(row, unit)| (members.names[row as usize], F::number(unit))).collect()
            };
            let mut chains = Chains::default();
            for place in (0..found.cells.len()).filter(|&place| is_left(degree, place)) {
                chains.push(prime, names(&found.cells[place]));
            }
            boundaries.push(chains);
            let of_part = &self.part.rules[degree - 1];
            let mut left = Rules::default();
            for (i, terms) in found.rules.iter().enumerate() {
                let cell = (of_part.cells.keys[i], of_part.cells.names[i]);
                left.push(prime, cell, of_part.askers.list(i).iter().copied(), names(terms));
            }
            rules.push(left);
        }
        let mut part = ImagePart { critical, edges, facets, boundaries, rules, top_rules, ..self.part };
        part.layer = part.layer_of_ends();
        part
    }
}

impl ImagePart {
    /// The voxels of other blocks that chains lead to.
    fn layer_of_ends(&self) -> Vec<[u64; 2]> {
        let rules = self.rules.iter().chain([&self.top_rules]).map(|rules| rules.chains.all_names());
        let lists = self.boundaries.iter().map(Chains::all_names).chain(rules);
        let couples = [self.edges.as_flattened(), self.facets.as_flattened()];
        let names = lists.chain(couples).flatten().filter(|&&name| name != OUTSIDE_NAME);
        let mut voxels: Vec<u64> = names.map(|&name| owner(name)).collect();
        voxels.sort_unstable();
        voxels.dedup();
        let mut layer = Vec::new();
        for voxel in voxels {
            let place = self.layer.binary_search_by_key(&voxel, |&[voxel, _]| voxel);
            layer.extend(place.ok().map(|place| self.layer[place]));
        }
        layer
    }
}

impl Contracted {
    fn couples_left(&mut self, is_left: impl Fn(usize) -> bool) -> Vec<[Name; 2]> {
        let mut couples = Vec::new();
        for (place, &couple) in self.couples.iter().enumerate() {
            if is_left(place) {
                couples.push(couple.map(|end| self.members.names[self.forest.root(end) as usize]));
            }
        }
        couples
    }

    fn rules_left(&mut self, rules: &Rules) -> Rules {
        let mut left = Rules::default();
        for (i, &end) in self.rules.iter().enumerate() {
            let end = self.members.names[self.forest.root(end) as usize];
            let cell = (rules.cells.keys[i], rules.cells.names[i]);
            left.push(2, cell, rules.askers.list(i).iter().copied(), [(end, 1)]);
        }
        left
    }
}

/// Boundaries that are reduced.
struct Columns<'a, F: Field> {
    field: &'a F,
    /// Rows that chains have no more.
    is_gone: Vec<bool>,
    /// Rows that no cell may be paired with: ends outside, and what is or may be a facet of an earlier cell.
    is_held: Vec<bool>,
    /// For each row the column that it was paired with.
    killers: Vec<u32>,
    /// Sparse columns in one array; the row that a column was paired with is its first.
    starts: Vec<usize>,
    terms: Vec<(u32, F::Unit)>,
    heap: BinaryHeap<(u32, F::Unit)>,
}

impl<F: Field> Columns<'_, F> {
    fn fill(&mut self, terms: impl Iterator<Item = (u32, u32)>) {
        self.heap.clear();
        for (row, unit) in terms {
            if !self.is_gone[row as usize] {
                self.heap.extend(self.field.unit(unit.cast_signed()).map(|unit| (row, unit)));
            }
        }
    }

    /// Takes out the last row of the sum that has no partner; those behind it that have one are replaced.
    fn lead(&mut self) -> Option<(u32, F::Unit)> {
        while let Some((row, unit)) = self.taken() {
            let killer = self.killers[row as usize];
            if killer == NONE {
                return Some((row, unit));
            }
            let column = &self.terms[self.starts[killer as usize]..self.starts[killer as usize + 1]];
            let factor = self.field.eliminator(unit, column[0].1);
            let field = self.field;
            self.heap.extend(column[1..].iter().map(|&(cell, x)| (cell, field.product(factor, x))));
        }
        None
    }

    /// Keeps the sum as the column that a row is paired with.
    fn kill(&mut self, row: u32, unit: F::Unit) {
        self.killers[row as usize] = (self.starts.len() - 1) as u32;
        self.terms.push((row, unit));
        while let Some(term) = self.taken() {
            self.terms.push(term);
        }
        self.starts.push(self.terms.len());
    }

    /// The whole sum, without rows that have a partner. Its rows are held from now on.
    fn held(&mut self, first: Option<(u32, F::Unit)>) -> Vec<(u32, F::Unit)> {
        let mut sum: Vec<(u32, F::Unit)> = first.into_iter().collect();
        while let Some(term) = self.lead() {
            sum.push(term);
        }
        for &(row, _) in &sum {
            self.is_held[row as usize] = true;
        }
        sum
    }

    /// Takes the last row out of the sum, with its coefficient.
    fn taken(&mut self) -> Option<(u32, F::Unit)> {
        while let Some((cell, unit)) = self.heap.pop() {
            let mut total = Some(unit);
            while let Some(&(other, x)) = self.heap.peek()
                && other == cell
            {
                self.heap.pop();
                total = match total {
                    Some(sum) => self.field.sum(sum, x),
                    None => Some(x),
                };
            }
            if let Some(unit) = total {
                return Some((cell, unit));
            }
        }
        None
    }
}
