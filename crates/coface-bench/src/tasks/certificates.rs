//! Certificates: what they take to make, and what they take to check.

use super::solids::half;
use super::{Clock, SOLIDS, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::answers::{HomologyRequest, SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
use coface::arrange::boolean::BooleanFormula;
use coface::io::{self, Format};
use std::path::Path;

pub(super) const CERTIFY: Task = Task {
    name: "certify",
    about: "integral homology of a facet list with its certificate, which is checked before it is given",
    extension: "raw",
    inputs: SOLIDS,
    work: Work::Inside(|path, clock| {
        let input = facet_list(path)?;
        let model = io::read(input.as_bytes(), Format::Json)?;
        let size = input.lines().count();
        let text = clock.time(size, || of_homology(model, input.as_bytes()))?;
        packed(&text).map(|packed| format!("{} bytes packed", packed.len()))
    }),
};

pub(super) const CHECK: Task = Task {
    name: "check",
    about: "the check of such a certificate in its binary form, with the input read anew",
    work: Work::Inside(|path, clock| {
        let input = facet_list(path)?;
        let text = of_homology(io::read(input.as_bytes(), Format::Json)?, input.as_bytes())?;
        let packed = packed(&text)?;
        drop(text);
        let size = input.lines().count();
        checked(clock, size, &packed, &[input.as_bytes()])
    }),
    ..CERTIFY
};

pub(super) const CERTIFY_SOLIDS: Task = Task {
    name: "certify-solids",
    about: "the union of two closed meshes with its certificate, which is checked before it is given",
    extension: "raw3",
    inputs: &["spheres3", "spheres4", "spheres5", "spheres6"],
    work: Work::Inside(|path, clock| {
        let (size, inputs) = solids(path)?;
        let text = clock.time(size, || of_solids(&inputs))?;
        packed(&text).map(|packed| format!("{} bytes packed", packed.len()))
    }),
};

pub(super) const CHECK_SOLIDS: Task = Task {
    name: "check-solids",
    about: "the check of such a certificate in its binary form, with the inputs read anew",
    work: Work::Inside(|path, clock| {
        let (size, inputs) = solids(path)?;
        let packed = packed(&of_solids(&inputs)?)?;
        let bytes: Vec<&[u8]> = inputs.iter().map(Vec::as_slice).collect();
        checked(clock, size, &packed, &bytes)
    }),
    ..CERTIFY_SOLIDS
};

/// The simplices of a mesh, one a line.
fn facet_list(path: &Path) -> Result<String, Error> {
    let mesh = Mesh::read_raw(path)?;
    let facets: Vec<String> = mesh.lists.iter().map(|facet| format!("{facet:?}")).collect();
    Ok(format!("[{}]", facets.join(",\n")))
}

fn of_homology(model: io::Model, input: &[u8]) -> Result<String, Error> {
    let name = "input.json";
    HomologyRequest::new().found(name, model)?.certificate(&[(name, input)])
}

/// Both meshes as files, and the number of their triangles.
fn solids(path: &Path) -> Result<(usize, [Vec<u8>; 2]), Error> {
    let mesh = Mesh::read_raw3(path)?;
    let mut files = [Vec::new(), Vec::new()];
    for (part, file) in files.iter_mut().enumerate() {
        io::write(&half(&mesh, part)?, file, Format::Off)?;
    }
    Ok((mesh.lists.len(), files))
}

fn of_solids(inputs: &[Vec<u8>; 2]) -> Result<String, Error> {
    let models = [io::read(&inputs[0][..], Format::Off)?, io::read(&inputs[1][..], Format::Off)?];
    let named = [("first.off", &models[0]), ("second.off", &models[1])];
    let arrangement = SceneArrangement::of(named, &SpatialRequest::default())?;
    let request = SolidRequest::of(BooleanFormula::union(2));
    let files = [("first.off", &inputs[0][..]), ("second.off", &inputs[1][..])];
    SolidBoolean::of(&arrangement, &request)?.certificate(&files)
}

fn packed(text: &str) -> Result<Vec<u8>, Error> {
    coface_check_binary::packed(text.as_bytes()).map_err(|fault| Error::invalid(fault.to_string()))
}

fn checked(clock: &mut Clock, size: usize, certificate: &[u8], inputs: &[&[u8]]) -> Result<String, Error> {
    let verdict = clock.time(size, || coface_check_binary::check(certificate, inputs));
    let verdict = verdict.map_err(|fault| Error::invalid(fault.to_string()))?;
    Ok(format!("{} claims, {} bytes", verdict.proved().len(), certificate.len()))
}
