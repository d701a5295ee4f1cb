//! Incidence and adjacency of cells, by their facets.

use super::overlaps::{Counter, Overlaps, joined};
use super::{LarModel, Operator};
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use std::borrow::Cow;

impl LarModel {
    /// Which cells are incident or adjacent, as topology understands it: for each cell that is a row the cells of the
    /// columns, rising.
    ///
    /// Cells of different degrees are incident when one is a face of the other. Vertices are adjacent when an edge joins
    /// them; edges, faces and other cells of one degree when they share a facet: a vertex, an edge, a face. No cell is
    /// adjacent to itself. The facets are those of [`Self::facets`], so counts of vertices decide only where they prove it.
    ///
    /// # Errors
    /// Those of [`Self::facets_by_vertices`] for the degrees between rows and columns; [`coface_algebra::ErrorKind::TooLarge`] beyond
    /// 2^32 - 1 pairs.
    ///
    /// # Complexity
    /// Linear in the facets of each degree between, and in the pairs with a common facet; in parallel.
    ///
    /// # Examples
    /// Two quadrangles that share the edge 1 2:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2, 3], [1, 4, 5, 2]]), &[])?;
    /// let model = LarModel::try_from(&mesh)?;
    /// assert_eq!(model.incident("FF".parse()?)?.list(0), [1]);
    /// assert_eq!(model.incident("VV".parse()?)?.list(1), [0, 2, 4]);
    /// assert_eq!(model.incident("VF".parse()?)?.list(1), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn incident(&self, operator: Operator) -> Result<RaggedArray, Error> {
        let (rows, columns) = (operator.rows(), operator.columns());
        if rows < columns {
            return Ok(self.incident(operator.transposed())?.transposed(self.cell_count(rows)));
        }
        if rows > columns {
            return self.faces_of_degree(rows, columns);
        }
        if rows == 0 {
            let edges = self.cells(1);
            return neighbors(&edges.transposed(self.vertex_count()), edges.into_owned());
        }
        let facets = self.facets(rows)?;
        neighbors(&facets, facets.transposed(self.cell_count(rows - 1)))
    }

    /// The faces of degree `columns` of the cells of a higher degree, rising.
    fn faces_of_degree(&self, rows: usize, columns: usize) -> Result<RaggedArray, Error> {
        if self.cell_count(rows) == 0 {
            return Ok(RaggedArray::new());
        }
        // Every vertex of a cell is listed.
        let mut faces =
            if columns == 0 { self.cells(rows).into_owned() } else { self.facets(rows)?.into_owned() };
        let mut degree = if columns == 0 { 0 } else { rows - 1 };
        while degree > columns {
            let facets = self.facets(degree)?.into_owned();
            faces = through(&faces, facets, self.cell_count(degree - 1))?;
            degree -= 1;
        }
        let starts: Vec<u32> = (0..=faces.len()).map(|cell| faces.start(cell) as u32).collect();
        let items = faces.items_mut();
        for range in starts.windows(2) {
            items[range[0] as usize..range[1] as usize].sort_unstable();
        }
        Ok(faces)
    }
}

/// The lists of items that the items of each row have, each once, rising.
fn through(rows: &RaggedArray, lists: RaggedArray, column_count: usize) -> Result<RaggedArray, Error> {
    collect(&Overlaps { rows: Cow::Borrowed(rows), columns_at: lists, column_count }, |_, _| true)
}

/// The rows that have an item in common with each row, but itself; `rows_at` has the rows of each item, or the items beyond.
fn neighbors(rows: &RaggedArray, rows_at: RaggedArray) -> Result<RaggedArray, Error> {
    let column_count = rows.len();
    let overlaps = Overlaps { rows: Cow::Borrowed(rows), columns_at: rows_at, column_count };
    collect(&overlaps, |row, column| row != column as usize)
}

fn collect(overlaps: &Overlaps<'_>, keep: impl Fn(usize, u32) -> bool + Sync) -> Result<RaggedArray, Error> {
    let parts = overlaps.in_parts(|counter: &mut Counter, rows| {
        let (mut ends, mut columns) = (Vec::with_capacity(rows.len()), Vec::new());
        for row in rows {
            counter.push_row(overlaps, row, 1, |column, _| keep(row, column), &mut columns);
            ends.push(columns.len() as u32);
        }
        (ends, columns)
    });
    let (starts, columns) = joined(parts)?;
    RaggedArray::from_parts(starts, columns)
}

