//! Curves over whole numbers, drawn with letters on a logarithmic axis: for a terminal.

/// Most lines of a plot, and most lines for a power of ten.
const HIGHEST: i32 = 18;
const FINEST: i32 = 3;
/// Powers of ten below the largest value that are drawn.
const DEEPEST: i32 = 16;
/// Columns before the axis, and most columns from one number to the next.
const MARGIN: usize = 6;
const WIDEST: usize = 8;

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The letter that it is drawn with.
    pub mark: char,
    /// Whole numbers with their values; what is not above 0 is not drawn.
    pub points: Vec<(usize, f64)>,
}

/// The curves within so many columns, a dotted line at `level`, a name under the axis; where two curves meet stands the mark
/// of the first. Nothing where no value is above 0.
pub fn log_plot(curves: &[Curve], level: f64, name: &str, columns: usize) -> String {
    let points = || curves.iter().flat_map(|curve| &curve.points).filter(|point| is_drawn(point.1));
    let Some(largest) = points().map(|point| point.1).reduce(f64::max) else { return String::new() };
    let least = points().map(|point| point.1).fold(level, f64::min);
    let top = largest.max(level).log10().ceil() as i32;
    let bottom = (least.log10().floor() as i32).max(top - DEEPEST).min(top - 1);
    let fine = (HIGHEST / (top - bottom)).clamp(1, FINEST);
    let last = points().map(|point| point.0).max().unwrap_or(0).max(1);
    let room = columns.saturating_sub(MARGIN + 6 + name.chars().count()).max(1);
    let apart = (room / last).clamp(1, WIDEST);
    let column = |x: usize| if apart * last <= room { apart * x } else { x * room / last };
    let row = |y: f64| (f64::from(fine) * (f64::from(top) - y.log10())).round() as usize;
    let mut drawn = vec![vec![' '; column(last) + 1]; (fine * (top - bottom)) as usize + 1];
    for dot in drawn.get_mut(row(level)).into_iter().flat_map(|line| line.iter_mut().step_by(2)) {
        *dot = '·';
    }
    for curve in curves.iter().rev() {
        for &(x, y) in curve.points.iter().filter(|point| is_drawn(point.1)) {
            if let Some(line) = drawn.get_mut(row(y)) {
                line[column(x)] = curve.mark;
            }
        }
    }
    let lines = drawn.iter().enumerate().map(|(i, line)| {
        let power = if i as i32 % fine == 0 { format!("1e{}", top - i as i32 / fine) } else { String::new() };
        let bar = if power.is_empty() { '│' } else { '┤' };
        let line: String = line.iter().collect();
        format!("{}\n", format!("{power:>MARGIN$} {bar} {line}").trim_end())
    });
    let lines: String = lines.collect();
    format!("{lines}{:MARGIN$} └{}\n{}", "", "─".repeat(column(last) + 2), numbered(last, column, name))
}

fn is_drawn(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// Round numbers under the axis, and what they count.
fn numbered(last: usize, column: impl Fn(usize) -> usize, name: &str) -> String {
    let steps = (0..).flat_map(|power| [1, 2, 5].map(|step| step * 10_usize.pow(power)));
    let wide = last.to_string().len() + 1;
    let step = steps.into_iter().find(|step| column(*step) > wide).unwrap_or(last);
    let mut line = String::new();
    for x in (0..=last).step_by(step) {
        let at = MARGIN + 3 + column(x);
        line += &format!("{:>1$}{x}", "", at.saturating_sub(line.chars().count()));
    }
    format!("{line}  {name}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: drawn by hand.
    #[test]
    fn curves_stand_at_their_powers_of_ten() {
        let fast = Curve { mark: 'n', points: vec![(0, 1.0), (1, 1e-2), (2, 1e-4)] };
        let slow = Curve { mark: 's', points: vec![(0, 1.0), (1, 1e-1), (2, 1e-2), (3, 0.0)] };
        let plot = log_plot(&[fast, slow], 1e-3, "iteration", 40);
        let lines: Vec<&str> = plot.lines().collect();
        assert_eq!(lines[0], "   1e0 ┤ n");
        assert_eq!(lines[3], "  1e-1 ┤         s");
        assert_eq!(lines[6], "  1e-2 ┤         n       s");
        assert_eq!(lines[9], "  1e-3 ┤ · · · · · · · · ·");
        assert_eq!(lines[12], "  1e-4 ┤                 n");
        assert_eq!(lines[14], "         0       1       2  iteration");
        assert!(log_plot(&[], 1e-3, "iteration", 30).is_empty());
        let long = Curve { mark: 's', points: (0..1000).map(|i| (i, 0.99_f64.powi(i as i32))).collect() };
        assert!(log_plot(&[long], 1e-5, "", 80).lines().all(|line| line.chars().count() <= 80));
    }
}
