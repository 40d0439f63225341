//! Slips of the keyboard: a value in place of the one that was meant.

/// Whether somebody who means a value may have written another one: with another sign, with the decimal point one or two
/// places away, or with two neighbouring digits exchanged.
pub fn is_slip(written: f64, meant: f64) -> bool {
    let near = |one: f64, other: f64| (one - other).abs() <= 1e-9 * other.abs();
    if written == 0.0 || meant == 0.0 {
        return false;
    }
    let factor = [10.0, 0.1, 100.0, 0.01].iter().any(|factor| near(written, meant * factor));
    near(written, -meant) || factor || exchanged(written, meant)
}

/// Whether two neighbouring digits are exchanged.
fn exchanged(one: f64, other: f64) -> bool {
    let (one, other) = (one.to_string(), other.to_string());
    let differ: Vec<usize> =
        one.bytes().zip(other.bytes()).enumerate().filter(|(_, (a, b))| a != b).map(|own| own.0).collect();
    let ([first, second], true) = (differ.as_slice(), one.len() == other.len()) else { return false };
    let at = |text: &str, place: usize| text.as_bytes().get(place).copied();
    second - first == 1 && at(&one, *first) == at(&other, *second) && at(&one, *second) == at(&other, *first)
}
