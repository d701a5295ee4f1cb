//! Known spaces, built by rule: the complexes whose topology the literature states, in every dimension that makes sense.
//!
//! Each function says its rule; none reads a stored list longer than a handful of base simplices that a group moves
//! around. Vertices are `0..n` in the order the rule names them. Spaces that are made of others are made by
//! [`SimplicialComplex::cone`], [`SimplicialComplex::suspension`], [`SimplicialComplex::join`],
//! [`SimplicialComplex::wedge`], [`SimplicialComplex::connected_sum`] and [`SimplicialComplex::product`].

use super::SimplicialComplex;
use crate::Error;

pub use super::attached_disk::{dunce_hat, moore_space, presentation_complex};
pub use super::glued_solid::{Solid, glued_solid};

/// The complex of facets that a rule of this file has made: sorted by the rule or not, without repeated vertices.
pub(super) fn from_rule(facets: impl IntoIterator<Item = Vec<u32>>) -> Result<SimplicialComplex, Error> {
    SimplicialComplex::from_facets(facets)
}

/// `Ok` if `holds`; else an error that says what the rule needs.
pub(super) fn require(holds: bool, what: impl FnOnce() -> String) -> Result<(), Error> {
    if holds { Ok(()) } else { Err(Error::invalid(what())) }
}

/// The full simplex of this dimension, with all its faces: a ball.
///
/// # Errors
/// As [`SimplicialComplex::from_facets`] beyond the highest dimension a complex may have.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::simplex(2)?.f_vector(), [3, 3, 1]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn simplex(dimension: usize) -> Result<SimplicialComplex, Error> {
    from_rule([(0..=dimension as u32).collect()])
}

/// The sphere of this dimension as the boundary of the simplex one dimension higher: the fewest vertices possible.
///
/// # Errors
/// As [`SimplicialComplex::from_facets`] beyond the highest dimension a complex may have.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::simplex_boundary(2)?.f_vector(), [4, 6, 4]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn simplex_boundary(dimension: usize) -> Result<SimplicialComplex, Error> {
    let vertices = 0..dimension as u32 + 2;
    from_rule(vertices.clone().map(|left_out| vertices.clone().filter(|&v| v != left_out).collect()))
}

/// The sphere of this dimension as the boundary of the cross-polytope: vertices 2i and 2i + 1 are opposite, a facet
/// takes one of each pair. Dimension 2 is the octahedron.
///
/// # Errors
/// As [`SimplicialComplex::from_facets`] beyond the highest dimension a complex may have.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::cross_polytope_boundary(3)?.f_vector(), [8, 24, 32, 16]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn cross_polytope_boundary(dimension: usize) -> Result<SimplicialComplex, Error> {
    require(dimension < 24, || {
        format!("a cross-polytope of dimension {dimension} has too many facets; the limit is 23")
    })?;
    from_rule(
        (0..1u32 << (dimension + 1))
            .map(|choice| (0..=dimension as u32).map(|i| 2 * i + (choice >> i & 1)).collect()),
    )
}

/// The circle with this many vertices, each joined to the next.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] below 3 vertices.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::circle(5)?.f_vector(), [5, 5]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn circle(vertex_count: u32) -> Result<SimplicialComplex, Error> {
    require(vertex_count >= 3, || {
        format!("a circle of {vertex_count} vertices is not simplicial; it needs 3")
    })?;
    from_rule((0..vertex_count).map(|i| vec![i, (i + 1) % vertex_count]))
}

/// The torus of this dimension with $2^{d+1} - 1$ vertices, cyclic: the facets are the partial sums of the numbers
/// $1, 2, 4, \dots, 2^d$ in every order, moved around modulo the number of vertices. Dimension 2 is the torus with 7
/// vertices (the orbits of {0,1,3} and {0,2,3}), dimension 3 the one with 15.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless the dimension is 1 to 8.
///
/// # References
/// W. Kuehnel, G. Lassmann, *Combinatorial d-tori with a large symmetry group* (1988).
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::cyclic_torus(2)?.f_vector(), [7, 21, 14]);
/// assert_eq!(known_spaces::cyclic_torus(3)?.f_vector(), [15, 105, 180, 90]);
/// # Ok::<(), coface::Error>(())
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

