// SPDX-License-Identifier: BSD-3-Clause
// Figures in space: a path, its shadow and outlines of bodies, coloured by time; the arrow keys turn them.

const spaceFrame = {width: 560, height: 480, half: 235};

// Seen from an elevation and an azimuth (degrees), as gnuplot does: [right, up].
function projected([x, y, z], [elevation, azimuth]) {
  const e = (elevation * Math.PI) / 180, a = (azimuth * Math.PI) / 180;
  const floor = y * Math.cos(a) - x * Math.sin(a);
  return [x * Math.cos(a) + y * Math.sin(a), floor * Math.cos(e) + z * Math.sin(e)];
}

function spaceView(figure) {
  const {low, high, view, path, lines, t} = figure.space, angles = [...view];
  const middle = low.map((value, k) => (value + high[k]) / 2), size = (high[0] - low[0]) / 2;
  const svg = draw('svg', {
    viewBox: `0 0 ${spaceFrame.width} ${spaceFrame.height}`,
    tabindex: 0,
    role: 'application',
    'aria-label': `${plainLabel(figure.title || figure.name)}: the path of a mass centre in space. Arrow keys turn it.`
  });
  const place = (p) => {
    const [right, up] = projected(p.map((value, k) => (value - middle[k]) / (1.75 * size)), angles);
    const {width, height, half} = spaceFrame;
    return [(width / 2 + half * right).toFixed(1), (height / 2 - half * up).toFixed(1)];
  };
  const line = (points, attributes) => draw('path', {...attributes, d: `M${points.map(place).join('L')}`});
  const at = (time) => viridisAt((time - t[0]) / (t[t.length - 1] - t[0] || 1));
  const floor = ([x, y]) => [x, y, low[2]];
  function update() {
    const corner = (i, j, z) => [i ? high[0] : low[0], j ? high[1] : low[1], z];
    const base = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]].map(([i, j]) => corner(i, j, low[2]));
    const label = (p, text) => {
      const [x, y] = place(p);
      return draw('text', {x, y, 'text-anchor': 'middle'}, svgLabel(text));
    };
    const between = (a, b) => a.map((value, k) => middle[k] + 1.18 * ((value + b[k]) / 2 - middle[k]));
    svg.replaceChildren(
        line(base, {class: 'grid'}), line([base[0], corner(0, 0, high[2])], {class: 'axis'}),
        line(path.map(floor), {class: 'guide'}),
        ...lines.map(([time, points]) => line(points, {class: 'outline', stroke: at(time)})),
        ...path.slice(1).map((p, i) => line([path[i], p], {class: 'track', stroke: at(t[i])})),
        label(between(base[0], base[1]), `x_1 [m], ${shortText(low[0])} … ${shortText(high[0])}`),
        label(between(base[1], base[2]), `x_2 [m], ${shortText(low[1])} … ${shortText(high[1])}`),
        label(corner(0, 0, high[2] + 0.06 * size), `x_3 [m], ${shortText(low[2])} … ${shortText(high[2])}`));
  }
  svg.addEventListener('keydown', (event) => {
    const moves = {ArrowLeft: [0, 5], ArrowRight: [0, -5], ArrowUp: [-5, 0], ArrowDown: [5, 0]}[event.key];
    if (!moves) return;
    event.preventDefault();
    angles[0] = Math.min(Math.max(angles[0] + moves[0], 0), 90);
    angles[1] += moves[1];
    update();
  });
  update();
  const [first, last] = [t[0], t[t.length - 1]].map(shortText);
  const times = `Dark at t = ${first} s, bright at t = ${last} s; the shadow lies on the floor.`;
  return make('div', {class: 'plot space'}, svg, make('p', {class: 'faint small'}, times));
}
