//! Cycles, bounding chains and cocycles of the classes of an image.
//!
//! The complex of the critical cells has cycles, which [`persistent_cycles`] finds. They are grown along the gradient to those of all cubes, of the classes that
//! are wanted alone; no complex of cubes is made.

mod circles;
mod cubes;
mod flow;
mod morse;
mod shortening;

#[cfg(test)]
mod tests;

use super::diagram::{ImageDiagram, ImagePair};
use super::filtration::ImageFiltration;
use super::gradient::{Cell, Gradient, OUTSIDE};
use crate::homology::Coefficients;
use crate::persistence::reduction::{persistence, prime};
use crate::persistence::torsion::torsion_primes;
use crate::persistence::{PersistencePair, PersistentCycle, persistent_cycles};
use circles::Multiplied;
use coface_algebra::progress::stage;
use coface_algebra::{Binary, CellId, Error, Field, Integer, Odd, memory};
use cubes::Cubes;
use flow::{Flow, NO_END, Terms, add_up};
use morse::Morse;
use rayon::prelude::*;
use shortening::Shortening;

/// A sum of cubes: the number of each, by rising numbers, and its coefficient.
pub type CubeTerms = Vec<(u64, i64)>;

/// A class of an image with what proves it: a cycle of cubes that are there from the birth on, the chain that it bounds from the death on, and a cocycle.
///
/// Cubes have the numbers that [`ImageCycles::doubled_shape`] tells. The faces of a cube that spans some axes are across them, in order: the end behind less the
/// end before, with alternating signs. Over the field of p elements coefficients are the whole numbers of least absolute value.
///
/// # Examples
/// See [`ImageCycles`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ImageCycle {
    pair: ImagePair,
    birth_cube: u64,
    death_cube: Option<u64>,
    cycle: CubeTerms,
    bounding_chain: Option<CubeTerms>,
    cocycle: CubeTerms,
}

impl ImageCycle {
    /// The birth and the death of the class.
    ///
    /// # Examples
    /// See [`ImageCycles`].
    pub fn pair(&self) -> &ImagePair {
        &self.pair
    }

    /// The cube that makes the class. It enters with the voxel of the birth.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let found = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?.persistent_cycles(Coefficients::Modulo(2), 0.0)?;
    /// // The pixel at 1 has the places 4 to 6, and makes the class with its first corner.
    /// assert_eq!(found.classes()[1].birth_cube(), 4);
    /// # Ok(()) }
    /// ```
    pub fn birth_cube(&self) -> u64 {
        self.birth_cube
    }

    /// The cube that ends the class. It enters with the voxel of the death.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let found = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?.persistent_cycles(Coefficients::Modulo(2), 0.0)?;
    /// assert_eq!(found.classes()[1].death_cube(), Some(3));
    /// # Ok(()) }
    /// ```
    pub fn death_cube(&self) -> Option<u64> {
        self.death_cube
    }

    /// A cycle of the class. No cube of it enters later than the voxel of the birth, and the cube that makes the class has the coefficient 1.
    ///
    /// # Examples
    /// See [`ImageCycles`].
    pub fn cycle(&self) -> &[(u64, i64)] {
        &self.cycle
    }

    /// The chain whose boundary the cycle is; no cube of it enters later than the voxel of the death. `None` for a class that never dies.
    ///
    /// # Examples
    /// See [`ImageCycles`].
    pub fn bounding_chain(&self) -> Option<&[(u64, i64)]> {
        self.bounding_chain.as_deref()
    }

    /// A cocycle of the cubes that enter before the voxel of the death, of all cubes if the class never dies. Its value on the cycle is 1, and it is 0 on cubes that
    /// enter before the voxel of the birth.
    ///
    /// # Examples
    /// See [`ImageCycles`].
    pub fn cocycle(&self) -> &[(u64, i64)] {
        &self.cocycle
    }
}

