//! Faults of the library as exceptions of Python.

use crate::cures::in_python;
use coface::algebra::escaped;
use coface::{Error, ErrorKind};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyTuple, PyType};
use std::ffi::CString;

/// The classes, written in Python: only there can one exception have two bases.
const SOURCE: &str = include_str!("errors.py");

/// The names of the classes, the base first.
const NAMES: [&str; 19] = [
    "Error",
    "FileError",
    "ParseError",
    "UnsupportedFormatError",
    "InvalidInputError",
    "InvalidTypeError",
    "OutOfRangeError",
    "NotInComplexError",
    "NoSuchPlaceError",
    "NotAComplexError",
    "NotPureError",
    "BoundaryOfBoundaryError",
    "NotACycleError",
    "ShapeError",
    "TooLargeError",
    "NonManifoldError",
    "CoefficientError",
    "NotInstalledError",
    "AssumptionWarning",
];

static CLASSES: PyOnceLock<Py<PyDict>> = PyOnceLock::new();

/// Makes the classes and puts them into the module.
pub(crate) fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    let classes = PyDict::new(py);
    classes.set_item("__name__", "coface")?;
    let source = CString::new(SOURCE)?;
    py.run(&source, Some(&classes), None)?;
    for name in NAMES {
        if let Some(class) = classes.get_item(name)? {
            module.add(name, class)?;
        }
    }
    // Made once, when the module is loaded first.
    drop(CLASSES.set(py, classes.unbind()));
    Ok(())
}

/// Warns of what a reader assumed.
pub(crate) fn warn(py: Python<'_>, message: &str) -> PyResult<()> {
    let Some(classes) = CLASSES.get(py) else { return Ok(()) };
    let Some(class) = classes.bind(py).get_item("AssumptionWarning")? else { return Ok(()) };
    PyErr::warn(py, &class, &CString::new(escaped(&in_python(message)).into_owned())?, 1)
}

fn class_name(kind: ErrorKind) -> &'static str {
    match kind {
        ErrorKind::Io => "FileError",
        ErrorKind::Parse => "ParseError",
        ErrorKind::UnsupportedFormat => "UnsupportedFormatError",
        ErrorKind::InvalidInput => "InvalidInputError",
        ErrorKind::NotInComplex => "NotInComplexError",
        ErrorKind::NotAComplex => "NotAComplexError",
        ErrorKind::NotPure => "NotPureError",
        ErrorKind::BoundaryOfBoundary => "BoundaryOfBoundaryError",
        ErrorKind::NotACycle => "NotACycleError",
        ErrorKind::Shape => "ShapeError",
        ErrorKind::TooLarge => "TooLargeError",
        ErrorKind::NonManifold => "NonManifoldError",
        ErrorKind::Coefficient => "CoefficientError",
        _ => "Error",
    }
}

/// The exception for a fault of the library.
pub(crate) fn raised(py: Python<'_>, error: &Error) -> PyErr {
    raised_as(py, class_name(error.kind()), error)
}

fn raised_as(py: Python<'_>, name: &str, error: &Error) -> PyErr {
    let make = || -> PyResult<PyErr> {
        let Some(classes) = CLASSES.get(py) else { return Ok(PyRuntimeError::new_err(error.to_string())) };
        let classes = classes.bind(py);
        let class = classes.get_item(name)?.or(classes.get_item("Error")?);
        let Some(class) = class else { return Ok(PyRuntimeError::new_err(error.to_string())) };
        let fields = PyDict::new(py);
        fields.set_item("fault", error.message())?;
        fields.set_item("cure", error.cure().map(in_python))?;
        fields.set_item("cells", error.cells())?;
        fields.set_item("file", error.file())?;
        fields.set_item("line", error.line())?;
        fields.set_item("byte", error.byte())?;
        let value = class.cast::<PyType>()?.call((in_python(&error.to_string()),), Some(&fields))?;
        Ok(PyErr::from_value(value))
    };
    make().unwrap_or_else(|fault| fault)
}

