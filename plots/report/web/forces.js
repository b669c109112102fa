// SPDX-License-Identifier: BSD-3-Clause
// Forces and torques on the bodies of a mechanism, as arrows.

// The upper halves of numbers of 32 bits.
const halvesOf = (text) =>
    new Float32Array(Uint32Array.from(new Uint16Array(bytesOf(text)), (half) => half << 16).buffer);

const swingOf = ({amplitude, frequency}, time) => 1 + amplitude * Math.sin(frequency * time);
const turned3 = (pose, v) => add3(apply4(pose, v), apply4(pose, [0, 0, 0]), -1);
// 1, 2 or 5 times a power of ten, the next that is not below.
function roundAbove(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= value * 0.999);
}

const forceGroups = {
  joints: 'forces of joints',
  between: 'springs, dampers, attractions',
  applied: 'applied forces'
};
const forceNames = {
  reaction: 'reaction of a joint on its second body (on its first, where the second is the ground)',
  drive: 'what drives a joint',
  between: 'spring, damper, bushing or attraction, on both bodies',
  applied: 'weight or load'
};
const groupOf = (what) => (what in forceGroups ? what : 'joints');
// Where a force acts on its first body: along a line at its own point there, else where it does on the second.
const actsAlongLine = (link) => ['spring', 'polynomial_spring', 'attraction'].includes(link.type);

class Forces {
  constructor(mechanism, cell, motion) {
    const places = (link) => link.between.map((name) => (name === 'ground' ? 'ground' : motion.names.indexOf(name)));
    this.motion = motion;
    this.mechanism = mechanism || {bodies: [], links: []};
    this.applied = cell.applied;
    this.links = cell.forces.map(({link, ...numbers}) => ({
                                    link: this.mechanism.links[link],
                                    at: places(this.mechanism.links[link]),
                                    ...Object.fromEntries(
                                        Object.entries(numbers).map(([name, text]) => [name, halvesOf(text)]))
                                  }));
    this.masses = new Map(this.mechanism.bodies.map((body) => [body.name, body.mass]));
    this.kinds = new Set();  // of the arrows at any instant
    // The forces and torques that the scale is made for: nine instants in ten have none that is larger.
    this.typical = this.typicalSizes();
  }
  // Whether samples could hold forces of a group of links and do not.
  lacks(group) {
    const fits = (link) => link.force === (group === 'between');
    return group !== 'applied' && this.mechanism.links.some(fits) && !this.links.some(({link}) => fits(link));
  }
  // Arrows {from, vector, isTorque, what} at a time; poses of the bodies then.
  arrows(time, poses) {
    const found = [];
    const add = (from, vector, isTorque, what) => {
      if (vector.every(Number.isFinite)) found.push({from, vector, isTorque, what});
    };
    const poseOf = (home) => (home === 'ground' ? identity4 : poses[home]);
    for (const exerted of this.links)
      exerted.link.force ? this.addForce(exerted, time, poseOf, add) : this.addJoint(exerted, time, poseOf, add);
    this.motion.names.forEach((name, body) => {
      const weight = (this.masses.get(name) || 0) * swingOf(this.applied.gravity, time);
      add(apply4(poses[body], [0, 0, 0]), times3(this.applied.gravity.g, weight), false, 'applied');
    });
    for (const load of this.applied.loads) this.addLoad(load, time, poses[this.motion.names.indexOf(load.body)], add);
    return found;
  }
  // The vector, or the number, of a list at a time.
  vectorAt(list, time) {
    const [i, j, part] = this.motion.instant(time);
    return [0, 1, 2].map((k) => list[3 * i + k] + part * (list[3 * j + k] - list[3 * i + k]));
  }
  numberAt(list, time) {
    const [i, j, part] = this.motion.instant(time);
    return list[i] + part * (list[j] - list[i]);
  }
  addJoint({link, at, F, tau, force, torque}, time, poseOf, add) {
    const side = at[1] === 'ground' || at[1] === -1 ? 0 : 1, sign = side === 1 ? 1 : -1;
    if (at[side] === 'ground' || at[side] === -1) return;
    const from = apply4(poseOf(at[side]), link.points[side]);
    if (F) add(from, times3(this.vectorAt(F, time), sign), false, 'reaction');
    if (tau) add(from, times3(this.vectorAt(tau, time), sign), true, 'reaction');
    if (!force && !torque || at[1] === -1) return;
    const axis = times3(turned3(poseOf(at[1]), link.axes[1]), sign);
    if (force) add(from, times3(axis, this.numberAt(force, time)), false, 'drive');
    if (torque) add(from, times3(axis, this.numberAt(torque, time)), true, 'drive');
  }
  // On both bodies, the ground apart.
  addForce({link, at, F, tau}, time, poseOf, add) {
    at.forEach((home, side) => {
      if (home === 'ground' || home === -1) return;
      const place = actsAlongLine(link) || !F ? side : 1, sign = side === 1 ? 1 : -1;
      if (at[place] === -1) return;
      const from = apply4(poseOf(at[place]), link.points[place]);
      if (F) add(from, times3(this.vectorAt(F, time), sign), false, 'between');
      if (tau) add(from, times3(this.vectorAt(tau, time), sign), true, 'between');
    });
  }
  addLoad(load, time, pose, add) {
    if (!pose) return;
    const inSpace = (v) => times3(load.frame === 'body' ? turned3(pose, v) : v, swingOf(load, time));
    add(apply4(pose, load.point), inSpace(load.force), false, 'applied');
    add(apply4(pose, [0, 0, 0]), inSpace(load.torque), true, 'applied');
  }
  typicalSizes() {
    const sizes = {force: [], torque: []}, {motion} = this;
    for (const time of motion.t) {
      const largest = {force: 0, torque: 0}, poses = motion.names.map((name, body) => motion.pose(body, time));
      for (const {vector, isTorque, what} of this.arrows(time, poses)) {
        if (length3(vector) > 0) this.kinds.add(what);
        const kind = isTorque ? 'torque' : 'force';
        largest[kind] = Math.max(largest[kind], length3(vector));
      }
      for (const kind of ['force', 'torque']) sizes[kind].push(largest[kind]);
    }
    const typical = (all) => all.sort((a, b) => a - b)[Math.floor(0.9 * (all.length - 1))];
    return {force: typical(sizes.force), torque: typical(sizes.torque)};
  }
}

