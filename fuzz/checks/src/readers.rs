//! Readers of files: any bytes make a sound model or an error, and what is written of a model is read as the same model.

use crate::models::{check_model, check_round};
use coface::io::matrix_market::{self, MatrixField};
use coface::io::{
    FlagReading, Format, ReadOptions, VolumeReading, VoxelRule, read, read_unknown as read_guessed,
    read_with, write,
};

/// Gives the bytes to the reader of a format; what it makes of them is written and read again.
fn check_reader(bytes: &[u8], format: Format) {
    if let Ok(model) = read(bytes, format) {
        check_model(&model);
        if !format.is_read_only() {
            check_round(&model, format);
        }
    }
}

/// The reader of OFF.
pub fn read_off(bytes: &[u8]) {
    check_reader(bytes, Format::Off);
}

/// The reader of OBJ.
pub fn read_obj(bytes: &[u8]) {
    check_reader(bytes, Format::Obj);
}

/// The reader of PLY.
pub fn read_ply(bytes: &[u8]) {
    check_reader(bytes, Format::Ply);
}

/// The reader of STL.
pub fn read_stl(bytes: &[u8]) {
    check_reader(bytes, Format::Stl);
}

/// The reader of MEDIT meshes.
pub fn read_mesh(bytes: &[u8]) {
    check_reader(bytes, Format::Medit);
}

/// The reader of Gmsh MSH.
pub fn read_msh(bytes: &[u8]) {
    check_reader(bytes, Format::Msh);
}

/// The reader of legacy VTK.
pub fn read_vtk(bytes: &[u8]) {
    check_reader(bytes, Format::Vtk);
}

/// The reader of VTK XML.
pub fn read_vtk_xml(bytes: &[u8]) {
    check_reader(bytes, Format::VtkGrid);
}

/// The reader of JSON: facet lists, halfedges, gluings, chain complexes, polygons; one value or one a line.
pub fn read_json(bytes: &[u8]) {
    check_reader(bytes, Format::Json);
}

/// The reader of isomorphism signatures.
pub fn read_isosig(bytes: &[u8]) {
    check_reader(bytes, Format::Isosig);
}

/// The reader of segments as text.
pub fn read_lines(bytes: &[u8]) {
    check_reader(bytes, Format::Lines);
}

/// The reader of GeoJSON and TopoJSON, one value or one a line.
pub fn read_geojson(bytes: &[u8]) {
    check_reader(bytes, Format::GeoJson);
}

/// The reader of WKT.
pub fn read_wkt(bytes: &[u8]) {
    check_reader(bytes, Format::Wkt);
}

/// The reader of glTF and GLB. The lengths in the header of a GLB are made right, so that what is behind them is read.
pub fn read_gltf(bytes: &[u8]) {
    let mut bytes = bytes.to_vec();
    if bytes.starts_with(b"glTF") && bytes.len() >= 20 {
        let length = bytes.len() as u32;
        bytes[8..12].copy_from_slice(&length.to_le_bytes());
    }
    check_reader(&bytes, Format::Gltf);
}

/// The reader of COLLADA.
pub fn read_collada(bytes: &[u8]) {
    check_reader(bytes, Format::Collada);
}

/// The reader of AMF.
pub fn read_amf(bytes: &[u8]) {
    check_reader(bytes, Format::Amf);
}

/// The reader of Abaqus input.
pub fn read_abaqus(bytes: &[u8]) {
    check_reader(bytes, Format::Abaqus);
}

/// The reader of the text files of TetGen.
pub fn read_tetgen(bytes: &[u8]) {
    check_reader(bytes, Format::TetGen);
}

/// The reader of points as text.
pub fn read_points(bytes: &[u8]) {
    check_reader(bytes, Format::Points);
}

/// The reader of `.npy`.
pub fn read_npy(bytes: &[u8]) {
    check_volume(bytes, Format::Npy);
}

/// The reader of NRRD.
pub fn read_nrrd(bytes: &[u8]) {
    check_volume(bytes, Format::Nrrd);
}

/// The reader of NIfTI.
pub fn read_nifti(bytes: &[u8]) {
    check_volume(bytes, Format::Nifti);
}

