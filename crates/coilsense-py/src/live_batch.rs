//! `coilsense.LiveBatch`: many springs whose inputs come one sample at a time, stepped by one call.
//!
//! Next door: one of them (`live`).

use std::mem::discriminant;
use std::sync::atomic::{AtomicUsize, Ordering};

use coilsense::motion::Live;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::exceptions::{PyIndexError, PyKeyboardInterrupt};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::errors::{IntoPython, refused};
use crate::live::PyLive;
use crate::long_work::{Progress, watched};
use crate::series::{Series, Table, rows};
use crate::stream::Samples;

/// Forces at both ends.
type Forces<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>);

/// From so many steps of a mode on a call is worth threads, and Ctrl-C may come: a millisecond.
const MANY: usize = 500_000;

/// Most copies made at once.
const MOST: usize = 1_000_000;

/// Steps of a spring between two looks at whether to go on.
const STRETCH: usize = 1024;

/// Many `Live` springs, stepped by one call: the same bits as each by itself.
///
/// They may differ in all but the step, the kind of far end and the number of modes. What does not move is shared by copies of one spring.
///
/// Parameters
/// ----------
/// lives : sequence of Live
///     The springs, as they are now; they are copied. `Live.batch` makes it of copies of one.
///
/// Raises
/// ------
/// Error
///     For no spring, and for the first of another step, kind of far end or number of modes than the first.
///
/// Notes
/// -----
/// What does not fit changes nothing: errors name the spring, all of them then stay where they are, as they do on Ctrl-C. Other threads of Python run meanwhile.
///
/// Examples
/// --------
/// >>> import numpy
/// >>> from coilsense import Live, Spring
/// >>> batch = Live(Spring.of_paper("S_T"), 0.23, 1e-3).batch(3)
/// >>> t, F_i, F_o = batch.advance(numpy.zeros(3), [0.23, 0.2301, 0.2302])
/// >>> (F_o - 95.76).round(3)
/// array([0.   , 0.565, 1.129])
/// >>> F_i, F_o = batch.rollout(numpy.zeros((3, 100)), numpy.full((3, 100), 0.23))
/// >>> F_i.shape, batch.time.round(9)[0]
/// ((3, 100), np.float64(0.101))
#[pyclass(name = "LiveBatch", module = "coilsense")]
pub struct PyLiveBatch(Vec<Live>);

impl PyLiveBatch {
    /// A batch of springs that can be stepped together.
    pub fn of(lives: Vec<Live>) -> PyResult<Self> {
        let Some(first) = lives.first() else {
            return Err(refused("lives must hold at least 1 spring, got 0"));
        };
        for (place, live) in lives.iter().enumerate() {
            let (ours, wanted) = (live.step(), first.step());
            if ours.to_bits() != wanted.to_bits() {
                return Err(refused(format!(
                    "step of lives[{place}] must be that of lives[0], {wanted} s, got {ours} s"
                )));
            }
            let (ours, wanted) = (live.mount().far_end(), first.mount().far_end());
            if discriminant(&ours) != discriminant(&wanted) {
                let text =
                    format!("far end of lives[{place}] must be of the kind of lives[0], {wanted:?}, got {ours:?}");
                return Err(refused(text));
            }
            let modes = |live: &Live| live.state_count() / 2 - 2;
            if modes(live) != modes(first) {
                let (ours, wanted) = (modes(live), modes(first));
                return Err(refused(format!(
                    "modes of lives[{place}] must be as many as of lives[0], {wanted}, got {ours}"
                )));
            }
        }
        Ok(Self(lives))
    }

    /// How many numbers a state holds.
    fn state_count(&self) -> usize {
        self.0.first().map_or(0, Live::state_count)
    }

    /// Steps of a mode that so many steps of all are.
    fn work(&self, steps: usize) -> usize {
        self.0.len().saturating_mul(steps).saturating_mul(self.state_count() / 2)
    }

    /// Refuses a series that does not hold a value, or a row, for each spring.
    fn check_count(&self, name: &str, what: &str, found: usize) -> PyResult<()> {
        let wanted = self.0.len();
        if found == wanted {
            return Ok(());
        }
        Err(refused(format!("{name} must hold {wanted} {what}, one for each spring, got {found}")))
    }

    /// Inputs of each spring's next step.
    fn next_inputs(&self, u1: &Series<'_>, end2: &Series<'_>) -> PyResult<Vec<[f64; 2]>> {
        let (u1, end2) = (u1.values("u1")?, end2.values("end2")?);
        self.check_count("u1", "values", u1.len())?;
        self.check_count("end2", "values", end2.len())?;
        let ends = u1.iter().zip(end2.iter());
        let each = self.0.iter().zip(ends).enumerate();
        each.map(|(place, (live, (u1, end2)))| live.inputs_of([*u1, *end2]).map_err(|error| of_spring(place, &error)))
            .collect()
    }
}

#[pymethods]
impl PyLiveBatch {
    #[new]
    fn new(lives: Vec<PyRef<'_, PyLive>>) -> PyResult<Self> {
        Self::of(lives.iter().map(|live| live.0.clone()).collect())
    }

