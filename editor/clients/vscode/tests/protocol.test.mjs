// What the tested editors do not ask for, or not in this way: encodings, pulled diagnostics, hints, cancelled requests, null as
// parameters, clients that die.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { cp, mkdtemp, readFile, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { CancellationTokenSource, FileChangeType } from 'vscode-languageserver-protocol/node';
import { findings, program, samples, start, uriOf } from './server.mjs';

const wait = { timeout: 60000 };
const whole = { start: { line: 0, character: 0 }, end: { line: 1000, character: 0 } };
const mill = 'mill/default.lis';

for (const [encoding, length] of [
  ['utf-8', 11],
  ['utf-16', 8],
  ['utf-32', 7],
]) {
  test(`positions count ${encoding} units`, wait, async () => {
    const server = await start({ general: { positionEncodings: [encoding] } });
    assert.equal(server.capabilities.positionEncoding, encoding);
    const uri = uriOf('encoding.lis');
    await server.open(uri, '# Ä😀\n');
    // Typed after both characters: the server finds the place in its own text.
    const at = { line: 0, character: 2 + (encoding === 'utf-8' ? 6 : encoding === 'utf-16' ? 3 : 2) };
    await server.connection.sendNotification('textDocument/didChange', {
      textDocument: { uri, version: 2 },
      contentChanges: [{ range: { start: at, end: at }, text: '\nfilter[0].type LOWPÄ😀S\n#' }],
    });
    const changed = (await server.diagnostics(uri, 2)).filter((finding) => finding.range.start.line === 1);
    assert.equal(changed.length, 1);
    assert.equal(changed[0].range.start.character, 15);
    assert.equal(changed[0].range.end.character - 15, length);
    assert.equal(await server.end(), 0);
  });
}

test('a client that offers no encoding counts UTF-16 units', wait, async () => {
  const server = await start();
  assert.equal(server.capabilities.positionEncoding, 'utf-16');
  assert.equal(await server.end(), 0);
});

for (const file of ['mistakes/typing.lis', 'mistakes/units.lis', 'mill/x.lis', 'mill/machine.json']) {
  test(`pulled and pushed diagnostics of ${file} are what lint says`, wait, async () => {
    const server = await start({ textDocument: { diagnostic: {} } });
    assert.ok(server.capabilities.diagnosticProvider);
    const pushed = await server.openSample(file);
    const pulled = await server.ask('textDocument/diagnostic', uriOf(file));
    assert.equal(pulled.kind, 'full');
    assert.deepEqual(pulled.items, pushed);
    const input = file.startsWith('mill/') ? 'mill/machine.json' : file;
    const key = (line, code) => `${line} ${code}`;
    assert.deepEqual(
      pulled.items.map((item) => key(item.range.start.line + 1, item.code)).sort(),
      findings(input)
        .filter((finding) => finding.file.endsWith(file))
        .map((finding) => key(finding.line ?? 1, finding.code))
        .sort(),
    );
    assert.equal(await server.end(), 0);
  });
}

test('diagnostics are not offered to who is told them', wait, async () => {
  const server = await start({ textDocument: { diagnostic: {}, publishDiagnostics: {} } });
  assert.equal(server.capabilities.diagnosticProvider, undefined);
  assert.equal(await server.end(), 0);
});

test('a cancelled request is answered, and so is the next one', wait, async () => {
  const server = await start();
  await server.openSample(mill);
  const position = { line: 10, character: 10 };
  // Of a request that never was.
  await server.connection.sendNotification('$/cancelRequest', { id: 424242 });
  const cancelling = Array.from({ length: 20 }, () => new CancellationTokenSource());
  const asked = cancelling.map(({ token }) =>
    server.connection.sendRequest('textDocument/hover', { textDocument: { uri: uriOf(mill) }, position }, token),
  );
  for (const source of cancelling) source.cancel();
  const ended = await Promise.allSettled(asked);
  for (const answer of ended) {
    // Computed all the same, or refused with the code of cancelled requests.
    assert.ok(answer.status === 'fulfilled' || answer.reason.code === -32800, answer.reason?.message);
  }
  assert.ok(await server.ask('textDocument/hover', uriOf(mill), { position }));
  assert.equal(await server.end(), 0);
});

