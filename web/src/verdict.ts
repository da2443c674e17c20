// The verdict on the open files, in words that cannot be overlooked, and what it is about.
import { byId } from './elements';
import type { Facts } from './facts';
import { counted, countOf, severities, type Finding } from './findings';
import { say } from './texts';

/** `safe`: findings that `lint --fix` repairs. */
type Verdict = { words: string } | { findings: readonly Finding[]; facts: Facts; files: number; safe: number };

function subject({ path, machine, cycleTime }: Facts): string {
  if (machine === null) return '';
  if (machine.axes.some(({ list }) => list === path)) return say('alone', { file: path });
  const values = { machine: machine.machine, axes: machine.axes.map((axis) => axis.name).join(', ') };
  return cycleTime ? say('subject', { ...values, time: say('from', cycleTime) }) : say('subjectAssumed', values);
}

export function showVerdict(verdict: Verdict): void {
  const place = byId('verdict');
  if ('words' in verdict) {
    place.dataset['state'] = 'busy';
    byId('counts').textContent = verdict.words;
    byId('next').textContent = '';
    return;
  }
  const { findings, facts, files, safe } = verdict;
  const worst = severities.find((severity) => countOf(findings, severity) > 0);
  place.dataset['state'] = worst ?? 'sound';
  const there = severities.filter((severity) => countOf(findings, severity) > 0);
  const words = there.map((severity) => counted(severity, countOf(findings, severity))).join(', ');
  byId('counts').textContent = words || say('nothing', { files: files === 1 ? say('file') : say('files', { count: files }) });
  const next = worst === 'error' ? 'nextErrors' : worst === 'warning' ? 'nextWarnings' : facts.machine ? 'nextSound' : null;
  byId('next').textContent = next ? say(next) : '';
  byId('subject-words').textContent = subject(facts);
  byId('cycle-line').hidden = facts.cycleTime !== null;
  const fix = byId<HTMLButtonElement>('fix-all');
  fix.textContent = say('fixAll', { count: safe });
  fix.disabled = safe === 0;
  fix.classList.toggle('primary', safe > 0);
  byId('compile').classList.toggle('primary', safe === 0 && worst !== 'error');
}
