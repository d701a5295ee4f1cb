//! Interfaces: phases side by side.

use super::parts::Parts;
use super::sets::filled_component;
use super::{Layer, Scene};
use coface_algebra::{EdgeId, Error, RaggedArray, VertexId};
use coface_answers::{PlanarInterface, PlanarSet};
use coface_io::yin::flattened;
use coface_yin::{Curve, InterfaceGraph, Order};

/// So many types are written beside junctions at most.
const MOST_TYPES: usize = 200;

/// The part of the extent of an interface that its chords keep from its curves.
const FINENESS: f64 = 2e-4;

impl Scene {
    /// The scene of an interface in the plane: its phases filled, each in a color, its edges as fine chords, and its junctions with their types.
    /// Vertices are those of the interface.
    ///
    /// # Errors
    /// Those of [`PlanarInterface::phases`] and [`PlanarInterface::answer`].
    ///
    /// # Complexity
    /// Linear in the chords, but for sorting those of each phase.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_pictures::Scene;
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2, 3, 3])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let scene = Scene::of_interface("labels", &interface)?;
    /// let names: Vec<&str> = scene.layers().iter().map(|layer| layer.name.as_str()).collect();
    /// assert_eq!(names, ["phase 1", "phase 2", "phase 3", "edges", "junctions"]);
    /// # Ok(()) }
    /// ```
    pub fn of_interface(title: &str, interface: &PlanarInterface) -> Result<Self, Error> {
        let graph = interface.graph();
        let vertices: Vec<[f64; 3]> = graph.vertices().iter().copied().map(lift).collect();
        let points: Vec<[u32; 1]> = (0..vertices.len() as u32).map(|vertex| [vertex]).collect();
        let parts = Parts { simplices: RaggedArray::from_lists(points), ..Parts::default() };
        let mut scene = Self::flat(title, vertices, parts);
        let [low, high] = frame_of(graph);
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let tolerance = (FINENESS * extent).max(f64::MIN_POSITIVE);
        let answer = interface.answer(&[], false)?;
        for (number, (phase, facts)) in interface.phases()?.iter().zip(&answer.phases).enumerate() {
            let mut layer = Layer::new("phases", format!("phase {}", facts.name));
            layer.detail = match facts.area {
                Some(area) => format!("area {area:.6}, {} neighbors", facts.neighbors.len()),
                None => "unbounded, shown within a frame".to_owned(),
            };
            layer.is_on = true;
            layer.color = Some(number as u32);
            fill(&mut layer, phase, [low, high], tolerance)?;
            scene.push_layer(layer);
        }
        let mut edges = Layer::new("interface", "edges");
        let mut positions = Vec::new();
        for edge in (0..graph.edge_count()).map(EdgeId::new) {
            let first = positions.len() as u32;
            positions.extend(chords_of(graph.curve(edge), tolerance)?.into_iter().map(lift));
            edges.lines.push(&(first..positions.len() as u32).collect::<Vec<_>>());
        }
        edges.detail = format!("{} of them", graph.edge_count());
        edges.is_on = true;
        edges.positions = Some(positions);
        scene.push_layer(edges);
        let mut junctions = Layer::new("interface", "junctions");
        junctions.points = graph.junctions().map(VertexId::to_u32).collect();
        junctions.detail = format!("{} of them", junctions.points.len());
        junctions.is_on = true;
        if junctions.points.len() <= MOST_TYPES {
            let types = answer.junctions.iter().map(|own| (own.vertex, own.kind.word().to_owned()));
            junctions.labels = types.collect();
        }
        scene.push_layer(junctions);
        Ok(scene)
    }
}

fn lift([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// The points of a curve by fine chords, its end among them.
fn chords_of(curve: &Curve<'_>, tolerance: f64) -> Result<Vec<[f64; 2]>, Error> {
    let end = curve.knot_point(curve.piece_count());
    let mut points = match curve.order() {
        Order::LINEAR => (0..curve.piece_count()).map(|knot| curve.knot_point(knot)).collect(),
        _ => flattened(curve, tolerance)?,
    };
    if points.last() != Some(&end) {
        points.push(end);
    }
    Ok(points)
}

/// The box around the edges, with a margin for phases that are not bounded.
fn frame_of(graph: &InterfaceGraph) -> [[f64; 2]; 2] {
    let boxes = (0..graph.edge_count()).map(|edge| graph.curve(EdgeId::new(edge)).bounding_box());
    let joined = boxes.reduce(|[low, high], [lower, higher]| {
        [[0, 1].map(|axis| low[axis].min(lower[axis])), [0, 1].map(|axis| high[axis].max(higher[axis]))]
    });
    let [low, high] = joined.unwrap_or([[0.0; 2], [1.0; 2]]);
    let margin = 0.15 * (high[0] - low[0]).max(high[1] - low[1]);
    [low.map(|x| x - margin), high.map(|x| x + margin)]
}

/// Fills a layer with the components of a phase, within a frame.
fn fill(
    layer: &mut Layer,
    phase: &PlanarSet,
    [[x, y], [u, v]]: [[f64; 2]; 2],
    tolerance: f64,
) -> Result<(), Error> {
    let set = phase.set();
    let mut chords = Vec::with_capacity(set.curve_count() + 1);
    for number in 0..set.curve_count() {
        let mut points = chords_of(&set.curve(number), tolerance)?;
        points.pop();
        chords.push(points);
    }
    chords.push(vec![[x, y], [u, y], [u, v], [x, v]]);
    let mut atoms: Vec<Vec<usize>> = set.atoms().iter().map(|atom| atom.curves().collect()).collect();
    if set.is_plane() {
        atoms.push(Vec::new());
    }
    let mut positions: Vec<[f64; 3]> = Vec::new();
    for atom in &mut atoms {
        if !atom.first().is_some_and(|&curve| set.is_positive(curve)) {
            atom.insert(0, chords.len() - 1);
        }
        let (points, triangles) = filled_component(atom, &chords);
        let before = positions.len() as u32;
        layer.triangles.extend(triangles.into_iter().map(|corners| corners.map(|corner| corner + before)));
        positions.extend(points);
    }
    layer.positions = Some(positions);
    Ok(())
}
