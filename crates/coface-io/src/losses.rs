//! What a format does not keep of a model, beside groups and data.

use crate::drawing::{Shape, shapes, written_dimension};
use crate::geometries::surface_of_faces;
use crate::{Format, GroupKind, Model, Remark, RemarkCode, Structure, obj, print_objects, stl};
use std::collections::HashSet;

/// What a file of a format does not keep of this model, or keeps in another way: positions that are rounded, vertices that become one, faces of a
/// mesh that become rings of a drawing. Nothing for what [`write`](crate::write) refuses.
///
/// Whether a format keeps groups and data at all is said by [`Format::keeps_groups`] and [`Format::keeps_data`].
///
/// # Complexity
/// $O(n \log n)$ for n vertices.
///
/// # Examples
/// A tenth is no number of single precision.
/// ```
/// use coface_io::{Format, RemarkCode, losses, read};
/// let model = read(&b"v 0 0 0\nv 0.1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// assert_eq!(losses(&model, Format::Stl)[0].code, RemarkCode::NumbersRounded);
/// assert!(losses(&model, Format::Ply).is_empty());
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn losses(model: &Model, format: Format) -> Vec<Remark> {
    match format {
        Format::Stl => stl::losses(model),
        Format::ThreeMf | Format::Amf => print_objects::losses(model, format),
        Format::Wkt | Format::Wkb | Format::WkbHex | Format::GeoJson | Format::Svg | Format::Lines => {
            of_drawing(model, format)
        }
        Format::Obj => {
            let count = obj::lost_groups(model);
            let message = match count {
                1 => "OBJ has no room for 1 group of vertices, lines or points: it is left out".to_owned(),
                _ => format!(
                    "OBJ has no room for {count} groups of vertices, lines or points: they are left out"
                ),
            };
            kept_less(count, message)
        }
        Format::Medit => of_medit(model),
        Format::Json if model.structure().is_none() && model.require_finite().is_err() => {
            let message =
                "JSON has no words for NaN and infinity: the positions of all vertices are left out";
            kept_less(model.vertex_count(), message.to_owned())
        }
        _ => Vec::new(),
    }
}

fn kept_less(count: usize, message: String) -> Vec<Remark> {
    match count {
        0 => Vec::new(),
        _ => vec![Remark::new(RemarkCode::FormatKeepsLess, message).at(count, [])],
    }
}

/// One number for each element, and no names.
fn of_medit(model: &Model) -> Vec<Remark> {
    let is_named = |name: &str| name.parse::<i32>().is_err();
    let names = model.groups().iter().filter(|group| is_named(group.name())).count();
    let mut further = 0;
    for kind in [GroupKind::Vertices, GroupKind::Lines, GroupKind::Polygons, GroupKind::Cells] {
        let mut seen = HashSet::new();
        let members = model.groups().iter().filter(|group| group.kind() == kind);
        further += members.flat_map(|group| group.members()).filter(|&&member| !seen.insert(member)).count();
    }
    let mut remarks = match names {
        1 => kept_less(1, "MEDIT has numbers for groups and no names: 1 name is left out".to_owned()),
        _ => {
            kept_less(names, format!("MEDIT has numbers for groups and no names: {names} names are left out"))
        }
    };
    remarks.extend(kept_less(
        further,
        format!("MEDIT puts each element into one group; left out are further memberships: {further}"),
    ));
    remarks
}

fn of_drawing(model: &Model, format: Format) -> Vec<Remark> {
    let Ok(dimension) = written_dimension(model, format.title()) else { return Vec::new() };
    let title = format.title();
    let has_surfaces = dimension == 3 && matches!(format, Format::Wkt | Format::Wkb | Format::WkbHex);
    let faces = model.polygons().len();
    let mut remarks = Vec::new();
    if format == Format::Lines {
        let message = match faces {
            1 => "a file of segments has no faces: the sides of 1 polygon are written".to_owned(),
            _ => format!("a file of segments has no faces: the sides of {faces} polygons are written"),
        };
        remarks.extend(kept_less(faces, message));
    } else if dimension == 2 {
        let message = match faces {
            1 => format!("1 polygon of a mesh is a ring of a drawing to readers of {title}"),
            _ => format!(
                "{faces} polygons of a mesh are rings of a drawing to readers of {title}, which have no vertices in common"
            ),
        };
        remarks.extend(kept_less(faces, message));
    }
    let loose = model.lines().len() + model.points().len();
    if has_surfaces && faces > 0 {
        let message = format!(
            "lines, points and surfaces have no vertices in common in {title}; lines and points beside the faces: {loose}"
        );
        remarks.extend(kept_less(loose, message));
    }
    let merged = merged_count(model, dimension, has_surfaces);
    let message = match merged {
        1 => format!("1 vertex is at the place of another: it is that one in {title}"),
        _ => format!("{merged} vertices are at the places of others: they are these in {title}"),
    };
    remarks.extend(kept_less(merged, message));
    remarks
}

