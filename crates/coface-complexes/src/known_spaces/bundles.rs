//! Bundles over the circle.

use super::{from_rule, require};
use crate::simplicial::SimplicialComplex;
use coface_algebra::{Error, VertexId};

/// A bundle of spheres of dimension `dimension - 1` over the circle with few vertices: the boundary of the ring of
/// simplices {i, ..., i + d + 1} modulo the number of vertices. It is the product (orientable) when the dimension times
/// the number of vertices is even, else the twisted bundle.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the dimension is at least 2 and there are $2d + 3$ vertices or more.
///
/// # References
/// W. Kuehnel, *Higher dimensional analogues of Csaszar's torus* (1986).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::sphere_bundle_over_circle(3, 9)?.f_vector(), [9, 36, 54, 27]);
/// assert_eq!(known_spaces::sphere_bundle_over_circle(4, 11)?.f_vector(), [11, 55, 110, 110, 44]);
/// # Ok::<(), coface_algebra::Error>(())
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

/// The mapping torus of an automorphism of a complex: the fiber times an interval, with each vertex of one end glued to its
/// image on the other. Of a closed manifold it is the bundle over the circle with this monodromy.
///
/// There are three copies of the fiber; vertex number i of the fiber, in rising order, has the numbers i, n + i and 2n + i,
/// n being the number of vertices. Prisms between copies are cut by that order.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless `image` moves the vertices one to one and facets to facets, naming the first
/// vertex or facet where it does not; [`coface_algebra::ErrorKind::TooLarge`] beyond 2^30 vertices.
///
/// # Complexity
/// A facet of dimension d becomes 3 (d + 1) facets.
///
/// # Examples
/// A circle reflected: the Klein bottle.
/// ```
/// use coface_algebra::VertexId;
/// use coface_complexes::known_spaces;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let circle = known_spaces::circle(3)?;
/// let bottle = known_spaces::mapping_torus(&circle, |v| VertexId::new((3 - v.index()) % 3))?;
/// assert_eq!(bottle.f_vector(), [9, 27, 18]);
/// assert_eq!(bottle.orientability()?.is_orientable(), Some(false));
/// # Ok(()) }
/// ```
pub fn mapping_torus(
    fiber: &SimplicialComplex,
    image: impl Fn(VertexId) -> VertexId,
) -> Result<SimplicialComplex, Error> {
    let vertices: Vec<VertexId> = fiber.vertices().collect();
    let n = vertices.len();
    if n >= 1 << 30 {
        return Err(Error::new(
            coface_algebra::ErrorKind::TooLarge,
            format!("three copies of {n} vertices exceed 32-bit vertex numbers"),
        ));
    }
    let mut images = Vec::with_capacity(n);
    let mut taken = vec![false; n];
    for &v in &vertices {
        let place = vertices.binary_search(&image(v)).ok().filter(|&place| !taken[place]);
        let Some(place) = place else {
            return Err(Error::invalid(format!(
                "the image {} of {v} is no vertex of the fiber or is taken",
                image(v)
            ))
            .with_cure("give a map that moves the vertices of the fiber one to one"));
        };
        taken[place] = true;
        images.push(place as u32);
    }
    let mut facets = Vec::new();
    for facet in fiber.facets() {
        let moved = crate::simplicial::Simplex::new(facet.vertices().map(&image))?;
        require(fiber.contains(&moved), || {
            format!("the image {moved} of the facet {facet} is no simplex of the fiber")
        })?;
        let places: Vec<u32> = facet
            .vertices()
            .map(|v| vertices.binary_search(&v).expect("a complex lists its vertices") as u32)
            .collect();
        for level in 0..3 {
            let here = |place: u32| level * n as u32 + place;
            let there = |place: u32| {
                if level == 2 { images[place as usize] } else { (level + 1) * n as u32 + place }
            };
            facets.extend(prism(&places, here, there));
        }
    }
    from_rule(facets)
}

/// The prism between two copies of a simplex whose vertices are in order, cut into simplices: the first of it here, the rest
/// there.
fn prism(simplex: &[u32], here: impl Fn(u32) -> u32, there: impl Fn(u32) -> u32) -> Vec<Vec<u32>> {
    let cut = |i: usize| {
        let below = simplex[..=i].iter().map(|&v| here(v));
        below.chain(simplex[i..].iter().map(|&v| there(v))).collect()
    };
    (0..simplex.len()).map(cut).collect()
}

type Vector = [i64; 2];

