//! Every reader through the public doors: bad input, mutated real files, conversions, and the truth of the development
//! data.
#![allow(clippy::print_stderr, reason = "a test says what it skips")]

use coface_algebra::{Error, ErrorKind};
use coface_io as io;
use coface_io::{Format, Model, ReadOptions, RemarkCode, Structure};
use proptest::prelude::*;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// One sound file of each format: a triangle, or a tetrahedron where the format has cells.
const SAMPLES: [(Format, &str); 18] = [
    (Format::Off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    (Format::Obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
    (
        Format::Ply,
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
         property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n",
    ),
    (
        Format::Stl,
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
         endsolid a\n",
    ),
    (
        Format::Medit,
        "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n\
         1 2 3 4 0\nEnd\n",
    ),
    (
        Format::Msh,
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n\
         $Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n",
    ),
    (
        Format::Vtk,
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0\n1 0 0\n0 1 0\n\
         0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nCELL_DATA 1\nSCALARS a int 1\nLOOKUP_TABLE default\n7\n\
         POINT_DATA 4\nFIELD data 2\nb 1 4 float\n0.5 1 nan -2\nc 2 4 int\n0 1 2 3 4 5 6 7\n",
    ),
    (
        Format::VtkGrid,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points>\n\
         <DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray>\n\
         </Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>\n\
         <DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">4</DataArray>\n\
         <DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray>\n</Cells>\n</Piece>\n\
         </UnstructuredGrid>\n</VTKFile>\n",
    ),
    (
        Format::VtkPolygons,
        "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\">\n<PolyData>\n\
         <Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">\n<Points>\n\
         <DataArray type=\"UInt8\" NumberOfComponents=\"3\" format=\"binary\">CQAAAAAAAAEAAAABAA==</DataArray>\n\
         </Points>\n<Polys>\n<DataArray type=\"UInt8\" Name=\"connectivity\" format=\"appended\" offset=\"0\"/>\n\
         <DataArray type=\"UInt8\" Name=\"offsets\" format=\"appended\" offset=\"12\"/>\n</Polys>\n</Piece>\n\
         </PolyData>\n<AppendedData encoding=\"base64\">_AwAAAAABAg==AQAAAAM=</AppendedData>\n</VTKFile>\n",
    ),
    (Format::Json, "{\"facets\":[[0,1,2]]}"),
    (Format::Isosig, "# figure 8\ncPcbbbiht\n"),
    (Format::Nrrd, "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 2 2\nencoding: ascii\n\n1 0 1 1\n"),
    (Format::Pgm, "P2\n2 2\n1\n1 0\n1 1\n"),
    (
        Format::MetaImage,
        "ObjectType = Image\nNDims = 2\nDimSize = 2 2\nBinaryData = False\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n1 0 1 1\n",
    ),
    (Format::Lines, "0,0,1,0\n1,0,0,1\n0,1,0,0\n"),
    (
        Format::GeoJson,
        "{\"type\":\"Feature\",\"properties\":{\"name\":\"a\"},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":\
         [[[0,0],[1,0],[0,1],[0,0]]]}}\n",
    ),
    (Format::Wkt, "POLYGON ((0 0, 1 0, 0 1, 0 0))\nPOINT (5 6)\n"),
    (
        Format::Svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\">\n<path d=\"M0 0 h1 v1 z\"/>\n<line x1=\"5\" y2=\"6\"/>\n</svg>\n",
    ),
];

fn sample(format: Format) -> &'static str {
    SAMPLES.iter().find(|(f, _)| *f == format).map(|(_, text)| *text).expect("a sample of every format")
}

/// The folder of the development data, if it is there.
fn data_folder(test: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("COFACE_DATA").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("{test}: COFACE_DATA is not set, so this is skipped");
    }
    folder
}

/// The real files: those that come with the sources, and the development data of the formats here.
fn real_files(test: &str) -> Vec<PathBuf> {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let mut folders = vec![shipped];
    if let Some(data) = data_folder(test) {
        folders.extend(["surfaces", "volumes", "complexes", "tricky", "planar"].map(|name| data.join(name)));
    }
    let mut files: Vec<PathBuf> = folders
        .iter()
        .filter_map(|folder| fs::read_dir(folder).ok())
        .flat_map(|entries| entries.filter_map(|entry| entry.ok().map(|entry| entry.path())))
        .filter(|path| Format::from_path(path).is_some())
        .collect();
    files.sort();
    files
}

