//! Arrays of numbers beside the JSON of an answer.

use serde_json::{Value, json};

/// Arrays one after the other.
#[derive(Default)]
pub struct Numbers(Vec<f64>);

impl Numbers {
    /// Adds an array; what stands for it in the JSON.
    pub fn put(&mut self, values: impl IntoIterator<Item = f64>) -> Value {
        let at = self.0.len();
        self.0.extend(values);
        json!({ "at": at, "of": self.0.len() - at })
    }

    pub fn all(self) -> Vec<f64> {
        self.0
    }
}
