//! CSV files that a case names: their lines, and the section of a tool by points.

use super::*;
use crate::case::files;
use crate::geometry::{FilletTooLarge, fillet};
use crate::table::{Csv, CsvError, Record, Unit};
use miette::NamedSource;
use std::{io::ErrorKind, path::Path, sync::Arc};

/// Distance below which points are one \[mm\]: drawings repeat where their curves meet.
const SAME: f64 = 1e-5;
/// Most points of a section; each node checks every one of them in every iteration.
const MOST: usize = 2000;
const EXAMPLE: &str = "write for example r_mm,z_mm in the first line and 30.5,-6 below it";

pub struct Points {
    text: Lines,
    /// Chain through the points.
    pub chords: Profile,
    /// Line of each point in the file, from 1.
    pub lines: Vec<usize>,
}

impl Points {
    pub fn error(&self, point: usize, what: impl Into<String>, help: impl Into<String>) -> CaseError {
        self.text.error(self.lines[point.min(self.lines.len() - 1)], what, help)
    }
}

struct Row {
    line: usize,
    point: Point,
    radius: Option<f64>,
}

/// Reads `file`, named at the key `key`; `radius` \[mm\] is the fillet of the points that have none of their own.
pub fn convert(
    file: &str, key: &str, radius: Option<f64>, (name, geometry): (&str, Geometry), source: &Source,
) -> Result<(Profile, Points)> {
    let (text, csv) = Named { file, what: "profile", example: EXAMPLE, key }.open(source)?;
    let rows = distinct(read(&text, &csv, geometry)?, file, source);
    let [first, .., last] = &rows[..] else {
        let what = format!("a profile needs at least two points, found {}", rows.len());
        return Err(text.error(rows.first().map_or(1, |row| row.line), what, EXAMPLE));
    };
    if rows.len() > MOST {
        let what = format!("{} points are more than the {MOST} a section may have", rows.len());
        return Err(text.error(last.line, what, "thin them out: chords are rounded off by tangent arcs"));
    }
    if let Some(end) = [first, last].iter().find(|end| end.radius.is_some_and(|radius| radius > 0.0)) {
        let what = "the first and the last point have no corner to round";
        return Err(text.error(end.line, what, "leave the radius empty there"));
    }
    let points: Vec<Point> = rows.iter().map(|row| row.point).collect();
    let chords = points.windows(2).map(|w| Piece::line(w[0], w[1])).collect();
    let chords = Profile::new(chords).expect("distinct points in a row are a chain");
    source.note(format!("the {name}'s profile is read from {file}: {} points", rows.len()));
    let profile = if radius.is_some() || rows.iter().any(|row| row.radius.is_some()) {
        let radii: Vec<f64> = rows.iter().map(|row| row.radius.or(radius).unwrap_or(0.0)).collect();
        let pieces = fillet(&points, &radii).map_err(|FilletTooLarge { vertex, at, radius, largest }| {
            let what = format!("a fillet of {radius} mm does not fit at {}: at most {largest:.4} mm", place_of(at));
            text.error(rows[vertex].line, what, "make it smaller, or move the points beside it further away")
        })?;
        Profile::new(pieces).map_err(|error| source.error(key, format!("{file}: {error}"), "check the points"))?
    } else {
        let rounded = chords.rounded();
        let moved = rounded.polyline(0.01).into_iter().map(|p| chords.closest(p).distance.abs()).fold(0.0, f64::max);
        if moved > 1e-6 {
            let moved = Amount::size(moved);
            source.note(format!(
                "corners below 25° in {file} are rounded by tangent arcs, up to {moved} off the chords; `fillet` keeps lines"
            ));
        }
        rounded
    };
    Ok((profile, Points { text, chords, lines: rows.iter().map(|row| row.line).collect() }))
}

fn distinct(rows: Vec<Row>, file: &str, source: &Source) -> Vec<Row> {
    let (mut kept, mut repeats): (Vec<Row>, Vec<[usize; 2]>) = (Vec::new(), Vec::new());
    for row in rows {
        if let Some(last) = kept.last_mut().filter(|last| (last.point - row.point).norm() < SAME) {
            repeats.push([row.line, last.line]);
            last.radius = last.radius.or(row.radius);
        } else {
            kept.push(row);
        }
    }
    if let Some(([line, of], rest)) = repeats.split_first() {
        let more = if rest.is_empty() { String::new() } else { format!(", as are {} more such points", rest.len()) };
        source.note(format!("line {line} of {file} repeats the point of line {of} and is left out{more}"));
    }
    kept
}

