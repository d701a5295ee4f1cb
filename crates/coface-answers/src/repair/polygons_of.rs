//! Facet lists of dimension 2 as polygons, and back.

use crate::producer::Labels;
use coface_algebra::{Error, ErrorKind, RaggedArray};
use coface_io::{Model, ModelParts, Structure};
use std::collections::BTreeSet;

/// A model of polygons; of a facet list, with the numbers that its vertices have there.
pub(crate) struct PolygonsOf {
    pub(crate) model: Model,
    pub(crate) labels: Option<Labels>,
}

impl PolygonsOf {
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for models with 3-cells and structures that are no facet list of dimension 2.
    pub(crate) fn new(model: &Model) -> Result<Self, Error> {
        let refused = |what: &str| {
            Err(Error::new(ErrorKind::UnsupportedFormat, format!("{what} cannot be repaired"))
                .with_cure("give polygons, or a facet list of triangles, edges and points"))
        };
        if !model.cells().is_empty() {
            return refused("a model with 3-cells");
        }
        let mut facets = match model.structure() {
            None => return Ok(Self { model: model.clone(), labels: None }),
            Some(Structure::Facets(facets)) if facets.iter().all(|facet| facet.len() <= 3) => facets.clone(),
            Some(Structure::Facets(_)) => return refused("a complex of dimension 3 or more"),
            Some(_) => return refused("a structure without vertices"),
        };
        let (labels, vertex_count) = Labels::compact(&mut facets);
        let of_size =
            |size: usize| RaggedArray::from_lists(facets.iter().filter(|facet| facet.len() == size));
        let parts = ModelParts {
            vertex_count,
            polygons: of_size(3),
            lines: of_size(2),
            structure: None,
            ..model.clone().into_parts()
        };
        Ok(Self { model: parts.into_model(), labels: Some(labels) })
    }

    /// The model in the form in which it was given. `sources` says for each vertex which one it was; vertices behind them are new.
    pub(crate) fn into_given(self, sources: &[usize]) -> Model {
        let Some(labels) = self.labels else { return self.model };
        let named: Vec<u32> = sources.iter().map(|&vertex| labels.of(vertex as u32)).collect();
        let model = self.model;
        // New vertices get the numbers behind the highest, or those that are free where none are left there.
        let most = named.iter().max().copied().unwrap_or(0);
        let is_taken: BTreeSet<u32> = named.iter().copied().collect();
        let free = (most..=u32::MAX).chain(0..most).filter(|number| !is_taken.contains(number));
        let new: Vec<u32> = free.take(model.vertex_count().saturating_sub(named.len())).collect();
        let name = |vertex: u32| match named.get(vertex as usize) {
            Some(&name) => name,
            None => new[vertex as usize - named.len()],
        };
        let mut is_used = vec![false; model.vertex_count()];
        let cells = model.polygons().iter().chain(model.lines().iter());
        let mut facets: Vec<Vec<u32>> = Vec::new();
        for cell in cells {
            cell.iter().for_each(|&vertex| is_used[vertex as usize] = true);
            facets.push(cell.iter().map(|&vertex| name(vertex)).collect());
        }
        let unused = (0u32..).zip(&is_used).filter(|(_, is_used)| !**is_used);
        facets.extend(unused.map(|(vertex, _)| vec![name(vertex)]));
        Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets)))
    }
}
