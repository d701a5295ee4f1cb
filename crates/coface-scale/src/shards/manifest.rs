//! What a folder says about its shards.

use coface_algebra::{Error, ErrorKind};
use coface_io::Remark;
use serde::{Deserialize, Serialize};

/// What the shards of a folder are, as stated in its file `shards.json`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ShardManifest {
    /// The number that all shards have, see [`ShardPlace::complex`](super::ShardPlace::complex).
    pub complex: u64,
    /// The number of shards.
    pub part_count: u32,
    /// How many neighbors are merged at once.
    pub fan_in: u32,
    /// What they were made from.
    pub source: ShardSource,
}

/// What shards were made from, for people and for programs that go on with what they find.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ShardSource {
    /// The name of a file or a grid.
    #[serde(default)]
    pub name: String,
    /// `model`, `grid`, `volume`, `tetrahedra`.
    #[serde(default)]
    pub kind: String,
    /// Something that is the same when the file and the request are: its length, the time of its change, how it was cut. May be empty.
    #[serde(default)]
    pub fingerprint: String,
    /// What was assumed when it was read, and when its cells were identified.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<Remark>,
}

const VERSION: u64 = 1;

/// The keys of the file.
#[derive(Serialize)]
struct Written<'a> {
    coface_shards: u64,
    /// In 16 hexadecimal digits.
    complex: String,
    fan_in: u32,
    parts: u32,
    source: &'a ShardSource,
}

/// The keys of the file as they are read: what lacks is named.
#[derive(Deserialize)]
struct Found {
    coface_shards: Option<u64>,
    complex: Option<String>,
    fan_in: Option<u32>,
    parts: Option<u32>,
    #[serde(default)]
    source: ShardSource,
}

/// The version alone: a newer one may have other keys.
#[derive(Deserialize)]
struct Version {
    coface_shards: Option<u64>,
}

impl ShardManifest {
    /// A manifest.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::{ShardManifest, ShardSource};
    /// assert_eq!(ShardManifest::new(7, 3, 8, ShardSource::default()).part_count, 3);
    /// ```
    pub fn new(complex: u64, part_count: u32, fan_in: u32, source: ShardSource) -> Self {
        Self { complex, part_count, fan_in, source }
    }

    pub(super) fn to_json(&self) -> String {
        let written = Written {
            coface_shards: VERSION,
            complex: format!("{:016x}", self.complex),
            fan_in: self.fan_in,
            parts: self.part_count,
            source: &self.source,
        };
        // By way of a value, whose keys are in alphabetical order.
        let value = serde_json::to_value(&written).expect("manifests have texts as keys");
        format!("{value:#}\n")
    }

    pub(super) fn from_json(text: &str) -> Result<Self, Error> {
        let fault = |error: &serde_json::Error| {
            let what = if error.is_data() { "is no list of shards" } else { "is no JSON" };
            let fault = Error::parse(format!("{what}: {error}")).at_line(error.line() as u64);
            fault.with_cure("shard the complex again")
        };
        let Version { coface_shards: version } = serde_json::from_str(text).map_err(|error| fault(&error))?;
        if version.is_some_and(|version| version > VERSION) {
            return Err(Error::new(ErrorKind::UnsupportedFormat, "the shards are of a newer version")
                .with_cure("merge them with a newer coface"));
        }
        let found: Found = serde_json::from_str(text).map_err(|error| fault(&error))?;
        let lacks = |what: &str| {
            Error::parse(format!("does not say {what} as a list of shards does"))
                .with_cure("shard the complex again")
        };
        if found.coface_shards != Some(VERSION) {
            return Err(lacks("its version"));
        }
        let complex = found.complex.and_then(|digits| u64::from_str_radix(&digits, 16).ok());
        let parts = found.parts.filter(|&count| count > 0);
        let fan_in = found.fan_in.filter(|&fan_in| fan_in > 1);
        Ok(Self {
            complex: complex.ok_or_else(|| lacks("the number of the complex"))?,
            part_count: parts.ok_or_else(|| lacks("how many parts there are"))?,
            fan_in: fan_in.ok_or_else(|| lacks("how many are merged"))?,
            source: found.source,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io::RemarkCode;

    #[test]
    fn manifests_are_read_as_they_were_written() {
        let source = ShardSource {
            name: "b".into(),
            kind: "grid".into(),
            fingerprint: "1".into(),
            remarks: vec![Remark::new(RemarkCode::IsolatedVertex, "1 vertex is in no cell").at(1, [])],
        };
        let manifest = ShardManifest::new(0xab, 3, 8, source);
        let text = manifest.to_json();
        let keys = ["coface_shards", "complex", "fan_in", "parts", "source", "fingerprint", "kind", "name"];
        let places = keys.map(|key| text.find(&format!("\"{key}\": ")));
        assert!(places.is_sorted() && places[0].is_some() && text.contains("00000000000000ab"), "{text}");
        assert_eq!(ShardManifest::from_json(&text).unwrap(), manifest);
    }

    #[test]
    fn what_is_no_manifest_is_refused() {
        for (text, said) in [
            ("{\"coface_shards\": 2, \"parts\": \"many\"}", "a newer version"),
            ("{\"coface_shards\": 1, \"complex\": \"1\", \"fan_in\": 2, \"part\": 3}", "how many parts"),
            ("{\"coface_shards\": 1, \"parts\": \"many\"}", "is no list of shards: invalid type"),
            ("{\"complex\": \"1\"}", "its version"),
            ("{", "is no JSON"),
        ] {
            let error = ShardManifest::from_json(text).unwrap_err();
            assert!(error.message().contains(said) && error.cure().is_some(), "{error}");
        }
    }
}
