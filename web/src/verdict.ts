// The verdict on the open files, in words that cannot be overlooked, and what it is about.
import { byId } from './elements';
import type { Facts } from './facts';
import { counted, countOf, severities, type Finding } from './findings';
import { figure, say } from './texts';

export interface Checked {
  findings: readonly Finding[];
  /** How many were checked; null before the first result. */
  files: number | null;
  /** Why not everything could be checked; null where everything was. */
  trouble: string | null;
}

interface Verdict extends Checked {
  facts: Facts;
  /** Findings that `lint --fix` repairs. */
  safe: number;
  /** The path of the file in the editor. */
  shown: string;
}

function subject(facts: Facts, shown: string): string {
  if (!facts) return '';
  const { alone, machine, axes, cycle_time_us: time, cycle_time_from: place } = facts.described;
  if (alone) return say('alone', { file: shown });
  const values = { machine, axes: axes.join(', ') };
  if (time === null || place === null) return say('subjectAssumed', values);
  return say('subject', { ...values, time: say('from', { time: `${figure(time, 6)} µs`, place }) });
}

export type State = 'busy' | 'sound' | 'note' | 'warning' | 'error' | 'trouble';

/** What could not be checked is never sound, and neither is a check of nothing. */
export function stateOf({ findings, files, trouble }: Checked): State {
  if (files === null) return 'busy';
  if (trouble !== null || files === 0) return 'trouble';
  return severities.find((severity) => countOf(findings, severity) > 0) ?? 'sound';
}

function countsOf(findings: readonly Finding[]): string {
  const there = severities.filter((severity) => countOf(findings, severity) > 0);
  return there.map((severity) => counted(severity, countOf(findings, severity))).join(', ');
}

/** The verdict, and what to do next. */
function wordsOf(state: State, { findings, facts, files, trouble }: Verdict): [string, string] {
  const counts = countsOf(findings);
  switch (state) {
    case 'busy':
      return [say('checking'), ''];
    case 'trouble':
      return [[say(files === 0 ? 'notChecked' : 'partlyChecked'), counts].filter((part) => part !== '').join('; '), trouble ?? say('nothingToCheck')];
    case 'error':
      return [counts, say('nextErrors')];
    case 'warning':
      return [counts, say('nextWarnings')];
    case 'note':
    case 'sound':
      return [counts || say('nothing', { files: files === 1 ? say('file') : say('files', { count: files ?? 0 }) }), facts ? say('nextSound') : ''];
  }
}

export function showVerdict(verdict: Verdict): void {
  const { facts, safe, shown } = verdict;
  const state = stateOf(verdict);
  byId('verdict').dataset['state'] = state;
  [byId('counts').textContent, byId('next').textContent] = wordsOf(state, verdict);
  if (state === 'busy') return;
  byId('subject-words').textContent = subject(facts, shown);
  byId('cycle-line').hidden = facts !== null && facts.described.cycle_time_from !== null;
  const fix = byId<HTMLButtonElement>('fix-all');
  fix.textContent = say('fixAll', { count: safe });
  fix.disabled = safe === 0;
  fix.classList.toggle('primary', safe > 0);
  byId('compile').classList.toggle('primary', safe === 0 && state !== 'error' && state !== 'trouble');
}