/// The classes of an image with their cycles.
///
/// # Examples
/// A ring of eight dark pixels around a bright one, which are squares: a loop from 1 to 9.
/// ```
/// use coface_topology::{Coefficients, ImageFiltration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ring = ImageFiltration::new(&[3, 3], [1.0, 1.0, 1.0, 1.0, 9.0, 1.0, 1.0, 1.0, 1.0])?;
/// let found = ring.persistent_cycles(Coefficients::Modulo(3), 0.0)?;
/// assert_eq!(found.doubled_shape(), [7, 7]);
/// let [_, rim] = found.classes() else { panic!("a component and a loop") };
/// assert_eq!((rim.pair().birth(), rim.pair().death()), (1.0, Some(9.0)));
/// // The bright pixel has the places 2 to 4 along both axes, and its middle the number 3 * 7 + 3.
/// assert!(rim.bounding_chain().expect("it dies").iter().any(|&(cube, _)| cube == 24));
/// // The value of the cocycle on the cycle.
/// let of_cycle = |cube| rim.cycle().iter().find(|term| term.0 == cube).map_or(0, |term| term.1);
/// let value: i64 = rim.cocycle().iter().map(|&(cube, x)| x * of_cycle(cube)).sum();
/// assert_eq!(value.rem_euclid(3), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImageCycles {
    diagram: ImageDiagram,
    classes: Vec<ImageCycle>,
    doubled_shape: Vec<u64>,
    torsion_primes: Vec<u32>,
}

impl ImageCycles {
    /// The diagram of all classes, also of those without cycles.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let found = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?.persistent_cycles(Coefficients::Modulo(2), 4.5)?;
    /// assert_eq!((found.diagram().pairs().len(), found.classes().len()), (2, 1));
    /// # Ok(()) }
    /// ```
    pub fn diagram(&self) -> &ImageDiagram {
        &self.diagram
    }

    /// The classes that were wanted, in the order of the diagram.
    ///
    /// # Examples
    /// See [`ImageCycles`].
    pub fn classes(&self) -> &[ImageCycle] {
        &self.classes
    }

    /// How many places cubes have along each axis: a cube that spans an axis has an odd place there, its ends the even ones beside it. The number of a cube counts
    /// places with the last axis running fastest. In the T-construction voxel i spans place 2 i + 1; in the V-construction it is at place 2 i. Along a periodic axis the
    /// end behind the last place is place 0.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageConstruction, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?;
    /// assert_eq!(image.persistent_cycles(Coefficients::Modulo(2), 0.0)?.doubled_shape(), [7]);
    /// let image = image.construction(ImageConstruction::Vertices);
    /// let found = image.persistent_cycles(Coefficients::Modulo(2), 0.0)?;
    /// assert_eq!(found.doubled_shape(), [5]);
    /// assert_eq!(found.classes()[1].cycle(), [(0, 1), (4, 1)]);
    /// # Ok(()) }
    /// ```
    pub fn doubled_shape(&self) -> &[u64] {
        &self.doubled_shape
    }

    /// The primes over whose fields the diagram is another one than over the rational numbers, rising: those of torsion along the way.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let found = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?.persistent_cycles(Coefficients::Modulo(2), 0.0)?;
    /// assert!(found.torsion_primes().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn torsion_primes(&self) -> &[u32] {
        &self.torsion_primes
    }
}

impl ImageFiltration {
    /// The diagram of [`Self::persistence`] with cycles of the classes whose persistence is greater than `length`.
    ///
    /// Cycles are found among critical cells, whose complex [`persistent_cycles`] reduces, and grow along the gradient to cubes. Then boundaries of single cubes that
    /// enter no later than the class are added to a cycle while that makes it shorter, in the number of cubes with multiplicity, and to its bounding chain. Shortest cycles
    /// are not promised.
    ///
    /// # Errors
    /// Those of [`Self::persistence`]; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) where boundaries along the gradient have coefficients beyond 32 bits.
    ///
    /// # Complexity
    /// That of [`Self::persistence`], of [`persistent_cycles`] for the critical cells, and $O(m \log m)$ for m cubes that are given or that chains flow over.
    ///
    /// # References
    /// R. Forman, *Morse theory for cell complexes* (1998), for the chains that critical cells stand for; M. Čufar, Ž. Virk, *Fast computation of persistent homology
    /// representatives with involuted persistent homology* (2023).
    ///
    /// # Examples
    /// See [`ImageCycles`].
    pub fn persistent_cycles(&self, coefficients: Coefficients, length: f64) -> Result<ImageCycles, Error> {
        let prime = prime(coefficients)?;
        self.require_births()?;
        self.require_memory()?;
        let gradient = self.gradient();
        let critical: u64 = gradient.critical.iter().map(|cells| cells.len() as u64).sum();
        memory::require(critical.saturating_mul(200), || {
            format!("cycles of an image with {critical} critical cells")
        })?;
        let diagram = ImageDiagram {
            prime,
            is_falling: self.is_falling(),
            shape: self.lengths().to_vec(),
            pairs: Vec::new(),
        };
        let doubled_shape = self.doubled_shape();
        if gradient.vertices.is_empty() {
            let (classes, torsion_primes) = (Vec::new(), Vec::new());
            return Ok(ImageCycles { diagram, classes, doubled_shape, torsion_primes });
        }
        let morse = Morse::new(self, &gradient)?;
        let whole = persistence(&morse.complex, &morse.filtration, coefficients)?;
        let found = Found { image: self, gradient: &gradient, morse: &morse };
        let rises = self.circles().rises();
        let multiplied = |pair: &PersistencePair| {
            let (key, pair) = found.pair(pair);
            let of_rise = |rise: &usize| ImagePair { degree: pair.degree + rise, ..pair };
            rises.iter().map(of_rise).map(|pair| ((pair.degree, key.1, key.2), pair)).collect::<Vec<_>>()
        };
        let mut pairs: Vec<Sorted<ImagePair>> =
            whole.longer_than(0.0).pairs().iter().flat_map(multiplied).collect();
        pairs.sort_by_key(|pair| pair.0);
        let cycles = persistent_cycles(&morse.complex, &morse.filtration, &whole, length.max(0.0))?;
        let torsion_primes = torsion_primes(&morse.complex, &morse.filtration)?;
        let classes = match prime {
            2 => found.grown(&Binary, &|()| 1, &cycles),
            _ => {
                let least = |unit: u32| {
                    let unit = i64::from(unit);
                    if 2 * unit > i64::from(prime) { unit - i64::from(prime) } else { unit }
                };
                found.grown(&Odd::new(prime), &least, &cycles)
            }
        };
        let diagram = ImageDiagram { pairs: pairs.into_iter().map(|pair| pair.1).collect(), ..diagram };
        Ok(ImageCycles { diagram, classes, doubled_shape, torsion_primes })
    }
}

