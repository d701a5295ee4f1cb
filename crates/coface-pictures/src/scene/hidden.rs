//! What a scene leaves out: vertices with a coordinate that is not finite, and the cells at them.

use super::Layer;
use coface_algebra::{Error, RaggedArray, VertexId};
use coface_answers::answer::{Place, Remark, RemarkCode};
use coface_geometry::{PartialPositions, Positions};
use coface_io::Model;

/// Vertices that have no place, and the cells that have such a vertex. The numbers of the vertices are those of the model.
#[derive(Clone, Debug, Default)]
pub(super) struct Hidden {
    /// Whether each vertex is hidden; empty where none is.
    is_hidden: Vec<bool>,
    /// The polygons that are left out.
    pub(super) polygons: RaggedArray,
    /// Whether 3-cells are left out.
    pub(super) has_cells: bool,
    cell_count: usize,
}

impl Hidden {
    pub(super) fn has(&self, vertex: u32) -> bool {
        self.is_hidden.get(vertex as usize).copied().unwrap_or(false)
    }

    fn has_none_of(&self, vertices: &[u32]) -> bool {
        !vertices.iter().any(|&vertex| self.has(vertex))
    }

    /// The parts of a walk between hidden vertices that have a segment.
    fn seen_parts<'w>(&self, walk: &'w [u32]) -> impl Iterator<Item = &'w [u32]> {
        walk.split(|&vertex| self.has(vertex)).filter(|part| part.len() > 1)
    }

    /// The layer without what lies at hidden vertices; one with positions of its own has none.
    pub(super) fn seen_of(&self, mut layer: Layer) -> Layer {
        if self.is_hidden.is_empty() || layer.positions.is_some() {
            return layer;
        }
        layer.lines = RaggedArray::from_lists(layer.lines.iter().flat_map(|walk| self.seen_parts(walk)));
        layer.points.retain(|&vertex| !self.has(vertex));
        layer.rings.retain(|&vertex| !self.has(vertex));
        layer.triangles.retain(|triangle| self.has_none_of(triangle));
        layer.labels.retain(|label| !self.has(label.0));
        layer
    }

    /// What is said of it; `None` if nothing is left out.
    pub(super) fn remark(&self) -> Option<Remark> {
        let vertices = (0u32..).zip(&self.is_hidden).filter(|(_, is_hidden)| **is_hidden);
        let count = vertices.clone().count();
        let (vertex, has) = if count == 1 { ("vertex", "has") } else { ("vertices", "have") };
        let cell = if self.cell_count == 1 { "cell" } else { "cells" };
        let message = format!(
            "not drawn: {count} {vertex} that {has} a coordinate that is not finite, and {} {cell} there",
            self.cell_count
        );
        let places = vertices.map(|(vertex, _)| Place::cell(&[vertex]));
        (count > 0).then(|| Remark::new(RemarkCode::NotDrawn, message).at(count, places))
    }
}

/// The part of a model that can be drawn, with the numbers of its vertices, and what is left out. A hidden vertex lies where another one
/// is, so that it does not widen the picture.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if no vertex has a place.
pub(super) fn drawable(model: &Model, partial: &PartialPositions) -> Result<(Model, Hidden), Error> {
    let mut hidden = Hidden { is_hidden: vec![false; model.vertex_count()], ..Hidden::default() };
    partial.unplaced().iter().for_each(|vertex| hidden.is_hidden[vertex.index()] = true);
    let vertices = (0..model.vertex_count()).map(VertexId::new);
    let Some(somewhere) = vertices.clone().find_map(|vertex| partial.point(vertex)) else {
        return Err(partial.fault().expect("no vertex has a place"));
    };
    let flat = vertices.flat_map(|vertex| partial.point(vertex).unwrap_or(somewhere)).copied().collect();
    let positions = Positions::from_flat(partial.dimension(), flat)?;
    let mut polygons = RaggedArray::new();
    for polygon in model.polygons().iter() {
        if hidden.has_none_of(polygon) {
            polygons.push(polygon);
        } else {
            hidden.polygons.push(polygon);
            hidden.cell_count += 1;
        }
    }
    let (mut shapes, mut cells) = (Vec::new(), RaggedArray::new());
    for (cell, &shape) in model.cells().iter().zip(model.shapes()) {
        if hidden.has_none_of(cell) {
            shapes.push(shape);
            cells.push(cell);
        } else {
            hidden.has_cells = true;
            hidden.cell_count += 1;
        }
    }
    let mut lines = RaggedArray::new();
    for line in model.lines().iter() {
        hidden.cell_count += line.len() - 1;
        for part in hidden.seen_parts(line) {
            lines.push(part);
        }
    }
    hidden.cell_count -= lines.item_count() - lines.len();
    let points: Vec<VertexId> =
        model.points().iter().copied().filter(|point| !hidden.has(point.to_u32())).collect();
    hidden.cell_count += model.points().len() - points.len();
    let drawn = Model::from_parts(model.vertex_count(), positions, polygons, (shapes, cells), lines, points)?;
    Ok((drawn, hidden))
}

