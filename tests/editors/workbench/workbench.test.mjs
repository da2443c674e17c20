// The real workbench shows what the program says: squiggles, hover, completion, fixes, layout and pages.
// AXISC_PACKED is the folder of an unpacked .vsix whose server runs in the browser; without it, the server is the native program.
// AXISC_UPDATE_GOLDEN=1 writes the pictures of docs/editors.md, AXISC_PICTURES=FOLDER writes them elsewhere.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cp, mkdir, mkdtemp, readFile, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { serve } from './bridge.mjs';

const program = process.env.AXISC ?? 'axisc';
const samples = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../../samples');
const documented = ['findings', 'hover', 'fix'];
const documents = path.resolve(samples, '../docs/pictures/editor');
const wait = { timeout: 60000 };

let folder;
let bridge;
let browser;
let page;

before(async () => {
  folder = await mkdtemp(path.join(os.tmpdir(), 'axisc-'));
  await cp(samples, folder, { recursive: true });
  bridge = await serve({ folder, program, packed: process.env.AXISC_PACKED, settings: { 'workbench.colorTheme': 'Default Light Modern', 'workbench.activityBar.location': 'hidden' } });
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
  page = await browser.newPage({ viewport: { width: 960, height: 540 } });
  page.setDefaultTimeout(20000);
  page.on('console', (message) => message.type() === 'error' && process.env.AXISC_LOUD && console.error(message.text()));
  await page.goto(bridge.address);
  await page.waitForSelector('.monaco-workbench');
  // More room for what is looked at.
  await page.locator('.explorer-folders-view').waitFor();
  await press('Control+b');
}, wait);

after(async () => {
  await browser?.close();
  await bridge?.close();
  if (folder) await rm(folder, { recursive: true, force: true });
});

/** Keys as the manual names them. */
async function press(...keys) {
  for (const key of keys) await page.keyboard.press(key);
}

async function picture(name) {
  const updates = process.env.AXISC_UPDATE_GOLDEN === '1' && documented.includes(name);
  const pictures = process.env.AXISC_PICTURES ?? (updates ? documents : undefined);
  if (!pictures) return;
  await mkdir(pictures, { recursive: true });
  // Until what fades in has come.
  await new Promise((wake) => setTimeout(wake, 500));
  await page.screenshot({ path: path.join(pictures, `${name}.png`) });
}

const text = (file) => readFile(path.join(folder, file), 'utf8');

/** The file as it is after saving. */
async function saved(file, condition) {
  await press('Control+s');
  for (;;) {
    const now = await text(file);
    if (condition(now)) return now;
    await new Promise((wake) => setTimeout(wake, 50));
  }
}

async function lineOf(file, part) {
  const lines = (await text(file)).split('\n');
  const line = lines.findIndex((one) => one.includes(part));
  assert.ok(line >= 0, part);
  return line;
}

test('findings are underlined and listed', wait, async () => {
  assert.equal(await bridge.open('mistakes/typing.lis'), 'axis-list');
  await page.waitForSelector('.squiggly-error');
  await page.waitForSelector('.squiggly-warning');
  await press('Control+Shift+M');
  // Each once: the workbench is told, and does not ask as well.
  const found = JSON.parse(spawnSync(program, ['lint', 'mistakes/typing.lis', '--format', 'json'], { cwd: samples, encoding: 'utf8' }).stdout);
  await page.locator('.panel .badge', { hasText: new RegExp(`^${found.diagnostics.length}$`) }).waitFor();
  const problems = page.locator('.markers-panel .monaco-list-row');
  await problems.filter({ hasText: 'AX2007' }).first().waitFor();
  await problems.filter({ hasText: 'is not a valid value' }).first().waitFor();
  await picture('findings');
  await press('Control+j');
});

test('the fallback grammar colours a list', wait, async () => {
  await bridge.open('mill/default.lis');
  const coloured = await page.waitForFunction(() => {
    const lines = [...document.querySelectorAll('.view-line')].filter((line) => line.textContent.includes('BANDSTOP'));
    return lines.length > 0 && new Set([...lines[0].querySelectorAll('span span')].map((span) => span.className)).size > 3;
  });
  assert.ok(coloured);
});

test('a name and a value say what they mean', wait, async () => {
  const line = await lineOf('mill/default.lis', 'filter[0].fg_f0');
  await bridge.open('mill/default.lis', line, 12);
  await press('Control+k', 'Control+i');
  const hover = page.locator('.monaco-hover:not(.hidden)');
  await hover.filter({ hasText: 'P-AXIS-00067' }).waitFor();
  await picture('hover');
  await press('Escape');
  await bridge.open('mill/default.lis', line, 53);
  await press('Control+k', 'Control+i');
  await hover.filter({ hasText: '42 Hz' }).waitFor();
  await press('Escape');
});

