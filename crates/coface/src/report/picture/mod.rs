//! Still pictures of scenes: PNG by a depth buffer, SVG with what is hidden left out; sparsity of boundary matrices.
//!
//! # Words and conventions
//! * Pixels count from the upper left corner; x goes to the right, y down. **Depth** grows away from the eye and is linear in the
//!   picture, also in perspective.
//! * A **camera** looks at the middle of the scene from a direction, so that all of it is in the picture.
//! * A layer that is not shown at first is not drawn.

mod camera;
mod matrix;
mod palette;
mod raster;
mod style;
mod svg;

pub use camera::Camera;
pub use matrix::matrix_picture;
pub use style::{Picture, PictureStyle};
