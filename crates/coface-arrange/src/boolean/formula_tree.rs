//! Formulas as trees, with all operands of an operator beside each other.

use super::BooleanFormula;
use super::formula::Step;

/// So deep a tree may be.
const MOST_LEVELS: usize = 64;
/// More operands on the right of an operator stay together, so that parentheses in parentheses are not moved each time.
const MOST_MOVED: usize = 1_000;

/// A formula as a tree: an operator has as many operands as are written with it, however they are in parentheses.
///
/// # Examples
/// ```
/// use coface_arrange::boolean::{BooleanFormula, FormulaTree, TreeOperator};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let formula = BooleanFormula::parse("a | (b | c)", &[])?;
/// let operands = vec![FormulaTree::Input(0), FormulaTree::Input(1), FormulaTree::Input(2)];
/// assert_eq!(FormulaTree::of(&formula), Some(FormulaTree::Operation(TreeOperator::Union, operands)));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FormulaTree {
    /// An input by its number.
    Input(usize),
    /// What is not in it.
    Complement(Box<FormulaTree>),
    /// Two or more operands with an operator between them.
    Operation(TreeOperator, Vec<FormulaTree>),
}

/// An operator between two or more operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TreeOperator {
    /// What is in one of them.
    Union,
    /// What is in all of them.
    Intersection,
    /// What is in the first and in none of the others.
    Difference,
    /// What is in an odd number of them.
    Xor,
}

impl FormulaTree {
    /// The tree of a formula; none if it is more than 64 levels deep.
    ///
    /// # Complexity
    /// Linear in the length of the formula.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::{BooleanFormula, FormulaTree, TreeOperator};
    /// let FormulaTree::Operation(operator, operands) = FormulaTree::of(&BooleanFormula::difference(4)).expect("flat")
    /// else { panic!("four operands") };
    /// assert_eq!((operator, operands.len()), (TreeOperator::Difference, 4));
    /// ```
    pub fn of(formula: &BooleanFormula) -> Option<Self> {
        // Trees with their depths.
        let mut stack: Vec<(Self, usize)> = Vec::new();
        for step in formula.steps() {
            let made = match step {
                Step::Input(input) => (Self::Input(*input as usize), 0),
                Step::Complement => {
                    let (operand, depth) = stack.pop()?;
                    (Self::Complement(Box::new(operand)), depth + 1)
                }
                Step::Union => joined(TreeOperator::Union, &mut stack)?,
                Step::Intersection => joined(TreeOperator::Intersection, &mut stack)?,
                Step::Difference => joined(TreeOperator::Difference, &mut stack)?,
                Step::Xor => joined(TreeOperator::Xor, &mut stack)?,
            };
            if made.1 > MOST_LEVELS {
                return None;
            }
            stack.push(made);
        }
        stack.pop().map(|(tree, _)| tree)
    }

    /// The formula that has this tree.
    ///
    /// # Panics
    /// For an operator without operands.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::{BooleanFormula, FormulaTree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let formula = BooleanFormula::parse("a - b - !(c & d)", &[])?;
    /// assert_eq!(FormulaTree::of(&formula).expect("three levels").to_formula(), formula);
    /// # Ok(()) }
    /// ```
    pub fn to_formula(&self) -> BooleanFormula {
        let mut steps = Vec::new();
        self.push_steps(&mut steps);
        BooleanFormula::of_steps(steps)
    }

