//! Generators of homology and cohomology, which cochains and chains on the other side tell apart.

use crate::claims::keys;
use crate::complex::{Complex, Finder};
use crate::groups::{Group, Ring};
use crate::json::{field, index, integer, list, optional};
use crate::{Fault, complex::Column};
use dashu_int::IBig;
use dashu_int::ops::Abs;
use serde_json::Value;
use std::collections::BTreeMap;

/// A chain or a cochain: cells with coefficients.
type Chain = BTreeMap<u32, IBig>;

/// What generators are checked in.
pub(crate) struct Generators<'a> {
    pub(crate) complex: &'a Complex,
    pub(crate) ring: &'a Ring,
    pub(crate) is_cohomology: bool,
    pub(crate) is_reduced: bool,
}

impl Generators<'_> {
    /// Checks that the generators of each degree have the orders that they should, and generate the group.
    ///
    /// Generator i of order m is closed. Dual i is closed on the other side modulo N, and has the value N/m on generator i and 0 on the
    /// others, modulo N. Over Z/n all N are n, over Z and Q they are the orders, and for the order 0 the value is 1.
    pub(crate) fn check(&self, groups: &[Group], claimed: &Value, duals: &Value) -> Result<(), Fault> {
        let all = |value, what| list(value, what, "generators").map(|all| (all, all.len() == groups.len()));
        let ((claimed, is_whole), (duals, has_all)) =
            (all(claimed, "\"generators\"")?, all(duals, "\"duals\"")?);
        if !is_whole || !has_all {
            return Err(Fault::new("generators", "there are not generators and duals of each degree"));
        }
        for (k, group) in groups.iter().enumerate() {
            self.check_degree(k, group, &claimed[k], &duals[k])?;
        }
        Ok(())
    }

    fn check_degree(
        &self,
        degree: usize,
        group: &Group,
        claimed: &Value,
        duals: &Value,
    ) -> Result<(), Fault> {
        let step = format!("generators of degree {degree}");
        let (claimed, duals) = (list(claimed, "\"generators\"", &step)?, list(duals, "\"duals\"", &step)?);
        let orders = [&group.torsion[..], &vec![IBig::ZERO; group.betti]].concat();
        let orders: Vec<&IBig> = orders.iter().collect();
        if claimed.len() != orders.len() || duals.len() != orders.len() {
            return Err(Fault::new(
                step,
                format!("the group has {} summands, the proof others", orders.len()),
            ));
        }
        let finder = Finder::of(self.complex, Some(degree));
        let cofaces = self.complex.cofaces(degree);
        let whole = self.ring.modulus();
        let mut on_cell: BTreeMap<u32, Vec<(usize, IBig)>> = BTreeMap::new();
        for (i, (claim, order)) in claimed.iter().zip(&orders).enumerate() {
            keys(
                claim,
                &["chain", "order", "length", "bounding"],
                &format!("a generator of degree {degree}"),
            )?;
            let chain = chain(&finder, degree, field(claim, "chain", &step)?, &step)?;
            let length: IBig = chain.values().map(|coefficient| coefficient.clone().abs()).sum();
            if integer(field(claim, "order", &step)?, "\"order\"", &step)? != **order
                || integer(field(claim, "length", &step)?, "\"length\"", &step)? != length
            {
                return Err(Fault::new(step, format!("generator {i} has another order or length")));
            }
            if !self.is_closed(degree, &chain, self.is_cohomology, &cofaces, &whole) {
                return Err(Fault::new(step, format!("generator {i} is not closed")));
            }
            if let Some(bounding) = optional(claim, "bounding") {
                self.check_bounding(degree, &chain, order, bounding, &step)?;
            }
            chain.into_iter().for_each(|(cell, value)| on_cell.entry(cell).or_default().push((i, value)));
        }
        let moduli: Vec<&IBig> =
            orders.iter().map(|order| if whole == IBig::ZERO { *order } else { &whole }).collect();
        let mut values: BTreeMap<(usize, usize), IBig> = BTreeMap::new();
        for (j, dual) in duals.iter().enumerate() {
            let dual = chain(&finder, degree, dual, &step)?;
            if !self.is_closed(degree, &dual, !self.is_cohomology, &cofaces, moduli[j]) {
                return Err(Fault::new(step, format!("dual {j} is not closed")));
            }
            for (cell, value) in &dual {
                for (i, coefficient) in on_cell.get(cell).into_iter().flatten() {
                    *values.entry((*i, j)).or_default() += coefficient * value;
                }
            }
        }
        for (i, order) in orders.iter().enumerate() {
            let unit = if **order == IBig::ZERO { IBig::ONE } else { moduli[i] / *order };
            *values.entry((i, i)).or_default() -= unit;
        }
        match values.iter().find(|((_, j), value)| !is_zero(value, moduli[*j])) {
            Some(((i, j), _)) => {
                Err(Fault::new(step, format!("dual {j} has another value on generator {i}")))
            }
            None => Ok(()),
        }
    }

    /// Whether the boundary of a chain, or the coboundary of a cochain, is zero modulo a number.
    fn is_closed(&self, degree: usize, chain: &Chain, up: bool, cofaces: &[Column], modulus: &IBig) -> bool {
        match (up, degree) {
            (true, _) => is_all_zero(&image(chain, |cell| &cofaces[cell]), modulus),
            // In a reduced complex the boundary of each vertex is the empty simplex.
            (false, 0) => !self.is_reduced || is_zero(&chain.values().sum(), modulus),
            (false, _) => is_all_zero(&image(chain, |cell| self.complex.boundary(degree, cell)), modulus),
        }
    }

    /// Checks that a chain bounds so many times a cycle as its order says.
    fn check_bounding(
        &self,
        degree: usize,
        cycle: &Chain,
        order: &IBig,
        bounding: &Value,
        step: &str,
    ) -> Result<(), Fault> {
        let is_asked = !self.is_cohomology && matches!(self.ring, Ring::Integers) && *order != IBig::ZERO;
        let above = Finder::of(self.complex, Some(degree + 1));
        let bounding = chain(&above, degree + 1, bounding, step)?;
        let mut rest = image(&bounding, |cell| self.complex.boundary(degree + 1, cell));
        cycle.iter().for_each(|(cell, coefficient)| *rest.entry(*cell).or_default() -= coefficient * order);
        match is_asked && is_all_zero(&rest, &IBig::ZERO) {
            true => Ok(()),
            false => Err(Fault::new(step, format!("\"bounding\" does not bound {order} times its cycle"))),
        }
    }
}

