//! Scenes, stills and pages.
//!
#![doc = include_str!("../README.md")]

pub mod pages;
mod picture;
mod scene;
mod set_picture;

pub use picture::{
    Camera, Coloring, DiagramPoint, FlatPicture, GltfForm, Picture, PictureStyle, blocked_matrix_picture,
    colored, diagram_picture, gltf, matrix_picture, palette_color, pane_picture, schema_picture,
    sequence_picture, spin_png, vertex_colors,
};
pub use scene::{
    LabelDocument, Layer, LayerDocument, PackedLists, PackedTriangles, Pane, PaneDocument, Scene,
    SceneDocument, SceneReport,
};
pub use set_picture::{SetPicture, set_picture};
