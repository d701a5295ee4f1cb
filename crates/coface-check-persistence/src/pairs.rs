//! The pairs that chains prove.

use coface_check::json::{index, list};
use coface_check::{Complex, Fault};
use serde_json::Value;
use std::collections::BTreeMap;

/// A pair: its degree, the cell that makes the class, and the cell that ends it.
pub(crate) type Pair = (usize, u32, Option<u32>);

/// The cells of a degree as they enter.
pub(crate) struct Order {
    pub(crate) cells: Vec<u32>,
    /// For each cell its place among them.
    places: Vec<u32>,
}

impl Order {
    /// That of some of the cells, with the numbers that they have among themselves.
    pub(crate) fn restricted(&self, kept: &[usize]) -> Self {
        let number = |cell: &u32| kept.binary_search(&(*cell as usize)).ok().map(|number| number as u32);
        let cells: Vec<u32> = self.cells.iter().filter_map(number).collect();
        let mut places = vec![0; cells.len()];
        cells.iter().zip(0..).for_each(|(&cell, place)| places[cell as usize] = place);
        Self { cells, places }
    }

    /// The place of a cell.
    pub(crate) fn place(&self, cell: u32) -> u32 {
        self.places[cell as usize]
    }
}

/// The orders of all degrees, by value; no cell enters before a face of it.
pub(crate) fn orders(
    complex: &Complex,
    values: &[Vec<f64>],
    given: &Value,
    is_upper: bool,
) -> Result<Vec<Order>, Fault> {
    let sign = if is_upper { -1.0 } else { 1.0 };
    for k in 1..values.len() {
        let early = |cell: &usize| {
            let own = sign * values[k][*cell];
            complex.boundary(k, *cell).iter().any(|(face, _)| sign * values[k - 1][*face as usize] > own)
        };
        if let Some(cell) = (0..values[k].len()).find(early) {
            return Err(Fault::new(
                "values",
                format!("cell {cell} of degree {k} enters before a face of it"),
            ));
        }
    }
    let given = list(given, "\"order\"", "order")?;
    if given.len() != values.len() {
        return Err(Fault::new("order", "there is not an order of each degree"));
    }
    let of_degree = |(k, (values, given)): (usize, (&Vec<f64>, &Value))| {
        let cells = list(given, "an order", "order")?.iter().map(|cell| index(cell, "a cell", "order"));
        let cells = cells.collect::<Result<Vec<u32>, Fault>>()?;
        let mut places = vec![u32::MAX; values.len()];
        for (&cell, place) in cells.iter().zip(0..) {
            let known = places.get_mut(cell as usize).filter(|known| **known == u32::MAX);
            *known.ok_or_else(|| {
                Fault::new("order", format!("cell {cell} of degree {k} is twice or not there"))
            })? = place;
        }
        let rises = |pair: &[u32]| sign * values[pair[0] as usize] <= sign * values[pair[1] as usize];
        match cells.len() == values.len() && cells.windows(2).all(rises) {
            true => Ok(Order { cells, places }),
            false => Err(Fault::new(
                "order",
                format!("the cells of degree {k} are not all sorted by their values"),
            )),
        }
    };
    values.iter().zip(given).enumerate().map(of_degree).collect()
}

/// The pairs of all cells, by chains over the field.
pub(crate) fn pairs(
    complex: &Complex,
    orders: &[Order],
    chains: &Value,
    prime: i128,
) -> Result<Vec<Pair>, Fault> {
    let step = "chains";
    let chains = list(chains, "\"chains\"", step)?;
    let counts = complex.counts();
    if chains.len() + 1 != counts.len() {
        return Err(Fault::new(step, "there are not chains of each degree from 1 on"));
    }
    let mut pairs: Vec<Pair> = Vec::new();
    // The cells that are the last of a chain, and those that are the last of a boundary.
    let mut is_owner: Vec<Vec<bool>> = counts.iter().map(|count| vec![false; *count]).collect();
    let mut is_ended = is_owner.clone();
    for (k, of_degree) in (1..).zip(chains) {
        for chain in list(of_degree, "the chains of a degree", step)? {
            let (owner, boundary) = read(complex, orders, k, chain, prime)?;
            let is_new = !std::mem::replace(&mut is_owner[k][owner as usize], true);
            let low = boundary.iter().rev().find(|(_, value)| **value != 0);
            match low.map(|(place, _)| orders[k - 1].cells[*place as usize]) {
                Some(low) if is_new && !std::mem::replace(&mut is_ended[k - 1][low as usize], true) => {
                    pairs.push((k - 1, low, Some(owner)));
                }
                None if is_new => pairs.push((k, owner, None)),
                _ => return Err(Fault::new(step, "two chains, or their boundaries, have one last cell")),
            }
        }
    }
    let all = (0..counts.len()).flat_map(|k| (0..counts[k]).map(move |cell| (k, cell)));
    for (k, cell) in all {
        match (is_owner[k][cell], is_ended[k][cell]) {
            (false, false) if k == 0 => pairs.push((0, cell as u32, None)),
            (true, false) | (false, true) => {}
            _ => return Err(Fault::new(step, format!("cell {cell} of degree {k} is in no pair, or in two"))),
        }
    }
    Ok(pairs)
}

/// The last cell of a chain of a degree, and its boundary by the places of the faces.
pub(crate) fn read(
    complex: &Complex,
    orders: &[Order],
    k: usize,
    chain: &Value,
    prime: i128,
) -> Result<(u32, BTreeMap<u32, i128>), Fault> {
    let step = "chains";
    let mut boundary: BTreeMap<u32, i128> = BTreeMap::new();
    let mut last: Option<u32> = None;
    for term in list(chain, "a chain", step)? {
        let [coefficient, cell] = list(term, "a term", step)? else {
            return Err(Fault::new(step, "a term is not a coefficient and a cell"));
        };
        let cell = index(cell, "a cell", step)?;
        let coefficient = coefficient.as_i64().map(|number| i128::from(number) % prime);
        let Some(coefficient) = coefficient.filter(|c| *c != 0 && (cell as usize) < complex.counts()[k])
        else {
            return Err(Fault::new(step, "a term is zero or of a cell that is not there"));
        };
        let place = |cell: u32| orders[k].places[cell as usize];
        if last.is_some_and(|last| place(last) >= place(cell)) {
            return Err(Fault::new(step, "the cells of a chain do not rise"));
        }
        last = Some(cell);
        for (face, incidence) in complex.boundary(k, cell as usize) {
            let entry = boundary.entry(orders[k - 1].places[*face as usize]).or_default();
            *entry = (*entry + coefficient * i128::from(*incidence)) % prime;
        }
    }
    let owner = last.ok_or_else(|| Fault::new(step, "a chain is empty"))?;
    Ok((owner, boundary))
}
