// The server: the program as WebAssembly, beside a file system in memory.
import createAxisc, { type Instance } from 'axisc-program';
import { Axisc } from '../../../../../web/interface/axisc.mjs';
import { type Beginning, type FileState, isTold } from './messages';

/** As JSON-RPC numbers it. */
const invalidParams = -32602;

let program: Instance;
let workspace: Axisc;

async function beginWith({ program: wasmBinary, language }: Beginning): Promise<void> {
  program = await createAxisc({ wasmBinary });
  workspace = new Axisc(program, { language });
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
  if (workspace.error === '') {
    for (const sent of workspace.message(...messages)) postMessage(sent);
    return;
  }
  for (const { id } of messages) {
    if (id !== undefined) postMessage({ jsonrpc: '2.0', id, error: { code: invalidParams, message: workspace.error } });
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
