// What the program knows of the machines among the open files, and of that of the shown file.
import type { Program } from './program';

export interface Machine {
  machine: string;
  cycle_time_us?: number;
  default_list?: string;
  default_channel_list?: string;
  axes: { name: string; list: string }[];
  groups?: { name?: string; axes: string[]; programs?: string[]; channel_list?: string }[];
}

export interface Facts {
  /** The file that describes the machine, and what the machine consists of; null where the list stands alone. */
  path: string;
  machine: Machine | null;
  /** "2000 µs" and the place that says so; null where no file does. */
  cycleTime: { time: string; place: string } | null;
}

export const noFacts: Facts = { path: '', machine: null, cycleTime: null };

/** Files that may describe a machine, whatever they are named. */
const mayBeMachine = /(^|\/)(hochlauf[^/]*\.lis|[^/]*\.(tsproj|xti|json))$/i;
const most = 12;

async function machineAt(program: Program, input: string): Promise<Machine | null> {
  const { result } = await program.answer({ question: 'machine', input, format: 'json' });
  if (result === '') return null;
  const machine = JSON.parse(result) as Machine;
  return (machine.axes ?? []).length > 0 ? machine : null;
}

const machineOf = async (program: Program, input: string): Promise<string> => (await program.answer({ question: 'machine_of', input })).result;

/** The machines among the files, by the paths of what describes them. */
export async function machinesAmong(program: Program, paths: readonly string[]): Promise<Map<string, Machine>> {
  const list = paths.find((path) => /\.lis$/i.test(path));
  const candidates = paths.filter((path) => mayBeMachine.test(path)).slice(0, most);
  if (list !== undefined) candidates.push(await machineOf(program, list));
  const found = new Map<string, Machine>();
  for (const path of candidates) {
    const machine = path === list || found.has(path) || !paths.includes(path) ? null : await machineAt(program, path);
    if (machine) found.set(path, machine);
  }
  return new Map([...found].sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** The first fact of the answer for people is the cycle time, with its place in brackets. */
const timeIn = /^- [^:]+: ([^(\n]*?)(?: \(([^()\n]*)\))?$/m;

export async function factsOf(program: Program, input: string, textOf: (path: string) => string): Promise<Facts> {
  const path = await machineOf(program, input);
  const machine = await machineAt(program, input);
  if (machine === null) return { ...noFacts, path };
  const { result } = await program.answer({ question: 'machine', input, format: 'markdown' });
  const [, time = '', place] = timeIn.exec(result) ?? [];
  const isSaid = place !== undefined || /"cycle_time_us"/.test(textOf(path));
  return { path, machine, cycleTime: isSaid ? { time, place: place ?? path } : null };
}
