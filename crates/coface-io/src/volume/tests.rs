//! Files of every type, byte order and encoding, written here.

use super::*;
use crate as io;
use crate::{Format, ReadOptions, Structure};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cubical::{CubicalVolume, VoxelBoxes, Voxels};
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use proptest::prelude::*;
use std::io::Write;

/// The values of the fixtures, with the first axis running fastest: shape 3, 2, 2.
const VALUES: [i64; 12] = [0, 1, 2, 3, 100, 0, 7, 7, 1, 0, 0, 5];
const SHAPE: [u32; 3] = [3, 2, 2];

/// A type in all formats: NumPy, NRRD, MetaImage, NIfTI.
struct Type {
    npy: &'static str,
    nrrd: &'static str,
    meta: &'static str,
    nifti: i16,
    size: usize,
}

const TYPES: [Type; 12] = [
    Type { npy: "i1", nrrd: "int8", meta: "MET_CHAR", nifti: 256, size: 1 },
    Type { npy: "u1", nrrd: "unsigned char", meta: "MET_UCHAR", nifti: 2, size: 1 },
    Type { npy: "i2", nrrd: "short", meta: "MET_SHORT", nifti: 4, size: 2 },
    Type { npy: "u2", nrrd: "uint16_t", meta: "MET_USHORT", nifti: 512, size: 2 },
    Type { npy: "i4", nrrd: "int", meta: "MET_INT", nifti: 8, size: 4 },
    Type { npy: "u4", nrrd: "uint32", meta: "MET_ULONG", nifti: 768, size: 4 },
    Type { npy: "i8", nrrd: "long long int", meta: "MET_LONG_LONG", nifti: 1024, size: 8 },
    Type { npy: "u8", nrrd: "ulonglong", meta: "MET_ULONG_LONG", nifti: 1280, size: 8 },
    Type { npy: "f4", nrrd: "float", meta: "MET_FLOAT", nifti: 16, size: 4 },
    Type { npy: "f8", nrrd: "double", meta: "MET_DOUBLE", nifti: 64, size: 8 },
    Type { npy: "f2", nrrd: "", meta: "", nifti: 0, size: 2 },
    Type { npy: "b1", nrrd: "", meta: "", nifti: 0, size: 1 },
];

/// A small integer as 16 bits of floating point.
fn half_bits(value: i64) -> u16 {
    if value == 0 {
        return 0;
    }
    let exponent = value.ilog2();
    ((15 + exponent) << 10) as u16 | ((value << 10 >> exponent) & 0x3ff) as u16
}

fn numbers(values: &[i64], name: &str, is_big: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    for &value in values {
        let little: Vec<u8> = match name {
            "f4" => (value as f32).to_le_bytes().to_vec(),
            "f8" => (value as f64).to_le_bytes().to_vec(),
            "f2" => half_bits(value).to_le_bytes().to_vec(),
            "b1" => vec![u8::from(value != 0)],
            _ => value.to_le_bytes()[..name[1..].parse::<usize>().unwrap()].to_vec(),
        };
        if is_big {
            bytes.extend(little.iter().rev());
        } else {
            bytes.extend(little);
        }
    }
    bytes
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// A MetaImage of the shape of the fixture, with more fields before the last one.
fn metaimage(kind: &str, is_big: bool, fields: &str, file: &str, data: &[u8]) -> Vec<u8> {
    let order = if is_big { "True" } else { "False" };
    let header = format!(
        "ObjectType = Image\nNDims = 3\r\nDimSize = 3 2 2\nElementSpacing = 1 1 2.5\nElementType = {kind}\n\
         BinaryDataByteOrderMSB = {order}\n{fields}ElementDataFile = {file}\n"
    );
    [header.as_bytes(), data].concat()
}

fn npy(descr: &str, is_fortran: bool, shape: &str, version: u8, data: &[u8]) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let mut text = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    while (text.len() + 10) % 16 != 0 {
        text.insert(text.len() - 1, ' ');
    }
    let mut file = b"\x93NUMPY".to_vec();
    file.extend([version, 0]);
    match version {
        1 => file.extend((text.len() as u16).to_le_bytes()),
        _ => file.extend((text.len() as u32).to_le_bytes()),
    }
    file.extend(text.as_bytes());
    file.extend(data);
    file
}

