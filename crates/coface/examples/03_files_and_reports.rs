//! Guide 3: from a file to a report, and to another format.
//!
//! Run with `cargo run -p coface --example 03_files_and_reports`.

use coface::answers::{Answer, Report};
use coface::complexes::surface::PolygonMesh;
use coface::io;
use coface::io::Format;
use coface::topology::homology;

fn main() -> Result<(), coface::Error> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/spot.obj");
    let model = io::read_path(path, None)?;
    assert_eq!((model.vertex_count(), model.polygons().len()), (2930, 5856));

    // The producer by hand: edges are identified, and the chain complex can be asked.
    let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[])?;
    assert_eq!(mesh.f_vector(), [2930, 8784, 5856]);
    assert_eq!(homology(&mesh.chain_complex()?).betti_numbers(), [1, 0, 1]);

    // Any format that can hold it: written to memory here, to a file with io::write_path.
    let mut bytes = Vec::new();
    io::write(&model, &mut bytes, Format::Off)?;
    let again = io::read(&bytes[..], Format::Off)?;
    assert_eq!(again.polygons(), model.polygons());
    assert_eq!(again.positions(), model.positions());

    // Everything that `coface info` says, as data.
    let report = Report::of(model)?;
    assert_eq!(report.manifold(), Answer::Yes);
    assert_eq!(report.name(), Some("sphere"));

    // A fault names its place and its cure.
    let error =
        io::read(&b"v 0 0 0\nv 1 0 0\nf 1 2 3\n"[..], Format::Obj).expect_err("there are two vertices");
    assert_eq!(
        error.to_string(),
        "line 3: vertex index 3, but there are 2 vertices, numbered from 1; correct the index or add the vertices"
    );
    Ok(())
}
