// What the page shows is what the native program says, and nothing leaves it.
import assert from 'node:assert/strict';
import { cp, mkdtemp, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { afterCheck, begin, choose, chooseFolder, chooseSample, cycle, drawn, end, expected, filesBelow, listed, opened, picture, require, run, samples, saved, strangers, violations, wait } from './support.mjs';

let folder;
let page;

before(async () => {
  folder = await begin();
  page = await opened();
}, wait);

after(() => end(folder));

test('findings of every list are those of the program', wait, async () => {
  const lists = (await filesBelow(samples)).filter((file) => file.endsWith('.lis'));
  assert.ok(lists.length > 30);
  for (const list of lists) {
    // A start-up list names the list that says the cycle time.
    const isStartUp = path.basename(list).startsWith('hochlauf');
    const alone = await mkdtemp(path.join(folder, 'list-'));
    await cp(list, path.join(alone, path.basename(list)));
    await choose(page, path.join(alone, path.basename(list)));
    assert.deepEqual(await listed(page), expected([...(isStartUp ? [] : cycle), path.basename(list)], alone), list);
  }
});

test('findings of every folder are those of the program', wait, async () => {
  for (const name of ['mistakes', 'mistakes/controller', 'controller', 'controller-project', 'controller-xml', 'mill', 'manual']) {
    const whole = path.join(samples, name);
    await chooseFolder(page, whole);
    const paths = await page.$$eval('#file-list button', (rows) => rows.map((row) => row.title).sort());
    assert.deepEqual(paths, (await filesBelow(whole)).map((file) => path.relative(path.dirname(whole), file)).sort());
    // The page has a cycle time for lists of which no file says one.
    const found = expected([path.basename(whole)], path.dirname(whole)).filter(({ code }) => code !== 'AX9006');
    assert.deepEqual(await listed(page), found, name);
    const severities = await page.$$eval('#finding-list li', (items) => items.map((item) => ['error', 'warning', 'note'].indexOf(item.className)));
    assert.deepEqual(severities, [...severities].sort(), `${name}: errors first`);
  }
});

test('what is downloaded after "fix all" is what --fix writes, byte for byte', wait, async () => {
  const copy = path.join(folder, 'typing.lis');
  await cp(path.join(samples, 'mistakes/typing.lis'), copy);
  await choose(page, copy);
  await afterCheck(page, () => page.click('#fix-all'));
  const bytes = await saved(page, '#download');
  run(['lint', '--fix', ...cycle, 'typing.lis'], folder);
  assert.deepEqual(bytes, await readFile(copy));
});

test('a quick fix changes its bytes alone; line ends and windows-1252 stay', wait, async () => {
  const list = path.join(folder, 'alt.lis');
  await writeFile(list, Buffer.from('kenngr.achs_typ 1 # Längsachse\r\nkopf.achs_nr 01\r\n', 'latin1'));
  await choose(page, list);
  await afterCheck(page, () => page.click('#finding-list li:has-text("AX1006") .fix'));
  const bytes = await saved(page, '#download');
  assert.equal(bytes.toString('latin1'), 'kenngr.achs_typ 1 # Längsachse\r\nkopf.achs_nr 1\r\n');
});

test('an image compiled in the page is the native one', wait, async () => {
  await chooseFolder(page, path.join(samples, 'controller'));
  const bytes = await saved(page, '#compile');
  const image = path.join(folder, 'native.axim');
  const { status, stderr } = run(['compile', '--quiet', '-o', image, 'controller'], samples);
  assert.equal(status, 0, String(stderr));
  assert.deepEqual(bytes, await readFile(image));
});

test('an FMU made in the page is the native one', wait, async () => {
  await chooseFolder(page, path.join(samples, 'controller'));
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#fmu')]);
  const fmu = path.join(folder, download.suggestedFilename());
  assert.match(fmu, /\.fmu$/);
  const { status, stderr } = run(['export', 'controller', '--to', 'fmu3', '--binaries', 'none', '-o', fmu], samples);
  assert.equal(status, 0, String(stderr));
  assert.deepEqual(await readFile(await download.path()), await readFile(fmu));
});

test('machine, pictures with zoom, before and after, report', wait, async () => {
  await chooseSample(page, 'mill');
  await page.click('#tab-machine');
  await page.waitForFunction(() => document.getElementById('machine-text').textContent.includes('X') && document.getElementById('contour-text').textContent.includes('µm'));
  await page.click('#tab-pictures');
  for (const kind of ['response', 'step', 'delay', 'corner', 'circle']) {
    await drawn(page, kind);
  }
  await page.focus('.frame');
  await page.keyboard.press('+');
  assert.match(await page.$eval('.frame img', (image) => image.style.transform), /scale\(1\.5\)/);
  await page.keyboard.press('0');
  await page.selectOption('#kind', 'response');
  await picture(page, 'pictures');
  await page.click('#tab-report');
  const frame = page.frameLocator('#report-page');
  await frame.locator('h1').first().waitFor();
  assert.match(String(await saved(page, '#save-report')), /^<!doctype html>/i);
  await page.click('#tab-findings');
});

test('typing in the editor is checked, and findings lead to their lines', wait, async () => {
  const list = path.join(folder, 'x.lis');
  await writeFile(list, 'kenngr.achs_typ 1\nkopf.achs_nr 1\n');
  await choose(page, list);
  assert.deepEqual(await listed(page), []);
  await page.click('.cm-content');
  await page.keyboard.press('Control+End');
  await afterCheck(page, () => page.keyboard.insertText('filter[0].oder 2\n'));
  const found = await listed(page);
  assert.equal(found.length, 1);
  assert.equal(found[0].code, 'AX2001');
  await page.keyboard.press('Control+Home');
  await page.click('#finding-list .message');
  assert.equal(await page.evaluate(() => getSelection().toString()), 'filter[0].oder');
  await page.waitForSelector('.cm-lintRange');
  await page.click('#finding-list .code');
  await page.waitForSelector('dialog[open]');
  assert.match(await page.$eval('#page-text', (text) => text.textContent), /AX2001/);
  await page.keyboard.press('Escape');
});

test('a link carries a list', wait, async () => {
  const list = path.join(folder, 'shared.lis');
  await writeFile(list, 'kopf.achs_nr 1 # ü <b>\n');
  await choose(page, list);
  await page.click('#share');
  await page.waitForFunction(() => location.hash.startsWith('#list='));
  const other = await opened({}, await page.evaluate(() => location.hash));
  assert.equal(await other.$eval('.cm-line', (line) => line.textContent), 'kopf.achs_nr 1 # ü <b>');
  await other.context().close();
  await page.evaluate(() => history.replaceState(null, '', location.pathname));
});

test('hostile input is text', wait, async () => {
  const hostile = path.join(folder, '<img src=x onerror=alert(1)>.lis');
  await writeFile(hostile, 'kopf.achs_nr 1 # <script>alert(1)</script>\n<img/src=x/onerror=alert(1)> 2\n\u0007\u001b[31m 1\n');
  page.once('dialog', (dialog) => dialog.message().startsWith('Unsaved') || violations.push(dialog.message()));
  await choose(page, hostile);
  assert.ok((await listed(page)).length > 0);
  assert.equal(await page.$$eval('main img:not(.frame img), main script', (found) => found.length), 0);
  assert.equal(await page.$$eval('#file-list img', (found) => found.length), 0);
  const binary = path.join(folder, 'x.bin');
  await writeFile(binary, Buffer.from(Array.from({ length: 5000 }, (_, i) => (i * 37) % 256)));
  await choose(page, binary);
  assert.equal(await page.$eval('#hidden-text', (text) => text.hidden), false);
});

test('a file of 100 MB is not shown; the next list does not wait for it', wait, async () => {
  const large = path.join(folder, 'large.lis');
  await writeFile(large, Buffer.alloc(100 << 20, 'filter[0].order 2\n'));
  await page.setInputFiles('#files', large);
  await page.waitForFunction(() => document.getElementById('file-name').textContent === 'large.lis');
  assert.equal(await page.$eval('#hidden-text', (text) => text.hidden), false);
  await new Promise((wake) => setTimeout(wake, 2000));
  const small = path.join(folder, 'small.lis');
  await writeFile(small, 'kopf.achs_nr 01\n');
  await choose(page, small);
  assert.deepEqual(await listed(page), expected([...cycle, 'small.lis'], folder));
});

test('keyboard alone opens, fixes, and turns the panels', wait, async () => {
  const list = path.join(folder, 'keys.lis');
  await writeFile(list, 'kopf.achs_nr 1\nENDE\n');
  await choose(page, list);
  await page.waitForFunction(() => !document.getElementById('fix-all').disabled);
  await page.focus('#home');
  const seen = new Set();
  for (let i = 0; i < 40; ++i) {
    await page.keyboard.press('Tab');
    const id = await page.evaluate(() => document.activeElement.id || document.activeElement.className);
    seen.add(id);
    if (id === 'fix') break;
  }
  for (const id of ['other', 'word', 'language', 'theme', 'cycle-time', 'fix-all', 'compile', 'tab-findings', 'code', 'message', 'place', 'fix']) {
    assert.ok(seen.has(id), `${id} of ${[...seen]}`);
  }
  await afterCheck(page, () => page.keyboard.press('Enter'));
  assert.deepEqual(await listed(page), []);
  await page.focus('#tab-findings');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.$eval('#machine', (panel) => panel.hidden), false);
  await page.keyboard.press('ArrowLeft');
});

