//! Extended persistence: the classes of the cone over a complex.

use crate::cone::{below, made};
use crate::pairs;
use crate::values::{of_cells, values};
use crate::{Cells, PAIR_KEYS, shown};
use coface_check::json::{field, index, list, text};
use coface_check::{Complex, Fault, Verdict};
use serde_json::Value;

const KNOWN: [&str; 5] = ["file", "field", "star", "diagram", "betti"];

/// A complex and when its cells enter sublevel sets, and superlevel sets.
struct Cone<'a> {
    complex: &'a Complex,
    lower: &'a [Vec<f64>],
    upper: &'a [Vec<f64>],
}

/// A cell of the complex that makes or ends a class, by itself or by its cone.
#[derive(Clone, Copy)]
struct Owner {
    is_over: bool,
    degree: usize,
    cell: u32,
    value: f64,
}

impl Cone<'_> {
    /// The steps at which cells enter: sublevel sets first, from the lowest value up, and then superlevel sets, from the highest value down; the apex before all.
    fn steps(&self) -> Vec<Vec<f64>> {
        let mut known: Vec<f64> = self.lower[0].clone();
        known.sort_by(f64::total_cmp);
        known.dedup();
        let rank = |value: f64| known.partition_point(|other| *other < value) as f64;
        let last = 2.0 * known.len() as f64;
        let of_degree = |degree: usize| {
            let own = self.lower.get(degree).into_iter().flatten().map(|value| rank(*value));
            let over: Vec<f64> = match degree.checked_sub(1) {
                Some(below) => self.upper[below].iter().map(|value| last - rank(*value)).collect(),
                None => vec![-1.0],
            };
            own.chain(over).collect()
        };
        (0..=self.complex.counts().len()).map(of_degree).collect()
    }

    /// What a cell of the cone comes from; `None` for the apex.
    fn owner(&self, degree: usize, cell: u32) -> Option<Owner> {
        let (is_over, degree, cell) = below(self.complex, degree, cell)?;
        let values = if is_over { self.upper } else { self.lower };
        Some(Owner { is_over, degree, cell, value: values[degree][cell as usize] })
    }
}