/// The number of vertices that lines and points, or faces of a surface, have in common with others at their place when they are read.
fn merged_count(model: &Model, dimension: usize, has_surfaces: bool) -> usize {
    let width = model.positions().dimension();
    let place = |vertex: u32| -> [u64; 3] {
        std::array::from_fn(|axis| match axis < dimension.min(width) {
            // Zeros of both signs are equal.
            true => (model.positions().as_flat()[vertex as usize * width + axis] + 0.0).to_bits(),
            false => 0,
        })
    };
    let surfaces = if has_surfaces { surface_of_faces(model) } else { Vec::new() };
    let mut used: Vec<(u32, [u64; 3], u32)> = Vec::new();
    for (shape, _) in shapes(model) {
        match shape {
            Shape::Line(line) => used.extend(model.lines().list(line).iter().map(|&v| (0, place(v), v))),
            Shape::Point(vertex) => used.push((0, place(vertex.to_u32()), vertex.to_u32())),
            Shape::Face(face) => {
                let Some(surface) = surfaces.get(face) else { continue };
                used.extend(model.polygons().list(face).iter().map(|&v| (surface + 1, place(v), v)));
            }
            Shape::Rings(_) => {}
        }
    }
    used.sort_unstable();
    used.dedup();
    used.windows(2).filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1)).count()
}

/// That these positions are others in a file that holds numbers of 32 bits: each pair has a position and what is written. None where all
/// are the same.
///
/// # Complexity
/// Linear.
#[doc(hidden)]
pub fn single_precision_remark(points: impl IntoIterator<Item = [[f64; 3]; 2]>) -> Option<Remark> {
    let (mut moved, mut farthest) = (0, 0.0f64);
    for [point, written] in points {
        let square: f64 = point.iter().zip(written).map(|(x, y)| (x - y).powi(2)).sum();
        if square > 0.0 {
            (moved, farthest) = (moved + 1, farthest.max(square.sqrt()));
        }
    }
    let moves = match moved {
        0 => return None,
        1 => "1 vertex moves".to_owned(),
        _ => format!("{moved} vertices move"),
    };
    let message =
        format!("coordinates are rounded to single precision: {moves}, by up to about {farthest:.2e}");
    Some(Remark::new(RemarkCode::NumbersRounded, message).at(moved, []))
}

/// What an isomorphism signature of the tetrahedra of this model leaves out: positions, groups, data, and what is no face of a tetrahedron.
///
/// # Examples
/// ```
/// use coface_io::{Format, read, signature_losses};
/// let model = read(&b"MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n"[..], Format::Medit)?;
/// assert!(signature_losses(&model)[0].message.contains("positions"));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn signature_losses(model: &Model) -> Vec<Remark> {
    if matches!(model.structure(), Some(Structure::Gluings(_))) {
        return Vec::new();
    }
    let mut in_cell = vec![false; model.vertex_count()];
    let (mut edges, mut triangles) = (HashSet::new(), HashSet::new());
    let sorted = |list: &[u32]| {
        let mut list = list.to_vec();
        list.sort_unstable();
        list
    };
    let is_small = !model.lines().is_empty() || !model.polygons().is_empty();
    for cell in model.cells().iter() {
        cell.iter().for_each(|&vertex| in_cell[vertex as usize] = true);
        for i in 0..if is_small { cell.len() } else { 0 } {
            let without: Vec<u32> =
                cell.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, &v)| v).collect();
            triangles.insert(sorted(&without));
            edges.extend(cell[..i].iter().map(|&other| sorted(&[other, cell[i]])));
        }
    }
    let vertices = if model.cells().is_empty() { 0 } else { in_cell.iter().filter(|&&is_in| !is_in).count() };
    let loose_edges =
        crate::segments(model.lines()).iter().filter(|pair| !edges.contains(&sorted(&pair[..]))).count();
    let loose_triangles =
        model.polygons().iter().filter(|polygon| !triangles.contains(&sorted(polygon))).count();
    let positions = if model.coordinate_count() > 0 { model.vertex_count() } else { 0 };
    let parts = [
        (positions, "positions of vertices"),
        (model.groups().len(), "groups"),
        (model.data().len(), "data on cells"),
        (vertices, "vertices that are in no tetrahedron"),
        (loose_edges, "edges of no tetrahedron"),
        (loose_triangles, "triangles of no tetrahedron"),
    ];
    let counts: Vec<String> = parts
        .iter()
        .filter(|(count, _)| *count > 0 && !model.cells().is_empty())
        .map(|(count, what)| format!("{what}: {count}"))
        .collect();
    let total = parts.iter().map(|(count, _)| count).sum();
    if counts.is_empty() {
        return Vec::new();
    }
    kept_less(
        total,
        format!("a signature keeps only how tetrahedra are glued; left out are {}", counts.join(", ")),
    )
}

