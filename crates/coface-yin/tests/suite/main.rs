//! Tests of `coface-yin`, in one program: each test program links everything anew.

mod near_identical;
mod small_differences;
mod splines;
mod yin_algebra;
mod yin_booleans;
mod yin_comparisons;
mod yin_curved;
mod yin_curves;
mod yin_cut_cells;
mod yin_events;
mod yin_flows;
mod yin_homology;
mod yin_interface_edits;
mod yin_interface_events;
mod yin_interfaces;
mod yin_invariance;
mod yin_kinks;
mod yin_lattice;
mod yin_nesting;
mod yin_places;
mod yin_scales;
mod yin_sets;
mod yin_soups;
mod yin_tangencies;
mod yin_tracking;
