// SPDX-License-Identifier: BSD-3-Clause
// Figures: the panels that kreisel plot draws, with legends that switch curves and axes that may be linear.

function legendView(panel, figure, state, changed) {
  if (panel.curves.length < 2 && !(panel.curves[0] || {}).label) return null;
  const longest = Math.max(...panel.curves.map((curve) => legendName(curve).length));
  const entries = panel.curves.map((curve) => {
    const toggle = (event) => {
      const others = panel.curves.map((one) => one.style).filter((style) => style !== curve.style);
      const alone = event.shiftKey || event.type === 'dblclick';
      if (alone) {
        const isAlone = others.every((style) => state.hidden.has(style)) && !state.hidden.has(curve.style);
        state.hidden = new Set(isAlone ? [] : others);
      } else if (!state.hidden.delete(curve.style)) state.hidden.add(curve.style);
      changed();
    };
    const button = make(
        'button', {type: 'button', onclick: toggle, title: 'Click: show or hide. Shift-click: this one alone.'},
        swatch(curve.style, figure.marks || (curve.marked || []).length > 0), make('span', {}, htmlLabel(curve.label || 'curve')));
    return {curve, button};
  });
  const list = make('ul', {class: 'legend', 'aria-label': 'Legend'}, entries.map(({button}) => make('li', {}, button)));
  list.style.setProperty('--entry', `${Math.min(330, 60 + 7.2 * longest)}px`);
  const update = () =>
      entries.forEach(({curve, button}) => button.setAttribute('aria-pressed', String(!state.hidden.has(curve.style))));
  update();
  return {list, update};
}

// Two buttons that say how an axis is drawn.
function scaleButtons(axis, state, changed) {
  const buttons = [['linear', false], ['log', true]].map(
      ([text, log]) =>
          [log,
           make(
               'button', {
                 type: 'button',
                 onclick: () => {
                   state.log[axis] = log;
                   update();
                   changed();
                 }
               },
               text)]);
  const update = () =>
      buttons.forEach(([log, button]) => button.setAttribute('aria-pressed', String(state.log[axis] === log)));
  update();
  return make(
      'span', {class: 'group', role: 'group', 'aria-label': `Scale of the ${axis} axis`}, `${axis}: `,
      buttons.map(([, button]) => button));
}

// A curve with the x of an earlier one has the index of that curve in place of numbers.
const withAbscissae = (panel) => ({
  ...panel,
  curves: panel.curves.map((curve) => Array.isArray(curve.x) ? curve : {...curve, x: panel.curves[curve.x].x})
});

function panelsView(figure) {
  const first = figure.panels[0], state = {log: {x: first.log_x, y: first.log_y}, hidden: new Set()};
  const updates = [], changed = () => updates.forEach((update) => update());
  const panels = figure.panels.map(withAbscissae).map((panel) => {
    const plot = plotView(panel, figure, state), legend = legendView(panel, figure, state, changed);
    updates.push(plot.update);
    if (legend) updates.push(legend.update);
    return make('div', {class: 'panel'}, plot.box, legend && legend.list);
  });
  const all = make(
      'button', {
        type: 'button',
        onclick: () => {
          state.hidden = new Set();
          changed();
        }
      },
      'show all curves');
  const many = figure.panels.some((panel) => panel.curves.length > 1);
  const fitted = figure.panels.some((panel) => panel.curves.some((curve) => curve.fitted));
  const grid = make('div', {class: 'panels'}, panels);
  const columns = Math.min(figure.panels.length, figure.columns || 2, 2);
  grid.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
  if (columns === 1) grid.style.maxWidth = '680px';
  return make(
      'div', {},
      make(
          'div', {class: 'bar'}, scaleButtons('x', state, changed), scaleButtons('y', state, changed),
          many ? all : null),
      grid,
      fitted ?
          make(
              'p', {class: 'faint small'},
              'Filled marks: the window of step sizes that the order in the legend was fitted to; ± is the largest distance ' +
             'of a slope in it.') :
          null);
}

function figureView(figure) {
  const heading = make('h3', {}, figure.title || figure.name);
  if (figure.not_drawn) return make('div', {}, heading, make('p', {class: 'alert'}, `Not drawn: ${figure.not_drawn}`));
  const view = figure.heat ? heatView : figure.space ? spaceView : panelsView;
  return make('section', {class: 'figure', 'aria-label': figure.title || figure.name}, heading, view(figure));
}