const unitOf = {
  force: 'N',
  torque: 'N m'
};

// Boxes that switch groups of forces, how long the arrows are, and what they mean. `changed` is called where one is
// switched.
class ForceControls {
  constructor(changed) {
    const box = () => make('input', {type: 'checkbox', onchange: () => { this.say(); changed(); }});
    this.boxes = {joints: box(), between: box(), applied: box()};
    const options = [1, 2, 5, 10].map((value) => make('option', {value}, `${value}×`));
    const rescale = () => { this.measure(this.stages); changed(); };
    this.factor = make('select', {'aria-label': 'Length of arrows', onchange: rescale}, options);
    this.labels = [
      ...Object.entries(this.boxes).map(([group, node]) => make('label', {}, node, forceGroups[group])),
      make('label', {}, 'arrows ', this.factor)
    ];
    this.legend = make('p', {class: 'faint small forces', 'aria-live': 'polite', hidden: true});
    this.scale = null;
    this.stages = [];
  }
  isShown(what) {
    return this.boxes[groupOf(what)].checked;
  }
  // One scale for all that is in sight.
  measure(stages) {
    this.stages = stages;
    const typical = (kind) => Math.max(...stages.map((stage) => stage.forces.typical[kind]));
    const unit = (kind) => (typical(kind) > 0 ? roundAbove(typical(kind)) / Number(this.factor.value) : 0);
    const length = Math.max(...stages.map((stage) => stage.size)) / 4;
    this.scale = {force: unit('force'), torque: unit('torque'), length};
    this.say();
  }
  say() {
    const {legend, scale, stages} = this, wanted = Object.keys(forceNames).filter((what) => this.isShown(what));
    legend.hidden = !wanted.length;
    if (legend.hidden) return;
    const shown = wanted.filter((what) => stages.some((stage) => stage.forces.kinds.has(what)));
    const length = Number(scale.length.toPrecision(2));
    const lengths = ['force', 'torque'].filter((kind) => scale[kind] > 0)
                        .map((kind) => `a ${kind} of ${shortText(scale[kind])} ${unitOf[kind]}`);
    const swatch = (what) => make('span', {class: `swatch ${what}`, 'aria-hidden': 'true'});
    const key = (what) => [swatch(what), `\u00a0${forceNames[what]}. `];
    const lacks = wanted.some((what) => stages.some((stage) => stage.forces.lacks(groupOf(what))));
    legend.replaceChildren(
        ...shown.flatMap(key),
        shown.length && lengths.length ? `An arrow of ${length} m is ${lengths.join(', or with two heads ')}; ` +
                'arrows longer than 1.5 times that are cut, below 1/50 not drawn. ' :
                         'There are none. ',
        lacks ? 'These samples do not hold all of them; kreisel run with "output": {"samples": 500} writes them.' : '');
  }
  // Shows the arrows at a time in a stage.
  paint(stage, time, poses, colours) {
    for (const arrow of stage.forces.arrows(time, poses)) {
      const unit = this.scale[arrow.isTorque ? 'torque' : 'force'], part = length3(arrow.vector) / unit;
      if (!this.isShown(arrow.what) || !(part > 0.02)) continue;
      paintArrow(stage, arrow, this.scale.length * Math.min(part, 1.5), colours[arrow.what]);
    }
  }
}

// A shaft with a head, of a torque with two.
function paintArrow({scene, size}, {from, vector, isTorque}, length, colour) {
  const along = unit3(vector), head = Math.min(0.045 * size, 0.5 * length), wide = 0.6 * head;
  const at = (distance) => add3(from, along, distance);
  scene.solid('cylinder', rod4(from, at(length - head), 0.011 * size), colour);
  scene.solid('cone', along4(along, [wide, wide, head], at(length - head / 2)), colour);
  if (isTorque) scene.solid('cone', along4(along, [wide, wide, head], at(length - 1.4 * head)), colour);
}