/// Calls `visit` with every order of `0..count`.
fn for_each_permutation(count: usize, visit: &mut dyn FnMut(&[usize])) {
    fn extend(order: &mut Vec<usize>, count: usize, visit: &mut dyn FnMut(&[usize])) {
        if order.len() == count {
            return visit(order);
        }
        for i in 0..count {
            if !order.contains(&i) {
                order.push(i);
                extend(order, count, visit);
                order.pop();
            }
        }
    }
    extend(&mut Vec::with_capacity(count), count, visit);
}

/// The torus as a periodic grid of cubes, each cut into simplices along its diagonal (the Kuhn triangulation): vertex
/// $(i_1, \dots, i_d)$ has the number $i_1 + n_1 (i_2 + n_2 (\dots))$; a facet walks from a vertex along all axes in some
/// order. `lengths` are the numbers of cubes along the axes.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless there is an axis and every length is 3 or more;
/// [`crate::ErrorKind::TooLarge`] beyond 2^31 vertices.
///
/// # References
/// H. W. Kuhn, *Some combinatorial lemmas in topology* (1960).
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::torus_grid(&[3, 3])?.f_vector(), [9, 27, 18]);
/// assert_eq!(known_spaces::torus_grid(&[3, 3, 4])?.f_vector(), [36, 252, 432, 216]);
/// # Ok::<(), coface::Error>(())
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
            crate::ErrorKind::TooLarge,
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
/// [`crate::ErrorKind::InvalidInput`] unless there are 4 columns and 3 rows or more.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::klein_grid(5, 5)?.f_vector(), [25, 75, 50]);
/// # Ok::<(), coface::Error>(())
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

/// The strip of triangles {i, i+1, i+2} modulo the number of vertices: a Moebius band for odd numbers, an annulus for
/// even ones. 5 vertices give the smallest Moebius band.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] below 5 vertices.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::triangle_strip(5)?.f_vector(), [5, 10, 5]);
/// assert_eq!(known_spaces::triangle_strip(6)?.f_vector(), [6, 12, 6]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn triangle_strip(vertex_count: u32) -> Result<SimplicialComplex, Error> {
    require(vertex_count >= 5, || {
        format!("a closed strip of {vertex_count} triangles is not simplicial; it needs 5")
    })?;
    from_rule((0..vertex_count).map(|i| (i..i + 3).map(|v| v % vertex_count).collect()))
}

/// The projective plane with 6 vertices: vertex 5 over the pentagon 0..5, and the triangles {i, i+1, i+3} modulo 5. Half
/// an icosahedron.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::projective_plane()?.f_vector(), [6, 15, 10]);
/// # Ok::<(), coface::Error>(())
/// ```
///
/// # Errors
/// None: the rule is sound.
pub fn projective_plane() -> Result<SimplicialComplex, Error> {
    from_rule((0..5).flat_map(|i| [vec![5, i, (i + 1) % 5], vec![i, (i + 1) % 5, (i + 3) % 5]]))
}

/// The complex projective plane with 9 vertices, the least possible: the images of {0,1,3,4,5} and {0,1,3,4,8} under the
/// group of order 54 that (036)(147)(258), (012)(354) and (01)(34)(67) generate.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// W. Kuehnel, T. F. Banchoff, *The 9-vertex complex projective plane* (1983).
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::complex_projective_plane()?.f_vector(), [9, 36, 84, 90, 36]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn complex_projective_plane() -> Result<SimplicialComplex, Error> {
    let generators: [[u32; 9]; 3] =
        [[3, 4, 5, 6, 7, 8, 0, 1, 2], [1, 2, 0, 5, 3, 4, 6, 7, 8], [1, 0, 2, 4, 3, 5, 7, 6, 8]];
    let mut facets = vec![vec![0, 1, 3, 4, 5], vec![0, 1, 3, 4, 8]];
    let mut done = 0;
    while done < facets.len() {
        for generator in &generators {
            let mut image: Vec<u32> = facets[done].iter().map(|&v| generator[v as usize]).collect();
            image.sort_unstable();
            if !facets.contains(&image) {
                facets.push(image);
            }
        }
        done += 1;
    }
    from_rule(facets)
}

