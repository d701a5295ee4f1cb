//! Cocycles and harmonic forms of a surface.

use crate::answer::{EdgeWeights, Remark, RemarkCode};
use coface_algebra::chains::Cochain;
use coface_algebra::{Error, Integer};
use coface_complexes::surface::GeneralizedMap;
use coface_topology::{
    CocycleBasis, HarmonicForm, SurfaceHomology, TreeCotree, cotangent_weights, harmonic_forms,
};

/// A basis of the first cohomology of a surface, dual to the loops of a tree-cotree decomposition.
///
/// # Examples
/// ```
/// use coface_answers::{SurfaceCocycles, SurfaceModel};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let tetrahedron = coface_io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], coface_io::Format::Json)?;
/// let surface = SurfaceModel::of(tetrahedron)?;
/// let cocycles = SurfaceCocycles::new(surface.map(), None, false)?;
/// assert!(cocycles.basis().cocycles().is_empty());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceCocycles {
    basis: CocycleBasis,
    is_sliced: bool,
    intersection: Option<(Vec<Vec<i64>>, Option<Integer>)>,
}

impl SurfaceCocycles {
    /// Finds the cocycles: by slicing along the loops, or by crossing the faces between them. Lengths of edges make the
    /// loops short.
    ///
    /// # Errors
    /// Those of [`TreeCotree::greedy`], and of [`CocycleBasis::by_slicing`] if slicing is asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceCocycles, SurfaceModel};
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let torus = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let found = SurfaceCocycles::new(torus.map(), None, false)?;
    /// assert_eq!(found.basis().cocycles().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn new(map: &GeneralizedMap, lengths: Option<&[f64]>, is_sliced: bool) -> Result<Self, Error> {
        let trees = match lengths {
            Some(_) => TreeCotree::greedy(map, None, lengths)?,
            None => TreeCotree::new(map),
        };
        let homology = SurfaceHomology::new(map, &trees);
        let is_closed = map.sides().all(|side| map.mate(side).is_some());
        let has_intersections = is_closed && map.orientation().conflicts().iter().all(Option::is_none);
        let sliced = match has_intersections || is_sliced {
            true => Some(CocycleBasis::by_slicing(map, homology.loops())?),
            false => None,
        };
        let basis = match sliced.as_ref().filter(|_| is_sliced) {
            Some(sliced) => sliced.dual()?,
            None => CocycleBasis::by_crossing(&homology),
        };
        let intersection = sliced
            .filter(|_| has_intersections)
            .map(|sliced| (sliced.pairing().to_vec(), sliced.determinant().cloned()));
        Ok(Self { basis, is_sliced, intersection })
    }

    /// The cocycles with their loops.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceCocycles, SurfaceModel};
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let torus = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let found = SurfaceCocycles::new(torus.map(), None, false)?;
    /// assert_eq!(found.basis().cocycles().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn basis(&self) -> &CocycleBasis {
        &self.basis
    }

    /// Whether they were found by slicing.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceCocycles, SurfaceModel};
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let torus = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let found = SurfaceCocycles::new(torus.map(), None, false)?;
    /// assert!(!found.is_sliced());
    /// # Ok(()) }
    /// ```
    pub fn is_sliced(&self) -> bool {
        self.is_sliced
    }

    /// The intersection numbers of the loops and their determinant, of a closed orientable surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SurfaceCocycles, SurfaceModel};
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let torus = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let found = SurfaceCocycles::new(torus.map(), None, false)?;
    /// // Two loops of a torus cross once.
    /// assert_eq!(found.intersection().map(|(crossings, _)| crossings[0][1].abs()), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn intersection(&self) -> Option<(&[Vec<i64>], Option<&Integer>)> {
        self.intersection.as_ref().map(|(matrix, determinant)| (&matrix[..], determinant.as_ref()))
    }
}

/// The harmonic forms in the classes of cocycles, the weights that they are for, and a remark if those are not cotangents
/// although nothing else was asked for.
///
/// # Errors
/// Those of [`harmonic_forms`]; those of [`cotangent_weights`] if cotangents are asked for.
///
/// # Examples
/// ```
/// use coface_answers::answer::EdgeWeights;
/// use coface_answers::{SurfaceModel, surface_harmonic_forms};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let tetrahedron = coface_io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], coface_io::Format::Json)?;
/// let surface = SurfaceModel::of(tetrahedron)?;
/// let (weights, forms, remark) = surface_harmonic_forms(surface.map(), &[], None, None)?;
/// assert_eq!((weights, forms.len(), remark), (EdgeWeights::Uniform, 0, None));
/// # Ok(()) }
/// ```
pub fn surface_harmonic_forms(
    map: &GeneralizedMap,
    cocycles: &[Cochain<Integer>],
    lengths: Option<&[f64]>,
    weights: Option<EdgeWeights>,
) -> Result<(EdgeWeights, Vec<HarmonicForm>, Option<Remark>), Error> {
    let uniform = || harmonic_forms(map, cocycles, &vec![1.0; map.skeleton().edge_count()]);
    if weights == Some(EdgeWeights::Uniform) || cocycles.is_empty() {
        return Ok((EdgeWeights::Uniform, uniform()?, None));
    }
    let found = match lengths {
        None => Err(Error::invalid("the model has no positions, so angles have no cotangents")
            .with_cure("take uniform weights")),
        Some(lengths) => {
            cotangent_weights(map, lengths).and_then(|weights| harmonic_forms(map, cocycles, &weights))
        }
    };
    match found {
        Ok(forms) => Ok((EdgeWeights::Cotangent, forms, None)),
        Err(error) if weights.is_some() => Err(error),
        Err(error) => {
            let message = format!("uniform weights are taken: {}", error.message());
            Ok((EdgeWeights::Uniform, uniform()?, Some(Remark::new(RemarkCode::UniformWeights, message))))
        }
    }
}