    /// The inputs in the order in which they are named.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::{BooleanFormula, FormulaTree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let formula = BooleanFormula::parse("c - a & c", &[])?;
    /// assert_eq!(FormulaTree::of(&formula).expect("two levels").inputs(), [2, 0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn inputs(&self) -> Vec<usize> {
        match self {
            Self::Input(input) => vec![*input],
            Self::Complement(operand) => operand.inputs(),
            Self::Operation(_, operands) => operands.iter().flat_map(Self::inputs).collect(),
        }
    }

    fn push_steps(&self, steps: &mut Vec<Step>) {
        match self {
            // Inputs of a formula are numbered with 32 bits.
            Self::Input(input) => steps.push(Step::Input(*input as u32)),
            Self::Complement(operand) => {
                operand.push_steps(steps);
                steps.push(Step::Complement);
            }
            Self::Operation(operator, operands) => {
                assert!(!operands.is_empty(), "an operator without operands");
                let step = match operator {
                    TreeOperator::Union => Step::Union,
                    TreeOperator::Intersection => Step::Intersection,
                    TreeOperator::Difference => Step::Difference,
                    TreeOperator::Xor => Step::Xor,
                };
                for (place, operand) in operands.iter().enumerate() {
                    operand.push_steps(steps);
                    if place > 0 {
                        steps.push(step);
                    }
                }
            }
        }
    }
}

/// The last two operands with an operator between them.
fn joined(operator: TreeOperator, stack: &mut Vec<(FormulaTree, usize)>) -> Option<(FormulaTree, usize)> {
    let ((right, right_depth), (left, left_depth)) = (stack.pop()?, stack.pop()?);
    let (mut operands, left_depth) = match left {
        FormulaTree::Operation(own, operands) if own == operator => (operands, left_depth),
        other => (vec![other], left_depth + 1),
    };
    let right_depth = match right {
        // What is subtracted is not subtracted from.
        FormulaTree::Operation(own, others)
            if own == operator && operator != TreeOperator::Difference && others.len() <= MOST_MOVED =>
        {
            operands.extend(others);
            right_depth
        }
        other => {
            operands.push(other);
            right_depth + 1
        }
    };
    Some((FormulaTree::Operation(operator, operands), left_depth.max(right_depth)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn trees() -> impl Strategy<Value = FormulaTree> {
        let leaf = (0usize..5).prop_map(FormulaTree::Input);
        leaf.prop_recursive(4, 40, 4, |inner| {
            let operator = prop_oneof![
                Just(TreeOperator::Union),
                Just(TreeOperator::Intersection),
                Just(TreeOperator::Difference),
                Just(TreeOperator::Xor)
            ];
            prop_oneof![
                inner.clone().prop_map(|own| FormulaTree::Complement(Box::new(own))),
                (operator, prop::collection::vec(inner, 2..5))
                    .prop_map(|(operator, operands)| FormulaTree::Operation(operator, operands)),
            ]
        })
    }

    proptest! {
        #[test]
        fn trees_have_the_tables_of_their_formulas(tree in trees()) {
            let formula = tree.to_formula();
            let again = FormulaTree::of(&formula).unwrap().to_formula();
            for inputs in 0..32u32 {
                let is_in = |input: usize| inputs >> input & 1 == 1;
                prop_assert_eq!(formula.evaluate(is_in), again.evaluate(is_in));
            }
            prop_assert_eq!(formula.input_count(), again.input_count());
        }
    }

    #[test]
    fn operands_are_beside_each_other() {
        let operands = |text: &str| match FormulaTree::of(&BooleanFormula::parse(text, &[]).unwrap()) {
            Some(FormulaTree::Operation(_, operands)) => operands.len(),
            _ => 0,
        };
        assert_eq!(operands("(a | b) | (c | d)"), 4);
        assert_eq!(operands("a & (b & c)"), 3);
        assert_eq!(operands("(a - b) - c"), 3);
        assert_eq!(operands("a - (b - c)"), 2);
        assert_eq!(operands("!a"), 0);
        // Of a long sum without parentheses the tree is flat, of one in parentheses too.
        assert!(FormulaTree::of(&BooleanFormula::union(100_000)).is_some());
        let deep = format!("{}a{}", "(b | a & ".repeat(200), ")".repeat(200));
        assert_eq!(FormulaTree::of(&BooleanFormula::parse(&deep, &[]).unwrap()), None);
    }
}
