//! GeoJSON and TopoJSON: points, lines and polygons with holes, with names and properties.
//!
//! A file is a `FeatureCollection`, a `Feature`, a geometry (`Point`, `MultiPoint`, `LineString`, `MultiLineString`,
//! `Polygon`, `MultiPolygon`, `GeometryCollection`), or the bare coordinates of a polygon or of several,
//! whose rings need not have their first position at the end again. A `Topology` (TopoJSON) is read as the map that it stands for:
//! arcs are joined, whole numbers become coordinates by its `transform`, and the geometries of each object are features.
//! GeoPackage and FlatGeobuf are not read: convert them to GeoJSON, for instance with `ogr2ogr map.geojson map.gpkg`.
//!
//! Lines and points share their vertices: equal positions are one vertex, so that ways that meet are connected. A polygon with
//! holes is no polygon of a mesh: each ring becomes a closed line, and two arrays of integers on the lines say what
//! it bounds. `polygon` numbers the polygons from 0, `ring` is 0 for the outer ring and 1, 2, .. for the holes; both
//! are -1 for lines that are no rings. Where a feature without a name has several polygons a third one, `feature`, numbers
//! the features without names, and is -1 for others. Rings have vertices of their own, so polygons that touch stay apart. The
//! direction of a ring is that of the file.
//!
//! The property `name` of a feature, in any case, or else its `id`, names a group of its lines or points. All
//! properties of each feature, and its id, are kept as they stand in a [`FeatureTable`](crate::FeatureTable); a file
//! that is written has them again, and so the reference system that `crs` names. Coordinates are taken as they stand.
//! A file may hold several objects one after the other, such as a feature a line, or the records of a text sequence (RFC 8142, each behind a
//! byte 0x1E): they are one drawing.
//!
//! What lies in several features, a face of an arrangement for instance, has the properties of all of them: a key
//! with one value, or with equal ones, keeps it, a key with different values has the list of them, as
//! [`MergedProperties`] says.

mod columns;
mod coordinates;
mod properties;
mod reading;
#[cfg(test)]
mod tests;
mod topology;
mod writing;

#[doc(hidden)]
pub use columns::{equal_text, property_pairs};
pub use properties::MergedProperties;
pub use reading::read;
pub(super) use reading::{first_record, is_geojson};
pub use writing::write;
#[doc(hidden)]
pub use writing::{write_with, write_with_texts};
