//! Certificates of homology: the proof that `coface check` follows. What is found here is checked before it is given.

use super::FoundHomology;
use crate::answer::HomologyAnswer;
use coface_algebra::chains::{ChainComplex, MorseComplex};
use coface_algebra::{Error, ErrorKind, Integer, SparseMatrix, WideMatrix, smith_form_with_transforms};
use serde::Serialize;

/// A certificate, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    input: Input,
    reduced: bool,
    answer: &'a HomologyAnswer,
    proof: Proof,
}

#[derive(Serialize)]
struct Input {
    sha256: String,
}

#[derive(Serialize)]
struct Proof {
    cells: Vec<usize>,
    /// For each degree from 1 on the faces and cells of the matching, in an order of elimination.
    pairs: Vec<Vec<[usize; 2]>>,
    /// For each degree from 1 on the normal form of the Morse boundary; `None` where that is zero.
    smith: Vec<Option<NormalForm>>,
}

#[derive(Serialize)]
struct NormalForm {
    diagonal: Vec<Number>,
    left: Columns,
    left_inverse: Columns,
    right: Columns,
    right_inverse: Columns,
}

/// The columns of a matrix as lists of rows and values.
type Columns = Vec<Vec<(u32, Number)>>;

/// An integer; beyond 64 bits its decimal digits.
#[derive(Serialize)]
#[serde(untagged)]
enum Number {
    Short(i64),
    Digits(String),
}

impl FoundHomology {
    /// A certificate of the groups, for the bytes of the file that the model was read from: an answer with a proof that
    /// [`coface_check::check`] follows without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for relative groups, and if the checker does not read the file as this library does: it reads facet
    /// lists, boundary matrices, and plain OFF and OBJ.
    ///
    /// # Complexity
    /// That of the groups, and of a Smith form with transforms of what the matching leaves.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let input = b"[[0,1],[1,2],[0,2]]";
    /// let rim = coface_io::read(&input[..], coface_io::Format::Json)?;
    /// let certificate = HomologyRequest::new().found("rim.json", rim)?.certificate(input)?;
    /// let verdict = coface_check::check(certificate.as_bytes(), input).expect("the proof holds");
    /// assert_eq!(verdict.proved(), ["H_0 = Z", "H_1 = Z"]);
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, input: &[u8]) -> Result<String, Error> {
        if self.is_relative {
            return Err(refused("relative groups have none"));
        }
        // The order of cells is the checker's own, so that nothing about cells has to be translated.
        let complex = coface_check::Complex::read(input).map_err(|fault| refused(&fault.to_string()))?;
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "homology",
            input: Input { sha256: coface_check::sha256(input) },
            reduced: self.is_reduced,
            answer: &self.answer,
            proof: proof(&chain_complex(&complex)?, complex.counts()),
        };
        let text = crate::answer::to_json(&certificate) + "\n";
        coface_check::check(text.as_bytes(), input).map_err(|fault| refused(&fault.to_string()))?;
        Ok(text)
    }
}

fn refused(why: &str) -> Error {
    Error::new(
        ErrorKind::UnsupportedFormat,
        format!(
            "no certificate: {why}; leave --certificate out, or give a facet list, a chain complex, or a surface as plain \
             OFF or OBJ"
        ),
    )
}

fn chain_complex(complex: &coface_check::Complex) -> Result<ChainComplex, Error> {
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
    ChainComplex::new(boundaries.collect::<Result<_, _>>()?)
}

fn proof(complex: &ChainComplex, counts: &[usize]) -> Proof {
    let morse = MorseComplex::new(complex);
    let matching = morse.matching();
    let (mut pairs, mut smith) = (Vec::new(), Vec::new());
    for degree in 1..counts.len() {
        let listed = matching.pairs(complex, degree).iter();
        pairs.push(listed.map(|pair| [pair.face().index(), pair.cell().index()]).collect());
        let boundary = morse.boundary_matrix(degree);
        smith.push((boundary.entry_count() > 0).then(|| normal_form(&boundary)));
    }
    Proof { cells: counts.to_vec(), pairs, smith }
}

fn normal_form(matrix: &WideMatrix) -> NormalForm {
    let smith = smith_form_with_transforms(matrix);
    NormalForm {
        diagonal: smith.form().diagonal().iter().map(number).collect(),
        left: columns(smith.left()),
        left_inverse: columns(smith.left_inverse()),
        right: columns(smith.right()),
        right_inverse: columns(smith.right_inverse()),
    }
}

fn columns(matrix: &WideMatrix) -> Columns {
    let entries = |j| {
        let column = matrix.column(j);
        column.rows().iter().zip(column.entries()).map(|(&row, entry)| (row, number(entry))).collect()
    };
    (0..matrix.column_count()).map(entries).collect()
}

fn number(entry: &Integer) -> Number {
    entry.to_i64().map_or_else(|| Number::Digits(entry.to_string()), Number::Short)
}
