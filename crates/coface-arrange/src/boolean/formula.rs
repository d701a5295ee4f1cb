//! Formulas over inputs.

use coface_algebra::Error;

/// A formula of union, intersection, difference, symmetric difference and complement over numbered inputs.
///
/// # Examples
/// ```
/// use coface_arrange::boolean::BooleanFormula;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let formula = BooleanFormula::parse("(a | b) - c", &[])?;
/// assert_eq!(formula.input_count(), 3);
/// assert!(formula.evaluate(|input| input == 1));
/// assert!(!formula.evaluate(|input| input > 0));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BooleanFormula {
    /// Operands before their operators.
    steps: Vec<Step>,
    input_count: usize,
}

/// An input, or an operator on what comes before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Input(u32),
    Complement,
    Intersection,
    Difference,
    Xor,
    Union,
}

/// What waits for its right operand.
#[derive(Clone, Copy, Debug)]
enum Waiting {
    Operator(Step),
    Parenthesis(usize),
}

impl Step {
    /// Operators of higher rank bind more tightly.
    fn rank(self) -> u8 {
        match self {
            Self::Union => 0,
            Self::Xor => 1,
            Self::Difference => 2,
            Self::Intersection => 3,
            Self::Complement | Self::Input(_) => 4,
        }
    }
}

