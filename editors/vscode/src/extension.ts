import * as vscode from 'vscode';
import { LanguageClient } from 'vscode-languageclient/node';
import { clientOptions } from './client';
import { offerCommands, registerCommands } from './commands';
import { findProgram } from './program';
import { serverArguments } from './settings';

let client: LanguageClient | undefined;

function program(): string | undefined {
  return findProgram(vscode.workspace.getConfiguration('axisc').get<string>('path', ''), {
    path: process.env.PATH ?? '',
    endings: process.platform === 'win32' ? (process.env.PATHEXT ?? '.EXE') : '',
  });
}

async function tellMissing(): Promise<void> {
  const setting = vscode.workspace.getConfiguration('axisc').get<string>('path', '').trim();
  const settings = vscode.l10n.t('Open Settings');
  const message =
    setting === ''
      ? vscode.l10n.t('The program axisc is not on the PATH. Install it, or name its file in the setting axisc.path.')
      : vscode.l10n.t('The setting axisc.path names "{0}", which is not a program. Name the file, with its whole path.', setting);
  if ((await vscode.window.showErrorMessage(message, settings)) === settings) {
    await vscode.commands.executeCommand('workbench.action.openSettings', 'axisc.path');
  }
}

async function stop(): Promise<void> {
  const ending = client;
  client = undefined;
  await ending?.dispose();
}

async function start(): Promise<void> {
  await stop();
  const command = program();
  if (command === undefined) {
    // Not awaited: the message stays until somebody answers it.
    void tellMissing();
    return;
  }
  client = new LanguageClient(
    'axisc',
    'Axisc',
    { command, args: serverArguments() },
    clientOptions(['file', 'untitled']),
  );
  await client.start();
  await offerCommands(client);
}

/** One start after the other, however fast settings change. */
let starting: Promise<void> = Promise.resolve();
function restart(): Promise<void> {
  starting = starting.then(start, start);
  return starting;
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    registerCommands(() => client),
    vscode.commands.registerCommand('axisc.restart', restart),
    vscode.workspace.onDidChangeConfiguration(async (event) => {
      if (event.affectsConfiguration('axisc')) await restart();
    }),
  );
  await restart();
}

export async function deactivate(): Promise<void> {
  await starting.catch(() => undefined);
  await stop();
}
