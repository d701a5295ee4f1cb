//! Certificates of Vietoris-Rips persistence: cochains instead of the chains of all simplices, so that the simplices of the highest degree are not listed.

use crate::points::Near;
use crate::{PAIR_KEYS, above};
use coface_check::json::{field, index, list, optional, text};
use coface_check::{Fault, Verdict};
use serde_json::Value;
use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap, HashSet};

const KNOWN: [&str; 7] = ["file", "field", "function", "star", "threshold", "diagram", "betti"];
/// Degrees go up to this one.
const MOST_DEGREE: usize = 12;
/// So many simplices are listed.
const MOST_SIMPLICES: usize = 1 << 26;
/// So many points are tried as further points of simplices.
const MOST_WORK: u64 = 1 << 38;

/// A simplex: where it enters among those of its degree, and its points from the last one down.
#[derive(Clone, Debug, PartialEq)]
struct Simplex {
    diameter: f64,
    index: u64,
    points: Vec<u32>,
}

impl Simplex {
    /// By diameter, then by falling index.
    fn enters(&self, other: &Self) -> Ordering {
        self.diameter.total_cmp(&other.diameter).then(other.index.cmp(&self.index))
    }

    fn rising(&self) -> Vec<u32> {
        self.points.iter().rev().copied().collect()
    }
}

/// The simplices up to a threshold.
struct Simplices {
    near: Near,
    /// For k from 0 on the numbers C(n, k).
    binomials: Vec<Vec<u64>>,
    work: u64,
}

/// A simplex that makes a class, and one that ends it.
type Pair = (Simplex, Option<Simplex>);

/// Checks a certificate of the persistence of points.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let number = |object: &Value, key: &str| {
        let found = field(object, key, "answer")?.as_f64();
        found.ok_or_else(|| Fault::new("answer", format!("\"{key}\" is not a number")))
    };
    let prime = index(field(answer, "field", "answer")?, "\"field\"", "answer")?;
    if !coface_check::is_prime(prime) {
        return Err(Fault::new("answer", format!("{prime} is not prime")));
    }
    if answer["function"].as_str() != Some("vietoris-rips") || optional(answer, "star").is_some() {
        return Err(Fault::new("answer", "the answer is of no Vietoris-Rips filtration"));
    }
    let threshold = number(answer, "threshold")?;
    let layout = text(field(whole, "layout", "input")?, "\"layout\"", "input")?;
    let near = Near::read(inputs[0], layout, threshold)?;
    let claimed_betti = list(field(answer, "betti", "answer")?, "\"betti\"", "answer")?;
    let dimension = claimed_betti.len().checked_sub(1).filter(|degree| *degree <= MOST_DEGREE);
    let dimension = dimension.ok_or_else(|| Fault::new("answer", "\"betti\" has no degrees, or too many"))?;
    let claim = near.claim.clone();
    let mut simplices = Simplices::of(near, dimension + 2)?;
    let cochains = list(field(proof, "cochains", "cochains")?, "\"cochains\"", "cochains")?;
    if cochains.len() != dimension {
        return Err(Fault::new("cochains", "there are not cochains of each degree from 1 on"));
    }
    let pairs = simplices.pairs(dimension, cochains, prime.into())?;
    let stay = |pairs: &Vec<Pair>| pairs.iter().filter(|pair| pair.1.is_none()).count() as u64;
    let betti: Vec<u64> = pairs.iter().map(stay).collect();
    if !claimed_betti.iter().map(Value::as_u64).eq(betti.iter().map(|count| Some(*count))) {
        return Err(Fault::new("answer", format!("the Betti numbers over F_{prime} are {betti:?}")));
    }
    let least = number(whole, "min_persistence")?;
    let counts = compare(list(field(answer, "diagram", "answer")?, "\"diagram\"", "answer")?, &pairs, least)?;
    let mut proved = vec![
        claim,
        format!("the filtration is that of Vietoris and Rips up to the diameter {threshold}"),
        format!("Betti numbers over F_{prime} at this diameter = {betti:?}"),
    ];
    for (k, count) in counts.iter().enumerate() {
        proved.push(format!(
            "degree {k}: the {count} pairs whose persistence is {}, and no others",
            above(least)
        ));
    }
    Ok(Verdict::of(proved, answer, &KNOWN))
}