/// Whether a fault says what to do, or at least where it is.
fn assert_helpful(error: &Error, context: &str) {
    assert!(
        error.cure().is_some() || error.line().is_some() || error.byte().is_some(),
        "{context}: \"{error}\" has neither a place nor a cure"
    );
    let text = error.to_string();
    assert!(text.len() < 4000 && !text.contains('\n'), "{context}: {text}");
    assert!(!text.chars().any(char::is_control), "{context}: {text:?}");
}

fn assert_sound(model: &Model, context: &str) {
    if let Err(error) = model.check() {
        panic!("{context}: a model that breaks its own rules: {error}");
    }
    assert!(model.positions().as_flat().iter().all(|x| x.is_finite()), "{context}");
}

#[test]
fn every_sample_is_read_and_recognized() {
    for (format, text) in SAMPLES {
        let model = io::read_unknown(text.as_bytes()).unwrap();
        assert_eq!(model.format(), Some(format));
        assert_eq!(io::read(text.as_bytes(), format).unwrap(), model);
        assert_sound(&model, text);
        let with_mark = [b"\xef\xbb\xbf", text.as_bytes()].concat();
        assert_eq!(io::read_unknown(&with_mark[..]).unwrap(), model);
    }
}

/// What to put for what in a sample, and what the message must say.
const FAULTS: [(Format, &str, &str, &str); 49] = [
    (Format::VtkGrid, "0 1 2 3<", "0 1 2 4<", "4"),
    (Format::VtkGrid, ">10<", ">42<", "polyhedra"),
    (Format::Off, "3 0 1 2", "3 0 1 3", "3"),
    (Format::Off, "3 0 1 2", "3 0 1 -2", "-2"),
    (Format::Off, "3 1 0\n", "4000000000 4000000000 0\n", ""),
    (Format::Off, "0 1 0", "0 one 0", "one"),
    (Format::Obj, "f 1 2 3", "f 1 2 4", "4"),
    (Format::Obj, "f 1 2 3", "f 1 2 -4", "-4"),
    (Format::Obj, "f 1 2 3", "f 1 2 0", "0"),
    (Format::Ply, "3 0 1 2", "3 0 1 3", "3"),
    (Format::Ply, "3 0 1 2", "3 0 1 -1", "-1"),
    (Format::Ply, "vertex 3", "vertex 4000000000", ""),
    (Format::Medit, "1 2 3 4 0", "1 2 3 5 0", "5"),
    (Format::Medit, "1 2 3 4 0", "1 2 3 0 0", "0"),
    (Format::Medit, "1 2 3 4 0", "1 2 3 -4 0", "-4"),
    (Format::Medit, "Vertices 4", "Vertices 4000000000", ""),
    (Format::Msh, "1 2 3 4\n$End", "1 2 3 5\n$End", "5"),
    (Format::Msh, "1 2 3 4\n$End", "1 2 3 -4\n$End", "-4"),
    (Format::Msh, "$Nodes\n4", "$Nodes\n4000000000000", ""),
    (Format::Vtk, "4 0 1 2 3\n", "4 0 1 2 4\n", "4"),
    (Format::Vtk, "4 0 1 2 3\n", "4 0 1 2 -3\n", "-3"),
    (Format::Vtk, "POINTS 4", "POINTS 4000000000000", ""),
    (Format::Vtk, "CELLS 1 5\n4 ", "CELLS 1 5000000000\n4000000000 ", ""),
    (Format::Ply, "0 1 0 3", "0 1 0 red", "red"),
    (Format::Vtk, "CELL_DATA 1", "CELL_DATA 2", "data on 2 cells, but there are 1"),
    (Format::Vtk, "default\n7", "default\nseven", "seven"),
    (Format::Vtk, "b 1 4", "b 1 3", "3 rows"),
    (Format::Vtk, "c 2 4", "c 4000000000 4", ""),
    (Format::Json, "[0,1,2]", "[0,1,-2]", "facet 0 is -2"),
    (Format::Json, "[0,1,2]", "[0,1,1.5]", "1.5"),
    (Format::Json, "[0,1,2]", "[0,1,1]", "facet 0 repeats vertex 1"),
    (Format::Json, "[0,1,2]", "[0,1,5000000000]", "5000000000"),
    (Format::Json, "[0,1,2]", "[]", "facet 0 has no vertex"),
    (Format::Json, "\"facets\":[[0,1,2]]", "\"gluings\":[[[0,[1,0]],null]]", "facet 1 of simplex 0"),
    (Format::Json, "\"facets\":[[0,1,2]]", "\"gluings\":[[[1,[1,0]],null]]", "simplex 1"),
    (Format::Json, "\"facets\":[[0,1,2]]", "\"gluings\":[[[0,[1,1]],null]]", "no permutation"),
    (Format::Isosig, "iht", "i*t", "character 8"),
    (Format::Isosig, "iht", "ih", "ends after 8"),
    (Format::Lines, "1,0,0,1", "1,0,0", "3 numbers"),
    (Format::Lines, "1,0,0,1", "1,0,0,inf", "inf"),
    (Format::Lines, "1,0,0,1", "1,0,0,b", "\"b\""),
    (Format::GeoJson, "[0,1]", "[0]", "one number"),
    (Format::GeoJson, "[0,1]", "[0,1e999]", "out of range"),
    (Format::GeoJson, "Polygon", "Polyhedron", "polyhedron"),
    (Format::Wkt, "0 1,", "0 nan,", "nan"),
    (Format::Wkt, "POINT", "PINT", "\"PINT\""),
    (Format::Svg, "h1", "h1e999", "number is missing"),
    (Format::Svg, "\"5\"", "\"5ells\"", "no length"),
    (Format::Svg, "</svg>", "", "root"),
];

