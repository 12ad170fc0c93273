//! `stampflow sweep`, `search`, `scatter` and `merge`, and the options and output that all studies share.

use super::*;
use stampflow::study::{
    self, BaseCase, Evaluation, LimitSearch, Scatter, SearchRequest, Shard, Side, Study, StudyReport, Sweep, TableFile,
    begin, evaluate,
};
use std::ops::ControlFlow;

const MANY: u64 = 100_000;

options! {
    StudyOptions {
        out: Option<PathBuf> = "DIR" [long, alias = "output"] "Folder for the results [default: out/<file>-<verb>, of a search with its key or name]",
    } common: Common, threads: Threads, pictures: PictureOptions;
    TableOptions {
        file: PathBuf = "CASE.toml|STUDY.toml" [] "A case file; for sweep and scatter also a study file",
        resume: bool [long] "Keep the rows of the study that is there, and run what is missing",
        restart: bool [long, hide_short_help = true, conflicts_with = "resume"] "Replace the study that is there, complete or not",
    } study: StudyOptions;
    ShardOptions {
        shard: Option<Shard> = "K/N" [long, hide_short_help = true] "Run one share of so many, such as 7/64, into a table of its own",
        yes: bool [long, hide_short_help = true] "Begin more than 100 000 runs without asking",
    } table: TableOptions;
    /// Run a case with many settings, one row a run
    SweepArgs {
        vary: Vec<String> = "KEY=VALUES" [long]
            "A key and its values: KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT; as often as needed",
        one_at_a_time: bool [long] "Each key by itself at each of its values, instead of every combination",
        keep: Option<String> = "curves" [long, hide_short_help = true, value_parser = ["curves"]]
            "Also write load and thickness of each design, two CSV files in DIR/curves",
    } options: ShardOptions;
    /// Run a case with scattering inputs: how sure the verdict is
    ScatterArgs {
        vary: Vec<String> = "KEY=DISTRIBUTION" [long]
            "A key and its distribution, as often as needed [default: blank.thickness=tolerance, where it is known]",
        runs: Option<u64> = "N" [long] "Sample size; best a power of two [default: 1024]",
        seed: Option<u32> = "N" [long, hide_short_help = true] "Seed of the sample [default: 1]",
    } options: ShardOptions;
    /// Find the limit of a condition, or the value that meets a target
    SearchArgs {
        vary: Option<String> = "KEY=RANGE" [long] "A key and its range, KEY=FROM..TO UNIT, with `log` for even ratios",
        goal: Option<String> = "SEARCH" [long = "for"] "A search with a name",
        largest: bool [long, conflicts_with = "smallest"] "Find the largest value at which the condition holds",
        smallest: bool [long] "Find the smallest value",
        condition: Option<String> = "CONDITION" [long = "while", conflicts_with = "target"]
            "The condition, such as \"no red\" or \"thinning < 20 % and punch_force <= 60 kN\"",
        target: Option<String> = "QUANTITY=VALUE" [long] "A quantity and its wanted value, such as \"draw_in=8 mm\"",
        tolerance: Option<String> = "VALUE" [long]
            "Accuracy of the limit, in the unit of the key [default: 0.5 % of the range]",
    } options: TableOptions;
    /// Put the tables of a study's shards together
    MergeArgs {
        shards: Vec<PathBuf> = "SHARD.csv" [required = true] "Tables of all shards of one study",
        out: PathBuf = "FILE.csv" [long, alias = "output"] "The table to write",
        restart: bool [long] "Replace the table that is there",
    };
}

pub fn sweep(SweepArgs { vary, one_at_a_time, keep, options }: &SweepArgs) -> Result<Code> {
    let table = &options.table;
    let mut sweep = Sweep::load(&table.file, table.study.common.overrides.all(), vary, *one_at_a_time)?;
    options.run(&mut sweep, ["sweep", "study"], keep.is_some())
}

pub fn scatter(ScatterArgs { vary, runs, seed, options }: &ScatterArgs) -> Result<Code> {
    let table = &options.table;
    let mut scatter = Scatter::load(&table.file, table.study.common.overrides.all(), vary, *runs, *seed)?;
    options.run(&mut scatter, ["scatter"; 2], false)
}

pub fn search(args: SearchArgs) -> Result<Code> {
    let SearchArgs { vary, goal, largest, smallest, condition, target, tolerance, options } = args;
    let name = goal.iter().chain(&vary).find_map(|text| text.split('=').next()).unwrap_or_default();
    let folder = format!("search-{}", name.trim().replace('*', "all"));
    let side = if largest { Some(Side::Largest) } else { smallest.then_some(Side::Smallest) };
    let base = BaseCase::load(&options.file, options.study.common.overrides.all())?;
    let mut search = LimitSearch::new(base, &SearchRequest { vary, goal, side, condition, target, tolerance })?;
    options.run(&mut search, [&folder, "search"], Shard::WHOLE, false)
}

pub fn merge(MergeArgs { shards, out, restart }: &MergeArgs) -> Result<Code> {
    place::replaced(out, b"study,designs,index,", shards, "--out")?;
    ensure!(*restart || !out.exists(), bad_path(out, "is there, of a complete study", "replace it with --restart"));
    let (text, designs) = study::merge(shards)?;
    write(out, text.as_bytes())?;
    print(wrapped(format!("{designs} designs of {} shards in {}", shards.len(), out.display())))
}

