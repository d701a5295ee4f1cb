//! An order of elimination that keeps the Cholesky factor sparse.

/// The rows of a symmetric matrix in an order of small fill: each next row has about the least degree among those left.
///
/// `neighbors` lists for each row the other rows that share an entry with it, in any order, both ways.
///
/// The graph of what is left is kept as the cliques ("elements") that elimination makes, not as their edges. Degrees
/// are bounds from above; rows with the same neighbors are eliminated together. The order depends on nothing but the
/// input.
///
/// # References
/// P. R. Amestoy, T. A. Davis, I. S. Duff, *An approximate minimum degree ordering algorithm* (1996).
pub(super) fn minimum_degree_order(neighbors: Vec<Vec<u32>>) -> Vec<u32> {
    let count = neighbors.len();
    let mut graph = QuotientGraph::new(neighbors);
    let mut order = Vec::with_capacity(count);
    while order.len() < count {
        let pivot = graph.next_pivot();
        graph.eliminate(pivot, &mut order);
    }
    order
}

/// What is left of the graph: rows, grouped where they have the same neighbors, and the cliques among them.
struct QuotientGraph {
    /// For each row that stands for a group the rows of the group, empty for all others.
    groups: Vec<Vec<u32>>,
    /// The rows next to a row that share no clique with it.
    rows: Vec<Vec<u32>>,
    /// The cliques that a row is in.
    cliques: Vec<Vec<u32>>,
    /// The rows of the clique that the elimination of a row made; empty once another clique contains them.
    members: Vec<Vec<u32>>,
    /// The number of rows in a clique, groups counted in full.
    clique_size: Vec<usize>,
    degree: Vec<usize>,
    /// Rows by degree; an entry is out of date if the row has another degree by now.
    buckets: Vec<Vec<u32>>,
    least: usize,
    left: usize,
    /// Marks rows of the clique that is being made.
    mark: Vec<u32>,
    /// For a clique the step of elimination that counted it last, and the number of its rows outside the new one.
    outside: Vec<(u32, usize)>,
    step: u32,
}

impl QuotientGraph {
    fn new(rows: Vec<Vec<u32>>) -> Self {
        let count = rows.len();
        let degree: Vec<usize> = rows.iter().map(Vec::len).collect();
        let mut buckets = vec![Vec::new(); count];
        for row in (0..count).rev() {
            buckets[degree[row]].push(row as u32);
        }
        Self {
            groups: (0..count as u32).map(|row| vec![row]).collect(),
            rows,
            cliques: vec![Vec::new(); count],
            members: vec![Vec::new(); count],
            clique_size: vec![0; count],
            degree,
            buckets,
            least: 0,
            left: count,
            mark: vec![0; count],
            outside: vec![(0, 0); count],
            step: 0,
        }
    }

    fn next_pivot(&mut self) -> usize {
        loop {
            match self.buckets[self.least].pop() {
                None => self.least += 1,
                Some(row) => {
                    let row = row as usize;
                    if !self.groups[row].is_empty() && self.degree[row] == self.least {
                        return row;
                    }
                }
            }
        }
    }

    fn weight(&self, row: u32) -> usize {
        self.groups[row as usize].len()
    }