/// What to put for what in a sample, so that a coordinate is not finite.
const NONFINITE: [(Format, &str, &str); 11] = [
    (Format::Off, "0 1 0", "0 nan 0"),
    (Format::Off, "0 1 0", "0 inf 0"),
    (Format::Off, "0 1 0", "0 1e999 0"),
    (Format::Obj, "v 0 1 0", "v 0 nan 0"),
    (Format::Obj, "v 0 1 0", "v 0 -inf 0"),
    (Format::Ply, "0 1 0", "0 nan 0"),
    (Format::Stl, "vertex 0 1 0", "vertex 0 nan 0"),
    (Format::Stl, "vertex 0 1 0", "vertex 0 inf 0"),
    (Format::Medit, "0 1 0 0", "0 nan 0 0"),
    (Format::Msh, "3 0 1 0", "3 0 inf 0"),
    (Format::Vtk, "0 1 0", "0 nan 0"),
];

#[test]
fn coordinates_that_are_not_finite_are_kept_and_refused_by_strict_reading() {
    for (format, from, to) in NONFINITE {
        let text = sample(format);
        assert!(text.contains(from), "{format:?} has no {from:?}");
        let context = format!("{format:?} with {to:?} for {from:?}");
        let text = text.replacen(from, to, 1);
        let model = io::read(text.as_bytes(), format).unwrap_or_else(|error| panic!("{context}: {error}"));
        assert_sound(&model, &context);
        assert!(model.require_finite().is_err(), "{context}");
        assert!(
            model.remarks().iter().any(|remark| remark.code == RemarkCode::NonfiniteCoordinate),
            "{context}"
        );
        let strict = ReadOptions::new().format(format).strict(true);
        let error = io::read_with(text.as_bytes(), &strict).expect_err(&context);
        let line = text.split(to).next().unwrap_or_default().lines().count() as u64 + 1;
        assert_eq!(error.line(), Some(line), "{context}: {error}");
        assert_helpful(&error, &context);
    }
}

#[test]
fn faults_are_named_with_their_place() {
    for (format, from, to, message) in FAULTS {
        let text = sample(format);
        assert!(text.contains(from), "{format:?} has no {from:?}");
        let context = format!("{format:?} with {to:?} for {from:?}");
        let error = io::read(text.replacen(from, to, 1).as_bytes(), format).expect_err(&context);
        let shown = error.to_string().to_lowercase();
        assert!(shown.contains(&message.to_lowercase()), "{context}: {shown}");
        // A count that lies has no place but the end of the file.
        let placed = error.line().is_some() || error.byte().is_some() || message.is_empty();
        assert!(placed, "{context}: no place in \"{shown}\"");
        assert_helpful(&error, &context);
    }
}

