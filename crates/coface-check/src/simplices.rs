//! The simplicial complex of a list of facets.

use crate::complex::Column;
use crate::{Complex, Fault};

/// The complex of facets whose vertices rise, and of more vertices; the file has so many bytes.
pub(crate) fn of_facets(facets: &[Vec<u32>], vertices: Vec<u32>, size: usize) -> Result<Complex, Fault> {
    let step = "input";
    let longest = facets.iter().map(Vec::len).max().unwrap_or(usize::from(!vertices.is_empty()));
    if longest == 0 {
        return Err(Fault::new(step, "there is no cell"));
    }
    let mut budget = size.saturating_mul(64).saturating_add(1 << 16);
    let mut levels: Vec<Vec<Vec<u32>>> = vec![Vec::new(); longest];
    levels[0] = vertices.into_iter().map(|vertex| vec![vertex]).collect();
    facets.iter().for_each(|facet| levels[facet.len() - 1].push(facet.clone()));
    for k in (0..longest).rev() {
        let (below, level) = levels.split_at_mut(k);
        level[0].sort_unstable();
        level[0].dedup();
        if let Some(below) = below.last_mut() {
            budget = budget
                .checked_sub(level[0].len() * (k + 1))
                .ok_or_else(|| Fault::new(step, "the facets have too many faces for the size of the file"))?;
            below.extend(level[0].iter().flat_map(|simplex| (0..=k).map(|i| face(simplex, i))));
        }
    }
    let column = |below: &[Vec<u32>], simplex: &Vec<u32>| -> Result<Column, Fault> {
        let place = |i: usize| {
            let place =
                below.binary_search(&face(simplex, i)).ok().and_then(|place| u32::try_from(place).ok());
            let row = place.ok_or_else(|| Fault::new(step, "more than 2^32 cells"))?;
            Ok((row, if i.is_multiple_of(2) { 1 } else { -1 }))
        };
        // Faces without a later vertex come first.
        (0..simplex.len()).rev().map(place).collect()
    };
    let columns =
        levels.windows(2).map(|pair| pair[1].iter().map(|simplex| column(&pair[0], simplex)).collect());
    let columns = columns.collect::<Result<_, _>>()?;
    Ok(Complex::new(levels.iter().map(Vec::len).collect(), columns, Some(levels)))
}

/// The face without vertex i.
fn face(simplex: &[u32], i: usize) -> Vec<u32> {
    [&simplex[..i], &simplex[i + 1..]].concat()
}
