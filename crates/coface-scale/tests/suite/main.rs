//! Tests of `coface-scale`, in one program: each test program links everything anew.

mod shards;
mod shards_streamed;
