//! Linking numbers of the loops of a tree-cotree decomposition, and what they say about classes.

use super::{HandleKind, Linking};
use crate::curves::{ClosedWalk, SurfaceHomology, TreeCotree};
use coface_algebra::EdgeId;
use coface_algebra::{Error, Integer, SparseMatrix, smith_form_with_transforms};
use coface_complexes::surface::GeneralizedMap;
use std::ops::Range;

/// The modulus of fingerprints, a prime.
const MODULUS: u64 = (1 << 61) - 1;

/// Numbers modulo a prime that tell what a class is: the first vanishes on the classes of handle loops, the second on those of tunnel loops, the
/// third on none, but for a chance of $2^{-61}$. They add up along walks.
pub(super) type Fingerprint = [u64; 3];

pub(super) fn sum(a: Fingerprint, b: Fingerprint) -> Fingerprint {
    [0, 1, 2].map(|i| {
        let sum = a[i] + b[i];
        if sum >= MODULUS { sum - MODULUS } else { sum }
    })
}

pub(super) fn negative(a: Fingerprint) -> Fingerprint {
    a.map(|x| if x == 0 { 0 } else { MODULUS - x })
}

/// What kind of loop has this fingerprint, and a number that it shares with those of its class and the opposite one.
pub(super) fn read(print: Fingerprint) -> Option<(HandleKind, u64)> {
    let kind = match (print[0] == 0, print[1] == 0) {
        (true, false) => HandleKind::Handle,
        (false, true) => HandleKind::Tunnel,
        _ => return None,
    };
    Some((kind, print[2].min(MODULUS - print[2])))
}

fn times(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    let folded = (product >> 61) as u64 + (product as u64 & MODULUS);
    if folded >= MODULUS { folded - MODULUS } else { folded }
}

fn reduced(x: i64) -> u64 {
    x.rem_euclid(MODULUS as i64) as u64
}

/// Entry (i, j) is the linking number of loop i with loop j pushed off to the outside, for loops of one component; else it is zero.
pub(super) struct LinkingMatrix {
    rows: Vec<Vec<i64>>,
    /// The loops of each component.
    ranges: Vec<Range<usize>>,
}

impl LinkingMatrix {
    /// # Errors
    /// Those of `linking`, and [`coface_algebra::ErrorKind::InvalidInput`] if the numbers are not those of a surface that does not meet itself.
    pub(super) fn new(
        map: &GeneralizedMap,
        trees: &TreeCotree,
        homology: &SurfaceHomology<'_>,
        linking: Linking<'_>,
    ) -> Result<Self, Error> {
        let loops = homology.loops();
        let mut edges: Vec<EdgeId> =
            loops.iter().flat_map(|walk| walk.steps()).map(|&step| EdgeId::from_u32(step >> 1)).collect();
        edges.sort_unstable();
        edges.dedup();
        let mut terms = linking(&edges)?;
        terms.sort_unstable();
        let mut ranges = Vec::new();
        let mut first = 0;
        for component in trees.components() {
            ranges.push(first..first + component.generators().len());
            first += component.generators().len();
        }
        let mut rows = vec![vec![0; loops.len()]; loops.len()];
        // What each edge adds to the linking number with one loop.
        let mut added = vec![0i64; map.edge_count()];
        for range in &ranges {
            for i in range.clone() {
                let mut touched = Vec::new();
                for (edge, sign) in signed(&loops[i]) {
                    let start = terms.partition_point(|term| term.on_surface < edge);
                    for term in terms[start..].iter().take_while(|term| term.on_surface == edge) {
                        added[term.outside.index()] += sign * term.value;
                        touched.push(term.outside.index());
                    }
                }
                for j in range.clone() {
                    rows[i][j] = signed(&loops[j]).map(|(edge, sign)| sign * added[edge.index()]).sum();
                }
                touched.into_iter().for_each(|edge| added[edge] = 0);
            }
        }
        let matrix = Self { rows, ranges };
        match matrix.ranges.iter().all(|range| 2 * matrix.rank(range) == range.len()) {
            true => Ok(matrix),
            false => {
                Err(Error::invalid("the linking numbers are those of no surface in space: it meets itself"))
            }
        }
    }

    pub(super) fn ranges(&self) -> &[Range<usize>] {
        &self.ranges
    }

    /// What kind of loop has this class; `None` if it bounds on the surface or is of neither kind.
    pub(super) fn kind(&self, class: &[i64]) -> Option<HandleKind> {
        if class.iter().all(|&x| x == 0) {
            return None;
        }
        let range = self.ranges.iter().find(|range| class[(*range).clone()].iter().any(|&x| x != 0))?;
        let bounds_inside = range.clone().all(|j| {
            range.clone().map(|i| i128::from(class[i]) * i128::from(self.rows[i][j])).sum::<i128>() == 0
        });
        let bounds_outside = range.clone().all(|i| {
            range.clone().map(|j| i128::from(self.rows[i][j]) * i128::from(class[j])).sum::<i128>() == 0
        });
        match (bounds_inside, bounds_outside) {
            (true, false) => Some(HandleKind::Handle),
            (false, true) => Some(HandleKind::Tunnel),
            _ => None,
        }
    }

