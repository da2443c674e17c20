// The page in a browser, and what the native program says about the same files.
//   AXISC, PAGE: the native program and the folder of the page, or its one file, axisc.html, which is opened from the disk;
//   AXISC_PICTURES: where pictures of the page are written
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const require = createRequire(path.join(root, 'web/package.json'));
const { chromium } = require('playwright-core');
export const native = process.env.AXISC ?? path.join(root, 'build/release/bin/axisc');
export const place = process.env.PAGE ?? path.join(root, 'build/web');
export const isOneFile = place.endsWith('.html');
export const samples = path.join(root, 'samples');
export const wait = { timeout: 120000 };
export const cycle = ['--cycle-time', '1ms'];
const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.svg': 'image/svg+xml' };

let server;
let browser;
let address;
export const violations = [];
export const strangers = [];

/** Serves the page and starts a browser; gives a folder for files. */
export async function begin() {
  if (isOneFile) address = String(pathToFileURL(place));
  else await serve();
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu', '--enable-precise-memory-info', '--js-flags=--expose-gc'] });
  return mkdtemp(path.join(os.tmpdir(), 'axisc-web-'));
}

async function serve() {
  server = createServer(async (request, response) => {
    const name = path.join(place, path.normalize(new URL(request.url, 'http://x').pathname.replace(/\/$/, '/index.html')));
    try {
      const bytes = await readFile(name);
      response.writeHead(200, { 'content-type': types[path.extname(name)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  address = `http://127.0.0.1:${server.address().port}/`;
}

export async function end(folder) {
  await browser?.close();
  server?.close();
  if (folder) await rm(folder, { recursive: true, force: true });
}

export async function opened(options = {}, target = '') {
  const context = await browser.newContext({ locale: 'en-GB', viewport: { width: 1280, height: 800 }, ...options });
  const made = await context.newPage();
  made.setDefaultTimeout(10000);
  made.on('console', (message) => message.type() === 'error' && violations.push(message.text()));
  // Changes of one test are of no interest to the next one.
  made.on('dialog', (dialog) => dialog.accept());
  made.on('pageerror', (failure) => violations.push(String(failure)));
  made.on('request', (request) => {
    if (!request.url().startsWith(address) && !/^(blob|data):/.test(request.url())) strangers.push(request.url());
  });
  await made.goto(address + target);
  await checked(made);
  return made;
}

export const rounds = (one) => one.evaluate(() => Number(document.body.dataset.checked ?? 0));

/** After `act`, the next check is done. */
export async function checked(one, act = async () => {}, since = 0) {
  await act();
  await one.waitForFunction((before) => Number(document.body.dataset.checked ?? 0) > before, since);
}

export async function afterCheck(one, act) {
  await checked(one, act, await rounds(one));
}

const inOrder = (findings) => findings.map((finding) => [JSON.stringify(finding), finding]).sort(([a], [b]) => (a < b ? -1 : 1)).map(([, finding]) => finding);

/** Findings as the page lists them, without their order: equal ones are one entry with several places. */
export const listed = async (one) =>
  inOrder(
    await one.$$eval('#finding-list li', (items) =>
      items.flatMap((item) =>
        [...item.querySelectorAll('.place')].map((place) => ({
          severity: item.className,
          code: item.querySelector('.code').textContent,
          message: item.querySelector('.message').textContent,
          place: place.textContent.replace(/^.* · /, ''),
        })),
      ),
    ),
  );

export function expected(words, cwd, language = 'en') {
  const { stdout } = run(['lint', '--lang', language, ...words, '--format', 'json'], cwd);
  return inOrder(
    JSON.parse(stdout).diagnostics.map((finding) => ({
      severity: finding.severity,
      code: finding.code,
      message: finding.message.replace(/`/g, ''),
      place: finding.line > 0 ? `${finding.file}:${finding.line}:${finding.column ?? 1}` : finding.file,
    })),
  );
}

export async function filesBelow(whole) {
  const entries = await readdir(whole, { withFileTypes: true, recursive: true });
  return entries.filter((entry) => entry.isFile()).map((entry) => path.join(entry.parentPath ?? entry.path, entry.name)).sort();
}

export const choose = (one, files) => afterCheck(one, () => one.setInputFiles('#files', files));
export const chooseFolder = (one, whole) => afterCheck(one, () => one.setInputFiles('#folder', whole));

/** A sample of the start page. */
export const chooseSample = async (one, name) => {
  if (await one.isHidden('#start')) await one.click('#other');
  await afterCheck(one, () => one.click(`[data-sample=${name}]`));
};

/** A list of 1,000 lines, with the cursor in a comment at its end. */
export async function chooseLongList(one, folder) {
  const list = (await readFile(path.join(samples, 'mill/default.lis'), 'utf8')).trimEnd();
  const lines = 1000 - list.split('\n').length;
  const file = path.join(folder, 'long.lis');
  await writeFile(file, `${list}\n${Array.from({ length: lines }, (_, i) => `# P-AXIS-00067 ${i}\n`).join('')}`);
  await choose(one, file);
  await one.click('.cm-content');
  await one.keyboard.press('Control+End');
  await one.keyboard.insertText('# ');
}

export async function picture(one, name) {
  if (!process.env.AXISC_PICTURES) return;
  await mkdir(process.env.AXISC_PICTURES, { recursive: true });
  await new Promise((wake) => setTimeout(wake, 400));
  await one.screenshot({ path: path.join(process.env.AXISC_PICTURES, `${name}.png`) });
}

/** Chooses a kind of picture, and waits for it. */
export async function drawn(one, kind) {
  await one.selectOption('#kind', kind);
  await one.waitForFunction((alt) => {
    const image = document.querySelector('.frame img');
    return image.alt === alt && image.complete && image.naturalWidth > 0;
  }, await one.$eval('#kind', (menu) => menu.selectedOptions[0].textContent));
}

/** What a click on `selector` saves. */
export async function saved(one, selector) {
  const [download] = await Promise.all([one.waitForEvent('download'), one.click(selector)]);
  return readFile(await download.path());
}

/** MB that the processes of pages and their workers occupy. */
export async function resident() {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const sizes = processInfo
    .filter(({ type }) => type === 'renderer')
    .map(({ id }) => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1] ?? 0));
  return sizes.reduce((sum, size) => sum + size, 0) / 1024;
}

/** The native program, in a folder. */
export function run(words, cwd) {
  return spawnSync(native, words, { cwd, env: { LANG: 'C.UTF-8' }, maxBuffer: 1 << 28 });
}
