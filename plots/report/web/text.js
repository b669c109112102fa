// SPDX-License-Identifier: BSD-3-Clause
// Elements, numbers and labels. Whatever comes from results becomes text nodes: no markup in it is ever read as such.

const data = JSON.parse(document.getElementById('data').textContent);
const svgSpace = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith('on')) node.addEventListener(key.slice(2), value);
    else node.setAttribute(key, value === true ? '' : value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}
const make = (tag, attributes = {}, ...children) => fill(document.createElement(tag), attributes, children);
const draw = (tag, attributes = {}, ...children) => fill(document.createElementNS(svgSpace, tag), attributes, children);

// A number in all its digits: the shortest text that reads back, or as many as a quad number has.
const exactText = (value) => (value === null || value === undefined ? '' : String(value));
// A number in four to five digits.
function shortText(value) {
  if (value === null || value === undefined || value === '') return '';
  const number = Number(value), size = Math.abs(number);
  if (!Number.isFinite(number)) return String(value);
  if (number === 0 || (Number.isInteger(number) && size < 1e6)) return String(number);
  return size >= 1e-2 && size < 1e4 ? String(Number(number.toPrecision(5))) : number.toExponential(3);
}
const count = (number, what) => `${number} ${what}${number === 1 ? '' : 's'}`;

// The enhanced text of gnuplot as pieces [{text, shift}], shift 1 raised and -1 lowered: ^ and _ apply to the next
// character or group, a backslash makes a character literal, {/*0.8 ...} sets a size, which is not followed here.
function pieces(label) {
  const found = [];
  let at = 0;
  function put(text, shift) {
    const last = found[found.length - 1];
    if (last && last.shift === shift) last.text += text;
    else found.push({text, shift});
  }
  function item(shift) {
    const c = String.fromCodePoint(label.codePointAt(at));
    at += c.length;
    if (c === '\\') {
      if (at < label.length) put(label[at++], shift);
    } else if (c === '^' || c === '_') {
      if (at < label.length) item(c === '^' ? 1 : -1);
    } else if (c === '{') {
      if (label[at] === '/') at = Math.max(at, label.indexOf(' ', at) + 1);
      while (at < label.length && label[at] !== '}') item(shift);
      at++;
    } else if (c !== '@' && c !== '&' && c !== '~') put(c, shift);
  }
  while (at < label.length) item(0);
  return found;
}
const plainLabel = (label) => pieces(label).map((piece) => piece.text).join('');
function htmlLabel(label) {
  const tags = {1: 'sup', '-1': 'sub'};
  return pieces(label).map(({text, shift}) => (shift ? make(tags[shift], {}, text) : text));
}
// The same within an SVG text: each piece says how far it lies from the one before.
function svgLabel(label) {
  let below = 0;
  return pieces(label).map(({text, shift}) => {
    const wanted = shift === 1 ? -4.5 : shift === -1 ? 3 : 0;
    const piece = draw(
        'tspan', {dy: wanted === below ? undefined : wanted - below, 'font-size': shift ? '0.78em' : undefined}, text);
    below = wanted;
    return piece;
  });
}

// Saves a text that the page itself has made.
function save(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], {type}));
  make('a', {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
