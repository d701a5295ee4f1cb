//! What is drawn over a model or beside it.

use coface_algebra::RaggedArray;

/// Points, lines and triangles that are shown together.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Layer {
    /// What it is called.
    pub name: String,
    /// Layers of one group stand together: "homology", "boundary", "witness", "cut".
    pub group: String,
    /// What is said about it beside its name.
    pub detail: String,
    /// Whether it is shown at first.
    pub is_on: bool,
    /// A place in the palette, for layers that belong together, or a color of its own by [`Layer::rgb`]; none for the next free one.
    pub color: Option<u32>,
    /// Whether lines have arrowheads: they run from their first point to their last.
    pub has_arrows: bool,
    /// Three coordinates a point if it has points of its own; else points are vertices of the model.
    pub positions: Option<Vec<[f64; 3]>>,
    /// Polylines through points.
    pub lines: RaggedArray,
    /// Points with a mark.
    pub points: Vec<u32>,
    /// Points with a ring: they bound what is shown and are not in it.
    pub rings: Vec<u32>,
    /// Triangles of points.
    pub triangles: Vec<[u32; 3]>,
    /// Texts at points.
    pub labels: Vec<(u32, String)>,
}

impl Layer {
    /// A layer without content.
    ///
    /// # Examples
    /// ```
    /// use coface_pictures::Layer;
    /// let mut layer = Layer::new("notes", "a triangle");
    /// layer.is_on = true;
    /// assert_eq!((layer.group.as_str(), layer.name.as_str()), ("notes", "a triangle"));
    /// ```
    pub fn new(group: &str, name: impl Into<String>) -> Self {
        Self { name: name.into(), group: group.to_owned(), ..Self::default() }
    }

    /// The number of a color that is in no palette, from its red, green and blue.
    ///
    /// # Examples
    /// ```
    /// use coface_pictures::Layer;
    /// let mut layer = Layer::new("notes", "a triangle");
    /// layer.color = Some(Layer::rgb([255, 128, 0]));
    /// assert_eq!(layer.color, Some(0x1ff8000));
    /// ```
    pub fn rgb([red, green, blue]: [u8; 3]) -> u32 {
        u32::from_be_bytes([1, red, green, blue])
    }

    /// Adds a cell of dimension 0, 1 or 2 by its vertices; of higher dimension its triangles.
    ///
    /// # Examples
    /// ```
    /// use coface_pictures::Layer;
    /// let mut layer = Layer::new("notes", "a triangle");
    /// layer.push_simplex(&[0, 1, 2]);
    /// assert_eq!(layer.triangles, [[0, 1, 2]]);
    /// ```
    pub fn push_simplex(&mut self, vertices: &[u32]) {
        match *vertices {
            [] => {}
            [vertex] => self.points.push(vertex),
            [_, _] => self.lines.push(vertices),
            _ => {
                for (i, &a) in vertices.iter().enumerate() {
                    for (j, &b) in vertices.iter().enumerate().skip(i + 1) {
                        self.triangles.extend(vertices.iter().skip(j + 1).map(|&c| [a, b, c]));
                    }
                }
            }
        }
    }

    /// Adds a cell with a coefficient: edges run backwards where it is negative.
    pub(super) fn push_term(&mut self, vertices: &[u32], is_negative: bool) {
        match *vertices {
            [a, b] if is_negative => self.lines.push(&[b, a]),
            _ => self.push_simplex(vertices),
        }
    }

    /// Adds triangles around a point, for a polygon that bends little.
    pub(super) fn push_fan(&mut self, walk: &[u32]) {
        self.triangles.extend(walk.windows(2).skip(1).map(|pair| [walk[0], pair[0], pair[1]]));
    }

    /// Whether nothing would be seen of it.
    ///
    /// # Examples
    /// ```
    /// use coface_pictures::Layer;
    /// let mut layer = Layer::new("notes", "a triangle");
    /// assert!(layer.is_empty());
    /// layer.push_simplex(&[7]);
    /// assert!(!layer.is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        let has_points = !self.points.is_empty() || !self.rings.is_empty();
        !has_points && self.lines.is_empty() && self.triangles.is_empty() && self.labels.is_empty()
    }

    /// The highest point that is used.
    pub(super) fn last_point(&self) -> Option<u32> {
        let used = self
            .lines
            .items()
            .iter()
            .chain(&self.points)
            .chain(&self.rings)
            .chain(self.triangles.as_flattened());
        used.copied().chain(self.labels.iter().map(|label| label.0)).max()
    }
}

/// A flat picture beside the model; its layers have points of their own.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Pane {
    /// What it shows.
    pub name: String,
    /// The positions of its points.
    pub positions: Vec<[f64; 2]>,
    /// What is drawn.
    pub layers: Vec<Layer>,
    /// What is to the right and what is up, for diagrams.
    pub axes: Option<[String; 2]>,
}
