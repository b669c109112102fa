// SPDX-License-Identifier: BSD-3-Clause
// Vectors of three numbers and matrices of 4 x 4, column after column, as WebGL takes them.

const add3 = (a, b, factor = 1) => [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
const dot3 = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross3 = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length3 = (a) => Math.hypot(a[0], a[1], a[2]);
const times3 = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
const unit3 = (a) => times3(a, 1 / (length3(a) || 1));
// Some unit vector across a.
function across3(a) {
  const size = a.map(Math.abs), least = size.indexOf(Math.min(...size));
  return unit3(cross3(a, [0, 1, 2].map((i) => (i === least ? 1 : 0))));
}

function multiply4(A, B) {
  const C = new Float32Array(16);
  for (let column = 0; column < 4; column++)
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += A[4 * k + row] * B[4 * column + k];
      C[4 * column + row] = sum;
    }
  return C;
}
const identity4 = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
// Three axes, each times its size, about an origin.
const frame4 = (axes, sizes, origin) => new Float32Array(
    [...times3(axes[0], sizes[0]), 0, ...times3(axes[1], sizes[1]), 0, ...times3(axes[2], sizes[2]), 0, ...origin, 1]);
const along4 = (axis, sizes, origin) => {
  const z = unit3(axis), x = across3(z);
  return frame4([x, cross3(z, x), z], sizes, origin);
};
// What reaches from a to b.
const rod4 = (a, b, diameter) =>
    along4(add3(b, a, -1), [diameter, diameter, length3(add3(b, a, -1))], times3(add3(a, b), 0.5));
// The pose of a body: x, and the rotation of a unit quaternion (w, x, y, z).
function pose4(x, [w, a, b, c]) {
  return new Float32Array([
    1 - 2 * (b * b + c * c), 2 * (a * b + c * w), 2 * (a * c - b * w), 0, 2 * (a * b - c * w), 1 - 2 * (a * a + c * c),
    2 * (b * c + a * w), 0, 2 * (a * c + b * w), 2 * (b * c - a * w), 1 - 2 * (a * a + b * b), 0, ...x, 1
  ]);
}
const apply4 = (M, p) => [0, 1, 2].map((row) => M[row] * p[0] + M[4 + row] * p[1] + M[8 + row] * p[2] + M[12 + row]);
// Seen from `eye`, looking at `target`, z upwards.
function view4(eye, target, up) {
  const z = unit3(add3(eye, target, -1)), x = unit3(cross3(up, z)), y = cross3(z, x);
  return new Float32Array(
      [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot3(x, eye), -dot3(y, eye), -dot3(z, eye), 1]);
}
function lens4(focus, aspect, near, far) {
  return new Float32Array([
    focus / aspect, 0, 0, 0, 0, focus, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
    (2 * far * near) / (near - far), 0
  ]);
}