/// A NIfTI header of version 1 or 2, and the numbers if there are any.
fn nifti(
    version: u8,
    is_big: bool,
    (code, bits): (i16, i16),
    dims: &[i64],
    scale: (f64, f64),
    magic: &[u8],
    data: &[u8],
) -> Vec<u8> {
    let length = if version == 1 { 348 } else { 540 };
    let mut header = vec![0u8; length];
    let mut put = |at: usize, little: &[u8]| {
        let mut bytes = little.to_vec();
        if is_big {
            bytes.reverse();
        }
        header[at..at + bytes.len()].copy_from_slice(&bytes);
    };
    put(0, &(length as i32).to_le_bytes());
    let axes: Vec<i64> = std::iter::once(dims.len() as i64).chain(dims.iter().copied()).collect();
    let offset = if magic.starts_with(b"n+") { length + 4 } else { 0 };
    for (i, &axis) in axes.iter().enumerate() {
        match version {
            1 => put(40 + 2 * i, &(axis as i16).to_le_bytes()),
            _ => put(16 + 8 * i, &axis.to_le_bytes()),
        }
    }
    if version == 1 {
        put(70, &code.to_le_bytes());
        put(72, &bits.to_le_bytes());
        put(108, &(offset as f32).to_le_bytes());
        put(112, &(scale.0 as f32).to_le_bytes());
        put(116, &(scale.1 as f32).to_le_bytes());
    } else {
        put(12, &code.to_le_bytes());
        put(14, &bits.to_le_bytes());
        put(168, &(offset as i64).to_le_bytes());
        put(176, &scale.0.to_le_bytes());
        put(184, &scale.1.to_le_bytes());
    }
    let at = if version == 1 { 344 } else { 4 };
    header[at..at + magic.len()].copy_from_slice(magic);
    if offset > 0 {
        header.extend([0; 4]);
    }
    header.extend(data);
    header
}

fn options(rule: VoxelRule) -> ReadOptions {
    let mut options = ReadOptions::default();
    options.volume.rule = rule;
    options
}

fn read_with(bytes: &[u8], rule: VoxelRule) -> Result<CubicalVolume, Error> {
    let model = io::read_with(bytes, &options(rule))?;
    match model.structure() {
        Some(Structure::Volume(volume)) => Ok(volume.clone()),
        _ => panic!("no volume"),
    }
}

/// The volume of the values that the rule holds of.
fn expected(values: &[i64], shape: &[u32], rule: VoxelRule) -> CubicalVolume {
    CubicalVolume::new(shape, &vec![false; shape.len()], |voxel| {
        let at = voxel.iter().zip(shape).rev().fold(0, |at, (&x, &length)| at * length as usize + x as usize);
        rule.holds(values[at] as f64)
    })
    .unwrap()
}

/// Values with the last axis running fastest instead of the first.
fn last_fastest(values: &[i64], shape: &[u32]) -> Vec<i64> {
    let [nx, ny, nz] = [0, 1, 2].map(|axis| shape[axis] as usize);
    let places = (0..nx).flat_map(|x| (0..ny).flat_map(move |y| (0..nz).map(move |z| x + nx * (y + ny * z))));
    places.map(|at| values[at]).collect()
}

const RULES: [VoxelRule; 6] = [
    VoxelRule::Nonzero,
    VoxelRule::AtLeast(2.5),
    VoxelRule::Below(2.0),
    VoxelRule::Between(1.0, 5.0),
    VoxelRule::Equal(7.0),
    VoxelRule::Equal(7.5),
];

