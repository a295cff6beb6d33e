// The sun's light that comes through a cloud: which baked directions lie around it, and what is left at a point. The twin
// of core/src/baked/ and core/src/shading/through.rs.

/** Numbers of three directions around one that is given in a model's space, and their shares. */
function around([x, y, z]) {
  const n = HEADER.constants.BAKED_PARTS;
  const above = unit_or([x, Math.max(y, 0), z], [0, 1, 0]);
  const flat = scaled(above, n / (Math.abs(above[0]) + above[1] + Math.abs(above[2])));
  const [across, along] = [Math.min(Math.abs(flat[0]), n), Math.min(Math.abs(flat[2]), n)];
  const [column, row] = [across, along].map((parts) => Math.min(Math.floor(parts), n - 1));
  const [right, down] = [across - column, along - row];
  const number = (dx, dz) => {
    const whole = clamp((column + dx) * (flat[0] < 0 ? -1 : 1), -n, n);
    const width = n - Math.abs(whole);
    const before = whole <= 0 ? (whole + n) ** 2 : 2 * n * n + 2 * n + 1 - (n - whole + 1) ** 2;
    return before + clamp((row + dz) * (flat[2] < 0 ? -1 : 1), -width, width) + width;
  };
  return right + down <= 1
    ? { at: [number(0, 0), number(1, 0), number(0, 1)], shares: [1 - right - down, right, down] }
    : { at: [number(1, 1), number(0, 1), number(1, 0)], shares: [right + down - 1, 1 - right, 1 - down] };
}

/** How a cloud is lit besides by its groups; null if it is not. */
function soft_light(clouds, cloud) {
  const [first, self_shadow, halo, , sin, cos] = clouds.subarray(CLOUD_NUMBERS * cloud + 32, CLOUD_NUMBERS * cloud + 38);
  return self_shadow > 0 || halo > 0 ? { first, self_shadow, halo, sin, cos } : null;
}

/** A direction at rest as it lies in the model's space. */
const in_model = ({ sin, cos }, [x, y, z]) => [cos * x - sin * z, y, sin * x + cos * z];

/** Ambient and directional light within a cloud in place of those by level and group, at `offset` from a sprite's middle, in
 * its reaches; the halo is the mean of all around. */
function through(scene, soft, sprite, offset, sun, c_max, [ambient, directional], shade) {
  const { SCATTERED, STRAIGHT, SKY_KEPT_OUT, FROM_BELOW, HALO } = HEADER.constants;
  const base = BAKED_WORDS * (soft.first + sprite);
  const left = (direction) => {
    const word = scene.baked[base + direction];
    const part = (i) => ((word << (24 - 8 * i)) >> 24) / 127;
    return (word & 255) / 255 + part(1) * offset[0] + part(2) * offset[1] + part(3) * offset[2];
  };
  const { at, shares } = around(sun);
  const from_sun = clamp(shares.reduce((sum, share, i) => sum + share * left(at[i]), 0), 0, 1) * shade;
  const open = (direction) => Math.sqrt(clamp(left(direction), 0, 1));
  const let_through = c_max * (SCATTERED * from_sun + STRAIGHT * from_sun ** 8);
  const closed = 1 - (1 - FROM_BELOW) * open(BAKED_UP) - FROM_BELOW * open(BAKED_DOWN);
  return [
    ambient * (1 - soft.self_shadow * SKY_KEPT_OUT * closed),
    directional * (1 - soft.self_shadow) + soft.self_shadow * let_through
      + (soft.halo * HALO * from_sun ** 4) / (4 * Math.PI),
  ];
}