test('files that change on the disk are asked for, and count', wait, async () => {
  const server = await start({ workspace: { didChangeWatchedFiles: { dynamicRegistration: true } } });
  const watched = new Promise((wake) => {
    server.connection.onRequest('client/registerCapability', ({ registrations }) => {
      wake(registrations.flatMap(({ registerOptions }) => registerOptions.watchers ?? []).map(({ globPattern }) => globPattern));
      return null;
    });
  });
  assert.ok((await watched).includes('**/*.lis'));
  const folder = await mkdtemp(path.join(os.tmpdir(), 'axisc-'));
  await cp(path.join(samples, 'mill'), folder, { recursive: true });
  const uri = pathToFileURL(path.join(folder, 'x.lis')).href;
  const list = await readFile(path.join(folder, 'x.lis'), 'latin1');
  await server.open(uri, list);
  const codes = async () => (await server.ask('textDocument/diagnostic', uri)).items.map(({ code }) => code);
  assert.ok(!(await codes()).includes('AX9006'));
  // Without its machine, nothing tells the list's cycle time.
  await rm(path.join(folder, 'machine.json'));
  await server.connection.sendNotification('workspace/didChangeWatchedFiles', {
    changes: [{ uri: pathToFileURL(path.join(folder, 'machine.json')).href, type: FileChangeType.Deleted }],
  });
  assert.ok((await codes()).includes('AX9006'));
  assert.equal(await server.end(), 0);
  await rm(folder, { recursive: true });
});

test('settings are asked for, and apply when they change', wait, async () => {
  const server = await start({ workspace: { configuration: true, didChangeConfiguration: { dynamicRegistration: true } } });
  const settings = { cycleTime: '' };
  const asked = [];
  server.connection.onRequest('client/registerCapability', ({ registrations }) => {
    asked.push(...registrations.map(({ method, registerOptions }) => `${method} ${registerOptions.section}`));
    return null;
  });
  server.connection.onRequest('workspace/configuration', ({ items }) => items.map(({ section }) => (section === 'axisc' ? settings : null)));
  const file = 'manual/axis-pt1.lis';
  const codes = async () => (await server.ask('textDocument/diagnostic', uriOf(file))).items.map(({ code }) => code).join();
  const becomes = async (wanted) => {
    while ((await codes()) !== wanted) await new Promise((wake) => setTimeout(wake, 10));
  };
  await server.openSample(file);
  await becomes('AX9006');
  for (const [time, wanted] of [
    ['100ms', 'AX3004'],
    ['1ms', ''],
    ['', 'AX9006'],
  ]) {
    settings.cycleTime = time;
    await server.connection.sendNotification('workspace/didChangeConfiguration', { settings: null });
    await becomes(wanted);
  }
  assert.deepEqual(asked, ['workspace/didChangeConfiguration axisc']);
  assert.equal(await server.end(), 0);
});

test('a value leads to all places that set it', wait, async () => {
  const server = await start();
  await server.openSample('mill/x.lis');
  const text = await readFile(path.join(samples, 'mill/x.lis'), 'utf8');
  const line = text.split('\n').findIndex((each) => each.startsWith('kopf.achs_nr '));
  const uri = uriOf('mill/x.lis');
  const [item] = await server.ask('textDocument/prepareTypeHierarchy', uri, { position: { line, character: 3 } });
  assert.equal(item.selectionRange.start.line, line);
  const above = await server.connection.sendRequest('typeHierarchy/supertypes', { item });
  assert.equal(path.basename(above[0].uri), 'default.lis');
  const below = await server.connection.sendRequest('typeHierarchy/subtypes', { item: above[0] });
  assert.ok(below.some((each) => each.uri === uri && each.selectionRange.start.line === line));
  assert.equal(await server.end(), 0);
});

test('null as parameters ends the server as well', wait, async () => {
  const server = await start();
  const exit = once(server.process, 'exit');
  assert.equal(await server.connection.sendRequest('shutdown', null), null);
  await server.connection.sendNotification('exit', null);
  assert.deepEqual(await exit, [0, null]);
});

test('null where a request needs parameters is refused', wait, async () => {
  const server = await start();
  await assert.rejects(server.connection.sendRequest('textDocument/hover', null), { code: -32602 });
  await assert.rejects(server.connection.sendRequest('textDocument/noSuchMethod', {}), { code: -32601 });
  await assert.rejects(server.ask('textDocument/hover', uriOf('gone.lis'), { position: whole.start }), { code: -32602 });
  assert.equal(await server.end(), 0);
});

