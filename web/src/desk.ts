// The part of the page that its panels use.
import type { Commands } from './commands';
import type { Program } from './program';
import type { Workspace } from './workspace';

export interface Desk {
  readonly program: Program;
  readonly commands: Commands;
  readonly workspace: Workspace;
  /** Shows a file. */
  choose(path: string): void;
  /** Shows a sentence in the status line. */
  tell(text: string): void;
}
