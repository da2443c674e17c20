// Edits do not make the page larger: one instance of the program serves them all.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { afterCheck, begin, choose, chooseLongList, end, listed, opened, resident } from './support.mjs';

// An instance of the program begins with 16 MB. What the browser has not collected yet makes the page up to 40 MB larger or smaller;
// an instance for each edit made it up to 120 MB larger.
const most = 64;  // MB
let folder;

before(async () => {
  folder = await begin();
});

after(() => end(folder));

/** Counts the instances that are made from now on. */
async function counted(page) {
  const worker = page.workers()[0];
  await worker.evaluate(() => {
    const instantiate = WebAssembly.instantiate;
    globalThis.instances = 0;
    WebAssembly.instantiate = (...given) => (++globalThis.instances, instantiate(...given));
  });
  return () => worker.evaluate(() => globalThis.instances);
}

test('1,000 edits need the instance of the first one, and no more memory', { timeout: 300000 }, async () => {
  const page = await opened();
  await chooseLongList(page, folder);
  const instances = await counted(page);
  const edit = async (count) => {
    for (let i = 0; i < count; ++i) {
      await afterCheck(page, () => page.keyboard.insertText(i % 2 ? 'a' : '1'));
      // Long enough for the quantities to be asked for.
      if (i % 50 === 0) await new Promise((wake) => setTimeout(wake, 300));
    }
  };
  await edit(200);
  const before = await resident();
  await edit(800);
  const growth = (await resident()) - before;
  assert.ok(growth < most, `${growth} MB`);
  assert.equal(await instances(), 0);
  assert.equal(page.workers().length, 1);
  assert.ok((await listed(page)).length > 0);
});

test('what a large file needed is given back', { timeout: 60000 }, async () => {
  const page = await opened();
  const list = path.join(folder, 'x.lis');
  const check = async (text) => {
    await writeFile(list, text);
    await choose(page, list);
  };
  const instances = await counted(page);
  await check(`# ${'x'.repeat(72 << 20)}\n`);
  await check('kopf.achs_nr 01\n');
  assert.equal(await instances(), 1);
  assert.deepEqual((await listed(page)).map(({ code }) => code), ['AX1006']);
});
