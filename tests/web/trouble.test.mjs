// What could not be checked is never shown as sound.
import assert from 'node:assert/strict';
import { cp, mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { afterCheck, begin, choose, chooseFolder, cycle, end, listed, opened, picture, run, samples, wait } from './support.mjs';

let folder;
let page;

before(async () => {
  folder = await begin();
  page = await opened();
}, wait);

after(() => end(folder));

const inTrouble = async (reason) => {
  assert.equal(await page.getAttribute('#verdict', 'data-state'), 'trouble');
  assert.doesNotMatch(await page.textContent('#judgement'), /No findings|can be compiled/);
  assert.match(await page.textContent('#next'), reason);
  assert.ok(await page.isHidden('#no-findings'));
  assert.ok(await page.isVisible('#findings'));
};

test('files that the program refuses are not checked, and the page says why', wait, async () => {
  const binary = path.join(folder, 'x.bin');
  await writeFile(binary, Buffer.from(Array.from({ length: 5000 }, (_, i) => (i * 37) % 256)));
  assert.equal(run(['lint', 'x.bin'], folder).status, 2);
  await choose(page, binary);
  await inTrouble(/x\.bin.*binary/);
  const whole = path.join(folder, 'settings');
  await mkdir(whole);
  await cp(path.join(samples, 'mill/x.lis'), path.join(whole, 'x.lis'));
  await writeFile(path.join(whole, 'axisc.json'), '{');
  assert.equal(run(['lint', 'settings'], folder).status, 2);
  await chooseFolder(page, whole);
  await inTrouble(/axisc\.json/);
  await picture(page, 'trouble');
});

test('of files that are checked in part, findings are shown, and that the verdict is not whole', wait, async () => {
  const whole = path.join(folder, 'part');
  await mkdir(path.join(whole, 'inner'), { recursive: true });
  await writeFile(path.join(whole, 'x.lis'), 'kopf.achs_nr 01\n');
  await writeFile(path.join(whole, 'inner/y.lis'), 'kopf.achs_nr 2\n');
  await writeFile(path.join(whole, 'inner/axisc.json'), '{');
  const { status } = run(['lint', ...cycle, 'part'], folder);
  await chooseFolder(page, whole);
  assert.equal(status, 2);
  await inTrouble(/axisc\.json/);
});

test('a program that gives up leaves no verdict, until it checks again', wait, async () => {
  const list = path.join(folder, 'x.lis');
  await writeFile(list, 'kopf.achs_nr 01\n');
  await choose(page, list);
  assert.equal(await page.getAttribute('#verdict', 'data-state'), 'error');
  const worker = page.workers()[0];
  await worker.evaluate(() => {
    globalThis.decode = TextDecoder.prototype.decode;
    TextDecoder.prototype.decode = () => {
      throw new Error('given up');
    };
  });
  await page.click('.cm-content');
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('# ');
  await page.waitForFunction(() => document.getElementById('verdict').dataset.state === 'trouble');
  await inTrouble(/given up/);
  assert.deepEqual(await listed(page), []);
  await worker.evaluate(() => void (TextDecoder.prototype.decode = globalThis.decode));
  await afterCheck(page, () => page.keyboard.insertText('x'));
  assert.equal(await page.getAttribute('#verdict', 'data-state'), 'error');
  assert.ok((await listed(page)).length > 0);
});

test('a repair that fails is told, and changes nothing', wait, async () => {
  await choose(page, path.join(samples, 'mistakes/typing.lis'));
  await page.waitForFunction(() => !document.getElementById('fix-all').disabled);
  const worker = page.workers()[0];
  await worker.evaluate(() => {
    globalThis.parse = JSON.parse;
    JSON.parse = () => {
      throw new Error('given up');
    };
  });
  await page.click('#fix-all');
  await page.waitForFunction(() => /given up/.test(document.getElementById('told').textContent));
  await worker.evaluate(() => void (JSON.parse = globalThis.parse));
  assert.equal(await page.locator('#file-list .changed').count(), 0);
});

test('with errors nothing is compiled: the findings come first', wait, async () => {
  await choose(page, path.join(samples, 'mistakes/typing.lis'));
  await page.click('#tab-pictures');
  await page.click('#compile');
  await page.waitForFunction(() => /errors first/.test(document.getElementById('told').textContent));
  assert.equal(await page.getAttribute('#tab-findings', 'aria-selected'), 'true');
});
