//! The contact of a stylus shaft: a cylinder with round ends that moves without turning.
//!
//! Invariant: the shaft is all balls of its radius whose centres lie on its axis. A stretch of the axis is free if one ball
//! that holds the whole stretch is; it touches if the ball in its middle does. What is decided is exact; a shaft that comes
//! closer than [`NEAR`] without a ball of it touching counts as touching, so that no contact is ever missed.
use super::SolidError;
use super::body::Body;
use super::contact::Contact;
use super::path::Path;
use glam::DVec3;

/// A shaft that comes closer than this, in mm, counts as touching.
const NEAR: f64 = 1e-6;

impl Body {
    /// A place where a shaft touches while the lower end of its axis moves along a path; nothing if it stays free. It need
    /// not be the first one. `axis` leads from the lower end to the upper one.
    ///
    /// # Errors
    /// As for [`Body::first_contact_on`].
    pub fn shaft_contact(&self, radius: f64, axis: DVec3, path: &Path) -> Result<Option<Contact>, SolidError> {
        if !(radius.is_finite() && radius > 0.0 && axis.is_finite() && path.is_finite()) {
            return Err(SolidError::NotFinite);
        }
        let length = axis.length();
        let mut open = vec![(0.0, 1.0)];
        while let Some((low, high)) = open.pop() {
            let middle = f64::midpoint(low, high);
            let way = path.moved(axis * middle);
            let around = libm::hypot(radius, 0.5 * (high - low) * length);
            let around = match self.first_contact_on(around, &way) {
                Ok(None) => continue,
                Ok(Some(contact)) if around - radius < NEAR => return Ok(Some(contact)),
                Err(error) if around - radius < NEAR => return Err(error),
                // The smaller balls of its halves may be free, or beyond the trouble.
                Ok(Some(_)) | Err(_) => self.first_contact_on(radius, &way),
            };
            if let Ok(Some(contact)) = around {
                return Ok(Some(contact));
            }
            open.extend([(middle, high), (low, middle)]);
        }
        Ok(None)
    }
}
