// SPDX-License-Identifier: BSD-3-Clause
// Heat maps: values of cells as the colours of the places between two axes.

// viridis, as in the figures on paper.
const viridis = [
  [68, 1, 84], [72, 40, 120], [62, 73, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121],
  [110, 206, 88], [181, 222, 43]
];
function viridisAt(part) {
  const at = Math.min(Math.max(part, 0), 1) * (viridis.length - 1), i = Math.min(Math.floor(at), viridis.length - 2);
  return `rgb(${viridis[i].map((a, k) => Math.round(a + (at - i) * (viridis[i + 1][k] - a))).join()})`;
}

// Where a value stands between the least and the largest, from 0 to 1.
function partOf(values, log) {
  const size = log ? Math.log10 : (value) => value, sizes = values.map(size);
  const low = Math.min(...sizes), high = Math.max(...sizes);
  return (value) => (high > low ? (size(value) - low) / (high - low) : 0);
}

// A table, so that it is read and selected as one: a row for each value of the y axis, the largest on top.
function heatTable(figure, map) {
  const {heat} = figure, part = partOf(map.places.map(([, , value]) => value), heat.log);
  const values = new Map(map.places.map(([x, y, value]) => [`${x} ${y}`, value]));
  const cell = (x, y) => {
    const value = values.get(`${x} ${y}`);
    if (value === undefined) return make('td', {class: 'none'});
    const at = part(value);
    const node = make('td', {class: at < 2 / 3 ? 'deep' : 'bright', title: exactText(value)}, value.toExponential(1));
    node.style.backgroundColor = viridisAt(at);
    return node;
  };
  const rows = heat.y_values.map((name, y) => make(
      'tr', {}, make('th', {scope: 'row'}, name), heat.x_values.map((unused, x) => cell(x, y)))).reverse();
  const head = make(
      'tr', {}, make('th', {class: 'corner'}, htmlLabel(heat.y_label), ' \\ ', htmlLabel(heat.x_label)),
      heat.x_values.map((name) => make('th', {scope: 'col'}, name)));
  return make(
      'div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': plainLabel(map.label)},
      make('table', {class: 'heat'}, make('caption', {}, htmlLabel(map.label)), make('thead', {}, head),
           make('tbody', {}, rows)));
}

const heatView = (figure) => make('div', {}, figure.heat.maps.map((map) => heatTable(figure, map)));
