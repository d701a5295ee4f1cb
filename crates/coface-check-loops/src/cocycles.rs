//! Certificates of bases of the first cohomology.

use coface_check::claims::{Claims, count};
use coface_check::json::{field, index, integer, list, optional};
use coface_check::{Complex, Fault, Verdict};
use dashu_int::IBig;
use dashu_int::ops::BitTest;
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashMap};

/// Numbers in an elimination have at most so many bits.
const MOST_BITS: usize = 4096;

/// Checks a certificate of cocycles.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let complex = Complex::read(inputs[0])?;
    let answer = field(whole, "answer", "answer")?;
    let rank = rank(whole, inputs)?;
    let edges = Edges::of(&complex)?;
    let step = "cocycles";
    let cocycles = list(field(answer, "cocycles", step)?, "\"cocycles\"", step)?;
    let cocycles = cocycles.iter().map(|terms| edges.chain(terms, step)).collect::<Result<Vec<_>, _>>()?;
    if cocycles.len() != rank {
        let message = format!("{} cocycles are there, and the rank is {rank}", cocycles.len());
        return Err(Fault::new(step, message));
    }
    let faces = faces_of_edges(&complex);
    for (i, cocycle) in cocycles.iter().enumerate() {
        let mut sums: BTreeMap<u32, IBig> = BTreeMap::new();
        for (edge, value) in cocycle {
            for (face, incidence) in faces.get(*edge as usize).into_iter().flatten() {
                *sums.entry(*face).or_default() += value * IBig::from(*incidence);
            }
        }
        if let Some((face, sum)) = sums.iter().find(|(_, sum)| **sum != IBig::ZERO) {
            return Err(Fault::new(step, format!("the sum of cocycle {i} around face {face} is {sum}")));
        }
    }
    let loops = list(field(answer, "loops", "loops")?, "\"loops\"", "loops")?;
    let loops = loops.iter().map(|one| edges.cycle(one, &complex)).collect::<Result<Vec<_>, _>>()?;
    let value = |cocycle: &BTreeMap<u32, IBig>, cycle: &BTreeMap<u32, IBig>| {
        let terms = cycle.iter().filter_map(|(edge, times)| Some(cocycle.get(edge)? * times));
        terms.fold(IBig::ZERO, |sum, term| sum + term)
    };
    let pairing: Vec<Vec<IBig>> =
        cocycles.iter().map(|cocycle| loops.iter().map(|cycle| value(cocycle, cycle)).collect()).collect();
    let said = list(field(answer, "pairing", "pairing")?, "\"pairing\"", "pairing")?;
    let row = |row: &Value| -> Result<Vec<IBig>, Fault> {
        list(row, "a row", "pairing")?.iter().map(|entry| integer(entry, "a value", "pairing")).collect()
    };
    if said.iter().map(row).collect::<Result<Vec<_>, _>>()? != pairing {
        return Err(Fault::new("pairing", "the values of the cocycles on the loops are others"));
    }
    let is_negative = determinant_if_onto(pairing, loops.len())?;
    let mut claims = Claims::of(answer);
    claims.prove(format!("the first cohomology over Z has rank {rank}"));
    claims.equal("rank", &json!(rank))?;
    claims.prove(format!(
        "{}, closed, whose values on {} are the pairing",
        count(rank, "cocycle", "cocycles"),
        count(loops.len(), "closed loop", "closed loops")
    ));
    claims.prove("the classes of the cocycles are a basis of the first cohomology over Z".to_owned());
    if optional(answer, "determinant").is_some() {
        let sign = if is_negative { -1 } else { 1 };
        claims.equal("determinant", &if loops.len() == rank { json!(sign) } else { Value::Null })?;
    }
    claims.know(&["file", "cocycles", "loops", "pairing"]);
    Ok(claims.verdict())
}

/// For each edge the faces that have it, with their incidences.
fn faces_of_edges(complex: &Complex) -> Vec<Vec<(u32, i64)>> {
    let counts = complex.counts();
    let mut faces = vec![Vec::new(); counts.get(1).copied().unwrap_or(0)];
    for face in 0..counts.get(2).copied().unwrap_or(0) {
        for &(edge, incidence) in complex.boundary(2, face) {
            faces[edge as usize].push((face as u32, incidence));
        }
    }
    faces
}

/// The rank of the first cohomology: that of the first homology, which a certificate inside of this one proves.
fn rank(whole: &Value, inputs: &[&[u8]]) -> Result<usize, Fault> {
    let inner = field(whole, "homology", "homology")?;
    let refuse = |message: &str| Fault::new("homology", message);
    let is_plain = inner["kind"] == json!("homology")
        && inner["reduced"] == json!(false)
        && inner["relative"].is_null()
        && inner["answer"]["coefficients"] == json!("Z")
        && inner["answer"]["cohomology"] == json!(false);
    if !is_plain {
        return Err(refuse("it is no certificate of homology over Z"));
    }
    coface_check::check(inner.to_string().as_bytes(), inputs)?;
    let groups = list(&inner["answer"]["homology"], "\"homology\"", "homology")?;
    match groups.get(1) {
        None => Ok(0),
        Some(group) => Ok(index(field(group, "betti", "homology")?, "\"betti\"", "homology")? as usize),
    }
}

/// The edges of a complex by their vertices, with the direction of the complex or against it.
struct Edges(HashMap<[u32; 2], (u32, bool)>);

