//! Coefficients of the polynomials in `reduced`, made by `reference/elliptic_d_fit.py` and `reference/inductance_fits.py` and compared
//! with their files by a test.
//!
//! Next door: what is done with them (`reduced`).

/// P of D = P − Q ln c: relative minimax fit over c = 1e-12…1, error 4.3e-17; made by `reference/elliptic_d_fit.py`, compared with its file by a test.
pub(super) const D_REGULAR: [f64; 11] = [
    0.38629436111989063,
    0.03972077087018226,
    0.01380077041176886,
    0.006916723345762544,
    0.004626644351127254,
    0.011039610125396782,
    0.053322646772748845,
    0.12457888108888666,
    0.1111611605990793,
    0.0320280779278331,
    0.0019085167847720944,
];

/// Q: as [`D_REGULAR`].
pub(super) const D_LOGARITHM: [f64; 11] = [
    0.5,
    0.3749999999967554,
    0.3515624926361114,
    0.3417948583476364,
    0.33631944147020515,
    0.32996009025548206,
    0.30215071544812566,
    0.21163027257842013,
    0.08330766267041059,
    0.01278589154455907,
    0.0004051983383970111,
];

/// P of B = P − c Q ln c: relative minimax fit over c = 1e-12…1, error 2.8e-17, by `reference/inductance_fits.py`.
pub(super) const B_REGULAR: [f64; 11] = [
    1.0,
    0.05685281943985694,
    0.017084418424182016,
    0.008029213868313364,
    0.004519104863771056,
    6.372544364447228e-05,
    -0.02436209725661591,
    -0.09057051861544352,
    -0.12247245509983927,
    -0.05710255010086895,
    -0.0066434975695519195,
];
/// Q of B.
pub(super) const B_LOGARITHM: [f64; 11] = [
    -0.25,
    -0.2812499995420062,
    -0.2929684850908265,
    -0.2990430894983846,
    -0.3018292434932218,
    -0.2927927668941133,
    -0.23776212554374945,
    -0.12281037285517929,
    -0.02847792365316798,
    -0.001702847055594684,
    1.2187367547773113e-05,
];

/// R of ln((1 + z)/(1 − z)) = 2z + z³ R(z²): absolute error of the logarithm 2.5e-19 for |z| ≤ 0.2021, by `reference/inductance_fits.py`.
pub(super) const INVERSE_TANGENT: [f64; 8] = [
    0.6666666666666666,
    0.40000000000009056,
    0.2857142856677866,
    0.22222223130372643,
    0.18181731249994482,
    0.1538912011623676,
    0.13204792516304956,
    0.13646429045562844,
];

#[cfg(test)]
mod tests {
    use super::{B_LOGARITHM, B_REGULAR, D_LOGARITHM, D_REGULAR, INVERSE_TANGENT};

    /// One column of a generator's file, without its empty entries.
    fn column(file: &str, index: usize) -> Vec<f64> {
        file.lines()
            .filter(|line| line.starts_with(|first: char| first.is_ascii_digit()))
            .filter_map(|line| line.split(',').nth(index))
            .filter(|text| !text.is_empty())
            .map(|text| text.parse().unwrap())
            .collect()
    }

    #[test]
    fn the_coefficients_are_those_of_the_generators() {
        let d = include_str!("../../tests/golden/elliptic_d_fit.csv");
        assert_eq!(column(d, 1), D_REGULAR);
        assert_eq!(column(d, 2), D_LOGARITHM);
        let fits = include_str!("../../tests/golden/inductance_fits.csv");
        assert_eq!(column(fits, 1), B_REGULAR);
        assert_eq!(column(fits, 2), B_LOGARITHM);
        assert_eq!(column(fits, 3), INVERSE_TANGENT);
    }
}