/// All files of the fixture's values, with their names.
fn files() -> Vec<(String, Vec<u8>, bool)> {
    let mut files = Vec::new();
    for kind in TYPES {
        for is_big in [false, true] {
            let is_bool = kind.npy == "b1";
            let data = numbers(&VALUES, kind.npy, is_big);
            let mark = if kind.size == 1 {
                '|'
            } else if is_big {
                '>'
            } else {
                '<'
            };
            for version in 1..=3 {
                let descr = format!("{mark}{}", kind.npy);
                files.push((
                    format!("npy {descr} F"),
                    npy(&descr, true, "(3, 2, 2)", version, &data),
                    is_bool,
                ));
                let data = numbers(&last_fastest(&VALUES, &SHAPE), kind.npy, is_big);
                files.push((
                    format!("npy {descr} C"),
                    npy(&descr, false, "(3L, 2L, 2L)", version, &data),
                    is_bool,
                ));
            }
            if kind.nrrd.is_empty() {
                continue;
            }
            let endian = if is_big { "big" } else { "little" };
            let head = |encoding: &str| {
                format!(
                    "NRRD0005\r\n# a comment\ntype: {}\ndimension: 3\nspace: left\nsizes: 3 2 2\nkey:=value: 1\nendian: {endian}\nencoding: {encoding}\n\n",
                    kind.nrrd
                )
            };
            let with = |encoding: &str, data: &[u8]| [head(encoding).as_bytes(), data].concat();
            files.push((format!("nrrd {} raw", kind.nrrd), with("raw", &data), false));
            files.push((format!("nrrd {} gzip", kind.nrrd), with("gzip", &gzip(&data)), false));
            let text = VALUES.map(|value| value.to_string()).join(" ");
            files.push((format!("nrrd {} ascii", kind.nrrd), with("ascii", text.as_bytes()), false));
            let meta = |fields: &str, data: &[u8]| metaimage(kind.meta, is_big, fields, "LOCAL", data);
            files.push((format!("{} raw", kind.meta), meta("", &data), false));
            files.push((format!("{} zlib", kind.meta), meta("CompressedData = True\n", &zlib(&data)), false));
            files.push((format!("{} text", kind.meta), meta("BinaryData = False\n", text.as_bytes()), false));
            for (version, magic) in [(1, &b"n+1\0"[..]), (2, b"n+2\0\r\n\x1a\n")] {
                let dims: &[i64] = if is_big { &[3, 2, 2, 1, 1] } else { &[3, 2, 2] };
                let file = nifti(
                    version,
                    is_big,
                    (kind.nifti, 8 * kind.size as i16),
                    dims,
                    (0.0, 0.0),
                    magic,
                    &data,
                );
                files.push((format!("nifti {version} {} gz", kind.npy), gzip(&file), false));
                files.push((format!("nifti {version} {}", kind.npy), file, false));
            }
        }
    }
    files
}

#[test]
fn every_type_order_and_encoding_is_read() {
    let truth = VALUES.map(|value| i64::from(value != 0));
    for (name, bytes, is_bool) in files() {
        for rule in RULES {
            let values = if is_bool { &truth } else { &VALUES };
            assert_eq!(read_with(&bytes, rule).unwrap(), expected(values, &SHAPE, rule), "{name} {rule}");
        }
    }
}

/// A file that is cut off anywhere is an error with a place, but for what is not needed.
#[test]
fn cut_files_are_refused() {
    for (name, bytes, _) in files() {
        let format = Format::from_name(name.split(' ').next().unwrap()).ok();
        let how = ReadOptions { format, ..ReadOptions::default() };
        assert!(io::read_with(&bytes[..], &how).is_ok());
        for length in 0..bytes.len() {
            let cut = io::read_with(&bytes[..length], &how);
            // The end of a packed file is a checksum; text may end within a number.
            let is_whole = name.contains("ascii") && length + 1 == bytes.len();
            assert!(cut.is_err() || is_whole, "{name} cut at {length} of {}", bytes.len());
        }
    }
}

