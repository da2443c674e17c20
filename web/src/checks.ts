// One check after the other, until the present state has been checked.
import { Interrupted, type Timed } from './program';

export const reasonOf = (failure: unknown): string => (failure instanceof Error ? failure.message : String(failure));

export class Checks {
  private isChecking = false;
  private isStale = false;
  private since = 0;

  constructor(
    /** Null if there is nothing to check any more. */
    private readonly check: () => Promise<Timed<string> | null>,
    private readonly failed: (failure: unknown) => void,
  ) {}

  async again(): Promise<void> {
    this.isStale = true;
    this.since = performance.now();
    if (this.isChecking) return;
    this.isChecking = true;
    while (this.isStale) {
      this.isStale = false;
      await this.once();
    }
    this.isChecking = false;
  }

  private async once(): Promise<void> {
    try {
      const outcome = await this.check();
      if (outcome) this.finished(outcome);
    } catch (failure) {
      if (!(failure instanceof Interrupted)) this.failed(failure);
    }
  }

  /** For tests that measure the page. */
  private finished(outcome: Timed<string>): void {
    const data = document.body.dataset;
    data['checked'] = String(Number(data['checked'] ?? 0) + 1);
    data['time'] = outcome.time.toFixed(1);
    data['first'] ??= performance.now().toFixed(1);
    data['latency'] = (performance.now() - this.since).toFixed(1);
  }
}
