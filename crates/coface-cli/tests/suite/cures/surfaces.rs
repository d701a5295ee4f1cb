//! Messages about models that are no surfaces, simplices or cochains.

use super::{Case, Files};

/// Three triangles on one edge.
const BOOK: Files = &[("book.json", "[[0,1,2],[0,1,3],[0,1,4]]")];
/// A triangle with an edge, and three triangles on one edge.
const FLAG: Files = &[("flag.json", "[[0,1,2],[0,1,3],[0,1,4],[4,5]]")];
/// A sphere as the boundary of a tetrahedron, beside a tetrahedron of the same facet list.
const SOLID: Files = &[("solid.json", "[[0,1,2,3],[1,2,3,4]]")];
/// Two triangles, one of them a physical group.
const LID: Files = &[(
    "lid.msh",
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n\
     $Elements\n2\n1 2 2 7 1 1 2 3\n2 2 2 0 1 1 3 4\n$EndElements\n",
)];
const VOXELS: Files = &[(
    "voxels.nrrd",
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n1 1 1 1 1 1 1 0\n",
)];
const SQUARE: Files = &[("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")];
/// Two tetrahedra that share an edge.
pub(super) const PINCHED: Files = &[(
    "pinched.mesh",
    "MeshVersionFormatted 1\nDimension 3\nVertices\n6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 -1 0 0\n0 0 -1 0\n\
     Tetrahedra\n2\n1 2 3 4 0\n1 2 5 6 0\nEnd\n",
)];

const SPLIT: &str = "coface convert book.json --split-edges pairs --split-vertices -o split.json";
const REPAIR: &str = "coface convert flag.json --repair -o repaired.json";
const UNION: &str = "coface boolean union pinched.mesh --pinches split -o boundary.off";
const BOUNDARY: &str = "coface boundary solid.json -o boundary.json";
const SURFACE: &str = "cli/src/surface.rs";

