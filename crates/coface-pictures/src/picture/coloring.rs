//! Colors of vertices, for files that have room for them.

use super::palette::{ALARM, LIGHT, packed, palette_color};
use super::scene_picture::shown;
use crate::Scene;
use coface_algebra::UnionFind;
use coface_algebra::{Error, ErrorKind};
use coface_io::{CellData, GroupKind, Model};

/// What the color of a vertex says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coloring {
    /// Each component has a color.
    Components,
    /// Vertices on the boundary are red: of sides in one polygon, of faces in one cell where there are 3-cells.
    Boundary,
    /// Vertices in layers that are shown have the color of the last of them.
    Layers,
}

/// The color of each vertex of a scene as red, green and blue, from the palette of pictures; what is not marked has that of a surface.
///
/// # Complexity
/// $O(n \log n)$ in the cells.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_pictures::{Coloring, Scene, palette_color, vertex_colors};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let apart = io::read(&b"[[0, 1, 2], [3, 4]]"[..], Format::Json)?;
/// let colors = vertex_colors(&Scene::of("apart", &apart)?, Coloring::Components);
/// assert_eq!((colors[2], colors[4]), (palette_color(0), palette_color(1)));
/// # Ok(()) }
/// ```
pub fn vertex_colors(scene: &Scene, coloring: Coloring) -> Vec<[u8; 3]> {
    let bytes = |color| {
        let [_, red, green, blue] = packed(color).to_be_bytes();
        [red, green, blue]
    };
    let mut colors = vec![bytes(LIGHT.surface); scene.positions().len()];
    match coloring {
        Coloring::Components => {
            let mut components = UnionFind::new(colors.len());
            for [a, b] in scene.edges() {
                components.unite(a, b);
            }
            for (color, component) in colors.iter_mut().zip(components.class_numbers()) {
                *color = palette_color(component as usize);
            }
        }
        Coloring::Boundary => {
            for vertex in boundary_vertices(scene) {
                colors[vertex as usize] = bytes(ALARM);
            }
        }
        Coloring::Layers => {
            for (layer, color) in shown(scene).filter(|(layer, _)| layer.positions.is_none()) {
                let used = layer.lines.items().iter().chain(&layer.points);
                for &vertex in used.chain(layer.triangles.as_flattened()) {
                    colors[vertex as usize] = bytes(color);
                }
            }
        }
    }
    colors
}

/// The vertices of what lies in one cell of the highest degree only.
fn boundary_vertices(scene: &Scene) -> Vec<u32> {
    let mut walls: Vec<[u32; 3]> = scene.triangles().to_vec();
    walls.iter_mut().for_each(|wall| wall.sort_unstable());
    walls.sort_unstable();
    // A face between two cells is shaded for each of them.
    let has_cells = walls.windows(2).any(|pair| pair[0] == pair[1]) || scene.has_cells();
    if has_cells {
        return walls.chunk_by(|a, b| a == b).filter(|run| run.len() == 1).flat_map(|run| run[0]).collect();
    }
    let mut sides: Vec<[u32; 2]> = Vec::new();
    for walk in scene.polygons().iter().chain(scene.rims().iter()) {
        sides.extend((0..walk.len()).map(|i| {
            let [a, b] = [walk[i], walk[(i + 1) % walk.len()]];
            [a.min(b), a.max(b)]
        }));
    }
    sides.sort_unstable();
    sides.chunk_by(|a, b| a == b).filter(|run| run.len() == 1).flat_map(|run| run[0]).collect()
}

/// The model with the colors of its vertices as data `red`, `green` and `blue`, as PLY has them.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is a color for each vertex.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, GroupKind};
/// use coface_pictures::colored;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let model = colored(triangle, &[[255, 0, 0], [0, 255, 0], [0, 0, 255]])?;
/// let mut text = Vec::new();
/// io::write(&model, &mut text, Format::Obj)?;
/// assert!(String::from_utf8_lossy(&text).contains("v 1 0 0 0 1 0\n"));
/// # Ok(()) }
/// ```
pub fn colored(mut model: Model, colors: &[[u8; 3]]) -> Result<Model, Error> {
    if colors.len() != model.vertex_count() {
        let message = format!("there are {} colors for {} vertices", colors.len(), model.vertex_count());
        return Err(Error::new(ErrorKind::Shape, message).with_cure("color a model that is a mesh"));
    }
    for (part, name) in ["red", "green", "blue"].into_iter().enumerate() {
        let values = colors.iter().map(|color| color[part]).collect();
        model = model.without_data(name, GroupKind::Vertices);
        model = model.with_data(CellData::bytes(name, GroupKind::Vertices, 1, values)?)?;
    }
    Ok(model)
}
