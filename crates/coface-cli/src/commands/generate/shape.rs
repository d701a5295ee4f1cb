//! Shapes with positions, by name and parameters.

use clap::{Args, Subcommand, ValueEnum};
use coface::Error;
use coface::complexes::shapes;
use coface::complexes::shapes::{CellKind, PlacedCells};
use coface::complexes::shapes::{DiskGrid, SphereGrid};

/// A shape by its name; the numbers of cells are those along an axis.
#[derive(Subcommand)]
pub(super) enum Shape {
    /// A simplex: the origin and the unit vectors
    Simplex {
        /// The dimension
        #[arg(long, short, value_name = "D", default_value_t = 3, value_parser = clap::value_parser!(u32).range(..=20))]
        dimension: u32,
    },
    /// A circle in the plane
    Circle {
        /// The radius
        #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
        radius: f64,
        /// The number of segments, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        segments: u32,
    },
    /// A helix about the third axis
    Helix {
        /// The radius
        #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
        radius: f64,
        #[command(flatten)]
        winding: Winding,
        /// The number of segments in all
        #[arg(long, value_name = "N", default_value_t = 96)]
        segments: u32,
    },
    /// A disk in the plane
    Disk {
        /// The radius
        #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
        radius: f64,
        /// Rings of sectors around the center, or the image of a square grid
        #[arg(long, value_name = "KIND", default_value = "polar")]
        kind: DiskKind,
        /// Polar: the number of rings
        #[arg(long, value_name = "N", default_value_t = 8)]
        rings: u32,
        /// Polar: the number of sectors, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        sectors: u32,
        /// Square: the number of squares along a side
        #[arg(long, value_name = "N", default_value_t = 16)]
        subdivisions: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// A ring in the plane between two circles
    Ring {
        #[command(flatten)]
        radii: Radii,
        /// The number of rings
        #[arg(long, value_name = "N", default_value_t = 4)]
        rings: u32,
        /// The number of sectors, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        sectors: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// A spiral ramp about the third axis
    Helicoid {
        #[command(flatten)]
        radii: Radii,
        #[command(flatten)]
        winding: Winding,
        /// The number of steps outward
        #[arg(long, value_name = "N", default_value_t = 4)]
        rings: u32,
        /// The number of steps along, in all
        #[arg(long, value_name = "N", default_value_t = 96)]
        segments: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// The side of a cylinder about the third axis
    Cylinder {
        #[command(flatten)]
        size: RadiusAndHeight,
        /// The number of sectors, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        sectors: u32,
        /// The number of layers
        #[arg(long, value_name = "N", default_value_t = 8)]
        layers: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// The side of a cone about the third axis, of triangles
    Cone {
        #[command(flatten)]
        size: RadiusAndHeight,
        /// The number of sectors, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        sectors: u32,
        /// The number of layers
        #[arg(long, value_name = "N", default_value_t = 8)]
        layers: u32,
    },
    /// A sphere about the origin
    Sphere {
        /// The radius
        #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
        radius: f64,
        #[command(flatten)]
        grid: SphereArguments,
        #[command(flatten)]
        cells: Cells,
    },
    /// A torus about the third axis
    Torus {
        #[command(flatten)]
        radii: TorusRadii,
        #[command(flatten)]
        grid: TorusGrid,
        #[command(flatten)]
        cells: Cells,
    },
    /// The outer half of a torus
    Crown {
        #[command(flatten)]
        radii: TorusRadii,
        #[command(flatten)]
        grid: TorusGrid,
        #[command(flatten)]
        cells: Cells,
    },
    /// A Moebius band about the third axis
    Moebius {
        /// The radius of the middle line
        #[arg(long, default_value_t = 2.0, allow_hyphen_values = true)]
        radius: f64,
        /// The width of the band
        #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
        width: f64,
        /// The number of columns around, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        columns: u32,
        /// The number of rows across
        #[arg(long, value_name = "N", default_value_t = 4)]
        rows: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// A Klein bottle: crossing itself in space, or embedded in dimension 4
    Klein {
        #[command(flatten)]
        radii: KleinRadii,
        #[command(flatten)]
        grid: TorusGrid,
        /// The dimension of the space around it: 3, where it crosses itself, or 4
        #[arg(long, value_name = "D", default_value_t = 3, value_parser = clap::value_parser!(u32).range(3..=4))]
        space: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// The torus with 7 vertices and flat triangles that do not cross
    Csaszar,
    /// A box from the origin
    #[command(name = "box")]
    Cuboid {
        /// The sizes along the axes
        #[arg(
            long,
            value_name = "X,Y,..",
            value_delimiter = ',',
            allow_hyphen_values = true,
            default_value = "1,1,1"
        )]
        sizes: Vec<f64>,
        /// The numbers of cells along the axes
        #[arg(long, value_name = "N,N,..", value_delimiter = ',', default_value = "1,1,1")]
        shape: Vec<u32>,
        #[command(flatten)]
        cells: Cells,
    },
    /// A solid ball about the origin
    Ball {
        /// The radius
        #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
        radius: f64,
        /// The number of cells along a diameter
        #[arg(long, value_name = "N", default_value_t = 8)]
        subdivisions: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// A solid cylinder about the third axis
    Rod {
        #[command(flatten)]
        size: RadiusAndHeight,
        /// The number of cells along a diameter
        #[arg(long, value_name = "N", default_value_t = 8)]
        subdivisions: u32,
        /// The number of layers
        #[arg(long, value_name = "N", default_value_t = 8)]
        layers: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// The solid in a torus
    SolidTorus {
        #[command(flatten)]
        radii: TorusRadii,
        /// The number of cells along a diameter of the tube
        #[arg(long, value_name = "N", default_value_t = 4)]
        subdivisions: u32,
        /// The number of sectors around, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        sectors: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// The solid between two cylinders
    HollowCylinder {
        #[command(flatten)]
        radii: Radii,
        /// The height
        #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
        height: f64,
        /// The number of shells between the radii
        #[arg(long, value_name = "N", default_value_t = 2)]
        shells: u32,
        /// The number of sectors, 3 or more
        #[arg(long, value_name = "N", default_value_t = 48)]
        sectors: u32,
        /// The number of layers
        #[arg(long, value_name = "N", default_value_t = 8)]
        layers: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// The solid between two spheres
    HollowBall {
        #[command(flatten)]
        radii: Radii,
        #[command(flatten)]
        grid: SphereArguments,
        /// The number of shells between the radii
        #[arg(long, value_name = "N", default_value_t = 2)]
        shells: u32,
        #[command(flatten)]
        cells: Cells,
    },
    /// A closed surface of any genus: the boundary of a plate with holes
    Genus {
        /// The genus
        #[arg(long, value_name = "G", default_value_t = 2)]
        genus: u32,
        /// The number of cells along an edge of a unit cube
        #[arg(long, value_name = "N", default_value_t = 1)]
        subdivisions: u32,
        /// The solid plate instead of its boundary
        #[arg(long)]
        solid: bool,
        #[command(flatten)]
        cells: Cells,
    },
}

/// Which cells to make.
#[derive(Args)]
pub(super) struct Cells {
    /// Quadrangles and hexahedra instead of triangles and tetrahedra
    #[arg(long, visible_aliases = ["quadrangles", "hexahedra"])]
    cuboids: bool,
}

impl Cells {
    fn kind(&self) -> CellKind {
        if self.cuboids { CellKind::Cuboid } else { CellKind::Simplex }
    }
}

#[derive(Args)]
pub(super) struct Radii {
    /// The inner radius
    #[arg(long, value_name = "R", default_value_t = 0.5, allow_hyphen_values = true)]
    inner_radius: f64,
    /// The outer radius
    #[arg(long, value_name = "R", default_value_t = 1.0, allow_hyphen_values = true)]
    outer_radius: f64,
}

#[derive(Args)]
pub(super) struct Winding {
    /// The rise of a turn
    #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
    pitch: f64,
    /// The number of turns; negative ones wind the other way
    #[arg(long, default_value_t = 2.0, allow_hyphen_values = true)]
    turns: f64,
}

#[derive(Args)]
pub(super) struct RadiusAndHeight {
    /// The radius
    #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
    radius: f64,
    /// The height
    #[arg(long, default_value_t = 1.0, allow_hyphen_values = true)]
    height: f64,
}

#[derive(Args)]
pub(super) struct TorusRadii {
    /// The radius of the circle that the tube follows
    #[arg(long, value_name = "R", default_value_t = 2.0, allow_hyphen_values = true)]
    major_radius: f64,
    /// The radius of the tube
    #[arg(long, value_name = "R", default_value_t = 1.0, allow_hyphen_values = true)]
    minor_radius: f64,
}

#[derive(Args)]
pub(super) struct KleinRadii {
    /// The radius of the circle that the bottle follows
    #[arg(long, value_name = "R", default_value_t = 3.0, allow_hyphen_values = true)]
    major_radius: f64,
    /// The size of the bottle around it
    #[arg(long, value_name = "R", default_value_t = 1.0, allow_hyphen_values = true)]
    minor_radius: f64,
}

#[derive(Args)]
pub(super) struct TorusGrid {
    /// The number of columns around, 3 or more
    #[arg(long, value_name = "N", default_value_t = 48)]
    columns: u32,
    /// The number of rows along the tube, 3 or more
    #[arg(long, value_name = "N", default_value_t = 24)]
    rows: u32,
}

#[derive(Args)]
pub(super) struct SphereArguments {
    /// A divided icosahedron, circles of latitude, or a divided cube
    #[arg(long, value_name = "KIND")]
    kind: Option<SphereKind>,
    /// Ico and cube: the number of parts of an edge
    #[arg(long, value_name = "N", default_value_t = 8)]
    subdivisions: u32,
    /// Latitude: the number of meridians, 3 or more
    #[arg(long, value_name = "N", default_value_t = 48)]
    meridians: u32,
    /// Latitude: the number of bands between the poles, 2 or more
    #[arg(long, value_name = "N", default_value_t = 24)]
    bands: u32,
}

#[derive(Clone, Copy, ValueEnum)]
enum SphereKind {
    Ico,
    Latitude,
    Cube,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum DiskKind {
    Polar,
    Square,
}

impl SphereArguments {
    /// Without a kind, the one that has the cells asked for.
    fn grid(&self, cells: CellKind) -> SphereGrid {
        let usual = if cells == CellKind::Cuboid { SphereKind::Cube } else { SphereKind::Ico };
        let subdivisions = self.subdivisions;
        match self.kind.unwrap_or(usual) {
            SphereKind::Ico => SphereGrid::Icosahedron { subdivisions },
            SphereKind::Latitude => SphereGrid::Latitude { meridians: self.meridians, bands: self.bands },
            SphereKind::Cube => SphereGrid::Cube { subdivisions },
        }
    }
}

impl Shape {
    pub(super) fn cells(&self) -> Result<PlacedCells, Error> {
        match self {
            Self::Simplex { dimension } => simplex(*dimension),
            Self::Circle { radius, segments } => shapes::circle(*radius, *segments),
            Self::Helix { radius, winding, segments } => {
                shapes::helix(*radius, winding.pitch, winding.turns, *segments)
            }
            Self::Disk { radius, kind, rings, sectors, subdivisions, cells } => {
                let grid = match kind {
                    DiskKind::Polar => DiskGrid::Polar { rings: *rings, sectors: *sectors },
                    DiskKind::Square => DiskGrid::Square { subdivisions: *subdivisions },
                };
                shapes::disk(*radius, grid, cells.kind())
            }
            Self::Ring { radii, rings, sectors, cells } => {
                shapes::ring(radii.inner_radius, radii.outer_radius, [*rings, *sectors], cells.kind())
            }
            Self::Helicoid { radii, winding, rings, segments, cells } => shapes::helicoid(
                radii.inner_radius,
                radii.outer_radius,
                [winding.pitch, winding.turns],
                [*rings, *segments],
                cells.kind(),
            ),
            Self::Cylinder { size, sectors, layers, cells } => {
                shapes::cylinder(size.radius, size.height, [*sectors, *layers], cells.kind())
            }
            Self::Cone { size, sectors, layers } => {
                shapes::cone(size.radius, size.height, [*sectors, *layers])
            }
            Self::Sphere { radius, grid, cells } => {
                shapes::sphere(*radius, grid.grid(cells.kind()), cells.kind())
            }
            Self::Torus { radii, grid, cells } => {
                shapes::torus(radii.major_radius, radii.minor_radius, [grid.columns, grid.rows], cells.kind())
            }
            Self::Crown { radii, grid, cells } => {
                shapes::crown(radii.major_radius, radii.minor_radius, [grid.columns, grid.rows], cells.kind())
            }
            Self::Moebius { radius, width, columns, rows, cells } => {
                shapes::moebius(*radius, *width, [*columns, *rows], cells.kind())
            }
            Self::Klein { radii, grid, space, cells } => {
                let bottle = if *space == 4 { shapes::klein_bottle_in_4d } else { shapes::klein_bottle };
                bottle(radii.major_radius, radii.minor_radius, [grid.columns, grid.rows], cells.kind())
            }
            Self::Csaszar => shapes::csaszar_torus(),
            Self::Cuboid { sizes, shape, cells } => shapes::cuboid(sizes, shape, cells.kind()),
            Self::Ball { radius, subdivisions, cells } => shapes::ball(*radius, *subdivisions, cells.kind()),
            Self::Rod { size, subdivisions, layers, cells } => {
                shapes::rod(size.radius, size.height, [*subdivisions, *layers], cells.kind())
            }
            Self::SolidTorus { radii, subdivisions, sectors, cells } => shapes::solid_torus(
                radii.major_radius,
                radii.minor_radius,
                [*subdivisions, *sectors],
                cells.kind(),
            ),
            Self::HollowCylinder { radii, height, shells, sectors, layers, cells } => {
                shapes::hollow_cylinder(
                    [radii.inner_radius, radii.outer_radius],
                    *height,
                    [*shells, *sectors, *layers],
                    cells.kind(),
                )
            }
            Self::HollowBall { radii, grid, shells, cells } => shapes::hollow_ball(
                [radii.inner_radius, radii.outer_radius],
                grid.grid(cells.kind()),
                *shells,
                cells.kind(),
            ),
            Self::Genus { genus, subdivisions, solid, cells } => {
                let plate = shapes::plate_with_holes(*genus, *subdivisions, cells.kind())?;
                if *solid { Ok(plate) } else { Ok(plate.boundary()?.compacted()) }
            }
        }
    }
}

/// The origin and the unit vectors; a point lies on a line.
fn simplex(dimension: u32) -> Result<PlacedCells, Error> {
    let space = dimension.max(1) as usize;
    let coordinate = |vertex: u32| (0..space).map(move |axis| f64::from(u8::from(axis as u32 + 1 == vertex)));
    let coordinates = (0..=dimension).flat_map(coordinate).collect();
    let cell: Vec<u32> = (0..=dimension).collect();
    PlacedCells::new(
        coface::geometry::Positions::from_flat(space, coordinates)?,
        CellKind::Simplex,
        dimension as usize,
        coface::algebra::RaggedArray::from_lists([cell]),
    )
}
