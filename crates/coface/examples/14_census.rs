//! Guide 14: a census of 3-manifolds: signatures, names with proofs, groups, and a table of many at once.
//!
//! Run with `cargo run -p coface --example 14_census`.

use coface::algebra::RaggedArray;
use coface::complexes::gluing::GluingTable;
use coface::complexes::known_spaces::lens_space;
use coface::scale::batch::TableFormat;
use coface::scale::signatures::SignatureBatch;
use coface::topology::{EdgePathGroups, Effort, named_space, simplified};
use coface::{Error, homology};

/// What a census has about a triangulation: its name, its first homology, and its fundamental group.
fn entry(table: &GluingTable) -> Result<[String; 3], Error> {
    let faces = table.faces()?;
    let name = named_space(table, &faces, 60)?.map_or("?".to_owned(), |space| space.name().to_string());
    let homology = homology(&faces.chain_complex()?).groups()[1].to_string();
    let group = EdgePathGroups::new(&faces.two_skeleton()?);
    let group = group.presentation(0).recognized(Effort::default());
    Ok([name, homology, group.map_or("?".to_owned(), |group| group.to_string())])
}

fn main() -> Result<(), Error> {
    // A signature is a whole triangulation in a word, as in Regina. Each of these is of one or two tetrahedra.
    for (signature, known) in [
        ("bkaagb", ["S3", "0", "trivial"]),
        ("cMcabbjak", ["L(3,1)", "Z/3", "Z/3"]),
        ("cMcabbjxr", ["L(5,1)", "Z/5", "Z/5"]),
        ("cMcabbjqs", ["L(8,3)", "Z/8", "Z/8"]),
    ] {
        let table = GluingTable::from_isomorphism_signature(signature, 3)?;
        assert_eq!(entry(&table)?, known, "{signature}");
        // The same word comes back, whatever the numbers of tetrahedra and vertices were.
        assert_eq!(table.isomorphism_signature()?, signature);
    }

    // From a list of simplices: a lens space that was made with many tetrahedra becomes one of two, whose signature tells which.
    let facets: Vec<Vec<u32>> = lens_space(5, 1)?
        .facets()
        .iter()
        .map(|simplex| simplex.vertices().map(|vertex| vertex.index() as u32).collect())
        .collect();
    let large = GluingTable::from_simplices(&RaggedArray::from_lists(facets))?;
    let small = simplified(&large, 20)?.into_table();
    assert!(small.simplex_count() < large.simplex_count());
    assert_eq!(entry(&small)?, ["L(5,1)", "Z/5", "Z/5"]);

    // A vertex of a closed manifold has a sphere around it. The complement of the figure-eight knot has one ideal vertex, whose link is a torus.
    // Truncated there it is a manifold with boundary, and its first homology is Z, as for the complement of any knot.
    let knot = GluingTable::from_isomorphism_signature("cPcbbbiht", 3)?;
    let faces = knot.faces()?;
    assert_eq!((knot.simplex_count(), knot.ideal_vertices(&faces)?.len()), (2, 1));
    let outside = knot.truncated(&faces)?.faces()?;
    assert_eq!(homology(&outside.chain_complex()?).betti_numbers(), [1, 1, 0, 0]);

    // Many at once: a row for each line, and a line that is no signature costs its own row only.
    let folder = tempfile::tempdir()?;
    let (list, out) = (folder.path().join("census.sig"), folder.path().join("census.csv"));
    std::fs::write(&list, "bkaagb sphere\ncMcabbjak\nno signature\n")?;
    let summary = SignatureBatch::new(vec![list]).write(&out, TableFormat::Csv)?;
    assert_eq!((summary.files(), summary.error_count()), (3, 1));
    let table = std::fs::read_to_string(&out)?;
    assert_eq!(table.lines().count(), 1 + 3);
    Ok(())
}
