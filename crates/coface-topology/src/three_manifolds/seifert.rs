//! Seifert fibered spaces: their invariants and names.

use super::layered::{bezout, normal};
use coface_algebra::{SparseMatrix, invariant_factors};
use std::fmt;

/// A closed orientable Seifert fibered space by its base and the invariants of fibers, up to orientation.
///
/// A fiber $(\alpha, \beta)$: the meridian of a tube around it is $\alpha\, q + \beta\, h$, with h a regular fiber and q the boundary of a section
/// outside of all tubes. The base is orientable with so many handles, or it has so many cross-caps and walks along them reverse fibers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeifertSpace {
    is_orientable: bool,
    genus: usize,
    fibers: Vec<(i64, i64)>,
}

impl SeifertSpace {
    /// The space with these fibers in its least form: 0 < β < α for all fibers but the last, which holds what is left, and of both
    /// orientations the one that is first in the order of numbers.
    ///
    /// `None` if a multiplicity is not positive.
    pub(super) fn new(is_orientable: bool, genus: usize, fibers: &[(i64, i64)]) -> Option<Self> {
        let form = |sign: i64| {
            let mut whole = 0_i64;
            let mut proper = Vec::new();
            for &(alpha, beta) in fibers {
                if alpha < 1 {
                    return None;
                }
                let beta = sign * beta;
                whole += beta.div_euclid(alpha);
                if alpha > 1 {
                    proper.push((alpha, beta.rem_euclid(alpha)));
                }
            }
            proper.sort_unstable();
            match proper.last_mut() {
                Some(last) => last.1 += whole * last.0,
                None => proper.push((1, whole)),
            }
            Some(proper)
        };
        let (one, two) = (form(1)?, form(-1)?);
        // The last fiber nearer to zero first.
        let key = |fibers: &Vec<(i64, i64)>| {
            let last = fibers.last().map_or(0, |last| last.1.abs());
            (fibers[..fibers.len() - 1].to_vec(), last, fibers.clone())
        };
        Some(Self { is_orientable, genus, fibers: if key(&one) <= key(&two) { one } else { two } })
    }

    /// Whether the base is orientable.
    pub fn is_base_orientable(&self) -> bool {
        self.is_orientable
    }

    /// The number of handles, or of cross-caps, of the base.
    pub fn base_genus(&self) -> usize {
        self.genus
    }

    /// The invariants $(\alpha, \beta)$ of the fibers; one $(1, b)$ if none is exceptional.
    pub fn fibers(&self) -> &[(i64, i64)] {
        &self.fibers
    }

    /// The number of exceptional fibers.
    pub(super) fn exceptional_count(&self) -> usize {
        self.fibers.iter().filter(|fiber| fiber.0 > 1).count()
    }

    /// The torsion and the rank of the first homology, from the presentation by sections and fibers.
    pub(super) fn first_homology(&self) -> Option<(Vec<String>, usize)> {
        let fibers = self.fibers.len();
        // Generators: a section around each fiber, the regular fiber, loops of the base.
        let loops = if self.is_orientable { 2 * self.genus } else { self.genus };
        let mut entries: Vec<(usize, usize, i64)> = Vec::new();
        for (relator, &(alpha, beta)) in self.fibers.iter().enumerate() {
            entries.extend([(relator, relator, alpha), (fibers, relator, beta), (relator, fibers, 1)]);
        }
        if !self.is_orientable {
            entries.extend((0..loops).map(|cross_cap| (fibers + 1 + cross_cap, fibers, 2)));
            entries.push((fibers, fibers + 1, 2));
        }
        entries.retain(|entry| entry.2 != 0);
        let count = fibers + 1 + loops;
        let matrix = SparseMatrix::from_entries(count, fibers + 2, entries).ok()?;
        let factors = invariant_factors(&matrix);
        let rank = count - factors.len();
        let torsion = factors.iter().map(ToString::to_string).filter(|factor| factor != "1").collect();
        Some((torsion, rank))
    }

    /// The lens space over the sphere with two fibers at most.
    pub(super) fn lens(&self) -> Option<(u64, u64)> {
        if !self.is_orientable || self.genus > 0 {
            return None;
        }
        let ((a, b), (c, d)) = match self.fibers[..] {
            [only] => (only, (1, 0)),
            [one, two] => (one, two),
            _ => return None,
        };
        let p = a * d + b * c;
        let (gcd, x, y) = bezout(a, b);
        // The other tube by a slope that meets the first meridian once.
        let q = c * x - d * y;
        (gcd == 1).then(|| normal(p.unsigned_abs(), q))
    }
}

impl fmt::Display for SeifertSpace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.is_orientable, self.genus, &self.fibers[..]) {
            (true, 1, [(1, 0)]) => return f.write_str("T x S1"),
            (false, 2, [(1, 0)]) => return f.write_str("KB/n2 x~ S1"),
            _ => {}
        }
        let base = match (self.is_orientable, self.genus) {
            (true, 0) => "S2".to_owned(),
            (true, 1) => "T".to_owned(),
            (true, genus) => format!("Or, g={genus}"),
            (false, 1) => "RP2/n2".to_owned(),
            (false, 2) => "KB/n2".to_owned(),
            (false, genus) => format!("Non-or, g={genus}/n2"),
        };
        let fibers: Vec<String> =
            self.fibers.iter().map(|(alpha, beta)| format!("({alpha},{beta})")).collect();
        write!(f, "SFS [{base}: {}]", fibers.join(" "))
    }
}
