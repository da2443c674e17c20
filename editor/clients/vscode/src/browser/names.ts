// Where the server in the browser sees a file: the name of its file system is the first folder.
import * as vscode from 'vscode';

const separator = '+';

/** `vscode-vfs://github/team/x.lis` is `/vscode-vfs+github/team/x.lis`. */
export function pathOf(uri: vscode.Uri): string {
  return `/${uri.scheme}${separator}${uri.authority}${uri.path}`;
}

/** Documents without a file keep their names. */
export function toServer(uri: vscode.Uri): string {
  return uri.scheme === 'untitled' ? uri.toString() : vscode.Uri.file(pathOf(uri)).toString();
}

export function fromServer(text: string): vscode.Uri {
  const uri = vscode.Uri.parse(text);
  const [, scheme, authority, path] = /^\/([^/+]+)\+([^/]*)(\/.*)$/.exec(uri.path) ?? [];
  return uri.scheme === 'file' && scheme !== undefined ? vscode.Uri.from({ scheme, authority, path }) : uri;
}
