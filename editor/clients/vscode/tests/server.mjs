// A conversation with the real program: AXISC, else the one on the PATH.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import protocol from 'vscode-languageserver-protocol/node';

export const program = process.env.AXISC ?? 'axisc';
export const samples = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../../../samples');
export const uriOf = (file) => pathToFileURL(path.resolve(samples, file)).href;

export function lint(...words) {
  const run = spawnSync(program, ['lint', ...words], { cwd: samples, encoding: 'utf8' });
  if (run.error) throw run.error;
  return run.stdout;
}

export function findings(file) {
  return JSON.parse(lint(file, '--format', 'json')).diagnostics;
}

// A test that failed leaves none behind.
const started = [];
after(() => started.forEach((server) => server.kill()));

/** A server after `initialize`; capabilities are what the client says of itself. */
export async function start(capabilities = {}, more = {}) {
  const process = spawn(program, ['lsp', '--lang', 'en'], { cwd: samples, stdio: ['pipe', 'pipe', 'inherit'] });
  started.push(process);
  const connection = protocol.createProtocolConnection(
    new protocol.StreamMessageReader(process.stdout),
    new protocol.StreamMessageWriter(process.stdin),
  );
  const published = new Map();
  const waiting = new Set();
  connection.onNotification('textDocument/publishDiagnostics', (params) => {
    published.set(params.uri, params);
    for (const resolve of waiting) resolve();
  });
  connection.listen();
  const answer = await connection.sendRequest('initialize', {
    processId: null,
    rootUri: null,
    capabilities,
    ...more,
  });
  await connection.sendNotification('initialized', {});
  const server = {
    connection,
    process,
    capabilities: answer.capabilities,
    published,
    /** Opens a document; its first diagnostics. */
    async open(uri, text) {
      await connection.sendNotification('textDocument/didOpen', {
        textDocument: { uri, languageId: 'axis-list', version: 1, text },
      });
      return server.diagnostics(uri, 1);
    },
    async openSample(file) {
      const bytes = await readFile(path.resolve(samples, file));
      return server.open(uriOf(file), new TextDecoder('utf-8').decode(bytes));
    },
    /** The pushed diagnostics of a version, when they arrive. */
    async diagnostics(uri, version) {
      while (published.get(uri)?.version !== version) {
        await new Promise((resolve) => {
          const wake = () => {
            waiting.delete(wake);
            resolve();
          };
          waiting.add(wake);
        });
      }
      return published.get(uri).diagnostics;
    },
    ask: (method, uri, more) => connection.sendRequest(method, { textDocument: { uri }, ...more }),
    /** The exit status after a proper farewell. */
    async end() {
      const exit = once(process, 'exit');
      await connection.sendRequest('shutdown');
      await connection.sendNotification('exit');
      const [status] = await exit;
      connection.dispose();
      return status;
    },
  };
  return server;
}
