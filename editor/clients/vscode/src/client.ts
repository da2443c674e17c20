// What every form of the client has in common, however it reaches the server.
import type { LanguageClientOptions, Middleware } from 'vscode-languageclient';
import { isPage } from './page';
import { show } from './preview';
import { serverSettings } from './settings';

/** Lists by the control vendor's extension or by this one, NC programs, and the files that make a machine of lists. */
export const languages = ['isg-list', 'axis-list', 'isg-cnc'];
export const machineFiles = '**/machine.json';
export const programs = '**/*.{nc,NC}';
/** Endings of the files that a machine is made of. */
export const endings = ['lis', 'LIS', 'json', 'nc', 'NC', 'xml', 'tsproj', 'xti'];

function middleware(): Middleware {
  return {
    // A page that a command returns is shown, whether the palette or a code lens called it.
    executeCommand: async (command, args, next) => {
      const answer: unknown = await next(command, args);
      if (isPage(answer)) show(command, answer);
      return answer;
    },
  };
}

export function clientOptions(schemes: string[]): LanguageClientOptions {
  return {
    documentSelector: schemes.flatMap((scheme) => [
      ...languages.map((id) => ({ scheme, language: id })),
      { scheme, pattern: machineFiles },
      { scheme, pattern: programs },
    ]),
    initializationOptions: serverSettings,
    middleware: middleware(),
  };
}
