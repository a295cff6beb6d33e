//! Our tiles in other sheets of four by four, and back.

/// Columns and rows of our sheet.
const SIDE: usize = 4;
/// Texture coordinates that differ by less are taken for one.
const SAME: f32 = 0.01;

/// Left, top, right and bottom of a tile, in shares of the sheet from its top left.
pub(super) fn edges(tile: u8) -> [f32; 4] {
    let (column, row) = (usize::from(tile) % SIDE, usize::from(tile) / SIDE);
    [column, row, column + 1, row + 1].map(|at| at as f32 / SIDE as f32)
}

/// The tile in which the middle of these edges lies, and whether they are its own.
pub(super) fn of_edges([left, top, right, bottom]: [f32; 4]) -> (u8, bool) {
    let along = |from: f32, to: f32| ((0.5 * (from + to) * SIDE as f32).floor().clamp(0.0, (SIDE - 1) as f32)) as usize;
    let tile = (along(top, bottom) * SIDE + along(left, right)) as u8;
    let alike = edges(tile).iter().zip([left, top, right, bottom]).all(|(own, edge)| (own - edge).abs() < SAME);
    (tile, alike)
}

/// The tile of ours that lies where the tile of that number lies on a sheet of so many columns and rows.
pub(super) fn of_sheet(number: usize, columns: usize, rows: usize) -> (u8, bool) {
    let (columns, rows) = (columns.max(1), rows.max(1));
    let (column, row) = (number % columns, (number / columns).min(rows - 1));
    let share = |at: usize, of: usize| at as f32 / of as f32;
    of_edges([share(column, columns), share(row, rows), share(column + 1, columns), share(row + 1, rows)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        for tile in 0..16 {
            assert_eq!(of_edges(edges(tile)), (tile, true));
            assert_eq!(of_sheet(tile.into(), 4, 4), (tile, true));
        }
        assert_eq!(of_edges([0.3, 0.0, 0.4, 0.2]), (1, false), "a part of a tile");
        assert_eq!(of_edges([-9.0, 9.0, -8.0, 10.0]), (12, false), "beside the sheet");
        assert_eq!(of_sheet(1, 2, 2), (7, false), "the right upper quarter: its middle");
        assert_eq!(of_sheet(usize::MAX, 0, 0).0, 10);
    }
}
