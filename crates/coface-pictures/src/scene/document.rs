//! A scene as the document that a page holds.

use super::parts::common_width;
use super::{Layer, Pane, Scene};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coface_algebra::RaggedArray;
use coface_answers::answer::{InfoAnswer, Remark, YinSetAnswer};
use serde::{Deserialize, Serialize};

/// What the page of a scene shows. Texts of numbers are base64 of little-endian bytes, 32 bits each.
///
/// # Examples
/// ```
/// use coface_io::{Format, read};
/// use coface_pictures::Scene;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let document = Scene::of("triangle", &triangle)?.document();
/// assert_eq!((document.title.as_str(), document.polygons.width), ("triangle", Some(3)));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub struct SceneDocument {
    /// The version of the document: 1.
    pub coface_scene: u32,
    /// The title of the page.
    pub title: String,
    /// What is known of the model; null where it was not examined.
    pub report: Option<SceneReport>,
    /// The number of coordinates that matter: 2 or 3.
    pub dimension: usize,
    /// What was subtracted from all positions before they were rounded to 32 bits.
    pub origin: [f64; 3],
    /// Three numbers a vertex.
    pub positions: String,
    /// The number of each vertex in the model; absent where vertices are numbered as here.
    #[serde(rename = "vertexNumbers", default, skip_serializing_if = "Option::is_none")]
    pub vertex_numbers: Option<String>,
    /// The polygons by the first walk around each.
    pub polygons: PackedLists,
    /// Walks around polygons beyond the first.
    pub rims: PackedLists,
    /// The polygon of each of these walks.
    #[serde(rename = "polygonsOfRims")]
    pub polygons_of_rims: String,
    /// The top cells that are neither polygons nor 3-cells.
    pub simplices: PackedLists,
    /// The polygons around each 3-cell.
    pub cells: PackedLists,
    /// For each polygon of each 3-cell 1 where the cell has it with a minus, else 0; empty where that is not known.
    pub signs: String,
    /// What is known of each 3-cell, or of each polygon where there are none.
    pub notes: Vec<String>,
    /// What is shaded; null where that is the polygons.
    pub triangles: Option<PackedTriangles>,
    /// What is not drawn, drawn instead of the model, or invented for it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<Remark>,
    /// What is drawn over the model.
    pub layers: Vec<LayerDocument>,
    /// Flat pictures beside the model.
    pub panes: Vec<PaneDocument>,
}

/// What is known of what a scene shows.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(untagged)]
pub enum SceneReport {
    /// The report on a model.
    Model(Box<InfoAnswer>),
    /// The facts about a set of the plane.
    Set(Box<YinSetAnswer>),
}

/// Lists of numbers: all of one width, or by where each starts.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PackedLists {
    /// The length of all lists; absent where they differ.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<usize>,
    /// Where each list starts, and where the last ends; absent where all have one width.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub starts: Option<String>,
    /// The entries of all lists.
    pub items: String,
}

/// Triangles that are shaded.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PackedTriangles {
    /// Three vertices each.
    pub items: String,
    /// The polygon of each.
    pub polygons: String,
    /// The 3-cell of each; empty without 3-cells.
    pub cells: String,
}

/// A [`Layer`] in a document.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LayerDocument {
    /// What it is called.
    pub name: String,
    /// Layers of one group stand together.
    pub group: String,
    /// What is said about it beside its name.
    pub detail: String,
    /// Whether it is shown at first.
    pub on: bool,
    /// Polylines through points.
    pub lines: PackedLists,
    /// Points with a mark.
    pub points: String,
    /// Triangles of points, three each.
    pub triangles: String,
    /// Texts at points.
    pub labels: Vec<LabelDocument>,
    /// A place in the palette; absent for the next free one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<u32>,
    /// Whether lines have arrowheads; absent where they have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arrows: Option<bool>,
    /// Three numbers a point if it has points of its own; absent where they are vertices of the model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub positions: Option<String>,
}

/// A text at a point.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LabelDocument {
    /// The point.
    pub point: u32,
    /// The text.
    pub text: String,
}

