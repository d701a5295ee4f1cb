//! Several models in one scene.

use super::{Layer, Scene};
use std::ops::Range;

/// The group of layers that each show one of several models.
const MODELS: &str = "models";

impl Scene {
    /// Shows the cells whose vertices are all in a range as a layer with a name: one of several models that were put side by side in one. Of cells
    /// that are shaded the layer has the triangles, of others the edges and points. `color` is as in [`Layer::color`].
    ///
    /// # Complexity
    /// Linear in the cells of the scene.
    ///
    /// # Examples
    /// A triangle and an edge beside it.
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let both = &b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nl 4 5\n"[..];
    /// let both = coface_io::read(both, coface_io::Format::Obj)?;
    /// let mut scene = Scene::of("both", &both)?;
    /// scene.add_member("triangle", 0..3, None);
    /// scene.add_member("edge", 3..5, None);
    /// assert_eq!(scene.layers()[0].triangles, [[0, 1, 2]]);
    /// assert_eq!(scene.layers()[1].lines.list(0), [3, 4]);
    /// # Ok(()) }
    /// ```
    pub fn add_member(&mut self, name: &str, vertices: Range<u32>, color: Option<u32>) {
        let is_own = |cell: &[u32]| cell.iter().all(|vertex| vertices.contains(vertex));
        let mut layer = Layer::new(MODELS, name);
        layer.triangles = self.triangles.iter().filter(|triangle| is_own(&triangle[..])).copied().collect();
        for simplex in self.parts.simplices.iter().filter(|simplex| is_own(simplex)) {
            layer.push_simplex(simplex);
        }
        let mut is_used: Vec<bool> = vec![false; vertices.len()];
        let of_layer = layer.triangles.as_flattened().iter().chain(layer.lines.items()).chain(&layer.points);
        of_layer.for_each(|&vertex| is_used[(vertex - vertices.start) as usize] = true);
        let isolated =
            vertices.clone().zip(is_used).filter(|(_, is_used)| !is_used).map(|(vertex, _)| vertex);
        if layer.triangles.is_empty() {
            layer.points.extend(isolated);
        }
        layer.detail = match vertices.len() {
            1 => "1 vertex".to_owned(),
            count => format!("{count} vertices"),
        };
        layer.color = color;
        layer.is_on = true;
        self.add_layer(layer);
    }
}
