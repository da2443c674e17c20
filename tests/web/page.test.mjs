// The page in a real browser: what it shows is what the native program says, and nothing leaves it.
//   AXISC, PAGE: the native program and the folder of the page; AXISC_PICTURES: where pictures of the page are written
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { createServer } from 'node:http';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync } from 'node:zlib';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const require = createRequire(path.join(root, 'web/package.json'));
const { chromium } = require('playwright-core');
const native = process.env.AXISC ?? path.join(root, 'build/release/bin/axisc');
const pageFolder = process.env.PAGE ?? path.join(root, 'build/web');
const samples = path.join(root, 'samples');
const wait = { timeout: 120000 };
const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.svg': 'image/svg+xml' };

let server;
let browser;
let page;
let folder;
let address;
const violations = [];
const strangers = [];

before(async () => {
  folder = await mkdtemp(path.join(os.tmpdir(), 'axisc-web-'));
  server = createServer(async (request, response) => {
    const name = path.join(pageFolder, path.normalize(new URL(request.url, 'http://x').pathname.replace(/\/$/, '/index.html')));
    try {
      const bytes = await readFile(name);
      response.writeHead(200, { 'content-type': types[path.extname(name)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  address = `http://127.0.0.1:${server.address().port}/`;
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
  page = await opened();
}, wait);

after(async () => {
  await browser?.close();
  server?.close();
  if (folder) await rm(folder, { recursive: true, force: true });
});

async function opened(options = {}, target = '') {
  const context = await browser.newContext({ locale: 'en-GB', viewport: { width: 1280, height: 800 }, ...options });
  const made = await context.newPage();
  made.setDefaultTimeout(30000);
  made.on('console', (message) => /Content Security Policy/.test(message.text()) && violations.push(message.text()));
  made.on('pageerror', (failure) => violations.push(String(failure)));
  made.on('request', (request) => {
    if (!request.url().startsWith(address) && !/^(blob|data):/.test(request.url())) strangers.push(request.url());
  });
  await made.goto(address + target);
  await checked(made);
  return made;
}

const rounds = (one = page) => one.evaluate(() => Number(document.body.dataset.checked ?? 0));

/** After `act`, the next check is done. */
async function checked(one = page, act = async () => {}, since = 0) {
  await act();
  await one.waitForFunction((before) => Number(document.body.dataset.checked ?? 0) > before, since);
}

async function afterCheck(one, act) {
  await checked(one, act, await rounds(one));
}

/** Findings as the page lists them. */
const listed = (one = page) =>
  one.$$eval('#finding-list li', (items) =>
    items.map((item) => ({
      severity: item.className,
      code: item.querySelector('.code').textContent,
      message: item.querySelector('.message').textContent,
      place: item.querySelector('.place').textContent.replace(/^.* · /, ''),
    })),
  );

function expected(words, cwd) {
  const { stdout } = spawnSync(native, ['lint', '--lang', 'en', ...words, '--format', 'json'], { cwd, env: { ...process.env, LANG: 'C.UTF-8' }, maxBuffer: 1 << 28 });
  return JSON.parse(stdout).diagnostics.map((finding) => ({
    severity: finding.severity,
    code: finding.code,
    message: finding.message,
    place: finding.line > 0 ? `${finding.file}:${finding.line}:${finding.column ?? 1}` : finding.file,
  }));
}

async function filesBelow(whole) {
  const entries = await readdir(whole, { withFileTypes: true, recursive: true });
  return entries.filter((entry) => entry.isFile()).map((entry) => path.join(entry.parentPath ?? entry.path, entry.name)).sort();
}

const choose = (one, files) => afterCheck(one, () => one.setInputFiles('#files', files));
const chooseFolder = (one, whole) => afterCheck(one, () => one.setInputFiles('#folder', whole));

async function picture(one, name) {
  if (!process.env.AXISC_PICTURES) return;
  await mkdir(process.env.AXISC_PICTURES, { recursive: true });
  await new Promise((wake) => setTimeout(wake, 400));
  await one.screenshot({ path: path.join(process.env.AXISC_PICTURES, `${name}.png`) });
}

test('findings of every list are those of the program', wait, async () => {
  const lists = (await filesBelow(samples)).filter((file) => file.endsWith('.lis'));
  assert.ok(lists.length > 30);
  for (const list of lists) {
    await choose(page, list);
    assert.deepEqual(await listed(), expected(['--cycle-time', '1ms', path.basename(list)], path.dirname(list)), list);
  }
});

test('findings of every folder are those of the program', wait, async () => {
  for (const name of ['mistakes', 'mistakes/controller', 'controller', 'controller-project', 'controller-xml', 'mill', 'manual']) {
    const whole = path.join(samples, name);
    await chooseFolder(page, whole);
    const paths = await page.$$eval('#file-list button', (rows) => rows.map((row) => row.firstChild.textContent));
    assert.deepEqual(paths, (await filesBelow(whole)).map((file) => path.relative(path.dirname(whole), file)).sort());
    assert.deepEqual(await listed(), expected([path.basename(whole)], path.dirname(whole)), name);
  }
});

test('what is downloaded after "fix all" is what --fix writes, byte for byte', wait, async () => {
  for (const name of ['typing.lis', 'comments.lis', 'units.lis']) {
    const copy = path.join(folder, name);
    await cp(path.join(samples, 'mistakes', name), copy);
    await choose(page, copy);
    await afterCheck(page, () => page.click('#fix-all'));
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#download')]);
    spawnSync(native, ['lint', '--fix', '--cycle-time', '1ms', name], { cwd: folder });
    assert.deepEqual(await readFile(await download.path()), await readFile(copy), name);
  }
});

test('a quick fix changes its bytes alone; line ends and windows-1252 stay', wait, async () => {
  const list = path.join(folder, 'alt.lis');
  await writeFile(list, Buffer.from('kenngr.achs_typ 1 # Längsachse\r\nkopf.achs_nr 01\r\n', 'latin1'));
  await choose(page, list);
  await afterCheck(page, () => page.click('#finding-list li:has-text("AX1006") .fix'));
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#download')]);
  const bytes = await readFile(await download.path());
  assert.equal(bytes.toString('latin1'), 'kenngr.achs_typ 1 # Längsachse\r\nkopf.achs_nr 1\r\n');
});

test('an image compiled in the page is the native one', wait, async () => {
  await chooseFolder(page, path.join(samples, 'controller'));
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#compile')]);
  const image = path.join(folder, 'native.axim');
  const run = spawnSync(native, ['compile', '--quiet', '-o', image, 'controller'], { cwd: samples });
  assert.equal(run.status, 0, String(run.stderr));
  assert.deepEqual(await readFile(await download.path()), await readFile(image));
});

test('machine, pictures with zoom, before and after, report', wait, async () => {
  await afterCheck(page, () => page.selectOption('#samples', 'mill'));
  await page.click('#tab-machine');
  await page.waitForFunction(() => document.getElementById('machine-text').textContent.includes('X'));
  await page.click('#tab-pictures');
  for (const kind of ['response', 'step', 'delay', 'corner', 'circle']) {
    await page.selectOption('#kind', kind);
    await page.waitForFunction((alt) => {
      const image = document.querySelector('.frame img');
      return image.alt === alt && image.complete && image.naturalWidth > 0;
    }, await page.$eval('#kind', (menu) => menu.selectedOptions[0].textContent));
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
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-report')]);
  assert.match(await readFile(await download.path(), 'utf8'), /^<!doctype html>/i);
  await page.click('#tab-findings');
});

test('typing in the editor is checked, and findings lead to their lines', wait, async () => {
  const list = path.join(folder, 'x.lis');
  await writeFile(list, 'kenngr.achs_typ 1\nkopf.achs_nr 1\n');
  await choose(page, list);
  assert.deepEqual(await listed(), []);
  await page.click('.cm-content');
  await page.keyboard.press('Control+End');
  await afterCheck(page, () => page.keyboard.insertText('filter[0].oder 2\n'));
  const found = await listed();
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
  page.once('dialog', (dialog) => violations.push(dialog.message()));
  await choose(page, hostile);
  assert.ok((await listed()).length > 0);
  assert.equal(await page.$$eval('main img:not(.frame img), main script', (found) => found.length), 0);
  const binary = path.join(folder, 'x.bin');
  await writeFile(binary, Buffer.from(Array.from({ length: 5000 }, (_, i) => (i * 37) % 256)));
  await choose(page, binary);
  assert.equal(await page.$eval('#hidden-text', (text) => text.hidden), false);
  const large = path.join(folder, 'large.lis');
  await writeFile(large, Buffer.alloc(100 << 20, 'filter[0].order 2\n'));
  await choose(page, large);
  assert.equal(await page.$eval('#hidden-text', (text) => text.hidden), false);
});

test('keyboard alone opens, fixes, and turns the panels', wait, async () => {
  const list = path.join(folder, 'keys.lis');
  await writeFile(list, 'kopf.achs_nr 01\n');
  await choose(page, list);
  await page.focus('h1 ~ .bar #open');
  const seen = new Set();
  for (let i = 0; i < 40; ++i) {
    await page.keyboard.press('Tab');
    const id = await page.evaluate(() => document.activeElement.id || document.activeElement.className);
    seen.add(id);
    if (id === 'fix') break;
  }
  for (const id of ['open-folder', 'samples', 'cycle-time', 'language', 'theme', 'download', 'share', 'tab-findings', 'fix-all', 'compile', 'code', 'message', 'fix']) {
    assert.ok(seen.has(id), `${id} of ${[...seen]}`);
  }
  await afterCheck(page, () => page.keyboard.press('Enter'));
  assert.deepEqual(await listed(), []);
  await page.focus('#tab-findings');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.$eval('#machine', (panel) => panel.hidden), false);
  await page.keyboard.press('ArrowLeft');
});

test('axe-core finds nothing serious; every language, theme and width', wait, async () => {
  const axe = await readFile(require.resolve('axe-core/axe.min.js'), 'utf8');
  for (const [language, theme, width] of [['en', 'light', 1280], ['de', 'dark', 1280], ['de', 'light', 420], ['en', 'dark', 420]]) {
    const one = await opened({ locale: language === 'de' ? 'de-DE' : 'en-GB', colorScheme: theme, viewport: { width, height: 800 }, bypassCSP: true });
    await chooseFolder(one, path.join(samples, 'mistakes'));
    for (const panel of ['findings', 'machine', 'pictures', 'report']) {
      await one.click(`#tab-${panel}`);
      await one.evaluate(axe);
      const found = await one.evaluate(() => axe.run(document, { iframes: false }));
      const serious = found.violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
      assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), [], `${language} ${theme} ${width} ${panel}`);
    }
    await one.click('#tab-findings');
    await picture(one, `${language}-${theme}-${width}`);
    assert.ok(await one.evaluate(() => document.documentElement.scrollWidth <= innerWidth + 1), `${width} wide`);
    await one.context().close();
  }
});

test('figures of the page', wait, async () => {
  const started = performance.now();
  const fresh = await opened();
  const start = performance.now() - started;
  const lines = Array.from({ length: 1000 }, (_, i) => (i % 7 === 0 ? `# Zeile ${i}` : `lr_param.table[${i % 100}].value ${i}`));
  const list = path.join(folder, 'long.lis');
  await writeFile(list, `kopf.achs_nr 1\n${lines.join('\n')}\n`);
  await choose(fresh, list);
  await fresh.click('.cm-content');
  await fresh.keyboard.press('Control+End');
  const times = [];
  const memory = () => fresh.evaluate(() => performance.memory?.usedJSHeapSize ?? 0);
  for (let i = 0; i < 20; ++i) await afterCheck(fresh, () => fresh.keyboard.insertText('# '));
  const before = await memory();
  for (let i = 0; i < 200; ++i) {
    const begin = performance.now();
    await afterCheck(fresh, () => fresh.keyboard.insertText(i % 2 ? 'a' : '1'));
    times.push(performance.now() - begin, Number(await fresh.evaluate(() => document.body.dataset.time)));
  }
  const after = await memory();
  const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)].toFixed(1);
  const whole = times.filter((_, i) => i % 2 === 0);
  const inWorker = times.filter((_, i) => i % 2 === 1);
  const machine = path.join(folder, 'sixteen');
  await mkdir(machine);
  const axes = Array.from({ length: 16 }, (_, i) => ({ name: `A${i}`, list: `a${i}.lis` }));
  await writeFile(path.join(machine, 'machine.json'), JSON.stringify({ machine: 'sixteen', cycle_time_us: 1000, axes }));
  for (let i = 0; i < 16; ++i) await writeFile(path.join(machine, `a${i}.lis`), `kopf.achs_nr ${i + 1}\n${lines.join('\n')}\n`);
  await chooseFolder(fresh, machine);
  const ofFolder = Number(await fresh.evaluate(() => document.body.dataset.time));
  let size = 0;
  for (const name of ['index.html', 'page.css', 'page.js', 'worker.js', 'axisc.js', 'axisc.wasm', 'icon.svg']) {
    size += brotliCompressSync(await readFile(path.join(pageFolder, name))).length;
  }
  console.error(`start to findings ${start.toFixed(0)} ms; a keystroke in 1,000 lines ${median(whole)} ms (in the worker ${median(inWorker)} ms); ` +
    `16 axes of 1,000 lines ${ofFolder.toFixed(0)} ms; ${(size / 1e6).toFixed(2)} MB with brotli; ` +
    `heap ${(before / 1e6).toFixed(1)} to ${(after / 1e6).toFixed(1)} MB over 200 edits`);
  await fresh.context().close();
});

test('nothing was refused by the policy, and nothing asked for elsewhere', () => {
  assert.deepEqual(violations, []);
  assert.deepEqual(strangers, []);
});