#[cfg(test)]
mod tests {
    use crate::{Layer, Picture, PictureStyle, Scene};
    use coface_answers::answer::{Place, RemarkCode};
    use coface_io::{Format, read};

    /// A strip of three triangles whose last vertex has no place.
    const STRIP: &[u8] =
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv nan 5 inf\nf 1 2 3\nf 3 2 4\nf 3 4 5\nl 1 2 5\np 5\n";

    #[test]
    fn cells_at_a_vertex_without_a_place_are_left_out() {
        let scene = Scene::of("strip", &read(STRIP, Format::Obj).unwrap()).unwrap();
        assert_eq!((scene.polygons().len(), scene.triangles()), (2, &[[0, 1, 2], [2, 1, 3]][..]));
        assert_eq!(scene.edges(), [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
        assert!(scene.positions().as_flattened().iter().all(|x| (0.0..=1.0).contains(x)));
        let remarks = scene.remarks();
        // A triangle, a segment and a point.
        let message = "not drawn: 1 vertex that has a coordinate that is not finite, and 3 cells there";
        assert_eq!((remarks.len(), remarks[0].code), (1, RemarkCode::NotDrawn));
        assert_eq!((&remarks[0].message[..], &remarks[0].places), (message, &vec![Place::cell(&[4])]));
        let whole = Scene::of("whole", &read(&STRIP[..31], Format::Obj).unwrap()).unwrap();
        assert!(whole.remarks().is_empty());
    }

    #[test]
    fn a_boundary_is_that_of_the_model_and_drawn_where_it_can_be() {
        let scene = Scene::of("strip", &read(STRIP, Format::Obj).unwrap()).unwrap().with_boundary();
        let mut sides: Vec<[u32; 2]> = scene
            .layers()
            .iter()
            .flat_map(|layer| layer.lines.iter().flat_map(|walk| walk.windows(2).map(|s| [s[0], s[1]])))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        sides.sort_unstable();
        // The side {2 3} lies between two triangles, one of which is not drawn.
        assert_eq!(sides, [[0, 1], [0, 2], [1, 3]]);
    }

    #[test]
    fn a_picture_is_the_same_with_and_without_what_is_hidden() {
        let seen = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\nl 1 2\n";
        let svg = |text: &[u8]| {
            let mut scene = Scene::of("strip", &read(text, Format::Obj).unwrap()).unwrap();
            let mut layer = Layer::new("a", "b");
            layer.push_simplex(&[0, 3]);
            layer.push_simplex(&[4, 3]);
            layer.points = vec![4];
            layer.labels = vec![(4, "here".to_owned())];
            if scene.positions().len() == 4 {
                layer = Layer::new("a", "b");
                layer.push_simplex(&[0, 3]);
            }
            layer.is_on = true;
            scene.push_layer(layer);
            Picture::new(&scene, &PictureStyle::default()).unwrap().svg()
        };
        assert_eq!(svg(STRIP), svg(seen));
    }

    #[test]
    fn a_model_without_any_place_is_refused() {
        let model = read(&b"v nan 0 0\nv 0 inf 0\nl 1 2\n"[..], Format::Obj).unwrap();
        let error = Scene::of("nowhere", &model).unwrap_err();
        assert_eq!(error.message(), "coordinate 0 of v0 is NaN, not a finite number");
    }
}
