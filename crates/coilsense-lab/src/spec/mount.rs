//! The table `[mount]`: what end 2 is tied to, and the dampings for which results are given.
//!
//! Next door: what they mean (`coilsense::{Mount, Damping}`), how the ends are held against rotations (`ends`).

use coilsense::geometry::EndType;
use coilsense::modes::ModalModel;
use coilsense::{Damping, FarEnd, Mount, Spring};

use super::contact::ContactCase;
use super::document::Document;
use super::ends::EndsSpec;
use super::section::Section;
use super::{SpecError, plain, stem};
use crate::helix::Held;
use crate::quantity::Dimension;

/// Damping ratios for which results are given where a spec says nothing: none is the paper's case, and no measured range is known.
pub const BAND: [f64; 4] = [0.0, 0.001, 0.005, 0.02];

/// What end 2 is tied to, under each damping for which results are wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct MountSpec {
    /// One mount for each damping.
    pub cases: Vec<DampingCase>,
    /// Whether the spec said nothing of damping, so that the cases are [`BAND`].
    pub is_band: bool,
    /// How the ends are held against tilting and turning.
    pub ends: EndsSpec,
}

/// A mount under one damping.
#[derive(Debug, Clone, PartialEq)]
pub struct DampingCase {
    /// `ζ = 0.005`, or what else damps.
    pub label: String,
    /// The same for file names: `zeta-0.005`.
    pub stem: String,
    /// ζ where it is the same in every mode.
    pub ratio: Option<f64>,
    /// The mount.
    pub mount: Mount,
    /// The way in which the ends are held, where a case is of one of several.
    pub held: Option<Held>,
    /// What windings do when they meet; `None` where they pass through one another.
    pub contact: Option<ContactCase>,
}

impl MountSpec {
    /// What end 2 is tied to.
    pub fn far_end(&self) -> FarEnd {
        self.cases.first().map_or(FarEnd::Position, |case| case.mount.far_end())
    }

    /// The same with a case for each way in which the ends may be held: what hangs on them is then told for both.
    pub(super) fn by_ways(self) -> Self {
        let (tightest, Some(loosest)) = self.ends.ways() else { return self };
        let of = |case: &DampingCase, way: Held| DampingCase {
            label: format!("{} ({})", case.label, way.words()),
            stem: format!("{}-{}", case.stem, stem(&way.words())),
            held: Some(way),
            ..case.clone()
        };
        let cases = self.cases.iter().flat_map(|case| [of(case, tightest), of(case, loosest)]).collect();
        Self { cases, ..self }
    }

    /// The same with a case for each way in which windings may meet.
    pub(super) fn by_contacts(self, contacts: &[ContactCase]) -> Self {
        if contacts.is_empty() {
            return self;
        }
        let of = |case: &DampingCase, contact: &ContactCase| DampingCase {
            label: format!("{}, {}", case.label, contact.label),
            stem: format!("{}-{}", case.stem, contact.stem()),
            contact: Some(contact.clone()),
            ..case.clone()
        };
        let cases = self.cases.iter().flat_map(|case| contacts.iter().map(|contact| of(case, contact))).collect();
        Self { cases, ..self }
    }

    /// As [`super::Spec::needs_no_contact`]; `file` is the spec's.
    pub(crate) fn needs_no_contact(&self, file: &str, what: &str) -> Result<(), SpecError> {
        if self.cases.iter().all(|case| case.contact.is_none()) {
            return Ok(());
        }
        let takes = "takes windings = \"off\"; windings that meet are for simulate, analyze and sweep";
        Err(SpecError(format!("{file}: [contact]: {what} {takes}")))
    }

