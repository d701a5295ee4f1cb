//! Tori, Klein bottles and strips made of periodic grids.

use super::{for_each_permutation, from_orbits, from_rule, require};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// The torus of this dimension with $2^{d+1} - 1$ vertices, cyclic: the facets are the partial sums of the numbers
/// $1, 2, 4, \dots, 2^d$ in every order, moved around modulo the number of vertices. Dimension 2 is the torus with 7
/// vertices (the orbits of {0,1,3} and {0,2,3}), dimension 3 the one with 15.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the dimension is 1 to 8.
///
/// # References
/// W. Kuehnel, G. Lassmann, *Combinatorial d-tori with a large symmetry group* (1988).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::cyclic_torus(2)?.f_vector(), [7, 21, 14]);
/// assert_eq!(known_spaces::cyclic_torus(3)?.f_vector(), [15, 105, 180, 90]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn cyclic_torus(dimension: usize) -> Result<SimplicialComplex, Error> {
    require((1..=8).contains(&dimension), || {
        format!("a cyclic torus of dimension {dimension} is not built; 1 to 8 are")
    })?;
    let modulus = (1u32 << (dimension + 1)) - 1;
    let mut facets = Vec::new();
    // The last step closes the cycle, so it may be kept the greatest: other orders are shifts of these.
    for_each_permutation(dimension, &mut |order| {
        for start in 0..modulus {
            let mut at = start;
            let mut facet = vec![at];
            for &i in order {
                at = (at + (1 << i)) % modulus;
                facet.push(at);
            }
            facets.push(facet);
        }
    });
    from_rule(facets)
}

/// The torus as a periodic grid of cubes, each cut into simplices along its diagonal (the Kuhn triangulation): vertex
/// $(i_1, \dots, i_d)$ has the number $i_1 + n_1 (i_2 + n_2 (\dots))$; a facet walks from a vertex along all axes in some
/// order. `lengths` are the numbers of cubes along the axes.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless there is an axis and every length is 3 or more;
/// [`coface_algebra::ErrorKind::TooLarge`] beyond 2^31 vertices.
///
/// # References
/// H. W. Kuhn, *Some combinatorial lemmas in topology* (1960).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::torus_grid(&[3, 3])?.f_vector(), [9, 27, 18]);
/// assert_eq!(known_spaces::torus_grid(&[3, 3, 4])?.f_vector(), [36, 252, 432, 216]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn torus_grid(lengths: &[u32]) -> Result<SimplicialComplex, Error> {
    require(!lengths.is_empty() && lengths.iter().all(|&n| n >= 3), || {
        format!("a torus grid of lengths {lengths:?} is not simplicial; each length must be 3 or more")
    })?;
    require(lengths.len() <= 9, || {
        format!("a torus grid of dimension {} is not built; the limit is 9", lengths.len())
    })?;
    let count = lengths.iter().try_fold(1u32, |product, &n| product.checked_mul(n)).filter(|&n| n < 1 << 31);
    let Some(count) = count else {
        return Err(Error::new(
            coface_algebra::ErrorKind::TooLarge,
            format!("a torus grid of lengths {lengths:?} has over 2^31 vertices"),
        ));
    };
    let mut facets = Vec::new();
    for_each_permutation(lengths.len(), &mut |order| {
        for start in 0..count {
            let mut place = digits(start, lengths);
            let mut facet = vec![start];
            for &axis in order {
                place[axis] = (place[axis] + 1) % lengths[axis];
                facet.push(number(&place, lengths));
            }
            facets.push(facet);
        }
    });
    from_rule(facets)
}

fn digits(mut number: u32, lengths: &[u32]) -> Vec<u32> {
    let digit = |&n: &u32| {
        let d = number % n;
        number /= n;
        d
    };
    lengths.iter().map(digit).collect()
}

fn number(place: &[u32], lengths: &[u32]) -> u32 {
    place.iter().zip(lengths).rev().fold(0, |sum, (&d, &n)| sum * n + d)
}

/// A grid of `columns` x `rows` squares, each cut along the diagonal from (i, j) to (i + 1, j + 1), closed up by `close`,
/// which takes a place of `0..=columns` x `0..=rows` to a vertex.
fn square_grid(columns: u32, rows: u32, close: impl Fn(u32, u32) -> u32) -> Vec<Vec<u32>> {
    let mut facets = Vec::new();
    for i in 0..columns {
        for j in 0..rows {
            let [a, b, c, d] = [close(i, j), close(i + 1, j), close(i, j + 1), close(i + 1, j + 1)];
            facets.extend([vec![a, b, d], vec![a, c, d]]);
        }
    }
    facets
}

/// The Klein bottle as a grid of `columns` x `rows` squares: the rows close up as a circle, the last column is glued to
/// the first upside down.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless there are 4 columns and 3 rows or more.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::klein_grid(5, 5)?.f_vector(), [25, 75, 50]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn klein_grid(columns: u32, rows: u32) -> Result<SimplicialComplex, Error> {
    require((4..1 << 15).contains(&columns) && (3..1 << 15).contains(&rows), || {
        format!(
            "a Klein bottle of {columns} x {rows} squares is not built; it takes 4 columns and 3 rows or more"
        )
    })?;
    from_rule(square_grid(columns, rows, |i, j| {
        if i == columns { (rows - j % rows) % rows } else { i * rows + j % rows }
    }))
}

/// The Klein bottle with 8 vertices, the least possible: the images of five triangles under (0 1 2 3)(4 5)(6 7).
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// That 8 vertices are the least: P. Franklin, *A six color problem* (1934). The rule was found by trying all sets of orbits.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::small_klein_bottle()?.f_vector(), [8, 24, 16]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn small_klein_bottle() -> Result<SimplicialComplex, Error> {
    from_orbits(&[&[0, 1, 4], &[0, 1, 6], &[0, 2, 4], &[0, 2, 7], &[0, 5, 6]], &[&[1, 2, 3, 0, 5, 4, 7, 6]])
}

/// The strip of triangles {i, i+1, i+2} modulo the number of vertices: a Moebius band for odd numbers, an annulus for
/// even ones. 5 vertices give the smallest Moebius band.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless there are 5 to 2^24 vertices.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::triangle_strip(5)?.f_vector(), [5, 10, 5]);
/// assert_eq!(known_spaces::triangle_strip(6)?.f_vector(), [6, 12, 6]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn triangle_strip(vertex_count: u32) -> Result<SimplicialComplex, Error> {
    require((5..=1 << 24).contains(&vertex_count), || {
        format!("a closed strip of {vertex_count} triangles is not built; 5 to 2^24 are")
    })?;
    from_rule((0..vertex_count).map(|i| (i..i + 3).map(|v| v % vertex_count).collect()))
}

/// The torus grid with two far vertices made one: a surface but for one vertex with two fans.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless both lengths are 6 or more.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::pinched_torus_grid(6, 6)?.f_vector(), [35, 108, 72]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn pinched_torus_grid(columns: u32, rows: u32) -> Result<SimplicialComplex, Error> {
    require((6..1 << 15).contains(&columns) && (6..1 << 15).contains(&rows), || {
        format!(
            "a pinched torus of {columns} x {rows} squares is not built; each length must be 6 to 2^15 - 1"
        )
    })?;
    let pinched = (columns / 2) * rows + rows / 2;
    from_rule(square_grid(columns, rows, |i, j| match (i % columns) * rows + j % rows {
        v if v == pinched => 0,
        // The number that is free now is not left out.
        v if v > pinched => v - 1,
        v => v,
    }))
}
