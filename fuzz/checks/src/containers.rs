//! The binary container and what the folders of shards hold.
//!
//! Nearly all changes of a container are found by its checksums, behind which nothing would ever be tried. So the checks make the checksums
//! right first, and the starts and lengths that the format leaves no choice for.

use crate::models::{check_model, check_round};
use coface::io::{Format, read};
use coface::scale::shards::{
    ShardChains, ShardFolder, ShardPlace, chains_on_cells, merge, part_of_shard, reduce, root_chains,
    root_homology, sum_chains, summary,
};
use xxhash_rust::xxh3::xxh3_64;

const MARK: [u8; 8] = *b"\x89cfc\r\n\x1a\n";
const HEADER: usize = 64;
const ROW: usize = 40;
const ALIGNMENT: usize = 64;

/// The container of this kind that bytes come nearest to: mark, version, starts and checksums are made right, and lengths are cut to what is
/// there. Roles, indices, widths and contents stay as they are.
fn mended(bytes: &[u8], kind: u32) -> Vec<u8> {
    let mut out = bytes.to_vec();
    out.resize(out.len().max(HEADER), 0);
    out[..8].copy_from_slice(&MARK);
    out[8..12].copy_from_slice(&1u32.to_le_bytes());
    out[12..16].copy_from_slice(&kind.to_le_bytes());
    out[28..32].fill(0);
    out[40..64].fill(0);
    let stated = u32::from_le_bytes(out[24..28].try_into().expect("four bytes")) as usize;
    let count = stated.min((out.len() - HEADER) / ROW).min(64);
    out[24..28].copy_from_slice(&(count as u32).to_le_bytes());
    let table_end = HEADER + ROW * count;
    let mut end = table_end;
    for i in 0..count {
        let row = HEADER + ROW * i;
        let stated = u64::from_le_bytes(out[row + 24..row + 32].try_into().expect("eight bytes"));
        let start = end.next_multiple_of(ALIGNMENT);
        let left = out.len().saturating_sub(start);
        let length = usize::try_from(stated).unwrap_or(usize::MAX).min(left);
        if start > out.len() {
            out.resize(start, 0);
        }
        out[end..start].fill(0);
        let checksum = xxh3_64(&out[start..start + length]);
        out[row + 12..row + 16].fill(0);
        out[row + 16..row + 24].copy_from_slice(&(start as u64).to_le_bytes());
        out[row + 24..row + 32].copy_from_slice(&(length as u64).to_le_bytes());
        out[row + 32..row + 40].copy_from_slice(&checksum.to_le_bytes());
        end = start + length;
    }
    out.truncate(end);
    out[16..24].copy_from_slice(&(end as u64).to_le_bytes());
    let checksum = xxh3_64(&[&out[..32], &out[40..table_end]].concat());
    out[32..40].copy_from_slice(&checksum.to_le_bytes());
    out
}

/// The container of a chain complex: it makes a complex whose products are zero, or an error.
pub fn read_container(bytes: &[u8]) {
    drop(read(bytes, Format::Container));
    if let Ok(model) = read(&mended(bytes, 1)[..], Format::Container) {
        check_model(&model);
        check_round(&model, Format::Container);
    }
}

/// A shard: its part of a complex is sound, and it is reduced or refused.
pub fn read_shard(bytes: &[u8]) {
    let shard = mended(bytes, 2);
    drop(part_of_shard(&shard));
    if let Ok(reduced) = reduce(&shard) {
        summary(&reduced).expect("what was made by reducing is a reduced shard");
        check_reduced(&reduced);
    }
}

/// Reduced shards: they are merged with themselves, and taken for the whole, or refused.
pub fn read_reduced_shard(bytes: &[u8]) {
    check_reduced(&mended(bytes, 3));
}

fn check_reduced(reduced: &[u8]) {
    if let Ok(found) = summary(reduced) {
        let place = found.place();
        drop(merge(place.at(place.level + 1, place.number / place.fan_in.max(1)), &[reduced]));
    }
    if let Ok(homology) = root_homology(reduced) {
        assert!(!homology.groups().is_empty() || summary(reduced).is_ok());
    }
    if let Ok(chains) = root_chains(reduced) {
        ShardChains::from_bytes(&chains).expect("what was made is read");
    }
    let place = ShardPlace::new(1, 2, 2, 0).expect("a place of two shards");
    drop(merge(place.at(1, 0), &[reduced, reduced]));
}

/// Chains by ids: read, written again as they are, and added to themselves.
pub fn read_chains(bytes: &[u8]) {
    let chains = mended(bytes, 4);
    if let Ok(read) = ShardChains::from_bytes(&chains) {
        let written = read.to_bytes();
        let again = ShardChains::from_bytes(&written).expect("what is written is read");
        assert!(again.to_bytes() == written, "chains are written differently after they were read");
    }
    drop(sum_chains(&[&chains, &chains]));
    drop(chains_on_cells(&mended(bytes, 2), &chains));
}

/// The list of a folder of shards: the file `shards.json` alone in its folder.
pub fn read_manifest(bytes: &[u8]) {
    let folder = tempfile::tempdir().expect("a folder for temporary files");
    std::fs::write(folder.path().join("shards.json"), bytes).expect("a file in it");
    if let Ok(shards) = ShardFolder::open(folder.path()) {
        let manifest = shards.manifest();
        assert!(manifest.part_count > 0 && manifest.fan_in > 1);
        // Nothing is there but the list.
        assert!(shards.merge_all(false).is_err());
    }
}
