//! Combinations of many solids that cover each other, some at a time: what is inside of a part of the result is left out before it
//! meets the rest. Nothing is rounded between.

use super::arranged::{Arranged, Origins};
use super::inputs::Inputs;
use super::scene_arrangement::ResultSurface;
use super::{SceneArrangement, SolidRequest, SpatialRequest, SpatialScene};
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::{Steps, stage};
use coface_algebra::{CellId, Error, ErrorKind, FaceId, Sign};
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_arrange::CoordinatePrecision;
use coface_arrange::boolean::{BooleanFormula, CellSelection, FormulaTree, InsideRule, TreeOperator};
use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface_geometry::{AxisBox, BoxTree, Positions};
use rayon::prelude::*;
use std::sync::Arc;

/// So many operands are arranged at a time.
const WIDTH: usize = 8;
/// Fewer operands are arranged at once.
const LEAST_OPERANDS: usize = 16;
/// Operands cover each other enough if so many boxes of others lie over a place in the box of one, on average.
const LEAST_COVER: f64 = 8.0;

impl SceneArrangement {
    /// An arrangement that a request is answered from. Where many operands of a union or an intersection cover each other, they are
    /// combined some at a time, exactly, and the arrangement has what is left of them: it answers no other request. Else it
    /// is as [`Self::of_scene`].
    ///
    /// # Errors
    /// As [`Self::of_scene`].
    ///
    /// # Complexity
    /// For n solids of m triangles, k of them over each place: $O(nm \log^2 nm)$ where nearly all of them is inside, which does not
    /// depend on k; all at once it is $O(nmk \log nmk)$ and what they cut each other into.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialScene};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // Cubes above each other, each 1/32 higher than the one before.
    /// let cube = |i: u32| {
    ///     let mut text = String::new();
    ///     for bits in 0..8 {
    ///         let [x, y, z] = [0, 1, 2].map(|axis| f64::from(bits >> axis & 1));
    ///         text += &format!("v {x} {y} {}\n", z + f64::from(i) / 32.0);
    ///     }
    ///     text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    ///     coface_io::read(text.as_bytes(), coface_io::Format::Obj)
    /// };
    /// let cubes = (0..20).map(cube).collect::<Result<Vec<_>, _>>()?;
    /// let scene = SpatialScene::of(cubes.iter().map(|own| ("cube", own)), true)?;
    /// let request = SolidRequest::of(BooleanFormula::union(20));
    /// let arranged = SceneArrangement::for_result(scene, &Default::default(), &request)?;
    /// let union = SolidBoolean::of(&arranged, &request)?;
    /// assert_eq!(union.volume(), Some(1.0 + 19.0 / 32.0));
    /// # Ok(()) }
    /// ```
    pub fn for_result(
        scene: SpatialScene,
        request: &SpatialRequest,
        solid: &SolidRequest,
    ) -> Result<Self, Error> {
        if let Some(cascade) = Cascade::new(&scene, request, solid)
            && let Some((arranged, operands, selection, inputs)) = cascade.result()?
        {
            let cell_count = selection.cells().count();
            let surface =
                ResultSurface { request: solid.clone(), selection, cell_count, operands: Some(operands) };
            return Ok(Self::of_surface(scene, arranged, inputs, *request, surface));
        }
        Self::of_scene(scene, request)
    }
}

/// The polygons of some inputs, or of a combination of some.
struct Group {
    polygons: SpatialPolygons,
    origins: Origins,
    /// The middle of its box, doubled.
    middle: [f64; 3],
    is_input: bool,
}

/// What stands in a formula for something that has been combined.
enum Operand {
    Group(Box<Group>),
    Operation(TreeOperator, Vec<Operand>),
}

/// Why operands are not combined some at a time.
enum Halt {
    /// All of them must be arranged at once, for what is to be said of them.
    AllAtOnce,
    Failed(Error),
}

impl From<Error> for Halt {
    fn from(error: Error) -> Self {
        match error.kind() {
            // What it says is about some inputs alone.
            ErrorKind::InvalidInput | ErrorKind::NotACycle | ErrorKind::UnsupportedFormat => Self::AllAtOnce,
            _ => Self::Failed(error),
        }
    }
}

struct Cascade<'a> {
    scene: &'a SpatialScene,
    request: &'a SpatialRequest,
    solid: &'a SolidRequest,
    tree: FormulaTree,
    polygons_of_input: RaggedArray,
}

/// A combination of some groups.
struct Combined {
    arrangement: SpatialArrangement,
    complex: ChainComplex,
    operands: Operands,
    selection: CellSelection,
    origins: Origins,
}

