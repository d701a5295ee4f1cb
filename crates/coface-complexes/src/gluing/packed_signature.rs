//! Isomorphism signatures of the second generation: a row of bits. Their format is described with those of the first.

use super::isomorphism_signature::{ReadGluing, Text, factorial, unrank};
use coface_algebra::{Error, Sign};

/// How many bits a number takes that is at most this one.
fn bit_count(last: u64) -> usize {
    (u64::BITS - last.leading_zeros()) as usize
}

/// The permutation at a place where of each two in lexicographic order the even one comes first.
fn even_first(count: usize, place: u64) -> Vec<u32> {
    let images = unrank(count, place);
    let inversions =
        (0..count).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| images[i] > images[j]);
    let sign = if inversions.count().is_multiple_of(2) { Sign::Plus } else { Sign::Minus };
    let wanted = if place.is_multiple_of(2) { Sign::Plus } else { Sign::Minus };
    if sign == wanted { images } else { unrank(count, place ^ 1) }
}

/// The bits of a signature from a character on.
struct Bits<'t, 'a> {
    text: &'t Text<'a>,
    at: usize,
}

impl Bits<'_, '_> {
    /// The character of the next bit.
    fn place(&self) -> usize {
        self.at / 6
    }

    /// A number of so many bits.
    fn number(&mut self, width: usize, what: &str) -> Result<u64, Error> {
        let mut number = 0;
        for bit in 0..width {
            let Some(digit) = self.text.digits.get(self.at / 6) else {
                return Err(self.text.fault(self.at / 6, &format!("{what} is missing")));
            };
            number |= u64::from(digit >> (self.at % 6) & 1) << bit;
            self.at += 1;
        }
        Ok(number)
    }
}

impl Text<'_> {
    /// Reads what follows the number of simplices of a component, which are numbered from `first`.
    pub(super) fn packed_component(
        &mut self,
        count: usize,
        facets: usize,
        first: usize,
        gluings: &mut Vec<ReadGluing>,
    ) -> Result<(), Error> {
        let end = {
            let mut bits = Bits { text: self, at: 6 * self.at };
            bits.number(2, "the mark of the second generation")?;
            let is_odd = bits.number(1, "the bit for odd permutations")? == 1;
            let (targets, boundary_count) = targets(&mut bits, count, facets)?;
            // All facets once: a gluing to a new simplex has two.
            let fresh_count = count - 1;
            let kind_count = fresh_count + targets.len();
            let kinds_at = bits.at;
            let mut kinds = Vec::with_capacity(kind_count);
            for _ in 0..kind_count {
                kinds.push(bits.number(1, "the type of a facet")? == 1);
            }
            kinds.reverse();
            if kinds.iter().filter(|&&is_known| is_known).count() != targets.len() {
                let what =
                    format!("begins types of facets with other than {} gluings to new simplices", count - 1);
                return Err(self.fault(kinds_at / 6, &what));
            }
            let total = factorial(facets);
            let width = bit_count(total - 1);
            let mut permutations = Vec::with_capacity(targets.len() - boundary_count);
            for _ in boundary_count..targets.len() {
                let place = bits.place();
                let what = "the permutation of a gluing";
                let number =
                    if is_odd { 2 * bits.number(width - 1, what)? + 1 } else { bits.number(width, what)? };
                if number >= total {
                    return Err(
                        self.fault(place, &format!("names permutation {number}, but there are {total}"))
                    );
                }
                permutations.push((place, even_first(facets, number)));
            }
            let end = bits.at.div_ceil(6);
            if bits.number(6 * end - bits.at, "the last bit")? != 0 {
                return Err(self.fault(end - 1, "has bits that mean nothing"));
            }
            self.assemble_packed((count, facets, first), &kinds, &targets, permutations, gluings)?;
            end
        };
        self.at = end;
        Ok(())
    }

    /// The gluings that types, targets and permutations mean.
    fn assemble_packed(
        &self,
        (count, facets, first): (usize, usize, usize),
        kinds: &[bool],
        targets: &[(usize, usize)],
        permutations: Vec<(usize, Vec<u32>)>,
        gluings: &mut Vec<ReadGluing>,
    ) -> Result<(), Error> {
        let mut is_glued = vec![false; count * facets];
        let (mut kinds, mut targets, mut permutations) =
            (kinds.iter(), targets.iter(), permutations.into_iter());
        let exchange: Vec<u32> = [1, 0].into_iter().chain(2..facets as u32).collect();
        let (mut met, mut place) = (1, self.at);
        for simplex in 0..count {
            if simplex >= met {
                return Err(
                    self.fault(place, &format!("leaves out simplex {simplex}, which no gluing reaches"))
                );
            }
            for facet in 0..facets {
                if is_glued[simplex * facets + facet] {
                    continue;
                }
                let Some(&is_known) = kinds.next() else {
                    return Err(self.fault(place, "leaves a facet without a type"));
                };
                let (other, images) = if is_known {
                    let Some(&(at, target)) = targets.next() else { continue };
                    place = at;
                    if target == count {
                        continue;
                    }
                    let Some((at, images)) = permutations.next() else { continue };
                    if target >= met {
                        return Err(self
                            .fault(place, &format!("names simplex {target}, which no gluing has reached")));
                    }
                    place = at;
                    (target, images)
                } else {
                    met += 1;
                    (met - 1, exchange.clone())
                };
                let partner = other * facets + images[facet] as usize;
                if other >= count || is_glued[partner] || partner == simplex * facets + facet {
                    return Err(self.fault(place, "means a gluing to a facet that is glued already"));
                }
                is_glued[simplex * facets + facet] = true;
                is_glued[partner] = true;
                gluings.push((place, first + simplex, facet, first + other, images));
            }
        }
        Ok(())
    }
}