    /// t [s] of each, shape (springs,).
    #[getter]
    fn time<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.0.iter().map(Live::time).collect::<Vec<_>>().into_pyarray(py)
    }

    /// All that the next steps depend on, a row for each as `Live.state` has it, shape (springs, 2 modes + 5). A copy; rows of other springs made
    /// alike may be assigned.
    #[getter]
    fn state<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.0.iter().flat_map(Live::state).collect(), self.state_count())
    }

    #[setter]
    fn set_state(&mut self, state: Table<'_>) -> PyResult<()> {
        let wanted = self.state_count();
        let (state, columns) = state.to_vec("state")?;
        if columns != wanted {
            return Err(refused(format!("state must have {wanted} columns, twice the modes and 5, got {columns}")));
        }
        self.check_count("state", "rows", state.len() / wanted)?;
        let mut set = self.0.clone();
        for (place, (live, row)) in set.iter_mut().zip(state.chunks_exact(wanted)).enumerate() {
            live.set_state(row).map_err(|error| of_spring(place, &error))?;
        }
        self.0 = set;
        Ok(())
    }

    /// Goes on by one step.
    ///
    /// Parameters
    /// ----------
    /// u1, end2 : array_like of float, shape (springs,)
    ///     Of each spring, as `Live.advance` takes them.
    ///
    /// Returns
    /// -------
    /// t, F_i, F_o : numpy.ndarray, shape (springs,)
    ///     [s], [N], [N].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For an array that has no value for each spring; for the first spring as `Live.advance`.
    fn advance<'py>(&mut self, py: Python<'py>, u1: Series<'py>, end2: Series<'py>) -> PyResult<Samples<'py>> {
        let next = self.next_inputs(&u1, &end2)?;
        let lives = &mut self.0;
        let stepped = py.detach(|| {
            let each = lives.iter_mut().zip(next);
            each.map(|(live, inputs)| live.advance(inputs)).collect::<Result<Vec<_>, _>>()
        });
        let forces = stepped.python()?;
        let series = |part: fn(&coilsense::motion::ForceSample) -> f64| {
            forces.iter().map(part).collect::<Vec<_>>().into_pyarray(py)
        };
        Ok((series(|at| at.time), series(|at| at.input), series(|at| at.output)))
    }

    /// Goes on by many steps, each spring by its own inputs, spread over threads.
    ///
    /// Parameters
    /// ----------
    /// u1, end2 : array_like of float, shape (springs, samples)
    ///     Of each spring over the coming samples, as `Live.advance` takes them.
    ///
    /// Returns
    /// -------
    /// F_i, F_o : numpy.ndarray, shape (springs, samples)
    ///     At end 1 and at end 2 [N].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For arrays that have no row for each spring or unlike shapes; for the first sample that `Live.advance` refuses.
    ///
    /// Notes
    /// -----
    /// What is refused, and Ctrl-C, leave all springs where they were.
    fn rollout<'py>(&mut self, py: Python<'py>, u1: Table<'py>, end2: Table<'py>) -> PyResult<Forces<'py>> {
        let (u1, samples) = u1.to_vec("u1")?;
        let (end2, others) = end2.to_vec("end2")?;
        if samples == 0 {
            return Err(refused("u1 must have at least 1 column, one for each sample, got 0"));
        }
        if others != samples {
            return Err(refused(format!("end2 must have as many columns as u1, {samples}, got {others}")));
        }
        self.check_count("u1", "rows", u1.len() / samples)?;
        self.check_count("end2", "rows", end2.len() / samples)?;
        // Steps are those of copies, which replace the springs where all went well.
        let mut lives = self.0.clone();
        let inputs = Inputs { u1: &u1, end2: &end2, samples };
        let found = if self.work(samples) < MANY {
            py.detach(|| inputs.drive(&mut lives))
        } else {
            watched(py, None, |go_on| inputs.drive_many(&mut lives, go_on))?
        };
        // Whoever stopped it has raised.
        let [input, output] = found?.ok_or_else(|| PyKeyboardInterrupt::new_err(()))?;
        self.0 = lives;
        Ok((rows(py, input, samples)?, rows(py, output, samples)?))
    }

    /// Back to t = 0, at rest.
    ///
    /// Parameters
    /// ----------
    /// u1, end2 : array_like of float, shape (springs,), optional
    ///     Where each rests, as `advance` takes them; where it was made without them.
    ///
    /// Returns
    /// -------
    /// None
    ///
    /// Raises
    /// ------
    /// Error
    ///     As `advance`.
    #[pyo3(signature = (u1=None, end2=None))]
    fn reset(&mut self, u1: Option<Series<'_>>, end2: Option<Series<'_>>) -> PyResult<()> {
        let mut ends: Vec<[f64; 2]> = self.0.iter().map(Live::mean_ends).collect();
        for (end, (name, given)) in [("u1", u1), ("end2", end2)].into_iter().enumerate() {
            let Some(given) = given else { continue };
            let values = given.values(name)?;
            self.check_count(name, "values", values.len())?;
            ends.iter_mut().zip(values.iter()).for_each(|(ends, value)| ends[end] = *value);
        }
        let mut reset = self.0.clone();
        for (place, (live, ends)) in reset.iter_mut().zip(ends).enumerate() {
            live.reset(ends).map_err(|error| of_spring(place, &error))?;
        }
        self.0 = reset;
        Ok(())
    }

    /// Another batch that goes on from here by itself, with the same bits.
    ///
    /// Returns
    /// -------
    /// LiveBatch
    fn copy(&self) -> Self {
        Self(self.0.clone())
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.copy()
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    /// A copy of one of them.
    fn __getitem__(&self, index: isize) -> PyResult<PyLive> {
        let count = self.0.len();
        let place = if index < 0 { index.checked_add_unsigned(count) } else { Some(index) };
        let found = place.and_then(|place| self.0.get(usize::try_from(place).ok()?));
        found.cloned().map(PyLive).ok_or_else(|| PyIndexError::new_err(format!("spring {index} of a batch of {count}")))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, (Vec<PyLive>,)) {
        let lives = slf.borrow().0.iter().cloned().map(PyLive).collect();
        (slf.get_type().into_any(), (lives,))
    }

    fn __repr__(&self) -> String {
        format!("<LiveBatch of {} springs>", self.0.len())
    }
}

