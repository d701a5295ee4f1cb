//! What stands at the end of the help of each verb: one or two command lines, and what they give.

use clap::Command;

/// Verb, command line, what it gives. The lines of a verb stand together, in the order of its help.
const EXAMPLES: &[(&str, &str, &str)] = &[
    ("info", "coface info bunny.ply", "what it is, and what is wrong with it"),
    (
        "info",
        "coface info part.off --json --moment 1,0,0",
        "the same as data, with an integral of x over the volume",
    ),
    (
        "homology",
        "coface homology torus.off --generators -o loops.json",
        "the groups, and cycles that generate them",
    ),
    ("homology", "coface homology scan.obj --coefficients f2 --parts 8", "over two elements, in 8 parts"),
    ("check", "coface check answer.cert model.json", "whether the proof of an answer about model.json holds"),
    ("shard", "coface shard scan.msh --parts 64 -o shards", "64 files, each to be reduced alone"),
    ("reduce", "coface reduce shards", "all shards of a folder; give files to reduce some of them"),
    (
        "merge",
        "coface merge shards --generators loops.json",
        "the groups of the whole, and cycles on its cells",
    ),
    (
        "persistence",
        "coface persistence bunny.ply --function z -o heights.json",
        "by the height of the vertices",
    ),
    (
        "persistence",
        "coface persistence points.csv --alpha --min-persistence 0.1",
        "by balls that grow around points",
    ),
    ("diagram", "coface diagram distance a.json b.json", "how far two diagrams are from each other"),
    ("diagram", "coface diagram landscape a.json -o landscape.csv", "landscapes as columns of a table"),
    (
        "euler",
        "coface euler scan.nii -o curve.csv",
        "the Euler characteristic of the voxels up to each grey value",
    ),
    (
        "euler",
        "coface euler tooth.ply --directions 64 --normalize -o tooth.npy",
        "the Euler characteristic transform: a row of numbers for each direction",
    ),
    ("pi1", "coface pi1 poincare.json --simplify", "few generators and short relators"),
    ("loops", "coface loops torus.off --shortest -o loops.json", "the shortest generators at a vertex"),
    (
        "cycles",
        "coface cycles scan.off --kind non-contractible",
        "the shortest loop that cannot be contracted",
    ),
    ("cycles", "coface cycles scan.off --handles", "a handle loop and a tunnel loop for each handle"),
    (
        "homotopic",
        "coface homotopic mesh.off \"0 1 2 0\" \"5 6 7 5\"",
        "two closed walks, each by its vertices",
    ),
    ("subgroups", "coface subgroups poincare.json --index 5", "how many subgroups have an index up to 5"),
    ("cut", "coface cut torus.off -o disk.off", "cut open to a disk"),
    (
        "cut",
        "coface cut genus2.off --canonical --layout polygon -o octagon.off",
        "drawn as its canonical polygon",
    ),
    (
        "edit",
        "coface edit mesh.obj --flip 7 --log log.json -o flipped.obj",
        "edge 7 flipped, and a log of it",
    ),
    ("edit", "coface edit flipped.obj --undo log.json -o again.obj", "the edit undone"),
    (
        "isomorphic",
        "coface isomorphic a.json b.json",
        "whether only the names differ, and which name is which",
    ),
    (
        "simplify",
        "coface simplify lens.json -o small.json",
        "the same 3-manifold with fewer tetrahedra, and its name",
    ),
    ("cover", "coface cover torus.off --radius 3 -o cover.obj", "copies up to 3 steps away, laid out"),
    ("cover", "coface cover klein.off --orientation -o double.json", "the orientation double cover"),
    ("cocycles", "coface cocycles torus.off -o forms.json", "integers on edges, dual to loops"),
    ("cocycles", "coface cocycles torus.off --harmonic", "the forms of least energy in the same classes"),
    ("star", "coface star mesh.obj --simplices 17 --json", "all simplices with the vertex 17"),
    (
        "closure",
        "coface closure mesh.obj --simplices \"1 2; 7\" -o closure.json",
        "an edge with its ends, and a vertex",
    ),
    ("link", "coface link mesh.obj --simplices 17", "the ring around the vertex 17"),
    ("boundary", "coface boundary sheet.obj -o rim.obj", "the edges of one triangle only, and their ends"),
    ("interior", "coface interior sheet.obj", "all simplices that are not on the boundary"),
    ("skeleton", "coface skeleton solid.msh --dimension 1 -o wires.obj", "vertices and edges alone"),
    (
        "incidence",
        "coface incidence mesh.obj FE --signed -o fe.mtx",
        "which edges bound which faces, with signs",
    ),
    ("incidence", "coface incidence mesh.obj VV", "how many edges join two vertices"),
    (
        "congruence",
        "coface congruence parts.stl --tolerance 1e-6 -o whole.off",
        "vertices within 1e-6 become one",
    ),
    ("arrange", "coface arrange plan.svg -o rooms.json", "all faces that the lines enclose"),
    (
        "arrange",
        "coface arrange a.off b.off",
        "the cells that two solids cut space into, and what each lies in",
    ),
    ("boolean", "coface boolean difference block.off tool.off -o part.off", "the first without the others"),
    (
        "boolean",
        "coface boolean --formula \"(a | b) - c\" a.wkt b.wkt c.wkt",
        "any formula; inputs are a, b, c",
    ),
    ("map", "coface map repair parcels.geojson -o valid.geojson", "valid polygons in place of broken ones"),
    ("map", "coface map buffer roads.wkt --distance 2.5 -o zone.wkt", "everything within 2.5 of a road"),
    ("yin", "coface yin join a.json b.json -o both.json", "the union of two sets, with curves kept"),
    ("yin", "coface yin info drop.svg --order 4", "area, curves, kinks and how curves lie in each other"),
    ("generate", "coface generate torus --columns 16 --rows 8 -o torus.off", "a torus of 256 triangles"),
    ("generate", "coface generate lens --help", "the parameters of one family"),
    ("batch", "coface batch -r models -o table.csv", "a row for each file below a folder"),
    (
        "convert",
        "coface convert scan.ply --weld 1e-6 -o scan.off",
        "another format, with near vertices made one",
    ),
    ("convert", "coface convert bad.obj --repair -o good.obj", "made a surface where it is none"),
    ("view", "coface view mesh.obj -o mesh.html", "a page that any browser opens"),
    ("view", "coface view torus.off --with loops.json -o loops.html", "with the cycles of another answer"),
    ("render", "coface render mesh.obj --edges --size 800x600 -o mesh.png", "a picture with its edges"),
    ("render", "coface render torus.off --with loops.json -o loops.svg", "with the cycles of another answer"),
    ("completions", "coface completions bash", "the script, to be put where the shell looks for it"),
    ("man", "coface man -o man1", "a page for each verb in the folder man1"),
];

