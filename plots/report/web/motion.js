// SPDX-License-Identifier: BSD-3-Clause
// Motions as the page holds them, and the parts of a mechanism that follow its bodies.

const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;

// The samples of a cell that the page holds.
class Motion {
  constructor(cell) {
    this.names = cell.bodies;
    this.t = new Float64Array(bytesOf(cell.t));
    this.x = new Float64Array(bytesOf(cell.x));
    this.q = cell.q === null ? null : new Int16Array(bytesOf(cell.q));
    this.v = cell.v === null ? null : new Float32Array(bytesOf(cell.v));
    this.end = this.t[this.t.length - 1];
  }
  position(body, i) {
    const at = 3 * (i * this.names.length + body);
    return [this.x[at], this.x[at + 1], this.x[at + 2]];
  }
  rotation(body, i) {
    const at = 4 * (i * this.names.length + body);
    return this.q ? [0, 1, 2, 3].map((k) => this.q[at + k] / 32767) : [1, 0, 0, 0];
  }
  // The instant before a time, and how far it is to the next one.
  instant(time) {
    let low = 0, high = this.t.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.t[middle] <= time) low = middle;
      else high = middle;
    }
    const part = high > low ? (time - this.t[low]) / (this.t[high] - this.t[low]) : 0;
    return [low, high, Math.min(Math.max(part, 0), 1)];
  }
  velocity(body, i) {
    const at = 3 * (i * this.names.length + body);
    return [this.v[at], this.v[at + 1], this.v[at + 2]];
  }
  // Between instants i and j, s of the time from one to the other, 0 < s < 1: by cubic Hermite interpolation of x and
  // v, or straight where these do not belong to one smooth arc, no longer than twice its chord.
  place(body, i, j, s) {
    const x = this.position(body, i), way = add3(this.position(body, j), x, -1), h = this.t[j] - this.t[i];
    if (this.v && h > 0) {
      const v = this.velocity(body, i), w = this.velocity(body, j);
      if (h * (length3(v) + length3(w)) < 4 * length3(way)) {
        const bent = add3(add3(x, way, s * s * (3 - 2 * s)), v, h * s * (1 - s) * (1 - s));
        return add3(bent, w, -h * s * s * (1 - s));
      }
    }
    return add3(x, way, s);
  }
  pose(body, time) {
    const [i, j, part] = this.instant(time), q = this.rotation(body, i), r = this.rotation(body, j);
    const mixed = q.map((value, k) => value + part * (r[k] - value)), size = Math.hypot(...mixed) || 1;
    return pose4(this.place(body, i, j, part), mixed.map((value) => value / size));
  }
  // The places of a body on its way, `pieces` from each instant to the next.
  trail(body, pieces) {
    const points = [...this.position(body, 0)];
    for (let i = 1; i < this.t.length; i++)
      for (let k = 1; k <= pieces; k++) points.push(...this.place(body, i - 1, i, k / pieces));
    return points;
  }
  // Whether some body turns by more than a third of a turn from an instant to the next.
  isCoarse() {
    for (let i = 1; this.q && i < this.t.length; i++)
      for (let body = 0; body < this.names.length; body++) {
        const q = this.rotation(body, i - 1), r = this.rotation(body, i);
        if (Math.abs(q[0] * r[0] + q[1] * r[1] + q[2] * r[2] + q[3] * r[3]) < 0.5) return true;
      }
    return false;
  }
}

// Distance of two motions over time: the norm over all bodies, at the instants that both have.
function distanceCurve(a, b) {
  const x = [], y = [];
  if (a.names.join() !== b.names.join()) return null;
  for (let i = 0, j = 0; i < a.t.length && j < b.t.length;) {
    const gap = a.t[i] - b.t[j];
    if (Math.abs(gap) > 1e-9 * (Math.abs(a.t[i]) + 1e-9)) {
      if (gap < 0) i++;
      else j++;
      continue;
    }
    let sum = 0;
    for (let body = 0; body < a.names.length; body++) {
      const d = length3(add3(a.position(body, i), b.position(body, j), -1));
      sum += d * d;
    }
    x.push(a.t[i]);
    y.push(Number.isFinite(sum) ? Math.sqrt(sum) : null);
    i++;
    j++;
  }
  return {label: '', style: 1, x, y};
}

