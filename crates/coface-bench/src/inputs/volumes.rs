//! Volumes of voxels: NumPy arrays of bytes, or only a name where every voxel is set.

use coface::Error;
use coface::complexes::cubical::CubicalVolume;
use coface::io::volume::write_npy;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

/// Writes the volume of this name; `None` if it names none.
///
/// # Errors
/// If the size is out of range, or the file cannot be written.
pub(super) fn write(name: &str, path: &Path) -> Option<Result<(), Error>> {
    if name.strip_prefix("torus_").is_some() {
        return Some(torus(name).and_then(|_| Ok(std::fs::write(path, name)?)));
    }
    let (is_full, side) = match (name.strip_prefix("gyroid_"), name.strip_prefix("box_")) {
        (Some(side), _) => (false, side),
        (_, Some(side)) => (true, side),
        _ => return None,
    };
    Some(side_of(name, side).and_then(|side| {
        let volume = if is_full { CubicalVolume::full(&[side; 3], &[false; 3])? } else { gyroid(side)? };
        write_npy(&volume, BufWriter::new(File::create(path)?))
    }))
}

/// The side and the number of blocks of a torus named `torus_NxP`.
///
/// # Errors
/// If it is named otherwise.
pub(crate) fn torus(name: &str) -> Result<(u32, u32), Error> {
    let size = name.trim().strip_prefix("torus_").and_then(|size| size.split_once('x'));
    let (side, parts) =
        size.ok_or_else(|| Error::invalid(format!("{name:?} names no torus")).with_cure("write torus_64x8"))?;
    Ok((side_of(name, side)?, side_of(name, parts)?))
}

fn side_of(name: &str, text: &str) -> Result<u32, Error> {
    let number: Option<u32> = text.parse().ok().filter(|side| (1..=1 << 20).contains(side));
    number.ok_or_else(|| Error::invalid(format!("{name:?} has no size from 1 to 2^20")))
}

/// One side of the gyroid, a surface of high genus, with a voxel in sixteen turned over: loops and cavities of all sizes.
fn gyroid(side: u32) -> Result<CubicalVolume, Error> {
    let angles: Vec<(f64, f64)> = (0..side).map(|x| (f64::from(x) * 0.4).sin_cos()).collect();
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    CubicalVolume::new(&[side; 3], &[false; 3], |voxel| {
        let [(sx, cx), (sy, cy), (sz, cz)] = [0, 1, 2].map(|axis| angles[voxel[axis] as usize]);
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (sx * cy + sy * cz + sz * cx > 0.0) != state.is_multiple_of(16)
    })
}
