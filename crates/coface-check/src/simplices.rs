//! The simplicial complex of a list of facets.

use crate::complex::Column;
use crate::lists::Lists;
use crate::{Complex, Fault};

/// The complex of facets whose vertices rise, and of more vertices; the file has so many bytes.
pub(crate) fn of_facets(facets: &[Vec<u32>], vertices: &[u32], size: usize) -> Result<Complex, Fault> {
    let step = "input";
    let longest = facets.iter().map(Vec::len).max().unwrap_or(usize::from(!vertices.is_empty()));
    if longest == 0 {
        return Err(Fault::new(step, "there is no cell"));
    }
    let mut budget = size.saturating_mul(64).saturating_add(1 << 16);
    let of_length = |length: usize| facets.iter().filter(move |facet| facet.len() == length).cloned();
    let (mut names, mut columns) = (Vec::<Lists<u32>>::new(), Vec::new());
    // The simplices of one dimension: those of the file, then the faces of those above, of which each has `k + 2`.
    let mut level: Lists<u32> = of_length(longest).collect();
    for k in (0..longest).rev() {
        vertices.iter().filter(|_| k == 0).for_each(|&vertex| level.push([vertex]));
        let given = level.len();
        if let Some(above) = names.last() {
            for simplex in above.iter() {
                (0..k + 2).for_each(|i| level.push(face(simplex, i)));
            }
        }
        let mut order: Vec<usize> = (0..level.len()).collect();
        order.sort_unstable_by(|&a, &b| level.get(a).cmp(level.get(b)));
        let mut place = vec![0u32; order.len()];
        let mut kept: Lists<u32> = std::iter::empty::<[u32; 0]>().collect();
        for &simplex in &order {
            if kept.len() == 0 || kept.get(kept.len() - 1) != level.get(simplex) {
                kept.push(level.get(simplex).iter().copied());
            }
            place[simplex] = kept.len() as u32 - 1;
        }
        // Faces without a later vertex come first.
        let incidence = |(i, place): (usize, &u32)| (*place, if i.is_multiple_of(2) { 1 } else { -1 });
        let column = |places: &[u32]| places.iter().enumerate().rev().map(incidence).collect::<Column>();
        columns.push(place[given..].chunks_exact(k + 2).map(column).collect());
        budget = budget
            .checked_sub(kept.len() * (k + 1))
            .filter(|_| u32::try_from(level.len()).is_ok())
            .ok_or_else(|| Fault::new(step, "the facets have too many faces for the size of the file"))?;
        names.push(kept);
        level = of_length(k).collect();
    }
    names.reverse();
    columns.reverse();
    // There is nothing above the simplices of the highest dimension.
    columns.pop();
    Ok(Complex::new(names.iter().map(Lists::len).collect(), columns, Some(names)))
}

/// The face without vertex i.
fn face(simplex: &[u32], i: usize) -> Vec<u32> {
    [&simplex[..i], &simplex[i + 1..]].concat()
}
