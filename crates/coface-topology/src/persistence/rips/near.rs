//! Which points are near each other, and at which rank.

/// The rank of a distance beyond the threshold, and of a point to itself.
pub(super) const FAR: u32 = u32::MAX;
/// The most points of a simplex.
pub(super) const MOST_POINTS: usize = 18;

/// The ranks of the distances up to a threshold.
pub(super) trait Near: Sync {
    /// The rank of the distance of two points; [`FAR`] beyond the threshold.
    fn rank(&self, i: u32, j: u32) -> u32;

    /// Makes the rank of the distance of two points that are near another one; [`FAR`] takes it away.
    fn set_rank(&mut self, i: u32, j: u32, rank: u32);

    /// Goes through the points from the last one down to `least` that are near all of some points, with the largest of their ranks, until
    /// `visit` gives something.
    fn common<T>(&self, points: &[u32], least: u32, visit: impl FnMut(u32, u32) -> Option<T>) -> Option<T>;
}

/// All ranks in a square.
pub(super) struct Square {
    count: usize,
    ranks: Vec<u32>,
}

/// So many ranks are looked at together.
const BLOCK: usize = 64;

impl Square {
    pub(super) fn new(count: usize, pairs: impl Iterator<Item = (u32, u32, u32)>) -> Self {
        let mut ranks = vec![FAR; count * count];
        for (i, j, rank) in pairs {
            ranks[i as usize * count + j as usize] = rank;
            ranks[j as usize * count + i as usize] = rank;
        }
        Self { count, ranks }
    }

    fn row(&self, point: u32) -> &[u32] {
        &self.ranks[point as usize * self.count..][..self.count]
    }
}

impl Near for Square {
    fn rank(&self, i: u32, j: u32) -> u32 {
        self.ranks[i as usize * self.count + j as usize]
    }

    fn set_rank(&mut self, i: u32, j: u32, rank: u32) {
        self.ranks[i as usize * self.count + j as usize] = rank;
        self.ranks[j as usize * self.count + i as usize] = rank;
    }

    fn common<T>(
        &self,
        points: &[u32],
        least: u32,
        mut visit: impl FnMut(u32, u32) -> Option<T>,
    ) -> Option<T> {
        let least = least as usize;
        let mut largest = [0u32; BLOCK];
        let mut end = self.count;
        while end > least {
            let start = least.max(end.saturating_sub(BLOCK));
            let largest = &mut largest[..end - start];
            largest.fill(0);
            for &point in points {
                for (most, &rank) in largest.iter_mut().zip(&self.row(point)[start..end]) {
                    *most = rank.max(*most);
                }
            }
            for (i, &rank) in largest.iter().enumerate().rev() {
                if rank != FAR
                    && let Some(found) = visit((start + i) as u32, rank)
                {
                    return Some(found);
                }
            }
            end = start;
        }
        None
    }
}

/// For each point the points near it, from the last one down.
pub(super) struct Lists {
    starts: Vec<usize>,
    /// Points and ranks.
    near: Vec<(u32, u32)>,
}

impl Lists {
    pub(super) fn new(count: usize, pairs: impl Iterator<Item = (u32, u32, u32)> + Clone) -> Self {
        let mut starts = vec![0; count + 1];
        for (i, j, _) in pairs.clone() {
            starts[i as usize + 1] += 1;
            starts[j as usize + 1] += 1;
        }
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut near = vec![(0, 0); starts[count]];
        for (i, j, rank) in pairs {
            for (from, to) in [(i, j), (j, i)] {
                near[next[from as usize]] = (to, rank);
                next[from as usize] += 1;
            }
        }
        for i in 0..count {
            near[starts[i]..starts[i + 1]].sort_unstable_by(|a, b| b.cmp(a));
        }
        Self { starts, near }
    }

    fn list(&self, point: u32) -> &[(u32, u32)] {
        &self.near[self.starts[point as usize]..self.starts[point as usize + 1]]
    }
}

impl Near for Lists {
    fn rank(&self, i: u32, j: u32) -> u32 {
        let list = self.list(i);
        list.binary_search_by(|&(point, _)| j.cmp(&point)).map_or(FAR, |at| list[at].1)
    }

    fn set_rank(&mut self, i: u32, j: u32, rank: u32) {
        for (from, to) in [(i, j), (j, i)] {
            let places = self.starts[from as usize]..self.starts[from as usize + 1];
            let list = &mut self.near[places];
            if let Ok(at) = list.binary_search_by(|&(point, _)| to.cmp(&point)) {
                list[at].1 = rank;
            }
        }
    }

    fn common<T>(
        &self,
        points: &[u32],
        least: u32,
        mut visit: impl FnMut(u32, u32) -> Option<T>,
    ) -> Option<T> {
        let mut lists: [&[(u32, u32)]; MOST_POINTS] = [&[]; MOST_POINTS];
        for (list, &point) in lists.iter_mut().zip(points) {
            *list = self.list(point);
        }
        let lists = &mut lists[..points.len()];
        // The shortest one leads.
        let shortest = (0..lists.len()).min_by_key(|&i| lists[i].len())?;
        lists.swap(0, shortest);
        let (lead, others) = lists.split_first_mut()?;
        'points: for &(point, rank) in *lead {
            if point < least {
                return None;
            }
            let mut most = rank;
            for list in others.iter_mut() {
                while let Some(&(other, _)) = list.first()
                    && other > point
                {
                    *list = &list[1..];
                }
                let &(other, rank) = list.first()?;
                if other != point {
                    continue 'points;
                }
                most = most.max(rank);
            }
            if let Some(found) = visit(point, most) {
                return Some(found);
            }
        }
        None
    }
}
