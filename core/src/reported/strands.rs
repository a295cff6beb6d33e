//! Layers that go on: which layer of one sky is the same as one of the next.

use super::{Genus, PlannedLayer};

/// A layer of clouds through several skies.
#[derive(Debug, Clone, PartialEq)]
pub struct Strand {
    /// What it is in each of them; none where it is not there.
    pub at: Vec<Option<PlannedLayer>>,
}

/// Kinds of cloud that pass into one another, or are taken for one another.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Family {
    Heaps,
    Towers,
    LowSheets,
    MiddleSheets,
    High,
}

fn family(genus: Genus) -> Family {
    match genus {
        Genus::Cumulus | Genus::ToweringCumulus => Family::Heaps,
        Genus::Cumulonimbus => Family::Towers,
        Genus::Fog | Genus::Stratus | Genus::Stratocumulus | Genus::Nimbostratus => Family::LowSheets,
        Genus::Altocumulus | Genus::Altostratus => Family::MiddleSheets,
        Genus::Cirrus | Genus::Cirrostratus => Family::High,
    }
}

impl Strand {
    /// It at its largest, which has clouds enough for every sky; of equal ones the first.
    pub fn fullest(&self) -> Option<PlannedLayer> {
        let layers = self.at.iter().flatten();
        layers.copied().reduce(|most, next| if next.oktas > most.oktas { next } else { most })
    }

    /// How much of each sky it covers, eighths.
    pub fn oktas(&self) -> impl Iterator<Item = f64> {
        self.at.iter().map(|layer| layer.map_or(0.0, |layer| layer.oktas))
    }

    fn latest(&self) -> Option<&PlannedLayer> {
        self.at.iter().flatten().next_back()
    }
}

/// The layers of all `skies`, in order of their first appearance. A layer goes on as one of its family in the next sky: those
/// whose bases are nearest to each other first; none stands for two of one sky.
pub fn strands<'a>(skies: impl IntoIterator<Item = &'a [PlannedLayer]>) -> Vec<Strand> {
    let mut strands: Vec<Strand> = Vec::new();
    for (count, sky) in skies.into_iter().enumerate() {
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for (i, latest) in strands.iter().enumerate().filter_map(|(i, strand)| Some((i, strand.latest()?))) {
            let same = sky.iter().enumerate().filter(|(_, layer)| family(layer.genus) == family(latest.genus));
            pairs.extend(same.map(|(j, layer)| ((layer.base_m - latest.base_m).abs(), i, j)));
        }
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
        strands.iter_mut().for_each(|strand| strand.at.push(None));
        let mut goes_on = vec![false; sky.len()];
        for (_, i, j) in pairs {
            if !goes_on[j] && strands[i].at[count].is_none() {
                strands[i].at[count] = Some(sky[j]);
                goes_on[j] = true;
            }
        }
        let new = sky.iter().zip(goes_on).filter(|(_, goes_on)| !goes_on);
        strands.extend(new.map(|(layer, _)| {
            let mut at = vec![None; count];
            at.push(Some(*layer));
            Strand { at }
        }));
    }
    strands
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(genus: Genus, base_m: f64, oktas: f64) -> PlannedLayer {
        PlannedLayer { genus, cover: None, base_m, base_assumed: false, thickness_m: 500.0, oktas }
    }

    #[test]
    fn layers_go_on_as_the_nearest_of_their_kind() {
        let skies = [
            vec![layer(Genus::Cumulus, 900.0, 1.5), layer(Genus::Stratocumulus, 1800.0, 3.5)],
            vec![],
            vec![
                layer(Genus::Stratus, 300.0, 6.0),
                layer(Genus::ToweringCumulus, 1000.0, 3.5),
                layer(Genus::Stratocumulus, 1700.0, 8.0),
            ],
        ];
        let strands = strands(skies.iter().map(Vec::as_slice));
        let bases: Vec<Vec<Option<f64>>> =
            strands.iter().map(|strand| strand.at.iter().map(|layer| Some(layer.as_ref()?.base_m)).collect()).collect();
        assert_eq!(
            bases,
            [
                vec![Some(900.0), None, Some(1000.0)],
                vec![Some(1800.0), None, Some(1700.0)],
                vec![None, None, Some(300.0)]
            ]
        );
        assert_eq!(strands[0].fullest().map(|layer| layer.genus), Some(Genus::ToweringCumulus));
        assert_eq!(strands[1].oktas().collect::<Vec<_>>(), [3.5, 0.0, 8.0]);
    }
}
