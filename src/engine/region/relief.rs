//! Areas with depths of their own: how deep each place is machined, and how high what stays there may be.
//!
//! A relief is cut into layers from the surface down. In each of them is known what of the plane a pocket takes away,
//! and what an island keeps where the relief is taken off another one. A contour without a depth of its own is a pocket
//! as deep as all, and an island up to the surface (TNC 640 manual, lines 5931-5933). Invariant: the layers of a relief
//! lie on each other without a gap, what a pocket takes away never grows downwards, and what an island keeps never
//! grows upwards.
use super::Region;

/// Areas that differ by less, mm², are one.
const SAME_AREA: f64 = 1e-6;
/// Depths that differ by less, mm, are one.
const SAME_DEPTH: f64 = 1e-6;

/// What two reliefs become.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `&`: what belongs to both.
    And,
    /// `|`: what belongs to one of them or both.
    Or,
    /// `^`, also `|\`: what belongs to one of them only.
    Xor,
    /// `\`: the first without the second, which is an island.
    Without,
}

/// A layer, down to a depth below the surface, mm; the last one of a relief is endless.
#[derive(Clone, Debug)]
struct Layer {
    to: f64,
    /// What is taken away there.
    pocket: Region,
    /// What stays there where the relief is an island.
    island: Region,
}

/// Areas of which each has a depth.
#[derive(Clone, Debug)]
pub struct Relief {
    layers: Vec<Layer>,
    /// Of how many contours it consists.
    pub contours: usize,
    /// How many elements these have.
    pub elements: usize,
}

/// What is machined between two depths below the surface, mm.
#[derive(Clone, Debug)]
pub struct Band {
    /// Where it begins.
    pub from: f64,
    /// Where its floor is.
    pub to: f64,
    /// What is machined there.
    pub region: Region,
}

impl Relief {
    /// An area with so many elements, with a depth of its own (mm, positive) or without one.
    pub fn new(area: Region, elements: usize, depth: Option<f64>) -> Self {
        let endless = |pocket, island| Layer { to: f64::INFINITY, pocket, island };
        let layers = match depth {
            None => vec![endless(area.clone(), area)],
            Some(to) => {
                let above = Layer { to, pocket: area.clone(), island: Region::default() };
                vec![above, endless(Region::default(), area)]
            }
        };
        Self { layers, contours: 1, elements }
    }

    /// What this one and another one become.
    pub fn joined(&self, operator: Operator, other: &Self) -> Self {
        let (own, foreign) = (self.area(), other.area());
        let mut depths: Vec<f64> = self.layers.iter().chain(&other.layers).map(|layer| layer.to).collect();
        depths.sort_by(f64::total_cmp);
        depths.dedup_by(|a, b| a == b || (*a - *b).abs() <= SAME_DEPTH);
        let layer = |to: f64| {
            let (a, b) = (self.layer(to), other.layer(to));
            let join = |a: &Region, b: &Region, kept: &Region| match operator {
                Operator::And => a.intersection(b),
                Operator::Or => a.union(b),
                Operator::Xor => a.difference(&foreign).union(&b.difference(&own)),
                Operator::Without => a.difference(kept),
            };
            Layer { to, pocket: join(&a.pocket, &b.pocket, &b.island), island: join(&a.island, &b.island, &b.pocket) }
        };
        let layers = depths.into_iter().map(layer).collect();
        Self { layers, contours: self.contours + other.contours, elements: self.elements + other.elements }
    }

    /// What it covers, however deep.
    fn area(&self) -> Region {
        match self.layers.as_slice() {
            [only] => only.pocket.clone(),
            [first, .., last] => first.pocket.union(&last.island),
            [] => Region::default(),
        }
    }

    /// The layer in which a depth lies, or that ends there.
    fn layer(&self, depth: f64) -> &Layer {
        let found = self.layers.iter().position(|layer| layer.to >= depth - SAME_DEPTH);
        &self.layers[found.unwrap_or(self.layers.len() - 1)]
    }

    /// The greatest depth of its own that a contour has.
    pub fn deepest(&self) -> f64 {
        self.layers.iter().map(|layer| layer.to).filter(|to| to.is_finite()).fold(0.0, f64::max)
    }

    /// What is machined down to a depth, from above; layers in which the same is machined are one.
    pub fn bands(&self, depth: f64) -> Vec<Band> {
        let mut bands: Vec<Band> = Vec::with_capacity(self.layers.len());
        let mut from = 0.0;
        for layer in self.layers.iter().filter(|layer| !layer.pocket.is_empty()) {
            let to = layer.to.min(depth);
            if to - from <= SAME_DEPTH {
                continue;
            }
            match bands.last_mut() {
                Some(last) if (last.region.area() - layer.pocket.area()).abs() <= SAME_AREA => last.to = to,
                _ => bands.push(Band { from, to, region: layer.pocket.clone() }),
            }
            from = to;
        }
        bands
    }
}