#[test]
fn samples_cut_short_are_refused_or_sound() {
    for (format, text) in SAMPLES {
        for cut in 0..text.len() {
            let context = format!("{format:?} cut at {cut}");
            match io::read(&text.as_bytes()[..cut], format) {
                Ok(model) => assert_sound(&model, &context),
                Err(error) => assert_helpful(&error, &context),
            }
        }
        let half = &text.as_bytes()[..text.len() / 2];
        // A text format without counts cannot know what is missing.
        if format != Format::Obj {
            assert!(io::read(half, format).is_err(), "{format:?}");
        }
    }
}

#[test]
fn files_that_are_no_models_get_one_message() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let fault = |path: &Path| {
        let error = io::read_path(path, None).unwrap_err();
        assert_eq!(error.file(), Some(path.display().to_string().as_str()));
        assert!(error.cure().is_some(), "{error}");
        (error.kind(), error.to_string())
    };
    let (kind, text) = fault(&path("missing.off"));
    assert_eq!(kind, ErrorKind::Io);
    assert!(text.contains("there is no such file"), "{text}");
    let (kind, text) = fault(folder.path());
    assert_eq!(kind, ErrorKind::Io);
    assert!(text.contains("is a directory"), "{text}");
    for format in Format::ALL {
        let path = path(&format!("a.{}", format.name()));
        for (bytes, message) in [
            (&b""[..], "the file is empty"),
            (b"  \n\n", "white space"),
            (&[0; 4096], "zero bytes"),
            (b"It was a dark and stormy night; the rain fell in torrents.\n", "the name says"),
            (b"\x1f\x8b\x08\0\0\0\0\0\0\x03", "gzip"),
        ] {
            fs::write(&path, bytes).unwrap();
            let (_, text) = fault(&path);
            assert!(text.contains(message), "{text}");
            let error = io::read_path(&path, Some(format)).unwrap_err();
            assert_helpful(&error, &format!("{format:?} as told"));
        }
    }
    fs::write(path("garbage"), (0..5000u32).map(|i| ((i * i) >> 7) as u8 ^ 0x5a).collect::<Vec<u8>>())
        .unwrap();
    let (kind, text) = fault(&path("garbage"));
    assert_eq!(kind, ErrorKind::UnsupportedFormat);
    assert!(text.contains("--format"), "{text}");
}

#[test]
fn a_wrong_extension_is_named_or_the_content_decides() {
    let folder = tempfile::tempdir().unwrap();
    for (real, text) in SAMPLES {
        for named in Format::ALL.into_iter().filter(|&named| named != real) {
            if (real, named) == (Format::GeoJson, Format::Json) {
                // GeoJSON is JSON.
                continue;
            }
            let path = folder.path().join(format!("a.{}", named.name()));
            fs::write(&path, text).unwrap();
            if real == Format::Lines && matches!(named, Format::TetGen | Format::Points) {
                // Lines of four numbers are what the name says.
                continue;
            }
            match io::read_path(&path, None) {
                // Content that is sure decides.
                Ok(model) => {
                    assert_eq!(model.format(), Some(real), "{}", path.display());
                    assert_eq!(model.remarks()[0].code, io::RemarkCode::FormatByContent);
                    let strict = io::ReadOptions::new().strict(true);
                    let error = io::read_path_with(&path, &strict).unwrap_err();
                    assert!(error.to_string().contains("the name says"), "{error}");
                }
                Err(error) => {
                    let cure = format!("--format {}", real.name());
                    assert!(error.cure().is_some_and(|text| text.contains(&cure)), "{error}");
                }
            }
            assert_eq!(io::read_path(&path, Some(real)).unwrap().format(), Some(real));
        }
        let path = folder.path().join("a.unknown");
        fs::write(&path, text).unwrap();
        assert_eq!(io::read_path(&path, None).unwrap().format(), Some(real));
    }
}

