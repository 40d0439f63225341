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

/// Whether two neighbouring digits are exchanged, be it across the decimal point.
pub(super) fn exchanged(one: f64, other: f64) -> bool {
    let (one, other) = (one.to_string(), other.to_string());
    if one.len() != other.len() || one.find('.') != other.find('.') {
        return false;
    }
    let digits = |text: &str| text.bytes().filter(|own| *own != b'.').collect::<Vec<_>>();
    let (one, other) = (digits(&one), digits(&other));
    let differ: Vec<usize> = (0..one.len()).filter(|at| one.get(*at) != other.get(*at)).collect();
    let [first, second] = differ.as_slice() else { return false };
    second - first == 1 && one.get(*first) == other.get(*second) && one.get(*second) == other.get(*first)
}
