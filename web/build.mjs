// build/web: the page as static files, and as one file, axisc.html. Expects build/wasm/bin/axisc.js and axisc.wasm
// (docs/webassembly.md).
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { copyFile, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, '..');
const out = path.join(root, 'build/web');
const samples = {
  typing: ['mistakes/typing.lis', ''],
  unsuitable: ['mistakes/unsuitable.lis', ''],
  mill: ['mill', 'mill'],
  rack: ['motion/rack', 'rack'],
  controller: ['controller', 'controller'],
  recording: ['recording', 'recording', ['scope.csv', 'x.lis']],
};

async function filesIn(folder) {
  const entries = await readdir(folder, { withFileTypes: true, recursive: true });
  return entries.filter((entry) => entry.isFile()).map((entry) => path.relative(folder, path.join(entry.parentPath ?? entry.path, entry.name))).sort();
}

/** Size of the names, names and sizes as JSON, bytes: see sample() of src/incoming.ts. */
async function packed(source, name, wanted) {
  const whole = path.join(root, 'samples', source);
  const names = wanted ?? (name === '' ? [''] : await filesIn(whole));
  const contents = await Promise.all(names.map((one) => readFile(path.join(whole, one))));
  const index = names.map((one, i) => [name === '' ? path.basename(source) : `${name}/${one}`, contents[i].length]);
  const head = Buffer.from(JSON.stringify(index));
  const size = Buffer.alloc(4);
  size.writeUInt32LE(head.length);
  return Buffer.concat([size, head, ...contents]);
}

async function notice(metafile) {
  const inputs = Object.values(metafile.outputs).flatMap((output) => Object.keys(output.inputs));
  const folders = [...new Set(inputs.map((input) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(input)?.[0]).filter(Boolean))].sort();
  const licences = await Promise.all(
    folders.map(async (folder) => {
      const about = JSON.parse(await readFile(path.join(here, folder, 'package.json'), 'utf8'));
      const file = (await readdir(path.join(here, folder))).find((one) => /^licen[cs]e/i.test(one));
      if (file === undefined) throw new Error(`${about.name} has no licence in its package`);
      return `${about.name} ${about.version} (${about.license})\n\n${(await readFile(path.join(here, folder, file), 'utf8')).trim()}\n`;
    }),
  );
  return ['page.js contains these packages.\n', ...licences].join(`\n${'-'.repeat(78)}\n\n`);
}

const largest = 3_000_000;  // bytes of axisc.html

/** As bytesOf() of src/parts.ts reads it. What HTML changes in scripts, or takes for their end, is marked. */
function encoded(bytes) {
  const marked = new Set([0x00, 0x0a, 0x0d, 0x3c, 0x3d]);
  return Buffer.from([...bytes].flatMap((byte) => (marked.has(byte) ? [0x3d, byte + 64] : [byte])));
}

/** The page with everything in it, in windows-1252, in which a byte of a packed part is a character: a third less than base64. */
async function oneFile(parts) {
  const bytes = await Promise.all(parts.map(async (name) => [name, await readFile(path.join(out, name))]));
  const text = Object.fromEntries(await Promise.all(['start.js', 'page.css', 'icon.svg'].map(async (name) => [name, await readFile(path.join(out, name), 'utf8')])));
  const digest = (script) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`;
  const scripts = [text['start.js'], bytes.find(([name]) => name === 'page.js')[1]];
  const policy = `default-src 'none'; script-src ${scripts.map(digest).join(' ')} 'wasm-unsafe-eval'; worker-src blob:; style-src 'unsafe-inline'; img-src blob: data:; frame-src blob:; base-uri 'none'; form-action 'none'`;
  const packed = (wanted) => bytes.filter(([name]) => wanted.includes(name)).map(([name, one]) => `<script type="text/plain" id="part:${name}">${encoded(gzipSync(one, { level: 9 })).toString('latin1')}</script>\n`).join('');
  const early = ['worker.js', 'page.js'];
  const replaced = [
    ['<meta charset="utf-8">', () => '<meta charset="windows-1252">'],
    [/(http-equiv="Content-Security-Policy" content=")[^"]*/, (_, before) => before + policy],
    [/<link rel="icon"[^>]*>/, () => `<link rel="icon" href="data:image/svg+xml;base64,${Buffer.from(text['icon.svg']).toString('base64')}">`],
    [/<link rel="stylesheet"[^>]*>/, () => `<style>\n${text['page.css']}</style>`],
    [/<script src="start.js"><\/script>\n<script src="page.js" defer><\/script>\n/, () => ''],
    // The page begins while its largest part is still being read.
    [/<\/body>/, () => `${packed(early)}<script>${text['start.js']}</script>\n${packed(parts.filter((name) => !early.includes(name)))}</body>`],
  ];
  let page = await readFile(path.join(out, 'index.html'), 'utf8');
  if (!/^[\t-~]*$/.test(page + text['page.css'] + text['start.js'])) throw new Error('the page itself has to be ASCII');
  for (const [pattern, replacement] of replaced) {
    if (page.search(pattern) < 0) throw new Error(`index.html lacks ${pattern}`);
    page = page.replace(pattern, replacement);
  }
  if (page.length > largest) throw new Error(`axisc.html has ${page.length} bytes, more than ${largest}`);
  return Buffer.from(page, 'latin1');
}

await rm(out, { recursive: true, force: true });
await mkdir(path.join(out, 'samples'), { recursive: true });
const { metafile } = await build({
  absWorkingDir: here,
  entryPoints: { start: 'src/start.ts', page: 'src/main.ts', worker: 'src/worker.ts' },
  outdir: out,
  bundle: true,
  format: 'iife',
  target: 'es2022',
  minify: true,
  legalComments: 'none',
  charset: 'utf8',
  metafile: true,
});
const module = await readFile(path.join(root, 'build/wasm/bin/axisc.js'), 'utf8');
await writeFile(path.join(out, 'worker.js'), `${module}\n${await readFile(path.join(out, 'worker.js'), 'utf8')}`);
await copyFile(path.join(root, 'build/wasm/bin/axisc.wasm'), path.join(out, 'axisc.wasm'));
await writeFile(path.join(out, 'NOTICE.txt'), await notice(metafile));
await copyFile(path.join(root, 'build/release/notices/third-party-licences.txt'), path.join(out, 'third-party-licences.txt'));
await copyFile(path.join(root, 'LICENSE'), path.join(out, 'LICENSE.txt'));
for (const name of ['index.html', 'page.css', 'icon.svg']) await copyFile(path.join(here, name), path.join(out, name));
for (const [name, [source, folder, wanted]] of Object.entries(samples)) {
  await writeFile(path.join(out, 'samples', `${name}.bin`), await packed(source, folder, wanted));
}
const parts = ['axisc.wasm', 'worker.js', 'page.js', 'LICENSE.txt', 'NOTICE.txt', 'third-party-licences.txt', ...Object.keys(samples).map((name) => `samples/${name}.bin`)];
await writeFile(path.join(out, 'axisc.html'), await oneFile(parts));
