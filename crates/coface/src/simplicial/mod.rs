//! Simplicial complexes of any dimension.
