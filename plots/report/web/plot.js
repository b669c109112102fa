// SPDX-License-Identifier: BSD-3-Clause
// A panel of curves as SVG: linear or logarithmic axes, values under the pointer or by the arrow keys.

const frame = {
  width: 560,
  height: 370,
  left: 66,
  right: 12,
  top: 26,
  bottom: 46
};
const dashes = ['', '8 3', '2 2', '10 3 2 3', '10 3 2 3 2 3'];
const dashOf = (style) => dashes[(style - 1 + Math.floor((style - 1) / 7)) % 5];
const colourOf = (style) => 1 + ((style - 1) % 7);
// Outlines of marks about the origin, in the order of the figures on paper.
const outlines = [
  'M-3.2 0A3.2 3.2 0 1 0 3.2 0A3.2 3.2 0 1 0 -3.2 0Z', 'M-3-3H3V3H-3Z', 'M0-3.8L3.6 2.6H-3.6Z', 'M0 3.8L3.6-2.6H-3.6Z',
  'M0-4L3.4 0L0 4L-3.4 0Z', 'M-3-3L3 3M-3 3L3-3', 'M-3.6 0H3.6M0-3.6V3.6', 'M0-3.8L3.6-1.2L2.2 3H-2.2L-3.6-1.2Z',
  'M-3.6 0H3.6M0-3.6V3.6M-2.5-2.5L2.5 2.5M-2.5 2.5L2.5-2.5'
];
const outlineOf = (style) => outlines[(style - 1) % 9];

const isDrawn = (x, y, log) => x !== null && y !== null && !(log.x && x <= 0) && !(log.y && y <= 0);

// A number as enhanced text: 0.05, 5·10^{−4}.
function tickText(value) {
  const [digits, power] = shortText(Number(value.toPrecision(12))).replace(/-/g, '−').split('e');
  if (power === undefined) return digits;
  const factor = digits.replace(/[.]?0+$/, ''), raised = `10^{${power.replace('+', '')}}`;
  return factor === '1' ? raised : `${factor}·${raised}`;
}

// Ticks [value, label] of a range; the labels are enhanced text.
function ticksOf([low, high], log) {
  if (log) {
    const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9);
    const step = Math.max(1, Math.ceil((last - first) / 6)), ticks = [];
    for (let k = first; k <= last; k++)
      if ((k - first) % step === 0) ticks.push([10 ** k, `10^{${String(k).replace('-', '−')}}`]);
    if (ticks.length > 1) return ticks;
    const between =
        [1, 2, 5, 10, 20, 50].map((factor) => factor * 10 ** (first - 1)).filter((v) => v >= low && v <= high);
    if (between.length > 1) return between.map((v) => [v, tickText(v)]);
  }
  const rough = (high - low) / 5, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= rough * 0.999), ticks = [];
  for (let k = Math.ceil(low / step); k <= Math.floor(high / step); k++)
    ticks.push([k * step, tickText(k * step)]);
  return ticks;
}

function rangeOf(values, log, fromZero) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (!(low <= high)) return log ? [0.1, 1] : [0, 1];
  if (log) {
    const factor = Math.max(1.12, (high / low) ** 0.04);
    return [low / factor, high * factor];
  }
  const margin = 0.04 * (high - low || Math.abs(high) || 1);
  return fromZero ? [Math.min(0, low), high + margin] : [low - margin, high + margin];
}

// The range that a config gives, where the axis can show it.
const givenRange = (range, log) => (range && (!log || range[0] > 0) ? range : null);

// How data lie on the page.
function scaleOf(panel, curves, log) {
  const xs = [], ys = [];
  for (const curve of curves)
    curve.x.forEach((x, i) => {
      if (isDrawn(x, curve.y[i], log)) {
        xs.push(x);
        ys.push(curve.y[i]);
      }
    });
  const x = givenRange(panel.x_range, log.x) || rangeOf(xs, log.x);
  const y = givenRange(panel.y_range, log.y) || rangeOf(ys, log.y, panel.from_zero && !log.y);
  const part = (value, [low, high], isLog) =>
      (isLog ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low));
  return {
    x,
    y,
    log,
    px: (value) => frame.left + (frame.width - frame.left - frame.right) * part(value, x, log.x),
    py: (value) => frame.height - frame.bottom - (frame.height - frame.top - frame.bottom) * part(value, y, log.y),
  };
}

function pathOf(xs, ys, scale) {
  let path = '', down = false;
  xs.forEach((x, i) => {
    if (!isDrawn(x, ys[i], scale.log)) {
      down = false;
      return;
    }
    path += `${down ? 'L' : 'M'}${scale.px(x).toFixed(2)} ${scale.py(ys[i]).toFixed(2)}`;
    down = true;
  });
  return path;
}

