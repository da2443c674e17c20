// What the buttons do with the files: repair, align, save, compile, and make a link of them.
import { zipSync } from 'fflate';
import { byId, save } from './elements';
import { toFragment } from './link';
import type { Page } from './page';
import { say } from './texts';

const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);
const isEqual = (a: Uint8Array, b: Uint8Array): boolean => a.length === b.length && a.every((byte, i) => byte === b[i]);

export class Actions {
  constructor(private readonly page: Page) {}

  connect(): void {
    const actions: Record<string, () => unknown> = {
      'fix-all': () => this.fixAll(), align: () => this.align(), download: () => this.download(), 'download-all': () => this.downloadAll(),
      compile: () => this.compile(), share: () => this.share(),
    };
    for (const [id, act] of Object.entries(actions)) {
      byId(id).addEventListener('click', () => {
        Promise.resolve(act()).catch((failure: unknown) => this.page.tell(say('failed', { reason: String(failure) })));
      });
    }
  }

  /** Runs a command that writes files in place, and takes over the changed files. */
  private async written(words: string[], paths: string[]): Promise<{ changed: string[]; err: string }> {
    const outcome = await this.page.program.run({ words, wanted: paths });
    const files = this.page.workspace.files;
    const changed = new Map([...outcome.written].filter(([path, bytes]) => !isEqual(bytes, files.get(path)?.bytes ?? bytes)));
    this.page.replaced(changed);
    await this.page.check(false);
    return { changed: [...changed.keys()], err: outcome.err };
  }

  /** As `lint --fix` writes the files. */
  async fixAll(): Promise<void> {
    const { changed } = await this.written(this.page.commands.checking('--fix'), this.page.workspace.paths);
    this.page.tell(changed.length === 0 ? say('nothingToFix') : say('fixed', { files: changed.map(nameOf).join(', ') }));
  }

  /** As `fmt` writes the list. */
  async align(): Promise<void> {
    const { shown } = this.page;
    const { changed, err } = await this.written(['fmt', /^[-@]/.test(shown) ? `./${shown}` : shown], [shown]);
    this.page.tell(changed.length === 0 ? err || say('isAligned') : say('aligned', { file: nameOf(shown) }));
  }

  download(): void {
    const { workspace, shown } = this.page;
    const file = workspace.files.get(shown);
    if (file) save(nameOf(shown), file.bytes);
  }

  /** Changed files in their folders, not compressed. */
  downloadAll(): void {
    const changed = this.page.workspace.changed.map(({ path, bytes }) => [path, bytes] as const);
    save('lists.zip', zipSync(Object.fromEntries(changed), { level: 0 }), 'application/zip');
  }

  async compile(): Promise<void> {
    const image = '/image.axim';
    const outcome = await this.page.program.run({ words: this.page.commands.words('compile', '--quiet', '-o', image), wanted: [image] });
    const bytes = outcome.written.get(image);
    if (bytes) save(`${nameOf(this.page.commands.machine).replace(/\.\w+$/, '') || 'machine'}.axim`, bytes);
    else this.page.said(outcome.err);
  }

  async share(): Promise<void> {
    const { decoded, shown, commands } = this.page;
    if (!decoded) return;
    const fragment = await toFragment({ name: nameOf(shown), cycleTime: commands.cycleTime, text: decoded.text });
    if (fragment === null) {
      this.page.tell(say('tooLong'));
      return;
    }
    history.replaceState(null, '', fragment);
    const isCopied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    this.page.tell(say(isCopied ? 'shared' : 'inAddress'));
  }
}
