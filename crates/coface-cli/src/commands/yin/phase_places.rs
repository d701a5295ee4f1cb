//! What is shown of places on and around the edges of an interface.

use super::places::{LISTED, cell, more, place};
use coface::answers::answer::{
    YinBendPlace, YinInterfaceComparisonAnswer, YinInterfaceCurvatureAnswer, YinInterfaceLocateAnswer,
    YinInterfaceSampleAnswer, YinLocation,
};
use coface::answers::text;
use std::fmt::Write;

/// A whole number of a table; nothing if there is none.
fn whole(number: Option<impl ToString>) -> String {
    number.map_or(String::new(), |number| number.to_string())
}

/// What lies on a side of an edge.
fn side(phase: Option<u32>) -> String {
    phase.map_or("outside".to_owned(), |phase| format!("phase {phase}"))
}

pub(super) fn located_table(answer: &YinInterfaceLocateAnswer) -> String {
    let mut table = "x,y,location,phases,distance,nearest_x,nearest_y,edge,piece,parameter\n".to_owned();
    for found in &answer.points {
        let [x, y] = found.point;
        let phases: Vec<String> = found.phases.iter().map(u32::to_string).collect();
        // Writing to a string does not fail.
        let _ = writeln!(
            table,
            "{x:?},{y:?},{},{},{},{},{},{},{},{}",
            found.location.word(),
            phases.join(" "),
            cell(found.distance),
            cell(found.nearest.map(|[x, _]| x)),
            cell(found.nearest.map(|[_, y]| y)),
            whole(found.edge),
            whole(found.piece),
            cell(found.parameter)
        );
    }
    table
}

pub(super) fn located_page(answer: &YinInterfaceLocateAnswer) -> String {
    let mut facts = Vec::new();
    for phase in answer.phases.iter().filter(|phase| phase.inside > 0).take(LISTED) {
        facts.push((format!("in {}", phase.name), text::grouped(phase.inside), String::new()));
    }
    facts.push(("on edges".to_owned(), text::grouped(answer.boundary), String::new()));
    facts.push(("in no phase".to_owned(), text::grouped(answer.outside), String::new()));
    for (number, found) in answer.points.iter().enumerate().take(LISTED) {
        let label = if number == 0 { "point by point" } else { "" };
        let names: Vec<&str> =
            found.phases.iter().map(|&phase| answer.phases[phase as usize].name.as_str()).collect();
        let where_it_is = match found.location {
            YinLocation::Inside => format!("in {}", names.join(", ")),
            YinLocation::Boundary => format!("on an edge of {}", names.join(", ")),
            YinLocation::Outside => "in no phase".to_owned(),
        };
        let gloss = match (found.nearest, found.distance, found.edge) {
            (Some(nearest), Some(distance), Some(edge)) => {
                format!("distance {} from {} of edge {edge}", text::number(distance), place(nearest))
            }
            _ => "there are no edges".to_owned(),
        };
        facts.push((label.to_owned(), format!("{}: {where_it_is}", place(found.point)), gloss));
    }
    more(&mut facts, answer.points.len());
    text::facts("Location", &facts)
}

pub(super) fn sample_table(answer: &YinInterfaceSampleAnswer) -> String {
    let mut table = "edge,left,right,piece,parameter,length,x,y,tangent_x,tangent_y,curvature\n".to_owned();
    for sample in &answer.samples {
        let [x, y] = sample.point;
        // Writing to a string does not fail.
        let _ = writeln!(
            table,
            "{},{},{},{},{:?},{:?},{x:?},{y:?},{},{},{}",
            sample.edge,
            whole(sample.left),
            whole(sample.right),
            sample.piece,
            sample.parameter,
            sample.length,
            cell(sample.tangent.map(|[x, _]| x)),
            cell(sample.tangent.map(|[_, y]| y)),
            cell(sample.curvature)
        );
    }
    table
}

pub(super) fn sample_page(answer: &YinInterfaceSampleAnswer) -> String {
    let mut facts = vec![("points".to_owned(), text::grouped(answer.samples.len()), String::new())];
    for (number, sample) in answer.samples.iter().enumerate().take(LISTED) {
        let label = if number == 0 { "point by point" } else { "" };
        let curvature = sample
            .curvature
            .map_or("no direction".to_owned(), |curvature| format!("curvature {}", text::number(curvature)));
        let gloss = format!(
            "edge {} between {} and {}, length {}, {curvature}",
            sample.edge,
            side(sample.left),
            side(sample.right),
            text::number(sample.length)
        );
        facts.push((label.to_owned(), place(sample.point), gloss));
    }
    more(&mut facts, answer.samples.len());
    text::facts("Samples", &facts)
}

pub(super) fn curvature_page(answer: &YinInterfaceCurvatureAnswer) -> String {
    let at = |found: &YinBendPlace| format!("{} at {}", text::number(found.value), place(found.point));
    let mut facts = Vec::new();
    for bend in answer.edges.iter().take(LISTED) {
        let between = format!("between {} and {}", side(bend.left), side(bend.right));
        facts.push((format!("edge {}", bend.edge), format!("least {}", at(&bend.least)), between));
        facts.push((String::new(), format!("greatest {}", at(&bend.greatest)), String::new()));
        if let Some(sharpest) = &bend.sharpest {
            let gloss = "degrees, at a knot between its ends".to_owned();
            facts.push((String::new(), format!("turns {}", at(sharpest)), gloss));
        }
    }
    more(&mut facts, answer.edges.len());
    text::facts("Curvature", &facts)
}

pub(super) fn comparison_page(answer: &YinInterfaceComparisonAnswer) -> String {
    let real = |number: Option<f64>| number.map_or("infinite".to_owned(), text::number);
    let [first, second] = answer.junctions.map(text::grouped);
    let mut facts = vec![
        (
            "area of a xor b".to_owned(),
            real(answer.area_xor),
            format!("of all phases, off by at most about {}", text::rounded(answer.area_xor_error, 1)),
        ),
        ("junctions".to_owned(), format!("{first} and {second}"), String::new()),
    ];
    for phase in answer.phases.iter().take(LISTED) {
        let sets = &phase.sets;
        let label = match &sets.files[..] {
            [a, b] if a != b => format!("{a}, {b}"),
            names => names[0].clone(),
        };
        let area = format!("area of xor {}", real(sets.area_xor));
        facts.push((label, area, format!("Hausdorff distance {}", real(sets.hausdorff))));
    }
    more(&mut facts, answer.phases.len());
    text::facts("Comparison", &facts)
}
