//! Parts of an image merged to one: open ends in the union are replaced by what they flow to, then pairs are taken out.

use super::cut::ImageBlocks;
use super::part::{Cells, Chains, ImagePart, Name, OUTSIDE_NAME, Rules, owner};
use coface_algebra::progress::stage;
use coface_algebra::{Error, SpreadMap};
use std::ops::Range;
use std::sync::Arc;

impl ImagePart {
    /// The part of all blocks of these parts, whose numbers follow each other.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for no parts, parts of images that are cut or asked differently, and blocks that do not follow each
    /// other; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for parts whose paths run in circles, as parts of other numbers may.
    ///
    /// # Complexity
    /// Near-linear in the parts and in the chains that replace open ends, but for the degrees strictly between 0 and the last one, in which the boundaries of critical
    /// cells are reduced: cubic in their number at worst.
    ///
    /// # Examples
    /// See [`ImagePart`].
    pub fn merged(parts: &[Self]) -> Result<Self, Error> {
        let Some(first) = parts.first() else {
            return Err(Error::invalid("no parts of an image are given").with_cure("give one part or more"));
        };
        let cut = Arc::clone(&first.cut);
        let axes = first.axes();
        let mut blocks = first.blocks.start..first.blocks.start;
        for part in parts {
            if *part.cut != *cut {
                return Err(Error::invalid(format!(
                    "the parts of blocks {:?} and {:?} are of images that are cut or asked differently",
                    first.blocks, part.blocks
                ))
                .with_cure("give parts that one ImageBlocks has made"));
            }
            if part.blocks.start != blocks.end {
                return Err(Error::invalid(format!(
                    "the part of blocks {:?} does not follow that of block {}",
                    part.blocks,
                    i64::from(blocks.end) - 1
                ))
                .with_cure("give parts in the order of their blocks, without gaps"));
            }
            blocks.end = part.blocks.end;
        }
        let _steps = stage("merging parts of an image", 0);
        let union = Union { cut: &cut, blocks: blocks.clone() };
        let mut edges: Vec<[Name; 2]> = parts.iter().flat_map(|part| part.edges.iter().copied()).collect();
        let mut facets: Vec<[Name; 2]> = parts.iter().flat_map(|part| part.facets.iter().copied()).collect();
        let vertex_rules = union.followed(parts.iter().map(|part| &part.rules[0]), &mut edges)?;
        let top_rules = union.followed(parts.iter().map(|part| &part.top_rules), &mut facets)?;
        let mut rules = vec![vertex_rules];
        let mut boundaries = Vec::new();
        let mut critical = Vec::new();
        let mut orders = Vec::new();
        for degree in 0..=axes {
            let (cells, order) = sorted(parts.iter().map(|part| &part.critical[degree]));
            critical.push(cells);
            orders.push(order);
        }
        for degree in 2..axes {
            let of_cells: Vec<&Chains> = parts.iter().map(|part| &part.boundaries[degree - 2]).collect();
            let of_rules: Vec<&Rules> = parts.iter().map(|part| &part.rules[degree - 1]).collect();
            let flow = Flow::new(&union, &critical[degree - 1], &of_rules, &of_cells)?;
            boundaries.push(flow.chains(&of_cells, &orders[degree]));
            rules.push(flow.open_rules());
        }
        let edges = orders[1].iter().map(|&(_, place)| edges[place as usize]).collect();
        let facets = match axes {
            1 => Vec::new(),
            _ => orders[axes - 1].iter().map(|&(_, place)| facets[place as usize]).collect(),
        };
        let layers = parts.iter().flat_map(|part| &part.layer);
        let mut layer: Vec<[u64; 2]> =
            layers.filter(|&&[voxel, _]| !union.has_voxel(voxel)).copied().collect();
        layer.sort_unstable();
        layer.dedup_by_key(|place| place[0]);
        let pairs = |degree: usize| parts.iter().flat_map(move |part| &part.pairs[degree]).copied().collect();
        let pairs = (0..axes).map(pairs).collect();
        let cut = Arc::clone(&cut);
        let merged =
            Self { blocks, critical, edges, facets, boundaries, rules, top_rules, layer, pairs, cut };
        merged.cancelled()
    }
}

/// Which part a thing comes from, and its place among those of all parts.
type Origin = (u32, u32);

