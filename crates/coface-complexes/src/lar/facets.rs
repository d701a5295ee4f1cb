//! Facets found by vertices, where it can be proved that they are the facets.

use super::{LarModel, Operator, Shared};
use coface_algebra::Error;
use coface_algebra::progress::stage;
use coface_algebra::{RaggedArray, UnionFind};
use rayon::prelude::*;
use std::borrow::Cow;

impl LarModel {
    /// The facets of the k-cells as positions of (k-1)-cells: those that were given, else those found by
    /// [`Self::facets_by_vertices`]. The facets of an edge are its vertices in their order.
    ///
    /// # Errors
    /// Those of [`Self::facets_by_vertices`].
    pub fn facets(&self, degree: usize) -> Result<Cow<'_, RaggedArray>, Error> {
        if degree == 1 {
            return Ok(self.cells(1));
        }
        match self.given_facets(degree) {
            Some(facets) => Ok(Cow::Borrowed(facets)),
            None => self.facets_by_vertices(degree).map(Cow::Owned),
        }
    }

    /// The facets of the k-cells, found as the (k-1)-cells all of whose vertices the k-cell has, rising.
    ///
    /// This is right for simplices and for convex cells. In general a (k-1)-cell may have its vertices in a k-cell without
    /// being a facet of it, as a chord outside of a polygon that is not convex. So the cells that are found are taken only
    /// where they must be the facets, provided that these are a closed manifold, perhaps in several parts: for each
    /// k-cell each ridge (facet of a facet) lies in exactly two of the cells found, each vertex of the k-cell in one at least,
    /// and each of their parts that hang together by ridges has a vertex that no other part has. In a polygon the edges
    /// found are then disjoint cycles through all its vertices.
    ///
    /// Why that is a proof: the facets are among the cells found. A superfluous one has no ridge in common with a facet,
    /// which would be in three, so that the superfluous ones are whole parts. Each part has a vertex of its own, which some
    /// facet must have.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming the first cell for which the cells found are not proved to be the facets, and
    /// the ones that are superfluous or the place where one is missing; [`coface_algebra::ErrorKind::Shape`] for degree 0.
    ///
    /// # Complexity
    /// Linear in the ridges of facets, with a sort of those of each cell; in parallel.
    ///
    /// # Examples
    /// A quadrangle and an edge 0 2: it may be a diagonal outside of the quadrangle.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let edges = RaggedArray::from_lists([[0, 1], [1, 2], [2, 3], [0, 3], [0, 2]]);
    /// let error = LarModel::new(4, vec![edges, faces.clone()])?.facets_by_vertices(2).unwrap_err();
    /// assert!(error.message().contains("edge 4 = {0, 2}"));
    /// let edges = RaggedArray::from_lists([[0, 1], [1, 2], [2, 3], [0, 3]]);
    /// assert_eq!(LarModel::new(4, vec![edges, faces])?.facets_by_vertices(2)?.list(0), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn facets_by_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        if degree == 0 {
            return Err(Error::new(coface_algebra::ErrorKind::Shape, "vertices have no facets"));
        }
        if degree == 1 || self.cell_count(degree) == 0 {
            return Ok(self.cells(degree).into_owned());
        }
        let found = self.related(Operator::new(degree, degree - 1), Shared::AllOfColumn)?;
        let ridges = self.facets(degree - 1)?;
        let search = Search { model: self, degree, found: &found, ridges: &ridges };
        const BLOCK: usize = 1 << 12;
        let steps = stage("proving facets", found.len().div_ceil(BLOCK));
        let block = |block: usize| {
            steps.advance(1);
            let mut scratch = Scratch::default();
            (block * BLOCK..((block + 1) * BLOCK).min(found.len()))
                .find_map(|cell| search.fault(cell, &mut scratch))
        };
        match (0..found.len().div_ceil(BLOCK)).into_par_iter().find_map_first(block) {
            Some(error) => Err(error.with_cure(format!(
                "give the facets of the cells of degree {degree} themselves, with LarModel::with_facets"
            ))),
            None => Ok(found),
        }
    }

    /// A cell for people: its number and, if that is short, its vertices.
    pub(super) fn cell_name(&self, degree: usize, cell: u32) -> String {
        let name = match degree {
            0 => return format!("vertex {cell}"),
            1 => format!("edge {cell}"),
            2 => format!("face {cell}"),
            _ => format!("cell {cell} of degree {degree}"),
        };
        let vertices = self.cells(degree);
        let list: Vec<String> = vertices.list(cell as usize).iter().map(u32::to_string).collect();
        if list.len() > 8 { name } else { format!("{name} = {{{}}}", list.join(", ")) }
    }
}

