//! The cells of a model for drawing.

use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind, RaggedArray};
use coface_answers::answer::{Remark, RemarkCode};
use coface_io::{Model, Structure};

/// The cells of a model for drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct Parts {
    /// Polygons by the first walk around each.
    pub(super) polygons: RaggedArray,
    /// Further walks around polygons: holes, and what hangs together in a vertex only.
    pub(super) rims: RaggedArray,
    pub(super) polygon_of_rim: Vec<u32>,
    /// Top cells that are neither polygons nor 3-cells.
    pub(super) simplices: RaggedArray,
    /// The polygons around each 3-cell.
    pub(super) cells: RaggedArray,
    /// Whether a 3-cell has its polygon with a minus, for chain complexes; else empty.
    pub(super) cell_signs: Vec<bool>,
    /// How many simplices have edges only, because their triangles are too many.
    pub(super) edges_alone: usize,
}

/// Triangles of larger simplices are not drawn: each hides all others.
const MOST_CORNERS: usize = 16;
/// Simplices with more edges in all are not drawn.
const MOST_EDGES: usize = 1 << 22;

impl Parts {
    /// The sides of polygons and the edges of simplices, rising and each once.
    pub(super) fn edges(&self) -> Vec<[u32; 2]> {
        let mut edges = Vec::new();
        for walk in self.polygons.iter().chain(self.rims.iter()) {
            edges.extend((0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]));
        }
        for simplex in self.simplices.iter() {
            for (i, &a) in simplex.iter().enumerate() {
                edges.extend(simplex[i + 1..].iter().map(|&b| [a, b]));
            }
        }
        edges.iter_mut().for_each(|edge| edge.sort_unstable());
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// # Errors
    /// [`ErrorKind::TooLarge`] for facets with more than $2^{22}$ edges.
    pub(super) fn add(&mut self, model: &Model) -> Result<(), Error> {
        for polygon in model.polygons().iter() {
            self.polygons.push(polygon);
        }
        for line in model.lines().iter() {
            line.windows(2).for_each(|edge| self.simplices.push(edge));
        }
        for point in model.points() {
            self.simplices.push(&[point.to_u32()]);
        }
        if let Some(Structure::Facets(facets)) = model.structure() {
            self.add_facets(facets)?;
        }
        if let Some(Structure::Chains(complex)) = model.structure() {
            self.add_chains(complex);
        }
        self.add_cells(model);
        Ok(())
    }

    /// Facets: triangles are polygons, and so are the triangles of higher simplices, each once; tetrahedra are 3-cells.
    fn add_facets(&mut self, facets: &RaggedArray) -> Result<(), Error> {
        let edge_count: usize =
            facets.iter().map(|facet| facet.len() * facet.len().saturating_sub(1) / 2).sum();
        if edge_count > MOST_EDGES {
            let message = format!("the simplices have {edge_count} edges, too many to draw");
            return Err(Error::new(ErrorKind::TooLarge, message)
                .with_cure("draw a part of them, such as a link or a star"));
        }
        let mut triangles: Vec<[u32; 3]> = Vec::new();
        let mut tetrahedra: Vec<[u32; 4]> = Vec::new();
        for facet in facets.iter() {
            let mut sorted = facet.to_vec();
            sorted.sort_unstable();
            let cornered = if sorted.len() <= MOST_CORNERS { &sorted[..] } else { &[] };
            self.edges_alone += usize::from(sorted.len() > MOST_CORNERS);
            for (i, &a) in cornered.iter().enumerate() {
                for (j, &b) in cornered.iter().enumerate().skip(i + 1) {
                    triangles.extend(sorted.iter().skip(j + 1).map(|&c| [a, b, c]));
                }
            }
            match sorted[..] {
                [_, _, _] => {}
                [a, b, c, d] => tetrahedra.push([a, b, c, d]),
                _ => self.simplices.push(facet),
            }
        }
        triangles.sort_unstable();
        triangles.dedup();
        let first = self.polygons.len();
        triangles.iter().for_each(|triangle| self.polygons.push(triangle));
        for [a, b, c, d] in tetrahedra {
            let sides = [[b, c, d], [a, c, d], [a, b, d], [a, b, c]];
            let polygon = |side: &[u32; 3]| (first + triangles.partition_point(|other| other < side)) as u32;
            self.cells.push(&sides.each_ref().map(polygon));
        }
        Ok(())
    }

