//! Detection of the format of a file by its first bytes.

use super::format::names;
use super::{
    Format, abaqus, cityjson, container, foreign, geojson, isosig, lines_text, matrix_market, points_text,
    volume, wkb, wkt, wkt_table, yin,
};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};

/// How well the first bytes of a file fit a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Likeness {
    No,
    Possible,
    Certain,
}

impl Format {
    /// The format that the first bytes of a file look like. The more bytes, the surer: some thousand do. `whole` says
    /// that nothing comes after them.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert_eq!(Format::from_content(b"ply\nformat ascii 1.0\n", false), Some(Format::Ply));
    /// assert_eq!(Format::from_content(b"It was a dark and stormy night", true), None);
    /// ```
    pub fn from_content(start: &[u8], whole: bool) -> Option<Self> {
        let best = Self::ALL.into_iter().map(|format| (format.likeness(start, whole), format));
        // The first of equals: max_by_key would take the last.
        let (likeness, format) = best.rev().max_by_key(|&(likeness, _)| likeness)?;
        (likeness > Likeness::No).then_some(format)
    }

    fn likeness(self, start: &[u8], whole: bool) -> Likeness {
        let certain_if = |fits: bool| if fits { Likeness::Certain } else { Likeness::No };
        let word = first_word(start);
        match self {
            Self::Off => {
                if is_off_keyword(word) {
                    Likeness::Certain
                } else if is_text(start) && is_off_without_keyword(start, whole) {
                    // The keyword may be left out.
                    Likeness::Possible
                } else {
                    Likeness::No
                }
            }
            Self::Obj => obj_likeness(start),
            Self::Ply => certain_if(start.starts_with(b"ply\n") || start.starts_with(b"ply\r")),
            Self::Stl => stl_likeness(start, whole),
            // The third number of a binary file is a keyword, 3 for the dimension.
            Self::Medit if yin::is_dat(start, whole) => Likeness::No,
            Self::Medit => certain_if(
                word == b"MeshVersionFormatted"
                    || word == b"MeshVersionUnformatted"
                    || start.starts_with(&[1, 0, 0, 0]) && matches!(start.get(4..8), Some([1..=4, 0, 0, 0]))
                    || start.starts_with(&[0, 0, 0, 1]) && matches!(start.get(4..8), Some([0, 0, 0, 1..=4])),
            ),
            Self::Msh => certain_if(is_msh(start)),
            Self::Vtk => certain_if(start.len() >= 14 && start[..14].eq_ignore_ascii_case(b"# vtk DataFile")),
            Self::Gltf if start.starts_with(b"glTF") => Likeness::Certain,
            Self::Gltf => certain_if(is_gltf(start)),
            Self::ThreeMf => certain_if(is_three_mf(start)),
            Self::Collada => certain_if(is_collada(start)),
            Self::Amf => certain_if(is_amf(start)),
            Self::Abaqus if abaqus::is_likely(start) && is_text(start) => Likeness::Possible,
            // Numbers alone are many things: the name tells these.
            Self::Abaqus | Self::TetGen | Self::Points => Likeness::No,
            Self::CityJson => certain_if(cityjson::is_cityjson(start)),
            Self::MatrixMarket => certain_if(matrix_market::is_matrix_market(start)),
            Self::Json | Self::GeoJson if cityjson::is_cityjson(start) => Likeness::No,
            Self::Json if is_gltf(start) => Likeness::No,
            Self::Json => {
                let first = start.iter().find(|byte| !byte.is_ascii_whitespace());
                certain_if(matches!(first, Some(b'{' | b'[')) && !geojson::is_geojson(start))
            }
            // A text of one word is many things; that it can be read throughout tells.
            Self::Isosig if isosig::is_signature(first_line(start)) => Likeness::Possible,
            Self::Isosig => Likeness::No,
            Self::Lines if lines_text::is_segment(first_line(start)) => Likeness::Certain,
            // Comments alone.
            Self::Lines if first_line(start).is_empty() && is_text(start) => Likeness::Possible,
            Self::Lines => Likeness::No,
            Self::GeoJson if geojson::is_geojson(start) => Likeness::Certain,
            // The type may come behind all coordinates.
            Self::GeoJson if !whole && geojson::first_record(start).starts_with(b"{") => Likeness::Possible,
            Self::GeoJson => Likeness::No,
            Self::Wkt => certain_if(
                wkt::is_geometry(first_line(start)) || is_text(start) && wkt_table::is_table(start),
            ),
            Self::Wkb => certain_if(!is_text(start) && wkb::is_binary(start)),
            Self::WkbHex => certain_if(wkb::is_digits(first_line(start))),
            Self::Svg => certain_if(is_svg(start)),
            Self::Dat => certain_if(yin::is_dat(start, whole)),
            Self::Container => certain_if(start.starts_with(&container::MARK)),
            Self::Npy => certain_if(start.starts_with(volume::NPY_MAGIC)),
            Self::Nrrd => certain_if(start.starts_with(volume::NRRD_MAGIC)),
            Self::Nifti => certain_if(volume::is_nifti(start)),
            Self::MetaImage => certain_if(volume::is_metaimage(start)),
            Self::Pgm => certain_if(volume::is_pgm(start)),
            Self::Png => certain_if(start.starts_with(volume::PNG_MAGIC)),
            Self::VtkGrid | Self::VtkPolygons => match vtk_xml_kind(start) {
                Some(b"PolyData") => certain_if(self == Self::VtkPolygons),
                Some(b"UnstructuredGrid") => certain_if(self == Self::VtkGrid),
                // Their reader says best what else it is.
                Some(_) => Likeness::Possible,
                None => Likeness::No,
            },
        }
    }
}

