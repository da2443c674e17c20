// What the manifest promises is what the program says and takes, in both languages.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { findings, lint, program, samples } from './server.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..');
const read = (file) => readFileSync(path.join(root, file), 'utf8');
const manifest = JSON.parse(read('package.json'));
const { contributes } = manifest;

test('the version is that of the program', () => {
  const said = spawnSync(program, ['--version'], { encoding: 'utf8' }).stdout;
  assert.ok(said.startsWith(`axisc ${manifest.version}`), said);
  assert.ok(read('CHANGELOG.md').includes(`## ${manifest.version}`));
});

test('both languages have the same texts, and all that are used', () => {
  const english = JSON.parse(read('package.nls.json'));
  const german = JSON.parse(read('package.nls.de.json'));
  assert.deepEqual(Object.keys(german), Object.keys(english));
  const used = [...read('package.json').matchAll(/"%([^"]+)%"/g)].map(([, key]) => key);
  assert.deepEqual([...new Set(used)].sort(), Object.keys(english).sort());
  const sources = readdirSync(path.join(root, 'src'), { recursive: true }).filter((name) => name.endsWith('.ts')).map((name) => read(`src/${name}`)).join('\n');
  const said = [...sources.matchAll(/l10n\.t\(\s*'([^']+)'/g)].map(([, text]) => text);
  assert.deepEqual(said.sort(), Object.keys(JSON.parse(read('l10n/bundle.l10n.de.json'))).sort());
});

test('the kinds of lists are those that the program knows', () => {
  const refused = spawnSync(program, ['lint', '--lang', 'en', '--kind', 'none', 'mill/x.lis'], { cwd: samples, encoding: 'utf8' });
  const kinds = contributes.configuration.properties['axisc.kind'].enum.filter((kind) => kind !== '');
  assert.ok(refused.stderr.includes(kinds.join(', ')), refused.stderr);
});

const matcher = (name) => contributes.problemMatchers.find((one) => one.name === name);

/** As the editor applies a pattern of several lines. */
function matched(patterns, text) {
  const lines = text.split('\n');
  const found = [];
  for (let i = 0; i + patterns.length <= lines.length; ++i) {
    const groups = patterns.map(({ regexp }, line) => new RegExp(regexp).exec(lines[i + line]));
    if (groups.some((group) => group === null)) continue;
    const values = {};
    patterns.forEach((pattern, line) => {
      for (const [key, group] of Object.entries(pattern)) if (key !== 'regexp') values[key] = groups[line][group];
    });
    found.push(values);
  }
  return found;
}

for (const [name, ...options] of [['axisc'], ['axisc-github', '--format', 'github']]) {
  test(`the problem matcher ${name} finds what lint says`, () => {
    const { pattern } = matcher(name);
    for (const file of ['mistakes/typing.lis', 'mistakes/units.lis', 'mistakes/controller/listen/hochlauf.lis']) {
      const found = matched([pattern].flat(), lint(file, '--lang', 'en', ...options)).filter((one) => one.line !== undefined);
      const place = (one) => [path.basename(one.file), Number(one.line), Number(one.column), one.code].join(' ');
      assert.deepEqual(
        found.map(place).sort(),
        findings(file).filter((one) => one.line !== null).map(place).sort(),
      );
      assert.ok(found.every((one) => /^(error|warning|note|notice)$/.test(one.severity) && one.message.length > 0));
    }
  });
}

test('the package has the same bytes whenever it is built, the bundle and every licence', (t) => {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'axisc-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const packed = ['first', 'second'].map((name) => {
    const file = path.join(folder, `${name}.vsix`);
    const made = spawnSync(path.join(root, 'package.sh'), [file], {
      encoding: 'utf8',
      env: { ...process.env, SOURCE_DATE_EPOCH: '1700000000' },
    });
    assert.equal(made.status, 0, made.stderr + made.stdout);
    return file;
  });
  assert.ok(readFileSync(packed[0]).equals(readFileSync(packed[1])));
  const bytes = readFileSync(packed[0]).toString('latin1');
  // The names of the central directory.
  const names = [...bytes.matchAll(/PK\x01\x02[^]{42}((?:extension\/|\[Content|extension\.)[\x21-\x7e]*)/g)].map(([, name]) => name);
  assert.ok(!bytes.includes('node_modules/'));
  for (const name of ['dist/extension.js', 'dist/NOTICE.txt', 'icon.png', 'l10n/bundle.l10n.de.json', 'LICENSE.txt']) {
    assert.ok(bytes.includes(`extension/${name}`), name);
  }
  assert.ok(names.every((name) => !/\/(src|tests)\//.test(name)));
  const notice = read('dist/NOTICE.txt');
  for (const name of ['vscode-languageclient', 'vscode-jsonrpc', 'minimatch', 'semver']) assert.ok(notice.includes(`\n${name} `), name);
});
