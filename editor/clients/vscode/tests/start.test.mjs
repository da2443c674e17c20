// The bundle starts the real program, and says what to do where there is none. The editor is a stub, the client and the server
// are not.
import assert from 'node:assert/strict';
import { build } from 'esbuild';
import { spawnSync } from 'node:child_process';
import { chmod, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire, Module } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { program } from './server.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const require = createRequire(import.meta.url);
const resolve = Module._resolveFilename;
Module._resolveFilename = (name, ...more) => (name === 'vscode' ? path.join(here, 'stub.cjs') : resolve(name, ...more));
const { test: editor, env: environment } = require('vscode');

test('the extension starts, restarts and ends the server', { timeout: 60000 }, async (t) => {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'axisc-'));
  t.after(() => rm(folder, { recursive: true }));
  const outfile = path.join(folder, 'extension.cjs');
  await build({ entryPoints: [path.join(here, '../src/extension.ts')], outfile, bundle: true, platform: 'node', external: ['vscode'] });
  const real = path.isAbsolute(program) ? program : spawnSync('sh', ['-c', 'command -v "$0"', program], { encoding: 'utf8' }).stdout.trim();
  const log = path.join(folder, 'log');
  const wrapper = path.join(folder, 'axisc');
  await writeFile(wrapper, `#!/bin/sh\necho "$@" >>'${log}'\n'${real}' "$@"\necho "status $?" >>'${log}'\n`);
  await chmod(wrapper, 0o755);
  const logged = async () => (await readFile(log, 'utf8').catch(() => '')).trim().split('\n');

  const extension = require(outfile);
  const { settings, recorded } = editor;
  settings.path = path.join(folder, 'gone');
  await extension.activate({ subscriptions: [] });
  assert.equal(recorded.errors.length, 1);
  assert.match(recorded.errors[0], /axisc\.path names ".*gone"/);
  settings.path = '';
  const before = process.env.PATH;
  process.env.PATH = '/nowhere';
  await editor.change('path');
  process.env.PATH = before;
  assert.match(recorded.errors[1], /not on the PATH/);

  settings.path = wrapper;
  await editor.change('path');
  assert.deepEqual(recorded.errors.slice(2), []);
  assert.deepEqual(await logged(), ['lsp --lang en']);
  // Settings reach the server that runs, another program is started.
  Object.assign(settings, { language: 'de', cycleTime: 'soon', build: 'V3.1.3075.04', kind: 'axis' });
  const told = recorded.errors.length;
  await editor.change('cycleTime');
  while (recorded.errors.length === told) await new Promise((wake) => setTimeout(wake, 20));
  assert.match(recorded.errors[told], /^axisc\.cycleTime: "soon" ist keine gültige Zykluszeit/);
  assert.deepEqual((await logged()).filter((line) => line.startsWith('lsp')), ['lsp --lang en']);
  environment.language = 'de';
  await editor.change('path');
  assert.deepEqual((await logged()).filter((line) => line.startsWith('lsp')), ['lsp --lang en', 'lsp --lang de']);
  await extension.deactivate();
  while ((await logged()).filter((line) => line.startsWith('status')).length < 2) {
    await new Promise((wake) => setTimeout(wake, 20));
  }
  assert.deepEqual((await logged()).filter((line) => line.startsWith('status')), ['status 0', 'status 0']);
});
