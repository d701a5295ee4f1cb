//! Messages of convert, generate, cut, render, view and the like.

use super::{Case, Files};

const BOOK: Files = &[("book.json", "[[0,1,2],[0,1,3],[0,1,4]]")];
/// A simplex with half a million faces.
const LARGE: Files = &[("large.json", "[[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18]]")];
const TRIANGLE: Files = &[("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")];
/// The boundary of a tetrahedron.
const SPHERE: Files = &[("sphere.json", "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]")];

/// Points of the plane, or, with a weight, of a line.
const POINTS: Files = &[("points.csv", "0,0,1\n6,0,1\n6,8,1\n")];

pub(super) const CASES: &[Case] = &[
    Case::new("io/src/alpha.rs", "ask for their Vietoris-Rips filtration: coface persistence POINTS --rips")
        .files(&[("points.csv", "1,2,3,4\n5,6,7,9\n")])
        .refused("coface persistence points.csv --alpha")
        .cured(&[&["coface persistence points.csv --rips"]]),
    Case::new("io/src/alpha.rs", "leave out --radii, or --weighted")
        .files(POINTS)
        .refused("coface persistence points.csv --alpha --radii --weighted")
        .cured(&[
            &["coface persistence points.csv --alpha --weighted"],
            &["coface persistence points.csv --alpha --radii"],
        ]),
    Case::new("simplicial/lists.rs", "take a skeleton of it: coface skeleton INPUT --dimension K -o OUT.json")
        .files(&[(
            "large.json",
            "[[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30]]",
        )])
        .refused("coface homology large.json")
        .cured(&[&[
            "coface skeleton large.json --dimension 2 -o skeleton.json",
            "coface homology skeleton.json",
        ]]),
    Case::new("src/points.rs", "to end the alpha complex at the value A give --alpha A")
        .files(POINTS)
        .refused("coface homology points.csv --alpha --threshold 9")
        .cured(&[&["coface homology points.csv --alpha 9"]]),
    Case::new("src/points.rs", "to end the complex of {given} give --threshold T")
        .files(POINTS)
        .refused("coface info points.csv --rips --below 9")
        .cured(&[&["coface info points.csv --rips --threshold 9"]]),
    Case::new("commands/persistence.rs", "{option} is for volumes, and --alpha for points: leave one out")
        .files(POINTS)
        .refused("coface persistence points.csv --alpha --superlevel")
        .cured(&[&["coface persistence points.csv --alpha"]]),
    Case::new("src/points.rs", "write the complex first: coface convert INPUT {given} -o COMPLEX.json")
        .files(POINTS)
        .refused("coface shard points.csv --alpha --parts 1 -o parts")
        .cured(&[&[
            "coface convert points.csv --alpha -o complex.json",
            "coface shard complex.json --parts 1 -o parts",
        ]]),
    Case::new("src/points.rs", "give --rips, --cech, --landmarks or --flag")
        .files(&[("points.csv", "0,0,1\n6,0,1\n6,8,1\n"), ("graph.txt", "0 1 2\n")])
        .misused("coface persistence points.csv --dimension 1")
        .cured(&[
            &["coface persistence points.csv --rips --dimension 1"],
            &["coface persistence points.csv --cech --dimension 1"],
            &["coface persistence points.csv --landmarks 2 --dimension 1"],
            &["coface persistence graph.txt --flag --dimension 1"],
        ]),
    Case::new("io/src/rips.rs", "--dimension K takes those up to K")
        .files(&[("points.csv", "0,0\n3,0\n3,4\n0,4\n")])
        .answered("coface info points.csv --rips")
        .cured(&[&["coface info points.csv --rips --dimension 3"]]),
    Case::new("graph/rows.rs", "--directed takes the directed flag complex")
        .files(&[(
            "graph.graphml",
            "<graphml><graph edgedefault=\"directed\"><node id=\"a\"/><node id=\"b\"/><edge source=\"a\" target=\"b\"/></graph></graphml>",
        )])
        .answered("coface persistence graph.graphml --flag")
        .cured(&[&["coface persistence graph.graphml --flag --directed"]]),
    Case::new("io/src/table_form.rs", "or say what they are by --distances lower")
        .files(&[("a.csv", "1\n2 3\n")])
        .refused("coface persistence a.csv --rips")
        .cured(&[&["coface persistence a.csv --rips --distances lower"]]),
    Case::new(
        "io/src/table_form.rs",
        "or say how the table is laid out by --distances square or --distances sparse",
    )
    .files(&[("a.csv", "0 1 2\n1 2 1\n0 2 2\n")])
    .refused("coface persistence a.csv --rips --distances lower --threshold 5")
    .cured(&[&["coface persistence a.csv --rips --distances sparse"]]),
    Case::new("io/src/table_form.rs", "--distances points takes its rows as points")
        .files(&[("a.csv", "0 1 2\n1 0 1\n2 1 0\n")])
        .answered("coface persistence a.csv --rips")
        .cured(&[&["coface persistence a.csv --rips --distances points"]]),
    Case::new("commands/batch.rs", "ask coface pi1 about other models")
        .files(TRIANGLE)
        .refused("coface batch triangle.off -o rows.csv --with pi1")
        .cured(&[&["coface pi1 triangle.off"]]),
    Case::new("repair/triangulation.rs", "convert the model without --triangulate")
        .files(TRIANGLE)
        .refused("coface convert triangle.off --triangulate -o a.obj")
        .cured(&[&["coface convert triangle.off -o a.obj"]]),
    Case::new("producer/bounded.rs", "--pseudomanifold takes ideal vertices as points")
        .files(&[("knot.sig", "cPcbbbiht\n")])
        .answered("coface homology knot.sig")
        .cured(&[
            &["coface homology knot.sig --pseudomanifold"],
            &["coface convert --truncate knot.sig -o bounded.json", "coface homology bounded.json"],
        ]),
    Case::new("repair/triangulation.rs", "convert the model without --truncate")
        .files(TRIANGLE)
        .refused("coface convert triangle.off --truncate -o a.obj")
        .cured(&[&["coface convert triangle.off -o a.obj"]]),
    Case::new("repair/triangulation.rs", "convert the model without --truncate")
        .files(&[("lens.sig", "cMcabbgqw\n")])
        .refused("coface convert lens.sig --truncate -o a.json")
        .cured(&[&["coface convert lens.sig -o a.json"]]),
    Case::new("commands/convert.rs", "or say it with --to")
        .files(TRIANGLE)
        .refused("coface convert triangle.off -o a.model")
        .cured(&[&["coface convert triangle.off -o a.model --to obj"]]),
    Case::new("commands/convert.rs", "give -o OUT, or --to FORMAT for standard output")
        .files(TRIANGLE)
        .refused("coface convert triangle.off")
        .cured(&[&["coface convert triangle.off -o a.obj"], &["coface convert triangle.off --to obj"]]),
    Case::new("commands/convert.rs", "both the model and --json; give -o OUT")
        .files(TRIANGLE)
        .refused("coface convert triangle.off --to obj --json")
        .cured(&[&["coface convert triangle.off --to obj --json -o a.obj"]]),
    Case::new("commands/cut.rs", "is no vertex; write a path as \"0 1 2\"")
        .files(SPHERE)
        .refused("coface cut sphere.json --along '0-1-2'")
        .cured(&[&["coface cut sphere.json --along '0 1 2'"]]),
    Case::new("commands/cut.rs", "a path has two vertices at least; write it as \"0 1 2\"")
        .files(SPHERE)
        .refused("coface cut sphere.json --along 0")
        .cured(&[&["coface cut sphere.json --along '0 1 2'"]]),
    Case::new("commands/cut.rs", "{name}: --along \"{path}\": {error}")
        .files(SPHERE)
        .refused("coface cut sphere.json --along '0 1 5'")
        .cured(&[&["coface cut sphere.json --along '0 1 2'"]]),
    Case::new("generate/mod.rs", "every facet lies in two cells; leave --boundary out")
        .refused("coface generate torus --boundary --to off")
        .cured(&[&["coface generate torus --to off"]]),
    Case::new("generate/mod.rs", "or say it with --to")
        .refused("coface generate torus -o a.model")
        .cured(&[&["coface generate torus -o a.model --to off"]]),
    Case::new("generate/mod.rs", "both the model and --json; give -o OUT")
        .refused("coface generate torus --to off --json")
        .cured(&[&["coface generate torus --to off --json -o a.off"]]),
    Case::new("generate/mod.rs", "written with -o OUT or --to FORMAT")
        .answered("coface generate torus")
        .cured(&[&["coface generate torus -o a.off --json"], &["coface generate torus --to off"]]),
    Case::new("generate/scene.rs", "parameters that `coface generate {name} --help` lists")
        .files(&[("scene.json", "[{\"shape\":\"torus\",\"holes\":3}]")])
        .refused("coface generate assembly scene.json --to off")
        .cured(&[&["coface generate torus --help"]]),
    Case::new("cli/src/limits.rs", "takes longer than {}; allow more by --time-limit")
        .files(LARGE)
        .refused("coface homology large.json --time-limit 1ms")
        .cured(&[&["coface homology large.json --time-limit 10m"]]),
    Case::new("cli/src/limits.rs", "needs more than {} of memory (the last piece asked for: {asked})")
        .files(LARGE)
        .refused("coface info large.json --memory 8M")
        .cured(&[&["coface info large.json --memory 2G"]]),
    Case::new("homology/mod.rs", "ask for it with --relative boundary --sequence")
        .files(BOOK)
        .refused("coface homology book.json -o book.svg")
        .cured(&[&["coface homology book.json --relative boundary --sequence -o book.svg"]]),
    Case::new("render/mod.rs", "name the model before --matrix, or give a degree as in --matrix=2")
        .files(BOOK)
        .misused("coface render --matrix book.json")
        .cured(&[&["coface render book.json --matrix"], &["coface render book.json --matrix=2"]]),
    Case::new("render/mod.rs", "--blocks: name the degree of a matrix")
        .files(BOOK)
        .refused("coface render book.json --matrix --blocks matching")
        .cured(&[&["coface render book.json --matrix=1 --blocks matching"]]),
    Case::new("render/mod.rs", "--word \"{word}\"")
        .files(BOOK)
        .refused("coface render --word 'a b 3'")
        .cured(&[&["coface render --word 'a b a^-1 b^-1'"]])
        .shows("torus"),
    Case::new("homology/mod.rs", "--cycle \"{argument}\"")
        .files(BOOK)
        .refused("coface homology book.json --cycle '0 1'")
        .cured(&[&["coface homology book.json --cycle '0 1; 1 2; -1*0 2'"]]),
    Case::new("render/mod.rs", "--pane draws it instead")
        .before(&["coface generate torus -o a.off", "coface cut a.off -o cut.json"])
        .answered("coface render a.off --with cut.json -o a.svg")
        .cured(&[&["coface render a.off --with cut.json --pane -o a.svg"]]),
    Case::new("render/mod.rs", "coface cut -o and coface cover -o write some that have, as .json")
        .before(&["coface generate torus -o a.off", "coface homology a.off --generators g.json"])
        .refused("coface render a.off --with g.json --pane -o a.svg")
        .cured(&[
            &["coface cut a.off -o cut.json", "coface render a.off --with cut.json --pane -o a.svg"],
            &[
                "coface cover a.off --copies 2 -o cover.json",
                "coface render a.off --with cover.json --pane -o a.svg",
            ],
        ]),
    Case::new("render/mod.rs", "there is no such picture; there is")
        .before(&["coface generate torus -o a.off", "coface cut a.off -o cut.json"])
        .refused("coface render a.off --with cut.json --pane=nothing -o a.svg")
        .cured(&[&["coface render a.off --with cut.json --pane=domain -o a.svg"]]),
    Case::new("json/reading.rs", "give the model that it is about; coface view MODEL --with ANSWER shows both")
        .files(TRIANGLE)
        .before(&["coface persistence triangle.off -o p.json"])
        .refused("coface view p.json -o a.html")
        .cured(&[&["coface view triangle.off --with p.json -o a.html"]]),
    Case::new("render/diagram.rs", "give what coface persistence wrote")
        .files(TRIANGLE)
        .with(&[("diagram.json", "{\"diagram\":[{}]}")])
        .refused("coface render diagram.json --diagram -o a.svg")
        .cured(&[&["coface persistence triangle.off -o p.json", "coface render p.json --diagram -o a.svg"]]),
    Case::new("scene/results.rs", "homology --generators, cut, cover")
        .files(TRIANGLE)
        .with(&[("no.json", "{}")])
        .refused("coface view triangle.off --with no.json -o a.html")
        .cured(&[&[
            "coface homology triangle.off --generators g.json",
            "coface view triangle.off --with g.json -o a.html",
        ], &[
            "coface generate torus -o torus.off",
            "coface pi1 torus.off --loops loops.json",
            "coface view torus.off --with loops.json -o a.html",
        ]]),
];
