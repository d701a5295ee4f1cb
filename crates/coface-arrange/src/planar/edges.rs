//! The edges of an arrangement: what the vertices cut the segments into, equal pieces made one.

use super::crossings::{Meetings, Soup};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;

/// Edges between vertices, with the segments that run along them.
pub(super) struct Edges {
    /// The two ends, the lower vertex first; edges rise by their ends.
    pub(super) ends: Vec<[u32; 2]>,
    /// The segments along each edge, rising.
    pub(super) segments: RaggedArray,
    /// The edges along each segment, from its lower end to its upper one.
    pub(super) of_segment: RaggedArray,
}

impl Edges {
    /// The pieces of the unstructured segments (points on their own have none).
    pub(super) fn new(soup: &Soup, meetings: &Meetings, vertex_of_event: &[u32]) -> Result<Self, Error> {
        let given = soup.points.len();
        let ends = soup.segments.iter().enumerate().flat_map(|(s, ends)| ends.map(|end| (s as u32, end)));
        let touches = meetings.touches.iter().map(|&[s, point]| (s, point));
        let crossings = meetings
            .crossings
            .iter()
            .enumerate()
            .flat_map(|(i, crossing)| crossing.segments.map(|s| (s, (given + i) as u32)));
        // (segment, vertex on it), in no order.
        let on = ends.chain(touches).chain(crossings);
        let on: Vec<[u32; 2]> = on.map(|(s, event)| [s, vertex_of_event[event as usize]]).collect();
        if u32::try_from(on.len()).is_err() {
            return Err(too_large());
        }
        let segment_count = soup.segments.len();
        let mut along = RaggedArray::grouped(segment_count, on.iter().map(|&[s, _]| s));
        along.items_mut().par_iter_mut().for_each(|item| *item = on[*item as usize][1]);
        drop(on);
        let chains: Vec<Vec<u32>> = (0..segment_count)
            .into_par_iter()
            .with_min_len(64)
            .map(|s| {
                let mut chain = along.list(s).to_vec();
                chain.sort_unstable();
                chain.dedup();
                chain
            })
            .collect();
        drop(along);
        Self::of_chains(vertex_of_event.iter().max().map_or(0, |&last| last as usize + 1), &chains)
    }

    /// The edges between consecutive vertices of chains; each chain rises.
    pub(super) fn of_chains(vertex_count: usize, chains: &[Vec<u32>]) -> Result<Self, Error> {
        let pieces = || {
            chains
                .iter()
                .enumerate()
                .flat_map(|(s, chain)| chain.windows(2).map(move |w| (s as u32, [w[0], w[1]])))
        };
        let piece_count: usize = chains.iter().map(|chain| chain.len().saturating_sub(1)).sum();
        if u32::try_from(piece_count).is_err() {
            return Err(too_large());
        }
        let piece_of: Vec<(u32, [u32; 2])> = pieces().collect();
        // By lower end with one counting sort, then by upper end and segment.
        let mut by_lower = RaggedArray::grouped(vertex_count, piece_of.iter().map(|(_, ends)| ends[0]));
        let mut ends: Vec<[u32; 2]> = Vec::with_capacity(piece_count);
        let (mut starts, mut items) = (vec![0], Vec::with_capacity(piece_count));
        let mut edge_of_piece = vec![0; piece_count];
        let list_starts: Vec<usize> = (0..=vertex_count).map(|v| by_lower.start(v)).collect();
        for list in list_starts.windows(2) {
            let pieces = &mut by_lower.items_mut()[list[0]..list[1]];
            pieces.sort_unstable_by_key(|&piece| (piece_of[piece as usize].1[1], piece));
            for &piece in &*pieces {
                let (segment, piece_ends) = piece_of[piece as usize];
                if ends.last() != Some(&piece_ends) {
                    if !ends.is_empty() {
                        starts.push(items.len() as u32);
                    }
                    ends.push(piece_ends);
                }
                items.push(segment);
                edge_of_piece[piece as usize] = ends.len() as u32 - 1;
            }
        }
        if !ends.is_empty() {
            starts.push(items.len() as u32);
        }
        let mut chain_starts = Vec::with_capacity(chains.len() + 1);
        chain_starts.push(0);
        let mut total = 0;
        for chain in chains {
            total += chain.len().saturating_sub(1) as u32;
            chain_starts.push(total);
        }
        if ends.len() >= 1 << 31 {
            return Err(too_large());
        }
        Ok(Self {
            ends,
            segments: RaggedArray::from_parts(starts, items)?,
            of_segment: RaggedArray::from_parts(chain_starts, edge_of_piece)?,
        })
    }
}

fn too_large() -> Error {
    Error::new(ErrorKind::TooLarge, "the segments cut each other into more than 2^31 pieces")
        .with_cure("arrange them in parts")
}