/// What is left of a formula where the inputs of an arrangement are combinations of others.
#[derive(Clone, Debug)]
pub(super) struct Operands {
    formula: BooleanFormula,
    /// The inputs of the arrangement that the operands of the formula are; none for empty ones.
    columns: Vec<Option<usize>>,
}

impl Operands {
    fn selection(&self, inputs: &Inputs, cell_count: usize, rule: InsideRule) -> CellSelection {
        let membership = inputs.membership_of_closed(rule);
        let is_inside =
            |cell, operand: usize| self.columns[operand].is_some_and(|own| membership.is_inside(cell, own));
        CellSelection::by_membership(cell_count, &self.formula, is_inside)
    }

    /// The cells for which the formula holds in an arrangement of the same inputs, which has these chains of faces.
    pub(super) fn selection_of(
        &self,
        complex: &ChainComplex,
        chains: &SparseMatrix,
        rule: InsideRule,
    ) -> Result<CellSelection, Error> {
        let inputs = Inputs::of_chains(chains.column_count(), complex, chains)?;
        Ok(self.selection(&inputs, complex.cell_count(3), rule))
    }
}

impl<'a> Cascade<'a> {
    /// Whether the request is for one that can be made some operands at a time, and its operands cover each other.
    fn new(scene: &'a SpatialScene, request: &'a SpatialRequest, solid: &'a SolidRequest) -> Option<Self> {
        let count = scene.names().len();
        let is_plain = request.tolerance.is_none()
            && !request.snap
            && request.precision == CoordinatePrecision::Double
            && !solid.keep_walls
            && scene.first_patch.is_none()
            && scene.mouths.iter().all(Option::is_none)
            && scene.surfaces.iter().all(Vec::is_empty)
            && !scene.is_wall.contains(&true);
        if count < LEAST_OPERANDS || solid.formula.input_count() > count || !is_plain {
            return None;
        }
        let tree = FormulaTree::of(&solid.formula)?;
        let mut named = tree.inputs();
        named.sort_unstable();
        if !named.into_iter().eq(0..count) || has_complement(&tree) || widest(&tree) < LEAST_OPERANDS {
            return None;
        }
        let polygons_of_input = RaggedArray::grouped(count, scene.input_of_polygon.iter().copied());
        let cascade = Self { scene, request, solid, tree, polygons_of_input };
        (cascade.cover() >= LEAST_COVER).then_some(cascade)
    }

    /// How many boxes of other inputs lie over a place in the box of one, on average.
    fn cover(&self) -> f64 {
        let boxes: Vec<AxisBox> =
            (0..self.scene.names().len()).into_par_iter().map(|input| self.box_of(input)).collect();
        let volume = |own: &AxisBox| own.iter().map(|[low, high]| (high - low).max(0.0)).product::<f64>();
        let all: f64 = boxes.iter().map(volume).sum();
        let tree = BoxTree::new(&boxes);
        let common = |a: &AxisBox, b: &AxisBox| {
            [0, 1, 2].map(|axis| [a[axis][0].max(b[axis][0]), a[axis][1].min(b[axis][1])])
        };
        let of_group = |group: usize| {
            let mut sum = 0.0;
            tree.pairs_of_group(group, |a, b| sum += volume(&common(&boxes[a as usize], &boxes[b as usize])));
            sum
        };
        let shared: f64 = (0..tree.group_count()).map(of_group).sum();
        if all > 0.0 { 2.0 * shared / all } else { 0.0 }
    }

    fn box_of(&self, input: usize) -> AxisBox {
        let points = self.scene.flat.as_chunks::<3>().0;
        let own = self.polygons_of_input.list(input).iter();
        box_around(own.flat_map(|&polygon| self.walks_of(polygon).flatten()).map(|&v| points[v as usize]))
    }

