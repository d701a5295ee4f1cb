//! New complexes from old: join, cone, suspension, disjoint union, wedge, connected sum, barycentric subdivision.
//!
//! Labels: the vertices of the first complex keep their numbers. Those of a second complex are shifted past the
//! greatest number of the first, and new vertices (apexes) come after all others. [`Composite`] says where the vertices of
//! the second complex went.

use super::{Simplex, SimplicialComplex};
use coface_algebra::{Error, ErrorKind, IdVec, VertexId};

/// A complex made of two. The vertices of the first keep their numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Composite {
    complex: SimplicialComplex,
    shift: u32,
    /// Vertices of the second complex that became vertices of the first, sorted.
    identified: Vec<(u32, u32)>,
}

impl Composite {
    /// The complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = simplex_boundary(1)?;
    /// let eight = circle.wedge(VertexId::new(0), &circle, VertexId::new(0))?;
    /// assert_eq!(eight.complex().f_vector(), [5, 6]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &SimplicialComplex {
        &self.complex
    }

    /// The complex alone.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = simplex_boundary(1)?;
    /// let eight = circle.wedge(VertexId::new(0), &circle, VertexId::new(0))?;
    /// assert_eq!(eight.into_complex().f_vector(), [5, 6]);
    /// # Ok(()) }
    /// ```
    pub fn into_complex(self) -> SimplicialComplex {
        self.complex
    }

    /// The vertex of the whole that a vertex of the second complex became.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = simplex_boundary(1)?;
    /// let eight = circle.wedge(VertexId::new(0), &circle, VertexId::new(0))?;
    /// assert_eq!(eight.second_label(VertexId::new(0)), VertexId::new(0));
    /// # Ok(()) }
    /// ```
    pub fn second_label(&self, vertex: VertexId) -> VertexId {
        VertexId::from_u32(
            Placement { shift: self.shift, identified: &self.identified }.label(vertex.to_u32()),
        )
    }
}

/// Where the vertices of a second complex go.
struct Placement<'a> {
    shift: u32,
    identified: &'a [(u32, u32)],
}

impl Placement<'_> {
    fn label(&self, vertex: u32) -> u32 {
        match self.identified.binary_search_by_key(&vertex, |&(from, _)| from) {
            Ok(at) => self.identified[at].1,
            Err(_) => vertex + self.shift,
        }
    }

    fn image(&self, simplex: &Simplex) -> Vec<u32> {
        simplex.numbers().iter().map(|&v| self.label(v)).collect()
    }
}

impl SimplicialComplex {
    /// The first vertex number above all that are used.
    fn next_label(&self) -> u64 {
        self.vertices().last().map_or(0, |v| u64::from(v.to_u32()) + 1)
    }

    /// Room for `count` new vertices: the first of their numbers.
    fn new_labels(&self, count: u64) -> Result<u32, Error> {
        let first = self.next_label();
        u32::try_from(first + count).map(|_| first as u32).map_err(|_| {
            Error::new(
                ErrorKind::TooLarge,
                format!("vertex numbers from {first} on do not leave room for {count} more"),
            )
            .with_cure("renumber the vertices from 0")
        })
    }

