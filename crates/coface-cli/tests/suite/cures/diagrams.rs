//! Messages about persistence diagrams as data.

use super::{Case, Files};

const LINE: Files =
    &[("line.csv", "-inf,inf\n"), ("model.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")];
/// Points of a line.
const POINTS: Files = &[("points.csv", "0 0\n1 0\n3 0\n")];
const TWO: Files = &[("a.csv", "0,inf\n1,3\n"), ("b.csv", "0,inf\n1,2\n")];

pub(super) const CASES: &[Case] = &[
    Case::new("persistence/curves.rs", "give the range of values (--range A B)")
        .files(LINE)
        .refused("coface diagram landscape line.csv")
        .cured(&[&["coface diagram landscape line.csv --range 0 1"]]),
    Case::new("persistence/curves.rs", "(--births A B --persistences A B)")
        .files(LINE)
        .refused("coface diagram image line.csv --degree 0")
        .cured(&[&["coface diagram image line.csv --degree 0 --births 0 1 --persistences 0 1"]]),
    Case::new("persistence/curves.rs", "--end T takes T for the death")
        .files(TWO)
        .answered("coface diagram silhouette a.csv")
        .cured(&[&["coface diagram silhouette a.csv --end 4"]]),
    Case::new("persistence/given.rs", "give a diagram that coface persistence INPUT -o DIAGRAM.json writes")
        .files(LINE)
        .refused("coface diagram betti model.off")
        .cured(&[&["coface persistence model.off -o a.json", "coface diagram betti a.json"]]),
    Case::new("commands/diagram.rs", "is for Wasserstein distances; say --metric wasserstein")
        .files(TWO)
        .refused("coface diagram distance a.csv b.csv --order 2")
        .cured(&[&["coface diagram distance a.csv b.csv --order 2 --metric wasserstein"]]),
    Case::new("persistence/euler.rs", "give a model with positions, or leave --directions out")
        .files(&[("facets.json", "[[0,1]]")])
        .refused("coface euler facets.json --directions 8")
        .cured(&[&["coface euler facets.json"]]),
    Case::new("persistence/euler.rs", "give the range of values (--range A B)")
        .files(&[("image.nrrd", "NRRD0004\ntype: double\ndimension: 1\nsizes: 2\nencoding: ascii\n\nnan nan\n")])
        .refused("coface euler image.nrrd --samples 3")
        .cured(&[&["coface euler image.nrrd --samples 3 --range 0 1"]]),
    Case::new("commands/euler.rs", "choose others with --threshold T")
        .files(&[("image.pgm", "P2\n2 2\n9\n1 2\n3 4\n")])
        .answered("coface euler image.pgm --directions 3")
        .cured(&[&["coface euler image.pgm --directions 3 --threshold 2"]]),
    Case::new("persistence/euler.rs", "give a table with a row for each direction: --directions FILE")
        .files(&[("four.off", "4OFF\n2 0 1\n0 0 0 0\n1 0 0 0\n2 0 1\n"), ("rows.txt", "1 0 0 0\n")])
        .refused("coface euler four.off --directions 8")
        .cured(&[&["coface euler four.off --directions rows.txt"]]),
    Case::new("commands/euler.rs", "all with -o or --json")
        .files(&[("model.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")])
        .answered("coface euler model.off --directions 3")
        .cured(&[&["coface euler model.off --directions 3 --json"]]),
    Case::new("commands/euler.rs", "{}; all with -o or --json")
        .files(&[("model.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")])
        .answered("coface euler model.off --function x --samples 50")
        .cured(&[&["coface euler model.off --function x --samples 50 --json"]]),
    Case::new("persistence/image.rs", "--upper-star is for functions on vertices")
        .files(&[("image.pgm", "P2\n2 2\n9\n1 2\n3 4\n")])
        .refused("coface persistence image.pgm --upper-star")
        .cured(&[
            &["coface persistence image.pgm --superlevel"],
            &["coface persistence image.pgm --upper-star --function y"],
        ]),
    Case::new("commands/persistence.rs", "with coface render FILE --diagram, or cycles on the model with --cycles OUT")
        .files(LINE)
        .refused("coface persistence model.off -o a.svg")
        .cured(&[
            &["coface persistence model.off -o a.json", "coface render a.json --diagram -o a.svg"],
            &["coface persistence model.off --cycles a.obj"],
        ]),
    Case::new("commands/persistence.rs", "--extended is for functions on vertices")
        .files(&[("image.pgm", "P2\n2 2\n9\n1 2\n3 4\n")])
        .refused("coface persistence image.pgm --extended")
        .cured(&[&["coface persistence image.pgm --extended --function y"]]),
    Case::new("commands/persistence.rs", "--relative and --image-of are for functions on vertices")
        .files(&[("image.pgm", "P2\n2 2\n9\n1 2\n3 4\n")])
        .refused("coface persistence image.pgm --relative boundary")
        .cured(&[
            &["coface persistence image.pgm --relative boundary --function y"],
            &["coface persistence image.pgm --image-of boundary --function y"],
        ]),
    Case::new("commands/persistence.rs", "leave --collapse out")
        .files(&[("points.csv", "0,0\n1,0\n0,1\n"), ("edges.txt", "0 1 1\n1 2 2\n0 2 3\n")])
        .refused("coface persistence points.csv --alpha --collapse")
        .cured(&[
            &["coface persistence points.csv --alpha"],
            &["coface persistence points.csv --rips --collapse"],
            &["coface persistence edges.txt --flag --collapse"],
        ]),
    Case::new("render/mod.rs", "draw it with --diagram")
        .files(LINE)
        .before(&["coface persistence model.off -o a.json"])
        .refused("coface render a.json -o a.svg")
        .cured(&[&["coface render a.json --diagram -o a.svg"]]),
    Case::new("persistence/vineyard.rs", "and {more} more; all with -o or --json")
        .files(&[(
            "path.json",
            "[[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,8],[8,9],[9,10],[10,11],[11,12],[12,13],[13,14],[14,15],[15,16],[16,17],[17,18]]",
        ), ("f.txt", "0\n9\n1\n9\n1\n9\n1\n9\n1\n9\n1\n9\n1\n9\n1\n9\n1\n9\n1\n")])
        .answered("coface persistence path.json --vineyard f.txt")
        .cured(&[&["coface persistence path.json --vineyard f.txt --json"]]),
    Case::new("persistence/image_certificate.rs", "leave --certificate out, or give a small array of NumPy (.npy) or a grey map (.pgm)")
        .files(&[("image.pgm", "P2\n2 2\n9\n1 2\n3 4\n")])
        .refused("coface persistence image.pgm --periodic 0 --certificate image.cert")
        .cured(&[
            &["coface persistence image.pgm --periodic 0"],
            &["coface persistence image.pgm --certificate image.cert", "coface check image.cert image.pgm"],
        ]),
    Case::new("persistence/points_certificate.rs", "leave --certificate out, or give points or distances as rows of numbers")
        .files(POINTS)
        .refused("coface persistence points.csv --rips --distances upper --certificate points.cert")
        .cured(&[
            &["coface persistence points.csv --rips --distances upper"],
            &["coface persistence points.csv --rips --certificate points.cert", "coface check points.cert points.csv"],
        ]),
    Case::new("commands/diagram.rs", "all values with -o or --json")
        .files(&[("many.csv", "0 1\n2 3\n4 5\n6 7\n8 9\n10 11\n12 13\n14 15\n16 17\n18 19\n20 21\n")])
        .answered("coface diagram betti many.csv")
        .cured(&[&["coface diagram betti many.csv --json"]]),
    Case::new("commands/diagram.rs", "births x persistences; all with -o or --json")
        .files(TWO)
        .answered("coface diagram image a.csv --degree 0")
        .cured(&[&["coface diagram image a.csv --degree 0 --json"]]),
];