    fn walks_of(&self, polygon: u32) -> impl Iterator<Item = &'a [u32]> {
        let of_walk = &self.scene.polygon_of_walk;
        let first = of_walk.partition_point(|&own| own < polygon);
        let last = of_walk.partition_point(|&own| own <= polygon);
        let walks = &self.scene.walks;
        (first..last).map(move |walk| walks.list(walk))
    }

    /// The last arrangement, what is left of the formula, the cells of the result, and the inputs, which are all closed; none if all
    /// inputs must be arranged at once.
    fn result(&self) -> Result<Option<(Arranged, Operands, CellSelection, Inputs)>, Error> {
        let steps = stage("combining solids", self.scene.names().len());
        let made = self.operand(&self.tree, &steps).and_then(|whole| self.combined(whole));
        drop(steps);
        let made = match made {
            Ok(made) => made,
            Err(Halt::AllAtOnce) => return Ok(None),
            Err(Halt::Failed(error)) => return Err(error),
        };
        let count = self.scene.names().len();
        let inputs = Inputs::of_closed(count, &made.complex)?;
        let arranged = Arranged::of_operands(made.arrangement, made.complex, count, made.origins)?;
        Ok(Some((arranged, made.operands, made.selection, inputs)))
    }

    /// A part of the formula, of which unions and intersections have few operands left.
    fn operand(&self, tree: &FormulaTree, steps: &Steps) -> Result<Operand, Halt> {
        let (operator, operands) = match tree {
            FormulaTree::Input(input) => return Ok(Operand::Group(Box::new(self.group_of_input(*input)?))),
            FormulaTree::Complement(_) => return Err(Halt::AllAtOnce),
            FormulaTree::Operation(operator, operands) => (*operator, operands),
        };
        let mut operands: Vec<Operand> =
            operands.iter().map(|own| self.operand(own, steps)).collect::<Result<_, _>>()?;
        match operator {
            TreeOperator::Union | TreeOperator::Intersection => {
                operands = self.reduced(operator, operands, steps)?;
            }
            TreeOperator::Difference => {
                let others = operands.split_off(1);
                operands.extend(self.reduced(TreeOperator::Union, others, steps)?);
            }
            TreeOperator::Xor => {}
        }
        Ok(Operand::Operation(operator, operands))
    }

    /// Combines operands that are near each other until few are left.
    fn reduced(
        &self,
        operator: TreeOperator,
        mut operands: Vec<Operand>,
        steps: &Steps,
    ) -> Result<Vec<Operand>, Halt> {
        while operands.len() > WIDTH {
            let (count, lots) = (operands.len(), operands.len().div_ceil(WIDTH));
            let mut rest = order_along_curve(operands).into_iter();
            let lots: Vec<Vec<Operand>> = (0..lots)
                .map(|lot| rest.by_ref().take(count * (lot + 1) / lots - count * lot / lots).collect())
                .collect();
            let combine = |lot: Vec<Operand>| {
                let inputs = lot.iter().filter(|own| own.is_input()).count();
                let made = self.combined(Operand::Operation(operator, lot))?.group()?;
                steps.advance(inputs);
                Ok(Operand::Group(Box::new(made)))
            };
            let made: Vec<Result<Operand, Halt>> = lots.into_par_iter().map(combine).collect();
            operands = made.into_iter().collect::<Result<_, _>>()?;
        }
        Ok(operands)
    }

    fn group_of_input(&self, input: usize) -> Result<Group, Halt> {
        let own = self.polygons_of_input.list(input);
        let is_exact = own.first().and_then(|first| self.scene.exact.iter().find(|exact| exact.0 == *first));
        let polygons = match is_exact {
            Some((_, exact)) => SpatialPolygons::from_exact(Arc::clone(exact))?,
            None => {
                let mut vertices: Vec<u32> =
                    own.iter().flat_map(|&polygon| self.walks_of(polygon).flatten().copied()).collect();
                vertices.sort_unstable();
                vertices.dedup();
                let point = |&vertex: &u32| &self.scene.flat[3 * vertex as usize..][..3];
                let flat: Vec<f64> = vertices.iter().flat_map(point).copied().collect();
                let (mut walks, mut polygon_of_walk) = (RaggedArray::new(), Vec::new());
                let mut moved = Vec::new();
                for (&polygon, number) in own.iter().zip(0..) {
                    for walk in self.walks_of(polygon) {
                        moved.clear();
                        moved.extend(walk.iter().map(|v| vertices.partition_point(|other| other < v) as u32));
                        walks.push(&moved);
                        polygon_of_walk.push(number);
                    }
                }
                SpatialPolygons::new(Positions::from_flat(3, flat)?, walks, polygon_of_walk)?
            }
        };
        let origins = Origins::of_whole(own);
        let middle = middle_of(polygons.positions().as_flat().as_chunks::<3>().0.iter().copied());
        Ok(Group { polygons, origins, middle, is_input: true })
    }

    /// Arranges the groups of an operand and finds the cells in it.
    fn combined(&self, operand: Operand) -> Result<Combined, Halt> {
        let mut groups = Vec::new();
        let formula = tree_of(operand, &mut groups).to_formula();
        let has_inputs = groups.iter().any(|group| group.is_input);
        // Groups without polygons are no inputs of the arrangement.
        let mut columns = Vec::new();
        let mut column_count = 0;
        for group in &groups {
            let is_there = group.polygons.polygon_count() > 0;
            columns.push(is_there.then_some(column_count));
            column_count += usize::from(is_there);
        }
        if column_count == 0 {
            return Err(Halt::AllAtOnce);
        }
        let mut origins = Origins::default();
        let mut lots = Vec::with_capacity(groups.len());
        for group in groups {
            origins.append(group.origins);
            lots.push(group.polygons);
        }
        let options = SpatialOptions::new()
            .non_planar(self.request.non_planar)
            // In combinations of others all faces in one plane would be of one input.
            .merge_coplanar(self.request.merge_coplanar && has_inputs)
            .max_cells(self.request.max_cells);
        let arrangement = SpatialArrangement::new(&SpatialPolygons::joined(&lots)?, &options)?;
        drop(lots);
        let split = arrangement.split_polygons();
        if split.iter().any(|own| !self.solid.triangles || !own.is_rounding()) {
            return Err(Halt::AllAtOnce);
        }
        origins.add_notes(arrangement.polygons_without_area(), split);
        let (complex, chains) = (arrangement.coarse_complex()?, arrangement.input_chains()?);
        let inputs = Inputs::of_chains(column_count, &complex, &chains)?;
        if !inputs.are_plain() {
            return Err(Halt::AllAtOnce);
        }
        let operands = Operands { formula, columns };
        let selection = operands.selection(&inputs, complex.cell_count(3), self.solid.rule);
        Ok(Combined { arrangement, complex, operands, selection, origins })
    }
}

