// The client of editors/vscode in the browser. The folder and the server are on the other side of the test's bridge, which this
// reaches over HTTP: the server is the real program.
import * as vscode from 'vscode';
import {
  AbstractMessageReader,
  AbstractMessageWriter,
  LanguageClient,
  type DataCallback,
  type Disposable,
  type Message,
} from 'vscode-languageclient/browser';
import { clientOptions } from '../../../editors/vscode/src/client';
import { offerCommands, registerCommands } from '../../../editors/vscode/src/commands';
import { serverArguments } from '../../../editors/vscode/src/settings';

declare const BRIDGE: string;

const mounted = '/lists';

/** The lines of an endless answer. */
async function lines(url: string, take: (line: string) => void): Promise<void> {
  const reader = (await fetch(url)).body!.pipeThrough(new TextDecoderStream()).getReader();
  let rest = '';
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    const parts = (rest + value).split('\n');
    rest = parts.pop()!;
    parts.forEach(take);
  }
}

class Reader extends AbstractMessageReader {
  constructor(private readonly url: string) {
    super();
  }
  listen(callback: DataCallback): Disposable {
    void lines(this.url, (line) => callback(JSON.parse(line) as Message)).then(() => this.fireClose());
    return { dispose() {} };
  }
}

class Writer extends AbstractMessageWriter {
  private last: Promise<unknown> = Promise.resolve();
  write(message: Message): Promise<void> {
    // In order.
    this.last = this.last.then(() => fetch(`${BRIDGE}/send`, { method: 'POST', body: JSON.stringify(message) }));
    return this.last.then(() => undefined);
  }
  end(): void {}
}

class Folder implements vscode.FileSystemProvider {
  private readonly changed = new vscode.EventEmitter<vscode.FileChangeEvent[]>();
  readonly onDidChangeFile = this.changed.event;
  private async ask(what: string, uri: vscode.Uri, body?: Uint8Array): Promise<Response> {
    const answer = await fetch(`${BRIDGE}/${what}?path=${encodeURIComponent(uri.path)}`, body && { method: 'POST', body });
    if (!answer.ok) throw vscode.FileSystemError.FileNotFound(uri);
    return answer;
  }
  watch(): vscode.Disposable {
    return new vscode.Disposable(() => {});
  }
  async stat(uri: vscode.Uri): Promise<vscode.FileStat> {
    return (await this.ask('stat', uri)).json();
  }
  async readDirectory(uri: vscode.Uri): Promise<[string, vscode.FileType][]> {
    return (await this.ask('folder', uri)).json();
  }
  async readFile(uri: vscode.Uri): Promise<Uint8Array> {
    return new Uint8Array(await (await this.ask('file', uri)).arrayBuffer());
  }
  async writeFile(uri: vscode.Uri, content: Uint8Array): Promise<void> {
    await this.ask('write', uri, content);
    this.changed.fire([{ type: vscode.FileChangeType.Changed, uri }]);
  }
  createDirectory(): void {}
  delete(): void {}
  rename(): void {}
}

/** What the test does that no key does: opening a file at a place. */
async function open(line: string): Promise<void> {
  const { path, at } = JSON.parse(line) as { path: string; at: [number, number] };
  const document = await vscode.workspace.openTextDocument(vscode.Uri.from({ scheme: 'memfs', path }));
  const place = new vscode.Position(...at);
  await vscode.window.showTextDocument(document, { selection: new vscode.Range(place, place), preview: false, viewColumn: vscode.ViewColumn.One });
  await fetch(`${BRIDGE}/opened`, { method: 'POST', body: JSON.stringify({ path, language: document.languageId }) });
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(vscode.workspace.registerFileSystemProvider('memfs', new Folder(), { isCaseSensitive: true }));
  const root = await (await fetch(`${BRIDGE}/root`)).text();
  let client: LanguageClient | undefined;
  context.subscriptions.push(registerCommands(() => client));
  client = new LanguageClient(
    'axisc',
    'Axisc',
    async () => ({
      reader: new Reader(`${BRIDGE}/receive?arguments=${encodeURIComponent(JSON.stringify(serverArguments()))}`),
      writer: new Writer(),
    }),
    {
      ...clientOptions(['memfs']),
      uriConverters: {
        code2Protocol: (uri) => vscode.Uri.file(root + uri.path.slice(mounted.length)).toString(),
        protocol2Code: (text) => vscode.Uri.from({ scheme: 'memfs', path: mounted + vscode.Uri.parse(text).path.slice(root.length) }),
      },
    },
  );
  await client.start();
  await offerCommands(client);
  void lines(`${BRIDGE}/open`, (line) => void open(line));
}