test('axe-core finds nothing serious; every language, theme and width', wait, async () => {
  const axe = await readFile(require.resolve('axe-core/axe.min.js'), 'utf8');
  for (const [language, theme, width] of [['en', 'light', 1280], ['de', 'dark', 1280], ['de', 'light', 420], ['en', 'dark', 420]]) {
    const one = await opened({ locale: language === 'de' ? 'de-DE' : 'en-GB', colorScheme: theme, viewport: { width, height: 800 }, bypassCSP: true });
    await one.evaluate(axe);
    const judge = async (view) => {
      const found = await one.evaluate(() => axe.run(document, { iframes: false }));
      const serious = found.violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
      assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), [], `${language} ${theme} ${width} ${view}`);
    };
    await judge('start');
    await chooseSample(one, 'controller');
    await one.click('#tab-machine');
    await one.waitForFunction(() => document.getElementById('contour-text').textContent.includes('µm'));
    await judge('sound machine');
    await picture(one, `sound-${language}-${theme}-${width}`);
    await chooseFolder(one, path.join(samples, 'mistakes'));
    for (const panel of ['findings', 'machine', 'pictures', 'report']) {
      await one.click(`#tab-${panel}`);
      await judge(panel);
    }
    await one.click('#tab-findings');
    await picture(one, `${language}-${theme}-${width}`);
    assert.ok(await one.evaluate(() => document.documentElement.scrollWidth <= innerWidth + 1), `${width} wide`);
    await one.context().close();
  }
});

test('nothing was refused by the policy, and nothing asked for elsewhere', () => {
  assert.deepEqual(violations, []);
  assert.deepEqual(strangers, []);
});
