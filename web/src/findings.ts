// Findings as `lint --format json` gives them, and the list that leads to their lines.
import { button, element } from './elements';
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

export interface Finding extends Partial<Place> {
  code: string;
  name: string;
  severity: 'error' | 'warning' | 'note';
  message: string;
  file: string;
  parameter?: string | null;
  axis?: string | null;
  control?: { message: string | null; reaction: string | null; value: string | null } | null;
  notes?: string[];
  fix?: { title: string; edits: Edit[] } | null;
}

export function findingsIn(json: string): Finding[] {
  const parsed = JSON.parse(json) as { diagnostics?: Finding[] };
  return parsed.diagnostics ?? [];
}

export interface Actions {
  go: (finding: Finding) => void;
  fix: (finding: Finding) => void;
  explain: (code: string) => void;
}

function place(finding: Finding): string {
  return finding.line === undefined || finding.line === 0 ? finding.file : `${finding.file}:${finding.line}:${finding.column ?? 1}`;
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
      button(finding.message, () => actions.go(finding), { class: 'message' }),
      element('span', { class: 'place' }, finding.axis ? `${finding.axis} · ${place(finding)}` : place(finding)),
      control && element('span', { class: 'control' }, control),
      ...(finding.notes ?? []).map((note) => element('span', { class: 'control' }, note)),
    ),
    finding.fix ? button(say('fix'), () => actions.fix(finding), { class: 'fix', title: finding.fix.title }) : null,
  );
}

const mostShown = 2000;

export function showFindings(list: HTMLElement, findings: readonly Finding[], actions: Actions): void {
  const items = findings.slice(0, mostShown).map((finding) => item(finding, actions));
  if (findings.length > mostShown) items.push(element('li', {}, `… ${findings.length - mostShown}`));
  list.replaceChildren(...items);
}

export function countsOf(findings: readonly Finding[]): string {
  if (findings.length === 0) return say('nothing');
  const count = (severity: string): number => findings.filter((finding) => finding.severity === severity).length;
  return say('counts', { errors: count('error'), warnings: count('warning') });
}