/// Decides the format of a file from its first bytes and, if it has one, its name. Where they disagree and the content is sure,
/// it decides, with a remark.
///
/// # Errors
/// What the content is not, what it looks like, and how to say which format is meant.
pub(super) fn decide(
    start: &[u8],
    whole: bool,
    by_name: Option<Format>,
) -> Result<(Format, Vec<Remark>), Error> {
    check_hopeless(start, whole)?;
    let unsupported = |message: String| Error::new(ErrorKind::UnsupportedFormat, message);
    let surely = |format: Format| Ok((format, Vec::new()));
    if let Some((what, cure)) = foreign::surely(start) {
        return Err(unsupported(format!("this is {what}")).with_cure(cure));
    }
    let Some(named) = by_name else {
        if let Some((what, cure)) = foreign(start).filter(|_| !volume::is_nifti(start)) {
            return Err(unsupported(format!("this is {what}")).with_cure(cure));
        }
        let is_sure = Format::from_content(start, whole)
            .is_some_and(|seen| seen.likeness(start, whole) == Likeness::Certain);
        if whole && !is_sure && is_text(start) && first_line(start).is_empty() {
            return Err(unsupported("the file holds nothing but comments".to_owned())
                .with_cure(format!("say what it is with --format, one of {}", names())));
        }
        let seen = Format::from_content(start, whole).ok_or_else(|| {
            unsupported(format!(
                "the content, {}, is of no format known here",
                if is_text(start) { "text" } else { "binary data" }
            ))
            .with_cure(format!("say what it is with --format, one of {}", names()))
        })?;
        return surely(seen);
    };
    if named.likeness(start, whole) > Likeness::No {
        return surely(named);
    }
    let seen = Format::from_content(start, whole);
    let sure = seen.filter(|seen| seen.likeness(start, whole) == Likeness::Certain);
    // What only the name tells.
    let is_told = match named {
        Format::Off => is_text(start) && is_counts(first_line(start)),
        Format::TetGen => is_text(start) && first_line(start).iter().all(|byte| !byte.is_ascii_alphabetic()),
        Format::Points => is_text(start) && points_text::is_likely(start),
        Format::Gltf => !whole && start.trim_ascii_start().starts_with(b"{"),
        Format::ThreeMf | Format::Amf => start.starts_with(b"PK"),
        _ => false,
    };
    if is_told && sure.is_none_or(|sure| matches!(sure, Format::Lines | Format::Json)) {
        return surely(named);
    }
    if matches!(named, Format::Json | Format::GeoJson) && cityjson::is_cityjson(start) {
        // CityJSON is JSON, and its files are named `.city.json`.
        return surely(Format::CityJson);
    }
    if named == Format::Json && geojson::is_geojson(start) {
        // GeoJSON is JSON, and its files are often named so.
        return surely(Format::GeoJson);
    }
    if let Some((what, cure)) = foreign(start) {
        return Err(unsupported(format!("this is {what}, not {}", named.title())).with_cure(cure));
    }
    if named == Format::Stl && seen.is_none() && !is_text(start) {
        // A binary STL has no mark: its reader says best what is wrong with it.
        return surely(named);
    }
    let is_word = !first_line(start).contains(&b' ') && is_text(start);
    if named == Format::Isosig && seen.is_none() && is_word {
        // Neither has a signature.
        return surely(named);
    }
    match seen {
        Some(seen) if sure.is_some() => {
            let message = format!(
                "the name says {}, but the content is {} and is read as that",
                named.title(),
                seen.title()
            );
            Ok((seen, vec![Remark::new(RemarkCode::FormatByContent, message)]))
        }
        Some(seen) => Err(unsupported(format!(
            "the name says {}, but the content looks like {}",
            named.title(),
            seen.title()
        ))
        .with_cure(format!("rename the file, or say what it is with --format {}", seen.name()))),
        None if named == Format::Msh && is_counts(first_line(start)) => Err(unsupported(
            "this is no mesh of Gmsh; it may be one of FreeFem, which is not read".to_owned(),
        )
        .with_cure("save it as MEDIT: savemesh(Th, \"name.mesh\")")),
        None => Err(unsupported(format!(
            "the name says {}, but the content is {}",
            named.title(),
            if is_text(start) { "text of another kind" } else { "binary data of another kind" }
        ))
        .with_cure("check that the file is the one meant, or say what it is with --format")),
    }
}