/// The real projective space of this dimension with $2^{n+1} - 1$ vertices: the non-empty proper subsets of n + 2 things,
/// each one with its complement; simplices are chains of subsets. It is half the barycentric subdivision of the boundary
/// of a simplex.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless the dimension is 1 to 7.
///
/// # References
/// W. Kuehnel, *Minimal triangulations of Kummer varieties* (1987).
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::real_projective_space(2)?.f_vector(), [7, 18, 12]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn real_projective_space(dimension: usize) -> Result<SimplicialComplex, Error> {
    require((1..=7).contains(&dimension), || {
        format!("a projective space of dimension {dimension} is not built; 1 to 7 are")
    })?;
    let mut facets = Vec::new();
    let all = (1u32 << (dimension + 2)) - 1;
    for_each_permutation(dimension + 2, &mut |order| {
        let mut subset = 0;
        let prefixes = order[..=dimension].iter().map(|&i| {
            subset |= 1 << i;
            // Of a subset and its complement the smaller number stands for both.
            subset.min(all ^ subset) - 1
        });
        facets.push(prefixes.collect::<Vec<u32>>());
    });
    from_rule(facets)
}

/// The K3 surface with 16 vertices, the least possible: the images of {0,1,2,4,8} and {0,1,2,10,13} under the affine
/// maps x -> ax + b of the field with 16 elements. An element is the number whose bits are the coefficients of a polynomial
/// modulo $x^4 + x + 1$.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// M. Casella, W. Kuehnel, *A triangulated K3 surface with the minimum number of vertices* (2001), found again here by
/// trying all pairs of orbits; isomorphic to the list in the simpcomp library.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::k3_surface()?.f_vector(), [16, 120, 560, 720, 288]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn k3_surface() -> Result<SimplicialComplex, Error> {
    let times = |a: u32, b: u32| {
        let product = (0..4).filter(|i| b >> i & 1 == 1).fold(0, |sum, i| sum ^ a << i);
        (4..7).rev().fold(product, |sum, i| if sum >> i & 1 == 1 { sum ^ 0b1_0011 << (i - 4) } else { sum })
    };
    from_rule((1..16).flat_map(|a| (0..16).map(move |b| (a, b))).flat_map(|(a, b)| {
        [[0, 1, 2, 4, 8], [0, 1, 2, 10, 13]].map(|facet| facet.map(|x| times(a, x) ^ b).to_vec())
    }))
}

/// A bundle of spheres of dimension `dimension - 1` over the circle with few vertices: the boundary of the ring of
/// simplices {i, ..., i + d + 1} modulo the number of vertices. It is the product (orientable) when the dimension times
/// the number of vertices is even, else the twisted bundle.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless the dimension is at least 2 and there are $2d + 3$ vertices or more.
///
/// # References
/// W. Kuehnel, *Higher dimensional analogues of Csaszar's torus* (1986).
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::sphere_bundle_over_circle(3, 9)?.f_vector(), [9, 36, 54, 27]);
/// assert_eq!(known_spaces::sphere_bundle_over_circle(4, 11)?.f_vector(), [11, 55, 110, 110, 44]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn sphere_bundle_over_circle(dimension: u32, vertex_count: u32) -> Result<SimplicialComplex, Error> {
    require((2..=28).contains(&dimension) && (2 * dimension + 3..1 << 24).contains(&vertex_count), || {
        format!(
            "a ring of simplices of dimension {dimension} with {vertex_count} vertices is not built; it needs 2 * dimension + 3 vertices"
        )
    })?;
    from_rule((0..vertex_count).flat_map(|i| {
        (1..=dimension).map(move |left_out| {
            (0..=dimension + 1).filter(|&k| k != left_out).map(|k| (i + k) % vertex_count).collect()
        })
    }))
}

/// The book: `pages` triangles on one common edge {0, 1}.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] from 2^31 pages on.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::book(3)?.f_vector(), [5, 7, 3]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn book(pages: u32) -> Result<SimplicialComplex, Error> {
    require(pages < 1 << 31, || format!("a book of {pages} pages is too large"))?;
    from_rule((0..pages).map(|i| vec![0, 1, 2 + i]).chain([vec![0, 1]]))
}

