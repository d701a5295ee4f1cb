//! Few bytes cannot ask for much: what is read takes memory by what the file holds. Fuzzing and hand-made files have found these.

use coface_algebra::ErrorKind;
use coface_io::{self as io, Format};
use std::io::Write;

/// An archive whose parts are all in the same bytes: one local header, and a row of the directory for each name.
fn archive_of_one_part(text: &[u8], names: &[&str]) -> Vec<u8> {
    let mut deflated = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::best());
    deflated.write_all(text).expect("memory takes all bytes");
    let deflated = deflated.finish().expect("memory takes all bytes");
    let mut sum = flate2::Crc::new();
    sum.update(text);
    // Method, time, date, checksum and sizes stand in both headers.
    let common = |name: &str| {
        let mut bytes = vec![20, 0, 0, 0, 8, 0, 0, 0, 33, 0];
        for number in [sum.sum(), deflated.len() as u32, text.len() as u32] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend((name.len() as u16).to_le_bytes());
        bytes.extend([0, 0]);
        bytes
    };
    let mut archive = [b"PK\x03\x04".to_vec(), common(names[0]), names[0].into(), deflated.clone()].concat();
    let start = archive.len() as u32;
    for name in names {
        archive.extend(
            [b"PK\x01\x02\x14\x00".to_vec(), common(name), vec![0; 14], name.as_bytes().to_vec()].concat(),
        );
    }
    let length = archive.len() as u32 - start;
    let count = (names.len() as u16).to_le_bytes();
    archive.extend([b"PK\x05\x06\0\0\0\0".as_slice(), &count, &count].concat());
    archive.extend([length.to_le_bytes(), start.to_le_bytes()].concat());
    archive.extend([0, 0]);
    archive
}

#[test]
fn parts_of_an_archive_that_share_their_bytes_are_bounded_together() {
    let model = "<model><resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/></vertices><triangles/></mesh>\
                 </object></resources><build><item objectid=\"1\"/></build></model>";
    let archive = archive_of_one_part(model.as_bytes(), &["a.model", "b.model"]);
    assert_eq!(io::read(&archive[..], Format::ThreeMf).unwrap().vertex_count(), 1);
    let long = [model, &" ".repeat(30 << 20)].concat();
    let archive = archive_of_one_part(long.as_bytes(), &["a.model", "b.model"]);
    assert!(io::read(&archive[..], Format::ThreeMf).is_ok(), "60 MiB are within the limit");
    let archive = archive_of_one_part(long.as_bytes(), &["a.model", "b.model", "c.model"]);
    let error = io::read(&archive[..], Format::ThreeMf).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::TooLarge, "{error}");
}

#[test]
fn components_of_components_are_bounded_by_their_triangles() {
    let triangles = "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>".repeat(1500);
    let mut text = format!(
        "<model><resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>\
         <vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles>{triangles}</triangles></mesh></object>"
    );
    for id in 2..17 {
        let below = id - 1;
        text += &format!(
            "<object id=\"{id}\"><components>{}</components></object>",
            format!("<component objectid=\"{below}\"/>").repeat(2)
        );
    }
    text += "</resources><build><item objectid=\"16\"/></build></model>";
    let error = io::read(&archive_of_one_part(text.as_bytes(), &["3D/3dmodel.model"])[..], Format::ThreeMf)
        .unwrap_err();
    assert!(error.to_string().contains("places its meshes too often"), "{error}");
}

#[test]
fn primitives_of_gltf_that_share_a_buffer_are_bounded_together() {
    // Sparse accessors need no bytes for what they do not replace.
    let file = |primitives: usize| {
        let primitive = r#"{"attributes":{"POSITION":0},"mode":0},"#.repeat(primitives);
        let sparse =
            r#"{"count":1,"indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}"#;
        format!(
            r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":30000,"uri":"data:;base64,{}"}}],
            "bufferViews":[{{"buffer":0,"byteLength":30000}}],
            "accessors":[{{"componentType":5126,"count":30000,"type":"VEC3","min":[0,0,0],"max":[0,0,0],"sparse":{sparse}}}],
            "meshes":[{{"primitives":[{}]}}]}}"#,
            "A".repeat(40_000),
            primitive.trim_end_matches(',')
        )
    };
    assert_eq!(io::read(file(1).as_bytes(), Format::Gltf).unwrap().vertex_count(), 1);
    let error = io::read(file(600).as_bytes(), Format::Gltf).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::TooLarge, "{error}");
}

