//! A checker of the certificates of congruences. It shares no code with what computed them: complexes and points are those that [`coface_check`] reads,
//! and it looks for near points by itself.
//!
//! A certificate has the class of each vertex, the image of each cell in the complex of the classes, and the boundaries there. [`check`] tests the
//! classes against the tolerance, and that the images are a chain map onto a complex without two cells of one boundary. `docs/certificates.md` has each
//! rule and why it proves the claim. Certificates of other kinds are handed to [`coface_check`].

mod near;
mod quotient;

use coface_check::json::{field, index, list, optional, text};
use coface_check::{Complex, Fault, Surface, Verdict};
use quotient::Quotient;
use serde_json::Value;

const PROVED: [&str; 7] = [
    "inputs",
    "f_vector_before",
    "f_vector",
    "euler_characteristic",
    "classes",
    "discarded",
    "products_zero",
];

/// Checks a certificate of a congruence, or of what [`coface_check`] knows, against the bytes of its inputs, in their order.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// Near-linear in the incidences where not many vertices are within the tolerance of one; certificates of other kinds as [`coface_check::check`].
///
/// # Examples
/// Two edges whose ends are 0.001 apart become one path.
/// ```
/// let input = b"v 0 0 0\nv 1 0 0\nv 1.001 0 0\nv 2 0 0\nl 1 2\nl 3 4\n";
/// let hash = coface_check::sha256(input);
/// let certificate = |tolerance: f64| format!(
///     r#"{{"coface_certificate":1,"kind":"congruence","inputs":[{{"name":"a.obj","sha256":"{hash}"}}],"rule":"transitive",
///         "answer":{{"inputs":[{{"file":"a.obj","f_vector":[4,2]}}],"tolerance":{tolerance},"f_vector_before":[4,2],"f_vector":[3,2],
///             "euler_characteristic":1,"classes":[3,2],"discarded":[0,0],"products_zero":true,"remarks":[]}},
///         "proof":{{"images":[[[[0,1]],[[1,1]],[[1,1]],[[2,1]]],[[[0,1]],[[1,1]]]],"boundaries":[[[[0,-1],[1,1]],[[1,-1],[2,1]]]]}}}}"#
/// );
/// let verdict = coface_check_congruence::check(certificate(0.01).as_bytes(), &[input]).expect("the path");
/// assert_eq!(verdict.proved()[1], "cells become those of a complex with the f-vector [3, 2] by a chain map onto it");
/// // The ends are farther than that apart.
/// assert!(coface_check_congruence::check(certificate(0.0001).as_bytes(), &[input]).is_err());
/// ```
pub fn check(certificate: &[u8], inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    check_opened(&coface_check::opened(certificate, inputs)?, inputs)
}

/// The same for a certificate that [`coface_check::opened`] gave for these inputs.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// That of [`check`].
///
/// # Examples
/// See [`check`].
pub fn check_opened(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    match text(field(whole, "kind", "certificate")?, "\"kind\"", "certificate")? {
        "congruence" => congruence(whole, inputs),
        _ => coface_check::check_opened(whole, inputs),
    }
}

