//! Maps between homology groups.

use crate::failure::Failure;
use crate::input::Loaded;
use coface::Error;
use coface::answers::Producer;
use coface::answers::answer::{GroupAnswer, InducedMap, InducedMaps, WholeNumber};
use coface::complexes::simplicial::{FrozenComplex, SimplicialMap};
use coface::topology::{HomologyBasis, HomologyMap, induced_maps};
use serde_json::Value;
use std::path::Path;

/// The maps that a simplicial map induces, with kernels and cokernels, and a page that shows them.
pub(super) fn answer(
    source: &Producer,
    map: &Path,
    target: Loaded,
) -> Result<(InducedMaps, String), Failure> {
    let images = read_images(map)?;
    let target_name = target.name.clone();
    let in_target = |error: Error| error.in_file(target_name.clone());
    let target = simplices(&Producer::of(target.model).map_err(in_target)?).map_err(in_target)?;
    let source = simplices(source)?;
    let simplicial = SimplicialMap::new(&source, &target, images)
        .map_err(|error| error.in_file(map.display().to_string()))?;
    let (from, to) = (source.chain_complex()?, target.chain_complex()?);
    let maps = induced_maps(
        &simplicial.chain_map(&from, &to)?,
        &HomologyBasis::new(&from),
        &HomologyBasis::new(&to),
    )?;
    let degrees = maps.iter().enumerate().map(|(degree, map)| InducedMap {
        degree,
        source_orders: orders(map.source_orders()),
        target_orders: orders(map.target_orders()),
        matrix: matrix(map),
        kernel: GroupAnswer::from(&map.kernel()),
        cokernel: GroupAnswer::from(&map.cokernel()),
    });
    let degrees = degrees.collect();
    let mut page = format!("  induced map to {target_name}; columns are images of generators\n");
    for (degree, map) in maps.iter().enumerate() {
        page += &format!(
            "    H_{degree}: {}; kernel {}, cokernel {}\n",
            words_of(map),
            map.kernel(),
            map.cokernel()
        );
    }
    Ok((InducedMaps { target: target_name, degrees }, page))
}

fn simplices(producer: &Producer) -> Result<FrozenComplex, Error> {
    producer.ordered_simplices()?.simplicial().cloned().ok_or_else(|| {
        Error::invalid("a simplicial map goes between simplicial complexes")
            .with_cure("give facet lists or triangulated meshes")
    })
}

/// Pairs of a vertex and its image, from a list of pairs or under the key "vertices".
fn read_images(path: &Path) -> Result<Vec<(u32, u32)>, Failure> {
    let place = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new(format!("{place}: cannot be read: {error}")))?;
    let how = "write a map of vertices as [[vertex,image],..]";
    let value: Value = serde_json::from_str(&text)
        .map_err(|error| Failure::new(format!("{place}:{}: {error}; {how}", error.line())))?;
    let list = value.get("vertices").unwrap_or(&value);
    let list =
        list.as_array().ok_or_else(|| Failure::new(format!("{place}: there is no list of pairs; {how}")))?;
    let number = |value: &Value| u32::try_from(value.as_u64()?).ok();
    let pair = |(i, value): (usize, &Value)| {
        let pair = value.as_array().filter(|pair| pair.len() == 2);
        pair.and_then(|pair| Some((number(&pair[0])?, number(&pair[1])?)))
            .ok_or_else(|| Failure::new(format!("{place}: pair {i} is {value}; {how}")))
    };
    list.iter().enumerate().map(pair).collect()
}

/// The columns of a map: for each generator of the source the coefficients of its image.
pub(super) fn matrix(map: &HomologyMap) -> Vec<Vec<WholeNumber>> {
    map.columns().iter().map(|column| column.iter().map(WholeNumber::from).collect()).collect()
}

fn orders(orders: &[Option<coface::algebra::Integer>]) -> Vec<WholeNumber> {
    orders.iter().map(|order| WholeNumber::of_order(order.as_ref())).collect()
}

/// A small matrix by columns, or its size.
pub(super) fn words_of(map: &HomologyMap) -> String {
    const MOST: usize = 8;
    let (from, to) = (map.source_orders().len(), map.target_orders().len());
    if map.is_zero() {
        return "zero".to_owned();
    }
    if from > MOST || to > MOST {
        return format!("{from} generators to {to}, see --json");
    }
    let column = |column: &Vec<coface::algebra::Integer>| {
        format!("({})", column.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "))
    };
    map.columns().iter().map(column).collect::<Vec<_>>().join(" ")
}
