// The program in its worker. Every run has a new instance of the WebAssembly, with the files that the page holds.
export interface Outcome {
  status: number;
  out: string;
  err: string;
  /** What the run wrote, of the paths that were asked for. */
  written: Map<string, Uint8Array>;
  /** Milliseconds in the worker. */
  time: number;
}

export interface Run {
  words: string[];
  /** Paths that are read after the run. */
  wanted?: string[];
}

/** From the page to the worker. */
export type Request =
  | { kind: 'files'; set: [string, Uint8Array][]; removed: string[] }
  | { kind: 'run'; id: number; words: string[]; wanted: string[] };

/** And back. */
export type Answer =
  | { kind: 'ready' }
  | { kind: 'done'; id: number; status: number; out: Uint8Array; err: Uint8Array; written: [string, Uint8Array][]; time: number }
  | { kind: 'failed'; id: number | null; reason: string };

interface Waiting {
  resolve: (outcome: Outcome) => void;
  reject: (reason: Error) => void;
}

export class Program {
  private readonly worker = new Worker('worker.js');
  private readonly waiting = new Map<number, Waiting>();
  private last = 0;
  readonly ready: Promise<void>;

  constructor() {
    this.ready = new Promise((resolve, reject) => {
      this.worker.onerror = (event) => reject(new Error(event.message || 'worker.js'));
      this.worker.onmessage = (event: MessageEvent<Answer>) => {
        const answer = event.data;
        if (answer.kind === 'ready') resolve();
        else if (answer.kind === 'failed' && answer.id === null) reject(new Error(answer.reason));
        else this.settle(answer);
      };
    });
  }

  private settle(answer: Exclude<Answer, { kind: 'ready' }>): void {
    const waiting = this.waiting.get(answer.id ?? 0);
    this.waiting.delete(answer.id ?? 0);
    if (answer.kind === 'failed') {
      waiting?.reject(new Error(answer.reason));
      return;
    }
    const decoder = new TextDecoder();
    waiting?.resolve({
      status: answer.status,
      out: decoder.decode(answer.out),
      err: decoder.decode(answer.err),
      written: new Map(answer.written),
      time: answer.time,
    });
  }

  private send(request: Request): void {
    this.worker.postMessage(request);
  }

  /** Gives files to the runs that follow, or takes them away. */
  update(set: [string, Uint8Array][], removed: string[] = []): void {
    this.send({ kind: 'files', set, removed });
  }

  run({ words, wanted = [] }: Run): Promise<Outcome> {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.send({ kind: 'run', id, words, wanted });
    });
  }
}