function axesOf(panel, scale) {
  const {left, right, top, bottom, width, height} = frame, low = height - bottom, far = width - right;
  const parts = [draw('path', {class: 'axis', d: `M${left} ${top}V${low}H${far}`})], grid = [];
  for (const [value, label] of ticksOf(scale.x, scale.log.x)) {
    const at = scale.px(value);
    grid.push(draw('path', {class: 'grid', d: `M${at} ${top}V${low}`}));
    parts.push(
        draw('path', {class: 'axis', d: `M${at} ${low}v4`}),
        draw('text', {x: at, y: low + 18, 'text-anchor': 'middle'}, svgLabel(label)));
  }
  for (const [value, label] of ticksOf(scale.y, scale.log.y)) {
    const at = scale.py(value);
    grid.push(draw('path', {class: 'grid', d: `M${left} ${at}H${far}`}));
    parts.push(
        draw('path', {class: 'axis', d: `M${left} ${at}h-4`}),
        draw('text', {x: left - 8, y: at + 4, 'text-anchor': 'end'}, svgLabel(label)));
  }
  parts.push(
      draw('text', {x: (left + far) / 2, y: height - 6, 'text-anchor': 'middle'}, svgLabel(panel.x_label)),
      draw(
          'text', {transform: `translate(13 ${(top + low) / 2}) rotate(-90)`, 'text-anchor': 'middle'},
          svgLabel(panel.y_label)),
      draw('text', {class: 'title', x: (left + far) / 2, y: 15, 'text-anchor': 'middle'}, svgLabel(panel.title)));
  return [...grid, ...parts];
}

function curveOf(curve, scale, withMarks, withLines) {
  const parts = withLines ?
      [draw('path', {d: pathOf(curve.x, curve.y, scale), 'stroke-dasharray': dashOf(curve.style)})] :
      [];
  const fitted = new Set(curve.fitted || []);
  // Of lines, those of one colour bear marks, each between those of the others.
  const offsets = new Set(curve.marked || []);
  if (withMarks || offsets.size) {
    curve.x.forEach((x, i) => {
      if (!(withMarks || offsets.has(i)) || !isDrawn(x, curve.y[i], scale.log)) return;
      parts.push(draw('path', {
        class: fitted.has(i) ? 'mark fitted' : 'mark',
        d: outlineOf(curve.style),
        transform: `translate(${scale.px(x).toFixed(2)} ${scale.py(curve.y[i]).toFixed(2)})`
      }));
    });
  }
  return draw('g', {class: `curve s${colourOf(curve.style)}`}, parts);
}

const swatch = (style, withMarks) => draw(
    'svg', {width: 30, height: 12, 'aria-hidden': 'true', class: `curve s${colourOf(style)}`},
    draw('path', {d: 'M0 6H30', fill: 'none', 'stroke-width': 1.8, 'stroke-dasharray': dashOf(style)}),
    withMarks ? draw('path', {class: 'mark', d: outlineOf(style), transform: 'translate(15 6)'}) : null);

const legendName = (curve) => (curve.label ? plainLabel(curve.label) : 'curve');

