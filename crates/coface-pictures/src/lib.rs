//! Scenes, stills and pages.
//!
#![doc = include_str!("../README.md")]

mod interface_picture;
pub mod pages;
mod picture;
mod scene;
mod set_picture;

pub use interface_picture::interface_picture;
pub use picture::{
    Camera, Coloring, DiagramPoint, FlatPicture, GltfForm, Picture, PictureStyle, barcode_picture,
    blocked_matrix_picture, colored, diagram_picture, gltf, gltf_rounding, image_picture, matrix_picture,
    palette_color, pane_picture, schema_picture, sequence_picture, spin_frames, spin_gif, spin_png,
    spin_webp, vertex_colors,
};
pub use scene::{
    LabelDocument, Layer, LayerDocument, PackedLists, PackedTriangles, Pane, PaneDocument, Scene,
    SceneDocument, SceneReport,
};
pub use set_picture::{SetPicture, set_picture};
