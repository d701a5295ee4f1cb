//! Finite groups by their multiplication tables, and which of the well-known ones they are.

use crate::groups::CosetTable;
use std::collections::BTreeMap;

/// A finite group: elements 0, 1, ..., with 0 the unit.
#[derive(Clone, Debug)]
pub(super) struct FiniteGroup {
    order: usize,
    /// The product of i and j at position `i * order + j`.
    products: Vec<u32>,
    /// The least positive power of each element that is the unit.
    orders: Vec<u32>,
}

impl FiniteGroup {
    /// Groups with more elements have no table.
    pub(super) const LARGEST: usize = 1000;

    /// The group whose elements are the cosets of the trivial subgroup; `None` if it is too large for a table.
    pub(super) fn new(cosets: &CosetTable) -> Option<Self> {
        let order = cosets.index();
        if order > Self::LARGEST {
            return None;
        }
        let mut products = vec![0; order * order];
        let words = cosets.representatives();
        for i in 0..order {
            for (j, word) in words.iter().enumerate() {
                products[i * order + j] = cosets.image_by(i, word) as u32;
            }
        }
        Some(Self::from_products(order, products))
    }

    fn from_products(order: usize, products: Vec<u32>) -> Self {
        let mut group = Self { order, products, orders: Vec::new() };
        group.orders = (0..order)
            .map(|x| {
                let mut power = x;
                let mut exponent = 1;
                while power != 0 {
                    power = group.product(power, x);
                    exponent += 1;
                }
                exponent
            })
            .collect();
        group
    }

    fn product(&self, a: usize, b: usize) -> usize {
        self.products[a * self.order + b] as usize
    }

    fn power(&self, x: usize, exponent: usize) -> usize {
        (0..exponent).fold(0, |power, _| self.product(power, x))
    }

    fn elements_of_order(&self, order: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.order).filter(move |&x| self.orders[x] as usize == order)
    }

    /// Whether these elements generate the group.
    fn is_generated_by(&self, elements: &[usize]) -> bool {
        let mut is_met = vec![false; self.order];
        is_met[0] = true;
        let mut queue = vec![0];
        while let Some(x) = queue.pop() {
            for &y in elements {
                let next = self.product(x, y);
                if !std::mem::replace(&mut is_met[next], true) {
                    queue.push(next);
                }
            }
        }
        is_met.into_iter().all(|met| met)
    }

    /// The known group of the same order that this is: two elements are found that generate it and satisfy the relators
    /// of that group. So it is a quotient of that group (W. von Dyck), and equal orders make the two isomorphic.
    pub(super) fn name(&self) -> Option<String> {
        self.polyhedral_name()
            .or_else(|| self.dihedral_name())
            .or_else(|| self.dicyclic_name())
            .or_else(|| self.name_with_cyclic_factor())
    }

    fn polyhedral_name(&self) -> Option<String> {
        // x^a = y^b = (xy)^2, which is the unit or, in the binary groups, an involution.
        let known = match self.order {
            12 => ("A4", 3, 3, false),
            24 if self.orders.iter().filter(|&&order| order == 2).count() > 1 => ("S4", 3, 4, false),
            24 => ("SL(2,3)", 3, 3, true),
            48 => ("binary octahedral group", 3, 4, true),
            60 => ("A5", 3, 5, false),
            120 => ("SL(2,5)", 3, 5, true),
            _ => return None,
        };
        let (name, a, b, is_binary) = known;
        let factor = if is_binary { 2 } else { 1 };
        let found = self.elements_of_order(a * factor).any(|x| {
            self.elements_of_order(b * factor).any(|y| {
                let end = self.power(x, a);
                self.power(y, b) == end
                    && self.power(self.product(x, y), 2) == end
                    && self.is_generated_by(&[x, y])
            })
        });
        found.then(|| name.to_owned())
    }

    fn dihedral_name(&self) -> Option<String> {
        let half = self.order / 2;
        if !self.order.is_multiple_of(2) || half < 3 {
            return None;
        }
        // From 3 on all rotations of the greatest order generate the same subgroup: the first is as good as any.
        let x = self.elements_of_order(half).next()?;
        let found = self
            .elements_of_order(2)
            .any(|y| self.power(self.product(x, y), 2) == 0 && self.is_generated_by(&[x, y]));
        found.then(|| match half {
            3 => "S3".to_owned(),
            _ => format!("dihedral group of order {}", self.order),
        })
    }

    fn dicyclic_name(&self) -> Option<String> {
        if !self.order.is_multiple_of(4) || self.order < 8 {
            return None;
        }
        let found = self.elements_of_order(self.order / 2).any(|x| {
            self.elements_of_order(4).any(|y| {
                // y^2 = x^n and y^-1 x y = x^-1, that is x y x = y.
                self.power(y, 2) == self.power(x, self.order / 4)
                    && self.product(self.product(x, y), x) == y
                    && self.is_generated_by(&[x, y])
            })
        });
        found.then(|| match self.order {
            8 => "Q8".to_owned(),
            order => format!("dicyclic group of order {order}"),
        })
    }

    /// The name as a product with a cyclic group of coprime order in the center: a central Hall subgroup is a direct
    /// factor, and the other one has the elements whose order divides the rest.
    fn name_with_cyclic_factor(&self) -> Option<String> {
        let is_central = |x: usize| (0..self.order).all(|y| self.product(x, y) == self.product(y, x));
        let best = (0..self.order)
            .filter(|&x| {
                let order = self.orders[x] as usize;
                order > 1 && gcd(order, self.order / order) == 1 && is_central(x)
            })
            .max_by_key(|&x| (self.orders[x], std::cmp::Reverse(x)))?;
        let cyclic = self.orders[best] as usize;
        let rest = self.order / cyclic;
        let elements: Vec<usize> =
            (0..self.order).filter(|&x| rest.is_multiple_of(self.orders[x] as usize)).collect();
        let number: BTreeMap<usize, u32> = elements.iter().zip(0..).map(|(&x, i)| (x, i)).collect();
        let mut products = Vec::with_capacity(rest * rest);
        for &x in &elements {
            for &y in &elements {
                products.push(*number.get(&self.product(x, y))?);
            }
        }
        let factor = Self::from_products(rest, products);
        Some(format!("{} x Z/{cyclic}", factor.name()?))
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}
