//! Components: what is connected, through vertices or through faces of a given dimension.

use super::{Simplex, SimplicialComplex};
use crate::components::Components;
use coface_algebra::UnionFind;
use coface_algebra::VertexId;

impl Simplex {
    /// Whether two simplices are s-adjacent: they have a common face of dimension s.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// let (a, b) = (Simplex::from([0, 1, 2]), Simplex::from([1, 2, 3]));
    /// assert!(a.is_adjacent(&b, 0) && a.is_adjacent(&b, 1) && !a.is_adjacent(&b, 2));
    /// ```
    pub fn is_adjacent(&self, other: &Self, s: usize) -> bool {
        self.intersection(other).is_some_and(|common| common.dimension() >= s)
    }
}

impl SimplicialComplex {
    /// The connected components, in the order of their least vertices.
    ///
    /// # Complexity
    /// Nearly linear in vertices and edges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([vec![0, 4], vec![1], vec![2, 3, 4]])?;
    /// let components = complex.components();
    /// assert_eq!(components.members(), [[0, 2, 3, 4].map(VertexId::new).to_vec(), vec![VertexId::new(1)]]);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> Components {
        let vertices: Vec<VertexId> = self.vertices().collect();
        let position = |v: u32| {
            vertices.binary_search(&VertexId::from_u32(v)).expect("ends of edges are vertices") as u32
        };
        let mut partition = UnionFind::new(vertices.len());
        for edge in self.simplices(1) {
            partition.unite(position(edge.numbers()[0]), position(edge.numbers()[1]));
        }
        Components::of_cells(vertices, partition)
    }

    /// The classes of the simplices of one dimension that chains of s-adjacent ones connect, each in lexicographic
    /// order, by their first members.
    ///
    /// # Complexity
    /// $O(m \log m)$ for m pairs of such a simplex and a face of it of dimension s.
    ///
    /// # Examples
    /// Two triangles with a common vertex:
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([[0, 1, 2], [2, 3, 4]])?;
    /// assert_eq!(complex.adjacency_classes(2, 0).len(), 1);
    /// assert_eq!(complex.adjacency_classes(2, 1).len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn adjacency_classes(&self, dimension: usize, s: usize) -> Vec<Vec<Simplex>> {
        classes_through_faces(self.simplices(dimension).collect(), |_| s)
    }

    /// The strongly connected components: the classes of facets that chains of common faces of codimension one connect,
    /// each in lexicographic order, by their first members. Facets of different dimensions are never in one class.
    ///
    /// # Complexity
    /// $O(m \log m)$ for m pairs of a facet and a face of codimension one.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([vec![0, 1, 2], vec![1, 2, 3], vec![3, 4, 5], vec![5, 6]])?;
    /// assert_eq!(complex.strong_components().len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn strong_components(&self) -> Vec<Vec<Simplex>> {
        classes_through_faces(self.facets(), |facet| facet.dimension().wrapping_sub(1))
    }
}

/// The classes of simplices of the same dimension that have common faces of a dimension that `through` says.
fn classes_through_faces(simplices: Vec<Simplex>, through: impl Fn(&Simplex) -> usize) -> Vec<Vec<Simplex>> {
    let mut incidences: Vec<(usize, Simplex, u32)> = Vec::new();
    for (i, simplex) in simplices.iter().enumerate() {
        let faces = simplex.faces_of_dimension(through(simplex));
        incidences.extend(faces.map(|face| (simplex.dimension(), face, i as u32)));
    }
    incidences.sort_unstable();
    let mut partition = UnionFind::new(simplices.len());
    for pair in incidences.windows(2) {
        if (pair[0].0, &pair[0].1) == (pair[1].0, &pair[1].1) {
            partition.unite(pair[0].2, pair[1].2);
        }
    }
    classes(simplices, &mut partition)
}

/// The members of each class, in their order; classes in the order of their first members.
fn classes<T>(members: Vec<T>, partition: &mut UnionFind) -> Vec<Vec<T>> {
    let mut classes: Vec<Vec<T>> = (0..partition.class_count()).map(|_| Vec::new()).collect();
    for (member, class) in members.into_iter().zip(partition.class_numbers()) {
        classes[class as usize].push(member);
    }
    classes
}

#[cfg(test)]
mod tests {
    use super::super::neighborhood::tests::complex_and_part;
    use super::*;
    use proptest::prelude::*;

    /// The classes of a relation by spreading from member to member.
    fn spread<T: Clone + PartialEq>(members: &[T], related: impl Fn(&T, &T) -> bool) -> Vec<Vec<T>> {
        let mut class: Vec<usize> = (0..members.len()).collect();
        for _ in members {
            for i in 0..members.len() {
                for j in 0..members.len() {
                    if related(&members[i], &members[j]) {
                        class[i] = class[i].min(class[j]);
                    }
                }
            }
        }
        let with = |c: usize| -> Vec<T> {
            (0..members.len()).filter(|&i| class[i] == c).map(|i| members[i].clone()).collect()
        };
        (0..members.len()).map(with).filter(|c| !c.is_empty()).collect()
    }

    proptest! {
        #[test]
        fn classes_are_those_of_the_relation((k, _) in complex_and_part(), dimension in 0usize..4, s in 0usize..4) {
            let simplices: Vec<Simplex> = k.simplices(dimension).collect();
            prop_assert_eq!(k.adjacency_classes(dimension, s), spread(&simplices, |a, b| a == b || a.is_adjacent(b, s)));
            let strong = spread(&k.facets(), |a, b| {
                a == b || (a.dimension() == b.dimension() && a.dimension() > 0 && a.is_adjacent(b, a.dimension() - 1))
            });
            prop_assert_eq!(k.strong_components(), strong);
            let vertices: Vec<VertexId> = k.vertices().collect();
            let edge = |a: &VertexId, b: &VertexId| a == b || k.contains(&Simplex::new([*a, *b]).unwrap());
            let expected = spread(&vertices, edge);
            let components = k.components();
            prop_assert_eq!(components.members(), &expected[..]);
            for (number, members) in expected.iter().enumerate() {
                prop_assert!(members.iter().all(|&vertex| components.of(vertex) == number));
            }
        }
    }
}
