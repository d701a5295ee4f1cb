//! What a format does not keep of a model.

use crate::answer::{Remark, RemarkCode};
use crate::planar::reference_loss;
use coface_arrange::planar::ExactVertex;
use coface_io::{CellData, Format, GroupKind, Model};
use serde::de::IgnoredAny;
use std::collections::BTreeMap;

/// The number of features with properties other than a name, which groups tell.
fn described_count(model: &Model) -> usize {
    let features = model.features();
    let has_others = |feature: &usize| {
        let properties: BTreeMap<String, IgnoredAny> =
            serde_json::from_str(features.properties(*feature)).unwrap_or_default();
        properties.keys().any(|key| !key.eq_ignore_ascii_case("name"))
    };
    (0..features.len()).filter(has_others).count()
}

/// The number of vertices that are known by lines and planes, and not by coordinates.
fn exact_point_count(model: &Model) -> usize {
    let in_space = model.exact_polygons().map_or(0, |exact| {
        (0..exact.vertices().len()).filter(|&vertex| exact.vertices().list(vertex).len() > 1).count()
    });
    let in_plane = model.exact_segments().map_or(0, |exact| {
        exact.vertices().iter().filter(|own| matches!(own, ExactVertex::Crossing(_))).count()
    });
    in_space + in_plane
}

/// That the format has no room for the groups, the data or the properties of the model, where that is so.
///
/// # Complexity
/// Linear in the number of features and of exact points, and as of [`coface_io::losses`].
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_io::{Format, Group, GroupKind};
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// let named = coface_io::read(text.as_bytes(), Format::Obj)?
///     .with_group(Group::new("floor", GroupKind::Polygons, vec![0]))?;
/// let counts = [Format::Obj, Format::Off].map(|format| coface_answers::losses_of(&named, format).len());
/// assert_eq!(counts, [0, 1]);
/// # Ok(()) }
/// ```
pub fn losses_of(model: &Model, format: Format) -> Vec<Remark> {
    let colors = model.vertex_colors();
    // Rings are written as rings of polygons, and polygons of one feature together, which tells these.
    let is_told = |data: &CellData| match format {
        Format::GeoJson | Format::Wkt | Format::Wkb | Format::WkbHex | Format::Svg => {
            data.kind() == GroupKind::Lines
                && (matches!(data.name(), "polygon" | "ring")
                    || data.name() == "feature" && format != Format::Svg)
        }
        Format::Obj | Format::ThreeMf | Format::Amf => colors.is_some_and(|colors| colors.contains(&data)),
        _ => false,
    };
    let data_count = model.data().iter().filter(|data| !is_told(data)).count();
    let losses = [
        ("groups", model.groups().len(), format.keeps_groups()),
        ("data on cells", data_count, format.keeps_data()),
        ("properties of features", described_count(model), format == Format::GeoJson),
        ("exact points", exact_point_count(model), format == Format::Json),
    ];
    let is_lost = |&(_, count, is_kept): &(&str, usize, bool)| count > 0 && !is_kept;
    let remark = |(what, count, _): (&str, usize, bool)| {
        let message = format!("a file of {} does not keep {what}: {count} left out", format.title());
        Remark::new(RemarkCode::FormatKeepsLess, message).at(count, [])
    };
    let system = model.reference_system().and_then(|system| reference_loss(system, format));
    let surface = (format == Format::GeoJson && is_surface_in_space(model)).then(|| {
        let message =
            "GeoJSON has no surfaces in space: polygons that are read from it lie in the plane, with heights";
        Remark::new(RemarkCode::FormatKeepsLess, message)
    });
    let others = coface_io::losses(model, format);
    losses.into_iter().filter(is_lost).map(remark).chain(system).chain(surface).chain(others).collect()
}

/// Whether polygons do not lie in the plane of the first two coordinates.
fn is_surface_in_space(model: &Model) -> bool {
    let heights = model.positions().as_flat().iter().skip(2).step_by(3);
    model.positions().dimension() == 3 && !model.polygons().is_empty() && heights.clone().any(|&z| z != 0.0)
}
