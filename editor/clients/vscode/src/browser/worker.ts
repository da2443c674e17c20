// The server: the program as WebAssembly, beside a file system in memory.
import createAxisc, { type Instance } from 'axisc-program';
import { begin, take } from '../../../../../cli/browser/server.mjs';
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

interface Message {
  id?: number | string;
}

/** Answers messages that arrived together: the server checks only the last of several changes. */
function answer(messages: Message[]): void {
  if (hasBegun) {
    for (const sent of take(program, ...messages)) postMessage(sent);
    return;
  }
  for (const { id } of messages) {
    // The program was not started rightly: what it says of that is shown by the client.
    if (id !== undefined) postMessage({ jsonrpc: '2.0', id, error: { code: invalidParams, message: said.join('\n') } });
  }
}

const waiting: unknown[] = [];
let isTaking = false;

/** In the order of arrival, the first messages when the program is there. */
async function takeAll(): Promise<void> {
  isTaking = true;
  while (waiting.length > 0) {
    // Whatever has been sent already arrives first.
    await new Promise((wake) => setTimeout(wake, 0));
    let messages: Message[] = [];
    for (const data of waiting.splice(0)) {
      if (!isTold(data)) {
        messages.push(data as Message);
        continue;
      }
      if (messages.length > 0) answer(messages);
      messages = [];
      if (data.kind === 'begin') await beginWith(data);
      else keep(data);
    }
    if (messages.length > 0) answer(messages);
  }
  isTaking = false;
}

addEventListener('message', ({ data }: MessageEvent<unknown>) => {
  waiting.push(data);
  if (!isTaking) void takeAll();
});