/// Refuses content that a reader of the stated format would take for a model of nothing.
///
/// # Errors
/// An OBJ without a single known keyword; a binary STL of no triangles that goes on; those of [`check_hopeless`].
pub(super) fn check_stated(format: Format, start: &[u8], whole: bool) -> Result<(), Error> {
    check_hopeless(start, whole)?;
    let text = is_text(start);
    if format == Format::Obj && obj_likeness(start) == Likeness::No {
        let kind = if text { "text of another kind" } else { "binary data" };
        return Err(Error::new(ErrorKind::UnsupportedFormat, format!("this is {kind}, not OBJ"))
            .with_cure("check that the file is the one meant, or say what it is with --format"));
    }
    if format == Format::Stl && !text && start.len() > 84 && start[80..84] == [0; 4] {
        return Err(Error::parse("the file promises 0 triangles, but goes on behind them")
            .at_byte(80)
            .with_cure("it is damaged or no STL: write it again"));
    }
    Ok(())
}

/// Refuses content that is nothing in any format.
pub(super) fn check_hopeless(start: &[u8], whole: bool) -> Result<(), Error> {
    if whole && start.iter().all(u8::is_ascii_whitespace) {
        let message = if start.is_empty() { "the file is empty" } else { "the file holds only white space" };
        return Err(Error::parse(message).with_cure("write it again, or restore it from a copy"));
    }
    // 84 zeros are a binary STL without triangles, 4 are no curves.
    if start.iter().all(|&byte| byte == 0) && !(whole && matches!(start.len(), 4 | 84)) {
        return Err(Error::parse("the file holds nothing but zero bytes")
            .at_byte(0)
            .with_cure("it was not written to its end: write it again, or restore it from a copy"));
    }
    Ok(())
}

