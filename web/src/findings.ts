// Findings as `lint --format json` gives them, and the list that leads to their lines: errors first, equal ones
// folded into one.
import { button, element } from './elements';
import { spans } from './markdown';
import { say } from './texts';

export interface Place {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
}

export interface Edit extends Place {
  text: string;
}

export interface Finding {
  code: string;
  name: string;
  severity: 'error' | 'warning' | 'note';
  message: string;
  file: string;
  /** Null where a finding is about the whole file. */
  line: number | null;
  column: number | null;
  end_line: number | null;
  end_column: number | null;
  parameter?: string | null;
  axis?: string | null;
  control?: { message: string | null; reaction: string | null; value: string | null } | null;
  notes?: string[];
  fix?: { title: string; edits: Edit[] } | null;
}

export const severities = ['error', 'warning', 'note'] as const;
export type Severity = (typeof severities)[number];

/** The page's name of a file. */
const plain = (path: string): string => path.replace(/^\.\//, '');

export function findingsIn(json: string): { findings: Finding[]; files: number } {
  const parsed = JSON.parse(json) as { diagnostics?: Finding[]; summary?: { files: number } };
  const findings = (parsed.diagnostics ?? []).map((finding) => ({
    ...finding,
    file: plain(finding.file),
    fix: finding.fix ? { ...finding.fix, edits: finding.fix.edits.map((edit) => ({ ...edit, file: plain(edit.file) })) } : null,
  }));
  return { findings, files: parsed.summary?.files ?? 0 };
}

export const countOf = (findings: readonly Finding[], severity: Severity): number =>
  findings.filter((finding) => finding.severity === severity).length;

const many = { error: ['oneError', 'manyErrors'], warning: ['oneWarning', 'manyWarnings'], note: ['oneNote', 'manyNotes'] } as const;
export const counted = (severity: Severity, count: number): string => say(many[severity][count === 1 ? 0 : 1], { count });

/** Findings that say the same, the severest first, otherwise in their order. */
function grouped(findings: readonly Finding[]): Finding[][] {
  const groups = new Map<string, Finding[]>();
  for (const finding of findings) {
    const key = [finding.severity, finding.code, finding.message, finding.fix?.title].join('\n');
    const group = groups.get(key);
    if (group) group.push(finding);
    else groups.set(key, [finding]);
  }
  const rank = ([finding]: Finding[]): number => severities.indexOf(finding?.severity ?? 'note');
  return [...groups.values()].sort((a, b) => rank(a) - rank(b));
}

export interface Actions {
  go: (finding: Finding) => void;
  fix: (findings: readonly Finding[]) => void;
  explain: (code: string) => void;
}

function place(finding: Finding, actions: Actions): HTMLElement {
  const text = !finding.line ? finding.file : `${finding.file}:${finding.line}:${finding.column ?? 1}`;
  return button(finding.axis ? `${finding.axis} · ${text}` : text, () => actions.go(finding), { class: 'place' });
}

const placesAtFirst = 100;

function more(rest: readonly Finding[], actions: Actions): HTMLElement {
  const places = rest.slice(0, placesAtFirst).map((finding) => place(finding, actions));
  const words = rest.length === 1 ? say('onePlace') : say('places', { count: rest.length });
  return element('details', {}, element('summary', {}, words), ...places, rest.length > placesAtFirst && '…');
}

function item(group: readonly Finding[], actions: Actions): HTMLLIElement {
  const [finding, ...rest] = group as [Finding, ...Finding[]];
  const message = button('', () => actions.go(finding), { class: 'message' });
  message.append(...spans(finding.message));
  const reaction = finding.control?.reaction ?? null;
  const fixing = group.length === 1 ? say('fix') : say('fixMany', { count: group.length });
  return element(
    'li',
    { class: finding.severity },
    element(
      'div',
      { class: 'kind' },
      element('span', { class: 'severity' }, say(finding.severity)),
      button(finding.code, () => actions.explain(finding.code), { class: 'code', title: say('explain', { code: finding.code }) }),
    ),
    element(
      'div',
      { class: 'words' },
      message,
      place(finding, actions),
      rest.length > 0 && more(rest, actions),
      reaction && element('span', { class: 'control' }, `${say('control')}: `, ...spans(reaction)),
      ...(finding.notes ?? []).map((note) => element('span', { class: 'control' }, ...spans(note))),
      finding.fix && element('span', { class: 'remedy' }, button(fixing, () => actions.fix(group), { class: 'fix' }), ' ', ...spans(finding.fix.title)),
    ),
  );
}

const atFirst = 200;
const further = 1000;

/** The first of them; a button shows more. */
export function showFindings(list: HTMLElement, findings: readonly Finding[], actions: Actions, most = atFirst): void {
  const groups = grouped(findings);
  const items = groups.slice(0, most).map((group) => item(group, actions));
  if (groups.length > most) {
    const rest = say('more', { count: groups.length - most });
    items.push(element('li', {}, button(rest, () => showFindings(list, findings, actions, most + further))));
  }
  list.replaceChildren(...items);
}

/** Chooses a severity among those that there are; null: all. */
export function showFilters(line: HTMLElement, findings: readonly Finding[], chosen: Severity | null, choose: (severity: Severity | null) => void): void {
  const there = severities.filter((severity) => countOf(findings, severity) > 0);
  const one = (text: string, severity: Severity | null): HTMLElement =>
    button(text, () => choose(severity), { 'aria-pressed': String(severity === chosen), class: severity ?? 'all' });
  line.hidden = there.length < 2;
  line.replaceChildren(one(`${say('all')} (${findings.length})`, null), ...there.map((severity) => one(counted(severity, countOf(findings, severity)), severity)));
}
