//! Zigzag persistence: complexes that gain and lose simplices.

use super::extended::cone;
use super::{Filtration, persistence};
use crate::homology::Coefficients;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, Sign, SparseMatrix};
use coface_complexes::simplicial::Simplex;
use std::collections::HashMap;

/// A simplex that enters or leaves a complex at a time.
///
/// # Examples
/// See [`ZigzagFiltration`].
#[derive(Clone, Debug, PartialEq)]
pub struct ZigzagStep {
    simplex: Simplex,
    is_insertion: bool,
    time: f64,
}

impl ZigzagStep {
    /// The simplex enters.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn insertion(simplex: Simplex, time: f64) -> Self {
        Self { simplex, is_insertion: true, time: time + 0.0 }
    }

    /// The simplex leaves.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn deletion(simplex: Simplex, time: f64) -> Self {
        Self { simplex, is_insertion: false, time: time + 0.0 }
    }

    /// The simplex.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn simplex(&self) -> &Simplex {
        &self.simplex
    }

    /// Whether it enters.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn is_insertion(&self) -> bool {
        self.is_insertion
    }

    /// When.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn time(&self) -> f64 {
        self.time
    }
}

/// A complex that begins empty and gains or loses a simplex at each step, faces entering before cofaces and leaving behind them. Times do not fall.
///
/// A simplex is there at the time at which it enters, and still at the time at which it leaves.
///
/// # Examples
/// Two points, which an edge joins from 3 to 5.
/// ```
/// use coface_complexes::simplicial::Simplex;
/// use coface_topology::{Coefficients, ZigzagFiltration, ZigzagStep};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edge = Simplex::from([0, 1]);
/// let filtration = ZigzagFiltration::new(vec![
///     ZigzagStep::insertion(Simplex::from([0]), 1.0),
///     ZigzagStep::insertion(Simplex::from([1]), 2.0),
///     ZigzagStep::insertion(edge.clone(), 3.0),
///     ZigzagStep::deletion(edge, 5.0),
/// ])?;
/// assert!(filtration.steps()[0].is_insertion());
/// let pairs = filtration.persistence(Coefficients::Modulo(2))?;
/// let found: Vec<_> = pairs.iter().map(|pair| (pair.birth(), pair.death(), pair.is_birth_closed())).collect();
/// // The second point is a component up to 3, not at 3 itself, and again behind 5.
/// assert_eq!(found, [(1.0, None, true), (2.0, Some(3.0), true), (5.0, None, false)]);
/// assert!(!pairs[1].is_death_closed());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default)]
pub struct ZigzagFiltration {
    steps: Vec<ZigzagStep>,
    cells: Cells,
}

/// A class that is born at one step of a zigzag and dies at another one, or stays.
///
/// # Examples
/// See [`ZigzagFiltration`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ZigzagPair {
    degree: usize,
    birth_step: usize,
    death_step: Option<usize>,
    birth: f64,
    death: Option<f64>,
    is_birth_closed: bool,
    is_death_closed: bool,
}

impl ZigzagPair {
    /// The degree of the class.
    ///
    /// # Examples
    /// See [`ZigzagFiltration::persistence`].
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The place of the step by which it is born, from 0 on: the class lives in the complex behind this step.
    ///
    /// # Examples
    /// See [`ZigzagFiltration::persistence`].
    pub fn birth_step(&self) -> usize {
        self.birth_step
    }

    /// The place of the step by which it dies: the class lives up to the complex before this step. `None` if it is there at the end.
    ///
    /// # Examples
    /// See [`ZigzagFiltration::persistence`].
    pub fn death_step(&self) -> Option<usize> {
        self.death_step
    }

    /// The time at which it is born.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn birth(&self) -> f64 {
        self.birth
    }

    /// The time at which it dies; `None` if it is there at the end.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn death(&self) -> Option<f64> {
        self.death
    }

    /// Whether it is there at the time of its birth: it is born by a simplex that enters, and not by one that leaves.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn is_birth_closed(&self) -> bool {
        self.is_birth_closed
    }

    /// Whether it is there at the time of its death: it dies by a simplex that leaves. False for a class that stays.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn is_death_closed(&self) -> bool {
        self.is_death_closed
    }

    /// The time from birth to death; infinite for a class that stays.
    ///
    /// # Examples
    /// See [`ZigzagFiltration::persistence`].
    pub fn persistence(&self) -> f64 {
        self.death.map_or(f64::INFINITY, |death| death - self.birth)
    }
}

