//! Messages about files: what they are, and what was read of them.

use super::{Case, Files};

const SHORT: Files = &[("short.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")];
const TRIANGLE: Files = &[("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")];
const PLY: Files = &[(
    "short.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n\
     property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
)];
const REPEATED: Files = &[("repeated.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 3\n")];

pub(super) const CASES: &[Case] = &[
    Case::new("cityjson/reading.rs", "leave --lod out: the geometries say no level")
        .files(&[(
            "road.city.json",
            "{\"type\":\"CityJSON\",\"CityObjects\":{\"r\":{\"type\":\"Road\",\"geometry\":[\
             {\"type\":\"MultiSurface\",\"boundaries\":[[[0,1,2]]]}]}},\"vertices\":[[0,0,0],[1,0,0],[0,1,0]]}",
        )])
        .refused("coface info road.city.json --lod 2")
        .cured(&[&["coface info road.city.json"]]),
    Case::new("io/src/detection.rs", "say what it is with --format, one of")
        .files(&[("points", "1;2;3\n")])
        .refused("coface info points")
        .cured(&[&["coface info points --format xyz"]]),
    Case::new("io/src/detection.rs", "rename the file, or say what it is with --format {}")
        .files(&[("triangle.stl", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")])
        .refused("coface info triangle.stl")
        .cured(&[&["coface info triangle.stl --format off"]]),
    Case::new("io/src/detection.rs", "check that the file is the one meant, or say what it is with --format")
        .files(&[("points.obj", "1;2;3\n")])
        .refused("coface info points.obj")
        .cured(&[&["coface info points.obj --format xyz"]]),
    Case::new("io/src/detection.rs", "check that the file is the one meant, or say what it is with --format")
        .files(&[("points.obj", "1;2;3\n")])
        .refused("coface info points.obj --format obj")
        .cured(&[&["coface info points.obj --format xyz"]]),
    Case::new("off/read.rs", "correct the counts, or read what is there with --partial")
        .files(SHORT)
        .refused("coface info short.off")
        .cured(&[&["coface info short.off --partial"]]),
    Case::new("ply/read.rs", "or read what is there with --partial")
        .files(PLY)
        .refused("coface info short.ply")
        .cured(&[&["coface info short.ply --partial"]]),
    Case::new("io/src/readers.rs", "leave out --strict, or correct the file")
        .files(REPEATED)
        .refused("coface info repeated.obj --strict")
        .cured(&[&["coface info repeated.obj"]]),
    Case::new("cli/src/remarks.rs", "--strict refuses what is assumed: leave it out")
        .files(&[("hole.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (8 8, 9 8, 9 9, 8 8))")])
        .refused("coface boolean union hole.wkt --strict")
        .cured(&[&["coface boolean union hole.wkt"]]),
    Case::new(
        "io/src/written.rs",
        "write another format; of a drawing coface yin info INPUT -o OUT.dat makes a set",
    )
    .files(&[("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")])
    .refused("coface boolean union square.wkt -o union.dat")
    .cured(&[
        &["coface boolean union square.wkt -o union.wkt"],
        &["coface boolean union square.wkt -o union.wkt", "coface yin info union.wkt -o union.dat"],
    ]),
    Case::new("io/src/written.rs", "draw the model by coface render INPUT -o OUT.png")
        .files(&[("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")])
        .refused("coface convert square.off -o square.png")
        .cured(&[&["coface render square.off -o square.png"]]),
    Case::new("commands/generate/mod.rs", "or the surface of it with --boundary")
        .refused("coface generate box -o box.off")
        .cured(&[&["coface generate box --boundary -o box.off"], &["coface generate box -o box.mesh"]]),
    Case::new("yin/boundary.rs", "ask coface yin, which knows unbounded sets")
        .files(&[("plane.json", "{\"plane\":true}")])
        .refused("coface arrange plane.json")
        .cured(&[&["coface yin info plane.json"]]),
    Case::new("container/reading.rs", "name a file that coface convert, shard, reduce or merge has written")
        .files(TRIANGLE)
        .with(&[("no.cfc", "OFF\n")])
        .refused("coface info no.cfc --format cfc")
        .cured(&[&["coface convert triangle.off -o a.cfc", "coface info a.cfc --format cfc"]]),
    Case::new("container/reading.rs", "reduce it by coface reduce")
        .files(TRIANGLE)
        .before(&["coface shard triangle.off --parts 1 -o parts"])
        .refused("coface info parts/part-000000.shard --format cfc")
        .cured(&[&["coface reduce parts"]]),
    Case::new("container/reading.rs", "merge its folder by coface merge")
        .files(TRIANGLE)
        .before(&["coface shard triangle.off --parts 1 -o parts", "coface reduce parts"])
        .refused("coface info parts/part-000000.reduced --format cfc")
        .cured(&[&["coface merge parts"]]),
    Case::new("container/reading.rs", "shard it by coface shard")
        .files(TRIANGLE)
        .before(&["coface convert triangle.off -o a.shard --to cfc"])
        .refused("coface reduce a.shard")
        .cured(&[&[
            "coface convert triangle.off -o a.cfc",
            "coface shard a.cfc --parts 1 -o parts",
            "coface reduce parts",
        ]]),
    Case::new("files/companion.rs", "copy it into that folder, or allow it by --allow-outside")
        .files(&[("numbers.raw", "1234")])
        .before(&["coface man -o deep"])
        .damaged(&[(
            "deep/a.nhdr",
            "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 2 2\nencoding: raw\ndata file: ../numbers.raw\n\n",
        )])
        .refused("coface info deep/a.nhdr")
        .cured(&[&["coface info deep/a.nhdr --allow-outside"]]),
];
