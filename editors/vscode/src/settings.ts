import * as vscode from 'vscode';

/** A setting, and the option of the program that it becomes. */
const options: Record<string, string> = { cycleTime: '--cycle-time', build: '--build', kind: '--kind' };

/** The language of findings: that of the editor where the settings name none. */
function language(settings: vscode.WorkspaceConfiguration): string {
  const chosen = settings.get<string>('language', 'auto');
  if (chosen !== 'auto') return chosen;
  return vscode.env.language.startsWith('de') ? 'de' : 'en';
}

/** What the program is started with. Settings that are empty are left out: then axisc.json and the lists decide. */
export function serverArguments(): string[] {
  const settings = vscode.workspace.getConfiguration('axisc');
  const given = Object.entries(options).map(([name, option]) => [option, settings.get<string>(name, '').trim()]);
  return ['lsp', '--lang', language(settings), ...given.filter(([, value]) => value !== '').flat()];
}
