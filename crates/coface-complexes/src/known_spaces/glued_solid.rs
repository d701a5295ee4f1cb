//! Closed 3-manifolds from one solid whose opposite faces are glued with a twist.

use super::require;
use crate::simplicial::{Simplex, SimplicialComplex};
use coface_algebra::Error;
use coface_algebra::UnionFind;
use std::collections::BTreeMap;

/// A solid with central symmetry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Solid {
    /// 6 squares.
    Cube,
    /// 8 triangles.
    Octahedron,
    /// 12 pentagons.
    Dodecahedron,
}

/// The space that a solid becomes when each face is glued to the opposite one: a point goes through the center of the
/// solid to the opposite face and is then turned there by `steps` corners, counter-clockwise as seen from outside the
/// first face.
///
/// * Cube: 0 gives the projective space, 1 or 3 the quaternion space, 2 the 3-torus.
/// * Octahedron: 0 gives the projective space, 1 or 2 the octahedral space.
/// * Dodecahedron: 0 gives the projective space, 1 or 4 the space of Weber and Seifert, 2 or 3 the homology sphere of
///   Poincare.
///
/// The simplices are those of the second barycentric subdivision of the glued solid; its first is a complex of simplices
/// that may have all vertices in common.
///
/// # Errors
/// As [`SimplicialComplex::from_facets`].
///
/// # References
/// C. Weber, H. Seifert, *Die beiden Dodekaederraeume* (1933); W. P. Thurston, *Three-dimensional geometry and topology*
/// (1997), section 1.4.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::{Solid, glued_solid};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let poincare = glued_solid(Solid::Dodecahedron, 2)?;
/// assert_eq!((poincare.dimension(), poincare.simplex_count(3)), (Some(3), 120 * 24));
/// # Ok(()) }
/// ```
pub fn glued_solid(solid: Solid, steps: usize) -> Result<SimplicialComplex, Error> {
    let (vertex_count, faces, antipodes) = description(solid);
    let faces: Vec<(Vec<u32>, usize)> = faces.into_iter().map(|face| (face, steps)).collect();
    glued(vertex_count, &faces, &antipodes)
}

/// The truncated cube with its faces glued to the opposite ones by the least turn, an eighth for octagons and a sixth for
/// triangles: the quotient of the 3-sphere by the binary octahedral group of order 48. Its first homology group is Z/2.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// W. P. Thurston, *Three-dimensional geometry and topology* (1997), section 4.4.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::truncated_cube_space;
/// let space = truncated_cube_space()?;
/// assert_eq!((space.simplex_count(3), space.euler_characteristic()), ((6 * 8 + 8 * 3) * 2 * 24, 0));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn truncated_cube_space() -> Result<SimplicialComplex, Error> {
    // Vertex 3 c + a is the end near corner c of the cut edge in direction a; corner x + 2 y + 4 z.
    let vertex = |corner: u32, axis: u32| 3 * corner + axis;
    let mut faces = Vec::new();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let bit = |a: u32| 1 << a;
        // Around the face where the coordinate is 1, counter-clockwise: each side is what is left of an edge.
        let corners = [bit(axis), bit(axis) | bit(u), bit(axis) | bit(u) | bit(v), bit(axis) | bit(v)];
        let sides = [u, v, u, v];
        let octagon = (0..4).flat_map(|i| {
            let next = (i + 1) % 4;
            [vertex(corners[i], sides[i]), vertex(corners[next], sides[i])]
        });
        faces.push((octagon.collect(), 3));
    }
    // The triangles at the four corners with x + y + z odd, one of each opposite pair. Corner 111 sees its axes in rising
    // order counter-clockwise, and each coordinate that is 0 instead mirrors the view.
    for corner in [7u32, 1, 2, 4] {
        let mut triangle: Vec<u32> = (0..3).map(|axis| vertex(corner, axis)).collect();
        if corner.count_zeros() % 2 != 7u32.count_zeros() % 2 {
            triangle.swap(1, 2);
        }
        faces.push((triangle, 1));
    }
    let antipodes: Vec<u32> = (0..24).map(|v| vertex(7 - v / 3, v % 3)).collect();
    glued(24, &faces, &antipodes)
}

/// The prism manifold of order 4n: a prism over a 2n-gon whose bases are glued by a turn of one corner and whose opposite
/// sides by a quarter turn. It is the quotient of the 3-sphere by the binary dihedral group of order 4n; n = 2 gives the
/// quaternion space.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless n is 2 to 10,000.
///
/// # References
/// W. P. Thurston, *Three-dimensional geometry and topology* (1997), section 4.4.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::prism_manifold;
/// assert_eq!(prism_manifold(3)?.simplex_count(3), (2 * 6 + 6 * 4) * 2 * 24);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn prism_manifold(n: u32) -> Result<SimplicialComplex, Error> {
    require((2..=10_000).contains(&n), || {
        format!("a prism manifold of order 4 * {n} is not built; 2 to 10,000 are")
    })?;
    // Vertices 0 to 2n - 1 around the upper base, counter-clockwise from above, then those below them.
    let sides = 2 * n;
    let mut faces = vec![((0..sides).collect(), n as usize - 1)];
    faces.extend((0..n).map(|i| (vec![i, sides + i, sides + i + 1, i + 1], 1)));
    let antipodes: Vec<u32> =
        (0..2 * sides).map(|v| (v % sides + n) % sides + if v < sides { sides } else { 0 }).collect();
    glued(2 * sides, &faces, &antipodes)
}

