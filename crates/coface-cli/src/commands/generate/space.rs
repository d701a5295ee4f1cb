//! Known spaces without positions, by name and parameters.

use super::construction::Numbers;
use clap::{Subcommand, ValueEnum};
use coface::Error;
use coface::complexes::known_spaces;
use coface::complexes::known_spaces::{FlatManifold, Solid};
use coface::complexes::simplicial::SimplicialComplex;

/// A known space, as a list of facets.
#[derive(Subcommand)]
pub(super) enum Space {
    /// The boundary of a simplex: the least sphere
    SimplexBoundary {
        /// The dimension of the sphere
        #[arg(long, short, value_name = "D", default_value_t = 2, value_parser = clap::value_parser!(u32).range(..=20))]
        dimension: u32,
    },
    /// The boundary of a cross polytope, a sphere; dimension 2 is the octahedron
    CrossPolytope {
        /// The dimension of the sphere
        #[arg(long, short, value_name = "D", default_value_t = 2)]
        dimension: usize,
    },
    /// The torus with 2^(d+1) - 1 vertices
    CyclicTorus {
        /// The dimension, 1 to 8
        #[arg(long, short, value_name = "D", default_value_t = 2)]
        dimension: usize,
    },
    /// A torus as a periodic grid of cubes cut into simplices
    TorusGrid {
        /// The numbers of cubes along the axes, each 3 or more
        #[arg(long, value_name = "N,N,..", value_delimiter = ',', default_value = "3,3")]
        shape: Vec<u32>,
    },
    /// A Klein bottle as a grid of squares cut into triangles
    KleinGrid {
        /// The number of columns, 4 or more
        #[arg(long, value_name = "N", default_value_t = 5)]
        columns: u32,
        /// The number of rows, 3 or more
        #[arg(long, value_name = "N", default_value_t = 5)]
        rows: u32,
    },
    /// The Klein bottle with 8 vertices
    SmallKlein,
    /// A torus grid with two vertices made one: no surface
    PinchedTorus {
        /// The number of columns, 6 or more
        #[arg(long, value_name = "N", default_value_t = 6)]
        columns: u32,
        /// The number of rows, 6 or more
        #[arg(long, value_name = "N", default_value_t = 6)]
        rows: u32,
    },
    /// A closed strip of triangles: a Moebius band for odd numbers, an annulus for even ones
    Strip {
        /// The number of vertices, 5 or more
        #[arg(long, value_name = "N", default_value_t = 5)]
        vertices: u32,
    },
    /// The projective plane with 6 vertices
    Rp2,
    /// Real projective space
    Rp {
        /// The dimension
        #[arg(long, short, value_name = "D", default_value_t = 3)]
        dimension: usize,
    },
    /// The complex projective plane with 9 vertices
    Cp2,
    /// A manifold of dimension 8 with 15 vertices, like the quaternionic projective plane
    Hp2,
    /// The K3 surface with 16 vertices
    K3,
    /// The lens space L(p, q)
    Lens {
        /// The order of the fundamental group
        #[arg(long, value_name = "P", default_value_t = 5)]
        p: u32,
        /// The twist, coprime to p
        #[arg(long, value_name = "Q", default_value_t = 2)]
        q: u32,
    },
    /// The homology sphere of Poincare
    Poincare,
    /// The hyperbolic space of Weber and Seifert
    WeberSeifert,
    /// A solid with opposite faces glued with a twist
    GluedSolid {
        /// The solid
        #[arg(long, default_value = "cube")]
        solid: SolidName,
        /// The twist in corners
        #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(..=4))]
        steps: u32,
    },
    /// The prism manifold of order 4 n
    PrismManifold {
        /// A quarter of the order of the fundamental group
        #[arg(long, value_name = "N", default_value_t = 2)]
        n: u32,
    },
    /// The truncated cube with opposite faces glued: fundamental group of order 48
    TruncatedCube,
    /// One of the ten closed flat manifolds of dimension 3
    Flat {
        /// Its name after Wolf
        #[arg(long, default_value = "g6")]
        manifold: FlatName,
    },
    /// The torus bundle over the circle with this monodromy
    TorusBundle {
        /// The matrix, row after row, of determinant 1 or -1
        #[arg(long, value_name = "A,B,C,D", allow_hyphen_values = true, default_value = "2,1,1,1")]
        matrix: Numbers<i64>,
    },
    /// The sphere bundle over the circle with few vertices
    SphereBundle {
        /// The dimension, 2 or more
        #[arg(long, short, value_name = "D", default_value_t = 3, value_parser = clap::value_parser!(u32).range(..=20))]
        dimension: u32,
        /// The number of vertices, 2 d + 3 or more
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(..=100_000))]
        vertices: Option<u32>,
    },
    /// A disk attached along a circle run n times: torsion of order n
    Moore {
        /// The order, 2 or more
        #[arg(long, value_name = "N", default_value_t = 3)]
        order: u32,
    },
    /// The presentation complex of a group
    Presentation {
        /// The number of generators
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(..=10_000))]
        generators: u32,
        /// A relator as letters 1, -1, 2, ..: 1,2,-1,-2; may be repeated
        #[arg(long = "relator", value_name = "WORD", allow_hyphen_values = true)]
        relators: Vec<Numbers<i32>>,
    },
    /// The dunce hat: contractible, but nowhere collapsible
    DunceHat,
    /// The house with two rooms of Bing
    House,
    /// Triangles around one edge
    Book {
        /// The number of triangles
        #[arg(long, value_name = "N", default_value_t = 3)]
        pages: u32,
    },
    /// The chessboard complex: rooks that do not take each other
    Chessboard {
        /// The number of rows, 1 to 8
        #[arg(long, value_name = "N", default_value_t = 3)]
        rows: u32,
        /// The number of columns, 1 to 8
        #[arg(long, value_name = "N", default_value_t = 4)]
        columns: u32,
    },
    /// The matching complex of a complete graph
    Matching {
        /// The number of vertices of the graph, 2 to 12
        #[arg(long, value_name = "N", default_value_t = 7)]
        count: u32,
    },
    /// A sum complex modulo n
    SumComplex {
        /// The modulus
        #[arg(long, value_name = "N", default_value_t = 7)]
        modulus: u32,
        /// The sums that are allowed
        #[arg(long, value_name = "N,N,..", value_delimiter = ',', default_value = "0,1,3")]
        sums: Vec<u32>,
    },
    /// The sphere of Barnette, of dimension 3 with 8 vertices, which no convex polytope bounds
    Barnette,
    /// The sphere of Bruckner, of dimension 3 with 8 vertices
    Bruckner,
    /// The ball of Rudin, which cannot be shelled
    RudinBall,
    /// The ball of Ziegler, which cannot be shelled
    ZieglerBall,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum SolidName {
    Cube,
    Octahedron,
    Dodecahedron,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum FlatName {
    G1,
    G2,
    G3,
    G4,
    G5,
    G6,
    B1,
    B2,
    B3,
    B4,
}

impl Space {
    pub(super) fn complex(&self) -> Result<SimplicialComplex, Error> {
        match self {
            Self::SimplexBoundary { dimension } => known_spaces::simplex_boundary(*dimension as usize),
            Self::CrossPolytope { dimension } => known_spaces::cross_polytope_boundary(*dimension),
            Self::CyclicTorus { dimension } => known_spaces::cyclic_torus(*dimension),
            Self::TorusGrid { shape } => known_spaces::torus_grid(shape),
            Self::KleinGrid { columns, rows } => known_spaces::klein_grid(*columns, *rows),
            Self::SmallKlein => known_spaces::small_klein_bottle(),
            Self::PinchedTorus { columns, rows } => known_spaces::pinched_torus_grid(*columns, *rows),
            Self::Strip { vertices } => known_spaces::triangle_strip(*vertices),
            Self::Rp2 => known_spaces::projective_plane(),
            Self::Rp { dimension } => known_spaces::real_projective_space(*dimension),
            Self::Cp2 => known_spaces::complex_projective_plane(),
            Self::Hp2 => known_spaces::quaternionic_projective_plane(),
            Self::K3 => known_spaces::k3_surface(),
            Self::Lens { p, q } => known_spaces::lens_space(*p, *q),
            Self::Poincare => known_spaces::glued_solid(Solid::Dodecahedron, 2),
            Self::WeberSeifert => known_spaces::glued_solid(Solid::Dodecahedron, 1),
            Self::GluedSolid { solid, steps } => known_spaces::glued_solid(solid.solid(), *steps as usize),
            Self::PrismManifold { n } => known_spaces::prism_manifold(*n),
            Self::TruncatedCube => known_spaces::truncated_cube_space(),
            Self::Flat { manifold } => known_spaces::flat_manifold(FlatManifold::ALL[*manifold as usize]),
            Self::TorusBundle { matrix } => {
                let &[a, b, c, d] = matrix.as_slice() else {
                    let count = matrix.as_slice().len();
                    return Err(Error::invalid(format!(
                        "a matrix of {count} entries is no monodromy of a torus"
                    ))
                    .with_cure("give four integers, row after row"));
                };
                known_spaces::torus_bundle([[a, b], [c, d]])
            }
            Self::SphereBundle { dimension, vertices } => {
                let least = dimension.saturating_mul(2).saturating_add(3);
                known_spaces::sphere_bundle_over_circle(*dimension, vertices.unwrap_or(least))
            }
            Self::Moore { order } => known_spaces::moore_space(*order),
            Self::Presentation { generators, relators } => {
                let words: Vec<Vec<i32>> = relators.iter().map(|word| word.as_slice().to_vec()).collect();
                known_spaces::presentation_complex(*generators, &words)
            }
            Self::DunceHat => known_spaces::dunce_hat(),
            Self::House => known_spaces::house_with_two_rooms(),
            Self::Book { pages } => known_spaces::book(*pages),
            Self::Chessboard { rows, columns } => known_spaces::chessboard(*rows, *columns),
            Self::Matching { count } => known_spaces::matching_complex(*count),
            Self::SumComplex { modulus, sums } => known_spaces::sum_complex(*modulus, sums),
            Self::Barnette => known_spaces::barnette_sphere(),
            Self::Bruckner => known_spaces::bruckner_sphere(),
            Self::RudinBall => known_spaces::rudin_ball(),
            Self::ZieglerBall => known_spaces::ziegler_ball(),
        }
    }
}

impl SolidName {
    fn solid(self) -> Solid {
        match self {
            Self::Cube => Solid::Cube,
            Self::Octahedron => Solid::Octahedron,
            Self::Dodecahedron => Solid::Dodecahedron,
        }
    }
}