/// Whether the first word begins a section of Gmsh, alone on its line; what is a comment of Nastran begins with `$` too.
fn is_msh(start: &[u8]) -> bool {
    let line = first_line(start);
    let name = line.strip_prefix(b"$").unwrap_or_default();
    !name.is_empty() && name.iter().all(u8::is_ascii_alphanumeric) && !foreign::is_nastran(start)
}

/// What a file is that is surely none of ours, and what to do about it.
fn foreign(start: &[u8]) -> Option<(&'static str, &'static str)> {
    let is_read = is_svg(start)
        || vtk_xml_kind(start).is_some()
        || is_collada(start)
        || is_amf(start)
        || is_three_mf(start);
    foreign::perhaps(start).filter(|_| !is_read)
}

/// Whether this is the text form of glTF: an object with an asset that has a version, and scenes, nodes or meshes.
fn is_gltf(start: &[u8]) -> bool {
    let has = |word: &[u8]| memchr::memmem::find(start, word).is_some();
    start.trim_ascii_start().starts_with(b"{")
        && has(b"\"asset\"")
        && has(b"\"version\"")
        && (has(b"\"scenes\"") || has(b"\"nodes\"") || has(b"\"meshes\"") || has(b"\"accessors\""))
}

/// Whether this is a ZIP archive with a 3D model among its first parts.
fn is_three_mf(start: &[u8]) -> bool {
    let has = |word: &[u8]| memchr::memmem::find(start, word).is_some();
    start.starts_with(b"PK\x03\x04") && (has(b"3D/") || has(b".model"))
}

fn is_collada(start: &[u8]) -> bool {
    start.trim_ascii_start().starts_with(b"<") && memchr::memmem::find(start, b"<COLLADA").is_some()
}

/// Whether the start is that of XML with the element `amf`, or of an archive whose first file has a name of such a file.
fn is_amf(start: &[u8]) -> bool {
    let text = start.trim_ascii_start();
    if text.starts_with(b"<") {
        let found = memchr::memmem::find_iter(text, b"<amf");
        return found
            .map(|at| text.get(at + 4))
            .any(|next| next.is_some_and(|byte| byte.is_ascii_whitespace() || matches!(byte, b'>' | b'/')));
    }
    if !start.starts_with(b"PK\x03\x04") {
        return false;
    }
    // The length of the name stands in bytes 26 and 27 of the header, the name from byte 30 on.
    let length =
        start.get(26..28).map_or(0, |length| usize::from(u16::from_le_bytes([length[0], length[1]])));
    start.get(30..30 + length).is_some_and(|name| name.to_ascii_lowercase().ends_with(b".amf"))
}

/// Whether the start is that of XML with an element `svg` that nothing but comments and declarations stand before.
fn is_svg(start: &[u8]) -> bool {
    let mut rest = start.trim_ascii_start();
    while rest.first() == Some(&b'<') {
        if let Some(name) = rest.strip_prefix(b"<svg") {
            return name
                .first()
                .is_none_or(|byte| byte.is_ascii_whitespace() || matches!(byte, b'>' | b'/' | b':'));
        }
        if let Some(prefixed) = memchr::memmem::find(&rest[..rest.len().min(64)], b":svg")
            && rest[1..prefixed].iter().all(u8::is_ascii_alphanumeric)
        {
            return true;
        }
        let end: &[u8] = if rest.starts_with(b"<!--") {
            b"-->"
        } else if rest.starts_with(b"<?") {
            b"?>"
        } else {
            return rest.starts_with(b"<!DOCTYPE svg");
        };
        let Some(at) = memchr::memmem::find(rest, end) else { return false };
        rest = rest[at + end.len()..].trim_ascii_start();
    }
    false
}

