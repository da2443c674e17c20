// What is asked about the open files after they were checked, when there is time: their machines, and what --fix
// would repair.
import { factsOf, machinesAmong, type Facts, type Machine } from './facts';
import type { Finding } from './findings';
import { Interrupted, type Program } from './program';
import type { Workspace } from './workspace';

const pause = 200;  // ms without a check

interface Asking {
  readonly program: Program;
  readonly workspace: Workspace;
  readonly shown: string;
  readonly findings: readonly Finding[];
}

export class Survey {
  facts: Facts = null;
  /** The machines among the files, by their paths. */
  machines = new Map<string, Machine>();
  /** How many findings `lint --fix` repairs. */
  safe = 0;
  private waiting = 0;

  constructor(
    private readonly page: Asking,
    private readonly changed: () => void,
    private readonly failed: (failure: unknown) => void,
  ) {}

  forget(): void {
    [this.facts, this.machines, this.safe] = [null, new Map(), 0];
  }

  /** The first machine of new files. */
  async begin(): Promise<string | undefined> {
    await this.whileOpen(async (workspace) => {
      const machines = workspace.files.size > 1 ? await machinesAmong(this.page.program) : new Map<string, Machine>();
      if (workspace !== this.page.workspace) return;
      this.machines = machines;
      this.soon();
    });
    return [...this.machines.keys()][0];
  }

  soon(): void {
    clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => void this.whileOpen((workspace) => this.ask(workspace)), pause);
  }

  /** A failure is told as long as the files are still those that were asked about. */
  private async whileOpen(ask: (workspace: Workspace) => Promise<void>): Promise<void> {
    const { workspace } = this.page;
    try {
      await ask(workspace);
    } catch (failure) {
      if (workspace === this.page.workspace && !(failure instanceof Interrupted)) this.failed(failure);
    }
  }

  private async ask(workspace: Workspace): Promise<void> {
    const { program, shown, findings } = this.page;
    const safe = findings.some(({ fix }) => fix) ? (await program.fix(workspace.whole)).result.fixed : 0;
    const facts = await factsOf(program, shown);
    if (workspace !== this.page.workspace) return;
    if (findings === this.page.findings) this.safe = safe;
    if (shown === this.page.shown) this.facts = facts;
    this.changed();
  }
}
