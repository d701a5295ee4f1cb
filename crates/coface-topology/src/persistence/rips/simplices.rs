//! Simplices as numbers, their facets and cofacets.

use super::near::{FAR, MOST_POINTS, Near};

/// A simplex of a degree that is known: simplices are ordered as they enter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Simplex {
    pub(super) rank: u32,
    /// The complement of the index: the larger index enters first.
    complement: u64,
}

impl Simplex {
    pub(super) fn new(rank: u32, index: u64) -> Self {
        Self { rank, complement: !index }
    }

    pub(super) fn index(self) -> u64 {
        !self.complement
    }
}

/// The numbers C(n, k).
#[derive(Clone, Debug)]
pub(super) struct Binomials(Vec<Vec<u64>>);

impl Binomials {
    /// Those for n up to `count` and k up to `points`; `None` if one is beyond 63 bits.
    pub(super) fn new(count: usize, points: usize) -> Option<Self> {
        let mut rows = vec![vec![1u64; count + 1]];
        for k in 1..=points {
            let mut row = vec![0u64; count + 1];
            for n in 1..=count {
                let sum = row[n - 1].checked_add(rows[k - 1][n - 1])?;
                row[n] = Some(sum).filter(|sum| sum >> 63 == 0)?;
            }
            rows.push(row);
        }
        Some(Self(rows))
    }

    fn choose(&self, n: u32, k: usize) -> u64 {
        self.0[k][n as usize]
    }
}

/// The points of a simplex, from the last one down.
#[derive(Clone, Copy)]
pub(super) struct Points {
    points: [u32; MOST_POINTS],
    count: usize,
}

impl std::ops::Deref for Points {
    type Target = [u32];

    fn deref(&self) -> &[u32] {
        &self.points[..self.count]
    }
}

/// The simplices up to a threshold.
pub(super) struct Simplices<N> {
    pub(super) near: N,
    pub(super) binomials: Binomials,
}

impl<N: Near> Simplices<N> {
    /// The points of a simplex.
    pub(super) fn points(&self, degree: usize, index: u64) -> Points {
        let mut points = Points { points: [0; MOST_POINTS], count: degree + 1 };
        let mut rest = index;
        let mut end = self.binomials.0[0].len();
        for (i, k) in (1..=degree + 1).rev().enumerate() {
            let row = &self.binomials.0[k][..end];
            let point = row.partition_point(|&number| number <= rest) - 1;
            points.points[i] = point as u32;
            rest -= row[point];
            end = point;
        }
        points
    }

    /// Goes through the cofacets of a simplex as they enter among those of one diameter, by points down to `least`, with the place of the point
    /// that is added among the points of the cofacet, until `visit` gives something.
    pub(super) fn cofacets<T>(
        &self,
        simplex: Simplex,
        points: &[u32],
        least: u32,
        mut visit: impl FnMut(Simplex, usize) -> Option<T>,
    ) -> Option<T> {
        let count = points.len();
        let (mut above, mut below, mut place) = (0, simplex.index(), 0);
        self.near.common(points, least, |point, rank| {
            while place < count && points[place] > point {
                below -= self.binomials.choose(points[place], count - place);
                above += self.binomials.choose(points[place], count + 1 - place);
                place += 1;
            }
            let index = above + self.binomials.choose(point, count + 1 - place) + below;
            visit(Simplex::new(rank.max(simplex.rank), index), place)
        })
    }

    /// The last facet of a simplex to enter if it has the same diameter, with the place of the point that it lacks.
    fn last_facet(&self, simplex: Simplex, points: &[u32]) -> Option<(Simplex, usize)> {
        let count = points.len();
        let (mut above, mut below) = (0, simplex.index());
        for place in 0..count {
            below -= self.binomials.choose(points[place], count - place);
            let mut rank = 0;
            for i in 0..count {
                for j in i + 1..count {
                    if i != place && j != place {
                        rank = rank.max(self.near.rank(points[i], points[j]));
                    }
                }
            }
            debug_assert!(rank != FAR, "the faces of a simplex are within the threshold");
            if rank == simplex.rank {
                return Some((Simplex::new(rank, above + below), place));
            }
            above += self.binomials.choose(points[place], count - 1 - place);
        }
        None
    }

    /// The first cofacet of a simplex to enter if it has the same diameter.
    fn first_cofacet(&self, simplex: Simplex, points: &[u32]) -> Option<Simplex> {
        self.cofacets(simplex, points, 0, |cofacet, _| (cofacet.rank == simplex.rank).then_some(cofacet))
    }

    /// The facet with which a simplex is an apparent pair, with the place of the point that it lacks.
    pub(super) fn apparent_facet(&self, degree: usize, simplex: Simplex) -> Option<(Simplex, usize)> {
        let points = self.points(degree, simplex.index());
        let (facet, place) = self.last_facet(simplex, &points)?;
        let mut others = points;
        others.points.copy_within(place + 1..points.count, place);
        others.count -= 1;
        (self.first_cofacet(facet, &others) == Some(simplex)).then_some((facet, place))
    }

    /// Whether a simplex and a cofacet are an apparent pair.
    pub(super) fn has_apparent_cofacet(&self, degree: usize, simplex: Simplex) -> bool {
        let points = self.points(degree, simplex.index());
        self.first_cofacet(simplex, &points).is_some_and(|cofacet| {
            let around = self.points(degree + 1, cofacet.index());
            self.last_facet(cofacet, &around).is_some_and(|(facet, _)| facet == simplex)
        })
    }
}