/// Reads voxels by several rules; a voxel is in one half of a rule and its opposite, or in none if it is no number.
fn check_volume(bytes: &[u8], format: Format) {
    let counted = |rule: VoxelRule| {
        let options =
            ReadOptions::new().format(format).volume(VolumeReading { rule, ..VolumeReading::default() });
        let model = read_with(bytes, &options).ok()?;
        check_model(&model);
        check_round(&model, Format::Npy);
        let Some(coface::io::Structure::Volume(voxels)) = model.structure() else {
            panic!("a file of voxels holds a volume")
        };
        Some((voxels.set_count(), voxels.shape().iter().map(|&length| u64::from(length)).product::<u64>()))
    };
    let above = counted(VoxelRule::AtLeast(1.5));
    let below = counted(VoxelRule::Below(1.5));
    let nonzero = counted(VoxelRule::Nonzero);
    assert_eq!(
        above.map(|counts| counts.1),
        below.map(|counts| counts.1),
        "the rule does not change the shape"
    );
    assert_eq!(
        above.map(|counts| counts.1),
        nonzero.map(|counts| counts.1),
        "the rule does not change the shape"
    );
    if let (Some((above, all)), Some((below, _))) = (above, below) {
        assert!(above as u64 + below as u64 <= all, "a number is not on both sides of another");
    }
}

/// A reader whose format must be guessed.
pub fn read_unknown(bytes: &[u8]) {
    if let Ok(model) = read_guessed(bytes) {
        check_model(&model);
    }
}

/// The reader of Matrix Market: the matrix is written and read again as it is; a graph has edges between its vertices.
pub fn read_matrix_market(bytes: &[u8]) {
    if let Ok(matrix) = matrix_market::read(bytes) {
        let mut text = Vec::new();
        matrix_market::write(&matrix, MatrixField::Integer, &mut text).expect("a list of bytes takes all");
        assert_eq!(matrix_market::read(&text[..]).expect("what is written can be read"), matrix);
    }
    check_reader(bytes, Format::MatrixMarket);
    if let Ok(graph) = FlagReading::default().graph(bytes) {
        let count = graph.numbers().len();
        assert!(graph.graph().edges().iter().all(|&(i, j, _)| j < i && (i as usize) < count));
    }
}

/// The reader of SVG, with curves approximated by chords of a given distance, of a chosen one, and kept.
pub fn read_svg(bytes: &[u8]) {
    check_reader(bytes, Format::Svg);
    if let Ok(model) = read_with(bytes, &ReadOptions::new().format(Format::Svg).flatten(1.0)) {
        check_model(&model);
    }
    // Errors are fine; panics are not.
    drop(coface::io::read_boundary(bytes, Format::Svg, &ReadOptions::new()));
}

/// Any format with any options: the first byte chooses the format, the second the options, the third the format that is written.
///
/// Strict reading accepts nothing that ordinary reading refuses, and the same model comes of it. What one format writes of a model that was
/// read from another is read again.
pub fn read_any(bytes: &[u8]) {
    let [format, how, output, bytes @ ..] = bytes else { return };
    let chosen = |byte: &u8| Format::ALL[usize::from(*byte) % Format::ALL.len()];
    let options = ReadOptions::new().format(chosen(format)).partial(how & 1 != 0);
    let options = if how & 2 != 0 { options.flatten(0.25) } else { options };
    let strict = read_with(bytes, &options.strict(true));
    let usual = read_with(bytes, &options);
    let Ok(model) = usual else {
        assert!(strict.is_err(), "strict reading accepts what ordinary reading refuses");
        return;
    };
    check_model(&model);
    if let Ok(strict) = strict {
        // Positions that are no numbers are not equal to themselves.
        let is_finite = model.positions().as_flat().iter().all(|x| x.is_finite());
        assert!(!is_finite || strict == model, "strict reading makes another model");
    }
    let output = chosen(output);
    let mut written = Vec::new();
    if write(&model, &mut written, output).is_ok() {
        let again = read(&written[..], output);
        let again =
            again.unwrap_or_else(|error| panic!("{} is written but not read: {error}", output.title()));
        check_model(&again);
    }
}
