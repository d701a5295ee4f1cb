//! XML documents of meshes.

use coface_algebra::Error;
use roxmltree::Document;

/// The document of a text.
pub(crate) fn document(text: &str) -> Result<Document<'_>, Error> {
    // A document type without entities of its own does no harm.
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let message: String = error.to_string().chars().flat_map(char::escape_default).collect();
        Error::parse(format!("this is no XML: {message}"))
            .at_line(u64::from(error.pos().row))
            .with_cure("the file is damaged or cut short: write it again")
    })
}

/// The numbers of a list, which must be finite.
pub(crate) fn numbers(text: &str) -> Result<Vec<f64>, Error> {
    text.split_ascii_whitespace()
        .map(|word| {
            word.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| {
                Error::parse(format!("{} is no finite number", crate::scanner::quoted(word.as_bytes())))
                    .with_cure("write the file again")
            })
        })
        .collect()
}
