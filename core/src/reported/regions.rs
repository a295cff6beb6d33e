//! Roughly where a station is, by the first letters of its name.

use super::Place;

/// Letters that names of stations in a region begin with, and a place in its middle, degrees north and east. After ICAO
/// Doc 7910, *Location Indicators*; two letters stand before one.
const REGIONS: &[(&str, [f64; 2])] = &[
    ("BG", [68.0, -50.0]),
    ("BI", [64.5, -19.0]),
    ("NZ", [-41.0, 174.0]),
    ("PA", [62.0, -150.0]),
    ("PG", [14.0, 145.0]),
    ("PH", [21.0, -157.5]),
    ("RC", [24.0, 121.0]),
    ("RJ", [36.0, 138.0]),
    ("RK", [36.5, 127.5]),
    ("RO", [26.5, 128.0]),
    ("RP", [13.0, 122.0]),
    ("UA", [48.0, 68.0]),
    ("UE", [64.0, 130.0]),
    ("UH", [50.0, 138.0]),
    ("UI", [55.0, 105.0]),
    ("UN", [56.0, 88.0]),
    ("US", [57.0, 62.0]),
    ("UT", [40.0, 66.0]),
    ("VH", [22.3, 114.0]),
    ("VT", [14.0, 101.0]),
    ("VV", [16.0, 107.0]),
    ("A", [-6.0, 150.0]),
    ("C", [50.0, -95.0]),
    ("D", [20.0, 3.0]),
    ("E", [54.0, 12.0]),
    ("F", [-16.0, 25.0]),
    ("G", [17.0, -12.0]),
    ("H", [10.0, 36.0]),
    ("K", [39.0, -97.0]),
    ("L", [43.0, 12.0]),
    ("M", [18.0, -88.0]),
    ("N", [-18.0, -172.0]),
    ("O", [30.0, 50.0]),
    ("S", [-20.0, -60.0]),
    ("T", [16.0, -63.0]),
    ("U", [53.0, 40.0]),
    ("V", [22.0, 79.0]),
    ("W", [-2.0, 110.0]),
    ("Y", [-26.0, 135.0]),
    ("Z", [35.0, 110.0]),
];

/// In the middle of the region that the station's name begins with, often 1,000 km off: enough for the hour and the height
/// of the sun. None of a name that no region has.
pub fn roughly(station: &str) -> Option<Place> {
    let (_, [latitude_deg, longitude_deg]) = REGIONS.iter().find(|(letters, _)| station.starts_with(letters))?;
    Some(Place { latitude_deg: *latitude_deg, longitude_deg: *longitude_deg })
}