/// The simplices of the facets that are no gluings to new ones, with the places of their characters, and how many of them are boundary.
fn targets(
    bits: &mut Bits<'_, '_>,
    count: usize,
    facets: usize,
) -> Result<(Vec<(usize, usize)>, usize), Error> {
    let width = bit_count(count as u64);
    let (mut reached, mut boundary_count, mut targets) = (2 * (count - 1), 0, Vec::new());
    while reached < count * facets {
        let place = bits.place();
        let target = bits.number(width, "the simplex of a gluing")? as usize;
        if target > count {
            return Err(bits.text.fault(place, &format!("names simplex {target}, but there are {count}")));
        }
        boundary_count += usize::from(target == count);
        reached += if target == count { 1 } else { 2 };
        targets.push((place, target));
    }
    if reached > count * facets {
        return Err(bits.text.fault(bits.place(), "glues the last facet to none"));
    }
    Ok((targets, boundary_count))
}

#[cfg(test)]
mod tests {
    use crate::gluing::GluingTable;

    fn table(signature: &str) -> Result<GluingTable, coface_algebra::Error> {
        GluingTable::from_isomorphism_signature(signature, 3)
    }

    /// Triangulations of Regina's census by both of their signatures (B. A. Burton).
    #[test]
    fn both_generations_are_read() {
        for (second, first) in [
            ("bNha", "bkaagb"),
            ("bNhc", "bkaagj"),
            ("bNjc", "bkaajj"),
            ("bNjd", "bkaajn"),
            ("cV6gaa", "cPcbbbahh"),
            ("cN6OXa", "cMcabbjaj"),
            ("hVCC2+FGIiSSCb", "hLALMkbcceffggemkbtibj"),
        ] {
            let found = table(second).unwrap();
            assert_eq!(found.isomorphism_signature().unwrap(), first, "{second}");
        }
    }

    #[test]
    fn what_is_cut_or_changed_is_named() {
        for (signature, expected) in [
            ("bN", "is missing"),
            ("bNj", "is missing"),
            ("cV6g", "is missing"),
            ("bNjcz", "begins a part of 25 simplices"),
            ("bNj_", "is none of"),
        ] {
            let message = table(signature).unwrap_err().message().to_owned();
            assert!(message.contains(expected), "{signature}: {message}");
        }
    }
}
