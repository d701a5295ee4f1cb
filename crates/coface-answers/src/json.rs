//! Groups and integers as JSON.

use coface_algebra::Integer;
use coface_topology::AbelianGroup;
use serde_json::{Value, json};

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
