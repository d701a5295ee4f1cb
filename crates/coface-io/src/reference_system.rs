//! The reference system of coordinates, as the formats of maps name it.

use crate::Model;
use crate::json_text::compact;
use coface_algebra::Error;
use serde_json::Value;
use std::borrow::Cow;
use std::fmt;

/// The number of the system that GeoJSON has by itself, degrees of longitude and latitude.
const WGS_84: u32 = 4326;

/// The reference system of coordinates: a number (the SRID of EWKT and EWKB), or the `crs` member of GeoJSON.
///
/// Numbers are those of EPSG, so `EPSG:25832` and `urn:ogc:def:crs:EPSG::25832` are the system of SRID 25832, and `CRS84` of OGC is
/// that of 4326, with longitude before latitude as databases have it. Coordinates are never transformed: a system goes from
/// the inputs to what is written. Two systems are equal if they have one number, or the same text.
///
/// # Examples
/// ```
/// use coface_io::ReferenceSystem;
/// let crs = r#"{"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}}"#;
/// let system = ReferenceSystem::from_crs(crs)?;
/// assert_eq!(system.as_ref().and_then(ReferenceSystem::srid), Some(25832));
/// assert_eq!(system, ReferenceSystem::from_srid(25832));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ReferenceSystem {
    srid: Option<u32>,
    /// The member of GeoJSON without white space; made of the number if there is none.
    crs: Option<Box<str>>,
}

impl ReferenceSystem {
    /// The system of this number; 0 is none.
    ///
    /// # Examples
    /// ```
    /// use coface_io::ReferenceSystem;
    /// assert_eq!(ReferenceSystem::from_srid(4326).map(|system| system.to_string()), Some("SRID 4326".to_owned()));
    /// assert_eq!(ReferenceSystem::from_srid(0), None);
    /// ```
    pub fn from_srid(srid: u32) -> Option<Self> {
        (srid > 0).then_some(Self { srid: Some(srid), crs: None })
    }

    /// The system of a `crs` member of GeoJSON; null is none.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is neither a JSON object nor null.
    ///
    /// # Examples
    /// ```
    /// use coface_io::ReferenceSystem;
    /// let linked = ReferenceSystem::from_crs(r#"{"type":"link","properties":{"href":"a.proj4"}}"#)?;
    /// assert!(linked.is_some_and(|system| system.srid().is_none()));
    /// assert_eq!(ReferenceSystem::from_crs("null")?, None);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_crs(crs: &str) -> Result<Option<Self>, Error> {
        match serde_json::from_str::<Value>(crs) {
            Ok(Value::Null) => Ok(None),
            Ok(Value::Object(object)) => {
                let properties = object.get("properties").unwrap_or(&Value::Null);
                let srid = match (&properties["name"], &properties["code"]) {
                    (Value::String(name), _) => srid_of(name),
                    (_, Value::Number(code)) => code.as_u64().and_then(|code| u32::try_from(code).ok()),
                    _ => None,
                };
                Ok(Some(Self { srid, crs: Some(compact(crs).into()) }))
            }
            _ => Err(Error::parse("\"crs\" is neither an object nor null")
                .with_cure(r#"write it as in {"type": "name", "properties": {"name": "EPSG:4326"}}"#)),
        }
    }

    /// The number of the system, if it has one.
    ///
    /// # Examples
    /// ```
    /// use coface_io::ReferenceSystem;
    /// assert_eq!(ReferenceSystem::from_srid(3035).and_then(|system| system.srid()), Some(3035));
    /// ```
    pub fn srid(&self) -> Option<u32> {
        self.srid
    }

    /// The `crs` member of GeoJSON: as it was read, or made of the number.
    ///
    /// # Examples
    /// ```
    /// use coface_io::ReferenceSystem;
    /// let crs = ReferenceSystem::from_srid(3035).map(|system| system.crs().into_owned());
    /// let expected = r#"{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3035"}}"#;
    /// assert_eq!(crs.as_deref(), Some(expected));
    /// ```
    pub fn crs(&self) -> Cow<'_, str> {
        if let Some(crs) = &self.crs {
            return Cow::Borrowed(crs);
        }
        let name = match self.srid {
            Some(WGS_84) | None => "urn:ogc:def:crs:OGC:1.3:CRS84".to_owned(),
            Some(srid) => format!("urn:ogc:def:crs:EPSG::{srid}"),
        };
        Cow::Owned(format!(r#"{{"type":"name","properties":{{"name":"{name}"}}}}"#))
    }

    /// The one system of several files, each with its name, and the names of those without one.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming two files with different systems.
    ///
    /// # Examples
    /// ```
    /// use coface_io::ReferenceSystem;
    /// let [a, b] = [25832, 4326].map(ReferenceSystem::from_srid);
    /// let common = ReferenceSystem::common([("a", a.as_ref()), ("b", None), ("c", None)])?;
    /// assert_eq!(common.map(|(system, without)| (system.srid(), without)), Some((Some(25832), vec!["b", "c"])));
    /// assert!(ReferenceSystem::common([("a", a.as_ref()), ("b", b.as_ref())]).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn common<'a>(
        files: impl IntoIterator<Item = (&'a str, Option<&'a Self>)>,
    ) -> Result<Option<(&'a Self, Vec<&'a str>)>, Error> {
        let mut known: Option<(&str, &Self)> = None;
        let mut without = Vec::new();
        for (name, system) in files {
            match (system, known) {
                (None, _) => without.push(name),
                (Some(system), None) => known = Some((name, system)),
                (Some(system), Some((first, other))) if system != other => {
                    return Err(Error::invalid(format!(
                        "{first} is in {other}, but {name} is in {system}: their coordinates cannot be compared"
                    ))
                    .with_cure(other.transformation()));
                }
                _ => {}
            }
        }
        Ok(known.map(|(_, system)| (system, without)))
    }

    /// How a file comes into this system.
    pub(crate) fn transformation(&self) -> String {
        match self.srid {
            Some(srid) => format!("transform one of them first, as ogr2ogr -t_srs EPSG:{srid} does"),
            None => "transform one of them first, as ogr2ogr -t_srs does".to_owned(),
        }
    }
}

/// The number in the name of a system.
fn srid_of(name: &str) -> Option<u32> {
    let lower = name.trim().to_ascii_lowercase();
    if lower.starts_with("urn:ogc:def:crs:ogc:") && lower.ends_with(":crs84")
        || matches!(&lower[..], "ogc:crs84" | "http://www.opengis.net/def/crs/ogc/1.3/crs84")
    {
        return Some(WGS_84);
    }
    let rest = ["urn:ogc:def:crs:epsg:", "http://www.opengis.net/def/crs/epsg/", "epsg:"]
        .into_iter()
        .find_map(|start| lower.strip_prefix(start))?;
    rest.rsplit([':', '/']).next()?.parse().ok().filter(|&srid| srid > 0)
}

impl Model {
    /// The reference system that the file names: `SRID=..;` of EWKT, the flag of EWKB, or `crs` of GeoJSON.
    ///
    /// # Examples
    /// ```
    /// let model = coface_io::wkt::read(&b"SRID=25832;POINT (1 2)"[..])?;
    /// assert_eq!(model.reference_system().and_then(|system| system.srid()), Some(25832));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn reference_system(&self) -> Option<&ReferenceSystem> {
        self.reference.as_ref()
    }

