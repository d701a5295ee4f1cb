//! Grids, prisms and products.

use super::{Made, scene};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::progress::Progress;
use clap::Subcommand;
use coface::algebra::RaggedArray;
use coface::algebra::chains::ProductComplex;
use coface::answers::{Producer, simplicial_complex};
use coface::complexes::families::FamilyModel;
use coface::complexes::grids::CuboidGrid;
use coface::complexes::shapes::{CellKind, PlacedCells};
use coface::complexes::simplicial::{Simplex, SimplicialGrid, extrude};
use coface::geometry::Positions;
use coface::io::{Model, Structure};
use coface::{Error, VertexId};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Numbers with commas between them.
#[derive(Clone, Debug)]
pub(super) struct Numbers<T>(Vec<T>);

impl<T> Numbers<T> {
    pub(super) fn as_slice(&self) -> &[T] {
        &self.0
    }

    pub(super) fn into_inner(self) -> Vec<T> {
        self.0
    }
}

impl<T: FromStr> FromStr for Numbers<T> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |word: &str| {
            word.trim().parse().map_err(|_| format!("{word:?} is no number: write 1,2,3 without spaces"))
        };
        text.split(',').map(number).collect::<Result<_, _>>().map(Self)
    }
}

impl<T> AsRef<[T]> for Numbers<T> {
    fn as_ref(&self) -> &[T] {
        &self.0
    }
}

/// Models made of numbers of cells, or of other models.
#[derive(Subcommand)]
pub(super) enum Construction {
    /// A grid of cubes, each cut into simplices
    Grid {
        /// The numbers of cubes along the axes
        #[arg(long, value_name = "N,N,..", value_delimiter = ',', required = true)]
        shape: Vec<u32>,
    },
    /// A grid of cuboids of any dimension
    Cuboids {
        /// The numbers of unit cubes along the axes
        #[arg(long, value_name = "N,N,..", value_delimiter = ',', required_unless_present = "lengths")]
        shape: Vec<u32>,
        /// The lengths of the intervals of an axis, negative where it is empty; once for each axis
        #[arg(long, value_name = "X,X,..", allow_hyphen_values = true, conflicts_with = "shape")]
        lengths: Vec<Numbers<f64>>,
    },
    /// A model swept through layers: segments become triangles, triangles tetrahedra
    #[command(visible_alias = "extrude")]
    Prism {
        /// The model, of segments or triangles; a facet list of any dimension gives one without positions
        #[arg(value_name = "INPUT")]
        input: PathBuf,
        /// The heights of the layers, negative where a layer is empty
        #[arg(long, value_name = "X,X,..", allow_hyphen_values = true, default_value = "1")]
        layers: Numbers<f64>,
        /// The way up for a model in space [default: the last axis]; a plane model gets one more axis
        #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
        direction: Option<Numbers<f64>>,
    },
    /// Shapes and files in place: a JSON scene of nested lists with affine maps
    ///
    /// `{"assembly": [{"translate": [0,0,2]}, {"shape": "sphere", "radius": 2, "kind": "cube"}, [{"rotate": {"axis": [0,0,1],
    /// "degrees": 90}}, {"file": "part.obj"}], {"scale": [1,1,-1]}, {"matrix": [[1,0,0,5],[0,1,0,0],[0,0,1,0]]}]}`
    ///
    /// A map moves everything after it in its list; shapes have the parameters of the command line; "dimension" beside "assembly"
    /// is that of the space, 3 if it is left out, and plane things lie in its first axes. Each shape and file becomes a group.
    Assembly {
        /// The scene; - is standard input
        #[arg(value_name = "SCENE")]
        scene: PathBuf,
    },
    /// The product of two models: simplices cut along staircases, of other cells the chain complex
    Product {
        /// The first model
        #[arg(value_name = "A")]
        first: PathBuf,
        /// The second model
        #[arg(value_name = "B")]
        second: PathBuf,
        /// The chain complex of products of cells, for simplices too
        #[arg(long)]
        chains: bool,
    },
}

impl Construction {
    pub(super) fn make(&self, common: &Common, progress: &Progress) -> Result<Made, Failure> {
        match self {
            Self::Grid { shape } => {
                let grid = SimplicialGrid::new(shape)?;
                let cells = grid.simplices()?.to_oriented();
                Ok(of_cells(PlacedCells::new(grid.positions()?, CellKind::Simplex, shape.len(), cells)?))
            }
            Self::Cuboids { shape, lengths } => {
                let grid = if lengths.is_empty() {
                    CuboidGrid::new(shape)
                } else {
                    CuboidGrid::with_lengths(lengths)
                }?;
                let Some(dimension) = grid.dimension() else {
                    return Err(Failure::new("the grid is empty: an axis has no full interval"));
                };
                let cells = grid.cells(dimension)?;
                Ok(of_cells(PlacedCells::new(grid.positions()?, CellKind::Cuboid, dimension, cells)?))
            }
            Self::Prism { input, layers, direction } => {
                let loaded = input::read(input, common.reading(), progress)?;
                let direction = direction.as_ref().map(Numbers::as_slice);
                Ok(prism(&loaded.model, layers.as_slice(), direction)
                    .map_err(|error| error.in_file(loaded.name))?)
            }
            Self::Assembly { scene } => Ok(Made::Model(Box::new(scene::assemble(scene, common, progress)?))),
            Self::Product { first, second, chains } => product(first, second, *chains, common, progress),
        }
    }
}

