//! What readers take: memory by what a file holds, never by what it claims. `docs/limits.md` has the table.

use coface_allocator::CountingAllocator;
use coface_io::{Format, ReadOptions};
use std::fmt::Write;
use std::sync::Mutex;

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator::new();

/// Tests that measure run one after the other.
static ALONE: Mutex<()> = Mutex::new(());

/// What any reader may take besides, for buffers.
const FIXED: usize = 1 << 20;
/// What a file of a line may take, whatever it claims.
const CLAIM: usize = 40 << 20;

/// The most bytes held while a file is read, beyond those before.
fn peak_of(bytes: &[u8], format: Format) -> (usize, Result<(), String>) {
    let before = ALLOCATOR.held();
    ALLOCATOR.restart_peak();
    let read = coface_io::read_with(bytes, &ReadOptions::new().format(Some(format)));
    let peak = ALLOCATOR.peak() - before;
    (peak, read.map(drop).map_err(|error| error.to_string()))
}

/// So many repetitions of a text.
fn lines(count: usize, line: &str) -> String {
    line.repeat(count)
}

/// Files in which every byte counts: as many cells a byte as the format allows.
fn dense_files() -> Vec<(Format, &'static str, Vec<u8>)> {
    let n = 20_000;
    let mut files: Vec<(Format, &'static str, Vec<u8>)> = Vec::new();
    let mut add = |format, what, bytes: Vec<u8>| files.push((format, what, bytes));
    let off = |faces: String, count: usize| format!("OFF\n{n} {count} 0\n{}{faces}", lines(n, "0 0 0\n"));
    add(Format::Off, "points", off(String::new(), 0).into_bytes());
    add(Format::Off, "triangles", off(lines(n, "3 0 1 2\n"), n).into_bytes());
    add(Format::Obj, "points", lines(n, "v 0 0 0\n").into_bytes());
    add(Format::Obj, "triangles", ("v 0 0 0\n".repeat(9) + &lines(n, "f 1 2 3\n")).into_bytes());
    add(Format::Obj, "lines", ("v 0 0 0\n".repeat(9) + &lines(n, "l 1 2\n")).into_bytes());
    add(Format::Obj, "marked points", ("v 0 0 0\n".repeat(9) + &lines(n, "p 1\n")).into_bytes());
    let header = |vertices: usize, faces: usize| {
        format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty uchar x\nproperty uchar y\n\
             property uchar z\nelement face {faces}\nproperty list uchar uchar vertex_indices\nend_header\n"
        )
        .into_bytes()
    };
    add(Format::Ply, "points of bytes", [header(n, 0), vec![0; 3 * n]].concat());
    add(Format::Ply, "triangles of bytes", [header(9, n), vec![0; 27], [3, 0, 1, 2].repeat(n)].concat());
    let mut stl = [vec![b' '; 80], (n as u32).to_le_bytes().to_vec()].concat();
    for i in 0..n {
        let corners = [[0.0, 0.0, i as f32], [1.0, 0.0, i as f32], [0.0, 1.0, i as f32]];
        stl.extend([0.0f32; 3].iter().chain(corners.as_flattened()).flat_map(|x| x.to_le_bytes()));
        stl.extend([0, 0]);
    }
    add(Format::Stl, "binary", stl);
    let facet =
        "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    add(Format::Stl, "text", format!("solid\n{}endsolid\n", lines(n / 4, facet)).into_bytes());
    let medit = format!(
        "MeshVersionFormatted 1\nDimension 3\nVertices {n}\n{}Tetrahedra {n}\n{}End\n",
        lines(n, "0 0 0 0\n"),
        lines(n, "1 2 3 4 0\n")
    );
    add(Format::Medit, "tetrahedra", medit.into_bytes());
    let mut nodes = String::new();
    let mut elements = String::new();
    for i in 1..=n {
        let _ = writeln!(nodes, "{i} 0 0 0");
        let _ = writeln!(elements, "{i} 15 0 {i}");
    }
    let msh = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{n}\n{nodes}$EndNodes\n$Elements\n{n}\n{elements}$EndElements\n"
    );
    add(Format::Msh, "points", msh.into_bytes());
    let vtk = |cells: &str, kind: u8| {
        let width = cells.split(' ').count();
        format!(
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {n} float\n{}CELLS {n} {}\n{}\
             CELL_TYPES {n}\n{}",
            lines(n, "0 0 0\n"),
            n * width,
            lines(n, &format!("{cells}\n")),
            lines(n, &format!("{kind}\n"))
        )
        .into_bytes()
    };
    add(Format::Vtk, "tetrahedra", vtk("4 0 1 2 3", 10));
    add(Format::Vtk, "marked points", vtk("1 0", 1));
    let grid = "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 60 60 60\nORIGIN 0 0 0\n\
                SPACING 1 1 1\nPOINT_DATA 216000\nSCALARS a unsigned_char 1\nLOOKUP_TABLE default\n";
    add(Format::Vtk, "grid of bytes", [grid.as_bytes(), &vec![1; 216_000]].concat());
    let xml = format!(
        "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"{n}\" NumberOfCells=\"{n}\"><Points>\
         <DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">{}</DataArray></Points><Cells>\
         <DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">{}</DataArray>\
         <DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">{}</DataArray>\
         <DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">{}</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>",
        lines(n, "0 0 0 "),
        lines(n, "0 "),
        (1..=n).map(|i| format!("{i} ")).collect::<String>(),
        lines(n, "1 ")
    );
    add(Format::VtkGrid, "marked points", xml.into_bytes());
    add(Format::Json, "triangles", format!("[{}[0,1,2]]", lines(n, "[0,1,2],")).into_bytes());
    add(Format::Json, "points", format!("[{}[0]]", lines(n, "[0],")).into_bytes());
    let entries: String = (0..n).map(|i| format!("[{},{i},1],", i % 9)).collect();
    let matrix = format!(
        "{{\"boundaries\":[{{\"rows\":9,\"cols\":{n},\"entries\":[{}]}}]}}",
        entries.trim_end_matches(',')
    );
    add(Format::Json, "matrix", matrix.into_bytes());
    add(Format::Lines, "segments", lines(n, "0 0 1 1\n").into_bytes());
    add(Format::Points, "points", (0..n).map(|i| format!("{i} 0\n")).collect::<String>().into_bytes());
    let ring = "[[[0,0],[1,0],[0,1],[0,0]]],";
    let polygons = format!(
        "{{\"type\":\"MultiPolygon\",\"coordinates\":[{}[[[0,0],[1,0],[0,1],[0,0]]]]}}",
        lines(n, ring)
    );
    add(Format::GeoJson, "triangles", polygons.into_bytes());
    let points = format!("{{\"type\":\"MultiPoint\",\"coordinates\":[{}[0,0]]}}", lines(n, "[0,0],"));
    add(Format::GeoJson, "points", points.into_bytes());
    add(Format::Wkt, "segments", format!("LINESTRING({}0 0)", lines(n, "0 0,1 1,")).into_bytes());
    add(Format::Wkt, "points", format!("MULTIPOINT({}0 0)", lines(n, "0 0,")).into_bytes());
    add(Format::Svg, "path", format!("<svg><path d=\"M0 0{}\"/></svg>", lines(n, "h1v1")).into_bytes());
    add(Format::Svg, "curves", format!("<svg><path d=\"M0 0{}\"/></svg>", lines(n, "q1 0 1 1")).into_bytes());
    add(Format::Svg, "circles", format!("<svg>{}</svg>", lines(n / 4, "<circle r=\"1\"/>")).into_bytes());
    add(Format::Svg, "elements", format!("<svg>{}</svg>", lines(n, "<line x2=\"1\"/>")).into_bytes());
    let mut npy = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    npy.extend(
        format!("{:117}\n", "{'descr': '|u1', 'fortran_order': False, 'shape': (60, 60, 60), }").bytes(),
    );
    npy.extend(vec![1; 216_000]);
    add(Format::Npy, "bytes", npy);
    let nrrd = "NRRD0001\ntype: uchar\ndimension: 3\nsizes: 60 60 60\nencoding: raw\n\n";
    add(Format::Nrrd, "bytes", [nrrd.as_bytes(), &vec![1; 216_000]].concat());
    let mha = "NDims = 3\nDimSize = 60 60 60\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
    add(Format::MetaImage, "bytes", [mha.as_bytes(), &vec![1; 216_000]].concat());
    add(Format::Pgm, "bytes", [&b"P5 600 360 255\n"[..], &vec![1; 216_000]].concat());
    add(Format::Png, "noise", noise_image());
    let inp = format!(
        "*NODE\n{}*ELEMENT, TYPE=S3\n{}",
        (1..=n).map(|i| format!("{i},0,0\n")).collect::<String>(),
        (1..=n).map(|i| format!("{i},1,2,3\n")).collect::<String>()
    );
    add(Format::Abaqus, "triangles", inp.into_bytes());
    let gltf = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scenes\":[{{\"nodes\":[0]}}],\"scene\":0,\"nodes\":[{{\"mesh\":0}}],\"meshes\":\
         [{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":1}}]}}],\"accessors\":[{{\"bufferView\":0,\
         \"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[0,0,0]}},{{\"bufferView\":1,\"componentType\":5121,\
         \"count\":{c},\"type\":\"SCALAR\"}}],\"bufferViews\":[{{\"buffer\":0,\"byteLength\":36}},{{\"buffer\":0,\"byteOffset\":36,\
         \"byteLength\":{c}}}],\"buffers\":[{{\"byteLength\":{b},\"uri\":\"data:application/octet-stream;base64,{}\"}}]}}",
        "AAAA".repeat((36 + 3 * n) / 3),
        c = 3 * n,
        b = 36 + 3 * n
    );
    add(Format::Gltf, "triangles of bytes", gltf.into_bytes());
    let city = |geometry: String, vertices: String| {
        format!(
            "{{\"type\":\"CityJSON\",\"CityObjects\":{{\"a\":{{\"type\":\"Building\",\"geometry\":[{geometry}]}}}},\"vertices\":[{vertices}]}}"
        )
    };
    let triangles =
        format!("{{\"type\":\"MultiSurface\",\"boundaries\":[{}[[0,1,2]]]}}", "[[0,1,2]],".repeat(n));
    let corners = "[0,0,0],[1,0,0],[0,1,0]".to_owned();
    add(Format::CityJson, "triangles", city(triangles, corners.clone()).into_bytes());
    let points = format!("{{\"type\":\"MultiPoint\",\"boundaries\":[{}]}}", "0,".repeat(n) + "1");
    add(Format::CityJson, "points", city(points, "[0,0,0],".repeat(n) + &corners).into_bytes());
    let empty = "{\"type\":\"Solid\",\"boundaries\":[]}";
    add(Format::CityJson, "geometries", city(vec![empty; n / 4].join(","), corners).into_bytes());
    let matrix = format!("%%MatrixMarket matrix coordinate integer general\n9 {n} {n}\n");
    let entries: String = (1..=n).map(|column| format!("1 {column} 1\n")).collect();
    add(Format::MatrixMarket, "entries", (matrix + &entries).into_bytes());
    add(Format::Isosig, "one tetrahedron a few letters", b"cMcabbgqw\n".repeat(n));
    files
}