/// The pairs of the answer are those that live longer than this; how many there are of each degree.
fn compare(claimed: &[Value], pairs: &[Vec<Pair>], least: f64) -> Result<Vec<usize>, Fault> {
    let step = "answer";
    let mut expected: BTreeMap<(usize, Vec<u32>), &Pair> = BTreeMap::new();
    for (degree, pairs) in pairs.iter().enumerate() {
        for pair in pairs {
            let length = pair.1.as_ref().map_or(f64::INFINITY, |death| death.diameter - pair.0.diameter);
            if length > 0.0 && length > least {
                expected.insert((degree, pair.0.rising()), pair);
            }
        }
    }
    let mut counts = vec![0; pairs.len()];
    for pair in claimed {
        let keys = pair.as_object().into_iter().flat_map(|object| object.keys());
        if let Some(key) = keys.into_iter().find(|key| !PAIR_KEYS.contains(&key.as_str())) {
            return Err(Fault::new(step, format!("a pair has the key {key:?}, of which nothing is proved")));
        }
        let cell = |key: &str| {
            let points = list(field(pair, key, step)?, key, step)?.iter();
            points.map(|point| index(point, "a point", step)).collect::<Result<Vec<u32>, Fault>>()
        };
        let degree = index(field(pair, "degree", step)?, "\"degree\"", step)? as usize;
        let own = expected.remove(&(degree, cell("birth_cell")?));
        let (birth, death) =
            own.ok_or_else(|| Fault::new(step, format!("{} makes no such class", pair["birth_cell"])))?;
        let is_birth = pair["birth"].as_f64() == Some(birth.diameter);
        let is_death = match death {
            Some(death) => {
                pair["death"].as_f64() == Some(death.diameter) && cell("death_cell")? == death.rising()
            }
            None => optional(pair, "death").is_none() && optional(pair, "death_cell").is_none(),
        };
        if !is_birth || !is_death {
            return Err(Fault::new(
                step,
                format!("the class of {} has another birth or death", pair["birth_cell"]),
            ));
        }
        counts[degree] += 1;
    }
    match expected.is_empty() {
        true => Ok(counts),
        false => Err(Fault::new(step, "a pair is missing")),
    }
}

impl Simplices {
    /// For simplices of up to so many points.
    fn of(near: Near, points: usize) -> Result<Self, Fault> {
        let count = near.lists.len();
        let mut binomials = vec![vec![1u64; count + 1]];
        for k in 1..=points {
            let mut row = vec![0u64];
            for n in 0..count {
                let sum = row[n].checked_add(binomials[k - 1][n]);
                row.push(
                    sum.ok_or_else(|| Fault::new("input", "the simplices are too many to be numbered"))?,
                );
            }
            binomials.push(row);
        }
        Ok(Self { near, binomials, work: 0 })
    }

    /// The simplex of these points, which fall.
    fn simplex(&self, points: &[u32], diameter: f64) -> Simplex {
        let numbers = points.iter().zip((1..=points.len()).rev());
        let index = numbers.map(|(point, k)| self.binomials[k][*point as usize]).sum();
        Simplex { diameter, index, points: points.to_vec() }
    }

    fn distance(&self, a: u32, b: u32) -> Option<f64> {
        let list = self.near.lists.get(a as usize)?;
        list.binary_search_by(|(point, _)| b.cmp(point)).ok().map(|at| list[at].1)
    }

