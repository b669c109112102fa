// SPDX-License-Identifier: BSD-3-Clause
// The page: what was run, what came out, and from what.

const tables = data.tables.map(readTable), cells = tables[0];
const column = (name) => cells.columns.find((one) => one.name === name);
const rowsOf = (table) => [...Array(table.rows).keys()];
const distinct = (one) => [...new Set(rowsOf(cells).map((row) => one.value(row)))].filter((value) => !isEmpty(value));
const statusOf = (row) => column('status').value(row);

function headerView() {
  const counts = new Map();
  for (const row of rowsOf(cells)) counts.set(statusOf(row), (counts.get(statusOf(row)) || 0) + 1);
  const chips = [...counts].map(
      ([status, number]) => make(
          'li',
          {class: status === 'ok'   ? 'good' :
               status === 'skipped' ? null :
                                      'bad'},
          `${number} ${status}`));
  return make(
      'header', {}, make('h1', {}, data.name),
      make('p', {class: 'faint'}, (data.config && data.config.description) || ''),
      make(
          'ul', {class: 'chips', 'aria-label': 'Cells by status'}, make('li', {}, data.kind || 'experiment'),
          make('li', {}, count(cells.rows, 'cell')), chips));
}

function damageView() {
  if (!data.damage.length) return null;
  return make(
      'div', {class: 'alert', role: 'alert'},
      make('strong', {}, 'Something in the results folder is damaged or old; it is left out here:'),
      make('ul', {}, data.damage.map((text) => make('li', {}, text))));
}

// The axes of the experiment with their values.
function axesView() {
  const list = make('dl', {class: 'axes'});
  for (const name of ['problem', 'formulation', 'method', 'projection', 'precision', 'steps', 'tolerance', 'end']) {
    const one = column(name), values = one ? distinct(one) : [];
    if (!values.length) continue;
    const ordered = one.isNumber ? values.sort((a, b) => a - b) : values,
          plural = values.length > 1 && !['steps', 'precision', 'end'].includes(name) ? 's' : '';
    const shown = ordered.slice(0, 60).map((value) => make('code', {}, exactText(value)));
    list.append(
        make('dt', {}, `${name}${plural}${one.unit ? ` [${one.unit}]` : ''}`),
        make(
            'dd', {}, shown.flatMap((code) => [code, ' ']),
            ordered.length > 60 ? `and ${ordered.length - 60} more` : null));
  }
  return list;
}

// Cells that did not end well, by status and reason.
function reasonsTable() {
  const groups = new Map();
  for (const row of rowsOf(cells)) {
    if (statusOf(row) === 'ok') continue;
    const key = JSON.stringify([statusOf(row), (column('reason') ? column('reason').value(row) : '') || '']);
    groups.set(key, [...(groups.get(key) || []), row]);
  }
  if (!groups.size) return make('p', {}, 'Every cell ended well.');
  const lines = [...groups].map(([key, rows]) => {
    const methods = [...new Set(rows.map((row) => column('method').value(row)))];
    return [
      ...JSON.parse(key), rows.length,
      methods.slice(0, 4).join(', ') + (methods.length > 4 ? `, and ${methods.length - 4} more` : '')
    ];
  });
  const titles = ['status', 'reason', 'cells', 'methods'];
  const table = {
    name: 'statuses',
    title: 'Cells that are not ok',
    rows: lines.length,
    columns: titles.map(
        (title, i) =>
            ({title, name: title, unit: '', same: false, isNumber: title === 'cells', value: (row) => lines[row][i]}))
  };
  return tableView(table, {rowClass: (_, row) => (lines[row][0] === 'skipped' ? 'skipped' : 'failed')});
}

const minorEnding = /\.(final|max|relative|slope|slope_error|uncertainty)$/;
const minorCounts = new Set([
  'exponentials', 'brackets', 'accepted', 'rejected', 'output_evaluations', 'newton_iterations', 'projection_iterations'
]);
const minorColumn = (one) => minorEnding.test(one.name) || minorCounts.has(one.name);
function tablesView() {
  const place = make('div'), made = new Map();
  const buttons = tables.map(
      (table) => make(
          'button', {
            type: 'button',
            disabled: table.left_out,
            title: table.left_out ? 'Left out of this page for its size; kreisel table writes it.' : null,
            onclick: () => show(table)
          },
          table.name === 'cells' ? 'all cells' : table.name.replace(/_/g, ' ')));
  function show(table) {
    const isCells = table === cells;
    if (!made.has(table)) {
      const rowClass = isCells ? (_, row) => ({ok: '', skipped: 'skipped'})[statusOf(row)] ?? 'failed' : () => '';
      made.set(
          table,
          make(
              'div', {}, make('h3', {}, table.title),
              tableView(table, {minor: isCells ? minorColumn : undefined, rowClass}),
              table.notes.map((note) => make('p', {class: 'faint small'}, note))));
    }
    place.replaceChildren(made.get(table));
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(tables[i] === table)));
  }
  show(cells);
  const left = tables.filter((table) => table.left_out).map((table) => table.name);
  return make(
      'div', {}, tables.length > 1 ? make('div', {class: 'bar', role: 'group', 'aria-label': 'Tables'}, buttons) : null,
      left.length ?
          make('p', {class: 'faint small'}, `Left out for their size: ${left.join(', ')}; kreisel table writes them.`) :
          null,
      place);
}

