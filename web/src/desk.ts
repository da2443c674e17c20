// The part of the page that its panels use.
import type { Program } from './program';
import type { Workspace } from './workspace';

export interface Desk {
  readonly program: Program;
  readonly workspace: Workspace;
  /** The path of the file in the editor: questions are about its machine. */
  readonly shown: string;
  /** Shows a file. */
  choose(path: string): void;
  /** Shows a sentence in the status line. */
  tell(text: string): void;
}
