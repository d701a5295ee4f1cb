//! The tags of nodes.

use coface_algebra::Error;

/// The tags of the nodes, and the vertex of each tag.
#[derive(Debug, Default)]
pub(super) struct Nodes {
    /// The tag of each vertex.
    tags: Vec<u64>,
    index: Index,
}

/// How a vertex is found by its tag.
#[derive(Debug, Default)]
enum Index {
    #[default]
    Empty,
    /// The tags run on from this one.
    Consecutive(u64),
    /// One more than the vertex, from the lowest tag on; 0 where there is none.
    Table(u64, Vec<u32>),
    /// Tags and vertices, sorted.
    Sorted(Vec<(u64, u32)>),
}

impl Nodes {
    /// Enters the tag of the next vertex.
    pub(super) fn add(&mut self, tag: i64) -> Result<(), Error> {
        match u64::try_from(tag) {
            // Programs number from 0 too.
            Ok(tag) => self.tags.push(tag),
            _ => {
                return Err(
                    Error::invalid(format!("a node has the tag {tag}")).with_cure("number nodes from 1")
                );
            }
        }
        Ok(())
    }

    /// The tag of a vertex.
    pub(super) fn tag(&self, vertex: u32) -> u64 {
        self.tags.get(vertex as usize).copied().unwrap_or(0)
    }

    /// The vertex of a tag.
    pub(super) fn vertex(&self, tag: i64) -> Option<u32> {
        let tag = u64::try_from(tag).ok()?;
        match &self.index {
            Index::Empty => None,
            Index::Consecutive(first) => {
                let vertex = tag.checked_sub(*first)?;
                (vertex < self.tags.len() as u64).then_some(vertex as u32)
            }
            Index::Table(first, table) => {
                let at = usize::try_from(tag.checked_sub(*first)?).ok()?;
                table.get(at)?.checked_sub(1)
            }
            Index::Sorted(pairs) => {
                let at = pairs.binary_search_by_key(&tag, |&(tag, _)| tag).ok()?;
                Some(pairs[at].1)
            }
        }
    }

    /// Makes the index once all nodes are there.
    pub(super) fn finish(&mut self) -> Result<(), Error> {
        let (Some(&first), Some(&low), Some(&high)) =
            (self.tags.first(), self.tags.iter().min(), self.tags.iter().max())
        else {
            return Ok(());
        };
        let twice = |tag: u64| {
            Error::invalid(format!("node {tag} stands twice")).with_cure("give each node a tag of its own")
        };
        if self.tags.iter().enumerate().all(|(i, &tag)| tag == first + i as u64) {
            self.index = Index::Consecutive(first);
        } else if high - low < 4 * self.tags.len() as u64 + 1024 {
            let mut table = vec![0; (high - low) as usize + 1];
            for (vertex, &tag) in (1..).zip(&self.tags) {
                let place = &mut table[(tag - low) as usize];
                if *place != 0 {
                    return Err(twice(tag));
                }
                *place = vertex;
            }
            self.index = Index::Table(low, table);
        } else {
            let mut pairs: Vec<(u64, u32)> = self.tags.iter().copied().zip(0..).collect();
            pairs.sort_unstable();
            if let Some(pair) = pairs.windows(2).find(|pair| pair[0].0 == pair[1].0) {
                return Err(twice(pair[0].0));
            }
            self.index = Index::Sorted(pairs);
        }
        Ok(())
    }
}
