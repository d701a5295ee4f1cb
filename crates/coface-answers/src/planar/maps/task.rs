//! What can be done to a map.

/// What is done to a map.
///
/// # Examples
/// ```
/// use coface_answers::{MapTask, RepairMethod};
/// assert_eq!(MapTask::Repair(RepairMethod::Linework).name(), "repair");
/// assert_eq!(MapTask::Clip([0.0, 0.0, 1.0, 1.0]).name(), "clip");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MapTask {
    /// Makes polygons valid that are not.
    Repair(RepairMethod),
    /// What is at most, or for a negative distance at least, so far away.
    Buffer(BufferOptions),
    /// What is in a box: least x, least y, greatest x, greatest y.
    Clip([f64; 4]),
    /// Lines and rings cut where they meet.
    Node(LineOptions),
    /// The faces that lines and rings bound.
    Polygonize(LineOptions),
    /// Fewer vertices: no border moves farther than this, and what touches, contains or lies beside what stays so.
    Simplify(f64),
    /// Gaps and overlaps of a coverage, and the sides of polygons that do not fit those of their neighbors. Gaps that are at most so wide
    /// are faults; without a width no gap is one.
    Coverage {
        /// The greatest width of a gap that is a fault.
        gap_width: Option<f64>,
    },
}

impl MapTask {
    /// The word for it.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::MapTask::Node(Default::default()).name(), "node");
    /// ```
    pub fn name(&self) -> &'static str {
        match self {
            Self::Repair(_) => "repair",
            Self::Buffer(_) => "buffer",
            Self::Clip(_) => "clip",
            Self::Node(_) => "node",
            Self::Polygonize(_) => "polygonize",
            Self::Simplify(_) => "simplify",
            Self::Coverage { .. } => "coverage",
        }
    }
}

/// How near lines that are cut must be to meet: exactly, unless something else is said.
///
/// # Examples
/// ```
/// use coface_answers::LineOptions;
/// assert_eq!(LineOptions::new(), LineOptions::default());
/// assert_ne!(LineOptions::new().tolerance(Some(0.1)), LineOptions::new().grid(Some(0.1)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineOptions {
    pub(super) snap: bool,
    pub(super) grid: Option<f64>,
    pub(super) tolerance: Option<f64>,
}

impl LineOptions {
    /// Lines meet where they do exactly.
    ///
    /// # Examples
    /// See [`LineOptions`].
    pub fn new() -> Self {
        Self::default()
    }

    /// Whether coordinates are rounded and lines cut again until all vertices are where their coordinates say.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::LineOptions;
    /// assert_ne!(LineOptions::new().snap(true), LineOptions::new());
    /// ```
    pub fn snap(mut self, snap: bool) -> Self {
        self.snap = snap;
        self
    }

    /// The step of a grid that all vertices are put on, in the unit of the map.
    ///
    /// # Examples
    /// See [`LineOptions`].
    pub fn grid(mut self, step: Option<f64>) -> Self {
        self.grid = step;
        self
    }

    /// Vertices and lines that are at most so far apart become one, in the unit of the map.
    ///
    /// # Examples
    /// See [`LineOptions`].
    pub fn tolerance(mut self, tolerance: Option<f64>) -> Self {
        self.tolerance = tolerance;
        self
    }
}

/// What the inside of a polygon is that is not valid, with the names of GEOS.
///
/// # Examples
/// ```
/// use coface_answers::RepairMethod;
/// assert_eq!(RepairMethod::default().name(), "structure");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RepairMethod {
    /// What the outer ring winds around and no hole does; a hole outside of its outer ring is a polygon.
    #[default]
    Structure,
    /// What lies behind an odd number of lines: those that rings run along, each once, counted on the way with the fewest from outside.
    Linework,
}

impl RepairMethod {
    /// The word for it.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::RepairMethod::Linework.name(), "linework");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Structure => "structure",
            Self::Linework => "linework",
        }
    }
}

/// How corners of a buffer are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum BufferJoins {
    /// By arcs.
    #[default]
    Round,
    /// By continuing the sides until they meet, and cutting what is farther away than this many times the distance off.
    Mitre(f64),
    /// By straight cuts.
    Bevel,
}

/// How a buffer ends where a line does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BufferCaps {
    /// In half a disk.
    #[default]
    Round,
    /// At the end of the line.
    Flat,
    /// At the distance beyond the end of the line.
    Square,
}

/// A buffer: its distance, and how far its flattened arcs may be from true ones.
///
/// # Examples
/// ```
/// use coface_answers::{BufferCaps, BufferOptions};
/// let buffer = BufferOptions::new(2.0).caps(BufferCaps::Flat);
/// assert_eq!((buffer.distance(), buffer.arc_error()), (2.0, 0.002));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BufferOptions {
    pub(super) distance: f64,
    pub(super) error: Option<f64>,
    pub(super) joins: BufferJoins,
    pub(super) caps: BufferCaps,
}

impl BufferOptions {
    /// Round joins and caps, arcs right to a thousandth of the distance.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::BufferOptions::new(-3.0).distance(), -3.0);
    /// ```
    pub fn new(distance: f64) -> Self {
        Self { distance, error: None, joins: BufferJoins::default(), caps: BufferCaps::default() }
    }

    /// No point of a flattened arc is farther than this from the true one.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::BufferOptions::new(3.0).error(0.5).arc_error(), 0.5);
    /// ```
    pub fn error(mut self, error: f64) -> Self {
        self.error = Some(error);
        self
    }

    /// How corners are joined.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{BufferJoins, BufferOptions};
    /// assert_ne!(BufferOptions::new(3.0).joins(BufferJoins::Bevel), BufferOptions::new(3.0));
    /// ```
    pub fn joins(mut self, joins: BufferJoins) -> Self {
        self.joins = joins;
        self
    }

    /// How the ends of lines are closed.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{BufferCaps, BufferOptions};
    /// assert_ne!(BufferOptions::new(3.0).caps(BufferCaps::Square), BufferOptions::new(3.0));
    /// ```
    pub fn caps(mut self, caps: BufferCaps) -> Self {
        self.caps = caps;
        self
    }

    /// The distance, in the unit of the map.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::BufferOptions::new(3.0).distance(), 3.0);
    /// ```
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// How far a flattened arc may be from the true one: a thousandth of the distance unless another length was given.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::BufferOptions::new(-4.0).arc_error(), 0.004);
    /// ```
    pub fn arc_error(&self) -> f64 {
        self.error.unwrap_or(self.distance.abs() / 1000.0)
    }
}
