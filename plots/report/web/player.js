// SPDX-License-Identifier: BSD-3-Clause
// What moves on the page: the picture, its clock and camera, and the distance of two cells below it.

const colourOfPage = (name) => {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16) / 255);
};

// Names of cells: what varies among those shown.
function cellNames(shown) {
  const axes =
      ['problem', 'formulation', 'method', 'projection', 'precision', 'steps', 'tolerance'].map(column).filter(Boolean);
  const varying = axes.filter((one) => new Set(shown.map((cell) => one.value(cell.row))).size > 1);
  const used = varying.length ? varying : axes.filter((one) => one.name === 'method');
  const text = (one, row) => {
    const value = one.value(row);
    return isEmpty(value) ? '' :
        one.isNumber      ? `${one.name} ${value}` :
             one.name === 'projection' && value === 'none' ? 'no projection' :
                                                             value;
  };
  return shown.map((cell) => used.map((one) => text(one, cell.row)).filter(Boolean).join(', '));
}

// Why a motion ends before its time; empty where it does not.
function endText(cell, motion, end) {
  const status = statusOf(cell.row), reached = column('reached'), reason = column('reason');
  if (status === 'ok' && motion.end >= end) return '';
  const time = (reached && reached.value(cell.row)) || motion.end, why = (reason && reason.value(cell.row)) || '';
  const short = why.length > 150 ? `${why.slice(0, 150).replace(/\s+\S*$/, '')} …` : why;
  return status === 'ok' ? `ends at t = ${shortText(motion.end)} s` :
                           `stopped at t = ${shortText(time)} s: ${status}${short && `, ${short}`}`;
}

// The distance of two motions as a plot with a line at the present instant, or a sentence.
function distanceView(a, b) {
  const curve = distanceCurve(a, b), sentence = (text) => make('p', {class: 'faint small'}, text);
  if (!curve || !curve.x.length) {
    return {nodes: [sentence('The two cells have other bodies, or no instants in common: they have no distance.')]};
  }
  const differ = curve.y.some((value) => value > 0);
  const labels = {title: 'Distance of the two, over all bodies', x_label: 't [s]', y_label: '|x_{left} − x_{right}| [m]'};
  const panel = {...labels, curves: [curve], guides: [], marks: [], from_zero: true};
  const state = {log: {x: false, y: differ}, hidden: new Set()};
  const plot = plotView(panel, {name: 'distance', marks: false, cursor: true}, state);
  const bar = make('div', {class: 'bar'}, scaleButtons('y', state, () => plot.update()));
  const same = differ ? [] : [sentence('The two are the same at every instant, to the last digit.')];
  return {nodes: [...same, bar, plot.box], at: plot.at};
}

const speeds = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 50];
// With which a motion takes some nine seconds.
function fittingSpeed(end) {
  const off = (speed) => Math.abs(Math.log((9 * speed) / end));
  return speeds.reduce((best, speed) => (off(speed) < off(best) ? speed : best));
}
const views = {view: [-0.95, 0.36], front: [-Math.PI / 2, 0], side: [0, 0], top: [-Math.PI / 2, 1.5]};
const help = 'Arrow keys turn the view, plus and minus come nearer and go away, the space bar plays and pauses.';
const coarseText = 'Some body turns by more than a third of a turn from one instant shown to the next: its spin looks ' +
    'slower than it is. More samples show it.';

