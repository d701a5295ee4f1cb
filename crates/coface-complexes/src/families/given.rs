//! The values that a family is made with: those that are given, and the usual ones.

use super::{Family, Parameter, ParameterKind, ParameterValue};
use crate::shapes::{CellKind, SphereGrid};

/// Values for the parameters of a family, each of which can be taken.
pub(super) struct Given<'a> {
    pub(super) family: &'static Family,
    pub(super) values: &'a [(&'a str, ParameterValue)],
}

impl Given<'_> {
    fn value(&self, name: &str) -> Option<&ParameterValue> {
        self.values.iter().find(|(given, _)| *given == name).map(|(_, value)| value)
    }

    fn kind(&self, name: &str) -> ParameterKind {
        self.family.parameter(name).map(Parameter::kind).expect("a rule reads the parameters of its family")
    }

    pub(super) fn real(&self, name: &str) -> f64 {
        match (self.value(name), self.kind(name)) {
            (Some(ParameterValue::Real(value)), _) => *value,
            (_, ParameterKind::Real { usual }) => usual,
            _ => unreachable!("a rule reads a parameter as what it is"),
        }
    }

    /// A count that has a usual value.
    pub(super) fn count(&self, name: &str) -> u32 {
        self.count_if_given(name).expect("a count without a usual value is read as what it is")
    }

    /// A count, or its usual value if it has one.
    pub(super) fn count_if_given(&self, name: &str) -> Option<u32> {
        match (self.value(name), self.kind(name)) {
            (Some(ParameterValue::Count(value)), _) => Some(*value),
            (_, ParameterKind::Count { usual, .. }) => usual,
            _ => unreachable!("a rule reads a parameter as what it is"),
        }
    }

    pub(super) fn counts(&self, name: &str) -> Vec<u32> {
        match (self.value(name), self.kind(name)) {
            (Some(ParameterValue::Counts(values)), _) => values.clone(),
            (_, ParameterKind::Counts { usual }) => usual.to_vec(),
            _ => unreachable!("a rule reads a parameter as what it is"),
        }
    }

    pub(super) fn reals(&self, name: &str) -> Vec<f64> {
        match (self.value(name), self.kind(name)) {
            (Some(ParameterValue::Reals(values)), _) => values.clone(),
            (_, ParameterKind::Reals { usual }) => usual.to_vec(),
            _ => unreachable!("a rule reads a parameter as what it is"),
        }
    }

    pub(super) fn integers(&self, name: &str) -> Vec<i64> {
        match (self.value(name), self.kind(name)) {
            (Some(ParameterValue::Integers(values)), _) => values.clone(),
            (_, ParameterKind::Integers { usual }) => usual.to_vec(),
            _ => unreachable!("a rule reads a parameter as what it is"),
        }
    }

    pub(super) fn flag(&self, name: &str) -> bool {
        debug_assert_eq!(self.kind(name), ParameterKind::Flag);
        self.value(name) == Some(&ParameterValue::Flag(true))
    }

    pub(super) fn choice(&self, name: &str) -> Option<&str> {
        match (self.value(name), self.kind(name)) {
            (Some(ParameterValue::Choice(word)), _) => Some(word),
            (_, ParameterKind::Choice { usual, .. }) => usual,
            _ => unreachable!("a rule reads a parameter as what it is"),
        }
    }

    pub(super) fn words(&self, name: &str) -> &[Vec<i32>] {
        match self.value(name) {
            Some(ParameterValue::Words(words)) => words,
            _ => &[],
        }
    }

    /// Whether a value was given.
    pub(super) fn has(&self, name: &str) -> bool {
        self.value(name).is_some()
    }

    /// Which cells to make.
    pub(super) fn cells(&self) -> CellKind {
        if self.flag("cuboids") { CellKind::Cuboid } else { CellKind::Simplex }
    }

    /// The grid on a sphere; without a kind, the one that has the cells asked for.
    pub(super) fn sphere(&self) -> SphereGrid {
        let usual = if self.cells() == CellKind::Cuboid { "cube" } else { "ico" };
        let subdivisions = self.count("subdivisions");
        match self.choice("kind").unwrap_or(usual) {
            "latitude" => {
                SphereGrid::Latitude { meridians: self.count("meridians"), bands: self.count("bands") }
            }
            "cube" => SphereGrid::Cube { subdivisions },
            _ => SphereGrid::Icosahedron { subdivisions },
        }
    }
}