    fn composite(
        &self,
        other: &Self,
        mut identified: Vec<(u32, u32)>,
        facets: impl FnOnce(&Placement<'_>) -> Vec<Vec<u32>>,
    ) -> Result<Composite, Error> {
        let shift = self.new_labels(other.next_label())?;
        identified.sort_unstable();
        let complex = Self::from_facets(facets(&Placement { shift, identified: &identified }))?;
        Ok(Composite { complex, shift, identified })
    }

    /// The disjoint union.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if vertex numbers run out.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = SimplicialComplex::from_facets([[0, 1]])?;
    /// let two = edge.disjoint_union(&edge)?;
    /// assert_eq!(two.complex().f_vector(), [4, 2]);
    /// assert_eq!(two.second_label(VertexId::new(0)), VertexId::new(2));
    /// # Ok(()) }
    /// ```
    pub fn disjoint_union(&self, other: &Self) -> Result<Composite, Error> {
        self.composite(other, Vec::new(), |placement| {
            let first = self.facets().into_iter().map(|facet| facet.numbers().to_vec());
            first.chain(other.facets().iter().map(|facet| placement.image(facet))).collect()
        })
    }

    /// The wedge: the union in which a vertex of one complex is a vertex of the other, and nothing else is common.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if one of the vertices is not there; [`ErrorKind::TooLarge`] if vertex numbers run out.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (circle, v) = (known_spaces::circle(3)?, VertexId::new(0));
    /// let eight = circle.wedge(v, &circle, v)?;
    /// assert_eq!(eight.complex().f_vector(), [5, 6]);
    /// assert_eq!(eight.second_label(v), v);
    /// # Ok(()) }
    /// ```
    pub fn wedge(&self, at: VertexId, other: &Self, other_at: VertexId) -> Result<Composite, Error> {
        self.require(&Simplex::vertex(at))?;
        other.require(&Simplex::vertex(other_at))?;
        self.composite(other, vec![(other_at.to_u32(), at.to_u32())], |placement| {
            let first = self.facets().into_iter().map(|facet| facet.numbers().to_vec());
            first.chain(other.facets().iter().map(|facet| placement.image(facet))).collect()
        })
    }

    /// The join: all simplices of both, and each simplex of one spanned together with each of the other. The join with
    /// the empty complex changes nothing.
    ///
    /// # Errors
    /// As [`SimplicialComplex::from_facets`]; [`ErrorKind::TooLarge`] if vertex numbers run out.
    ///
    /// # Examples
    /// Two circles join to a 3-sphere.
    /// ```
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = known_spaces::circle(3)?;
    /// assert_eq!(circle.join(&circle)?.complex().f_vector(), [6, 15, 18, 9]);
    /// # Ok(()) }
    /// ```
    pub fn join(&self, other: &Self) -> Result<Composite, Error> {
        let or_none = |complex: &Self| {
            let facets = complex.facets();
            if facets.is_empty() { vec![None] } else { facets.into_iter().map(Some).collect() }
        };
        self.composite(other, Vec::new(), |placement| {
            let second = or_none(other);
            let mut facets = Vec::new();
            for first in or_none(self) {
                for second in &second {
                    let mut facet = first.as_ref().map_or(Vec::new(), |facet| facet.numbers().to_vec());
                    facet.extend(second.iter().flat_map(|facet| placement.image(facet)));
                    facets.push(facet);
                }
            }
            facets.retain(|facet| !facet.is_empty());
            facets
        })
    }

    /// The cone: the join with one new vertex, the apex. The cone of the empty complex is a point.
    ///
    /// # Errors
    /// As [`Self::join`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (disk, apex) = known_spaces::circle(5)?.cone()?;
    /// assert_eq!((disk.f_vector(), apex), (vec![6, 10, 5], VertexId::new(5)));
    /// # Ok(()) }
    /// ```
    pub fn cone(&self) -> Result<(Self, VertexId), Error> {
        let apex = Self::from_facets([[0]])?;
        let cone = self.join(&apex)?;
        let label = cone.second_label(VertexId::new(0));
        Ok((cone.into_complex(), label))
    }

    /// The suspension: the join with two new vertices, the apexes. The suspension of the empty complex is two points.
    ///
    /// # Errors
    /// As [`Self::join`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (sphere, apexes) = known_spaces::circle(4)?.suspension()?;
    /// assert_eq!(sphere.f_vector(), [6, 12, 8]);
    /// assert_eq!(apexes.map(|v| v.index()), [4, 5]);
    /// # Ok(()) }
    /// ```
    pub fn suspension(&self) -> Result<(Self, [VertexId; 2]), Error> {
        let apexes = Self::from_facets([[0], [1]])?;
        let suspension = self.join(&apexes)?;
        let labels = [0, 1].map(|i| suspension.second_label(VertexId::new(i)));
        Ok((suspension.into_complex(), labels))
    }

    /// The connected sum: a facet of each complex is taken out, and their rims are identified, vertex by vertex in the
    /// orders given. Of manifolds it is a manifold; an odd permutation of one order reverses the orientation of that
    /// summand.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] unless both are facets of the top dimension; [`ErrorKind::InvalidInput`] if their
    /// dimensions differ, are 0, or a vertex is repeated; [`ErrorKind::TooLarge`] if vertex numbers run out.
    ///
    /// # Examples
    /// Two tori with 7 vertices make a surface of genus 2 with 11.
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = known_spaces::cyclic_torus(2)?;
    /// let facet = [0, 1, 3].map(VertexId::new);
    /// assert_eq!(torus.connected_sum(&facet, &torus, &facet)?.complex().f_vector(), [11, 39, 26]);
    /// # Ok(()) }
    /// ```
    pub fn connected_sum(
        &self,
        facet: &[VertexId],
        other: &Self,
        other_facet: &[VertexId],
    ) -> Result<Composite, Error> {
        let [out, other_out] = [(self, facet), (other, other_facet)].map(|(complex, order)| {
            let simplex = Simplex::new(order.iter().copied())?;
            complex.require(&simplex)?;
            if Some(simplex.dimension()) != complex.dimension() {
                return Err(Error::new(
                    ErrorKind::NotInComplex,
                    format!("{simplex} is no facet of the top dimension"),
                )
                .with_cure("name a simplex of the dimension of its complex"));
            }
            Ok(simplex)
        });
        let (out, other_out) = (out?, other_out?);
        if facet.len() != other_facet.len() || facet.len() < 2 {
            return Err(Error::invalid(format!(
                "{out} and {other_out} have no connected sum; both must have the same dimension, 1 or more"
            )));
        }
        let identified =
            other_facet.iter().zip(facet).map(|(from, to)| (from.to_u32(), to.to_u32())).collect();
        self.composite(other, identified, |placement| {
            let first = self.facets().into_iter().filter(|f| *f != out).map(|f| f.numbers().to_vec());
            let rim = out.facets().map(|(_, ridge)| ridge.numbers().to_vec());
            let second = other.facets().into_iter().filter(|f| *f != other_out).map(|f| placement.image(&f));
            first.chain(rim).chain(second).collect()
        })
    }

    /// The barycentric subdivision, and the simplex in whose middle each new vertex lies.
    ///
    /// The new vertices are numbered by the dimensions of their simplices, and in lexicographic order within one; a
    /// set of them spans a simplex when their simplices form a chain of faces.
    ///
    /// # Errors
    /// As [`SimplicialComplex::from_facets`].
    ///
    /// # Complexity
    /// A facet of dimension d becomes $(d+1)!$ facets.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (triangles, middles) = SimplicialComplex::from_facets([[0, 1, 2]])?.barycentric_subdivision()?;
    /// assert_eq!(triangles.f_vector(), [7, 12, 6]);
    /// assert_eq!(middles[VertexId::new(3)], Simplex::from([0, 1]));
    /// # Ok(()) }
    /// ```
    pub fn barycentric_subdivision(&self) -> Result<(Self, IdVec<VertexId, Simplex>), Error> {
        let top = self.dimension().map_or(0, |n| n + 1);
        let mut starts = vec![0];
        let mut levels: Vec<Vec<Simplex>> = Vec::with_capacity(top);
        for k in 0..top {
            levels.push(self.simplices(k).collect());
            starts.push(starts[k] + levels[k].len());
        }
        if u32::try_from(starts[top]).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{} simplices exceed 32-bit vertex numbers", starts[top]),
            ));
        }
        let number = |simplex: &Simplex| {
            let k = simplex.dimension();
            (starts[k]
                + levels[k].binary_search(simplex).expect("a complex holds the faces of its simplices"))
                as u32
        };
        // Every chain of faces from a vertex up to a facet, built from the facet down.
        fn descend(
            simplex: &Simplex,
            number: &dyn Fn(&Simplex) -> u32,
            chain: &mut Vec<u32>,
            all: &mut Vec<Vec<u32>>,
        ) {
            chain.push(number(simplex));
            if simplex.dimension() == 0 {
                all.push(chain.clone());
            }
            for (_, face) in simplex.facets() {
                descend(&face, number, chain, all);
            }
            chain.pop();
        }
        let mut chains = Vec::new();
        for facet in self.facets() {
            descend(&facet, &number, &mut Vec::new(), &mut chains);
        }
        Ok((Self::from_facets(chains)?, levels.into_iter().flatten().collect()))
    }

    /// The product, triangulated by staircases: a chain of vertices (v, w) spans a simplex when both coordinates rise
    /// weakly and span simplices of their complexes. With it, the pair of each vertex: they are numbered in
    /// lexicographic order.
    ///
    /// # Errors
    /// As [`SimplicialComplex::from_facets`]; [`ErrorKind::TooLarge`] if vertex numbers run out.
    ///
    /// # Complexity
    /// Facets of dimensions p and q make $\binom{p+q}{p}$ facets.
    ///
    /// # References
    /// S. Eilenberg, N. Steenrod, *Foundations of algebraic topology* (1952), chapter II, section 8.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = known_spaces::circle(3)?;
    /// let (torus, pairs) = circle.product(&circle)?;
    /// assert_eq!(torus.f_vector(), [9, 27, 18]);
    /// assert_eq!(pairs.len(), 9);
    /// # Ok(()) }
    /// ```
    pub fn product(&self, other: &Self) -> Result<(Self, VertexPairs), Error> {
        let (first, second): (Vec<VertexId>, Vec<VertexId>) =
            (self.vertices().collect(), other.vertices().collect());
        if first.len().checked_mul(second.len()).is_none_or(|count| u32::try_from(count).is_err()) {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "a product of {} by {} vertices exceeds 32-bit vertex numbers",
                    first.len(),
                    second.len()
                ),
            ));
        }
        let place =
            |of: &[VertexId], v: VertexId| of.binary_search(&v).expect("a complex lists its vertices");
        let mut facets = Vec::new();
        let others = other.facets();
        for a in self.facets() {
            let columns: Vec<usize> = a.vertices().map(|v| place(&first, v)).collect();
            for b in &others {
                let rows: Vec<usize> = b.vertices().map(|w| place(&second, w)).collect();
                staircases(columns.len() - 1, rows.len() - 1, &mut |steps| {
                    let vertex = |&(i, j): &Place| (columns[i] * second.len() + rows[j]) as u32;
                    facets.push(steps.iter().map(vertex).collect::<Vec<u32>>());
                });
            }
        }
        let pairs = first.iter().flat_map(|&v| second.iter().map(move |&w| (v, w))).collect();
        Ok((Self::from_facets(facets)?, pairs))
    }
}

