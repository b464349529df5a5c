//! `coilsense.Recording` and `open_log`: a measured log in SI on one rising clock, with an account of its rows.
//!
//! Next door: how a log is to be read (`log_options`), what is made of it (`calibration`, `identification`, `mitigation`).

use std::path::PathBuf;

use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::request::{FROM, TO};
use coilsense_lab::recording::{Cleaning, Clock, Recording};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{IntoPython, LogError};
use crate::log_options::LogOptions;
use crate::long_work::interruptible;
use crate::names::Names;
use crate::quantity::{Quantity, cleaning, given};
use crate::results::laid_out;
use crate::signals::{PySignals, channel, told};
use crate::value::getters;

/// Signals that were recorded, with an account of where they come from; made by `open_log`, or of signals in memory.
///
/// Parameters
/// ----------
/// signals : Signals, pandas.DataFrame or mapping
///     A data frame as `Signals.from_pandas` takes it, a mapping as `Signals.from_dict`.
/// name : str, optional
///     What messages and reports call it.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
/// >>> coilsense.Recording(signals).sample_rate
/// 10.0
#[pyclass(name = "Recording", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyRecording(pub Recording);

/// What is known about a second device's clock.
#[derive(FromPyObject)]
enum ClockArgument {
    /// A channel of the first and one of the second that saw the same motion.
    Pair(String, String),
    /// What to add to its times.
    Offset(Quantity),
}

impl ClockArgument {
    fn clock(self) -> PyResult<Clock> {
        match self {
            Self::Pair(mine, theirs) => Ok(Clock::Found(Some([channel(&mine)?, channel(&theirs)?]))),
            Self::Offset(offset) => offset.finite("clock", Dimension::Time).map(Clock::Offset),
        }
    }
}

getters! {
    PyRecording, self;
    /// What was recorded, copied.
    signals<'py>(py): PySignals = PySignals::of(py, self.0.signals().clone());
    /// What became of every row: a line each, as ``coilsense import`` prints them.
    account: Vec<String> = self.0.account().lines();
    /// The file, or the name it was given.
    file: String = self.0.account().file.display().to_string();
    /// Comment lines and what else stands above the rows.
    remarks: Vec<String> = self.0.remarks().to_vec();
    /// What the log says of its being simulated; None where it does not.
    simulated: Option<&str> = self.0.simulated();
    /// Samples per second [Hz]; a LogError where the clock is not even.
    sample_rate: PyResult<f64> = self.0.sample_rate().python();
}

#[pymethods]
impl PyRecording {
    #[new]
    #[pyo3(signature = (signals, name="signals"))]
    fn new(signals: &Bound<'_, PyAny>, name: &str) -> PyResult<Self> {
        let wrong = || {
            let class = signals.get_type().name().map_or_else(|_| "an object".to_owned(), |name| name.to_string());
            let wanted = "Signals, a data frame, or a mapping with time and channels";
            PyTypeError::new_err(format!("signals must be {wanted}, got {class}"))
        };
        Ok(Self(Recording::of_signals(name, told(signals)?.ok_or_else(wrong)?)))
    }