impl BooleanFormula {
    /// Reads a formula.
    ///
    /// From the tightest to the loosest: `!a` or `~a` complement, `a & b` intersection, `a - b` difference, `a ^ b`
    /// symmetric difference, `a | b` union; operators of one kind go from left to right, parentheses go first. An input
    /// is one of `names` or its number from 0; without names also a single letter, `a` or `A` for input 0.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Parse`] naming the byte at which the text is no formula.
    ///
    /// # References
    /// The shunting yard of E. W. Dijkstra, *Making a translator for ALGOL 60* (1961).
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let formula = BooleanFormula::parse("wall - door", &["wall", "door"])?;
    /// assert!(formula.evaluate(|input| input == 0));
    /// assert!(BooleanFormula::parse("wall -", &["wall"]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn parse(text: &str, names: &[&str]) -> Result<Self, Error> {
        let mut steps = Vec::new();
        let mut waiting: Vec<Waiting> = Vec::new();
        let mut input_count = 0;
        let mut operand_next = true;
        let mut rest = text.char_indices().peekable();
        while let Some((at, letter)) = rest.next() {
            if letter.is_whitespace() {
                continue;
            }
            let unexpected = || {
                let wanted = if operand_next { "an input" } else { "an operator" };
                Error::parse(format!("{letter:?} stands where {wanted} is expected")).at_byte(at as u64)
            };
            let is_name = |c: char| c.is_alphanumeric() || c == '_';
            match letter {
                '(' if operand_next => waiting.push(Waiting::Parenthesis(at)),
                '!' | '~' if operand_next => waiting.push(Waiting::Operator(Step::Complement)),
                ')' if !operand_next => loop {
                    match waiting.pop() {
                        Some(Waiting::Operator(step)) => steps.push(step),
                        Some(Waiting::Parenthesis(_)) => break,
                        None => {
                            return Err(
                                Error::parse("a parenthesis is closed but not opened").at_byte(at as u64)
                            );
                        }
                    }
                },
                '&' | '-' | '^' | '|' if !operand_next => {
                    let step = match letter {
                        '&' => Step::Intersection,
                        '-' => Step::Difference,
                        '^' => Step::Xor,
                        _ => Step::Union,
                    };
                    while let Some(&Waiting::Operator(before)) = waiting.last() {
                        if before.rank() < step.rank() {
                            break;
                        }
                        steps.push(before);
                        waiting.pop();
                    }
                    waiting.push(Waiting::Operator(step));
                    operand_next = true;
                }
                _ if operand_next && is_name(letter) => {
                    let mut end = at + letter.len_utf8();
                    while let Some((next, c)) = rest.next_if(|&(_, c)| is_name(c)) {
                        end = next + c.len_utf8();
                    }
                    let input =
                        input_number(&text[at..end], names).map_err(|error| error.at_byte(at as u64))?;
                    input_count = input_count.max(input as usize + 1);
                    steps.push(Step::Input(input));
                    operand_next = false;
                }
                _ => return Err(unexpected()),
            }
        }
        if operand_next {
            return Err(
                Error::parse("the formula ends where an input is expected").at_byte(text.len() as u64)
            );
        }
        while let Some(last) = waiting.pop() {
            match last {
                Waiting::Operator(step) => steps.push(step),
                Waiting::Parenthesis(at) => {
                    return Err(Error::parse("a parenthesis is opened but not closed").at_byte(at as u64));
                }
            }
        }
        Ok(Self { steps, input_count })
    }

    /// The union of the inputs below `count`, at least one.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// assert!(BooleanFormula::union(3).evaluate(|input| input == 2));
    /// ```
    pub fn union(count: usize) -> Self {
        Self::chain(count, Step::Union)
    }

    /// The intersection of the inputs below `count`, at least one.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// assert!(!BooleanFormula::intersection(3).evaluate(|input| input == 2));
    /// ```
    pub fn intersection(count: usize) -> Self {
        Self::chain(count, Step::Intersection)
    }

    /// The first input without the others below `count`.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// let rest = BooleanFormula::difference(3);
    /// assert!(rest.evaluate(|input| input == 0) && !rest.evaluate(|input| input != 1));
    /// ```
    pub fn difference(count: usize) -> Self {
        Self::chain(count, Step::Difference)
    }

    /// What is in an odd number of the inputs below `count`, at least one.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// let odd = BooleanFormula::xor(3);
    /// assert!(odd.evaluate(|_| true) && !odd.evaluate(|input| input > 0));
    /// ```
    pub fn xor(count: usize) -> Self {
        Self::chain(count, Step::Xor)
    }

    fn chain(count: usize, operator: Step) -> Self {
        let mut steps = vec![Step::Input(0)];
        for input in 1..count as u32 {
            steps.extend([Step::Input(input), operator]);
        }
        Self { steps, input_count: count.max(1) }
    }

    /// One more than the highest input that is named.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(BooleanFormula::parse("a & c", &[])?.input_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn input_count(&self) -> usize {
        self.input_count
    }

    /// Whether an input is named.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let formula = BooleanFormula::parse("a & c", &[])?;
    /// assert!(formula.names(2) && !formula.names(1));
    /// # Ok(()) }
    /// ```
    pub fn names(&self, input: usize) -> bool {
        self.steps.iter().any(|step| matches!(step, Step::Input(own) if *own as usize == input))
    }

    /// The value, given the inputs that are true.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let formula = BooleanFormula::parse("a & !b", &[])?;
    /// assert!(formula.evaluate(|input| input == 0) && !formula.evaluate(|_| true));
    /// # Ok(()) }
    /// ```
    pub fn evaluate(&self, input: impl Fn(usize) -> bool) -> bool {
        self.evaluate_on(&mut Vec::new(), input)
    }

    /// The formula in reverse Polish notation: inputs by their numbers and the operators `!`, `&`, `-`, `^`, `|` behind their operands, with
    /// blanks between them.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(BooleanFormula::parse("(a | b) - !c", &[])?.to_postfix(), "0 1 | 2 ! -");
    /// # Ok(()) }
    /// ```
    pub fn to_postfix(&self) -> String {
        let word = |step: &Step| match step {
            Step::Input(input) => input.to_string(),
            Step::Complement => "!".to_owned(),
            Step::Intersection => "&".to_owned(),
            Step::Difference => "-".to_owned(),
            Step::Xor => "^".to_owned(),
            Step::Union => "|".to_owned(),
        };
        self.steps.iter().map(word).collect::<Vec<String>>().join(" ")
    }

    /// The steps, operands before their operators.
    /// The formula of some steps that leave one operand.
    pub(super) fn of_steps(steps: Vec<Step>) -> Self {
        let input = |step: &Step| if let Step::Input(input) = step { *input as usize + 1 } else { 0 };
        let input_count = steps.iter().map(input).max().unwrap_or(0);
        Self { steps, input_count }
    }

    pub(super) fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The same with a stack to use again.
    pub(super) fn evaluate_on(&self, stack: &mut Vec<bool>, input: impl Fn(usize) -> bool) -> bool {
        stack.clear();
        for &step in &self.steps {
            let value = match step {
                Step::Input(number) => input(number as usize),
                Step::Complement => !pop(stack),
                _ => {
                    let (b, a) = (pop(stack), pop(stack));
                    match step {
                        Step::Intersection => a & b,
                        Step::Difference => a & !b,
                        Step::Xor => a ^ b,
                        _ => a | b,
                    }
                }
            };
            stack.push(value);
        }
        pop(stack)
    }
}

fn pop(stack: &mut Vec<bool>) -> bool {
    stack.pop().expect("a formula that was read has an operand for each place")
}

