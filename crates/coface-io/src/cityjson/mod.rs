//! CityJSON 1.0, 1.1 and 2.0, and CityJSON text sequences (CityJSONSeq): cities, buildings and their rooms.
//!
//! | CityJSON | becomes |
//! |---|---|
//! | an object with a geometry | a [`Group`](crate::Group) of polygons with the role of an object, named by its id |
//! | its id and attributes | a feature: [`FeatureTable`](crate::FeatureTable) |
//! | a surface with holes | triangles on its own vertices, with a remark; holes that cross or touch their rings along edges are left out |
//! | rings, shells and solids | [`StatedSurfaces`](crate::StatedSurfaces), which `info` checks |
//! | the semantics of a surface, such as `WallSurface` | a [`Group`](crate::Group) of polygons |
//! | shells of solids, inner shells too | polygons; together they run counterclockwise seen from outside of the solid |
//! | `MultiPoint`, `MultiLineString` | points and lines |
//! | `GeometryInstance` | its template, moved |
//!
//! An object has its geometries of one level of detail: the highest, or the one of
//! [`ReadOptions::lod`](crate::ReadOptions::lod). Solids go before
//! surfaces of the same level. Vertices are the decimal numbers that the transform says, each rounded once.
//! Appearances, extensions and vertices that no
//! chosen geometry has are passed over.

mod document;
mod nested;
mod reading;
#[cfg(test)]
mod tests;
mod transform;

pub use reading::read;
pub(crate) use reading::{is_cityjson, read_with};