/// A list of coefficients and cells.
fn chain(finder: &Finder<'_>, degree: usize, terms: &Value, step: &str) -> Result<Chain, Fault> {
    let mut chain = Chain::new();
    for term in list(terms, "a chain", step)? {
        let [coefficient, vertices] = list(term, "a term", step)? else {
            return Err(Fault::new(step, "a term is not a coefficient and a cell"));
        };
        let vertices = list(vertices, "a cell", step)?.iter().map(|vertex| index(vertex, "a vertex", step));
        let (cell, sign) = finder.oriented(degree, &vertices.collect::<Result<Vec<_>, _>>()?, step)?;
        if chain.insert(cell, integer(coefficient, "a coefficient", step)? * IBig::from(sign)).is_some() {
            return Err(Fault::new(step, format!("cell {cell} is twice in a chain")));
        }
    }
    Ok(chain)
}

fn image<'a>(chain: &Chain, column: impl Fn(usize) -> &'a [(u32, i64)]) -> Chain {
    let mut sum = Chain::new();
    for (cell, coefficient) in chain {
        for (other, incidence) in column(*cell as usize) {
            *sum.entry(*other).or_default() += coefficient * IBig::from(*incidence);
        }
    }
    sum
}

/// Whether a number is zero modulo another; modulo 0 only 0 is.
fn is_zero(value: &IBig, modulus: &IBig) -> bool {
    *value == IBig::ZERO || *modulus != IBig::ZERO && value % modulus == IBig::ZERO
}

fn is_all_zero(chain: &Chain, modulus: &IBig) -> bool {
    chain.values().all(|value| is_zero(value, modulus))
}
