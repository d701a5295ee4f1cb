//! The numbers that vertices have in a file, when those of a structure made from it differ.

use coface_algebra::RaggedArray;
use coface_io::FileGraph;

/// The number in the file of each vertex `0..count`; facet lists may leave numbers out. Vertices of graphs may have names too.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Labels {
    /// Rising; `None` when every vertex is its own label.
    numbers: Option<Vec<u32>>,
    /// By the numbers in the file.
    names: Option<Vec<String>>,
}

impl Labels {
    /// Renumbers the vertices of the lists to `0..count` in their order; gives the count along.
    pub(crate) fn compact(lists: &mut RaggedArray) -> (Self, usize) {
        let mut numbers = lists.items().to_vec();
        numbers.sort_unstable();
        numbers.dedup();
        let count = numbers.len();
        if numbers.last().is_none_or(|&last| last as usize + 1 == count) {
            return (Self::default(), count);
        }
        for vertex in lists.items_mut() {
            *vertex = numbers.binary_search(vertex).expect("every vertex of the lists was gathered") as u32;
        }
        (Self { numbers: Some(numbers), names: None }, count)
    }

    /// Those of the vertices of a graph, by rising numbers.
    pub(crate) fn of_graph(graph: &FileGraph) -> Self {
        Self { numbers: Some(graph.numbers()), names: graph.names().map(<[String]>::to_vec) }
    }

    /// The names of the vertices by their numbers, if they have names.
    pub(crate) fn names(&self) -> Option<&[String]> {
        self.names.as_deref()
    }

    /// The number in the file of this vertex.
    pub(crate) fn of(&self, vertex: u32) -> u32 {
        self.numbers.as_ref().map_or(vertex, |numbers| numbers[vertex as usize])
    }

    /// The numbers in the file of these vertices.
    pub(crate) fn of_all(&self, mut vertices: Vec<u32>) -> Vec<u32> {
        if self.numbers.is_some() {
            for vertex in &mut vertices {
                *vertex = self.of(*vertex);
            }
        }
        vertices
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_closed_and_remembered() {
        let mut lists = RaggedArray::from_lists([[7, 3, 9], [9, 3, 1_000_000]]);
        let (labels, count) = Labels::compact(&mut lists);
        assert_eq!((count, lists.items()), (4, &[1, 0, 2, 2, 0, 3][..]));
        assert_eq!(labels.of_all(vec![3, 0]), [1_000_000, 3]);
        let mut dense = RaggedArray::from_lists([[1, 0], [2, 0]]);
        assert_eq!(Labels::compact(&mut dense), (Labels::default(), 3));
        assert_eq!(Labels::compact(&mut RaggedArray::new()), (Labels::default(), 0));
    }
}