/// The torus grid with two far vertices made one: a surface but for one vertex with two fans.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless both lengths are 6 or more.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::pinched_torus_grid(6, 6)?.f_vector(), [35, 108, 72]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn pinched_torus_grid(columns: u32, rows: u32) -> Result<SimplicialComplex, Error> {
    require((6..1 << 15).contains(&columns) && (6..1 << 15).contains(&rows), || {
        format!("a pinched torus of {columns} x {rows} squares is not built; each length must be 6 or more")
    })?;
    let pinched = (columns / 2) * rows + rows / 2;
    from_rule(square_grid(columns, rows, |i, j| match (i % columns) * rows + j % rows {
        v if v == pinched => 0,
        // The number that is free now is not left out.
        v if v > pinched => v - 1,
        v => v,
    }))
}

/// The chessboard complex: the vertices are the squares of a board of `rows` x `columns` (number row * columns +
/// column), the simplices the sets of rooks that do not attack each other.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] without squares or beyond 8 rows and columns.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::chessboard(3, 4)?.f_vector(), [12, 36, 24]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn chessboard(rows: u32, columns: u32) -> Result<SimplicialComplex, Error> {
    require((1..=8).contains(&rows) && (1..=8).contains(&columns), || {
        format!("a chessboard of {rows} x {columns} squares is not built; 1 to 8 each are")
    })?;
    // Each facet has a rook in every line of the shorter direction.
    let (short, long) = (rows.min(columns), rows.max(columns));
    let mut facets = Vec::new();
    let mut chosen = Vec::new();
    fn extend(chosen: &mut Vec<u32>, short: u32, long: u32, facets: &mut Vec<Vec<u32>>) {
        if chosen.len() == short as usize {
            return facets.push(chosen.clone());
        }
        for place in 0..long {
            if !chosen.contains(&place) {
                chosen.push(place);
                extend(chosen, short, long, facets);
                chosen.pop();
            }
        }
    }
    extend(&mut chosen, short, long, &mut facets);
    from_rule(facets.into_iter().map(|facet| {
        let square = |(line, place): (usize, u32)| {
            if rows <= columns { line as u32 * columns + place } else { place * columns + line as u32 }
        };
        facet.into_iter().enumerate().map(square).collect()
    }))
}

/// The matching complex: the vertices are the pairs of `0..count` in lexicographic order, the simplices the sets of
/// disjoint pairs.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless the count is 2 to 12.
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::matching_complex(7)?.f_vector(), [21, 105, 105]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn matching_complex(count: u32) -> Result<SimplicialComplex, Error> {
    require((2..=12).contains(&count), || {
        format!("a matching complex on {count} points is not built; 2 to 12 are")
    })?;
    // The pair a < b has the number of pairs before it.
    let pair = |a: u32, b: u32| a * count - a * (a + 1) / 2 + b - a - 1;
    let mut facets = Vec::new();
    fn extend(free: &[u32], spare: bool, chosen: &mut Vec<[u32; 2]>, facets: &mut Vec<Vec<[u32; 2]>>) {
        let Some((&a, rest)) = free.split_first() else { return facets.push(chosen.clone()) };
        if spare {
            extend(rest, false, chosen, facets);
        }
        for (i, &b) in rest.iter().enumerate() {
            let others: Vec<u32> =
                rest.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, &v)| v).collect();
            chosen.push([a, b]);
            extend(&others, spare, chosen, facets);
            chosen.pop();
        }
    }
    extend(&(0..count).collect::<Vec<_>>(), count % 2 == 1, &mut Vec::new(), &mut facets);
    from_rule(facets.into_iter().map(|matching| matching.into_iter().map(|[a, b]| pair(a, b)).collect()))
}

