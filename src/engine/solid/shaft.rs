//! The contact of a stylus shaft: a cylinder with round ends that moves along a path or turns about an axis.
//!
//! Invariant: the shaft is all balls of its radius whose centres lie on its axis: a cylinder and the balls at its ends.
//! A stretch of the cylinder is free if one ball that holds the whole stretch is; it touches if the ball in its middle
//! does. What is decided is exact; a shaft that comes closer than [`NEAR`] without a ball of it touching counts as
//! touching, so that no contact is ever missed.
use super::SolidError;
use super::body::Body;
use super::contact::Contact;
use super::path::Path;

/// A shaft that comes closer than this, in mm, counts as touching.
const NEAR: f64 = 1e-6;

impl Body {
    /// A place where a shaft touches while it moves; nothing if it stays free. It need not be the first one. `way`
    /// says how a point of its axis moves: the one at 0 is the lower end, the one at 1 the upper end,
    /// `length` away from it.
    ///
    /// # Errors
    /// As for [`Body::first_contact_on`].
    pub fn shaft_contact(
        &self,
        radius: f64,
        length: f64,
        way: &dyn Fn(f64) -> Path,
    ) -> Result<Option<Contact>, SolidError> {
        self.shaft_contact_by(radius, length, &|radius, share| self.first_contact_on(radius, &way(share)))
    }

    /// The same for any movement: `touches` says whether a ball of a radius touches whose centre
    /// is that point of the axis.
    ///
    /// # Errors
    /// Those of `touches`, where no smaller stretch decides.
    pub fn shaft_contact_by(
        &self,
        radius: f64,
        length: f64,
        touches: &dyn Fn(f64, f64) -> Result<Option<Contact>, SolidError>,
    ) -> Result<Option<Contact>, SolidError> {
        if !(radius.is_finite() && radius > 0.0 && length.is_finite()) {
            return Err(SolidError::NotFinite);
        }
        for end in [0.0, 1.0] {
            if let Some(contact) = touches(radius, end)? {
                return Ok(Some(contact));
            }
        }
        let mut open = vec![(0.0, 1.0)];
        while let Some((low, high)) = open.pop() {
            let middle = f64::midpoint(low, high);
            let around = libm::hypot(radius, 0.5 * (high - low) * length);
            let around = match touches(around, middle) {
                Ok(None) => continue,
                Ok(Some(contact)) if around - radius < NEAR => return Ok(Some(contact)),
                Err(error) if around - radius < NEAR => return Err(error),
                // The smaller balls of its halves may be free, or beyond the trouble.
                Ok(Some(_)) | Err(_) => touches(radius, middle),
            };
            if let Ok(Some(contact)) = around {
                return Ok(Some(contact));
            }
            open.extend([(middle, high), (low, middle)]);
        }
        Ok(None)
    }
}
