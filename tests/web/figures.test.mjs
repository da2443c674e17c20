// How quick and how large the page is: printed, not asserted, for machines differ.
import { mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { brotliCompressSync } from 'node:zlib';
import { afterCheck, begin, chooseFolder, chooseLongList, end, isOneFile, opened, place, resident, samples, wait } from './support.mjs';

let folder;

before(async () => {
  folder = await begin();
}, wait);

after(() => end(folder));

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const pause = (time) => new Promise((wake) => setTimeout(wake, time));

test('figures', { timeout: 300000 }, async () => {
  const starts = [];
  for (let i = 0; i < 5; ++i) {
    const one = await opened();
    starts.push(await one.evaluate(() => Number(document.body.dataset.first)));
    await one.context().close();
  }
  const page = await opened();
  await chooseLongList(page, folder);
  const memory = () => page.evaluate(() => (globalThis.gc?.(), performance.memory.usedJSHeapSize / 1e6));
  const latencies = [];
  let before = 0;
  let occupied = 0;
  for (let i = 0; i < 1000; ++i) {
    if (i === 100) [before, occupied] = [await memory(), await resident()];
    await afterCheck(page, () => page.keyboard.insertText(i % 2 ? 'a' : '1'));
    latencies.push(await page.evaluate(() => Number(document.body.dataset.latency)));
    if (i < 100) await pause(60);
  }
  const [atEnd, occupiedAtEnd] = [await memory(), await resident()];
  const typed = median(latencies.slice(0, 100));
  const machine = path.join(folder, 'sixteen');
  const list = await readFile(path.join(samples, 'mill/default.lis'), 'utf8');
  await mkdir(machine);
  const axes = Array.from({ length: 16 }, (_, i) => ({ name: `A${i}`, list: `a${i}.lis` }));
  await writeFile(path.join(machine, 'machine.json'), JSON.stringify({ machine: 'sixteen', cycle_time_us: 1000, axes }));
  for (let i = 0; i < 16; ++i) await writeFile(path.join(machine, `a${i}.lis`), list.replace(/kopf.achs_nr +0/, `kopf.achs_nr ${i + 1}`));
  const folders = [];
  for (let i = 0; i < 5; ++i) {
    await chooseFolder(page, machine);
    folders.push(await page.evaluate(() => Number(document.body.dataset.latency)));
  }
  let size = 0;
  const parts = isOneFile ? [] : (await readdir(place)).filter((one) => /\.(css|js|wasm|svg)$|^index/.test(one));
  for (const name of parts) size += brotliCompressSync(await readFile(path.join(place, name))).length;
  const sizes = isOneFile ? `${(await readFile(place)).length} bytes in one file` : `${(size / 1e6).toFixed(2)} MB with brotli`;
  console.error(
    `figures: ${median(starts).toFixed(0)} ms from navigation to the first findings; ${typed.toFixed(0)} ms from a keystroke in 1,000 lines to its findings; ` +
      `${median(folders).toFixed(0)} ms for 16 axes; ${sizes}; ` +
      `after 100 edits ${before.toFixed(1)} MB of objects, ${occupied.toFixed(0)} MB with the worker; ` +
      `after 1,000 edits ${atEnd.toFixed(1)} MB and ${occupiedAtEnd.toFixed(0)} MB`,
  );
});
