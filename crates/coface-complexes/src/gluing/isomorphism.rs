//! Isomorphisms of gluing tables: the same table under other names.

use super::GluingTable;
use coface_algebra::{Permutation, narrow};
use std::collections::{BTreeMap, BTreeSet};

/// The names that simplices and vertices have in another table that is the same but for names.
///
/// [`GluingTable::relabeled`] with them gives the other table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GluingIsomorphism {
    simplices: Permutation,
    vertices: Vec<Permutation>,
}

impl GluingIsomorphism {
    /// Simplex i is simplex `image(i)` of the other table.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segments = GluingTable::unglued(1, 2)?;
    /// let found = segments.isomorphism(&segments).expect("the identity is one");
    /// assert_eq!(found.simplices().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn simplices(&self) -> &Permutation {
        &self.simplices
    }

    /// Vertex k of simplex i is vertex `[i].image(k)` of its simplex in the other table.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segments = GluingTable::unglued(1, 2)?;
    /// let found = segments.isomorphism(&segments).expect("the identity is one");
    /// assert_eq!(found.vertices()[0].len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn vertices(&self) -> &[Permutation] {
        &self.vertices
    }
}

impl GluingTable {
    /// An isomorphism to another table: names of its simplices and vertices with which this table is the other one. `None` if there
    /// is none.
    ///
    /// The image of the first simplex of a component says all others there: each is tried, with each order of vertices.
    ///
    /// # Complexity
    /// $O(d\, n)$ for each image of a first simplex that is followed to its end, among $(d + 1)!\, n$ for n simplices of
    /// dimension d. Most end early.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let read = |text| GluingTable::from_isomorphism_signature(text, 3);
    /// let (lens, other) = (read("cMcabbjxr")?, read("cMcabbgqw")?);
    /// assert!(lens.isomorphism(&other).is_none());
    /// let found = lens.isomorphism(&lens).expect("the identity is one");
    /// assert_eq!(lens.relabeled(found.simplices(), found.vertices())?, lens);
    /// # Ok(()) }
    /// ```
    pub fn isomorphism(&self, other: &Self) -> Option<GluingIsomorphism> {
        let count = self.simplex_count();
        if other.simplex_count() != count || (count > 0 && other.dimension() != self.dimension()) {
            return None;
        }
        let width = self.dimension() + 1;
        let orders = orders_of(width);
        let parts = |table: &Self| -> Vec<Vec<usize>> {
            let members = table.components().members();
            members.into_iter().map(|part| part.into_iter().map(|cell| cell.index()).collect()).collect()
        };
        let mut left = parts(other);
        let mut images: Vec<Option<(usize, Vec<u8>)>> = vec![None; count];
        for part in parts(self) {
            // Isomorphic components may be exchanged: the first that fits is as good as any.
            let found = left.iter().enumerate().filter(|(_, target)| target.len() == part.len()).find_map(
                |(at, target)| {
                    let starts =
                        target.iter().flat_map(|&simplex| orders.iter().map(move |order| (simplex, order)));
                    starts.into_iter().find_map(|(simplex, order)| {
                        self.followed(other, part[0], (simplex, order)).map(|map| (at, map))
                    })
                },
            );
            let (at, map) = found?;
            left.swap_remove(at);
            for (simplex, image) in map {
                images[simplex] = Some(image);
            }
        }
        let images: Option<Vec<(usize, Vec<u8>)>> = images.into_iter().collect();
        let images = images?;
        let permutation =
            |images: Vec<u32>| Permutation::from_images(images).expect("an isomorphism is one to one");
        Some(GluingIsomorphism {
            simplices: permutation(images.iter().map(|&(simplex, _)| narrow(simplex)).collect()),
            vertices: images
                .iter()
                .map(|(_, order)| permutation(order.iter().map(|&image| u32::from(image)).collect()))
                .collect(),
        })
    }

