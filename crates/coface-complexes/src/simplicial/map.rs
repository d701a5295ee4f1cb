//! Simplicial maps.

use super::FrozenComplex;
use coface_algebra::SparseMatrix;
use coface_algebra::chains::{ChainComplex, ChainMap};
use coface_algebra::{Error, ErrorKind};

/// A map of vertices that takes the vertices of each simplex of a source to those of a simplex of a target, of the same
/// dimension or less.
///
/// # Examples
/// See [`ChainMap`].
#[derive(Clone, Debug)]
pub struct SimplicialMap<'a> {
    source: &'a FrozenComplex,
    target: &'a FrozenComplex,
    /// The image of each vertex of the source, by its position.
    images: Vec<u32>,
}

impl<'a> SimplicialMap<'a> {
    /// The map that takes the first vertex of each pair to the second.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] for a vertex of a pair that is not there, [`ErrorKind::InvalidInput`] for a vertex of
    /// the source without image or with two, and naming a simplex whose image is no simplex of the target.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n simplices.
    pub fn new(
        source: &'a FrozenComplex,
        target: &'a FrozenComplex,
        vertices: impl IntoIterator<Item = (u32, u32)>,
    ) -> Result<Self, Error> {
        let mut images: Vec<Option<u32>> = vec![None; source.simplex_count(0)];
        for (from, to) in vertices {
            let missing = |vertex: u32, place: &str| {
                Error::new(
                    ErrorKind::NotInComplex,
                    format!("there is no vertex {vertex} in the {place} of the map"),
                )
            };
            let at = source.index_of(&[from]).ok_or_else(|| missing(from, "source"))?;
            target.index_of(&[to]).ok_or_else(|| missing(to, "target"))?;
            match images[at] {
                Some(other) if other != to => {
                    return Err(Error::invalid(format!("vertex {from} goes to {other} and to {to}"))
                        .with_cure("give each vertex one image"));
                }
                _ => images[at] = Some(to),
            }
        }
        if let Some(at) = images.iter().position(Option::is_none) {
            return Err(Error::invalid(format!("vertex {} has no image", source.numbers(0, at)[0]))
                .with_cure("give an image for each vertex of the source"));
        }
        let map = Self { source, target, images: images.into_iter().flatten().collect() };
        for dimension in 0..source.f_vector().len() {
            for i in 0..source.simplex_count(dimension) {
                let mut image = map.image(dimension, i);
                image.sort_unstable();
                image.dedup();
                if target.index_of(&image).is_none() {
                    return Err(Error::invalid(format!(
                        "the simplex {:?} goes to {image:?}, which is no simplex of the target",
                        source.numbers(dimension, i)
                    ))
                    .with_cure("give a map that takes simplices to simplices"));
                }
            }
        }
        Ok(map)
    }

    /// The images of the vertices of a simplex, in their order.
    fn image(&self, dimension: usize, i: usize) -> Vec<u32> {
        let position =
            |&number: &u32| self.source.index_of(&[number]).expect("a simplex has vertices of its complex");
        self.source.numbers(dimension, i).iter().map(|number| self.images[position(number)]).collect()
    }

    /// The chain map: a simplex goes to its image with the sign of the permutation that sorts the vertices, and to zero
    /// if two of them have one image. The complexes are those that `chain_complex()` of source and target gave.
    ///
    /// # Errors
    /// Those of [`ChainMap::new`], which other complexes would have.
    pub fn chain_map(&self, source: &ChainComplex, target: &ChainComplex) -> Result<ChainMap, Error> {
        let matrices = (0..source.degree_count()).map(|dimension| {
            let mut entries = Vec::new();
            for i in 0..source.cell_count(dimension) {
                let image = self.image(dimension, i);
                let mut sorted = image.clone();
                sorted.sort_unstable();
                if sorted.windows(2).any(|pair| pair[0] == pair[1]) {
                    continue;
                }
                let inversions = (0..image.len())
                    .map(|a| image[a + 1..].iter().filter(|&&other| other < image[a]).count())
                    .sum::<usize>();
                let row = self.target.index_of(&sorted).expect("images are simplices of the target");
                entries.push((row, i, if inversions % 2 == 0 { 1 } else { -1 }));
            }
            SparseMatrix::from_entries(target.cell_count(dimension), source.cell_count(dimension), entries)
        });
        ChainMap::new(source, target, matrices.collect::<Result<_, Error>>()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::known_spaces::{circle, simplex};

    #[test]
    fn faults_are_named() {
        let (four, three) = (circle(4).unwrap().freeze(), circle(3).unwrap().freeze());
        let fault = |pairs: &[(u32, u32)]| {
            SimplicialMap::new(&four, &three, pairs.iter().copied()).unwrap_err().to_string()
        };
        assert!(fault(&[(0, 0), (1, 1), (2, 2)]).contains("vertex 3 has no image"));
        assert!(fault(&[(0, 7)]).contains("no vertex 7 in the target"));
        assert!(fault(&[(0, 1), (0, 2)]).contains("vertex 0 goes to 1 and to 2"));
        let back = SimplicialMap::new(&three, &four, [(0, 0), (1, 1), (2, 2)]).unwrap_err();
        assert!(back.to_string().contains("goes to [0, 2]"), "{back}");
    }

    #[test]
    fn collapsed_simplices_vanish() {
        let (triangle, point) = (simplex(2).unwrap().freeze(), simplex(0).unwrap().freeze());
        let map = SimplicialMap::new(&triangle, &point, (0..3).map(|v| (v, 0))).unwrap();
        let (source, target) = (triangle.chain_complex().unwrap(), point.chain_complex().unwrap());
        let map = map.chain_map(&source, &target).unwrap();
        assert_eq!(map.matrix(0).unwrap().entry_count(), 3);
        assert_eq!(map.matrix(1).unwrap().entry_count(), 0);
    }
}