#[test]
fn no_number_sets_no_voxel() {
    let data: Vec<u8> =
        [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    let file = npy("<f8", false, "(4,)", 1, &data);
    let set = |rule| {
        let volume = read_with(&file, rule).unwrap();
        [0, 1, 2, 3].map(|x| volume.is_set(&[x]))
    };
    assert_eq!(set(VoxelRule::Nonzero), [false, true, true, false]);
    assert_eq!(set(VoxelRule::AtLeast(f64::NEG_INFINITY)), [false, true, true, true]);
    assert_eq!(set(VoxelRule::Below(f64::INFINITY)), [false, false, true, true]);
    assert_eq!(set(VoxelRule::Equal(0.0)), [false, false, false, true]);
    let text = b"NRRD0001\ntype: float\ndimension: 1\nsizes: 3\nencoding: txt\n\nNaN, inf\n1e-3";
    let volume = read_with(text, VoxelRule::AtLeast(0.001f32.into())).unwrap();
    assert_eq!([0, 1, 2].map(|x| volume.is_set(&[x])), [false, true, true]);
    assert!(read_with(&file, VoxelRule::AtLeast(f64::NAN)).is_err());
    assert!(
        read_with(&file, VoxelRule::Between(2.0, 1.0)).unwrap_err().to_string().contains("lower bound first")
    );
    // The number of 32 bits next to 0.1.
    let tenth = npy("<f4", false, "(1,)", 1, &0.1f32.to_le_bytes());
    assert!(read_with(&tenth, VoxelRule::Equal(0.1)).unwrap().is_set(&[0]));
}

#[test]
fn scaled_numbers_are_what_is_compared() {
    for (version, magic) in [(1, &b"n+1\0"[..]), (2, b"n+2\0\r\n\x1a\n")] {
        let file = nifti(version, true, (2, 8), &[12], (0.5, -1.0), magic, &VALUES.map(|value| value as u8));
        let volume = read_with(&file, VoxelRule::AtLeast(0.0)).unwrap();
        assert_eq!((0..12).map(|x| volume.is_set(&[x])).collect::<Vec<_>>(), VALUES.map(|value| value >= 2));
        let plain =
            nifti(version, true, (2, 8), &[12], (f64::NAN, 3.0), magic, &VALUES.map(|value| value as u8));
        assert_eq!(read_with(&plain, VoxelRule::Equal(100.0)).unwrap().set_count(), 1);
    }
}

/// Rows run along axis 0, from the top down along axis 1.
#[test]
fn grey_images_are_volumes_of_two_axes() {
    let values: Vec<u8> = vec![0, 9, 5, 5, 0, 9];
    for bytes in [
        b"P2\n# made by hand\n3 2\n255\n0 9 5\n5 0 9\n".to_vec(),
        [&b"P5 3 2 255\n"[..], &values].concat(),
        [&b"P5#c\n3 2\n65535\n"[..], &values.iter().flat_map(|&value| [0, value]).collect::<Vec<_>>()]
            .concat(),
    ] {
        let volume = read_with(&bytes, VoxelRule::AtLeast(5.0)).unwrap();
        assert_eq!(volume.shape(), [3, 2]);
        let set: Vec<bool> = (0..6).map(|at| volume.is_set(&[at % 3, at / 3])).collect();
        assert_eq!(set, [false, true, true, true, false, true]);
        assert_eq!(io::read_with(&bytes[..], &ReadOptions::new()).unwrap().format(), Some(Format::Pgm));
    }
}

/// What a header may lie about, and what is said.
#[test]
fn lies_are_named() {
    let nii = |code, bits, dims: &[i64]| nifti(1, false, (code, bits), dims, (0.0, 0.0), b"n+1\0", &[1; 8]);
    let nrrd = |fields: &str| [b"NRRD0004\n", fields.as_bytes(), b"\n\n12345678"].concat();
    let cases: Vec<(Vec<u8>, Format, &str)> = vec![
        (npy("<f8", false, "(2, 2)", 1, &[0; 31]), Format::Npy, "numbers end after 3 of 4"),
        (npy("<f8", false, "(400000000, 4000000000)", 1, &[0; 31]), Format::Npy, "numbers end after 3"),
        (npy("<f8", false, "(4000000000, 4000000000, 4000000000)", 1, &[]), Format::Npy, "has no size"),
        (npy("<f8", false, "(5000000000,)", 1, &[]), Format::Npy, "longer than 2^32"),
        (npy("<c8", false, "(1,)", 1, &[0; 8]), Format::Npy, "\"<c8\" has no numbers"),
        (npy("|O", false, "(1,)", 1, &[0; 8]), Format::Npy, "no numbers"),
        (npy("<f8", false, "()", 1, &[0; 8]), Format::Npy, "0 axes"),
        (npy("<f8", false, "(1,1,1,1,1,1,1,1,1)", 1, &[0; 8]), Format::Npy, "9 axes"),
        (npy("<f8", false, "(0, 3)", 1, &[]), Format::Npy, "axis 0"),
        (npy("<f8", false, "(-1,)", 1, &[]), Format::Npy, "no number"),
        (npy("<f8", false, "3", 1, &[]), Format::Npy, "parentheses"),
        (npy("<f8', 'descr': [('x', '<f8')], 'x': '", false, "(1,)", 1, &[]), Format::Npy, "records"),
        (npy("<f8", false, "(1,)", 4, &[]), Format::Npy, "version 4"),
        (b"\x93NUMPY\x02\x00\xff\xff\xff\xff{".to_vec(), Format::Npy, "claims 4294967295 bytes"),
        (b"\x93NUMPX\x01\x00".to_vec(), Format::Npy, "does not begin"),
        (nii(4, 8, &[4]), Format::Nifti, "8 bits"),
        (nii(128, 24, &[2]), Format::Nifti, "colors"),
        (nii(999, 8, &[2]), Format::Nifti, "not known"),
        (nii(2, 8, &[-3]), Format::Nifti, "length -3"),
        (nii(2, 8, &[]), Format::Nifti, "0 axes"),
        (nii(2, 8, &[3, 3]), Format::Nifti, "numbers end after 8 of 9"),
        (nii(2, 8, &[30000, 30000, 30000]), Format::Nifti, "numbers end after 8"),
        (nifti(1, false, (2, 8), &[2], (0.0, 0.0), b"ni1\0", &[]), Format::Nifti, "the other file lies"),
        (nifti(1, false, (2, 8), &[2], (0.0, 0.0), b"\0\0\0\0", &[]), Format::Nifti, "ANALYZE"),
        (nifti(2, false, (2, 8), &[2], (0.0, 0.0), b"n+3\0", &[]), Format::Nifti, "mark of NIfTI"),
        (vec![7; 400], Format::Nifti, "348 or 540"),
        (metaimage("MET_SHORT", false, "", "LOCAL", &[0; 20]), Format::MetaImage, "end after 10 of 12"),
        (metaimage("MET_OTHER", false, "", "LOCAL", &[]), Format::MetaImage, "\"MET_OTHER\""),
        (
            metaimage("MET_SHORT", false, "ElementNumberOfChannels = 3\n", "LOCAL", &[]),
            Format::MetaImage,
            "3 numbers",
        ),
        (
            metaimage("MET_SHORT", false, "CompressedData = yes\n", "LOCAL", &[]),
            Format::MetaImage,
            "not True or False",
        ),
        (
            metaimage("MET_SHORT", false, "CompressedData = True\n", "LOCAL", &[7; 30]),
            Format::MetaImage,
            "unpacked",
        ),
        (metaimage("MET_SHORT", false, "", "LIST", &[]), Format::MetaImage, "several files"),
        (metaimage("MET_SHORT", false, "", "../other.raw", &[]), Format::MetaImage, "other file"),
        (b"ObjectType = Image\nNDims = 2\nDimSize = 2 2\n".to_vec(), Format::MetaImage, "ElementDataFile"),
        (b"ObjectType = Mesh\n".to_vec(), Format::MetaImage, "not Image"),
        (
            b"NDims = 2\nDimSize = 2\nElementType = MET_CHAR\nElementDataFile = LOCAL\n".to_vec(),
            Format::MetaImage,
            "2 axes",
        ),
        (b"P2 2 2 1\n1 1 0\n".to_vec(), Format::Pgm, "3 of 4"),
        (b"P5 4000000000 4000000000 255\n".to_vec(), Format::Pgm, "numbers end after 0"),
        (b"P2 2 x 1\n".to_vec(), Format::Pgm, "\"x\""),
        (b"P2 2 2 70000\n".to_vec(), Format::Pgm, "largest value"),
        (b"P2 2".to_vec(), Format::Pgm, "no end"),
        (nrrd("type: block\ndimension: 1\nsizes: 2\nencoding: raw"), Format::Nrrd, "\"block\""),
        (nrrd("type: short\ndimension: 1\nsizes: 2\nencoding: raw"), Format::Nrrd, "\"endian\""),
        (
            nrrd("type: short\ndimension: 2\nsizes: 2\nencoding: raw\nendian: big"),
            Format::Nrrd,
            "2 axes, but gives 1",
        ),
        (nrrd("type: short\ndimension: 1\nsizes: x\nencoding: raw"), Format::Nrrd, "are no sizes"),
        (nrrd("type: short\ndimension: 1\nsizes: 2\nencoding: bzip2"), Format::Nrrd, "bzip2"),
        (nrrd("type: short\ndimension: 1\nsizes: 2\nendian: middle"), Format::Nrrd, "byte order"),
        (
            nrrd("type: uint8\ndimension: 1\nsizes: 9\nencoding: raw"),
            Format::Nrrd,
            "numbers end after 8 of 9",
        ),
        (nrrd("type: uint8\ndimension: 1\nsizes: 9\nencoding: gzip"), Format::Nrrd, "unpacked"),
        (
            nrrd("type: uint8\ndimension: 1\nsizes: 1\nencoding: ascii"),
            Format::Nrrd,
            "\"12345678\" is no integer",
        ),
        (nrrd("type: uint8\ndimension: 1\nsizes: 2\nencoding: raw\nline skip: 3"), Format::Nrrd, "3 lines"),
        (
            nrrd("type: uint8\ndimension: 1\nsizes: 2\nencoding: raw\nbyte skip: -1"),
            Format::Nrrd,
            "the end is not known",
        ),
        (
            nrrd("type: uint8\ndimension: 1\nsizes: 2\nencoding: gzip\nbyte skip: -1"),
            Format::Nrrd,
            "only of raw",
        ),
        (nrrd("type: uint8\ndimension: 1\nsizes: 2\nencoding: raw\ndata file: a.raw"), Format::Nrrd, "a.raw"),
        (
            nrrd("type: uint8\ndimension: 1\nsizes: 2\nencoding: raw\ndata file: LIST"),
            Format::Nrrd,
            "several files",
        ),
        (nrrd("nonsense"), Format::Nrrd, "no field"),
        (b"NRRD0004\ntype: uint8\n".to_vec(), Format::Nrrd, "does not end"),
        (b"NRRD0009\n\n".to_vec(), Format::Nrrd, "NRRD0001 to NRRD0005"),
    ];
    for (bytes, format, words) in cases {
        let how = ReadOptions { format: Some(format), ..ReadOptions::default() };
        let error = io::read_with(&bytes[..], &how).unwrap_err();
        assert!(error.to_string().contains(words), "{error} should say {words}");
    }
    // A header that lies is found out before numbers are read, where the size of the file is known.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("short.npy");
    std::fs::write(&path, npy("<f8", false, "(1000, 1000, 1000)", 1, &[0; 80])).unwrap();
    let error = io::read_path(&path, None).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Parse);
    assert!(
        error.to_string().contains("short.npy") && error.to_string().contains("80 bytes are left"),
        "{error}"
    );
}

