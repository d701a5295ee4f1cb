//! Edits, their inverses, and logs.

use super::*;
use coface_io::Format;

fn editor(text: &str, format: Format) -> SurfaceEditor {
    SurfaceEditor::new(coface_io::read(text.as_bytes(), format).unwrap()).unwrap()
}

/// A strip of squares, two triangles each, closed to a ring of six.
fn grid() -> SurfaceEditor {
    let mut text = String::new();
    for y in 0..4 {
        for x in 0..5 {
            text += &format!("v {x} {y} 0\n");
        }
    }
    for y in 0..3 {
        for x in 0..4 {
            let a = 5 * y + x + 1;
            text += &format!("f {} {} {}\nf {} {} {}\n", a, a + 1, a + 6, a, a + 6, a + 5);
        }
    }
    editor(&text, Format::Obj)
}

fn all_edits(mesh: &HalfedgeMesh) -> Vec<Edit> {
    let mut edits = Vec::new();
    for edge in (0..mesh.edge_count()).map(CellName::of) {
        edits.push(Edit::FlipEdge { edge: edge.clone() });
        edits.push(Edit::FlipEdgeBack { edge: edge.clone() });
        edits.push(Edit::SplitEdge { edge: edge.clone() });
        edits.push(Edit::RemoveEdge { edge: edge.clone() });
        edits.push(Edit::ContractEdge { edge: edge.clone() });
        edits.push(Edit::CollapseEdge { edge });
    }
    edits.extend((0..mesh.face_count()).map(|face| Edit::PokeFace { face }));
    edits.extend((0..mesh.halfedge_count()).map(|h| {
        let h = HalfedgeId::new(h);
        let around = mesh.next(mesh.twin(h));
        split_vertex([h, around])
    }));
    edits
}

#[test]
fn each_edit_is_undone_by_its_inverse_and_by_the_log() {
    let torus = editor(r#"{"next": [2, 3, 4, 5, 0, 1]}"#, Format::Json);
    let disk =
        editor(r#"{"next": [1, 2, 0, 4, 5, 3], "twin": [null, null, 3, 2, null, null]}"#, Format::Json);
    let mut done = 0;
    for start in [grid(), torus, disk] {
        let numbers = |mesh: &HalfedgeMesh| (mesh.f_vector(), mesh.surface(), mesh.outer_face_count());
        for edit in all_edits(start.mesh()) {
            let mut editor = start.clone();
            let Ok(record) = editor.apply(&edit) else {
                assert_eq!(editor.mesh(), start.mesh(), "{edit:?} was refused, but changed the mesh");
                assert_eq!(editor.points, start.points);
                continue;
            };
            done += 1;
            editor.mesh().check().unwrap();
            assert_eq!(editor.mesh().surface(), start.mesh().surface(), "{edit:?}");
            assert_eq!(editor.points.len(), editor.dimension * editor.mesh().vertex_count(), "{edit:?}");
            let log = serde_json::to_string(&editor.log()).unwrap();
            let mut again = SurfaceEditor::of_log(serde_json::from_str(&log).unwrap()).unwrap();
            assert_eq!((again.mesh(), &again.points), (editor.mesh(), &editor.points), "{edit:?}");
            again.undo(1).unwrap();
            assert_eq!((again.mesh(), &again.points), (start.mesh(), &start.points), "{edit:?}");
            for inverse in &record.inverse {
                editor.apply(inverse).unwrap();
            }
            editor.mesh().check().unwrap();
            assert_eq!(numbers(editor.mesh()), numbers(start.mesh()), "{edit:?}");
        }
    }
    assert!(done > 300, "{done}");
}

#[test]
fn positions_follow_the_vertices() {
    let mut editor = grid();
    // Vertex 6 lies inside; its edge to 7 is collapsed, and the last vertex moves to 7.
    let record = editor.apply(&Edit::CollapseEdge { edge: "6 7".parse().unwrap() }).unwrap();
    assert_eq!(record.kept_vertex, Some(6));
    let model = editor.model().unwrap();
    assert_eq!((model.vertex_count(), model.polygons().len()), (19, 22));
    let at = |vertex| model.positions().point(VertexId::new(vertex)).to_vec();
    assert_eq!((at(6), at(7)), (vec![1.0, 1.0, 0.0], vec![4.0, 3.0, 0.0]));
    // It is a simplicial complex still, the same disk.
    let report = crate::Report::of(model).unwrap();
    assert_eq!(report.name(), Some("disk"));
}

#[test]
fn what_cannot_be_done_is_named() {
    let mut editor = grid();
    let mut fault = |edit: Edit| editor.apply(&edit).unwrap_err().to_string();
    let edge = |text: &str| text.parse::<CellName>().unwrap();
    assert!(fault(Edit::FlipEdge { edge: edge("0 1") }).contains("boundary"));
    assert!(fault(Edit::FlipEdge { edge: edge("0 19") }).contains("no edge joins vertices 0 and 19"));
    assert!(fault(Edit::SplitEdge { edge: edge("999") }).contains("there is no edge 999"));
    assert!(fault(Edit::RemoveVertex { vertex: 6 }).contains("v6"));
    let tetrahedron = "[[0,1,2],[0,2,3],[0,3,1],[1,3,2]]";
    let mut tetrahedron = self::editor(tetrahedron, Format::Json);
    let error = tetrahedron.apply(&Edit::CollapseEdge { edge: edge("0 1") }).unwrap_err().to_string();
    assert!(error.contains("cannot be collapsed"), "{error}");
}

#[test]
fn edited_halfedges_come_back_from_their_file() {
    let mut editor =
        editor(r#"{"next": [1, 2, 0, 4, 5, 3], "twin": [null, null, 3, 2, null, null]}"#, Format::Json);
    editor.apply(&Edit::FlipEdge { edge: CellName::of(2) }).unwrap();
    editor.apply(&Edit::SplitEdge { edge: CellName::of(0) }).unwrap();
    let mut bytes = Vec::new();
    coface_io::write(&editor.model().unwrap(), &mut bytes, Format::Json).unwrap();
    let again = coface_io::read(&bytes[..], Format::Json).unwrap();
    assert_eq!(again, editor.model().unwrap());
    assert_eq!(SurfaceEditor::new(again).unwrap().mesh().f_vector(), editor.mesh().f_vector());
}
