//! Smith normal forms: the checker multiplies the transforms out.

use crate::Fault;
use crate::json::{field, index, integer, list};
use dashu_int::IBig;
use serde_json::Value;
use std::collections::BTreeMap;

/// A sparse integer matrix by columns.
pub(crate) struct Matrix {
    pub(crate) rows: usize,
    pub(crate) columns: Vec<BTreeMap<u32, IBig>>,
}

impl Matrix {
    fn is_zero(&self) -> bool {
        self.columns.iter().all(BTreeMap::is_empty)
    }

    /// A square matrix of a certificate, a list of columns, which are lists of a row and a value.
    fn square(value: &Value, key: &str, size: usize, step: &str) -> Result<Self, Fault> {
        let columns = list(field(value, key, step)?, key, step)?;
        if columns.len() != size {
            return Err(Fault::new(step, format!("{key:?} has {} columns, not {size}", columns.len())));
        }
        let column = |column: &Value| {
            let mut entries = BTreeMap::new();
            for entry in list(column, "a column", step)? {
                let [row, value] = list(entry, "an entry", step)? else {
                    return Err(Fault::new(step, format!("an entry of {key:?} is not a row and a value")));
                };
                let row = index(row, "a row", step)?;
                let value = integer(value, "a value", step)?;
                if row as usize >= size || value == IBig::ZERO || entries.insert(row, value).is_some() {
                    return Err(Fault::new(
                        step,
                        format!("row {row} of {key:?} is not there, zero, or twice there"),
                    ));
                }
            }
            Ok(entries)
        };
        Ok(Self { rows: size, columns: columns.iter().map(column).collect::<Result<_, _>>()? })
    }

    /// The product with a column.
    fn times(&self, column: &BTreeMap<u32, IBig>) -> BTreeMap<u32, IBig> {
        let mut sum: BTreeMap<u32, IBig> = BTreeMap::new();
        for (j, factor) in column {
            for (row, entry) in &self.columns[*j as usize] {
                *sum.entry(*row).or_default() += entry * factor;
            }
        }
        sum.retain(|_, entry| *entry != IBig::ZERO);
        sum
    }

    fn is_inverse_of(&self, other: &Self) -> bool {
        let mut columns = (0..).zip(&other.columns);
        columns.all(|(j, column)| self.times(column) == BTreeMap::from([(j, IBig::ONE)]))
    }
}

/// Checks the Smith normal form of a matrix that the checker made, and gives the invariant factors. `null` says that the matrix is zero.
pub(crate) fn diagonal(matrix: &Matrix, proof: &Value, step: &str) -> Result<Vec<IBig>, Fault> {
    if proof.is_null() {
        return match matrix.is_zero() {
            true => Ok(Vec::new()),
            false => Err(Fault::new(step, "the certificate says that the matrix is zero, but it is not")),
        };
    }
    let (rows, width) = (matrix.rows, matrix.columns.len());
    let left = Matrix::square(proof, "left", rows, step)?;
    let left_inverse = Matrix::square(proof, "left_inverse", rows, step)?;
    let right = Matrix::square(proof, "right", width, step)?;
    let right_inverse = Matrix::square(proof, "right_inverse", width, step)?;
    if !left.is_inverse_of(&left_inverse) {
        return Err(Fault::new(step, "\"left\" times \"left_inverse\" is not the identity"));
    }
    if !right.is_inverse_of(&right_inverse) {
        return Err(Fault::new(step, "\"right\" times \"right_inverse\" is not the identity"));
    }
    let factors = list(field(proof, "diagonal", step)?, "\"diagonal\"", step)?;
    let factors =
        factors.iter().map(|factor| integer(factor, "a factor", step)).collect::<Result<Vec<IBig>, _>>()?;
    if factors.len() > rows.min(width) || factors.iter().any(|factor| *factor <= IBig::ZERO) {
        return Err(Fault::new(step, "\"diagonal\" has too many factors, or one that is not positive"));
    }
    if factors.windows(2).any(|pair| &pair[1] % &pair[0] != IBig::ZERO) {
        return Err(Fault::new(step, "a factor of \"diagonal\" does not divide the next"));
    }
    // M V = U^-1 D, column by column.
    for (j, column) in right.columns.iter().enumerate() {
        let scaled = match factors.get(j) {
            Some(factor) => {
                left_inverse.columns[j].iter().map(|(row, entry)| (*row, entry * factor)).collect()
            }
            None => BTreeMap::new(),
        };
        if matrix.times(column) != scaled {
            return Err(Fault::new(step, format!("the transforms do not make column {j} diagonal")));
        }
    }
    Ok(factors)
}
