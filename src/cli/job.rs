//! A case on its way from its file to its results.

use super::progress::{Kept, Watch};
use rayon::prelude::*;
use stampflow::assess::{self, Finding};
use stampflow::case::{self, Case};
use stampflow::compare::{CompareError, Comparison, Computed, compare};
use stampflow::output::{
    StageLine, Subject, WriteError, film, load_travel, profile, remove_stale, residual_stress, springback,
    stage_folder, stages_report, vtk, write_all, write_comparison, write_stages,
};
use stampflow::solution::StageSolution;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A case whose input was found to be in order.
pub struct Job {
    pub case: Case,
    pub overrides: Vec<String>,
}

/// What is written of the frames of a [`Reels`](super::reel::Reels).
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    pub vtu: bool,
    pub film: bool,
}

impl Moving {
    /// Whether frames must be kept for it.
    pub fn needs_frames(self) -> bool {
        self.vtu || self.film
    }
}

/// A case with its runs, one for each stage that was run.
pub struct Solved {
    job: Job,
    /// What the results of each stage are called.
    names: Vec<String>,
    passes: Vec<StageSolution>,
    /// What is told with each of them.
    told: Vec<Vec<Finding>>,
    wall: Duration,
    pub comparisons: Vec<Comparison>,
    pub kept: Kept,
}

impl Job {
    /// Reads a case and the curves that it will be compared with, so that bad input is found before solving.
    pub fn load(path: &Path, overrides: &[String]) -> anyhow::Result<Self> {
        let case = case::load(path, overrides)?;
        compared(&case, &StageSolution::unsolved(case.model().clone()))?;
        Ok(Self { case, overrides: overrides.to_vec() })
    }

    /// Runs the case under a watch.
    fn solve(self, watch: Watch) -> anyhow::Result<Solved> {
        let case = &self.case;
        let (passes, wall, kept) = watch.solve(case);
        let name = |(i, stage): (usize, &str)| match case.later().is_empty() {
            true => case.name.clone(),
            false => format!("{}/{}", case.name, stage_folder(i, stage)),
        };
        let names = case.stage_names().enumerate().map(name).collect();
        let told = assess::told(&assess::before(case), &passes);
        let comparisons = compared(case, &passes[0])?;
        Ok(Solved { job: self, names, passes, told, wall, comparisons, kept })
    }
}

impl Solved {
    /// The name of the case.
    pub fn name(&self) -> &str {
        &self.job.case.name
    }

    /// Whether the case has stages beside its first.
    pub fn has_stages(&self) -> bool {
        !self.job.case.later().is_empty()
    }

    /// Whether every stage came to its end.
    pub fn is_complete(&self) -> bool {
        self.job.case.is_completed_by(&self.passes)
    }

    /// What outputs are made from, of every stage that was run.
    pub fn subjects(&self) -> impl Iterator<Item = Subject<'_>> {
        let case = &self.job.case;
        self.names.iter().zip(self.passes.iter().zip(&self.told)).map(|(name, (run, findings))| Subject {
            name,
            case_text: &case.text,
            overrides: &self.job.overrides,
            model: &run.model,
            run,
            findings,
            wall: self.wall,
        })
    }

    /// What outputs of the first stage are made from: comparisons are with it.
    fn first(&self) -> Subject<'_> {
        self.subjects().next().expect("a case has a first stage")
    }

    /// The stages by name, with what was run of them; none where there is one only.
    fn lines(&self) -> Vec<StageLine<'_>> {
        let case = &self.job.case;
        if case.later().is_empty() {
            return Vec::new();
        }
        case.stage_names()
            .enumerate()
            .map(|(i, name)| (name, self.passes.get(i).map(|pass| (&pass.model, pass))))
            .collect()
    }

    /// The printed line of every stage; nothing where there is one only.
    pub fn stages(&self) -> String {
        stages_report(self.job.case.model().geometry, &self.lines())
    }

    /// Writes tables, plots and comparisons, and what is asked for of the moving section; those of several stages into a
    /// folder each.
    pub fn write(&self, dir: &Path, moving: Moving) -> anyhow::Result<Vec<PathBuf>> {
        let lines = self.lines();
        let mut written = Vec::new();
        let mut kept = self.write_comparisons(dir)?;
        if lines.is_empty() {
            kept.extend(self.write_stage(0, moving, dir)?);
        } else {
            kept.push(write_stages(self.job.case.model().geometry, &lines, dir)?);
        }
        for (i, (name, _)) in lines.iter().enumerate() {
            let dir = dir.join(stage_folder(i, name));
            let mut files = self.write_stage(i, moving, &dir)?;
            files.extend(self.write_release(i, &dir)?);
            remove_stale(&dir, &files)?;
            written.extend(files);
        }
        remove_stale(dir, &kept)?;
        written.extend(kept);
        Ok(written)
    }

    /// Writes what every stage has; nothing of one that was not run.
    fn write_stage(&self, stage: usize, moving: Moving, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
        let Some(subject) = self.subjects().nth(stage) else { return Ok(Vec::new()) };
        let mut files = write_all(&subject, dir)?;
        let frames = self.kept.reels.as_ref().map_or_else(Vec::new, |reels| reels.of_stage(stage, subject.run));
        if moving.vtu {
            files.extend(vtk::write(&subject, &frames, dir)?);
        }
        if moving.film {
            files.extend(film::write(&subject, &frames, dir)?);
        }
        Ok(files)
    }

    /// Writes what the sheet does as a stage takes its tools away; nothing for other stages.
    fn write_release(&self, stage: usize, dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
        let Some(pass) = self.passes.get(stage) else { return Ok(Vec::new()) };
        let Some([from, to]) = pass.released() else { return Ok(Vec::new()) };
        let mut files = springback::write(dir, from, to, &pass.model)?;
        files.extend(residual_stress::write(dir, to, &pass.model)?);
        Ok(files)
    }

    /// Writes comparisons only.
    pub fn write_comparisons(&self, dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
        let mut written = Vec::new();
        for (i, comparison) in self.comparisons.iter().enumerate() {
            written.extend(write_comparison(&self.first(), i + 1, comparison, dir)?);
        }
        Ok(written)
    }
}

/// Solves jobs side by side and hands each to `then` as it ends; what `then` returns comes back in the jobs' order.
pub fn solve_all<T: Send>(
    jobs: Vec<Job>,
    watch: impl Fn(&Case) -> Watch + Sync,
    then: impl Fn(Solved) -> anyhow::Result<T> + Sync,
) -> Vec<anyhow::Result<T>> {
    jobs.into_par_iter()
        .map(|job| {
            let watch = watch(&job.case);
            then(job.solve(watch)?)
        })
        .collect()
}

fn compared(case: &Case, run: &StageSolution) -> Result<Vec<Comparison>, CompareError> {
    let history = load_travel::table(case.model(), run);
    let profile = profile::last(case.model(), &run.frames);
    let computed = Computed { history: &history, profile: &profile, complete: run.stop.is_complete() };
    case.compare.iter().map(|spec| compare(spec, &computed)).collect()
}
