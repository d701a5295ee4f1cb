//! The models of a scene as inputs of formulas: which are closed, and which cells are inside them.

use super::arranged::Arranged;
use super::{SpatialRequest, SpatialScene};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind, VertexId};
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_arrange::boolean::{InputRim, InsideRule, WindingNumbers};
use std::fmt::Write;

/// So many vertices of a rim are named in a message.
const MOST_NAMED: usize = 8;

/// Whether a model has an inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum InputState {
    /// It is closed: each cell has a winding number.
    Closed,
    /// It is closed but for the directions of polygons, which do not agree across `edges` edges of the arrangement: each cell has a
    /// winding number modulo 2.
    Incoherent {
        /// The number of such edges.
        edges: usize,
    },
    /// It has a rim of `edges` edges of the arrangement.
    Open {
        /// The number of edges of the rim.
        edges: usize,
    },
}

/// What becomes of models that are open, where [their mouths](SpatialScene::close_mouths) are not closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OpenInputs {
    /// They are refused, with a closed walk along their rim.
    #[default]
    Refuse,
    /// Nothing is inside them. A model whose polygons only disagree in direction has an inside by parity.
    Empty,
}

/// The models as chains of faces.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    /// Whether no face is left of an input in the sum of its polygons.
    pub(super) vanishes: Vec<bool>,
    rims: Vec<Option<InputRim>>,
    /// Zero around all cells for models that are not closed.
    winding: WindingNumbers,
    /// Zero for models that are closed, and for open ones.
    parities: Option<WindingNumbers>,
}

/// Which cells are inside which inputs.
#[derive(Clone, Debug)]
pub(super) struct Membership {
    /// The inputs that each cell is inside of, rising.
    inputs: RaggedArray,
}

impl Membership {
    pub(super) fn is_inside(&self, cell: CellId, input: usize) -> bool {
        self.inputs.list(cell.index()).binary_search(&(input as u32)).is_ok()
    }

    /// The inputs that a cell is inside of, rising.
    pub(super) fn inputs_around(&self, cell: CellId) -> Vec<usize> {
        self.inputs.list(cell.index()).iter().map(|&input| input as usize).collect()
    }
}

impl Inputs {
    pub(super) fn new(scene: &SpatialScene, arranged: &Arranged) -> Result<Self, Error> {
        Self::of_chains(scene.names().len(), arranged.complex(), arranged.inputs())
    }

    /// So many models as chains of faces: rows are faces, columns models.
    pub(super) fn of_chains(
        count: usize,
        complex: &ChainComplex,
        chains: &SparseMatrix,
    ) -> Result<Self, Error> {
        let mut rims = vec![None; count];
        for rim in InputRim::of_inputs(complex, chains)? {
            let input = rim.input();
            rims[input] = Some(rim);
        }
        let is_even = |input: usize| rims[input].as_ref().is_some_and(InputRim::is_even);
        let with = |is_kept: &dyn Fn(usize) -> bool| {
            let kept =
                chains.columns().enumerate().filter(|&(input, _)| is_kept(input)).flat_map(
                    |(input, column)| column.iter().map(move |(face, m)| (face, input, i64::from(m))),
                );
            SparseMatrix::from_entries(chains.row_count(), count, kept)
        };
        let winding = if rims.iter().all(Option::is_none) {
            WindingNumbers::of_cycles(complex, chains)?
        } else {
            WindingNumbers::of_cycles(complex, &with(&|input| rims[input].is_none())?)?
        };
        let parities = match (0..count).any(is_even) {
            true => Some(WindingNumbers::parities(complex, &with(&is_even)?)?),
            false => None,
        };
        let vanishes = chains.columns().take(count).map(|column| column.iter().next().is_none()).collect();
        Ok(Self { vanishes, rims, winding, parities })
    }

    /// So many models that are closed and enclose no cell of a complex: nothing more is known of them.
    pub(super) fn of_closed(count: usize, complex: &ChainComplex) -> Result<Self, Error> {
        let none = SparseMatrix::from_entries(complex.cell_count(2), count, [])?;
        let winding = WindingNumbers::of_cycles(complex, &none)?;
        Ok(Self { vanishes: vec![false; count], rims: vec![None; count], winding, parities: None })
    }

    /// Whether each is closed, winds once around what it encloses, and encloses something.
    pub(super) fn are_plain(&self) -> bool {
        self.rims.iter().all(Option::is_none)
            && !self.vanishes.contains(&true)
            && self.odd_cells().iter().all(|own| *own == [0; 2])
    }

    pub(super) fn state(&self, input: usize) -> InputState {
        match &self.rims[input] {
            None => InputState::Closed,
            Some(rim) if rim.is_even() => InputState::Incoherent { edges: rim.ridges().len() },
            Some(rim) => InputState::Open { edges: rim.ridges().len() },
        }
    }

    /// How many cells each input winds around less than zero times, and more than once: parts that are inside out, and
    /// that overlap.
    pub(super) fn odd_cells(&self) -> Vec<[usize; 2]> {
        let mut counts = vec![[0; 2]; self.rims.len()];
        for cell in 0..self.winding.cell_count() {
            for &(input, number) in self.winding.around(CellId::new(cell)) {
                counts[input as usize][0] += usize::from(number < 0);
                counts[input as usize][1] += usize::from(number.abs() > 1);
            }
        }
        counts
    }

