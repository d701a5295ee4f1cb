//! Velocity fields that are written as expressions.

use coface_algebra::Error;
use std::f64::consts::{E, PI};

type OfOne = fn(f64) -> f64;
type OfTwo = fn(f64, f64) -> f64;

/// What an expression does next with its stack of numbers.
#[derive(Clone, Copy, Debug)]
enum Step {
    Number(f64),
    X,
    Y,
    Time,
    Period,
    Negate,
    One(OfOne),
    Two(OfTwo),
}

/// Functions of one number.
const ONE: [(&str, OfOne); 14] = [
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("asin", f64::asin),
    ("acos", f64::acos),
    ("atan", f64::atan),
    ("sinh", f64::sinh),
    ("cosh", f64::cosh),
    ("tanh", f64::tanh),
    ("exp", f64::exp),
    ("log", f64::ln),
    ("sqrt", f64::sqrt),
    ("abs", f64::abs),
    ("floor", f64::floor),
];

/// Functions of two numbers.
const TWO: [(&str, OfTwo); 4] =
    [("atan2", f64::atan2), ("hypot", f64::hypot), ("min", f64::min), ("max", f64::max)];

/// The most numbers that wait at a time, and the deepest nesting.
const DEEPEST: usize = 64;

/// A velocity that two expressions give, one for each direction: `"-y; x"` is a rotation.
///
/// They have numbers, `x`, `y`, the time `t`, the period `T`, `pi`, `e`, the operations `+ - * /` and `^` for powers, brackets, and the functions
/// sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log (the natural one), sqrt, abs, floor, atan2(y, x), hypot, min and max.
/// Powers bind first and from the right, a sign after them: $-2^2$ is $-4$, and $2^{3^2}$ is $512$.
///
/// # Examples
/// ```
/// use coface_yin::VelocityExpression;
/// let flow = VelocityExpression::parse("-2^2*y; x + t/T", 4.0)?;
/// assert_eq!(flow.velocity([3.0, 0.5], 1.0), [-2.0, 3.25]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct VelocityExpression {
    components: [Vec<Step>; 2],
    period: f64,
}

impl VelocityExpression {
    /// Reads two expressions with a semicolon between them.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the column, counted from 1 in the whole text, of what cannot
    /// be read; for one expression, or three; and for a period that is zero or not finite where it is named.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::VelocityExpression;
    /// let error = VelocityExpression::parse("2x; 1", 1.0).map(drop).map_err(|error| error.to_string());
    /// assert!(error.is_err_and(|error| error.starts_with("column 2: \"x\" stands behind a number")));
    /// ```
    pub fn parse(text: &str, period: f64) -> Result<Self, Error> {
        let parts: Vec<&str> = text.split(';').collect();
        let &[first, second] = parts.as_slice() else {
            let message = match parts.len() {
                1 => "there is one expression, and a velocity has two directions".to_owned(),
                count => format!("there are {count} expressions, and a velocity has two directions"),
            };
            return Err(Error::invalid(message)
                .with_cure("write one for x and one for y with ; between them, as in \"-y; x\""));
        };
        let components = [
            Parser::new(first, 0).expression_to_end()?,
            Parser::new(second, first.chars().count() + 1).expression_to_end()?,
        ];
        let found = Self { components, period };
        if found.has_period() && !(period.is_finite() && period != 0.0) {
            return Err(Error::invalid(format!("the period T is {period}"))
                .with_cure("give a finite time other than 0"));
        }
        Ok(found)
    }

