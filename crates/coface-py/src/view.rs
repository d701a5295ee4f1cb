//! The page of `coface view`.

use crate::errors::OrRaise;
use crate::given::source_of;
use crate::work::run;
use coface::answers::Report;
use coface::pictures::pages::viewer;
use coface::pictures::{Layer, Scene};
use coface::{Error, ErrorKind};
use pyo3::prelude::*;
use serde_json::Value;
use std::sync::Arc;

/// The report lists at most so many places of a problem.
const PLACES: usize = 100;

/// One of several models that stand in one: its name, where its vertices begin and end, and its color as red, green and blue.
pub(crate) type Member = (String, u32, u32, Option<[u8; 3]>);

/// Shows each of several models as a layer.
pub(crate) fn add_members(scene: &mut Scene, members: &[Member]) {
    for (name, start, end, color) in members {
        scene.add_member(name, *start..*end, color.map(Layer::rgb));
    }
}

/// The page that shows a model and answers about it, which are texts of JSON.
#[pyfunction]
#[pyo3(signature = (model, title, results, report, members=Vec::new(), progress=None))]
pub(crate) fn _page(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    title: &str,
    results: Vec<String>,
    report: bool,
    members: Vec<Member>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let source = source_of(model)?;
    let parse = |text: &String| -> Result<Value, Error> {
        serde_json::from_str(text).map_err(|error| {
            Error::new(ErrorKind::Parse, error.to_string()).with_cure("give what to_dict() gave")
        })
    };
    let results: Vec<Value> = results.iter().map(parse).collect::<Result<_, _>>().or_raise(py)?;
    run(py, progress, || {
        let model = &Arc::clone(&source).model;
        let mut scene = Scene::of(title, model)?;
        add_members(&mut scene, &members);
        for result in &results {
            scene.add_result("the answer", result)?;
        }
        if report {
            let report = Report::of(model.clone())?;
            scene = scene.with_boundary().with_report(&report.answer(PLACES));
        }
        Ok(viewer::page_of(&scene.document(), None))
    })
}
