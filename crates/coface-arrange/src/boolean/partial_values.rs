//! Formulas of many inputs of which few are true, and some may be unknown.

use super::BooleanFormula;
use super::formula::Step;

/// A value that may be unknown.
type Partial = Option<bool>;

/// What combines the values of any number of terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Some term is true.
    Any,
    /// All terms are true.
    All,
    /// An odd number of terms is true.
    Odd,
}

/// Where a value goes: a node, and whether it is turned around on the way.
#[derive(Clone, Copy, Debug)]
struct Term {
    node: u32,
    is_negated: bool,
}

/// The root has itself as its place.
const ROOT: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Node {
    kind: Kind,
    into: Term,
    /// How many terms there are, are true, and are unknown.
    count: u32,
    trues: u32,
    unknowns: u32,
}

impl Node {
    fn value(&self) -> Partial {
        match self.kind {
            Kind::Any if self.trues > 0 => Some(true),
            Kind::All if self.trues + self.unknowns < self.count => Some(false),
            _ if self.unknowns > 0 => None,
            Kind::Any => Some(false),
            Kind::All => Some(true),
            Kind::Odd => Some(self.trues % 2 == 1),
        }
    }

    fn count(&mut self, value: Partial, by: u32) {
        match value {
            Some(true) => self.trues = self.trues.wrapping_add(by),
            None => self.unknowns = self.unknowns.wrapping_add(by),
            Some(false) => {}
        }
    }
}

/// The values of a formula where some inputs are true, some unknown and all others false: a union of a thousand inputs
/// is asked about the few that matter.
///
/// What is unknown is taken as independent: of `a - a` nothing is known where `a` is unknown.
///
/// # Examples
/// ```
/// use coface_arrange::boolean::{BooleanFormula, PartialValues};
/// let mut union = PartialValues::new(&BooleanFormula::union(1000));
/// assert_eq!(union.value([7], [3, 4]), Some(true));
/// assert_eq!(union.value([], [3]), None);
/// assert_eq!(union.value([], []), Some(false));
/// ```
#[derive(Clone, Debug)]
pub struct PartialValues {
    nodes: Vec<Node>,
    /// Where each input goes; one after the other.
    places: Vec<Vec<Term>>,
    root: Term,
}

impl PartialValues {
    /// The values of this formula.
    ///
    /// # Complexity
    /// Linear in the formula. A value costs as many steps as operators that cannot be made one are around its inputs.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::{BooleanFormula, PartialValues};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut rest = PartialValues::new(&BooleanFormula::parse("a - b", &[])?);
    /// // What is in b is not in the difference, whether or not it is in a.
    /// assert_eq!(rest.value([1], [0]), Some(false));
    /// # Ok(()) }
    /// ```
    pub fn new(formula: &BooleanFormula) -> Self {
        let mut found = Self {
            nodes: Vec::new(),
            places: vec![Vec::new(); formula.input_count()],
            root: Term { node: 0, is_negated: false },
        };
        // An input is a node of one term, so that all operands are nodes.
        let mut stack: Vec<Term> = Vec::new();
        for &step in formula.steps() {
            let term = match step {
                Step::Input(input) => {
                    let term = found.add(Kind::Any);
                    found.nodes[term.node as usize].count = 1;
                    found.places[input as usize].push(term);
                    term
                }
                Step::Complement => negated(stack.pop().expect("a complement has an operand")),
                _ => {
                    let b = stack.pop().expect("an operator has two operands");
                    let a = stack.pop().expect("an operator has two operands");
                    match step {
                        Step::Intersection => found.join(Kind::All, a, b),
                        Step::Difference => found.join(Kind::All, a, negated(b)),
                        Step::Xor => found.join(Kind::Odd, a, b),
                        _ => found.join(Kind::Any, a, b),
                    }
                }
            };
            stack.push(term);
        }
        found.root = stack.pop().expect("a formula has a value");
        // With all inputs false: nodes come before those that they go into, or grow into them.
        let mut order: Vec<u32> = (0..found.nodes.len() as u32).collect();
        order.sort_by_key(|&node| std::cmp::Reverse(found.depth(node)));
        for node in order {
            let Node { into, .. } = found.nodes[node as usize];
            let value = found.nodes[node as usize].value();
            if into.node != ROOT {
                found.nodes[into.node as usize].count(turned(value, into.is_negated), 1);
            }
        }
        found
    }

    fn add(&mut self, kind: Kind) -> Term {
        let into = Term { node: ROOT, is_negated: false };
        self.nodes.push(Node { kind, into, count: 0, trues: 0, unknowns: 0 });
        Term { node: self.nodes.len() as u32 - 1, is_negated: false }
    }