test('names are completed', wait, async () => {
  const line = await lineOf('mill/default.lis', 'filter[0].fg_f0');
  await bridge.open('mill/default.lis', line, 0);
  await press('End', 'Enter');
  await page.keyboard.type('filter[0].');
  await press('Control+Space');
  const list = page.locator('.suggest-widget.visible .monaco-list-row');
  await list.filter({ hasText: 'prototype' }).waitFor();
  await page.keyboard.type('prot');
  await list.filter({ hasText: 'prototype' }).waitFor();
  await press('Enter');
  await saved('mill/default.lis', (now) => now.split('\n')[line + 1]?.startsWith('filter[0].prototype'));
  await press('Control+Shift+k');
  await saved('mill/default.lis', (now) => !now.split('\n')[line + 1]?.startsWith('filter[0].prototype'));
});

test('the code of a finding leads to its page', wait, async () => {
  await bridge.open('mistakes/typing.lis', await lineOf('mistakes/typing.lis', '17,5'), 35);
  await page.waitForSelector('.squiggly-error');
  await press('Control+k', 'Control+i');
  const code = page.locator('.monaco-hover:not(.hidden) a.code-link', { hasText: 'AX1005' });
  await code.waitFor();
  await picture('code');
  await code.click();
  const shown = page.frameLocator('iframe.webview.ready').last().frameLocator('#active-frame');
  await shown.locator('h1', { hasText: 'AX1005' }).waitFor();
  await picture('page');
});

test('a fix is offered and applied', wait, async () => {
  const line = await lineOf('mistakes/typing.lis', '17,5');
  await bridge.open('mistakes/typing.lis', line, 35);
  await page.waitForSelector('.squiggly-error');
  await press('Control+.');
  const action = page.locator('.action-widget .monaco-list-row').filter({ hasText: '17.5' });
  await action.waitFor();
  await picture('fix');
  await press('Enter');
  await saved('mistakes/typing.lis', (now) => now.includes('17.5') && !now.includes('17,5'));
});

test('a file that is not open counts as soon as it is written', wait, async () => {
  // With a cycle time, the list has figures and a picture of them.
  await bridge.write('manual/axisc.json', '{"cycle_time_us": 1000}');
  await bridge.open('manual/axis-bandstop.lis', await lineOf('manual/axis-bandstop.lis', 'filter[0].fg_f0'), 12);
  const response = page.locator('.monaco-hover:not(.hidden) img[src^="data:image/svg+xml"]');
  while ((await response.count()) === 0) {
    await press('Escape', 'Control+k', 'Control+i');
    await new Promise((wake) => setTimeout(wake, 500));
  }
  await response.scrollIntoViewIfNeeded();
  assert.ok(await response.evaluate((image) => image.complete && image.naturalWidth > 100));
  await picture('response');
  await press('Escape');
});

test('the layout is that of fmt', wait, async () => {
  await bridge.open('manual/axis-pt1.lis', 1, 0);
  await press('End', 'Enter');
  await page.keyboard.type('filter[0].guete 3 ( x');
  await press('Escape', 'Escape');
  await saved('manual/axis-pt1.lis', (now) => now.includes('filter[0].guete 3 ( x'));
  const copy = path.join(folder, 'copy.lis');
  await cp(path.join(folder, 'manual/axis-pt1.lis'), copy);
  assert.equal(spawnSync(program, ['fmt', copy]).status, 0);
  await press('Control+Shift+i');
  const expected = await text('copy.lis');
  await saved('manual/axis-pt1.lis', (now) => now === expected);
});

test('a list in windows-1252 keeps its bytes', wait, async () => {
  const name = path.join(folder, 'mill/x.lis');
  const before = await readFile(name);
  assert.ok(before.includes(Buffer.from('gr\xf6\xdfte', 'latin1')));
  await bridge.open('mill/x.lis', 0, 0);
  await page.locator('.view-line', { hasText: 'längs' }).waitFor();
  await page.keyboard.type('#');
  await saved('mill/x.lis', (now) => now.startsWith('##'));
  assert.ok((await readFile(name)).equals(Buffer.concat([Buffer.from('#'), before])));
});

test('commands show pages beside the text', wait, async () => {
  await bridge.open('mill/x.lis', 0, 0);
  const command = async (title) => {
    await press('F1');
    await page.keyboard.type(`Axisc: ${title}`);
    await page.locator('.quick-input-list .monaco-list-row', { hasText: `Axisc: ${title}` }).first().waitFor();
    await press('Enter');
  };
  const shown = () => page.frameLocator('iframe.webview.ready').last().frameLocator('#active-frame');
  await command('Report');
  await shown().locator('h1').waitFor();
  // The page's own script runs, and nothing of it is refused.
  await shown().locator('button').first().waitFor();
  await picture('report');
  await shown().locator('button').first().click();
  await shown().locator('canvas').first().waitFor();
  await bridge.open('mill/x.lis', 0, 0);
  await command('Plot');
  await page.locator('.quick-input-list .monaco-list-row', { hasText: 'response' }).waitFor();
  await press('Enter');
  await shown().locator('svg').first().waitFor();
  await picture('plot');
});