fn congruence(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let sum = Sum::read(inputs)?;
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let quotient = Quotient::read(&sum, proof)?;
    let mut known = Vec::new();
    let mut proved = Vec::new();
    let counted = |key: &str, expected: &[usize]| match counts(field(answer, key, "answer")?, key)? {
        found if found == expected => Ok(()),
        _ => Err(Fault::new("answer", format!("{key:?} is not {expected:?}"))),
    };
    if let Some(rule) = near::Rule::of(whole)? {
        let tolerance = field(answer, "tolerance", "answer")?.as_f64().filter(|tolerance| *tolerance >= 0.0);
        let tolerance =
            tolerance.ok_or_else(|| Fault::new("answer", "\"tolerance\" is no number from 0 on"))?;
        near::check(&sum.points, &quotient.class_of_vertex(), tolerance, rule)?;
        proved.push(rule.claim(sum.points.len(), quotient.counts()[0], tolerance));
        known.push("tolerance");
    }
    counted("f_vector_before", &sum.counts)?;
    counted("f_vector", quotient.counts())?;
    counted("classes", quotient.counts())?;
    counted("discarded", &quotient.lost_counts())?;
    let files = list(field(answer, "inputs", "answer")?, "\"inputs\"", "answer")?;
    if files.len() != sum.parts.len() {
        return Err(Fault::new("answer", format!("the answer is of {} inputs", files.len())));
    }
    for (file, part) in files.iter().zip(&sum.parts) {
        let own = counts(field(file, "f_vector", "answer")?, "f_vector")?;
        let expected = (0..sum.counts.len()).map(|degree| part.counts().get(degree).copied().unwrap_or(0));
        if file.as_object().is_none_or(|keys| keys.len() != 2 || !keys.contains_key("file"))
            || !expected.eq(own)
        {
            return Err(Fault::new("answer", format!("the f-vector of input {file} is another")));
        }
    }
    let euler: i64 =
        (0..).zip(quotient.counts()).map(|(k, &n)| if k % 2 == 0 { n as i64 } else { -(n as i64) }).sum();
    if field(answer, "euler_characteristic", "answer")?.as_i64() != Some(euler) {
        return Err(Fault::new("answer", format!("the Euler characteristic is {euler}")));
    }
    if optional(answer, "products_zero") != Some(&Value::Bool(true)) {
        return Err(Fault::new("answer", "boundaries of boundaries are zero"));
    }
    let [before, after, lost] = [&sum.counts[..], quotient.counts(), &quotient.lost_counts()];
    proved
        .push(format!("cells become those of a complex with the f-vector {after:?} by a chain map onto it"));
    proved.push(format!("of {before:?} cells {lost:?} become zero"));
    proved.push("boundaries of boundaries are zero".to_owned());
    proved.push(
        "no two classes of cells have one boundary, up to sign, and none has the boundary zero".to_owned(),
    );
    proved.push(format!("Euler characteristic = {euler}"));
    known.extend(PROVED);
    Ok(Verdict::of(proved, answer, &known))
}

fn counts(value: &Value, key: &str) -> Result<Vec<usize>, Fault> {
    let numbers = list(value, key, "answer")?.iter();
    numbers.map(|number| Ok(index(number, key, "answer")? as usize)).collect()
}

/// The complexes of all inputs as one: cells are numbered one input after the other.
struct Sum {
    parts: Vec<Complex>,
    counts: Vec<usize>,
    points: Vec<[f64; 3]>,
}

impl Sum {
    fn read(inputs: &[&[u8]]) -> Result<Self, Fault> {
        let mut sum = Self { parts: Vec::new(), counts: Vec::new(), points: Vec::new() };
        for bytes in inputs {
            let surface = Surface::read(bytes)?;
            let part = Complex::read(bytes)?;
            if part.counts()[0] != surface.points.len()
                || surface.points.iter().flatten().any(|x| !x.is_finite())
            {
                return Err(Fault::new("input", "not a point with three coordinates for each vertex"));
            }
            let degrees = sum.counts.len().max(part.counts().len());
            sum.counts.resize(degrees, 0);
            sum.counts.iter_mut().zip(part.counts()).for_each(|(sum, count)| *sum += count);
            sum.points.extend(surface.points);
            sum.parts.push(part);
        }
        Ok(sum)
    }

    /// The boundaries of all cells of a degree.
    fn boundaries(&self, degree: usize) -> impl Iterator<Item = Vec<(u32, i64)>> + '_ {
        let count = move |part: &Complex, degree: usize| part.counts().get(degree).copied().unwrap_or(0);
        let starts = self.parts.iter().scan(0, move |start, part| {
            *start += count(part, degree - 1);
            Some(*start - count(part, degree - 1))
        });
        self.parts.iter().zip(starts).flat_map(move |(part, start)| {
            (0..count(part, degree)).map(move |cell| {
                part.boundary(degree, cell)
                    .iter()
                    .map(|&(face, entry)| (face + start as u32, entry))
                    .collect()
            })
        })
    }
}
