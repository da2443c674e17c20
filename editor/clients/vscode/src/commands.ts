// The commands that show a page: the server computes it, whatever is unsaved included.
import * as vscode from 'vscode';
import type { BaseLanguageClient } from 'vscode-languageclient';

const kinds = ['response', 'step', 'delay', 'corner', 'circle', 'dynamics', 'robustness'];

async function call(client: BaseLanguageClient, command: string, ...more: string[]): Promise<void> {
  // While a page has the focus there is no active text editor.
  const document = (vscode.window.activeTextEditor ?? vscode.window.visibleTextEditors[0])?.document;
  if (document === undefined) {
    void vscode.window.showInformationMessage(vscode.l10n.t('Open a list or a machine file first.'));
    return;
  }
  if (!offered(client).includes(command)) {
    void vscode.window.showErrorMessage(vscode.l10n.t('This axisc does not know {0}; install a newer one.', command));
    return;
  }
  try {
    // By the client's own command, so that its middleware shows the page.
    await vscode.commands.executeCommand(command, client.code2ProtocolConverter.asUri(document.uri), ...more);
  } catch (mistake) {
    void vscode.window.showErrorMessage(mistake instanceof Error ? mistake.message : String(mistake));
  }
}

function offered(client: BaseLanguageClient): string[] {
  return client.initializeResult?.capabilities.executeCommandProvider?.commands ?? [];
}

export function registerCommands(client: () => BaseLanguageClient | undefined): vscode.Disposable {
  const command = (name: string, run: (client: BaseLanguageClient, word: string) => Promise<void>) =>
    vscode.commands.registerCommand(name, async (word: unknown) => {
      const running = client();
      if (running !== undefined) await run(running, String(word));
    });
  return vscode.Disposable.from(
    command('axisc.showReport', (running) => call(running, 'axisc.report')),
    // From the code of a finding.
    command('axisc.showFinding', (running, code) => call(running, 'axisc.explain', code)),
    command('axisc.showMachine', (running) => call(running, 'axisc.machine')),
    command('axisc.showPlot', async (running) => {
      const kind = await vscode.window.showQuickPick(kinds, { placeHolder: vscode.l10n.t('What to draw') });
      if (kind !== undefined) await call(running, 'axisc.plot', kind);
    }),
  );
}

/** The palette offers the commands only where the server has them. */
export async function offerCommands(client: BaseLanguageClient): Promise<void> {
  await vscode.commands.executeCommand('setContext', 'axisc.shows', offered(client).includes('axisc.report'));
}
