//! Bases of the first cohomology of surfaces and their values on loops.

use super::{ClosedWalk, Slicing, SurfaceHomology};
use coface_algebra::chains::Cochain;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{Integer, SkewForm, SparseMatrix, smith_form_with_transforms};
use coface_complexes::surface::GeneralizedMap;

/// Closed integral cochains of degree 1 on a surface, with their values on loops.
///
/// [`Self::by_crossing`] gives cochains that are dual to the loops of a tree-cotree decomposition, on every surface.
/// [`Self::by_slicing`] slices a closed oriented surface along the loops; the values are then the intersection numbers
/// of the loops. Both span the same classes; [`Self::dual`] leads from the second to the first, up to exact cochains.
///
/// # Examples
/// The torus with 7 vertices: two loops that cross once.
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
/// let trees = TreeCotree::new(&torus);
/// let homology = SurfaceHomology::new(&torus, &trees);
/// let sliced = CocycleBasis::by_slicing(&torus, homology.loops())?;
/// assert_eq!(sliced.pairing()[0][0], 0);
/// assert_eq!(sliced.pairing()[0][1], -sliced.pairing()[1][0]);
/// assert_eq!(sliced.determinant(), Some(&1.into()));
/// assert_eq!(sliced.dual()?.pairing(), [[1, 0], [0, 1]]);
/// assert_eq!(CocycleBasis::by_crossing(&homology).pairing(), [[1, 0], [0, 1]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CocycleBasis {
    loops: Vec<ClosedWalk>,
    cocycles: Vec<Cochain<Integer>>,
    pairing: Vec<Vec<i64>>,
    determinant: Option<Integer>,
}

impl CocycleBasis {
    /// A basis of the first cohomology by the crossing cochains of generators, see [`SurfaceHomology::cocycles`], and
    /// the simple loops of generators that it is dual to: a basis of the first homology modulo torsion. In a
    /// component that is closed and not orientable that is one loop less than there are generators.
    ///
    /// # Complexity
    /// Linear in the values that are not zero and the lengths of the loops, and the matrix of values.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let basis = CocycleBasis::by_crossing(&homology);
    /// assert_eq!(basis.pairing(), [[1, 0], [0, 1]]);
    /// # Ok(()) }
    /// ```
    pub fn by_crossing(homology: &SurfaceHomology<'_>) -> Self {
        let (cocycles, values) = homology.cocycles();
        let free = homology.free_generators();
        let all = homology.loops();
        let loops = free.iter().map(|&i| all[i].clone()).collect();
        let pairing = values.iter().map(|row| free.iter().map(|&i| row[i]).collect()).collect();
        Self { loops, cocycles, pairing, determinant: Some(Integer::ONE) }
    }

    /// The cocycles of these loops by slicing; see [`super::slicing_cocycle`]. Cocycle i has on loop j the intersection
    /// number of loop j with loop i, so the matrix of values is skew. If the loops are a basis of the first homology of
    /// a closed surface, its determinant is 1.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a loop that is one-sided; [`ErrorKind::NotInComplex`] for one that is not of
    /// this surface.
    ///
    /// # Complexity
    /// Linear in the edges, in the edges at the loops, and, for each loop, in the lengths of all loops; and the matrix
    /// of values.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let basis = CocycleBasis::by_slicing(&torus, homology.loops())?;
    /// // The loops cross once; the sign depends on their order.
    /// let pairing = basis.pairing();
    /// assert_eq!((pairing[0][0], pairing[0][1].abs(), pairing[0][1] + pairing[1][0]), (0, 1, 0));
    /// # Ok(()) }
    /// ```
    pub fn by_slicing(map: &GeneralizedMap, loops: Vec<ClosedWalk>) -> Result<Self, Error> {
        let slicing = Slicing::new(map);
        let values: Vec<Vec<(u32, i64)>> =
            loops.iter().map(|walk| slicing.values(walk)).collect::<Result<_, _>>()?;
        let mut on_edge = vec![0i64; map.skeleton().edge_count()];
        let mut pairing = Vec::with_capacity(loops.len());
        let steps = stage("counting crossings of loops", values.len());
        for terms in &values {
            steps.advance(1);
            terms.iter().for_each(|&(edge, value)| on_edge[edge as usize] = value);
            let value = |&step: &u32| {
                let value = on_edge[(step >> 1) as usize];
                if step & 1 == 0 { value } else { -value }
            };
            pairing.push(loops.iter().map(|walk| walk.steps().iter().map(value).sum()).collect::<Vec<i64>>());
            terms.iter().for_each(|&(edge, _)| on_edge[edge as usize] = 0);
        }
        let rows = pairing.iter().map(|row| row.iter().map(|&x| Integer::from(x)).collect());
        // Only two-sided loops of an oriented surface have a skew matrix for certain.
        let determinant = SkewForm::new(rows.collect()).ok().map(|form| form.determinant());
        let cocycle = |terms: Vec<(u32, i64)>| {
            let terms = terms.into_iter().map(|(edge, value)| (CellId::from_u32(edge), Integer::from(value)));
            Cochain::of_cells(1, terms)
        };
        let cocycles = values.into_iter().map(cocycle).collect::<Result<_, _>>()?;
        Ok(Self { loops, cocycles, pairing, determinant })
    }

