//! Messages about work in parts.

use super::{Case, Files};

const BOOK: Files = &[("book.json", "[[0,1,2],[0,1,3],[0,1,4]]")];
const TWO: Files = &[("book.json", "[[0,1,2],[0,1,3],[0,1,4]]"), ("other.json", "[[0,1,2,3]]")];
const VOXELS: Files = &[(
    "voxels.nrrd",
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n1 1 1 1 1 1 1 0\n",
)];
const FOLDER: &str = "shards/folder.rs";
const SHARDED: &str = "coface shard book.json --parts 2 -o parts";

pub(super) const CASES: &[Case] = &[
    Case::new("homology/mod.rs", "needs the whole complex in memory; leave {option} out, or --parts")
        .files(BOOK)
        .refused("coface homology book.json --reduced --parts 2 --memory 1G --work w")
        .cured(&[
            &["coface homology book.json --parts 2 --memory 1G --work w"],
            &["coface homology book.json --reduced"],
        ]),
    Case::new("homology/mod.rs", "needs the whole complex in memory; leave {option} out, or --parts")
        .refused("coface homology --grid 2,2 --simplicial --cup 1 1")
        .cured(&[&["coface homology --grid 2,2 --simplicial"]]),
    Case::new("workers.rs", "is too little for any part; give --memory")
        .files(BOOK)
        .refused("coface homology book.json --memory 1M")
        .cured(&[&["coface homology book.json --memory 96M"]]),
    Case::new("workers.rs", "name another folder with --work")
        .files(BOOK)
        .refused("coface homology book.json --parts 2 --work book.json")
        .cured(&[&["coface homology book.json --parts 2 --work work"]]),
    Case::new(
        "persistence.rs",
        "parts give the diagram of the values of a volume alone; leave {option} out, or --parts and --work",
    )
    .files(VOXELS)
    .refused("coface persistence voxels.nrrd --parts 2 --work w --cycles")
    .cured(&[&["coface persistence voxels.nrrd --parts 2"], &["coface persistence voxels.nrrd --cycles"]]),
    Case::new("persistence/parts.rs", "and this is none; leave --parts and --work out")
        .files(BOOK)
        .refused("coface persistence book.json --parts 2 --work w")
        .cured(&[&["coface persistence book.json"]]),
    Case::new("workers.rs", "is too little for any part; give --memory")
        .files(VOXELS)
        .refused("coface persistence voxels.nrrd --parts 2 --memory 1M")
        .cured(&[&["coface persistence voxels.nrrd --parts 2 --memory 96M"]]),
    Case::new("commands/merge.rs", "leave --coefficients and --cohomology away")
        .files(BOOK)
        .before(&[SHARDED, "coface reduce parts"])
        .refused("coface merge parts --generators --coefficients f2 --cohomology")
        .cured(&[&["coface merge parts --generators"]]),
    Case::new("commands/shard.rs", "volumes are cut into boxes; leave --owners away")
        .files(VOXELS)
        .refused("coface shard voxels.nrrd --parts 2 --owners walk -o parts")
        .cured(&[&["coface shard voxels.nrrd --parts 2 -o parts"]]),
    Case::new("commands/shard.rs", "--simplicial cuts voxels, and there are none; leave it away")
        .files(BOOK)
        .refused("coface shard book.json --parts 2 --simplicial -o parts")
        .cured(&[&["coface shard book.json --parts 2 -o parts"]]),
    Case::new(FOLDER, "name files that coface shard has made")
        .files(BOOK)
        .refused("coface reduce book.json")
        .cured(&[&[SHARDED, "coface reduce parts"]]),
    Case::new(FOLDER, "name an empty folder, or replace them by coface shard --force")
        .files(TWO)
        .before(&["coface homology book.json --parts 2 --work parts"])
        .refused("coface homology other.json --parts 2 --work parts")
        .cured(&[
            &["coface homology other.json --parts 2 --work empty"],
            &[
                "coface shard other.json --parts 2 -o parts --force",
                "coface homology other.json --parts 2 --work parts",
            ],
        ]),
    Case::new(FOLDER, "name an empty folder, or replace them by coface shard --force")
        .files(TWO)
        .before(&[SHARDED])
        .refused("coface shard other.json --parts 2 -o parts")
        .cured(&[
            &["coface shard other.json --parts 2 -o empty"],
            &["coface shard other.json --parts 2 -o parts --force"],
        ]),
    Case::new(FOLDER, "make one by coface shard INPUT -o FOLDER --parts N")
        .files(BOOK)
        .refused("coface merge .")
        .cured(&[&[
            "coface shard book.json -o parts --parts 2",
            "coface reduce parts",
            "coface merge parts",
        ]]),
    Case::new(FOLDER, "coface reduce {}{more}")
        .files(BOOK)
        .before(&[SHARDED])
        .refused("coface merge parts")
        .cured(&[&["coface reduce parts", "coface merge parts"]]),
    Case::new("shards/folder.rs", "shard the complex again into the folder, then coface reduce {}")
        .files(TWO)
        .before(&[SHARDED, "coface reduce parts", "coface shard other.json --parts 2 -o parts --force"])
        .refused("coface merge parts")
        .cured(&[&[
            "coface shard other.json --parts 2 -o parts",
            "coface reduce parts",
            "coface merge parts",
        ]]),
    Case::new(FOLDER, "coface reduce {}")
        .files(BOOK)
        .before(&[SHARDED, "coface reduce parts"])
        .damaged(&[("parts/part-000001.reduced", "no container")])
        .refused("coface merge parts")
        .cured(&[&["coface reduce parts/part-000001.shard", "coface merge parts"]]),
    Case::new("homology/parts.rs", "allow more, or cut it on a larger machine by coface shard")
        .before(&["coface generate torus-grid --shape 300,300 -o torus.json"])
        .refused("coface homology torus.json --memory 64M")
        .cured(&[
            &["coface homology torus.json --memory 1G"],
            &["coface shard torus.json --parts 4 -o parts", "coface reduce parts", "coface merge parts"],
        ]),
    Case::new("homology/parts.rs", "cut into more by --parts {}, or allow more")
        .refused("coface homology --grid 40,40,40 --memory 98M --parts 1")
        .cured(&[
            &["coface homology --grid 40,40,40 --memory 98M --parts 2"],
            &["coface homology --grid 40,40,40 --memory 1G --parts 1"],
        ]),
];
