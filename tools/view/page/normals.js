// Computes the normals of a cloud from the spread of the points around each, in small cells with
// their neighbours.

const kCellsAlongScene = 160;

/// @return a Float32Array of unit normals that point to the viewpoint; zero if too few points are
/// near
export function normalsOf(positions, viewpoint) {
  const cell = cellSize(positions);
  const key = (p) => Math.floor(positions[p] / cell) * 73856093 ^ Math.floor(positions[p + 1] / cell) * 19349663 ^
    Math.floor(positions[p + 2] / cell) * 83492791;
  const cells = new Map();
  for (let p = 0; p < positions.length; p += 3) add(cells, key(p), positions, p);
  const normals = new Float32Array(positions.length);
  const made = new Map();
  for (let p = 0; p < positions.length; p += 3) {
    const k = key(p);
    if (!made.has(k)) made.set(k, normalOf(around(cells, positions, p, cell)));
    orient(made.get(k), positions, viewpoint, p, normals);
  }
  return normals;
}

function cellSize(positions) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return Math.max(Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / kCellsAlongScene, 1e-6);
}

/// Adds 1, x, y, z and their products to the sums of a cell.
function add(cells, key, positions, p) {
  let sums = cells.get(key);
  if (!sums) cells.set(key, sums = new Float64Array(10));
  const x = positions[p], y = positions[p + 1], z = positions[p + 2];
  [1, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z].forEach((value, i) => { sums[i] += value; });
}

function around(cells, positions, p, cell) {
  const total = new Float64Array(10);
  const [i, j, k] = [0, 1, 2].map((axis) => Math.floor(positions[p + axis] / cell));
  for (let a = -1; a <= 1; ++a) for (let b = -1; b <= 1; ++b) for (let c = -1; c <= 1; ++c) {
    const sums = cells.get((i + a) * 73856093 ^ (j + b) * 19349663 ^ (k + c) * 83492791);
    if (sums) for (let n = 0; n < 10; ++n) total[n] += sums[n];
  }
  return total;
}

/// Returns the direction of least spread, by repeatedly squaring (trace - covariance) until that
/// direction dominates.
function normalOf(s) {
  const n = s[0];
  if (n < 5) return [0, 0, 0];
  const [x, y, z] = [s[1] / n, s[2] / n, s[3] / n];
  let m = [s[4] / n - x * x, s[5] / n - x * y, s[6] / n - x * z, s[7] / n - y * y, s[8] / n - y * z, s[9] / n - z * z];
  const trace = m[0] + m[3] + m[5];
  m = [trace - m[0], -m[1], -m[2], trace - m[3], -m[4], trace - m[5]];
  for (let i = 0; i < 8; ++i) {
    const [a, b, c, d, e, f] = m;
    m = [a * a + b * b + c * c, a * b + b * d + c * e, a * c + b * e + c * f, b * b + d * d + e * e,
      b * c + d * e + e * f, c * c + e * e + f * f];
    const scale = 1 / Math.max(m[0] + m[3] + m[5], 1e-300);
    m = m.map((value) => value * scale);
  }
  const columns = [[m[0], m[1], m[2]], [m[1], m[3], m[4]], [m[2], m[4], m[5]]];
  const best = columns.reduce((a, b) => (Math.hypot(...a) > Math.hypot(...b) ? a : b));
  const length = Math.hypot(...best);
  return length > 0 ? best.map((value) => value / length) : [0, 0, 0];
}

function orient(normal, positions, viewpoint, p, normals) {
  let towards = 0;
  for (let i = 0; i < 3; ++i) towards += normal[i] * (viewpoint[i] - positions[p + i]);
  for (let i = 0; i < 3; ++i) normals[p + i] = towards < 0 ? -normal[i] : normal[i];
}
