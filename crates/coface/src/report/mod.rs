//! The report on a model: everything that `coface info` says, as data.
