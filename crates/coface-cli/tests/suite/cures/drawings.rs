//! Messages of arrangements and Boolean combinations.

use super::surfaces::PINCHED;
use super::{Case, Files};

const BOW: Files = &[("bow.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))")];
/// Three lines that nearly meet in (1, 1).
const NEAR: Files = &[("near.lines", "0,0,2,2\n0,2,2,0\n0,1,4,1.0000000000000002\n")];
/// The same as sides of triangles.
const THIN: Files = &[(
    "near.wkt",
    "POLYGON ((-1120500.000000126 850931.058865365, -1120500.0000001257 851343.3885007716, \
     -1120500.0000001257 851342.2386007707, -1120399.762684411 851199.4941312922, -1120500.000000126 850931.058865365))\n\
     POLYGON ((-1120500.000000126 851253.4627870625, -1120500.0000001257 851299.8179383819, \
     -1120492.1498410008 851293.8417889411, -1120500.000000126 851253.4627870625))\n",
)];
const CURVED: Files =
    &[("disk.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle cx=\"5\" cy=\"5\" r=\"3\"/></svg>")];
const WARPED: Files = &[("warped.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n4 0 1 2 3\n")];
/// Two tetrahedra with a common face.
const TWO_OBJECTS: Files = &[(
    "two.obj",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nv 0 0 -6\no up\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n\
     o down\nf 1 2 3\nf 2 1 5\nf 3 2 5\nf 1 3 5\n",
)];
/// A cube without its top.
const OPEN: Files = &[(
    "open.off",
    "OFF\n8 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
     4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
)];
/// A tetrahedron, listed twice.
const OVERLAPPING: Files = &[(
    "twice.off",
    "OFF\n4 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
)];
/// A cube whose lid is 2.2e-16 above it.
const CRACK: Files = &[(
    "crack.off",
    "OFF\n12 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
     0 0 1.0000000000000002\n1 0 1.0000000000000002\n1 1 1.0000000000000002\n0 1 1.0000000000000002\n\
     4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n4 8 9 10 11\n",
)];
/// A cube whose lid, a pentagon with a vertex on an edge, is 2.2e-16 above it.
const CORNERLESS_CRACK: Files = &[(
    "crack.off",
    "OFF\n13 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
     0 0 1.0000000000000002\n1 0 1.0000000000000002\n1 1 1.0000000000000002\n0 1 1.0000000000000002\n\
     0.5 0 1.0000000000000002\n\
     4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n5 8 12 9 10 11\n",
)];
/// An octahedron of triangles with vertices of their own, some of which are 1e-9 farther out.
const LOOSE: Files = &[(
    "loose.off",
    "OFF\n24 8 0\n\
     1 0 0\n0 1.000000001 0\n0 0 1\n0 1.000000001 0\n-1 0 0\n0 0 1.000000001\n-1 0 0\n0 -1.000000001 0\n\
     0 0 1\n0 -1.000000001 0\n1 0 0\n0 0 1.000000001\n0 1 0\n1.000000001 0 0\n0 0 -1\n-1.000000001 0 0\n\
     0 1 0\n0 0 -1.000000001\n0 -1 0\n-1.000000001 0 0\n0 0 -1\n1.000000001 0 0\n0 -1 0\n0 0 -1.000000001\n\
     3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n3 12 13 14\n3 15 16 17\n3 18 19 20\n3 21 22 23\n",
)];
/// A cube one face of which is turned inside out, each face with corners of its own.
const TURNED_APART: Files = &[(
    "apart.off",
    "OFF\n24 6 0\n\
     0 0 0\n0 1 0\n1 1 0\n1 0 0\n0 0 0\n1 0 0\n1 0 1\n0 0 1\n1 0 0\n1 1 0\n1 1 1\n1 0 1\n1 1 0\n0 1 0\n\
     0 1 1\n1 1 1\n0 1 0\n0 0 0\n0 0 1\n0 1 1\n0 1 1\n1 1 1\n1 0 1\n0 0 1\n4 0 1 2 3\n4 4 5 6 7\n\
     4 8 9 10 11\n4 12 13 14 15\n4 16 17 18 19\n4 20 21 22 23\n",
)];
/// An open cube with cracks along its edges.
const CRACK_AND_HOLE: Files = &[(
    "cracked.off",
    "OFF\n20 5 0\n\
     0.000000001 0 0\n0.000000001 1 0\n1.000000001 1 0\n1.000000001 0 0\n0.000000002 0 0\n\
     1.000000002 0 0\n1.000000002 0 1\n0.000000002 0 1\n1.000000003 0 0\n1.000000003 1 0\n\
     1.000000003 1 1\n1.000000003 0 1\n1.000000004 1 0\n0.000000004 1 0\n0.000000004 1 1\n\
     1.000000004 1 1\n0.000000005 1 0\n0.000000005 0 0\n0.000000005 0 1\n0.000000005 1 1\n4 0 1 2 3\n\
     4 4 5 6 7\n4 8 9 10 11\n4 12 13 14 15\n4 16 17 18 19\n",
)];
/// A cube one face of which is turned inside out.
const TURNED: Files = &[(
    "turned.off",
    "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
     4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n\
     4 7 6 5 4\n",
)];
/// A tetrahedron of height 1e-12.
const SLIVER: Files = &[(
    "sliver.off",
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0.25 0.25 1e-12\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
)];
const CROSSINGS: &str = "planar/crossings.rs";

