//! What the library serializes, such as an answer, as objects of Python.

use crate::cures::in_python;
use crate::errors::invalid;
use coface::answers::answer::Remark;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString};
use serde::ser::{
    Serialize, SerializeMap, SerializeSeq, SerializeStruct, SerializeStructVariant, SerializeTuple,
    SerializeTupleStruct, SerializeTupleVariant, Serializer,
};
use std::fmt;

/// An answer as dictionaries, lists, texts and numbers of Python: what its JSON stands for, with keys in alphabetical order. A number that
/// is not finite is `None`.
pub(crate) fn to_python<'py, T: Serialize + ?Sized>(
    py: Python<'py>,
    answer: &T,
) -> PyResult<Bound<'py, PyAny>> {
    answer.serialize(Objects(py)).map_err(|fault| match fault {
        Fault::Python(error) => error,
        Fault::Answer(message) => {
            invalid(py, message, "tell the authors: an answer has what is no object of Python")
        }
    })
}

/// The remarks of an answer as dictionaries, their messages with the parameters of functions for the options of the program.
pub(crate) fn remarks_of<'py>(py: Python<'py>, remarks: &[Remark]) -> PyResult<Bound<'py, PyAny>> {
    let mut remarks = remarks.to_vec();
    remarks.iter_mut().for_each(|remark| remark.message = in_python(&remark.message));
    to_python(py, &remarks)
}

/// An answer, or one of its keys, as JSON, for the text that represents an object.
pub(crate) fn text_of(answer: &(impl Serialize + ?Sized)) -> String {
    serde_json::to_string(answer).expect("answers have texts as keys")
}

/// Why there is no object.
#[derive(Debug)]
enum Fault {
    Python(PyErr),
    Answer(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Python(error) => error.fmt(formatter),
            Self::Answer(message) => message.fmt(formatter),
        }
    }
}

impl std::error::Error for Fault {}

impl serde::ser::Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self::Answer(message.to_string())
    }
}

impl From<PyErr> for Fault {
    fn from(error: PyErr) -> Self {
        Self::Python(error)
    }
}

type Made<'py> = Result<Bound<'py, PyAny>, Fault>;

/// Makes an object of each value.
#[derive(Clone, Copy)]
struct Objects<'py>(Python<'py>);

impl<'py> Objects<'py> {
    fn number(self, number: impl IntoPyObject<'py, Target = PyInt, Output = Bound<'py, PyInt>>) -> Made<'py> {
        Ok(number.into_pyobject(self.0).map_err(Into::<PyErr>::into)?.into_any())
    }

    /// The dictionary of an enum's variant with fields.
    fn variant(self, name: &str, content: Bound<'py, PyAny>) -> Made<'py> {
        let dict = PyDict::new(self.0);
        dict.set_item(name, content)?;
        Ok(dict.into_any())
    }

    fn items(self, count: Option<usize>, variant: Option<&'static str>) -> Items<'py> {
        Items { objects: self, variant, items: Vec::with_capacity(count.unwrap_or(0)) }
    }

    fn fields(self, count: Option<usize>, variant: Option<&'static str>) -> Fields<'py> {
        Fields { objects: self, variant, key: None, fields: Vec::with_capacity(count.unwrap_or(0)) }
    }
}

/// Items of a list to be.
struct Items<'py> {
    objects: Objects<'py>,
    variant: Option<&'static str>,
    items: Vec<Bound<'py, PyAny>>,
}

impl<'py> Items<'py> {
    fn push<T: Serialize + ?Sized>(&mut self, item: &T) -> Result<(), Fault> {
        self.items.push(item.serialize(self.objects)?);
        Ok(())
    }

    fn list(self) -> Made<'py> {
        let list = PyList::new(self.objects.0, self.items)?.into_any();
        match self.variant {
            Some(name) => self.objects.variant(name, list),
            None => Ok(list),
        }
    }
}

/// Keys and values of a dictionary to be.
struct Fields<'py> {
    objects: Objects<'py>,
    variant: Option<&'static str>,
    /// The key whose value comes next.
    key: Option<Bound<'py, PyString>>,
    fields: Vec<(Bound<'py, PyString>, Bound<'py, PyAny>)>,
}

impl<'py> Fields<'py> {
    fn push<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Result<(), Fault> {
        self.fields.push((PyString::intern(self.objects.0, key), value.serialize(self.objects)?));
        Ok(())
    }

    fn dict(self) -> Made<'py> {
        let mut fields = Vec::with_capacity(self.fields.len());
        for (key, value) in &self.fields {
            fields.push((key.to_str()?, value));
        }
        fields.sort_by_key(|(key, _)| *key);
        let dict = PyDict::new(self.objects.0);
        for (key, value) in fields {
            dict.set_item(key, value)?;
        }
        match self.variant {
            Some(name) => self.objects.variant(name, dict.into_any()),
            None => Ok(dict.into_any()),
        }
    }
}

