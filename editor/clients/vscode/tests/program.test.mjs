// The parts of the extension that need no editor.
import assert from 'node:assert/strict';
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { chmod, mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..');

async function load(t, source) {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'axisc-'));
  t.after(() => rm(folder, { recursive: true }));
  const outfile = path.join(folder, 'module.mjs');
  await build({ entryPoints: [path.join(root, 'src', source)], outfile, bundle: true, platform: 'node', format: 'esm' });
  return { folder, module: await import(pathToFileURL(outfile).href) };
}

test('the program is found as a shell finds it', async (t) => {
  const { folder, module } = await load(t, 'program.ts');
  const [first, second] = [path.join(folder, 'first'), path.join(folder, 'second')];
  const program = path.join(second, 'axisc');
  await mkdir(path.join(first, 'axisc'), { recursive: true });
  await mkdir(second);
  await writeFile(program, '');
  await writeFile(path.join(second, 'text'), '');
  await chmod(program, 0o755);
  const find = (setting, endings = '') => module.findProgram(setting, { path: `.::${first}:${second}`, endings });
  assert.equal(find(''), program);
  assert.equal(find(' axisc '), program);
  assert.equal(find(program), program);
  assert.equal(find('text'), undefined, 'no program');
  assert.equal(find(first), undefined, 'a folder');
  assert.equal(find('second/axisc'), undefined, 'a relative path');
  assert.equal(find('other'), undefined);
  assert.equal(find(path.join(folder, 'gone')), undefined);
  await writeFile(`${path.join(second, 'other')}.exe`, '');
  await chmod(`${path.join(second, 'other')}.exe`, 0o755);
  assert.equal(find('other', '.com;.exe'), `${path.join(second, 'other')}.exe`);
});

test('a page runs the scripts that the server names and nothing else', async (t) => {
  const { module } = await load(t, 'page.ts');
  const script = 'zoom();\n';
  const digest = `sha256-${createHash('sha256').update(script).digest('base64')}`;
  const page = (scripts) => ({
    title: 'x',
    html: `<!doctype html><html lang="en"><head><title>x</title></head><body><script>alert(1)</script><script>${script}</script></body></html>`,
    scripts,
  });
  const policy = (given) => /content="([^"]*)"/.exec(module.guarded(given))[1];
  assert.match(module.guarded(page([digest])), /<head><meta http-equiv="Content-Security-Policy" content="default-src 'none';/);
  assert.ok(policy(page([digest])).endsWith(`; script-src '${digest}'`));
  // What the page contains decides nothing.
  assert.ok(policy(page(undefined)).endsWith("; script-src 'none'"));
  for (const other of ["unsafe-inline'", '*', `${digest}' *; img-src '${digest}`, `${digest}\n`, '', 1, null]) {
    assert.ok(policy(page([other])).endsWith("; script-src 'none'"), String(other));
  }
  const picture = module.guarded({ title: 'x', html: '<svg></svg>' });
  assert.ok(picture.includes("script-src 'none'") && picture.endsWith('<body><svg></svg></body></html>'));
  assert.ok(module.isPage({ title: 'a', html: 'b' }));
  for (const other of [null, undefined, 1, 'text', {}, { html: 1, title: 'a' }, { html: 'b', title: 'a', scripts: 'c' }]) assert.ok(!module.isPage(other));
});