/// A stay of a simplex in the complex: a simplex that comes again is another cell.
#[derive(Clone, Debug)]
struct Cell {
    entrance: usize,
    exit: Option<usize>,
}

/// The cells of all steps, and which of them the simplices are at the end.
#[derive(Clone, Debug, Default)]
struct Cells {
    /// By degree.
    all: Vec<Vec<Cell>>,
    /// The boundaries of the cells by degree: faces with their signs.
    boundaries: Vec<Vec<Vec<(usize, i64)>>>,
    /// The number of each simplex that is there among the cells of its degree, and how many of its cofacets are there.
    there: HashMap<Simplex, (usize, usize)>,
}

impl ZigzagFiltration {
    /// The filtration of these steps.
    ///
    /// # Errors
    /// Those of [`Self::push`], naming the step counted from 1.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn new(steps: impl IntoIterator<Item = ZigzagStep>) -> Result<Self, Error> {
        let mut filtration = Self::default();
        for (place, step) in steps.into_iter().enumerate() {
            filtration.push(step).map_err(|error| {
                let message = format!("step {}: {}", place + 1, error.message());
                Error::new(error.kind(), message).with_cure(error.cure().unwrap_or_default())
            })?;
        }
        Ok(filtration)
    }

    /// Adds a step.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a simplex enters that is there or before one of its faces, if one leaves that is
    /// not there or before one of its cofaces, or if the time is not finite or before that of the last step. The filtration is as before then.
    ///
    /// # Complexity
    /// Quadratic in the number of vertices of the simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// use coface_topology::{ZigzagFiltration, ZigzagStep};
    /// let mut filtration = ZigzagFiltration::default();
    /// let early = filtration.push(ZigzagStep::insertion(Simplex::from([0, 1]), 0.0)).unwrap_err();
    /// assert_eq!(early.message(), "{0, 1} enters before its face {1}");
    /// ```
    pub fn push(&mut self, step: ZigzagStep) -> Result<(), Error> {
        let time = step.time;
        if !time.is_finite() {
            return Err(Error::invalid(format!("the time is {time}")).with_cure("give finite times"));
        }
        if let Some(last) = self.steps.last().map(ZigzagStep::time).filter(|&last| time < last) {
            let message = format!("the time falls from {last} to {time}");
            return Err(Error::invalid(message).with_cure("sort the steps by their times"));
        }
        match step.is_insertion {
            true => self.cells.insert(&step.simplex, self.steps.len())?,
            false => self.cells.delete(&step.simplex, self.steps.len())?,
        }
        self.steps.push(step);
        Ok(())
    }

    /// The steps.
    ///
    /// # Examples
    /// See [`ZigzagFiltration`].
    pub fn steps(&self) -> &[ZigzagStep] {
        &self.steps
    }

    /// The intervals into which the homology of the complexes and the maps between them decompose: by rising degree, then by steps of birth.
    ///
    /// Each stay of a simplex is a cell of its own. Of these cells a filtration without deletions is made, in which the cone over a cell enters for its exit,
    /// the last exit first; its pairs are those of the zigzag.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`](coface_algebra::ErrorKind::Coefficient) unless the coefficients are modulo a prime below 2^31.
    ///
    /// # Complexity
    /// That of [`persistence`] of twice as many cells as simplices enter.
    ///
    /// # References
    /// T. K. Dey, T. Hou, *Fast computation of zigzag persistence* (2022); G. Carlsson, V. de Silva, D. Morozov, *Zigzag persistent homology and real-valued
    /// functions* (2009).
    ///
    /// # Examples
    /// A loop of three edges that is filled from 7 to 8: before, and behind.
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// use coface_topology::{Coefficients, ZigzagFiltration, ZigzagStep};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let simplices = [&[0][..], &[1], &[2], &[0, 1], &[0, 2], &[1, 2], &[0, 1, 2]];
    /// let mut steps = Vec::new();
    /// for (place, numbers) in simplices.iter().enumerate() {
    ///     steps.push(ZigzagStep::insertion(Simplex::from_numbers(numbers)?, 1.0 + place as f64));
    /// }
    /// steps.push(ZigzagStep::deletion(Simplex::from([0, 1, 2]), 8.0));
    /// let pairs = ZigzagFiltration::new(steps)?.persistence(Coefficients::Modulo(3))?;
    /// let loops: Vec<_> = pairs.iter().filter(|pair| pair.degree() == 1).collect();
    /// assert_eq!((loops[0].birth_step(), loops[0].death_step(), loops[0].persistence()), (5, Some(6), 1.0));
    /// assert_eq!((loops[1].birth_step(), loops[1].death_step()), (7, None));
    /// # Ok(()) }
    /// ```
    pub fn persistence(&self, coefficients: Coefficients) -> Result<Vec<ZigzagPair>, Error> {
        let steps = stage("making the cone", 0);
        let all = &self.cells.all;
        if all.is_empty() {
            super::reduction::prime(coefficients)?;
            return Ok(Vec::new());
        }
        let (cone, filtration) = self.cone_filtration()?;
        drop(steps);
        let whole = persistence(&cone, &filtration, coefficients)?;
        let cell = |degree: usize, cell: CellId| {
            let own = all.get(degree).map_or(0, Vec::len);
            match cell.index().checked_sub(own) {
                Some(over) => (true, &all[degree - 1][over]),
                None => (false, &all[degree][cell.index()]),
            }
        };
        let mut pairs = Vec::new();
        for pair in whole.pairs() {
            // The apex is the one class that stays.
            let Some(death_cell) = pair.death_cell() else { continue };
            let degree = pair.degree();
            let (is_born_over, born) = cell(degree, pair.birth_cell());
            let (is_dead_over, dead) = cell(degree + 1, death_cell);
            let interval = match (is_born_over, is_dead_over) {
                (false, false) => (degree, born.entrance, Some(dead.entrance)),
                (true, _) => match dead.exit {
                    Some(exit) => (degree - 1, exit, born.exit),
                    // Both stay.
                    None => continue,
                },
                (false, true) => match dead.exit {
                    Some(exit) if exit < born.entrance => {
                        let below = degree.checked_sub(1).expect("a vertex that enters ends no class");
                        (below, exit, Some(born.entrance))
                    }
                    exit => (degree, born.entrance, exit),
                },
            };
            pairs.push(self.pair(interval));
        }
        pairs.sort_by_key(|pair| (pair.degree, pair.birth_step, pair.death_step.unwrap_or(usize::MAX)));
        Ok(pairs)
    }

    /// The cone over the complex of all stays of simplices, with a filtration whose pairs are those of the zigzag: the cells of each degree in the order of their
    /// entrance, then the cones over those of the degree below, in degree 0 the apex. A cell enters at its step, counted from 0. Of n steps the cone over a cell that
    /// leaves at step s enters at 2 n - s, and one over a cell that stays at n; the apex comes first.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if there is no step.
    ///
    /// # Complexity
    /// Linear in the cells and their faces.
    ///
    /// # References
    /// T. K. Dey, T. Hou, *Fast computation of zigzag persistence* (2022).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// use coface_topology::{ZigzagFiltration, ZigzagStep};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let steps = [ZigzagStep::insertion(Simplex::from([0]), 1.0), ZigzagStep::deletion(Simplex::from([0]), 2.0)];
    /// let (cone, filtration) = ZigzagFiltration::new(steps)?.cone_filtration()?;
    /// assert_eq!(cone.f_vector(), [2, 1]);
    /// assert_eq!((filtration.values(0), filtration.values(1)), (&[0.0, -1.0][..], &[3.0][..]));
    /// # Ok(()) }
    /// ```
    pub fn cone_filtration(&self) -> Result<(ChainComplex, Filtration), Error> {
        let Cells { all, boundaries, .. } = &self.cells;
        if all.is_empty() {
            return Err(Error::invalid("the zigzag has no step").with_cure("give steps"));
        }
        let matrices = boundaries.iter().enumerate().skip(1).map(|(degree, columns)| {
            let entries = columns
                .iter()
                .enumerate()
                .flat_map(|(cell, faces)| faces.iter().map(move |&(face, sign)| (face, cell, sign)));
            SparseMatrix::from_entries(all[degree - 1].len(), columns.len(), entries)
        });
        let complex = match all.len() {
            1 => ChainComplex::of_points(all[0].len()),
            _ => ChainComplex::new(matrices.collect::<Result<_, Error>>()?)?,
        };
        let cone = cone(&complex)?;
        let filtration = Filtration::new(&cone, self.entrances(all))?;
        Ok((cone, filtration))
    }

    /// When the cells of the cone enter: those of the complex at their steps, then the cones, over what stays first, then over what leaves last.
    fn entrances(&self, all: &[Vec<Cell>]) -> Vec<Vec<f64>> {
        let count = self.steps.len();
        let over = |cell: &Cell| match cell.exit {
            Some(exit) => (2 * count - exit) as f64,
            None => count as f64,
        };
        let level = |degree: usize| {
            let own = all.get(degree).into_iter().flatten().map(|cell| cell.entrance as f64);
            match degree.checked_sub(1) {
                Some(below) => own.chain(all[below].iter().map(over)).collect(),
                // The apex is there from the beginning.
                None => own.chain([-1.0]).collect(),
            }
        };
        (0..=all.len()).map(level).collect()
    }

    fn pair(&self, (degree, birth_step, death_step): (usize, usize, Option<usize>)) -> ZigzagPair {
        let (birth, death) = (&self.steps[birth_step], death_step.map(|step| &self.steps[step]));
        ZigzagPair {
            degree,
            birth_step,
            death_step,
            birth: birth.time,
            death: death.map(|step| step.time),
            is_birth_closed: birth.is_insertion,
            is_death_closed: death.is_some_and(|step| !step.is_insertion),
        }
    }
}

