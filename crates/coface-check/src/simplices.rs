//! The simplicial complex of a list of facets.

use crate::complex::Column;
use crate::{Complex, Fault};

/// The simplices of one degree: rising lists of vertices, one after the other, in their order.
struct Level {
    size: usize,
    vertices: Vec<u32>,
}

impl Level {
    /// Sorts lists of `size` vertices, and keeps each once.
    fn of(size: usize, lists: &[u32]) -> Self {
        let mut order: Vec<&[u32]> = lists.chunks_exact(size).collect();
        order.sort_unstable();
        order.dedup();
        Self { size, vertices: order.concat() }
    }

    fn len(&self) -> usize {
        self.vertices.len() / self.size
    }

    fn position(&self, simplex: &[u32]) -> Option<u32> {
        let (mut low, mut high) = (0, self.len());
        while low < high {
            let middle = usize::midpoint(low, high);
            match self.vertices[middle * self.size..][..self.size].cmp(simplex) {
                std::cmp::Ordering::Less => low = middle + 1,
                std::cmp::Ordering::Greater => high = middle,
                std::cmp::Ordering::Equal => return u32::try_from(middle).ok(),
            }
        }
        None
    }
}

/// The complex of facets whose vertices rise, and of more vertices; the file has so many bytes.
pub(crate) fn of_facets(facets: &[Vec<u32>], vertices: Vec<u32>, size: usize) -> Result<Complex, Fault> {
    let step = "input";
    let longest = facets.iter().map(Vec::len).max().unwrap_or(usize::from(!vertices.is_empty()));
    if longest == 0 {
        return Err(Fault::new(step, "there is no cell"));
    }
    let mut of_size: Vec<Vec<u32>> = vec![Vec::new(); longest + 1];
    of_size[1] = vertices;
    for facet in facets {
        of_size[facet.len()].extend(facet);
    }
    let (mut levels, mut budget) = (Vec::new(), size.saturating_mul(64).saturating_add(1 << 16));
    for count in (1..=longest).rev() {
        let level = Level::of(count, &of_size[count]);
        of_size[count] = Vec::new();
        if count > 1 {
            budget = budget
                .checked_sub(level.vertices.len())
                .ok_or_else(|| Fault::new(step, "the facets have too many faces for the size of the file"))?;
            for simplex in level.vertices.chunks_exact(count) {
                for i in 0..count {
                    of_size[count - 1].extend(simplex[..i].iter().chain(&simplex[i + 1..]));
                }
            }
        }
        levels.push(level);
    }
    levels.reverse();
    let mut columns = Vec::new();
    for pair in levels.windows(2) {
        let mut face = Vec::new();
        let of_cell = |simplex: &[u32]| -> Result<Column, Fault> {
            let mut column = Column::new();
            for i in 0..simplex.len() {
                face.clear();
                face.extend(simplex[..i].iter().chain(&simplex[i + 1..]));
                let row = pair[0].position(&face).ok_or_else(|| Fault::new(step, "more than 2^32 cells"))?;
                column.push((row, if i % 2 == 0 { 1 } else { -1 }));
            }
            column.sort_unstable();
            Ok(column)
        };
        columns.push(pair[1].vertices.chunks_exact(pair[1].size).map(of_cell).collect::<Result<_, _>>()?);
    }
    let names =
        levels.iter().map(|level| level.vertices.chunks_exact(level.size).map(<[u32]>::to_vec).collect());
    Ok(Complex::new(levels.iter().map(Level::len).collect(), columns, Some(names.collect())))
}