    /// 3-cells by their polygons; a polygon between two cells, or in the list of polygons too, is one.
    fn add_cells(&mut self, model: &Model) {
        if model.cells().is_empty() {
            return;
        }
        let own = self.polygons.len();
        let mut faces: Vec<(Vec<u32>, u32, Vec<u32>)> = Vec::new();
        let key = |walk: &[u32]| {
            let mut sorted = walk.to_vec();
            sorted.sort_unstable();
            sorted
        };
        faces.extend(self.polygons.iter().map(|walk| (key(walk), u32::MAX, Vec::new())));
        for (cell, (shape, vertices)) in model.shapes().iter().zip(model.cells().iter()).enumerate() {
            for face in shape.faces() {
                let walk: Vec<u32> = face.iter().map(|&i| vertices[i]).collect();
                faces.push((key(&walk), cell as u32, walk));
            }
        }
        let mut order: Vec<u32> = (0..faces.len() as u32).collect();
        order.sort_by(|&a, &b| faces[a as usize].0.cmp(&faces[b as usize].0).then(a.cmp(&b)));
        let mut polygons_of_cell = vec![Vec::new(); model.cells().len()];
        for group in order.chunk_by(|&a, &b| faces[a as usize].0 == faces[b as usize].0) {
            let first = group[0] as usize;
            let polygon = if first < own {
                first as u32
            } else {
                self.polygons.push(&faces[first].2);
                self.polygons.len() as u32 - 1
            };
            for &face in group.iter().filter(|&&face| face as usize >= own) {
                polygons_of_cell[faces[face as usize].1 as usize].push(polygon);
            }
        }
        self.cells = RaggedArray::from_lists(polygons_of_cell);
    }

    /// The cells of a chain complex up to degree 3, by their boundaries. Cells that no walks bound are left out.
    fn add_chains(&mut self, complex: &ChainComplex) {
        let Some(edge_matrix) = complex.boundary_matrix(1) else {
            (0..complex.cell_count(0) as u32).for_each(|vertex| self.simplices.push(&[vertex]));
            return;
        };
        // The source and the target of each edge; edges that are no segments have none.
        let ends: Vec<Option<[u32; 2]>> = edge_matrix
            .columns()
            .map(|column| match (column.rows(), column.entries()) {
                (&[a, b], &[-1, 1]) => Some([a, b]),
                (&[a, b], &[1, -1]) => Some([b, a]),
                _ => None,
            })
            .collect();
        let mut is_free = vec![true; ends.len()];
        let mut polygon_of_face = vec![None; complex.cell_count(2)];
        for (face, column) in
            complex.boundary_matrix(2).iter().flat_map(|matrix| matrix.columns()).enumerate()
        {
            let mut sides: Vec<[u32; 2]> = Vec::new();
            for (edge, entry) in column.iter() {
                is_free[edge] = false;
                let Some([a, b]) = ends[edge] else { continue };
                let side = if entry > 0 { [a, b] } else { [b, a] };
                sides.extend(std::iter::repeat_n(side, entry.unsigned_abs() as usize));
            }
            let mut walks = walks_of(sides).into_iter();
            let Some(first) = walks.next() else { continue };
            let polygon = self.polygons.len() as u32;
            polygon_of_face[face] = Some(polygon);
            self.polygons.push(&first);
            for walk in walks {
                self.rims.push(&walk);
                self.polygon_of_rim.push(polygon);
            }
        }
        for (ends, _) in ends.iter().zip(&is_free).filter(|(_, is_free)| **is_free) {
            ends.iter().for_each(|ends| self.simplices.push(ends));
        }
        for column in complex.boundary_matrix(3).iter().flat_map(|matrix| matrix.columns()) {
            let mut around = Vec::new();
            for (face, entry) in column.iter() {
                if let Some(polygon) = polygon_of_face[face] {
                    around.push(polygon);
                    self.cell_signs.push(entry < 0);
                }
            }
            self.cells.push(&around);
        }
    }