impl Cells {
    fn insert(&mut self, simplex: &Simplex, step: usize) -> Result<(), Error> {
        if self.there.contains_key(simplex) {
            return Err(Error::invalid(format!("{simplex} enters and is there"))
                .with_cure("leave the step out, or let it leave before"));
        }
        let degree = simplex.dimension();
        let mut boundary = Vec::new();
        if degree > 0 {
            for (sign, facet) in simplex.facets() {
                let Some((face, _)) = self.there.get(&facet) else {
                    return Err(Error::invalid(format!("{simplex} enters before its face {facet}"))
                        .with_cure("let faces enter before cofaces"));
                };
                boundary.push((*face, if sign == Sign::Plus { 1 } else { -1 }));
            }
            for (_, facet) in simplex.facets() {
                self.there.get_mut(&facet).expect("facets are there").1 += 1;
            }
        }
        if self.all.len() == degree {
            self.all.push(Vec::new());
            self.boundaries.push(Vec::new());
        }
        self.there.insert(simplex.clone(), (self.all[degree].len(), 0));
        self.all[degree].push(Cell { entrance: step, exit: None });
        self.boundaries[degree].push(boundary);
        Ok(())
    }

    fn delete(&mut self, simplex: &Simplex, step: usize) -> Result<(), Error> {
        let Some(&(cell, cofacets)) = self.there.get(simplex) else {
            return Err(Error::invalid(format!("{simplex} leaves and is not there"))
                .with_cure("leave the step out, or let it enter before"));
        };
        if cofacets > 0 {
            let coface = self.there.keys().filter(|other| simplex.is_face_of(other) && *other != simplex);
            let coface = coface.min().map_or(String::new(), |coface| format!(" {coface}"));
            return Err(Error::invalid(format!("{simplex} leaves before its coface{coface}"))
                .with_cure("let cofaces leave before faces"));
        }
        self.there.remove(simplex);
        let degree = simplex.dimension();
        if degree > 0 {
            for (_, facet) in simplex.facets() {
                self.there.get_mut(&facet).expect("facets leave later").1 -= 1;
            }
        }
        self.all[degree][cell].exit = Some(step);
        Ok(())
    }
}
