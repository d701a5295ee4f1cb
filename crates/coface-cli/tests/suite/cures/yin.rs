//! Messages about regions with curved boundaries.

use super::{Case, Files};

const DISK: Files =
    &[("disk.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle cx=\"5\" cy=\"5\" r=\"3\"/></svg>")];
const DISK_AND_POINTS: Files = &[DISK[0], ("points.xyz", "1 2\n5 5\n")];
const BOW: Files = &[("bow.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))")];
/// Two disks nearer to each other than can be told.
const DISKS: Files = &[
    ("a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle cx=\"5\" cy=\"5\" r=\"3\"/></svg>"),
    (
        "b.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle cx=\"5\" cy=\"5\" r=\"3.00000000000001\"/></svg>",
    ),
];
/// Two squares that overlap.
const SQUARES: Files =
    &[("a.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"), ("b.wkt", "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))")];
/// Two curves that leave one point side by side.
const ARCS: Files = &[
    ("a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0 C3 4 4 1 4 0 L2 -3 Z\"/></svg>"),
    (
        "b.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 1e-13 C3 4 4 1 4 -1e-13 L2 -3 Z\"/></svg>",
    ),
];
/// Two squares side by side.
const ROOMS: Files = &[
    ("rooms.wkt", "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 1, 1 0)))"),
    ("square.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"),
];
/// A phase whose edge crosses itself.
const BOW_PHASE: &str = "{\"files\":[],\"order\":2,\"phases\":[{\"name\":\"a\",\"area\":1,\"perimeter\":1,\"components\":1,\"holes\":0,\"neighbors\":[]}],\
     \"vertices\":[[0,0]],\"edges\":[{\"ends\":[0,0],\"left\":0,\"right\":null,\"length\":1,\"pieces\":4,\"knots\":[0,1,2,3,4],\
     \"controls\":[[0,0],[2,2],[2,0],[0,2],[0,0]]}],\"junctions\":[],\"smooth_pairs\":[],\"length\":1,\"remarks\":[]}";
const INTERFACE: &[&str] = &["coface yin interface rooms.wkt -o rooms.json"];
/// A drop that becomes a long thin thread in a vortex.
const DROP: Files = &[(
    "drop.json",
    "{\"order\":4,\"curves\":[{\"points\":[[0.65,0.75],[0.6299,0.825],[0.575,0.8799],[0.5,0.9],[0.425,0.8799],\
     [0.3701,0.825],[0.35,0.75],[0.3701,0.675],[0.425,0.6201],[0.5,0.6],[0.575,0.6201],[0.6299,0.675]]}]}",
)];

