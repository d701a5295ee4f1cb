use super::*;
use crate::{Format, Model, Structure};
use coface_algebra::Error;
use coface_algebra::ErrorKind;
use coface_algebra::chains::{ChainComplex, WideComplex};
use coface_algebra::samples::random_complexes;
use coface_algebra::{Integer, SparseMatrix, WideMatrix};
use coface_geometry::Positions;
use proptest::prelude::*;

fn bytes_of(model: &Model) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(model, &mut bytes).unwrap();
    bytes
}

fn complex_of(model: &Model) -> &ChainComplex {
    match model.structure() {
        Some(Structure::Chains(complex)) => complex,
        other => panic!("{other:?}"),
    }
}

/// Puts a right checksum on the header again.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = HEADER + ROW * u32::from_le_bytes(bytes[24..28].try_into().unwrap()) as usize;
    let checksum = super::writing::head_checksum(&bytes[..end.min(bytes.len())]);
    bytes[32..40].copy_from_slice(&checksum.to_le_bytes());
    bytes
}

fn sample() -> Vec<u8> {
    let circle = SparseMatrix::from_entries(
        3,
        3,
        [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, 300), (2, 2, -300)],
    )
    .unwrap();
    let positions = Positions::from_flat(2, vec![0.0, 0.0, 1.0, 0.0, 0.0, 0.1]).unwrap();
    bytes_of(&Model::from_chains(ChainComplex::new(vec![circle]).unwrap(), positions).unwrap())
}

fn fault(bytes: &[u8]) -> Error {
    let error = read(bytes).unwrap_err();
    assert!(error.byte().is_some() && error.cure().is_some(), "{error}");
    error
}

proptest! {
    #[test]
    fn a_complex_comes_back(complex in random_complexes()) {
        let model = Model::from_structure(Structure::Chains(complex));
        let bytes = bytes_of(&model);
        prop_assert_eq!(&read(&bytes[..]).unwrap(), &model);
        prop_assert_eq!(bytes_of(&read(&bytes[..]).unwrap()), bytes);
    }

    #[test]
    fn integers_of_any_size_come_back(
        numbers in prop::collection::vec((any::<i64>(), 0usize..3, any::<bool>()), 0..20),
    ) {
        let numbers: Vec<Integer> = numbers
            .into_iter()
            .map(|(x, squarings, is_short)| {
                let mut x = Integer::from(if is_short { x % 128 } else { x });
                (0..squarings).for_each(|_| x = &x * &x);
                x
            })
            .chain([Integer::from(i64::MIN), Integer::from(-128)])
            .collect();
        let mut writer = ContainerWriter::new(Kind::Chains);
        push_integers(&mut writer, (Role::Orders, Role::WideOrders), 4, numbers.iter());
        let bytes = writer.into_bytes();
        let container = Container::open(&bytes, Kind::Chains).unwrap();
        prop_assert_eq!(integers(&container, (Role::Orders, Role::WideOrders), 4).unwrap(), numbers);
    }

    /// No change of bytes, with a right checksum on top or not, makes a reader panic.
    #[test]
    fn changed_bytes_do_no_harm(changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..5)) {
        let mut bytes = sample();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let _ = read(&bytes[..]);
        let _ = read(&sealed(bytes)[..]);
    }
}

#[test]
fn every_flipped_bit_is_seen() {
    let bytes = sample();
    assert_eq!(read(&bytes[..]).unwrap().positions().len(), 3);
    for at in 0..bytes.len() {
        for bit in 0..8 {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1 << bit;
            fault(&damaged);
        }
    }
}

#[test]
fn every_shorter_file_is_seen() {
    let bytes = sample();
    for length in 0..bytes.len() {
        let error = fault(&bytes[..length]);
        assert!(length < HEADER || error.to_string().contains(&format!("after {length} of")), "{error}");
    }
    assert!(fault(&[&bytes[..], b"x"].concat()).to_string().contains("goes on"));
}

#[test]
fn lies_under_a_right_checksum_are_named() {
    let lie = |at: usize, value: &[u8], message: &str| {
        let mut bytes = sample();
        bytes[at..at + value.len()].copy_from_slice(value);
        let error = fault(&sealed(bytes));
        assert!(error.to_string().contains(message), "{error}");
    };
    lie(0, b"\x89cfc\n\x1a\n\0", "mark");
    lie(8, &2u32.to_le_bytes(), "newer coface");
    lie(8, &0u32.to_le_bytes(), "no such version");
    lie(12, &3u32.to_le_bytes(), "coface merge");
    lie(12, &9u32.to_le_bytes(), "kind");
    lie(24, &u32::MAX.to_le_bytes(), "does not fit");
    lie(24, &1u32.to_le_bytes(), "does not begin");
    lie(28, &[1], "mean nothing");
    lie(HEADER, &77u32.to_le_bytes(), "no known sort");
    lie(HEADER + 8, &3u32.to_le_bytes(), "width");
    lie(HEADER + 16, &u64::MAX.to_le_bytes(), "does not begin");
    lie(HEADER + 24, &u64::MAX.to_le_bytes(), "longer");
    lie(HEADER + 24, &(1u64 << 40).to_le_bytes(), "longer");
    // The second row like the first: twice the same.
    let first = sample()[HEADER..HEADER + 4].to_vec();
    lie(HEADER + ROW, &first, "no section");
}