/// The command line with its examples at the end of the help of each verb.
pub(crate) fn with_examples(mut whole: Command) -> Command {
    let verbs: Vec<String> = whole.get_subcommands().map(|verb| verb.get_name().to_owned()).collect();
    for verb in verbs {
        if let Some(text) = text_of(&verb) {
            whole = whole.mut_subcommand(verb, |verb| verb.after_help(text));
        }
    }
    whole
}

/// The examples of a verb, each with what it gives on the line below.
fn text_of(verb: &str) -> Option<String> {
    let lines: Vec<String> = EXAMPLES
        .iter()
        .filter(|(of, ..)| *of == verb)
        .map(|(_, line, what)| format!("  {line}\n      {what}"))
        .collect();
    (!lines.is_empty()).then(|| format!("Examples:\n{}", lines.join("\n")))
}

#[cfg(test)]
mod tests {
    use super::{EXAMPLES, text_of};
    use crate::verbs::Arguments;
    use clap::Command;
    use clap::error::ErrorKind;

    /// The words of a line, as a shell has them; what stands between double quotes is one word.
    fn words(line: &str) -> Vec<String> {
        let mut words = Vec::new();
        for (i, part) in line.split('"').enumerate() {
            if i % 2 == 1 {
                words.push(part.to_owned());
            } else {
                words.extend(part.split_whitespace().map(str::to_owned));
            }
        }
        words
    }

    #[test]
    fn each_verb_has_one_or_two_examples_at_the_end_of_its_help() {
        let mut whole = Arguments::shaped();
        whole.build();
        let is_shown = |verb: &&mut Command| !verb.is_hide_set() && verb.get_name() != "help";
        for verb in whole.get_subcommands_mut().filter(is_shown) {
            let name = verb.get_name().to_owned();
            let count = EXAMPLES.iter().filter(|(of, ..)| *of == name).count();
            assert!((1..=2).contains(&count), "{name} has {count} examples");
            let text = text_of(&name).expect("it has examples");
            for help in [verb.render_help(), verb.render_long_help()] {
                assert!(help.to_string().trim_end().ends_with(&text), "{name}");
            }
        }
    }

    #[test]
    fn examples_are_command_lines_of_their_verbs() {
        for (verb, line, what) in EXAMPLES {
            assert!(line.len() <= 90 && what.len() <= 90, "{line}: too wide for a terminal");
            match Arguments::shaped().try_get_matches_from(words(line)) {
                Ok(matches) => assert_eq!(matches.subcommand_name(), Some(*verb), "{line}"),
                Err(error) => assert_eq!(error.kind(), ErrorKind::DisplayHelp, "{line}: {error}"),
            }
        }
    }

    #[test]
    fn quoted_words_are_one_word() {
        assert_eq!(
            words("coface link a.obj --simplices \"1 2; 7\" -q"),
            ["coface", "link", "a.obj", "--simplices", "1 2; 7", "-q"]
        );
    }
}