/// The cells found for the k-cells, and the facets of these.
struct Search<'a> {
    model: &'a LarModel,
    degree: usize,
    found: &'a RaggedArray,
    ridges: &'a RaggedArray,
}

/// Lists that are used again for each cell.
#[derive(Default)]
struct Scratch {
    /// Pairs of a ridge, or a vertex, and the position of a facet in the list of those found.
    uses: Vec<(u32, u32)>,
}

impl Search<'_> {
    /// Why the cells found for a k-cell are not proved to be its facets.
    fn fault(&self, cell: usize, scratch: &mut Scratch) -> Option<Error> {
        let found = self.found.list(cell);
        let uses = &mut scratch.uses;
        uses.clear();
        for (position, &facet) in found.iter().enumerate() {
            uses.extend(self.ridges.list(facet as usize).iter().map(|&ridge| (ridge, position as u32)));
        }
        uses.sort_unstable();
        let by_ridge = |a: &(u32, u32), b: &(u32, u32)| a.0 == b.0;
        if let Some(at) = uses.chunk_by(by_ridge).find(|at| at.len() != 2) {
            return Some(self.bad_ridge(cell, uses, at));
        }
        let mut parts = UnionFind::new(found.len());
        for at in uses.chunk_by(by_ridge) {
            parts.unite(at[0].1, at[1].1);
        }
        self.fault_of_vertices(cell, parts, uses)
    }

    /// A vertex in no cell found, or a part without a vertex of its own.
    fn fault_of_vertices(
        &self,
        cell: usize,
        mut parts: UnionFind,
        uses: &mut Vec<(u32, u32)>,
    ) -> Option<Error> {
        let found = self.found.list(cell);
        let (degree, facets) = (self.degree, self.model.cells(self.degree - 1));
        uses.clear();
        for (position, &facet) in found.iter().enumerate() {
            let part = parts.find(position as u32);
            uses.extend(facets.list(facet as usize).iter().map(|&vertex| (vertex, part)));
        }
        uses.sort_unstable();
        uses.dedup();
        let vertices = self.model.cells(degree);
        if let Some(vertex) =
            vertices.list(cell).iter().find(|&&v| uses.binary_search_by_key(&v, |u| u.0).is_err())
        {
            return Some(Error::invalid(format!(
                "vertex {vertex} of {} lies in no facet of it",
                self.model.cell_name(degree, cell as u32)
            )));
        }
        if parts.class_count() == 1 {
            return None;
        }
        let mut has_own_vertex = vec![false; found.len()];
        for at in uses.chunk_by(|a, b| a.0 == b.0).filter(|at| at.len() == 1) {
            has_own_vertex[at[0].1 as usize] = true;
        }
        let shared =
            (0..found.len() as u32).find(|&position| !has_own_vertex[parts.find(position) as usize])?;
        Some(Error::invalid(format!(
            "{} and what hangs together with it may be superfluous among the facets of {}: it has no vertex of its own",
            self.model.cell_name(degree - 1, found[shared as usize]),
            self.model.cell_name(degree, cell as u32)
        )))
    }

    /// The fault at a ridge that is not in two of the cells found.
    fn bad_ridge(&self, cell: usize, uses: &[(u32, u32)], at: &[(u32, u32)]) -> Error {
        let found = self.found.list(cell);
        let name = self.model.cell_name(self.degree, cell as u32);
        let ridge = self.model.cell_name(self.degree - 2, at[0].0);
        let facet = |position: u32| self.model.cell_name(self.degree - 1, found[position as usize]);
        if at.len() == 1 {
            return Error::invalid(format!(
                "{ridge} lies in {} alone of the facets of {name}: another one is missing",
                facet(at[0].1)
            ));
        }
        // Superfluous facets have all their ridges in common with others.
        let crowded = |position: u32| {
            uses.iter().filter(|u| u.1 == position).all(|u| uses.iter().filter(|w| w.0 == u.0).count() > 2)
        };
        let suspects: Vec<u32> = at.iter().map(|u| u.1).filter(|&position| crowded(position)).collect();
        let listed = if suspects.is_empty() { at.iter().map(|u| u.1).collect() } else { suspects };
        let listed: Vec<String> = listed.into_iter().take(8).map(facet).collect();
        Error::invalid(format!(
            "{ridge} lies in {} cells of degree {} with vertices of {name}, but a facet has one neighbor there; superfluous may be {}",
            at.len(),
            self.degree - 1,
            listed.join(", ")
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{cube, grid};
    use super::*;
    use crate::simplicial::FrozenComplex;
    use proptest::prelude::*;

    fn model(vertex_count: usize, edges: &[[u32; 2]], faces: &[&[u32]]) -> LarModel {
        LarModel::new(vertex_count, vec![RaggedArray::from_lists(edges), RaggedArray::from_lists(faces)])
            .unwrap()
    }

    #[test]
    fn convex_cells_have_the_facets_found() {
        for model in [cube(), grid([3, 2, 2])] {
            for degree in [2, 3] {
                let facets = model.facets_by_vertices(degree).unwrap();
                assert!(facets.iter().all(|list| list.len() == 2 * degree));
                // Each facet is found because it lies in the cell: by the vertices, one after the other.
                for (cell, list) in facets.iter().enumerate() {
                    let (cells, lower) = (model.cells(degree), model.cells(degree - 1));
                    let inside = |&facet: &u32| {
                        lower.list(facet as usize).iter().all(|v| cells.list(cell).contains(v))
                    };
                    let expected: Vec<u32> = (0..lower.len() as u32).filter(inside).collect();
                    assert_eq!(list, expected);
                }
            }
        }
    }

    /// The chord 1 3 of the arrow 0 1 2 3 is an edge of the triangle 1 2 3 beside it, or lies outside.
    #[test]
    fn a_chord_of_a_polygon_is_refused_and_named() {
        let arrow =
            model(5, &[[0, 1], [1, 2], [2, 3], [0, 3], [1, 3], [1, 4], [3, 4]], &[&[1, 3, 4], &[0, 1, 2, 3]]);
        let error = arrow.facets_by_vertices(2).unwrap_err();
        assert_eq!(
            error.message(),
            "vertex 1 lies in 3 cells of degree 1 with vertices of face 1 = {0, 1, 2, 3}, but a facet has one neighbor \
             there; superfluous may be edge 4 = {1, 3}"
        );
        assert!(error.cure().unwrap().contains("with_facets"));
        let given = arrow.with_facets(2, RaggedArray::from_lists([vec![4, 5, 6], vec![0, 1, 2, 3]])).unwrap();
        assert_eq!(given.facets(2).unwrap().list(1), [0, 1, 2, 3]);
    }

    #[test]
    fn what_is_missing_is_named() {
        let open = model(3, &[[0, 1], [1, 2]], &[&[0, 1, 2]]);
        assert!(
            open.facets_by_vertices(2)
                .unwrap_err()
                .message()
                .contains("vertex 0 lies in edge 0 = {0, 1} alone")
        );
        let lone = model(4, &[[0, 1], [1, 2], [0, 2]], &[&[0, 1, 2, 3]]);
        assert!(lone.facets_by_vertices(2).unwrap_err().message().contains("vertex 3 of face 0"));
        assert!(model(2, &[[0, 1]], &[]).facets_by_vertices(0).is_err());
    }

    /// Two squares in one face, one around the other: two parts, each with vertices of its own.
    #[test]
    fn a_face_with_a_hole_is_proved() {
        let ring = model(
            8,
            &[[0, 1], [1, 2], [2, 3], [0, 3], [4, 5], [5, 6], [6, 7], [4, 7]],
            &[&[0, 1, 2, 3, 4, 5, 6, 7], &[4, 5, 6, 7]],
        );
        let facets = ring.facets_by_vertices(2).unwrap();
        assert_eq!((facets.list(0).len(), facets.list(1)), (8, &[4, 5, 6, 7][..]));
    }

    /// A square with a triangle inside that touches it in a corner: four edges at that vertex cannot be told apart.
    #[test]
    fn a_pinched_face_is_refused() {
        let pinched = model(
            6,
            &[[0, 1], [1, 2], [2, 3], [0, 3], [0, 4], [4, 5], [0, 5]],
            &[&[0, 1, 2, 3, 4, 5], &[0, 4, 5]],
        );
        let message = pinched.facets_by_vertices(2).unwrap_err().message().to_owned();
        assert!(message.starts_with("vertex 0 lies in 4 cells of degree 1"), "{message}");
    }

    /// The torus on seven vertices with more triangles on them: edges lie in more than two.
    #[test]
    fn a_second_closed_surface_on_the_same_vertices_is_refused() {
        let orbit = |a: u32, b: u32, c: u32| (0..7).map(move |i| [(a + i) % 7, (b + i) % 7, (c + i) % 7]);
        let faces = RaggedArray::from_lists(orbit(0, 1, 3).chain(orbit(0, 2, 3)).chain(orbit(0, 1, 5)));
        let edges = (0..7).flat_map(|b| (0..b).map(move |a| [a, b]));
        let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6]]);
        let model = LarModel::new(7, vec![RaggedArray::from_lists(edges), faces, cells]).unwrap();
        let error = model.facets_by_vertices(3).unwrap_err();
        assert!(error.message().contains("lies in 3 cells of degree 2"), "{error}");
    }

    /// Two boundaries of a tetrahedron on the same four vertices, with edges of their own that join the same vertices.
    #[test]
    fn parts_without_vertices_of_their_own_are_refused() {
        let pairs = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
        let edges = RaggedArray::from_lists(pairs.iter().chain(&pairs));
        let faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
        let sides: [[u32; 3]; 4] = [[0, 1, 3], [0, 2, 4], [1, 2, 5], [3, 4, 5]];
        let facets = sides.iter().copied().chain(sides.iter().map(|side| side.map(|edge| edge + 6)));
        let model = LarModel::new(
            4,
            vec![
                edges,
                RaggedArray::from_lists(faces.iter().chain(&faces)),
                RaggedArray::from_lists([[0, 1, 2, 3]]),
            ],
        )
        .unwrap()
        .with_facets(2, RaggedArray::from_lists(facets))
        .unwrap();
        let error = model.facets_by_vertices(3).unwrap_err();
        assert!(error.message().contains("has no vertex of its own"), "{error}");
    }

    proptest! {
        #[test]
        fn simplices_have_the_facets_found(
            facets in prop::collection::vec(prop::collection::btree_set(0u32..9, 1..6), 1..8),
        ) {
            let lists = RaggedArray::from_lists(facets.iter().map(|f| f.iter().copied().collect::<Vec<_>>()));
            let model = LarModel::try_from(&FrozenComplex::from_facets(&lists).unwrap()).unwrap();
            for degree in 2..=model.dimension().unwrap() {
                let found = model.facets_by_vertices(degree).unwrap();
                prop_assert_eq!(&found, model.given_facets(degree).unwrap());
            }
        }
    }
}