fn of_cells(cells: PlacedCells) -> Made {
    Made::Family(FamilyModel::Cells(cells))
}

/// The sweep of the simplices of a model.
fn prism(model: &Model, layers: &[f64], direction: Option<&[f64]>) -> Result<Made, Error> {
    if let Some(Structure::Facets(facets)) = model.structure() {
        let count = facets.items().iter().max().map_or(0, |&last| last as usize + 1);
        let lists = extrude(count, facets, layers)?.into_simplices().into_lists();
        return Ok(Made::Model(Box::new(Model::from_structure(Structure::Facets(lists)))));
    }
    if model.structure().is_some() || !model.cells().is_empty() {
        return Err(Error::invalid("only points, segments and triangles can be swept within space")
            .with_cure("give a model of these, or the boundary of a volume"));
    }
    if let Some(i) = model.polygons().iter().position(|polygon| polygon.len() != 3) {
        let sides = model.polygons().list(i).len();
        return Err(Error::invalid(format!("face f{i} has {sides} sides, so it is no simplex"))
            .with_cure("triangulate the model first"));
    }
    let segments: Vec<&[u32]> = model.lines().iter().flat_map(|line| line.windows(2)).collect();
    let (dimension, simplices) = match (model.polygons().is_empty(), segments.is_empty()) {
        (false, true) => (2, model.polygons().clone()),
        (true, false) => (1, RaggedArray::from_lists(segments)),
        (false, false) => {
            return Err(Error::invalid("the model has triangles and lines").with_cure("sweep one of the two"));
        }
        (true, true) => {
            let vertices = (0..model.vertex_count() as u32).collect();
            (0, RaggedArray::uniform(1, vertices)?)
        }
    };
    if let Some(direction) =
        direction.filter(|d| d.iter().any(|x| !x.is_finite()) || d.iter().all(|&x| x == 0.0))
    {
        return Err(Error::invalid(format!("{direction:?} is no direction"))
            .with_cure("give finite numbers that are not all zero"));
    }
    let sweep = extrude(model.vertex_count(), &simplices, layers)?;
    model.require_finite()?;
    let base = model.positions();
    let positions = match (direction, base.dimension()) {
        (None, 0..=2) => sweep.positions(base)?,
        (None, space) => {
            let mut last = vec![0.0; space];
            last[space - 1] = 1.0;
            along(base, sweep.heights(), &last)?
        }
        (Some(direction), space) if direction.len() == space => along(base, sweep.heights(), direction)?,
        (Some(direction), space) => {
            let message = format!("the direction has {} numbers, but points have {space}", direction.len());
            return Err(Error::invalid(message).with_cure("give as many numbers as a point has"));
        }
    };
    let cells = sweep.simplices().to_oriented();
    Ok(of_cells(PlacedCells::new(positions, CellKind::Simplex, dimension + 1, cells)?))
}

/// Copies of all points at these heights in a direction.
fn along(base: &Positions, heights: &[f64], direction: &[f64]) -> Result<Positions, Error> {
    let mut coordinates = Vec::with_capacity(base.as_flat().len() * heights.len());
    for height in heights {
        for vertex in 0..base.len() {
            let point = base.point(VertexId::new(vertex));
            coordinates.extend(point.iter().zip(direction).map(|(x, d)| x + height * d));
        }
    }
    Positions::from_flat(base.dimension(), coordinates)
}

fn product(
    first: &Path,
    second: &Path,
    chains: bool,
    common: &Common,
    progress: &Progress,
) -> Result<Made, Failure> {
    let [first, second] = [first, second].map(|path| input::read(path, common.reading(), progress));
    let (first, second) = (first?, second?);
    progress.stage("making the product");
    if !chains && let (Ok(a), Ok(b)) = (simplicial_complex(&first.model), simplicial_complex(&second.model)) {
        let (complex, _) = a.product(&b)?;
        return Ok(Made::Family(FamilyModel::Complex(complex)));
    }
    let complex = |loaded: input::Loaded| {
        Producer::of(loaded.model)
            .and_then(Producer::into_chain_complex)
            .map_err(|error| error.in_file(loaded.name))
    };
    let product = ProductComplex::new(&complex(first)?, &complex(second)?)?;
    Ok(Made::Model(Box::new(Model::from_structure(Structure::Chains(product.into_complex())))))
}

/// The facets of a complex as a structure that files hold.
pub(super) fn facets(facets: &[Simplex]) -> Model {
    Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets.iter().map(Simplex::numbers))))
}
