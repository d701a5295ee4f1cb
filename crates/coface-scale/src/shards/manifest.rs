//! What a folder says about its shards.

use coface_algebra::{Error, ErrorKind};
use serde_json::{Value, json};

/// What the shards of a folder are, as stated in its file `shards.json`.
#[derive(Clone, Debug, PartialEq, Eq)]
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
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ShardSource {
    /// The name of a file or a grid.
    pub name: String,
    /// `model`, `grid`, `volume`, `tetrahedra`.
    pub kind: String,
    /// Something that is the same when the file and the request are: its length, the time of its change, how it was cut. May be empty.
    pub fingerprint: String,
}

const VERSION: u64 = 1;

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
        let value = json!({
            "coface_shards": VERSION,
            "complex": format!("{:016x}", self.complex),
            "parts": self.part_count,
            "fan_in": self.fan_in,
            "source": {"name": self.source.name, "kind": self.source.kind, "fingerprint": self.source.fingerprint},
        });
        format!("{value:#}\n")
    }

    pub(super) fn from_json(text: &str) -> Result<Self, Error> {
        let value: Value = serde_json::from_str(text).map_err(|error| {
            let place = Error::parse(format!("is no JSON: {error}")).at_line(error.line() as u64);
            place.with_cure("shard the complex again")
        })?;
        if value["coface_shards"].as_u64().is_some_and(|version| version > VERSION) {
            return Err(Error::new(ErrorKind::UnsupportedFormat, "the shards are of a newer version")
                .with_cure("merge them with a newer coface"));
        }
        let lacks = |what: &str| {
            Error::parse(format!("does not say {what} as a list of shards does"))
                .with_cure("shard the complex again")
        };
        let number = |key: &str| value[key].as_u64().and_then(|x| u32::try_from(x).ok());
        let text = |key: &str| value["source"][key].as_str().unwrap_or_default().to_owned();
        let complex = value["complex"].as_str().and_then(|text| u64::from_str_radix(text, 16).ok());
        if value["coface_shards"].as_u64() != Some(VERSION) {
            return Err(lacks("its version"));
        }
        Ok(Self {
            complex: complex.ok_or_else(|| lacks("the number of the complex"))?,
            part_count: number("parts")
                .filter(|&count| count > 0)
                .ok_or_else(|| lacks("how many parts there are"))?,
            fan_in: number("fan_in")
                .filter(|&fan_in| fan_in > 1)
                .ok_or_else(|| lacks("how many are merged"))?,
            source: ShardSource { name: text("name"), kind: text("kind"), fingerprint: text("fingerprint") },
        })
    }
}
