//! Harmonic one-forms of surfaces with edge lengths.

use crate::hodge::{CholeskyFactor, MOST_FILL};
use coface_algebra::chains::Cochain;
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, IdVec};
use coface_algebra::{Integer, RaggedArray};
use coface_complexes::surface::GeneralizedMap;

/// The harmonic one-form of an integral class: a real value on each edge, with measures of what rounding left.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct HarmonicForm {
    values: IdVec<EdgeId, f64>,
    potential: Vec<f64>,
    closed_residual: f64,
    coclosed_residual: f64,
}

impl HarmonicForm {
    /// The value on each edge, in its direction. On closed walks the sums are those of the integral class.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree, harmonic_forms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let basis = CocycleBasis::by_crossing(&SurfaceHomology::new(&torus, &trees));
    /// let forms = harmonic_forms(&torus, basis.cocycles(), &[1.0, 1.0])?;
    /// assert_eq!(forms[1].values().as_slice(), [0.0, 1.0]);
    /// # Ok(()) }
    /// ```
    pub fn values(&self) -> &IdVec<EdgeId, f64> {
        &self.values
    }

    /// A function on the vertices whose coboundary is the integral cochain less this form; zero at the first vertex of
    /// each component.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree, harmonic_forms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let basis = CocycleBasis::by_crossing(&SurfaceHomology::new(&torus, &trees));
    /// let forms = harmonic_forms(&torus, basis.cocycles(), &[1.0, 1.0])?;
    /// // One vertex: there is nothing to correct.
    /// assert_eq!(forms[0].potential(), [0.0]);
    /// # Ok(()) }
    /// ```
    pub fn potential(&self) -> &[f64] {
        &self.potential
    }

    /// The largest absolute value of a sum around a face, zero but for rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree, harmonic_forms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let basis = CocycleBasis::by_crossing(&SurfaceHomology::new(&torus, &trees));
    /// let forms = harmonic_forms(&torus, basis.cocycles(), &[1.0, 1.0])?;
    /// assert_eq!(forms[0].closed_residual(), 0.0);
    /// # Ok(()) }
    /// ```
    pub fn closed_residual(&self) -> f64 {
        self.closed_residual
    }

    /// The largest absolute value of a weighted sum over the edges out of a vertex, zero but for rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree, harmonic_forms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let basis = CocycleBasis::by_crossing(&SurfaceHomology::new(&torus, &trees));
    /// let forms = harmonic_forms(&torus, basis.cocycles(), &[1.0, 1.0])?;
    /// assert_eq!(forms[0].coclosed_residual(), 0.0);
    /// # Ok(()) }
    /// ```
    pub fn coclosed_residual(&self) -> f64 {
        self.coclosed_residual
    }
}

