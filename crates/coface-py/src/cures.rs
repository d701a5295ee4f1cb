//! Cures in the words of Python: the library names commands and options of the program, and users of Python have functions and parameters.

/// What the program does by a command, and Python by a function.
const PHRASES: [(&str, &str); 58] = [
    ("coface convert INPUT --weld 0 -o OUT.off joins", "model.welded(0.0) joins"),
    ("coface view MODEL --with ANSWER shows both", "coface.view([model, answer]) shows both"),
    ("by ChainComplex::of_points", "by coface.ChainComplex.of_points(n)"),
    ("ask with HomologyRequest::certified(true)", "ask with generators=True"),
    (
        "take a skeleton of it: coface skeleton INPUT --dimension K -o OUT.json",
        "give its faces of the dimensions that are wanted",
    ),
    ("coface cover INPUT --orientation -o OUT.off", "model.surface().double_cover()"),
    ("draw the model by coface render INPUT -o OUT.png", "draw it by coface.render(model, \"png\")"),
    ("read it as an interface", "read it as an interface: coface.Interface.read(path)"),
    ("coface persistence POINTS --rips", "coface.rips(points)"),
    (
        "read it as a graph (--flag) or as distances (--rips)",
        "read it by coface.flag(path), or by coface.rips(scipy.io.mmread(path))",
    ),
    ("read a graph as one (--flag)", "read a graph by coface.flag(path)"),
    (
        "coface incidence INPUT VE --signed -o OUT.mtx writes",
        "scipy.io.mmwrite(\"out.mtx\", model.chain_complex().boundary(1)) writes",
    ),
    ("leave out --radii, or --weighted", "leave out radii, or weights"),
    ("give the range of values (--range A B)", "give values: at=array"),
    (
        "give a table with a row for each direction: --directions FILE",
        "give directions=array, with a row for each",
    ),
    ("(--births A B --persistences A B)", "(births=(a, b), persistences=(a, b))"),
    (
        "give a diagram that coface persistence INPUT -o DIAGRAM.json writes, or a table of births and deaths",
        "give a Persistence, or an array of births and deaths",
    ),
    ("--end T takes T for the death", "end=t takes t for the death"),
    ("leave --certificate out, or write the domain", "write the domain"),
    ("leave --certificate out, or give a facet list", "give the file of a facet list"),
    ("leave --certificate out, or give WKT", "give WKT"),
    ("leave --certificate out, or give points", "give points"),
    ("leave --certificate out, or give a small array", "give a small array"),
    ("keep exact coordinates with --exact", "keep exact coordinates with exact=True"),
    (
        "or say to which of them common points go",
        "or say to which of them common points go: overlaps=\"first\" or overlaps=\"last\"",
    ),
    ("by coface shard --force", "by replace=True"),
    ("coface convert VOLUME -o boundary.obj", "volume.to_model(surface=True)"),
    (
        "coface homology --parts N",
        "coface.shards.shard(model, folder, parts), then coface.shards.homology(folder)",
    ),
    ("coface homology --cohomology --harmonic", "coface.harmonic(model, degree=1)"),
    ("make it halfedges: coface convert INPUT -o OUT.halfedges.json", "give a mesh of polygons"),
    (
        "halfedges become facets by coface convert INPUT --triangulate -o OUT.json",
        "halfedges become facets by model.subdivided()",
    ),
    ("--keep-small keeps such curves", "keep_small=True keeps such curves"),
    ("repair it with coface yin normalize", "repair it with coface.Interface.read(path, rule=\"nonzero\")"),
    ("coface convert --orient", "model.repaired(orient=True)"),
    (
        "coface convert INPUT --repair -o OUT with that --weld",
        "model.welded(radius).repaired_surface().model",
    ),
    ("coface yin info INPUT -o OUT.dat", "coface.YinSet.from_model(model).write(\"out.dat\")"),
    ("coface shard INPUT -o FOLDER --parts N", "coface.shards.shard(model, folder, parts)"),
    ("coface convert, shard, reduce or merge has written", "model.write or coface.shards has written"),
    ("then coface reduce ", "then call coface.shards.homology of "),
    ("coface reduce ", "call coface.shards.homology of the folder of "),
    ("coface shard", "coface.shards.shard"),
    ("coface reduce", "coface.shards.homology"),
    ("coface yin compare A B", "a.compare(b)"),
    ("coface yin", "coface.YinSet"),
    ("--order 2 --flatten LENGTH", "order=2, flatten=LENGTH"),
    ("(--all lists", "(limit= lists"),
    ("--non-planar split", "split=True"),
    ("--force", "replace=True"),
    ("convert the model without --triangulate", "take it as it is: only the others need model.subdivided()"),
    ("convert the model without --truncate", "take it as it is"),
    (
        ", which coface convert --truncate writes; --pseudomanifold takes",
        "; coface.read(path, pseudomanifold=True) takes",
    ),
    ("print the set with --json", "take its simplices(k)"),
    ("themselves, with LarModel::with_facets", "too, all of them"),
    (
        "close it first: coface convert INPUT --repair closed -o OUT.off",
        "close it first: model.repaired_surface(closed=True).model",
    ),
    ("leave --handles out: coface cycles INPUT", "ask for other paths: model.surface().shortest_cycles()"),
    (
        "make it the boundary of a solid first: coface boolean union INPUT --pinches split -o OUT.off",
        "make it the boundary of a solid first: coface.boolean(\"union\", [model], split_pinches=True)",
    ),
    (
        "split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT",
        "split it first: model.repaired(split_edges=\"pairs\", split_vertices=True)",
    ),
    (
        "give the JSON of homology --generators, cut, cover -o, pi1 --loops, cycles, cocycles, arrange, persistence, star, link, .., or a chain as [[coefficient,[vertices..]],..]",
        "give an answer of coface.homology(model, generators=True), coface.cut, cover, pi1, cocycles, arrange, persistence, .., or a list of coefficients with vertices",
    ),
];

