//! Files within files: archives, compressed input, arrays behind XML.

use crate::models::{check_model, check_round};
use arbitrary::{Arbitrary, Unstructured};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coface::io::{Format, read, read_unknown};
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use std::io::{Cursor, Write};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// 3MF: the bytes themselves, if they begin as an archive; else an archive whose model they are.
pub fn read_three_mf(bytes: &[u8]) {
    let archive = if bytes.starts_with(b"PK") { bytes.to_vec() } else { archive_of(bytes) };
    if let Ok(model) = read(&archive[..], Format::ThreeMf) {
        check_model(&model);
    }
}

fn archive_of(model: &[u8]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    archive.start_file("3D/3dmodel.model", SimpleFileOptions::default()).expect("memory takes a file");
    archive.write_all(model).expect("memory takes all bytes");
    archive.finish().expect("memory takes a directory").into_inner()
}

/// Compressed files: the bytes themselves, and the bytes compressed by gzip, of which the same model comes as of the bytes.
pub fn read_compressed(bytes: &[u8]) {
    let plain = read_unknown(bytes);
    if let Ok(model) = &plain {
        check_model(model);
    }
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).expect("memory takes all bytes");
    let packed = encoder.finish().expect("memory takes all bytes");
    // What is compressed twice is unpacked once; numbers of NIfTI are compressed otherwise.
    let is_packed = [&b"\x1f\x8b"[..], b"BZh", b"\xfd7zXZ", b"\x28\xb5\x2f\xfd"]
        .iter()
        .any(|mark| bytes.starts_with(mark));
    if !is_packed && plain.as_ref().map_or(true, |model| model.format() != Some(Format::Nifti)) {
        let unpacked = read_unknown(&packed[..]);
        assert_eq!(unpacked.is_ok(), plain.is_ok(), "compression changes whether a file is read");
    }
}

/// A grid whose arrays stand behind it.
#[derive(Arbitrary, Debug)]
struct Grid {
    points: Vec<[i8; 3]>,
    cells: Vec<(u8, Vec<u8>)>,
    numbers: Vec<i16>,
    has_long_lengths: bool,
    is_big_endian: bool,
    is_compressed: bool,
    is_base64: bool,
    is_inline: bool,
    block: u8,
    /// Bytes of the file that are replaced.
    faults: Vec<(u16, u8)>,
    /// Numbers before blocks that are lies: their number, sizes and lengths.
    lies: Vec<(u8, u64)>,
}

/// VTK XML with arrays as bytes or base64, in the file's order of bytes, compressed or not, with a few bytes and lengths that are wrong.
pub fn read_vtk_appended(bytes: &[u8]) {
    let Ok(mut grid) = Grid::arbitrary(&mut Unstructured::new(bytes)) else { return };
    grid.points.truncate(40);
    grid.cells.truncate(40);
    let is_true = grid.faults.is_empty() && grid.lies.is_empty();
    let file = file_of(&grid);
    match read(&file[..], Format::VtkGrid) {
        Ok(model) => {
            check_model(&model);
            check_round(&model, Format::VtkGrid);
            assert!(!is_true || model.positions().len() == grid.points.len());
        }
        Err(_) => {
            assert!(!is_true || !grid.cells.is_empty() || grid.points.is_empty(), "a sound file is refused");
        }
    }
}

