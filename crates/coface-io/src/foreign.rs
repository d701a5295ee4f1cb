//! Formats that are not read, told by their first bytes, so that a message can name them.

const CONVERT: &str = "convert it to one of the formats known here first";
const UNPACK: &str = "unpack it first";

/// What a file is and what to do about it.
type Known = (&'static str, &'static str);

/// Beginnings of files.
const MARKS: [(&[u8], &str, &str); 46] = [
    (b"\x1f\x8b", "compressed by gzip", UNPACK),
    (b"PK\x03\x04", "a ZIP archive", UNPACK),
    (b"BZh", "compressed by bzip2", UNPACK),
    (b"\xfd7zXZ", "compressed by xz", UNPACK),
    (b"\x28\xb5\x2f\xfd", "compressed by zstd", UNPACK),
    (b"7z\xbc\xaf", "a 7-Zip archive", UNPACK),
    (b"Rar!", "a RAR archive", UNPACK),
    (b"\xff\xfe", "text in UTF-16 or UTF-32 that begins with no letter", "save it as plain text (UTF-8)"),
    (b"\xfe\xff", "text in UTF-16 that begins with no letter", "save it as plain text (UTF-8)"),
    (
        b"version https://git-lfs",
        "a pointer of Git LFS, not the file itself",
        "fetch the file with git lfs pull",
    ),
    (b"Kaydara FBX", "FBX", CONVERT),
    (b"; FBX", "FBX", CONVERT),
    (b"BLENDER", "a Blender file", "export it from Blender as OBJ, PLY or STL"),
    (b"ISO-10303-21", "STEP", "export a mesh of it, such as STL"),
    (b"AutoCAD Binary DXF", "DXF", CONVERT),
    (b"AC10", "DWG", CONVERT),
    (b"3D Geometry File Format", "a Rhino 3DM file", CONVERT),
    (b"xof 0", "a DirectX .x file", CONVERT),
    (b"#VRML", "VRML", CONVERT),
    (b"#X3D", "X3D", CONVERT),
    (b"#usda", "USD", CONVERT),
    (b"PXR-USDC", "USD", CONVERT),
    (b"#binvox", "a binvox volume", "convert it to .npy or NRRD first"),
    (b"OCTM", "OpenCTM", CONVERT),
    (b"DRACO", "Draco", CONVERT),
    (b"#INVENTOR", "an Open Inventor file", CONVERT),
    (b"#Inventor", "an Open Inventor file", CONVERT),
    (b"LASF", "LAS", "convert it to .xyz or PLY first"),
    (b"\x89HDF", "HDF5, as MED, XDMF and CGNS files are", "convert it to VTK or Gmsh MSH first"),
    (b"CDF\x01", "NetCDF, as Exodus files are", "convert it to VTK or Gmsh MSH first"),
    (b"CDF\x02", "NetCDF, as Exodus files are", "convert it to VTK or Gmsh MSH first"),
    (b"SQLite format 3", "SQLite, as GeoPackage files are", "convert it to GeoJSON first"),
    (b"fgb\x03", "FlatGeobuf", "convert it to GeoJSON first"),
    (b"\0\0\x27\x0a", "an ESRI shapefile", "convert it to GeoJSON first"),
    (b"\xff\xd8\xff", "a JPEG picture", CONVERT),
    (b"GIF8", "a GIF picture", CONVERT),
    (b"II*\0", "a TIFF picture", CONVERT),
    (b"MM\0*", "a TIFF picture", CONVERT),
    (b"%PDF", "a PDF document", CONVERT),
    (b"%!PS", "PostScript", CONVERT),
    (b"\x80\x04\x95", "a Python pickle", "write the arrays with numpy.save"),
    (b"MATLAB 5.0", "a MATLAB file", CONVERT),
    (b"\x7fELF", "a program", "name the file of the model"),
    (b"MZ\x90", "a program", "name the file of the model"),
    (b"!<arch>", "a library of programs", "name the file of the model"),
    (b"\xca\xfe\xba\xbe", "a program", "name the file of the model"),
];

/// Elements of XML.
const ELEMENTS: [(&[u8], &str, &str); 9] = [
    (b"<kml", "KML", "convert it to GeoJSON first"),
    (b"<Xdmf", "XDMF", "convert it to VTK or Gmsh MSH first"),
    (b"<X3D", "X3D", CONVERT),
    (b"<osm", "OpenStreetMap data", "convert it to GeoJSON first"),
    (b"<gpx", "GPX", "convert it to GeoJSON first"),
    (b"<VTKFile", "VTK XML of a kind that is not read", CONVERT),
    (b"http://www.opengis.net/gml", "GML", "convert it to GeoJSON or WKT first"),
    (b"<html", "HTML", "name the file of the model: this is a page about it"),
    (b"<!DOCTYPE html", "HTML", "name the file of the model: this is a page about it"),
];