    pub(super) fn membership(
        &self,
        scene: &SpatialScene,
        arranged: &Arranged,
        rule: InsideRule,
        open: OpenInputs,
        request: &SpatialRequest,
        is_used: impl Fn(usize) -> bool,
    ) -> Result<Membership, Error> {
        let is_part = |input: usize| scene.is_named_part(input);
        let refused = |input: usize, rim: &InputRim| refusal(scene, input, rim, arranged, request);
        self.membership_or(rule, open, (is_used, is_part), refused)
    }

    /// The same where models that have no inside contain nothing.
    pub(super) fn membership_of_closed(&self, rule: InsideRule) -> Membership {
        let none = |input, _: &InputRim| Error::invalid(format!("input {input} is open"));
        self.membership_or(rule, OpenInputs::Empty, (|_| true, |_| false), none)
            .expect("open inputs are empty here")
    }

    /// The same with what is refused of an input that is used and has no inside; of a part of a model the inside is found by parity
    /// where its polygons do not agree in direction, as those of a cell whose faces other cells have too.
    pub(super) fn membership_or(
        &self,
        rule: InsideRule,
        open: OpenInputs,
        (is_used, is_part): (impl Fn(usize) -> bool, impl Fn(usize) -> bool),
        refused: impl Fn(usize, &InputRim) -> Error,
    ) -> Result<Membership, Error> {
        let cell_count = self.winding.cell_count();
        // Pairs of a cell and an input that it is inside of.
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        for cell in (0..cell_count).map(CellId::new) {
            let inside = self.winding.inputs_around(cell, rule);
            pairs.extend(inside.map(|input| (cell.to_u32(), input as u32)));
        }
        for (input, rim) in self.rims.iter().enumerate() {
            let Some(rim) = rim else { continue };
            let by_parity =
                rim.is_even() && (rule == InsideRule::Odd || open == OpenInputs::Empty || is_part(input));
            if let Some(parities) = self.parities.as_ref().filter(|_| by_parity) {
                let is_odd = |cell: &u32| parities.number(CellId::from_u32(*cell), input) != 0;
                pairs.extend((0..cell_count as u32).filter(is_odd).map(|cell| (cell, input as u32)));
                continue;
            }
            if open == OpenInputs::Refuse && is_used(input) {
                return Err(refused(input, rim));
            }
        }
        pairs.sort_unstable();
        let mut rest = &pairs[..];
        let mut inputs = RaggedArray::new();
        let mut own = Vec::new();
        for cell in 0..cell_count as u32 {
            let (of_cell, behind) = rest.split_at(rest.partition_point(|pair| pair.0 == cell));
            own.clear();
            own.extend(of_cell.iter().map(|pair| pair.1));
            inputs.push(&own);
            rest = behind;
        }
        Ok(Membership { inputs })
    }
}

/// Says where a model is open.
fn refusal(
    scene: &SpatialScene,
    input: usize,
    rim: &InputRim,
    arranged: &Arranged,
    request: &SpatialRequest,
) -> Error {
    let mut walk = String::new();
    let vertices = rim.walk_vertices(arranged.complex());
    for (i, vertex) in vertices.iter().take(MOST_NAMED).enumerate() {
        let point = arranged.positions().point(VertexId::from_u32(vertex.to_u32()));
        let separator = if i == 0 { "" } else { " - " };
        // Writing to a string does not fail.
        let _ = write!(walk, "{separator}({}, {}, {})", point[0], point[1], point[2]);
    }
    if vertices.len() > MOST_NAMED {
        let _ = write!(walk, " - ... ({} points)", vertices.len());
    }
    let (count, edges) = match rim.ridges().len() {
        1 => ("one edge".to_owned(), "it"),
        count => (format!("{count} edges"), "them"),
    };
    let (fault, cure) = if rim.is_even() {
        (
            format!("polygons do not agree in direction across {count}; a walk along {edges}: {walk}"),
            match scene.pairing_weld(input) {
                Some(radius) => format!(
                    "merge vertices that nearly coincide and count by parity (--weld {radius:.0e} --rule evenodd), or turn polygons so that all agree (coface convert INPUT --repair -o OUT with that --weld)"
                ),
                None => "turn polygons so that all agree (coface convert --orient), or count by parity (--rule evenodd)"
                    .to_owned(),
            },
        )
    } else {
        (
            format!("the surface is not closed: it is open along {count}; a walk along {edges}: {walk}"),
            match scene.closing_weld(input) {
                Some(radius) => format!(
                    "merge vertices that nearly coincide (--weld {radius:.2e}), or close its mouths with patches (--open close)"
                ),
                None => match scene.closing_tolerance(input, request) {
                    Some(tolerance) => format!(
                        "put together what nearly coincides (--tolerance {tolerance:.0e}), or close its mouths with patches (--open close)"
                    ),
                    None => match scene.crack_weld(input) {
                        Some(radius) => format!(
                            "merge vertices that nearly coincide and have mouths closed with patches (--weld {radius:.0e} --open close)"
                        ),
                        None => "close it, or have its mouths closed with patches (--open close)".to_owned(),
                    },
                },
            },
        )
    };
    let steps = vertices.windows(2).map(|step| [step[0].to_u32(), step[1].to_u32()]);
    Error::new(ErrorKind::NotACycle, fault).with_cells(steps).with_cure(cure).in_file(scene.label(input))
}
