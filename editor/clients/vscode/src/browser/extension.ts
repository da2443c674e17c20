// The extension where there is no computer below the editor: the program runs in a worker, on copies of the workspace's files.
import * as vscode from 'vscode';
import { BrowserMessageReader, BrowserMessageWriter, LanguageClient } from 'vscode-languageclient/browser';
import { clientOptions } from '../client';
import { end, run } from '../lifecycle';
import { ownLanguage } from '../settings';
import { filesOfWorkspace, stateOf } from './files';
import type { Told } from './messages';
import { fromServer, toServer } from './names';

let worker: Worker | undefined;

function stopWorker(): void {
  worker?.terminate();
  worker = undefined;
}

async function begin(folder: vscode.Uri): Promise<LanguageClient> {
  stopWorker();
  const started = new Worker(vscode.Uri.joinPath(folder, 'worker.js').toString(true));
  worker = started;
  const tell = (message: Told) => started.postMessage(message);
  const program = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(folder, 'axisc.wasm'));
  tell({ kind: 'begin', program, language: ownLanguage() });
  (await filesOfWorkspace()).forEach(tell);
  const ofFolders = (vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.scheme);
  const options = clientOptions([...new Set([...ofFolders, 'file', 'vscode-vfs', 'untitled'])]);
  return new LanguageClient(
    'axisc',
    'Axisc',
    async () => ({ reader: new BrowserMessageReader(started), writer: new BrowserMessageWriter(started) }),
    {
      ...options,
      uriConverters: { code2Protocol: toServer, protocol2Code: fromServer },
      middleware: {
        ...options.middleware,
        workspace: {
          // The server reads its copy as soon as it is told.
          didChangeWatchedFile: async (event, next) => {
            tell(await stateOf(fromServer(event.uri)));
            await next(event);
          },
        },
      },
    },
  );
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.workspace.onDidChangeWorkspaceFolders(() => vscode.commands.executeCommand('axisc.restart')),
  );
  await run(context, () => begin(vscode.Uri.joinPath(context.extensionUri, 'dist/browser')));
}

export async function deactivate(): Promise<void> {
  await end();
  stopWorker();
}