impl Combined {
    /// The surface around the cells that are in it.
    fn group(self) -> Result<Group, Error> {
        let Self { arrangement, complex, selection, mut origins, .. } = self;
        let boundary = selection.boundary_without_pinches(&complex)?;
        let face = |&(face, sign): &(CellId, Sign)| (FaceId::from_u32(face.to_u32()), sign);
        let surface: Vec<(FaceId, Sign)> = boundary.facets().iter().map(face).collect();
        let (exact, places) = arrangement.exact_faces(&surface);
        origins.polygons = RaggedArray::from_lists(places.iter().map(|&place| {
            let (face, sign) = surface[place as usize];
            origins.of_polygons(arrangement.polygons_of_face(face), sign)
        }));
        let polygons = SpatialPolygons::from_exact(Arc::new(exact))?;
        let middle = middle_of(polygons.positions().as_flat().as_chunks::<3>().0.iter().copied());
        Ok(Group { polygons, origins, middle, is_input: false })
    }
}

impl Operand {
    /// Where it is, for groups the middle of their boxes.
    fn middle(&self) -> [f64; 3] {
        match self {
            Self::Group(group) => group.middle,
            Self::Operation(_, operands) => operands.first().map_or([0.0; 3], Self::middle),
        }
    }

    fn is_input(&self) -> bool {
        matches!(self, Self::Group(group) if group.is_input)
    }
}

/// The middle of the box around some points, doubled.
fn middle_of(points: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    box_around(points).map(|[low, high]| low + high)
}

fn box_around(points: impl Iterator<Item = [f64; 3]>) -> AxisBox {
    points.fold([[f64::INFINITY, f64::NEG_INFINITY]; 3], |own, point| {
        [0, 1, 2].map(|axis| [own[axis][0].min(point[axis]), own[axis][1].max(point[axis])])
    })
}

/// Operands that are near each other stand near each other.
fn order_along_curve(operands: Vec<Operand>) -> Vec<Operand> {
    let middles: Vec<AxisBox> = operands.iter().map(|own| own.middle().map(|x| [x, x])).collect();
    let tree = BoxTree::new(&middles);
    let mut operands: Vec<Option<Operand>> = operands.into_iter().map(Some).collect();
    tree.order().iter().filter_map(|&place| operands[place as usize].take()).collect()
}

/// An operand as a tree over groups, which are added to those that there are.
fn tree_of(operand: Operand, groups: &mut Vec<Group>) -> FormulaTree {
    match operand {
        Operand::Group(group) => {
            groups.push(*group);
            FormulaTree::Input(groups.len() - 1)
        }
        Operand::Operation(operator, operands) => {
            let operands = operands.into_iter().map(|own| tree_of(own, groups)).collect();
            FormulaTree::Operation(operator, operands)
        }
    }
}

fn has_complement(tree: &FormulaTree) -> bool {
    match tree {
        FormulaTree::Input(_) => false,
        FormulaTree::Complement(_) => true,
        FormulaTree::Operation(_, operands) => operands.iter().any(has_complement),
    }
}

/// The most operands that can be combined some at a time.
fn widest(tree: &FormulaTree) -> usize {
    match tree {
        FormulaTree::Input(_) | FormulaTree::Complement(_) => 0,
        FormulaTree::Operation(operator, operands) => {
            let own = if *operator == TreeOperator::Xor { 0 } else { operands.len() };
            operands.iter().map(widest).max().unwrap_or(0).max(own)
        }
    }
}