impl Edges {
    fn of(complex: &Complex) -> Result<Self, Fault> {
        let count = complex.counts().get(1).copied().unwrap_or(0);
        let mut edges = HashMap::new();
        for edge in 0..count {
            let number = edge as u32;
            match complex.vertices(1, edge) {
                Some(&[a, b]) => {
                    edges.insert([a, b], (number, true));
                    edges.insert([b, a], (number, false));
                }
                _ => return Err(Fault::new("input", "an edge has not two vertices")),
            }
        }
        Ok(Self(edges))
    }

    /// Terms of a coefficient and an edge, added where they are of one edge.
    fn chain(&self, terms: &Value, step: &str) -> Result<BTreeMap<u32, IBig>, Fault> {
        let mut chain: BTreeMap<u32, IBig> = BTreeMap::new();
        for term in list(terms, "a chain", step)? {
            let [value, cell] = list(term, "a term", step)? else {
                return Err(Fault::new(step, "a term is not a value and an edge"));
            };
            let value = integer(value, "a value", step)?;
            let cell = crate::cut::vertices(cell, "an edge", step)?;
            self.add(&mut chain, &cell, value, step)?;
        }
        Ok(chain)
    }

    fn add(
        &self,
        chain: &mut BTreeMap<u32, IBig>,
        cell: &[u32],
        value: IBig,
        step: &str,
    ) -> Result<(), Fault> {
        let (edge, is_along) = <&[u32; 2]>::try_from(cell)
            .ok()
            .and_then(|cell| self.0.get(cell))
            .ok_or_else(|| Fault::new(step, format!("there is no edge {cell:?}")))?;
        *chain.entry(*edge).or_default() += if *is_along { value } else { -value };
        Ok(())
    }

    /// A closed walk through vertices, or a chain whose boundary is zero.
    fn cycle(&self, given: &Value, complex: &Complex) -> Result<BTreeMap<u32, IBig>, Fault> {
        let step = "loops";
        let items = list(given, "a loop", step)?;
        let mut chain = BTreeMap::new();
        if items.iter().all(Value::is_u64) {
            let walk = crate::cut::vertices(given, "a loop", step)?;
            for pair in walk.windows(2) {
                self.add(&mut chain, pair, IBig::ONE, step)?;
            }
        } else {
            chain = self.chain(given, step)?;
        }
        let mut boundary: BTreeMap<u32, IBig> = BTreeMap::new();
        for (edge, times) in &chain {
            for (vertex, incidence) in complex.boundary(1, *edge as usize) {
                *boundary.entry(*vertex).or_default() += times * IBig::from(*incidence);
            }
        }
        match boundary.values().all(|value| *value == IBig::ZERO) {
            true => Ok(chain),
            false => Err(Fault::new(step, "a loop is not closed")),
        }
    }
}

/// Whether the determinant is -1, of a matrix whose columns generate all columns of its length; a fault if they do not. Columns are added to
/// each other until the matrix is triangular (C. Hermite, 1851); then it is so if all entries on the diagonal are 1 or -1.
fn determinant_if_onto(mut rows: Vec<Vec<IBig>>, width: usize) -> Result<bool, Fault> {
    let step = "pairing";
    let mut is_negative = false;
    for row in 0..rows.len() {
        loop {
            let entries = (row..width).filter(|&j| rows[row][j] != IBig::ZERO);
            let least = |j: &usize| {
                let entry = &rows[row][*j];
                if *entry < IBig::ZERO { -entry } else { entry.clone() }
            };
            let Some(least) = entries.min_by_key(least) else {
                return Err(Fault::new(step, "the cocycles are no basis: the pairing is degenerate"));
            };
            if least != row {
                rows.iter_mut().for_each(|entries| entries.swap(least, row));
                is_negative = !is_negative;
            }
            let others: Vec<usize> = (row + 1..width).filter(|&j| rows[row][j] != IBig::ZERO).collect();
            if others.is_empty() {
                break;
            }
            for j in others {
                let times = &rows[row][j] / &rows[row][row];
                for entries in &mut rows[row..] {
                    let less = &times * &entries[row];
                    entries[j] -= less;
                    if entries[j].bit_len() > MOST_BITS {
                        return Err(Fault::new(step, "the numbers of an elimination are too large"));
                    }
                }
            }
        }
        match &rows[row][row] {
            entry if *entry == IBig::ONE => {}
            entry if *entry == -IBig::ONE => is_negative = !is_negative,
            entry => {
                return Err(Fault::new(
                    step,
                    format!("the cocycles are no basis: a factor of the pairing is {entry}"),
                ));
            }
        }
    }
    Ok(is_negative)
}

#[cfg(test)]
mod tests {
    use super::determinant_if_onto;
    use dashu_int::IBig;

    #[test]
    fn columns_that_generate_all_are_told_from_others() {
        let rows =
            |rows: &[&[i64]]| rows.iter().map(|row| row.iter().map(|n| IBig::from(*n)).collect()).collect();
        assert_eq!(determinant_if_onto(rows(&[&[1, 0], &[0, 1]]), 2), Ok(false));
        assert_eq!(determinant_if_onto(rows(&[&[0, 1], &[1, 5]]), 2), Ok(true));
        assert!(determinant_if_onto(rows(&[&[2, 3]]), 2).is_ok());
        assert_eq!(determinant_if_onto(rows(&[&[7, 5], &[4, 3]]), 2), Ok(false));
        assert_eq!(determinant_if_onto(Vec::new(), 0), Ok(false));
        for singular in [&[&[2, 4][..]][..], &[&[1, 2], &[2, 4]], &[&[1, 0], &[0, 2]], &[&[0, 0]]] {
            assert!(determinant_if_onto(rows(singular), 2).is_err());
        }
    }
}
