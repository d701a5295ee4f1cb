//! Rows of signatures as tables have them: one value a column.

use super::SignatureRow;
use crate::tables::{Cell, Column, Kind};
use coface_answers::SignatureRequest;
use coface_answers::answer::{PresentedGroup, SignatureAnswer};
use std::fmt::Display;

/// Tables of signatures have this dimension.
const DIMENSION: usize = 3;

/// The columns of all rows of a request.
pub(super) fn columns(request: SignatureRequest) -> Vec<Column> {
    let mut columns: Vec<Column> = [
        ("path", Kind::Text),
        ("line", Kind::Whole),
        ("name", Kind::Text),
        ("signature", Kind::Text),
        ("error_kind", Kind::Text),
        ("error_message", Kind::Text),
        ("error_cure", Kind::Text),
    ]
    .map(|(name, kind)| Column::new(name, kind))
    .to_vec();
    let mut numbered = |stem: &str, kind: Kind| {
        columns.extend((0..=DIMENSION).map(|degree| Column::new(format!("{stem}_{degree}"), kind)));
    };
    numbered("f", Kind::Whole);
    numbered("betti", Kind::Whole);
    numbered("torsion", Kind::Text);
    let facts = [
        ("components", Kind::Whole),
        ("closed", Kind::Flag),
        ("ideal_vertices", Kind::Whole),
        ("euler_characteristic", Kind::Whole),
        ("manifold", Kind::Text),
        ("witness", Kind::Text),
        ("orientable", Kind::Flag),
    ];
    columns.extend(facts.map(|(name, kind)| Column::new(name, kind)));
    if request.has_names() {
        columns.extend(["space", "space_proof"].map(|name| Column::new(name, Kind::Text)));
    }
    if request.has_groups() {
        let groups = ["group", "group_generators", "group_relators"];
        columns.extend(groups.map(|name| Column::new(name, Kind::Text)));
    }
    columns
}

/// The values of a row in these columns.
pub(super) fn values(row: &SignatureRow, request: SignatureRequest) -> Vec<Cell> {
    let fault = row.outcome.as_ref().err();
    let answer = row.answer();
    let mut cells: Vec<Cell> = vec![
        row.path.as_str().into(),
        row.line.into(),
        row.name.as_deref().into(),
        row.signature.as_deref().into(),
        fault.map(|fault| fault.kind.as_str()).into(),
        fault.map(|fault| fault.message.as_str()).into(),
        fault.and_then(|fault| fault.cure.as_deref()).into(),
    ];
    let group = |degree: usize| answer.and_then(|answer| answer.homology.get(degree));
    let count = |degree: usize| answer.and_then(|answer| answer.f_vector.get(degree)).copied();
    cells.extend((0..=DIMENSION).map(|degree| Cell::from(count(degree))));
    cells.extend((0..=DIMENSION).map(|degree| Cell::from(group(degree).map(|group| group.betti))));
    cells.extend(
        (0..=DIMENSION).map(|degree| Cell::from(group(degree).map(|group| joined(&group.torsion, " ")))),
    );
    let fact = |value: fn(&SignatureAnswer) -> Cell| answer.map_or(Cell::Nothing, value);
    cells.extend([
        fact(|answer| answer.components.into()),
        fact(|answer| answer.closed.into()),
        fact(|answer| answer.ideal_vertices.into()),
        fact(|answer| answer.euler_characteristic.into()),
        fact(|answer| answer.manifold.as_str().into()),
        fact(|answer| answer.witness.as_deref().into()),
        fact(|answer| answer.orientable.into()),
    ]);
    if request.has_names() {
        let space = answer.and_then(|answer| answer.space.as_ref()?.as_ref());
        cells.push(space.map(|space| space.name.as_str()).into());
        cells.push(space.map(|space| space.proof.as_str()).into());
    }
    if request.has_groups() {
        let groups = answer.and_then(|answer| answer.groups.as_deref());
        let listed = |value: fn(&PresentedGroup) -> String| {
            Cell::from(groups.map(|groups| joined(&groups.iter().map(value).collect::<Vec<_>>(), "; ")))
        };
        cells.extend([
            listed(|group| group.name.clone().unwrap_or_default()),
            listed(|group| group.generators.to_string()),
            listed(|group| serde_json::to_string(&group.relators).expect("numbers are JSON")),
        ]);
    }
    cells
}

/// Items as one text.
fn joined<T: Display>(items: &[T], separator: &str) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<_>>().join(separator)
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io::SignatureLines;

    #[test]
    fn each_row_has_a_value_a_column() {
        let list = b"cMcabbjak\tL(3,1)\ncPcbbbiht\nnone of them\n";
        for request in [SignatureRequest::new(), SignatureRequest::new().groups(true).names(true)] {
            let names: Vec<String> = columns(request).into_iter().map(|column| column.name).collect();
            let mut found = Vec::new();
            for line in SignatureLines::new(&list[..]) {
                let row = SignatureRow::of_line("list.sig", &line.unwrap(), request);
                let cells = values(&row, request);
                assert_eq!(cells.len(), names.len());
                found.push(cells);
            }
            let at = |name: &str| names.iter().position(|other| other == name).unwrap();
            assert_eq!(found[0][at("name")], "L(3,1)".into());
            assert_eq!(found[0][at("torsion_1")], "3".into());
            assert_eq!(found[1][at("betti_1")], 1_u64.into());
            assert_eq!(found[2][at("error_kind")], "parse".into());
            assert_eq!(found[2][at("line")], 3_u64.into());
            if request.has_groups() {
                assert_eq!(found[0][at("group")], "Z/3".into());
                assert_eq!(found[0][at("space")], "L(3,1)".into());
            }
        }
    }
}
