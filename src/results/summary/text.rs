//! Summary as text and as JSON.

use super::{Group, Line, Summary, Value};
use crate::measure::{Change, Event};
use crate::table::Unit;
use crate::units::{Amount, rounded};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::json;
use std::fmt;

impl Serialize for Summary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for Line { key, value, .. } in &self.lines {
            match value {
                Value::Number(amount) => {
                    map.serialize_entry(&amount.unit.keyed(key), &rounded(amount.value))?;
                    if let Some(bar) = amount.bar() {
                        map.serialize_entry(&amount.unit.keyed(&format!("{key}_error_bar")), &rounded(bar))?;
                    }
                }
                Value::Count(count) => map.serialize_entry(key, count)?,
                Value::Flag(flag) => map.serialize_entry(key, flag)?,
                Value::Text(text) => map.serialize_entry(key, text)?,
                Value::List(list) => map.serialize_entry(key, list)?,
                Value::Rows(_, json) => map.serialize_entry(key, json)?,
            }
        }
        map.end()
    }
}

impl Summary {
    /// Label, value and unit of the lines of some groups that have one value.
    pub fn figures(&self, is_wanted: fn(Group) -> bool) -> impl Iterator<Item = [String; 3]> {
        self.printed().filter(move |line| is_wanted(line.group)).filter_map(|Line { label, value, .. }| {
            let (value, unit) = match value {
                Value::Number(amount) => amount.parts(),
                value => (value.text()?, ""),
            };
            Some([label.clone(), value, unit.to_owned()])
        })
    }

    /// Labels and values of all printed lines; the entries of a list stand below each other.
    pub fn rows(&self) -> impl Iterator<Item = [String; 2]> {
        self.printed().flat_map(|Line { label, value, .. }| match value {
            Value::List(entries) => {
                let labels = std::iter::once(label.clone()).chain(std::iter::repeat(String::new()));
                labels.zip(entries).map(|(label, entry)| [label, format!("- {entry}")]).collect()
            }
            Value::Rows(rows, _) => {
                let mut rows = rows.clone();
                rows.iter_mut().take(1).for_each(|[first, _]| first.insert_str(0, label));
                rows
            }
            value => vec![[label.clone(), value.text().unwrap_or_default()]],
        })
    }

    fn printed(&self) -> impl Iterator<Item = &Line> {
        self.lines.iter().filter(|line| !line.label.is_empty())
    }
}

impl Value {
    /// Value of a line that is neither a list nor a table.
    fn text(&self) -> Option<String> {
        match self {
            Self::Number(amount) => Some(amount.to_string()),
            Self::Count(count) => Some(count.to_string()),
            Self::Flag(flag) => Some(if *flag { "yes" } else { "no" }.to_owned()),
            Self::Text(text) => Some(text.clone()),
            Self::List(_) | Self::Rows(..) => None,
        }
    }

    /// `44.1 mm, 48.3 kN: rim meets the die`; the time in place of travel and force where a gas works.
    pub(super) fn events(events: &[Event], force: Unit) -> Self {
        let row = |event: &Event| {
            let (travel, load) = (Amount::place(event.travel), Amount::force(event.force, force));
            let at =
                if event.travel == 0.0 { Amount::time(event.time).to_string() } else { format!("{travel}, {load}") };
            [String::new(), format!("{at}: {}", event.kind.label())]
        };
        let entry = |event: &Event| {
            json!({
                "key": event.kind.key(),
                "what": event.kind.label(),
                Unit::Mm.keyed("travel"): rounded(event.travel),
                Unit::Second.keyed("time"): rounded(event.time),
                force.keyed("punch_force"): rounded(event.force),
            })
        };
        Self::Rows(events.iter().map(row).collect(), events.iter().map(entry).collect())
    }

    /// `Wall to the punch direction  0.3° → 8.2° (+7.9°)`
    pub(super) fn changes(changes: &[Change]) -> Self {
        let row = |change: &Change| {
            let by = change.change().map_or_else(String::new, |by| format!(" ({})", change.quantity.signed_text(by)));
            [format!("  {}", change.quantity.label), format!("{change}{by}")]
        };
        let entry = |change: &Change| {
            json!({
                "key": change.quantity.key,
                "unit": change.quantity.unit.spelled(),
                "before": change.before.map(rounded),
                "after": change.after.map(rounded),
                "change": change.change().map(rounded),
            })
        };
        let head = [String::new(), "before → after (change)".to_owned()];
        Self::Rows(std::iter::once(head).chain(changes.iter().map(row)).collect(), changes.iter().map(entry).collect())
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.rows().map(|[label, _]| label.chars().count()).max().unwrap_or(0);
        self.rows().try_for_each(|[label, value]| writeln!(f, "{label:<width$}  {value}"))
    }
}
