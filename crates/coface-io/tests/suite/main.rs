//! Tests of `coface-io`, in one program: each test program links everything anew.

mod doors;
mod mesh_doors;
