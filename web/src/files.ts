// The open files, by what they are for: machine, axes, channels, programs.
import { button, element } from './elements';
import type { Machine } from './facts';
import type { Finding } from './findings';
import { say, type Key } from './texts';
import type { Workspace } from './workspace';

export const isProgram = (path: string): boolean => /\.nc$/i.test(path);

const kinds = ['kindMachine', 'kindAxes', 'kindDefaults', 'kindChannels', 'kindPrograms', 'kindRecordings', 'kindOthers'] as const satisfies readonly Key[];
interface Row {
  kind: (typeof kinds)[number];
  path: string;
  /** The axis or channel whose list it is. */
  name: string;
}

type Machines = readonly (readonly [path: string, machine: Machine])[];

/** What a file is for: in the first machine that has it. */
function rowOf(path: string, machines: Machines, isRecording: boolean): Row {
  for (const [described, machine] of machines) {
    const axes = machine.axes.filter(({ list }) => list === path).map(({ name }) => name);
    const group = machine.groups?.find((one) => one.channel_list === path);
    if (axes.length > 0) return { kind: 'kindAxes', path, name: axes.join(', ') };
    if (path === described) return { kind: 'kindMachine', path, name: machine.machine };
    if (path === machine.default_list || path === machine.default_channel_list) return { kind: 'kindDefaults', path, name: '' };
    if (group) return { kind: 'kindChannels', path, name: group.name ?? group.axes.join('') };
  }
  return { kind: isProgram(path) ? 'kindPrograms' : isRecording ? 'kindRecordings' : 'kindOthers', path, name: '' };
}

function rowsOf({ paths, recordings }: Workspace, machines: Machines): Row[] {
  const order = machines.flatMap(([, { axes }]) => axes.map(({ list }) => list));
  return paths
    .map((path) => rowOf(path, machines, recordings.includes(path)))
    .sort((a, b) => kinds.indexOf(a.kind) - kinds.indexOf(b.kind) || order.indexOf(a.path) - order.indexOf(b.path) || a.path.localeCompare(b.path));
}

export function showFiles(list: HTMLElement, workspace: Workspace, machines: Machines, findings: readonly Finding[], shown: string, choose: (path: string) => void): void {
  const rows = rowsOf(workspace, machines);
  const counts = new Map<string, { count: number; worst: string }>();
  for (const { file, severity } of findings) {
    if (severity === 'note') continue;
    const { count = 0, worst = severity } = counts.get(file) ?? {};
    counts.set(file, { count: count + 1, worst: severity === 'error' ? severity : worst });
  }
  const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);
  const isTwice = (path: string): boolean => rows.filter((row) => nameOf(row.path) === nameOf(path)).length > 1;
  const onlyOthers = rows.every(({ kind }) => kind === 'kindOthers');
  let before: string | null = null;
  list.replaceChildren(
    ...rows.flatMap(({ kind, path, name }) => {
      const heading = kind === before || onlyOthers ? [] : [element('li', { class: 'folder' }, say(kind))];
      before = kind;
      const found = counts.get(path);
      const isChanged = workspace.isChanged(path);
      const row = button('', () => choose(path), { 'aria-current': String(path === shown), title: path });
      row.append(
        ...(name === '' ? [] : [element('b', {}, name)]),
        element('span', { class: 'name' }, isTwice(path) ? path : nameOf(path)),
        ...(isChanged ? [element('span', { class: 'changed', role: 'img', 'aria-label': say('isChanged') }, '●')] : []),
        ...(found ? [element('span', { class: `count ${found.worst}` }, String(found.count))] : []),
      );
      return [...heading, element('li', {}, row)];
    }),
  );
}