/// Endless bytes of one kind behind a start.
fn endless(start: &str, byte: u8) -> impl Read {
    std::io::Cursor::new(start.as_bytes().to_vec()).chain(std::io::repeat(byte).take(10 << 30))
}

#[test]
fn ten_gigabytes_of_zeros_are_refused_at_once() {
    assert!(io::read_unknown(endless("", 0)).is_err());
    for (format, text) in SAMPLES {
        assert_helpful(&io::read(endless("", 0), format).unwrap_err(), &format!("{format:?}, zeros"));
        // Zeros behind the first half of a sound file: the reader itself must stop.
        let start = &text[..text.len() / 2];
        let error = io::read(endless(start, 0), format).unwrap_err();
        assert_helpful(&error, &format!("{format:?}, zeros behind a start"));
    }
    let folder = tempfile::tempdir().unwrap();
    for format in Format::ALL {
        let path = folder.path().join(format!("zeros.{}", format.name()));
        fs::File::create(&path).unwrap().set_len(10 << 30).unwrap();
        let error = io::read_path(&path, None).unwrap_err();
        assert!(error.to_string().contains("zero bytes"), "{error}");
        fs::remove_file(&path).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn random_bytes_do_no_harm(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        for (format, text) in SAMPLES {
            for keep in [0, 10, text.len() / 2, text.len()] {
                let input = [&text.as_bytes()[..keep.min(text.len())], &bytes].concat();
                match io::read(&input[..], format) {
                    Ok(model) => assert_sound(&model, "random bytes"),
                    Err(error) => assert_helpful(&error, "random bytes"),
                }
            }
        }
        if let Err(error) = io::read_unknown(&bytes[..]) {
            assert_helpful(&error, "random bytes");
        }
    }

    #[test]
    fn samples_with_changed_words_do_no_harm(
        which in 0..SAMPLES.len(),
        at in any::<prop::sample::Index>(),
        word in prop::sample::select(vec![
            "-1", "0", "1", "2", "3", "99999999999999999999", "4294967295", "4294967296", "nan", "-inf", "1e308", "x", "",
            "2147483648", "-2147483648", "18446744073709551615", "{", "]", "#", "\"", "\n\n", "\u{0}",
        ]),
    ) {
        let (format, text) = SAMPLES[which];
        let words: Vec<(usize, &str)> = text.match_indices(|c: char| c.is_ascii_digit()).collect();
        let (place, digit) = words[at.index(words.len())];
        let changed = [&text[..place], word, &text[place + digit.len()..]].concat();
        match io::read(changed.as_bytes(), format) {
            Ok(model) => assert_sound(&model, &changed),
            Err(error) => assert_helpful(&error, &changed),
        }
    }
}

/// A generator of numbers with a known start, so that a failure can be repeated.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % limit.max(1)
    }
}

#[test]
fn mutated_real_files_do_no_harm() {
    let mut numbers = Numbers(2026);
    for path in real_files("mutated_real_files_do_no_harm") {
        let bytes = fs::read(&path).unwrap();
        let format = Format::from_path(&path).expect("files were chosen by their extension");
        // Small files, or the start of large ones, in every binary and text form that can be written.
        let mut forms = vec![bytes[..bytes.len().min(60_000)].to_vec()];
        if bytes.len() < 400_000
            && let Ok(model) = io::read(&bytes[..], format)
        {
            forms.extend(encodings(&model, format));
        }
        for form in forms {
            for _ in 0..12 {
                let mut mutated = form.clone();
                for _ in 0..1 + numbers.below(4) {
                    mutate(&mut mutated, &mut numbers);
                }
                let context = format!("{} mutated", path.display());
                match io::read(&mutated[..], format) {
                    Ok(model) => assert_sound(&model, &context),
                    Err(error) => assert_helpful(&error, &context),
                }
            }
        }
    }
}

