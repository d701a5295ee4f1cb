//! Messages about maps: lines and rings, reference systems.

use super::{Case, Files};

const RING: Files = &[("ring.wkt", "LINESTRING (0 0, 2 0, 2 2, 0 0)")];
const BESIDE: Files = &[("beside.wkt", "POLYGON ((5 5, 6 5, 6 6, 5 5))\nLINESTRING (0 0, 2 0, 2 2, 0 0)")];
const TWO_BESIDE: Files = &[(
    "beside.wkt",
    "POLYGON ((5 5, 6 5, 6 6, 5 5))\nLINESTRING (0 0, 2 0, 2 2, 0 0)\nLINESTRING (0 0, 1 0, 1 3, 0 0)",
)];
const ZONE: Files = &[(
    "zone.geojson",
    r#"{"type":"Feature","properties":{"zone":"A"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}}"#,
)];

pub(super) const CASES: &[Case] = &[
    Case::new("planar/drawing.rs", "take closed lines as rings with --close, or give polygons")
        .files(RING)
        .refused("coface boolean union ring.wkt")
        .cured(&[&["coface boolean union ring.wkt --close"]]),
    Case::new("planar/drawing.rs", "1 line is closed: --close takes closed lines as rings")
        .files(BESIDE)
        .answered("coface boolean union beside.wkt")
        .cured(&[&["coface boolean union beside.wkt --close"]]),
    Case::new("planar/drawing.rs", "{closed} lines are closed: --close takes closed lines as rings")
        .files(TWO_BESIDE)
        .answered("coface boolean union beside.wkt")
        .cured(&[&["coface boolean union beside.wkt --close"]]),
    Case::new("arrange/mod.rs", "--close is for drawings in the plane, and the inputs lie in space")
        .before(&["coface generate box -o box.mesh"])
        .refused("coface boolean union box.mesh --close")
        .cured(&[&["coface boolean union box.mesh"]]),
    Case::new("boolean/mod.rs", "--dissolve is for maps in the plane, and the inputs lie in space")
        .before(&["coface generate box -o box.mesh"])
        .refused("coface boolean union box.mesh --dissolve zone")
        .cured(&[&["coface boolean union box.mesh"]]),
    Case::new("arrange/mod.rs", "--attributes is for maps in the plane, and the inputs lie in space")
        .before(&["coface generate box -o box.mesh"])
        .refused("coface arrange box.mesh --attributes faces.geojson")
        .cured(&[&["coface arrange box.mesh"]]),
    Case::new("boolean/dissolve.rs", "--dissolve unites features: the operation is union")
        .files(ZONE)
        .misused("coface boolean xor zone.geojson --dissolve zone")
        .cured(&[&["coface boolean union zone.geojson --dissolve zone"]]),
];
