// Runs the program: one compiled module, an instance for each run, a file system in memory for each instance.
import type { Answer, Request } from './program';

interface Module {
  FS: {
    init(input: () => number | null, output: (byte: number | null) => void, error: (byte: number | null) => void): void;
    mkdirTree(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
    readFile(path: string): Uint8Array;
    analyzePath(path: string): { exists: boolean };
    chdir(path: string): void;
  };
  ENV: Record<string, string>;
  callMain(words: string[]): number | undefined;
}

declare function createAxisc(options: object): Promise<Module>;
declare function importScripts(...scripts: string[]): void;

const folder = '/work';
const files = new Map<string, Uint8Array>();

function answer(message: Answer, transferred: Transferable[] = []): void {
  (self as unknown as { postMessage(message: Answer, transferred: Transferable[]): void }).postMessage(message, transferred);
}

/** Bytes as they come. */
class Stream {
  private bytes = new Uint8Array(4096);
  private size = 0;

  add(byte: number | null): void {
    if (byte === null) return;
    if (this.size === this.bytes.length) {
      const longer = new Uint8Array(2 * this.size);
      longer.set(this.bytes);
      this.bytes = longer;
    }
    this.bytes[this.size++] = byte;
  }

  taken(): Uint8Array {
    return this.bytes.slice(0, this.size);
  }
}

async function run(compiled: WebAssembly.Module, words: string[], wanted: string[]) {
  const out = new Stream();
  const err = new Stream();
  let status = 0;
  const program = await createAxisc({
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
      void WebAssembly.instantiate(compiled, imports).then(done);
      return {};
    },
    preRun: [
      (module: Module) => {
        module.FS.init(() => null, (byte) => out.add(byte), (byte) => err.add(byte));
        for (const name of Object.keys(module.ENV)) delete module.ENV[name];
        Object.assign(module.ENV, { LANG: 'C.UTF-8', NO_COLOR: '1' });
      },
    ],
    onExit: (code: number) => (status = code),
    quit: (code: number) => (status = code),
  });
  program.FS.mkdirTree(folder);
  for (const [path, bytes] of files) {
    const whole = path.startsWith('/') ? path : `${folder}/${path}`;
    program.FS.mkdirTree(whole.slice(0, whole.lastIndexOf('/')));
    program.FS.writeFile(whole, bytes);
  }
  program.FS.chdir(folder);
  status = program.callMain(words) ?? status;
  const written: [string, Uint8Array][] = [];
  for (const path of wanted) {
    const whole = path.startsWith('/') ? path : `${folder}/${path}`;
    if (program.FS.analyzePath(whole).exists) written.push([path, program.FS.readFile(whole)]);
  }
  return { status, out: out.taken(), err: err.taken(), written };
}

function reason(failure: unknown): string {
  return failure instanceof Error ? failure.message : String(failure);
}

async function begin(): Promise<void> {
  let compiled: WebAssembly.Module;
  try {
    importScripts('axisc.js');
    compiled = await WebAssembly.compileStreaming(fetch('axisc.wasm'));
  } catch (failure) {
    answer({ kind: 'failed', id: null, reason: reason(failure) });
    return;
  }
  let queue = Promise.resolve();
  self.onmessage = (event: MessageEvent<Request>) => {
    const request = event.data;
    queue = queue.then(async () => {
      if (request.kind === 'files') {
        for (const path of request.removed) files.delete(path);
        for (const [path, bytes] of request.set) files.set(path, bytes);
        return;
      }
      const start = performance.now();
      try {
        const done = await run(compiled, request.words, request.wanted);
        answer({ kind: 'done', id: request.id, ...done, time: performance.now() - start });
      } catch (failure) {
        answer({ kind: 'failed', id: request.id, reason: reason(failure) });
      }
    });
  };
  answer({ kind: 'ready' });
}

// What arrives while the module is compiled waits.
const early: MessageEvent<Request>[] = [];
self.onmessage = (event: MessageEvent<Request>) => void early.push(event);
void begin().then(() => {
  for (const event of early) self.onmessage?.(event as MessageEvent);
});