/// The bundle of tori over the circle with this monodromy, a matrix A of determinant 1 or -1 that acts on columns: the
/// torus times an interval, with p at its end glued to $A^{-1} p$ at its start. $H_1 = \mathbb{Z} \oplus
/// \operatorname{coker}(A - 1)$; the space is flat if A has finite order, nil if A has the only eigenvalue 1 (or -1) and infinite
/// order, solv otherwise.
///
/// The torus is the grid of 3 x 3 squares with diagonals. A changes its edges but not its vertices; a layer of tetrahedra on
/// all parallelograms of the grid flips their diagonals, and flips lead from the edges (1,0), (0,1), (1,1) to their images
/// under A. Levels of 9 vertices are one for each layer, and three at least.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the determinant is 1 or -1 and the entries are at most 10,000 in absolute value.
///
/// # References
/// W. Floyd, A. Hatcher, *Incompressible surfaces in punctured-torus bundles* (1982), section 1: layers of flips along the
/// Farey graph.
///
/// # Examples
/// The Heisenberg manifold.
/// ```
/// use coface_complexes::known_spaces;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let heisenberg = known_spaces::torus_bundle([[1, 1], [0, 1]])?;
/// assert_eq!(heisenberg.f_vector(), [27, 198, 342, 171]);
/// assert_eq!(heisenberg.chain_complex()?.euler_characteristic(), 0);
/// # Ok(()) }
/// ```
pub fn torus_bundle(monodromy: [[i64; 2]; 2]) -> Result<SimplicialComplex, Error> {
    let [[a, b], [c, d]] = monodromy;
    let is_small = monodromy.as_flattened().iter().all(|x| (-10_000..=10_000).contains(x));
    require(is_small && (a * d - b * c).abs() == 1, || {
        format!(
            "no torus bundle has the monodromy {monodromy:?}; its determinant must be 1 or -1, its entries at most 10,000"
        )
    })?;
    let determinant = a * d - b * c;
    let inverse = [[determinant * d, -determinant * b], [-determinant * c, determinant * a]];
    let flips = flips_to([[a, c], [b, d]]);
    let level_count = flips.len().max(3);
    let vertex = |level: usize, [x, y]: Vector| {
        let ([x, y], level) =
            if level == level_count { (inverse.map(|[p, q]| p * x + q * y), 0) } else { ([x, y], level) };
        (9 * level as i64 + 3 * x.rem_euclid(3) + y.rem_euclid(3)) as u32
    };
    let points = || (0..3).flat_map(|x| (0..3).map(move |y| [x, y]));
    let mut facets = Vec::new();
    let mut sides: [Vector; 2] = [[1, 0], [0, 1]];
    for level in 0..level_count {
        for p in points() {
            for side in sides {
                let triangle = [p, sum(p, side), sum(p, sum(sides[0], sides[1]))];
                let mut triangle = triangle.map(|[x, y]| [x.rem_euclid(3), y.rem_euclid(3)]);
                triangle.sort_unstable();
                facets.extend(prism(
                    &[0, 1, 2],
                    |i| vertex(level, triangle[i as usize]),
                    |i| vertex(level + 1, triangle[i as usize]),
                ));
            }
        }
        let Some(&[u, v]) = flips.get(level) else { continue };
        for p in points() {
            let corners = [p, sum(p, u), sum(p, v), sum(p, sum(u, v))];
            facets.push(corners.map(|corner| vertex(level + 1, corner)).to_vec());
        }
        sides = [u, v];
    }
    from_rule(facets)
}

fn sum(p: Vector, q: Vector) -> Vector {
    [p[0] + q[0], p[1] + q[1]]
}

/// The sides u, v of the parallelograms whose diagonal u - v is flipped to u + v, one flip after the other, on the way from
/// the edges (1,0), (0,1), (1,1) to those with these sides and their sum. Backwards: the longest edge is the sum of the
/// others (up to signs), and flipping it makes it shorter.
fn flips_to([u, v]: [Vector; 2]) -> Vec<[Vector; 2]> {
    let length = |p: Vector| p[0].abs() + p[1].abs();
    // Of a vector and its opposite, the one that rises first.
    let positive = |p: Vector| if p < [0, 0] { p.map(|x| -x) } else { p };
    let mut edges = [positive(u), positive(v), positive(sum(u, v))];
    let mut flips = Vec::new();
    loop {
        edges.sort_unstable();
        if edges == [[0, 1], [1, 0], [1, 1]] {
            break;
        }
        edges.sort_by_key(|&p| length(p));
        let [u, v, longest] = edges;
        let v = if positive(sum(u, v)) == longest { v } else { v.map(|x| -x) };
        flips.push([u, v]);
        edges[2] = positive(sum(u, v.map(|x| -x)));
    }
    flips.reverse();
    flips
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn monodromies_that_are_none_are_refused() {
        assert!(torus_bundle([[1, 1], [1, 1]]).is_err());
        assert!(torus_bundle([[1, i64::MAX], [0, 1]]).is_err());
        let circle = super::super::circle(4).unwrap();
        let error = mapping_torus(&circle, |_| VertexId::new(0)).unwrap_err();
        assert!(error.message().contains("or is taken"), "{error}");
        let exchange = |v: VertexId| if v.index() < 2 { VertexId::new(1 - v.index()) } else { v };
        let error = mapping_torus(&circle, exchange).unwrap_err();
        assert!(error.message().contains("is no simplex of the fiber"), "{error}");
    }
}
