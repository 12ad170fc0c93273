//! Correlations: a Gaussian copula, by which any two distributions can go together.
//!
//! Coordinates u of the unit cube become normal variables z = Φ⁻¹(u); L z, with L Lᵀ the matrix of correlations, are
//! correlated; Φ(L z) are coordinates again, and each goes through its own distribution. The coefficient that is given is the
//! one of the normal variables: of two normal distributions Pearson's, of others near to it (of two uniform ones at most 0.02
//! more than theirs).

use super::StudyError;
use super::distribution::{normal_probability, normal_quantile};
use nalgebra::DMatrix;

/// Two keys and the coefficient of their correlation.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    /// Keys, as they are varied.
    pub keys: [String; 2],
    /// Between −1 and 1 \[–\].
    pub coefficient: f64,
}

/// The factor L of correlated coordinates, all of one sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Copula {
    /// Row by row, up to the diagonal.
    factor: Vec<Vec<f64>>,
}

impl Correlation {
    /// Reads `KEY,KEY=COEFFICIENT`.
    ///
    /// # Errors
    /// When something is missing, or the coefficient is not between −1 and 1.
    pub fn read(text: &str) -> Result<Self, StudyError> {
        let usage = "write KEY,KEY=COEFFICIENT, such as \"material.hardening.swift.k,material.hardening.swift.n=-0.8\"";
        let wrong = |what: String| StudyError::new(what, usage);
        let (keys, number) = text.split_once('=').ok_or_else(|| wrong(format!("`{text}` gives no correlation")))?;
        let keys: Vec<&str> = keys.split(',').map(str::trim).collect();
        let &[a, b] = keys.as_slice() else {
            return Err(wrong(format!("`{text}` correlates {} keys, not two", keys.len())));
        };
        if a == b {
            return Err(wrong(format!("{a} is correlated with itself")));
        }
        let number = number.trim().replace('−', "-");
        let coefficient: f64 =
            number.parse().map_err(|_| wrong(format!("the correlation of {a} and {b} is no number: `{number}`")))?;
        if coefficient.is_nan() || coefficient.abs() >= 1.0 {
            let help = "a coefficient lies between -1 and 1; of what goes together wholly vary one key";
            return Err(StudyError::new(format!("the correlation of {a} and {b} is {number}"), help));
        }
        Ok(Self { keys: [a.to_owned(), b.to_owned()], coefficient })
    }
}

/// The group of each key, by the order of the keys: what is correlated, also by way of others, is one.
///
/// # Errors
/// When a correlation names what does not scatter.
pub fn groups(keys: &[&str], correlations: &[Correlation]) -> Result<Vec<usize>, StudyError> {
    let mut groups: Vec<usize> = (0..keys.len()).collect();
    for pair in places(keys, correlations)? {
        let [a, b] = pair.map(|i| groups[i]);
        groups.iter_mut().filter(|group| **group == a.max(b)).for_each(|group| *group = a.min(b));
    }
    let mut order: Vec<usize> = Vec::new();
    for group in &mut groups {
        let place = order.iter().position(|known| known == group);
        *group = place.unwrap_or_else(|| {
            order.push(*group);
            order.len() - 1
        });
    }
    Ok(groups)
}

fn places(keys: &[&str], correlations: &[Correlation]) -> Result<Vec<[usize; 2]>, StudyError> {
    let place = |key: &String| {
        keys.iter().position(|known| known == key).ok_or_else(|| {
            let what = format!("{key} is correlated and does not scatter");
            StudyError::new(what, format!("what scatters is {}", keys.join(", ")))
        })
    };
    correlations.iter().map(|pair| Ok([place(&pair.keys[0])?, place(&pair.keys[1])?])).collect()
}

impl Copula {
    /// Of keys in the order of their coordinates.
    ///
    /// # Errors
    /// When a correlation names what does not scatter, is given twice, or all together are impossible: the matrix is not
    /// positive definite.
    pub fn new(keys: &[&str], correlations: &[Correlation]) -> Result<Self, StudyError> {
        let mut matrix = DMatrix::<f64>::identity(keys.len(), keys.len());
        for ([i, j], pair) in places(keys, correlations)?.into_iter().zip(correlations) {
            if matrix[(i, j)] != 0.0 {
                let [a, b] = &pair.keys;
                return Err(StudyError::new(format!("the correlation of {a} and {b} is given twice"), "give it once"));
            }
            (matrix[(i, j)], matrix[(j, i)]) = (pair.coefficient, pair.coefficient);
        }
        let least = matrix.clone().symmetric_eigenvalues().min();
        let cholesky = matrix.cholesky().ok_or_else(|| {
            let what =
                format!("these correlations cannot be all at once: the least eigenvalue of their matrix is {least:.2}");
            StudyError::new(what, "smaller coefficients, or those of the pairs between as well")
        })?;
        let l = cholesky.l();
        Ok(Self { factor: (0..keys.len()).map(|i| (0..=i).map(|j| l[(i, j)]).collect()).collect() })
    }

    /// Correlated coordinates of independent ones; those that nothing is correlated with stay as they are.
    pub fn correlated(&self, unit: &[f64]) -> Vec<f64> {
        let of = |(i, row): (usize, &Vec<f64>)| {
            if row[..i].iter().all(|factor| *factor == 0.0) {
                return unit[i];
            }
            normal_probability(row.iter().zip(unit).map(|(factor, u)| factor * normal_quantile(*u)).sum())
        };
        self.factor.iter().enumerate().map(of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(texts: &[&str]) -> Vec<Correlation> {
        texts.iter().map(|text| Correlation::read(text).unwrap_or_else(|error| panic!("{error}"))).collect()
    }

    /// Trust: by hand.
    #[test]
    fn what_is_correlated_is_one_group() {
        let pairs = read(&["d,b=0.5", "a,d=-0.3"]);
        assert_eq!(groups(&["a", "b", "c", "d"], &pairs).expect("keys"), [0, 0, 1, 0]);
        assert_eq!(groups(&["a", "b"], &[]).expect("keys"), [0, 1]);
    }

    /// Trust: each is wrong as its message says; three keys cannot each go against both others by 0.9.
    #[test]
    fn impossible_correlations_are_told() {
        for (text, said) in [
            ("a,b", "gives no correlation"),
            ("a=0.5", "1 keys, not two"),
            ("a,a=0.5", "with itself"),
            ("a,b=much", "no number"),
            ("a,b=-1.2", "is -1.2"),
            ("a,b=1", "is 1"),
            ("a,b=nan", "is nan"),
        ] {
            let error = Correlation::read(text).expect_err(text).to_string();
            assert!(error.contains(said), "{text}: {error}");
        }
        let keys = ["a", "b", "c"];
        for (pairs, said) in [
            (read(&["a,b=-0.9", "b,c=-0.9", "a,c=-0.9"]), "least eigenvalue of their matrix is -0.80"),
            (read(&["a,x=0.5"]), "x is correlated and does not scatter"),
            (read(&["a,b=0.5", "b,a=0.5"]), "given twice"),
        ] {
            let error = Copula::new(&keys, &pairs).expect_err(said).to_string();
            assert!(error.contains(said), "{error}");
        }
    }
}
