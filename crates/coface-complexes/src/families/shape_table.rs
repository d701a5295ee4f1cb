//! The table of the shapes with positions.

use super::{Family, Parameter, ParameterKind};
use crate::shapes::{self, DiskGrid};

const CELLS: Parameter =
    Parameter::flag("cuboids", "Quadrangles and hexahedra instead of triangles and tetrahedra");
const RADIUS: Parameter = Parameter::real("radius", "RADIUS", "The radius", 1.0);
const HEIGHT: Parameter = Parameter::real("height", "HEIGHT", "The height", 1.0);
const INNER: Parameter = Parameter::real("inner_radius", "R", "The inner radius", 0.5);
const OUTER: Parameter = Parameter::real("outer_radius", "R", "The outer radius", 1.0);
const MAJOR: Parameter =
    Parameter::real("major_radius", "R", "The radius of the circle that the tube follows", 2.0);
const MINOR: Parameter = Parameter::real("minor_radius", "R", "The radius of the tube", 1.0);
const PITCH: Parameter = Parameter::real("pitch", "PITCH", "The rise of a turn", 1.0);
const TURNS: Parameter =
    Parameter::real("turns", "TURNS", "The number of turns; negative ones wind the other way", 2.0);
const RINGS: Parameter = Parameter::count("rings", "N", "The number of rings", 4);
const SECTORS: Parameter = Parameter::count("sectors", "N", "The number of sectors, 3 or more", 48);
const LAYERS: Parameter = Parameter::count("layers", "N", "The number of layers", 8);
const SHELLS: Parameter = Parameter::count("shells", "N", "The number of shells between the radii", 2);
const COLUMNS: Parameter = Parameter::count("columns", "N", "The number of columns around, 3 or more", 48);
const TUBE_ROWS: Parameter =
    Parameter::count("rows", "N", "The number of rows along the tube, 3 or more", 24);
const ALONG_DIAMETER: Parameter =
    Parameter::count("subdivisions", "N", "The number of cells along a diameter", 8);
const SPHERE_KIND: Parameter = Parameter::new(
    "kind",
    "KIND",
    "A divided icosahedron, circles of latitude, or a divided cube",
    ParameterKind::Choice { words: &["ico", "latitude", "cube"], usual: None },
);
const SPHERE_PARTS: Parameter =
    Parameter::count("subdivisions", "N", "Ico and cube: the number of parts of an edge", 8);
const MERIDIANS: Parameter =
    Parameter::count("meridians", "N", "Latitude: the number of meridians, 3 or more", 48);
const BANDS: Parameter =
    Parameter::count("bands", "N", "Latitude: the number of bands between the poles, 2 or more", 24);

