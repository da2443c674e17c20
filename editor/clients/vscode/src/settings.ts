import * as vscode from 'vscode';

/** What the program is started with: the language of the editor, for settings that name none. */
export function ownLanguage(): 'de' | 'en' {
  return vscode.env.language.startsWith('de') ? 'de' : 'en';
}

export function serverArguments(): string[] {
  return ['lsp', '--lang', ownLanguage()];
}

/** The settings at the start, so that the first findings are right. The server asks for them again when they change. */
export function serverSettings(): Record<string, string> {
  const settings = vscode.workspace.getConfiguration('axisc');
  const names = ['language', 'cycleTime', 'build', 'kind', 'findingPage'];
  return Object.fromEntries(names.map((name) => [name, settings.get<string>(name, '')]));
}
