//! Vines: paths of points of diagrams.

/// A point of a diagram at a parameter.
///
/// # Examples
/// See [`vineyard`](super::vineyard).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct VinePoint {
    pub(super) parameter: f64,
    pub(super) birth: f64,
    pub(super) death: Option<f64>,
}

impl VinePoint {
    /// The parameter: 0 at the first function, 1 at the second one, and so on.
    ///
    /// # Examples
    /// See [`vineyard`](super::vineyard).
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// The value at which the class is born.
    ///
    /// # Examples
    /// See [`vineyard`](super::vineyard).
    pub fn birth(&self) -> f64 {
        self.birth
    }

    /// The value at which it dies; `None` if it stays.
    ///
    /// # Examples
    /// See [`vineyard`](super::vineyard).
    pub fn death(&self) -> Option<f64> {
        self.death
    }

    /// How long it lives.
    ///
    /// # Examples
    /// See [`vineyard`](super::vineyard).
    pub fn persistence(&self) -> f64 {
        self.death.map_or(f64::INFINITY, |death| death - self.birth)
    }
}

/// The path of a class while the function moves: points between which births and deaths are on lines.
///
/// # Examples
/// See [`vineyard`](super::vineyard).
#[derive(Clone, Debug, PartialEq)]
pub struct Vine {
    pub(super) degree: usize,
    pub(super) points: Vec<VinePoint>,
}

impl Vine {
    /// The degree of the class.
    ///
    /// # Examples
    /// See [`vineyard`](super::vineyard).
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Where it bends, and its points at all functions along its way: by rising parameters.
    ///
    /// # Examples
    /// See [`vineyard`](super::vineyard).
    pub fn points(&self) -> &[VinePoint] {
        &self.points
    }

    /// The longest persistence along the way.
    ///
    /// # Examples
    /// See [`vineyard`](super::vineyard).
    pub fn persistence(&self) -> f64 {
        self.points.iter().map(VinePoint::persistence).fold(0.0, f64::max)
    }
}

/// The vertices whose values a birth and a death are, from a parameter on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stretch {
    pub(super) from: f64,
    pub(super) birth: u32,
    pub(super) death: Option<u32>,
}

impl Stretch {
    fn is_on_the_diagonal(&self) -> bool {
        self.death == Some(self.birth)
    }
}

/// The values of the vertices at all parameters.
pub(super) struct Motion<'a> {
    pub(super) functions: &'a [Vec<f64>],
}

impl Motion<'_> {
    /// The value of a vertex at a parameter.
    pub(super) fn value(&self, vertex: u32, parameter: f64) -> f64 {
        let place = parameter as usize;
        let (vertex, part) = (vertex as usize, parameter - place as f64);
        let from = self.functions[place][vertex];
        match self.functions.get(place + 1).filter(|_| part > 0.0) {
            Some(to) => from * (1.0 - part) + to[vertex] * part,
            None => from,
        }
    }

    fn point(&self, stretch: &Stretch, parameter: f64) -> VinePoint {
        let value = |vertex| self.value(vertex, parameter);
        let birth = value(stretch.birth);
        // Where two vertices meet, rounding may turn their values around.
        VinePoint { parameter, birth, death: stretch.death.map(|death| value(death).max(birth)) }
    }

    /// The vines of a class: its stretches apart from those on the diagonal.
    pub(super) fn vines(&self, degree: usize, stretches: &[Stretch], vines: &mut Vec<Vine>) {
        let last = (self.functions.len() - 1) as f64;
        let end = |place: usize| stretches.get(place + 1).map_or(last, |next| next.from);
        let mut points: Vec<VinePoint> = Vec::new();
        for (place, stretch) in stretches.iter().enumerate() {
            if !stretch.is_on_the_diagonal() {
                let (from, to) = (stretch.from, end(place));
                let between = (from.floor() as usize + 1..).map(|at| at as f64).take_while(|&at| at < to);
                let ends = std::iter::once(from).chain(between).chain((to > from).then_some(to));
                // The first point is the last one of the stretch before, whose values are those of other vertices.
                let is_continued = points.last().is_some_and(|last| last.parameter == from);
                points.extend(ends.skip(usize::from(is_continued)).map(|at| self.point(stretch, at)));
            }
            let is_last = place + 1 == stretches.len();
            if (stretch.is_on_the_diagonal() || is_last) && !points.is_empty() {
                let points = std::mem::take(&mut points);
                if points.iter().any(|point| point.persistence() > 0.0) {
                    vines.push(Vine { degree, points });
                }
            }
        }
    }
}