impl ShardOptions {
    fn run(&self, study: &mut dyn Study, names: [&str; 2], curves: bool) -> Result<Code> {
        let shard = self.shard.unwrap_or(Shard::WHOLE);
        let count = shard.len(study.plan().designs);
        let what = format!("{count} runs are asked for, more than {MANY}: give --yes if that is meant, or --shard");
        ensure!(count <= MANY || self.yes, bad_request(what));
        self.table.run(study, names, shard, curves)
    }
}

impl TableOptions {
    fn run(&self, study: &mut dyn Study, [verb, name]: [&str; 2], shard: Shard, with_curves: bool) -> Result<Code> {
        let file = &self.file;
        let dir = self.study.folder(file, verb)?;
        let path = dir.join(shard.file(name));
        place::file(&path, std::slice::from_ref(file), "--out")?;
        let start = Instant::now();
        let watch = self.study.count(file, "runs");
        let settings = Evaluation { threads: self.study.threads.count(), shard, watch: &watch };
        let mut table = TableFile::open(&path, self.resume, self.restart, &watch)?;
        let folder =
            (shard == Shard::WHOLE).then(|| study_folder(name, &dir).map_err(unusable("--out"))).transpose()?;
        let runs = begin(study, &settings)?;
        if is_interrupted() {
            drop(watch);
            warn("ended before the first run: the same command begins again".to_owned());
            return Ok(Code::Interrupted);
        }
        let earlier = table.begin(&runs)?;
        let mut failed = None;
        let runs = evaluate(study, &settings, runs, &earlier, &mut |runs, evaluated| {
            if failed.is_none() {
                failed = table.add(runs, evaluated, with_curves).err();
                failed.iter().for_each(|error| warn(format!("{error}: {}; the runs go on", error.source)));
            }
            ControlFlow::Continue(())
        });
        drop(watch);
        let (all, designs) = (study.plan().designs, runs.runs.len());
        if is_interrupted() && (all == 0 || (designs as u64) < shard.len(all)) {
            warn(format!("{designs} runs are in {}; --resume goes on with the others", table.part.display()));
            return failed.map_or(Ok(Code::Interrupted), |error| Err(error.into()));
        }
        let Some(folder) = folder else {
            let text = format!("{designs} runs in {}; `stampflow merge` joins the shards", path.display());
            let printed = print(wrapped(text));
            return table.finish(&runs).map_err(Into::into).and(printed);
        };
        let files = vec![(shard.file(name), runs.csv())];
        let wall_s = start.elapsed().as_secs_f64();
        let extra = json!({ "designs": designs, "lights": runs.lights(), "file": path, "wall_s": wall_s });
        let code = self.study.present(&study.report(&runs), (&dir, folder), files, &table.curve_files(), extra)?;
        // Rows are kept in memory, curves are not.
        failed.filter(|_| with_curves).map_or(Ok(code), |error| Err(error.into()))
    }
}

impl StudyOptions {
    pub fn folder(&self, file: &Path, verb: &str) -> Result<PathBuf> {
        self.pictures.pictures()?;
        Ok(self.out.clone().unwrap_or_else(|| Path::new("out").join(format!("{}-{verb}", stem(file)))))
    }

    pub fn count(&self, file: &Path, what: &str) -> progress::Count {
        self.common.progress().count(format!("{}, {what}", stem(file)))
    }

    /// Prints the report, whatever becomes of the files; then writes charts, tables, curves and other files as one set.
    pub fn present(
        &self, report: &StudyReport, (dir, mut folder): (&Path, ResultFolder), mut files: Vec<(String, Vec<u8>)>,
        curves: &[PathBuf], extra: Value,
    ) -> Result<Code> {
        let pictures = self.pictures.pictures()?;
        let tables = || report.tables.iter().filter(|table| !table.rows.is_empty());
        files.extend(tables().map(|table| (format!("{}.csv", table.name), table.csv())));
        files.extend(report.charts.iter().flat_map(|(name, chart)| pictures.files(name, chart)));
        let paths = files.iter().map(|(name, _)| dir.join(name)).collect::<Vec<_>>();
        let value = with(with(serde_json::to_value(report)?, extra), json!({ "files": paths }));
        let printed = emit(self.common.json(), value, || {
            let text = wrapped(&report.headline) + list(&report.notes);
            let printed = tables().map(|table| table.printed.as_deref().unwrap_or(table));
            let text = printed.fold(text, |text, t| text + "\n" + table(&t.columns, t.rows.clone()));
            text + wrapped(format!("\n{}", dir.display()))
        });
        files.iter().try_for_each(|(name, bytes)| folder.write(name, bytes))?;
        for path in curves {
            let name = Path::new("curves").join(path.file_name().unwrap_or_default());
            folder.write(name, &std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?)?;
        }
        folder.commit()?;
        printed.map(|_| if report.found { Code::Done } else { Code::Failed })
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "study".into(), |stem| stem.to_string_lossy().into_owned())
}
