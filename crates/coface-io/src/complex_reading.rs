//! Files that are no models by themselves: points, distances and graphs that make a complex.

use crate::readers::ReadOptions;
use crate::{
    AlphaReading, CechReading, FlagReading, MapperReading, Model, NumberTable, RipsReading, WitnessReading,
};
use coface_algebra::Error;
use std::io::Read;
use std::path::Path;

/// What a file is read as that is no model by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ComplexReading {
    Alpha(AlphaReading),
    Rips(RipsReading),
    Flag(FlagReading),
    Cech(CechReading),
    Witness(WitnessReading),
    Mapper(MapperReading),
}

/// How points and graphs become complexes: of several options the last one counts.
impl ReadOptions {
    /// Reads points, rows of numbers or the vertices of a model, as their alpha complex: a mesh of tetrahedra, triangles, edges and points; of points
    /// that repeat, a list of simplices, or a chain complex where there are few points.
    ///
    /// # Examples
    /// The edges of a triangle, of which two are there at the squared radius 16.
    /// ```
    /// use coface_io::{AlphaReading, ReadOptions, read_with};
    /// let alpha = AlphaReading { bound: Some(16.0), ..AlphaReading::default() };
    /// let model = read_with(&b"0 0\n6 0\n0 8\n"[..], &ReadOptions::new().alpha(alpha))?;
    /// assert_eq!((model.lines().len(), model.polygons().len()), (2, 0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn alpha(self, alpha: impl Into<Option<AlphaReading>>) -> Self {
        self.with_complex(alpha.into().map(ComplexReading::Alpha))
    }

    /// Reads points or distances as their Vietoris-Rips complex: a mesh of tetrahedra, triangles, edges and points if points have at most three coordinates and
    /// simplices at most four points, else a list of simplices.
    ///
    /// # Examples
    /// See [`RipsReading`].
    #[must_use]
    pub fn rips(self, rips: impl Into<Option<RipsReading>>) -> Self {
        self.with_complex(rips.into().map(ComplexReading::Rips))
    }

    /// Reads a graph, an edge list or GraphML, as its flag complex: a list of simplices, whose vertices have the numbers of the file, or are numbered in its order
    /// where they have names; if edges have directions, as a chain complex whose cells of each degree are the lists of vertices in lexicographic order.
    ///
    /// # Examples
    /// See [`FlagReading`].
    #[must_use]
    pub fn flag(self, flag: impl Into<Option<FlagReading>>) -> Self {
        self.with_complex(flag.into().map(ComplexReading::Flag))
    }

    /// Reads points as their Čech complex, as [`Self::rips`] does.
    ///
    /// # Examples
    /// See [`CechReading`].
    #[must_use]
    pub fn cech(self, cech: impl Into<Option<CechReading>>) -> Self {
        self.with_complex(cech.into().map(ComplexReading::Cech))
    }

    /// Reads points as the witness complex of landmarks among them, which are its vertices, as [`Self::rips`] does.
    ///
    /// # Examples
    /// See [`WitnessReading`].
    #[must_use]
    pub fn witness(self, witness: impl Into<Option<WitnessReading>>) -> Self {
        self.with_complex(witness.into().map(ComplexReading::Witness))
    }

    /// Reads points as the Mapper complex of a function on them, whose vertices are clusters of points, at their means, as [`Self::rips`] does.
    ///
    /// # Examples
    /// See [`MapperReading`].
    #[must_use]
    pub fn mapper(self, mapper: impl Into<Option<MapperReading>>) -> Self {
        self.with_complex(mapper.into().map(ComplexReading::Mapper))
    }

    fn with_complex(mut self, complex: Option<ComplexReading>) -> Self {
        self.complex = complex.or(self.complex);
        self
    }

    /// Reads a file as the model that it is.
    pub(crate) fn as_file(mut self) -> Self {
        self.complex = None;
        self
    }
}

impl ComplexReading {
    fn of_path(self, path: &Path, options: &ReadOptions) -> Result<Model, Error> {
        let named = |error: Error| error.in_file(path.display().to_string());
        match self {
            Self::Alpha(alpha) => alpha.points_of_path(path, options)?.into_model().map_err(named),
            Self::Rips(rips) => rips.model(rips.distances_of_path(path, options)?).map_err(named),
            Self::Flag(flag) => flag.model(&flag.graph_of_path(path)?).map_err(named),
            Self::Cech(cech) => Ok(cech.points_of_path(path, options)?.into_model()),
            Self::Witness(witness) => Ok(witness.points_of_path(path, options)?.into_model()),
            Self::Mapper(mapper) => Ok(mapper.points_of_path(path, options)?.into_model()),
        }
    }

    fn of_stream(self, input: &mut dyn Read) -> Result<Model, Error> {
        match self {
            Self::Alpha(alpha) => alpha.points(&NumberTable::read(input)?)?.into_model(),
            Self::Rips(rips) => rips.model(rips.distances(&NumberTable::read_distances(input)?)?),
            Self::Flag(flag) => flag.model(&flag.graph(input)?),
            Self::Cech(cech) => Ok(cech.points(&NumberTable::read(input)?)?.into_model()),
            Self::Witness(witness) => Ok(witness.points(&NumberTable::read(input)?)?.into_model()),
            Self::Mapper(mapper) => Ok(mapper.points(&NumberTable::read(input)?)?.into_model()),
        }
    }
}

/// The model of a file, if it is to be read as a complex that its points or its graph make.
pub(crate) fn model_of_path(path: &Path, options: &ReadOptions) -> Option<Result<Model, Error>> {
    let complex = options.complex?;
    let read = || {
        let model = complex.of_path(path, options)?;
        options.accept(model.remarks()).map_err(|error| error.in_file(path.display().to_string()))?;
        Ok(model)
    };
    Some(read())
}

/// The model of a stream, if it is to be read as a complex that its points or its graph make.
pub(crate) fn model_of_stream(input: &mut dyn Read, options: &ReadOptions) -> Option<Result<Model, Error>> {
    let complex = options.complex?;
    let mut read = || {
        let model = complex.of_stream(input)?;
        options.accept(model.remarks())?;
        Ok(model)
    };
    Some(read())
}
