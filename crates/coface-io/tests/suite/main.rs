//! Tests of `coface-io`, in one program: each test program links everything anew.

mod formats;
mod mesh_formats;
mod nonfinite;
mod wild;
