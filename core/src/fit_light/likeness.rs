//! How near pictures come to wanted ones.

/// How near the sprites' light comes to the path tracer's, over all views, by all hours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Likeness {
    /// The root of the mean square of the difference, of the sky's light and of the sun's each by itself, as a share of that
    /// of the wanted lights; 0 is the same. It is what the fit makes least.
    pub error: f64,
    /// How the sprites' light goes with the wanted one from place to place within an hour, on average over the hours: 1 is
    /// the same but for a scale and an offset, 0 has nothing to do with it.
    pub correlation: f64,
}

/// Weighted sums over one hour's pixels.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Pairs {
    weight: f64,
    shown: f64,
    wanted: f64,
    shown_2: f64,
    wanted_2: f64,
    both: f64,
    /// Of each light by itself: squares of differences, and of what is wanted.
    apart: f64,
    each_wanted: f64,
}

impl Pairs {
    /// A pixel: the sky's light and the sun's, each as it shows and as it is wanted.
    pub(super) fn add(&mut self, lights: [[f64; 2]; 2], weight: f64) {
        let [shown, wanted] = [0, 1].map(|which| lights[0][which] + lights[1][which]);
        for [shown, wanted] in lights {
            self.apart += weight * (shown - wanted) * (shown - wanted);
            self.each_wanted += weight * wanted * wanted;
        }
        self.weight += weight;
        self.shown += weight * shown;
        self.wanted += weight * wanted;
        self.shown_2 += weight * shown * shown;
        self.wanted_2 += weight * wanted * wanted;
        self.both += weight * shown * wanted;
    }

    pub(super) fn joined(self, other: Self) -> Self {
        Self {
            weight: self.weight + other.weight,
            shown: self.shown + other.shown,
            wanted: self.wanted + other.wanted,
            shown_2: self.shown_2 + other.shown_2,
            wanted_2: self.wanted_2 + other.wanted_2,
            both: self.both + other.both,
            apart: self.apart + other.apart,
            each_wanted: self.each_wanted + other.each_wanted,
        }
    }

    /// By how much brighter what shows is than what is wanted; 1 where nothing is wanted.
    pub(super) fn brightness(all: &[Self]) -> f64 {
        let [shown, wanted] = all.iter().fold([0.0, 0.0], |[a, b], one| [a + one.shown, b + one.wanted]);
        if shown > 0.0 && wanted > 0.0 { shown / wanted } else { 1.0 }
    }

    /// Pearson's; 0 where either is even.
    fn correlation(&self) -> f64 {
        let spread = |sum: f64, sum_2: f64| (self.weight * sum_2 - sum * sum).max(0.0);
        let together = self.weight * self.both - self.shown * self.wanted;
        let apart = (spread(self.shown, self.shown_2) * spread(self.wanted, self.wanted_2)).sqrt();
        if apart > 1e-12 * self.weight * self.weight { together / apart } else { 0.0 }
    }
}

impl Likeness {
    /// Of the hours.
    pub(super) fn of(hours: &[Pairs]) -> Self {
        let difference: f64 = hours.iter().map(|hour| hour.apart).sum();
        let wanted: f64 = hours.iter().map(|hour| hour.each_wanted).sum();
        Self {
            error: if wanted > 0.0 { (difference / wanted).sqrt() } else { 0.0 },
            correlation: hours.iter().map(Pairs::correlation).sum::<f64>() / hours.len().max(1) as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_pictures_that_differ_by_a_scale() {
        let mut hour = Pairs::default();
        for (wanted, weight) in [(1.0, 1.0), (2.0, 0.5), (4.0, 0.25)] {
            hour.add([[0.5 * wanted, 0.0], [wanted, wanted]], weight);
        }
        let likeness = Likeness::of(&[hour]);
        assert!((likeness.error - 0.5).abs() < 1e-12 && (likeness.correlation - 1.0).abs() < 1e-12, "{likeness:?}");
        assert_eq!(Likeness::of(&[]), Likeness { error: 0.0, correlation: 0.0 });
    }
}
