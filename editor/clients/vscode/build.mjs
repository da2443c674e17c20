// LICENSE and dist/: the bundles, the schemas of JSON files, and a notice with the licences of what the bundles contain.
// AXISC_WASM is the folder of axisc.js and axisc.wasm; without it, the part for editors in browsers is not built.
import { build } from 'esbuild';
import { copyFile, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, '../../..');
const dist = path.join(here, 'dist');

/** The packages that have a source in the bundles. */
function packagesIn(builds) {
  const outputs = builds.flatMap(({ metafile }) => Object.values(metafile.outputs));
  const inputs = outputs.flatMap((output) => Object.keys(output.inputs));
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
const common = { absWorkingDir: here, bundle: true, minify: true, legalComments: 'none', metafile: true };
const built = [
  await build({
    ...common,
    entryPoints: ['src/extension.ts'],
    outfile: 'dist/extension.js',
    platform: 'node',
    format: 'cjs',
    target: 'node20',
    external: ['vscode'],
  }),
];
const wasm = process.env.AXISC_WASM;
if (wasm) {
  const inBrowser = { ...common, platform: 'browser', target: 'es2022', outdir: 'dist/browser' };
  built.push(
    await build({ ...inBrowser, entryPoints: ['src/browser/extension.ts'], format: 'cjs', external: ['vscode'] }),
    await build({
      ...inBrowser,
      entryPoints: ['src/browser/worker.ts'],
      format: 'iife',
      alias: { 'axisc-program': path.resolve(wasm, 'axisc.js') },
      // Of the program's branch for Node.js.
      external: ['fs', 'path', 'crypto'],
    }),
  );
  await copyFile(path.resolve(wasm, 'axisc.wasm'), path.join(dist, 'browser/axisc.wasm'));
}
const notices = await Promise.all(packagesIn(built).map(licence));
const rule = `\n${'-'.repeat(78)}\n\n`;
await writeFile(path.join(dist, 'NOTICE.txt'), ['The scripts in dist contain these packages.\n', ...notices].join(rule));
await copyFile(path.join(root, 'LICENSE'), path.join(here, 'LICENSE'));
for (const name of ['settings', 'machine']) {
  const file = `${name}.schema.json`;
  await copyFile(path.join(root, 'docs/schemas', file), path.join(dist, 'schemas', file));
}
