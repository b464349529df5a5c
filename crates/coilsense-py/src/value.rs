//! What makes a value of Python out of a noun: its arguments as a dict, from which come `repr`, `to_dict` and pickle.
//!
//! A value that is made by name (`Spring(rest_length=…)`) gives its arguments; one of several kinds (`EndInput.ramp(…)`) its kind beside them.
//! Next door: equality, which PyO3 takes from Rust's `PartialEq`.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// Its arguments by name, as the constructor takes them.
pub type Arguments<'py> = Bound<'py, PyDict>;

/// What `pickle` hands to the class: no argument by place, all by name.
pub type NewArguments<'py> = (Bound<'py, PyTuple>, Arguments<'py>);

/// The arguments as `__getnewargs_ex__` has them.
pub fn new_arguments(arguments: Arguments<'_>) -> NewArguments<'_> {
    (PyTuple::empty(arguments.py()), arguments)
}

/// `Name(key=value, …)`.
pub fn shown(name: &str, arguments: &Arguments<'_>) -> PyResult<String> {
    let mut parts = Vec::new();
    for (key, value) in arguments {
        parts.push(format!("{key}={}", value.repr()?));
    }
    Ok(format!("{name}({})", parts.join(", ")))
}

/// The arguments with values that are nouns turned into dicts, too: nothing but numbers, texts, lists and dicts.
pub fn plain<'py>(arguments: &Arguments<'py>) -> PyResult<Arguments<'py>> {
    let dict = PyDict::new(arguments.py());
    for (key, value) in arguments {
        if value.hasattr("to_dict")? {
            dict.set_item(key, value.call_method0("to_dict")?)?;
        } else if value.hasattr("tolist")? {
            dict.set_item(key, value.call_method0("tolist")?)?;
        } else {
            dict.set_item(key, value)?;
        }
    }
    Ok(dict)
}

/// A value of several kinds: which, and its arguments.
pub struct Kind<'py> {
    /// The name of the constructor.
    pub name: &'static str,
    /// What it takes.
    pub arguments: Arguments<'py>,
}

impl<'py> Kind<'py> {
    /// A kind without arguments yet.
    pub fn new(py: Python<'py>, name: &'static str) -> Self {
        Self { name, arguments: PyDict::new(py) }
    }

    /// The same with one more argument.
    pub fn with(self, key: &str, value: impl IntoPyObject<'py>) -> PyResult<Self> {
        self.arguments.set_item(key, value)?;
        Ok(self)
    }

    /// `Name.kind(key=value, …)`.
    pub fn shown(&self, class: &str) -> PyResult<String> {
        shown(&format!("{class}.{}", self.name), &self.arguments)
    }

    /// The kind and its arguments in one dict.
    pub fn to_dict(&self) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(self.arguments.py());
        dict.set_item("kind", self.name)?;
        dict.update(plain(&self.arguments)?.as_mapping())?;
        Ok(dict)
    }

    /// What `pickle` keeps: `Class.from_dict` and its argument.
    pub fn reduced(&self, class: &Bound<'py, PyAny>) -> PyResult<(Bound<'py, PyAny>, (Arguments<'py>,))> {
        Ok((class.getattr("from_dict")?, (self.to_dict()?,)))
    }
}

/// Calls `class.kind(**rest)` for a dict of a kind and its arguments: the way back from [`Kind::to_dict`].
pub fn of_dict<'py>(
    class: &Bound<'py, pyo3::types::PyType>,
    dict: &Arguments<'py>,
    kinds: &[&str],
) -> PyResult<Bound<'py, PyAny>> {
    let arguments = dict.copy()?;
    let Some(kind) = dict.get_item("kind")? else {
        return Err(crate::errors::Error::new_err(format!("kind is missing; it must be one of {}", kinds.join(", "))));
    };
    arguments.del_item("kind")?;
    let kind: String = kind.extract()?;
    if !kinds.contains(&kind.as_str()) {
        return Err(crate::errors::unknown("kind", kinds, &kind));
    }
    class.call_method(kind.as_str(), (), Some(&arguments))
}
