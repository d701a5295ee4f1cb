use super::*;
use crate::{Format, Model, read_unknown, wkt};
use proptest::prelude::*;

const TEXTS: [&str; 9] = [
    "POINT (1 2)",
    "SRID=4326;POINT (1 2)",
    "POLYGON Z ((0 0 5, 1 0 6, 0 1 7, 0 0 5))",
    "SRID=25832;MULTIPOLYGON Z (((0 0 5, 4 0 6, 0 4 7, 0 0 5), (1 1 0, 1 2 0, 2 1 0, 1 1 0)), ((9 9 1, 8 9 1, 9 8 1, 9 9 1)))",
    "LINESTRING (0 0, 1 1, 2 0)\nMULTIPOINT (3 4, 5 6)",
    "POLYGON ((0 0, 1 0, 0 1, 0 0))\nPOLYGON ((0 0, 1 0, 1 1, 0 0))",
    "GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), POLYGON ((5 5, 6 5, 5 6, 5 5)), LINESTRING (0 0, 1 1))",
    "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))\nPOLYGON ((0 0, 1 0, 1 1, 0 0))",
    "GEOMETRYCOLLECTION EMPTY",
];

fn written(model: &Model, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    crate::write(model, &mut bytes, format).unwrap();
    bytes
}

#[test]
fn what_is_written_is_read_as_the_same() {
    for text in TEXTS {
        let model = wkt::read(text.as_bytes()).unwrap();
        for format in [Format::Wkb, Format::WkbHex, Format::Wkt] {
            let bytes = written(&model, format);
            let back = crate::read(&bytes[..], format).unwrap();
            assert_eq!(back, model, "{text} as {format:?}");
            assert_eq!(written(&back, format), bytes);
            // The content says what it is.
            assert_eq!(read_unknown(&bytes[..]).unwrap(), model, "{text} as {format:?}");
        }
    }
}

#[test]
fn systems_are_flags_of_ewkb_and_heights_numbers_of_iso() {
    let code = |text: &str| {
        let bytes = written(&wkt::read(text.as_bytes()).unwrap(), Format::Wkb);
        u32::from_le_bytes(bytes[1..5].try_into().unwrap())
    };
    assert_eq!(code("POINT Z (1 2 3)"), 1001);
    assert_eq!(code("SRID=5;POINT Z (1 2 3)"), 1 | HAS_Z | HAS_SRID);
    assert_eq!(code("SRID=5;POINT (1 2)"), 1 | HAS_SRID);
    assert_eq!(code("POINT (1 2)"), 1);
}

#[test]
fn faults_name_the_byte() {
    let whole = written(&wkt::read(TEXTS[3].as_bytes()).unwrap(), Format::Wkb);
    for length in 0..whole.len() {
        let error = read(&whole[..length]).unwrap_err();
        assert!(error.byte().is_some() && error.cure().is_some(), "{length}: {error}");
    }
    let changed = |at: usize, byte: u8| {
        let mut bytes = whole.clone();
        bytes[at] = byte;
        read(&bytes[..]).unwrap_err().to_string()
    };
    assert!(changed(0, 7).contains("7 is no byte order"));
    assert!(changed(1, 13).contains("no shape of its own"));
    assert!(changed(1, 99).contains("no kind"));
    let [a, b] = ["SRID=1;POINT (1 2)", "SRID=2;POINT (1 2)"]
        .map(|text| written(&wkt::read(text.as_bytes()).unwrap(), Format::Wkb));
    let error = read(&[a, b].concat()[..]).unwrap_err();
    assert!(error.to_string().contains("SRID 1") && error.to_string().contains("SRID 2"), "{error}");
}

#[test]
fn an_empty_polygon_is_one_without_rings() {
    let system = crate::ReferenceSystem::from_srid(25832);
    let mut bytes = Vec::new();
    write_empty_polygon(system.as_ref(), &mut bytes, Encoding::Bytes).unwrap();
    assert_eq!(bytes, [1, 3, 0, 0, 32, 232, 100, 0, 0, 0, 0, 0, 0]);
    let model = read(&bytes[..]).unwrap();
    assert_eq!((model.lines().len(), model.reference_system()), (0, system.as_ref()));
    let mut digits = Vec::new();
    write_empty_polygon(None, &mut digits, Encoding::Digits).unwrap();
    assert_eq!(digits, b"010300000000000000\n");
}

proptest! {
    #[test]
    fn coordinates_keep_all_their_bits(places in proptest::collection::vec(proptest::num::f64::NORMAL, 6)) {
        let line = format!("LINESTRING Z ({:?} {:?} {:?}, {:?} {:?} {:?})", places[0], places[1], places[2], places[3], places[4], places[5]);
        let model = wkt::read(line.as_bytes()).unwrap();
        for format in [Format::Wkb, Format::WkbHex] {
            prop_assert_eq!(&crate::read(&written(&model, format)[..], format).unwrap(), &model);
        }
    }
}