fn input_number(name: &str, names: &[&str]) -> Result<u32, Error> {
    let unknown = || {
        let cure = if names.is_empty() {
            "write letters or numbers from 0".to_owned()
        } else {
            format!("the inputs are {}", names.join(", "))
        };
        Error::parse(format!("there is no input {name:?}")).with_cure(cure)
    };
    if let Some(at) = names.iter().position(|&known| known == name) {
        return u32::try_from(at).map_err(|_| unknown());
    }
    if name.bytes().all(|byte| byte.is_ascii_digit()) {
        // A formula never names more inputs than can be counted in 16 bits; others are a slip.
        let number = name.parse::<u16>().map_err(|_| unknown())?;
        let known = names.is_empty() || usize::from(number) < names.len();
        return if known { Ok(u32::from(number)) } else { Err(unknown()) };
    }
    match name.as_bytes() {
        [letter] if names.is_empty() && letter.is_ascii_alphabetic() => {
            Ok(u32::from(letter.to_ascii_lowercase() - b'a'))
        }
        _ => Err(unknown()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// All values of a formula over four inputs.
    fn table(text: &str) -> Vec<bool> {
        let formula = BooleanFormula::parse(text, &[]).unwrap();
        (0..16u32).map(|inputs| formula.evaluate(|input| inputs >> input & 1 == 1)).collect()
    }

    #[test]
    fn operators_bind_as_they_say() {
        assert_eq!(table("(a | b) - c & d ^ a"), table("((a | b) - (c & d)) ^ a"));
        assert_eq!(table("a | b ^ c"), table("a | (b ^ c)"));
        assert_eq!(table("a - b - c"), table("(a - b) - c"));
        assert_eq!(table("!a & ~!b"), table("(!a) & b"));
        assert_ne!(table("a - (b - c)"), table("a - b - c"));
        assert_eq!(table("0|3"), table("A | d"));
        let names = ["rod", "cube"];
        let formula = BooleanFormula::parse("cube-rod", &names).unwrap();
        assert!(formula.evaluate(|input| input == 1));
        assert_eq!(formula, BooleanFormula::parse("1 - 0", &names).unwrap());
        for (chain, text) in [
            (BooleanFormula::union(3), "a|b|c"),
            (BooleanFormula::intersection(3), "a&b&c"),
            (BooleanFormula::difference(3), "a-b-c"),
            (BooleanFormula::xor(3), "a^b^c"),
        ] {
            assert_eq!(chain, BooleanFormula::parse(text, &[]).unwrap());
        }
    }

    #[test]
    fn faults_are_placed() {
        let places = [
            ("", 0),
            ("a |", 3),
            ("a b", 2),
            ("(a", 0),
            ("a & (b | c", 4),
            ("a)", 1),
            ("a $ b", 2),
            ("a | bc", 4),
            ("& a", 0),
            ("a !b", 2),
            ("99999999999", 0),
            ("()", 1),
        ];
        for (text, byte) in places {
            let error = BooleanFormula::parse(text, &[]).unwrap_err();
            assert_eq!(
                (error.kind(), error.byte()),
                (coface_algebra::ErrorKind::Parse, Some(byte)),
                "{text} {error}"
            );
        }
        let error = BooleanFormula::parse("a | c", &["a", "b"]).unwrap_err();
        assert_eq!(error.to_string(), "at byte 4: there is no input \"c\"; the inputs are a, b");
    }

    /// A formula with all parentheses, and its table by itself.
    fn formulas() -> impl Strategy<Value = (String, u16)> {
        let tables = [0xaaaa, 0xcccc, 0xf0f0, 0xff00];
        let leaf =
            (0usize..4).prop_map(move |input| (char::from(b'a' + input as u8).to_string(), tables[input]));
        leaf.prop_recursive(5, 40, 2, |inner| {
            (inner.clone(), inner, 0u8..5).prop_map(|((s, x), (t, y), operator)| match operator {
                0 => (format!("!{s}"), !x),
                1 => (format!("({s}&{t})"), x & y),
                2 => (format!("({s} - {t})"), x & !y),
                3 => (format!("({s} ^{t})"), x ^ y),
                _ => (format!("({s}| {t})"), x | y),
            })
        })
    }

    proptest! {
        #[test]
        fn formulas_have_their_tables((text, expected) in formulas()) {
            let found = table(&text);
            prop_assert!((0..16).all(|i| found[i] == (expected >> i & 1 == 1)), "{}", text);
        }

        #[test]
        fn no_text_is_a_panic(text in "[ab0-9 ()!~&^|_é-]{0,30}") {
            let _ = BooleanFormula::parse(&text, &[]);
        }
    }
}
