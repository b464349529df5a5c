//! What makes a value of Python out of a noun: its attributes, and its arguments as a dict, from which come `repr`, `to_dict` and pickle.
//!
//! A value that is made by name (`Spring(rest_length=…)`) gives its arguments ([`named_value`]); one of several kinds (`EndInput.ramp(…)`)
//! its kind beside them ([`value_of_kinds`]). What a value of any sort only shows is a line each ([`getters`]).
//! `results` has the crate's only other macro. Without them each class would spell the same functions. PyO3's own `get_all` cannot stand in
//! for them: it shows fields of the class itself, and a class here holds one value of the science whose fields are private.
//! Next door: equality, which PyO3 takes from Rust's `PartialEq`.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// Attributes of a class that are read only: documentation, name, type, and where the value comes from.
///
/// ```text
/// getters! {
///     PySpring, self;
///     /// k: stiffness [N/m].
///     stiffness: f64 = self.0.stiffness();
///     /// Of the modes [rad/s], shape (modes,).
///     frequencies<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.frequencies());
/// }
/// ```
///
/// A value that takes more than one expression to compute is a `#[getter]` among the class's methods.
macro_rules! getters {
    ($class:ident, $self:ident; $(
        $(#[$documentation:meta])+
        $seen:vis $name:ident $(<$life:lifetime>($py:ident))?: $type:ty = $value:expr;
    )+) => {
        #[::pyo3::pymethods]
        impl $class {
            $(
                $(#[$documentation])+
                #[getter]
                $seen fn $name $(<$life>)?(&$self $(, $py: ::pyo3::Python<$life>)?) -> $type {
                    $value
                }
            )+
        }
    };
}

/// What a value needs that its constructor makes by name: `arguments` for Rust; `to_dict`, pickle and `repr` for Python.
///
/// An argument is worth what the getter of its name says, unless it is told otherwise. The line of documentation is `to_dict`'s.
///
/// ```text
/// named_value! {
///     /// The arguments by name, the material as a dict.
///     PyGeometry, self;
///     wire_diameter = self.0.parameters().wire_diameter, end_type, material,
/// }
/// ```
macro_rules! named_value {
    ($(#[$documentation:meta])+ $class:ident, $self:ident; $($name:ident $(= $value:expr)?),+ $(,)?) => {
        $crate::value::named_value! { $(#[$documentation])+ $class, $self, made = |slf| Ok(slf.get_type().into_any()); $($name $(= $value)?),+ }
    };
    ($(#[$documentation:meta])+ $class:ident, $self:ident, made = $made:expr; $($name:ident $(= $value:expr)?),+ $(,)?) => {
        impl $class {
            fn arguments<'py>(&$self, py: ::pyo3::Python<'py>) -> ::pyo3::PyResult<$crate::value::Arguments<'py>> {
                let arguments = ::pyo3::types::PyDict::new(py);
                $(arguments.set_item(stringify!($name), $crate::value::argument!($self, $name $(, $value)?))?;)+
                Ok(arguments)
            }
        }

        #[::pyo3::pymethods]
        impl $class {
            $(#[$documentation])+
            ///
            /// Returns
            /// -------
            /// dict
            fn to_dict<'py>(&self, py: ::pyo3::Python<'py>) -> ::pyo3::PyResult<$crate::value::Arguments<'py>> {
                $crate::value::plain(&self.arguments(py)?)
            }

            /// The same with other values for some of the arguments, checked as the constructor checks them; ``copy.replace`` of Python 3.13 calls it, too.
            ///
            /// Parameters
            /// ----------
            /// **changes
            ///     Arguments of the constructor by name.
            ///
            /// Returns
            /// -------
            /// Self
            ///
            /// Raises
            /// ------
            /// TypeError
            ///     For a name that is none of them; it says which there are.
            /// Error
            ///     Where the constructor would.
            #[pyo3(signature = (**changes))]
            fn replace<'py>(
                slf: &::pyo3::Bound<'py, Self>,
                changes: Option<$crate::value::Arguments<'py>>,
            ) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                let made: fn(&::pyo3::Bound<'py, Self>) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> = $made;
                let (name, arguments) = (<Self as ::pyo3::PyClass>::NAME, slf.get().arguments(slf.py())?);
                made(slf)?.call((), Some(&$crate::value::replaced(name, arguments, changes)?))
            }

            #[pyo3(signature = (**changes))]
            fn __replace__<'py>(
                slf: &::pyo3::Bound<'py, Self>,
                changes: Option<$crate::value::Arguments<'py>>,
            ) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                Self::replace(slf, changes)
            }

            fn __getnewargs_ex__<'py>(
                &self,
                py: ::pyo3::Python<'py>,
            ) -> ::pyo3::PyResult<$crate::value::NewArguments<'py>> {
                Ok($crate::value::new_arguments(self.arguments(py)?))
            }

            fn __repr__(&self, py: ::pyo3::Python<'_>) -> ::pyo3::PyResult<String> {
                $crate::value::shown(<Self as ::pyo3::PyClass>::NAME, &self.arguments(py)?)
            }
        }
    };
}

