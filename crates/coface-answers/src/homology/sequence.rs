//! The long exact sequence of a pair.

use super::maps::matrix;
use crate::Pair;
use crate::answer::{HomologyGroup, SequenceAnswer, SequenceMap};
use coface_algebra::Error;
use coface_algebra::chains::ChainComplex;
use coface_topology::{HomologyMap, LongExactSequence};

/// The groups and maps, whose exactness is checked.
pub(super) fn answer(whole: &ChainComplex, pair: &Pair) -> Result<SequenceAnswer, Error> {
    let sequence = LongExactSequence::new(whole, &pair.subcomplex(whole)?)?;
    sequence.check()?;
    let degrees = sequence.whole().groups().len();
    let maps = |map: &dyn Fn(usize) -> Option<HomologyMap>| {
        (0..degrees).map(|degree| map(degree).as_ref().map(matrix)).collect()
    };
    let mut known = Vec::new();
    for degree in (0..degrees).rev() {
        let maps = [
            ("inclusion", sequence.inclusion(degree)),
            ("projection", sequence.projection(degree)),
            ("connecting", sequence.connecting(degree)),
        ];
        let there = maps.into_iter().filter_map(|(name, map)| Some(SequenceMap::of(name, degree, map?)));
        known.extend(there);
    }
    Ok(SequenceAnswer {
        subcomplex: HomologyGroup::list(sequence.part().groups()),
        complex: HomologyGroup::list(sequence.whole().groups()),
        pair: HomologyGroup::list(sequence.pair().groups()),
        inclusion: maps(&|degree| sequence.inclusion(degree).cloned()),
        projection: maps(&|degree| sequence.projection(degree).cloned()),
        connecting: maps(&|degree| sequence.connecting(degree).cloned()),
        maps: known,
        exact: true,
    })
}
