//! A tool's section from a CSV file of points.

use super::section::{Drawn, Origin, place_of};
use super::tools::Shop;
use crate::case::CaseError;
use crate::geometry::{FilletTooLarge, Piece, Point, Profile, Segment, fillet};
use crate::model::{Geometry, Role};
use crate::quantity::{Length, Quantity};
use crate::table::Unit;
use csv::StringRecord;
use miette::NamedSource;
use std::sync::Arc;

/// Points closer than this are one \[mm\]: drawings repeat where their curves meet.
const SAME: f64 = 1e-5;

/// More points than a section needs; each node looks at every one of them in every iteration.
const MOST: usize = 2000;

const EXAMPLE: &str = "write for example r_mm,z_mm in the first line and 30.5,-6 below it";

/// The points of a file, and the file for messages.
pub(super) struct Points {
    text: Text,
    /// The chain through the points.
    pub chords: Profile,
    /// Line of each point in the file, from 1.
    pub lines: Vec<usize>,
}

impl Points {
    /// An error about a point.
    pub fn error(&self, point: usize, what: String, help: impl Into<String>) -> CaseError {
        at_line(&self.text, self.lines[point.min(self.lines.len() - 1)], what, help)
    }
}

/// The text of a file, and the key that names it.
struct Text {
    shown: Arc<NamedSource<String>>,
    key: String,
}

/// One row of the file.
struct Row {
    line: usize,
    point: Point,
    radius: Option<f64>,
}

/// Reads `file`, named at the key `key`; `radius` \[mm\] is the fillet of the points that have none of their own.
pub(super) fn convert(
    file: &str,
    key: &str,
    radius: Option<f64>,
    role: Role,
    shop: &Shop,
    derived: &mut Vec<String>,
) -> Result<Drawn, CaseError> {
    let path = shop.folder.join(file);
    let name = role.name();
    if !path.is_file() {
        let what = format!("the profile file \"{file}\" is not there");
        return Err(shop.source.error(key, what, format!("put it at {}", path.display())));
    }
    let text = std::fs::read_to_string(&path).map_err(|error| {
        let what = format!("the profile file \"{file}\" cannot be read: {error}");
        shop.source.error(key, what, "save it as CSV in UTF-8")
    })?;
    let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
    let shown = Arc::new(NamedSource::new(path.display().to_string(), text));
    let shown = Text { shown, key: key.to_owned() };
    let rows = distinct(read(&shown, shop.sheet.geometry)?, file, derived);
    let [first, .., last] = &rows[..] else {
        let what = format!("a profile needs at least two points, found {}", rows.len());
        return Err(at_line(&shown, rows.first().map_or(1, |row| row.line), what, EXAMPLE));
    };
    if rows.len() > MOST {
        let what = format!("{} points are more than the {MOST} a section may have", rows.len());
        return Err(at_line(&shown, last.line, what, "thin them out: chords are rounded off by tangent arcs"));
    }
    for end in [first, last] {
        if end.radius.is_some_and(|radius| radius > 0.0) {
            let what = "the first and the last point have no corner to round".to_owned();
            return Err(at_line(&shown, end.line, what, "leave the radius empty there"));
        }
    }

    let points: Vec<Point> = rows.iter().map(|row| row.point).collect();
    let chords = points.windows(2).map(|w| Piece::Segment(Segment::new(w[0], w[1]))).collect();
    let chords = Profile::new(chords).expect("distinct points in a row are a chain");
    let filleted = radius.is_some() || rows.iter().any(|row| row.radius.is_some());
    derived.push(format!("the {name}'s profile is read from {file}: {} points", rows.len()));
    let profile = if filleted {
        let radii: Vec<f64> = rows.iter().map(|row| row.radius.or(radius).unwrap_or(0.0)).collect();
        let pieces = fillet(&points, &radii).map_err(|FilletTooLarge { vertex, at, radius, largest }| {
            let what = format!("a fillet of {radius} mm does not fit at {}: at most {largest:.4} mm", place_of(at));
            at_line(&shown, rows[vertex].line, what, "make it smaller, or move the points beside it further away")
        })?;
        Profile::new(pieces).map_err(|error| shop.source.error(key, format!("{file}: {error}"), "check the points"))?
    } else {
        let rounded = chords.rounded();
        let moved = rounded.polyline(0.01).into_iter().map(|p| chords.closest(p).distance.abs()).fold(0.0, f64::max);
        if moved > 1e-6 {
            derived.push(format!(
                "corners of less than 25° in {file} are rounded off by tangent arcs, up to {moved:.4} mm beside the \
                 chords; `fillet` keeps straight lines"
            ));
        }
        rounded
    };
    let lines = rows.iter().map(|row| row.line).collect();
    let path = format!("tools.{name}.profile");
    Ok(Drawn { profile, path, origin: Origin::Points(Points { text: shown, chords, lines }) })
}

/// The rows without those that repeat the one before.
fn distinct(rows: Vec<Row>, file: &str, derived: &mut Vec<String>) -> Vec<Row> {
    let mut kept: Vec<Row> = Vec::new();
    for row in rows {
        match kept.last_mut().filter(|last| (last.point - row.point).norm() < SAME) {
            Some(last) => {
                derived.push(format!(
                    "line {} of {file} repeats the point of line {} and is left out",
                    row.line, last.line
                ));
                last.radius = last.radius.or(row.radius);
            }
            None => kept.push(row),
        }
    }
    kept
}

/// An error at a line of a file.
fn at_line(text: &Text, line: usize, what: String, help: impl Into<String>) -> CaseError {
    let inner = text.shown.inner();
    let start = inner.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
    let length = inner[start..].lines().next().map_or(0, str::len);
    let label = format!("line {line} of {}", text.key);
    CaseError::at(text.shown.clone(), start..start + length, what, label, help.into())
}

