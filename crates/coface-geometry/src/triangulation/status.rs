//! The edges that a sweep line crosses, from the lowest to the highest.

/// No edge.
pub(super) const NONE: u32 = u32::MAX;

/// A balanced tree of edges by their numbers, in an order that is given by where they are inserted; neighbors are
/// linked.
///
/// The balance is that of a treap: priorities are scrambled numbers, so the tree is the same on every machine.
#[derive(Debug)]
pub(super) struct Status {
    root: u32,
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    parent: u32,
    /// The subtrees of lower and of higher edges.
    children: [u32; 2],
    /// The next lower and the next higher edge.
    neighbors: [u32; 2],
}

const FREE: Node = Node { parent: NONE, children: [NONE; 2], neighbors: [NONE; 2] };

/// A number that looks random, the same for the same edge.
fn priority(edge: u32) -> u64 {
    let mixed = (u64::from(edge) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed ^ mixed >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93)
}

impl Status {
    /// No edge yet; numbers up to `edge_count` may come.
    pub(super) fn new(edge_count: usize) -> Self {
        Self { root: NONE, nodes: vec![FREE; edge_count] }
    }

    /// The next lower edge.
    pub(super) fn below(&self, edge: u32) -> u32 {
        self.nodes[edge as usize].neighbors[0]
    }

    /// The next higher edge; the lowest of all after `NONE`.
    pub(super) fn above(&self, edge: u32) -> u32 {
        if edge != NONE {
            return self.nodes[edge as usize].neighbors[1];
        }
        let mut lowest = self.root;
        while lowest != NONE && self.nodes[lowest as usize].children[0] != NONE {
            lowest = self.nodes[lowest as usize].children[0];
        }
        lowest
    }

    /// The highest edge that is below something, `NONE` if there is none. An edge of which that cannot be said is an
    /// error.
    pub(super) fn highest_below<E>(&self, is_below: impl Fn(u32) -> Result<bool, E>) -> Result<u32, E> {
        let (mut here, mut best) = (self.root, NONE);
        while here != NONE {
            let below = is_below(here)?;
            if below {
                best = here;
            }
            here = self.nodes[here as usize].children[usize::from(below)];
        }
        Ok(best)
    }

    /// Inserts an edge just above another one, or lowest of all after `NONE`.
    pub(super) fn insert_above(&mut self, edge: u32, lower: u32) {
        let upper = self.above(lower);
        self.nodes[edge as usize] = Node { neighbors: [lower, upper], ..FREE };
        if lower != NONE {
            self.nodes[lower as usize].neighbors[1] = edge;
        }
        if upper != NONE {
            self.nodes[upper as usize].neighbors[0] = edge;
        }
        // Of two neighbors one is in a subtree of the other, so one of these places is free.
        let (parent, side) = if lower != NONE && self.nodes[lower as usize].children[1] == NONE {
            (lower, 1)
        } else {
            (upper, 0)
        };
        if parent == NONE {
            self.root = edge;
            return;
        }
        self.nodes[parent as usize].children[side] = edge;
        self.nodes[edge as usize].parent = parent;
        while let parent = self.nodes[edge as usize].parent
            && parent != NONE
            && priority(parent) < priority(edge)
        {
            self.rotate_up(edge);
        }
    }

    /// Takes an edge out.
    pub(super) fn remove(&mut self, edge: u32) {
        loop {
            let [low, high] = self.nodes[edge as usize].children;
            match (low, high) {
                (NONE, child) | (child, NONE) => {
                    let parent = self.nodes[edge as usize].parent;
                    self.replace_child(parent, edge, child);
                    break;
                }
                _ => self.rotate_up(if priority(low) > priority(high) { low } else { high }),
            }
        }
        let [lower, upper] = self.nodes[edge as usize].neighbors;
        if lower != NONE {
            self.nodes[lower as usize].neighbors[1] = upper;
        }
        if upper != NONE {
            self.nodes[upper as usize].neighbors[0] = lower;
        }
        self.nodes[edge as usize] = FREE;
    }

    /// Puts a child in the place of its parent.
    fn rotate_up(&mut self, child: u32) {
        let parent = self.nodes[child as usize].parent;
        let side = usize::from(self.nodes[parent as usize].children[1] == child);
        let inner = self.nodes[child as usize].children[1 - side];
        let grandparent = self.nodes[parent as usize].parent;
        self.replace_child(grandparent, parent, child);
        self.nodes[parent as usize].children[side] = inner;
        if inner != NONE {
            self.nodes[inner as usize].parent = parent;
        }
        self.nodes[child as usize].children[1 - side] = parent;
        self.nodes[parent as usize].parent = child;
    }

    fn replace_child(&mut self, parent: u32, old: u32, new: u32) {
        if parent == NONE {
            self.root = new;
        } else {
            let children = &mut self.nodes[parent as usize].children;
            children[usize::from(children[1] == old)] = new;
        }
        if new != NONE {
            self.nodes[new as usize].parent = parent;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(status: &Status) -> Vec<u32> {
        std::iter::successors(Some(status.above(NONE)), |&edge| Some(status.above(edge)))
            .take_while(|&edge| edge != NONE)
            .collect()
    }

    #[test]
    fn the_order_is_that_of_a_list() {
        let count = 300;
        let mut status = Status::new(count);
        let mut list: Vec<u32> = Vec::new();
        for step in 0..3 * count {
            let number = (priority(step as u32) >> 20) as usize;
            let edge = number % count;
            if let Some(place) = list.iter().position(|&e| e as usize == edge) {
                list.remove(place);
                status.remove(edge as u32);
            } else {
                let place = number / count % (list.len() + 1);
                status.insert_above(edge as u32, place.checked_sub(1).map_or(NONE, |i| list[i]));
                list.insert(place, edge as u32);
            }
            assert_eq!(order(&status), list);
            for (i, &edge) in list.iter().enumerate() {
                assert_eq!(status.below(edge), i.checked_sub(1).map_or(NONE, |i| list[i]));
                let place = |e: u32| list.iter().position(|&other| other == e).unwrap();
                assert_eq!(status.highest_below(|e| Ok::<_, ()>(place(e) <= i)), Ok(edge));
            }
        }
    }
}
