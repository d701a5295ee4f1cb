//! Keys: the set of parts that contain each cell.

use crate::chains::ChainComplex;
use crate::ids::narrow;
use crate::matrices::{Entry, RaggedArray};
use std::collections::BTreeMap;

/// Sets of part numbers, each held once, and which of them each cell has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Keys {
    /// The sets that occur, rising lists in lexicographic order.
    pub(super) sets: RaggedArray,
    /// For each degree the number of the set of each cell.
    pub(super) of_cell: Vec<Vec<u32>>,
}

impl Keys {
    /// The keys of cells whose maximal ones have owners.
    ///
    /// # Complexity
    /// Linear in the boundary matrices, but for cells whose cofaces have different keys: each of those costs a search
    /// among the sets.
    pub(super) fn of_owners<E: Entry>(complex: &ChainComplex<E>, owner: impl Fn(usize, u32) -> u32) -> Self {
        const NONE: u32 = u32::MAX;
        let mut sets = Sets::default();
        let mut of_cell: Vec<Vec<u32>> = complex.f_vector().iter().map(|&count| vec![NONE; count]).collect();
        for degree in (0..complex.degree_count()).rev() {
            let (below, from_here) = of_cell.split_at_mut(degree);
            let own = &mut from_here[0];
            for (cell, key) in own.iter_mut().enumerate().filter(|(_, key)| **key == NONE) {
                *key = sets.number(vec![owner(degree, narrow(cell))]);
            }
            let (Some(faces), Some(matrix)) = (below.last_mut(), complex.boundary_matrix(degree)) else {
                continue;
            };
            // Most faces see one key; those that see several are gathered with all of them.
            let mut mixed: Vec<(u32, u32)> = Vec::new();
            for (column, &key) in matrix.columns().zip(own.iter()) {
                for &face in column.rows() {
                    let known = &mut faces[face as usize];
                    if *known == NONE {
                        *known = key;
                    } else if *known != key {
                        mixed.extend([(face, *known), (face, key)]);
                    }
                }
            }
            mixed.sort_unstable();
            mixed.dedup();
            for group in mixed.chunk_by(|a, b| a.0 == b.0) {
                let numbers: Vec<u32> = group.iter().map(|&(_, key)| key).collect();
                faces[group[0].0 as usize] = sets.union(numbers);
            }
        }
        sets.into_keys(of_cell)
    }

    /// The keys of cells that are given as numbers of sets.
    pub(super) fn of_sets(key_sets: &RaggedArray, mut of_cell: Vec<Vec<u32>>) -> Self {
        let mut sets = Sets::default();
        let numbers: Vec<u32> = key_sets.iter().map(|set| sets.number(set.to_vec())).collect();
        of_cell.iter_mut().flatten().for_each(|key| *key = numbers[*key as usize]);
        sets.into_keys(of_cell)
    }

    /// The keys of some of the cells, those at these positions, with each part number replaced.
    pub(super) fn renamed<'c>(
        &self,
        cells: impl Iterator<Item = &'c [u32]>,
        rename: impl Fn(u32) -> u32,
    ) -> Self {
        let mut sets = Sets::default();
        let numbers: Vec<u32> = self
            .sets
            .iter()
            .map(|set| {
                let mut renamed: Vec<u32> = set.iter().map(|&part| rename(part)).collect();
                renamed.sort_unstable();
                renamed.dedup();
                sets.number(renamed)
            })
            .collect();
        let of_cell =
            self.of_cell.iter().zip(cells).map(|(keys, cells)| {
                cells.iter().map(|&cell| numbers[keys[cell as usize] as usize]).collect()
            });
        let of_cell = of_cell.collect();
        sets.into_keys(of_cell)
    }

    /// The key of a cell.
    pub(super) fn of(&self, degree: usize, cell: u32) -> &[u32] {
        self.sets.list(self.of_cell[degree][cell as usize] as usize)
    }

    /// Where each face's key contains its cell's, how large each key is: then pairs within keys go by rising size.
    pub(super) fn sizes(&self) -> Vec<u32> {
        self.sets.iter().map(|set| narrow(set.len())).collect()
    }
}

/// Sets while they are gathered.
#[derive(Default)]
pub(super) struct Sets {
    numbers: BTreeMap<Vec<u32>, u32>,
    unions: BTreeMap<Vec<u32>, u32>,
    sets: Vec<Vec<u32>>,
}

impl Sets {
    /// The number of a set, a rising list.
    pub(super) fn number(&mut self, set: Vec<u32>) -> u32 {
        if let Some(&number) = self.numbers.get(&set) {
            return number;
        }
        let number = narrow(self.sets.len());
        self.sets.push(set.clone());
        self.numbers.insert(set, number);
        number
    }

    /// The number of the union of sets with these numbers, a rising list.
    fn union(&mut self, numbers: Vec<u32>) -> u32 {
        if let Some(&number) = self.unions.get(&numbers) {
            return number;
        }
        let mut union: Vec<u32> =
            numbers.iter().flat_map(|&number| &self.sets[number as usize]).copied().collect();
        union.sort_unstable();
        union.dedup();
        let number = self.number(union);
        self.unions.insert(numbers, number);
        number
    }

    /// The sets that occur in lexicographic order, and their numbers in it.
    pub(super) fn into_keys(self, mut of_cell: Vec<Vec<u32>>) -> Keys {
        let mut occurs = vec![false; self.sets.len()];
        of_cell.iter().flatten().for_each(|&number| occurs[number as usize] = true);
        let mut position = vec![0; self.sets.len()];
        let mut sets = RaggedArray::new();
        for (set, &number) in self.numbers.iter().filter(|&(_, &number)| occurs[number as usize]) {
            position[number as usize] = narrow(sets.len());
            sets.push(set);
        }
        of_cell.iter_mut().flatten().for_each(|number| *number = position[*number as usize]);
        Keys { sets, of_cell }
    }
}
