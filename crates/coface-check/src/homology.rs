//! Certificates of homology and cohomology groups.

use crate::groups::{Group, Ring, integral};
use crate::json::{field, integer, list, text, truth};
use crate::matching::Morse;
use crate::smith::diagonal;
use crate::{Complex, Fault, Verdict};
use serde_json::Value;

/// The keys of an answer that the groups are made of; `file` is the name that the input had.
const PROVED: [&str; 4] = ["coefficients", "cohomology", "homology", "file"];

pub(crate) fn check(certificate: &Value, complex: &Complex) -> Result<Verdict, Fault> {
    let (answer, proof) =
        (field(certificate, "answer", "certificate")?, field(certificate, "proof", "certificate")?);
    let step = "cells";
    let cells = list(field(proof, "cells", step)?, "\"cells\"", step)?;
    let same = complex.counts().iter().map(|count| Some(*count as u64));
    if !cells.iter().map(Value::as_u64).eq(same) {
        return Err(Fault::new(
            step,
            format!("the input has {:?} cells, the certificate others", complex.counts()),
        ));
    }
    let morse = Morse::new(complex, field(proof, "pairs", "matching")?)?;
    let forms = list(field(proof, "smith", "smith")?, "\"smith\"", "smith")?;
    if forms.len() != morse.boundaries.len() {
        return Err(Fault::new("smith", format!("there are normal forms of {} degrees", forms.len())));
    }
    let mut factors = Vec::new();
    for (k, (matrix, form)) in morse.boundaries.iter().zip(forms).enumerate() {
        factors.push(diagonal(matrix, form, &format!("smith of degree {}", k + 1))?);
    }
    let mut groups = integral(&morse.counts, &factors, "groups")?;
    let reduced = truth(field(certificate, "reduced", "certificate")?, "\"reduced\"", "certificate")?;
    if reduced {
        if !complex.is_augmented() {
            return Err(Fault::new("groups", "reduced groups need cells with vertices"));
        }
        let betti = groups.first_mut().map(|group| &mut group.betti).filter(|betti| **betti > 0);
        *betti.ok_or_else(|| Fault::new("groups", "reduced groups need a vertex"))? -= 1;
    }
    let step = "answer";
    let ring = Ring::of(text(field(answer, "coefficients", step)?, "\"coefficients\"", step)?, step)?;
    let cohomology = truth(field(answer, "cohomology", step)?, "\"cohomology\"", step)?;
    let groups = ring.groups(&groups, cohomology);
    let claimed = list(field(answer, "homology", step)?, "\"homology\"", step)?;
    if claimed.len() != groups.len() {
        return Err(Fault::new(
            step,
            format!("the answer has {} groups, not {}", claimed.len(), groups.len()),
        ));
    }
    let symbol = format!("{}H{}", if reduced { "reduced " } else { "" }, if cohomology { '^' } else { '_' });
    let mut proved = Vec::new();
    for (k, (claim, group)) in claimed.iter().zip(&groups).enumerate() {
        let claim = group_of(claim, k)?;
        if claim != *group {
            let (found, said) = (ring.in_words(group), ring.in_words(&claim));
            return Err(Fault::new(step, format!("{symbol}{k} is {found}, but the answer says {said}")));
        }
        proved.push(format!("{symbol}{k} = {}", ring.in_words(group)));
    }
    let keys = answer.as_object().into_iter().flatten();
    let unchecked = keys
        .filter(|(key, value)| {
            !PROVED.contains(&key.as_str()) && !value.is_null() && **value != Value::Array(vec![])
        })
        .map(|(key, _)| key.clone())
        .collect();
    Ok(Verdict { proved, unchecked })
}

/// The group that an answer claims.
fn group_of(claim: &Value, degree: usize) -> Result<Group, Fault> {
    let step = "answer";
    let at = field(claim, "degree", step)?;
    if at.as_u64() != Some(degree as u64) {
        return Err(Fault::new(step, format!("group {degree} of the answer is of degree {at}")));
    }
    let betti = field(claim, "betti", step)?;
    let betti = betti.as_u64().and_then(|betti| usize::try_from(betti).ok());
    let torsion = list(field(claim, "torsion", step)?, "\"torsion\"", step)?;
    Ok(Group {
        betti: betti.ok_or_else(|| Fault::new(step, "\"betti\" is not a number from 0"))?,
        torsion: torsion.iter().map(|order| integer(order, "an order", step)).collect::<Result<_, _>>()?,
    })
}
