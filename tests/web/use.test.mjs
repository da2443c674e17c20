// What one can do on the page: repair folders, align, paste, ask what a name means, compare with what was opened.
import assert from 'node:assert/strict';
import { cp, mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { equalAsNumbers } from '../platforms/equal_as_numbers.mjs';
import test, { after, before } from 'node:test';
import { afterCheck, begin, choose, chooseFolder, chooseSample, cycle, drawn, end, expected, filesBelow, listed, opened, picture, require, root, run, samples, saved, strangers, violations, wait } from './support.mjs';

const { unzipSync } = require('fflate');
const notch = `kopf.achs_nr 1
kenngr.achs_typ 1
filter[0].enable 1
filter[0].type BANDSTOP
filter[0].order 2
filter[0].prototype BUTTERWORTH
filter[0].guete 2
filter[0].fg_f0 42
`;
let folder;
let page;

before(async () => {
  folder = await begin();
  page = await opened();
}, wait);

after(() => end(folder));

test('a repaired folder is what --fix writes, and is saved as one file', wait, async () => {
  const whole = path.join(folder, 'mistakes');
  await cp(path.join(samples, 'mistakes'), whole, { recursive: true });
  const typing = path.join(whole, 'typing.lis');
  await cp(typing, path.join(whole, 'controller/again.lis'));
  const before = new Map();
  for (const file of await filesBelow(whole)) before.set(file, await readFile(file));
  await chooseFolder(page, whole);
  await afterCheck(page, () => page.click('#fix-all'));
  const files = Object.entries(unzipSync(await saved(page, '#download-all')));
  assert.equal(run(['lint', '--fix', 'mistakes'], folder).signal, null);
  for (const [name, bytes] of files) assert.deepEqual(Buffer.from(bytes), await readFile(path.join(folder, name)), name);
  const changed = [];
  for (const file of await filesBelow(whole)) {
    if (!before.get(file).equals(await readFile(file))) changed.push(path.relative(folder, file));
  }
  assert.deepEqual(files.map(([name]) => name).sort(), changed.sort());
  assert.ok(changed.length > 1);
  for (const name of changed) {
    await page.click(`#file-list button[title="${name}"]`);
    assert.deepEqual(await saved(page, '#download'), await readFile(path.join(folder, name)), name);
  }
});

test('a fix in a file that is not shown opens it', wait, async () => {
  await chooseFolder(page, path.join(samples, 'mistakes'));
  const place = 'mistakes/typing.lis:2:34';
  await afterCheck(page, () => page.click(`#finding-list li:has-text("${place}") .fix`));
  assert.equal(await page.$eval('#file-name', (name) => name.textContent), 'mistakes/typing.lis');
  const before = await readFile(path.join(samples, 'mistakes/typing.lis'), 'latin1');
  assert.equal((await saved(page, '#download')).toString('latin1'), before.replace(/ 01(?=\s)/, ' 1'));
});

test('a fix in another list than its finding changes that list', wait, async () => {
  const rules = path.join(root, 'validator/rules');
  const machine = path.join(rules, 'AX4011-group-delay-mismatch/fail');
  const report = JSON.parse(String(run(['lint', '--format', 'json', 'fail'], path.dirname(machine)).stdout));
  const { file, fix } = report.diagnostics.find((finding) => finding.fix?.edits.some((edit) => edit.file !== finding.file));
  const [{ file: repaired, line, column, end_line: endLine, end_column: endColumn, text }] = fix.edits;
  assert.equal(line, endLine);
  const lines = (await readFile(path.join(path.dirname(machine), repaired), 'latin1')).split('\n');
  lines[line - 1] = lines[line - 1].slice(0, column - 1) + text + lines[line - 1].slice(endColumn - 1);
  await chooseFolder(page, machine);
  await afterCheck(page, () => page.click(`#finding-list li:has-text("${file}") .fix`));
  assert.equal(await page.$eval('#file-name', (name) => name.textContent), repaired);
  assert.equal((await saved(page, '#download')).toString('latin1'), lines.join('\n'));
  assert.equal(await page.isVisible('#download-all'), false);
});

test('an aligned list is what fmt writes; undo brings the old one back', wait, async () => {
  const list = path.join(folder, 'wide.lis');
  const text = 'kopf.achs_nr 1 ( Nummer\r\nkenngr.achs_typ       1 ( Typ\r\n';
  await writeFile(list, text);
  await choose(page, list);
  await afterCheck(page, () => page.click('#align'));
  run(['fmt', 'wide.lis'], folder);
  assert.notEqual(await readFile(list, 'utf8'), text);
  assert.deepEqual(await saved(page, '#download'), await readFile(list));
  await page.click('.cm-content');
  await afterCheck(page, () => page.keyboard.press('Control+z'));
  assert.equal(String(await saved(page, '#download')), text);
});

test('findings are German in German', wait, async () => {
  const list = path.join(samples, 'mistakes/units.lis');
  await choose(page, list);
  await afterCheck(page, () => page.selectOption('#language', 'de'));
  assert.deepEqual(await listed(page), expected([...cycle, 'units.lis'], path.dirname(list), 'de'));
  assert.equal(await page.$eval('html', (html) => html.lang), 'de');
  await afterCheck(page, () => page.selectOption('#language', 'en'));
});

test('the cycle time decides', wait, async () => {
  const list = path.join(samples, 'mistakes/units.lis');
  await choose(page, list);
  await page.fill('#cycle-time', 'Abc');
  await page.press('#cycle-time', 'Enter');
  assert.equal(await page.getAttribute('#cycle-time', 'aria-invalid'), 'true');
  await page.fill('#cycle-time', '250us');
  await afterCheck(page, () => page.press('#cycle-time', 'Enter'));
  assert.deepEqual(await listed(page), expected(['--cycle-time', '250us', 'units.lis'], path.dirname(list)));
  await page.fill('#cycle-time', '1ms');
  await afterCheck(page, () => page.press('#cycle-time', 'Enter'));
});

test('what is pasted becomes a list; names that look like options are names', wait, async () => {
  await page.focus('#theme');
  await afterCheck(page, () =>
    page.evaluate(() => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text/plain', 'kopf.achs_nr 01\n');
      document.activeElement.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
    }),
  );
  assert.deepEqual((await listed(page)).map(({ code, place }) => [code, place]), [['AX1006', 'x.lis:1:14']]);
  const odd = ['--help.lis', '@x.lis', 'ä ö.lis'].map((name) => path.join(folder, name));
  for (const file of odd) await writeFile(file, 'kopf.achs_nr 01\n');
  await choose(page, odd);
  assert.deepEqual((await listed(page)).map(({ place }) => place).sort(), ['--help.lis:1:14', '@x.lis:1:14', 'ä ö.lis:1:14']);
});

