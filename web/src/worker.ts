// Runs the program: one compiled module, an instance for each run, a file system in memory for each instance.
import type { Answer, Request } from './program';
import { Stream, create, type Instance } from './instance';

declare function importScripts(...scripts: string[]): void;

const folder = '/work';
const files = new Map<string, Uint8Array>();

function answer(message: Answer): void {
  (self as unknown as { postMessage(message: Answer): void }).postMessage(message);
}

const whole = (path: string): string => (path.startsWith('/') ? path : `${folder}/${path}`);
const reason = (failure: unknown): string => (failure instanceof Error ? failure.message : String(failure));

/** Instances of the module; the next one is made while nobody waits for it. */
class Instances {
  private next: Promise<Instance> | null = null;

  constructor(private readonly compiled: WebAssembly.Module) {}

  take(): Promise<Instance> {
    const taken = this.next ?? create(this.compiled);
    this.next = null;
    return taken;
  }

  prepare(): void {
    this.next ??= create(this.compiled);
  }
}

function run({ program, streams }: Instance, { words, input, wanted }: Extract<Request, { kind: 'run' }>) {
  streams.in = new Stream(new TextEncoder().encode(input));
  program.FS.mkdirTree(folder);
  for (const [path, bytes] of files) {
    program.FS.mkdirTree(whole(path).slice(0, whole(path).lastIndexOf('/')));
    program.FS.writeFile(whole(path), bytes);
  }
  program.FS.chdir(folder);
  const status = program.callMain(words) ?? streams.status;
  const written: [string, Uint8Array][] = [];
  for (const path of wanted) {
    if (program.FS.analyzePath(whole(path)).exists) written.push([path, program.FS.readFile(whole(path))]);
  }
  return { status, out: streams.out.written(), err: streams.err.written(), written };
}

/** What to do about a request, once the module is compiled. */
async function begin(): Promise<(request: Request) => Promise<void>> {
  const compiled = WebAssembly.compileStreaming(fetch('axisc.wasm'));
  importScripts('axisc.js');
  const instances = new Instances(await compiled);
  instances.prepare();
  answer({ kind: 'ready' });
  return async (request) => {
    if (request.kind === 'files') {
      for (const path of request.removed) files.delete(path);
      for (const [path, bytes] of request.set) files.set(path, bytes);
      return;
    }
    const start = performance.now();
    try {
      const done = run(await instances.take(), request);
      answer({ kind: 'done', id: request.id, ...done, time: performance.now() - start });
    } catch (failure) {
      answer({ kind: 'failed', id: request.id, reason: reason(failure) });
    }
    instances.prepare();
  };
}

// One after the other; what arrives while the module is compiled waits for it.
const started = begin();
let queue: Promise<void> = started.then(
  () => undefined,
  (failure: unknown) => answer({ kind: 'failed', id: null, reason: reason(failure) }),
);
self.onmessage = (event: MessageEvent<Request>) => {
  queue = queue.then(async () => (await started)(event.data)).catch(() => undefined);
};