    /// An operator on two terms. A term with the same operator gets the other one added.
    fn join(&mut self, kind: Kind, a: Term, b: Term) -> Term {
        let own = &self.nodes[a.node as usize];
        let is_same = own.kind == kind && own.count > 1 && !a.is_negated;
        let node = if is_same { a } else { self.add(kind) };
        for term in [a, b].into_iter().skip(usize::from(is_same)) {
            self.nodes[term.node as usize].into = Term { node: node.node, is_negated: term.is_negated };
            self.nodes[node.node as usize].count += 1;
        }
        node
    }

    fn depth(&self, node: u32) -> usize {
        std::iter::successors(Some(node), |&node| {
            Some(self.nodes[node as usize].into.node).filter(|&n| n != ROOT)
        })
        .count()
    }

    /// Whether the formula holds where these inputs are true, these unknown and all others false; `None` where that
    /// depends on the unknown ones. Inputs come once; those that the formula does not name make no difference.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::{BooleanFormula, PartialValues};
    /// let mut odd = PartialValues::new(&BooleanFormula::xor(5));
    /// assert_eq!((odd.value([1, 2, 4], []), odd.value([1], [2])), (Some(true), None));
    /// ```
    pub fn value(
        &mut self,
        trues: impl IntoIterator<Item = u32> + Clone,
        unknowns: impl IntoIterator<Item = u32> + Clone,
    ) -> Option<bool> {
        let (was, is) = (Some(false), Some(true));
        trues.clone().into_iter().for_each(|input| self.set(input, was, is));
        unknowns.clone().into_iter().for_each(|input| self.set(input, was, None));
        let value = turned(self.nodes[self.root.node as usize].value(), self.root.is_negated);
        trues.into_iter().for_each(|input| self.set(input, is, was));
        unknowns.into_iter().for_each(|input| self.set(input, None, was));
        value
    }

    /// Whether nothing is known of the value as long as one input is unknown: an xor of inputs.
    #[doc(hidden)]
    pub fn depends_on_all(&self) -> bool {
        let is_term =
            |node: &Node| node.into.node == self.root.node && node.kind == Kind::Any && node.count == 1;
        (0..).zip(&self.nodes).all(|(number, node)| {
            if number == self.root.node { node.kind == Kind::Odd } else { is_term(node) }
        })
    }

    fn set(&mut self, input: u32, was: Partial, is: Partial) {
        let Some(places) = self.places.get(input as usize) else { return };
        for &place in places {
            let (mut at, mut change) = (place, [was, is]);
            while at.node != ROOT && change[0] != change[1] {
                let [was, is] = change.map(|value| turned(value, at.is_negated));
                let node = &mut self.nodes[at.node as usize];
                let before = node.value();
                node.count(was, u32::MAX);
                node.count(is, 1);
                change = [before, node.value()];
                at = node.into;
            }
        }
    }
}

fn negated(term: Term) -> Term {
    Term { is_negated: !term.is_negated, ..term }
}

fn turned(value: Partial, is_negated: bool) -> Partial {
    value.map(|value| value != is_negated)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Formulas of up to four inputs as texts.
    fn formulas() -> impl Strategy<Value = String> {
        let leaf = (0u8..4).prop_map(|input| char::from(b'a' + input).to_string());
        leaf.prop_recursive(5, 30, 2, |inner| {
            (inner.clone(), inner, 0usize..5).prop_map(|(s, t, operator)| match operator {
                0 => format!("!{s}"),
                _ => format!("({s}{}{t})", ["&", "-", "^", "|"][operator - 1]),
            })
        })
    }

    proptest! {
        /// A known value is that of the formula whatever the unknown inputs are; without unknown ones it is known.
        #[test]
        fn known_values_are_values(text in formulas(), trues in 0u32..16, unknowns in 0u32..16) {
            let formula = BooleanFormula::parse(&text, &[]).unwrap();
            let mut values = PartialValues::new(&formula);
            let list = |bits: u32| (0..4).filter(|i| bits >> i & 1 == 1).collect::<Vec<u32>>();
            let unknowns = unknowns & !trues;
            let found = values.value(list(trues), list(unknowns));
            for more in (0..16).filter(|more| more & !unknowns == 0) {
                let value = formula.evaluate(|input| (trues | more) >> input & 1 == 1);
                prop_assert!(found.is_none_or(|found| found == value), "{}", text);
                // The counts are put back each time.
                prop_assert_eq!(values.value(list(trues | more), []), Some(value), "{}", text);
            }
        }
    }

    #[test]
    fn an_xor_of_inputs_depends_on_all() {
        let depends = |text| PartialValues::new(&BooleanFormula::parse(text, &[]).unwrap()).depends_on_all();
        assert!(depends("a ^ b") && depends("a ^ !b ^ c"));
        assert!(!depends("a | b") && !depends("a ^ (b & c)") && !depends("a - b"));
    }

    #[test]
    fn chains_are_one_node() {
        for formula in [BooleanFormula::union(50), BooleanFormula::difference(50), BooleanFormula::xor(50)] {
            let values = PartialValues::new(&formula);
            assert!((0..values.nodes.len() as u32).all(|node| values.depth(node) <= 2));
        }
    }
}
