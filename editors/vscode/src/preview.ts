import * as vscode from 'vscode';
import { guarded, type Page } from './page';

const panels = new Map<string, vscode.WebviewPanel>();

/** Shows a page beside the text; each command has one panel. */
export async function show(command: string, page: Page): Promise<void> {
  const html = await guarded(page.html);
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