/// Bytes are changed one at a time: whatever it says, nothing panics.
#[test]
fn damage_never_panics() {
    let chosen = |name: &str| name.contains("i2") || name.contains("short") || name.contains("MET_SHORT");
    for (_, bytes, _) in files().into_iter().filter(|(name, ..)| chosen(name)) {
        for at in 0..bytes.len() {
            for change in [0xff, 0x01, 0x80] {
                let mut damaged = bytes.clone();
                damaged[at] ^= change;
                // Shapes that become huge end with the numbers.
                let _ = read_with(&damaged, VoxelRule::Nonzero);
            }
        }
    }
}

#[test]
fn pairs_are_read_by_either_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let data = numbers(&VALUES, "i2", true);
    let header = nifti(1, true, (4, 16), &[3, 2, 2], (0.0, 0.0), b"ni1\0", &[]);
    std::fs::write(path("brain.hdr"), &header).unwrap();
    let missing = io::read_path(path("brain.hdr"), None).unwrap_err();
    assert!(missing.to_string().contains("brain.img"), "{missing}");
    std::fs::write(path("brain.img"), &data).unwrap();
    std::fs::write(path("packed.hdr"), &header).unwrap();
    std::fs::write(path("packed.img.gz"), gzip(&data)).unwrap();
    let nhdr = "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 2 2\nendian: big\nencoding: raw\n";
    std::fs::write(path("a.nhdr"), format!("{nhdr}data file: skipped.raw\nline skip: 2\nbyte skip: 1\n"))
        .unwrap();
    std::fs::write(path("skipped.raw"), [b"one\ntwo\n.", &data[..]].concat()).unwrap();
    std::fs::write(path("b.nhdr"), format!("{nhdr}data file: skipped.raw\nbyte skip: -1\n")).unwrap();
    let outside = |fields: &str| metaimage("MET_SHORT", true, fields, "skipped.raw", &[]);
    std::fs::write(path("d.mhd"), outside("HeaderSize = 9\n")).unwrap();
    std::fs::write(path("e.mhd"), outside("HeaderSize = -1\n")).unwrap();
    std::fs::write(path("c.nrrd"), [nhdr.as_bytes(), b"byte skip: -1\n\nwhatever", &data].concat()).unwrap();
    let expected = expected(&VALUES, &SHAPE, VoxelRule::AtLeast(5.0));
    for name in [
        "brain.hdr",
        "brain.img",
        "packed.hdr",
        "packed.img.gz",
        "a.nhdr",
        "b.nhdr",
        "c.nrrd",
        "d.mhd",
        "e.mhd",
    ] {
        let model = io::read_path_with(path(name), &options(VoxelRule::AtLeast(5.0))).unwrap();
        assert_eq!(model.structure(), Some(&Structure::Volume(expected.clone())), "{name}");
    }
    std::fs::write(path("long.npy"), npy("|u1", false, "(2,)", 1, &[1; 3])).unwrap();
    let model = io::read_path(path("long.npy"), None).unwrap();
    assert!(model.remarks()[0].message.contains("goes on behind the 2 numbers"));
    // Told by content alone.
    let packed = gzip(&nifti(1, false, (2, 8), &[2], (0.0, 0.0), b"n+1\0", &[1, 0]));
    std::fs::write(path("nameless"), &packed).unwrap();
    assert_eq!(io::read_path(path("nameless"), None).unwrap().format(), Some(Format::Nifti));
    std::fs::write(path("mesh.obj.gz"), gzip(b"v 0 0 0\n")).unwrap();
    assert_eq!(io::read_path(path("mesh.obj.gz"), None).unwrap().format(), Some(Format::Obj));
}

