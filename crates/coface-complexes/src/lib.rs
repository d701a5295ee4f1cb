//! Producers: cell complexes of every kind, and the chain complexes they give.

pub mod cellular;
pub mod simplicial;
pub mod surface;