    /// Goes through the cofacets of a simplex by a point below `end`: the point, its place, and the diameter and the index of the cofacet.
    fn cofacets(
        &mut self,
        of: &Simplex,
        end: u32,
        mut visit: impl FnMut(u32, usize, f64, u64),
    ) -> Result<(), Fault> {
        let (count, first) = (of.points.len(), of.points[0] as usize);
        self.work += self.near.lists[first].len() as u64;
        if self.work > MOST_WORK {
            return Err(Fault::new("cochains", "there are too many simplices to look at"));
        }
        for &(point, length) in self.near.lists[first].iter().filter(|(point, _)| *point < end) {
            let mut others = of.points[1..].iter().map(|&other| self.distance(other, point));
            let diameter =
                others.try_fold(of.diameter.max(length), |so_far, next| Some(f64::max(so_far, next?)));
            let Some(diameter) = diameter else { continue };
            let place = of.points.iter().filter(|&&other| other > point).count();
            // The points above the new one are one place farther from the end.
            let number = |(i, &other): (usize, &u32)| {
                self.binomials[count - i + usize::from(i < place)][other as usize]
            };
            let others: u64 = of.points.iter().enumerate().map(number).sum();
            visit(point, place, diameter, others + self.binomials[count + 1 - place][point as usize]);
        }
        Ok(())
    }

    /// A simplex with a further point at this place.
    fn with(of: &Simplex, (point, place, diameter, index): (u32, usize, f64, u64)) -> Simplex {
        let mut points = of.points.clone();
        points.insert(place, point);
        Simplex { diameter, index, points }
    }

    /// The pairs of all degrees up to this one.
    fn pairs(&mut self, dimension: usize, cochains: &[Value], prime: i128) -> Result<Vec<Vec<Pair>>, Fault> {
        let mut edges = Vec::new();
        for (i, list) in self.near.lists.iter().enumerate() {
            let below = list.iter().filter(|(j, _)| (*j as usize) < i);
            edges.extend(below.map(|&(j, length)| self.simplex(&[i as u32, j], length)));
        }
        edges.sort_unstable_by(Simplex::enters);
        let (pairs, mut ended) = self.merged(&edges);
        let (mut pairs, mut level) = (vec![pairs], edges);
        for degree in 1..=dimension {
            let own = self.read(&cochains[degree - 1], degree, prime)?;
            let (found, next) = self.reduced(&level, &ended, own, prime)?;
            pairs.push(found);
            ended = next;
            if degree < dimension {
                let mut above = Vec::new();
                for simplex in &level {
                    self.cofacets(simplex, simplex.points[degree], |point, place, diameter, index| {
                        above.push(Self::with(simplex, (point, place, diameter, index)));
                    })?;
                    if above.len() > MOST_SIMPLICES {
                        return Err(Fault::new("cochains", "there are too many simplices to look at"));
                    }
                }
                level = above;
            }
        }
        Ok(pairs)
    }

    /// The pairs of points, of which the first of a component is the oldest, and the edges that end classes.
    fn merged(&self, edges: &[Simplex]) -> (Vec<Pair>, HashSet<u64>) {
        let count = self.near.lists.len() as u32;
        // Each point has the first one of its component, or one nearer to that.
        let mut oldest: Vec<u32> = (0..count).collect();
        let mut ends: Vec<Option<Simplex>> = vec![None; count as usize];
        let mut ended = HashSet::new();
        for edge in edges {
            let roots = [edge.points[0], edge.points[1]].map(|mut point| {
                while oldest[point as usize] != point {
                    oldest[point as usize] = oldest[oldest[point as usize] as usize];
                    point = oldest[point as usize];
                }
                point
            });
            if roots[0] != roots[1] {
                let younger = roots[0].max(roots[1]);
                oldest[younger as usize] = roots[0].min(roots[1]);
                ends[younger as usize] = Some(edge.clone());
                ended.insert(edge.index);
            }
        }
        let point = |(point, end): (u32, Option<Simplex>)| (self.simplex(&[point], 0.0), end);
        ((0..count).zip(ends).map(point).collect(), ended)
    }