/// Something of a class with what it is sorted by: degree, moments of birth and death.
type Sorted<T> = ((usize, u32, Option<u32>), T);

/// The critical cells of an image, with their pairs.
struct Found<'a> {
    image: &'a ImageFiltration,
    gradient: &'a Gradient,
    morse: &'a Morse<'a>,
}

impl Found<'_> {
    fn voxel(&self, rank: u32) -> usize {
        self.gradient.grid.voxel_of_vertex(self.gradient.vertex(rank))
    }

    /// The cells in the grid that make and end a class.
    fn cells(&self, pair: &PersistencePair) -> (Cell, Option<Cell>) {
        let degree = pair.degree();
        let death = pair.death_cell().map(|cell| self.morse.cell(degree + 1, cell));
        (self.morse.cell(degree, pair.birth_cell()), death)
    }

    fn pair(&self, pair: &PersistencePair) -> Sorted<ImagePair> {
        let (birth, death) = self.cells(pair);
        // Rising with the order in which cells enter.
        let moment = |cell: Cell| if self.image.is_dual() { u32::MAX - cell.rank() } else { cell.rank() };
        let found = ImagePair {
            degree: pair.degree(),
            birth: pair.birth(),
            death: pair.death(),
            birth_voxel: self.voxel(birth.rank()),
            death_voxel: death.map(|cell| self.voxel(cell.rank())),
        };
        ((found.degree, moment(birth), death.map(moment)), found)
    }

    /// The cycles of critical cells as those of cubes, in the order of the diagram.
    fn grown<F: Field<Unit: Send + Sync> + Sync>(
        &self,
        field: &F,
        integer: &(impl Fn(F::Unit) -> i64 + Sync),
        cycles: &[PersistentCycle],
    ) -> Vec<ImageCycle> {
        let steps = stage("growing cycles", cycles.len());
        let multiplied = Multiplied::new(self.image);
        let growing = Growing { found: self, field, integer, cubes: Cubes::new(self.image, self.gradient) };
        let grown = cycles.par_iter().with_max_len(1).map_init(
            || Flow::new(field, self.gradient),
            |flow, one| {
                steps.advance(1);
                let (key, class) = growing.grown(flow, one);
                let classes = multiplied.classes(class, field.unit(2).is_some()).into_iter();
                classes.map(|class| ((class.pair.degree, key.1, key.2), class)).collect()
            },
        );
        let grown: Vec<Vec<Sorted<ImageCycle>>> = grown.collect();
        let mut grown: Vec<Sorted<ImageCycle>> = grown.into_iter().flatten().collect();
        grown.sort_by_key(|class| class.0);
        grown.into_iter().map(|class| class.1).collect()
    }
}

/// Makes cycles of cubes.
struct Growing<'a, F, N> {
    found: &'a Found<'a>,
    field: &'a F,
    integer: &'a N,
    cubes: Cubes<'a>,
}