/// The cells of all parts as they enter, and where each comes from.
fn sorted<'a>(parts: impl Iterator<Item = &'a Cells>) -> (Cells, Vec<Origin>) {
    let mut all = Vec::new();
    for (number, cells) in (0..).zip(parts) {
        for (&key, &name) in cells.keys.iter().zip(&cells.names) {
            all.push((key, name, (number, all.len() as u32)));
        }
    }
    // Runs that are sorted already are merged.
    all.sort();
    let cells = Cells {
        keys: all.iter().map(|cell| cell.0).collect(),
        names: all.iter().map(|cell| cell.1).collect(),
    };
    (cells, all.into_iter().map(|cell| cell.2).collect())
}

fn circle() -> Error {
    Error::parse("the paths of these parts run in a circle, so they are not of one image")
        .with_cure("make the parts again")
}

/// The blocks that are merged.
struct Union<'a> {
    cut: &'a ImageBlocks,
    blocks: Range<u32>,
}

impl Union<'_> {
    fn owns(&self, name: Name) -> bool {
        self.has_voxel(owner(name))
    }

    fn has_voxel(&self, voxel: u64) -> bool {
        let voxels: usize = self.cut.shape().iter().product();
        (voxel as usize) < voxels && self.blocks.contains(&self.cut.block_of(voxel))
    }

    /// The blocks outside of the union that ask for a rule.
    fn askers(&self, rules: &Rules, i: usize) -> Vec<u64> {
        let is_outside = |&block: &u64| !u32::try_from(block).is_ok_and(|block| self.blocks.contains(&block));
        rules.askers.list(i).iter().copied().filter(is_outside).collect()
    }

    /// Follows ends, of which each flows to one cell at most, as far as the rules lead; gives the rules that are still asked for.
    fn followed<'a>(
        &self,
        rules: impl Iterator<Item = &'a Rules> + Clone,
        ends: &mut [[Name; 2]],
    ) -> Result<Rules, Error> {
        let mut next: SpreadMap<Name, Name> = SpreadMap::default();
        for rules in rules.clone() {
            for (i, &name) in rules.cells.names.iter().enumerate() {
                let end = rules.chains.names(i).first().copied().unwrap_or(OUTSIDE_NAME);
                // A critical cell flows to itself.
                if end != name {
                    next.insert(name, end);
                }
            }
        }
        let mut path = Vec::new();
        let mut follow = |start: Name| {
            let mut at = start;
            while let Some(&to) = next.get(&at) {
                path.push(at);
                if path.len() > next.len() {
                    return Err(circle());
                }
                at = to;
            }
            for passed in path.drain(..) {
                next.insert(passed, at);
            }
            Ok(at)
        };
        for end in ends.as_flattened_mut() {
            *end = follow(*end)?;
        }
        let mut asked = Vec::new();
        for rules in rules {
            for (i, (&key, &name)) in rules.cells.keys.iter().zip(&rules.cells.names).enumerate() {
                let askers = self.askers(rules, i);
                if !askers.is_empty() {
                    asked.push((key, name, askers));
                }
            }
        }
        asked.sort_unstable();
        let mut left = Rules::default();
        for (key, name, askers) in asked {
            let end = follow(name)?;
            left.push(2, (key, name), askers, [(end, 1)]);
        }
        Ok(left)
    }
}

/// A rule that is needed: its origin and, once it has been followed, what it flows to.
struct Needed {
    key: u64,
    name: Name,
    origin: Origin,
    terms: Vec<(Name, u32)>,
}

/// How cells of one degree flow in a union.
struct Flow<'a> {
    union: &'a Union<'a>,
    parts: &'a [&'a Rules],
    prime: u64,
    /// Critical cells of the union have no number; needed rules have theirs.
    known: SpreadMap<Name, Option<u32>>,
    needed: Vec<Needed>,
}

