//! Parameters of families, and what is given for them.

use std::fmt;

/// A parameter of a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    name: &'static str,
    symbol: &'static str,
    about: &'static str,
    kind: ParameterKind,
}

/// What a parameter takes, with its usual value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterKind {
    /// A real number.
    Real {
        /// The usual value.
        usual: f64,
    },
    /// A number of something, or a dimension.
    Count {
        /// The usual value; none where it depends on other parameters.
        usual: Option<u32>,
        /// The least value that is taken.
        least: u32,
        /// The greatest value that is taken.
        most: u32,
    },
    /// Several numbers, such as one for each axis.
    Counts {
        /// The usual values.
        usual: &'static [u32],
    },
    /// Several real numbers, such as one for each axis.
    Reals {
        /// The usual values.
        usual: &'static [f64],
    },
    /// Several integers, such as the entries of a matrix, row after row.
    Integers {
        /// The usual values.
        usual: &'static [i64],
    },
    /// Yes or no; no is usual.
    Flag,
    /// One of some words.
    Choice {
        /// The words.
        words: &'static [&'static str],
        /// The usual one; none where it depends on other parameters.
        usual: Option<&'static str>,
    },
    /// Words in the letters 1, -1, 2, -2, ..; usually none.
    Words,
}

/// What is given for a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum ParameterValue {
    /// A real number.
    Real(f64),
    /// A number of something.
    Count(u32),
    /// Several numbers.
    Counts(Vec<u32>),
    /// Several real numbers.
    Reals(Vec<f64>),
    /// Several integers.
    Integers(Vec<i64>),
    /// Yes or no.
    Flag(bool),
    /// One of the words of a [`ParameterKind::Choice`].
    Choice(String),
    /// Words in the letters 1, -1, 2, -2, ..
    Words(Vec<Vec<i32>>),
}

impl Parameter {
    /// The name, with `_` between its words.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// let torus = Family::named("torus").expect("there is a torus");
    /// assert_eq!(torus.parameters()[0].name(), "major_radius");
    /// ```
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// How a value is written in a synopsis: `R`, `N`, `N,N,..`.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// let torus = Family::named("torus").expect("there is a torus");
    /// assert_eq!(torus.parameters()[0].symbol(), "R");
    /// ```
    pub fn symbol(&self) -> &'static str {
        self.symbol
    }

    /// What it means, as one line without a period.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::Family;
    /// let circle = Family::named("circle").expect("there is a circle");
    /// assert_eq!(circle.parameters()[0].about(), "The radius");
    /// ```
    pub fn about(&self) -> &'static str {
        self.about
    }

    /// What it takes.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::{Family, ParameterKind};
    /// let circle = Family::named("circle").expect("there is a circle");
    /// assert_eq!(circle.parameters()[0].kind(), ParameterKind::Real { usual: 1.0 });
    /// ```
    pub fn kind(&self) -> ParameterKind {
        self.kind
    }

    pub(super) const fn new(
        name: &'static str,
        symbol: &'static str,
        about: &'static str,
        kind: ParameterKind,
    ) -> Self {
        Self { name, symbol, about, kind }
    }

    pub(super) const fn real(
        name: &'static str,
        symbol: &'static str,
        about: &'static str,
        usual: f64,
    ) -> Self {
        Self::new(name, symbol, about, ParameterKind::Real { usual })
    }

    pub(super) const fn count(
        name: &'static str,
        symbol: &'static str,
        about: &'static str,
        usual: u32,
    ) -> Self {
        let kind = ParameterKind::Count { usual: Some(usual), least: 0, most: u32::MAX };
        Self::new(name, symbol, about, kind)
    }

    /// The same count within these bounds.
    pub(super) const fn within(self, least: u32, most: u32) -> Self {
        let usual = match self.kind {
            ParameterKind::Count { usual, .. } => usual,
            _ => None,
        };
        Self { kind: ParameterKind::Count { usual, least, most }, ..self }
    }

    pub(super) const fn flag(name: &'static str, about: &'static str) -> Self {
        Self::new(name, "", about, ParameterKind::Flag)
    }

    /// Why a value cannot be taken, and what can; nothing if it can.
    pub(super) fn fault(&self, value: &ParameterValue) -> Option<(String, String)> {
        let cure = match (self.kind, value) {
            (ParameterKind::Count { least, most, .. }, ParameterValue::Count(count)) => {
                if (least..=most).contains(count) {
                    return None;
                }
                format!("give a number from {least} to {most}")
            }
            (ParameterKind::Choice { words, .. }, ParameterValue::Choice(word)) => {
                if words.contains(&word.as_str()) {
                    return None;
                }
                format!("choose one of {}", words.join(", "))
            }
            (ParameterKind::Real { .. }, ParameterValue::Real(_))
            | (ParameterKind::Counts { .. }, ParameterValue::Counts(_))
            | (ParameterKind::Reals { .. }, ParameterValue::Reals(_))
            | (ParameterKind::Integers { .. }, ParameterValue::Integers(_))
            | (ParameterKind::Flag, ParameterValue::Flag(_))
            | (ParameterKind::Words, ParameterValue::Words(_)) => return None,
            (ParameterKind::Real { .. }, _) => "give a number".to_owned(),
            (ParameterKind::Count { .. }, _) => "give a whole number".to_owned(),
            (ParameterKind::Counts { .. }, _) => "give whole numbers".to_owned(),
            (ParameterKind::Reals { .. }, _) => "give numbers".to_owned(),
            (ParameterKind::Integers { .. }, _) => "give integers".to_owned(),
            (ParameterKind::Flag, _) => "give yes or no".to_owned(),
            (ParameterKind::Choice { words, .. }, _) => format!("choose one of {}", words.join(", ")),
            (ParameterKind::Words, _) => "give words in the letters 1, -1, 2, -2, ..".to_owned(),
        };
        Some((format!("{} is {value}", self.name), cure))
    }
}

impl fmt::Display for ParameterValue {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Real(value) => value.fmt(formatter),
            Self::Count(value) => value.fmt(formatter),
            Self::Counts(values) => write!(formatter, "{values:?}"),
            Self::Reals(values) => write!(formatter, "{values:?}"),
            Self::Integers(values) => write!(formatter, "{values:?}"),
            Self::Flag(value) => value.fmt(formatter),
            Self::Choice(word) => write!(formatter, "{word:?}"),
            Self::Words(words) => write!(formatter, "{words:?}"),
        }
    }
}