/// A class: its degree and kind, and the degrees and numbers of the cells that make and end it.
type Class = (usize, &'static str, [(usize, u32); 2]);

/// The kinds of classes.
const KINDS: [&str; 4] = ["ordinary", "relative", "extended+", "extended-"];

/// Checks extended persistence of a function on the vertices of a complex.
pub(crate) fn check(whole: &Value, complex: &Complex, input: &[u8]) -> Result<Verdict, Fault> {
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let prime = index(field(answer, "field", "answer")?, "\"field\"", "answer")?;
    if !coface_check::is_prime(prime) {
        return Err(Fault::new("answer", format!("{prime} is not prime")));
    }
    let (lower, of_function) = values(complex, answer, field(proof, "values", "values")?, input)?;
    let upper = of_cells(complex, &lower[0], f64::min)?;
    let cone = Cone { complex, lower: &lower, upper: &upper };
    let made = made(complex)?;
    let orders = pairs::orders(&made, &cone.steps(), field(proof, "order", "order")?, false)?;
    let found = pairs::pairs(&made, &orders, field(proof, "chains", "chains")?, prime.into())?;
    let least = field(whole, "min_persistence", "answer")?.as_f64();
    let least = least.ok_or_else(|| Fault::new("answer", "\"min_persistence\" is not a number"))?;
    let mut betti = vec![0_u64; complex.counts().len()];
    let mut expected: Vec<Class> = Vec::new();
    for (degree, birth, death) in found {
        let (born, dead) = (cone.owner(degree, birth), death.map(|death| cone.owner(degree + 1, death)));
        let (born, dead) = match (born, dead) {
            // The component of the apex stays.
            (None, None) => continue,
            (Some(born), Some(Some(dead))) => (born, dead),
            _ => return Err(Fault::new("chains", "a class of the cone stays, or that of the apex ends")),
        };
        let kind = match (born.is_over, dead.is_over) {
            (false, false) => "ordinary",
            (true, _) => "relative",
            _ if born.value <= dead.value => "extended+",
            _ => "extended-",
        };
        let is_extended = kind.starts_with("extended");
        let length = (dead.value - born.value).abs();
        if is_extended {
            betti[degree] += 1;
        }
        if is_extended || length > least.max(0.0) {
            expected.push((degree, kind, [(born.degree, born.cell), (dead.degree, dead.cell)]));
        }
    }
    let claimed = list(field(answer, "betti", "answer")?, "\"betti\"", "answer")?;
    if !claimed.iter().map(Value::as_u64).eq(betti.iter().map(|count| Some(*count))) {
        return Err(Fault::new("answer", format!("the Betti numbers over F_{prime} are {betti:?}")));
    }
    let cells = Cells::of(complex, None);
    let claimed = list(field(answer, "diagram", "answer")?, "\"diagram\"", "answer")?;
    let claimed = claimed.iter().map(|class| claimed_class(&cells, &cone, class));
    let mut claimed = claimed.collect::<Result<Vec<Class>, Fault>>()?;
    expected.sort_unstable();
    claimed.sort_unstable();
    if expected != claimed {
        return Err(Fault::new("answer", "the classes of the chains are others than those of the answer"));
    }
    let mut known = KNOWN.to_vec();
    let mut proved = Vec::new();
    if let Some(of_function) = of_function {
        known.push("function");
        proved.push(of_function);
    }
    proved.push(format!("Betti numbers over F_{prime} = {betti:?}"));
    for degree in 0..betti.len() {
        let of_kind =
            |kind: &str| expected.iter().filter(|class| class.0 == degree && class.1 == kind).count();
        let [ordinary, relative, plus, minus] = KINDS.map(of_kind);
        proved.push(format!(
            "degree {degree}: all {} extended classes, the {ordinary} ordinary and {relative} relative ones whose persistence is above {}, and no others",
            plus + minus,
            shown(least.max(0.0))
        ));
    }
    Ok(Verdict::of(proved, answer, &known))
}

/// A class of the answer, whose values are those of its cells.
fn claimed_class(cells: &Cells, cone: &Cone<'_>, class: &Value) -> Result<Class, Fault> {
    let step = "answer";
    let keys = class.as_object().into_iter().flat_map(|object| object.keys());
    if let Some(key) = keys.into_iter().find(|key| *key != "kind" && !PAIR_KEYS.contains(&key.as_str())) {
        return Err(Fault::new(step, format!("a pair has the key {key:?}, of which nothing is proved")));
    }
    let degree = index(field(class, "degree", step)?, "\"degree\"", step)? as usize;
    let told = text(field(class, "kind", step)?, "\"kind\"", step)?;
    let kind = KINDS.into_iter().find(|kind| *kind == told);
    let kind = kind.ok_or_else(|| Fault::new(step, format!("{told:?} is no kind of a class")))?;
    let (is_over, birth_degree) = match kind {
        "relative" => ([true, true], degree.checked_sub(1)),
        "ordinary" => ([false, false], Some(degree)),
        _ => ([false, true], Some(degree)),
    };
    let birth_degree = birth_degree.ok_or_else(|| Fault::new(step, "a relative class has the degree 0"))?;
    let death_degree = if kind == "ordinary" { degree + 1 } else { degree };
    let found = |degree: usize, is_over: bool, key: &str, value: &str| {
        let cell = cells.find(degree, field(class, key, step)?, key)?;
        let own = if is_over { cone.upper[degree][cell as usize] } else { cone.lower[degree][cell as usize] };
        match field(class, value, step)?.as_f64() == Some(own) {
            true => Ok((degree, cell)),
            false => Err(Fault::new(step, format!("the value of the {key} {} is {own}", class[key]))),
        }
    };
    let birth = found(birth_degree, is_over[0], "birth_cell", "birth")?;
    let death = found(death_degree, is_over[1], "death_cell", "death")?;
    Ok((degree, kind, [birth, death]))
}