impl<F: Field, N: Fn(F::Unit) -> i64> Growing<'_, F, N> {
    fn grown(&self, flow: &mut Flow<'_, F>, one: &PersistentCycle) -> Sorted<ImageCycle> {
        let (found, morse) = (self.found, self.found.morse);
        let is_dual = found.image.is_dual();
        let degree = one.pair().degree();
        let (birth, death) = found.cells(one.pair());
        let of_grid = |degree: usize, terms: &[(CellId, Integer)]| -> Terms<F::Unit> {
            let unit = |x: &Integer| self.field.unit(x.to_i64()?.try_into().ok()?);
            terms.iter().filter_map(|(cell, x)| Some((morse.cell(degree, *cell), unit(x)?))).collect()
        };
        // Chains of a dual image are cochains of the grid.
        let mut cycle = Vec::new();
        let mut chain = match one.bounding_chain() {
            Some(bounding) => {
                let of_degree = morse.grid_degree(degree + 1);
                let terms = of_grid(degree + 1, bounding.terms());
                match is_dual {
                    // What enters before the class may stay in the cycle.
                    false => flow.chain(of_degree, terms, birth.rank() - 1, Some(&mut cycle)),
                    true => flow.cochain(of_degree, terms, birth.rank() + 1, Some(&mut cycle)),
                }
            }
            None => Vec::new(),
        };
        let of_degree = morse.grid_degree(degree);
        let is_middle = degree > 0 && degree < found.gradient.grid.axes();
        let essential = || of_grid(degree, one.cycle().terms());
        let mut cycle_places = match (death, is_dual) {
            (Some(_), _) => Vec::new(),
            (None, false) => flow.chain(of_degree, essential(), OUTSIDE, None),
            (None, true) => flow.cochain(of_degree, essential(), NO_END, None),
        };
        let terms = of_grid(degree, one.cocycle().terms());
        let cocycle = match is_dual {
            false => flow.cochain(of_degree, terms, death.map_or(NO_END, Cell::rank), None),
            true => flow.chain(of_degree, terms, death.map_or(OUTSIDE, Cell::rank), None),
        };
        if is_middle {
            if death.is_none() {
                let cells = cycle_places.iter().map(|&(place, unit)| (found.gradient.cell(place), unit));
                cycle = cells.collect();
            }
            let shortening =
                Shortening { field: self.field, integer: self.integer, gradient: found.gradient, is_dual };
            let added = shortening.shorten(birth, self.last_rank(birth), &mut cycle);
            if !added.is_empty() {
                chain.extend(flow.placed(added));
                add_up(self.field, &mut chain);
            }
        }
        if is_middle || death.is_some() {
            cycle_places = flow.placed(cycle);
        }
        let (key, pair) = found.pair(one.pair());
        let (birth_cube, is_turned) = self.cubes.cube(found.gradient.place(birth));
        let class = ImageCycle {
            pair,
            birth_cube,
            death_cube: death.map(|cell| self.cubes.cube(found.gradient.place(cell)).0),
            cycle: self.terms(&cycle_places, is_turned, &[0]),
            bounding_chain: one.bounding_chain().map(|_| self.terms(&chain, is_turned, &[0])),
            cocycle: self.terms(&cocycle, is_turned, self.cubes.sides()),
        };
        (key, class)
    }

    /// The last rank to enter of the voxels that have the value of a class's birth.
    fn last_rank(&self, birth: Cell) -> u32 {
        let found = self.found;
        let value = |rank: u32| found.image.value(found.voxel(rank));
        let (here, count) = (value(birth.rank()), found.gradient.vertices.len() as u32);
        // Values change in one direction along ranks.
        let (mut inside, mut outside) = match found.image.is_dual() {
            false => (birth.rank(), count + 1),
            true => (birth.rank(), OUTSIDE),
        };
        while inside.abs_diff(outside) > 1 {
            let middle = inside.min(outside) + inside.abs_diff(outside) / 2;
            if value(middle) == here {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        inside
    }

    /// The terms as cubes, on each of these sides of the axes of a single voxel.
    fn terms(&self, terms: &[(usize, F::Unit)], is_turned: bool, sides: &[u64]) -> CubeTerms {
        let mut cubes = Vec::with_capacity(terms.len() * sides.len());
        for &(place, unit) in terms {
            let (cube, other) = self.cubes.cube(place);
            let x = (self.integer)(unit);
            // One is its own negative over two elements.
            let x = if is_turned != other && self.field.unit(2).is_some() { -x } else { x };
            cubes.extend(sides.iter().map(|side| (cube + side, x)));
        }
        cubes.sort_unstable();
        cubes
    }
}