    /// Whether a handle loop and a tunnel loop cross an odd number of times.
    pub(super) fn is_odd(&self, handle: &[i64], tunnel: &[i64]) -> bool {
        // The intersection form is the difference of the linking numbers on either side, and those with the handle vanish on one.
        let odd_places =
            |class: &[i64]| -> Vec<usize> { (0..class.len()).filter(|&i| class[i] % 2 != 0).collect() };
        let (rows, columns) = (odd_places(tunnel), odd_places(handle));
        let ones = rows.iter().flat_map(|&i| columns.iter().map(move |&j| (i, j)));
        ones.filter(|&(i, j)| self.rows[i][j] % 2 != 0).count() % 2 == 1
    }

    /// A basis of the classes of one kind in a component.
    pub(super) fn basis(&self, component: usize, kind: HandleKind) -> Result<Vec<Vec<i64>>, Error> {
        let range = self.ranges[component].clone();
        let count = range.len();
        let entries = range.clone().flat_map(|i| range.clone().map(move |j| (i, j)));
        let entry = |(i, j): (usize, usize)| {
            let value = match kind {
                HandleKind::Tunnel => self.rows[i][j],
                HandleKind::Handle => self.rows[j][i],
            };
            (i - range.start, j - range.start, value)
        };
        let matrix =
            SparseMatrix::from_entries(count, count, entries.map(entry).filter(|entry| entry.2 != 0))?;
        let smith = smith_form_with_transforms(&matrix);
        let column = |column: usize| -> Result<Vec<i64>, Error> {
            let column = smith.right().column(column);
            let mut class = vec![0; self.rows.len()];
            for i in 0..count {
                let value: Integer = column.entry(i);
                class[range.start + i] = value.to_i64().ok_or_else(|| {
                    Error::invalid("the classes of handle loops have numbers beyond 64 bits")
                })?;
            }
            Ok(class)
        };
        (smith.form().rank()..count).map(column).collect()
    }

    /// The fingerprint of a step along each edge.
    pub(super) fn fingerprints(
        &self,
        map: &GeneralizedMap,
        homology: &SurfaceHomology<'_>,
    ) -> Vec<Fingerprint> {
        let count = self.rows.len();
        // The same numbers each time.
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = || {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            (mixed ^ (mixed >> 31)) % MODULUS
        };
        let numbers: Vec<u64> = (0..count).map(|_| random()).collect();
        let all: Vec<u64> = (0..count).map(|_| random()).collect();
        let weights: Vec<Fingerprint> = (0..count)
            .map(|i| {
                let range =
                    self.ranges.iter().find(|range| range.contains(&i)).expect("loops have components");
                let mut weight = [0, 0, all[i]];
                for j in range.clone() {
                    let inside = times(reduced(self.rows[i][j]), numbers[j]);
                    let outside = times(reduced(self.rows[j][i]), numbers[j]);
                    weight = sum(weight, [inside, outside, 0]);
                }
                weight
            })
            .collect();
        let of_edge = |edge: u32| {
            homology.crossed(edge).iter().fold([0; 3], |print, &(generator, value)| {
                sum(print, weights[generator as usize].map(|weight| times(reduced(value), weight)))
            })
        };
        (0..map.edge_count() as u32).map(of_edge).collect()
    }

    /// The rank of the part of a component, modulo a prime.
    fn rank(&self, range: &Range<usize>) -> usize {
        let mut rows: Vec<Vec<u64>> = range
            .clone()
            .map(|i| self.rows[i][range.clone()].iter().map(|&x| reduced(x)).collect())
            .collect();
        let mut rank = 0;
        for column in 0..range.len() {
            let Some(pivot) = (rank..rows.len()).find(|&i| rows[i][column] != 0) else { continue };
            rows.swap(rank, pivot);
            let inverse = power(rows[rank][column], MODULUS - 2);
            let (above, below) = rows.split_at_mut(rank + 1);
            let pivot = &above[rank];
            for row in below.iter_mut().filter(|row| row[column] != 0) {
                let factor = MODULUS - times(row[column], inverse);
                for (x, &y) in row[column..].iter_mut().zip(&pivot[column..]) {
                    let sum = *x + times(y, factor);
                    *x = if sum >= MODULUS { sum - MODULUS } else { sum };
                }
            }
            rank += 1;
        }
        rank
    }
}

fn power(base: u64, mut exponent: u64) -> u64 {
    let (mut square, mut result) = (base, 1);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = times(result, square);
        }
        square = times(square, square);
        exponent >>= 1;
    }
    result
}

fn signed(walk: &ClosedWalk) -> impl Iterator<Item = (EdgeId, i64)> + '_ {
    walk.steps().iter().map(|&step| (EdgeId::from_u32(step >> 1), if step & 1 == 0 { 1 } else { -1 }))
}