/// Turns faults of the library into exceptions.
pub(crate) trait OrRaise<T> {
    /// The value, or the exception.
    fn or_raise(self, py: Python<'_>) -> PyResult<T>;
}

impl<T> OrRaise<T> for Result<T, Error> {
    fn or_raise(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|error| raised(py, &error))
    }
}

/// An exception for arguments that cannot be what is asked for.
pub(crate) fn invalid(py: Python<'_>, message: impl Into<String>, cure: &str) -> PyErr {
    raised(py, &Error::invalid(message).with_cure(cure))
}

/// The same for an argument of a wrong type: a `TypeError` too.
pub(crate) fn wrong_type(py: Python<'_>, message: impl Into<String>, cure: &str) -> PyErr {
    raised_as(py, "InvalidTypeError", &Error::invalid(message).with_cure(cure))
}

/// The same for a place that a list does not have: an `IndexError` too.
pub(crate) fn no_place(py: Python<'_>, message: impl Into<String>, cure: &str) -> PyErr {
    raised_as(py, "NoSuchPlaceError", &Error::invalid(message).with_cure(cure))
}

/// A degree, a count or the number of a cell as Python gives it; negative and fractional ones are refused in words.
pub(crate) fn whole(value: &Bound<'_, PyAny>) -> PyResult<usize> {
    let py = value.py();
    let Ok(number) = py.import("operator")?.getattr("index")?.call1((value,)) else {
        let name = value.get_type().name()?;
        return Err(wrong_type(py, format!("{value} is a {name}"), "give an integer from 0"));
    };
    number.extract().map_err(|_| {
        let error = Error::invalid(format!("the number {number} is out of range"));
        raised_as(py, "OutOfRangeError", &error.with_cure("give an integer from 0"))
    })
}

/// The same, or nothing.
pub(crate) fn whole_or_none(value: &Bound<'_, PyAny>) -> PyResult<Option<usize>> {
    if value.is_none() { Ok(None) } else { whole(value).map(Some) }
}

/// True or false as Python or numpy gives it; what is neither is refused in words.
pub(crate) fn truth(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    value.extract().map_err(|_| {
        let name = value.get_type().name().map_or_else(|_| String::new(), |name| name.to_string());
        wrong_type(value.py(), format!("a {name} is neither true nor false"), "give True or False")
    })
}

/// The arguments of a constructor by their names, the first `places` of which may be given by place; `None` is none. Faults are those of this
/// package, where those that Python finds itself would be bare `TypeError`s.
pub(crate) fn bound<'py, const N: usize>(
    class: &str,
    names: [&str; N],
    places: usize,
    arguments: &Bound<'py, PyTuple>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<[Option<Bound<'py, PyAny>>; N]> {
    let py = arguments.py();
    let cure = format!("help(coface.{class}) says what it takes");
    let wrong = |fault: String| wrong_type(py, format!("{class}: {fault}"), &cure);
    let mut found: [Option<Bound<'py, PyAny>>; N] = std::array::from_fn(|_| None);
    if arguments.len() > places {
        let by_place = names[..places].join(", ");
        return Err(wrong(format!(
            "{} arguments are given by place, and only {by_place} may be",
            arguments.len()
        )));
    }
    for (at, given) in arguments.iter().enumerate() {
        found[at] = Some(given);
    }
    for (name, given) in options.into_iter().flatten() {
        let name = name.extract::<String>()?;
        let Some(at) = names.iter().position(|own| *own == name) else {
            return Err(wrong(format!("there is no parameter {name}")));
        };
        if found[at].replace(given).is_some() {
            return Err(wrong(format!("{name} is given twice")));
        }
    }
    Ok(found.map(|given| given.filter(|given| !given.is_none())))
}

/// An argument that a constructor needs.
pub(crate) fn required<'py>(
    py: Python<'py>,
    class: &str,
    name: &str,
    given: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let cure = format!("help(coface.{class}) says what it takes");
    given.ok_or_else(|| wrong_type(py, format!("{class}: {name} is not given"), &cure))
}

/// A message of the program in the words of Python, for tests.
#[pyfunction]
pub(crate) fn _in_python(message: &str) -> String {
    in_python(message)
}