#[test]
fn written_volumes_are_read_again() {
    let volume = CubicalVolume::new(&[3, 4, 70], &[false; 3], |v| (v[0] + v[1] * v[2]) % 3 == 0).unwrap();
    let mut bytes = Vec::new();
    write_npy(&volume, &mut bytes).unwrap();
    assert_eq!(bytes.len() % 64, (3 * 4 * 70) % 64);
    assert_eq!(read_with(&bytes, VoxelRule::Nonzero).unwrap(), volume);
    let mut how = VolumeReading::default();
    how.periodic[2] = true;
    let read = |how: &VolumeReading| VolumeStream::new(&bytes[..], Format::Npy)?.read(how);
    assert_eq!(read(&how).unwrap().0.is_periodic(), [false, false, true]);
    how.periodic[4] = true;
    assert!(read(&how).unwrap_err().to_string().contains("axis 4"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Windows made while a file is read are those of the volume, each given once.
    #[test]
    fn windows_are_those_of_the_volume(
        shape in prop::collection::vec(1u32..7, 1..4),
        cuts in prop::collection::vec(1u32..4, 3),
        periodic in any::<u8>(),
        is_fortran in any::<bool>(),
        seed in any::<u64>(),
    ) {
        let is_periodic: Vec<bool> = (0..shape.len()).map(|axis| periodic >> axis & 1 == 1).collect();
        let count = shape.iter().product::<u32>();
        let data: Vec<u8> = (0..count).map(|i| (seed.rotate_left(i * 7) & 1) as u8).collect();
        let text: String = shape.iter().map(|length| format!("{length}, ")).collect();
        let file = npy("|u1", is_fortran, &format!("({text})"), 1, &data);
        let mut how = VolumeReading::default();
        how.periodic[..shape.len()].copy_from_slice(&is_periodic);
        let stream = || VolumeStream::new(&file[..], Format::Npy).unwrap();
        let volume = stream().read(&how).unwrap().0;
        let counts: Vec<u32> = shape.iter().zip(&cuts).map(|(&length, &cut)| cut.min(length)).collect();
        let boxes = VoxelBoxes::new(&shape, &is_periodic, &counts).unwrap();
        let mut given = vec![0; boxes.count() as usize];
        stream().for_each_window(VoxelRule::Nonzero, &boxes, |number, window| {
            given[number as usize] += 1;
            assert_eq!(window, volume.window(&boxes.voxels(number)).unwrap());
            Ok(())
        }).unwrap();
        prop_assert!(given.iter().all(|&times| times == 1));
    }
}

#[test]
fn axes_of_colors_and_vectors_are_no_axes_of_space() {
    let text = |kinds: &str, sizes: &str| {
        format!(
            "NRRD0004\ntype: uint8\ndimension: 3\nsizes: {sizes}\nkinds: {kinds}\nencoding: ascii\n\n5 0 7 5 0 7 5 0 7 5 0 7\n"
        )
    };
    for kinds in ["RGB-color domain domain", "vector space space", "domain list domain"] {
        let sizes = if kinds.starts_with("domain") { "2 3 2" } else { "3 2 2" };
        let error = crate::read(text(kinds, sizes).as_bytes(), Format::Nrrd).unwrap_err();
        assert!(error.to_string().contains("a voxel has 3 numbers: axis"), "{kinds}: {error}");
        assert!(error.cure().is_some());
    }
    for kinds in ["domain domain domain", "space space time", "none ??? domain"] {
        assert!(crate::read(text(kinds, "3 2 2").as_bytes(), Format::Nrrd).is_ok(), "{kinds}");
    }
    assert!(crate::read(text("list domain domain", "1 3 4").as_bytes(), Format::Nrrd).is_ok());
}
