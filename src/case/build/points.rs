//! A tool's section from a CSV file of points.

use super::context::ToolContext;
use super::lines::{Lines, Named};
use super::values::place_of;
use crate::case::CaseError;
use crate::geometry::{FilletTooLarge, Piece, Point, Profile, Segment, fillet};
use crate::model::{Geometry, Role};
use crate::table::{Csv, Record, Unit};
use crate::units::Amount;
use crate::units::{Dimensioned, Length};

/// Points closer than this are one \[mm\]: drawings repeat where their curves meet.
const SAME: f64 = 1e-5;

/// More points than a section needs; each node looks at every one of them in every iteration.
const MOST: usize = 2000;

const EXAMPLE: &str = "write for example r_mm,z_mm in the first line and 30.5,-6 below it";

/// The points of a file, and the file for messages.
pub(super) struct Points {
    text: Lines,
    /// The chain through the points.
    pub chords: Profile,
    /// Line of each point in the file, from 1.
    pub lines: Vec<usize>,
}

impl Points {
    /// An error about a point.
    pub fn error(&self, point: usize, what: String, help: impl Into<String>) -> CaseError {
        self.text.error(self.lines[point.min(self.lines.len() - 1)], what, help)
    }
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
    context: &ToolContext,
    derived: &mut Vec<String>,
) -> Result<(Profile, Points), CaseError> {
    let name = role.name();
    let (shown, csv) = Named { file, what: "profile", example: EXAMPLE, key }.open(context.folder, context.source)?;
    let rows = distinct(read(&shown, &csv, context.sheet.extent.geometry())?, file, derived);
    let [first, .., last] = &rows[..] else {
        let what = format!("a profile needs at least two points, found {}", rows.len());
        return Err(shown.error(rows.first().map_or(1, |row| row.line), what, EXAMPLE));
    };
    if rows.len() > MOST {
        let what = format!("{} points are more than the {MOST} a section may have", rows.len());
        return Err(shown.error(last.line, what, "thin them out: chords are rounded off by tangent arcs"));
    }
    for end in [first, last] {
        if end.radius.is_some_and(|radius| radius > 0.0) {
            let what = "the first and the last point have no corner to round".to_owned();
            return Err(shown.error(end.line, what, "leave the radius empty there"));
        }
    }

    let points: Vec<Point> = rows.iter().map(|row| row.point).collect();
    let chords = points.windows(2).map(|w| Piece::Segment(Segment::new(w[0], w[1]))).collect();
    let chords = Profile::new(chords).expect("distinct points in a row are a chain");
    let filleted = radius.is_some() || rows.iter().any(|row| row.radius.is_some());
    derived.push(format!("the {name}'s profile is read from {file}: {n} points", n = rows.len()));
    let profile = if filleted {
        let radii: Vec<f64> = rows.iter().map(|row| row.radius.or(radius).unwrap_or(0.0)).collect();
        let pieces = fillet(&points, &radii).map_err(|FilletTooLarge { vertex, at, radius, largest }| {
            let what = format!("a fillet of {radius} mm does not fit at {}: at most {largest:.4} mm", place_of(at));
            shown.error(rows[vertex].line, what, "make it smaller, or move the points beside it further away")
        })?;
        Profile::new(pieces)
            .map_err(|error| context.source.error(key, format!("{file}: {error}"), "check the points"))?
    } else {
        let rounded = chords.rounded();
        let moved = rounded.polyline(0.01).into_iter().map(|p| chords.closest(p).distance.abs()).fold(0.0, f64::max);
        if moved > 1e-6 {
            derived.push(format!(
                "corners of less than 25° in {file} are rounded off by tangent arcs, up to {moved} beside the chords; \
                 `fillet` keeps straight lines",
                moved = Amount::size(moved)
            ));
        }
        rounded
    };
    let lines = rows.iter().map(|row| row.line).collect();
    Ok((profile, Points { text: shown, chords, lines }))
}

/// The rows without those that repeat the one before; one note says so, however many there are.
fn distinct(rows: Vec<Row>, file: &str, derived: &mut Vec<String>) -> Vec<Row> {
    let (mut kept, mut repeats): (Vec<Row>, Vec<[usize; 2]>) = (Vec::new(), Vec::new());
    for row in rows {
        match kept.last_mut().filter(|last| (last.point - row.point).norm() < SAME) {
            Some(last) => {
                repeats.push([row.line, last.line]);
                last.radius = last.radius.or(row.radius);
            }
            None => kept.push(row),
        }
    }
    if let Some(([line, of], others)) = repeats.split_first() {
        let (file, line, of) = (file.to_owned(), *line, *of);
        derived.push(match others.len() {
            0 => format!("line {line} of {file} repeats the point of line {of} and is left out"),
            more => format!("line {line} of {file} repeats the point of line {of} and is left out, as are {more} more that repeat the one \
                 before"),
        });
    }
    kept
}

/// Which columns hold what, and the factors to mm.
struct Columns {
    r: (usize, f64),
    z: (usize, f64),
    radius: Option<(usize, f64)>,
}

fn read(text: &Lines, csv: &Csv, geometry: Geometry) -> Result<Vec<Row>, CaseError> {
    let columns = header(csv, text, geometry)?;
    csv.rows.iter().map(|record| row(record, &columns, text, geometry)).collect()
}

fn header(csv: &Csv, text: &Lines, geometry: Geometry) -> Result<Columns, CaseError> {
    let fail = |what: String, help: &str| Err(text.error(csv.header.line, what, help));
    let (mut r, mut z, mut radius) = (None, None, None);
    for (i, field) in csv.header.fields.iter().enumerate() {
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
        let factor = match csv.unit(i) {
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
    let missing = |name: &str| format!("there is no column for {name}; found {}", csv.found());
    let first = if geometry == Geometry::PlaneStrain { "x" } else { "r" };
    match (r, z) {
        (Some(r), Some(z)) => Ok(Columns { r, z, radius }),
        (None, _) => fail(missing(first), &format!("name it {first}_mm")),
        (_, None) => fail(missing("z"), "name it z_mm"),
    }
}

fn row(record: &Record, columns: &Columns, text: &Lines, geometry: Geometry) -> Result<Row, CaseError> {
    let line = record.line;
    let fail = |what: String, help: &str| text.error(line, what, help);
    let number = |(column, factor): (usize, f64)| -> Result<Option<f64>, CaseError> {
        let Some(value) = text.number(record, column)? else { return Ok(None) };
        let field = record.fields.get(column).unwrap_or("");
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