test('dropped files are opened', wait, async () => {
  await afterCheck(page, () =>
    page.evaluate(() => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File(['kopf.achs_nr 02\n'], 'dropped.lis'));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    }),
  );
  assert.deepEqual((await listed(page)).map(({ place }) => place), ['dropped.lis:1:14']);
});

test('a name says what it means, and completes; numbers say their quantity', wait, async () => {
  const list = path.join(folder, 'q.lis');
  await writeFile(list, notch);
  await choose(page, list);
  await page.waitForSelector('.hint');
  assert.ok((await page.$$eval('.hint', (hints) => hints.map((hint) => hint.textContent))).includes('= 42 Hz'));
  await page.hover('.list-name:text-is("filter[0].fg_f0")');
  await page.waitForSelector('.meaning img');
  assert.match(await page.$eval('.meaning', (meaning) => meaning.textContent), /P-AXIS-00067/);
  await picture(page, 'hover');
  await page.mouse.move(2, 2);
  await page.click('.cm-content');
  await page.keyboard.press('Control+End');
  await page.keyboard.type('filter[1].proto', { delay: 30 });
  await page.waitForSelector('.cm-tooltip-autocomplete [aria-selected]');
  await picture(page, 'completion');
  await new Promise((wake) => setTimeout(wake, 200));
  await afterCheck(page, () => page.keyboard.press('Enter'));
  assert.match(String(await saved(page, '#download')), /\nfilter\[1\]\.prototype$/);
});

test('the machine leads to its files; an edit is compared with what was opened', wait, async () => {
  await chooseSample(page, 'mill');
  await page.click('#tab-machine');
  await page.waitForFunction(() => document.getElementById('contour-text').textContent.includes('µm'));
  await page.click('#machine-text .link:text-is("x.lis")');
  assert.equal(await page.$eval('#file-name', (name) => name.textContent), 'mill/x.lis');
  await page.click('#tab-pictures');
  const source = () => page.$eval('.frame img', (image) => image.src);
  await page.waitForFunction(() => document.querySelector('.frame img').naturalWidth > 0);
  const alone = await source();
  await page.click('.cm-content');
  await page.keyboard.press('Control+End');
  await afterCheck(page, () => page.keyboard.insertText('filter[0].guete 5\n'));
  await page.click('#compare');
  assert.ok(await page.isChecked('#before'));
  await page.waitForFunction((before) => document.querySelector('.frame img').src !== before, alone);
  const svg = String(await saved(page, '#save-picture'));
  assert.match(svg, /<svg[^]*before/);
  await page.uncheck('#before');
  await drawn(page, 'path');
  assert.equal(await page.isVisible('#before'), false);
  await page.click('#tab-findings');
});

