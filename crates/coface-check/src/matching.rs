//! Acyclic matchings: the checker tests the order, and finds what the critical cells bound.

use crate::complex::Complex;
use crate::json::{index, list};
use crate::{Fault, smith::Matrix};
use dashu_int::IBig;
use dashu_int::ops::BitTest;
use serde_json::Value;
use std::collections::BTreeMap;

/// Coefficients may have so many bits: no file of a stranger makes them grow without end.
const MOST_BITS: usize = 4096;

/// The pairs of one degree: a face and a cell each, with the incidence 1 or -1, in the order of elimination.
struct Pairs {
    pairs: Vec<(u32, u32, i64)>,
    /// For each face its position among the pairs; beyond the last for those in none.
    position: Vec<usize>,
}

/// The Morse complex: for each degree from 1 on the matrix from critical cells to critical faces.
pub(crate) struct Morse {
    pub(crate) counts: Vec<usize>,
    pub(crate) boundaries: Vec<Matrix>,
}

impl Morse {
    /// Checks the pairs, and cancels them.
    pub(crate) fn new(complex: &Complex, proof: &Value) -> Result<Self, Fault> {
        let counts = complex.counts();
        let lists = list(proof, "\"pairs\"", "matching")?;
        if lists.len() + 1 != counts.len() {
            return Err(Fault::new("matching", format!("there are pairs of {} degrees", lists.len())));
        }
        let mut is_used: Vec<Vec<bool>> = counts.iter().map(|count| vec![false; *count]).collect();
        let mut all = Vec::new();
        for (k, pairs) in lists.iter().enumerate() {
            all.push(Pairs::new(complex, k + 1, pairs, &mut is_used)?);
        }
        let critical: Vec<Vec<u32>> = is_used
            .iter()
            .map(|used| (0..).zip(used).filter(|(_, used)| !**used).map(|(cell, _)| cell).collect())
            .collect();
        let mut boundaries = Vec::new();
        for (k, pairs) in all.iter().enumerate() {
            let cells = critical[k + 1].iter();
            boundaries.push(Matrix {
                rows: critical[k].len(),
                columns: cells
                    .map(|&cell| pairs.boundary(complex, k + 1, cell, &critical[k]))
                    .collect::<Result<_, _>>()?,
            });
        }
        Ok(Self { counts: critical.iter().map(Vec::len).collect(), boundaries })
    }
}

impl Pairs {
    fn new(
        complex: &Complex,
        degree: usize,
        given: &Value,
        is_used: &mut [Vec<bool>],
    ) -> Result<Self, Fault> {
        let step = format!("matching of degree {degree}");
        let (mut pairs, mut position) = (Vec::new(), vec![usize::MAX; complex.counts()[degree - 1]]);
        for (i, pair) in list(given, "the list of pairs", &step)?.iter().enumerate() {
            let [face, cell] = list(pair, "a pair", &step)? else {
                return Err(Fault::new(step, format!("pair {i} is not a face and a cell")));
            };
            let (face, cell) = (index(face, "a face", &step)?, index(cell, "a cell", &step)?);
            for (k, one) in [(degree - 1, face), (degree, cell)] {
                let used = is_used[k].get_mut(one as usize);
                let used =
                    used.ok_or_else(|| Fault::new(&step, format!("pair {i}: there is no cell {one}")))?;
                if std::mem::replace(used, true) {
                    return Err(Fault::new(
                        step,
                        format!("pair {i}: cell {one} of degree {k} is in two pairs"),
                    ));
                }
            }
            let incidence = complex.boundary(degree, cell as usize).iter().find(|(row, _)| *row == face);
            let Some(&(_, incidence @ (1 | -1))) = incidence else {
                return Err(Fault::new(
                    step,
                    format!("pair {i}: face {face} has no unit incidence in cell {cell}"),
                ));
            };
            position[face as usize] = i;
            pairs.push((face, cell, incidence));
        }
        for (i, (_, cell, _)) in pairs.iter().enumerate() {
            let faces = complex.boundary(degree, *cell as usize).iter();
            if faces.map(|(face, _)| position[*face as usize]).any(|other| other < i) {
                let message =
                    format!("pair {i}: cell {cell} has the face of an earlier pair, so the order is wrong");
                return Err(Fault::new(step, message));
            }
        }
        Ok(Self { pairs, position })
    }

    /// What remains of the boundary of a cell on critical faces when the matched faces are eliminated, first pairs first.
    fn boundary(
        &self,
        complex: &Complex,
        degree: usize,
        cell: u32,
        critical: &[u32],
    ) -> Result<BTreeMap<u32, IBig>, Fault> {
        let (mut matched, mut rest) = (BTreeMap::new(), BTreeMap::new());
        let mut add = |cell: u32, factor: &IBig, matched: &mut BTreeMap<usize, IBig>| {
            for (face, incidence) in complex.boundary(degree, cell as usize) {
                let term = factor * IBig::from(*incidence);
                let position = self.position[*face as usize];
                if position < self.pairs.len() {
                    *matched.entry(position).or_default() += term;
                } else if let Ok(row) = critical.binary_search(face) {
                    *rest.entry(row as u32).or_default() += term;
                }
            }
        };
        add(cell, &IBig::ONE, &mut matched);
        while let Some((first, coefficient)) = matched.pop_first() {
            if coefficient.bit_len() > MOST_BITS {
                return Err(Fault::new("matching", format!("a coefficient has more than {MOST_BITS} bits")));
            }
            if coefficient == IBig::ZERO {
                continue;
            }
            let (_, pivot, incidence) = self.pairs[first];
            let factor = -coefficient * IBig::from(incidence);
            add(pivot, &factor, &mut matched);
            // The pivot's own face has cancelled; by the order all other faces it brought come later.
            matched.remove(&first);
        }
        rest.retain(|_, entry| *entry != IBig::ZERO);
        Ok(rest)
    }
}