/// The kind of data set of a VTK XML file: what its first element says; empty if it does not.
fn vtk_xml_kind(start: &[u8]) -> Option<&[u8]> {
    let mut rest = start.trim_ascii_start();
    loop {
        if let Some(head) = rest.strip_prefix(b"<VTKFile") {
            let head = &head[..memchr::memchr(b'>', head).unwrap_or(head.len())];
            let behind = memchr::memmem::find(head, b" type=").map(|at| &head[at + 6..]).unwrap_or_default();
            let Some((quote, value)) = behind.split_first() else { return Some(b"") };
            return Some(&value[..memchr::memchr(*quote, value).unwrap_or(0)]);
        }
        let end: &[u8] = match rest {
            [b'<', b'!', b'-', b'-', ..] => b"-->",
            [b'<', b'?', ..] => b"?>",
            _ => return None,
        };
        rest = rest[memchr::memmem::find(rest, end)? + end.len()..].trim_ascii_start();
    }
}

/// Whether this is text: no control bytes but white space.
fn is_text(start: &[u8]) -> bool {
    // Some programs write the end of a text of C too.
    let end = start.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    (end > 0 || start.is_empty())
        && start[..end].iter().all(|&byte| byte >= b' ' || byte.is_ascii_whitespace() || byte == 0x0b)
}

/// The first line that is neither empty nor a comment.
fn first_line(start: &[u8]) -> &[u8] {
    start
        .split(|&byte| byte == b'\n')
        .map(<[u8]>::trim_ascii)
        .find(|line| !line.is_empty() && line[0] != b'#')
        .unwrap_or_default()
}

/// The first word that is not in a comment.
fn first_word(start: &[u8]) -> &[u8] {
    first_line(start).split(u8::is_ascii_whitespace).next().unwrap_or_default()
}

/// Whether text begins with the numbers of vertices and faces, and has a face where the first should be, if that is seen.
fn is_off_without_keyword(start: &[u8], whole: bool) -> bool {
    fn words(line: &[u8]) -> impl Iterator<Item = Option<usize>> {
        let words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        words.map(|word| std::str::from_utf8(word).ok()?.parse().ok())
    }
    let is_content = |line: &&[u8]| line.trim_ascii_start().first().is_some_and(|&byte| byte != b'#');
    let mut lines = start.split(|&byte| byte == b'\n').filter(is_content);
    let Some(counts) = lines.next().filter(|line| is_counts(line)) else { return false };
    let mut counts = words(counts).flatten();
    let (Some(vertices), Some(faces)) = (counts.next(), counts.next()) else { return false };
    let face = lines.nth(vertices);
    // The last line that is seen may go on.
    let is_seen = whole || lines.next().is_some();
    // Numbers alone are points rather than vertices without faces.
    faces > 0
        && face.filter(|_| is_seen).is_none_or(|face| {
            let mut words = words(face);
            let size = words.next().flatten();
            size.is_some_and(|size| {
                let ids = words.take(size).map_while(|id| id.filter(|&id| id < vertices));
                size > 2 && ids.count() == size
            })
        })
}

/// Two or three numbers: vertices, faces and perhaps edges.
fn is_counts(line: &[u8]) -> bool {
    let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let count = words.clone().count();
    // Of nothing there is no mesh: 0 0 0 is a point.
    let is_some = words.clone().next().is_some_and(|first| first.iter().any(|&digit| digit != b'0'));
    is_some && (2..=3).contains(&count) && words.all(|word| word.iter().all(u8::is_ascii_digit))
}

/// `[ST][C][N][4][n]OFF`, perhaps with the first count behind it.
fn is_off_keyword(word: &[u8]) -> bool {
    let digits = word.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
    let Some(mut rest) = word[..word.len() - digits].strip_suffix(b"OFF") else { return false };
    for part in [&b"ST"[..], b"C", b"N", b"4", b"n"] {
        rest = rest.strip_prefix(part).unwrap_or(rest);
    }
    rest.is_empty()
}

