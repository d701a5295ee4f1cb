//! The map of cells to classes, and the complex of the classes.

use crate::Sum;
use coface_check::Fault;
use coface_check::json::{field, index, list};
use serde_json::Value;
use std::collections::{BTreeMap, HashSet};

/// A chain: cells with their entries, rising, none of them zero.
type Chain = Vec<(u32, i64)>;

/// What the proof says, after it was checked.
pub(crate) struct Quotient {
    counts: Vec<usize>,
    images: Vec<Vec<Chain>>,
}

impl Quotient {
    /// Reads images and boundaries, and checks that the images are a chain map onto the complex of the boundaries.
    pub(crate) fn read(sum: &Sum, proof: &Value) -> Result<Self, Fault> {
        let step = "boundaries";
        let boundaries = list(field(proof, "boundaries", "proof")?, "\"boundaries\"", step)?;
        let boundaries = boundaries.iter().map(|degree| chains(degree, step));
        let boundaries = boundaries.collect::<Result<Vec<Vec<Chain>>, Fault>>()?;
        let step = "images";
        let images = list(field(proof, "images", "proof")?, "\"images\"", step)?;
        let images = images.iter().map(|degree| chains(degree, step));
        let images = images.collect::<Result<Vec<Vec<Chain>>, Fault>>()?;
        if images.len() != sum.counts.len() || boundaries.len() + 1 != images.len() {
            let message =
                format!("images and boundaries are not of the {} degrees there are", sum.counts.len());
            return Err(Fault::new("proof", message));
        }
        for (k, (images, &count)) in images.iter().zip(&sum.counts).enumerate() {
            if images.len() != count {
                return Err(Fault::new(step, format!("there are {count} cells of degree {k}")));
            }
            let is_sign = |chain: &Chain| chain.iter().all(|&(_, entry)| entry.abs() == 1);
            if !images.iter().all(is_sign) {
                return Err(Fault::new(step, format!("an image of degree {k} has an entry that is no sign")));
            }
        }
        if images[0].iter().any(|chain| !matches!(chain[..], [(_, 1)])) {
            return Err(Fault::new(step, "the image of a vertex is not one class"));
        }
        let vertices = images[0].iter().map(|chain| chain[0].0 as usize + 1).max().unwrap_or(0);
        let counts: Vec<usize> = std::iter::once(vertices).chain(boundaries.iter().map(Vec::len)).collect();
        for (k, (images, &count)) in images.iter().zip(&counts).enumerate() {
            let mut is_met = vec![false; count];
            for &(class, _) in images.iter().flatten() {
                let outside = || Fault::new(step, format!("there is no class {class} of degree {k}"));
                *is_met.get_mut(class as usize).ok_or_else(outside)? = true;
            }
            if let Some(class) = is_met.iter().position(|is_met| !is_met) {
                return Err(Fault::new(step, format!("class {class} of degree {k} is no cell's image")));
            }
        }
        check_complex(&counts, &boundaries)?;
        for degree in 1..counts.len() {
            for (cell, boundary) in sum.boundaries(degree).enumerate() {
                let of_image = combination(&images[degree][cell], &boundaries[degree - 1]);
                if of_image.is_none() || of_image != combination(&boundary, &images[degree - 1]) {
                    let message = format!(
                        "the boundary of the image of cell {cell} of degree {degree} is not the image of its boundary"
                    );
                    return Err(Fault::new(step, message));
                }
            }
        }
        Ok(Self { counts, images })
    }

    /// The number of classes of each degree.
    pub(crate) fn counts(&self) -> &[usize] {
        &self.counts
    }

    pub(crate) fn class_of_vertex(&self) -> Vec<u32> {
        self.images[0].iter().map(|chain| chain[0].0).collect()
    }

    /// How many cells of each degree have the image zero.
    pub(crate) fn lost_counts(&self) -> Vec<usize> {
        self.images.iter().map(|images| images.iter().filter(|chain| chain.is_empty()).count()).collect()
    }
}

/// The boundaries of classes are of classes, their boundaries are zero, and they are told apart by them.
fn check_complex(counts: &[usize], boundaries: &[Vec<Chain>]) -> Result<(), Fault> {
    let step = "boundaries";
    for (below, columns) in boundaries.iter().enumerate() {
        let mut seen = HashSet::new();
        for (class, column) in columns.iter().enumerate() {
            let fault =
                |what: &str| Err(Fault::new(step, format!("class {class} of degree {}: {what}", below + 1)));
            if column.last().is_some_and(|&(row, _)| row as usize >= counts[below]) {
                return fault("its boundary has a class that is not there");
            }
            let Some(&(_, first)) = column.first() else { return fault("its boundary is zero") };
            if !seen.insert(scaled(column, first.signum())) {
                return fault("another has the same boundary, up to sign");
            }
            if below > 0 && combination(column, &boundaries[below - 1]).is_none_or(|sum| !sum.is_empty()) {
                return fault("the boundary of its boundary is not zero");
            }
        }
    }
    Ok(())
}

fn scaled(chain: &Chain, by: i64) -> Chain {
    chain.iter().map(|&(cell, entry)| (cell, by * entry)).collect()
}

/// The sum of multiples of chains; `None` where numbers are too large for 64 bits.
fn combination(multiples: &[(u32, i64)], chains: &[Chain]) -> Option<Chain> {
    let mut sum: BTreeMap<u32, i64> = BTreeMap::new();
    for &(which, by) in multiples {
        for &(cell, entry) in &chains[which as usize] {
            let place = sum.entry(cell).or_default();
            *place = place.checked_add(by.checked_mul(entry)?)?;
        }
    }
    Some(sum.into_iter().filter(|&(_, entry)| entry != 0).collect())
}

/// Chains as lists of pairs of a cell and an entry of 31 bits, cells rising.
fn chains(value: &Value, step: &str) -> Result<Vec<Chain>, Fault> {
    let term = |term: &Value| -> Result<(u32, i64), Fault> {
        let [cell, entry] = list(term, "a term", step)? else {
            return Err(Fault::new(step, "a term is no pair"));
        };
        let entry = entry
            .as_i64()
            .filter(|entry| *entry != 0 && i32::try_from(*entry).is_ok_and(|entry| entry != i32::MIN));
        let entry = entry.ok_or_else(|| Fault::new(step, "an entry is zero, or no integer of 31 bits"))?;
        Ok((index(cell, "a cell", step)?, entry))
    };
    let chain = |chain: &Value| -> Result<Chain, Fault> {
        let terms = list(chain, "a chain", step)?.iter().map(term).collect::<Result<Chain, Fault>>()?;
        match terms.windows(2).all(|pair| pair[0].0 < pair[1].0) {
            true => Ok(terms),
            false => Err(Fault::new(step, "the cells of a chain do not rise")),
        }
    };
    list(value, "the chains of a degree", step)?.iter().map(chain).collect()
}