    /// What an axial model takes of it, which the ways in which the ends are held do not concern: each damping once.
    pub fn without_ways(&self) -> Self {
        let (tightest, _) = self.ends.ways();
        let bare = |(text, end): (&String, String)| text.strip_suffix(&end).unwrap_or(text).to_owned();
        let of = |case: &DampingCase| DampingCase {
            label: bare((&case.label, format!(" ({})", tightest.words()))),
            stem: bare((&case.stem, format!("-{}", stem(&tightest.words())))),
            held: None,
            ..case.clone()
        };
        let once = self.cases.iter().filter(|case| case.held.is_none_or(|way| way == tightest));
        Self { cases: once.map(of).collect(), ..self.clone() }
    }

    /// How the ends are held, before anything else of the mount is read.
    pub(super) fn ends(document: &Document<'_>, end_type: EndType) -> Result<EndsSpec, SpecError> {
        match document.optional_section("mount")? {
            Some(section) => EndsSpec::parse(&section, end_type),
            None => Ok(EndsSpec::assumed(end_type)),
        }
    }

    pub(super) fn parse(document: &Document<'_>, spring: &Spring, end_type: EndType) -> Result<Self, SpecError> {
        let Some(section) = document.optional_section("mount")? else {
            let cases = BAND.map(|ratio| DampingCase::modal(FarEnd::Position, ratio, Damping::Modal(ratio)));
            let cases = cases.into_iter().flatten().collect();
            return Ok(Self { cases, is_band: true, ends: EndsSpec::assumed(end_type) });
        };
        let far_end = far_end(&section)?;
        let ends = EndsSpec::parse(&section, end_type)?;
        let keys = ["damping_ratio", "mass_damping", "stiffness_damping"];
        let given: Vec<&str> = keys.into_iter().filter(|key| section.has(key)).collect();
        if let [first, second, ..] = given.as_slice() {
            return Err(section.refuse(second, format!("only one kind of damping can be given, and {first} is")));
        }
        if let Some(case) = proportional(&section, spring, far_end)? {
            return Ok(Self { cases: vec![case], is_band: false, ends });
        }
        let given = section.optional_numbers("damping_ratio")?;
        let is_band = given.is_none();
        let ratios = given.unwrap_or(BAND.to_vec());
        check_ratios(&section, &ratios)?;
        let cases = ratios.into_iter().map(|ratio| modal(&section, spring, far_end, ratio));
        Ok(Self { cases: cases.collect::<Result<_, _>>()?, is_band, ends })
    }
}

impl MountSpec {
    /// Damping that is unusual for a coil, in a sentence; `None` of less.
    pub fn doubt(&self) -> Option<String> {
        let most = self.cases.iter().filter_map(|case| case.ratio).fold(0.0, f64::max);
        let usual = BAND[BAND.len() - 1];
        (most > LIKELY_RATIO).then(|| {
            format!(
                "ζ = {most} is unusually high for a coil's own ringing; where none is given, up to {usual} is taken. Half a per cent is 0.005; a damper \
                 beside the spring is first_mode_damping_ratio."
            )
        })
    }
}

/// The highest damping ratio that is not doubted; chosen, two and a half times that of [`BAND`], since no range is known by measurement.
const LIKELY_RATIO: f64 = 0.05;
/// The highest damping ratio taken: a coil that hardly moves.
const HIGHEST_RATIO: f64 = 10.0;
/// Most dampings in a list: what a report can show, and what the seeds of sensor noise tell apart.
const MOST_RATIOS: usize = 64;

/// Each ratio is one that is taken, and gives results of its own name.
fn check_ratios(section: &Section<'_>, ratios: &[f64]) -> Result<(), SpecError> {
    for (index, ratio) in ratios.iter().enumerate() {
        section.check("damping_ratio", (0.0..=HIGHEST_RATIO).contains(ratio), *ratio, "from 0 to 10")?;
        if ratios[..index].contains(ratio) {
            return Err(section.refuse("damping_ratio", format!("{} is there twice; give each once", ratio + 0.0)));
        }
    }
    if ratios.len() > MOST_RATIOS {
        let text = format!("must be at most {MOST_RATIOS} ratios, got {}", ratios.len());
        return Err(section.refuse("damping_ratio", text));
    }
    Ok(())
}

