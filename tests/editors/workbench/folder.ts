// What the workbench needs of the test besides the extension: the folder, over the bridge, and opening files.
import * as vscode from 'vscode';

declare const BRIDGE: string;

/** The lines of an endless answer. */
export async function lines(url: string, take: (line: string) => void): Promise<void> {
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

/** What the test does that no key does: opening a file at a place, and writing one that is not open. */
async function act(line: string): Promise<void> {
  const { path, at, text } = JSON.parse(line) as { path: string; at: [number, number]; text?: string };
  if (text !== undefined) {
    await vscode.workspace.fs.writeFile(vscode.Uri.from({ scheme: 'memfs', path }), new TextEncoder().encode(text));
    return;
  }
  const document = await vscode.workspace.openTextDocument(vscode.Uri.from({ scheme: 'memfs', path }));
  const place = new vscode.Position(...at);
  await vscode.window.showTextDocument(document, { selection: new vscode.Range(place, place), preview: false, viewColumn: vscode.ViewColumn.One });
  await fetch(`${BRIDGE}/opened`, { method: 'POST', body: JSON.stringify({ path, language: document.languageId }) });
}

export function mount(context: vscode.ExtensionContext): void {
  context.subscriptions.push(vscode.workspace.registerFileSystemProvider('memfs', new Folder(), { isCaseSensitive: true }));
}

/** Opens what the test asks for, from now on. */
export function openWhatIsAsked(): void {
  void lines(`${BRIDGE}/open`, (line) => void act(line));
}

/** Beside an extension that has a server of its own. */
export function activate(context: vscode.ExtensionContext): void {
  mount(context);
  openWhatIsAsked();
}
