//! A stretch of the motion with one sign of the friction: points of a rule, and the solution at them.
//!
//! With u = θ'²/E over ψ the equation of motion is du/dψ = p u + f, where with σ = S μ
//! p = 2 (ρ + σ k) k / (i + ρ² + σ k ρ) and f dψ = 2 dθ / (i + ρ² + σ k ρ). Its solution is
//! u = e^Λ (u₀ + J) with Λ = ∫ p and J = ∫ e^(−Λ) f. The first has no closed form that would be worth its price
//! (powers with complex exponents), the second has none.

use super::arc::Circle;
use super::exponential::exponentials;
use super::rule::{POINTS, Row, Rule, dot};

/// How the rule's interval lies on the axis of w.
#[derive(Clone, Copy, Debug)]
pub(super) enum Spread {
    /// Evenly.
    Even,
    /// As the square of the distance from the upper end, where the motion starts from rest: there √u is linear.
    FromRest,
}

/// Where the points of a stretch are, by rising w.
#[derive(Clone, Debug)]
pub(super) struct Points {
    /// Least w.
    pub low: f64,
    /// Greatest w.
    pub high: f64,
    pub spread: Spread,
    /// ρ.
    pub lead: Row,
    /// k.
    pub slide: Row,
    /// ψ per unit of the rule.
    stretch: Row,
    /// θ per unit of the rule.
    pub angle: Row,
}

/// The solution with one sign over a stretch, from its lower end.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    /// e^Λ at the points.
    pub growth: Row,
    /// J at the points.
    pub drive: Row,
    /// e^Λ at the upper end.
    pub growth_end: f64,
    /// J at the upper end.
    pub drive_end: f64,
    /// Λ at the upper end.
    pub exponent: f64,
}

impl Points {
    pub fn new(circle: &Circle, rule: &Rule, low: f64, high: f64, spread: Spread) -> Self {
        let mut points =
            Self { low, high, spread, lead: [0.0; _], slide: [0.0; _], stretch: [0.0; _], angle: [0.0; _] };
        let half = (high - low) / 2.0;
        let (mut places, mut rates) = ([0.0; POINTS], [half; POINTS]);
        match spread {
            Spread::Even => places = rule.points.map(|s| low + half * (1.0 + s)),
            Spread::FromRest => {
                for ((place, rate), &s) in places.iter_mut().zip(&mut rates).zip(&rule.points) {
                    (*place, *rate) = (points.at(s), half * (1.0 - s));
                }
            }
        }
        for index in 0..POINTS {
            let place = circle.place(places[index]);
            points.lead[index] = place.lead;
            points.slide[index] = place.slide;
            points.stretch[index] = place.stretch * rates[index];
            points.angle[index] = place.stretch * rates[index] / place.turning();
        }
        points
    }

    /// w at s between −1 and 1.
    pub fn at(&self, s: f64) -> f64 {
        match self.spread {
            Spread::Even => self.low + (self.high - self.low) * ((1.0 + s) / 2.0),
            Spread::FromRest => self.high - (self.high - self.low) * ((1.0 - s) / 2.0) * ((1.0 - s) / 2.0),
        }
    }

    /// What each point counts at w.
    pub fn shares(&self, rule: &Rule, w: f64) -> Row {
        let width = self.high - self.low;
        rule.shares(match self.spread {
            Spread::Even => (w - self.low - (self.high - w)) / width,
            Spread::FromRest => 1.0 - 2.0 * ((self.high - w) / width).max(0.0).sqrt(),
        })
    }

    /// dt per unit of the rule, at the points, where the unit of time is 1/√E, from u at them.
    pub fn rates(&self, squares: &Row) -> Row {
        let mut rates = self.angle;
        for (rate, square) in rates.iter_mut().zip(squares) {
            *rate /= square.sqrt();
        }
        rates
    }

    /// i + ρ² + σ k ρ at the points.
    fn inert(&self, inertia: f64, sigma: f64) -> Row {
        let mut inert = [0.0; _];
        for ((inert, lead), slide) in inert.iter_mut().zip(&self.lead).zip(&self.slide) {
            *inert = inertia + lead * (lead + sigma * slide);
        }
        inert
    }

    /// The solution with the friction σ = S μ.
    pub fn branch(&self, rule: &Rule, inertia: f64, sigma: f64) -> Branch {
        let (mut rate, mut force) = ([0.0; _], self.inert(inertia, sigma));
        for index in 0..rate.len() {
            let (lead, slide) = (self.lead[index], self.slide[index]);
            let scale = 2.0 / force[index];
            rate[index] = scale * (lead + sigma * slide) * slide * self.stretch[index];
            force[index] = scale * self.angle[index];
        }
        let (exponents, exponent) = rule.cumulative(&rate);
        let growth = exponentials(&exponents);
        let [growth_end] = exponentials(&[exponent]);
        for (force, growth) in force.iter_mut().zip(&growth) {
            *force /= growth;
        }
        let (drive, drive_end) = rule.cumulative(&force);
        Branch { growth, drive, growth_end, drive_end, exponent }
    }

    /// p with the plus sign less p with the minus sign, per unit of the rule: 4 μ i k²/(A₊ A₋) without cancellation.
    pub fn gap(&self, inertia: f64, friction: f64) -> Row {
        let (plus, minus) = (self.inert(inertia, friction), self.inert(inertia, -friction));
        let mut gap = [0.0; _];
        for (index, gap) in gap.iter_mut().enumerate() {
            let slide = self.slide[index];
            *gap = (4.0 * friction * inertia) * (slide * slide) * self.stretch[index] / (plus[index] * minus[index]);
        }
        gap
    }
}

impl Branch {
    /// The square's change over a stretch: u at the points and at the end, from u at the start.
    pub fn motion(&self, mirrored: bool, start: f64) -> (Row, f64) {
        if mirrored {
            (self.squares_of_approach(start), self.approach(start))
        } else {
            (self.squares_up(start), self.up(start))
        }
    }

    /// u at the upper end, from u at the lower.
    pub fn up(&self, square: f64) -> f64 {
        self.growth_end * (square + self.drive_end)
    }

    /// u at the lower end, from u at the upper, for the mirror image: the approach to the line of centres.
    pub fn approach(&self, square: f64) -> f64 {
        square / self.growth_end + self.drive_end
    }

    /// u at the points, from u at the lower end.
    fn squares_up(&self, square: f64) -> Row {
        let mut squares = [0.0; _];
        for ((value, growth), drive) in squares.iter_mut().zip(&self.growth).zip(&self.drive) {
            *value = growth * (square + drive);
        }
        squares
    }

    /// u at the points for the mirror image, from u at the upper end.
    fn squares_of_approach(&self, square: f64) -> Row {
        let start = square / self.growth_end;
        let mut squares = [0.0; _];
        for ((value, growth), drive) in squares.iter_mut().zip(&self.growth).zip(&self.drive) {
            *value = growth * (start + (self.drive_end - drive));
        }
        squares
    }

    /// e^Λ and J between the points.
    pub fn between(&self, shares: &Row) -> (f64, f64) {
        (dot(shares, &self.growth), dot(shares, &self.drive))
    }
}
