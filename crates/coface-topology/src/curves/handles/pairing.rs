//! Handle loops and tunnel loops in pairs.

use super::HandleKind;
use super::linking_matrix::LinkingMatrix;
use super::loop_search::Chosen;
use coface_algebra::Error;

/// Each handle loop with a tunnel loop that crosses it an odd number of times: shortest ones first, as far as all get one.
///
/// The numbers of crossings modulo 2 are an invertible matrix, so there are such pairs; they are a matching that is augmented along
/// alternating paths.
pub(super) fn pairs<'a>(
    chosen: &'a [Chosen],
    linking: &LinkingMatrix,
) -> Result<Vec<[&'a Chosen; 2]>, Error> {
    let of_kind = |kind: HandleKind| {
        let mut loops: Vec<&Chosen> = chosen.iter().filter(|chosen| chosen.kind == kind).collect();
        loops.sort_by(|a, b| a.length.total_cmp(&b.length));
        loops
    };
    let (handles, tunnels) = (of_kind(HandleKind::Handle), of_kind(HandleKind::Tunnel));
    let crossed: Vec<Vec<usize>> = handles
        .iter()
        .map(|handle| {
            let is_crossed = |&i: &usize| {
                let tunnel = tunnels[i];
                handle.component == tunnel.component && linking.is_odd(&handle.class, &tunnel.class)
            };
            (0..tunnels.len()).filter(is_crossed).collect()
        })
        .collect();
    let mut partners: Vec<Option<usize>> = vec![None; tunnels.len()];
    for handle in 0..handles.len() {
        if !augment(handle, &crossed, &mut partners) {
            return Err(Error::invalid(
                "the handle loops have no tunnel loops to pair with: the surface meets itself",
            ));
        }
    }
    let pair = |(tunnel, partner): (usize, Option<usize>)| Some([handles[partner?], tunnels[tunnel]]);
    Ok(partners.into_iter().enumerate().filter_map(pair).collect())
}

/// Finds a tunnel for a handle, breadth-first, and changes the partners on the way to it.
fn augment(handle: usize, crossed: &[Vec<usize>], partners: &mut [Option<usize>]) -> bool {
    // For each tunnel that was reached the handle that it was reached from.
    let mut reached_from = vec![None; partners.len()];
    let mut queue = vec![handle];
    let mut at = 0;
    while at < queue.len() {
        for &tunnel in &crossed[queue[at]] {
            if reached_from[tunnel].is_some() {
                continue;
            }
            reached_from[tunnel] = Some(queue[at]);
            if let Some(partner) = partners[tunnel] {
                queue.push(partner);
                continue;
            }
            let mut free = tunnel;
            loop {
                let from = reached_from[free].expect("it was reached");
                let before = partners.iter().position(|partner| *partner == Some(from));
                partners[free] = Some(from);
                match before {
                    Some(before) => free = before,
                    None => return true,
                }
            }
        }
        at += 1;
    }
    false
}