    /// The images of all simplices of a component, if its first one goes to a simplex of the other table in this order.
    #[expect(clippy::type_complexity, reason = "simplices with their images")]
    fn followed(
        &self,
        other: &Self,
        start: usize,
        (target, order): (usize, &[u8]),
    ) -> Option<Vec<(usize, (usize, Vec<u8>))>> {
        let mut map = BTreeMap::from([(start, (target, order.to_vec()))]);
        let mut taken = BTreeSet::from([target]);
        let mut queue = vec![start];
        while let Some(simplex) = queue.pop() {
            let (target, order) = map[&simplex].clone();
            for facet in 0..=self.dimension() {
                let ours = self.neighbor(simplex, facet);
                let theirs = other.neighbor(target, usize::from(order[facet]));
                let ((next, glued), (next_target, glued_target)) = match (ours, theirs) {
                    (None, None) => continue,
                    (Some(ours), Some(theirs)) => (ours, theirs),
                    _ => return None,
                };
                let mut next_order = vec![0; order.len()];
                for (vertex, &image) in glued.iter().enumerate() {
                    next_order[usize::from(image)] = glued_target[usize::from(order[vertex])];
                }
                match map.get(&next) {
                    Some(known) if *known == (next_target, next_order.clone()) => {}
                    Some(_) => return None,
                    None if taken.insert(next_target) => {
                        map.insert(next, (next_target, next_order));
                        queue.push(next);
                    }
                    None => return None,
                }
            }
        }
        Some(map.into_iter().collect())
    }
}

/// All orders of so many vertices.
fn orders_of(width: usize) -> Vec<Vec<u8>> {
    let mut orders = vec![Vec::new()];
    for vertex in 0..width as u8 {
        orders = orders
            .iter()
            .flat_map(|order: &Vec<u8>| {
                (0..=order.len()).map(move |place| {
                    let mut longer = order.clone();
                    longer.insert(place, vertex);
                    longer
                })
            })
            .collect();
    }
    orders
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const CENSUS: [&str; 6] =
        ["cMcabbgqw", "cMcabbjxr", "cPcbbbiht", "dLQbcccdero", "eLPkbcddddcwjb", "cMcabbjak"];

    fn table(text: &str) -> Option<GluingTable> {
        GluingTable::from_isomorphism_signature(text, 3).ok()
    }

    /// The same verdict as signatures, for all pairs, two components among them.
    #[test]
    fn isomorphisms_agree_with_signatures() {
        let mut tables: Vec<GluingTable> = CENSUS.iter().filter_map(|text| table(text)).collect();
        assert!(tables.len() >= 4);
        tables.extend(["cMcabbgqwcMcabbjxr", "cMcabbjxrcMcabbgqw"].iter().filter_map(|text| table(text)));
        for a in &tables {
            for b in &tables {
                let is_same = a.isomorphism_signature().unwrap() == b.isomorphism_signature().unwrap();
                let found = a.isomorphism(b);
                assert_eq!(found.is_some(), is_same);
                if let Some(found) = found {
                    assert_eq!(&a.relabeled(found.simplices(), found.vertices()).unwrap(), b);
                }
            }
        }
    }

    proptest! {
        #[test]
        fn tables_under_other_names_are_found(
            which in 0..CENSUS.len(),
            orders in prop::collection::vec(Just((0u32..4).collect::<Vec<_>>()).prop_shuffle(), 8),
            seed in any::<u64>(),
        ) {
            let Some(table) = table(CENSUS[which]) else { return Ok(()) };
            let count = table.simplex_count();
            let mut names: Vec<u32> = (0..count as u32).collect();
            names.rotate_left((seed % count as u64) as usize);
            let permutation = |images: &[u32]| Permutation::from_images(images.to_vec()).unwrap();
            let vertices: Vec<Permutation> = orders[..count].iter().map(|order| permutation(order)).collect();
            let other = table.relabeled(&permutation(&names), &vertices).unwrap();
            let found = table.isomorphism(&other).unwrap();
            prop_assert_eq!(table.relabeled(found.simplices(), found.vertices()).unwrap(), other);
        }
    }
}
