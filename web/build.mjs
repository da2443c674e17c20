// build/web: the page as static files. Expects build/wasm/bin/axisc.js and axisc.wasm (docs/webassembly.md).
import { build } from 'esbuild';
import { copyFile, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, '..');
const out = path.join(root, 'build/web');
const samples = {
  typing: ['mistakes/typing.lis', ''],
  unsuitable: ['mistakes/unsuitable.lis', ''],
  mill: ['mill', 'mill'],
  rack: ['motion/rack', 'rack'],
  controller: ['controller', 'controller'],
  'controller-project': ['controller-project', 'controller-project'],
};

async function filesIn(folder) {
  const entries = await readdir(folder, { withFileTypes: true, recursive: true });
  return entries.filter((entry) => entry.isFile()).map((entry) => path.relative(folder, path.join(entry.parentPath ?? entry.path, entry.name))).sort();
}

/** Size of the names, names and sizes as JSON, bytes: see sample() of src/incoming.ts. */
async function packed(source, name) {
  const whole = path.join(root, 'samples', source);
  const names = name === '' ? [''] : await filesIn(whole);
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
  metafile: true,
});
await writeFile(path.join(out, 'NOTICE.txt'), await notice(metafile));
for (const name of ['index.html', 'page.css', 'icon.svg']) await copyFile(path.join(here, name), path.join(out, name));
for (const name of ['axisc.js', 'axisc.wasm']) await copyFile(path.join(root, 'build/wasm/bin', name), path.join(out, name));
await copyFile(path.join(root, 'build/release/notices/third-party-licences.txt'), path.join(out, 'third-party-licences.txt'));
for (const [name, [source, folder]] of Object.entries(samples)) {
  await writeFile(path.join(out, 'samples', `${name}.bin`), await packed(source, folder));
}