fn obj_likeness(start: &[u8]) -> Likeness {
    const KEYWORDS: [&[u8]; 14] = [
        b"v", b"vt", b"vn", b"vp", b"f", b"fo", b"l", b"p", b"o", b"g", b"s", b"mtllib", b"usemtl", b"usemap",
    ];
    if !is_text(start) {
        return Likeness::No;
    }
    let (mut known, mut unknown) = (0u32, 0u32);
    for line in start.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii) {
        let word = line.split(u8::is_ascii_whitespace).next().unwrap_or_default();
        if KEYWORDS.contains(&word) {
            known += 1;
        } else if !word.is_empty() && word[0] != b'#' {
            unknown += 1;
        }
        if known + unknown == 100 {
            break;
        }
    }
    match (known, unknown) {
        (1.., 0) => Likeness::Certain,
        (1.., _) => Likeness::Possible,
        // Comments alone: an OBJ without anything in it.
        (0, 0) => Likeness::Possible,
        (0, _) => Likeness::No,
    }
}

fn stl_likeness(start: &[u8], whole: bool) -> Likeness {
    let text = first_word(start).eq_ignore_ascii_case(b"solid");
    if text && is_text(start) {
        return Likeness::Certain;
    }
    let Some(count) = start.get(80..84) else {
        return if text { Likeness::Possible } else { Likeness::No };
    };
    let count = u64::from(u32::from_le_bytes(count.try_into().expect("four bytes")));
    let size = 84 + 50 * count;
    if whole {
        return if start.len() as u64 == size {
            Likeness::Certain
        } else if text {
            Likeness::Possible
        } else {
            Likeness::No
        };
    }
    let triangles = start[84..].chunks_exact(50).take(count as usize);
    let finite = triangles.flat_map(|triangle| triangle[..48].chunks_exact(4)).all(|number| {
        let number = f32::from_le_bytes(number.try_into().expect("four bytes"));
        number.abs() < 1e30
    });
    if size > start.len() as u64 && finite && !is_text(start) { Likeness::Possible } else { Likeness::No }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_tells_the_format() {
        for (start, format) in [
            (&b"# a comment\n\nOFF\n"[..], Format::Off),
            (b"STCN4nOFF 8 6 12\n", Format::Off),
            (b"  8 6 12\n1 1 1\n", Format::Off),
            (b"mtllib a.mtl\nv 0 0 0\n", Format::Obj),
            (b"ply\r\nformat ascii 1.0\r\n", Format::Ply),
            (b"solid cube\n facet normal", Format::Stl),
            (b"\nMeshVersionFormatted 2\n", Format::Medit),
            (b"\x01\0\0\0\x02\0\0\0", Format::Medit),
            (b"$MeshFormat\n2.2 0 8\n", Format::Msh),
            (b"# vtk DataFile Version 3.0\n", Format::Vtk),
            (b"<?xml version='1.0'?>\n<VTKFile version='1.0' type='PolyData'>", Format::VtkPolygons),
            (b"<!-- <svg> --><VTKFile type=\"UnstructuredGrid\"", Format::VtkGrid),
            (b" [[0,1,2]]", Format::Json),
            (b"# figure eight\ncPcbbbiht\n", Format::Isosig),
            (b"# a drawing\n0,0, 1.5,-2e3\n", Format::Lines),
            (b"0 0 1 1\n", Format::Lines),
            (b"0,0,1,nan\n", Format::Lines),
            (b" { \"type\" : \"Feature\",", Format::GeoJson),
            (b"{\"crs\":{\"type\":\"name\"},\"type\":\"Point\"", Format::GeoJson),
            (b"[[[0, 1], [1, 2]]]", Format::GeoJson),
            (b"\x1e{\"type\":\"Feature\",", Format::GeoJson),
            (b"\n\x1e\x1e {\"id\":1,\"type\":\"Point\",", Format::GeoJson),
            (b"SRID=4326;POINT (1 2)", Format::Wkt),
            (b"polygon z((0 0 1,", Format::Wkt),
            (b"MULTIPOINT\n(1 2)", Format::Wkt),
            (b"CURVEPOLYGON (CIRCULARSTRING (0 0", Format::Wkt),
            (b"MultiSurfaceZ (((0 0 1", Format::Wkt),
            (b"<?xml version=\"1.0\"?>\n<!-- a > b -->\n<svg width=\"1\">", Format::Svg),
            (b"<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\">", Format::Svg),
            (b"\x89cfc\r\n\x1a\n\x01\0\0\0", Format::Container),
            (b"<svg:svg xmlns:svg=\"http://www.w3.org/2000/svg\"/>", Format::Svg),
        ] {
            assert_eq!(Format::from_content(start, true), Some(format), "{}", start.escape_ascii());
            assert_eq!(decide(start, true, None).unwrap().0, format);
            assert_eq!(decide(start, true, Some(format)).unwrap(), (format, Vec::new()));
            let other = if format == Format::Ply { Format::Vtk } else { Format::Ply };
            match decide(start, true, Some(other)) {
                Ok((seen, remarks)) => {
                    assert_eq!((seen, format.likeness(start, true)), (format, Likeness::Certain));
                    assert_eq!(remarks[0].code, RemarkCode::FormatByContent);
                }
                Err(error) => {
                    let cure = format!("--format {}", format.name());
                    assert!(error.to_string().contains(&cure), "{error}");
                    assert_eq!(format.likeness(start, true), Likeness::Possible);
                }
            }
        }
    }

    #[test]
    fn a_binary_stl_is_known_by_its_size() {
        let mut bytes = vec![0; 84 + 2 * 50];
        bytes[80] = 2;
        assert_eq!(Format::from_content(&bytes, true), Some(Format::Stl));
        assert_eq!(Format::from_content(&bytes, false), None);
        bytes.push(0);
        assert_eq!(Format::from_content(&bytes, true), None);
        assert_eq!(decide(&bytes, true, Some(Format::Stl)).unwrap().0, Format::Stl);
        bytes[80] = 3;
        assert_eq!(Format::from_content(&bytes, false), Some(Format::Stl));
    }

    #[test]
    fn numbers_alone_are_no_off_without_its_keyword() {
        for text in ["2 0 0\n1 2 3\n4 5 6\n", "1 2 3\n1 2 4\n1 3 4\n", "1 1 0\n0 0 0\n0 1 2\n0 0 1\n"] {
            assert_eq!(Format::from_content(text.as_bytes(), true), None, "{text}");
        }
        let plain = b"3 1 0\n0 0 0\n1 0 0\n# a comment\n0 1 0\n\n3 0 1 2 255 0 0\n";
        assert_eq!(Format::from_content(plain, true), Some(Format::Off));
        assert_eq!(Format::from_content(&plain[..20], false), Some(Format::Off));
        assert_eq!(decide(b"2 0 0\n1 2 3\n4 5 6\n", true, Some(Format::Off)).unwrap().0, Format::Off);
    }

    #[test]
    fn content_that_is_nothing_is_refused_with_a_cure() {
        for (start, message) in [
            (&b""[..], "empty"),
            (b" \n\t\r\n", "white space"),
            (&[0; 5000], "zero bytes"),
            (b"\xff\xfeO\0F\0", "UTF-16"),
            (b"<html>", "HTML"),
            (b"<svgfoo>", "XML"),
            (b"once upon a time", "text"),
            (b"\x07\x01\x99\x80", "binary"),
        ] {
            for by_name in [None, Some(Format::Obj), Some(Format::Json)] {
                let error = decide(start, true, by_name).unwrap_err();
                assert!(error.to_string().contains(message), "{error}");
                assert!(error.cure().is_some(), "{error}");
            }
        }
        assert!(check_hopeless(&[0; 84], true).is_ok());
    }
}
