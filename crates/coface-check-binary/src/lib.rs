//! The binary form of certificates: the same values as in JSON, with numbers of few bytes. It is read with memory that is bounded by what the
//! file holds. [`check`] takes both forms, and hands certificates to [`coface_check_walks`]. `docs/certificates.md` has the form.

mod form;

use coface_check::json::parsed;
use coface_check::{Fault, Verdict};
use form::Reader;
use serde_json::Value;
use std::borrow::Cow;

/// The first bytes of the binary form: no JSON begins with them.
const MARK: &[u8; 8] = b"\x89cofce\x1a\x01";

/// A certificate of JSON in the binary form.
///
/// # Errors
/// A [`Fault`] for what is no JSON.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// let text = r#"{"coface_certificate":1,"inputs":[{"name":"a.off","sha256":""}]}"#;
/// let packed = coface_check_binary::packed(text.as_bytes()).expect("JSON");
/// assert!(packed.len() < text.len());
/// assert_eq!(coface_check_binary::input_names(&packed).expect("a certificate"), ["a.off"]);
/// ```
pub fn packed(certificate: &[u8]) -> Result<Vec<u8>, Fault> {
    let value = parsed(certificate, "certificate")?;
    let mut out = MARK.to_vec();
    form::write(&value, &mut out);
    Ok(out)
}

/// A certificate of either form as JSON.
///
/// # Errors
/// A [`Fault`] for a binary form that ends early, goes on, or has values of no kind.
///
/// # Complexity
/// Linear in the file; counts that it names take no memory.
///
/// # Examples
/// ```
/// let packed = coface_check_binary::packed(br#"{"a":[1,-2,0.5]}"#).expect("JSON");
/// assert_eq!(&coface_check_binary::unpacked(&packed).expect("it is whole")[..], br#"{"a":[1,-2,0.5]}"#);
/// assert_eq!(&coface_check_binary::unpacked(b"{}").expect("JSON is given back")[..], b"{}");
/// assert!(coface_check_binary::unpacked(&packed[..packed.len() - 1]).is_err());
/// ```
pub fn unpacked(certificate: &[u8]) -> Result<Cow<'_, [u8]>, Fault> {
    match certificate.strip_prefix(MARK) {
        None => Ok(Cow::Borrowed(certificate)),
        Some(bytes) => Ok(Cow::Owned(value_of(bytes)?.to_string().into_bytes())),
    }
}

/// The value whose binary form this is.
fn value_of(bytes: &[u8]) -> Result<Value, Fault> {
    let mut reader = Reader(bytes);
    let value = reader.value(0)?;
    match reader.0 {
        [] => Ok(value),
        _ => Err(Fault::new("certificate", "the binary form goes on behind its end")),
    }
}

/// Checks a certificate of any kind and either form against the bytes of its inputs, in their order.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// That of [`coface_check_walks::check`].
///
/// # Examples
/// ```
/// let input = b"[[0,1,2]]";
/// let hash = coface_check::sha256(input);
/// let text = format!(
///     r#"{{"coface_certificate":1,"kind":"orientation cover","inputs":[{{"name":"a.json","sha256":"{hash}"}}],
///         "answer":{{"copies":2,"surfaces_below":["disk"],"surfaces":["disk","disk"],"f_vector":[6,6,2],"euler_characteristic":2}}}}"#
/// );
/// let packed = coface_check_binary::packed(text.as_bytes()).expect("JSON");
/// assert_eq!(coface_check_binary::check(&packed, &[input]), coface_check_binary::check(text.as_bytes(), &[input]));
/// assert!(coface_check_binary::check(&packed, &[input]).is_ok());
/// ```
pub fn check(certificate: &[u8], inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let whole = match certificate.strip_prefix(MARK) {
        None => coface_check::opened(certificate, inputs)?,
        Some(bytes) => coface_check::opened_value(value_of(bytes)?, inputs)?,
    };
    coface_check_walks::check_opened(&whole, inputs)
}

/// The names of the inputs of a certificate of either form; none where they are not there.
///
/// # Errors
/// A [`Fault`] for what is no certificate.
///
/// # Examples
/// See [`packed`].
pub fn input_names(certificate: &[u8]) -> Result<Vec<String>, Fault> {
    coface_check::input_names(&unpacked(certificate)?)
}

#[cfg(test)]
mod tests {
    use super::{MARK, packed, unpacked};
    use serde_json::{Value, json};

    #[test]
    fn values_come_back() {
        let value = json!({
            "a": [null, true, false, 0, 127, 128, u64::MAX, i64::MIN, -1, 0.1, -0.0, 1.0, 1e300],
            "": [], "b": {}, "c": {"d": [[1, 2, 3], [300, 70000], ["x", "ä"]]},
        });
        let bytes = packed(value.to_string().as_bytes()).expect("JSON");
        let back: Value = serde_json::from_slice(&unpacked(&bytes).expect("it is whole")).expect("JSON");
        assert_eq!(back.to_string(), value.to_string());
        // No part of it is a whole, and nothing may follow.
        for end in MARK.len()..bytes.len() {
            assert!(unpacked(&bytes[..end]).is_err(), "{end}");
        }
        assert!(unpacked(&[&bytes[..], b"\0"].concat()).is_err());
    }

    #[test]
    fn claims_of_strangers_take_no_memory() {
        for rest in [
            // 2^63 items, texts or numbers, of which none is there.
            &[7, 255, 255, 255, 255, 255, 255, 255, 255, 127][..],
            &[6, 255, 255, 255, 255, 15],
            &[9, 255, 255, 255, 255, 15, 1],
            // A number of 65 bits, one with zeros in front, a key twice, bytes that are no text, a number that is none, an unknown kind.
            &[3, 255, 255, 255, 255, 255, 255, 255, 255, 255, 2],
            &[3, 129, 0],
            &[8, 2, 1, b'a', 0, 1, b'a', 0],
            &[6, 1, 255],
            &[5, 0, 0, 0, 0, 0, 0, 240, 127],
            &[4, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1],
            &[10],
            &[],
        ] {
            assert!(unpacked(&[&MARK[..], rest].concat()).is_err(), "{rest:?}");
        }
        // Lists in lists, too deep for any certificate.
        assert!(unpacked(&[&MARK[..], &[7, 1].repeat(100_000)].concat()).is_err());
    }
}