// Shows the point nearest to the pointer, or the one that the arrow keys have come to.
function pointerOn(svg, box, panel, state) {
  const tip = make('div', {class: 'tip', hidden: true}), said = make('span', {class: 'unseen', 'aria-live': 'polite'});
  const ring = draw('circle', {class: 'ring', r: 6, visibility: 'hidden'});
  let at = null;
  const hide = () => {
    at = null;
    tip.hidden = true;
    ring.setAttribute('visibility', 'hidden');
  };
  function show(curve, i) {
    at = {curve, i};
    const x = state.scale.px(curve.x[i]), y = state.scale.py(curve.y[i]),
          name = panel.curves.length > 1 || curve.label ? htmlLabel(curve.label) : [];
    ring.setAttribute('cx', x);
    ring.setAttribute('cy', y);
    ring.setAttribute('visibility', 'visible');
    tip.replaceChildren(
        make('div', {}, name), make('div', {}, htmlLabel(panel.x_label), ` = ${exactText(curve.x[i])}`),
        make('div', {}, htmlLabel(panel.y_label), ` = ${exactText(curve.y[i])}`));
    tip.hidden = false;
    const factor = svg.clientWidth / frame.width || 1, right = x > frame.width / 2;
    tip.style.left = right ? 'auto' : `${x * factor + 12}px`;
    tip.style.right = right ? `${(frame.width - x) * factor + 12}px` : 'auto';
    tip.style.top = `${y * factor + 8}px`;
  }
  function nearest(event) {
    const rect = svg.getBoundingClientRect(), factor = frame.width / rect.width;
    const mx = (event.clientX - rect.left) * factor, my = (event.clientY - rect.top) * factor;
    let best = null, least = 40 ** 2;
    for (const curve of state.visible())
      curve.x.forEach((x, i) => {
        if (!isDrawn(x, curve.y[i], state.scale.log)) return;
        const distance = (state.scale.px(x) - mx) ** 2 + (state.scale.py(curve.y[i]) - my) ** 2;
        if (distance < least) {
          least = distance;
          best = [curve, i];
        }
      });
    best ? show(...best) : hide();
  }
  function step(event) {
    const curves = state.visible().filter((curve) => curve.x.some((x, i) => isDrawn(x, curve.y[i], state.scale.log)));
    const moves = {ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [1, 0], ArrowUp: [-1, 0]};
    if (event.key === 'Escape') return hide();
    if (!(event.key in moves) || !curves.length) return;
    event.preventDefault();
    const [over, along] = moves[event.key];
    const known = at ? curves.indexOf(at.curve) : -1;
    const curve = curves[known < 0 ? 0 : (known + over + curves.length) % curves.length];
    const drawn = curve.x.map((x, i) => i).filter((i) => isDrawn(curve.x[i], curve.y[i], state.scale.log));
    const place = known < 0 ? 0 : Math.max(0, drawn.indexOf(at.i)) + along;
    show(curve, drawn[Math.min(Math.max(place, 0), drawn.length - 1)]);
    said.textContent = tip.textContent.replace(/ = /g, ' is ');
  }
  svg.addEventListener('pointermove', nearest);
  svg.addEventListener('pointerleave', hide);
  svg.addEventListener('keydown', step);
  svg.addEventListener('blur', hide);
  box.append(tip, said);
  return {ring, hide};
}

// A panel in a box. `state`: log {x, y}, hidden (a set of styles). update() draws it anew, at(x) moves the line of an
// instant.
function plotView(panel, figure, state) {
  const svg = draw('svg', {
    viewBox: `0 0 ${frame.width} ${frame.height}`,
    tabindex: 0,
    role: 'application',
    'aria-label': `${plainLabel(panel.title || figure.title || figure.name)}: ${plainLabel(panel.y_label)} against ${
        plainLabel(panel.x_label)}, ${count(panel.curves.length, 'curve')}. Arrow keys go through the points.`
  });
  const box = make('div', {class: 'plot'}, svg);
  const own = {scale: null, visible: () => panel.curves.filter((curve) => !state.hidden.has(curve.style))};
  const pointer = pointerOn(svg, box, panel, own);
  const now = figure.cursor ? draw('path', {class: 'now'}) : null;
  let instant = null;
  function at(x) {
    instant = x;
    const within = x >= own.scale.x[0] && x <= own.scale.x[1];
    if (now) now.setAttribute('d', within ? `M${own.scale.px(x)} ${frame.top}V${frame.height - frame.bottom}` : '');
  }
  function update() {
    pointer.hide();
    const visible = own.visible();
    // Dashed curves over solid ones, which would hide them where both coincide.
    const inOrder = [false, true].flatMap((dashed) => visible.filter((curve) => (dashOf(curve.style) !== '') === dashed));
    own.scale = scaleOf(panel, visible.length ? visible : panel.curves, state.log);
    const clip = `clip${plotView.count = (plotView.count || 0) + 1}`, {left, top} = frame;
    const guides = panel.guides.map((guide) => draw('path', {class: 'guide', d: pathOf(guide.x, guide.y, own.scale)}));
    const marks =
        panel.marks.filter((mark) => isDrawn(mark.x, mark.y, state.log))
            .map(
                (mark) => draw(
                    'text',
                    {class: 'note', x: own.scale.px(mark.x), y: own.scale.py(mark.y) + 4, 'text-anchor': 'middle'},
                    svgLabel(mark.text)));
    svg.replaceChildren(
        draw('clipPath', {id: clip}, draw('rect', {
               x: left - 5,
               y: top - 5,
               width: frame.width - left - frame.right + 10,
               height: frame.height - top - frame.bottom + 10
             })),
        ...axesOf(panel, own.scale),
        draw(
            'g', {'clip-path': `url(#${clip})`}, guides, marks,
            inOrder.map((curve) => curveOf(curve, own.scale, figure.marks, figure.lines !== false))),
        ...(now ? [now] : []), pointer.ring);
    if (instant !== null) at(instant);
  }
  update();
  return {box, update, at};
}