test('an axis with its plant is drawn as plot draws it, from a folder and from single files', wait, async () => {
  const rack = path.join(samples, 'motion/rack');
  const plot = (...words) => String(run(['plot', '--lang', 'en', '--kind', 'plant', '--format', 'svg', '-o', '-', ...words], path.dirname(rack)).stdout);
  await chooseFolder(page, rack);
  await page.click('#tab-pictures');
  await drawn(page, 'plant');
  await picture(page, 'plant');
  const shows = async (wanted) => {
    while (!equalAsNumbers(String(await saved(page, '#save-picture')), wanted, true)) await new Promise((wake) => setTimeout(wake, 100));
  };
  await shows(plot('--plant', 'rack/plant.json', '--move', 'X:100', 'rack'));
  await page.fill('#travel', '800');
  await page.fill('#feed', '31800');
  await page.press('#feed', 'Enter');
  await shows(plot('--plant', 'rack/plant.json', '--move', 'X:800:31800', 'rack'));
  await page.fill('#travel', '8,0,0');
  await page.press('#travel', 'Enter');
  await page.waitForSelector('#picture-trouble:visible');
  await page.fill('#travel', '100');
  const single = (await filesBelow(rack)).filter((file) => /\.(lis|json)$/.test(file));
  await choose(page, single);
  assert.deepEqual(await listed(page), expected(['machine.json', 'x.lis'], rack));
  await page.click('#tab-pictures');
  await drawn(page, 'plant');
  assert.equal(await page.inputValue('#plant'), 'plant.json');
  await drawn(page, 'response');
  await page.click('#tab-findings');
});

test('an image of the mill is the native one', wait, async () => {
  await chooseSample(page, 'mill');
  const image = await saved(page, '#compile');
  await mkdir(path.join(folder, 'images'));
  run(['compile', '--quiet', '-o', path.join(folder, 'images/mill.axim'), 'mill'], samples);
  assert.deepEqual(image, await readFile(path.join(folder, 'images/mill.axim')));
});

test('the start page shows a result; its fix opens the list', wait, async () => {
  const one = await opened();
  const codes = await one.$$eval('#example-findings .code', (all) => all.map((code) => code.textContent));
  assert.ok(codes.includes('AX1005'), String(codes));
  assert.equal(await one.isVisible('#verdict'), false);
  await afterCheck(one, () => one.click('#example-findings li:has-text("AX1005") .fix'));
  assert.match(String(await saved(one, '#download')), /fg_f0 +42\.5\n/);
  await one.click('#home');
  assert.ok(await one.isVisible('#drop'));
  await one.click('#other');
  assert.ok(await one.isVisible('#verdict'));
  await one.context().close();
});

