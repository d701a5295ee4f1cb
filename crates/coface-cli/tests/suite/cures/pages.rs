//! What a page for people leaves out, and the option that lists it.

use super::{Case, Files};

const TRIANGLES: Files = &[(
    "a.json",
    "[[0,1,2],[3,4,5],[6,7,8],[9,10,11],[12,13,14],[15,16,17],[18,19,20],[21,22,23],[24,25,26],\
     [27,28,29],[30,31,32],[33,34,35],[36,37,38],[39,40,41],[42,43,44],[45,46,47],[48,49,50],[51,52,53],\
     [54,55,56],[57,58,59],[60,61,62],[63,64,65],[66,67,68],[69,70,71]]",
)];
/// Nine circles that meet in one point, and the identity.
const CIRCLES: Files = &[
    (
        "a.json",
        "[[0,1],[1,2],[0,2],[0,3],[3,4],[0,4],[0,5],[5,6],[0,6],[0,7],[7,8],[0,8],[0,9],[9,10],\
     [0,10],[0,11],[11,12],[0,12],[0,13],[13,14],[0,14],[0,15],[15,16],[0,16],[0,17],[17,18],\
     [0,18]]",
    ),
    (
        "map.json",
        "[[0,0],[1,1],[2,2],[3,3],[4,4],[5,5],[6,6],[7,7],[8,8],[9,9],[10,10],[11,11],[12,12],\
     [13,13],[14,14],[15,15],[16,16],[17,17],[18,18]]",
    ),
];
const DATA: Files = &[(
    "a.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
     property float p0\nproperty float p1\nproperty float p2\nproperty float p3\n\
     property float p4\nproperty float p5\nproperty float p6\nproperty float p7\n\
     property float p8\nproperty float p9\nproperty float p10\nproperty float p11\n\
     property float p12\nproperty float p13\nproperty float p14\nproperty float p15\n\
     property float p16\nproperty float p17\nproperty float p18\nproperty float p19\n\
     property float p20\nproperty float p21\nproperty float p22\nproperty float p23\n\
     end_header\n0 0 0 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n",
)];
/// Six letters any two of which commute.
const COMMUTING: &str = "coface generate presentation --generators 6 \
     --relator 1,2,-1,-2 --relator 1,3,-1,-3 --relator 1,4,-1,-4 --relator 1,5,-1,-5 --relator 1,6,-1,-6 \
     --relator 2,3,-2,-3 --relator 2,4,-2,-4 --relator 2,5,-2,-5 --relator 2,6,-2,-6 --relator 3,4,-3,-4 \
     --relator 3,5,-3,-5 --relator 3,6,-3,-6 --relator 4,5,-4,-5 --relator 4,6,-4,-6 --relator 5,6,-5,-6 -o a.json";

const TETRAHEDRON: Files =
    &[("t.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")];

/// A matrix of real numbers.
const WEIGHTS: Files =
    &[("w.mtx", "%%MatrixMarket matrix coordinate real general\n3 3 2\n2 1 0.5\n3 2 0.25\n")];