/// The cotangent weight of each edge of a surface of triangles: half the sum of the cotangents of the angles opposite
/// to it.
///
/// Angles are those of the plane triangles with these edge lengths. The weights are the inner product of one-forms that
/// are linear on the triangles, so the Laplacian of functions that they make is never negative; but a weight is zero or
/// below where the opposite angles add up to 180 degrees or more. Where all weights have to be positive, as in a
/// [`MetricComplex`](crate::hodge::MetricComplex), flip such edges or take the larger of the weight and a small
/// positive number.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is one length for each edge; [`ErrorKind::InvalidInput`] naming a face that is no
/// triangle, or a triangle whose longest side is not shorter than the other two together.
///
/// # Complexity
/// Linear.
///
/// # References
/// U. Pinkall, K. Polthier, *Computing discrete minimal surfaces and their conjugates* (1993).
///
/// # Examples
/// Two triangles with a right angle and legs of length 1, glued along the hypotenuse: its weight is 0, those of the
/// legs are 1/2.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::surface::{GeneralizedMap, PolygonMesh};
/// use coface_topology::cotangent_weights;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mesh = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]]), &[])?;
/// let square = GeneralizedMap::new(mesh.two_skeleton()?)?;
/// // The edges are 01, 02, 03, 12, 23.
/// let weights = cotangent_weights(&square, &[1.0, 2.0_f64.sqrt(), 1.0, 1.0, 1.0])?;
/// let expected = [0.5, 0.0, 0.5, 0.5, 0.5];
/// assert!(weights.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{weights:?}");
/// # Ok(()) }
/// ```
pub fn cotangent_weights(map: &GeneralizedMap, lengths: &[f64]) -> Result<Vec<f64>, Error> {
    let lengths = super::shortest_paths::checked_lengths(map, Some(lengths))?;
    let mut weights = vec![0.0; lengths.len()];
    for (face, rim) in map.skeleton().faces().iter().enumerate() {
        let &[a, b, c] = rim else {
            return Err(Error::invalid(format!("face {} has {} sides, not 3", FaceId::new(face), rim.len()))
                .with_cure("triangulate the surface, or take the weight 1 for each edge"));
        };
        let edges = [a, b, c].map(|step| (step >> 1) as usize);
        let [x, y, z] = edges.map(|edge| lengths[edge]);
        // Heron's formula as W. Kahan orders it would need sorted sides; the product of the four factors suffices here.
        let factors = [x + y + z, y + z - x, z + x - y, x + y - z];
        let area = factors.iter().map(|factor| factor.max(0.0).sqrt()).product::<f64>() / 4.0;
        if area.is_nan() || area <= 0.0 {
            return Err(Error::invalid(format!(
                "the sides of triangle {} are {x}, {y} and {z}: it has no area",
                FaceId::new(face)
            ))
            .with_cure("remove flat triangles, or take the weight 1 for each edge"));
        }
        for (i, &edge) in edges.iter().enumerate() {
            let [own, left, right] = [0, 1, 2].map(|k| [x, y, z][(i + k) % 3]);
            weights[edge] += (left * left + right * right - own * own) / (8.0 * area);
        }
    }
    Ok(weights)
}

/// The harmonic one-forms of closed integral cochains: of all cochains of the class the one with the least weighted sum
/// of squares. It is closed, and coclosed: the weighted sum over the edges out of each vertex is zero.
///
/// `weights` has a weight for each edge, such as [`cotangent_weights`], or 1. Where there is a boundary, the form is
/// tangential to it.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is one finite weight for each edge and the cochains are of degree 1;
/// [`ErrorKind::NotInComplex`] for a cochain with other edges; [`ErrorKind::TooLarge`] if the Laplacian of functions is
/// not positive, as it can be with weights that are not, or its factor does not fit.
///
/// # Complexity
/// One sparse Cholesky factor of the vertices, near-linear on surfaces in practice, and two solutions for each form.
///
/// # References
/// B. Eckmann, *Harmonische Funktionen und Randwertaufgaben in einem Komplex* (1944); X. Gu, S.-T. Yau, *Computational
/// Conformal Geometry* (2008).
///
/// # Examples
/// On a torus of one square the loops along the sides are harmonic already: nothing can be spread.
/// ```
/// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
/// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree, harmonic_forms};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
/// let trees = TreeCotree::new(&torus);
/// let basis = CocycleBasis::by_crossing(&SurfaceHomology::new(&torus, &trees));
/// let forms = harmonic_forms(&torus, basis.cocycles(), &[1.0, 1.0])?;
/// assert_eq!(forms[0].values().as_slice(), [1.0, 0.0]);
/// # Ok(()) }
/// ```
pub fn harmonic_forms(
    map: &GeneralizedMap,
    cocycles: &[Cochain<Integer>],
    weights: &[f64],
) -> Result<Vec<HarmonicForm>, Error> {
    let skeleton = map.skeleton();
    let (vertex_count, edge_count) = (skeleton.vertex_count(), skeleton.edge_count());
    if weights.len() != edge_count {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("{} weights for {edge_count} edges", weights.len()),
        ));
    }
    if let Some(edge) = weights.iter().position(|weight| !weight.is_finite()) {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("edge {} has the weight {}", EdgeId::new(edge), weights[edge]),
        )
        .with_cure("give finite weights"));
    }
    if cocycles.is_empty() {
        return Ok(Vec::new());
    }
    let laplacian = Laplacian::new(map, weights)?;
    let ends = skeleton.edge_ends();
    let form = |cocycle: &Cochain<Integer>| {
        if cocycle.degree() != 1 {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a cochain of degree {} where one of degree 1 is asked for", cocycle.degree()),
            ));
        }
        let mut values = vec![0.0; edge_count];
        for (cell, value) in cocycle.terms() {
            let Some(place) = values.get_mut(cell.index()) else {
                return Err(Error::new(
                    ErrorKind::NotInComplex,
                    format!("there is no edge {cell} of the cochain; there are {edge_count} edges"),
                ));
            };
            *place = value.to_f64();
        }
        let mut potential = vec![0.0; vertex_count];
        // The second solution is for what rounding left of the first.
        for _ in 0..2 {
            let correction = laplacian.solve(laplacian.inward_sums(ends, weights, &values));
            for (value, &[a, b]) in values.iter_mut().zip(ends.as_chunks::<2>().0) {
                *value -= correction[b as usize] - correction[a as usize];
            }
            potential.iter_mut().zip(&correction).for_each(|(sum, x)| *sum += x);
        }
        let largest = |sums: &mut dyn Iterator<Item = f64>| sums.map(f64::abs).fold(0.0, f64::max);
        let around = |rim: &[u32]| -> f64 {
            rim.iter()
                .map(|&step| {
                    let value = values[(step >> 1) as usize];
                    if step & 1 == 0 { value } else { -value }
                })
                .sum()
        };
        let closed_residual = largest(&mut skeleton.faces().iter().map(around));
        let coclosed_residual = largest(&mut laplacian.inward_sums(ends, weights, &values).into_iter());
        let values = values.into_iter().collect();
        Ok(HarmonicForm { values, potential, closed_residual, coclosed_residual })
    };
    let steps = stage("solving for harmonic forms", cocycles.len());
    let form = |cocycle: &Cochain<Integer>| {
        let form = form(cocycle);
        steps.advance(1);
        form
    };
    cocycles.iter().map(form).collect()
}

