//! How far each of the paper's forces is off in one condition under one damping: only the judged window is computed.
//!
//! Next door: what is made of it (`design`), the same with sensors, spectra and all signals (`crate::analysis`).

use coilsense::calibrate::Theory;
use coilsense::contact::{Contact, Touching};
use coilsense::inductance::MaxwellSum;
use coilsense::signals::sampled_window;
use coilsense::{Channel, Clash, Deviation, Error, Motion};

use super::column::{BY_INDUCTANCE, Needs};
use crate::spec::{Core, Side};
use crate::study::{self, Coil, MEET, Meets, Method, Setup, Simulation};

/// L is taken to second order where that is within this share of it.
const TOLERANCE: f64 = 1e-6;

/// F_x among [`Channel::FORCES`].
const BY_DEFLECTION: usize = 2;

/// Of the true force from itself.
const NONE: Deviation = Deviation { rmsd: 0.0, maximum: 0.0, maximum_absolute: 0.0, mean: 0.0, standard_error: 0.0 };

/// One condition under one damping.
#[derive(Debug, Clone, Default)]
pub(super) struct Judged {
    /// Of each of [`Channel::FORCES`] that is asked for \[N\].
    pub deviations: [Option<Deviation>; 4],
    /// How many samples of L took the second-order form, and how many the exact sum.
    pub methods: [usize; 2],
    /// The largest stated bound of L, as a share of it.
    pub bound: f64,
    /// How near windings of each spring come, where the positions had to be looked at.
    pub clashes: Vec<Option<Clash>>,
}

/// Times of judged windows, which conditions mostly share.
#[derive(Debug, Default)]
pub(super) struct Windows {
    known: Vec<([f64; 3], Vec<f64>)>,
}

impl Windows {
    fn of(&mut self, rate: f64, (from, to): (f64, f64)) -> Result<&[f64], Error> {
        let place = match self.known.iter().position(|(window, _)| *window == [rate, from, to]) {
            Some(place) => place,
            None => {
                self.known.push(([rate, from, to], sampled_window(rate, from, to)?));
                self.known.len() - 1
            }
        };
        Ok(&self.known[place].1)
    }
}

/// Judges a condition under a damping, of several springs what all of them do.
pub(super) fn judge(
    springs: &[(Side, Core)],
    coil: Option<&(MaxwellSum, Theory)>,
    (condition, damping): (usize, usize),
    needs: &Needs,
    windows: &mut Windows,
) -> Result<Judged, Error> {
    let core = &springs[0].1;
    let asked = &core.conditions[condition];
    if needs.forces == [false; 4] {
        let each = springs.iter().map(|(_, core)| {
            let (way, asked) = (&core.mount.cases[damping], &core.conditions[condition]);
            let motion = Motion::mounted(&core.spring.spring, &way.mount, &asked.excitation)?;
            clash(core, &motion, way.contact.as_ref().map(|way| &way.contact), condition, needs)
        });
        return Ok(Judged { clashes: each.collect::<Result<_, _>>()?, ..Judged::default() });
    }
    let times = windows.of(asked.sample_rate, asked.window)?;
    let coil = match coil.filter(|_| needs.forces[BY_INDUCTANCE]) {
        // Of a single winding, whose inductance does not tell its length, there is no F_L.
        Some((sum, theory)) => theory.calibration(sum, asked.excitation.mean_length()).ok().map(|calibration| Coil {
            sum,
            // Said in the sweep's notes.
            steel: None,
            calibration,
            method: Method::Within(TOLERANCE),
        }),
        None => None,
    };
    let (mut runs, mut clashes) = (Vec::with_capacity(springs.len()), Vec::with_capacity(springs.len()));
    for (number, (_, core)) in springs.iter().enumerate() {
        let way = &core.mount.cases[damping];
        let contact = way.contact.as_ref().map(|way| &way.contact);
        let setup = Setup {
            spring: &core.spring.spring,
            mount: &way.mount,
            excitation: &core.conditions[condition].excitation,
            coil: coil.filter(|_| number == 0),
            positions: false,
            helix: None,
            contact: contact.map(|contact| Meets { contact, apart: None }),
        };
        let run = study::simulate(&setup, times)?;
        clashes.push(clash(core, &run.motion, contact, condition, needs)?);
        runs.push(run);
    }
    let all = match runs.as_slice() {
        [_] => None,
        _ => {
            let each = springs.iter().zip(&runs).map(|((side, _), run)| (*side, &run.signals));
            Some(study::together(&each.collect::<Vec<_>>())?)
        }
    };
    let Simulation { signals, bounded, .. } = runs.swap_remove(0);
    let signals = all.unwrap_or(signals);
    let mut judged = Judged { clashes, ..Judged::default() };
    let truth = Channel::FORCES.iter().position(|force| *force == core.goal.force).unwrap_or(BY_DEFLECTION);
    let known = |index: &usize| needs.forces[*index] && signals.channel(Channel::FORCES[*index]).is_ok();
    for index in (0..Channel::FORCES.len()).filter(known) {
        let series = |index: usize| signals.channel(Channel::FORCES[index]);
        judged.deviations[index] = Some(match index == truth {
            true => NONE,
            false => Deviation::between(series(index)?, series(truth)?)?,
        });
    }
    if let Some(inductance) = bounded {
        judged.methods = [inductance.second_order, inductance.exact];
        judged.bound = inductance.samples.iter().map(|sample| sample.bound / sample.inductance).fold(0.0, f64::max);
    }
    Ok(judged)
}

/// Whether windings touch from t = 0 to the end of the judged window. Where contact is part of the motion, how near they come, if that is asked.
fn clash(
    core: &Core,
    motion: &Motion,
    meets: Option<&Contact>,
    condition: usize,
    needs: &Needs,
) -> Result<Option<Clash>, Error> {
    let asked = &core.conditions[condition];
    let contact = core.spring.contact_pitch();
    if let Some(meets) = meets {
        if !needs.pitch {
            return Ok(None);
        }
        MEET?;
        let times = sampled_window(asked.sample_rate, 0.0, asked.window.1)?;
        let windings =
            Touching::once(motion, meets, &times, true)?.windings.ok_or(Error::MissingSignal("of windings"))?;
        return Clash::met(motion.spring(), &times, &windings, contact, None).map(Some);
    }
    if !needs.pitch && Clash::excluded(motion, asked.window.1, contact) {
        return Ok(None);
    }
    let times = sampled_window(asked.sample_rate, 0.0, asked.window.1)?;
    Clash::seen(motion, &times, &motion.windings(&times)?, contact).map(Some)
}