/// An argument's value: the getter's of its name, or what is told.
macro_rules! argument {
    ($self:ident, $name:ident) => {
        $self.$name()
    };
    ($self:ident, $name:ident, $value:expr) => {
        $value
    };
}

/// What a value of several kinds needs beside its constructors and `as_kind`: `kind`, `to_dict` and the way back, pickle and `repr`.
///
/// ```text
/// value_of_kinds! {
///     /// Which constructor makes it: "position", "force" or "mass".
///     PyFarEnd, "FarEnd"; "position", "force", "mass"
/// }
/// ```
macro_rules! value_of_kinds {
    ($(#[$documentation:meta])+ $class:ident, $name:literal; $($kind:literal),+) => {
        #[::pyo3::pymethods]
        impl $class {
            $(#[$documentation])+
            #[getter]
            fn kind(&self, py: ::pyo3::Python<'_>) -> ::pyo3::PyResult<&'static str> {
                Ok(self.as_kind(py)?.name)
            }

            /// Its kind and its arguments by name.
            ///
            /// Returns
            /// -------
            /// dict
            fn to_dict<'py>(&self, py: ::pyo3::Python<'py>) -> ::pyo3::PyResult<$crate::value::Arguments<'py>> {
                self.as_kind(py)?.to_dict()
            }

            /// The way back from `to_dict`.
            ///
            /// Parameters
            /// ----------
            /// dict : dict
            ///     The kind, and the arguments of the constructor of that name.
            ///
            /// Returns
            /// -------
            #[doc = $name]
            #[classmethod]
            fn from_dict<'py>(
                class: &::pyo3::Bound<'py, ::pyo3::types::PyType>,
                dict: $crate::value::Arguments<'py>,
            ) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                $crate::value::of_dict(class, &dict, &[$($kind),+])
            }

            /// The same kind with other values for some of its arguments; ``copy.replace`` of Python 3.13 calls it, too.
            ///
            /// Parameters
            /// ----------
            /// **changes
            ///     Arguments of the kind's constructor by name.
            ///
            /// Returns
            /// -------
            #[doc = $name]
            ///
            /// Raises
            /// ------
            /// TypeError
            ///     For a name that is none of them; it says which there are.
            /// Error
            ///     Where the constructor would.
            #[pyo3(signature = (**changes))]
            fn replace<'py>(
                slf: &::pyo3::Bound<'py, Self>,
                changes: Option<$crate::value::Arguments<'py>>,
            ) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                let kind = slf.get().as_kind(slf.py())?;
                let name = format!("{}.{}", $name, kind.name);
                let arguments = $crate::value::replaced(&name, kind.arguments, changes)?;
                slf.get_type().call_method(kind.name, (), Some(&arguments))
            }

            #[pyo3(signature = (**changes))]
            fn __replace__<'py>(
                slf: &::pyo3::Bound<'py, Self>,
                changes: Option<$crate::value::Arguments<'py>>,
            ) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                Self::replace(slf, changes)
            }

            fn __reduce__<'py>(
                slf: &::pyo3::Bound<'py, Self>,
            ) -> ::pyo3::PyResult<(::pyo3::Bound<'py, ::pyo3::PyAny>, ($crate::value::Arguments<'py>,))> {
                slf.get().as_kind(slf.py())?.reduced(slf.get_type().as_any())
            }

            fn __repr__(&self, py: ::pyo3::Python<'_>) -> ::pyo3::PyResult<String> {
                self.as_kind(py)?.shown($name)
            }
        }
    };
}

pub(crate) use {argument, getters, named_value, value_of_kinds};

/// Its arguments by name, as the constructor takes them.
pub type Arguments<'py> = Bound<'py, PyDict>;

/// What `pickle` hands to the class: no argument by place, all by name.
pub type NewArguments<'py> = (Bound<'py, PyTuple>, Arguments<'py>);

/// The arguments as `__getnewargs_ex__` has them.
pub fn new_arguments(arguments: Arguments<'_>) -> NewArguments<'_> {
    (PyTuple::empty(arguments.py()), arguments)
}

/// The arguments with others for some of them.
///
/// # Errors
/// `TypeError` for a name that is none of them.
pub fn replaced<'py>(
    name: &str,
    arguments: Arguments<'py>,
    changes: Option<Arguments<'py>>,
) -> PyResult<Arguments<'py>> {
    for (key, value) in changes.iter().flatten() {
        if !arguments.contains(&key)? {
            let known = arguments.keys().iter().map(|key| key.to_string()).collect::<Vec<_>>();
            let takes = if known.is_empty() { "nothing".to_owned() } else { known.join(", ") };
            return Err(PyTypeError::new_err(format!("replace() of {name} takes {takes}, got {key}")));
        }
        arguments.set_item(key, value)?;
    }
    Ok(arguments)
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
