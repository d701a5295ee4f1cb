//! Vertices that are near each other become one.

use super::{NearChains, compare, minus, plus, squared};
use coface_algebra::UnionFind;
use coface_geometry::{AxisBox, BoxTree};
use rayon::prelude::*;

impl NearChains {
    /// Puts vertices together, nearest pairs first, while all of a class stay within the tolerance of each other. A
    /// class goes to the one of its members that is nearest to their mean; new points give way to others.
    pub(super) fn join_vertices(&mut self, tolerance: f64) -> bool {
        let equal = self.join_equal_vertices();
        let used = self.hot_vertices();
        let boxes: Vec<AxisBox> = used.iter().map(|&own| self.box_of([own], tolerance / 2.0)).collect();
        let tree = BoxTree::new(&boxes);
        let limit = tolerance * tolerance;
        let mut pairs: Vec<(f64, [u32; 2])> = (0..tree.group_count())
            .into_par_iter()
            .flat_map_iter(|group| {
                let mut own = Vec::new();
                tree.pairs_of_group(group, |i, j| {
                    let (a, b) = (self.point(used[i as usize]), self.point(used[j as usize]));
                    let distance = squared(minus(a, b));
                    if distance <= limit {
                        own.push((distance, if compare(a, b).is_lt() { [i, j] } else { [j, i] }));
                    }
                });
                own
            })
            .collect();
        if pairs.is_empty() {
            return equal;
        }
        let place = |i: u32| self.point(used[i as usize]);
        pairs.par_sort_unstable_by(|(x, [a, b]), (y, [c, d])| {
            x.total_cmp(y).then_with(|| compare(place(*a), place(*c)).then(compare(place(*b), place(*d))))
        });
        let mut classes = UnionFind::new(used.len());
        let mut members: Vec<Vec<u32>> = (0..used.len() as u32).map(|i| vec![i]).collect();
        for (_, [i, j]) in pairs {
            let [x, y] = [i, j].map(|own| classes.find(own) as usize);
            if x == y {
                continue;
            }
            let is_near = |&a: &u32| members[y].iter().all(|&b| squared(minus(place(a), place(b))) <= limit);
            if members[x].iter().all(is_near) {
                classes.unite(i, j);
                let root = classes.find(i) as usize;
                let other = if root == x { y } else { x };
                let moved = std::mem::take(&mut members[other]);
                members[root].extend(moved);
            }
        }
        let mut new_targets: Vec<(u32, u32)> = Vec::new();
        for class in members.iter().filter(|class| class.len() > 1) {
            let best = self.representative(&used, class);
            let others = class.iter().map(|&i| used[i as usize]);
            let others = others.filter(|&own| own != best && self.may_go(own, best));
            new_targets.extend(others.map(|own| (own, best)));
        }
        self.counts.vertices += new_targets.len();
        self.put(&new_targets);
        equal || !new_targets.is_empty()
    }

    /// The member of a class that is nearest to the mean of those that come first.
    fn representative(&self, used: &[u32], class: &[u32]) -> u32 {
        let own: Vec<u32> = class.iter().map(|&i| used[i as usize]).collect();
        let is_original = |vertex: &u32| !self.is_passing[*vertex as usize];
        let some_original = own.iter().any(is_original);
        let mut first: Vec<u32> =
            own.into_iter().filter(|vertex| !some_original || is_original(vertex)).collect();
        first.sort_by(|&a, &b| compare(self.point(a), self.point(b)));
        let origin = self.point(first[0]);
        let weight = 1.0 / first.len() as f64;
        let mean = first.iter().fold([0.0; 3], |sum, &own| plus(sum, weight, minus(self.point(own), origin)));
        let distance = |vertex: u32| squared(minus(minus(self.point(vertex), origin), mean));
        first.into_iter().min_by(|&a, &b| distance(a).total_cmp(&distance(b))).expect("classes have members")
    }

    /// Vertices at the same place become the first of them.
    fn join_equal_vertices(&mut self) -> bool {
        let mut used = self.used();
        let key = |point: [f64; 3]| point.map(|x| (x + 0.0).to_bits());
        let is_passing = |own: u32| self.is_passing[own as usize];
        used.par_sort_unstable_by_key(|&own| (key(self.point(own)), is_passing(own), own));
        let mut new_targets = Vec::new();
        for class in used.chunk_by(|&a, &b| key(self.point(a)) == key(self.point(b))) {
            new_targets.extend(class[1..].iter().map(|&own| (own, class[0])));
        }
        if !new_targets.is_empty() {
            self.put(&new_targets);
        }
        !new_targets.is_empty()
    }

    /// Puts vertices to others, which are put nowhere themselves.
    pub(super) fn put(&mut self, new_targets: &[(u32, u32)]) {
        for &(own, target) in new_targets {
            self.note_way(own, target);
            self.target[own as usize] = target;
        }
        for chain in &mut self.chains {
            chain.put(&self.target);
        }
        self.lines.as_flattened_mut().iter_mut().for_each(|end| *end = self.target[*end as usize]);
        self.lines.retain(|[a, b]| a != b);
        self.alone.iter_mut().for_each(|vertex| *vertex = self.target[*vertex as usize]);
    }
}
