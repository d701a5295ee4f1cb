//! Pages for browsers: answers as [`html`], and the interactive page of a scene, by [`viewer`]. Each is one file that needs no network.

pub mod html;
pub mod viewer;
