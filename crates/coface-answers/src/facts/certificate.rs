//! Certificates of reports.

use crate::answer::InfoAnswer;
use crate::homology::certificate::{Input, Proof, checked, refused};
use coface_algebra::Error;
use coface_complexes::simplicial::{SimplicialComplex, SphereCertificate, recognize_ball, recognize_sphere};
use serde::Serialize;
use std::collections::BTreeMap;

/// A certificate of a report, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    answer: &'a InfoAnswer,
    proof: ReportProof,
}

#[derive(Serialize)]
struct ReportProof {
    #[serde(flatten)]
    homology: Proof,
    /// The bistellar moves of the link of each vertex of a manifold above dimension 3, by rising vertices.
    #[serde(skip_serializing_if = "Option::is_none")]
    links: Option<Vec<LinkMoves>>,
}

/// Moves from a link, with the cone over its boundary if that has an apex, to the boundary of a simplex.
#[derive(Serialize)]
struct LinkMoves {
    #[serde(skip_serializing_if = "Option::is_none")]
    apex: Option<u32>,
    moves: Vec<[Vec<u32>; 2]>,
}

impl LinkMoves {
    fn of(found: &SphereCertificate) -> Self {
        let moves =
            found.moves().iter().map(|one| [one.removed(), one.added()].map(|face| face.numbers().to_vec()));
        Self { apex: found.apex(), moves: moves.collect() }
    }
}

/// So many moves are tried on a link, and more on a large one.
const LINK_MOVES: usize = 10_000;

/// The moves of all links of vertices; `None` where they are not found, or the dimension needs none.
fn links(complex: &coface_check::Complex) -> Result<Option<Vec<LinkMoves>>, Error> {
    let top = complex.counts().len().saturating_sub(1);
    if top < 4 {
        return Ok(None);
    }
    let mut around: BTreeMap<u32, Vec<Vec<u32>>> = BTreeMap::new();
    for cell in 0..complex.counts()[top] {
        let Some(vertices) = complex.vertices(top, cell) else { return Ok(None) };
        for &vertex in vertices {
            let others = vertices.iter().copied().filter(|&other| other != vertex).collect();
            around.entry(vertex).or_default().push(others);
        }
    }
    let mut found = Vec::with_capacity(around.len());
    for facets in around.values() {
        let link = SimplicialComplex::from_facets(facets)?;
        let budget = LINK_MOVES + 20 * facets.len();
        // A link with a boundary is refused by the search for spheres.
        let moves = match recognize_sphere(&link, budget) {
            Ok(moves) => moves,
            Err(_) => recognize_ball(&link, budget)?,
        };
        match moves {
            Some(moves) => found.push(LinkMoves::of(&moves)),
            None => return Ok(None),
        }
    }
    Ok(Some(found))
}

impl InfoAnswer {
    /// A certificate of the report on a file, from the name and the bytes of the file: the counts, components, Euler characteristic, and
    /// whether the model is a manifold, above dimension 3 where bistellar moves show it; whether it is orientable, its boundary loops and genus; and its homology.
    /// [`coface_check::check`] derives them without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, and
    /// plain OFF and OBJ.
    ///
    /// # Complexity
    /// That of homology, and of a Smith form with transforms of what a matching leaves.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Report;
    /// let input = &b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..];
    /// let sphere = Report::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let certificate = sphere.answer(10).of_file("sphere.json", "json").certificate(&[("sphere.json", input)])?;
    /// let verdict = coface_check::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert!(verdict.proved().contains(&"manifold = [\"yes\",true]".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let [(_, bytes)] = inputs else {
            return Err(Error::invalid("a certificate of a report is of one input"));
        };
        let complex = coface_check::Complex::read(bytes).map_err(|fault| refused(&fault.to_string()))?;
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "info",
            inputs: Input::list(inputs),
            answer: self,
            proof: ReportProof {
                homology: Proof::of(&complex)?,
                links: if self.manifold.verdict == "yes" { links(&complex)? } else { None },
            },
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}
