//! The numbers that a model gives its vertices, where they are not 0, 1, 2, ...

use super::Layer;
use coface_algebra::RaggedArray;

/// Which vertex of the model each vertex of the scene is. Facet lists may number vertices as they like, with gaps; a scene has only those
/// that lie in a cell, in the same order.
#[derive(Clone, Debug, Default)]
pub(super) struct Numbering {
    /// Rising; empty where both have the same numbers.
    pub(super) numbers: Vec<u32>,
}

impl Numbering {
    /// The numbering of the vertices of these lists, which are renumbered by it.
    pub(super) fn compact<const N: usize>(lists: [&mut RaggedArray; N]) -> Self {
        let mut numbers: Vec<u32> = lists.iter().flat_map(|lists| lists.items()).copied().collect();
        numbers.sort_unstable();
        numbers.dedup();
        if numbers.last().is_none_or(|&last| last as usize + 1 == numbers.len()) {
            return Self::default();
        }
        let numbering = Self { numbers };
        for lists in lists {
            *lists = RaggedArray::from_lists(lists.iter().map(|list| numbering.of_list(list)));
        }
        numbering
    }

    /// The vertex of the scene with this number in the model; none has the number `u32::MAX`.
    pub(super) fn of(&self, vertex: u32) -> u32 {
        if self.numbers.is_empty() {
            return vertex;
        }
        self.numbers.binary_search(&vertex).map_or(u32::MAX, |position| position as u32)
    }

    /// The number in the model of a vertex of the scene.
    pub(super) fn of_model(&self, vertex: u32) -> u32 {
        self.numbers.get(vertex as usize).copied().unwrap_or(vertex)
    }

    fn of_list(&self, list: &[u32]) -> Vec<u32> {
        list.iter().map(|&vertex| self.of(vertex)).collect()
    }

    /// A layer whose vertices have the numbers of the model.
    pub(super) fn of_layer(&self, mut layer: Layer) -> Layer {
        if self.numbers.is_empty() || layer.positions.is_some() {
            return layer;
        }
        layer.lines = RaggedArray::from_lists(layer.lines.iter().map(|walk| self.of_list(walk)));
        layer.points = self.of_list(&layer.points);
        layer.rings = self.of_list(&layer.rings);
        layer.triangles.as_flattened_mut().iter_mut().for_each(|vertex| *vertex = self.of(*vertex));
        layer.labels.iter_mut().for_each(|label| label.0 = self.of(label.0));
        layer
    }
}

#[cfg(test)]
mod tests {
    use crate::{Layer, Scene};
    use coface_io::{Format, read};

    #[test]
    fn vertices_with_gaps_between_their_numbers_are_few() {
        let model = read(&b"[[7, 4294967295, 0], [4294967295, 12]]"[..], Format::Json).unwrap();
        let mut scene = Scene::of("gaps", &model).unwrap();
        assert_eq!((scene.positions().len(), scene.triangles()), (4, &[[0, 1, 3]][..]));
        assert_eq!(scene.edges(), [[0, 1], [0, 3], [1, 3], [2, 3]]);
        let mut layer = Layer::new("a", "b");
        layer.lines.push(&[0, u32::MAX, 12]);
        scene.push_layer(layer);
        assert_eq!(scene.layers()[0].lines.list(0), [0, 3, 2]);
        // A layer of another model.
        let mut layer = Layer::new("a", "b");
        layer.lines.push(&[0, 1]);
        scene.push_layer(layer);
        assert_eq!(scene.layers().len(), 1);
        let text = serde_json::to_value(scene.document()).unwrap();
        assert!(text["vertexNumbers"].is_string());
    }

    #[test]
    fn answers_name_vertices_by_the_numbers_of_the_model() {
        let model = read(&b"[[5, 6], [6, 9], [5, 9]]"[..], Format::Json).unwrap();
        let mut scene = Scene::of("triangle", &model).unwrap();
        scene.add_result("star", &serde_json::json!({"simplices": [[9], [5, 9], [6, 9]]})).unwrap();
        assert_eq!((&scene.layers()[0].points[..], scene.layers()[0].lines.len()), (&[2][..], 2));
        for (simplices, fault) in
            [("[[7]]", "has vertex 7"), ("[[9], [2]]", "has another one"), ("[[10]]", "has vertex 10")]
        {
            let answer: serde_json::Value =
                serde_json::from_str(&format!("{{\"simplices\": {simplices}}}")).unwrap();
            let error = scene.add_result("star", &answer).unwrap_err();
            assert!(error.message().contains(fault), "{error}");
        }
    }

    #[test]
    fn large_simplices_are_drawn_by_their_edges() {
        let facet = |n: u32| read(format!("[{:?}]", Vec::from_iter(0..n)).as_bytes(), Format::Json).unwrap();
        let scene = Scene::of("16", &facet(16)).unwrap();
        assert_eq!((scene.triangles().len(), scene.edges().len(), scene.remarks().len()), (560, 120, 1));
        let scene = Scene::of("61", &facet(61)).unwrap();
        assert_eq!((scene.triangles().len(), scene.edges().len()), (0, 1830));
        assert!(scene.remarks()[1].message.contains("the triangles of 1 simplex"));
        let error = Scene::of("5000", &facet(5000)).unwrap_err();
        assert!(error.message().contains("12497500 edges"), "{error}");
    }
}
