//! Interfaces: phases that share the edges between them, as `coface yin interface` writes them.

use crate::yin::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::{Remark, RemarkCode};
use coface_algebra::{EdgeId, Error};
use coface_geometry::Positions;
use coface_yin::{Curve, DirectedEdge, InterfaceGraph, Order, YinSet};
use serde::Deserialize;
use serde_json::Value;

/// What an object says about an interface.
#[derive(Default)]
pub(super) struct InterfaceKeys {
    pub(super) phases: Option<Value>,
    pub(super) edges: Option<Value>,
    pub(super) smooth_pairs: Option<Value>,
    pub(super) has_junctions: bool,
}

#[derive(Deserialize)]
struct Phase {
    name: String,
}

#[derive(Deserialize)]
struct Edge {
    ends: [u32; 2],
    left: Option<u32>,
    right: Option<u32>,
    knots: Option<Vec<f64>>,
    controls: Option<Vec<[f64; 2]>>,
}

/// An interface, not yet checked.
pub(super) struct Interface {
    order: Option<u64>,
    vertices: Vec<[f64; 2]>,
    phases: Vec<Phase>,
    edges: Vec<Edge>,
    smooth_pairs: Vec<[(u32, i8); 2]>,
}

fn none(what: &str) -> Error {
    Error::parse(format!("the object is an interface of regions, but {what}"))
        .with_cure("give the file that coface yin interface -o FILE.json writes")
}

impl InterfaceKeys {
    /// The interface, if the keys are there that make an object one.
    pub(super) fn into_interface(
        self,
        order: Option<u64>,
        positions: Option<Positions>,
    ) -> Option<Result<Interface, Error>> {
        let (Some(phases), true) = (self.phases, self.has_junctions) else { return None };
        Some((|| {
            let fault =
                |what: &'static str| move |error: serde_json::Error| none(&format!("{what}: {error}"));
            let positions = positions.filter(|own| own.dimension() == 2);
            Ok(Interface {
                order,
                vertices: positions.map(|own| own.as_flat().as_chunks::<2>().0.to_vec()).unwrap_or_default(),
                phases: serde_json::from_value(phases).map_err(fault("its phases cannot be read"))?,
                edges: match self.edges {
                    Some(edges) => {
                        serde_json::from_value(edges).map_err(fault("its edges cannot be read"))?
                    }
                    None => return Err(none("it has no edges")),
                },
                smooth_pairs: match self.smooth_pairs {
                    Some(Value::Null) | None => Vec::new(),
                    Some(pairs) => {
                        serde_json::from_value(pairs).map_err(fault("its smooth pairs cannot be read"))?
                    }
                },
            })
        })())
    }
}

impl Interface {
    fn graph(&self) -> Result<(InterfaceGraph, Order), Error> {
        let order = self.order.and_then(|order| usize::try_from(order).ok());
        let order = order.map(Order::new).transpose()?.ok_or_else(|| none("its order is not said"))?;
        let mut curves = Vec::with_capacity(self.edges.len());
        for (number, edge) in self.edges.iter().enumerate() {
            let (Some(controls), Some(knots)) = (edge.controls.clone(), edge.knots.clone()) else {
                return Err(none("its edges have no control points"));
            };
            let curve = Curve::from_controls(order, controls, knots);
            curves.push(curve.map_err(|error| none(&format!("edge {number}: {}", error.message())))?);
        }
        let sides = |edge: &Edge| [edge.left, edge.right];
        let known = self.phases.len();
        if let Some(phase) =
            self.edges.iter().flat_map(sides).flatten().find(|&phase| phase as usize >= known)
        {
            return Err(none(&format!("an edge bounds phase {phase}, and there are {known}, from 0")));
        }
        let directed = |&(edge, sign): &(u32, i8)| match sign {
            1 => Ok(DirectedEdge::along(EdgeId::new(edge as usize))),
            -1 => Ok(DirectedEdge::against(EdgeId::new(edge as usize))),
            _ => Err(none(&format!("the direction of edge {edge} in a smooth pair is {sign}"))),
        };
        let pairs: Vec<[DirectedEdge; 2]> = self
            .smooth_pairs
            .iter()
            .map(|[from, to]| Ok([directed(from)?, directed(to)?]))
            .collect::<Result<_, Error>>()?;
        let ends: Vec<[u32; 2]> = self.edges.iter().map(|edge| edge.ends).collect();
        let phases: Vec<[Option<u32>; 2]> = self.edges.iter().map(sides).collect();
        Ok((InterfaceGraph::from_curves(&self.vertices, &ends, &phases, curves, &pairs, order)?, order))
    }

    /// The phase of a name, or of a number from 0 if none has that name.
    fn number_of(&self, wanted: &str) -> Result<u32, Error> {
        let named = self.phases.iter().position(|phase| phase.name == wanted);
        let number =
            named.or_else(|| wanted.parse().ok().filter(|&number: &usize| number < self.phases.len()));
        number.map(|number| number as u32).ok_or_else(|| {
            let names: Vec<String> =
                self.phases.iter().take(16).map(|phase| format!("\"{}\"", phase.name)).collect();
            let dots = if self.phases.len() > 16 { ", .." } else { "" };
            Error::invalid(format!("there is no phase \"{wanted}\"")).with_cure(match self.phases.len() {
                0 => "give another file: this interface has no phases".to_owned(),
                count => {
                    format!("name one of {}{dots}, or a number from 0 to {}", names.join(", "), count - 1)
                }
            })
        })
    }

    /// A phase as the boundary of a set.
    pub(super) fn phase(&self, wanted: &str) -> Result<BoundaryDrawing, Error> {
        let number = self.number_of(wanted)?;
        let (graph, order) = self.graph()?;
        let mut drawing = BoundaryDrawing::new(order);
        if graph.phases().contains(&number) {
            self.push(&mut drawing, number, &graph.phase_set(number)?);
        }
        Ok(drawing)
    }

    /// All phases, each a polygon; those that are not bounded are left out.
    pub(super) fn phases(&self) -> Result<BoundaryDrawing, Error> {
        let (graph, order) = self.graph()?;
        let mut drawing = BoundaryDrawing::new(order);
        for number in graph.phases() {
            let set = graph.phase_set(number)?;
            if set.is_bounded() {
                self.push(&mut drawing, number, &set);
                continue;
            }
            let name = &self.phases[number as usize].name;
            let message =
                format!("the phase \"{name}\" is not bounded, which no model holds, and is left out");
            drawing.remark(Remark::new(RemarkCode::ElementsLeftOut, message));
        }
        Ok(drawing)
    }

    fn push(&self, drawing: &mut BoundaryDrawing, number: u32, set: &YinSet) {
        let curve = |curve: usize| {
            let own = set.curve(curve);
            let points = (0..own.piece_count()).map(|knot| own.knot_point(knot)).collect();
            let mut found = BoundaryCurve::new(points);
            found.set_name(Some(self.phases[number as usize].name.clone()).filter(|name| !name.is_empty()));
            found.set_kinks(set.kinks().on_curve(curve as u32).collect());
            if set.order() > Order::LINEAR {
                found.set_curve(own.into_owned());
            } else {
                found.set_knots(own.knots().to_vec());
            }
            found
        };
        if set.curve_count() > 0 {
            drawing.push(Filling::Left, (0..set.curve_count()).map(curve).collect());
        }
    }
}