#[test]
fn a_scene_of_gltf_without_nodes_is_empty() {
    let text = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"name":"empty"}]}"#;
    let model = io::read(text.as_bytes(), Format::Gltf).unwrap();
    assert_eq!((model.vertex_count(), model.polygons().len()), (0, 0));
    let mut binary = b"glTF\x02\0\0\0".to_vec();
    binary.extend((20 + text.len() as u32 + 3).to_le_bytes());
    binary.extend((text.len() as u32 + 3).to_le_bytes());
    binary.extend([b"JSON", text.as_bytes(), b"   "].concat());
    assert_eq!((text.len() + 3) % 4, 0, "chunks are of four bytes each");
    assert_eq!(io::read(&binary[..], Format::Gltf).unwrap(), model);
    assert!(io::read(&b"{\"scenes\":[{}]}"[..], Format::Gltf).is_err(), "there is no version");
}

#[test]
fn gltf_is_read_without_what_shapes_do_not_need() {
    // Three points and their triangle, in base64, without bounds of the positions.
    let file = |more: &str| {
        format!(
            r#"{{"asset":{{"version":"2.0"}},{more}"buffers":[{{"byteLength":36,"uri":"data:;base64,{}"}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}]}}"#,
            "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
        )
    };
    for more in
        ["", r#""extensionsUsed":["KHR_technique_webgl"],"extensionsRequired":["KHR_technique_webgl"],"#]
    {
        let model = io::read(file(more).as_bytes(), Format::Gltf).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(model.positions().as_flat(), [0., 0., 0., 1., 0., 0., 0., 1., 0.]);
        assert_eq!(model.polygons().len(), 1);
    }
    let own = file("").replace("\"POSITION\":0", "\"POSITION\":0,\"_TEMPERATURE\":0,\"_FEATURE_ID_0\":0");
    assert_eq!(io::read(own.as_bytes(), Format::Gltf).unwrap().polygons().len(), 1);
    let error =
        io::read(file(r#""extensionsRequired":["KHR_draco_mesh_compression"],"#).as_bytes(), Format::Gltf)
            .unwrap_err();
    assert!(error.to_string().contains("compressed (KHR_draco_mesh_compression)"), "{error}");
    let error =
        io::read(&br#"{"asset":{"version":"1.0"},"meshes":{"box":{"primitives":[]}}}"#[..], Format::Gltf)
            .unwrap_err();
    assert!(error.to_string().contains("glTF 1.0"), "{error}");
}

#[test]
fn positions_of_gltf_must_be_an_accessor_that_is_there() {
    for accessors in
        ["", r#""accessors":[{"componentType":5126,"count":1,"type":"VEC3","min":[0,0,0],"max":[0,0,0]}],"#]
    {
        let text = format!(
            r#"{{"asset":{{"version":"2.0"}},{accessors}"meshes":[{{"primitives":[{{"attributes":{{"POSITION":255}}}}]}}]}}"#
        );
        let error = io::read(text.as_bytes(), Format::Gltf).unwrap_err().to_string();
        assert!(error.contains("names accessor 255"), "{error}");
    }
}

#[test]
fn a_curve_of_one_arc_is_written_and_read() {
    let text = r#"{"order":4,"curves":[{"points":[[0,0]],"kinks":[0],"controls":[[0,0],[3,0],[0,3]]}]}"#;
    let drawing = io::read_boundary(text.as_bytes(), Format::Json, &io::ReadOptions::new()).unwrap();
    assert_eq!(drawing.curves()[0].points(), [[0.0, 0.0]]);
    for refused in [
        r#"{"order":4,"curves":[{"points":[[0,0]]}]}"#,
        r#"{"order":2,"curves":[{"points":[[0,0]],"controls":[[0,0]]}]}"#,
        r#"{"order":4,"curves":[{"points":[],"controls":[]}]}"#,
    ] {
        let error = io::read_boundary(refused.as_bytes(), Format::Json, &io::ReadOptions::new()).unwrap_err();
        assert!(error.to_string().contains("bounds nothing"), "{error}");
    }
}

#[test]
fn gltf_may_have_whole_numbers() {
    // Sixteen bits each, of which the largest stands for one: 0 0 0, 1 0 0, 0 -1 0.
    let text = r#"{"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],
        "extensionsRequired":["KHR_mesh_quantization"],"buffers":[{"byteLength":24,"uri":"data:;base64,AAAAAAAAAAD/fwAAAAAAAAAAAYAAAAAA"}],
        "bufferViews":[{"buffer":0,"byteLength":24,"byteStride":8}],
        "accessors":[{"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3","min":[0,-32767,0],"max":[32767,0,0]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0,"scale":[2,2,2]}],"scenes":[{"nodes":[0]}]}"#;
    let model = io::read(text.as_bytes(), Format::Gltf).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(model.positions().as_flat(), [0., 0., 0., 2., 0., 0., 0., -2., 0.]);
}
