//! Drawings that state what is inside of their rings, as SVG does, in polygons of outer rings and holes.

use super::super::drawing::Filling;
use super::super::fill_rules::FillRules;
use super::layer::{MapLayer, Rings};
use super::map_builder::MapBuilder;
use super::repair::{faults_of, polygons_of, runs_clockwise, union_of};
use crate::answer::{Remark, RemarkCode};
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;
use coface_io::Model;

/// The polygons that rings bound by a rule; `None` if this is the first ring without the others.
pub(super) fn polygons_by_rule(rings: &Rings, rule: InsideRule) -> Result<Option<Vec<Rings>>, Error> {
    let (faults, _) = faults_of(std::slice::from_ref(rings))?;
    // Of rings that turn alike, those within another one are no holes of what winds around.
    let are_holes = || {
        let [first, holes @ ..] = &rings[..] else { return true };
        let outer = runs_clockwise(first);
        rule == InsideRule::Odd || holes.iter().all(|hole| runs_clockwise(hole) != outer)
    };
    if faults.is_empty() && are_holes() {
        return Ok(None);
    }
    polygons_of(&union_of(std::slice::from_ref(rings), Filling::Stated(rule))?).map(Some)
}

/// A drawing that states what is inside of its rings with polygons of outer rings and holes, as WKT, WKB and GeoJSON have them, and a remark
/// on those that are not as they were drawn; `None` if all of them are such polygons already.
///
/// A shape becomes as many polygons as what it fills has parts. Shapes with a name are features with the property `name`.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the model does not lie in the plane.
///
/// # Complexity
/// $O((n + k) \log n)$ for n sides of a shape and k meetings of them, one shape after the other.
///
/// # Examples
/// Two squares side by side in one path are two polygons, not a polygon with a hole.
/// ```
/// use coface_answers::polygons_of_fill_rules;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = br#"<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H1V1H0Z M2 0H3V1H2Z"/></svg>"#;
/// let drawing = coface_io::read(&text[..], coface_io::Format::Svg)?;
/// let (model, remark) = polygons_of_fill_rules(&drawing)?.expect("the path has two parts");
/// let mut written = Vec::new();
/// coface_io::write(&model, &mut written, coface_io::Format::Wkt)?;
/// assert!(written.starts_with(b"MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((2 0,"));
/// assert!(remark.message.starts_with("1 shape is written"));
/// # Ok(()) }
/// ```
pub fn polygons_of_fill_rules(model: &Model) -> Result<Option<(Model, Remark)>, Error> {
    if FillRules::of(model).are_none() {
        return Ok(None);
    }
    let layer = MapLayer::new(&[("drawing", model)])?;
    let changed = layer.filled_count;
    if changed == 0 {
        return Ok(None);
    }
    let mut builder = MapBuilder::new(layer.has_heights);
    for feature in &layer.features {
        builder.add(&feature.geometry, &feature.properties, &feature.id);
    }
    let what = if changed == 1 { "1 shape is".to_owned() } else { format!("{changed} shapes are") };
    let message =
        format!("{what} written as outer rings and holes of what the fill rule of the drawing fills");
    Ok(Some((
        builder.finish(layer.reference)?,
        Remark::new(RemarkCode::ModelRepaired, message).at(changed, []),
    )))
}
