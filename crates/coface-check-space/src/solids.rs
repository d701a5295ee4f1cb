//! The polygons of all inputs with their corners.

use coface_check::{Fault, Surface};

/// The polygons of all inputs, one input after the other.
#[derive(Default)]
pub(crate) struct Solids {
    pub(crate) polygons: Vec<Polygon>,
}

/// The corners of a polygon in order, and the input that it is of.
pub(crate) struct Polygon {
    pub(crate) corners: Vec<[f64; 3]>,
    pub(crate) input: u32,
}

impl Solids {
    pub(crate) fn read(inputs: &[&[u8]]) -> Result<Self, Fault> {
        let fault = |message: String| Fault::new("input", message);
        let mut solids = Self::default();
        for (input, bytes) in (0..).zip(inputs) {
            let surface = Surface::read(bytes)?;
            if !surface.edges.is_empty() {
                return Err(fault("it has edges that bound no polygon".to_owned()));
            }
            for (number, polygon) in surface.polygons.iter().enumerate() {
                let corner = |&point: &u32| surface.points.get(point as usize).copied();
                let corners: Option<Vec<[f64; 3]>> = polygon.iter().map(corner).collect();
                let corners = corners.filter(|corners| corners.as_flattened().iter().all(|x| x.is_finite()));
                let corners = corners
                    .ok_or_else(|| fault(format!("polygon {number} has a corner without coordinates")))?;
                solids.polygons.push(Polygon { corners, input });
            }
        }
        Ok(solids)
    }
}
