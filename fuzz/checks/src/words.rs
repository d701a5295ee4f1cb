//! Parsers of short texts.

use coface::Coefficients;
use coface::arrange::boolean::BooleanFormula;
use coface::io::Format;
use coface::scale::batch::{ReportRequest, flat_line};
use coface::scale::workers::{bytes_text, parse_bytes, parse_duration, seconds_text};

/// Formulas, coefficients, names of formats, durations, sizes, and lines that batches exchange with their workers.
pub fn parse_words(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(formula) = BooleanFormula::parse(text, &["first", "a b"]) {
        let count = formula.input_count();
        assert!(count <= text.len().max(1) * 26, "each letter names one input");
        formula.evaluate(|input| input % 2 == 0);
    }
    if let Ok(coefficients) = text.parse::<Coefficients>() {
        // Z/n is printed with a slash, as people write it.
        assert_eq!(coefficients.to_string().parse(), Ok(coefficients));
    }
    drop(Format::from_name(text));
    if let Ok(duration) = parse_duration(text) {
        assert!(parse_duration(&seconds_text(duration)).is_ok());
    }
    if let Ok(count) = parse_bytes(text) {
        let shown = bytes_text(count);
        assert_eq!(parse_bytes(shown.trim_end_matches(" bytes")), Ok(count));
    }
    if let Ok(request) = ReportRequest::from_line(text) {
        let line = request.to_line();
        let again = ReportRequest::from_line(&line).expect("what is written is read");
        assert_eq!(again.to_line(), line);
    }
    drop(flat_line(text, true));
}
