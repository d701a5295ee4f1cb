//! Alpha complexes of points that repeat periodically.

use super::copies::{Copies, are_exact};
use super::{AlphaComplex, PeriodicBox};
use crate::filtered::FilteredComplex;
use crate::simplicial::{DeltaComplex, FrozenComplex};
use coface_algebra::{Error, ErrorKind, RaggedArray, VertexId};
use coface_geometry::Positions;

/// The alpha complex of points on a flat torus: of points that repeat along each axis, with a copy of each simplex taken once.
///
/// At the value $a$ it has the homotopy type of the union of the balls of squared radius $a$ around the points, on the torus. Values are those of
/// [`AlphaComplex`] among all copies. In the whole complex, which is the torus, a simplex has its points in rising order, and a point twice if two of its copies are joined: it is a
/// [`DeltaComplex`]. Where there are enough points, some 20 in the plane and some 80 in space if they are at random places, it is simplicial.
///
/// Where coordinates and sides are not multiples of one power of two, they are taken in units of the first side and rounded to such multiples, at most $2^{-48}$ of a side
/// where sides differ little: so that points of a crystal at halves and thirds of its sides have equal distances.
///
/// # Examples
/// One point in a square of side 1: two sides and a diagonal from the point to its copies, and two triangles.
/// ```
/// use coface_complexes::alpha::{PeriodicAlphaComplex, PeriodicBox};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let point = Positions::from_flat(2, vec![0.25, 0.75])?;
/// let torus = PeriodicAlphaComplex::new(&point, &PeriodicBox::new(&[1.0, 1.0])?, None)?;
/// assert_eq!(torus.complex().f_vector(), [1, 3, 2]);
/// assert_eq!((torus.values(0), torus.values(2)), (&[0.0][..], &[0.5, 0.5][..]));
/// let mut edges = torus.values(1).to_vec();
/// edges.sort_by(f64::total_cmp);
/// assert_eq!(edges, [0.25, 0.25, 0.5]);
/// // Two balls of squared radius 0.25 that touch make two circles, and a hole.
/// assert_eq!(torus.up_to(0.25).complex().chain_complex()?.euler_characteristic(), -1);
/// assert!(torus.simplicial().is_none());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PeriodicAlphaComplex {
    complex: DeltaComplex,
    /// For each degree the points of each simplex.
    points: Vec<Vec<u32>>,
    values: Vec<Vec<f64>>,
    hidden: Vec<VertexId>,
}

