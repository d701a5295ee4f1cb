//! The polygon of one component: its curves and the word around it.

use coface_algebra::VertexId;
use coface_complexes::surface::SurfaceType;
use std::fmt;

/// What a curve of a canonical polygon is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CurveKind {
    /// One of the two loops of a handle.
    Handle,
    /// The loop of a cross-cap.
    Crosscap,
    /// A path from the base to a boundary loop.
    Join,
    /// A boundary loop.
    Boundary,
    /// The path along which a sphere is cut.
    Slit,
}

impl fmt::Display for CurveKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Handle => "handle",
            Self::Crosscap => "crosscap",
            Self::Join => "join",
            Self::Boundary => "boundary",
            Self::Slit => "slit",
        })
    }
}

/// A curve around a canonical polygon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CanonicalCurve {
    pub(super) kind: CurveKind,
    pub(super) name: String,
    pub(super) steps: Vec<u32>,
}

impl CanonicalCurve {
    /// What it is.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CanonicalCut, CurveKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.components()[0].curves()[0].kind(), CurveKind::Handle);
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> CurveKind {
        self.kind
    }

    /// Its name in the word: `a1`, `b1`, `a2`, .. of handles, `c1`, `c2`, .. of cross-caps, `d1`, .. of boundary loops, `e1`, .. of
    /// paths to them, `s1` of the slit of a sphere.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.components()[0].curves()[1].name(), "b1");
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its steps on the refined surface: 2e along edge e, 2e + 1 against it.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// // A loop ends where it starts.
    /// let ends = cut.refinement().map().skeleton().edge_ends();
    /// let steps = cut.components()[0].curves()[0].steps();
    /// assert_eq!(ends[steps[0] as usize], ends[(steps[steps.len() - 1] ^ 1) as usize]);
    /// # Ok(()) }
    /// ```
    pub fn steps(&self) -> &[u32] {
        &self.steps
    }
}

/// The canonical polygon of one component.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CanonicalComponent {
    pub(super) surface: SurfaceType,
    pub(super) base: Option<VertexId>,
    pub(super) curves: Vec<CanonicalCurve>,
    pub(super) word: Vec<i32>,
}

impl CanonicalComponent {
    /// What surface it is.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.components()[0].surface().to_string(), "torus");
    /// # Ok(()) }
    /// ```
    pub fn surface(&self) -> SurfaceType {
        self.surface
    }

    /// The vertex of the refined surface where all curves start; none of a disk, which is not cut.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert!(cut.components()[0].base().is_some());
    /// # Ok(()) }
    /// ```
    pub fn base(&self) -> Option<VertexId> {
        self.base
    }

    /// The curves. Letter i of the word, counted from 1, is curve i - 1.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.components()[0].curves().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn curves(&self) -> &[CanonicalCurve] {
        &self.curves
    }

    /// The curves around the polygon: i for curve i - 1, -i backwards.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.components()[0].word(), [1, 2, -1, -2]);
    /// # Ok(()) }
    /// ```
    pub fn word(&self) -> &[i32] {
        &self.word
    }
}

impl CanonicalComponent {
    /// Takes the word as it is read around the polygon, from any corner in either direction.
    pub(super) fn set_word(&mut self, mut word: Vec<i32>) {
        let kind = |letter: i32, curves: &[CanonicalCurve]| curves[letter.unsigned_abs() as usize - 1].kind;
        let loops: Vec<i32> = (1..=self.curves.len() as i32)
            .filter(|&letter| matches!(kind(letter, &self.curves), CurveKind::Handle | CurveKind::Crosscap))
            .collect();
        let expected: Vec<i32> = match (loops.len(), loops.first().map(|&letter| kind(letter, &self.curves)))
        {
            (_, Some(CurveKind::Crosscap)) => loops.iter().flat_map(|&c| [c, c]).collect(),
            _ => loops.chunks_exact(2).flat_map(|pair| [pair[0], pair[1], -pair[0], -pair[1]]).collect(),
        };
        let has_paths = self.curves.iter().any(|curve| curve.kind == CurveKind::Join);
        let starts_well = |word: &[i32]| match expected.first() {
            None => word[0] > 0 && (!has_paths || kind(word[0], &self.curves) == CurveKind::Join),
            Some(_) => word.starts_with(&expected),
        };
        'found: for _ in 0..2 {
            for start in 0..word.len() {
                let is_first = expected.first().is_none_or(|&first| word[start] == first);
                if is_first {
                    word.rotate_left(start);
                    if starts_well(&word) {
                        break 'found;
                    }
                    word.rotate_right(start);
                }
            }
            word.reverse();
            word.iter_mut().for_each(|letter| *letter = -*letter);
        }
        assert!(word.starts_with(&expected), "a canonical polygon has its canonical word");
        self.sort_boundaries(&mut word);
        self.word = word;
    }

    /// Numbers paths and boundary loops as they are met, and runs through boundary loops in the direction of the word.
    fn sort_boundaries(&mut self, word: &mut [i32]) {
        let is_sorted = |curve: &CanonicalCurve| matches!(curve.kind, CurveKind::Join | CurveKind::Boundary);
        let mut order: Vec<usize> = (0..self.curves.len()).filter(|&i| !is_sorted(&self.curves[i])).collect();
        let mut new = vec![0_i32; self.curves.len()];
        order.iter().zip(1..).for_each(|(&i, number)| new[i] = number);
        for kind in [CurveKind::Join, CurveKind::Boundary] {
            for &letter in word.iter() {
                let i = letter.unsigned_abs() as usize - 1;
                if self.curves[i].kind != kind || new[i] != 0 {
                    continue;
                }
                order.push(i);
                new[i] = order.len() as i32;
                if kind == CurveKind::Boundary && letter < 0 {
                    self.curves[i].steps.reverse();
                    self.curves[i].steps.iter_mut().for_each(|step| *step ^= 1);
                }
            }
        }
        for letter in word.iter_mut() {
            let i = letter.unsigned_abs() as usize - 1;
            let is_boundary = self.curves[i].kind == CurveKind::Boundary;
            *letter = if *letter < 0 && !is_boundary { -new[i] } else { new[i] };
        }
        let mut counts = [0; 2];
        self.curves = (order.into_iter())
            .map(|old| {
                let mut curve = self.curves[old].clone();
                if let Some((count, initial)) = match curve.kind {
                    CurveKind::Join => Some((&mut counts[0], 'e')),
                    CurveKind::Boundary => Some((&mut counts[1], 'd')),
                    _ => None,
                } {
                    *count += 1;
                    curve.name = format!("{initial}{count}");
                }
                curve
            })
            .collect();
    }
}

/// The curves of a component but slits and boundary loops.
pub(super) fn curves_of(surface: SurfaceType, loops: &[Vec<u32>], paths: &[Vec<u32>]) -> Vec<CanonicalCurve> {
    let mut curves = Vec::with_capacity(loops.len() + 2 * paths.len());
    for (i, steps) in loops.iter().enumerate() {
        let (kind, name) = if surface.is_orientable() {
            (CurveKind::Handle, format!("{}{}", if i % 2 == 0 { 'a' } else { 'b' }, i / 2 + 1))
        } else {
            (CurveKind::Crosscap, format!("c{}", i + 1))
        };
        curves.push(CanonicalCurve { kind, name, steps: steps.clone() });
    }
    for (steps, number) in paths.iter().zip(1..) {
        let name = format!("e{number}");
        curves.push(CanonicalCurve { kind: CurveKind::Join, name, steps: steps.clone() });
    }
    curves
}
