//! How far a GPU's picture may be from the plain renderer's, pixel by pixel, from how both round.
