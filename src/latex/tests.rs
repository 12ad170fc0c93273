//! Equations in LaTeX, evaluated over matrices.

use nalgebra::DMatrix;
use regex::Regex;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

pub type Matrix = DMatrix<f64>;

/// Random number between two.
pub type Random<'a> = &'a dyn Fn(f64, f64) -> f64;

/// Numbers of equations, what goes into functions and comes out of them, and the relative error of the functions.
pub type Check = (&'static [usize], fn(Random) -> Symbols, f64);

/// Checks every equation of a page: each on a line of its own, with its number.
pub fn check_equations(page: &str, checks: &[Check]) {
    let body = |line| str::strip_prefix(line, "$$ ")?.strip_suffix("} $$")?.split_once(r" \tag{");
    let (equations, numbers): (Vec<&str>, Vec<&str>) = page.lines().filter_map(body).unzip();
    let all = 1..=equations.len();
    assert!(all.clone().map(|number| number.to_string()).eq(numbers), "numbers from 1 on");
    assert_eq!(page.matches("$$").count(), 2 * equations.len(), "each equation has a line of its own");
    let inline = page.split("$$").step_by(2).flat_map(|text| text.split('$').skip(1).step_by(2));
    assert_eq!(inline.filter(|latex| latex.contains('=')).collect::<Vec<_>>(), [""; 0], "no equation in a sentence");
    let checked: BTreeSet<usize> = checks.iter().flat_map(|(numbers, ..)| numbers.iter().copied()).collect();
    assert_eq!(checked, all.collect());
    for ((numbers, check, error), seed) in checks.iter().flat_map(|check| (0..10).map(move |seed| (check, seed))) {
        let random = RefCell::new(fastrand::Rng::with_seed(seed));
        let mut known = check(&|low, high| low + (high - low) * random.borrow_mut().f64());
        let mut idle = BTreeSet::new();
        for equation in numbers.iter().flat_map(|number| equations[number - 1].split(r"\qquad")) {
            known.hold(equation, *error, &mut idle);
        }
        assert!(idle.is_empty(), "{idle:?} stands in no other equation");
    }
}

type Function = (&'static str, fn(f64) -> f64);

const FUNCTIONS: [Function; 6] = [
    ("\\sqrt", f64::sqrt),
    ("\\ln", f64::ln),
    ("\\exp", f64::exp),
    ("\\sin", f64::sin),
    ("\\cos", f64::cos),
    ("\\cosh", f64::cosh),
];

/// Symbols with their accents and indices, and what stands between them.
fn tokens(latex: &str) -> Vec<String> {
    let symbol = r"(?:\\(?:Delta|delta|partial|mathbf|boldsymbol|bar|dot) ?)*(?:\\[a-zA-Z]+|[a-zA-Z]|\{\\(?:bar|mathbf) ?\\?[a-z]+\})";
    let token = format!(r"\\(?:begin|end)\{{pmatrix\}}|{symbol}(?:_(?:\{{[^{{}}]*\}}|\\[a-z]+|.))?'?|\d+(?:\.\d+)?|\S");
    let all = Regex::new(&token).expect("a pattern");
    let all = all.find_iter(latex).map(|token| token.as_str().to_owned());
    all.filter(|token| !["\\left", "\\right", "\\min"].contains(&token.as_str())).collect()
}

/// Values of symbols, several where a sum runs over them.
#[derive(Default)]
pub struct Symbols(BTreeMap<String, Vec<Matrix>>);

impl Symbols {
    pub fn set(&mut self, name: &str, values: impl IntoIterator<Item = Matrix>) {
        self.0.insert(plain(name), values.into_iter().collect());
    }

    /// Numbers of names that commas part.
    pub fn numbers<const N: usize>(&mut self, names: &str, values: [f64; N]) {
        let names: Vec<&str> = names.split(", ").collect();
        assert_eq!(names.len(), N, "{names:?}");
        names.iter().zip(values).for_each(|(name, value)| self.list(name, [value]));
    }

    pub fn column(&mut self, name: &str, values: &[f64]) {
        self.set(name, [column(values)]);
    }

    pub fn list(&mut self, name: &str, values: impl IntoIterator<Item = f64>) {
        self.set(name, values.into_iter().map(|value| Matrix::from_element(1, 1, value)));
    }

    /// Compares the sides of an equation within a relative error, or defines the symbol on its left; symbols are `idle` from
    /// their definition to their use.
    fn hold(&mut self, equation: &str, error: f64, idle: &mut BTreeSet<String>) {
        let sides: Vec<_> = equation.split('=').map(tokens).collect();
        let terms = terms(&self.0);
        let unknown = plain(&sides[0].concat());
        for token in sides.iter().flatten().filter(|token| plain(token) != unknown) {
            idle.remove(&plain(token));
        }
        let evaluated = |side: &[String]| -> Vec<Matrix> { (0..terms).map(|term| self.evaluate(side, term)).collect() };
        if sides[0].len() == 1 && !self.0.contains_key(&unknown) {
            let values = evaluated(&sides[1]);
            let one = values.iter().all(|value| *value == values[0]);
            idle.insert(unknown.clone());
            self.0.insert(unknown, if one { vec![values[0].clone()] } else { values });
            return;
        }
        idle.remove(&unknown);
        let left = evaluated(&sides[0]);
        for (left, right) in sides[1..].iter().flat_map(|side| left.iter().zip(evaluated(side))) {
            let wrong = (left - &right).amax() / left.amax().max(right.amax()).max(f64::MIN_POSITIVE);
            assert!(wrong <= error, "{equation} is wrong by {wrong:.1e}: {left}{right}");
        }
    }

    /// Value of a side, of one term of a sum.
    fn evaluate(&self, tokens: &[String], term: usize) -> Matrix {
        let mut parser = Parser { tokens, at: 0, symbols: &self.0, term };
        let value = parser.sum();
        assert_eq!(parser.at, tokens.len(), "{tokens:?}");
        value
    }
}

pub fn column(values: &[f64]) -> Matrix {
    Matrix::from_column_slice(values.len(), 1, values)
}

/// Evaluation from left to right.
struct Parser<'a> {
    tokens: &'a [String],
    at: usize,
    symbols: &'a BTreeMap<String, Vec<Matrix>>,
    /// Term of a sum; with 1, ± is a minus.
    term: usize,
}

impl Parser<'_> {
    fn eat(&mut self, token: &str) -> bool {
        let is_next = self.tokens.get(self.at).is_some_and(|next| next == token);
        self.at += usize::from(is_next);
        is_next
    }

    fn closed(&mut self, end: &str) -> Matrix {
        let mut value = self.sum();
        while self.eat(",") {
            value = value.inf(&self.sum());
        }
        assert!(self.eat(end), "{end} at {} of {:?}", self.at, self.tokens);
        value
    }

    fn sum(&mut self) -> Matrix {
        let mut value = if self.eat("-") { -self.product() } else { self.product() };
        loop {
            value = match self.tokens.get(self.at).map_or("", String::as_str) {
                sign @ ("+" | "-" | "\\pm") => {
                    self.at += 1;
                    let is_minus = sign == "-" || sign == "\\pm" && self.term == 1;
                    value + self.product() * if is_minus { -1.0 } else { 1.0 }
                }
                _ => return value,
            }
        }
    }

    fn product(&mut self) -> Matrix {
        let ends = ["+", "-", "\\pm", ")", "}", ",", "&", "\\cr", "\\end{pmatrix}", "\\rvert"];
        let mut value = self.power();
        while self.tokens.get(self.at).is_some_and(|next| !ends.contains(&next.as_str())) {
            value = match self.eat("/") {
                true => value / self.power()[0],
                false => match (value.len(), self.power()) {
                    (1, right) => right * value[0],
                    (_, right) if right.len() == 1 => value * right[0],
                    (_, right) => value * right,
                },
            };
        }
        value
    }

    fn power(&mut self) -> Matrix {
        let base = self.atom();
        match self.eat("^") {
            false => base,
            true if self.eat("\\top") => base.transpose(),
            true => match self.atom()[0] {
                -1.0 if base.len() > 1 => base.try_inverse().expect("regular"),
                exponent => base.map(|base| base.powf(exponent)),
            },
        }
    }

    fn atom(&mut self) -> Matrix {
        let token = self.tokens[self.at].clone();
        self.at += 1;
        if let Some((_, function)) = FUNCTIONS.iter().find(|(name, _)| *name == token) {
            return self.atom().map(function);
        }
        match token.as_str() {
            "(" => self.closed(")"),
            "{" => self.closed("}"),
            "\\lvert" => Matrix::from_element(1, 1, self.closed("\\rvert").norm()),
            "\\frac" => self.atom() / self.atom()[0],
            "\\begin{pmatrix}" => {
                let (mut entries, mut rows) = (vec![self.sum()[0]], 1);
                while !self.eat("\\end{pmatrix}") {
                    rows += usize::from(!self.eat("&") && self.eat("\\cr"));
                    entries.push(self.sum()[0]);
                }
                Matrix::from_row_slice(rows, entries.len() / rows, &entries)
            }
            sum if sum.starts_with("\\sum_") => {
                let (from, term) = (self.at, self.term);
                let all = (0..terms(self.symbols)).map(|term| {
                    (self.at, self.term) = (from, term);
                    self.product()
                });
                let sum = all.reduce(|sum, term| sum + term).expect("terms");
                self.term = term;
                sum
            }
            number if number.starts_with(|first: char| first.is_ascii_digit()) => {
                Matrix::from_element(1, 1, number.parse().expect("a number"))
            }
            symbol => {
                let values = self.symbols.get(&plain(symbol));
                let values = values.unwrap_or_else(|| panic!("no {symbol} in {:?}", self.tokens));
                values[self.term % values.len()].clone()
            }
        }
    }
}

/// Name of a symbol without what groups it.
fn plain(name: &str) -> String {
    name.replace(['{', '}', ' '], "")
}

fn terms(symbols: &BTreeMap<String, Vec<Matrix>>) -> usize {
    symbols.values().map(Vec::len).max().unwrap_or(1)
}