    /// Whether the period is named.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::VelocityExpression;
    /// assert!(VelocityExpression::parse("1; cos(pi*t/T)", 4.0)?.has_period());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn has_period(&self) -> bool {
        self.components.iter().any(|steps| steps.iter().any(|step| matches!(step, Step::Period)))
    }

    /// The velocity at a point and a time; not finite where an expression has no value.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::VelocityExpression;
    /// let flow = VelocityExpression::parse("sqrt(x); 1/y", 1.0)?;
    /// assert_eq!(flow.velocity([4.0, 0.5], 0.0), [2.0, 2.0]);
    /// assert!(flow.velocity([-1.0, 0.5], 0.0)[0].is_nan());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn velocity(&self, [x, y]: [f64; 2], time: f64) -> [f64; 2] {
        [0, 1].map(|axis| {
            let mut stack = [0.0; DEEPEST];
            let mut height = 0;
            for step in &self.components[axis] {
                let pushed = match *step {
                    Step::Number(number) => number,
                    Step::X => x,
                    Step::Y => y,
                    Step::Time => time,
                    Step::Period => self.period,
                    Step::Negate => {
                        stack[height - 1] = -stack[height - 1];
                        continue;
                    }
                    Step::One(function) => {
                        stack[height - 1] = function(stack[height - 1]);
                        continue;
                    }
                    Step::Two(function) => {
                        height -= 1;
                        stack[height - 1] = function(stack[height - 1], stack[height]);
                        continue;
                    }
                };
                stack[height] = pushed;
                height += 1;
            }
            stack[0]
        })
    }
}

fn power(base: f64, exponent: f64) -> f64 {
    if exponent == 2.0 { base * base } else { base.powf(exponent) }
}

/// Reads an expression from the left, and writes down its steps.
struct Parser {
    text: Vec<char>,
    at: usize,
    /// The number of characters before the text.
    before: usize,
    depth: usize,
    /// How many numbers wait.
    height: usize,
    steps: Vec<Step>,
}

impl Parser {
    fn new(text: &str, before: usize) -> Self {
        Self { text: text.chars().collect(), at: 0, before, depth: 0, height: 0, steps: Vec::new() }
    }

    fn fault(&self, at: usize, what: &str, cure: &str) -> Error {
        Error::invalid(format!("column {}: {what}", self.before + at + 1)).with_cure(cure)
    }

