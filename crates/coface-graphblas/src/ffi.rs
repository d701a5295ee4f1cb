//! The functions of the C library that are used, as `GraphBLAS.h` declares them.
#![allow(non_snake_case, reason = "names of the C library")]

use std::ffi::c_int;
use std::marker::{PhantomData, PhantomPinned};

/// An object of the C library, known by its address only.
#[repr(C)]
pub(crate) struct Opaque {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// `GrB_Matrix`, `GrB_Type`, `GrB_Semiring`, `GrB_BinaryOp` and `GrB_Descriptor`: pointers to objects.
pub(crate) type Handle = *mut Opaque;

/// `GrB_BLOCKING`: each function has done its work when it returns.
pub(crate) const BLOCKING: c_int = 1;
/// `GrB_CSC_FORMAT`: compressed columns.
pub(crate) const COMPRESSED_COLUMNS: c_int = 1;

#[link(name = "graphblas")]
unsafe extern "C" {
    pub(crate) static GrB_INT64: Handle;
    pub(crate) static GrB_PLUS_INT64: Handle;
    pub(crate) static GrB_PLUS_TIMES_SEMIRING_INT64: Handle;

    pub(crate) fn GrB_init(mode: c_int) -> c_int;

    pub(crate) fn GrB_Matrix_new(matrix: *mut Handle, kind: Handle, rows: u64, columns: u64) -> c_int;
    pub(crate) fn GrB_Matrix_free(matrix: *mut Handle) -> c_int;

    pub(crate) fn GrB_Matrix_build_INT64(
        matrix: Handle,
        rows: *const u64,
        columns: *const u64,
        entries: *const i64,
        count: u64,
        sum: Handle,
    ) -> c_int;

    pub(crate) fn GrB_Matrix_import_INT64(
        matrix: *mut Handle,
        kind: Handle,
        row_count: u64,
        column_count: u64,
        starts: *const u64,
        rows: *const u64,
        entries: *const i64,
        start_count: u64,
        row_index_count: u64,
        entry_count: u64,
        format: c_int,
    ) -> c_int;

    pub(crate) fn GrB_Matrix_exportSize(
        start_count: *mut u64,
        row_index_count: *mut u64,
        entry_count: *mut u64,
        format: c_int,
        matrix: Handle,
    ) -> c_int;

    pub(crate) fn GrB_Matrix_export_INT64(
        starts: *mut u64,
        rows: *mut u64,
        entries: *mut i64,
        start_count: *mut u64,
        row_index_count: *mut u64,
        entry_count: *mut u64,
        format: c_int,
        matrix: Handle,
    ) -> c_int;

    pub(crate) fn GrB_mxm(
        product: Handle,
        mask: Handle,
        accumulator: Handle,
        semiring: Handle,
        first: Handle,
        second: Handle,
        descriptor: Handle,
    ) -> c_int;
}
