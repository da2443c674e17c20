// The Markdown that the program writes, as elements: headings, lists, code, pictures in data URIs. Anything
// else stays text, and addresses are not followed.
import { element } from './elements';

const picture = /^data:image\/svg\+xml[;,]/;
const inline = /`([^`]+)`|\*\*(.+?)\*\*|!\[(.*?)\]\(([^)\s]+)\)|\[([^\]]+)\]\(([^)\s]+)\)|\\([^\w\s])|(@)<!-- -->/g;

export function spans(text: string): (Node | string)[] {
  const parts: (Node | string)[] = [];
  let at = 0;
  for (const found of text.matchAll(inline)) {
    const [whole, code, strong, alternative, source, label, , escaped, sign] = found;
    parts.push(text.slice(at, found.index));
    if (code !== undefined) parts.push(element('code', {}, code));
    else if (strong !== undefined) parts.push(element('strong', {}, ...spans(strong)));
    else if (source !== undefined) parts.push(picture.test(source) ? element('img', { src: source, alt: alternative ?? '' }) : whole);
    else parts.push(label ?? escaped ?? sign ?? whole);
    at = found.index + whole.length;
  }
  return [...parts, text.slice(at)];
}

const isRow = (line: string): boolean => /^\|.*\|\s*$/.test(line);
const cells = (line: string): string[] =>
  line
    .trim()
    .slice(1, -1)
    .split(/(?<!\\)\|/)
    .map((cell) => cell.trim().replaceAll('\\|', '|'));

/** Numbers, which the second row says, are on the right. */
function table(rows: string[]): HTMLElement {
  const isRule = (row: string): boolean => /^\|[\s:|-]+\|\s*$/.test(row);
  const [head, ...body] = rows.filter((row) => !isRule(row));
  const isNumber = cells(rows.find(isRule) ?? '||').map((cell) => cell.endsWith(':'));
  const row = (line: string, cell: 'th' | 'td'): HTMLElement =>
    element('tr', {}, ...cells(line).map((text, i) => element(cell, isNumber[i] ? { class: 'number' } : {}, ...spans(text))));
  return element('table', { tabindex: '0' }, element('thead', {}, row(head ?? '||', 'th')), element('tbody', {}, ...body.map((line) => row(line, 'td'))));
}

/** The lines from `at` on for which `belongs` holds. */
function run(lines: string[], at: number, belongs: (line: string) => boolean): string[] {
  const end = lines.findIndex((line, i) => i >= at && !belongs(line));
  return lines.slice(at, end < 0 ? lines.length : end);
}

/** Blocks of the text, and how many lines each takes. */
function block(lines: string[], at: number): { made: HTMLElement; taken: number } {
  const line = lines[at] as string;
  const heading = /^(#+) (.*)$/.exec(line);
  if (heading) {
    const level = heading[1]?.length === 1 ? 'h3' : 'h4';
    return { made: element(level, {}, ...spans(heading[2] ?? '')), taken: 1 };
  }
  if (line.startsWith('```')) {
    const code = run(lines, at + 1, (one) => !one.startsWith('```'));
    return { made: element('pre', {}, code.join('\n')), taken: code.length + 2 };
  }
  if (line.startsWith('    ')) {
    const code = run(lines, at, (one) => one.startsWith('    '));
    return { made: element('pre', {}, code.map((one) => one.slice(4)).join('\n')), taken: code.length };
  }
  if (line.startsWith('- ')) {
    const items = run(lines, at, (one) => one.startsWith('- ') || /^ {2}\S/.test(one));
    const texts = items.join('\n').split(/^- /m).slice(1);
    return { made: element('ul', {}, ...texts.map((text) => element('li', {}, ...spans(text.trim())))), taken: items.length };
  }
  if (isRow(line)) {
    const rows = run(lines, at, isRow);
    return { made: table(rows), taken: rows.length };
  }
  const text = run(lines, at, (one) => one !== '' && !/^(#+ |```|- |\|)/.test(one));
  const taken = Math.max(1, text.length);
  return { made: element('p', {}, ...spans(lines.slice(at, at + taken).join('\n'))), taken };
}

export function markdown(text: string): HTMLElement {
  const page = element('div', { class: 'markdown' });
  const lines = text.split('\n');
  for (let at = 0; at < lines.length; ) {
    if (lines[at] === '') {
      at += 1;
      continue;
    }
    const { made, taken } = block(lines, at);
    page.append(made);
    at += taken;
  }
  return page;
}
