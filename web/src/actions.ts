// What the buttons do with the files: repair, align, save, compile, and make a link of them.
import { zipSync } from 'fflate';
import { reasonIn } from './desk';
import { byId, save } from './elements';
import { toFragment } from './link';
import type { Page } from './page';
import { say } from './texts';

const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

const modelOf = (path: string): string => nameOf(path).replace(/\.\w+$/, '') || 'machine';

export class Actions {
  constructor(private readonly page: Page) {}

  connect(): void {
    const actions: Record<string, () => unknown> = {
      'fix-all': () => this.fixAll(), align: () => this.align(), download: () => this.download(), 'download-all': () => this.downloadAll(),
      compile: () => this.compile(), fmu: () => this.fmu(), share: () => this.share(),
    };
    for (const [id, act] of Object.entries(actions)) {
      byId(id).addEventListener('click', () => {
        Promise.resolve(act()).catch((failure: unknown) => this.page.tell(say('failed', { reason: String(failure) })));
      });
    }
  }

  /** As `lint --fix` writes the files. */
  async fixAll(): Promise<void> {
    const { status, result, error } = await this.page.program.fix(this.page.workspace.whole);
    if (status !== 0) {
      this.page.tell(reasonIn(error));
      return;
    }
    const { changed } = result;
    this.page.replaced(changed);
    await this.page.check(false);
    this.page.tell(changed.length === 0 ? say('nothingToFix') : say('fixed', { files: changed.map(([path]) => nameOf(path)).join(', ') }));
  }

  /** As `fmt` writes the list. */
  async align(): Promise<void> {
    const isChanged = await this.page.align();
    await this.page.check(false);
    this.page.tell(isChanged ? say('aligned', { file: nameOf(this.page.shown) }) : say('isAligned'));
  }

  download(): void {
    const { workspace, shown } = this.page;
    const file = workspace.files.get(shown);
    if (!file) return;
    save(nameOf(shown), file.bytes);
    file.saved = file.bytes;
  }

  /** Changed files in their folders, not compressed. */
  downloadAll(): void {
    const { changed: files } = this.page.workspace;
    const changed = files.map(({ path, bytes }) => [path, bytes] as const);
    save('lists.zip', zipSync(Object.fromEntries(changed), { level: 0 }), 'application/zip');
    for (const file of files) file.saved = file.bytes;
  }

  async compile(): Promise<void> {
    const { shown } = this.page;
    const { status, result: bytes, error } = await this.page.program.compile(shown);
    if (status === 0) save(`${modelOf(shown)}.axim`, bytes);
    else this.refused(status, error);
  }

  /** As `export --to fmu3 --binaries none` writes it. */
  async fmu(): Promise<void> {
    const { shown } = this.page;
    const { status, result: bytes, error } = await this.page.program.fmu(shown, modelOf(shown));
    if (status === 0) save(`${modelOf(shown)}.fmu`, bytes, 'application/zip');
    else this.refused(status, error);
  }

  private refused(status: number, error: string): void {
    if (status === 1) {
      this.page.turn('findings');
      this.page.tell(say('errorsFirst'));
    } else this.page.tell(reasonIn(error));
  }

  async share(): Promise<void> {
    const { decoded, shown, cycleTime } = this.page;
    if (!decoded) return;
    const fragment = await toFragment({ name: nameOf(shown), cycleTime, text: decoded.text });
    if (fragment === null) {
      this.page.tell(say('tooLong'));
      return;
    }
    history.replaceState(null, '', fragment);
    const isCopied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    this.page.tell(say(isCopied ? 'shared' : 'inAddress'));
  }
}
