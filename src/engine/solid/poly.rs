//! Real roots of polynomials of low degree in an interval.
//!
//! Invariant: a polynomial that changes its sign in the interval has a root reported there; roots come in
//! ascending order. Between two neighbouring critical points a polynomial is monotone, so bisection is safe.

/// The highest degree that occurs: a circular path against a circular edge.
pub(super) const MAX_DEGREE: usize = 8;

/// A polynomial; `0[k]` is the coefficient of the k-th power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Poly(pub(super) [f64; MAX_DEGREE + 1]);

impl Poly {
    pub(super) const ZERO: Self = Self([0.0; MAX_DEGREE + 1]);

    /// `a + b u + c u²`
    pub(super) fn quadratic(a: f64, b: f64, c: f64) -> Self {
        let mut out = Self::ZERO;
        out.0[0] = a;
        out.0[1] = b;
        out.0[2] = c;
        out
    }

    pub(super) fn scale(self, factor: f64) -> Self {
        Self(self.0.map(|c| c * factor))
    }

    pub(super) fn add(self, other: Self) -> Self {
        let mut out = self;
        for (a, b) in out.0.iter_mut().zip(other.0) {
            *a += b;
        }
        out
    }

    pub(super) fn sub(self, other: Self) -> Self {
        self.add(other.scale(-1.0))
    }

    /// The product; powers above [`MAX_DEGREE`] do not occur and are dropped.
    pub(super) fn mul(self, other: Self) -> Self {
        let mut out = Self::ZERO;
        let (own, others) = (self.0.iter().take(self.degree() + 1), other.0.iter().take(other.degree() + 1));
        for (i, a) in own.enumerate() {
            for (slot, b) in out.0.iter_mut().skip(i).zip(others.clone()) {
                *slot += a * b;
            }
        }
        out
    }

    pub(super) fn square(self) -> Self {
        self.mul(self)
    }

    fn derivative(&self) -> Self {
        let mut out = Self::ZERO;
        for (k, c) in self.0.iter().enumerate().skip(1) {
            if let Some(slot) = out.0.get_mut(k - 1) {
                *slot = c * k as f64;
            }
        }
        out
    }

    fn degree(&self) -> usize {
        self.0.iter().rposition(|c| *c != 0.0).unwrap_or(0)
    }

    /// The roots in `[low, high]`, ascending.
    pub(super) fn roots(&self, low: f64, high: f64) -> Vec<f64> {
        match self.degree() {
            0 => Vec::new(),
            1 => {
                let root = -self.0[0] / self.0[1];
                if (low..=high).contains(&root) { vec![root] } else { Vec::new() }
            }
            2 => self.quadratic_roots(low, high),
            _ => self.roots_between(&self.derivative().roots(low, high), low, high),
        }
    }

    /// The roots of a polynomial of the second degree, without cancellation.
    fn quadratic_roots(&self, low: f64, high: f64) -> Vec<f64> {
        let [c, b, a, ..] = self.0;
        let discriminant = b * b - 4.0 * a * c;
        if discriminant < 0.0 {
            return Vec::new();
        }
        let sum = -0.5 * (b + libm::copysign(libm::sqrt(discriminant), b));
        let (one, other) = if sum == 0.0 { (0.0, 0.0) } else { (sum / a, c / sum) };
        let mut roots = vec![one.min(other), one.max(other)];
        roots.dedup();
        roots.retain(|root| (low..=high).contains(root));
        roots
    }

    /// The roots, and the places where it turns: an equation that was squared touches zero there (a ball that
    /// moves along the axis of a cone) without changing its sign.
    pub(super) fn roots_and_extrema(&self, low: f64, high: f64) -> Vec<f64> {
        let mut all = self.derivative().roots(low, high);
        let roots =
            if self.degree() == 2 { self.quadratic_roots(low, high) } else { self.roots_between(&all, low, high) };
        all.extend(roots);
        all
    }

    /// The roots in the monotone stretches between the critical points.
    fn roots_between(&self, critical: &[f64], low: f64, high: f64) -> Vec<f64> {
        let mut roots: Vec<f64> = Vec::new();
        let mut from = low;
        for to in critical.iter().copied().chain([high]) {
            if let Some(root) = self.root_in(from, to)
                && roots.last().is_none_or(|last| root > *last)
            {
                roots.push(root);
            }
            from = to;
        }
        roots
    }

    /// The root of a monotone stretch: bisection, sped up by secants that stay inside (Illinois).
    fn root_in(&self, low: f64, high: f64) -> Option<f64> {
        let known = self.0.get(..=self.degree()).unwrap_or(&self.0);
        let at = |u: f64| known.iter().rev().fold(0.0, |sum, c| sum * u + c);
        let (mut a, mut b, mut fa, mut fb) = (low, high, at(low), at(high));
        if fa == 0.0 {
            return Some(a);
        }
        if fb == 0.0 {
            return Some(b);
        }
        if (fa > 0.0) == (fb > 0.0) {
            return None;
        }
        let mut side = 0;
        for round in 0..200 {
            let secant = (a * fb - b * fa) / (fb - fa);
            let bisect = round % 3 == 2 || !(secant > a && secant < b);
            let middle = if bisect { 0.5 * (a + b) } else { secant };
            if middle <= a || middle >= b {
                break;
            }
            let fm = at(middle);
            if fm == 0.0 {
                return Some(middle);
            }
            if (fm > 0.0) == (fa > 0.0) {
                (a, fa) = (middle, fm);
                fb = if side == -1 { fb * 0.5 } else { fb };
                side = -1;
            } else {
                (b, fb) = (middle, fm);
                fa = if side == 1 { fa * 0.5 } else { fa };
                side = 1;
            }
        }
        Some(0.5 * (a + b))
    }
}