/// The Laplacian of functions on the vertices that are zero at the first vertex of each component, factorized.
struct Laplacian {
    /// The equation of each vertex; none for first and isolated ones.
    equations: Vec<Option<u32>>,
    factor: CholeskyFactor,
    count: usize,
}

impl Laplacian {
    fn new(map: &GeneralizedMap, weights: &[f64]) -> Result<Self, Error> {
        let skeleton = map.skeleton();
        let ends = skeleton.edge_ends();
        let mut equations: Vec<Option<u32>> = vec![Some(0); skeleton.vertex_count()];
        let steps_at = RaggedArray::grouped(skeleton.vertex_count(), ends.iter().copied());
        for (vertex, steps) in steps_at.iter().enumerate() {
            if steps.is_empty() {
                equations[vertex] = None;
            }
        }
        for first in super::shortest_paths::first_vertices(map) {
            equations[first.index()] = None;
        }
        let mut count = 0;
        for equation in equations.iter_mut().flatten() {
            *equation = count;
            count += 1;
        }
        let count = count as usize;
        let mut entries = Vec::with_capacity(3 * weights.len());
        for (&[a, b], &weight) in ends.as_chunks::<2>().0.iter().zip(weights) {
            let [a, b] = [a, b].map(|vertex| equations[vertex as usize].map(|row| row as usize));
            if a == b {
                continue;
            }
            entries.extend([a, b].into_iter().flatten().map(|row| (row, row, weight)));
            if let (Some(a), Some(b)) = (a, b) {
                entries.push((a.max(b), a.min(b), -weight));
            }
        }
        let _steps = stage("factorizing the Laplacian", 0);
        let factor = CholeskyFactor::new(count, entries, MOST_FILL)?;
        Ok(Self { equations, factor, count })
    }

