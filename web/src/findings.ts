// Findings as `lint --format json` gives them, and the list that leads to their lines.
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

/** The page's name of a file: see named() of src/workspace.ts. */
const plain = (path: string): string => path.replace(/^\.\//, '');

export function findingsIn(json: string): Finding[] {
  const parsed = JSON.parse(json) as { diagnostics?: Finding[] };
  return (parsed.diagnostics ?? []).map((finding) => ({
    ...finding,
    file: plain(finding.file),
    fix: finding.fix ? { ...finding.fix, edits: finding.fix.edits.map((edit) => ({ ...edit, file: plain(edit.file) })) } : null,
  }));
}

export interface Actions {
  go: (finding: Finding) => void;
  fix: (finding: Finding) => void;
  explain: (code: string) => void;
}

function place(finding: Finding): string {
  return !finding.line ? finding.file : `${finding.file}:${finding.line}:${finding.column ?? 1}`;
}

function message(finding: Finding, actions: Actions): HTMLButtonElement {
  const leading = button('', () => actions.go(finding), { class: 'message' });
  leading.append(...spans(finding.message));
  return leading;
}

function item(finding: Finding, actions: Actions): HTMLLIElement {
  const control = finding.control?.reaction ?? null;
  return element(
    'li',
    { class: finding.severity },
    button(finding.code, () => actions.explain(finding.code), { class: 'code', title: say('explain', { code: finding.code }) }),
    element(
      'div',
      { class: 'words' },
      message(finding, actions),
      element('span', { class: 'place' }, finding.axis ? `${finding.axis} · ${place(finding)}` : place(finding)),
      control && element('span', { class: 'control' }, `${say('control')}: `, ...spans(control)),
      ...(finding.notes ?? []).map((note) => element('span', { class: 'control' }, ...spans(note))),
    ),
    finding.fix ? button(say('fix'), () => actions.fix(finding), { class: 'fix', title: finding.fix.title }) : null,
  );
}

const atFirst = 200;
const more = 1000;

/** The first of them; a button shows more. */
export function showFindings(list: HTMLElement, findings: readonly Finding[], actions: Actions, most = atFirst): void {
  const items = findings.slice(0, most).map((finding) => item(finding, actions));
  if (findings.length > most) {
    const rest = say('more', { count: findings.length - most });
    items.push(element('li', {}, button(rest, () => showFindings(list, findings, actions, most + more))));
  }
  list.replaceChildren(...items);
}

export function countsOf(findings: readonly Finding[]): string {
  if (findings.length === 0) return say('nothing');
  const counted = (['error', 'warning', 'note'] as const).map((severity) => {
    const count = findings.filter((finding) => finding.severity === severity).length;
    return count === 0 ? null : say(count === 1 ? severity : `${severity}s`, { count });
  });
  return counted.filter((text) => text !== null).join(', ');
}
