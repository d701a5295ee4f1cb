//! Guide 12: complexes larger than memory: shards in a folder, each reduced alone, merged to the answer.
//!
//! Run with `cargo run -p coface --example 12_shards`.

use coface::io;
use coface::io::Format;
use coface::scale::shards::{GridSort, ShardFolder, ShardRequest, shard_grid, shard_model};

fn main() -> Result<(), coface::Error> {
    let folder = tempfile::tempdir()?;

    // A model, here a sphere of four triangles, as three files. What two shards share is reduced in the same way in both, so that the results fit
    // together without a message between them.
    let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    let sphere = shard_model(model, &folder.path().join("sphere"), &ShardRequest::new("sphere", 3))?;
    assert_eq!(sphere.manifest().part_count, 3);
    for number in 0..3 {
        // On a cluster each number is a task of its own, and only reads its own file.
        let step = sphere.reduce(number, false)?;
        assert!(step.is_new() && step.path().is_file());
    }
    // A step that is done is not done twice: a run that was cut short goes on where it was.
    assert!(!sphere.reduce(0, false)?.is_new());
    let found = sphere.merge_all(false)?;
    assert_eq!(found.cells(), [4, 6, 4]);
    assert_eq!(found.homology().betti_numbers(), [1, 0, 1]);

    // A grid is never held as a whole: its shards are made of boxes of voxels. With both ends of each axis glued, it is a torus.
    let request = ShardRequest::new("torus", 4).fan_in(2);
    let path = folder.path().join("torus");
    let torus = shard_grid(GridSort::Cubes, &[8, 8, 8], &[true; 3], &path, &request)?;
    let count = torus.manifest().part_count;
    assert!(count >= 4);
    (0..count).try_for_each(|number| torus.reduce(number, false).map(drop))?;
    let found = torus.merge_all(false)?;
    // 8 by 8 by 8 cubes have 512 vertices, three edges and three squares for each vertex, and as many cubes as vertices.
    assert_eq!(found.cells(), [512, 1536, 1536, 512]);
    assert_eq!(found.homology().betti_numbers(), [1, 3, 3, 1]);
    // Two files are merged at a time: four shards need two levels above them.
    assert!(found.levels().len() >= 3);
    assert_eq!(found.levels().last().map(|level| level.parts()), Some(1));

    // The folder is all there is: another process opens it, and asks for generators on the cells of the shards.
    let opened = ShardFolder::open(&path)?;
    let generators = opened.generators()?;
    assert_eq!(generators.degrees.iter().map(Vec::len).collect::<Vec<_>>(), [1, 3, 3, 1]);
    // The one of degree 3 is the sum of all cubes.
    assert_eq!(generators.degrees[3][0].terms.len(), 512);
    Ok(())
}
