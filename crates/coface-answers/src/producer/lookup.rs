//! Finding cells by their vertices.

use super::{Cells, Producer};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind};
use std::collections::{HashMap, HashSet};

impl Producer {
    /// Whether cells are told by their vertices; those of halfedge permutations, gluing tables and chain complexes are told
    /// by their own numbers.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert!(strip.names_cells_by_vertices());
    /// # Ok(()) }
    /// ```
    pub fn names_cells_by_vertices(&self) -> bool {
        match &self.cells {
            Cells::Polygons(_) | Cells::Solids(_) | Cells::Simplices(_) => true,
            Cells::Voxels(cells) => cells.are_told_by_vertices(),
            Cells::Halfedges(_) | Cells::Gluings(_) | Cells::Chains(_) | Cells::Ordered(_) => false,
        }
    }

    /// For each list all cells with these names, which [`Self::cell_vertices`] gives in any order, as (degree, cell). Polygons
    /// around the same vertices in different orders have one name.
    ///
    /// Cells that are told by their own numbers are looked for in `degree` only, which must be given.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming a list that no cell has, [`ErrorKind::InvalidInput`] if the degree is needed and
    /// missing.
    ///
    /// # Complexity
    /// Linear in the cells of the degrees that are searched.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::RaggedArray;
    /// use coface_io::{Model, Structure};
    /// use coface_answers::Producer;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let producer = Producer::of(Model::from_structure(Structure::Facets(RaggedArray::from_lists([[5, 7, 9]]))))?;
    /// let found = producer.cells_with_vertices(&producer.chain_complex()?, [&[9, 7][..], &[5]], None)?;
    /// assert_eq!(found, [[(1, CellId::new(2))], [(0, CellId::new(0))]]);
    /// # Ok(()) }
    /// ```
    pub fn cells_with_vertices<'t>(
        &self,
        complex: &ChainComplex,
        lists: impl IntoIterator<Item = &'t [u32]>,
        degree: Option<usize>,
    ) -> Result<Vec<Vec<(usize, CellId)>>, Error> {
        let names: Vec<Vec<u32>> = lists.into_iter().map(in_order).collect();
        let degrees = match degree {
            Some(degree) => degree..degree + 1,
            None if self.names_cells_by_vertices() || names.is_empty() => 0..complex.degree_count(),
            None => {
                return Err(Error::invalid("cells without vertices are told by their degree and number")
                    .with_cure(
                        "give the degree beside the cells, as in {\"degree\":1,\"chain\":[[1,[0]],..]}",
                    ));
            }
        };
        let mut found: HashMap<&[u32], Vec<(usize, CellId)>> =
            names.iter().map(|name| (&name[..], Vec::new())).collect();
        let sizes: HashSet<usize> = names.iter().map(Vec::len).collect();
        let named: HashSet<u32> = names.iter().flatten().copied().collect();
        for degree in degrees {
            for cell in (0..complex.cell_count(degree)).map(CellId::new) {
                let vertices = self.cell_vertices(degree, cell);
                if !sizes.contains(&vertices.len()) || vertices.first().is_some_and(|v| !named.contains(v)) {
                    continue;
                }
                if let Some(cells) = found.get_mut(&in_order(&vertices)[..]) {
                    cells.push((degree, cell));
                }
            }
        }
        let cells = |name: &Vec<u32>| match &found[&name[..]] {
            none if none.is_empty() => {
                Err(Error::new(ErrorKind::NotInComplex, format!("there is no cell {name:?} in the model"))
                    .with_cells([&name[..]])
                    .with_cure("name cells by the vertex numbers of the model, from 0"))
            }
            cells => Ok(cells.clone()),
        };
        names.iter().map(cells).collect()
    }
}

fn in_order(vertices: &[u32]) -> Vec<u32> {
    let mut sorted = vertices.to_vec();
    sorted.sort_unstable();
    sorted
}