/// The remark of what the file of a model has beside what is read of it; none if there is nothing.
///
/// # Examples
/// ```
/// use coface_io::{Format, read, unread_remark};
/// let model = read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"[..], Format::Obj)?;
/// let remark = unread_remark(&model).expect("there is a normal");
/// assert_eq!(remark.message, "the OBJ file has more than is read and written: normals (vn): 1");
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn unread_remark(model: &Model) -> Option<Remark> {
    let counts: Vec<String> = model.unread().iter().map(|(what, count)| format!("{what}: {count}")).collect();
    let title = model.format().map_or_else(String::new, |format| format!("{} ", format.title()));
    let message = format!("the {title}file has more than is read and written: {}", counts.join(", "));
    let total = model.unread().iter().map(|(_, count)| count).sum();
    (!counts.is_empty()).then(|| Remark::new(RemarkCode::DataLeftOut, message).at(total, []))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{read, write};

    fn messages(text: &str, format: Format) -> Vec<String> {
        let model = read(text.as_bytes(), Format::Obj).unwrap();
        losses(&model, format).into_iter().map(|remark| remark.message).collect()
    }

    #[test]
    fn single_precision_is_told() {
        let tall =
            "v 1e7 0 0\nv 10000000.5 0 0\nv 10000000.25 1 0\nv 1e7 2 0\nv 9 9 9\nf 1 2 3\nf 2 4 3\nf 1 3 4\n";
        let told = messages(tall, Format::Stl);
        assert_eq!(told.len(), 3, "{told:?}");
        assert_eq!(
            told[0],
            "coordinates are rounded to single precision: 2 vertices move, by up to about 5.00e-1"
        );
        assert_eq!(
            told[1],
            "single precision makes vertices one that are apart: 1 vertex is lost and 1 triangle collapses, so the surface that is read is another one"
        );
        assert_eq!(told[2], "1 vertex is in no triangle and is left out");
        assert!(messages("v 0 0 0\nv 0.5 0 0\nv 0 1 0\nf 1 2 3\n", Format::Stl).is_empty());
        let twice = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0.0 0 0\nv 1 0 1\nf 1 2 3\nf 4 5 2\n";
        assert_eq!(
            messages(twice, Format::Stl),
            ["1 vertex is at the place of another: they are one in STL"]
        );
        // Nothing but vertices is nothing in STL.
        let points = read(&b"v 0 0 0\nv 1 0 0\n"[..], Format::Obj).unwrap();
        let error = write(&points, Vec::new(), Format::Stl).unwrap_err().to_string();
        assert!(error.contains("2 vertices and no triangle"), "{error}");
    }

    #[test]
    fn drawings_of_meshes_are_told() {
        let flat = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
        for format in [Format::Wkt, Format::Wkb, Format::WkbHex, Format::Svg, Format::GeoJson, Format::Lines]
        {
            assert_eq!(messages(flat, format).len(), 1, "{format:?}");
        }
        let tall = format!("{flat}v 0 0 1\nv 1 0 0\nf 1 6 5\nl 1 5\n");
        assert_eq!(
            messages(&tall, Format::Wkt),
            [
                "lines, points and surfaces have no vertices in common in WKT; lines and points beside the faces: 1",
                "1 vertex is at the place of another: it is that one in WKT"
            ]
        );
        let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        assert_eq!(
            messages(triangle, Format::Svg),
            ["1 polygon of a mesh is a ring of a drawing to readers of SVG"]
        );
        assert_eq!(
            messages(triangle, Format::Lines),
            ["a file of segments has no faces: the sides of 1 polygon are written"]
        );
        let wires = "v 0 0 0\nv 1 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 3 4\n";
        assert_eq!(messages(wires, Format::GeoJson).len(), 1);
        assert!(messages("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n", Format::Lines).is_empty());
        assert!(messages(flat, Format::Off).is_empty() && messages(flat, Format::Obj).is_empty());
    }
}
