//! Whether two sides compute the same.

/// What rounding may do to the accelerations of twenty links, with three digits to spare.
const BOUND: f64 = 1e-9;

/// The greatest difference over all states, relative to the size of the accelerations there; an error
/// that names the state if it is more than rounding.
pub(crate) fn difference(ours: &[Vec<f64>], theirs: &[Vec<f64>]) -> Result<f64, String> {
    if theirs.len() != ours.len() {
        let (ours, theirs) = (ours.len(), theirs.len());
        return Err(format!("there are {theirs} answers to {ours} states"));
    }
    let mut worst = 0.0_f64;
    for (index, (ours, theirs)) in ours.iter().zip(theirs).enumerate() {
        let difference = relative(ours, theirs);
        // A difference that is not a number is refused with those that are too great.
        if difference.is_nan() || difference > BOUND {
            return Err(format!(
                "the accelerations at state {index} differ by {difference:.1e}: {ours:?}, {theirs:?}"
            ));
        }
        worst = worst.max(difference);
    }
    Ok(worst)
}

fn relative(ours: &[f64], theirs: &[f64]) -> f64 {
    if ours.len() != theirs.len() {
        return f64::NAN;
    }
    let apart = ours.iter().zip(theirs).map(|(a, b)| a - b);
    norm(apart) / norm(ours.iter().copied()).max(1.0)
}

fn norm(components: impl Iterator<Item = f64>) -> f64 {
    components.map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::difference;

    fn rows(last: f64) -> Vec<Vec<f64>> {
        vec![vec![1.0, 2.0], vec![3.0, last]]
    }

    #[test]
    fn rounding_is_measured() {
        let difference = difference(&rows(4.0), &rows(4.0 + 1e-12)).unwrap();
        assert!((1e-13..3e-13).contains(&difference), "{difference}");
    }

    #[test]
    fn what_is_not_rounding_is_refused() {
        for wrong in [4.0 + 1e-7, -4.0, f64::NAN, f64::INFINITY] {
            assert!(difference(&rows(4.0), &rows(wrong)).is_err(), "{wrong}");
        }
    }

    #[test]
    fn missing_answers_are_refused() {
        assert!(difference(&rows(4.0), &rows(4.0)[..1]).is_err());
        assert!(difference(&rows(4.0), &[vec![1.0], vec![3.0]]).is_err());
    }
}
