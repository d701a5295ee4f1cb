//! The long exact sequence of a pair.

use super::maps::{matrix, words_of};
use coface::algebra::chains::ChainComplex;
use coface::answers::Pair;
use coface::answers::answer::{HomologyGroup, SequenceAnswer};
use coface::topology::{HomologyMap, LongExactSequence};

/// The groups and maps, whose exactness is checked, and a page that shows them.
pub(super) fn answer(whole: &ChainComplex, pair: &Pair) -> Result<(SequenceAnswer, String), coface::Error> {
    let sequence = LongExactSequence::new(whole, &pair.subcomplex(whole)?)?;
    sequence.check()?;
    let degrees = sequence.whole().groups().len();
    let maps = |map: &dyn Fn(usize) -> Option<HomologyMap>| {
        (0..degrees).map(|degree| map(degree).as_ref().map(matrix)).collect()
    };
    let object = SequenceAnswer {
        subcomplex: HomologyGroup::list(sequence.part().groups()),
        complex: HomologyGroup::list(sequence.whole().groups()),
        pair: HomologyGroup::list(sequence.pair().groups()),
        inclusion: maps(&|degree| sequence.inclusion(degree).cloned()),
        projection: maps(&|degree| sequence.projection(degree).cloned()),
        connecting: maps(&|degree| sequence.connecting(degree).cloned()),
        exact: true,
    };
    let mut page =
        "  long exact sequence, checked to be exact; columns are images of generators\n".to_owned();
    for degree in (0..degrees).rev() {
        let group = |groups: &coface::topology::Homology| {
            groups.groups().get(degree).map_or("0".to_owned(), ToString::to_string)
        };
        for (name, group, map, next) in [
            (
                format!("H_{degree}(L)"),
                group(sequence.part()),
                sequence.inclusion(degree),
                format!("H_{degree}(K)"),
            ),
            (
                format!("H_{degree}(K)"),
                group(sequence.whole()),
                sequence.projection(degree),
                format!("H_{degree}(K, L)"),
            ),
            (
                format!("H_{degree}(K, L)"),
                group(sequence.pair()),
                sequence.connecting(degree),
                degree.checked_sub(1).map_or("0".to_owned(), |below| format!("H_{below}(L)")),
            ),
        ] {
            page += &format!(
                "    {name} = {group}{}\n",
                map.map_or(String::new(), |map| format!(" -> {next}: {}", words_of(map)))
            );
        }
    }
    Ok((object, page))
}