/// The model in the other forms of its format.
fn encodings(model: &Model, format: Format) -> Vec<Vec<u8>> {
    use coface_io::{msh, ply, stl, vtk};
    let mut forms = Vec::new();
    let mut add = |write: &dyn Fn(&mut Vec<u8>) -> Result<(), Error>| {
        let mut out = Vec::new();
        if write(&mut out).is_ok() {
            forms.push(out);
        }
    };
    match format {
        Format::Ply => {
            for encoding in [ply::Encoding::Ascii, ply::Encoding::LittleEndian, ply::Encoding::BigEndian] {
                add(&|out| ply::write(model, out, encoding));
            }
        }
        Format::Stl => {
            for encoding in [stl::Encoding::Ascii, stl::Encoding::Binary] {
                add(&|out| stl::write(model, out, encoding));
            }
        }
        Format::Msh => {
            for version in [msh::Version::TwoTwo, msh::Version::FourOne] {
                add(&|out| msh::write(model, out, version));
            }
        }
        Format::Vtk => {
            for encoding in [vtk::Encoding::Ascii, vtk::Encoding::Binary] {
                add(&|out| vtk::write(model, out, encoding));
            }
        }
        _ => {}
    }
    forms
}

fn mutate(bytes: &mut Vec<u8>, numbers: &mut Numbers) {
    let at = numbers.below(bytes.len());
    // The header decides most, so half of the changes are there.
    let at = if numbers.below(2) == 0 { at.min(numbers.below(400)) } else { at };
    let end = (at + 1 + numbers.below(64)).min(bytes.len());
    match numbers.below(6) {
        0 => bytes.truncate(at),
        1 => bytes[at..end].iter_mut().for_each(|byte| *byte ^= numbers.below(256) as u8),
        2 => bytes[at..end].fill(b"09-. \n\0\xff"[numbers.below(8)]),
        3 => drop(bytes.drain(at..end)),
        4 => {
            let piece = bytes[at..end].to_vec();
            bytes.splice(at..at, piece);
        }
        _ => {
            let word: &[u8] =
                [&b"99999999999"[..], b"-7", b"nan", b"4294967295", b" 1 2 3 "][numbers.below(5)];
            bytes.splice(at..end.min(at + 2), word.iter().copied());
        }
    }
}

#[test]
fn every_format_converts_to_every_other_that_can_hold_it() {
    let folder = tempfile::tempdir().unwrap();
    let samples = SAMPLES.iter().map(|(format, text)| {
        let path = folder.path().join(format!("sample.{}", format.name()));
        fs::write(&path, text).unwrap();
        path
    });
    for path in samples.chain(real_files("every_format_converts")).collect::<Vec<_>>() {
        if fs::metadata(&path).unwrap().len() > 2_000_000 {
            continue;
        }
        let Ok(model) = io::read_path(&path, None) else { continue };
        for format in Format::ALL {
            let target = folder.path().join(format!("converted.{}", format.name()));
            let context = format!("{} to {}", path.display(), format.name());
            if let Err(error) = io::write_path(&model, &target, None) {
                assert!(
                    matches!(
                        error.kind(),
                        ErrorKind::UnsupportedFormat | ErrorKind::TooLarge | ErrorKind::InvalidInput
                    ),
                    "{context}: {error}"
                );
                assert_eq!(error.file(), Some(target.display().to_string().as_str()));
                assert!(error.cure().is_some(), "{context}: {error}");
                assert!(!target.exists(), "{context}");
                continue;
            }
            let back = io::read_path(&target, None).unwrap_or_else(|error| panic!("{context}: {error}"));
            fs::remove_file(&target).unwrap();
            assert_eq!(back.format(), Some(format));
            assert_sound(&back, &context);
            // Drawings have rings for polygons, and vertices where lines have ends.
            let draws = format.keeps_heights() || matches!(format, Format::Lines | Format::Svg);
            if format == Format::Container {
                let complex = |model: &Model| matches!(model.structure(), Some(Structure::Chains(_)));
                assert!(complex(&back), "{context}: a container holds the chain complex");
                continue;
            }
            let triangulates = matches!(format, Format::Stl | Format::ThreeMf | Format::Amf);
            if format != Format::Json && !triangulates && !draws {
                assert_eq!(back.vertex_count(), model.vertex_count(), "{context}");
                assert_eq!(back.polygons().len(), model.polygons().len(), "{context}");
                assert_eq!(back.cells().len(), model.cells().len(), "{context}");
            }
            if Some(format) == model.format() && format == Format::Json {
                assert_eq!(back, model, "{context}");
            }
        }
        // Nothing half-written stays behind.
        let left: Vec<_> = fs::read_dir(folder.path()).unwrap().filter_map(Result::ok).collect();
        assert!(left.iter().all(|entry| !entry.file_name().to_string_lossy().ends_with(".part")));
    }
}

