//! What the cells of a file become in the model.

use crate::GroupKind;
use crate::numbers::Numbers;

/// What cells of the file became, for runs of cells that became elements of one kind, one after the other.
#[derive(Debug, Default)]
pub(super) struct Cells {
    /// By the place of their section in the order of data.
    runs: [Vec<Run>; 4],
}

#[derive(Debug)]
struct Run {
    /// `None` for cells that became points or nothing.
    kind: Option<GroupKind>,
    /// The first element.
    first: u32,
    /// How many cells.
    count: u64,
    /// How many elements each of them became.
    elements: u32,
}

impl Cells {
    /// The next cell of a section became these elements.
    pub(super) fn add(&mut self, section: usize, kind: Option<GroupKind>, first: u32, elements: u32) {
        if let Some(run) = self.runs[section].last_mut()
            && run.kind == kind
            && run.elements == elements
            && (kind.is_none() || u64::from(run.first) + run.count * u64::from(elements) == u64::from(first))
        {
            run.count += 1;
            return;
        }
        self.runs[section].push(Run { kind, first, count: 1, elements });
    }

    fn runs(&self) -> impl Iterator<Item = &Run> {
        self.runs.iter().flatten()
    }

    pub(super) fn count(&self) -> u64 {
        self.runs().map(|run| run.count).sum()
    }

    /// The numbers on elements of one kind: each has those of the cell that it comes from.
    pub(super) fn numbers_on(
        &self,
        kind: GroupKind,
        count: usize,
        components: usize,
        all: &Numbers,
    ) -> Numbers {
        let mut order: Vec<(u32, u64, &Run)> = Vec::new();
        let mut cell = 0;
        for run in self.runs() {
            if run.kind == Some(kind) {
                order.push((run.first, cell, run));
            }
            cell += run.count;
        }
        order.sort_unstable_by_key(|&(first, ..)| first);
        let mut numbers = all.of_same_type();
        for (_, cell, run) in order {
            let start = cell as usize * components;
            if run.elements == 1 {
                numbers.extend(all, start..start + run.count as usize * components);
                continue;
            }
            for row in all_rows(start, run.count, components) {
                for _ in 0..run.elements {
                    numbers.extend(all, row.clone());
                }
            }
        }
        debug_assert_eq!(numbers.len(), count * components, "every element comes from a cell");
        numbers
    }
}

/// The kinds of cells with data of their own.
pub(super) const KINDS: [GroupKind; 3] = [GroupKind::Lines, GroupKind::Polygons, GroupKind::Cells];

/// The places of so many rows from a start on.
fn all_rows(start: usize, count: u64, components: usize) -> impl Iterator<Item = std::ops::Range<usize>> {
    (0..count as usize).map(move |i| start + i * components..start + (i + 1) * components)
}
