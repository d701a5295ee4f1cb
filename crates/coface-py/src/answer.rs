//! Answers whose fields are the words of the program's JSON.

/// The methods of a class whose answer is JSON: one read-only property for each key, and what stands in the second part.
macro_rules! answer {
    ($type:ident { $($(#[$doc:meta])* $name:ident),* $(,)? } $($rest:tt)*) => {
        #[pymethods]
        impl $type {
            $(
                $(#[$doc])*
                #[getter]
                fn $name<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                    crate::json::to_python(py, &self.value[stringify!($name)])
                }
            )*

            /// The answer as a dictionary, in the words of the program's JSON.
            fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                crate::json::to_python(py, &self.value)
            }

            $($rest)*
        }
    };
}

pub(crate) use answer;
