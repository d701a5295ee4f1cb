//! Certificates of homology: the proof that `coface check` follows. What is found here is checked before it is given.

use super::FoundHomology;
use crate::answer::{ChainTerm, HomologyAnswer};
use coface_algebra::chains::{ChainComplex, MorseComplex};
use coface_algebra::{Error, ErrorKind, Integer, SparseMatrix, WideMatrix, smith_form_with_transforms};
use coface_topology::{Coefficients, homology};
use serde::Serialize;

/// A certificate, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<A> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    reduced: bool,
    relative: Option<&'static str>,
    answer: A,
    proof: Proof,
}

#[derive(Serialize)]
pub(crate) struct Input {
    name: String,
    sha256: String,
}

impl Input {
    /// The inputs of a certificate by their names and bytes.
    pub(crate) fn list(inputs: &[(&str, &[u8])]) -> Vec<Self> {
        let one = |(name, bytes): &(&str, &[u8])| Self {
            name: (*name).to_owned(),
            sha256: coface_check::sha256(bytes),
        };
        inputs.iter().map(one).collect()
    }
}

#[derive(Serialize)]
pub(crate) struct Proof {
    cells: Vec<usize>,
    /// For each degree from 1 on the faces and cells of the matching, in an order of elimination.
    pairs: Vec<Vec<[usize; 2]>>,
    /// For each degree from 1 on the normal form of the Morse boundary; `None` where that is zero.
    smith: Vec<Option<NormalForm>>,
    /// For each degree what tells the generators apart.
    #[serde(skip_serializing_if = "Option::is_none")]
    duals: Option<Vec<Vec<Vec<ChainTerm>>>>,
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
pub(crate) enum Number {
    Short(i64),
    Digits(String),
}

impl FoundHomology {
    /// A certificate of the groups and their generators, for the name and the bytes of the file that the model was read from, and those
    /// of the part that it is relative to: an answer with a proof that [`coface_check::check`] follows without any code of this library, as
    /// `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] if the checker does not read a file as this library does: it reads facet lists, boundary matrices, and
    /// plain OFF and OBJ. [`ErrorKind::InvalidInput`] if there are generators and the request was not
    /// [`certified`](crate::HomologyRequest::certified).
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
    /// let certificate = HomologyRequest::new().found("rim.json", rim)?.certificate(&[("rim.json", input)])?;
    /// let verdict = coface_check::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved(), ["H_0 = Z", "H_1 = Z"]);
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        if self.answer.generators.is_some() && self.duals.is_none() {
            return Err(Error::invalid("the request did not ask for what proves generators")
                .with_cure("ask with HomologyRequest::certified(true)"));
        }
        let refuse = |fault: coface_check::Fault| refused(&fault.to_string());
        let bytes: Vec<&[u8]> = inputs.iter().map(|(_, bytes)| *bytes).collect();
        // The order of cells is the checker's own, so that nothing about matchings has to be translated.
        let whole = bytes.first().ok_or_else(|| Error::invalid("a certificate needs its input"))?;
        let mut complex = coface_check::Complex::read(whole).map_err(refuse)?;
        if self.relative.is_some() {
            complex = complex.relative(bytes.get(1).copied()).map_err(refuse)?;
        }
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "homology",
            inputs: Input::list(inputs),
            reduced: self.is_reduced,
            relative: self.relative,
            answer: &self.answer,
            proof: Proof { duals: self.duals.clone(), ..Proof::of(&complex)? },
        };
        checked(&certificate, inputs).map_err(refuse)
    }
}

/// A certificate of the integral homology groups of a file, which stands inside of another one.
pub(crate) fn of_groups(inputs: &[(&str, &[u8])]) -> Result<impl Serialize + use<>, Error> {
    let (name, bytes) = inputs.first().ok_or_else(|| Error::invalid("a certificate needs its input"))?;
    let complex = coface_check::Complex::read(bytes).map_err(|fault| refused(&fault.to_string()))?;
    let groups = homology(&chain_complex(&complex)?);
    let answer = HomologyAnswer::of(name, Coefficients::Integers, false, groups.groups());
    Ok(Certificate {
        coface_certificate: coface_check::VERSION,
        coface: env!("CARGO_PKG_VERSION"),
        kind: "homology",
        inputs: Input::list(inputs),
        reduced: false,
        relative: None,
        answer,
        proof: Proof::of(&complex)?,
    })
}

/// A certificate as text, after the checker has accepted it.
pub(crate) fn checked(
    certificate: &impl Serialize,
    inputs: &[(&str, &[u8])],
) -> Result<String, coface_check::Fault> {
    let text = crate::answer::to_json(certificate) + "\n";
    let bytes: Vec<&[u8]> = inputs.iter().map(|(_, bytes)| *bytes).collect();
    coface_check_walks::check(text.as_bytes(), &bytes)?;
    Ok(text)
}

pub(crate) fn refused(why: &str) -> Error {
    Error::new(
        ErrorKind::UnsupportedFormat,
        format!(
            "no certificate: {why}; leave --certificate out, or give a facet list, a chain complex, or a surface as plain \
             OFF or OBJ"
        ),
    )
}

pub(crate) fn chain_complex(complex: &coface_check::Complex) -> Result<ChainComplex, Error> {
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

impl Proof {
    /// The pairs and the normal forms that prove the homology groups.
    pub(crate) fn of(complex: &coface_check::Complex) -> Result<Self, Error> {
        let counts = complex.counts();
        let complex = &chain_complex(complex)?;
        let morse = MorseComplex::new(complex);
        let matching = morse.matching();
        let (mut pairs, mut smith) = (Vec::new(), Vec::new());
        for degree in 1..counts.len() {
            let listed = matching.pairs(complex, degree).iter();
            pairs.push(listed.map(|pair| [pair.face().index(), pair.cell().index()]).collect());
            let boundary = morse.boundary_matrix(degree);
            smith.push((boundary.entry_count() > 0).then(|| normal_form(&boundary)));
        }
        Ok(Self { cells: counts.to_vec(), pairs, smith, duals: None })
    }
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

pub(crate) fn number(entry: &Integer) -> Number {
    entry.to_i64().map_or_else(|| Number::Digits(entry.to_string()), Number::Short)
}