#[test]
fn the_counts_of_the_development_data_hold() {
    let Some(data) = data_folder("the_counts_of_the_development_data_hold") else { return };
    let manifest = fs::read(data.join("MANIFEST.json")).unwrap();
    let manifest: serde_json::Value = serde_json::from_slice(&manifest).unwrap();
    let mut seen = 0;
    for record in manifest["files"].as_array().unwrap() {
        let name = record["file"].as_str().unwrap();
        if !name.starts_with("volumes/") {
            continue;
        }
        let model = io::read_path(data.join(name), None).unwrap();
        assert_eq!(model.format().unwrap().name(), record["format"].as_str().unwrap(), "{name}");
        assert_eq!(Some(model.vertex_count() as u64), record["vertices"].as_u64(), "{name}");
        assert_eq!(Some(model.cells().len() as u64), record["cells"].as_u64(), "{name}");
        for (key, size) in [("tets", 4), ("hexes", 8), ("prisms", 6)] {
            let count = model.cells().iter().filter(|cell| cell.len() == size).count() as u64;
            assert_eq!(Some(count), record[key].as_u64(), "{name}: {key}");
        }
        for (key, size) in [("Edges", 2), ("Triangles", 3), ("Quadrilaterals", 4)] {
            if let Some(count) = record["cells_in_file"][key].as_u64() {
                let lists = if size == 2 { model.lines() } else { model.polygons() };
                assert_eq!(
                    lists.iter().filter(|list| list.len() == size).count() as u64,
                    count,
                    "{name}: {key}"
                );
            }
        }
        seen += 1;
    }
    assert_eq!(seen, 5);
}

#[test]
fn groups_of_a_real_gmsh_file_keep_their_names() {
    let Some(data) = data_folder("groups_of_a_real_gmsh_file_keep_their_names") else { return };
    let model = io::read_path(data.join("volumes/box.msh"), None).unwrap();
    let names: Vec<&str> = model.groups().iter().map(io::Group::name).collect();
    for name in ["front", "back", "top", "all"] {
        assert!(names.contains(&name), "{names:?}");
    }
    let all = model.groups().iter().find(|group| group.name() == "all").unwrap();
    assert_eq!((all.kind(), all.members().len()), (io::GroupKind::Cells, model.cells().len()));
}

#[test]
fn entries_of_a_facet_list_are_chosen_by_name() {
    let Some(data) = data_folder("entries_of_a_facet_list_are_chosen_by_name") else { return };
    let path = data.join("complexes/facet_lists.json");
    // Without an entry the first is taken, and a remark says so.
    let first = io::read_path(&path, None).unwrap();
    assert_eq!(first.remarks()[0].code, io::RemarkCode::SeveralModels);
    let strict = io::ReadOptions::new().strict(true);
    let error = io::read_path_with(&path, &strict).unwrap_err().to_string();
    assert!(error.contains("RP^3"), "{error}");
    let records: serde_json::Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    for record in records.as_array().unwrap() {
        let name = record["name"].as_str().unwrap();
        let model = io::read_path(format!("{}#{name}", path.display()), None).unwrap();
        let Some(Structure::Facets(facets)) = model.structure() else { panic!("{name}") };
        assert_eq!(facets.len(), record["facets"].as_array().unwrap().len(), "{name}");
    }
    let error = io::read_path(format!("{}#nothing", path.display()), None).unwrap_err();
    assert!(error.to_string().contains("there is no entry nothing"), "{error}");
    let error = io::read_path_with(data.join("complexes/three_manifolds.json"), &strict).unwrap_err();
    assert!(error.to_string().contains("L(2,1)"), "{error}");
    let path = format!("{}#L(2,1)", data.join("complexes/three_manifolds.json").display());
    let model = io::read_path(path, None).unwrap();
    let Some(Structure::Gluings(table)) = model.structure() else { panic!("no gluing table") };
    assert_eq!(table.simplex_count(), 2);
}
