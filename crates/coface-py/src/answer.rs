//! Answers as classes, with the words of the program's JSON.

/// The methods of a class with the field `answer`: one read-only property for each key of it, and what stands in the second part.
macro_rules! answer {
    ($type:ident { $($(#[$doc:meta])* $name:ident),* $(,)? } $($rest:tt)*) => {
        #[pymethods]
        impl $type {
            $(
                $(#[$doc])*
                #[getter]
                fn $name<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                    crate::objects::to_python(py, &self.answer.$name)
                }
            )*

            /// The answer as a dictionary, in the words of the program's JSON.
            fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                crate::objects::to_python(py, &self.answer)
            }

            $($rest)*
        }
    };
}

pub(crate) use answer;