    /// Eliminates a group and all that have no other neighbors than its clique.
    fn eliminate(&mut self, pivot: usize, order: &mut Vec<u32>) {
        self.step += 1;
        let step = self.step;
        order.append(&mut self.groups[pivot]);
        self.mark[pivot] = step;
        let mut clique = Vec::new();
        let mut size = 0;
        let mut sources = vec![std::mem::take(&mut self.rows[pivot])];
        for old in std::mem::take(&mut self.cliques[pivot]) {
            sources.push(std::mem::take(&mut self.members[old as usize]));
        }
        for row in sources.into_iter().flatten() {
            if !self.groups[row as usize].is_empty() && self.mark[row as usize] != step {
                self.mark[row as usize] = step;
                size += self.weight(row);
                clique.push(row);
            }
        }
        for &row in &clique {
            let weight = self.weight(row);
            for &other in &self.cliques[row as usize] {
                let other = other as usize;
                if self.outside[other].0 != step {
                    self.outside[other] = (step, self.clique_size[other]);
                }
                self.outside[other].1 = self.outside[other].1.saturating_sub(weight);
            }
        }
        self.left = self.groups.len() - order.len();
        let mut keys = Vec::with_capacity(clique.len());
        for &row in &clique {
            let at = row as usize;
            let weight = self.weight(row);
            let mut degree = size - weight;
            let mut cliques = std::mem::take(&mut self.cliques[at]);
            cliques.retain(|&other| {
                let rest = self.outside[other as usize].1;
                if rest == 0 {
                    // The new clique contains it.
                    self.members[other as usize].clear();
                }
                let is_alive = !self.members[other as usize].is_empty();
                degree += if is_alive { rest } else { 0 };
                is_alive
            });
            let mut rows = std::mem::take(&mut self.rows[at]);
            rows.retain(|&other| {
                let is_outside = self.mark[other as usize] != step && !self.groups[other as usize].is_empty();
                degree += if is_outside { self.weight(other) } else { 0 };
                is_outside
            });
            if cliques.is_empty() && rows.is_empty() {
                size -= weight;
                order.append(&mut self.groups[at]);
                continue;
            }
            let before = self.degree[at] + size - weight;
            self.degree[at] = degree.min(before).min(self.left - weight);
            cliques.push(pivot as u32);
            cliques.sort_unstable();
            rows.sort_unstable();
            let key = cliques.iter().chain(&rows).fold(0u64, |sum, &x| sum.wrapping_add(u64::from(x)));
            (self.cliques[at], self.rows[at]) = (cliques, rows);
            keys.push((key, row));
        }
        keys.sort_unstable();
        for same in keys.chunk_by(|a, b| a.0 == b.0) {
            self.join_equal(same);
        }
        clique.retain(|&row| !self.groups[row as usize].is_empty());
        for &row in &clique {
            let degree = self.degree[row as usize];
            self.buckets[degree].push(row);
            self.least = self.least.min(degree);
        }
        self.clique_size[pivot] = size;
        self.members[pivot] = clique;
    }

    /// Joins the groups among these that have the same neighbors.
    fn join_equal(&mut self, same: &[(u64, u32)]) {
        for (i, &(_, first)) in same.iter().enumerate() {
            let first = first as usize;
            for &(_, other) in &same[i + 1..] {
                let other = other as usize;
                if self.groups[first].is_empty() || self.groups[other].is_empty() {
                    continue;
                }
                if self.cliques[first] == self.cliques[other] && self.rows[first] == self.rows[other] {
                    let mut group = std::mem::take(&mut self.groups[other]);
                    self.degree[first] = self.degree[first].saturating_sub(group.len());
                    self.groups[first].append(&mut group);
                    self.cliques[other] = Vec::new();
                    self.rows[other] = Vec::new();
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(count: usize, edges: impl IntoIterator<Item = (u32, u32)>) -> Vec<Vec<u32>> {
        let mut neighbors = vec![Vec::new(); count];
        for (a, b) in edges {
            neighbors[a as usize].push(b);
            neighbors[b as usize].push(a);
        }
        neighbors
    }

    #[test]
    fn an_order_has_each_row_once() {
        let size = 17u32;
        let at = |x: u32, y: u32| x * size + y;
        let edges = (0..size).flat_map(|x| {
            (0..size).flat_map(move |y| {
                let right = (x + 1 < size).then(|| (at(x, y), at(x + 1, y)));
                let up = (y + 1 < size).then(|| (at(x, y), at(x, y + 1)));
                right.into_iter().chain(up)
            })
        });
        let mut order = minimum_degree_order(graph(289, edges));
        order.sort_unstable();
        assert!(order.into_iter().eq(0..289));
    }

    #[test]
    fn the_hub_of_a_star_waits_for_its_rays() {
        let order = minimum_degree_order(graph(6, (1..6).map(|ray| (0, ray))));
        assert!(order.iter().position(|&row| row == 0).unwrap() >= 4, "{order:?}");
    }
}
