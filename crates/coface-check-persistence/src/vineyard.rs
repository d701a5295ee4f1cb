//! Vineyards: the points of a diagram while a function moves.

use crate::pairs::Pair;
use crate::{pairs, shown, values};
use coface_check::json::{field, index, list, text};
use coface_check::{Complex, Fault, Verdict};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// A point off the diagonal: its degree, and the bits of birth and death.
type Point = (usize, u64, Option<u64>);

/// What the diagrams at the functions leave open.
const BETWEEN: &str = "which points of two functions are on one vine, and the points between functions";

/// Checks the points of vines at all functions.
pub(crate) fn check(whole: &Value, input: &[u8]) -> Result<Verdict, Fault> {
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let prime = index(field(answer, "field", "answer")?, "\"field\"", "answer")?;
    if !coface_check::is_prime(prime) {
        return Err(Fault::new("answer", format!("{prime} is not prime")));
    }
    let least = field(whole, "min_persistence", "answer")?.as_f64();
    let least = least.ok_or_else(|| Fault::new("answer", "\"min_persistence\" is not a number"))?;
    let functions = list(field(answer, "functions", "answer")?, "\"functions\"", "answer")?;
    let proofs = list(proof, "\"proof\"", "proof")?;
    if functions.is_empty() || proofs.len() != functions.len() {
        return Err(Fault::new("proof", "there is not a proof for each function"));
    }
    let mut told = points(answer, functions.len())?;
    let complex = Complex::read(input)?;
    let (mut proved, mut are_known) = (Vec::new(), true);
    for (number, (function, proof)) in functions.iter().zip(proofs).enumerate() {
        let name = text(function, "a function", "answer")?;
        let of_one = json!({"star": "lower", "function": name});
        let (values, claim) = values::values(&complex, &of_one, field(proof, "values", "values")?, input)?;
        let orders = pairs::orders(&complex, &values, field(proof, "order", "order")?, false)?;
        let found = pairs::pairs(&complex, &orders, field(proof, "chains", "chains")?, prime.into())?;
        let value = |degree: usize, cell: u32| values[degree][cell as usize];
        let mut there: BTreeMap<Point, (usize, bool)> = BTreeMap::new();
        for (degree, birth, death) in &found as &[Pair] {
            let born = value(*degree, *birth);
            let dead = death.map(|cell| value(degree + 1, cell));
            let length = dead.map_or(f64::INFINITY, |dead| dead - born);
            if length > 0.0 {
                let point = (*degree, bits(born), dead.map(bits));
                there.entry(point).or_insert((0, length > least)).0 += 1;
            }
        }
        let own = std::mem::take(&mut told[number]);
        let fault = || {
            Fault::new("answer", format!("the points of the vines at function {number} are not the diagram"))
        };
        if own.iter().any(|(point, count)| there.get(point).is_none_or(|known| count > &known.0)) {
            return Err(fault());
        }
        if there.iter().any(|(point, &(count, is_long))| is_long && own.get(point) != Some(&count)) {
            return Err(fault());
        }
        are_known &= claim.is_some();
        proved.push(match claim {
            Some(claim) => format!("function {number}: {claim}"),
            None => format!("function {number} has the values of vertices that the certificate lists"),
        });
        let count: usize = own.values().sum();
        proved.push(format!(
            "function {number}: {count} points of vines are in its diagram over F_{prime}, with all that live longer than {}",
            shown(least)
        ));
    }
    let known = [&["file", "field", "vines"][..], if are_known { &["functions"] } else { &[] }].concat();
    Ok(Verdict::of(proved, answer, &known).leaving(BETWEEN))
}

fn bits(value: f64) -> u64 {
    (value + 0.0).to_bits()
}

/// The points off the diagonal that vines have at each function, each with how often it is there.
fn points(answer: &Value, count: usize) -> Result<Vec<BTreeMap<Point, usize>>, Fault> {
    let step = "answer";
    let mut told = vec![BTreeMap::new(); count];
    for vine in list(field(answer, "vines", step)?, "\"vines\"", step)? {
        coface_check::claims::keys(vine, &["degree", "points"], "a vine")?;
        let degree = index(field(vine, "degree", step)?, "\"degree\"", step)? as usize;
        // The parameter of the last point, and whether the class stays.
        let mut last: Option<(f64, bool)> = None;
        for point in list(field(vine, "points", step)?, "\"points\"", step)? {
            let [parameter, birth, death] = list(point, "a point", step)? else {
                return Err(Fault::new(step, "a point of a vine is not a parameter, a birth and a death"));
            };
            let number = |value: &Value| {
                value
                    .as_f64()
                    .ok_or_else(|| Fault::new(step, "a point of a vine has something else than numbers"))
            };
            let (parameter, birth) = (number(parameter)?, number(birth)?);
            let death = if death.is_null() { None } else { Some(number(death)?) };
            if !(0.0..=(count - 1) as f64).contains(&parameter) || death.is_some_and(|death| death < birth) {
                return Err(Fault::new(
                    step,
                    "a point of a vine is at no function, or dies before its birth",
                ));
            }
            if let Some((before, stays)) = last {
                // A vine says where it is at each function that it passes.
                if before >= parameter || parameter > before.floor() + 1.0 {
                    return Err(Fault::new(step, "the points of a vine do not rise, or pass by a function"));
                }
                if stays != death.is_none() {
                    return Err(Fault::new(step, "a vine has points that stay and others that die"));
                }
            }
            last = Some((parameter, death.is_none()));
            if parameter.fract() == 0.0 && death != Some(birth) {
                let point = (degree, bits(birth), death.map(bits));
                *told[parameter as usize].entry(point).or_insert(0) += 1;
            }
        }
        if last.is_none() {
            return Err(Fault::new(step, "a vine has no point"));
        }
    }
    Ok(told)
}