/// The space that a solid with central symmetry becomes when each of these faces is glued to its opposite: the face goes
/// through the center and is then turned by its own number of corners. Vertices go counter-clockwise as seen from outside.
fn glued(
    vertex_count: u32,
    faces: &[(Vec<u32>, usize)],
    antipodes: &[u32],
) -> Result<SimplicialComplex, Error> {
    let opposite = |face: &[u32]| -> Vec<u32> { face.iter().map(|&v| antipodes[v as usize]).collect() };
    let all_faces: Vec<Vec<u32>> = faces
        .iter()
        .map(|(face, _)| face.clone())
        .chain(faces.iter().map(|(face, _)| opposite(face)))
        .collect();

    // The cells are numbered: vertices, edges, faces, the body last.
    let mut edges: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for face in &all_faces {
        for (a, b) in sides(face) {
            let next = vertex_count + edges.len() as u32;
            edges.entry([a.min(b), a.max(b)]).or_insert(next);
        }
    }
    let edge = |a: u32, b: u32| edges[&[a.min(b), a.max(b)]];
    let first_face = vertex_count + edges.len() as u32;
    let body = first_face + all_faces.len() as u32;
    let mut flags = Vec::new();
    for (f, face) in all_faces.iter().enumerate() {
        for (a, b) in sides(face) {
            flags.extend([a, b].map(|end| [end, edge(a, b), first_face + f as u32, body]));
        }
    }
    let subdivided = SimplicialComplex::from_facets(&flags)?;
    let simplices: Vec<Simplex> = subdivided.iter().collect();
    let number = |cells: &[u32]| {
        let simplex = Simplex::from_sorted(cells);
        simplices.binary_search(&simplex).expect("faces of flags are listed") as u32
    };

    // Each simplex of a face is one with its image on the opposite face.
    let mut classes = UnionFind::new(simplices.len());
    for (f, (face, steps)) in faces.iter().enumerate() {
        let n = face.len();
        let image = |k: usize| antipodes[face[(k + steps) % n] as usize];
        for k in 0..n {
            let after = (k + 1) % n;
            let (e, image_e) = (edge(face[k], face[after]), edge(image(k), image(after)));
            let (here, there) = (first_face + f as u32, first_face + (f + faces.len()) as u32);
            for end in [k, after] {
                let (from, to) = ([face[end], e, here], [image(end), image_e, there]);
                for mask in 1..8u32 {
                    let chosen = |cells: [u32; 3]| -> Vec<u32> {
                        (0..3).filter(|i| mask >> i & 1 == 1).map(|i| cells[i]).collect()
                    };
                    classes.unite(number(&chosen(from)), number(&chosen(to)));
                }
            }
        }
    }
    let classes = classes.class_numbers();

    // The second subdivision: chains of faces of the flags.
    let mut facets = Vec::with_capacity(24 * flags.len());
    for flag in &flags {
        for a in 0..4 {
            for b in (0..4).filter(|&b| b != a) {
                for c in (0..4).filter(|&c| c != a && c != b) {
                    let chain =
                        [vec![a], vec![a, b], vec![a, b, c], vec![0, 1, 2, 3]].map(|mut positions| {
                            positions.sort_unstable();
                            let cells: Vec<u32> = positions.iter().map(|&i: &usize| flag[i]).collect();
                            classes[number(&cells) as usize]
                        });
                    facets.push(chain);
                }
            }
        }
    }
    SimplicialComplex::from_facets(facets)
}

fn sides(face: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    (0..face.len()).map(|i| (face[i], face[(i + 1) % face.len()]))
}

/// The number of vertices, one face of each opposite pair, counter-clockwise from outside, and the opposite of each
/// vertex.
fn description(solid: Solid) -> (u32, Vec<Vec<u32>>, Vec<u32>) {
    match solid {
        // Vertex x + 2y + 4z has the coordinates x, y, z.
        Solid::Cube => {
            (8, vec![vec![1, 3, 7, 5], vec![2, 6, 7, 3], vec![4, 5, 7, 6]], (0..8).map(|v| 7 - v).collect())
        }
        // Vertices +x, -x, +y, -y, +z, -z.
        Solid::Octahedron => (
            6,
            vec![vec![0, 2, 4], vec![1, 3, 4], vec![1, 4, 2], vec![0, 4, 3]],
            (0..6).map(|v| v ^ 1).collect(),
        ),
        // Four rings of five from top to bottom: t, m, n, b. The faces stand for the vertices of an icosahedron, the
        // top and its upper ring.
        Solid::Dodecahedron => {
            let [t, m, n, b] = [0, 5, 10, 15].map(|ring| move |i: u32| ring + i % 5);
            let mut faces = vec![(0..5).map(t).collect()];
            faces.extend((0..5).map(|i| vec![t(i), t(i + 4), m(i + 4), n(i + 4), m(i)]));
            let rings = [
                (0..5).map(|i| b(i + 2)).collect::<Vec<u32>>(),
                (0..5).map(|i| n(i + 2)).collect(),
                (0..5).map(|i| m(i + 3)).collect(),
                (0..5).map(|i| t(i + 3)).collect(),
            ];
            (20, faces, rings.concat())
        }
    }
}
