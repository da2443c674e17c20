// The client of editor/clients/vscode in the browser. The folder and the server are on the other side of the test's bridge, which this
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
import { clientOptions } from '../../../editor/clients/vscode/src/client';
import { offerCommands, registerCommands } from '../../../editor/clients/vscode/src/commands';
import { serverArguments } from '../../../editor/clients/vscode/src/settings';
import { lines, mount, openWhatIsAsked } from './folder';

declare const BRIDGE: string;

const mounted = '/lists';

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

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  mount(context);
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
        protocol2Code: (text) => {
          const uri = vscode.Uri.parse(text);
          return uri.scheme === 'file' ? vscode.Uri.from({ scheme: 'memfs', path: mounted + uri.path.slice(root.length) }) : uri;
        },
      },
    },
  );
  await client.start();
  await offerCommands(client);
  openWhatIsAsked();
}
