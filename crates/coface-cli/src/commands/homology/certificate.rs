//! Certificates of homology: the proof that `coface check` follows. What is found here is checked before it is written.

use crate::failure::Failure;
use crate::output::write_file;
use coface::algebra::chains::{ChainComplex, MorseComplex};
use coface::algebra::{Integer, SparseMatrix, WideMatrix, smith_form_with_transforms};
use coface::answers::answer::HomologyAnswer;
use serde_json::{Value, json};
use std::path::Path;

/// Proves the groups of an answer about the file `input`, and writes the certificate to `place`.
pub(super) fn save(
    place: &Path,
    input: &Path,
    reduced: bool,
    answer: &HomologyAnswer,
) -> Result<(), Failure> {
    let name = input.display();
    let bytes = std::fs::read(input).map_err(|error| {
        Failure::new(format!("{name}: cannot be read again for the certificate: {error}"))
    })?;
    let refused = |what: String| {
        Failure::new(format!(
            "{name}: no certificate: {what}; leave --certificate out, or give a facet list, a chain complex, or a \
             surface as plain OFF or OBJ"
        ))
    };
    // The order of cells is the checker's own, so that nothing about cells has to be translated.
    let complex = coface_check::Complex::read(&bytes).map_err(|fault| refused(fault.to_string()))?;
    let certificate = json!({
        "coface_certificate": coface_check::VERSION,
        "coface": env!("CARGO_PKG_VERSION"),
        "kind": "homology",
        "input": {"sha256": coface_check::sha256(&bytes)},
        "reduced": reduced,
        "answer": answer,
        "proof": proof(&chain_complex(&complex)?, complex.counts()),
    });
    let text = certificate.to_string() + "\n";
    coface_check::check(text.as_bytes(), &bytes).map_err(|fault| refused(fault.to_string()))?;
    write_file(place, text.as_bytes())
}

fn chain_complex(complex: &coface_check::Complex) -> Result<ChainComplex, Failure> {
    let counts = complex.counts();
    if let [points] = counts {
        return Ok(ChainComplex::of_points(*points));
    }
    let boundaries = (1..counts.len()).map(|degree| {
        let column = |cell| {
            let entries = complex.boundary(degree, cell).iter();
            entries.map(move |(face, incidence)| (*face as usize, cell, *incidence))
        };
        SparseMatrix::from_entries(counts[degree - 1], counts[degree], (0..counts[degree]).flat_map(column))
    });
    Ok(ChainComplex::new(boundaries.collect::<Result<_, _>>()?)?)
}

fn proof(complex: &ChainComplex, counts: &[usize]) -> Value {
    let morse = MorseComplex::new(complex);
    let matching = morse.matching();
    let (mut pairs, mut forms) = (Vec::new(), Vec::new());
    for degree in 1..counts.len() {
        let listed = matching.pairs(complex, degree).iter();
        pairs.push(listed.map(|pair| [pair.face().index(), pair.cell().index()]).collect::<Vec<_>>());
        let boundary = morse.boundary_matrix(degree);
        forms.push(match boundary.entry_count() {
            0 => Value::Null,
            _ => normal_form(&boundary),
        });
    }
    json!({"cells": counts, "pairs": pairs, "smith": forms})
}

fn normal_form(matrix: &WideMatrix) -> Value {
    let smith = smith_form_with_transforms(matrix);
    json!({
        "diagonal": smith.form().diagonal().iter().map(number).collect::<Vec<_>>(),
        "left": columns(smith.left()),
        "left_inverse": columns(smith.left_inverse()),
        "right": columns(smith.right()),
        "right_inverse": columns(smith.right_inverse()),
    })
}

/// The columns of a matrix as lists of a row and a value.
fn columns(matrix: &WideMatrix) -> Value {
    let entries = |j| {
        let column = matrix.column(j);
        let entries = column.rows().iter().zip(column.entries());
        entries.map(|(row, entry)| json!([row, number(entry)])).collect::<Value>()
    };
    (0..matrix.column_count()).map(entries).collect()
}

fn number(entry: &Integer) -> Value {
    entry.to_i64().map_or_else(|| entry.to_string().into(), Value::from)
}
