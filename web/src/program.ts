// The program in its worker, with the files that the page holds.
import type { Options, Outcome } from '../interface/axisc.mjs';

/** What is asked of the library (axisc.h). */
export type Call =
  | { name: 'check' | 'fix' | 'compile'; path: string }
  | { name: 'answer'; question: Record<string, string | undefined> };

/** A request to the language server about a list. */
export interface Question {
  path: string;
  text: string;
  /** Without its `textDocument/`. */
  method: string;
  /** Parameters in addition to the list. */
  more: object;
}

/** Files that a repair changed. */
export type Changed = [string, Uint8Array][];

/** From the page to the worker. */
export type Request =
  | { kind: 'files'; set: [string, Uint8Array][]; removed: string[] }
  | { kind: 'call'; id: number; options: Options; call: Call }
  | { kind: 'ask'; id: number; options: Options; question: Question };

/** And back. */
export type Answer =
  | { kind: 'ready' }
  | { kind: 'done'; id: number; outcome: Outcome<unknown>; time: number }
  | { kind: 'told'; id: number; result: unknown }
  | { kind: 'failed'; id: number | null; reason: string };

/** The worker, as src/start.ts leaves it. */
export interface Started {
  worker: Worker;
  early: MessageEvent<Answer>[];
}

/** With the milliseconds in the worker. */
export type Timed<Result> = Outcome<Result> & { time: number };

type Settled = Exclude<Answer, { kind: 'ready' | 'failed' }>;

interface Waiting {
  resolve: (answer: Settled) => void;
  reject: (reason: Error) => void;
}

/** A run that interrupt() ended. */
export class Interrupted extends Error {}

const patience = 1000;  // ms

export class Program {
  private worker: Worker;
  private readonly files = new Map<string, Uint8Array>();
  private begun = 0;
  private readonly waiting = new Map<number, Waiting>();
  private last = 0;
  ready: Promise<void>;

  constructor(
    { worker, early }: Started,
    private readonly options: () => Options,
  ) {
    this.worker = worker;
    this.ready = this.listen(early);
  }

  private listen(early: MessageEvent<Answer>[]): Promise<void> {
    return new Promise((resolve, reject) => {
      const take = ({ data: answer }: MessageEvent<Answer>): void => {
        if (answer.kind === 'ready') resolve();
        else if (answer.kind === 'failed' && answer.id === null) reject(new Error(answer.reason));
        else this.settle(answer);
      };
      this.worker.onerror = (event) => reject(new Error(event.message || 'worker.js'));
      this.worker.onmessage = take;
      early.forEach(take);
    });
  }

  private settle(answer: Exclude<Answer, { kind: 'ready' }>): void {
    const waiting = this.waiting.get(answer.id ?? 0);
    this.waiting.delete(answer.id ?? 0);
    if (answer.kind === 'failed') {
      waiting?.reject(new Error(answer.reason));
      return;
    }
    waiting?.resolve(answer);
  }

  private send(request: Request): void {
    this.worker.postMessage(request);
  }

  /** Gives files to the calls that follow, or takes them away. */
  update(set: [string, Uint8Array][], removed: string[] = []): void {
    for (const path of removed) this.files.delete(path);
    for (const [path, bytes] of set) this.files.set(path, bytes);
    this.send({ kind: 'files', set, removed });
  }

  /** Ends a long run whose result is not wanted any more. */
  interrupt(): void {
    if (this.waiting.size === 0 || performance.now() - this.begun < patience) return;
    this.worker.terminate();
    for (const { reject } of this.waiting.values()) reject(new Interrupted());
    this.waiting.clear();
    this.worker = new Worker('worker.js');
    this.ready = this.listen([]);
    this.send({ kind: 'files', set: [...this.files], removed: [] });
  }

  /** Findings as JSON. */
  check(path: string): Promise<Timed<string>> {
    return this.call({ name: 'check', path });
  }

  fix(path: string): Promise<Timed<Changed>> {
    return this.call({ name: 'fix', path });
  }

  /** An image. */
  compile(path: string): Promise<Timed<Uint8Array>> {
    return this.call({ name: 'compile', path });
  }

  answer(question: Record<string, string | undefined>): Promise<Timed<string>> {
    return this.call({ name: 'answer', question });
  }

  private async call<Result>(call: Call): Promise<Timed<Result>> {
    const answer = await this.request((id) => ({ kind: 'call', id, options: this.options(), call }));
    if (answer.kind !== 'done') throw new Error(answer.kind);
    return { ...(answer.outcome as Outcome<Result>), time: answer.time };
  }

  /** The answer of the language server; null where it has none. */
  async ask(question: Question): Promise<unknown> {
    const answer = await this.request((id) => ({ kind: 'ask', id, options: this.options(), question }));
    if (answer.kind !== 'told') throw new Error(answer.kind);
    return answer.result;
  }

  private request(made: (id: number) => Request): Promise<Settled> {
    if (this.waiting.size === 0) this.begun = performance.now();
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.send(made(id));
    });
  }
}