impl PeriodicAlphaComplex {
    /// The alpha complex of points of as many coordinates as the box has sides, with a weight for each point if there are weights: squared radii, which may be
    /// negative. Points outside of the box are those inside that they are copies of. Points that equal others, and those that weights hide, are in no simplex.
    ///
    /// The triangulation of the points and copies of them around the box is taken, and all of what meets the box must be there for each copy alike;
    /// else more copies are taken.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for points of another dimension; those of
    /// [`AlphaComplex::new`]; [`ErrorKind::TooLarge`] for more copies than memory has room for.
    ///
    /// # Complexity
    /// That of [`AlphaComplex::new`] of the points and copies around them: a few percent more of many points, 27 times as many and more of a few. Where points leave much of the box empty, copies are those across
    /// that space.
    ///
    /// # References
    /// M. Caroli, M. Teillaud, *Computing 3D periodic triangulations* (2009), for what is simplicial; O. Devillers, M. Teillaud, *Perturbations for Delaunay and
    /// weighted Delaunay 3D triangulations* (2011), for points on one sphere.
    ///
    /// # Examples
    /// See [`PeriodicAlphaComplex`].
    pub fn new(points: &Positions, domain: &PeriodicBox, weights: Option<&[f64]>) -> Result<Self, Error> {
        let dimension = domain.dimension();
        if points.is_empty() {
            return Ok(Self::default());
        }
        if points.dimension() != dimension {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "points of {} coordinates in a periodic box of {dimension} sides",
                    points.dimension()
                ),
            )
            .with_cure("give one length for each coordinate of the points"));
        }
        if weights.is_some_and(|weights| weights.len() != points.len()) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} weights for {} points", weights.map_or(0, <[f64]>::len), points.len()),
            )
            .with_cure("give one weight for each point"));
        }
        let diagonal =
            |domain: &PeriodicBox| domain.lengths().iter().map(|length| length * length).sum::<f64>().sqrt();
        if are_exact(points, domain, 4.0 * diagonal(domain)) {
            return Self::of_rounded(points, domain, weights);
        }
        let unit = domain.lengths()[0];
        let scaled = |numbers: &[f64], unit: f64| numbers.iter().map(|x| x / unit).collect::<Vec<f64>>();
        let domain = PeriodicBox::new(&scaled(domain.lengths(), unit))?;
        let points = Positions::from_flat(dimension, scaled(points.as_flat(), unit))?;
        let weights = weights.map(|weights| scaled(weights, unit * unit));
        let mut found = Self::of_rounded(&points, &domain, weights.as_deref())?;
        found.values.iter_mut().flatten().for_each(|value| *value *= unit * unit);
        Ok(found)
    }

    /// The complex of points whose coordinates are taken as multiples of a power of two.
    fn of_rounded(points: &Positions, domain: &PeriodicBox, weights: Option<&[f64]>) -> Result<Self, Error> {
        let dimension = domain.dimension();
        // No sphere that is empty of points reaches further than a diagonal from its points, and to the other side twice that.
        let most = 2.01 * domain.lengths().iter().map(|length| length * length).sum::<f64>().sqrt();
        let mut margins = first_margins(points, domain, most);
        loop {
            let copies = Copies::new(points, domain, &margins)?;
            let own: Option<Vec<f64>> =
                weights.map(|weights| copies.points.iter().map(|&point| weights[point as usize]).collect());
            let alpha = AlphaComplex::new(&copies.positions, own.as_deref())?;
            if let Some(found) = of_copies(&copies, &alpha, dimension) {
                return Ok(found);
            }
            if margins.iter().all(|&margin| margin >= 4.0 * most) {
                return Err(Error::invalid("the triangulation of the points does not repeat as they do"));
            }
            margins.iter_mut().for_each(|margin| *margin = (2.0 * *margin).min(4.0 * most));
        }
    }

    /// The simplices with their faces.
    ///
    /// # Examples
    /// See [`PeriodicAlphaComplex`].
    pub fn complex(&self) -> &DeltaComplex {
        &self.complex
    }

    /// The points of a simplex, in rising order; a point as often as it has copies in the simplex.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::{PeriodicAlphaComplex, PeriodicBox};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let two = Positions::from_flat(1, vec![0.0, 3.0])?;
    /// let circle = PeriodicAlphaComplex::new(&two, &PeriodicBox::new(&[10.0])?, None)?;
    /// assert_eq!((circle.points(1, 0), circle.points(1, 1)), (&[0, 1][..], &[0, 1][..]));
    /// assert_eq!(circle.values(1).iter().sum::<f64>(), 1.5f64.powi(2) + 3.5f64.powi(2));
    /// # Ok(()) }
    /// ```
    pub fn points(&self, degree: usize, i: usize) -> &[u32] {
        &self.points[degree][i * (degree + 1)..(i + 1) * (degree + 1)]
    }

    /// The values of the simplices of a degree: squared radii. Empty beyond the dimension.
    ///
    /// # Examples
    /// See [`PeriodicAlphaComplex`].
    pub fn values(&self, degree: usize) -> &[f64] {
        self.values.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The points in no simplex of the triangulation, rising.
    ///
    /// # Examples
    /// A point is given again as its copy.
    /// ```
    /// use coface_complexes::alpha::{PeriodicAlphaComplex, PeriodicBox};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let twice = Positions::from_flat(1, vec![1.0, 3.0, 11.0])?;
    /// let circle = PeriodicAlphaComplex::new(&twice, &PeriodicBox::new(&[10.0])?, None)?;
    /// assert_eq!(circle.hidden()[0].index(), 2);
    /// # Ok(()) }
    /// ```
    pub fn hidden(&self) -> &[VertexId] {
        &self.hidden
    }

    /// The same with radii, the square roots of the values, which are not negative where points have no weights.
    ///
    /// # Panics
    /// If a value is negative.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::{PeriodicAlphaComplex, PeriodicBox};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let one = Positions::from_flat(1, vec![1.0])?;
    /// let circle = PeriodicAlphaComplex::new(&one, &PeriodicBox::new(&[10.0])?, None)?;
    /// assert_eq!(circle.with_radii().values(1), [5.0]);
    /// # Ok(()) }
    /// ```
    pub fn with_radii(mut self) -> Self {
        for value in self.values.iter_mut().flatten() {
            assert!(*value >= 0.0, "negative values have no roots");
            *value = value.sqrt();
        }
        self
    }

    /// The part that is there at a value: the simplices that enter at it or before.
    ///
    /// # Examples
    /// See [`PeriodicAlphaComplex`].
    pub fn up_to(&self, bound: f64) -> Self {
        let mut part = Self { hidden: self.hidden.clone(), ..Self::default() };
        let (mut faces, mut numbers) = (Vec::new(), Vec::new());
        for (degree, values) in self.values.iter().enumerate() {
            let stays: Vec<usize> = (0..values.len()).filter(|&i| values[i] <= bound).collect();
            if stays.is_empty() {
                break;
            }
            if degree > 0 {
                let own = |&i: &usize| self.complex.faces(degree, coface_algebra::CellId::new(i));
                let before: &Vec<u32> = &numbers;
                faces.push(stays.iter().flat_map(own).map(|&face| before[face as usize]).collect());
            }
            part.points.push(stays.iter().flat_map(|&i| self.points(degree, i)).copied().collect());
            part.values.push(stays.iter().map(|&i| values[i]).collect());
            // Faces enter no later, so that all that are asked for have numbers.
            numbers = vec![0; values.len()];
            stays.iter().zip(0..).for_each(|(&i, number)| numbers[i] = number);
        }
        let vertices = part.values.first().map_or(0, Vec::len);
        part.complex = DeltaComplex::from_trusted_faces(vertices, faces);
        part
    }

    /// The complex as a simplicial one, with the numbers of the points, if no simplex has a point twice and no two have the same points.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::{PeriodicAlphaComplex, PeriodicBox};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let three = Positions::from_flat(1, vec![0.0, 2.0, 6.0])?;
    /// let circle = PeriodicAlphaComplex::new(&three, &PeriodicBox::new(&[12.0])?, None)?;
    /// assert_eq!(circle.simplicial().expect("three arcs").values(1), [1.0, 9.0, 4.0]);
    /// # Ok(()) }
    /// ```
    pub fn simplicial(&self) -> Option<FilteredComplex> {
        let mut orders = Vec::new();
        for degree in 0..self.values.len() {
            let own = |i: &u32| self.points(degree, *i as usize);
            let mut order: Vec<u32> = (0..self.values[degree].len() as u32).collect();
            order.sort_unstable_by_key(own);
            let repeats = order.iter().any(|i| own(i).windows(2).any(|two| two[0] == two[1]));
            if repeats || order.windows(2).any(|two| own(&two[0]) == own(&two[1])) {
                return None;
            }
            orders.push(order);
        }
        let simplices = (0..self.values.len()).flat_map(|degree| self.points[degree].chunks(degree + 1));
        let complex = FrozenComplex::from_facets(&RaggedArray::from_lists(simplices)).ok()?;
        let values = orders.iter().zip(&self.values);
        let values = values.map(|(order, values)| order.iter().map(|&i| values[i as usize]).collect());
        Some(FilteredComplex::from_trusted_parts(complex, values.collect()))
    }
}