pub(super) const CASES: &[Case] = &[
    Case::new("yin/making.rs", "say how far chords may be from it: --flatten LENGTH")
        .files(DISK)
        .before(&["coface yin info disk.svg --order 6 -o disk.json"])
        .refused("coface yin info disk.json --order 4")
        .cured(&[&["coface yin info disk.json --order 4 --flatten 0.01"]]),
    Case::new("yin/making.rs", "a thousandth of the size of the set; --flatten LENGTH says another length")
        .files(DISK)
        .before(&["coface yin info disk.svg -o disk.json"])
        .answered("coface yin info disk.json --order 2")
        .cured(&[&["coface yin info disk.json --order 2 --flatten 0.01"]]),
    Case::new("yin/making.rs", "repair the curves with a fill rule: --rule nonzero, evenodd or positive")
        .files(BOW)
        .refused("coface yin info bow.wkt")
        .cured(&[
            &["coface yin info bow.wkt --rule nonzero"],
            &["coface yin info bow.wkt --rule evenodd"],
            &["coface yin info bow.wkt --rule positive"],
        ]),
    Case::new("yin/svg.rs", "say how far chords may be from them: --flatten LENGTH")
        .files(DISK)
        .refused("coface yin info disk.svg --order 6 -o out.svg")
        .cured(&[&["coface yin info disk.svg --order 6 -o out.svg --flatten 0.01"]]),
    Case::new("yin/writing.rs", "say how far chords may be from them: --flatten LENGTH; or write .json")
        .files(DISK)
        .refused("coface yin info disk.svg -o out.wkt")
        .cured(&[
            &["coface yin info disk.svg -o out.wkt --flatten 0.01"],
            &["coface yin info disk.svg -o out.json"],
        ]),
    Case::new("yin/motion.rs", "--keep-small keeps such curves")
        .files(&[("hole.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (1 1, 1.01 1, 1 1.01, 1 1))")])
        .answered("coface yin advect hole.wkt --flow translation --time 0.1 --spacing 1")
        .cured(&[
            &["coface yin advect hole.wkt --flow translation --time 0.1 --spacing 1 --keep-small"],
        ]),
    Case::new("yin/advect.rs", "there is no such time; give a finite one")
        .files(DISK)
        .refused("coface yin advect disk.svg --flow rotation --time inf")
        .cured(&[&["coface yin advect disk.svg --flow rotation --time 0.1"]]),
    Case::new("yin/advect.rs", "--repair needs to know when: leave out --verify never")
        .files(DISK)
        .refused("coface yin advect disk.svg --flow rotation --time 0.1 --repair nonzero --verify never")
        .cured(&[&["coface yin advect disk.svg --flow rotation --time 0.1 --repair nonzero"]]),
    Case::new("yin/advect.rs", "a flow cannot come back after that; give a finite time other than 0")
        .files(DISK)
        .refused("coface yin advect disk.svg --flow vortex --period 0")
        .cured(&[&["coface yin advect disk.svg --flow vortex --period 0.1"]]),
    Case::new("yin/advect.rs", "give a finite number of radians per time")
        .files(DISK)
        .refused("coface yin advect disk.svg --flow rotation --speed inf --time 0.1")
        .cured(&[&["coface yin advect disk.svg --flow rotation --speed 1 --time 0.1"]]),
    Case::new("yin/cut_cells.rs", "ask for it with `coface yin info`")
        .files(DISK)
        .refused("coface yin cut-cells disk.svg --picture kinks -o a.svg")
        .cured(&[&["coface yin info disk.svg --picture kinks -o a.svg"]]),
    Case::new("yin/places.rs", "--picture draws a set, not places on it: ask for it with `coface yin info`")
        .files(DISK)
        .refused("coface yin sample disk.svg --picture kinks -o a.svg")
        .cured(&[&["coface yin info disk.svg --picture kinks -o a.svg"]]),
    Case::new("yin/places.rs", "there are no points to locate; give --point X,Y, or --points FILE")
        .files(DISK_AND_POINTS)
        .refused("coface yin locate disk.svg")
        .cured(&[
            &["coface yin locate disk.svg --point 5,5"],
            &["coface yin locate disk.svg --points points.xyz"],
        ]),
    Case::new("yin/validity.rs", "--picture draws a set, not its faults: ask for it with `coface yin info`")
        .files(DISK)
        .refused("coface yin validate disk.svg --picture kinks -o a.svg")
        .cured(&[&["coface yin info disk.svg --picture kinks -o a.svg"]]),
    Case::new("yin/validity.rs", "repair them with `coface yin normalize`")
        .files(BOW)
        .refused("coface yin validate bow.wkt")
        .cured(&[&["coface yin normalize bow.wkt -o good.wkt", "coface yin validate good.wkt"]]),
    Case::new("yin/validity.rs", "there is no map; give --scale, --rotate, --translate or --matrix")
        .files(DISK)
        .refused("coface yin transform disk.svg")
        .cured(&[
            &["coface yin transform disk.svg --scale 2"],
            &["coface yin transform disk.svg --rotate 90"],
            &["coface yin transform disk.svg --translate 1,0"],
            &["coface yin transform disk.svg --matrix 1,0,0,0,1,0"],
        ]),
    Case::new("yin/edit.rs", "`coface yin kinks` lists them")
        .files(BOW)
        .misused("coface yin kinks bow.wkt --rule nonzero --erase first")
        .cured(&[&["coface yin kinks bow.wkt --rule nonzero"]]),
    Case::new("yin/edit.rs", "the set has no curves, and so no knots; leave out --insert-near")
        .files(&[("none.json", "{\"curves\":[]}")])
        .refused("coface yin kinks none.json --insert-near 1,1")
        .cured(&[&["coface yin kinks none.json"]]),
    Case::new("yin/edit.rs", "the set has no kinks; leave out --erase-near")
        .files(DROP)
        .refused("coface yin kinks drop.json --erase-near 1,1")
        .cured(&[&["coface yin kinks drop.json"]]),
    Case::new("yin/compare.rs", "--exact: {error}")
        .files(DISK)
        .refused("coface yin compare disk.svg --exact 'function:5+3*cos(t/2); 5+3*sin(t)'")
        .cured(&[&["coface yin compare disk.svg --exact 'function:5+3*cos(t); 5+3*sin(t)'"]]),
    Case::new("yin/mod.rs", "--picture draws an SVG: name it with -o FILE.svg")
        .files(DISK)
        .refused("coface yin info disk.svg --picture forest")
        .cured(&[&["coface yin info disk.svg --picture forest -o a.svg"]]),
    Case::new("yin/advect.rs", "{cure}by a fill rule: --repair nonzero, evenodd or positive")
        .files(DROP)
        .refused("coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.15")
        .cured(&[
            &["coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.15 --repair nonzero"],
            &["coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.15 --repair evenodd"],
            &["coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.15 --repair positive"],
            &["coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.02 --step 0.05"],
        ]),
    Case::new("yin/advect.rs", "a shorter --step or a smaller --spacing")
        .files(DROP)
        .refused("coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.15")
        .cured(&[&["coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.02 --step 0.05"]]),
    Case::new("yin/advect.rs", "leave out --verify never, and repair the set by a fill rule")
        .files(DROP)
        .refused("coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.15 --verify never")
        .cured(&[&["coface yin advect drop.json --flow vortex --period 16 --time 8 --spacing 0.15 --repair nonzero"]]),
    Case::new("yin/advect.rs", "--events and --on-contact look after each step: leave out --verify")
        .files(DISK)
        .refused("coface yin advect disk.svg --velocity 1,0 --events --verify end")
        .cured(&[
            &["coface yin advect disk.svg --velocity 1,0 --events"],
            &["coface yin advect disk.svg --velocity 1,0 --on-contact keep"],
        ]),
    Case::new("yin/advect.rs", "and --repair changes them: leave one of them out")
        .files(DISK)
        .refused("coface yin advect disk.svg --velocity 1,0 --on-contact keep --repair nonzero")
        .cured(&[
            &["coface yin advect disk.svg --velocity 1,0 --on-contact keep"],
            &["coface yin advect disk.svg --velocity 1,0 --repair nonzero"],
        ]),
    Case::new("yin/advect.rs", "--event-tolerance is of events: ask for them with --events")
        .files(DISK)
        .refused("coface yin advect disk.svg --velocity 1,0 --event-tolerance 0.1")
        .cured(&[&["coface yin advect disk.svg --velocity 1,0 --event-tolerance 0.1 --events"]]),
    Case::new("yin/motion.rs", "a smaller --spacing or --least-ratio makes it so")
        .files(DISK)
        .answered("coface yin advect disk.svg --velocity 1,0 --spacing 0.5 --on-contact merge --contact-distance 0.01")
        .cured(&[
            &["coface yin advect disk.svg --velocity 1,0 --spacing 0.1 --on-contact merge --contact-distance 0.01"],
            &["coface yin advect disk.svg --velocity 1,0 --spacing 0.5 --least-ratio 0.02 --on-contact merge --contact-distance 0.01"],
        ]),
    Case::new("yin/interface_file.rs", "repair it with coface yin normalize")
        .files(ROOMS)
        .with(&[("bow.json", BOW_PHASE)])
        .refused("coface yin info bow.json")
        .cured(&[&["coface yin normalize bow.json -o rooms.json", "coface yin info rooms.json"]]),
    Case::new("yin/edit.rs", "write EDGE:KNOT, both numbered from 0, or a point with --insert-near")
        .files(ROOMS)
        .before(INTERFACE)
        .refused("coface yin kinks rooms.json --insert rim:1")
        .cured(&[
            &["coface yin kinks rooms.json --insert 1:1"],
            &["coface yin kinks rooms.json --insert-near 0,0"],
        ]),
    Case::new("yin/interface_motion.rs", "--keep-small keeps such edges")
        .files(&[("hole.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (1 1, 1.01 1, 1 1.01, 1 1))")])
        .answered("coface yin advect hole.wkt --inputs features --flow translation --time 0.1 --spacing 1")
        .cured(&[&[
            "coface yin advect hole.wkt --inputs features --flow translation --time 0.1 --spacing 1 --keep-small",
        ]]),
    Case::new("json/interface.rs", "give the file that coface yin interface -o FILE.json writes")
        .files(&[
            ("bad.json", r#"{"order":2,"phases":[{"name":"a"}],"junctions":[]}"#),
            ("rooms.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))\n"),
        ])
        .refused("coface info bad.json")
        .cured(&[&["coface yin interface rooms.wkt -o good.json", "coface info good.json"]]),
    Case::new("yin/interface_file.rs", "give the file that coface yin interface -o FILE.json writes")
        .files(DISK)
        .with(&[("bad.json", "{\"phases\":[],\"junctions\":[]}")])
        .refused("coface yin advect bad.json --velocity 1,0")
        .cured(&[&[
            "coface yin interface disk.svg -o good.json",
            "coface yin advect good.json --velocity 1,0",
        ]]),
    Case::new("yin/combine.rs", "could not be certified at the resolution of the arithmetic; --json lists them")
        .files(ARCS)
        .answered("coface yin meet a.svg b.svg")
        .cured(&[&["coface yin meet a.svg b.svg --json"]])
        .shows("\"uncertified\":[{")
        .stays(),
    Case::new("overlay/chains.rs", "or take chords for curves, which are exact: --order 2 --flatten LENGTH")
        .files(ARCS)
        .refused("coface yin xor a.svg b.svg")
        .cured(&[&["coface yin xor a.svg b.svg --order 2 --flatten 1e-3"]]),
    Case::new("commands/yin/advect.rs", "which says how points move already; leave one of them out")
        .files(DISK)
        .refused("coface yin advect disk.svg --flow vortex --velocity 1,0 -o out.json")
        .cured(&[
            &["coface yin advect disk.svg --velocity 1,0 -o out.json"],
            &["coface yin advect disk.svg --flow vortex -o out.json"],
        ]),
    Case::new("commands/yin/advect.rs", "--velocity: {error}")
        .files(DISK)
        .refused("coface yin advect disk.svg --velocity x^2 -o out.json")
        .cured(&[&["coface yin advect disk.svg --velocity '-y; x' -o out.json"]]),
    Case::new("boolean/curved.rs", "coface yin compare A B measures how far two sets are apart")
        .files(ARCS)
        .refused("coface yin xor a.svg b.svg")
        .cured(&[&["coface yin compare a.svg b.svg"]]),
    Case::new("yin/interface.rs", "--picture draws a set, not an interface: write the phases with --sets")
        .files(DISK)
        .refused("coface yin interface disk.svg --picture kinks -o a.svg")
        .cured(&[&[
            "coface yin interface disk.svg --sets phase.json",
            "coface yin info phase-001.json --picture kinks -o a.svg",
        ]]),
    Case::new("yin/interface.rs", "name the file so, or write its phases with --sets")
        .files(DISK)
        .refused("coface yin interface disk.svg -o a.obj")
        .cured(&[
            &["coface yin interface disk.svg -o a.json"],
            &["coface yin interface disk.svg --sets a.svg"],
        ]),
    Case::new("yin/interface.rs", "give an angle below 180 degrees; a negative one lets no edges go on smoothly")
        .files(DISK)
        .refused("coface yin interface disk.svg --smooth 200")
        .cured(&[
            &["coface yin interface disk.svg --smooth 20"],
            &["coface yin interface disk.svg --smooth -1"],
        ]),
    Case::new("yin/interface.rs", "give a file for each phase: --inputs files")
        .files(DROP)
        .refused("coface yin interface drop.json --inputs features")
        .cured(&[&["coface yin interface drop.json --inputs files"]]),
    Case::new("yin/interface.rs", "or say to which of them common points go: --overlaps first or --overlaps last")
        .files(SQUARES)
        .refused("coface yin interface a.wkt b.wkt")
        .cured(&[
            &["coface yin interface a.wkt b.wkt --overlaps first"],
            &["coface yin interface a.wkt b.wkt --overlaps last"],
        ]),
    Case::new("yin/compare.rs", "give another one, or a shape with --exact circle:X,Y,RADIUS")
        .files(DISK)
        .refused("coface yin compare disk.svg")
        .cured(&[&["coface yin compare disk.svg disk.svg"], &["coface yin compare disk.svg --exact circle:5,5,3"]]),
    Case::new("yin/compare.rs", "give two, or compare all with the last one in a table: --series")
        .files(DISKS)
        .refused("coface yin compare a.svg b.svg a.svg")
        .cured(&[&["coface yin compare a.svg b.svg"], &["coface yin compare a.svg b.svg a.svg --series"]]),
    Case::new("yin/compare.rs", "ask for it with `coface yin xor`")
        .files(DISKS)
        .refused("coface yin compare a.svg b.svg --picture kinks -o out.svg")
        .cured(&[&["coface yin xor a.svg b.svg --picture kinks -o out.svg"]]),
    Case::new("yin/given.rs", "name a phase by its number or its name, as in coface yin info {name}#0")
        .files(ROOMS)
        .before(INTERFACE)
        .refused("coface yin complement rooms.json")
        .cured(&[
            &["coface yin complement rooms.json#0"],
            &["coface yin complement rooms.json#rooms.wkt#1"],
        ]),
    Case::new("yin/given.rs", "leave it out, or name a phase, as in coface yin info {name}#0")
        .files(ROOMS)
        .before(INTERFACE)
        .refused("coface yin info rooms.json --order 4")
        .cured(&[&["coface yin info rooms.json"], &["coface yin info rooms.json#0 --order 4"]]),
    Case::new("yin/given.rs", "--ends natural")
        .files(ROOMS)
        .before(INTERFACE)
        .refused("coface yin fit rooms.json --ends natural")
        .cured(&[&["coface yin fit rooms.json"], &["coface yin fit rooms.json#0 --ends natural"]]),
    Case::new("yin/given.rs", "give the file alone, as in coface yin info {file}")
        .files(ROOMS)
        .refused("coface yin info square.wkt#1")
        .cured(&[&["coface yin info square.wkt"]]),
    Case::new("yin/validity.rs", "make it from sets again: coface yin interface SETS --overlaps first")
        .files(ROOMS)
        .before(INTERFACE)
        .damaged(&[("rooms.json", BOW_PHASE)])
        .refused("coface yin validate rooms.json")
        .cured(&[&[
            "coface yin interface rooms.wkt square.wkt --overlaps first -o rooms.json",
            "coface yin validate rooms.json",
        ]]),
    Case::new("cli/src/failure.rs", "coface yin info INPUT says what it is, and coface view INPUT -o OUT.html shows it")
        .files(ROOMS)
        .before(INTERFACE)
        .refused("coface render rooms.json --forest -o rooms.svg")
        .cured(&[&["coface yin info rooms.json"], &["coface view rooms.json -o rooms.html"]]),
];
