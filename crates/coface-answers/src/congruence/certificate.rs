//! Certificates of congruences.

use super::ModelCongruence;
use crate::answer::CongruenceAnswer;
use crate::homology::certificate::{Input, checked, refused};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error};
use coface_arrange::congruence::{ClassRule, Representative};
use serde::Serialize;

/// A certificate of a congruence, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    /// How the tolerance makes classes: `transitive`, `greedy`, or `stable` where they are merged again.
    rule: &'static str,
    answer: &'a CongruenceAnswer,
    proof: Proof,
}

/// A chain: cells with their entries, rising.
type Chain = Vec<(u32, i32)>;

#[derive(Serialize)]
struct Proof {
    /// For each degree the image of each cell, in the numbers of the checker.
    images: Vec<Vec<Chain>>,
    /// For each degree from 1 on the boundary of each class.
    boundaries: Vec<Vec<Chain>>,
}

impl ModelCongruence {
    /// A certificate of the congruence, for the names and the bytes of the files that the models were read from: the image of each cell and the boundaries
    /// of the classes, which [`coface_check_walks::check`] follows without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// Classes that were merged again ([`CongruenceRequest::stable`](super::CongruenceRequest::stable)) are not tested against the tolerance, which the
    /// checker then lists as unchecked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read a file as this library does: it reads surfaces as plain OFF and OBJ.
    ///
    /// # Complexity
    /// Near-linear in the incidences.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// use coface_io::Format;
    /// let text = &b"v 0 0 0\nv 1 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\nl 3 4\n"[..];
    /// let models = vec![("path.obj".to_owned(), coface_io::read(text, Format::Obj)?)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.0))?;
    /// let certificate = merged.certificate(&[("path.obj", text)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[text]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[1], "cells become those of a complex with the f-vector [3, 2] by a chain map onto it");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        if inputs.len() != self.producers.len() {
            return Err(Error::invalid("a certificate of a congruence is of all its models"));
        }
        let mut degrees = 1;
        let mut images: Vec<Vec<Chain>> =
            self.f_vector_before().iter().map(|&count| vec![Chain::new(); count]).collect();
        for (model, (producer, (name, bytes))) in self.producers.iter().zip(inputs).enumerate() {
            let refusal = |why: &str| refused(why).in_file(*name);
            let read = coface_check::Complex::read(bytes).map_err(|fault| refusal(&fault.to_string()))?;
            let own = producer.chain_complex()?;
            let places = producer.places_on(&read, own.f_vector()).map_err(|error| error.in_file(*name))?;
            let signs = signs(&own, &read, &places);
            let signs =
                signs.ok_or_else(|| refusal("the checker reads other boundaries than the library"))?;
            degrees = degrees.max(places.len());
            for (degree, (places, signs)) in places.iter().zip(&signs).enumerate() {
                let start = self.starts[degree][model];
                for (cell, (&place, sign)) in places.iter().zip(signs).enumerate() {
                    let image = self.chains().classes()[degree].image(CellId::new(start + cell));
                    let mut image: Chain =
                        image.map(|(class, own)| (class as u32, sign * own.to_i32())).collect();
                    image.sort_unstable();
                    images[degree][start + place as usize] = image;
                }
            }
        }
        images.truncate(degrees);
        let boundary = |degree: usize| -> Vec<Chain> {
            let columns =
                self.complex().boundary_matrix(degree).into_iter().flat_map(|matrix| matrix.columns());
            columns.map(|column| column.iter().map(|(row, entry)| (row as u32, entry)).collect()).collect()
        };
        let request = &self.request;
        let rule = match request.rule {
            _ if request.stable && request.representative != Representative::Lowest => "stable",
            ClassRule::Transitive => "transitive",
            ClassRule::Greedy => "greedy",
        };
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "congruence",
            inputs: Input::list(inputs),
            rule,
            answer: &self.answer()?,
            proof: Proof { images, boundaries: (1..degrees).map(boundary).collect() },
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}

/// For each cell 1 or -1: whether the checker orients it as the library does. `None` if boundaries differ by more than that.
fn signs(own: &ChainComplex, read: &coface_check::Complex, places: &[Vec<u32>]) -> Option<Vec<Vec<i32>>> {
    let mut signs = vec![vec![1; places[0].len()]];
    for degree in 1..places.len() {
        let matrix = own.boundary_matrix(degree);
        let below: &Vec<i32> = &signs[degree - 1];
        let sign = |(cell, &place): (usize, &u32)| {
            let faces = matrix.into_iter().flat_map(|matrix| matrix.column(cell).iter());
            let there = faces.map(|(face, entry)| (places[degree - 1][face], i64::from(entry * below[face])));
            let mut there: Vec<(u32, i64)> = there.collect();
            there.sort_unstable();
            let mut theirs = read.boundary(degree, place as usize).to_vec();
            theirs.sort_unstable();
            if there == theirs {
                return Some(1);
            }
            theirs.iter_mut().for_each(|(_, entry)| *entry = -*entry);
            (there == theirs).then_some(-1)
        };
        let of_degree = places[degree].iter().enumerate().map(sign).collect::<Option<Vec<i32>>>()?;
        signs.push(of_degree);
    }
    Some(signs)
}
