//! Segments with any finite coordinates make an arrangement whose boundaries of boundaries are zero.
#![no_main]

use coface::arrange::planar::PlanarArrangement;
use coface::geometry::Positions;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let coordinates: Vec<f64> = bytes
        .chunks_exact(8)
        .take(80)
        .map(|chunk| f64::from_le_bytes(chunk.try_into().expect("chunks are of eight bytes")))
        .filter(|x| x.is_finite())
        .collect();
    let count = coordinates.len() / 4 * 2;
    let Ok(positions) = Positions::from_flat(2, coordinates[..2 * count].to_vec()) else { return };
    let segments: Vec<[u32; 2]> = (0..count as u32 / 2).map(|i| [2 * i, 2 * i + 1]).collect();
    if let Ok(arrangement) = PlanarArrangement::new(&positions, &segments) {
        arrangement.chain_complex().expect("boundaries of boundaries are zero");
    }
});