impl<'a> Flow<'a> {
    /// Follows the rules that the chains and other blocks need.
    fn new(
        union: &'a Union<'a>,
        critical: &Cells,
        parts: &'a [&'a Rules],
        chains: &[&Chains],
    ) -> Result<Self, Error> {
        let mut known: SpreadMap<Name, Option<u32>> =
            critical.names.iter().map(|&name| (name, None)).collect();
        let mut places: SpreadMap<Name, Origin> = SpreadMap::default();
        let mut stack: Vec<Name> = Vec::new();
        for (number, rules) in (0..).zip(parts) {
            for (i, &name) in rules.cells.names.iter().enumerate() {
                let is_asked = !union.askers(rules, i).is_empty();
                // A critical cell flows to itself.
                if is_asked || !known.contains_key(&name) {
                    places.insert(name, (number, i as u32));
                }
                if is_asked {
                    stack.push(name);
                }
            }
        }
        for chains in chains {
            stack.extend(chains.all_names().iter().filter(|name| places.contains_key(name)));
        }
        let mut needed = Vec::new();
        while let Some(name) = stack.pop() {
            // Each is taken once.
            let Some(origin) = places.remove(&name) else { continue };
            let (rules, i) = (parts[origin.0 as usize], origin.1 as usize);
            needed.push(Needed { key: rules.cells.keys[i], name, origin, terms: Vec::new() });
            stack.extend(rules.chains.names(i).iter().filter(|name| places.contains_key(name)));
        }
        needed.sort_unstable_by_key(|rule| (rule.key, rule.name));
        for (number, rule) in (0..).zip(&needed) {
            known.entry(rule.name).or_insert(Some(number));
        }
        let mut flow = Self { union, parts, prime: union.cut.prime().into(), known, needed };
        // What a rule flows to in another block has entered before it.
        for number in 0..flow.needed.len() {
            let (part, i) = flow.needed[number].origin;
            let name = flow.needed[number].name;
            let terms = parts[part as usize].chains.terms(i as usize);
            flow.needed[number].terms = match flow.known.get(&name) {
                Some(None) => vec![(name, 1)],
                _ => flow.followed(terms, number)?,
            };
        }
        Ok(flow)
    }

    /// What a sum flows to, by rules of lower numbers than this one.
    fn followed(
        &self,
        terms: impl Iterator<Item = (Name, u32)>,
        below: usize,
    ) -> Result<Vec<(Name, u32)>, Error> {
        let mut sum = Vec::new();
        for (name, unit) in terms {
            match self.known.get(&name) {
                Some(None) => sum.push((name, unit)),
                Some(&Some(rule)) if (rule as usize) < below => {
                    let product = |x: u32| (u64::from(unit) * u64::from(x) % self.prime) as u32;
                    sum.extend(self.needed[rule as usize].terms.iter().map(|&(name, x)| (name, product(x))));
                }
                Some(Some(_)) => return Err(circle()),
                // A cell of the union that is matched with a facet flows to nothing.
                None if self.union.owns(name) => {}
                None => sum.push((name, unit)),
            }
        }
        Ok(added_up(sum, self.prime))
    }

    /// What the chains of all parts flow to, in this order.
    fn chains(&self, parts: &[&Chains], order: &[Origin]) -> Chains {
        let starts: Vec<usize> = parts
            .iter()
            .scan(0, |start, chains| {
                *start += chains.len();
                Some(*start - chains.len())
            })
            .collect();
        let mut found = Chains::default();
        for &(part, place) in order {
            let terms = parts[part as usize].terms(place as usize - starts[part as usize]);
            let terms = self.followed(terms, self.needed.len()).expect("all rules have been followed");
            found.push(self.union.cut.prime(), terms);
        }
        found
    }

    /// The rules that blocks outside ask for.
    fn open_rules(&self) -> Rules {
        let mut left = Rules::default();
        for rule in &self.needed {
            let askers = self.union.askers(self.parts[rule.origin.0 as usize], rule.origin.1 as usize);
            if !askers.is_empty() {
                let terms = rule.terms.iter().copied();
                left.push(self.union.cut.prime(), (rule.key, rule.name), askers, terms);
            }
        }
        left
    }
}

/// The sum of terms modulo a prime, by rising names, without zeros.
fn added_up(mut terms: Vec<(Name, u32)>, prime: u64) -> Vec<(Name, u32)> {
    terms.sort_unstable();
    let sum = |run: &[(Name, u32)]| {
        let total = run.iter().map(|&(_, unit)| u64::from(unit)).sum::<u64>() % prime;
        (total != 0).then_some((run[0].0, total as u32))
    };
    terms.chunk_by(|a, b| a.0 == b.0).filter_map(sum).collect()
}