/// What a file is that no reader here takes for its own, whatever its name.
pub(super) fn surely(start: &[u8]) -> Option<Known> {
    let text = start.trim_ascii_start();
    if text.starts_with(b"ISO-10303-21") && memchr::memmem::find(text, b"'IFC").is_some() {
        return Some(("IFC", "export a mesh of it, such as OBJ"));
    }
    text.starts_with(b"version https://git-lfs").then(|| perhaps(text)).flatten()
}

/// What a file is that is none of ours, unless a reader here takes it for its own.
pub(super) fn perhaps(start: &[u8]) -> Option<Known> {
    let start = start.trim_ascii_start();
    let of = |(mark, what, cure): &(&[u8], &'static str, &'static str)| {
        start.starts_with(mark).then_some((*what, *cure))
    };
    if let Some(known) = MARKS.iter().find_map(of) {
        return Some(known);
    }
    if start.starts_with(b"<") {
        let find = |&(mark, what, cure): &(&[u8], &'static str, &'static str)| {
            memchr::memmem::find(start, mark).map(|_| (what, cure))
        };
        return ELEMENTS.iter().find_map(find).or(Some(("XML of a kind that is not known here", CONVERT)));
    }
    if is_nastran(start) {
        return Some(("a Nastran file", "convert it to VTK or Gmsh MSH first"));
    }
    let mut lines = start.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    match (lines.next()?, lines.next()) {
        (b"0", Some(b"SECTION")) | (b"999", _) => Some(("DXF", CONVERT)),
        (line, _) if line.starts_with(b"TITLE") || line.starts_with(b"VARIABLES") => {
            Some(("Tecplot data", "convert it to VTK first"))
        }
        // The letter of the section stands in column 73 of the cards of IGES.
        (line, _)
            if line.len() >= 73
                && line.len() <= 80
                && line[72] == b'S'
                && line[73..].trim_ascii() == b"1" =>
        {
            Some(("IGES", "export a mesh of it, such as STL"))
        }
        _ => None,
    }
}

/// Whether lines begin bulk data of Nastran, or are entries of it; comments begin with `$`.
pub(super) fn is_nastran(start: &[u8]) -> bool {
    let is_entry = |line: &[u8]| {
        let word = line.split(|&byte| matches!(byte, b' ' | b',' | b'*')).next().unwrap_or_default();
        let is_bulk = line.get(..10).is_some_and(|line| line.eq_ignore_ascii_case(b"BEGIN BULK"));
        is_bulk || [&b"GRID"[..], b"SOL", b"CEND", b"CTRIA3", b"CQUAD4", b"CTETRA", b"CHEXA"].contains(&word)
    };
    let mut lines = start.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && line[0] != b'$');
    first.is_some_and(is_entry)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Format, ReadOptions, read_named};

    #[test]
    fn what_is_not_read_is_named() {
        for (start, what) in [
            (&b"<?xml version='1.0'?><a:b xmlns:gml='http://www.opengis.net/gml'/>"[..], "GML"),
            (b"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));", "IFC"),
            (b"ISO-10303-21;\nHEADER;\n", "STEP"),
            (b"BLENDER-v279", "Blender"),
            (b"Kaydara FBX Binary  \0", "FBX"),
            (b"  0\nSECTION\n  2\nHEADER\n", "DXF"),
            (b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "Git LFS"),
            (b"<html><body>404</body></html>", "HTML"),
            (b"\x89HDF\r\n", "MED"),
            (b"$ made by a mesher\n$$\nSOL 101\nCEND\nBEGIN BULK\nGRID,1,,0.,0.,0.\n", "Nastran"),
            (b"$title\nGRID           1       0      0.      0.      0.\n", "Nastran"),
        ] {
            for name in ["a", "a.obj", "a.json", "a.geojson", "a.wkt"] {
                let error = read_named(start, name, &ReadOptions::new()).unwrap_err();
                assert!(error.message().contains(what), "{name}: {error}");
                assert!(error.cure().is_some() && !error.to_string().contains("another kind"), "{error}");
            }
        }
        assert!(surely(b"cMcabbgqw").is_none() && Format::from_content(b"cMcabbgqw", true).is_some());
    }
}