/// A [`Pane`] in a document.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PaneDocument {
    /// What it shows.
    pub name: String,
    /// Two numbers a point.
    pub positions: String,
    /// What is drawn.
    pub layers: Vec<LayerDocument>,
    /// What is to the right and what is up; absent where that has no meaning.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axes: Option<[String; 2]>,
}

/// 32 bits each, little-endian.
fn numbers(numbers: impl IntoIterator<Item = u32>) -> String {
    let bytes: Vec<u8> = numbers.into_iter().flat_map(u32::to_le_bytes).collect();
    STANDARD.encode(bytes)
}

/// 32 bits each, little-endian.
fn reals(reals: impl IntoIterator<Item = f64>) -> String {
    let bytes: Vec<u8> = reals.into_iter().flat_map(|x| (x as f32).to_le_bytes()).collect();
    STANDARD.encode(bytes)
}

/// Lists by where they start; lists that all have one length say it instead.
fn packed(lists: &RaggedArray) -> PackedLists {
    let items = numbers(lists.items().iter().copied());
    match common_width(lists) {
        Some(width) => PackedLists { width: Some(width), starts: None, items },
        None => {
            let starts = numbers((0..=lists.len()).map(|i| lists.start(i) as u32));
            PackedLists { width: None, starts: Some(starts), items }
        }
    }
}

impl Scene {
    /// The scene as the document that a page shows.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// assert_eq!(scene.document().title, "square");
    /// # Ok(()) }
    /// ```
    pub fn document(&self) -> SceneDocument {
        let shifted = |point: &[f64; 3]| [0, 1, 2].map(|axis| point[axis] - self.origin[axis]);
        // Triangles that are the polygons need not be there twice.
        let is_plain = self.parts.cells.is_empty()
            && common_width(&self.parts.polygons) == Some(3)
            && self.triangles.as_flattened() == self.parts.polygons.items();
        SceneDocument {
            coface_scene: 1,
            title: self.title.clone(),
            report: self.report.clone(),
            dimension: self.dimension,
            origin: self.origin,
            positions: reals(self.positions.iter().flat_map(shifted)),
            vertex_numbers: Some(&self.numbering.numbers)
                .filter(|list| !list.is_empty())
                .map(|list| numbers(list.iter().copied())),
            polygons: packed(&self.parts.polygons),
            rims: packed(&self.parts.rims),
            polygons_of_rims: numbers(self.parts.polygon_of_rim.iter().copied()),
            simplices: packed(&self.parts.simplices),
            cells: packed(&self.parts.cells),
            signs: numbers(self.parts.cell_signs.iter().map(|&is_negative| u32::from(is_negative))),
            notes: self.notes.clone(),
            triangles: (!is_plain).then(|| PackedTriangles {
                items: numbers(self.triangles.as_flattened().iter().copied()),
                polygons: numbers(self.polygon_of_triangle.iter().copied()),
                cells: numbers(self.cell_of_triangle.iter().copied()),
            }),
            remarks: self.remarks(),
            layers: self.layers.iter().map(|layer| layer_document(layer, shifted)).collect(),
            panes: self.panes.iter().map(pane_document).collect(),
        }
    }
}

fn layer_document(layer: &Layer, shifted: impl Fn(&[f64; 3]) -> [f64; 3] + Copy) -> LayerDocument {
    LayerDocument {
        name: layer.name.clone(),
        group: layer.group.clone(),
        detail: layer.detail.clone(),
        on: layer.is_on,
        lines: packed(&layer.lines),
        points: numbers(layer.points.iter().copied()),
        triangles: numbers(layer.triangles.as_flattened().iter().copied()),
        labels: layer
            .labels
            .iter()
            .map(|(point, text)| LabelDocument { point: *point, text: text.clone() })
            .collect(),
        color: layer.color,
        arrows: layer.has_arrows.then_some(true),
        positions: layer.positions.as_ref().map(|positions| reals(positions.iter().flat_map(shifted))),
    }
}

fn pane_document(pane: &Pane) -> PaneDocument {
    PaneDocument {
        name: pane.name.clone(),
        positions: reals(pane.positions.iter().flatten().copied()),
        layers: pane.layers.iter().map(|layer| layer_document(layer, |point| *point)).collect(),
        axes: pane.axes.clone(),
    }
}
