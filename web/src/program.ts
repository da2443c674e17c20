// The program in its worker, with the files that the page holds.
import type { Options, Outcome } from '../interface/axisc.mjs';
import { startWorker, type Parts } from './parts';

/** What is asked of the library (axisc.h); the answer of `file` is bytes. */
export type Call =
  | { name: 'check' | 'fix' | 'compile'; path: string }
  | { name: 'answer'; question: Record<string, string | undefined> }
  | { name: 'file'; question: Record<string, string | undefined> };

/** A request to the language server about a list. */
export interface Question {
  path: string;
  text: string;
  /** Without its `textDocument/`. */
  method: string;
  /** Parameters in addition to the list. */
  more: object;
}

/** Files that a repair changed, and how many findings it repaired. */
export interface Repair {
  changed: [string, Uint8Array][];
  fixed: number;
}

/** From the page to the worker. */
export type Request =
  | { kind: 'module'; module: WebAssembly.Module }
  | { kind: 'files'; set: [string, Uint8Array][]; removed: string[] }
  | { kind: 'call'; id: number; options: Options; call: Call }
  | { kind: 'ask'; id: number; options: Options; question: Question };

/** And back. */
export type Answer =
  | { kind: 'done'; id: number; outcome: Outcome<unknown>; time: number }
  | { kind: 'told'; id: number; result: unknown }
  | { kind: 'failed'; id: number; reason: string };

/** With the milliseconds in the worker. */
export type Timed<Result> = Outcome<Result> & { time: number };

type Settled = Exclude<Answer, { kind: 'failed' }>;

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
  /** Why there is no program. */
  private failure: Error | null = null;

  constructor(
    private readonly parts: Parts,
    private readonly options: () => Options,
  ) {
    this.worker = this.listen(parts.worker);
    parts.module.catch((reason: Error) => this.abandon((this.failure = reason)));
  }

  private listen(worker: Worker): Worker {
    worker.onmessage = ({ data }: MessageEvent<Answer>) => this.settle(data);
    worker.onerror = (event) => this.abandon(new Error(event.message || 'worker.js'));
    return worker;
  }

  private settle(answer: Answer): void {
    const waiting = this.waiting.get(answer.id);
    this.waiting.delete(answer.id);
    if (answer.kind === 'failed') waiting?.reject(new Error(answer.reason));
    else waiting?.resolve(answer);
  }

  private abandon(reason: Error): void {
    for (const { reject } of this.waiting.values()) reject(reason);
    this.waiting.clear();
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
    this.abandon(new Interrupted());
    this.worker = this.listen(startWorker(this.parts));
    this.send({ kind: 'files', set: [...this.files], removed: [] });
  }

  /** Findings as JSON. */
  check(path: string): Promise<Timed<string>> {
    return this.call({ name: 'check', path });
  }

  fix(path: string): Promise<Timed<Repair>> {
    return this.call({ name: 'fix', path });
  }

  /** An image. */
  compile(path: string): Promise<Timed<Uint8Array>> {
    return this.call({ name: 'compile', path });
  }

  /** An FMU of the filters of a machine. */
  fmu(path: string, name: string): Promise<Timed<Uint8Array>> {
    return this.call({ name: 'file', question: { question: 'fmu', input: path, name } });
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
    if (this.failure) return Promise.reject(this.failure);
    if (this.waiting.size === 0) this.begun = performance.now();
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.send(made(id));
    });
  }
}
