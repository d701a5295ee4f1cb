//! Certificates of homology and cohomology: groups, and the cycles or cocycles that generate them.

use crate::claims::keys;
use crate::generators::Generators;
use crate::groups::{Group, Ring, integral};
use crate::json::{field, integer, list, optional, text, truth};
use crate::matching::Morse;
use crate::smith::diagonal;
use crate::{Complex, Fault, Verdict};
use serde_json::Value;

/// The keys of an answer that are derived; `file` is the name that the input had.
const PROVED: [&str; 5] = ["coefficients", "cohomology", "homology", "generators", "file"];

pub(crate) fn check(certificate: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let (answer, proof) =
        (field(certificate, "answer", "certificate")?, field(certificate, "proof", "certificate")?);
    let relative = optional(certificate, "relative");
    let mut complex = Complex::read(inputs[0])?;
    match (relative.map(Value::as_str), inputs) {
        (None, [_]) => (),
        (Some(Some("boundary")), [_]) => complex = complex.relative(None)?,
        (Some(Some("file")), [_, part]) => complex = complex.relative(Some(part))?,
        _ => return Err(Fault::new("relative", "the inputs are not those of such a pair")),
    }
    let mut groups = integral_groups(&complex, proof)?;
    let is_reduced = truth(field(certificate, "reduced", "certificate")?, "\"reduced\"", "certificate")?;
    if is_reduced {
        if complex.names().is_none() || relative.is_some() {
            return Err(Fault::new("groups", "reduced groups need cells with vertices, and no pair"));
        }
        let betti = groups.first_mut().map(|group| &mut group.betti).filter(|betti| **betti > 0);
        *betti.ok_or_else(|| Fault::new("groups", "reduced groups need a vertex"))? -= 1;
    }
    let step = "answer";
    let ring = Ring::of(text(field(answer, "coefficients", step)?, "\"coefficients\"", step)?, step)?;
    let is_cohomology = truth(field(answer, "cohomology", step)?, "\"cohomology\"", step)?;
    let groups = ring.groups(&groups, is_cohomology);
    let symbol = format!(
        "{}{}H{}",
        if relative.is_some() { "relative " } else { "" },
        if is_reduced { "reduced " } else { "" },
        if is_cohomology { '^' } else { '_' }
    );
    let mut proved = compare(field(answer, "homology", step)?, &groups, &ring, &symbol)?;
    if let Some(claimed) = optional(answer, "generators") {
        let generators = Generators { complex: &complex, ring: &ring, is_cohomology, is_reduced };
        generators.check(&groups, claimed, field(proof, "duals", "generators")?)?;
        let what = if is_cohomology { "cocycles" } else { "cycles" };
        proved.push(format!(
            "the {what} of the answer have the orders that it says, and generate these groups"
        ));
    }
    Ok(Verdict::of(proved, answer, &PROVED))
}

/// The integral homology groups, by the pairs and the normal forms of a proof.
pub(crate) fn integral_groups(complex: &Complex, proof: &Value) -> Result<Vec<Group>, Fault> {
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
    let factors = morse.boundaries.iter().zip(forms).enumerate();
    let factors =
        factors.map(|(k, (matrix, form))| diagonal(matrix, form, &format!("smith of degree {}", k + 1)));
    integral(&morse.counts, &factors.collect::<Result<Vec<_>, _>>()?, "groups")
}

/// Compares the groups that an answer claims with those that were derived, and says them in words.
pub(crate) fn compare(
    claimed: &Value,
    groups: &[Group],
    ring: &Ring,
    symbol: &str,
) -> Result<Vec<String>, Fault> {
    let step = "answer";
    let claimed = list(claimed, "\"homology\"", step)?;
    if claimed.len() != groups.len() {
        return Err(Fault::new(
            step,
            format!("the answer has {} groups, not {}", claimed.len(), groups.len()),
        ));
    }
    let pairs = claimed.iter().zip(groups).enumerate();
    let compared = pairs.map(|(k, (claim, group))| {
        let claim = group_of(claim, k)?;
        let found = ring.in_words(group);
        match claim == *group {
            true => Ok(format!("{symbol}{k} = {found}")),
            false => {
                let said = ring.in_words(&claim);
                Err(Fault::new(step, format!("{symbol}{k} is {found}, but the answer says {said}")))
            }
        }
    });
    compared.collect()
}

/// The group that an answer claims.
fn group_of(claim: &Value, degree: usize) -> Result<Group, Fault> {
    let step = "answer";
    keys(claim, &["degree", "betti", "torsion"], &format!("the group of degree {degree}"))?;
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