/// The most bytes of memory for each byte of a file, by format. `docs/limits.md` has the same.
const BOUNDS: [(Format, usize); 24] = [
    (Format::Off, 16),
    (Format::Obj, 12),
    (Format::Ply, 20),
    (Format::Stl, 6),
    (Format::Medit, 8),
    (Format::Msh, 6),
    (Format::Vtk, 100),
    (Format::VtkGrid, 10),
    (Format::Json, 8),
    (Format::Lines, 40),
    (Format::Points, 12),
    (Format::GeoJson, 32),
    (Format::CityJson, 100),
    (Format::Wkt, 48),
    (Format::Svg, 400),
    (Format::Npy, 4),
    (Format::Nrrd, 4),
    (Format::MetaImage, 4),
    (Format::Pgm, 4),
    (Format::Png, 4),
    (Format::Abaqus, 10),
    (Format::Gltf, 24),
    (Format::Isosig, 4),
    (Format::MatrixMarket, 16),
];

#[test]
fn readers_take_so_much_a_byte() {
    let _alone = ALONE.lock().unwrap();
    let mut faults = String::new();
    for (format, what, bytes) in dense_files() {
        let (peak, read) = peak_of(&bytes, format);
        let ratio = peak as f64 / bytes.len() as f64;
        let bound = BOUNDS.iter().find(|bound| bound.0 == format).unwrap().1;
        println!("{:10} {what:30} {:8} bytes, {ratio:6.1} a byte, {read:?}", format.name(), bytes.len());
        if peak > bound * bytes.len() + FIXED {
            let _ = writeln!(faults, "{} {what}: {ratio:.1} bytes a byte, more than {bound}", format.name());
        }
        assert!(read.is_ok(), "{} {what}: {read:?}", format.name());
    }
    assert!(faults.is_empty(), "{faults}");
}

