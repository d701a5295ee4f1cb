//! Forests whose roots are chosen by who unites them.

/// For each member its parent; a root is its own.
pub(super) struct Forest {
    parents: Vec<u32>,
}

impl Forest {
    pub(super) fn new(parents: Vec<u32>) -> Self {
        Self { parents }
    }

    /// The root of the tree of a member; paths are halved on the way.
    pub(super) fn root(&mut self, member: u32) -> u32 {
        let mut at = member;
        loop {
            let parent = self.parents[at as usize];
            if parent == at {
                return at;
            }
            let next = self.parents[parent as usize];
            self.parents[at as usize] = next;
            at = next;
        }
    }

    /// Hangs a root under another one.
    pub(super) fn hang(&mut self, root: u32, under: u32) {
        self.parents[root as usize] = under;
    }
}
