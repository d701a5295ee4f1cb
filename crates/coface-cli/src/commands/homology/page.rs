//! What people read of an answer on homology.

use coface::algebra::escaped;
use coface::answers::CellNames;
use coface::answers::answer::{
    ChainTerm, CupProducts, CycleClass, GeneratorAnswer, HarmonicCochain, HodgeParts, HomologyAnswer,
    HomologyGroup, InducedMaps, IntersectionFormAnswer, SequenceAnswer, SequenceMap, WholeNumber,
};
use std::path::Path;

/// Everything below the groups. Cycles and the decomposed cochain are named as the command line names them.
pub(super) fn details(
    answer: &HomologyAnswer,
    names: Option<CellNames<'_>>,
    cycles: &[String],
    decomposed: Option<&Path>,
) -> String {
    let mut page = String::new();
    if let (Some(generators), Some(names)) = (&answer.generators, names) {
        page += &list(generators, answer.cohomology, names);
    }
    for group in answer.physical_groups.iter().flatten() {
        let tag = group.tag.map_or(String::new(), |tag| format!(" {tag}"));
        let elements = coface::answers::text::count(group.elements, "element");
        page += &format!("    written as group{tag} \"{}\": {elements}\n", group.name);
    }
    for (argument, class) in cycles.iter().zip(answer.cycles.iter().flatten()) {
        page += &format!("    {argument}: {}\n", words_of_class(class));
    }
    page += &answer.sequence.as_ref().map_or(String::new(), sequence);
    page += &answer.cup.as_ref().map_or(String::new(), cup);
    page += &answer.intersection_form.as_ref().map_or(String::new(), form);
    page += &answer.harmonic.as_ref().map_or(String::new(), |degrees| harmonic(degrees));
    if let (Some(parts), Some(file)) = (&answer.decomposition, decomposed) {
        page += &decomposition(parts, file);
    }
    page + &answer.map.as_ref().map_or(String::new(), induced)
}

/// One line for each generator, with its cells if they are few.
fn list(generators: &[Vec<GeneratorAnswer>], is_cohomology: bool, names: CellNames<'_>) -> String {
    const MOST_CELLS: usize = 8;
    let what = if is_cohomology { "cocycle" } else { "cycle" };
    let mut page = String::new();
    for (degree, list) in generators.iter().enumerate() {
        for (i, found) in list.iter().enumerate() {
            let order =
                if found.order.is_zero() { String::new() } else { format!(" of order {}", found.order) };
            let length = &found.length;
            let cells = if *length == WholeNumber::Number(1) { "cell" } else { "cells" };
            page += &format!(
                "    generator {} of degree {degree}: a {what}{order}, length {length} {cells}",
                i + 1
            );
            if found.chain.len() <= MOST_CELLS {
                let term = |(x, vertices): &ChainTerm| {
                    let word = names.word_of(vertices);
                    match x.to_string().as_str() {
                        "1" => format!("+{word}"),
                        "-1" => format!("-{word}"),
                        x if x.starts_with('-') => format!("{x} {word}"),
                        x => format!("+{x} {word}"),
                    }
                };
                let terms: Vec<String> = found.chain.iter().map(term).collect();
                page += &format!(": {}", terms.join(" "));
            }
            page.push('\n');
        }
    }
    page
}

fn words_of_class(class: &CycleClass) -> String {
    let cells = class.bounding.as_ref().map_or(0, Vec::len);
    let words = match (&class.value, class.bounds, &class.multiple) {
        (Some(value), ..) => {
            format!("does not bound, nor does any multiple: a cocycle has the value {value} on it")
        }
        (None, true, _) => format!("bounds a chain of {cells} cells"),
        (None, false, Some(multiple)) => {
            format!("does not bound, {multiple} times it bounds a chain of {cells} cells")
        }
        (None, false, None) => "of unknown kind".to_owned(),
    };
    format!("class ({}) in H_{}; it {words}", joined(&class.class, ", "), class.degree)
}

fn joined(numbers: &[WholeNumber], separator: &str) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(separator)
}

/// A small matrix by columns, or its size.
fn words_of_map(columns: &[Vec<WholeNumber>]) -> String {
    const MOST: usize = 8;
    let (from, to) = (columns.len(), columns.first().map_or(0, Vec::len));
    if columns.iter().flatten().all(WholeNumber::is_zero) {
        return "zero".to_owned();
    }
    if from > MOST || to > MOST {
        return format!("{from} generators to {to}, see --json");
    }
    columns.iter().map(|column| format!("({})", joined(column, " "))).collect::<Vec<_>>().join(" ")
}

