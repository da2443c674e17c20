// The part of the page that its panels use.
import type { Outcome } from '../interface/axisc.mjs';
import { button, element } from './elements';
import type { Program } from './program';
import { say } from './texts';
import type { Workspace } from './workspace';

export interface Desk {
  readonly program: Program;
  readonly workspace: Workspace;
  /** The path of the file in the editor: questions are about its machine. */
  readonly shown: string;
  /** Whether a file describes a machine. */
  isMachine(path: string): boolean;
  /** Shows a file. */
  choose(path: string): void;
  /** Shows the findings. */
  turn(panel: 'findings'): void;
  /** Shows a sentence for a while. */
  tell(text: string): void;
}

/** What went wrong, without the program's name, which is for terminals. */
export const reasonIn = (error: string): string => error.replace(/^axisc: (error|Fehler)(\[\w+\])?: /, '').trim();

/** Why there is no result; empties `place` where there is one. */
export function showTrouble(place: HTMLElement, { status, result, error }: Outcome<string>, desk: Desk): void {
  place.hidden = result !== '';
  const trouble = status === 1 ? [say('errorsFirst'), ' ', button(say('seeFindings'), () => desk.turn('findings'))] : [reasonIn(error)];
  place.replaceChildren(...(result === '' ? [element('p', { class: 'trouble' }, ...trouble)] : []));
}
