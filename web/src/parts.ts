// Where the parts of the page come from: files next to it or, in axisc.html, packed in the page itself.

const packed = (name: string): string | undefined => document.getElementById(`part:${name}`)?.textContent ?? undefined;

/** The page is one file. */
export const isOneFile = packed('worker.js') !== undefined;

/** Resolves when all parts of the one file have been read. */
const whole = new Promise<void>((resolve) => {
  if (document.readyState !== 'loading') resolve();
  else document.addEventListener('DOMContentLoaded', () => resolve());
});

/** A character of windows-1252 is a byte; one after "=" is 64 less. */
function bytesOf(text: string): Uint8Array {
  const characters = new TextDecoder('windows-1252').decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
  const byteOf = new Uint8Array(0x10000);
  for (let byte = 0; byte < 256; ++byte) byteOf[characters.charCodeAt(byte)] = byte;
  const bytes = new Uint8Array(text.length);
  let size = 0;
  for (let i = 0; i < text.length; ++i) {
    const isMarked = text.charCodeAt(i) === 61;
    bytes[size++] = isMarked ? (byteOf[text.charCodeAt(++i)] as number) - 64 : (byteOf[text.charCodeAt(i)] as number);
  }
  return bytes.subarray(0, size);
}

async function part(name: string, type = 'application/octet-stream'): Promise<Response> {
  if (!isOneFile) {
    const answer = await fetch(name);
    if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
    return answer;
  }
  if (packed(name) === undefined) await whole;
  const stream = new Blob([bytesOf(packed(name) ?? '') as BlobPart]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream, { headers: { 'content-type': type } });
}

export const bytesOfPart = async (name: string): Promise<Uint8Array> => new Uint8Array(await (await part(name)).arrayBuffer());
export const textOfPart = async (name: string): Promise<string> => (await part(name)).text();

/** What a worker runs, as an address, the module that it is given, and a worker that runs already. */
export interface Parts {
  address: string;
  module: Promise<WebAssembly.Module>;
  worker: Worker;
}

export function startWorker({ address, module }: Omit<Parts, 'worker'>): Worker {
  const worker = new Worker(address);
  module.then((compiled) => worker.postMessage({ kind: 'module', module: compiled }), () => undefined);
  return worker;
}

export async function load(): Promise<Parts> {
  const address = isOneFile ? URL.createObjectURL(new Blob([await textOfPart('worker.js')], { type: 'text/javascript' })) : 'worker.js';
  const parts = { address, module: WebAssembly.compileStreaming(part('axisc.wasm', 'application/wasm')) };
  return { ...parts, worker: startWorker(parts) };
}
