//! The link of one simplex, cut out of a simplex tree.

use super::tree::{Children, ROOT, Tree};

/// Nodes of the ring of the last vertex of a simplex s, each with what its simplex has before that vertex and outside
/// of s.
struct Before {
    vertices: Vec<u32>,
    /// (where the vertices start, where they end, the node), lexicographic by vertices, the empty set first.
    entries: Vec<(u32, u32, u32)>,
}

impl Before {
    fn vertices(&self, entry: usize) -> &[u32] {
        let (start, end, _) = self.entries[entry];
        &self.vertices[start as usize..end as usize]
    }
}

impl Tree {
    /// The tree of the simplices t disjoint from s such that t and s together are a simplex; s must be in this tree.
    ///
    /// A simplex that contains s is a part before the last vertex of s, that vertex, and a part after it. Below the
    /// node of one first part and that vertex hang all its last parts, and they hang in the link below the first part
    /// without s. So subtrees are copied whole and the link needs no sorting and no search for faces.
    ///
    /// # Complexity
    /// Linear in the length of the ring and in $m \log v$, for m simplices and v vertices in the link.
    pub(super) fn link(&self, simplex: &[u32]) -> Self {
        let mut link = Self::default();
        let Some(ring) = simplex.last().and_then(|&last| self.find_child(ROOT, last)) else { return link };
        let mut before = Before { vertices: Vec::new(), entries: Vec::new() };
        let mut path = Vec::new();
        for node in self.ring(ring).filter(|&node| self.contains_path(node, simplex)) {
            self.path_to(node, &mut path);
            let start = before.vertices.len() as u32;
            before.vertices.extend(path.iter().filter(|&vertex| simplex.binary_search(vertex).is_err()));
            before.entries.push((start, before.vertices.len() as u32, node));
        }
        let Before { vertices, entries } = &mut before;
        let part = |&(start, end, _): &(u32, u32, u32)| &vertices[start as usize..end as usize];
        if !entries.is_sorted_by(|a, b| part(a) < part(b)) {
            entries.sort_unstable_by(|a, b| part(a).cmp(part(b)));
        }
        if !before.entries.is_empty() {
            let names = self.link_vertices(&before);
            self.link_below(&mut link, ROOT, &before, 0..before.entries.len(), &names, 0);
        }
        link
    }

    /// The vertices of the link, rising.
    fn link_vertices(&self, before: &Before) -> Vec<u32> {
        let mut names: Vec<u32> = (0..before.entries.len())
            .filter_map(|entry| match before.vertices(entry) {
                &[vertex] => Some(vertex),
                _ => None,
            })
            .collect();
        names.extend(self.cursor(before.entries[0].2).map(|(vertex, _)| vertex));
        names
    }

    /// Grows the link below `parent`, whose simplex is the first of `entries` and begins all of them.
    fn link_below(
        &self,
        link: &mut Self,
        parent: u32,
        before: &Before,
        entries: std::ops::Range<usize>,
        names: &[u32],
        depth: usize,
    ) {
        let first = link.nodes.len() as u32;
        let longer: Vec<usize> = (entries.start + 1..entries.end)
            .filter(|&entry| before.vertices(entry).len() == depth + 1)
            .collect();
        let source = before.entries[entries.start].2;
        let vertices = longer.iter().map(|&entry| before.vertices(entry)[depth]);
        let count = longer.len() + self.children(source).count();
        if count == 0 {
            return;
        }
        link.push_siblings(vertices.chain(self.cursor(source).map(|(vertex, _)| vertex)), parent, names);
        link.set_children(parent, Children::run(first, count));
        link.count_more(depth, count);
        for (i, &entry) in longer.iter().enumerate() {
            let end = longer.get(i + 1).copied().unwrap_or(entries.end);
            self.link_below(link, first + i as u32, before, entry..end, names, depth + 1);
        }
        for (copy, (_, child)) in (first + longer.len() as u32..).zip(self.cursor(source)) {
            self.copy_below(link, copy, child, names, depth + 1);
        }
    }

    /// Copies what is below `source` to below `parent`.
    fn copy_below(&self, link: &mut Self, parent: u32, source: u32, names: &[u32], depth: usize) {
        let count = self.children(source).count();
        if count == 0 {
            return;
        }
        let first = link.nodes.len() as u32;
        link.push_siblings(self.cursor(source).map(|(vertex, _)| vertex), parent, names);
        link.set_children(parent, Children::run(first, count));
        link.count_more(depth, count);
        for (copy, (_, child)) in (first..).zip(self.cursor(source)) {
            self.copy_below(link, copy, child, names, depth + 1);
        }
    }

    /// Appends nodes that end in these rising vertices; `names` are the vertices of the nodes of depth 0, in order.
    fn push_siblings(&mut self, vertices: impl Iterator<Item = u32>, parent: u32, names: &[u32]) {
        let mut ring = 0;
        for vertex in vertices {
            if parent == ROOT {
                self.push_node(vertex, ROOT, ROOT);
                continue;
            }
            ring += names[ring..].partition_point(|&name| name < vertex);
            self.push_node(vertex, parent, ring as u32);
        }
    }
}
