// What is asked about the open files after they were checked, when there is time: their machines, and what --fix
// would repair.
import { decode } from './encoding';
import { factsOf, machinesAmong, noFacts, type Facts, type Machine } from './facts';
import type { Finding } from './findings';
import type { Changed, Program } from './program';
import type { Workspace } from './workspace';

const pause = 200;  // ms without a check

interface Asking {
  readonly program: Program;
  readonly workspace: Workspace;
  readonly shown: string;
  readonly findings: readonly Finding[];
}

/** How many of the findings the new files repair: fixes keep their lines. */
function repairedBy(files: Changed, findings: readonly Finding[], workspace: Workspace): number {
  const changed = new Set<string>();
  for (const [path, bytes] of files) {
    const before = workspace.text(path)?.text.split('\n') ?? [];
    decode(bytes).text.split('\n').forEach((line, i) => line !== before[i] && changed.add(`${path.replace(/^\.\//, '')}:${i + 1}`));
  }
  return findings.filter(({ fix }) => fix?.edits.some(({ file, line }) => changed.has(`${file}:${line}`))).length;
}

export class Survey {
  facts: Facts = noFacts;
  /** The machines among the files, by their paths. */
  machines = new Map<string, Machine>();
  /** How many findings `lint --fix` repairs. */
  safe = 0;
  private waiting = 0;

  constructor(
    private readonly page: Asking,
    private readonly changed: () => void,
  ) {}

  forget(): void {
    [this.facts, this.machines, this.safe] = [noFacts, new Map(), 0];
  }

  /** The first machine of new files. */
  async begin(): Promise<string | undefined> {
    const { program, workspace } = this.page;
    const machines = workspace.files.size > 1 ? await machinesAmong(program, workspace.paths) : new Map<string, Machine>();
    if (workspace !== this.page.workspace) return undefined;
    this.machines = machines;
    this.soon();
    return [...machines.keys()][0];
  }

  soon(): void {
    clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => void this.ask().catch(() => undefined), pause);
  }

  private async ask(): Promise<void> {
    const { program, workspace, shown, findings } = this.page;
    const repaired = findings.some(({ fix }) => fix) ? (await program.fix(workspace.whole)).result : [];
    const facts = await factsOf(program, shown, (path) => workspace.text(path)?.text ?? '');
    if (workspace !== this.page.workspace) return;
    if (findings === this.page.findings) this.safe = repairedBy(repaired, findings, workspace);
    if (shown === this.page.shown) this.facts = facts;
    this.changed();
  }
}
