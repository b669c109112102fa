// SPDX-License-Identifier: BSD-3-Clause
// One mechanism in its part of the picture.

const piecesOfTrail = 8;  // from one instant to the next

class Stage {
  constructor(scene, cell, motion) {
    const mechanism = cell.mechanism === null ? null : data.motions.mechanisms[cell.mechanism];
    this.scene = scene;
    this.cell = cell;
    this.motion = motion;
    this.reach = reachOf(motion, mechanism);
    this.size = Math.max(...add3(this.reach.high, this.reach.low, -1));
    this.forces = new Forces(mechanism, cell, motion);
    Object.assign(this, partsOf(mechanism, motion.names, this.size * 0.6));
    const few = motion.names.length <= 6;
    this.trails = motion.names.map(
        (name, body) =>
            (few || body === motion.names.length - 1 ? scene.lines(motion.trail(body, piecesOfTrail)) : null));
    this.grid = scene.lines(this.gridLines());
  }
  gridLines() {
    const {low, high} = this.reach, lines = [], half = 0.62 * this.size,
                middle = [0, 1].map((k) => (low[k] + high[k]) / 2), z = low[2] - 0.02 * this.size;
    for (let i = -6; i <= 6; i++) {
      const at = (i / 6) * half;
      lines.push(
          middle[0] + at, middle[1] - half, z, middle[0] + at, middle[1] + half, z, middle[0] - half, middle[1] + at, z,
          middle[0] + half, middle[1] + at, z);
    }
    return lines;
  }
  paint(time, withTrails, forces, colours) {
    const {scene, motion} = this, poses = motion.names.map((name, body) => motion.pose(body, time));
    const at = (home) => (home === 'ground' ? identity4 : poses[home]);
    scene.segments(this.grid, identity4, colours.grid);
    for (const part of this.parts)
      scene.solid(
          part.solid, multiply4(at(part.at), part.model),
          part.body === undefined ? colours[part.colour] : colours.bodies[part.body % 7], part.pattern);
    for (const {link, ends} of this.springs) {
      if (ends.includes(-1)) continue;
      const [a, b] = ends.map((home, side) => apply4(at(home), link.points[side]));
      scene.solid('cylinder', rod4(a, b, 0.008 * this.size), colours.spring);
    }
    const [last, , part] = motion.instant(Math.min(time, motion.end));
    const drawn = 1 + Math.floor(piecesOfTrail * (last + part) + 1e-9);
    if (withTrails)
      this.trails.forEach((trail, body) => trail && scene.strip(trail, colours.bodies[body % 7], drawn));
    scene.over();
    forces.paint(this, time, poses, colours);
  }
  remove() {
    for (const lines of [this.grid, ...this.trails])
      if (lines) this.scene.remove(lines);
  }
}