/// The pair of vertices that each vertex of a product is.
pub type VertexPairs = IdVec<VertexId, (VertexId, VertexId)>;

type Place = (usize, usize);

/// Calls `visit` with every walk from (0, 0) to (p, q) in steps of one along either axis.
fn staircases(p: usize, q: usize, visit: &mut dyn FnMut(&[Place])) {
    fn walk(p: usize, q: usize, steps: &mut Vec<Place>, visit: &mut dyn FnMut(&[Place])) {
        let &(i, j) = steps.last().expect("a walk has its start");
        if (i, j) == (p, q) {
            return visit(steps);
        }
        for next in [(i + 1, j), (i, j + 1)] {
            if next.0 <= p && next.1 <= q {
                steps.push(next);
                walk(p, q, steps, visit);
                steps.pop();
            }
        }
    }
    walk(p, q, &mut vec![(0, 0)], visit);
}

#[cfg(test)]
mod tests {
    use super::super::SimplexSet;
    use super::super::neighborhood::tests::complex_and_part;
    use super::*;
    use proptest::prelude::*;

    fn polynomial(f_vector: &[usize], with_empty: bool) -> Vec<i64> {
        let mut all = vec![i64::from(with_empty)];
        all.extend(f_vector.iter().map(|&n| n as i64));
        all
    }

