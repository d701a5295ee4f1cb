//! The cells of a producer in the complex that the checker of certificates reads from the same file.

use super::Producer;
use coface_algebra::{CellId, Error};
use std::collections::HashMap;

impl Producer {
    /// For each degree that the checker reads the numbers that it gives to these cells.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if it reads other cells.
    pub(crate) fn places_on(
        &self,
        read: &coface_check::Complex,
        cell_counts: &[usize],
    ) -> Result<Vec<Vec<u32>>, Error> {
        let name = |mut vertices: Vec<u32>| {
            vertices.sort_unstable();
            vertices
        };
        let of_degree = |(degree, &count): (usize, &usize)| {
            if read.counts()[degree] > 0 && read.vertices(degree, 0).is_none() {
                return Some((0..count as u32).collect());
            }
            let known = (0..count)
                .filter_map(|cell| Some((name(read.vertices(degree, cell)?.to_vec()), cell as u32)));
            let known: HashMap<Vec<u32>, u32> = known.collect();
            let own = 0..cell_counts.get(degree).copied().unwrap_or(0);
            own.map(|cell| known.get(&name(self.cell_vertices(degree, CellId::new(cell)))).copied())
                .collect::<Option<Vec<u32>>>()
                .filter(|places| places.len() == count)
        };
        let places = read.counts().iter().enumerate().map(of_degree).collect::<Option<Vec<Vec<u32>>>>();
        let is_whole = cell_counts.iter().skip(read.counts().len()).all(|&count| count == 0);
        places.filter(|_| is_whole).ok_or_else(|| {
            crate::homology::certificate::refused("the checker reads other cells than the library")
        })
    }
}