    /// Rows by what became of them: "read", "kept", "added in gaps", and each reason for which some were left out.
    #[getter]
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let account = self.0.account();
        let dict = PyDict::new(py);
        dict.set_item("read", account.read)?;
        for (reason, tally) in &account.left_out {
            dict.set_item(reason.words(), tally.count)?;
        }
        dict.set_item("added in gaps", account.filled_rows)?;
        dict.set_item("kept", account.rows)?;
        Ok(dict)
    }

    /// The same with the channels of a second device, which has a clock of its own.
    ///
    /// Parameters
    /// ----------
    /// other : Recording
    ///     The second device's.
    /// clock : float, str or (str, str), optional
    ///     What to add to its times [s]; or a channel of each that saw the same motion, as in ``("F_o", "F_x")``. Without it the offset is
    ///     found by a channel that both have.
    ///
    /// Returns
    /// -------
    /// Recording
    ///     On the first device's times; rows where the second has no values are left out.
    ///
    /// Raises
    /// ------
    /// LogError
    ///     Where the offset cannot be found, or no times are in common.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> first = coilsense.Recording({"time": [0.0, 0.1, 0.2], "F_i": [1.0, 2.0, 4.0]})
    /// >>> second = coilsense.Recording({"time": [0.0, 0.1, 0.2], "F_o": [1.0, 2.0, 4.0]})
    /// >>> list(first.joined(second, "0 s").signals)
    /// ['F_i', 'F_o']
    #[pyo3(signature = (other, clock=None))]
    fn joined(&self, py: Python<'_>, other: &Self, clock: Option<ClockArgument>) -> PyResult<Self> {
        let clock = clock.map_or(Ok(Clock::Found(None)), ClockArgument::clock)?;
        let (mine, theirs) = (self.0.clone(), other.0.clone());
        interruptible(py, move || mine.joined(&theirs, clock))?.python().map(Self)
    }

    /// File, account and signals: nothing but numbers, texts, lists and dicts.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("file", self.file())?;
        dict.set_item("account", self.account())?;
        dict.set_item("signals", Py::new(py, self.signals(py))?.call_method0(py, "to_dict")?)?;
        Ok(dict)
    }

    /// The channels as a data frame of pandas over an index of time; ``pip install coilsense[pandas]``.
    ///
    /// Returns
    /// -------
    /// pandas.DataFrame
    ///     One column per channel; ``attrs["units"]`` holds their units.
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Py::new(py, self.signals(py))?.into_bound(py).call_method0("to_pandas")
    }

    /// Draws channels over time with matplotlib; ``pip install coilsense[plot]``.
    ///
    /// Parameters
    /// ----------
    /// channels : list of str, optional
    ///     Which, all of one unit; without it, the forces.
    /// ax : matplotlib.axes.Axes, optional
    ///     Where; without it, in a new figure.
    ///
    /// Returns
    /// -------
    /// matplotlib.axes.Axes
    #[pyo3(signature = (channels=None, ax=None))]
    fn plot<'py>(
        &self,
        py: Python<'py>,
        channels: Option<Names>,
        ax: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let channels = channels.map(|names| names.listed("channels")).transpose()?;
        Py::new(py, self.signals(py))?.into_bound(py).call_method1("plot", (channels, ax))
    }

    fn __len__(&self) -> usize {
        self.0.signals().time().len()
    }

    fn __str__(&self) -> String {
        self.account().join("\n")
    }

    fn __repr__(&self) -> String {
        let names: Vec<&str> = self.0.signals().channels().map(|(channel, _)| channel.name()).collect();
        format!("<Recording {}: {}, {} rows>", self.file(), names.join(", "), self.__len__())
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "recording_html", (slf,))
    }
}

/// A log of any layout as a recording: text (CSV and the like), Parquet, MATLAB, HDF5, MDF, NI TDMS, MCAP.
///
/// Nothing is cleaned unless an argument says so, and whatever is cleaned or left out is counted in the recording's account. Quantities are
/// numbers in SI, or texts with a unit such as ``"2.5 kHz"``.
///
/// Parameters
/// ----------
/// path : str or os.PathLike
///     The file.
/// columns : dict of str to str or int, optional
///     Which column is which channel ("time", "u1", "u2", "F_i", "F_o", "F_x", "F_L", "L"): its title, with its unit as in
///     ``{"F_o": "LC [N]"}``, or its number from 1. Columns that carry a channel's name need none.
/// units : dict of str to str, optional
///     Units by channel, where titles carry none, as in ``{"F_o": "mN"}``.
/// mapping : str or os.PathLike, optional
///     The same as a TOML file, which can say more: means of several columns, comment signs; see book/src/guide/logs.md.
/// preset : {"lab-data"}, optional
///     A known layout.
/// sample_rate : float or str, optional
///     How often a log without a time column was sampled [Hz]; a column of time is then left alone.
/// gain : dict of str to str, optional
///     What a sensor's own signal means, as in ``{"F_o": "12.5 N/V"}``, or ``"12.5 N"`` for one of the column's numbers.
/// offset : dict of str to str, optional
///     What is added to a channel in the end, as in ``{"F_o": "0.2 N"}``.
/// negate : list of str, optional
///     Channels whose sign is turned.
/// constant : dict of str to str, optional
///     Channels that are the same in every row, as in ``{"u2": "104 mm"}`` of an end that is held.
/// delimiter : {",", ";", "|", "tab", "space"}, optional
///     What separates the columns of a text; without it, it is found out.
/// decimal : {".", ","}, optional
///     The decimal sign; without it, it is found out.
/// drop_incomplete : bool
///     Leave out rows that lack a value or cannot be read.
/// sort : bool
///     Put rows into the order of their times.
/// merge_repeated : bool
///     Take the mean of rows that have the same time.
/// unwrap : bool
///     Count on where midnight passes or a counter rolls over.
/// fill_gaps : float or str, optional
///     Fill gaps and missing values up to this length [s] along straight lines.
/// resample : float or str, optional
///     Bring all channels to this rate [Hz] along straight lines.
/// repair_up_to : float or str, optional
///     Share of the rows that each of these may leave out, move, merge or fill, such as ``"5 %"``; without it 1 %. Ten rows are never too many.
/// from_, to : float or str, optional
///     Leave out what is before or after [s].
///
/// Returns
/// -------
/// Recording
///
/// Raises
/// ------
/// LogError
///     One line with file, line and column for what cannot be read, is wrong, and may not be cleaned.
///
/// Examples
/// --------
/// >>> import coilsense, pathlib, tempfile
/// >>> with tempfile.TemporaryDirectory() as folder:
/// ...     path = pathlib.Path(folder) / "run.csv"
/// ...     _ = path.write_text("Zeit [ms];LC [N]\n0;1,5\n4;1,75\n8;1,5\n")
/// ...     recording = coilsense.open_log(path, {"time": "Zeit [ms]", "F_o": "LC [N]"})
/// >>> recording.sample_rate, recording.signals["F_o"]
/// (250.0, array([1.5 , 1.75, 1.5 ]))
#[pyfunction]
#[pyo3(signature = (path, columns=None, units=None, *, mapping=None, preset=None, sample_rate=None, gain=None, offset=None,
                    negate=None, constant=None, delimiter=None, decimal=None, drop_incomplete=false, sort=false,
                    merge_repeated=false, unwrap=false, fill_gaps=None, resample=None, repair_up_to=None, from_=None, to=None))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