#[pymethods]
impl PyLive {
    /// So many copies that are stepped together.
    ///
    /// Parameters
    /// ----------
    /// count : int
    ///     How many, from 1 to a million: one of 52 modes takes 1.7 kB.
    ///
    /// Returns
    /// -------
    /// LiveBatch
    fn batch(&self, count: usize) -> PyResult<PyLiveBatch> {
        if !(1..=MOST).contains(&count) {
            return Err(refused(format!("count must be from 1 to {MOST}, got {count}")));
        }
        PyLiveBatch::of(vec![self.0.clone(); count])
    }
}

/// Inputs of all springs over the coming samples.
struct Inputs<'a> {
    /// Shape `springs × samples`, as `end2`.
    u1: &'a [f64],
    end2: &'a [f64],
    samples: usize,
}

/// F_i and F_o, shape `springs × samples`; `None` where it was not to go on.
type Driven = PyResult<Option<[Vec<f64>; 2]>>;

impl Inputs<'_> {
    /// One after the other on this thread.
    fn drive(&self, lives: &mut [Live]) -> Driven {
        let [mut input, mut output] = self.still();
        let forces = input.chunks_exact_mut(self.samples).zip(output.chunks_exact_mut(self.samples));
        for (place, (live, (input, output))) in lives.iter_mut().zip(forces).enumerate() {
            self.one(place, live, [input, output], |_| true)?;
        }
        Ok(Some([input, output]))
    }

    /// Spread over the threads of the pool that this is called in.
    fn drive_many(&self, lives: &mut [Live], go_on: &Progress<'_>) -> Driven {
        let [mut input, mut output] = self.still();
        let (done, of) = (AtomicUsize::new(0), self.u1.len());
        let more = |steps: usize| go_on(done.fetch_add(steps, Ordering::Relaxed) + steps, of);
        let forces = input.par_chunks_exact_mut(self.samples).zip(output.par_chunks_exact_mut(self.samples));
        let each = lives.par_iter_mut().zip(forces).enumerate();
        let each = each.map(|(place, (live, (input, output)))| self.one(place, live, [input, output], more));
        // All of them first: which error is told does not depend on who was fastest.
        let whole = each.collect::<Vec<_>>().into_iter().collect::<PyResult<Vec<bool>>>()?;
        Ok(whole.into_iter().all(|whole| whole).then_some([input, output]))
    }

    /// Nothing found yet.
    fn still(&self) -> [Vec<f64>; 2] {
        [vec![0.0; self.u1.len()], vec![0.0; self.u1.len()]]
    }

    /// The forces of one spring; whether `more`, which is told of steps that were made, let it go to the end.
    fn one(
        &self,
        place: usize,
        live: &mut Live,
        [input, output]: [&mut [f64]; 2],
        more: impl Fn(usize) -> bool,
    ) -> PyResult<bool> {
        let row = place * self.samples..(place + 1) * self.samples;
        let (u1, end2) = (&self.u1[row.clone()], &self.end2[row]);
        for begin in (0..self.samples).step_by(STRETCH) {
            let end = self.samples.min(begin + STRETCH);
            for sample in begin..end {
                let felt = live.advance_to([u1[sample], end2[sample]]);
                let felt = felt.map_err(|error| refused(format!("spring {place}, sample {sample}: {error}")))?;
                (input[sample], output[sample]) = (felt.input, felt.output);
            }
            if !more(end - begin) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// An exception for one of the springs.
fn of_spring(place: usize, error: &coilsense::Error) -> PyErr {
    refused(format!("spring {place}: {error}"))
}