function provenanceView() {
  if (!data.provenance)
    return make('p', {}, 'The manifest is missing or damaged: where these results come from is not known.');
  const list = make('dl', {class: 'provenance'});
  const add = (name, value) => {
    if (value && typeof value === 'object' && !Array.isArray(value))
      return Object.entries(value).forEach(([key, inner]) => add(name ? `${name}, ${key}` : key, inner));
    const text = Array.isArray(value) ?
        value.map((one) => (typeof one === 'string' ? one : JSON.stringify(one))).join('\n') :
        String(value);
    if (text) list.append(make('dt', {}, name), make('dd', {}, text));
  };
  const {earlier, started, ended, program = {}, machine, ...rest} = data.provenance;
  const {version, commit, build, compiler, flags, build_type: type, libraries, loaded, ...others} = program;
  Object
      .entries({
        started,
        ended,
        version,
        commit,
        build,
        compiler,
        'build type': type,
        flags,
        machine,
        libraries,
        'loaded libraries': loaded,
        ...others,
        ...rest
      })
      .forEach(([name, value]) => value !== undefined && add(name, value));
  return make(
      'div', {}, list,
      earlier && earlier.length ?
          make(
              'details', {},
              make('summary', {}, `${count(earlier.length, 'earlier run')} whose results were taken over`),
              make('pre', {tabindex: 0}, JSON.stringify(earlier, null, 2))) :
          null);
}

function configView() {
  if (!data.config) return make('p', {}, 'There is no config: the manifest is missing or damaged.');
  const text = JSON.stringify(data.config, null, 2) + '\n';
  return make(
      'div', {},
      make(
          'div', {class: 'bar'},
          make(
              'button',
              {type: 'button', id: 'save-config', onclick: () => save(`${data.name}.json`, 'application/json', text)},
              `Save ${data.name}.json`),
          make('span', {class: 'faint'}, 'kreisel run repeats the experiment from it.')),
      make('pre', {tabindex: 0, 'aria-label': 'Config'}, text));
}

// Follows the system until it is asked otherwise.
function themeButton() {
  const system = matchMedia('(prefers-color-scheme: dark)'), root = document.documentElement;
  const button = make(
      'button', {type: 'button', class: 'end', onclick: () => set(root.dataset.theme === 'dark' ? 'light' : 'dark')});
  function set(theme) {
    root.dataset.theme = theme;
    button.textContent = theme === 'dark' ? 'light page' : 'dark page';
    document.dispatchEvent(new Event('themechange'));
  }
  system.addEventListener('change', () => set(system.matches ? 'dark' : 'light'));
  set(system.matches ? 'dark' : 'light');
  return button;
}

function section(id, title, ...contents) {
  return make('section', {id, 'aria-labelledby': `${id}-title`}, make('h2', {id: `${id}-title`}, title), ...contents);
}

const sections = [
  section('run', 'What was run', axesView()),
  section('motion', 'Motion', motionView()),
  data.figures.length ? section('figures', 'Figures', data.figures.map(figureView)) : null,
  section(
      'statuses', 'How the cells ended', data.wanting ? make('p', {class: 'alert'}, data.wanting) : null,
      data.remarks.map((text) => make('p', {class: 'small'}, text)), reasonsTable()),
  section('tables', 'Tables', tablesView()),
  section('provenance', 'Where it comes from', provenanceView()),
  section('config', 'Config', configView()),
].filter(Boolean);
const links = sections.map((one) => make('a', {href: `#${one.id}`}, one.querySelector('h2').textContent));
document.getElementById('report').append(
    headerView(), make('nav', {'aria-label': 'Sections'}, links, themeButton()), damageView() || '', ...sections,
    make(
        'footer', {class: 'faint small'},
        make('p', {}, 'Made by kreisel report. This file loads nothing and sends nothing.')));
document.documentElement.dataset.ready = 'true';