pub fn open_log(
    py: Python<'_>,
    path: PathBuf,
    columns: Option<Bound<'_, PyDict>>,
    units: Option<Bound<'_, PyDict>>,
    mapping: Option<PathBuf>,
    preset: Option<String>,
    sample_rate: Option<Quantity>,
    gain: Option<Bound<'_, PyDict>>,
    offset: Option<Bound<'_, PyDict>>,
    negate: Option<Vec<String>>,
    constant: Option<Bound<'_, PyDict>>,
    delimiter: Option<String>,
    decimal: Option<String>,
    drop_incomplete: bool,
    sort: bool,
    merge_repeated: bool,
    unwrap: bool,
    fill_gaps: Option<Quantity>,
    resample: Option<Quantity>,
    repair_up_to: Option<Quantity>,
    from_: Option<Quantity>,
    to: Option<Quantity>,
) -> PyResult<PyRecording> {
    if path.as_os_str() == "-" {
        return Err(LogError::new_err("path must name a file, got \"-\": standard input is read by the command only"));
    }
    let told =
        LogOptions { columns, units, gain, offset, negate, constant, mapping, preset, delimiter, decimal, sample_rate };
    let mapping = told.mapping()?;
    let said = cleaning(drop_incomplete, sort, merge_repeated, unwrap, fill_gaps, resample, repair_up_to);
    let cleaning = Cleaning::of(&given(said.into_iter().chain([(&FROM, from_.into()), (&TO, to.into())]))?);
    interruptible(py, move || Recording::read(&path, &mapping, &cleaning))?.python().map(PyRecording)
}

/// A recording from Python: one, signals in memory, or the path of a log whose columns carry their channels' names.
pub fn recording(py: Python<'_>, object: &Bound<'_, PyAny>) -> PyResult<Recording> {
    if let Ok(recording) = object.cast::<PyRecording>() {
        return Ok(recording.get().0.clone());
    }
    if let Some(signals) = told(object)? {
        return Ok(Recording::of_signals("signals", signals));
    }
    let wrong = || {
        let class = object.get_type().name().map_or_else(|_| "an object".to_owned(), |name| name.to_string());
        PyTypeError::new_err(format!(
            "record must be a Recording, Signals, a data frame, a mapping with time and channels, or the path of a log, got {class}"
        ))
    };
    let path: PathBuf = object.extract().map_err(|_| wrong())?;
    interruptible(py, move || Recording::read(&path, &Default::default(), &Default::default()))?.python()
}