    /// The dual basis: combinations of the cocycles, by the inverse of the matrix of values, that have the value 1 on
    /// their own loop and 0 on the others.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] unless the matrix is square and invertible over Z.
    ///
    /// # Complexity
    /// That of a Smith form with transforms of the matrix, and of the combinations.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let basis = CocycleBasis::by_slicing(&torus, homology.loops())?;
    /// assert_eq!(basis.dual()?.pairing(), [[1, 0], [0, 1]]);
    /// # Ok(()) }
    /// ```
    pub fn dual(&self) -> Result<Self, Error> {
        let count = self.loops.len();
        let entries = self.pairing.iter().enumerate();
        let entries = entries.flat_map(|(i, row)| row.iter().enumerate().map(move |(j, &x)| (i, j, x)));
        let matrix = SparseMatrix::from_entries(self.cocycles.len(), count, entries)?;
        let smith = smith_form_with_transforms(&matrix);
        let is_unimodular = self.cocycles.len() == count
            && smith.form().rank() == count
            && smith.form().diagonal().iter().all(Integer::is_unit);
        if !is_unimodular {
            return Err(Error::new(
                ErrorKind::Coefficient,
                format!(
                    "the matrix of values of {} cocycles on {count} loops has no integer inverse",
                    self.cocycles.len()
                ),
            )
            .with_cure("take loops that are a basis of the first homology of a closed orientable surface"));
        }
        let inverse = smith.right().product(smith.left())?.into_wide().transpose();
        let cocycles = inverse.columns().map(|row| {
            let terms = row.terms().flat_map(|(i, factor)| {
                let terms = self.cocycles[i].terms().iter();
                terms.map(move |(cell, value)| (*cell, value * factor))
            });
            Cochain::of_cells(1, terms)
        });
        let identity = (0..count).map(|i| (0..count).map(|j| i64::from(i == j)).collect());
        Ok(Self {
            loops: self.loops.clone(),
            cocycles: cocycles.collect::<Result<_, _>>()?,
            pairing: identity.collect(),
            determinant: Some(Integer::ONE),
        })
    }

    /// The loops.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let basis = CocycleBasis::by_crossing(&homology);
    /// assert_eq!(basis.loops()[1].steps(), [2]);
    /// # Ok(()) }
    /// ```
    pub fn loops(&self) -> &[ClosedWalk] {
        &self.loops
    }

    /// The cocycles.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let basis = CocycleBasis::by_crossing(&homology);
    /// assert_eq!(basis.cocycles()[0].to_string(), "c0");
    /// # Ok(()) }
    /// ```
    pub fn cocycles(&self) -> &[Cochain<Integer>] {
        &self.cocycles
    }

    /// The matrix of values: row i has the values of cocycle i on all loops.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let basis = CocycleBasis::by_crossing(&homology);
    /// assert_eq!(basis.pairing()[1], [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn pairing(&self) -> &[Vec<i64>] {
        &self.pairing
    }

    /// The determinant of the matrix of values; `None` if it is not square, or of loops for which left and right have
    /// no common meaning.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CocycleBasis, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let basis = CocycleBasis::by_slicing(&torus, homology.loops())?;
    /// assert_eq!(basis.determinant(), Some(&1.into()));
    /// # Ok(()) }
    /// ```
    pub fn determinant(&self) -> Option<&Integer> {
        self.determinant.as_ref()
    }
}

#[cfg(test)]
mod tests;
