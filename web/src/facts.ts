// What the program knows of the machines among the open files, and of that of the shown file.
import type { Program } from './program';

export interface Machine {
  machine: string;
  default_list?: string;
  default_channel_list?: string;
  axes: { name: string; list: string }[];
  groups?: { name?: string; axes: string[]; programs?: string[]; channel_list?: string }[];
}

/** A row of the question `machines`. */
export interface Described {
  /** What describes it: the list itself where no machine reads it. */
  path: string;
  machine: string;
  axes: string[];
  alone: boolean;
  cycle_time_us: number | null;
  /** The line or file that says it; null where none does. */
  cycle_time_from: string | null;
}

/** The machine that the shown file belongs to; null where there is none. */
export type Facts = { described: Described; machine: Machine } | null;

/** Null for what cannot be read: the check has said so. */
async function answered<Result>(program: Program, question: Record<string, string>): Promise<Result | null> {
  const { status, result } = await program.answer({ ...question, format: 'json' });
  return status === 0 ? (JSON.parse(result) as Result) : null;
}

const machinesOf = async (program: Program, input: string): Promise<Described[]> =>
  (await answered<{ machines: Described[] }>(program, { question: 'machines', input }))?.machines ?? [];

const machineAt = (program: Program, input: string): Promise<Machine | null> => answered(program, { question: 'machine', input });

/** The machines among the files, by the paths of what describes them. */
export async function machinesAmong(program: Program): Promise<Map<string, Machine>> {
  const found = new Map<string, Machine>();
  for (const { path } of await machinesOf(program, '.')) {
    const machine = await machineAt(program, path);
    if (machine) found.set(path, machine);
  }
  return found;
}

export async function factsOf(program: Program, input: string): Promise<Facts> {
  const [described] = await machinesOf(program, input);
  const machine = described ? await machineAt(program, described.path) : null;
  return described && machine ? { described, machine } : null;
}