/// How far copies of points are taken along each axis at first: some points further than the widest gap between points along it. Spheres that reach across a gap
/// hold few points beside it, so that boxes with much empty space along one axis need copies along it alone.
fn first_margins(points: &Positions, domain: &PeriodicBox, most: f64) -> Vec<f64> {
    let dimension = domain.dimension();
    let gap = |axis: usize| {
        let length = domain.lengths()[axis];
        let mut along: Vec<f64> =
            points.as_flat().iter().skip(axis).step_by(dimension).map(|x| x.rem_euclid(length)).collect();
        along.sort_by(f64::total_cmp);
        let around = length - (along[along.len() - 1] - along[0]);
        along.windows(2).map(|two| two[1] - two[0]).fold(around, f64::max)
    };
    let gaps: Vec<f64> = (0..dimension).map(gap).collect();
    let count = points.len() as f64;
    // The part of the box without the gaps, in which the points are about evenly spread.
    let filled = domain.lengths().iter().zip(&gaps).map(|(length, gap)| (length - gap).max(length / count));
    let spacing = (filled.product::<f64>() / count).powf(1.0 / dimension as f64);
    gaps.iter().map(|gap| most.min(gap + 3.0 * spacing)).collect()
}

/// What of the alpha complex of points and copies is there once; none if copies differ in what they are in, because there are too few.
fn of_copies(copies: &Copies, alpha: &AlphaComplex, dimension: usize) -> Option<PeriodicAlphaComplex> {
    let complex = alpha.complex();
    if complex.dimension() != Some(dimension) || !repeats(copies, complex, dimension) {
        return None;
    }
    let is_first = |id: u32| copies.shifts[id as usize] == [0; 3];
    // Of all copies of a simplex the one whose first point is in the box.
    let degrees = 0..=dimension;
    let own: Vec<Vec<usize>> = degrees
        .map(|degree| {
            let count = complex.simplex_count(degree);
            (0..count).filter(|&i| is_first(complex.numbers(degree, i)[0])).collect()
        })
        .collect();
    let mut faces = Vec::new();
    for degree in 1..=dimension {
        let mut flat = Vec::with_capacity(own[degree].len() * (degree + 1));
        for &i in &own[degree] {
            let ids = complex.numbers(degree, i);
            for lacked in 0..=degree {
                let face: Vec<u32> =
                    (0..=degree).filter(|&place| place != lacked).map(|place| ids[place]).collect();
                let face = copies.moved_back(&face, copies.shifts[face[0] as usize])?;
                flat.push(own[degree - 1].binary_search(&complex.index_of(&face)?).ok()? as u32);
            }
        }
        faces.push(flat);
    }
    let points = own.iter().enumerate().map(|(degree, own)| {
        let ids = own.iter().flat_map(|&i| complex.numbers(degree, i));
        ids.map(|&id| copies.points[id as usize]).collect()
    });
    let values =
        own.iter().enumerate().map(|(degree, own)| own.iter().map(|&i| alpha.values(degree)[i]).collect());
    let hidden = alpha.hidden().iter().filter(|id| is_first(id.index() as u32));
    Some(PeriodicAlphaComplex {
        complex: DeltaComplex::from_trusted_faces(own[0].len(), faces),
        points: points.collect(),
        values: values.collect(),
        hidden: hidden.map(|id| VertexId::new(copies.points[id.index()] as usize)).collect(),
    })
}