impl<'py> Serializer for Objects<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;
    type SerializeSeq = Items<'py>;
    type SerializeTuple = Items<'py>;
    type SerializeTupleStruct = Items<'py>;
    type SerializeTupleVariant = Items<'py>;
    type SerializeMap = Fields<'py>;
    type SerializeStruct = Fields<'py>;
    type SerializeStructVariant = Fields<'py>;

    fn serialize_bool(self, value: bool) -> Made<'py> {
        Ok(PyBool::new(self.0, value).to_owned().into_any())
    }

    fn serialize_i8(self, value: i8) -> Made<'py> {
        self.number(value)
    }

    fn serialize_i16(self, value: i16) -> Made<'py> {
        self.number(value)
    }

    fn serialize_i32(self, value: i32) -> Made<'py> {
        self.number(value)
    }

    fn serialize_i64(self, value: i64) -> Made<'py> {
        self.number(value)
    }

    fn serialize_u8(self, value: u8) -> Made<'py> {
        self.number(value)
    }

    fn serialize_u16(self, value: u16) -> Made<'py> {
        self.number(value)
    }

    fn serialize_u32(self, value: u32) -> Made<'py> {
        self.number(value)
    }

    fn serialize_u64(self, value: u64) -> Made<'py> {
        self.number(value)
    }

    fn serialize_f32(self, value: f32) -> Made<'py> {
        self.serialize_f64(value.into())
    }

    fn serialize_f64(self, value: f64) -> Made<'py> {
        match value.is_finite() {
            true => Ok(PyFloat::new(self.0, value).into_any()),
            false => self.serialize_unit(),
        }
    }

    fn serialize_char(self, value: char) -> Made<'py> {
        self.serialize_str(value.encode_utf8(&mut [0; 4]))
    }

    fn serialize_str(self, value: &str) -> Made<'py> {
        Ok(PyString::new(self.0, value).into_any())
    }

    fn serialize_bytes(self, value: &[u8]) -> Made<'py> {
        Ok(PyList::new(self.0, value)?.into_any())
    }

    fn serialize_none(self) -> Made<'py> {
        self.serialize_unit()
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Made<'py> {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Made<'py> {
        Ok(self.0.None().into_bound(self.0))
    }

    fn serialize_unit_struct(self, _: &'static str) -> Made<'py> {
        self.serialize_unit()
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, variant: &'static str) -> Made<'py> {
        self.serialize_str(variant)
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, _: &'static str, value: &T) -> Made<'py> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Made<'py> {
        self.variant(variant, value.serialize(self)?)
    }

    fn serialize_seq(self, count: Option<usize>) -> Result<Items<'py>, Fault> {
        Ok(self.items(count, None))
    }

    fn serialize_tuple(self, count: usize) -> Result<Items<'py>, Fault> {
        Ok(self.items(Some(count), None))
    }

    fn serialize_tuple_struct(self, _: &'static str, count: usize) -> Result<Items<'py>, Fault> {
        Ok(self.items(Some(count), None))
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        count: usize,
    ) -> Result<Items<'py>, Fault> {
        Ok(self.items(Some(count), Some(variant)))
    }

    fn serialize_map(self, count: Option<usize>) -> Result<Fields<'py>, Fault> {
        Ok(self.fields(count, None))
    }

    fn serialize_struct(self, _: &'static str, count: usize) -> Result<Fields<'py>, Fault> {
        Ok(self.fields(Some(count), None))
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        count: usize,
    ) -> Result<Fields<'py>, Fault> {
        Ok(self.fields(Some(count), Some(variant)))
    }
}

impl<'py> SerializeSeq for Items<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, item: &T) -> Result<(), Fault> {
        self.push(item)
    }

    fn end(self) -> Made<'py> {
        self.list()
    }
}

impl<'py> SerializeTuple for Items<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, item: &T) -> Result<(), Fault> {
        self.push(item)
    }

    fn end(self) -> Made<'py> {
        self.list()
    }
}

impl<'py> SerializeTupleStruct for Items<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, item: &T) -> Result<(), Fault> {
        self.push(item)
    }

    fn end(self) -> Made<'py> {
        self.list()
    }
}

impl<'py> SerializeTupleVariant for Items<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, item: &T) -> Result<(), Fault> {
        self.push(item)
    }

    fn end(self) -> Made<'py> {
        self.list()
    }
}

impl<'py> SerializeMap for Fields<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Fault> {
        let key = key.serialize(self.objects)?;
        let is_number = key.is_instance_of::<PyInt>() && !key.is_instance_of::<PyBool>();
        self.key = Some(match key.cast_into::<PyString>() {
            Ok(text) => text,
            Err(other) if is_number => other.into_inner().str()?,
            Err(_) => return Err(Fault::Answer("a key is no text".to_owned())),
        });
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Fault> {
        let key = self.key.take().ok_or_else(|| Fault::Answer("a value has no key".to_owned()))?;
        self.fields.push((key, value.serialize(self.objects)?));
        Ok(())
    }

    fn end(self) -> Made<'py> {
        self.dict()
    }
}

impl<'py> SerializeStruct for Fields<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Result<(), Fault> {
        self.push(key, value)
    }

    fn end(self) -> Made<'py> {
        self.dict()
    }
}

impl<'py> SerializeStructVariant for Fields<'py> {
    type Ok = Bound<'py, PyAny>;
    type Error = Fault;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Result<(), Fault> {
        self.push(key, value)
    }

    fn end(self) -> Made<'py> {
        self.dict()
    }
}
