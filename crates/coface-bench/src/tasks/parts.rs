//! Complexes block by block, and volumes of voxels.

use super::{Clock, Task, Work};
use crate::inputs::torus;
use coface::Error;
use coface::algebra::chains::{Part, PartTree, Parts};
use coface::answers::homology_of_volume;
use coface::complexes::cubical::{CubicalBlocks, FullVoxels, SimplicialBlocks};
use coface::io;
use coface::io::Structure;
use coface::topology::homology;
use std::sync::atomic::{AtomicUsize, Ordering};

pub(super) const TORUS: Task = Task {
    name: "parts-torus",
    about: "integral homology of the cubical 3-torus of which nothing is stored, block by block",
    extension: "txt",
    inputs: &["torus_64x8", "torus_128x64", "torus_256x512", "torus_256x64"],
    work: Work::Inside(|path, clock| {
        let (side, parts) = torus(&std::fs::read_to_string(path)?)?;
        let volume = FullVoxels::new(&[side; 3], &[true; 3])?;
        let blocks = CubicalBlocks::at_least(&volume, parts)?;
        reduced(blocks, 8 * (side as usize).pow(3), clock)
    }),
};

pub(super) const SIMPLICIAL_TORUS: Task = Task {
    name: "parts-simplicial",
    about: "the same with each cube cut into six tetrahedra",
    inputs: &["torus_32x64", "torus_64x64", "torus_128x64"],
    work: Work::Inside(|path, clock| {
        let (side, parts) = torus(&std::fs::read_to_string(path)?)?;
        let volume = FullVoxels::new(&[side; 3], &[true; 3])?;
        let blocks = SimplicialBlocks::at_least(&volume, parts)?;
        reduced(blocks, 26 * (side as usize).pow(3), clock)
    }),
    ..TORUS
};

pub(super) const VOLUME: Task = Task {
    name: "volume",
    about: "integral homology of the cubical complex of a volume of voxels, the voxels in memory",
    extension: "npy",
    inputs: &["gyroid_64", "gyroid_128", "gyroid_256", "box_128"],
    work: Work::Inside(|path, clock| {
        let model = io::read_path(path, None)?;
        let Some(Structure::Volume(volume)) = model.structure() else {
            return Err(Error::invalid("the input is no volume"));
        };
        let cells = 8 * volume.voxel_count();
        let (_, groups) = clock.time(cells, || homology_of_volume(volume))?;
        Ok(betti_text(&groups.betti_numbers()))
    }),
};

/// Blocks whose strata and critical cells are counted.
struct Counted<P> {
    parts: P,
    strata: AtomicUsize,
}

impl<P: Parts> Parts for Counted<P> {
    fn part_count(&self) -> u32 {
        self.parts.part_count()
    }

    fn part(&self, number: u32) -> Result<Part, Error> {
        let part = self.parts.part(number)?;
        let own = part.keys().0.iter().filter(|key| key[0] == number).count();
        self.strata.fetch_add(own, Ordering::Relaxed);
        Ok(part)
    }
}

fn reduced(parts: impl Parts, cells: usize, clock: &mut Clock) -> Result<String, Error> {
    let parts = Counted { parts, strata: AtomicUsize::new(0) };
    clock.time(cells, || {
        let tree = PartTree::new(&parts, 8)?;
        let levels: Vec<String> =
            tree.critical_counts().iter().map(|counts| counts.iter().sum::<usize>().to_string()).collect();
        let groups = homology(tree.root().complex());
        Ok(format!(
            "{}, {} parts, {} strata, critical {}",
            betti_text(&groups.betti_numbers()),
            parts.part_count(),
            parts.strata.load(Ordering::Relaxed),
            levels.join(" > ")
        ))
    })
}

fn betti_text(numbers: &[usize]) -> String {
    numbers.iter().fold("betti".to_owned(), |text, number| format!("{text} {number}"))
}
