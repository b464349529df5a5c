//! Which vector instructions the kernels use: chosen once, when the program first asks, by what the processor has.
//!
//! Next door: the kernels themselves (`motion`, `inductance`).

use std::sync::OnceLock;

use crate::error::Error;

/// A set of vector instructions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SimdPath {
    /// None: one number at a time (or what every processor of its kind has).
    Scalar,
    /// AVX2 with FMA: four numbers at a time.
    Avx2,
    /// AVX-512: eight numbers at a time.
    Avx512,
}

/// Environment variable that forces a path: `scalar`, `avx2` or `avx512`.
pub const VARIABLE: &str = "COILSENSE_SIMD";

impl SimdPath {
    /// All paths, plainest first.
    pub const ALL: [Self; 3] = [Self::Scalar, Self::Avx2, Self::Avx512];

    /// Its name in [`VARIABLE`].
    pub fn name(self) -> &'static str {
        match self {
            Self::Scalar => "scalar",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }

    /// Whether this processor has it.
    pub fn is_available(self) -> bool {
        match self {
            Self::Scalar => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => pulp::x86::V3::try_new().is_some(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => pulp::x86::V4::try_new().is_some(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The path of this process: what [`VARIABLE`] says, else the widest that the processor has. Results are equal byte for byte
    /// on one path, and to 1e-12 of the peak across paths.
    ///
    /// # Errors
    /// [`Error::Simd`] where the variable names an unknown path or one that this processor lacks.
    pub fn selected() -> Result<Self, Error> {
        static SELECTED: OnceLock<Result<SimdPath, Error>> = OnceLock::new();
        SELECTED.get_or_init(|| Self::named(std::env::var(VARIABLE).ok().as_deref())).clone()
    }

    fn named(wanted: Option<&str>) -> Result<Self, Error> {
        let available = Self::ALL.into_iter().filter(|path| path.is_available());
        let Some(wanted) = wanted.filter(|name| !name.is_empty()) else {
            return Ok(available.max().unwrap_or(Self::Scalar));
        };
        let allowed: Vec<&str> = available.clone().map(Self::name).collect();
        let mut named = available.filter(|path| path.name() == wanted);
        named.next().ok_or_else(|| Error::Simd { wanted: wanted.to_owned(), allowed: allowed.join(", ") })
    }
}

/// Runs a kernel with the instructions of [`SimdPath::selected`]; a refused choice counts as none.
pub(crate) fn dispatch<K: pulp::WithSimd>(kernel: K) -> K::Output {
    static PATH: OnceLock<SimdPath> = OnceLock::new();
    run(*PATH.get_or_init(|| SimdPath::selected().unwrap_or(SimdPath::Scalar)), kernel)
}

#[cfg(target_arch = "x86_64")]
fn run<K: pulp::WithSimd>(path: SimdPath, kernel: K) -> K::Output {
    use pulp::Simd;
    match path {
        SimdPath::Avx512 => match pulp::x86::V4::try_new() {
            Some(simd) => Simd::vectorize(simd, kernel),
            None => Simd::vectorize(pulp::Scalar, kernel),
        },
        SimdPath::Avx2 => match pulp::x86::V3::try_new() {
            Some(simd) => Simd::vectorize(simd, kernel),
            None => Simd::vectorize(pulp::Scalar, kernel),
        },
        SimdPath::Scalar => Simd::vectorize(pulp::Scalar, kernel),
    }
}

#[cfg(not(target_arch = "x86_64"))]
fn run<K: pulp::WithSimd>(_: SimdPath, kernel: K) -> K::Output {
    use pulp::Simd;
    pulp::Scalar.vectorize(kernel)
}

#[cfg(test)]
mod tests {
    use super::SimdPath;

    #[test]
    fn the_widest_path_is_taken_unless_another_is_named() {
        let widest = SimdPath::ALL.into_iter().filter(|path| path.is_available()).max();
        assert_eq!(SimdPath::named(None).ok(), widest);
        assert_eq!(SimdPath::named(Some("")).ok(), widest);
        assert_eq!(SimdPath::named(Some("scalar")), Ok(SimdPath::Scalar));
    }

    #[test]
    fn an_unknown_path_is_refused_by_name() {
        let error = SimdPath::named(Some("mmx")).unwrap_err().to_string();
        assert!(error.starts_with("COILSENSE_SIMD must be one of scalar"), "{error}");
        assert!(error.ends_with("got mmx"), "{error}");
    }
}
