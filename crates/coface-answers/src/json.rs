//! The report as JSON.

use super::{Problem, Report};
use coface_algebra::Integer;
use coface_complexes::surface::{SurfaceComponent, SurfaceType};
use coface_topology::AbelianGroup;
use serde_json::{Value, json};

impl Report {
    /// The report as one JSON object with the keys that programs rely on: `dimension`, `f_vector`, `homology`, ...
    ///
    /// `"file"` and `"format"` are for the caller to add. Places of problems are listed up to `limit` for each sort of
    /// problem. `mass` has the inertia about the center for density 1. An area or volume beyond the range of floating point is `null`.
    pub fn to_json(&self, limit: usize) -> Value {
        json!({
            "kind": self.kind.word(),
            "dimension": self.dimension(),
            "f_vector": self.f_vector,
            "top_cells": self.shapes.iter().map(|&(name, count)| json!({"shape": name, "count": count})).collect::<Vec<_>>(),
            "pure": self.pure,
            "components": self.components,
            "euler_characteristic": self.euler_characteristic,
            "manifold": {
                "verdict": self.manifold.word(),
                "closed": self.closed,
                "witness": self.witness.as_ref().map(|witness| json!({
                    "kind": witness.kind,
                    "cells": witness.cells,
                    "message": witness.message,
                })),
            },
            "boundary_loops": self.boundary_loops.as_ref().map(Vec::len),
            "boundary_surface": self.skin.as_ref().map(|skin| json!({
                "faces": skin.face_count,
                "components": skin.components,
                "euler_characteristic": skin.euler_characteristic,
                "manifold": skin.is_manifold,
                "name": skin.name,
            })),
            "orientable": self.orientable,
            "coherently_oriented": self.coherently_oriented,
            "genus": self.surface_type.map(|surface| surface.genus()),
            "name": self.name,
            "surfaces": self.surfaces.iter().map(surface_to_json).collect::<Vec<_>>(),
            "homology": groups_to_json(&self.homology),
            "area": self.area,
            "signed_volume": self.signed_volume,
            "surface_centroid": self.surface_centroid,
            "mass": self.mass.as_ref().map(|mass| json!({
                "volume": mass.volume(),
                "centroid": mass.centroid(),
                "inertia": mass.inertia(),
            })),
            "moments": self.moments.iter().map(|moment| json!({
                "exponents": moment.exponents,
                "volume": moment.volume,
                "surface": moment.surface,
            })).collect::<Vec<_>>(),
            "data": self.data.iter().map(|data| json!({
                "name": data.name(),
                "on": data.kind().to_string(),
                "components": data.components(),
                "type": if data.is_integral() { "integer" } else { "real" },
                "range": data.range(),
            })).collect::<Vec<_>>(),
            "problems": self.problems.iter().map(|problem| problem_to_json(problem, limit)).collect::<Vec<_>>(),
            "warnings": self.warnings,
        })
    }
}

/// Groups of degrees 0, 1, ... as `[{"degree":0,"betti":1,"torsion":[]},..]`.
///
/// A torsion order beyond 64 bits is a string of decimal digits, since JSON readers round such numbers.
pub fn groups_to_json(groups: &[AbelianGroup]) -> Value {
    let group = |(degree, group): (usize, &AbelianGroup)| {
        let torsion: Vec<Value> = group.torsion().iter().map(integer_to_json).collect();
        json!({"degree": degree, "betti": group.betti(), "torsion": torsion})
    };
    groups.iter().enumerate().map(group).collect()
}

/// An integer as a JSON number, or beyond 64 bits as a string of decimal digits.
pub fn integer_to_json(integer: &Integer) -> Value {
    integer.to_i64().map_or_else(|| Value::from(integer.to_string()), Value::from)
}

fn surface_to_json(component: &SurfaceComponent) -> Value {
    let surface = component.surface();
    json!({
        "f_vector": component.f_vector(),
        "euler_characteristic": component.euler_characteristic(),
        "boundary_loops": component.boundary_count(),
        "orientable": surface.map(SurfaceType::is_orientable),
        "genus": surface.map(SurfaceType::genus),
        "name": surface.map(|surface| surface.to_string()),
    })
}

fn problem_to_json(problem: &Problem, limit: usize) -> Value {
    let cells: Vec<&[u32]> = problem.cells().iter().take(limit).collect();
    let tops: Vec<&[u32]> = problem.tops().iter().take(limit).collect();
    json!({
        "kind": problem.kind().word(),
        "count": problem.count(),
        "message": problem.message(),
        "cells": cells,
        "top_cells": tops,
    })
}