    /// The model in this reference system, or in none. Coordinates stay as they are.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReferenceSystem, wkt};
    /// let model = wkt::read(&b"POINT (1 2)"[..])?.with_reference_system(ReferenceSystem::from_srid(4326));
    /// let mut written = Vec::new();
    /// wkt::write(&model, &mut written)?;
    /// assert_eq!(written, b"SRID=4326;POINT (1 2)\n");
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn with_reference_system(mut self, system: Option<ReferenceSystem>) -> Self {
        self.reference = system;
        self
    }
}

impl PartialEq for ReferenceSystem {
    fn eq(&self, other: &Self) -> bool {
        match (self.srid, other.srid) {
            (Some(a), Some(b)) => a == b,
            _ => self.srid == other.srid && self.crs == other.crs,
        }
    }
}

impl Eq for ReferenceSystem {}

impl fmt::Display for ReferenceSystem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.srid, &self.crs) {
            (Some(srid), _) => write!(f, "SRID {srid}"),
            (None, Some(crs)) => write!(f, "the crs {crs}"),
            (None, None) => f.write_str("no system"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> ReferenceSystem {
        let crs = format!(r#"{{ "type" : "name", "properties": {{"name": "{name}"}} }}"#);
        ReferenceSystem::from_crs(&crs).unwrap().unwrap()
    }

    #[test]
    fn names_have_numbers() {
        for (name, srid) in [
            ("EPSG:25832", Some(25832)),
            ("epsg:25832", Some(25832)),
            ("urn:ogc:def:crs:EPSG::25832", Some(25832)),
            ("urn:ogc:def:crs:EPSG:9.8:25832", Some(25832)),
            ("http://www.opengis.net/def/crs/EPSG/0/25832", Some(25832)),
            ("urn:ogc:def:crs:OGC:1.3:CRS84", Some(4326)),
            ("OGC:CRS84", Some(4326)),
            ("urn:ogc:def:crs:EPSG::0", None),
            ("ESRI:102008", None),
            ("Mars", None),
        ] {
            assert_eq!(named(name).srid(), srid, "{name}");
        }
        let old = r#"{"type":"EPSG","properties":{"code":2263}}"#;
        assert_eq!(ReferenceSystem::from_crs(old).unwrap().unwrap().srid(), Some(2263));
        assert!(ReferenceSystem::from_crs("5").unwrap_err().cure().is_some());
        assert!(ReferenceSystem::from_crs("{").is_err());
    }

    #[test]
    fn systems_are_equal_by_number_or_text() {
        assert_eq!(named("EPSG:4326"), named("OGC:CRS84"));
        assert_eq!(named("ESRI:102008"), named("ESRI:102008"));
        assert_ne!(named("ESRI:102008"), named("ESRI:102009"));
        assert_ne!(named("ESRI:102008"), named("EPSG:4326"));
        // What is written of a number has that number.
        for srid in [1, 4326, 25832, u32::MAX] {
            let system = ReferenceSystem::from_srid(srid).unwrap();
            assert_eq!(ReferenceSystem::from_crs(&system.crs()).unwrap(), Some(system));
        }
        let text = named("ESRI:102008");
        assert_eq!(text.crs(), r#"{"type":"name","properties":{"name":"ESRI:102008"}}"#);
    }
}
