//! The boundary of a surface, and the edges where it branches.

use super::{Layer, Scene};
use coface_algebra::RaggedArray;

/// Of so many boundary loops each has a layer of its own; more are one layer.
const MOST_LAYERS: usize = 24;

impl Scene {
    /// The same with the boundary loops of a surface as layers, and the edges in three or more polygons as a witness. Scenes with
    /// cells of higher dimension or without polygons stay as they are.
    ///
    /// $O(n \log n)$ for n sides of polygons.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.with_boundary().layers()[0].group, "boundary");
    /// # Ok(()) }
    /// ```
    pub fn with_boundary(mut self) -> Self {
        let is_surface =
            self.parts.cells.is_empty() && self.parts.simplices.iter().all(|simplex| simplex.len() < 4);
        let has_polygons = !self.parts.polygons.is_empty() || !self.hidden.polygons.is_empty();
        if !is_surface || !has_polygons || self.hidden.has_cells {
            return self;
        }
        let (loose, branched) = self.sides_by_use();
        let loops = chained(&loose);
        if loops.len() <= MOST_LAYERS {
            for (number, walk) in loops.iter().enumerate() {
                let word = if walk.first() == walk.last() { "loop" } else { "path" };
                let mut layer = Layer::new("boundary", format!("boundary {word} {number}"));
                layer.detail = edges(walk.len() - 1);
                layer.lines.push(walk);
                // In the plane everybody sees where the faces end.
                layer.is_on = self.dimension == 3;
                self.add_layer(layer);
            }
        } else {
            let mut layer = Layer::new("boundary", format!("{} boundary loops", loops.len()));
            layer.detail = edges(loose.len());
            layer.lines = RaggedArray::from_lists(loops);
            layer.is_on = true;
            self.add_layer(layer);
        }
        let mut layer = Layer::new("witness", "edges in three or more faces");
        layer.detail = edges(branched.len());
        layer.lines = RaggedArray::from_lists(branched);
        layer.is_on = true;
        self.add_layer(layer);
        self
    }

    /// The sides of exactly one polygon, as it runs through them, and those of three or more.
    fn sides_by_use(&self) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
        let mut sides: Vec<([u32; 2], bool)> = Vec::with_capacity(self.parts.polygons.item_count());
        let hidden = self.hidden.polygons.iter();
        for walk in self.parts.polygons.iter().chain(self.parts.rims.iter()).chain(hidden) {
            sides.extend((0..walk.len()).map(|i| {
                let [a, b] = [walk[i], walk[(i + 1) % walk.len()]];
                ([a.min(b), a.max(b)], a > b)
            }));
        }
        sides.sort_unstable();
        let (mut loose, mut branched) = (Vec::new(), Vec::new());
        for uses in sides.chunk_by(|a, b| a.0 == b.0) {
            let ([a, b], is_reversed) = uses[0];
            match uses.len() {
                1 => loose.push(if is_reversed { [b, a] } else { [a, b] }),
                2 => {}
                _ => branched.push([a, b]),
            }
        }
        (loose, branched)
    }
}

fn edges(count: usize) -> String {
    if count == 1 { "1 edge".to_owned() } else { format!("{count} edges") }
}

/// Edges as walks that are closed, or end where not two edges meet; edges may be walked in either direction.
pub(super) fn chained(edges: &[[u32; 2]]) -> Vec<Vec<u32>> {
    // The ends of edges, by vertices: (vertex, edge).
    let mut ends: Vec<(u32, u32)> =
        edges.iter().zip(0..).flat_map(|(&[a, b], edge)| [(a, edge), (b, edge)]).collect();
    ends.sort_unstable();
    let mut is_used = vec![false; edges.len()];
    // Where to go on looking from each first place of a vertex.
    let mut next: Vec<usize> = (0..ends.len()).collect();
    let mut walks = Vec::new();
    // Walks begin and end where edges branch, or are closed.
    let is_branch = |vertex: u32| {
        let first = ends.partition_point(|end| end.0 < vertex);
        ends[first..].iter().take_while(|end| end.0 == vertex).count() != 2
    };
    let at_branches = edges.iter().enumerate().filter_map(|(start, &[a, b])| {
        if is_branch(a) { Some((start, [a, b])) } else { is_branch(b).then_some((start, [b, a])) }
    });
    let starts: Vec<(usize, [u32; 2])> = at_branches.chain(edges.iter().copied().enumerate()).collect();
    for (start, [source, target]) in starts {
        if std::mem::replace(&mut is_used[start], true) {
            continue;
        }
        let mut walk = vec![source, target];
        let mut at = target;
        while at != source && !is_branch(at) {
            let first = ends.partition_point(|&(vertex, _)| vertex < at);
            let from = next[first];
            let Some(place) =
                (from..ends.len()).take_while(|&i| ends[i].0 == at).find(|&i| !is_used[ends[i].1 as usize])
            else {
                break;
            };
            next[first] = place + 1;
            let edge = ends[place].1 as usize;
            is_used[edge] = true;
            let [a, b] = edges[edge];
            at = if a == at { b } else { a };
            walk.push(at);
        }
        walks.push(walk);
    }
    walks
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io as io;
    use coface_io::{Format, Model, Structure};

    #[test]
    fn a_ring_of_squares_has_two_loops() {
        let text = b"v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n\
            f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
        let scene = Scene::of("ring", &io::read(&text[..], Format::Obj).unwrap()).unwrap().with_boundary();
        let found: Vec<_> =
            scene.layers().iter().map(|layer| (&layer.name[..], layer.lines.items().len())).collect();
        assert_eq!(found, [("boundary loop 0", 5), ("boundary loop 1", 5)]);
    }

    #[test]
    fn three_pages_have_a_spine() {
        let text = b"v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";
        let scene = Scene::of("book", &io::read(&text[..], Format::Obj).unwrap()).unwrap().with_boundary();
        let paths: Vec<&str> = scene.layers().iter().map(|layer| &layer.name[..]).collect();
        assert_eq!(paths[..3], ["boundary path 0", "boundary path 1", "boundary path 2"]);
        let solids = Model::from_structure(Structure::Facets(RaggedArray::from_lists([
            [0, 1, 2, 3],
            [0, 1, 2, 4],
            [0, 1, 3, 4],
        ])));
        assert!(Scene::of("solids", &solids).unwrap().with_boundary().layers().is_empty());
        let witness = scene.layers().iter().find(|layer| layer.group == "witness").unwrap();
        assert_eq!(witness.lines.items(), [0, 1]);
    }
}