/// What is known of a map: nothing of one from or to zero that its group does not say.
fn kind_of_map(map: &SequenceMap) -> String {
    let words = match (map.injective, map.surjective) {
        (true, true) => "isomorphism",
        (true, false) => "injective",
        (false, true) => "surjective",
        (false, false) => "",
    };
    let rank = if map.image.betti + map.image.torsion.len() == 0 {
        String::new()
    } else {
        format!(", image {}", map.image)
    };
    if words.is_empty() { rank } else { format!("{rank}, {words}") }
}

fn sequence(sequence: &SequenceAnswer) -> String {
    let mut page =
        "  long exact sequence, checked to be exact; columns are images of generators\n".to_owned();
    let group = |groups: &[HomologyGroup], degree: usize| {
        groups.get(degree).map_or("0".to_owned(), ToString::to_string)
    };
    for degree in (0..sequence.complex.len()).rev() {
        let below = degree.checked_sub(1).map_or("0".to_owned(), |below| format!("H_{below}(L)"));
        for (name, groups, maps, known, next) in [
            ("L", &sequence.subcomplex, &sequence.inclusion, "inclusion", format!("H_{degree}(K)")),
            ("K", &sequence.complex, &sequence.projection, "projection", format!("H_{degree}(K, L)")),
            ("K, L", &sequence.pair, &sequence.connecting, "connecting", below),
        ] {
            let map = maps.get(degree).and_then(Option::as_ref);
            let known = sequence.maps.iter().find(|map| map.map == known && map.degree == degree);
            let kind = known.map_or(String::new(), kind_of_map);
            let arrow = map.map_or(String::new(), |map| format!(" -> {next}: {}{kind}", words_of_map(map)));
            page += &format!("    H_{degree}({name}) = {}{arrow}\n", group(groups, degree));
        }
    }
    page
}

fn cup(products: &CupProducts) -> String {
    let [p, q] = products.degrees;
    let mut page = format!("  cup products of degrees {p} and {q}, in the basis of H^{}\n", p + q);
    let mut is_zero = true;
    for (i, row) in products.table.iter().enumerate() {
        for (j, x) in row.iter().enumerate().filter(|(_, x)| !x.iter().all(WholeNumber::is_zero)) {
            is_zero = false;
            page += &format!("    a{i} b{j} = ({})\n", joined(x, " "));
        }
    }
    if is_zero {
        page += "    all products are zero\n";
    }
    page
}

fn form(form: &IntersectionFormAnswer) -> String {
    let mut words = format!("rank {}, determinant {}", form.rank, form.determinant);
    match (form.signature, &form.parity) {
        (Some(signature), Some(parity)) => {
            words += &format!(", signature {signature}, {parity}");
            words += &form.name.as_ref().map_or(String::new(), |name| format!(", {name}"));
        }
        _ => words += ", skew",
    }
    format!("  intersection form: {words}\n")
}

fn harmonic(degrees: &[Vec<HarmonicCochain>]) -> String {
    let mut page = "  harmonic cochains, dual to the free generators\n".to_owned();
    for (degree, list) in degrees.iter().enumerate() {
        for (i, cochain) in list.iter().enumerate() {
            page += &format!(
                "    cochain {i} of degree {degree}: norm {:.6}, residuals {:.1e} closed, {:.1e} coclosed\n",
                cochain.norm, cochain.closed_residual, cochain.coclosed_residual
            );
        }
    }
    page
}

fn decomposition(parts: &HodgeParts, file: &Path) -> String {
    let norms = &parts.norms;
    format!(
        "  Hodge decomposition of {}, of degree {} and norm {:.6}\n    \
         exact part: norm {:.6}\n    coexact part: norm {:.6}\n    harmonic part: norm {:.6}\n",
        escaped(&file.display().to_string()),
        parts.degree,
        norms.cochain,
        norms.exact,
        norms.coexact,
        norms.harmonic
    )
}

fn induced(maps: &InducedMaps) -> String {
    let mut page = format!("  induced map to {}; columns are images of generators\n", maps.target);
    for map in &maps.degrees {
        page += &format!(
            "    H_{}: {}; kernel {}, cokernel {}\n",
            map.degree,
            words_of_map(&map.matrix),
            map.kernel,
            map.cokernel
        );
    }
    page
}