    /// The next character that is no space.
    fn peek(&mut self) -> Option<char> {
        while self.text.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    fn takes(&mut self, wanted: char) -> bool {
        let is_there = self.peek() == Some(wanted);
        self.at += usize::from(is_there);
        is_there
    }

    fn push(&mut self, step: Step, at: usize) -> Result<(), Error> {
        match step {
            Step::Two(_) => self.height -= 1,
            Step::Negate | Step::One(_) => {}
            _ => self.height += 1,
        }
        if self.height > DEEPEST {
            return Err(self.too_deep(at));
        }
        self.steps.push(step);
        Ok(())
    }

    fn too_deep(&self, at: usize) -> Error {
        self.fault(at, "the expression is nested too deep", "take brackets apart: 64 may be open at a time")
    }

    fn expression_to_end(mut self) -> Result<Vec<Step>, Error> {
        self.sum()?;
        match self.peek() {
            None => Ok(self.steps),
            Some(')') => Err(self.fault(self.at, "a bracket is closed that is not open", "leave it out")),
            Some(',') => Err(self.fault(
                self.at,
                "a comma stands outside of a function",
                "write ; between the two expressions, and a point in decimal numbers",
            )),
            Some(c) => {
                let behind = if c.is_alphanumeric() || c == '(' {
                    format!("\"{c}\" stands behind a number without an operation")
                } else {
                    format!("\"{c}\" is no operation")
                };
                Err(self.fault(self.at, &behind, "write an operation between them: + - * / ^"))
            }
        }
    }

    fn sum(&mut self) -> Result<(), Error> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.too_deep(self.at));
        }
        self.product()?;
        loop {
            let at = self.at;
            if self.takes('+') {
                self.product()?;
                self.push(Step::Two(|a, b| a + b), at)?;
            } else if self.takes('-') {
                self.product()?;
                self.push(Step::Two(|a, b| a - b), at)?;
            } else {
                self.depth -= 1;
                return Ok(());
            }
        }
    }

    fn product(&mut self) -> Result<(), Error> {
        self.signed()?;
        loop {
            let at = self.at;
            if self.takes('*') {
                self.signed()?;
                self.push(Step::Two(|a, b| a * b), at)?;
            } else if self.takes('/') {
                self.signed()?;
                self.push(Step::Two(|a, b| a / b), at)?;
            } else {
                return Ok(());
            }
        }
    }

    /// A power with signs before it.
    fn signed(&mut self) -> Result<(), Error> {
        let mut is_negative = false;
        let at = self.at;
        loop {
            if self.takes('-') {
                is_negative = !is_negative;
            } else if !self.takes('+') {
                break;
            }
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.too_deep(at));
        }
        self.atom()?;
        if self.takes('^') {
            // From the right, and with a sign of its own.
            self.signed()?;
            self.push(Step::Two(power), at)?;
        }
        self.depth -= 1;
        if is_negative { self.push(Step::Negate, at) } else { Ok(()) }
    }

    fn atom(&mut self) -> Result<(), Error> {
        const WANTED: &str = "write a number, x, y, t, T, pi, a function or a bracket there";
        let next = self.peek();
        let start = self.at;
        match next {
            Some('(') => {
                self.at += 1;
                self.sum()?;
                self.close(start)
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some(c) => Err(self.fault(start, &format!("\"{c}\" stands where a value should"), WANTED)),
            None => Err(self.fault(start, "the expression ends where a value should stand", WANTED)),
        }
    }

    fn close(&mut self, open: usize) -> Result<(), Error> {
        if self.takes(')') {
            return Ok(());
        }
        match self.peek() {
            None => Err(self.fault(open, "this bracket is not closed", "write ) at its end")),
            Some(c) => {
                let what = format!(
                    "\"{c}\" stands where the bracket of column {} should close",
                    self.before + open + 1
                );
                Err(self.fault(self.at, &what, "write ) or an operation there"))
            }
        }
    }

    fn number(&mut self) -> Result<(), Error> {
        let start = self.at;
        let digit = |at: usize| self.text.get(at).is_some_and(char::is_ascii_digit);
        let mut at = start;
        while digit(at) || self.text.get(at) == Some(&'.') {
            at += 1;
        }
        // An exponent, if digits follow; else it is a name, which is a fault.
        if matches!(self.text.get(at), Some('e' | 'E')) {
            let sign = usize::from(matches!(self.text.get(at + 1), Some('+' | '-')));
            if digit(at + 1 + sign) {
                at += 1 + sign;
                while digit(at) {
                    at += 1;
                }
            }
        }
        let text: String = self.text[start..at].iter().collect();
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        let Some(number) = number else {
            return Err(self.fault(start, &format!("\"{text}\" is no number"), "write it as 1.5 or 2e-3"));
        };
        self.at = at;
        self.push(Step::Number(number), start)
    }

    fn name(&mut self) -> Result<(), Error> {
        let start = self.at;
        while self.text.get(self.at).is_some_and(|c| c.is_alphanumeric() || *c == '_') {
            self.at += 1;
        }
        let name: String = self.text[start..self.at].iter().collect();
        let value = match name.as_str() {
            "x" => Some(Step::X),
            "y" => Some(Step::Y),
            "t" => Some(Step::Time),
            "T" => Some(Step::Period),
            "pi" => Some(Step::Number(PI)),
            "e" => Some(Step::Number(E)),
            _ => None,
        };
        if let Some(value) = value {
            return self.push(value, start);
        }
        let one = ONE.iter().find(|(known, _)| *known == name).map(|&(_, function)| function);
        let two = TWO.iter().find(|(known, _)| *known == name).map(|&(_, function)| function);
        if one.is_none() && two.is_none() {
            return Err(self.fault(
                start,
                &format!("\"{name}\" is not known"),
                "there are x, y, t, T, pi and e, and the functions sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, sqrt, abs, \
                 floor, atan2, hypot, min and max",
            ));
        }
        let open = self.at;
        if !self.takes('(') {
            return Err(self.fault(
                start,
                &format!("\"{name}\" has no value to work on"),
                "write it in brackets behind the name",
            ));
        }
        self.sum()?;
        if let Some(function) = two {
            if !self.takes(',') {
                return Err(self.fault(
                    self.at,
                    &format!("\"{name}\" wants two values"),
                    "write , and the second one there",
                ));
            }
            self.sum()?;
            self.close(open)?;
            return self.push(Step::Two(function), start);
        }
        self.close(open)?;
        match one {
            Some(function) => self.push(Step::One(function), start),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Flow;

    fn value(text: &str) -> f64 {
        let flow = VelocityExpression::parse(&format!("{text}; 0"), 4.0).expect("it is an expression");
        flow.velocity([0.3, -0.7], 0.25)[0]
    }

    #[test]
    fn operations_bind_as_in_mathematics() {
        let (x, y, t): (f64, f64, f64) = (0.3, -0.7, 0.25);
        for (text, expected) in [
            ("-2^2", -4.0),
            ("2^3^2", 512.0),
            ("2^-1", 0.5),
            ("(-2)^3", -8.0),
            ("1 - 2 - 3", -4.0),
            ("8/4/2", 1.0),
            ("2*-3", -6.0),
            ("--2", 2.0),
            ("1+2*3^2", 19.0),
            ("1.5e-3*2E3", 3.0),
            ("2*e", 2.0 * E),
            ("sin(x)^2 + cos(x)^2", x.sin() * x.sin() + x.cos() * x.cos()),
            ("atan2(y, x)", y.atan2(x)),
            ("max(min(x, y), t)*T", t * 4.0),
            ("exp(log(2))", 2.0f64.ln().exp()),
        ] {
            assert_eq!(value(text), expected, "{text}");
        }
    }

    #[test]
    fn the_named_vortex_is_its_expression() {
        let text = "sin(pi*x)^2*sin(2*pi*y)*cos(pi*t/T); -sin(pi*y)^2*sin(2*pi*x)*cos(pi*t/T)";
        let flow = VelocityExpression::parse(text, 4.0).expect("these are expressions");
        let named = Flow::Vortex { period: 4.0 };
        for k in 0..100 {
            let (point, time) = ([f64::from(k) * 0.37 % 1.0, f64::from(k) * 0.73 % 1.0], f64::from(k) * 0.05);
            let [a, b] = [flow.velocity(point, time), named.velocity(point, time)];
            assert!((a[0] - b[0]).abs() < 1e-14 && (a[1] - b[1]).abs() < 1e-14, "{a:?} {b:?}");
        }
    }

    #[test]
    fn faults_have_a_place() {
        for (text, said) in [
            ("1", "there is one expression"),
            ("1;2;3", "there are 3 expressions"),
            ("; 1", "column 1: the expression ends"),
            ("1;", "column 3: the expression ends"),
            ("x; 2*(y", "column 6: this bracket is not closed"),
            ("x; y)", "column 5: a bracket is closed"),
            ("x; 2 y", "column 6: \"y\" stands behind a number"),
            ("z; 1", "column 1: \"z\" is not known"),
            ("sin x; 1", "column 1: \"sin\" has no value"),
            ("atan2(x); 1", "column 8: \"atan2\" wants two values"),
            ("sin(x, y); 1", "column 6: \",\" stands where"),
            ("x**2; 1", "column 3: \"*\" stands where a value should"),
            ("1.2.3; 1", "column 1: \"1.2.3\" is no number"),
            ("1e999; 1", "column 1: \"1e999\" is no number"),
            ("2 # 1; 1", "column 3: \"#\" is no operation"),
            ("1,5; 1", "column 2: a comma"),
        ] {
            let error = VelocityExpression::parse(text, 1.0).expect_err(text);
            assert!(error.to_string().starts_with(said), "{text}: {error}");
            assert!(error.cure().is_some(), "{text}");
        }
        assert!(VelocityExpression::parse("t/T; 1", 0.0).is_err());
        assert!(VelocityExpression::parse("t; 1", 0.0).is_ok());
        for deep in ["(".repeat(100_000), "2^".repeat(100_000), "sin(".repeat(100_000)] {
            assert!(VelocityExpression::parse(&format!("{deep}; 1"), 1.0).is_err());
        }
    }
}