pub(super) const CASES: &[Case] = &[
    Case::new("planar/arrangement.rs", "drawn with them this is another complex; without --exact it is made")
        .files(NEAR)
        .answered("coface arrange near.lines --exact --json")
        .cured(&[&["coface arrange near.lines --json"]]),
    Case::new("planar/boolean.rs", "the polygons are not valid; without --exact they are")
        .files(THIN)
        .answered("coface boolean union near.wkt --inputs features --exact --json")
        .cured(&[&["coface boolean union near.wkt --inputs features --json"]]),
    Case::new(CROSSINGS, "unless --rule says otherwise")
        .files(BOW)
        .answered("coface boolean union bow.wkt")
        .cured(&[
            &["coface boolean union bow.wkt --rule evenodd"],
            &["coface arrange bow.wkt --rule positive"],
        ]),
    Case::new(CROSSINGS, "say what is inside of it: --rule evenodd or --rule nonzero")
        .files(BOW)
        .refused("coface boolean union bow.wkt --strict")
        .cured(&[
            &["coface boolean union bow.wkt --strict --rule evenodd"],
            &["coface boolean union bow.wkt --strict --rule nonzero"],
        ]),
    Case::new("planar/drawing.rs", "arrange them in space: leave --dimension 2 out")
        .before(&["coface generate box -o box.mesh"])
        .refused("coface arrange box.mesh --dimension 2")
        .cured(&[&["coface arrange box.mesh"]]),
    Case::new("planar/certificate.rs", "leave --certificate out, or give WKT or GeoJSON of two coordinates")
        .with(&[("point.wkt", "POINT (1 2)"), ("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 0))")])
        .refused("coface arrange point.wkt --certificate point.cert")
        .cured(&[
            &["coface arrange point.wkt"],
            &["coface arrange square.wkt --certificate square.cert", "coface check square.cert square.wkt"],
        ]),
    Case::new("planar/certificate.rs", "keep exact coordinates with --exact")
        .files(NEAR)
        .refused("coface arrange near.lines --certificate near.cert")
        .cured(&[&[
            "coface arrange near.lines --exact --certificate near.cert",
            "coface check near.cert near.lines",
        ]]),
    Case::new(
        "arrange/mod.rs",
        "--certificate proves what files contain, not their parts: leave --inputs out",
    )
    .with(&[("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 0))")])
    .refused("coface boolean union square.wkt --inputs features --certificate square.cert")
    .cured(&[&["coface boolean union square.wkt --certificate square.cert"]]),
    Case::new("arrange/spatial.rs", "--method congruence puts vertices together: leave one of them out")
        .before(&["coface generate box --boundary -o box.off"])
        .refused("coface boolean union box.off --method congruence --certificate box.cert")
        .cured(&[
            &["coface boolean union box.off --method congruence"],
            &["coface boolean union box.off --certificate box.cert", "coface check box.cert box.off"],
        ]),
    Case::new("spatial/certificate.rs", "keep exact coordinates with --exact")
        .with(&[(
            "near.obj",
            "v 0 0 0\nv 2 2 0\nv 2 2 1\nv 0 0 1\nv 0 2 0\nv 2 0 0\nv 2 0 1\nv 0 2 1\nv 0 1 0\nv 4 1.0000000000000002 0\n\
             v 4 1.0000000000000002 1\nv 0 1 1\nf 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\n",
        )])
        .refused("coface arrange near.obj --certificate near.cert")
        .cured(&[&["coface arrange near.obj --exact --certificate near.cert", "coface check near.cert near.obj"]]),
    Case::new(
        "spatial/certificate.rs",
        "no certificate: {why}; leave --certificate out, or give closed surfaces as plain OFF or OBJ",
    )
    .before(&["coface generate box -o box.mesh", "coface generate box --boundary -o box.off"])
    .refused("coface boolean union box.mesh --certificate box.cert")
    .cured(&[
        &["coface boolean union box.mesh"],
        &["coface boolean union box.off --certificate box.cert", "coface check box.cert box.off"],
    ]),
    Case::new("arrange/mod.rs", "--grid is for drawings in the plane, and the inputs lie in space")
        .before(&["coface generate box -o box.mesh"])
        .refused("coface boolean union box.mesh --grid 0.5")
        .cured(&[&["coface boolean union box.mesh"]]),
    Case::new("spatial/inputs.rs", "coface convert --orient), or count by parity (--rule evenodd)")
        .files(TURNED)
        .refused("coface boolean union turned.off")
        .cured(&[
            &["coface convert turned.off --orient -o solid.off", "coface boolean union solid.off"],
            &["coface boolean union turned.off --rule evenodd"],
        ]),
    Case::new("spatial/inputs.rs", "coface convert INPUT --repair -o OUT with that --weld")
        .files(TURNED_APART)
        .refused("coface boolean union apart.off")
        .cured(&[
            &["coface boolean union apart.off --weld 1e-14 --rule evenodd"],
            &[
                "coface convert apart.off --weld 1e-14 --repair -o solid.off",
                "coface boolean union solid.off",
            ],
        ]),
    Case::new("spatial/inputs.rs", "have mouths closed with patches (--weld {radius:.0e} --open close)")
        .files(CRACK_AND_HOLE)
        .refused("coface boolean union cracked.off")
        .cured(&[&["coface boolean union cracked.off --weld 1e-9 --open close"]]),
    Case::new("spatial/facts.rs", "--rule positive counts what winds backward as outside")
        .files(OVERLAPPING)
        .answered("coface boolean union twice.off")
        .cured(&[&["coface boolean union twice.off --rule positive"]]),
    Case::new("spatial/inputs.rs", "have its mouths closed with patches (--open close)")
        .files(OPEN)
        .refused("coface boolean union open.off")
        .cured(&[&["coface boolean union open.off --open close"]]),
    Case::new("spatial/inputs.rs", "put together what nearly coincides (--tolerance {tolerance:.0e})")
        .files(CORNERLESS_CRACK)
        .refused("coface boolean union crack.off")
        .cured(&[&["coface boolean union crack.off --tolerance 2e-15"]]),
    Case::new("spatial/inputs.rs", "merge vertices that nearly coincide (--weld {radius:.2e})")
        .files(CRACK)
        .refused("coface boolean union crack.off")
        .cured(&[&["coface boolean union crack.off --weld 2.23e-16"]]),
    Case::new("spatial/mouths.rs", "merge vertices that nearly coincide (--weld {radius:.2e})")
        .files(LOOSE)
        .refused("coface boolean union loose.off --open close")
        .cured(&[&["coface boolean union loose.off --weld 1.01e-9"]]),
    Case::new("planar/settling.rs", "give a smaller --tolerance")
        .with(&[("edge.lines", "0,0,1,0\n")])
        .refused("coface arrange edge.lines --method congruence --tolerance 2")
        .cured(&[&["coface arrange edge.lines --method congruence --tolerance 0.1"]]),
    Case::new("spatial/congruent.rs", "give a smaller --tolerance")
        .files(CRACK)
        .refused("coface arrange crack.off --method congruence --tolerance 10")
        .cured(&[&["coface arrange crack.off --method congruence --tolerance 1e-9"]]),
    Case::new("spatial/congruent.rs", "give a larger --tolerance that closes its gaps")
        .files(CRACK)
        .refused("coface boolean union crack.off --method congruence --tolerance 0")
        .cured(&[&["coface boolean union crack.off --method congruence --tolerance 1e-9"]]),
    Case::new("spatial/congruent.rs", "turn polygons so that all agree")
        .files(TURNED)
        .refused("coface boolean union turned.off --method congruence --tolerance 1e-9")
        .cured(&[
            &[
                "coface convert turned.off --orient -o whole.off",
                "coface boolean union whole.off --method congruence --tolerance 1e-9",
            ],
            &["coface boolean union turned.off --method congruence --tolerance 1e-9 --rule evenodd"],
        ]),
    Case::new("spatial/congruent.rs", "or --non-planar split, which cuts such polygons into triangles")
        .files(WARPED)
        .refused("coface arrange warped.off --method congruence --tolerance 1e-9 --non-planar refuse")
        .cured(&[
            &["coface arrange warped.off --method congruence --tolerance 0.3 --non-planar refuse"],
            &["coface arrange warped.off --method congruence --tolerance 1e-9 --non-planar split"],
        ]),
    Case::new("repair/weld.rs", "give a mesh or a drawing, without --weld for the others")
        .with(&[("three.json", "{\"facets\":[[0,1],[1,2],[0,2]]}")])
        .refused("coface convert three.json --weld 1 -o out.json")
        .cured(&[&["coface convert three.json -o out.json"]]),
    Case::new("repair/weld.rs", "give a shorter --weld")
        .before(&["coface generate box -o box.mesh"])
        .refused("coface convert box.mesh --weld 1 -o out.mesh")
        .cured(&[&["coface convert box.mesh --weld 0.1 -o out.mesh"]]),
    Case::new("spatial/inputs.rs", "or close its mouths with patches (--open close)")
        .files(CRACK)
        .refused("coface boolean union crack.off")
        .cured(&[&["coface boolean union crack.off --open close"]]),
    Case::new("answers/src/near.rs", "what rounding explains, since no --tolerance is given")
        .files(CRACK)
        .answered("coface arrange crack.off --method congruence --json")
        .cured(&[&["coface arrange crack.off --method congruence --tolerance 1e-9 --json"]]),
    Case::new("answers/src/near.rs", "--tolerance {needed:.0e} puts together what is so near")
        .files(SLIVER)
        .answered("coface arrange sliver.off --json")
        .cured(&[&["coface arrange sliver.off --tolerance 2e-12 --json"]]),
    Case::new("spatial/flat_polygons.rs", "let such polygons be split (--non-planar split)")
        .files(WARPED)
        .refused("coface arrange warped.off --non-planar refuse")
        .cured(&[&["coface arrange warped.off --non-planar split"]]),
    Case::new("spatial/flat_polygons.rs", "let such polygons be split (--non-planar split)")
        .files(WARPED)
        .refused("coface arrange warped.off --strict")
        .cured(&[&["coface arrange warped.off --strict --non-planar split"]]),
    Case::new("src/parts.rs", "; it has {count} {}: --inputs {}")
        .files(TWO_OBJECTS)
        .refused("coface arrange two.obj --inputs groups")
        .cured(&[&["coface arrange two.obj --inputs objects"]]),
    Case::new(
        "src/parts.rs",
        "--inputs files takes it as one input, --inputs components its connected parts",
    )
    .files(OPEN)
    .refused("coface arrange open.off --inputs objects")
    .cured(&[&["coface arrange open.off --inputs files"], &["coface arrange open.off --inputs components"]]),
    Case::new("spatial/scene.rs", "--inputs objects makes each an input")
        .files(TWO_OBJECTS)
        .answered("coface arrange two.obj --json")
        .cured(&[&["coface arrange two.obj --inputs objects --json"]])
        .shows("\"regions\":[\"up\",\"down\"]"),
    Case::new(
        "spatial/scene.rs",
        "each of its {count} objects is an input, as if --inputs objects were given",
    )
    .files(TWO_OBJECTS)
    .answered("coface boolean two.obj --formula 'a - b' --json")
    .cured(&[&["coface boolean two.obj --formula 'a - b' --inputs objects --json"]]),
    Case::new("arrange/planar.rs", "--graph is for cells in space")
        .files(BOW)
        .refused("coface arrange bow.wkt --graph g.json")
        .cured(&[&["coface arrange bow.wkt"]]),
    Case::new("arrange/spatial.rs", "--prune is for drawings in the plane")
        .files(OPEN)
        .refused("coface arrange open.off --prune")
        .cured(&[&["coface arrange open.off"]]),
    Case::new("arrange/spatial.rs", "of coordinates; --snap makes them exact")
        .files(&[(
            "crossing.off",
            "OFF\n6 2 0\n0 0 -1\n0.1 1 1.3\n0.7 -0.3 1\n-1 -1 0.1\n1 -1 0.2\n0 1.1 0.37\n3 0 1 2\n3 3 4 5\n",
        )])
        .answered("coface arrange crossing.off")
        .cured(&[&["coface arrange crossing.off --snap --json"]])
        .shows("\"exact\":true"),
    Case::new("boolean/spatial.rs", "which are written as copies; --pinches tell keeps them")
        .files(PINCHED)
        .answered("coface boolean union pinched.mesh -o out.off")
        .cured(&[&["coface boolean union pinched.mesh --pinches tell -o out.off"]]),
    Case::new("boolean/spatial.rs", "--pinches split makes copies")
        .files(PINCHED)
        .answered("coface boolean union pinched.mesh")
        .cured(&[&["coface boolean union pinched.mesh --pinches split"]]),
    Case::new("boolean/mod.rs", "or give --formula")
        .files(BOW)
        .misused("coface boolean bow.wkt")
        .cured(&[&["coface boolean union bow.wkt"], &["coface boolean --formula a bow.wkt"]]),
    Case::new("boolean/mod.rs", "--formula: {error}")
        .files(BOW)
        .refused("coface boolean --formula 'a |' bow.wkt")
        .cured(&[&["coface boolean --formula 'a | a' bow.wkt"]]),
    Case::new("io/src/drawing.rs", "--flatten LENGTH says another distance")
        .files(&[("disk.wkt", "CURVEPOLYGON (CIRCULARSTRING (1 0, -1 0, 1 0))\n")])
        .answered("coface arrange disk.wkt")
        .cured(&[&["coface arrange disk.wkt --flatten 0.01"]]),
    Case::new("yin/flattening.rs", "--flatten LENGTH says another length, and coface yin keeps curves")
        .files(CURVED)
        .answered("coface arrange disk.svg")
        .cured(&[&["coface arrange disk.svg --flatten 0.01"], &["coface yin info disk.svg"]]),
];
