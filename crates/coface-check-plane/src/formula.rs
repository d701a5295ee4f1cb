//! Formulas of Booleans, and which winding numbers are inside.

use coface_check::Fault;
use coface_check::json::{optional, text};
use serde_json::Value;

/// A step of a formula in reverse Polish notation.
#[derive(Debug)]
enum Step {
    Input(u32),
    Operator(char),
}

/// A formula of inputs: its steps, and how it is usually written.
///
/// # Examples
/// ```
/// let formula = coface_check_plane::Formula::read("0 1 -", 2).expect("a difference");
/// assert_eq!((formula.shown(), formula.holds(|input| input == 0)), ("(0 - 1)", true));
/// assert!(coface_check_plane::Formula::read("0 1", 2).is_err());
/// ```
#[derive(Debug)]
pub struct Formula {
    steps: Vec<Step>,
    shown: String,
}

impl Formula {
    /// Numbers of inputs from 0 and the operators ! & - ^ | behind their operands, separated by blanks.
    ///
    /// # Errors
    /// A [`Fault`] for another text, or an input that is not there.
    pub fn read(text: &str, inputs: usize) -> Result<Self, Fault> {
        let fault = |message: String| Fault::new("formula", message);
        let (mut steps, mut waiting) = (Vec::new(), Vec::<String>::new());
        for word in text.split_whitespace() {
            if let Ok(input) = word.parse::<u32>() {
                if input as usize >= inputs {
                    return Err(fault(format!("there is no input {input}")));
                }
                waiting.push(input.to_string());
                steps.push(Step::Input(input));
                continue;
            }
            let short = || fault(format!("{word:?} has too few operands"));
            let last = waiting.pop().ok_or_else(short)?;
            let shown = match word {
                "!" => format!("!{last}"),
                "&" | "-" | "^" | "|" => format!("({} {word} {last})", waiting.pop().ok_or_else(short)?),
                _ => return Err(fault(format!("{word:?} is no operator"))),
            };
            waiting.push(shown);
            steps.push(Step::Operator(word.chars().next().unwrap_or('!')));
        }
        match &waiting[..] {
            [shown] => Ok(Self { steps, shown: shown.clone() }),
            _ => Err(fault(format!("{} results are left where one is wanted", waiting.len()))),
        }
    }

    /// The formula with its operators between their operands.
    pub fn shown(&self) -> &str {
        &self.shown
    }

    /// Whether the formula holds where one is in these inputs.
    pub fn holds(&self, is_in: impl Fn(u32) -> bool) -> bool {
        let mut values = Vec::new();
        for step in &self.steps {
            let value = match step {
                Step::Input(input) => is_in(*input),
                Step::Operator(operator) => {
                    let last = values.pop().unwrap_or(false);
                    match operator {
                        '!' => !last,
                        '&' => values.pop().unwrap_or(false) & last,
                        '-' => values.pop().unwrap_or(false) & !last,
                        '^' => values.pop().unwrap_or(false) ^ last,
                        _ => values.pop().unwrap_or(false) | last,
                    }
                }
            };
            values.push(value);
        }
        values.pop().unwrap_or(false)
    }
}

/// Which winding numbers are inside.
///
/// # Examples
/// ```
/// use coface_check_plane::Rule;
/// let rule = Rule::of(&serde_json::json!({"rule": "evenodd"})).expect("a rule");
/// assert_eq!((rule, rule.holds(2), rule.holds(-1)), (Rule::Odd, false, true));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// All but zero.
    Nonzero,
    /// Odd ones.
    Odd,
    /// Those above zero.
    Positive,
}

impl Rule {
    /// The rule of a certificate: `nonzero` where none is named, `evenodd` or `positive`.
    ///
    /// # Errors
    /// A [`Fault`] for another word.
    pub fn of(certificate: &Value) -> Result<Self, Fault> {
        let step = "certificate";
        match optional(certificate, "rule").map(|rule| text(rule, "\"rule\"", step)).transpose()? {
            None | Some("nonzero") => Ok(Self::Nonzero),
            Some("evenodd") => Ok(Self::Odd),
            Some("positive") => Ok(Self::Positive),
            Some(other) => Err(Fault::new(step, format!("{other:?} is no rule"))),
        }
    }

    /// The word for the rule in certificates.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nonzero => "nonzero",
            Self::Odd => "evenodd",
            Self::Positive => "positive",
        }
    }

    /// What a verdict says of the rule.
    pub fn claim(self) -> String {
        let inside = match self {
            Self::Nonzero => "other than 0",
            Self::Odd => "odd",
            Self::Positive => "above 0",
        };
        format!("inside is where winding numbers are {inside}, the rule {:?}", self.name())
    }

    /// Whether a winding number is inside.
    pub fn holds(self, winding: i64) -> bool {
        match self {
            Self::Nonzero => winding != 0,
            Self::Odd => winding % 2 != 0,
            Self::Positive => winding > 0,
        }
    }
}
