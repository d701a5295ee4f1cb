//! The families and how they are made.

use super::given::Given;
use super::shape_table::SHAPES;
use super::space_table::SPACES;
use super::{FamilyModel, Parameter, ParameterValue};
use crate::shapes::PlacedCells;
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;
use std::fmt;

/// A family of models: a name, parameters, and a rule.
///
/// # Examples
/// ```
/// use coface_complexes::families::{Family, FamilyModel, ParameterValue};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = Family::named("torus").expect("there is a torus");
/// let made = torus.make(&[("columns", ParameterValue::Count(8)), ("rows", ParameterValue::Count(6))])?;
/// let FamilyModel::Cells(cells) = made else { panic!("a torus has positions") };
/// assert_eq!(cells.cell_count(), 2 * 8 * 6);
/// # Ok(()) }
/// ```
pub struct Family {
    name: &'static str,
    aliases: &'static [&'static str],
    about: &'static str,
    parameters: &'static [Parameter],
    rule: Rule,
}

enum Rule {
    Cells(fn(&Given<'_>) -> Result<PlacedCells, Error>),
    Complex(fn(&Given<'_>) -> Result<SimplicialComplex, Error>),
}

impl Family {
    pub(super) const fn shape(
        name: &'static str,
        about: &'static str,
        parameters: &'static [Parameter],
        rule: fn(&Given<'_>) -> Result<PlacedCells, Error>,
    ) -> Self {
        Self { name, aliases: &[], about, parameters, rule: Rule::Cells(rule) }
    }

    pub(super) const fn space(
        name: &'static str,
        about: &'static str,
        parameters: &'static [Parameter],
        rule: fn(&Given<'_>) -> Result<SimplicialComplex, Error>,
    ) -> Self {
        Self { name, aliases: &[], about, parameters, rule: Rule::Complex(rule) }
    }

    /// All families: shapes with positions, then known spaces without.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// assert!(Family::all().any(|family| family.name() == "torus"));
    /// ```
    pub fn all() -> impl Iterator<Item = &'static Self> {
        SHAPES.iter().chain(SPACES)
    }

    /// With other names that people know it by.
    pub(super) const fn also(mut self, aliases: &'static [&'static str]) -> Self {
        self.aliases = aliases;
        self
    }

    /// The family of this name, or of this other name.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// assert!(Family::named("klein").is_some() && Family::named("donut").is_none());
    /// assert_eq!(Family::named("cube").map(Family::name), Some("box"));
    /// ```
    pub fn named(name: &str) -> Option<&'static Self> {
        Self::all().find(|family| family.name == name || family.aliases.contains(&name))
    }

    /// Other names of it, which [`Family::named`] takes too.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// assert_eq!(Family::named("ring").map(Family::aliases), Some(&["annulus"][..]));
    /// ```
    pub fn aliases(&self) -> &'static [&'static str] {
        self.aliases
    }

    /// The name, with `-` between its words.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// assert_eq!(Family::named("solid-torus").map(|family| family.name()), Some("solid-torus"));
    /// ```
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// What it is, as one line without a period.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// assert_eq!(Family::named("circle").map(|family| family.about()), Some("A circle in the plane"));
    /// ```
    pub fn about(&self) -> &'static str {
        self.about
    }

    /// The parameters.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// let circle = Family::named("circle").expect("there is a circle");
    /// let names: Vec<&str> = circle.parameters().iter().map(|parameter| parameter.name()).collect();
    /// assert_eq!(names, ["radius", "segments"]);
    /// ```
    pub fn parameters(&self) -> &'static [Parameter] {
        self.parameters
    }

    pub(super) fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.parameters.iter().find(|parameter| parameter.name() == name)
    }

    /// Whether what it makes has positions.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// assert!(Family::named("klein").is_some_and(|family| family.has_positions()));
    /// assert!(Family::named("small-klein").is_some_and(|family| !family.has_positions()));
    /// ```
    pub fn has_positions(&self) -> bool {
        matches!(self.rule, Rule::Cells(_))
    }

    /// The member with these values; parameters that are not given have their usual ones.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a parameter that the family does not have, or a value
    /// that cannot be taken, and the errors of the function that makes it.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::{Family, FamilyModel, ParameterValue};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let lens = Family::named("lens").expect("there are lens spaces");
    /// let made = lens.make(&[("p", ParameterValue::Count(7)), ("q", ParameterValue::Count(3))])?;
    /// assert!(matches!(made, FamilyModel::Complex(complex) if complex.dimension() == Some(3)));
    /// assert!(lens.make(&[("r", ParameterValue::Count(7))]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn make(&'static self, values: &[(&str, ParameterValue)]) -> Result<FamilyModel, Error> {
        for (name, value) in values {
            let Some(parameter) = self.parameter(name) else {
                let names: Vec<&str> = self.parameters.iter().map(Parameter::name).collect();
                let cure = match names.is_empty() {
                    true => "it has no parameters".to_owned(),
                    false => format!("its parameters are {}", names.join(", ")),
                };
                return Err(Error::invalid(format!("{} has no parameter {name}", self.name)).with_cure(cure));
            };
            if let Some((fault, cure)) = parameter.fault(value) {
                return Err(Error::invalid(format!("{}: {fault}", self.name)).with_cure(cure));
            }
        }
        let given = Given { family: self, values };
        match self.rule {
            Rule::Cells(rule) => rule(&given).map(FamilyModel::Cells),
            Rule::Complex(rule) => rule(&given).map(FamilyModel::Complex),
        }
    }
}

