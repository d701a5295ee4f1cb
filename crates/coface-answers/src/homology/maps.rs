//! Maps between homology groups.

use super::GivenVertexMap;
use crate::Producer;
use crate::answer::{GroupAnswer, InducedMap, InducedMaps, WholeNumber};
use coface_algebra::{Error, Integer};
use coface_complexes::simplicial::{FrozenComplex, SimplicialMap};
use coface_topology::{HomologyBasis, HomologyMap, induced_maps};

/// The maps that a simplicial map induces, with kernels and cokernels.
pub(super) fn answer(source: &Producer, map: &GivenVertexMap) -> Result<InducedMaps, Error> {
    let in_target = |error: Error| error.in_file(&map.target_name);
    let target = simplices(&Producer::of(map.target.clone()).map_err(in_target)?).map_err(in_target)?;
    let source = simplices(source)?;
    let simplicial = SimplicialMap::new(&source, &target, map.images.iter().copied())
        .map_err(|error| error.in_file(&map.place))?;
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
    Ok(InducedMaps { target: map.target_name.clone(), degrees: degrees.collect() })
}

fn simplices(producer: &Producer) -> Result<FrozenComplex, Error> {
    producer.ordered_simplices()?.simplicial().cloned().ok_or_else(|| {
        Error::invalid("a simplicial map goes between simplicial complexes")
            .with_cure("give facet lists or triangulated meshes")
    })
}

/// The columns of a map: for each generator of the source the coefficients of its image.
pub(super) fn matrix(map: &HomologyMap) -> Vec<Vec<WholeNumber>> {
    map.columns().iter().map(|column| column.iter().map(WholeNumber::from).collect()).collect()
}

fn orders(orders: &[Option<Integer>]) -> Vec<WholeNumber> {
    orders.iter().map(|order| WholeNumber::of_order(order.as_ref())).collect()
}
