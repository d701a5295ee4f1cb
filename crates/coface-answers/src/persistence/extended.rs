//! Extended persistence of a function on a model.

use super::certificate::{Certificate, Proof, chains, entering, renumbered};
use super::{Growth, PersistenceRequest, VertexFunction};
use crate::Producer;
use crate::answer::{PersistenceAnswer, PersistencePairAnswer};
use crate::homology::certificate::{checked, refused};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error};
use coface_topology::{Coefficients, ExtendedKind, ExtendedPair, extended_filtration, extended_persistence};

impl PersistenceRequest {
    /// Finds the extended persistence of a function on the vertices of a model with this name: pairs have a kind, and all classes die.
    ///
    /// # Errors
    /// Those of [`Producer::chain_complex`], [`VertexFunction::values`] and [`extended_persistence`];
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the model is to grow by superlevel sets or by values of cells, or cycles are asked for.
    ///
    /// # Examples
    /// The boundary of a triangle, by the numbers of its vertices.
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let circle = Producer::of(coface_io::read(&b"[[0,1],[1,2],[2,0]]"[..], coface_io::Format::Json)?)?;
    /// let answer = PersistenceRequest::new().extended("circle", &circle)?;
    /// let (component, circle) = (&answer.diagram[0], &answer.diagram[1]);
    /// assert_eq!((component.kind.as_deref(), component.birth, component.death), (Some("extended+"), 0.0, Some(2.0)));
    /// assert_eq!((circle.kind.as_deref(), circle.birth, circle.death), (Some("extended-"), 2.0, Some(0.0)));
    /// # Ok(()) }
    /// ```
    pub fn extended(&self, name: &str, producer: &Producer) -> Result<PersistenceAnswer, Error> {
        let Growth::Lower(function) = &self.growth else {
            return Err(Error::invalid(
                "extended persistence is of a function on vertices, and has superlevel sets too",
            )
            .with_cure("ask for it without superlevel sets and without values of cells"));
        };
        if self.relative.is_some() || self.image_of.is_some() {
            return Err(Error::invalid("extended persistence is of a whole model")
                .with_cure("ask for it without a part, or write the part as a model of its own"));
        }
        let Coefficients::Modulo(prime) = self.coefficients else {
            return Err(Error::invalid("persistence has a prime field").with_cure("give f2, f3, f5, ..."));
        };
        if function.is_none() {
            producer.require_finite().map_err(|error| error.in_file(name))?;
        }
        let complex = producer.chain_complex()?;
        let function = function.clone().unwrap_or_else(|| VertexFunction::of_positions(producer.positions()));
        let values = function.values(producer, complex.cell_count(0))?;
        let steps = stage("pairing cells", 0);
        let pairs = extended_persistence(&complex, &values, self.coefficients)
            .map_err(|error| error.in_file(name))?;
        drop(steps);
        let mut betti = vec![0; complex.degree_count()];
        for pair in pairs.iter().filter(|pair| is_extended(pair.kind())) {
            betti[pair.degree()] += 1;
        }
        let is_long = |pair: &&ExtendedPair| {
            is_extended(pair.kind()) || (pair.death() - pair.birth()).abs() > self.min_persistence
        };
        let answer = |pair: &ExtendedPair| {
            let vertices = |(degree, cell)| producer.cell_vertices(degree, cell);
            PersistencePairAnswer {
                degree: pair.degree(),
                kind: Some(kind_name(pair.kind()).to_owned()),
                birth: pair.birth(),
                death: Some(pair.death()),
                birth_cell: vertices(pair.birth_cell()),
                death_cell: Some(vertices(pair.death_cell())),
                cycle: None,
                bounding_chain: None,
                cocycle: None,
            }
        };
        Ok(PersistenceAnswer {
            file: name.to_owned(),
            field: prime as u32,
            function: function.name(),
            star: Some("extended".to_owned()),
            threshold: None,
            diagram: pairs.iter().filter(is_long).map(answer).collect(),
            betti,
            torsion_primes: None,
            collapsed: None,
            relative_to: None,
            image_of: None,
            vertex_names: None,
            remarks: Vec::new(),
        })
    }
}

impl PersistenceRequest {
    /// A certificate of [`Self::extended`], from the name and the bytes of the file that the model was read from: chains of the cone that prove it, which
    /// [`coface_check_persistence::check`] follows without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// Those of [`Self::extended`]; [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet
    /// lists, and plain OFF and OBJ.
    ///
    /// # Complexity
    /// That of the cycles of all pairs of the cone, also of those of persistence 0.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let input = &b"[[0,1],[1,2],[2,0]]"[..];
    /// let circle = Producer::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let certificate = PersistenceRequest::new().extended_certificate("circle", &circle, &[("circle", input)])?;
    /// let verdict = coface_check_persistence::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[1], "Betti numbers over F_2 = [1, 1]");
    /// # Ok(()) }
    /// ```
    pub fn extended_certificate(
        &self,
        name: &str,
        producer: &Producer,
        inputs: &[(&str, &[u8])],
    ) -> Result<String, Error> {
        let [(_, bytes)] = inputs else {
            return Err(Error::invalid("a certificate of persistence is of one input"));
        };
        let answer = self.extended(name, producer)?;
        let read = coface_check::Complex::read(bytes).map_err(|fault| refused(&fault.to_string()))?;
        let complex = producer.chain_complex()?;
        let places = producer.places_on(&read, complex.f_vector())?;
        let Growth::Lower(function) = &self.growth else { return Err(refused("there is no function")) };
        let function = function.clone().unwrap_or_else(|| VertexFunction::of_positions(producer.positions()));
        let own = function.values(producer, complex.cell_count(0))?;
        let mut values = vec![0.0; own.len()];
        places[0].iter().zip(&own).for_each(|(&place, &value)| values[place as usize] = value);
        // Cells of one value enter in the order of the library, on which the pairs depend.
        let complex = renumbered(&read, &places)?;
        let (cone, filtration) = extended_filtration(&complex, &own)?;
        let counts = complex.f_vector();
        let place = |degree: usize, cell: CellId| -> u32 {
            let own = counts.get(degree).copied().unwrap_or(0);
            match cell.index().checked_sub(own) {
                None => places[degree][cell.index()],
                Some(over) => {
                    let below = degree.checked_sub(1).map_or(0, |below| places[below][over]);
                    own as u32 + below
                }
            }
        };
        let order: Vec<Vec<u32>> =
            (0..cone.degree_count()).map(|degree| entering(&filtration, degree)).collect();
        let chains = chains(&cone, &filtration, answer.field, &order, place)?;
        let placed = |(degree, order): (usize, Vec<u32>)| {
            order.into_iter().map(|cell| place(degree, CellId::new(cell as usize))).collect()
        };
        let order = order.into_iter().enumerate().map(placed).collect();
        let proof = Proof { values: vec![values], order, chains, of_image: None };
        let certificate = Certificate::new("persistence", inputs, self.min_persistence, &answer, proof);
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}

fn is_extended(kind: ExtendedKind) -> bool {
    matches!(kind, ExtendedKind::ExtendedPlus | ExtendedKind::ExtendedMinus)
}

fn kind_name(kind: ExtendedKind) -> &'static str {
    match kind {
        ExtendedKind::Ordinary => "ordinary",
        ExtendedKind::ExtendedPlus => "extended+",
        ExtendedKind::ExtendedMinus => "extended-",
        ExtendedKind::Relative => "relative",
    }
}