/// The sum complex: vertices are the integers modulo `modulus`; the facets are the sets of as many vertices as
/// `sums` has members whose sum is among them; every smaller set is a simplex.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless there are 2 to 5 different sums and the modulus is larger and at most 200.
///
/// # References
/// N. Linial, R. Meshulam, M. Rosenthal, *Sum complexes: a new family of hypertrees* (2010).
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// assert_eq!(known_spaces::sum_complex(11, &[0, 1, 3])?.f_vector(), [11, 55, 45]);
/// # Ok::<(), coface::Error>(())
/// ```
pub fn sum_complex(modulus: u32, sums: &[u32]) -> Result<SimplicialComplex, Error> {
    let mut sums: Vec<u32> = sums.iter().map(|s| s % modulus.max(1)).collect();
    sums.sort_unstable();
    sums.dedup();
    let size = sums.len();
    require((2..=5).contains(&size) && size < modulus as usize && modulus <= 200, || {
        format!(
            "a sum complex modulo {modulus} with {size} different sums is not built; 2 to 5 sums are, modulo at most 200"
        )
    })?;
    let mut facets = Vec::new();
    let mut chosen: Vec<u32> = (0..size as u32).collect();
    loop {
        if sums.contains(&(chosen.iter().sum::<u32>() % modulus)) {
            facets.push(chosen.clone());
        } else {
            // Every proper subset stays a simplex.
            facets.extend(
                (0..size)
                    .map(|i| chosen.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, &v)| v).collect()),
            );
        }
        // The next combination in lexicographic order.
        let Some(i) = (0..size).rev().find(|&i| chosen[i] < modulus - (size - i) as u32) else { break };
        chosen[i] += 1;
        for j in i + 1..size {
            chosen[j] = chosen[j - 1] + 1;
        }
    }
    from_rule(facets)
}

/// The lens space L(p, q) with $9p + 6$ vertices: two solid tori on one torus.
///
/// The torus is the plane grid (squares with a diagonal) modulo the lattice spanned by (3p, 0) and (3q, 3). One solid
/// torus has disks in the direction (0, 1), where walks close up after 3p steps, the other in the direction (1, 0). A
/// solid torus is three slices: a center for each disk, each disk times an interval cut into simplices.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] unless p and q are coprime, p is 1 to 2^20 and q below p (0 for p = 1).
///
/// # Examples
/// ```
/// use coface::simplicial::known_spaces;
/// let space = known_spaces::lens_space(5, 2)?;
/// assert_eq!((space.dimension(), space.euler_characteristic(), space.f_vector()[0]), (Some(3), 0, 51));
/// # Ok::<(), coface::Error>(())
/// ```
pub fn lens_space(p: u32, q: u32) -> Result<SimplicialComplex, Error> {
    require((1..1 << 20).contains(&p) && q < p.max(1) && greatest_common_divisor(p, q) == 1, || {
        format!("there is no lens space L({p}, {q}); p and q must be coprime, q below p")
    })?;
    let (p, q) = (u64::from(p), u64::from(q));
    // The vertex of the torus at (x, y): reduce y into 0..3 by the second lattice vector, then x into 0..3p.
    let vertex = |x: u64, y: u64| {
        let turns = y / 3;
        let x = (x + 3 * (p - q) * (turns % p)) % (3 * p);
        (x * 3 + y % 3) as u32
    };
    let mut facets = Vec::new();
    for swapped in [false, true] {
        // Disk `slice` is spanned by the walk (slice, 0), (slice, 1), ...; the other solid torus swaps the axes.
        let rim = |slice: u64, step: u64| if swapped { vertex(step, slice) } else { vertex(slice, step) };
        // Three disks. After three slices the walk is the first again, shifted: (3, y) is (0, y + shift) and the
        // prisms between slices close up by themselves, for the rim is a vertex of the torus.
        let center = |slice: u64| (9 * p + if swapped { 3 } else { 0 } + slice % 3) as u32;
        for slice in 0..3 {
            for step in 0..3 * p {
                let [c, d] = [center(slice), center(slice + 1)];
                let [a, b] = [rim(slice, step), rim(slice, step + 1)];
                let [e, f] = [rim(slice + 1, step), rim(slice + 1, step + 1)];
                facets.extend([vec![c, a, b, f], vec![c, a, e, f], vec![c, d, e, f]]);
            }
        }
    }
    from_rule(facets)
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
