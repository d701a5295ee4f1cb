//! Numbers as they stand in sections.

use bytemuck::Pod;
use std::borrow::Cow;
use xxhash_rust::xxh3::Xxh3;

/// A number that sections hold.
pub trait Element: Pod {
    /// The number whose bytes, as they stand in a file, are those of `self` in memory; and back.
    fn swapped(self) -> Self;
}

macro_rules! element {
    ($($number:ty),*) => {
        $(impl Element for $number {
            fn swapped(self) -> Self {
                Self::from_le(self)
            }
        })*
    };
}

element!(u8, i8, u32, i32, u64, i64);

impl Element for f64 {
    fn swapped(self) -> Self {
        Self::from_bits(u64::from_le(self.to_bits()))
    }
}

/// The bytes of an array as they stand in a file.
pub(super) fn to_bytes<T: Element>(array: &[T]) -> Cow<'_, [u8]> {
    if cfg!(target_endian = "little") {
        return Cow::Borrowed(bytemuck::cast_slice(array));
    }
    Cow::Owned(array.iter().flat_map(|&x| bytemuck::bytes_of(&x.swapped()).to_vec()).collect())
}

/// Adds an array, as it stands in a file, to a hash.
pub fn hash_array<T: Element>(hash: &mut Xxh3, array: &[T]) {
    hash.update(&to_bytes(array));
}

/// The array with these bytes, whose number is a multiple of the width: in place where memory has them as the machine wants them.
pub fn array_of_bytes<T: Element>(bytes: &[u8]) -> Cow<'_, [T]> {
    match bytemuck::try_cast_slice(bytes) {
        Ok(array) if cfg!(target_endian = "little") => Cow::Borrowed(array),
        _ => {
            let elements = bytes.chunks_exact(size_of::<T>());
            Cow::Owned(elements.map(|bytes| bytemuck::pod_read_unaligned::<T>(bytes).swapped()).collect())
        }
    }
}