pub(super) const CASES: &[Case] = &[
    Case::new("render/spin.rs", "--spin: an animation is a GIF, a PNG or a WebP")
        .files(TRIANGLES)
        .refused("coface render a.json --spin -o a.svg")
        .cured(&[
            &["coface render a.json --spin=2 --size 40x30 -o a.gif"],
            &["coface render a.json --spin=2 --size 40x30 -o a.png"],
            &["coface render a.json --spin=2 --size 40x30 -o a.webp"],
            &["coface render a.json --spin=2 --size 40x30 -o frames/"],
        ]),
    Case::new("render/spin.rs", "--spin: an animation goes to a file or a folder")
        .files(TRIANGLES)
        .refused("coface render a.json --spin")
        .cured(&[&["coface render a.json --spin=2 --size 40x30 -o spin.gif"]]),
    Case::new("io/src/matrix_market.rs", "write integers or a pattern, or read it as a graph (--flag)")
        .files(WEIGHTS)
        .refused("coface info w.mtx")
        .cured(&[&["coface persistence w.mtx --flag"], &["coface persistence w.mtx --rips"]]),
    Case::new("io/src/matrix_market.rs", "write all entries, as general, or read it as a graph (--flag)")
        .files(&[("w.mtx", "%%MatrixMarket matrix coordinate integer symmetric\n2 2 1\n2 1 5\n")])
        .refused("coface info w.mtx")
        .cured(&[&["coface persistence w.mtx --flag"], &["coface persistence w.mtx --rips"]]),
    Case::new("io/src/number_table.rs", "read it as a graph (--flag) or as distances (--rips)")
        .files(WEIGHTS)
        .refused("coface persistence w.mtx --alpha")
        .cured(&[&["coface persistence w.mtx --flag"], &["coface persistence w.mtx --rips"]]),
    Case::new("io/src/number_table.rs", "read a graph as one (--flag), or write rows of numbers")
        .files(&[("g.graphml", "<graphml><graph><node id=\"a\"/></graph></graphml>")])
        .refused("coface persistence g.graphml --rips")
        .cured(&[&["coface persistence g.graphml --flag"]]),
    Case::new("io/src/written.rs", "coface incidence INPUT VE --signed -o OUT.mtx")
        .files(TETRAHEDRON)
        .refused("coface convert t.off -o t.mtx")
        .cured(&[&["coface incidence t.off VE --signed -o t.mtx"]]),
    Case::new("answers/src/text.rs", "(--check geometry checks it)")
        .files(TETRAHEDRON)
        .answered("coface info t.off --check topology")
        .cured(&[&["coface info t.off --check geometry"]])
        .shows("No problems found."),
    Case::new("answers/src/text.rs", "and {} more {noun} (--all lists them)")
        .files(TRIANGLES)
        .answered("coface info a.json")
        .cured(&[&["coface info a.json --all"]])
        .shows("loop 24: 3 edges"),
    Case::new("answers/src/text.rs", "and {rest} more (--all lists all)")
        .files(DATA)
        .answered("coface info a.ply")
        .cured(&[&["coface info a.ply --all"]])
        .shows("p23 on"),
    Case::new("answers/src/text.rs", "and {} more (--json lists all)")
        .files(&[("a.json", "[[0,1,2,3,4,5,6,7]]")])
        .answered("coface closure a.json --simplices '0 1 2 3 4 5 6 7'")
        .cured(&[&["coface closure a.json --simplices '0 1 2 3 4 5 6 7' --json"]])
        .shows("[0,1,2,3,4,5,6,7]"),
    Case::new("commands/cocycles.rs", "and {more} more (--json lists all)")
        .before(&["coface generate genus --genus 7 -o a.off"])
        .answered("coface cocycles a.off")
        .cured(&[&["coface cocycles a.off --json"]])
        .shows("\"cocycles\":["),
    Case::new("commands/isomorphic.rs", ", .. (--json lists all)")
        .before(&["coface generate genus --genus 2 -o a.off"])
        .answered("coface isomorphic a.off a.off")
        .cured(&[&["coface isomorphic a.off a.off --json"]])
        .shows("\"simplices\":"),
    Case::new("cli/src/output.rs", ".. ({} letters; --json has all)")
        .before(&["coface generate cyclic-torus --dimension 3 -o a.json"])
        .answered("coface isomorphic a.json a.json")
        .cured(&[&["coface isomorphic a.json a.json --json"]])
        .shows("\"signatures\":"),
    Case::new("commands/cut.rs", "and {rest} more (--json lists all)")
        .before(&["coface generate genus --genus 7 -o a.off"])
        .answered("coface cut a.off")
        .cured(&[&["coface cut a.off --json"]])
        .shows("\"number\":14"),
    Case::new("commands/cut.rs", "and {} (--json lists all)")
        .files(TRIANGLES)
        .answered("coface cut a.json")
        .cured(&[&["coface cut a.json --json"]])
        .shows("\"base\":69"),
    Case::new("commands/loops.rs", "and {more} more loops (--all prints all)")
        .before(&["coface generate genus --genus 7 -o a.off"])
        .answered("coface loops a.off")
        .cured(&[&["coface loops a.off --all"]])
        .shows("loop 14"),
    Case::new("commands/loops.rs", "and {more} more relators (--all prints all)")
        .before(&[COMMUTING])
        .answered("coface loops a.json")
        .cured(&[&["coface loops a.json --all"]]),
    Case::new("commands/loops.rs", "and {more} (--all prints all)")
        .files(TRIANGLES)
        .answered("coface loops a.json")
        .cured(&[&["coface loops a.json --all"]])
        .shows("24 of 24"),
    Case::new("commands/pi1.rs", "--all prints the group of each")
        .files(TRIANGLES)
        .answered("coface pi1 a.json")
        .cured(&[&["coface pi1 a.json --all"]])
        .shows("24 of 24"),
    Case::new("commands/cycles.rs", "and {more} (--all prints all)")
        .before(&["coface generate genus --genus 13 -o a.off"])
        .answered("coface cycles --handles a.off")
        .cured(&[&["coface cycles --handles a.off --all"]])
        .shows("handle 13"),
    Case::new("commands/subgroups.rs", "and {more} (--all prints all)")
        .files(TRIANGLES)
        .answered("coface subgroups a.json")
        .cured(&[&["coface subgroups a.json --all"]])
        .shows("24 of 24"),
    Case::new("cli/src/groups.rs", "and {} more walks (--all prints all)")
        .before(&["coface generate genus --genus 51 -o a.off", "coface loops a.off -o loops.json"])
        .answered("coface homotopic a.off --walks loops.json")
        .cured(&[&["coface homotopic a.off --walks loops.json --all"]])
        .shows("walk 101"),
    Case::new("cli/src/groups.rs", "and {} more pairs (--all prints all)")
        .before(&["coface generate genus --genus 8 -o a.off", "coface loops a.off -o loops.json"])
        .answered("coface pi1 a.off --walks loops.json")
        .cured(&[&["coface pi1 a.off --walks loops.json --all"]])
        .shows("walks 14, 15"),
    Case::new("homology/page.rs", "generators to {to}, see --json")
        .files(CIRCLES)
        .answered("coface homology a.json --map map.json --target a.json")
        .cured(&[&["coface homology a.json --map map.json --target a.json --json"]])
        .shows("[0,0,0,0,0,0,0,0,1]"),
    Case::new("commands/persistence.rs", "all with -o or --json")
        .before(&["coface generate torus -o a.off"])
        .answered("coface persistence a.off --min-persistence -1")
        .cured(&[
            &["coface persistence a.off --min-persistence -1 --json"],
            &["coface persistence a.off --min-persistence -1 -o diagram.json --quiet --json"],
        ])
        .shows("\"diagram\":[{"),
];
