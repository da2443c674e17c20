// The server: the program as WebAssembly, beside a file system in memory.
import createAxisc, { type Instance } from 'axisc-program';
import { begin, take } from '../../../../cli/browser/server.mjs';
import { type Beginning, type FileState, isTold } from './messages';

/** As JSON-RPC numbers it. */
const invalidParams = -32602;

const said: string[] = [];
let program: Instance;
let hasBegun = false;

async function beginWith({ program: wasmBinary, words }: Beginning): Promise<void> {
  program = await createAxisc({ wasmBinary, printErr: (line) => said.push(line) });
  hasBegun = begin(program, words);
}

function keep({ path, bytes }: FileState): void {
  if (bytes !== undefined) {
    program.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    program.FS.writeFile(path, bytes);
  } else if (program.FS.analyzePath(path).exists) {
    program.FS.unlink(path);
  }
}

function answer(message: { id?: number | string }): void {
  if (hasBegun) {
    for (const sent of take(program, message)) postMessage(sent);
  } else if (message.id !== undefined) {
    // The settings are at fault: what the program says of them is shown by the client.
    postMessage({ jsonrpc: '2.0', id: message.id, error: { code: invalidParams, message: said.join('\n') } });
  }
}

/** Messages are taken in order, the first ones when the program is there. */
let last: Promise<void> = Promise.resolve();
addEventListener('message', ({ data }: MessageEvent<unknown>) => {
  last = last.then(() => {
    if (!isTold(data)) return answer(data as { id?: number });
    return data.kind === 'begin' ? beginWith(data) : keep(data);
  });
});
