//! Congruences as answers, and their classes as JSON.

use super::{BlockRule, ModelCongruence};
use crate::answer::{BlockMergeAnswer, CongruenceAnswer, CongruenceInput, Place, Remark, RemarkCode};
use crate::text;
use coface_algebra::{CellId, Error, VertexId};
use coface_arrange::congruence::{BlockMerge, BlockPolicy};
use std::io::Write;

/// How many merges within blocks are listed.
const LISTED_MERGES: usize = 100;

impl ModelCongruence {
    /// The congruence as an answer.
    ///
    /// `discarded` and `changed` are the numbers of cells of each degree that collapsed, and that lost facets without
    /// collapsing. Merges within blocks are counted (none without blocks), and unless the request allows them the first 100
    /// are listed.
    ///
    /// # Errors
    /// Those of [`Self::products_are_zero`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.answer()?.f_vector, [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> Result<CongruenceAnswer, Error> {
        let chains = self.chains();
        let merges = self.merges().filter(|_| self.request.within_blocks != BlockPolicy::Allow);
        let inputs = self.names.iter().enumerate().map(|(model, name)| CongruenceInput {
            file: name.clone(),
            f_vector: self.starts.iter().map(|starts| starts[model + 1] - starts[model]).collect(),
        });
        Ok(CongruenceAnswer {
            inputs: inputs.collect(),
            tolerance: self.request.tolerance,
            f_vector_before: self.f_vector_before(),
            f_vector: self.complex().f_vector().to_vec(),
            euler_characteristic: self.complex().euler_characteristic(),
            classes: chains.classes().iter().map(|classes| classes.class_count()).collect(),
            largest_class_diameter: self.vertices().largest_diameter(),
            discarded: chains.collapsed_counts(),
            changed: chains.changed().iter().map(Vec::len).collect(),
            products_zero: self.products_are_zero()?,
            merged_within_blocks: self.merges().map(<[_]>::len),
            block_merges: merges.map(|merges| {
                merges.iter().take(LISTED_MERGES).map(|merge| self.merge_answer(merge)).collect()
            }),
            remarks: self.remarks(),
        })
    }

    /// What the request wants to be warned of: classes with several vertices of one block.
    fn remarks(&self) -> Vec<Remark> {
        let merges = match (self.request.within_blocks, self.merges()) {
            (BlockPolicy::Warn, Some(merges)) => merges,
            _ => return Vec::new(),
        };
        let nearest = merges.iter().min_by(|a, b| a.distance.total_cmp(&b.distance));
        let Some(nearest) = nearest else { return Vec::new() };
        let block = if self.request.blocks == BlockRule::Models { "file" } else { "component" };
        let (name, _) = self.vertex_source(VertexId::from_u32(nearest.vertices[0]));
        let message = format!(
            "{} with several vertices of one {block}; the nearest, in {name}, are {} apart",
            text::count(merges.len(), "class"),
            nearest.distance
        );
        vec![Remark::new(RemarkCode::MergedWithinBlock, message).at(merges.len(), [Place::file(name)])]
    }

    fn merge_answer(&self, merge: &BlockMerge) -> BlockMergeAnswer {
        BlockMergeAnswer {
            class: merge.class,
            block: merge.block,
            file: merge
                .vertices
                .first()
                .map(|&vertex| self.vertex_source(VertexId::from_u32(vertex)).0.to_owned()),
            vertices: merge
                .vertices
                .iter()
                .map(|&vertex| self.vertex_source(VertexId::from_u32(vertex)).1)
                .collect(),
            distance: merge.distance,
        }
    }

    /// Writes the classes of all degrees as JSON: for each degree the members of each class, rising, and their signs against the
    /// first of them. Members are numbered one model after the other.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Io`] from the output.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let twice = io::read(&b"v 0 0 0\nv 1 0 0\nv 1 0 0\nv 0 0 0\nl 1 2\nl 3 4\n"[..], Format::Obj)?;
    /// let merged = ModelCongruence::of(vec![("twice".to_owned(), twice)], &CongruenceRequest::within(0.0))?;
    /// let mut text = Vec::new();
    /// merged.write_classes(&mut text)?;
    /// let expected = "{\"classes\":[\n\
    ///     {\"degree\":0,\"members\":[[0,3],[1,2]],\"signs\":[[1,1],[1,1]]},\n\
    ///     {\"degree\":1,\"members\":[[0,1]],\"signs\":[[1,-1]]}\n]}\n";
    /// assert_eq!(String::from_utf8_lossy(&text), expected);
    /// # Ok(()) }
    /// ```
    pub fn write_classes(&self, mut out: impl Write) -> Result<(), Error> {
        write!(out, "{{\"classes\":[")?;
        for (degree, classes) in self.chains().classes().iter().enumerate() {
            write!(out, "{}\n{{\"degree\":{degree},\"members\":[", separator(degree))?;
            for (class, members) in classes.members().iter().enumerate() {
                write!(out, "{}[", separator(class))?;
                for (i, member) in members.iter().enumerate() {
                    write!(out, "{}{member}", separator(i))?;
                }
                write!(out, "]")?;
            }
            write!(out, "],\"signs\":[")?;
            for (class, members) in classes.members().iter().enumerate() {
                write!(out, "{}[", separator(class))?;
                for (i, &member) in members.iter().enumerate() {
                    let mut image = classes.image(CellId::from_u32(member));
                    let sign = image.find(|&(other, _)| other == class).map_or(1, |(_, sign)| sign.to_i32());
                    write!(out, "{}{sign}", separator(i))?;
                }
                write!(out, "]")?;
            }
            write!(out, "]}}")?;
        }
        writeln!(out, "\n]}}")?;
        Ok(())
    }
}

fn separator(position: usize) -> &'static str {
    if position == 0 { "" } else { "," }
}
