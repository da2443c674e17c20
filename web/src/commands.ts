// The arguments of commands: language, cycle time, and the files or the machine they are about.
import { byId } from './elements';
import { currentLanguage } from './texts';
import type { Workspace } from './workspace';

export interface Shown {
  readonly workspace: Workspace;
  /** The path of the file in the editor. */
  readonly shown: string;
}

export class Commands {
  constructor(private readonly page: Shown) {}

  get cycleTime(): string {
    return byId<HTMLInputElement>('cycle-time').value.trim();
  }

  /** Language, and the cycle time where no file sets it. Without an input: for everything that is open. */
  settings(input = ''): string[] {
    const { workspace } = this.page;
    const isSaid = input === '' ? workspace.descriptions.length > 0 : workspace.machineOf(input) !== input;
    const isList = input === '' || /\.(lis|xml|nc)$/i.test(input);
    return ['--lang', currentLanguage(), ...(isList && !isSaid && this.cycleTime !== '' ? ['--cycle-time', this.cycleTime] : [])];
  }

  /** `lint` of everything that is open. */
  checking(...more: string[]): string[] {
    return ['lint', ...this.settings(), ...more, ...this.page.workspace.checked];
  }

  /** The input of commands about one machine. */
  get machine(): string {
    return this.page.workspace.machineOf(this.page.shown);
  }

  /** A command about the machine, or about the list that is shown. */
  words(command: string, ...more: string[]): string[] {
    const isList = this.machine.replace(/^\.\//, '') === this.page.shown;
    return [command, ...this.settings(isList ? this.page.shown : this.machine), ...more, this.machine];
  }
}
