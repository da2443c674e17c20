// LICENSE and dist/: the bundle, the schemas of JSON files, and a notice with the licences of what the bundle contains.
import { build } from 'esbuild';
import { copyFile, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, '../..');
const dist = path.join(here, 'dist');

/** The packages that have a source in the bundle. */
function packagesIn(metafile) {
  const inputs = Object.values(metafile.outputs).flatMap((output) => Object.keys(output.inputs));
  const folders = inputs.map((input) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(input)?.[0]);
  return [...new Set(folders.filter(Boolean))].sort();
}

async function licence(folder) {
  const about = JSON.parse(await readFile(path.join(here, folder, 'package.json'), 'utf8'));
  const file = (await readdir(path.join(here, folder))).find((name) => /^licen[cs]e/i.test(name));
  if (file === undefined) throw new Error(`${about.name} has no licence in its package`);
  const text = await readFile(path.join(here, folder, file), 'utf8');
  return `${about.name} ${about.version} (${about.license})\n\n${text.replace(/\r\n/g, '\n').trim()}\n`;
}

await rm(dist, { recursive: true, force: true });
await mkdir(path.join(dist, 'schemas'), { recursive: true });
const { metafile } = await build({
  absWorkingDir: here,
  entryPoints: ['src/extension.ts'],
  outfile: 'dist/extension.js',
  bundle: true,
  platform: 'node',
  format: 'cjs',
  target: 'node20',
  external: ['vscode'],
  minify: true,
  legalComments: 'none',
  metafile: true,
});
const notices = await Promise.all(packagesIn(metafile).map(licence));
const rule = `\n${'-'.repeat(78)}\n\n`;
await writeFile(path.join(dist, 'NOTICE.txt'), ['dist/extension.js contains these packages.\n', ...notices].join(rule));
await copyFile(path.join(root, 'LICENSE'), path.join(here, 'LICENSE'));
for (const name of ['settings', 'machine']) {
  const file = `${name}.schema.json`;
  await copyFile(path.join(root, 'docs/schemas', file), path.join(dist, 'schemas', file));
}
