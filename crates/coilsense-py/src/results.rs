//! What results of the lab have in common: the command's text, its files, and how Python lays them out.
//!
//! Next door: JSON as a dict (`json`), what values have in common (`value`), the results (`identification`, `calibration`, `experiment`,
//! `mitigation`, `placement`, `sweep`).

use std::path::Path;

use coilsense_lab::output::Output;
use coilsense_lab::report::ReportError;
use pyo3::prelude::*;

use crate::analysis::day;
use crate::errors::IntoPython;
use crate::threads::spread;

/// What a study's result lets a user do with it, under one name everywhere: `to_dict`, `to_pandas`, `plot`, `str()`, what a notebook shows,
/// and `save`.
///
/// Lines of documentation are the methods' own; tables, figures and pages are functions of the Python code beside this module. A result
/// without a figure leaves out `plot`; one that is saved with other arguments leaves out `save` and has its own.
///
/// ```text
/// study_result! {
///     PyPlacement, self;
///     /// Everything, under the names of results.json.
///     to_dict = placement_json(&self.0);
///     /// The limits as a data frame of pandas; ``pip install coilsense[pandas]``.
///     to_pandas = "limits_frame";
///     str = placement_text(&self.0);
///     html = "placement_html";
///     /// Writes what ``coilsense placement --out`` writes: report.html and results.json; all of it or nothing.
///     save(date, output) = add_placement(&self.0, date, output);
/// }
/// ```
macro_rules! study_result {
    (
        $class:ident, $self:ident;
        $(#[$everything:meta])+
        to_dict = $json:expr;
        $(#[$tabulated:meta])+
        to_pandas = $table:literal;
        $(
            $(#[$drawn:meta])+
            plot = $figure:literal;
        )?
        str = $text:expr;
        html = $page:literal;
        $(
            $(#[$written:meta])+
            save($date:ident, $output:ident $(; $given:ident = $found:expr)?) = $add:expr;
        )?
    ) => {
        $crate::results::table_and_figure! {
            $class;
            $(#[$tabulated])+
            to_pandas = $table;
            $($(#[$drawn])+ plot = $figure;)?
        }

        #[::pyo3::pymethods]
        impl $class {
            $(#[$everything])+
            ///
            /// Returns
            /// -------
            /// dict
            fn to_dict<'py>(&$self, py: ::pyo3::Python<'py>) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                $crate::json::loads(py, $json)
            }

            fn __str__(&$self) -> String {
                $crate::results::plain(&$text)
            }

            fn _repr_html_<'py>(slf: &::pyo3::Bound<'py, Self>) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                $crate::results::laid_out(slf.py(), $page, (slf,))
            }

            $(
                $(#[$written])+
                ///
                /// Parameters
                /// ----------
                /// folder : str or os.PathLike
                ///     Its other files are left alone.
                /// date : str, optional
                ///     What the report carries; without it, today's.
                /// overwrite : bool
                ///     Whether files are replaced, too, that coilsense did not write or that have changed since.
                ///
                /// Returns
                /// -------
                /// int
                ///     How many files.
                #[pyo3(signature = (folder, date=None, overwrite=false))]
                fn save(
                    &$self,
                    py: ::pyo3::Python<'_>,
                    folder: ::std::path::PathBuf,
                    date: Option<String>,
                    overwrite: bool,
                ) -> ::pyo3::PyResult<usize> {
                    $(let $given = $found;)?
                    $crate::results::save(py, &folder, date, overwrite, |$date, $output| $add)
                }
            )?
        }
    };
}

/// What a noun shows as a data frame and in a figure, by functions of the Python code beside this module.
macro_rules! table_and_figure {
    (
        $class:ident;
        $(#[$tabulated:meta])+
        to_pandas = $table:literal;
        $(
            $(#[$drawn:meta])+
            plot = $figure:literal;
        )?
    ) => {
        #[::pyo3::pymethods]
        impl $class {
            $(#[$tabulated])+
            ///
            /// Returns
            /// -------
            /// pandas.DataFrame
            fn to_pandas<'py>(slf: &::pyo3::Bound<'py, Self>) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                $crate::results::laid_out(slf.py(), $table, (slf,))
            }

            $(
                $(#[$drawn])+
                ///
                /// Parameters
                /// ----------
                /// ax : matplotlib.axes.Axes, optional
                ///     Where; without it, in a new figure.
                ///
                /// Returns
                /// -------
                /// matplotlib.axes.Axes
                #[pyo3(signature = (ax=None))]
                fn plot<'py>(
                    slf: &::pyo3::Bound<'py, Self>,
                    ax: Option<::pyo3::Bound<'py, ::pyo3::PyAny>>,
                ) -> ::pyo3::PyResult<::pyo3::Bound<'py, ::pyo3::PyAny>> {
                    $crate::results::laid_out(slf.py(), $figure, (slf, ax))
                }
            )?
        }
    };
}

pub(crate) use {study_result, table_and_figure};

/// The text that the command prints, without colours.
pub fn plain(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

/// Writes into a folder what the command writes there, all of it or nothing; returns how many files.
pub fn save(
    py: Python<'_>,
    folder: &Path,
    date: Option<String>,
    overwrite: bool,
    add: impl FnOnce(&str, &mut Output) -> Result<(), ReportError> + Send,
) -> PyResult<usize> {
    let date = day(py, date)?;
    let written = || -> Result<usize, ReportError> {
        let mut output = Output::begin(folder)?.overwriting(overwrite);
        add(&date, &mut output)?;
        Ok(output.commit()?)
    };
    spread(py, written)?.python()
}

/// A function of the Python code beside this module that lays results out: tables, plots, pages for notebooks.
pub fn laid_out<'py>(
    py: Python<'py>,
    name: &str,
    arguments: impl pyo3::call::PyCallArgs<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import("coilsense._results")?.getattr(name)?.call1(arguments)
}