    /// The cochains of several terms, by the indices of their first simplices.
    fn read(
        &self,
        given: &Value,
        degree: usize,
        prime: i128,
    ) -> Result<HashMap<u64, Vec<(Simplex, i128)>>, Fault> {
        let (step, mut found) = ("cochains", HashMap::new());
        for cochain in list(given, "the cochains of a degree", step)? {
            let mut terms: Vec<(Simplex, i128)> = Vec::new();
            for term in list(cochain, "a cochain", step)? {
                let [coefficient, points] = list(term, "a term", step)? else {
                    return Err(Fault::new(step, "a term is not a coefficient and a simplex"));
                };
                let coefficient = coefficient.as_i64().map_or(0, |number| i128::from(number) % prime);
                let points =
                    list(points, "a simplex", step)?.iter().rev().map(|point| index(point, "a point", step));
                let points = points.collect::<Result<Vec<u32>, Fault>>()?;
                let falls = points.windows(2).all(|pair| pair[0] > pair[1]) && points.len() == degree + 1;
                let mut lengths = points
                    .iter()
                    .enumerate()
                    .flat_map(|(i, &a)| points[i + 1..].iter().map(move |&b| (a, b)));
                let diameter =
                    lengths.try_fold(0.0, |so_far, (a, b)| Some(f64::max(so_far, self.distance(a, b)?)));
                let (true, true, Some(diameter)) = (falls, coefficient != 0, diameter) else {
                    return Err(Fault::new(
                        step,
                        format!("{term} is no term of a cochain of degree {degree}"),
                    ));
                };
                let simplex = self.simplex(&points, diameter);
                if terms.first().is_some_and(|(first, _)| first.enters(&simplex) != Ordering::Less) {
                    return Err(Fault::new(step, "a term of a cochain enters before the first one"));
                }
                terms.push((simplex, coefficient));
            }
            let owner = terms.first().map(|(first, _)| first.index);
            let owner = owner.ok_or_else(|| Fault::new(step, "a cochain has no terms"))?;
            if found.insert(owner, terms).is_some() {
                return Err(Fault::new(step, "two cochains have one first simplex"));
            }
        }
        Ok(found)
    }

    /// The cofacet of a simplex that enters first.
    fn first_cofacet(&mut self, of: &Simplex) -> Result<Option<Simplex>, Fault> {
        let mut first: Option<(u32, usize, f64, u64)> = None;
        self.cofacets(of, u32::MAX, |point, place, diameter, index| {
            let is_before =
                |best: (u32, usize, f64, u64)| diameter < best.2 || diameter == best.2 && index > best.3;
            if first.is_none_or(is_before) {
                first = Some((point, place, diameter, index));
            }
        })?;
        Ok(first.map(|first| Self::with(of, first)))
    }

    /// The simplex of the coboundary of a cochain that enters first.
    fn first_of_sum(&mut self, terms: &[(Simplex, i128)], prime: i128) -> Result<Option<Simplex>, Fault> {
        let mut sum: BTreeMap<u64, (i128, Simplex)> = BTreeMap::new();
        for (term, coefficient) in terms {
            self.cofacets(term, u32::MAX, |point, place, diameter, index| {
                let own = if place % 2 == 0 { *coefficient } else { -coefficient };
                let cofacet = || (0, Self::with(term, (point, place, diameter, index)));
                let entry = &mut sum.entry(index).or_insert_with(cofacet).0;
                *entry = (*entry + own) % prime;
            })?;
        }
        let left = sum.into_values().filter(|(value, _)| *value != 0).map(|(_, cofacet)| cofacet);
        Ok(left.min_by(Simplex::enters))
    }

    /// The pairs of the simplices of a degree that end no class: each makes one, which the first simplex of the coboundary of its cochain ends. No two
    /// coboundaries have one first simplex.
    fn reduced(
        &mut self,
        level: &[Simplex],
        is_end: &HashSet<u64>,
        mut cochains: HashMap<u64, Vec<(Simplex, i128)>>,
        prime: i128,
    ) -> Result<(Vec<Pair>, HashSet<u64>), Fault> {
        let (mut pairs, mut ended) = (Vec::new(), HashSet::new());
        for simplex in level.iter().filter(|simplex| !is_end.contains(&simplex.index)) {
            let first = match cochains.remove(&simplex.index) {
                Some(terms) => self.first_of_sum(&terms, prime)?,
                None => self.first_cofacet(simplex)?,
            };
            if first.as_ref().is_some_and(|first| !ended.insert(first.index)) {
                return Err(Fault::new("cochains", "two coboundaries have one first simplex"));
            }
            pairs.push((simplex.clone(), first));
        }
        match cochains.is_empty() {
            true => Ok((pairs, ended)),
            false => {
                Err(Fault::new("cochains", "a cochain is of a simplex that ends a class, or is not there"))
            }
        }
    }
}