/// Pixels that cannot be packed.
fn noise_image() -> Vec<u8> {
    let mut state = 1u32;
    let pixels: Vec<u8> = std::iter::repeat_with(|| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    })
    .take(216_000)
    .collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 600, 360);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.write_header().expect("a header").write_image_data(&pixels).expect("all pixels");
    bytes
}

/// Files of a few lines that claim to be huge.
fn claims() -> Vec<(Format, String)> {
    let mut files: Vec<(Format, String)> = Vec::new();
    for count in ["16777216", "4294967295", "9223372036854775807", "18446744073709551615"] {
        let vtk = |rest: &str| format!("# vtk DataFile Version 3.0\nt\nASCII\n{}", rest.replace('N', count));
        let xml = |rest: &str| {
            format!("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>{}", rest.replace('N', count))
        };
        let with = |text: &str| text.replace('N', count);
        files.extend([
            (Format::Off, format!("OFF\n{count} {count} {count}\n0 0 0\n")),
            (Format::Off, format!("OFF BINARY\n{count} 0 0\n")),
            (Format::Off, format!("OFF\n1 1 0\n0 0 0\n{count} 0 0 0\n")),
            (Format::Obj, format!("v 0 0 0\nf 1 {count} 2\nl {count} 1\n")),
            (
                Format::Ply,
                with("ply\nformat ascii 1.0\nelement vertex N\nproperty float x\nelement face N\nproperty list uint int vertex_indices\nend_header\n"),
            ),
            (
                Format::Ply,
                with("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nelement face 1\nproperty list uint int vertex_indices\nend_header\n0 0\nN 0 0 0\n"),
            ),
            (Format::Medit, with("MeshVersionFormatted 2\nDimension 3\nVertices N\n0 0 0 0\n")),
            (Format::Medit, with("MeshVersionFormatted 2\nDimension N\nVertices 1\n0 0 0 0\n")),
            (Format::Msh, with("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nN\n1 0 0 0\n")),
            (Format::Msh, with("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\nN 0 0 0\n$EndNodes\n$Elements\nN\n1 15 0 N\n")),
            (Format::Msh, with("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\nN N N N\n")),
            (Format::Msh, with("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\nN N N N\n2 1 0 N\n")),
            (Format::Vtk, vtk("DATASET UNSTRUCTURED_GRID\nPOINTS N float\n0 0 0\n")),
            (Format::Vtk, vtk("DATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\nCELLS N N\n1 0\n")),
            (Format::Vtk, vtk("DATASET POLYDATA\nPOINTS 1 float\n0 0 0\nPOLYGONS 1 N\nN 0\n")),
            (Format::Vtk, vtk("DATASET STRUCTURED_POINTS\nDIMENSIONS N N N\nORIGIN 0 0 0\nSPACING 1 1 1\n")),
            (Format::Vtk, vtk("DATASET STRUCTURED_POINTS\nDIMENSIONS N 1 1\nORIGIN 0 0 0\nSPACING 1 1 1\n")),
            (Format::Vtk, vtk("DATASET RECTILINEAR_GRID\nDIMENSIONS 1 1 1\nX_COORDINATES N float\n0\n")),
            (Format::VtkGrid, xml("<Piece NumberOfPoints=\"N\" NumberOfCells=\"N\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\">0 0 0</DataArray></Points></Piece></UnstructuredGrid></VTKFile>")),
            (Format::Json, with("[[0,1,N]]")),
            (Format::Json, with("{\"boundaries\":[{\"rows\":N,\"cols\":N,\"entries\":[]}]}")),
            (Format::Json, with("{\"boundaries\":[{\"rows\":1048576,\"cols\":1048576,\"entries\":[]},{\"rows\":1048576,\"cols\":N,\"entries\":[]}]}")),
            (Format::Json, with("{\"d0\":{\"rows\":N,\"cols\":N,\"coo\":[]}}")),
            (Format::Json, with("{\"d0\":[[N,0,1]]}")),
            (Format::Json, with("{\"next\":[0],\"twin\":[N]}")),
            (Format::Json, with("{\"gluings\":[[[N,[0,1,2]],null,null]]}")),
            (Format::Isosig, format!("{}\n", "_".repeat(60))),
            (Format::GeoJson, with("{\"type\":\"Topology\",\"arcs\":[[[0,0],[1,1]]],\"objects\":{\"a\":{\"type\":\"LineString\",\"arcs\":[N]}}}")),
            (Format::Svg, with("<svg><circle r=\"N\"/></svg>")),
            (Format::Npy, format!("\u{1}NUMPY\u{1}{count}")),
            (Format::Nrrd, with("NRRD0001\ntype: uchar\ndimension: 3\nsizes: N N N\nencoding: raw\n\n")),
            (Format::Nrrd, with("NRRD0001\ntype: uchar\ndimension: N\nsizes: 1\nencoding: raw\n\n")),
            (Format::MetaImage, with("NDims = 3\nDimSize = N N N\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n")),
            (Format::Pgm, with("P5 N N 255\n")),
            (Format::Abaqus, with("*NODE\nN,0,0,0\n*ELEMENT,TYPE=S3\nN,N,N,N\n*NSET, GENERATE, NSET=a\n1, N, 1\n")),
            (Format::Points, with("N 0\n")),
            (Format::MatrixMarket, with("%%MatrixMarket matrix coordinate pattern general\nN N N\n1 1\n")),
        ]);
    }
    // Boundary matrices by the hundred.
    let matrix = "{\"rows\":1048576,\"cols\":1048576,\"entries\":[]}";
    let matrices = vec![matrix; 50].join(",");
    files.push((Format::Json, format!("{{\"boundaries\":[{matrices}]}}")));
    files
}

