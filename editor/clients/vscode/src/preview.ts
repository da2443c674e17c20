import * as vscode from 'vscode';
import { guarded, type Page } from './page';

const panels = new Map<string, vscode.WebviewPanel>();

/** Shows a page beside the text; each command has one panel. */
export function show(command: string, page: Page): void {
  const html = guarded(page);
  let panel = panels.get(command);
  if (panel === undefined) {
    panel = vscode.window.createWebviewPanel(
      command,
      page.title,
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, localResourceRoots: [], enableFindWidget: true },
    );
    panels.set(command, panel);
    panel.onDidDispose(() => panels.delete(command));
  }
  panel.title = page.title;
  panel.webview.html = html;
  panel.reveal(undefined, true);
}
