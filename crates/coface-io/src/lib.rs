//! Readers and writers of file formats, one module a format, and [`Model`], which holds what a file holds.
//!
//! A reader takes bytes and returns a whole [`Model`], or an error that names the line or the byte. It never allocates memory by a
//! count that a file merely claims. Indices in a model are 0-based whatever the format does. [`read_path`] and
//! [`write_path`] detect the format.
//!
//! # Features
//! * `xml` (default): SVG, VTK XML, COLLADA and AMF are read. The first two are written without it.
//! * `compression` (default): compressed files of all formats and compressed arrays of VTK XML are read.
//! * `gltf` (default): glTF and GLB are read.
//! * `images` (default): images as PNG are read.
//! * `archives` (default): 3MF is read and written.
//!
//! A reader that a build leaves out refuses its files and names the feature.
//!
#![doc = include_str!("../README.md")]

pub mod abaqus;
mod alpha;
pub mod amf;
mod arcs;
mod assembly;
mod blocks;
mod cech;
mod cells_not_balls;
pub mod cityjson;
pub mod collada;
mod complex_reading;
pub mod container;
mod counted_stream;
mod data;
mod decimal;
mod decimal_commas;
mod detection;
mod drawing;
mod element_kind;
mod entries;
mod equal_corners;
mod feature_table;
mod features;
mod files;
mod filtered_model;
mod foreign;
mod format;
mod generated;
pub mod geojson;
mod geometries;
pub mod gltf;
mod graph;
mod group;
mod holed_faces;
pub mod isosig;
pub mod json;
mod json_text;
mod keeping;
mod limits;
pub mod lines_text;
mod lists;
mod losses;
mod mapper;
pub mod matrix_market;
pub mod medit;
#[cfg(test)]
mod mesh_tests;
mod model;
mod model_cells;
pub mod msh;
mod number_table;
mod numbers;
pub mod obj;
mod oddities;
pub mod off;
mod parts;
mod planar_facet;
pub mod ply;
mod points_table;
pub mod points_text;
mod print_objects;
mod readers;
mod reference_system;
mod remark;
mod rips;
#[cfg(test)]
mod samples;
mod scanner;
mod scene;
mod scratch_mesh;
mod space_faces;
mod stated_surfaces;
pub mod stl;
mod stream_start;
pub mod svg;
mod table_form;
mod tail;
pub mod tetgen;
pub mod three_mf;
mod triangles;
mod unpacking;
mod utf16;
mod values;
pub mod volume;
pub mod vtk;
mod witness;
pub mod wkb;
pub mod wkt;
mod wkt_table;
mod word_columns;
mod written;
#[cfg(feature = "xml")]
mod xml_text;
pub mod yin;

pub use alpha::{AlphaCells, AlphaPoints, AlphaReading};
pub use cech::{CechPoints, CechReading};
pub use cells_not_balls::cells_not_balls;
pub use data::CellData;
#[doc(hidden)]
pub use decimal_commas::with_decimal_points;
#[doc(hidden)]
pub use drawing::{Features, features_of_shapes};
pub use drawing::{Shape, shapes};
pub use entries::{FileEntries, entries_of_path};
pub use feature_table::FeatureTable;
#[doc(hidden)]
pub use files::{
    FolderLock, MadeFolders, StagedFiles, TemporaryFolder, check_output, open_regular, replace_files,
    replace_together,
};
pub use files::{abandon_files, content_hash, replace_file};
pub use format::Format;
pub use graph::FileGraph;
pub use group::{Group, GroupKind, GroupRole};
pub use isosig::{SignatureLine, SignatureLines};
#[doc(hidden)]
pub use losses::single_precision_remark;
pub use losses::{losses, signature_losses, unread_remark};
pub use mapper::{Lens, MapperPoints, MapperReading};
pub use model::repeated_vertex;
pub use model::{Model, Structure};
#[doc(hidden)]
pub use model::{ModelParts, placed, segments};
pub use number_table::NumberTable;
pub use parts::parts_of_path;
pub use points_table::vertices_of_path;
pub use readers::{
    ReadOptions, format_of_path, read, read_boundary, read_boundary_path, read_boundary_with, read_named,
    read_path, read_path_with, read_unknown, read_with, volume_of, volume_of_path, write, write_path,
};
#[doc(hidden)]
pub use readers::{entry_of, read_companion, stream_mesh, write_empty_polygon};
pub use reference_system::ReferenceSystem;
pub use remark::{Place, Remark, RemarkCode};
pub use rips::{FlagReading, RipsPoints, RipsReading};
#[doc(hidden)]
pub use scratch_mesh::NO_VERTEX;
pub use stated_surfaces::StatedSurfaces;
pub use table_form::TableForm;
pub use unpacking::unpacked_bytes;
#[doc(hidden)]
pub use volume::VoxelFrame;
pub use volume::{VolumeReading, VolumeStream, VolumeWindows, VoxelRule};
pub use witness::{WitnessPoints, WitnessReading};
#[doc(hidden)]
pub use written::{format_of_output, never_written};