impl fmt::Debug for Family {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Family").field("name", &self.name).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::super::ParameterKind;
    use super::*;

    /// The value that a parameter has when it is not given.
    fn usual(parameter: &Parameter) -> Option<ParameterValue> {
        Some(match parameter.kind() {
            ParameterKind::Real { usual } => ParameterValue::Real(usual),
            ParameterKind::Count { usual, .. } => ParameterValue::Count(usual?),
            ParameterKind::Counts { usual } => ParameterValue::Counts(usual.to_vec()),
            ParameterKind::Reals { usual } => ParameterValue::Reals(usual.to_vec()),
            ParameterKind::Integers { usual } => ParameterValue::Integers(usual.to_vec()),
            ParameterKind::Flag => ParameterValue::Flag(false),
            ParameterKind::Choice { usual, .. } => ParameterValue::Choice(usual?.to_owned()),
            ParameterKind::Words => ParameterValue::Words(Vec::new()),
        })
    }

    fn summary(made: &FamilyModel) -> (Vec<f64>, usize) {
        match made {
            FamilyModel::Cells(cells) => (cells.positions().as_flat().to_vec(), cells.cell_count()),
            FamilyModel::Complex(complex) => (Vec::new(), complex.facets().len()),
        }
    }

    #[test]
    fn every_family_is_made_with_its_usual_values() {
        let mut names = Vec::new();
        for family in Family::all() {
            names.push(family.name());
            let made = family.make(&[]).unwrap_or_else(|error| panic!("{}: {error}", family.name()));
            let values: Vec<(&str, ParameterValue)> = family
                .parameters()
                .iter()
                .filter_map(|parameter| Some((parameter.name(), usual(parameter)?)))
                .collect();
            assert_eq!(summary(&family.make(&values).unwrap()), summary(&made), "{}", family.name());
            assert_eq!(family.has_positions(), matches!(made, FamilyModel::Cells(_)));
        }
        assert_eq!(names.len(), 55);
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), 55, "names are unique");
    }

    #[test]
    fn other_names_are_of_one_family() {
        let mut names: Vec<&str> = Family::all().flat_map(|family| family.aliases()).copied().collect();
        let count = names.len();
        names.extend(Family::all().map(Family::name));
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), 55 + count);
        for family in Family::all() {
            for alias in family.aliases() {
                assert_eq!(Family::named(alias).map(Family::name), Some(family.name()));
            }
        }
    }

    #[test]
    fn values_that_cannot_be_taken_are_named() {
        for (family, name, value, said, cure) in [
            (
                "torus",
                "column",
                ParameterValue::Count(8),
                "torus has no parameter column",
                "major_radius, minor_radius",
            ),
            ("k3", "rows", ParameterValue::Count(8), "k3 has no parameter rows", "no parameters"),
            ("torus", "rows", ParameterValue::Real(8.5), "torus: rows is 8.5", "a whole number"),
            ("klein", "space", ParameterValue::Count(5), "klein: space is 5", "from 3 to 4"),
            (
                "disk",
                "kind",
                ParameterValue::Choice("round".into()),
                "disk: kind is \"round\"",
                "polar, square",
            ),
        ] {
            let error = Family::named(family).unwrap().make(&[(name, value)]).unwrap_err();
            assert!(error.message().contains(said), "{error}");
            assert!(error.cure().is_some_and(|text| text.contains(cure)), "{error}");
        }
    }

    #[test]
    fn a_box_has_one_cell_along_each_axis_where_nothing_else_is_said() {
        let sizes = ParameterValue::Reals(vec![2.0, 3.0]);
        let made =
            Family::named("box").unwrap().make(&[("sizes", sizes), ("cuboids", ParameterValue::Flag(true))]);
        let FamilyModel::Cells(cells) = made.unwrap() else { panic!("a box has positions") };
        assert_eq!((cells.cell_count(), cells.positions().dimension()), (1, 2));
    }
}