fn file_of(grid: &Grid) -> Vec<u8> {
    let order = |little: &[u8]| -> Vec<u8> {
        let mut bytes = little.to_vec();
        if grid.is_big_endian {
            bytes.reverse();
        }
        bytes
    };
    let count = grid.points.len().max(1);
    let points: Vec<u8> =
        grid.points.iter().flatten().flat_map(|&x| order(&f64::from(x).to_le_bytes())).collect();
    let corners = grid.cells.iter().flat_map(|(_, cell)| cell);
    let connectivity: Vec<u8> =
        corners.flat_map(|&corner| order(&(i64::from(corner) % count as i64).to_le_bytes())).collect();
    let mut end = 0i64;
    let offsets: Vec<u8> = grid
        .cells
        .iter()
        .flat_map(|(_, cell)| {
            end += cell.len() as i64;
            order(&end.to_le_bytes())
        })
        .collect();
    let types: Vec<u8> = grid.cells.iter().map(|(kind, _)| kind % 16).collect();
    let mut numbers: Vec<i16> = grid.numbers.clone();
    numbers.resize(grid.points.len(), 7);
    let numbers: Vec<u8> = numbers.iter().flat_map(|x| order(&x.to_le_bytes())).collect();
    let mut appended = Vec::new();
    let mut lies = grid.lies.iter().copied();
    let mut array = |kind: &str, name: &str, components: usize, bytes: &[u8]| {
        let stored = stored(grid, bytes, lies.next(), &order);
        let attributes = format!("type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\"");
        if grid.is_inline {
            return format!(
                "<DataArray {attributes} format=\"binary\">{}</DataArray>\n",
                STANDARD.encode(stored)
            );
        }
        let offset = appended.len();
        if grid.is_base64 {
            appended.extend_from_slice(STANDARD.encode(stored).as_bytes());
        } else {
            appended.extend_from_slice(&stored);
        }
        format!("<DataArray {attributes} format=\"appended\" offset=\"{offset}\"/>\n")
    };
    let arrays = [
        ("<Points>", array("Float64", "Points", 3, &points), "</Points>"),
        ("<Cells>", array("Int64", "connectivity", 1, &connectivity), ""),
        ("", array("Int64", "offsets", 1, &offsets), ""),
        ("", array("UInt8", "types", 1, &types), "</Cells>"),
        ("<PointData>", array("Int16", "numbers", 1, &numbers), "</PointData>"),
    ];
    let mut file = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"{}\"{}>\n\
         <UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        if grid.is_big_endian { "BigEndian" } else { "LittleEndian" },
        if grid.has_long_lengths { "UInt64" } else { "UInt32" },
        if grid.is_compressed { " compressor=\"vtkZLibDataCompressor\"" } else { "" },
        grid.points.len(),
        grid.cells.len(),
    )
    .into_bytes();
    for (before, array, after) in arrays {
        file.extend_from_slice([before, &array, after].concat().as_bytes());
    }
    file.extend_from_slice(b"</Piece></UnstructuredGrid>\n");
    if !grid.is_inline {
        let encoding = if grid.is_base64 { "base64" } else { "raw" };
        file.extend_from_slice(format!("<AppendedData encoding=\"{encoding}\">_").as_bytes());
        file.extend_from_slice(&appended);
        file.extend_from_slice(b"</AppendedData>\n");
    }
    file.extend_from_slice(b"</VTKFile>\n");
    for &(at, byte) in &grid.faults {
        if let Some(place) = file.get_mut(usize::from(at)) {
            *place = byte;
        }
    }
    file
}

/// An array behind its length, or its compressed blocks behind theirs; one of these numbers may be a lie.
fn stored(grid: &Grid, bytes: &[u8], lie: Option<(u8, u64)>, order: &dyn Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
    let mut lengths = vec![bytes.len() as u64];
    let mut body = bytes.to_vec();
    if grid.is_compressed {
        let size = usize::from(grid.block).max(8);
        let blocks: Vec<&[u8]> = bytes.chunks(size).collect();
        lengths = vec![blocks.len() as u64, size as u64, (bytes.len() % size) as u64];
        body.clear();
        for block in blocks {
            let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
            encoder.write_all(block).expect("memory takes all bytes");
            let packed = encoder.finish().expect("memory takes all bytes");
            lengths.push(packed.len() as u64);
            body.extend_from_slice(&packed);
        }
    }
    if let Some((at, lie)) = lie {
        let at = usize::from(at) % lengths.len();
        lengths[at] = lie;
    }
    let width = if grid.has_long_lengths { 8 } else { 4 };
    let mut out: Vec<u8> = lengths.iter().flat_map(|length| order(&length.to_le_bytes()[..width])).collect();
    out.extend_from_slice(&body);
    out
}
