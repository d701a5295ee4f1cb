//! Guide 15: answers that prove themselves: certificates, a checker that shares no code with the solver, and a forgery.
//!
//! Run with `cargo run -p coface --example 15_certificates`.

use coface::Report;
use coface::answers::HomologyRequest;
use coface::io;
use coface::io::Format;

/// The projective plane of six vertices.
const PLANE: &[u8] = b"[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]";

fn main() -> Result<(), coface::Error> {
    // The solver finds the groups and writes down how: pairs of cells that cancel, and matrices that make what is left diagonal, with their inverses.
    let plane = io::read(PLANE, Format::Json)?;
    let found = HomologyRequest::new().found("rp2.json", plane)?;
    let certificate = found.certificate(&[("rp2.json", PLANE)])?;

    // The checker reads the certificate and the input itself, and multiplies. It depends on no crate of the solver.
    let verdict = coface_check::check(certificate.as_bytes(), &[PLANE]).expect("the proof holds");
    assert_eq!(verdict.proved(), ["H_0 = Z", "H_1 = Z/2", "H_2 = 0"]);
    // Whatever the answer says and the proof does not show would be listed here.
    assert!(verdict.unchecked().is_empty());

    // The certificate is of these bytes and of no others: its first claim is their SHA-256.
    let sphere = &b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..];
    assert!(certificate.contains(&coface_check::sha256(PLANE)));
    let fault = coface_check::check(certificate.as_bytes(), &[sphere]).expect_err("another file");
    assert!(fault.to_string().contains("SHA-256"), "{fault}");

    // A forgery: torsion of order 3 instead of 2. The claim is refused, since the diagonal has no 3.
    let forged = certificate.replacen("\"torsion\":[2]", "\"torsion\":[3]", 1);
    assert_ne!(forged, certificate);
    assert!(coface_check::check(forged.as_bytes(), &[PLANE]).is_err());

    // A report has one too: counts, manifold, orientation, boundary, name.
    let report = Report::of(io::read(sphere, Format::Json)?)?;
    let answer = report.answer(10).of_file("sphere.json", "json");
    let certificate = answer.certificate(&[("sphere.json", sphere)])?;
    let verdict = coface_check::check(certificate.as_bytes(), &[sphere]).expect("the proof holds");
    assert!(verdict.proved().contains(&"manifold = [\"yes\",true]".to_owned()));
    Ok(())
}
