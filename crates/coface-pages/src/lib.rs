//! What people read and look at: answers of the library as [`text`] for a terminal, as a page of [`html`], and the interactive page
//! of a scene, by [`viewer`]. The program and the Python package show the same.

pub mod html;
pub mod text;
pub mod viewer;
