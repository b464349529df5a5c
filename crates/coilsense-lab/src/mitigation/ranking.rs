//! What comes of a study: every candidate judged, and the best of them.
//!
//! Next door: the study (`study`), the answer as text and JSON (`report`).

use super::candidate::{Candidate, LeftOut, Origin, Truth};
use super::judge::Judgement;
use super::shaping::Shaping;
use super::shown::Shown;
use super::study::Study;

/// Every candidate judged, best first; filters of F_i, then estimators of F_o.
pub struct Ranking {
    /// What was asked.
    pub study: Study,
    /// How each did.
    pub judged: Vec<(Candidate, Judgement)>,
    /// Which could not be.
    pub left_out: Vec<LeftOut>,
    /// How many runs over the box there were.
    pub runs: usize,
    /// One run over time.
    pub shown: Option<Shown>,
    /// What shaping the command would do, where a condition moves u1 by one.
    pub shaping: Option<Shaping>,
}

impl Ranking {
    /// The best of those that are to give `truth` and are not too late, by the worst case; where all are too late, the least late.
    pub fn best(&self, truth: Truth) -> Option<&(Candidate, Judgement)> {
        self.in_time(truth, |_| true).next().or_else(|| {
            let those = self.judged.iter().filter(|(candidate, _)| candidate.truth == truth);
            those.min_by(|a, b| a.1.lag.total_cmp(&b.1.lag))
        })
    }

    /// Where in `judged` that one stands.
    pub fn place_of_best(&self, truth: Truth) -> Option<usize> {
        let best = self.best(truth)?;
        self.judged.iter().position(|one| std::ptr::eq(one, best))
    }

    /// The best of what one tries first that is not too late.
    pub fn best_textbook(&self, truth: Truth) -> Option<&(Candidate, Judgement)> {
        self.in_time(truth, |candidate| candidate.origin == Origin::Textbook).next()
    }

    /// Those that give `truth`, are `wanted` and not too late, best first.
    fn in_time(
        &self,
        truth: Truth,
        wanted: impl Fn(&Candidate) -> bool,
    ) -> impl Iterator<Item = &(Candidate, Judgement)> {
        let most = self.study.most_lag;
        self.judged.iter().filter(move |(candidate, judgement)| {
            candidate.truth == truth && wanted(candidate) && judgement.lag <= most
        })
    }
}