pub(super) static SHAPES: &[Family] = &[
    Family::shape(
        "simplex",
        "A simplex: the origin and the unit vectors",
        &[Parameter::count("dimension", "D", "The dimension", 3).within(0, 20)],
        |given| shapes::simplex(given.count("dimension")),
    ),
    Family::shape(
        "circle",
        "A circle in the plane",
        &[RADIUS, Parameter::count("segments", "N", "The number of segments, 3 or more", 48)],
        |given| shapes::circle(given.real("radius"), given.count("segments")),
    ),
    Family::shape(
        "helix",
        "A helix about the third axis",
        &[RADIUS, PITCH, TURNS, Parameter::count("segments", "N", "The number of segments in all", 96)],
        |given| {
            let [radius, pitch, turns] = ["radius", "pitch", "turns"].map(|name| given.real(name));
            shapes::helix(radius, pitch, turns, given.count("segments"))
        },
    ),
    Family::shape(
        "disk",
        "A disk in the plane",
        &[
            RADIUS,
            Parameter::new(
                "kind",
                "KIND",
                "Rings of sectors around the center, or the image of a square grid",
                ParameterKind::Choice { words: &["polar", "square"], usual: Some("polar") },
            ),
            Parameter::count("rings", "N", "Polar: the number of rings", 8),
            Parameter::count("sectors", "N", "Polar: the number of sectors, 3 or more", 48),
            Parameter::count("subdivisions", "N", "Square: the number of squares along a side", 16),
            CELLS,
        ],
        |given| {
            let grid = match given.choice("kind") {
                Some("square") => DiskGrid::Square { subdivisions: given.count("subdivisions") },
                _ => DiskGrid::Polar { rings: given.count("rings"), sectors: given.count("sectors") },
            };
            shapes::disk(given.real("radius"), grid, given.cells())
        },
    )
    .also(&["disc"]),
    Family::shape(
        "ring",
        "A ring in the plane between two circles",
        &[INNER, OUTER, RINGS, SECTORS, CELLS],
        |given| {
            let grid = [given.count("rings"), given.count("sectors")];
            shapes::ring(given.real("inner_radius"), given.real("outer_radius"), grid, given.cells())
        },
    )
    .also(&["annulus"]),
    Family::shape(
        "helicoid",
        "A spiral ramp about the third axis",
        &[
            INNER,
            OUTER,
            PITCH,
            TURNS,
            Parameter::count("rings", "N", "The number of steps outward", 4),
            Parameter::count("segments", "N", "The number of steps along, in all", 96),
            CELLS,
        ],
        |given| {
            let winding = [given.real("pitch"), given.real("turns")];
            let grid = [given.count("rings"), given.count("segments")];
            let [inner, outer] = [given.real("inner_radius"), given.real("outer_radius")];
            shapes::helicoid(inner, outer, winding, grid, given.cells())
        },
    ),
    Family::shape(
        "cylinder",
        "The side of a cylinder about the third axis",
        &[RADIUS, HEIGHT, SECTORS, LAYERS, CELLS],
        |given| {
            let grid = [given.count("sectors"), given.count("layers")];
            shapes::cylinder(given.real("radius"), given.real("height"), grid, given.cells())
        },
    ),
    Family::shape(
        "cone",
        "The side of a cone about the third axis, of triangles",
        &[RADIUS, HEIGHT, SECTORS, LAYERS],
        |given| {
            let grid = [given.count("sectors"), given.count("layers")];
            shapes::cone(given.real("radius"), given.real("height"), grid)
        },
    ),
    Family::shape(
        "sphere",
        "A sphere about the origin",
        &[RADIUS, SPHERE_KIND, SPHERE_PARTS, MERIDIANS, BANDS, CELLS],
        |given| shapes::sphere(given.real("radius"), given.sphere(), given.cells()),
    ),
    Family::shape(
        "torus",
        "A torus about the third axis",
        &[MAJOR, MINOR, COLUMNS, TUBE_ROWS, CELLS],
        |given| {
            let grid = [given.count("columns"), given.count("rows")];
            shapes::torus(given.real("major_radius"), given.real("minor_radius"), grid, given.cells())
        },
    ),
    Family::shape(
        "crown",
        "The outer half of a torus",
        &[MAJOR, MINOR, COLUMNS, TUBE_ROWS, CELLS],
        |given| {
            let grid = [given.count("columns"), given.count("rows")];
            shapes::crown(given.real("major_radius"), given.real("minor_radius"), grid, given.cells())
        },
    ),
    Family::shape(
        "moebius",
        "A Moebius band about the third axis",
        &[
            Parameter::real("radius", "RADIUS", "The radius of the middle line", 2.0),
            Parameter::real("width", "WIDTH", "The width of the band", 1.0),
            COLUMNS,
            Parameter::count("rows", "N", "The number of rows across", 4),
            CELLS,
        ],
        |given| {
            let grid = [given.count("columns"), given.count("rows")];
            shapes::moebius(given.real("radius"), given.real("width"), grid, given.cells())
        },
    )
    .also(&["moebius-band", "mobius"]),
    Family::shape(
        "klein",
        "A Klein bottle: crossing itself in space, or embedded in dimension 4",
        &[
            Parameter::real("major_radius", "R", "The radius of the circle that the bottle follows", 3.0),
            Parameter::real("minor_radius", "R", "The size of the bottle around it", 1.0),
            COLUMNS,
            TUBE_ROWS,
            Parameter::count(
                "space",
                "D",
                "The dimension of the space around it: 3, where it crosses itself, or 4",
                3,
            )
            .within(3, 4),
            CELLS,
        ],
        |given| {
            let is_embedded = given.count("space") == 4;
            let bottle = if is_embedded { shapes::klein_bottle_in_4d } else { shapes::klein_bottle };
            let grid = [given.count("columns"), given.count("rows")];
            bottle(given.real("major_radius"), given.real("minor_radius"), grid, given.cells())
        },
    )
    .also(&["klein-bottle"]),
    Family::shape("csaszar", "The torus with 7 vertices and flat triangles that do not cross", &[], |_| {
        shapes::csaszar_torus()
    }),
    Family::shape(
        "box",
        "A box from the origin",
        &[
            Parameter::new(
                "sizes",
                "X,Y,..",
                "The sizes along the axes",
                ParameterKind::Reals { usual: &[1.0, 1.0, 1.0] },
            ),
            Parameter::new(
                "shape",
                "N,N,..",
                "The numbers of cells along the axes",
                ParameterKind::Counts { usual: &[1, 1, 1] },
            ),
            CELLS,
        ],
        |given| {
            let sizes = given.reals("sizes");
            // One cell along each axis, however many axes there are.
            let shape = if given.has("shape") { given.counts("shape") } else { vec![1; sizes.len()] };
            shapes::cuboid(&sizes, &shape, given.cells())
        },
    )
    .also(&["cube", "cuboid"]),
    Family::shape("ball", "A solid ball about the origin", &[RADIUS, ALONG_DIAMETER, CELLS], |given| {
        shapes::ball(given.real("radius"), given.count("subdivisions"), given.cells())
    }),
    Family::shape(
        "rod",
        "A solid cylinder about the third axis",
        &[RADIUS, HEIGHT, ALONG_DIAMETER, LAYERS, CELLS],
        |given| {
            let grid = [given.count("subdivisions"), given.count("layers")];
            shapes::rod(given.real("radius"), given.real("height"), grid, given.cells())
        },
    )
    .also(&["solid-cylinder"]),
    Family::shape(
        "solid-torus",
        "The solid in a torus",
        &[
            MAJOR,
            MINOR,
            Parameter::count("subdivisions", "N", "The number of cells along a diameter of the tube", 4),
            Parameter::count("sectors", "N", "The number of sectors around, 3 or more", 48),
            CELLS,
        ],
        |given| {
            let grid = [given.count("subdivisions"), given.count("sectors")];
            shapes::solid_torus(given.real("major_radius"), given.real("minor_radius"), grid, given.cells())
        },
    ),
    Family::shape(
        "hollow-cylinder",
        "The solid between two cylinders",
        &[INNER, OUTER, HEIGHT, SHELLS, SECTORS, LAYERS, CELLS],
        |given| {
            let radii = [given.real("inner_radius"), given.real("outer_radius")];
            let grid = ["shells", "sectors", "layers"].map(|name| given.count(name));
            shapes::hollow_cylinder(radii, given.real("height"), grid, given.cells())
        },
    ),
    Family::shape(
        "hollow-ball",
        "The solid between two spheres",
        &[INNER, OUTER, SPHERE_KIND, SPHERE_PARTS, MERIDIANS, BANDS, SHELLS, CELLS],
        |given| {
            let radii = [given.real("inner_radius"), given.real("outer_radius")];
            shapes::hollow_ball(radii, given.sphere(), given.count("shells"), given.cells())
        },
    ),
    Family::shape(
        "genus",
        "A closed surface of any genus: the boundary of a plate with holes",
        &[
            Parameter::count("genus", "G", "The genus", 2),
            Parameter::count("subdivisions", "N", "The number of cells along an edge of a unit cube", 1),
            Parameter::flag("solid", "The solid plate instead of its boundary"),
            CELLS,
        ],
        |given| {
            let plate =
                shapes::plate_with_holes(given.count("genus"), given.count("subdivisions"), given.cells())?;
            if given.flag("solid") { Ok(plate) } else { Ok(plate.boundary()?.compacted()) }
        },
    ),
];