    /// What is said of the simplices that have edges only; `None` if there are none.
    pub(super) fn remark(&self) -> Option<Remark> {
        let word = if self.edges_alone == 1 { "simplex" } else { "simplices" };
        let message = format!(
            "not drawn: the triangles of {} {word} of more than {MOST_CORNERS} vertices; their edges are drawn",
            self.edges_alone
        );
        let remark = || Remark::new(RemarkCode::NotDrawn, message).at(self.edges_alone, []);
        (self.edges_alone > 0).then(remark)
    }

    pub(super) fn vertex_count(&self, model: &Model) -> usize {
        let used = self.polygons.items().iter().chain(self.simplices.items());
        let abstract_count =
            if matches!(model.structure(), Some(Structure::Facets(_))) { 0 } else { model.vertex_count() };
        used.max().map_or(0, |&last| last as usize + 1).max(abstract_count)
    }
}

/// The length of all lists, if it is one.
pub(super) fn common_width(lists: &RaggedArray) -> Option<usize> {
    let width = lists.iter().next()?.len();
    (width > 0 && lists.iter().all(|list| list.len() == width)).then_some(width)
}

/// Directed sides as closed walks; sides that lead nowhere are left out. $O(n \log n)$.
fn walks_of(mut sides: Vec<[u32; 2]>) -> Vec<Vec<u32>> {
    sides.sort_unstable();
    let mut next: Vec<usize> = (0..sides.len()).collect();
    let first_from = |vertex: u32| sides.partition_point(|side| side[0] < vertex);
    let mut walks = Vec::new();
    let mut is_used = vec![false; sides.len()];
    for start in 0..sides.len() {
        if is_used[start] {
            continue;
        }
        let mut walk = Vec::new();
        let mut at = start;
        let is_closed = loop {
            is_used[at] = true;
            let [source, target] = sides[at];
            walk.push(source);
            if target == sides[start][0] {
                break true;
            }
            // The first side from here that is not used; those before it never will be again.
            let first = first_from(target);
            let Some(from) = next.get(first).map(|&from| from.max(first)) else { break false };
            let Some(found) =
                (from..sides.len()).take_while(|&i| sides[i][0] == target).find(|&i| !is_used[i])
            else {
                break false;
            };
            next[first] = found + 1;
            at = found;
        };
        if is_closed && walk.len() > 1 {
            walks.push(walk);
        }
    }
    walks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tetrahedra_share_triangles() {
        let mut parts = Parts::default();
        parts
            .add_facets(&RaggedArray::from_lists([&[3, 0, 1, 2][..], &[1, 2, 3, 4], &[7, 8], &[0, 5, 6]]))
            .unwrap();
        assert_eq!((parts.polygons.len(), parts.simplices.len()), (8, 1));
        let walks = |cell: usize| -> Vec<&[u32]> {
            parts.cells.list(cell).iter().map(|&polygon| parts.polygons.list(polygon as usize)).collect()
        };
        assert_eq!(walks(0), [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]);
        assert!(walks(1).contains(&&[1, 2, 3][..]));
    }

    #[test]
    fn walks_meet_in_vertices() {
        let walks = walks_of(vec![[0, 1], [1, 2], [2, 0], [2, 3], [3, 4], [4, 2], [7, 8]]);
        let sizes: usize = walks.iter().map(Vec::len).sum();
        assert_eq!(sizes, 6);
        assert!(walks.iter().all(|walk| walk.len() % 3 == 0));
    }
}
