//! Still pictures, and models for programs that show them: of scenes, as PNG by a depth buffer, as SVG and PDF with what is hidden left out, and as animations; flat ones of boundary matrices,
//! persistence diagrams and sets of the plane; scenes as glTF, and colors of vertices.
//!
//! # Words and conventions
//! * Pixels count from the upper left corner; x goes to the right, y down. **Depth** grows away from the eye and is linear in the
//!   picture, also in perspective.
//! * A **camera** looks at the middle of the scene from a direction, so that all of it is in the picture.
//! * A layer that is not shown at first is not drawn. What hides lines of layers lets them shine through faintly.
//! * A **facet** is a triangle in the picture. A **flat picture** has no depth: one part is painted over the other.
//! * PNG needs no fonts: letters are strokes. The same picture has the same bytes on every machine.

mod barcode;
mod camera;
mod canvas;
mod coloring;
mod diagram;
mod drawing;
mod flat;
mod flat_svg;
mod formula;
#[cfg(feature = "png")]
mod gif_file;
mod gltf;
mod image;
mod legend;
mod letters;
mod matrix;
mod matrix_blocks;
mod painting;
mod palette;
mod pane;
mod pdf;
#[cfg(feature = "png")]
mod pixels;
mod raster;
mod scene_picture;
mod schema;
mod sequence;
mod sight;
mod spin;
mod style;
mod svg_text;
#[cfg(feature = "png")]
mod webp_file;

pub use barcode::barcode_picture;
pub use camera::Camera;
pub use coloring::{Coloring, colored, vertex_colors};
pub use diagram::{DiagramPoint, diagram_picture};
pub use flat::FlatPicture;
pub(super) use flat::{Anchor, Step};
pub use gltf::{GltfForm, gltf, gltf_rounding};
pub use image::image_picture;
pub use matrix::matrix_picture;
pub use matrix_blocks::blocked_matrix_picture;
pub use palette::palette_color;
pub(super) use palette::{Color, color_of_many, mixed, of as color_of};
pub use pane::pane_picture;
pub use scene_picture::Picture;
pub(super) use scene_picture::{COMPLEX, LABELS, NEIGHBORHOOD};
pub use schema::schema_picture;
pub use sequence::sequence_picture;
pub use spin::{spin_frames, spin_gif, spin_png, spin_webp};
pub use style::PictureStyle;
