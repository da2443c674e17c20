// Runs the program: one instance of its module does everything, as long as it stays small.
import { Conversation } from './conversation';
import { Instance } from './instance';
import type { Answer, Request } from './program';

/** The memory that an instance may keep: a large file must not burden later requests. */
const largest = 64 * 1024 * 1024;
const files = new Map<string, Uint8Array>();

function answer(message: Answer): void {
  (self as unknown as { postMessage(message: Answer): void }).postMessage(message);
}

const reason = (failure: unknown): string => (failure instanceof Error ? failure.message : String(failure));

class Service {
  private readonly changed = new Set<string>();
  private readonly conversation: Conversation;

  constructor(readonly instance: Instance) {
    this.conversation = new Conversation(instance);
  }

  do(request: Exclude<Request, { kind: 'files' | 'module' }>): Answer {
    const start = performance.now();
    for (const path of this.instance.update(files)) this.changed.add(path);
    if (request.kind === 'call') {
      const outcome = this.instance.call(request.options, request.call);
      return { kind: 'done', id: request.id, outcome, time: performance.now() - start };
    }
    const result = this.conversation.ask(request.options, request.question, this.changed);
    this.changed.clear();
    return { kind: 'told', id: request.id, result };
  }
}

/** Handles a request, once the module is there. */
function begin(compiled: WebAssembly.Module): (request: Exclude<Request, { kind: 'module' }>) => Promise<void> {
  const create = async (): Promise<Service> => new Service(await Instance.create(compiled));
  let service = create();
  return async (request) => {
    if (request.kind === 'files') {
      for (const path of request.removed) files.delete(path);
      for (const [path, bytes] of request.set) files.set(path, bytes);
      return;
    }
    try {
      const standing = await service;
      answer(standing.do(request));
      if (standing.instance.size > largest) service = create();
    } catch (failure) {
      // A failed run may have left anything behind.
      answer({ kind: 'failed', id: request.id, reason: reason(failure) });
      service = create();
    }
  };
}

// One after the other; all wait for the module.
let ready: (module: WebAssembly.Module) => void;
const handle = new Promise<WebAssembly.Module>((resolve) => (ready = resolve)).then(begin);
let queue = Promise.resolve();
self.onmessage = ({ data: request }: MessageEvent<Request>) => {
  if (request.kind === 'module') ready(request.module);
  else queue = queue.then(async () => (await handle)(request)).catch(() => undefined);
};