test('the server ends when its input ends', wait, async () => {
  const server = await start();
  const exit = once(server.process, 'exit');
  server.connection.dispose();
  server.process.stdin.end();
  assert.deepEqual(await exit, [1, null]);
});

test('a client that is killed leaves no server', wait, async () => {
  const code = `
    const server = require('node:child_process').spawn(${JSON.stringify(program)}, ['lsp']);
    server.stdin.write('Content-Length: 100000\\r\\n\\r\\n{');
    server.on('spawn', () => process.stdout.write(server.pid + '\\n'));
    setInterval(() => {}, 1000);`;
  const client = spawn(process.execPath, ['-e', code], { stdio: ['ignore', 'pipe', 'inherit'] });
  const [line] = await once(client.stdout, 'data');
  const pid = Number(line.toString());
  process.kill(pid, 0);
  client.kill('SIGKILL');
  await once(client, 'exit');
  const lives = () => {
    try {
      process.kill(pid, 0);
      return true;
    } catch {
      return false;
    }
  };
  while (lives()) await new Promise((resolve) => setTimeout(resolve, 20));
});

test('hints, tokens and lenses lie in the text', wait, async (t) => {
  const server = await start({
    textDocument: {
      inlayHint: {},
      codeLens: {},
      semanticTokens: { requests: { full: true }, tokenTypes: [], tokenModifiers: [], formats: ['relative'] },
    },
  });
  await server.openSample(mill);
  const lines = readFileSync(path.resolve(samples, mill), 'utf8').split('\n');
  const inText = ({ line, character }) => line < lines.length && character <= lines[line].length;
  const { inlayHintProvider, codeLensProvider, semanticTokensProvider } = server.capabilities;
  await t.test('inlay hints', { skip: !inlayHintProvider }, async () => {
    const hints = await server.ask('textDocument/inlayHint', uriOf(mill), { range: whole });
    const label = (hint) => (typeof hint.label === 'string' ? hint.label : hint.label.map((part) => part.value).join(''));
    assert.ok(hints.every((hint) => inText(hint.position)));
    assert.ok(hints.some((hint) => label(hint).includes('Hz')), 'the cut-off frequencies in Hz');
  });
  await t.test('code lenses', { skip: !codeLensProvider }, async () => {
    const lenses = await server.ask('textDocument/codeLens', uriOf(mill));
    assert.ok(lenses.length > 0 && lenses.every((lens) => inText(lens.range.start)));
  });
  await t.test('semantic tokens', { skip: !semanticTokensProvider }, async () => {
    const { tokenTypes } = semanticTokensProvider.legend;
    const { data } = await server.ask('textDocument/semanticTokens/full', uriOf(mill));
    assert.ok(data.length > 0 && data.length % 5 === 0);
    let line = 0;
    let character = 0;
    for (let i = 0; i < data.length; i += 5) {
      character = data[i] === 0 ? character + data[i + 1] : data[i + 1];
      line += data[i];
      assert.ok(inText({ line, character: character + data[i + 2] }), `token at ${line}:${character}`);
      assert.ok(data[i + 3] < tokenTypes.length);
    }
  });
  assert.equal(await server.end(), 0);
});

test('commands answer with pages', wait, async (t) => {
  const server = await start();
  await server.openSample('mill/x.lis');
  const { commands = [] } = server.capabilities.executeCommandProvider ?? {};
  for (const [command, ...more] of [['axisc.report'], ['axisc.plot', 'response'], ['axisc.machine']]) {
    await t.test(command, { skip: !commands.includes(command) }, async () => {
      const page = await server.connection.sendRequest('workspace/executeCommand', {
        command,
        arguments: [uriOf('mill/x.lis'), ...more],
      });
      assert.ok(page.title.length > 0);
      assert.match(page.html, /<(html|svg|pre|table)/);
      const scripts = [...page.html.matchAll(/<script>([\s\S]*?)<\/script>/g)].map(([, script]) => script);
      assert.equal(scripts.length, command === 'axisc.machine' ? 0 : 1);
      assert.deepEqual(page.scripts, scripts.map((script) => `sha256-${createHash('sha256').update(script).digest('base64')}`));
    });
  }
  assert.equal(await server.end(), 0);
});