/// A torus by the twins of the sides of a square.
const TORUS: Files = &[("torus.json", r#"{"next":[1,2,3,0],"twin":[2,3,0,1]}"#)];
/// Two triangles glued along all sides.
const PILLOW: Files = &[(
    "pillow.json",
    r#"{"gluings":[[[1,[0,1,2]],[1,[0,1,2]],[1,[0,1,2]]],[[0,[0,1,2]],[0,[0,1,2]],[0,[0,1,2]]]]}"#,
)];

/// A tetrahedron without a face.
const CUP: Files = &[("cup.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n")];
/// Two tetrahedra that cross.
const CROSSED: Files = &[(
    "crossed.off",
    "OFF\n8 8 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n1 1 -1\n5 1 -1\n1 5 -1\n1 1 3\n\
     3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n",
)];

/// Two triangles, each with vertices of its own.
const HALVES: Files =
    &[("halves.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n-0.0 1 0\n3 0 1 2\n3 3 4 5\n")];

pub(super) const CASES: &[Case] = &[
    Case::new("facts/polygons.rs", "coface convert INPUT --weld 0 -o OUT.off joins them")
        .files(HALVES)
        .answered("coface info halves.off")
        .cured(&[&["coface convert halves.off --weld 0 -o joined.off", "coface info joined.off"]])
        .shows("4 vertices, 5 edges"),
    Case::new(
        "handles/triangle_surface.rs",
        "close it first: coface convert INPUT --repair closed -o OUT.off",
    )
    .files(CUP)
    .refused("coface cycles cup.off --handles")
    .cured(&[&[
        "coface convert cup.off --repair closed -o closed.off",
        "coface cycles closed.off --handles",
    ]]),
    Case::new("handles/triangle_surface.rs", "leave --handles out: coface cycles INPUT")
        .before(&["coface generate klein -o klein.off"])
        .refused("coface cycles klein.off --handles")
        .cured(&[&["coface cycles klein.off"]]),
    Case::new("handles/triangle_surface.rs", "make it the boundary of a solid first: coface boolean union")
        .files(CROSSED)
        .refused("coface cycles crossed.off --handles")
        .cured(&[&[
            "coface boolean union crossed.off --pinches split -o union.off",
            "coface cycles union.off --handles",
        ]]),
    Case::new("commands/loops.rs", "for those of handles ask: coface cycles {input} --handles")
        .before(&["coface generate csaszar -o csaszar.off"])
        .refused("coface loops csaszar.off --handles")
        .cured(&[&["coface cycles csaszar.off --handles"]]),
    Case::new(
        "commands/loops.rs",
        "fill handles with: coface cycles {input} --fill-handles {length} -o OUT.off",
    )
    .before(&["coface generate torus -o torus.off"])
    .refused("coface loops torus.off --fill-handles all")
    .cured(&[&["coface cycles torus.off --fill-handles all -o filled.off"]]),
    Case::new("src/editing/mod.rs", "make it halfedges: coface convert INPUT -o OUT.halfedges.json")
        .files(PILLOW)
        .refused("coface edit pillow.json --flip 0 -o flipped.json")
        .cured(&[&[
            "coface convert pillow.json -o pillow.halfedges.json",
            "coface edit pillow.halfedges.json --flip 0 -o flipped.halfedges.json",
        ]]),
    Case::new("commands/edit.rs", "give a log that coface edit --log wrote")
        .files(SQUARE)
        .with(&[("bad.json", "{")])
        .refused("coface edit square.off --undo bad.json -o back.off")
        .cured(&[&[
            "coface edit square.off --poke 0 -o poked.off --log log.json",
            "coface edit poked.off --undo log.json -o back.off",
        ]]),
    Case::new(
        "src/isomorphism.rs",
        "halfedges become facets by coface convert INPUT --triangulate -o OUT.json",
    )
    .files(TORUS)
    .refused("coface isomorphic torus.json torus.json")
    .cured(&[&[
        "coface convert torus.json --triangulate -o facets.json",
        "coface isomorphic facets.json facets.json",
    ]]),
    Case::new("halfedge/permutations.rs", "by coface cover INPUT --orientation -o OUT.off")
        .before(&["coface generate moebius -o moebius.off"])
        .refused("coface convert moebius.off -o moebius.halfedges.json")
        .cured(&[&[
            "coface cover moebius.off --orientation -o annulus.off",
            "coface convert annulus.off -o annulus.halfedges.json",
        ]]),
    Case::new(
        "src/polygon_isomorphism.rs",
        "split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT",
    )
    .with(&[(
        "squares.off",
        "OFF\n8 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 -1 0\n0 -1 0\n1 0 1\n0 0 1\n4 0 1 2 3\n4 1 0 5 4\n4 0 1 6 7\n",
    )])
    .refused("coface isomorphic squares.off squares.off")
    .cured(&[&[
        "coface convert squares.off --split-edges pairs --split-vertices -o apart.off",
        "coface isomorphic apart.off apart.off",
    ]]),
    Case::new("congruence/chains.rs", "keep such cells as chains by --collisions keep")
        .with(&[("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1e-8 0\nv 0 1 0\nf 1 2 3 4\n")])
        .refused("coface congruence quad.obj --tolerance 1e-6 --collisions refuse")
        .cured(&[
            &["coface congruence quad.obj --tolerance 1e-9 --collisions refuse"],
            &["coface congruence quad.obj --tolerance 1e-6 --collisions keep"],
            &["coface congruence quad.obj --tolerance 1e-6 --collisions rewrap"],
        ]),
    Case::new(SURFACE, "split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT")
        .files(BOOK)
        .refused("coface cycles book.json")
        .cured(&[&[SPLIT, "coface cycles split.json"]]),
    Case::new(SURFACE, "split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT")
        .files(BOOK)
        .refused("coface homotopic book.json '0 1 2 0'")
        .cured(&[&[SPLIT, "coface homotopic split.json '0 1 2 0'"]]),
    Case::new(SURFACE, "split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT")
        .files(BOOK)
        .refused("coface cut book.json")
        .cured(&[&[SPLIT, "coface cut split.json"]]),
    Case::new(SURFACE, "split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT")
        .files(BOOK)
        .refused("coface cover book.json --copies 1")
        .cured(&[&[SPLIT, "coface cover split.json --copies 1"]]),
    Case::new(SURFACE, "coface convert INPUT --repair -o OUT")
        .files(FLAG)
        .refused("coface cycles flag.json")
        .cured(&[&[REPAIR, "coface cycles repaired.json"]]),
    Case::new(SURFACE, "coface convert INPUT --repair -o OUT")
        .files(FLAG)
        .refused("coface cut flag.json")
        .cured(&[&[REPAIR, "coface cut repaired.json"]]),
    Case::new(SURFACE, "coface boundary INPUT -o OUT.json")
        .files(SOLID)
        .refused("coface cycles solid.json")
        .cured(&[&[BOUNDARY, "coface cycles boundary.json"]]),
    Case::new(SURFACE, "coface boundary INPUT -o OUT.json")
        .files(SOLID)
        .refused("coface cut solid.json")
        .cured(&[&[BOUNDARY, "coface cut boundary.json"]]),
    Case::new(SURFACE, "coface boolean union INPUT --pinches split -o OUT.off")
        .files(PINCHED)
        .refused("coface cycles pinched.mesh")
        .cured(&[&[UNION, "coface cycles boundary.off"]]),
    Case::new(SURFACE, "coface boolean union INPUT --pinches split -o OUT.off")
        .before(&["coface generate box --cuboids --shape 2,1,1 -o hexahedra.vtu"])
        .refused("coface cycles hexahedra.vtu")
        .cured(&[&["coface boolean union hexahedra.vtu --pinches split -o b.off", "coface cycles b.off"]]),
    Case::new(SURFACE, "coface boolean union INPUT --pinches split -o OUT.off")
        .files(PINCHED)
        .refused("coface cut pinched.mesh --boundary")
        .cured(&[&[UNION, "coface cut boundary.off"]]),
    Case::new(SURFACE, "add --boundary to take its boundary")
        .before(&["coface generate box -o box.mesh"])
        .refused("coface cut box.mesh")
        .cured(&[&["coface cut box.mesh --boundary"]]),
    Case::new("commands/cut.rs", "add --layout polygon, or leave --weights out")
        .before(&["coface generate torus -o torus.off"])
        .refused("coface cut torus.off --weights cotangent")
        .cured(&[&["coface cut torus.off --weights cotangent --layout polygon"], &["coface cut torus.off"]]),
    Case::new("commands/loops.rs", "leave --shortest and --canonical out")
        .files(BOOK)
        .refused("coface loops book.json --shortest")
        .cured(&[&["coface loops book.json"], &[SPLIT, "coface loops split.json --shortest"]]),
    Case::new("commands/loops.rs", "leave --shortest and --canonical out")
        .files(BOOK)
        .refused("coface loops book.json --canonical")
        .cured(&[&["coface loops book.json"], &[SPLIT, "coface loops split.json --canonical"]]),
    Case::new("commands/pi1.rs", "leave --shortest, --canonical, --walks and --cycles out")
        .files(BOOK)
        .refused("coface pi1 book.json --shortest")
        .cured(&[&["coface pi1 book.json"], &[SPLIT, "coface pi1 split.json --shortest"]]),
    Case::new("commands/pi1.rs", "leave --shortest, --canonical, --walks and --cycles out")
        .files(FLAG)
        .refused("coface pi1 flag.json --canonical")
        .cured(&[&["coface pi1 flag.json"], &[REPAIR, "coface pi1 repaired.json --canonical"]]),
    Case::new("commands/pi1.rs", "leave --shortest, --canonical, --walks and --cycles out")
        .files(BOOK)
        .with(&[("walks.json", "[[0,1,2,0]]")])
        .refused("coface pi1 book.json --walks walks.json")
        .cured(&[&["coface pi1 book.json"], &[SPLIT, "coface pi1 split.json --walks walks.json"]]),
    Case::new("commands/pi1.rs", "leave --shortest, --canonical, --walks and --cycles out")
        .files(BOOK)
        .refused("coface pi1 book.json --cycles non-contractible")
        .cured(&[&["coface pi1 book.json"], &[SPLIT, "coface pi1 split.json --cycles non-contractible"]]),
    Case::new("cocycles/mod.rs", "coface homology --cohomology --harmonic")
        .files(BOOK)
        .refused("coface cocycles book.json --harmonic")
        .cured(&[&["coface homology --cohomology --harmonic book.json"]]),
    Case::new("commands/cocycles.rs", "take --method general, which serves for every model")
        .files(BOOK)
        .refused("coface cocycles book.json --method crossing")
        .cured(&[&["coface cocycles book.json --method general"]]),
    Case::new("commands/cocycles.rs", "take --method crossing")
        .before(&["coface generate moebius -o band.off"])
        .refused("coface cocycles band.off --method slicing")
        .cured(&[&["coface cocycles band.off --method crossing"]]),
    Case::new("commands/cocycles.rs", "take --weights uniform")
        .before(&["coface generate cyclic-torus --dimension 2 -o torus.json"])
        .refused("coface cocycles torus.json --harmonic --weights cotangent")
        .cured(&[&["coface cocycles torus.json --harmonic --weights uniform"]]),
    Case::new("commands/cocycles.rs", "say with --tolerance which sums count as zero")
        .files(BOOK)
        .with(&[("cochain.json", "[[0.5,[0,1]]]")])
        .refused("coface cocycles book.json --test cochain.json")
        .cured(&[&["coface cocycles book.json --test cochain.json --tolerance 1e-9"]]),
    Case::new("producer/mod.rs", "make a mesh of its boundary: coface convert VOLUME -o boundary.obj")
        .files(VOXELS)
        .refused("coface loops voxels.nrrd")
        .cured(&[&["coface convert voxels.nrrd -o boundary.obj", "coface loops boundary.obj"]]),
    Case::new("producer/mod.rs", "make a mesh of its boundary: coface convert VOLUME -o boundary.obj")
        .files(VOXELS)
        .refused("coface cocycles voxels.nrrd")
        .cured(&[
            &["coface homology voxels.nrrd"],
            &["coface convert voxels.nrrd -o boundary.obj", "coface cocycles boundary.obj"],
        ]),
    Case::new("cli/src/failure.rs", "coface convert INPUT -o boundary.obj")
        .files(VOXELS)
        .refused("coface star voxels.nrrd --simplices 0")
        .cured(&[
            &["coface homology voxels.nrrd"],
            &[
                "coface convert voxels.nrrd -o boundary.obj",
                "coface arrange boundary.obj --triangles -o triangles.off",
                "coface star triangles.off --simplices 0",
            ],
        ]),
    Case::new("cli/src/failure.rs", "coface arrange INPUT --dimension 3 --triangles -o OUT")
        .files(SQUARE)
        .refused("coface link square.off --simplices 0")
        .cured(&[&[
            "coface arrange square.off --dimension 3 --triangles -o triangles.off",
            "coface link triangles.off --simplices 0",
        ]]),
    Case::new("cli/src/failure.rs", "coface arrange INPUT --dimension 3 --triangles -o OUT")
        .files(SQUARE)
        .refused("coface homology square.off --cup 1 1")
        .cured(&[&[
            "coface arrange square.off --dimension 3 --triangles -o triangles.off",
            "coface homology triangles.off --cup 1 1",
        ]]),
    Case::new("answers/src/simplices.rs", "take its closure, or print the set with --json")
        .files(BOOK)
        .refused("coface star book.json --simplices 0 -o star.json")
        .cured(&[
            &["coface star book.json --simplices 0 --json"],
            &["coface closure book.json --simplices '0 1 2; 0 1 3' -o closure.json"],
        ]),
    Case::new("homology/certificate.rs", "leave --certificate out, or give a facet list, a chain complex")
        .files(VOXELS)
        .refused("coface homology voxels.nrrd --certificate voxels.cert")
        .cured(&[
            &["coface homology voxels.nrrd"],
            &[
                "coface convert voxels.nrrd -o boundary.off",
                "coface homology boundary.off --certificate boundary.cert",
                "coface check boundary.cert boundary.off",
            ],
        ]),
    Case::new("homology/mod.rs", "leave --certificate out, or write the domain as a model of its own")
        .files(LID)
        .with(&[("domain.json", "[[0,1,2]]")])
        .refused("coface homology lid.msh --domain 7 --certificate lid.cert")
        .cured(&[
            &["coface homology lid.msh --domain 7"],
            &["coface homology domain.json --certificate domain.cert", "coface check domain.cert"],
        ]),
    Case::new("commands/info.rs", "name one, or run the command once for each")
        .files(BOOK)
        .with(&[("edge.json", "[[0,1]]")])
        .refused("coface info book.json edge.json --certificate both.cert")
        .cured(&[&[
            "coface info book.json --certificate book.cert",
            "coface info edge.json --certificate edge.cert",
            "coface check edge.cert",
        ]]),
    Case::new("commands/check.rs", "name it: coface check CERTIFICATE INPUT")
        .files(BOOK)
        .with(&[("lone.cert", "{\"coface_certificate\":1,\"inputs\":[]}")])
        .before(&["coface homology book.json --certificate book.cert"])
        .refused("coface check lone.cert")
        .cured(&[&["coface check book.cert book.json"]]),
    Case::new("scene/pixels.rs", "leave out --periodic")
        .files(&[(
            "row.nrrd",
            "NRRD0004\ntype: double\ndimension: 2\nsizes: 3 1\nencoding: ascii\n\n1 2 3\n",
        )])
        .refused("coface render row.nrrd --threshold 2 --periodic x -o a.svg")
        .cured(&[&["coface render row.nrrd --threshold 2 -o a.svg"]]),
    Case::new("cubical/surface.rs", "leave out --periodic")
        .files(VOXELS)
        .refused("coface convert voxels.nrrd --periodic x -o boundary.obj")
        .cured(&[&["coface convert voxels.nrrd -o boundary.obj"]]),
    Case::new("persistence/mod.rs", "give a file of values: --function FILE")
        .files(BOOK)
        .with(&[("values.txt", "0\n1\n2\n3\n4\n")])
        .refused("coface persistence book.json --function x")
        .cured(&[&["coface persistence book.json --function values.txt"]]),
];