#[cfg(test)]
mod tests {
    use super::super::samples::{cube, grid};
    use super::*;
    use crate::lar::shared_vertices::Shared;
    use crate::simplicial::FrozenComplex;
    use proptest::prelude::*;

    fn incident(model: &LarModel, name: &str) -> RaggedArray {
        model.incident(name.parse().unwrap()).unwrap()
    }

    #[test]
    fn the_cube_has_its_incidences() {
        let cube = cube();
        let sizes = [
            ("VV", 3),
            ("VE", 3),
            ("VF", 3),
            ("VC", 1),
            ("EV", 2),
            ("EE", 4),
            ("EF", 2),
            ("EC", 1),
            ("FV", 4),
            ("FE", 4),
            ("FF", 4),
            ("FC", 1),
            ("CV", 8),
            ("CE", 12),
            ("CF", 6),
            ("CC", 0),
        ];
        for (name, size) in sizes {
            assert!(incident(&cube, name).iter().all(|list| list.len() == size), "{name}");
        }
        assert_eq!(incident(&grid([2, 1, 1]), "CC").items(), [1, 0]);
        assert_eq!(incident(&cube, "5:2").len(), 0);
        assert_eq!(incident(&cube, "2:5").len(), 6);
    }

    /// In a cuboid grid cells are convex, so counts of vertices agree with incidence.
    #[test]
    fn convex_cells_are_incident_by_counts() {
        let model = grid([3, 2, 2]);
        for (name, shared) in [
            ("FE", Shared::AllOfColumn),
            ("CF", Shared::AllOfColumn),
            ("CE", Shared::AllOfColumn),
            ("EC", Shared::AllOfRow),
            ("VC", Shared::AllOfRow),
            ("FF", Shared::AtLeast(2)),
            ("CC", Shared::AtLeast(4)),
            ("EE", Shared::AtLeast(1)),
            ("VV", Shared::AtLeast(1)),
        ] {
            assert_eq!(
                incident(&model, name),
                model.related(name.parse().unwrap(), shared).unwrap(),
                "{name}"
            );
        }
    }

    /// Two arrows head to head: their chord joins two vertices of each and is an edge of neither.
    #[test]
    fn a_chord_is_no_edge_of_the_face() {
        let edges = RaggedArray::from_lists([[0, 1], [1, 2], [2, 3], [0, 3], [1, 3]]);
        let model = LarModel::new(4, vec![edges, RaggedArray::from_lists([[0, 1, 2, 3]])]).unwrap();
        assert!(model.incident("FE".parse().unwrap()).is_err());
        assert!(model.incident("FF".parse().unwrap()).is_err());
        assert_eq!(incident(&model, "FV").list(0), [0, 1, 2, 3]);
        let model = model.with_facets(2, RaggedArray::from_lists([[3, 2, 1, 0]])).unwrap();
        assert_eq!(incident(&model, "FE").list(0), [0, 1, 2, 3]);
        assert!(incident(&model, "EF").list(4).is_empty());
    }

    proptest! {
        #[test]
        fn incidence_is_inclusion_of_simplices(
            facets in prop::collection::vec(prop::collection::btree_set(0u32..8, 1..6), 1..8),
        ) {
            let lists = RaggedArray::from_lists(facets.iter().map(|f| f.iter().copied().collect::<Vec<_>>()));
            let model = LarModel::try_from(&FrozenComplex::from_facets(&lists).unwrap()).unwrap();
            for rows in 0..5 {
                for columns in 0..5 {
                    let found = model.incident(Operator::new(rows, columns)).unwrap();
                    let (a, b) = (model.cells(rows), model.cells(columns));
                    let common = |i: usize, j: usize| a.list(i).iter().filter(|v| b.list(j).contains(v)).count();
                    let shares = |i: usize, j: usize| {
                        if rows == columns {
                            let joined = || model.cells(1).iter().any(|e| e == [i as u32, j as u32] || e == [j as u32, i as u32]);
                            i != j && if rows == 0 { joined() } else { common(i, j) == rows }
                        } else {
                            common(i, j) == rows.min(columns) + 1
                        }
                    };
                    for i in 0..a.len() {
                        let expected: Vec<u32> = (0..b.len()).filter(|&j| shares(i, j)).map(|j| j as u32).collect();
                        prop_assert_eq!(found.list(i), &expected[..]);
                    }
                }
            }
        }
    }
}