#[test]
fn claims_take_nothing() {
    let _alone = ALONE.lock().unwrap();
    let mut faults = String::new();
    for (format, text) in claims() {
        let (peak, read) = peak_of(text.as_bytes(), format);
        if peak > CLAIM {
            let _ = writeln!(faults, "{} takes {} MB: {read:?}: {text}", format.name(), peak >> 20);
        }
    }
    assert!(faults.is_empty(), "{faults}");
}

#[test]
fn the_table_of_the_docs_is_that_of_the_tests() {
    let page = include_str!("../../../docs/limits.md");
    for (format, bound) in BOUNDS {
        let row = format!("| {} | {bound} |", format.name());
        assert!(page.contains(&row), "docs/limits.md lacks the row {row}");
    }
}

/// An array of 72 bytes in a file that holds 4,000 packed blocks of a mebibyte each.
#[test]
fn a_packed_array_is_not_unpacked_beyond_its_numbers() {
    use base64::Engine;
    use std::io::Write as _;
    let _alone = ALONE.lock().unwrap();
    let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
    encoder.write_all(&vec![0; 1 << 20]).unwrap();
    let block = encoder.finish().unwrap();
    let count = 4000u64;
    let numbers = [count, 1 << 20, 0].into_iter().chain((0..count).map(|_| block.len() as u64));
    let header: Vec<u8> = numbers.flat_map(u64::to_le_bytes).collect();
    let encode = |bytes: &[u8]| base64::engine::general_purpose::STANDARD.encode(bytes);
    let text = format!(
        "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"UInt64\" \
         compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points>\
         <DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"binary\">{}{}</DataArray></Points></Piece>\
         </UnstructuredGrid></VTKFile>",
        encode(&header),
        encode(&block.repeat(count as usize))
    );
    let (peak, read) = peak_of(text.as_bytes(), Format::VtkGrid);
    let message = read.unwrap_err();
    assert!(message.contains("4194304000 bytes where the numbers have 72"), "{message}");
    assert!(peak < 10 * text.len(), "{peak} bytes for a file of {}", text.len());
}