fn read(text: &Lines, csv: &Csv, geometry: Geometry) -> Result<Vec<Row>> {
    let names = [if geometry == Geometry::PlaneStrain { "x" } else { "r" }, "z", "radius"];
    // Number of each column and its factor to mm.
    let mut columns = [None; 3];
    let fail = |what: String, help: &str| text.error(csv.header.line, what, help);
    for (i, field) in csv.header.fields.iter().enumerate() {
        let name = field.split('_').next().unwrap_or("");
        let known = names.iter().position(|known| *known == name || (*known, name) == ("x", "r"));
        let Some(at) = known else {
            let (what, help) = match name {
                "x" => (format!("`{field}` belongs to plane-strain cases, this one is axisymmetric"), "write r_mm"),
                _ => (format!("unknown column `{field}`"), "known columns: r_mm, z_mm, radius_mm"),
            };
            return Err(fail(what, help));
        };
        let Ok((Unit::Mm, factor)) = csv.unit(i) else {
            let what = format!("the column `{field}` has no unit of length");
            return Err(fail(what, &format!("write {name}_mm or {name}_in")));
        };
        if columns[at].replace((i, factor)).is_some() {
            return Err(fail(format!("there are two columns for {name}"), "keep one"));
        }
    }
    if let Some(i) = (0..2).find(|i| columns[*i].is_none()) {
        let what = format!("there is no column for {}; found {}", names[i], csv.names());
        return Err(fail(what, &format!("name it {}_mm", names[i])));
    }
    csv.rows.iter().map(|record| row(record, &columns, names, text)).collect()
}

fn row(record: &Record, columns: &[Option<(usize, f64)>; 3], names: [&str; 3], text: &Lines) -> Result<Row> {
    let line = record.line;
    let fail = |what: String, help: &str| text.error(line, what, help);
    let number = |i: usize| -> Result<Option<f64>> {
        let Some((column, factor)) = columns[i] else { return Ok(None) };
        let Some(value) = text.number(record, column)? else { return Ok(None) };
        let length = Length::checked(value * factor, record.fields.get(column).unwrap_or(""));
        length.map(|length| Some(length.value())).map_err(|error| fail(error.to_string(), "check the header's unit"))
    };
    let coordinate =
        |i: usize| number(i)?.ok_or_else(|| fail(format!("{} is missing", names[i]), "a point has two coordinates"));
    let point = Point::new(coordinate(0)?, coordinate(1)?);
    if point.x < 0.0 {
        let what = format!("a point lies at negative {}, {} mm", names[0], point.x);
        return Err(fail(what, "the section is drawn from the axis outward, r >= 0"));
    }
    let radius = number(2)?;
    if let Some(radius) = radius.filter(|radius| *radius < 0.0) {
        return Err(fail(format!("a fillet radius is negative, {radius} mm"), "write its size: hollows need no sign"));
    }
    Ok(Row { line, point, radius })
}

pub struct Named<'a> {
    pub file: &'a str,
    /// Content, as in "the profile file".
    pub what: &'static str,
    /// Example of its lines.
    pub example: &'static str,
    pub key: &'a str,
}

pub struct Lines {
    shown: Arc<NamedSource<String>>,
    key: String,
}

impl Named<'_> {
    pub fn open(&self, source: &Source) -> Result<(Lines, Csv)> {
        let path = source.folder.path.join(self.file);
        self.first(&[&path], source)?.map(|(_, lines, csv)| (lines, csv)).ok_or_else(|| {
            let what = format!("the {} file \"{}\" is not there", self.what, self.file);
            source.error(self.key, what, format!("put it at {}; {}", path.display(), self.example))
        })
    }

    pub fn first<'p>(&self, paths: &[&'p Path], source: &Source) -> Result<Option<(&'p Path, Lines, Csv)>> {
        for &path in paths {
            let text = match source.file(path, files::CSV) {
                Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::IsADirectory) => continue,
                text => text.map_err(|error| {
                    let what = format!("the {} file \"{}\" cannot be read: {error}", self.what, self.file);
                    source.error(self.key, what, "save it as CSV in UTF-8")
                })?,
            };
            let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
            let shown = Arc::new(NamedSource::new(path.display().to_string(), text));
            let lines = Lines { shown: shown.clone(), key: self.key.to_owned() };
            return match Csv::read(shown.inner(), &format!("the {} file", self.what), self.example) {
                Ok(csv) => Ok(Some((path, lines, csv))),
                Err(CsvError { line: None, what, help }) => Err(source.error(self.key, what, help)),
                Err(CsvError { line: Some(line), what, help }) => Err(lines.error(line, what, help)),
            };
        }
        Ok(None)
    }
}

impl Lines {
    /// Error at a line, from 1.
    pub fn error(&self, line: usize, what: impl Into<String>, help: impl Into<String>) -> CaseError {
        let inner = self.shown.inner();
        let start = inner.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
        let length = inner[start..].lines().next().map_or(0, str::len);
        let label = format!("line {line} of {}", self.key);
        CaseError::at(self.shown.clone(), start..start + length, what.into(), label, help.into())
    }

    /// Number in a column of a row; `None` if it is empty.
    pub fn number(&self, row: &Record, column: usize) -> Result<Option<f64>> {
        row.number(column).map_err(|CsvError { line, what, help }| self.error(line.unwrap_or(1), what, help))
    }
}