    /// For each equation the weighted sum of the values of the edges into its vertex, less those out of it.
    fn inward_sums(&self, ends: &[u32], weights: &[f64], values: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.count];
        for ((&[a, b], weight), value) in ends.as_chunks::<2>().0.iter().zip(weights).zip(values) {
            if a == b {
                continue;
            }
            for (vertex, sign) in [(a, -1.0), (b, 1.0)] {
                if let Some(row) = self.equations[vertex as usize] {
                    sums[row as usize] += sign * weight * value;
                }
            }
        }
        sums
    }

    /// The function on all vertices.
    fn solve(&self, mut right: Vec<f64>) -> Vec<f64> {
        if self.count > 0 {
            self.factor.solve(&mut right);
        }
        self.equations.iter().map(|equation| equation.map_or(0.0, |row| right[row as usize])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::cocycle_basis::CocycleBasis;
    use crate::curves::surface_homology::SurfaceHomology;
    use crate::curves::tree_cotree::TreeCotree;
    use crate::hodge::MetricComplex;
    use crate::homology::HomologyBasis;
    use coface_algebra::CellId;
    use coface_complexes::known_spaces;
    use coface_complexes::surface::samples::{all_kinds, genus, map_of};

    fn check(name: &str, map: &GeneralizedMap, weights: &[f64]) {
        let trees = TreeCotree::new(map);
        let basis = CocycleBasis::by_crossing(&SurfaceHomology::new(map, &trees));
        let forms = harmonic_forms(map, basis.cocycles(), weights).unwrap();
        assert_eq!(forms.len(), basis.cocycles().len());
        for (form, row) in forms.iter().zip(basis.pairing()) {
            assert!(form.closed_residual() < 1e-9 && form.coclosed_residual() < 1e-9, "{name}");
            for (walk, &expected) in basis.loops().iter().zip(row) {
                let value = |&step: &u32| {
                    let value = form.values()[EdgeId::from_u32(step >> 1)];
                    if step & 1 == 0 { value } else { -value }
                };
                let sum: f64 = walk.steps().iter().map(value).sum();
                assert!((sum - expected as f64).abs() < 1e-9, "{name}: {sum} {expected}");
            }
        }
    }

    #[test]
    fn forms_are_closed_coclosed_and_dual_to_the_loops() {
        for (name, map) in all_kinds() {
            check(name, &map, &vec![1.0; map.skeleton().edge_count()]);
        }
        // Lengths of a stretched double torus, with obtuse triangles.
        let map = genus(2);
        let lengths: Vec<f64> =
            (0..map.skeleton().edge_count()).map(|e| 1.0 + 0.37 * ((e * 7) % 5) as f64 / 5.0).collect();
        let weights = cotangent_weights(&map, &lengths).unwrap();
        check("lengths", &map, &weights);
    }

    #[test]
    fn forms_are_those_of_the_general_solver() {
        let map = map_of(known_spaces::torus_grid(&[4, 5]));
        let complex = map.skeleton().chain_complex().unwrap();
        let lengths: Vec<f64> =
            (0..map.skeleton().edge_count()).map(|e| 1.0 + 0.1 * (e % 4) as f64).collect();
        let weights: Vec<f64> = cotangent_weights(&map, &lengths).unwrap();
        assert!(weights.iter().all(|&weight| weight > 0.0));
        let ones = |degree| vec![1.0; complex.cell_count(degree)];
        let metric = MetricComplex::with_weights(&complex, vec![ones(0), weights.clone(), ones(2)]).unwrap();
        let basis = HomologyBasis::new(&complex);
        let expected = metric.harmonic_cochains(1, &basis).unwrap();
        let cocycles: Vec<_> = expected.iter().map(|harmonic| harmonic.class().clone()).collect();
        for (form, harmonic) in harmonic_forms(&map, &cocycles, &weights).unwrap().iter().zip(&expected) {
            for (edge, &value) in form.values().as_slice().iter().enumerate() {
                let other = harmonic.cochain().coefficient(CellId::new(edge)).copied().unwrap_or(0.0);
                assert!((value - other).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn bad_lengths_and_weights_are_named() {
        let torus = map_of(known_spaces::cyclic_torus(2));
        let mut lengths = vec![1.0; 21];
        lengths[5] = 3.0;
        assert!(cotangent_weights(&torus, &lengths).unwrap_err().message().contains("has no area"));
        let square = coface_complexes::surface::samples::polygon(&[1, 2, -1, -2]);
        assert!(cotangent_weights(&square, &[1.0, 1.0]).unwrap_err().message().contains("4 sides"));
        assert_eq!(harmonic_forms(&torus, &[], &[1.0]).unwrap_err().kind(), ErrorKind::Shape);
    }
}