class Player {
  // Takes its place in the page.
  constructor(shown, canvas, scene, place) {
    Object.assign(this, {shown, canvas, scene, names: cellNames(shown), motions: new Map(), stages: []});
    Object.assign(this, {time: 0, end: 1, last: 0, playing: false, plot: null});
    this.camera = new Camera(() => this.paint());
    this.makeControls();
    this.root = this.layout();
    place.replaceChildren(this.root);  // what is framed has a size
    this.right.value = shown.findIndex((cell, i) => i > 0 && cell.mechanism === shown[0].mechanism);
    this.readColours();
    this.choose(true);
    this.listen();
  }
  makeControls() {
    const options = () => this.shown.map((cell, i) => make('option', {value: i}, this.names[i]));
    const choice = (side, ...more) =>
        make('select', {'aria-label': `Cell on the ${side}`, onchange: () => this.choose(false)}, ...more, options());
    this.left = choice('left');
    this.right = choice('right', make('option', {value: -1}, 'none'));
    this.captions = [0, 1].map(() => make('span', {class: 'caption'}));
    this.ends = [0, 1].map(() => make('span', {class: 'stop'}));
    this.play = make('button', {type: 'button', class: 'play', onclick: () => this.toggle()}, 'Play');
    const seek = () => { this.stop(); this.seek(Number(this.scrub.value)); };
    this.scrub = make('input', {type: 'range', min: 0, step: 'any', value: 0, 'aria-label': 'Time', oninput: seek});
    this.clock = make('output', {class: 'clock'});
    this.speed = make('select', {'aria-label': 'Speed'}, speeds.map((value) => make('option', {value}, `${value}×`)));
    this.trails = make('input', {type: 'checkbox', checked: true, onchange: () => this.paint()});
    this.forces = new ForceControls(() => this.paint());
    this.distance = make('div', {class: 'distance'});
    this.coarse = make('p', {class: 'faint small', hidden: true}, coarseText);
  }
  layout() {
    const panes = [0, 1].map((k) => make('div', {class: 'pane'}, this.captions[k], this.ends[k]));
    const view = ([name, angles]) => make('button', {type: 'button', onclick: () => this.frame(...angles)}, name);
    this.panes = make('div', {class: 'panes'}, this.canvas, panes);
    return make('div', {class: 'motion'},
        make('div', {class: 'bar'}, make('label', {}, 'left ', this.left), make('label', {}, 'right ', this.right)),
        this.panes,
        make('div', {class: 'bar'}, this.play, this.scrub, this.clock, make('label', {}, 'speed ', this.speed),
             make('label', {}, this.trails, 'trails'), this.forces.labels,
             make('span', {class: 'group', role: 'group', 'aria-label': 'View'}, Object.entries(views).map(view))),
        this.forces.legend, this.coarse, this.distance);
  }
  listen() {
    this.camera.listen(this.canvas);
    this.canvas.addEventListener('keydown', (event) => {
      if (event.key !== ' ') return;
      event.preventDefault();
      this.toggle();
    });
    document.addEventListener('themechange', () => { this.readColours(); this.paint(); });
    // What nobody has turned stays as large as it fits.
    new ResizeObserver(() => (this.camera.isFramed ? this.frame() : this.paint())).observe(this.canvas);
  }
  readColours() {
    const names = {page: '--page', grid: '--line', ground: '--guide', joint: '--faint', spring: '--guide',
      reaction: '--reaction', drive: '--drive', between: '--between', applied: '--applied'};
    this.colours = {bodies: [1, 2, 3, 4, 5, 6, 7].map((k) => colourOfPage(`--c${k}`))};
    for (const [name, variable] of Object.entries(names)) this.colours[name] = colourOfPage(variable);
  }
  motionOf(cell) {
    if (!this.motions.has(cell)) this.motions.set(cell, new Motion(cell));
    return this.motions.get(cell);
  }
  // Shows the cells that the two choices name; at first all of the picture is in sight.
  choose(first) {
    this.stages.forEach((stage) => stage.remove());
    const chosen = [this.left, this.right].map((one) => Number(one.value)).filter((i) => i >= 0);
    this.stages = chosen.map((i) => new Stage(this.scene, this.shown[i], this.motionOf(this.shown[i])));
    chosen.forEach((i, k) => { this.captions[k].textContent = this.names[i]; });
    this.panes.classList.toggle('two', chosen.length === 2);
    this.end = Math.max(...this.stages.map((stage) => stage.motion.end));
    this.scrub.max = this.end;
    if (first) this.speed.value = fittingSpeed(this.end);
    this.coarse.hidden = !this.stages.some((stage) => stage.motion.isCoarse());
    this.forces.measure(this.stages);
    this.showDistance();
    this.frame();
    this.seek(this.time);
  }
  frame(...angles) {
    const {canvas, stages} = this, aspect = canvas.clientWidth / stages.length / canvas.clientHeight;
    this.camera.frame(stages.flatMap((stage) => stage.reach.points), aspect || 1, ...angles);
  }
  showDistance() {
    this.plot = this.stages.length === 2 ? distanceView(...this.stages.map((stage) => stage.motion)) : {nodes: []};
    this.distance.replaceChildren(...this.plot.nodes);
  }
  paint() {
    const {canvas, scene, stages, colours} = this, ratio = Math.min(devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (!width || !height) return;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const part = Math.floor(width / stages.length), view = this.camera.matrix(part / height);
    stages.forEach((stage, k) => {
      scene.pane(k * part, part, height, colours.page, view);
      stage.paint(Math.min(this.time, stage.motion.end), this.trails.checked, this.forces, colours);
    });
  }
  seek(time) {
    const {end, stages, clock} = this;
    this.time = Math.min(Math.max(time, 0), end);
    this.scrub.value = this.time;
    clock.textContent = `t = ${this.time.toFixed(end < 0.1 ? 5 : end < 10 ? 3 : 2)} s`;
    this.scrub.setAttribute('aria-valuetext', clock.textContent);
    const isOver = (motion) => this.time > motion.end * (1 - 1e-9);
    stages.forEach(({cell, motion}, k) => { this.ends[k].textContent = isOver(motion) ? endText(cell, motion, end) : ''; });
    if (this.plot.at) this.plot.at(this.time);
    this.paint();
  }
  stop() {
    this.playing = false;
    this.play.textContent = 'Play';
  }
  toggle() {
    if (this.playing) return this.stop();
    this.playing = true;
    this.play.textContent = 'Pause';
    this.last = performance.now();
    if (this.time >= this.end) this.seek(0);
    requestAnimationFrame((now) => this.step(now));
  }
  step(now) {
    if (!this.playing) return;
    this.seek(this.time + (Math.max(now - this.last, 0) / 1000) * Number(this.speed.value));
    this.last = now;
    if (this.time >= this.end) this.stop();
    else requestAnimationFrame((next) => this.step(next));
  }
}

function motionView() {
  const shown = data.motions.cells, small = (text) => make('p', {class: 'faint small'}, text);
  if (!shown.length) {
    return make('p', {class: 'faint'},
        'No cell of this experiment keeps samples, so that there is no motion to show. The key ',
        make('code', {}, '"output": {"samples": 500}'),
        ' in the config keeps 501 instants of every cell; it must divide the numbers of steps.');
  }
  const wait = make('p', {class: 'faint', role: 'status'}, 'The picture is being made …');
  const place = make('div', {class: 'motion-place'}, wait);
  // A browser may take seconds to open a scene: what else is on the page is seen before.
  afterPaint(() => startMotion(shown, place));
  return make('div', {}, place, data.motions.remarks.map(small),
      small('Drag turns the view, shift-drag moves it, the wheel comes nearer once the picture is clicked. ' +
            'Bodies without a shape of their own are drawn as homogeneous solids of their mass and inertia; rods ' +
            'lead from mass centres to joints.'));
}

// Once the page is seen, if the browser tells.
function afterPaint(what) {
  if (!window.PerformanceObserver || !(PerformanceObserver.supportedEntryTypes || []).includes('paint'))
    return requestAnimationFrame(() => setTimeout(what));
  new PerformanceObserver((list, observer) => {
    if (!list.getEntriesByName('first-contentful-paint').length) return;
    observer.disconnect();
    what();
  }).observe({type: 'paint', buffered: true});
}

function startMotion(shown, place) {
  performance.mark('motion');
  const canvas = make('canvas', {tabindex: 0, role: 'img', 'aria-label': `The mechanism in motion. ${help}`});
  const scene = openScene(canvas);
  if (scene) new Player(shown, canvas, scene, place);
  else
    place.replaceChildren(make('p', {class: 'alert'},
        'This browser has no WebGL2: the motion is not shown. The figures and tables are complete without it.'));
  document.documentElement.dataset.motion = 'true';
}