test('a sound folder shows its machine, its verdict, and what its files are for', wait, async () => {
  await chooseFolder(page, path.join(samples, 'controller'));
  await page.waitForFunction(() => document.body.dataset.panel === 'machine' && document.getElementById('contour-text').textContent.includes('µm'));
  assert.equal(await page.getAttribute('#verdict', 'data-state'), 'sound');
  await page.waitForFunction(() => document.getElementById('subject-words').textContent !== '');
  assert.match(await page.textContent('#subject'), /hochlauf.*X, Y, Z, X2, U, S.*2000 µs, from controller\/listen\/rtconf\.lis:5/);
  assert.equal(await page.isVisible('#cycle-time'), false);
  assert.ok(await page.isVisible('#contour-text'));
  const rows = await page.$$eval('#contour-text tbody tr', (all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  // samples/controller/listen/achsmds1.lis: a moving average of order 10, half of it at 2 ms; achsmds5.lis: a low-pass at 30 Hz.
  assert.deepEqual(rows[0].slice(0, 3), ['X', 'moving average of order 10', '10']);
  assert.deepEqual(rows[4].slice(0, 2), ['U', 'low-pass 30 Hz']);
  const files = await page.$$eval('#file-list button', (all) => all.map((row) => row.textContent));
  assert.ok(files.includes('Xachsmds1.lis') && files.includes('Fraesensda_mds1.lis'), String(files));
});

test('of several machines one is chosen', wait, async () => {
  for (const name of ['mill', 'motion/rack']) await cp(path.join(samples, name), path.join(folder, 'hall', path.basename(name)), { recursive: true });
  await chooseFolder(page, path.join(folder, 'hall'));
  await page.click('#tab-machine');
  await page.waitForFunction(() => document.querySelectorAll('#machines option').length === 2);
  await page.selectOption('#machines', 'hall/rack/machine.json');
  await page.waitForFunction(() => document.querySelector('#contour-text table')?.tBodies[0].rows.length === 1);
  assert.equal(await page.$eval('#file-name', (name) => name.textContent), 'hall/rack/machine.json');
});

test('equal findings are one entry that repairs all of them; severities are chosen', wait, async () => {
  const lists = ['a', 'b', 'c'].map((name) => path.join(folder, `${name}.lis`));
  for (const list of lists) await writeFile(list, 'kopf.achs_nr 01\nfilter[0].oder 2\nENDE\n');
  await choose(page, lists);
  const titles = await page.$$eval('#finding-list li', (items) => items.map((item) => item.querySelector('.code').textContent));
  assert.deepEqual(titles.filter((code) => code === 'AX1006'), ['AX1006']);
  const count = (await listed(page)).length;
  await page.click('#filters .error');
  assert.ok((await listed(page)).every(({ severity }) => severity === 'error'));
  await page.click('#filters .all');
  assert.equal((await listed(page)).length, count);
  await afterCheck(page, () => page.click('#finding-list li:has-text("AX1006") .fix'));
  assert.deepEqual((await listed(page)).filter(({ code }) => code === 'AX1006'), []);
  assert.equal(await page.$$eval('#file-list .changed', (marks) => marks.length), 3);
});

test('the number of safe fixes is that of --fix; without any there is nothing to press', wait, async () => {
  const copy = path.join(folder, 'typing.lis');
  await cp(path.join(samples, 'mistakes/typing.lis'), copy);
  await choose(page, copy);
  const { stdout, stderr } = run(['lint', '--fix', ...cycle, 'typing.lis'], folder);
  const fixed = /(\d+) findings? w/.exec(`${stdout}${stderr}`)?.[1];
  await page.waitForFunction((count) => document.getElementById('fix-all').textContent.includes(`(${count})`), fixed);
  await chooseFolder(page, path.join(samples, 'mill'));
  await page.waitForFunction(() => document.getElementById('fix-all').disabled);
});

test('numbers, codes and words are looked up, and lead to one another', wait, async () => {
  await page.fill('#word', 'AX3004');
  await page.press('#word', 'Enter');
  await page.waitForFunction(() => document.querySelector('dialog[open] #page-text')?.textContent.includes('AX3004'));
  await page.keyboard.press('Escape');
  await page.fill('#word', '50663');
  await page.press('#word', 'Enter');
  await page.waitForFunction(() => document.querySelector('dialog[open] #page-text')?.textContent.includes('50663'));
  await page.click('#page-text .link:text-is("AX3004")');
  await page.waitForFunction(() => document.querySelector('#page-text h3')?.textContent.startsWith('AX3004'));
  await page.keyboard.press('Escape');
});

test('a recording that is dropped on its lists is compared with them', wait, async () => {
  const recording = path.join(samples, 'recording');
  await choose(page, path.join(recording, 'x.lis'));
  const text = path.join(folder, 'scope.txt');
  await cp(path.join(recording, 'scope.csv'), text);
  await page.setInputFiles('#files', text);
  await page.waitForFunction(() => document.getElementById('picture-text').textContent !== '' && document.querySelector('.frame img').naturalWidth > 0);
  const { stdout } = run(['compare', '--lang', 'en', 'x.lis', 'scope.csv', ...cycle, '--format', 'json'], recording);
  const deviation = JSON.parse(stdout).listed.largest;
  assert.ok((await page.textContent('#picture-text')).includes(String(Number(deviation.toPrecision(3)))));
});

test('changes are not lost without a question', wait, async () => {
  await choose(page, path.join(samples, 'mistakes/units.lis'));
  await page.click('.cm-content');
  await afterCheck(page, () => page.keyboard.insertText('# '));
  const asked = page.waitForEvent('dialog');
  await choose(page, path.join(samples, 'mistakes/typing.lis'));
  assert.match((await asked).message(), /units\.lis/);
});

test('licences are in the page', wait, async () => {
  await page.click('#other');
  await page.click('#about .link');
  await page.waitForFunction(() => /MIT License[^]*codemirror[^]*Boost/i.test(document.querySelector('dialog[open] #page-text')?.textContent ?? ''));
  await page.keyboard.press('Escape');
  await page.click('#other');
});

test('nothing was refused by the policy, and nothing asked for elsewhere', () => {
  assert.deepEqual(violations, []);
  assert.deepEqual(strangers, []);
});
