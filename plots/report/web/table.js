// SPDX-License-Identifier: BSD-3-Clause
// Tables that sort by a click on a title and filter by words, column:word, column<number, column>number.

const rowsAtFirst = 300;

// A column of the data with its value in each row: a number, a text (also of a number with more digits than a double
// holds), or null.
function readColumn(column) {
  const match = column.title.match(/^(.*) \[(.*)\]$/);
  const value = 'same' in column ? () => column.same :
      column.numbers             ? (row) => column.numbers[row] :
                                   (row) => column.texts[column.index[row]];
  const isNumber = 'same' in column ? typeof column.same === 'number' : Boolean(column.numbers);
  return {
    title: column.title,
    name: match ? match[1] : column.title,
    unit: match && match[2] !== '1' ? match[2] : '',
    same: 'same' in column,
    isNumber,
    value
  };
}
const readTable = (table) => ({...table, columns: (table.columns || []).map(readColumn)});

const isEmpty = (value) => value === null || value === undefined || value === '';
// Absent values come last, whatever the direction.
function compareValues(a, b, direction, isNumber) {
  if (isEmpty(a) || isEmpty(b)) return isEmpty(a) - isEmpty(b);
  if (isNumber) return direction * (Number(a) - Number(b));
  return direction * String(a).localeCompare(String(b), 'en', {numeric: true});
}

// Tests of the words of a filter, all of which a row must pass.
function rowTests(text, columns) {
  const named = (name) =>
      columns.find((column) => column.name === name) || columns.find((column) => column.title === name);
  const has = (column, row, word) => String(column.value(row) ?? '').toLowerCase().includes(word.toLowerCase());
  return (text.match(/(?:[^\s"]|"[^"]*")+/g) || []).map((written) => {
    const word = written.replace(/"/g, '');
    const bound = word.match(/^([^<>]+)([<>])(.+)$/);
    const column = bound && named(bound[1]);
    if (column && Number.isFinite(Number(bound[3]))) {
      return (row) => !isEmpty(column.value(row)) &&
          (bound[2] === '<' ? Number(column.value(row)) < Number(bound[3]) :
                              Number(column.value(row)) > Number(bound[3]));
    }
    const colon = word.indexOf(':');
    const within = colon > 0 && named(word.slice(0, colon));
    if (within) return (row) => has(within, row, word.slice(colon + 1));
    return (row) => columns.some((one) => has(one, row, word));
  });
}

const csvField = (text) => (/[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
function csvOf(columns, rows) {
  const line = (fields) => fields.map((field) => csvField(exactText(field))).join(',') + '\n';
  return line(columns.map((column) => column.title)) +
      rows.map((row) => line(columns.map((column) => column.value(row)))).join('');
}

// What every row has is said once, above the table.
function sameInAll(table) {
  const same = table.rows > 1 ? table.columns.filter((column) => column.same && !isEmpty(column.value(0))) : [];
  if (!same.length) return null;
  const texts = same.map((column) => `${column.title}: ${exactText(column.value(0))}`);
  return make('p', {class: 'faint small'}, `The same in all ${table.rows} rows: ${texts.join('; ')}`);
}

// `minor(column)`: shown only on request.
function tableView(table, {minor = () => false, rowClass = () => ''} = {}) {
  const all = [...Array(table.rows).keys()];
  const shown = table.columns.filter((column) => !(column.same && table.rows > 1));
  const state = {key: null, direction: 1, filter: '', digits: false, every: false, limit: rowsAtFirst};
  const search = make('input', {
    type: 'search',
    placeholder: 'rk4   method:rkmk   h<0.01',
    'aria-label': `Filter rows of ${table.title}`,
    oninput: () => {
      state.filter = search.value;
      state.limit = rowsAtFirst;
      update();
    }
  });
  const counted = make('span', {role: 'status'});
  const check = (text, key) => make(
      'label', {}, make('input', {
        type: 'checkbox',
        onchange: (event) => {
          state[key] = event.target.checked;
          update();
        }
      }),
      text);
  const head = make('tr'), body = make('tbody');
  const more = make('button', {
    type: 'button',
    onclick: () => {
      state.limit = Infinity;
      update();
    }
  });
  const visible = () => shown.filter((column) => state.every || !minor(column));
  const rows = () => {
    const tests = rowTests(state.filter, table.columns);
    const kept = all.filter((row) => tests.every((test) => test(row)));
    const {key, direction} = state;
    return key ? kept.sort((a, b) => compareValues(key.value(a), key.value(b), direction, key.isNumber)) : kept;
  };
  function title(column) {
    const sorted = state.key === column ? (state.direction > 0 ? 'ascending' : 'descending') : null;
    const sort = () => {
      state.direction = state.key === column ? -state.direction : 1;
      state.key = column;
      update(column);
    };
    return make(
        'th', {scope: 'col', class: column.isNumber && 'number', 'aria-sort': sorted},
        make(
            'button', {type: 'button', onclick: sort}, column.name,
            column.unit && make('span', {class: 'unit'}, ` [${column.unit}]`)));
  }
  function cell(column, row) {
    const value = column.value(row), exact = exactText(value);
    const text = column.isNumber && !state.digits ? shortText(value) : exact;
    return make(
        'td', {
          class: column.isNumber       ? 'number' :
              column.name === 'reason' ? 'reason' :
                                         null,
          title: text === exact ? null : exact
        },
        text);
  }
  function update(focused) {
    const columns = visible(), kept = rows();
    head.replaceChildren(...columns.map(title));
    body.replaceChildren(
        ...kept.slice(0, state.limit)
            .map((row) => make('tr', {class: rowClass(table, row)}, columns.map((column) => cell(column, row)))));
    counted.textContent =
        kept.length === table.rows ? count(table.rows, 'row') : `${kept.length} of ${count(table.rows, 'row')}`;
    more.hidden = kept.length <= state.limit;
    more.textContent = `show the other ${kept.length - state.limit}`;
    if (focused) head.children[columns.indexOf(focused)].firstChild.focus();
  }
  const csv = make(
      'button', {
        type: 'button',
        onclick: () => save(
            `${data.name}.${table.name}.csv`, 'text/csv',
            csvOf(state.every ? table.columns : table.columns.filter((column) => !minor(column)), rows()))
      },
      'Save as CSV');
  update();
  return make(
      'div', {class: 'table'}, sameInAll(table),
      make(
          'div', {class: 'bar'}, search, counted, check('all digits', 'digits'),
          shown.some(minor) ? check('all columns', 'every') : null, csv),
      make(
          'div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': table.title},
          make('table', {}, make('caption', {class: 'unseen'}, table.title), make('thead', {}, head), body)),
      more);
}