/// Whether all cells at points of the box are there as often as they have points in different copies of it, and around each of these points. Then they
/// cover the torus once, and as each two neighbors have empty spheres, all have.
fn repeats(copies: &Copies, complex: &FrozenComplex, dimension: usize) -> bool {
    let is_first = |id: &u32| copies.shifts[*id as usize] == [0; 3];
    let mut cofaces = vec![0u8; complex.simplex_count(dimension - 1)];
    for i in 0..complex.simplex_count(dimension) {
        let ids = complex.numbers(dimension, i);
        complex.facets(dimension, i).for_each(|(_, facet)| cofaces[facet] += 1);
        if !ids.iter().any(is_first) {
            continue;
        }
        let is_there = |by: [i32; 3]| {
            by == [0; 3] || copies.moved_back(ids, by).is_some_and(|ids| complex.index_of(&ids).is_some())
        };
        if !ids.iter().all(|&id| is_there(copies.shifts[id as usize])) {
            return false;
        }
    }
    (0..cofaces.len())
        .all(|facet| cofaces[facet] == 2 || !complex.numbers(dimension - 1, facet).iter().any(is_first))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn torus(flat: &[f64], sides: &[f64], weights: Option<&[f64]>) -> PeriodicAlphaComplex {
        let points = Positions::from_flat(sides.len(), flat.to_vec()).unwrap();
        let found = PeriodicAlphaComplex::new(&points, &PeriodicBox::new(sides).unwrap(), weights).unwrap();
        found.complex().check().unwrap();
        found
    }

    fn sorted(values: &[f64]) -> Vec<f64> {
        let mut values = values.to_vec();
        values.sort_by(f64::total_cmp);
        values
    }

    #[test]
    fn lattices() {
        // The cube is cut into six tetrahedra around a diagonal.
        let cubic = torus(&[0.5, 0.5, 0.5], &[1.0; 3], None);
        assert_eq!(cubic.complex().f_vector(), [1, 7, 12, 6]);
        assert_eq!(sorted(cubic.values(1)), [0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 0.75]);
        assert_eq!(cubic.values(3), [0.75; 6]);
        // Centered: all tetrahedra are alike, 12 for each of the two points.
        let centered = torus(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], &[2.0; 3], None);
        assert_eq!(centered.complex().f_vector(), [2, 14, 24, 12]);
        assert_eq!(centered.values(3), [1.25; 12]);
        // Centered at faces: for each of the four points two tetrahedra, and an octahedron, which is cut into four.
        let faces = torus(&[0., 0., 0., 1., 1., 0., 1., 0., 1., 0., 1., 1.], &[2.0; 3], None);
        assert_eq!(faces.complex().f_vector(), [4, 28, 48, 24]);
        let values = sorted(faces.values(3));
        assert_eq!((&values[..8], &values[8..]), (&[0.75; 8][..], &[1.0; 16][..]));
        // A long box: a point sees only its copies along the short sides for a while.
        let long = torus(&[0.0, 0.0], &[1.0, 100.0], None);
        assert_eq!((long.complex().f_vector(), sorted(long.values(1))[0]), (vec![1, 3, 2], 0.25));
    }

    #[test]
    fn empty_space_along_an_axis_needs_no_copies_along_others() {
        // Three layers of points in a box that is mostly empty.
        let flat = |height: f64| -> Vec<f64> {
            let place = |i: u32| (f64::from(i) * 0.618_033_988_749_894_9).fract();
            (0..300).flat_map(|i| [place(i) * 8.0, f64::from(i) / 37.5, height * place(7 * i + 3)]).collect()
        };
        for (height, sides) in [(1.0, [8.0, 8.0, 9.0]), (1.0, [8.0, 8.0, 500.0])] {
            let points = Positions::from_flat(3, flat(height)).unwrap();
            let domain = PeriodicBox::new(&sides).unwrap();
            let margins = first_margins(&points, &domain, f64::INFINITY);
            assert!(margins[0] < 4.0 && margins[1] < 4.0 && margins[2] > sides[2] - 1.0, "{margins:?}");
            assert!(Copies::new(&points, &domain, &margins).unwrap().points.len() < 10 * 300);
            let found = torus(&flat(height), &sides, None);
            let counts = found.complex().f_vector();
            assert_eq!((counts[0], counts[0] + counts[2]), (300, counts[1] + counts[3]));
        }
    }

    #[test]
    fn points_of_a_crystal_have_equal_distances() {
        let iron = torus(&[0.0, 0.0, 0.0, 1.435, 1.435, 1.435], &[2.87; 3], None);
        assert_eq!(iron.complex().f_vector(), [2, 14, 24, 12]);
        let mut values = sorted(iron.values(1));
        values.dedup();
        assert_eq!(values.len(), 2, "{values:?}");
        assert!((values[0] - 3.0 * 1.435f64.powi(2) / 4.0).abs() < 1e-14, "{values:?}");
    }

    #[test]
    fn points_of_weight() {
        // The middle is hidden by the corner, whose copies are all around it.
        let hidden = torus(&[0.0, 0.0, 1.0, 1.0], &[2.0; 2], Some(&[3.0, 0.0]));
        assert_eq!((hidden.complex().f_vector(), hidden.hidden()), (vec![1, 3, 2], &[VertexId::new(1)][..]));
        assert_eq!((hidden.values(0), hidden.values(2)), (&[-3.0][..], &[-1.0; 2][..]));
    }

    #[test]
    fn faults_are_named() {
        let fault = |dimension: usize, flat: Vec<f64>, weights: Option<&[f64]>| {
            let points = Positions::from_flat(dimension, flat).unwrap();
            let domain = PeriodicBox::new(&[1.0, 2.0]).unwrap();
            PeriodicAlphaComplex::new(&points, &domain, weights).unwrap_err().to_string()
        };
        assert!(
            fault(3, vec![0.0; 3], None).contains("points of 3 coordinates in a periodic box of 2 sides")
        );
        assert!(fault(2, vec![0.0; 2], Some(&[])).contains("0 weights for 1 points"));
        for sides in [&[][..], &[1.0; 4], &[1.0, -1.0], &[f64::INFINITY], &[f64::NAN], &[1e-200]] {
            assert!(PeriodicBox::new(sides).is_err(), "{sides:?}");
        }
    }

    /// A box, points in it and around it, some of them of a grid, and weights or none.
    fn scenes() -> impl Strategy<Value = (Vec<f64>, Vec<f64>, Option<Vec<f64>>)> {
        let coordinate = prop_oneof![
            2 => (-4i32..12).prop_map(f64::from),
            1 => (0i32..1024).prop_map(|x| f64::from(x) / 128.0),
        ];
        (
            1usize..4,
            prop::sample::select(vec![[4.0, 4.0, 4.0], [4.0, 8.0, 6.0], [2.0, 16.0, 4.0]]),
            prop::bool::ANY,
        )
            .prop_flat_map(move |(dimension, sides, has_weights)| {
                let points = prop::collection::vec(coordinate.clone(), dimension..=dimension * 9);
                let weights = prop::collection::vec((0i32..5).prop_map(|w| f64::from(w) * 0.5), 9);
                (points, weights).prop_map(move |(mut flat, mut weights)| {
                    flat.truncate(flat.len() / dimension * dimension);
                    weights.truncate(flat.len() / dimension);
                    (flat, sides[..dimension].to_vec(), has_weights.then_some(weights))
                })
            })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Invariant 124: a box of two copies beside each other has each simplex twice, with the same values.
        #[test]
        fn a_box_of_two_has_all_twice((flat, sides, weights) in scenes(), axis in 0usize..3) {
            let axis = axis % sides.len();
            let one = torus(&flat, &sides, weights.as_deref());
            prop_assert_eq!(one.complex().chain_complex().unwrap().euler_characteristic(), 0);
            let mut both = flat.clone();
            for point in flat.chunks(sides.len()) {
                let mut point: Vec<f64> = point.iter().zip(&sides).map(|(x, side)| x.rem_euclid(*side)).collect();
                point[axis] += sides[axis];
                both.extend(point);
            }
            let first: Vec<f64> = flat.iter().enumerate().map(|(i, x)| x.rem_euclid(sides[i % sides.len()])).collect();
            both[..flat.len()].copy_from_slice(&first);
            let mut longer = sides.clone();
            longer[axis] *= 2.0;
            let twice: Option<Vec<f64>> = weights.map(|weights| weights.repeat(2));
            let two = torus(&both, &longer, twice.as_deref());
            for degree in 0..=sides.len() {
                prop_assert_eq!(sorted(two.values(degree)), sorted(&one.values(degree).repeat(2)));
            }
            // A part at a value is a complex.
            for &bound in one.values(1) {
                let part = one.up_to(bound);
                part.complex().check().unwrap();
                let count = |degree: usize| one.values(degree).iter().filter(|&&value| value <= bound).count();
                prop_assert!((0..=sides.len()).all(|degree| part.values(degree).len() == count(degree)));
            }
        }

        /// Where the complex is simplicial it is one whose values rise, and the union of balls is there as the points are far apart.
        #[test]
        fn many_points_are_simplicial(seed in 0u64..1000, dimension in 1usize..4) {
            let mut state = seed;
            let mut random = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 40) as f64 / (1u64 << 24) as f64
            };
            let count = [8, 60, 300][dimension - 1];
            let flat: Vec<f64> = (0..count * dimension).map(|_| random()).collect();
            let found = torus(&flat, &vec![1.0; dimension], None);
            let simplicial = found.simplicial();
            prop_assume!(simplicial.is_some());
            let simplicial = simplicial.unwrap();
            simplicial.complex().check().unwrap();
            prop_assert_eq!(simplicial.complex().f_vector(), found.complex().f_vector());
            for degree in 1..=dimension {
                prop_assert_eq!(sorted(simplicial.values(degree)), sorted(found.values(degree)));
                for i in 0..simplicial.complex().simplex_count(degree) {
                    for (_, face) in simplicial.complex().facets(degree, i) {
                        prop_assert!(simplicial.values(degree - 1)[face] <= simplicial.values(degree)[i]);
                    }
                }
            }
        }

        /// The triangles of points that are nowhere special are those of three copies with nothing inside their circle.
        #[test]
        fn triangles_have_empty_circles(flat in prop::collection::vec(0.0f64..1.0, 4..=8), long in prop::bool::ANY) {
            let flat = &flat[..flat.len() / 2 * 2];
            let sides = [1.0, if long { 1.75 } else { 1.0 }];
            let found = torus(flat, &sides, None);
            let points: Vec<[f64; 2]> = flat.chunks(2).map(|p| [p[0], p[1] * sides[1]]).collect();
            let found = if long { torus(&points.concat(), &sides, None) } else { found };
            let shifts = || (-4..=4).flat_map(|x| (-4..=4).map(move |y| [f64::from(x), f64::from(y) * sides[1]]));
            let all: Vec<[f64; 2]> =
                points.iter().flat_map(|p| shifts().map(|s| [p[0] + s[0], p[1] + s[1]])).collect();
            // No empty circle is wider than the diagonal; those of points on one line are not finite, but for rounding.
            let most = 0.26 * (sides[0] * sides[0] + sides[1] * sides[1]);
            let near = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]) <= sides[0].hypot(sides[1]);
            let mut squares = Vec::new();
            for &a in &points {
                let around: Vec<[f64; 2]> = all.iter().copied().filter(|&q| q != a && near(a, q)).collect();
                for (i, &b) in around.iter().enumerate() {
                    for &c in &around[..i] {
                        let ([bx, by], [cx, cy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
                        let double = 2.0 * (bx * cy - by * cx);
                        let (b2, c2) = (bx * bx + by * by, cx * cx + cy * cy);
                        let [x, y] = [(cy * b2 - by * c2) / double, (bx * c2 - cx * b2) / double];
                        let square = x * x + y * y;
                        let is_out = |q: &[f64; 2]| {
                            (q[0] - a[0] - x).powi(2) + (q[1] - a[1] - y).powi(2) > square * (1.0 - 1e-9)
                        };
                        if square <= most && all.iter().all(is_out) {
                            squares.push(square);
                        }
                    }
                }
            }
            // Each triangle was met at each of its three points.
            let (values, squares) = (sorted(&found.values(2).repeat(3)), sorted(&squares));
            prop_assume!(found.hidden().is_empty());
            prop_assert_eq!(values.len(), squares.len());
            let is_near = |(value, square): (&f64, &f64)| (value - square).abs() <= 1e-9 * square;
            prop_assert!(values.iter().zip(&squares).all(is_near), "{values:?} {squares:?}");
        }
    }
}
