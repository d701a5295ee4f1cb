//! Tests of `coface-io`, in one program: each test program links everything anew.

mod few_bytes;
mod files;
mod formats;
mod mesh_formats;
mod nonfinite;
mod print_formats;
mod wild;