/// Damping in proportion to mass or stiffness, where it is given.
fn proportional(section: &Section<'_>, spring: &Spring, far_end: FarEnd) -> Result<Option<DampingCase>, SpecError> {
    let lowest = ModalModel::chain(spring, far_end).frequencies().first().copied().unwrap_or(f64::INFINITY);
    let rounded = |value: f64| format!("{value:.4e}").parse().map_or_else(|_| plain(value), plain);
    let (key, most, unit, case) = if let Some(rate) = section.not_negative("mass_damping", Dimension::Rate)? {
        let label = format!("α = {} 1/s", plain(rate));
        let case =
            DampingCase::of(label, format!("alpha-{}", plain(rate)), far_end, Damping::MassProportional { rate });
        ("mass_damping", 2.0 * HIGHEST_RATIO * lowest, (rate, "1/s"), case)
    } else if let Some(time) = section.not_negative("stiffness_damping", Dimension::Time)? {
        let label = format!("β = {} µs", plain(1e6 * time));
        let case =
            DampingCase::of(label, format!("beta-{}", plain(time)), far_end, Damping::StiffnessProportional { time });
        ("stiffness_damping", 2.0 * HIGHEST_RATIO / lowest, (time, "s"), case)
    } else {
        return Ok(None);
    };
    if let Some(key) = section.first_of(&["first_mode_damping_ratio"]) {
        return Err(section.refuse(key, "goes with damping_ratio only"));
    }
    let allowed = format!("at most {} {}, where the first mode's ζ is 10", rounded(most), unit.1);
    section.check(key, unit.0 <= most, unit.0, &allowed)?;
    case.map(Some).map_err(|error| section.refuse(key, error))
}

/// Damping by ratios: the same in every mode, but for the swing of an end mass where that is given.
fn modal(section: &Section<'_>, spring: &Spring, far_end: FarEnd, ratio: f64) -> Result<DampingCase, SpecError> {
    let damping = match section.optional_number("first_mode_damping_ratio")? {
        None => Damping::Modal(ratio),
        Some(first) => {
            let holds = (0.0..=HIGHEST_RATIO).contains(&first);
            section.check("first_mode_damping_ratio", holds, first, "from 0 to 10")?;
            let mut ratios = vec![ratio; ModalModel::chain(spring, far_end).count()];
            ratios[0] = first;
            Damping::ModalEach(ratios)
        }
    };
    DampingCase::modal(far_end, ratio, damping).map_err(|error| section.refuse("damping_ratio", error))
}

impl DampingCase {
    fn modal(far_end: FarEnd, ratio: f64, damping: Damping) -> Result<Self, coilsense::Error> {
        // −0 is 0.
        let name = plain(ratio + 0.0);
        let case = Self::of(format!("ζ = {name}"), format!("zeta-{name}"), far_end, damping)?;
        Ok(Self { ratio: Some(ratio), ..case })
    }

    fn of(label: String, stem: String, far_end: FarEnd, damping: Damping) -> Result<Self, coilsense::Error> {
        Ok(Self { label, stem, ratio: None, mount: Mount::new(far_end, damping)?, held: None, contact: None })
    }
}

fn far_end(section: &Section<'_>) -> Result<FarEnd, SpecError> {
    let word = section.optional_word("end2", &["held", "force", "mass"])?.unwrap_or("held");
    section.only_of(word, &format!("an end 2 that is \"{word}\""))?;
    Ok(match word {
        "force" => FarEnd::Force,
        "mass" => {
            let mass = section.positive("end_mass", Dimension::Mass)?;
            // Here, so that the error stands at its key.
            Mount::new(FarEnd::Mass(mass), Damping::None).map_err(|error| section.refuse("end_mass", error))?;
            FarEnd::Mass(mass)
        }
        _ => FarEnd::Position,
    })
}
