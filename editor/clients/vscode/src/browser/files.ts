// The files of the workspace for the server, which sees no others: all at the start, then each that changes.
import * as vscode from 'vscode';
import { endings } from '../client';
import type { FileState } from './messages';
import { pathOf } from './names';

const skipped = new Set(['node_modules', '.git']);
const wanted = (name: string) => endings.some((ending) => name.endsWith(`.${ending}`));

/** The file as the disk has it: a file that cannot be read does not exist for the server either. */
export async function stateOf(uri: vscode.Uri): Promise<FileState> {
  try {
    return { kind: 'file', path: pathOf(uri), bytes: await vscode.workspace.fs.readFile(uri) };
  } catch {
    return { kind: 'file', path: pathOf(uri) };
  }
}

async function below(folder: vscode.Uri): Promise<FileState[]> {
  const entries = await vscode.workspace.fs.readDirectory(folder);
  const found = entries.map(async ([name, type]) => {
    const uri = vscode.Uri.joinPath(folder, name);
    if ((type & vscode.FileType.SymbolicLink) === 0 && (type & vscode.FileType.Directory) !== 0) {
      return skipped.has(name) ? [] : below(uri);
    }
    return wanted(name) ? [await stateOf(uri)] : [];
  });
  return (await Promise.all(found)).flat();
}

export async function filesOfWorkspace(): Promise<FileState[]> {
  const folders = vscode.workspace.workspaceFolders ?? [];
  return (await Promise.all(folders.map(({ uri }) => below(uri)))).flat();
}