/// The options whose values are words, and those words. No words stand for any.
const WORDS: [(&str, &[&str]); 7] = [
    ("collisions", &["keep", "rewrap", "refuse"]),
    ("distances", &["points", "lower", "upper", "square", "sparse"]),
    ("rule", &["nonzero", "evenodd", "positive"]),
    ("inputs", &["files", "features", "objects", "groups", "components"]),
    ("open", &["refuse", "close"]),
    ("check", &["usual", "geometry", "topology"]),
    ("format", &[]),
];

/// The options that are on or off.
const FLAGS: [&str; 8] =
    ["close", "snap", "partial", "strict", "allow-outside", "orient", "keep-walls", "prune"];

/// A message with the options that it names as the parameters of functions: `--rule evenodd` is `rule="evenodd"`, `--all-places` is
/// `all_places`, `--snap` is `snap=True`, and commands are functions.
pub(crate) fn in_python(message: &str) -> String {
    let mut message = message.to_owned();
    for (phrase, ours) in PHRASES {
        if message.contains(phrase) {
            message = message.replace(phrase, ours);
        }
    }
    let mut text = String::with_capacity(message.len());
    let mut parts = message.split(' ').peekable();
    // The words that may go on a list of values: `--rule nonzero, evenodd or positive`.
    let mut listed: &[&str] = &[];
    let mut is_first = true;
    while let Some(part) = parts.next() {
        if !is_first {
            text.push(' ');
        }
        is_first = false;
        let is_word = |name: &str| name.starts_with(|c: char| c.is_ascii_lowercase());
        let Some((before, rest)) =
            part.split_once("--").filter(|(before, name)| before.len() < 2 && is_word(name))
        else {
            let (word, end) = split_end(part);
            if listed.contains(&word) {
                text.extend(["\"", word, "\"", end]);
            } else {
                listed = if matches!(part, "or" | "and") { listed } else { &[] };
                text.push_str(part);
            }
            continue;
        };
        let (option, end) = split_end(rest);
        let is_named_only = text.ends_with("leave out ") || text.ends_with("unless ");
        text.extend([before, &option.replace('-', "_")]);
        let next = parts.peek().map(|next| split_end(next)).filter(|_| end.is_empty());
        let words = WORDS.iter().find(|(name, _)| *name == option).map(|(_, words)| *words);
        match (next, words) {
            (Some((value, value_end)), Some(words))
                if words.contains(&value) || words.is_empty() && is_name(value) =>
            {
                text.extend(["=\"", value, "\"", value_end]);
                listed = words;
                parts.next();
            }
            (Some((value, value_end)), None) if value.parse::<f64>().is_ok() || is_placeholder(value) => {
                text.extend(["=", value, value_end]);
                parts.next();
            }
            _ => {
                if FLAGS.contains(&option) && !is_named_only {
                    text.push_str("=True");
                }
                text.push_str(end);
            }
        }
    }
    text
}

/// A word, and the marks behind it.
fn split_end(part: &str) -> (&str, &str) {
    part.split_at(part.trim_end_matches([',', ';', ')', ':', '.']).len())
}

/// A format by its name.
fn is_name(value: &str) -> bool {
    !matches!(value, "" | "is" | "or" | "out")
        && value.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit())
}

/// A value that the user has to say.
fn is_placeholder(value: &str) -> bool {
    value.len() > 1 && value.chars().all(|c| c.is_ascii_uppercase())
}