// Whether a link is seen at one of its bodies: a force without a point of its own there is not.
const hasPlace = (link, side) => !link.force || length3(link.points[side]) > 0 ||
    ['spring', 'polynomial_spring', 'bushing'].includes(link.type) ||
    (link.type === 'attraction' && link.between[side] === 'ground');

// Parts of a mechanism about the frames of its bodies: "ground" or the index of a body, a matrix there, solid, colour.
function partsOf(mechanism, names, size) {
  const parts = [], springs = [], thin = 0.014 * size, ball = 0.034 * size;
  const home = (name) => (name === 'ground' ? 'ground' : names.indexOf(name));
  const known = new Map(((mechanism && mechanism.bodies) || []).map((body) => [body.name, body]));
  names.forEach((name, body) => {
    const shape = known.get(name);
    if (!shape || shape.shape === 'point')
      parts.push({
        at: body,
        solid: 'sphere',
        model: frame4([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [1.7, 1.7, 1.7].map((v) => v * ball), [0, 0, 0]),
        pattern: 2,
        body
      });
    else
      parts.push({
        at: body,
        solid: shape.shape,
        model: frame4(shape.axes, shape.sizes, [0, 0, 0]),
        pattern: {cylinder: 1, sphere: 2}[shape.shape] || 0,
        body
      });
  });
  for (const link of (mechanism && mechanism.links) || []) {
    if (['spring', 'polynomial_spring', 'distance'].includes(link.type))
      springs.push({link, ends: link.between.map(home)});
    link.between.map(home).forEach((at, side) => {
      if (at === -1 || !hasPlace(link, side)) return;
      const point = link.points[side], axis = link.axes[side],
            turns = ['revolute', 'cylindrical', 'universal'].includes(link.type);
      const colour = at === 'ground' ? 'ground' : 'joint';
      if (at !== 'ground' && length3(point) > 1e-9 * size)
        parts.push({at, solid: 'cylinder', model: rod4([0, 0, 0], point, thin), colour: 'joint'});
      if (at === 'ground')
        parts.push({
          at,
          solid: 'box',
          model: frame4([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [1.3 * ball, 1.3 * ball, 0.5 * ball], point),
          colour
        });
      else if (turns) parts.push({at, solid: 'cylinder', model: along4(axis, [ball, ball, 1.9 * ball], point), colour});
      else if (link.type === 'prismatic' || link.type === 'fixed')
        parts.push({at, solid: 'box', model: along4(axis || [0, 0, 1], [ball, ball, 1.9 * ball], point), colour});
      else if (link.type !== 'rolling')
        parts.push({at, solid: 'sphere', model: along4([0, 0, 1], [ball, ball, ball], point), colour});
    });
  }
  return {parts, springs};
}

// Points that a motion reaches, and the box about them: mass centres at all instants, corners of bodies and points of
// joints at some sixty.
function reachOf(motion, mechanism) {
  const points = [], take = (p) => p.every((value) => Math.abs(value) < 1e6) && points.push(p);
  const seen = motion.names.map(() => [[0, 0, 0]]), last = motion.t.length - 1, every = Math.ceil((last + 1) / 60);
  for (const {name, shape, axes, sizes} of (mechanism && mechanism.bodies) || []) {
    const body = motion.names.indexOf(name);
    if (body < 0 || shape === 'point') continue;
    for (let corner = 0; corner < 8; corner++) {
      const part = (k) => times3(axes[k], ((corner >> k) & 1 ? 0.5 : -0.5) * sizes[k]);
      seen[body].push(add3(add3(part(0), part(1)), part(2)));
    }
  }
  for (const link of (mechanism && mechanism.links) || [])
    link.between.forEach((name, side) => {
      if (!hasPlace(link, side)) return;
      if (name === 'ground') take(link.points[side]);
      else if (motion.names.includes(name)) seen[motion.names.indexOf(name)].push(link.points[side]);
    });
  for (let i = 0; i <= last; i++)
    seen.forEach((list, body) => {
      if (i % every && i !== last) return take(motion.position(body, i));
      const pose = motion.pose(body, motion.t[i]);
      list.forEach((p) => take(apply4(pose, p)));
    });
  return {points, ...boxOf(points)};
}
function boxOf(points) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const p of points)
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], p[k]);
      high[k] = Math.max(high[k], p[k]);
    }
  const has = points.length && length3(add3(high, low, -1)) > 0, middle = points.length ? low : [0, 0, 0];
  return has ? {low, high} : {low: middle.map((v) => v - 1), high: middle.map((v) => v + 1)};
}