    fn times(a: &[i64], b: &[i64]) -> Vec<i64> {
        let mut product = vec![0; a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        product
    }

    proptest! {
        #[test]
        fn counts_of_composites((k, _) in complex_and_part(), (l, _) in complex_and_part()) {
            let chi = |c: &SimplicialComplex| c.euler_characteristic();
            let union = k.disjoint_union(&l).unwrap().into_complex();
            prop_assert_eq!(union.len(), k.len() + l.len());
            prop_assert_eq!(union.components().count(), k.components().count() + l.components().count());
            // With the empty simplex counted, the f-polynomial of a join is the product.
            let join = k.join(&l).unwrap().into_complex();
            let product = times(&polynomial(&k.f_vector(), true), &polynomial(&l.f_vector(), true));
            prop_assert_eq!(polynomial(&join.f_vector(), true), product);
            let (cone, apex) = k.cone().unwrap();
            prop_assert_eq!(chi(&cone), 1);
            prop_assert_eq!(SimplexSet::from(&cone.link(Simplex::vertex(apex)).unwrap()), SimplexSet::from(&k));
            prop_assert_eq!(chi(&k.suspension().unwrap().0), 2 - chi(&k));
            let (product, pairs) = k.product(&l).unwrap();
            prop_assert_eq!(chi(&product), chi(&k) * chi(&l));
            prop_assert_eq!(product.simplex_count(0), pairs.len());
            if let (Some(v), Some(w)) = (k.vertices().next(), l.vertices().last()) {
                let wedge = k.wedge(v, &l, w).unwrap();
                prop_assert_eq!(wedge.second_label(w), v);
                prop_assert_eq!(wedge.complex().len(), k.len() + l.len() - 1);
            }
        }

        #[test]
        fn the_subdivision_has_the_chains_of_faces((k, _) in complex_and_part()) {
            let (fine, middles) = k.barycentric_subdivision().unwrap();
            prop_assert_eq!(middles.len(), k.len());
            prop_assert_eq!(fine.euler_characteristic(), k.euler_characteristic());
            for simplex in fine.iter() {
                let chain: Vec<&Simplex> = simplex.vertices().map(|v| &middles[v]).collect();
                prop_assert!(chain.windows(2).all(|pair| pair[0].is_face_of(pair[1]) && pair[0] != pair[1]));
            }
            let all: Vec<Simplex> = k.iter().collect();
            let pairs = all.iter().flat_map(|a| all.iter().map(move |b| (a, b))).filter(|(a, b)| a != b && a.is_face_of(b));
            prop_assert_eq!(fine.simplex_count(1), pairs.count());
        }
    }

    #[test]
    fn empty_complexes_are_ordinary() {
        let (empty, edge) = (SimplicialComplex::new(), SimplicialComplex::from_facets([[0, 1]]).unwrap());
        assert_eq!(empty.join(&edge).unwrap().complex(), &edge);
        assert_eq!(edge.join(&empty).unwrap().complex(), &edge);
        assert!(empty.join(&empty).unwrap().complex().is_empty());
        assert_eq!(empty.cone().unwrap().0.f_vector(), [1]);
        assert_eq!(empty.suspension().unwrap().0.f_vector(), [2]);
        assert!(empty.barycentric_subdivision().unwrap().0.is_empty());
        assert!(empty.product(&edge).unwrap().0.is_empty());
    }

    #[test]
    fn faults_name_the_place() {
        let edge = SimplicialComplex::from_facets([[0, 1]]).unwrap();
        let far = SimplicialComplex::from_facets([[u32::MAX]]).unwrap();
        assert_eq!(far.cone().unwrap_err().kind(), ErrorKind::TooLarge);
        assert_eq!(
            edge.wedge(VertexId::new(5), &edge, VertexId::new(0)).unwrap_err().kind(),
            ErrorKind::NotInComplex
        );
        let [a, b] = [0, 1].map(VertexId::new);
        assert_eq!(edge.connected_sum(&[a], &edge, &[a]).unwrap_err().kind(), ErrorKind::NotInComplex);
        assert_eq!(edge.connected_sum(&[a, a], &edge, &[a, b]).unwrap_err().kind(), ErrorKind::InvalidInput);
        let point = SimplicialComplex::from_facets([[0]]).unwrap();
        assert_eq!(point.connected_sum(&[a], &point, &[a]).unwrap_err().kind(), ErrorKind::InvalidInput);
    }
}
