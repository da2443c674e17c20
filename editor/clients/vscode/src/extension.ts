import * as vscode from 'vscode';
import { LanguageClient } from 'vscode-languageclient/node';
import { clientOptions } from './client';
import { end, run } from './lifecycle';
import { findProgram } from './program';
import { serverArguments } from './settings';

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

async function begin(): Promise<LanguageClient | undefined> {
  const command = program();
  if (command === undefined) {
    // Not awaited: the message stays until somebody answers it.
    void tellMissing();
    return undefined;
  }
  return new LanguageClient('axisc', 'Axisc', { command, args: serverArguments() }, clientOptions(['file', 'untitled']));
}

export function activate(context: vscode.ExtensionContext): Promise<void> {
  return run(context, begin);
}

export const deactivate = end;
