//! The sphere that fits points best, against spheres that were calculated with 50 digits.
use ciklo::engine::geometry::FitError;
use ciklo::engine::sphere::fit_sphere;
use glam::DVec3;

/// Spheres with 50 digits, calculated by `tests/references/sphere_fits.py`.
#[test]
fn fits_equal_the_references() {
    let text = include_str!("../references/sphere_fits.txt");
    let mut compared = 0;
    for line in text.lines().filter(|line| !line.starts_with('#') && !line.is_empty()) {
        let (points, wanted) = line.split_once('|').expect("points and sphere");
        let numbers =
            |text: &str| -> Vec<f64> { text.split_whitespace().map(|word| word.parse().expect("a number")).collect() };
        let points: Vec<DVec3> = numbers(points).chunks(3).map(DVec3::from_slice).collect();
        let wanted = numbers(wanted);
        let found = fit_sphere(&points).unwrap_or_else(|error| panic!("{error:?}: {line}"));
        let off = (found.centre - DVec3::from_slice(&wanted)).length().max((found.radius - wanted[3]).abs());
        assert!(off < 1e-9, "{off}: {line}");
        compared += 1;
    }
    assert!(compared >= 60, "{compared}");
}

#[test]
fn points_that_determine_no_sphere_are_refused() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y];
    assert_eq!(fit_sphere(&square), Err(FitError::Collinear));
    assert_eq!(fit_sphere(&square[..3]), Err(FitError::TooFew));
    assert_eq!(fit_sphere(&[DVec3::ONE; 4]), Err(FitError::Collinear));
    assert_eq!(fit_sphere(&[DVec3::X * f64::NAN; 4]), Err(FitError::NotFinite));
}