/// Which columns hold what, and the factors to mm.
struct Columns {
    r: (usize, f64),
    z: (usize, f64),
    radius: Option<(usize, f64)>,
    count: usize,
}

fn read(text: &Text, geometry: Geometry) -> Result<Vec<Row>, CaseError> {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .flexible(true)
        .has_headers(false)
        .from_reader(text.shown.inner().as_bytes());
    let mut columns = None;
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error.position().map_or(1, |p| p.line() as usize);
            at_line(text, line, format!("this is not CSV: {error}"), EXAMPLE)
        })?;
        let line = line_of(&record, text.shown.inner());
        match &columns {
            None => columns = Some(header(&record, line, text, geometry)?),
            Some(columns) => rows.push(row(&record, columns, line, text, geometry)?),
        }
    }
    match columns {
        Some(_) => Ok(rows),
        None => Err(at_line(text, 1, "the profile file is empty".into(), EXAMPLE)),
    }
}

/// The line that a record stands in: its position is that of the comments before it.
fn line_of(record: &StringRecord, text: &str) -> usize {
    let from = record.position().map_or(1, |p| p.line() as usize).max(1);
    let skipped = |line: &str| line.trim().is_empty() || line.starts_with('#');
    from + text.lines().skip(from - 1).take_while(|line| skipped(line)).count()
}

fn header(record: &StringRecord, line: usize, text: &Text, geometry: Geometry) -> Result<Columns, CaseError> {
    let fail = |what: String, help: &str| Err(at_line(text, line, what, help));
    if let Some(separator) = record.iter().flat_map(str::chars).find(|c| matches!(c, ';' | '\t')) {
        let name = if separator == ';' { "semicolons" } else { "tabs" };
        let help = "separate columns by commas and write decimals with a point: r_mm,z_mm and 30.5,-6 below it";
        return fail(format!("the columns are separated by {name}"), help);
    }
    if record.iter().all(|field| field.parse::<f64>().is_ok()) {
        return fail("the first line must name the columns, found numbers".into(), EXAMPLE);
    }
    let (mut r, mut z, mut radius) = (None, None, None);
    for (i, field) in record.iter().enumerate() {
        let name = field.split('_').next().unwrap_or("");
        let slot = match (name, geometry) {
            ("r", _) | ("x", Geometry::PlaneStrain) => &mut r,
            ("z", _) => &mut z,
            ("radius", _) => &mut radius,
            ("x", Geometry::Axisymmetric) => {
                return fail(
                    format!("`{field}` belongs to plane-strain cases, this one is axisymmetric"),
                    "write r_mm",
                );
            }
            _ => return fail(format!("unknown column `{field}`"), "known columns: r_mm, z_mm, radius_mm"),
        };
        let factor = match Unit::of_header(field) {
            Ok((Unit::Mm, factor)) => factor,
            _ => {
                return fail(
                    format!("the column `{field}` has no unit of length"),
                    &format!("write {name}_mm or {name}_in"),
                );
            }
        };
        if slot.replace((i, factor)).is_some() {
            return fail(format!("there are two columns for {name}"), "keep one");
        }
    }
    let found: Vec<&str> = record.iter().collect();
    let missing = |name: &str| format!("there is no column for {name}; found {}", found.join(", "));
    let first = if geometry == Geometry::PlaneStrain { "x" } else { "r" };
    match (r, z) {
        (Some(r), Some(z)) => Ok(Columns { r, z, radius, count: record.len() }),
        (None, _) => fail(missing(first), &format!("name it {first}_mm")),
        (_, None) => fail(missing("z"), "name it z_mm"),
    }
}

fn row(
    record: &StringRecord,
    columns: &Columns,
    line: usize,
    text: &Text,
    geometry: Geometry,
) -> Result<Row, CaseError> {
    let fail = |what: String, help: &str| at_line(text, line, what, help);
    if record.len() > columns.count {
        let what = format!("{} numbers stand under {} columns", record.len(), columns.count);
        return Err(fail(what, "write decimals with a point, not a comma: 30.5"));
    }
    let number = |(column, factor): (usize, f64)| -> Result<Option<f64>, CaseError> {
        let field = record.get(column).unwrap_or("");
        if field.is_empty() {
            return Ok(None);
        }
        let help = match field.contains(',') {
            true => "write decimals with a point, not a comma: 30.5",
            false => "write a plain number; its unit stands in the header",
        };
        let value: f64 = field.parse().map_err(|_| fail(format!("\"{field}\" is not a number"), help))?;
        let length = Length::checked(value * factor, field);
        length.map(|length| Some(length.value())).map_err(|error| fail(error.to_string(), "check the header's unit"))
    };
    let coordinate = |column, name: &str| {
        number(column)?.ok_or_else(|| fail(format!("{name} is missing"), "a point has two coordinates"))
    };
    let first = if geometry == Geometry::PlaneStrain { "x" } else { "r" };
    let point = Point::new(coordinate(columns.r, first)?, coordinate(columns.z, "z")?);
    if point.x < 0.0 {
        let what = format!("a point lies at negative {first}, {} mm", point.x);
        return Err(fail(what, "the section is drawn from the axis outward, r >= 0"));
    }
    let radius = columns.radius.map(number).transpose()?.flatten();
    if let Some(radius) = radius.filter(|radius| *radius < 0.0) {
        return Err(fail(format!("a fillet radius is negative, {radius} mm"), "write its size: hollows need no sign"));
    }
    Ok(Row { line, point, radius })
}
