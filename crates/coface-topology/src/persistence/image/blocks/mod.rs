//! Images by blocks: persistence of an image that no machine holds whole.
//!
//! # Words and conventions
//! * [`ImageBlocks`] cuts an image into **blocks**, boxes of voxels. A block is read with one layer of voxels around it, its **window**. Lower stars
//!   partition the cells of the image, and a voxel of a block sees its whole star in the window. So a block matches its cells as the whole image does:
//!   voxels of one value enter in the order of their numbers in the whole image.
//! * What is left of a block is an [`ImagePart`]: its critical cells, each with what its boundary flows down to. A path of the gradient that leaves the block
//!   is cut there: its **open end** is a cell of another block.
//! * A **rule** of a part says what a cell at its rim flows to, for the paths of other blocks that enter there. Those blocks **ask** for it.
//! * Parts are merged: open ends in the union are replaced by their rules, and rules that no block outside of the union asks for are dropped.
//! * In a block, and in what was merged, critical cells that are a **pair** whatever lies outside are taken out, and the pair is listed. What is left is near the
//!   rim, or lives longer than to the next block. The part of all blocks has no open ends: what is left there never dies. The diagram is that of an image in memory,
//!   bit for bit.
//! * A cell has a **name**, the number of the voxel that owns it and its code there, and a **key**, the value of that voxel as a whole number that rises in the
//!   order of entrance. Cells are compared by key, then by name.
//! * Vertices and top cells flow to one cell each; facets of top cells have the two ends of the paths that go up from them, the others what their boundary
//!   flows down to.

mod cancelling;
mod cut;
mod local;
mod merging;
mod part;
mod root;

#[cfg(test)]
mod tests;

pub use cut::ImageBlocks;
pub use part::ImagePart;