/// Sections that are sound by themselves and do not fit together.
#[test]
fn sections_that_do_not_fit_together_are_refused() {
    let write = |counts: &[u64], starts: &[u32], rows: &[u32], entries: &[i8]| {
        let mut writer = ContainerWriter::new(Kind::Complex);
        writer.push_owned(Role::Counts, 0, counts);
        writer.push_owned(Role::Starts, 1, starts);
        writer.push_owned(Role::Rows, 1, rows);
        writer.push_owned(Role::Entries, 1, entries);
        writer.into_bytes()
    };
    assert_eq!(
        complex_of(&read(&write(&[2, 1], &[0, 2], &[0, 1], &[-1, 1])[..]).unwrap()).f_vector(),
        [2, 1]
    );
    for bytes in [
        write(&[2, 3], &[0, 2], &[0, 1], &[-1, 1]),
        write(&[2, u64::MAX], &[0, 2], &[0, 1], &[-1, 1]),
        write(&[1, 1], &[0, 2], &[0, 1], &[-1, 1]),
        write(&[u64::MAX, 1], &[0, 2], &[0, 1], &[-1, 1]),
        write(&[2, 1], &[1, 2], &[0, 1], &[-1, 1]),
        write(&[2, 1], &[0, 2], &[1, 0], &[-1, 1]),
        write(&[2, 1], &[0, 2], &[0, 1], &[-1, 0]),
        write(&[2, 1], &[0, 2], &[0, 1], &[-1]),
        write(&[2, 1, 1], &[0, 2], &[0, 1], &[-1, 1]),
    ] {
        assert!(fault(&bytes).kind() != ErrorKind::Io);
    }
    // A boundary of a boundary.
    let mut writer = ContainerWriter::new(Kind::Complex);
    writer.push_owned(Role::Counts, 0, &[1u64, 1, 1]);
    for degree in [1, 2] {
        writer.push_owned(Role::Starts, degree, &[0u32, 1]);
        writer.push_owned(Role::Rows, degree, &[0u32]);
        writer.push_owned(Role::Entries, degree, &[1i8]);
    }
    assert_eq!(read(&writer.into_bytes()[..]).unwrap_err().kind(), ErrorKind::BoundaryOfBoundary);
}

#[test]
fn complexes_without_matrices_and_wide_ones() {
    for complex in [ChainComplex::of_points(0), ChainComplex::of_points(3)] {
        let model = Model::from_structure(Structure::Chains(complex));
        assert_eq!(read(&bytes_of(&model)[..]).unwrap(), model);
    }
    let huge: Integer = "-123456789012345678901234567890".parse().unwrap();
    let matrix =
        WideMatrix::from_integer_columns(1, [vec![(0, huge)], vec![], vec![(0, Integer::ONE)]]).unwrap();
    let complex = WideComplex::of_wide(1, vec![matrix]).unwrap();
    let mut writer = ContainerWriter::new(Kind::Reduced);
    push_wide_complex(&mut writer, &complex);
    let bytes = writer.into_bytes();
    assert_eq!(to_wide_complex(&Container::open(&bytes, Kind::Reduced).unwrap()).unwrap(), complex);
    // In memory that is not aligned arrays are copied.
    for shift in 0..8 {
        let moved = [&vec![0; shift][..], &bytes].concat();
        let container = Container::open(&moved[shift..], Kind::Reduced).unwrap();
        assert_eq!(to_wide_complex(&container).unwrap(), complex);
    }
}

#[test]
fn a_header_tells_the_checksum() {
    let bytes = sample();
    let container = Container::open(&bytes, Kind::Complex).unwrap();
    let told = checksum_of_header(&bytes[..HEADER], bytes.len() as u64).unwrap();
    assert_eq!(told, (Kind::Complex, container.checksum()));
    let mut other = bytes.clone();
    other[16] ^= 1;
    assert!(checksum_of_header(&other[..HEADER], bytes.len() as u64).is_err());
}

#[test]
fn every_structure_becomes_its_complex() {
    for (text, format, expected) in [
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", Format::Off, vec![4, 4, 1]),
        ("[[0,1,2,9]]", Format::Json, vec![4, 6, 4, 1]),
        ("{\"next\":[2,3,0,1],\"twin\":[1,0,3,2]}", Format::Json, vec![2, 2, 2]),
        ("cPcbbbiht\n", Format::Isosig, vec![1, 2, 4, 2]),
    ] {
        let model = crate::read(text.as_bytes(), format).unwrap();
        let again = read(&bytes_of(&model)[..]).unwrap();
        assert_eq!(complex_of(&again).f_vector(), expected);
        assert_eq!(again.positions(), model.positions());
    }
}
