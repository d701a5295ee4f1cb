//! The table of the known spaces without positions.

use super::{Family, Parameter, ParameterKind};
use crate::known_spaces::{self, FlatManifold, Solid};
use coface_algebra::Error;

const FLAT_NAMES: [&str; 10] = ["g1", "g2", "g3", "g4", "g5", "g6", "b1", "b2", "b3", "b4"];

pub(super) static SPACES: &[Family] = &[
    Family::space(
        "simplex-boundary",
        "The boundary of a simplex: the least sphere",
        &[Parameter::count("dimension", "D", "The dimension of the sphere", 2).within(0, 30)],
        |given| known_spaces::simplex_boundary(given.count("dimension") as usize),
    ),
    Family::space(
        "cross-polytope",
        "The boundary of a cross polytope, a sphere; dimension 2 is the octahedron",
        &[Parameter::count("dimension", "D", "The dimension of the sphere", 2)],
        |given| known_spaces::cross_polytope_boundary(given.count("dimension") as usize),
    ),
    Family::space(
        "cyclic-torus",
        "The torus with 2^(d+1) - 1 vertices",
        &[Parameter::count("dimension", "D", "The dimension, 1 to 8", 2)],
        |given| known_spaces::cyclic_torus(given.count("dimension") as usize),
    ),
    Family::space(
        "torus-grid",
        "A torus as a periodic grid of cubes cut into simplices",
        &[Parameter::new(
            "shape",
            "N,N,..",
            "The numbers of cubes along the axes, each 3 or more",
            ParameterKind::Counts { usual: &[3, 3] },
        )],
        |given| known_spaces::torus_grid(&given.counts("shape")),
    ),
    Family::space(
        "klein-grid",
        "A Klein bottle as a grid of squares cut into triangles",
        &[
            Parameter::count("columns", "N", "The number of columns, 4 or more", 5),
            Parameter::count("rows", "N", "The number of rows, 3 or more", 5),
        ],
        |given| known_spaces::klein_grid(given.count("columns"), given.count("rows")),
    ),
    Family::space("small-klein", "The Klein bottle with 8 vertices", &[], |_| {
        known_spaces::small_klein_bottle()
    }),
    Family::space(
        "pinched-torus",
        "A torus grid with two vertices made one: no surface",
        &[
            Parameter::count("columns", "N", "The number of columns, 6 or more", 6),
            Parameter::count("rows", "N", "The number of rows, 6 or more", 6),
        ],
        |given| known_spaces::pinched_torus_grid(given.count("columns"), given.count("rows")),
    ),
    Family::space(
        "strip",
        "A closed strip of triangles: a Moebius band for odd numbers, an annulus for even ones",
        &[Parameter::count("vertices", "N", "The number of vertices, 5 or more", 5)],
        |given| known_spaces::triangle_strip(given.count("vertices")),
    ),
    Family::space("rp2", "The projective plane with 6 vertices", &[], |_| known_spaces::projective_plane())
        .also(&["projective-plane"]),
    Family::space(
        "rp",
        "Real projective space",
        &[Parameter::count("dimension", "D", "The dimension", 3)],
        |given| known_spaces::real_projective_space(given.count("dimension") as usize),
    ),
    Family::space("cp2", "The complex projective plane with 9 vertices", &[], |_| {
        known_spaces::complex_projective_plane()
    }),
    Family::space(
        "hp2",
        "A manifold of dimension 8 with 15 vertices, like the quaternionic projective plane",
        &[],
        |_| known_spaces::quaternionic_projective_plane(),
    ),
    Family::space("k3", "The K3 surface with 16 vertices", &[], |_| known_spaces::k3_surface()),
    Family::space(
        "lens",
        "The lens space L(p, q)",
        &[
            Parameter::count("p", "P", "The order of the fundamental group", 5),
            Parameter::count("q", "Q", "The twist, coprime to p", 2),
        ],
        |given| known_spaces::lens_space(given.count("p"), given.count("q")),
    )
    .also(&["lens-space"]),
    Family::space("poincare", "The homology sphere of Poincare", &[], |_| {
        known_spaces::glued_solid(Solid::Dodecahedron, 2)
    })
    .also(&["poincare-sphere"]),
    Family::space("weber-seifert", "The hyperbolic space of Weber and Seifert", &[], |_| {
        known_spaces::glued_solid(Solid::Dodecahedron, 1)
    }),
    Family::space(
        "glued-solid",
        "A solid with opposite faces glued with a twist",
        &[
            Parameter::new(
                "solid",
                "SOLID",
                "The solid",
                ParameterKind::Choice { words: &["cube", "octahedron", "dodecahedron"], usual: Some("cube") },
            ),
            Parameter::count("steps", "N", "The twist in corners", 1).within(0, 4),
        ],
        |given| {
            let solid = match given.choice("solid") {
                Some("octahedron") => Solid::Octahedron,
                Some("dodecahedron") => Solid::Dodecahedron,
                _ => Solid::Cube,
            };
            known_spaces::glued_solid(solid, given.count("steps") as usize)
        },
    ),
    Family::space(
        "prism-manifold",
        "The prism manifold of order 4 n",
        &[Parameter::count("n", "N", "A quarter of the order of the fundamental group", 2)],
        |given| known_spaces::prism_manifold(given.count("n")),
    ),
    Family::space(
        "truncated-cube",
        "The truncated cube with opposite faces glued: fundamental group of order 48",
        &[],
        |_| known_spaces::truncated_cube_space(),
    ),
    Family::space(
        "flat",
        "One of the ten closed flat manifolds of dimension 3",
        &[Parameter::new(
            "manifold",
            "MANIFOLD",
            "Its name after Wolf",
            ParameterKind::Choice { words: &FLAT_NAMES, usual: Some("g6") },
        )],
        |given| {
            let place = FLAT_NAMES.iter().position(|name| given.choice("manifold") == Some(name));
            known_spaces::flat_manifold(FlatManifold::ALL[place.expect("the choice is one of the names")])
        },
    ),
    Family::space(
        "torus-bundle",
        "The torus bundle over the circle with this monodromy",
        &[Parameter::new(
            "matrix",
            "A,B,C,D",
            "The matrix, row after row, of determinant 1 or -1",
            ParameterKind::Integers { usual: &[2, 1, 1, 1] },
        )],
        |given| {
            let matrix = given.integers("matrix");
            let [a, b, c, d] = matrix[..] else {
                let message = format!("a matrix of {} entries is no monodromy of a torus", matrix.len());
                return Err(Error::invalid(message).with_cure("give four integers, row after row"));
            };
            known_spaces::torus_bundle([[a, b], [c, d]])
        },
    ),
    Family::space(
        "sphere-bundle",
        "The sphere bundle over the circle with few vertices",
        &[
            Parameter::count("dimension", "D", "The dimension, 2 or more", 3).within(0, 20),
            Parameter::new(
                "vertices",
                "N",
                "The number of vertices, 2 d + 3 or more",
                ParameterKind::Count { usual: None, least: 0, most: 1_000_000 },
            ),
        ],
        |given| {
            let dimension = given.count("dimension");
            let vertices = given.count_if_given("vertices").unwrap_or(2 * dimension + 3);
            known_spaces::sphere_bundle_over_circle(dimension, vertices)
        },
    ),
    Family::space(
        "moore",
        "A disk attached along a circle run n times: torsion of order n",
        &[Parameter::count("order", "N", "The order, 2 or more", 3)],
        |given| known_spaces::moore_space(given.count("order")),
    ),
    Family::space(
        "presentation",
        "The presentation complex of a group",
        &[
            Parameter::count("generators", "N", "The number of generators", 0).within(0, 1_000_000),
            Parameter::new(
                "relators",
                "WORD",
                "A relator as letters 1, -1, 2, ..: 1,2,-1,-2; may be repeated",
                ParameterKind::Words,
            ),
        ],
        |given| known_spaces::presentation_complex(given.count("generators"), given.words("relators")),
    ),
    Family::space("dunce-hat", "The dunce hat: contractible, but nowhere collapsible", &[], |_| {
        known_spaces::dunce_hat()
    }),
    Family::space("house", "The house with two rooms of Bing", &[], |_| known_spaces::house_with_two_rooms()),
    Family::space(
        "book",
        "Triangles around one edge",
        &[Parameter::count("pages", "N", "The number of triangles", 3)],
        |given| known_spaces::book(given.count("pages")),
    ),
    Family::space(
        "chessboard",
        "The chessboard complex: rooks that do not take each other",
        &[
            Parameter::count("rows", "N", "The number of rows, 1 to 8", 3),
            Parameter::count("columns", "N", "The number of columns, 1 to 8", 4),
        ],
        |given| known_spaces::chessboard(given.count("rows"), given.count("columns")),
    ),
    Family::space(
        "matching",
        "The matching complex of a complete graph",
        &[Parameter::count("count", "N", "The number of vertices of the graph, 2 to 12", 7)],
        |given| known_spaces::matching_complex(given.count("count")),
    ),
    Family::space(
        "sum-complex",
        "A sum complex modulo n",
        &[
            Parameter::count("modulus", "N", "The modulus", 7),
            Parameter::new(
                "sums",
                "N,N,..",
                "The sums that are allowed",
                ParameterKind::Counts { usual: &[0, 1, 3] },
            ),
        ],
        |given| known_spaces::sum_complex(given.count("modulus"), &given.counts("sums")),
    ),
    Family::space(
        "barnette",
        "The sphere of Barnette, of dimension 3 with 8 vertices, which no convex polytope bounds",
        &[],
        |_| known_spaces::barnette_sphere(),
    ),
    Family::space("bruckner", "The sphere of Bruckner, of dimension 3 with 8 vertices", &[], |_| {
        known_spaces::bruckner_sphere()
    }),
    Family::space("rudin-ball", "The ball of Rudin, which cannot be shelled", &[], |_| {
        known_spaces::rudin_ball()
    }),
    Family::space("ziegler-ball", "The ball of Ziegler, which cannot be shelled", &[], |_| {
        known_spaces::ziegler_ball()
    }),
];
