// What is open, and what the program says of it.
import { Editor } from './editor';
import { byId, save } from './elements';
import { countsOf, findingsIn, showFindings, type Finding } from './findings';
import type { Incoming } from './incoming';
import { fromFragment, toFragment } from './link';
import { Outputs } from './outputs';
import { Program, type Outcome } from './program';
import { currentLanguage, say } from './texts';
import { Workspace } from './workspace';
import type { Decoded } from './encoding';

const first = `kopf.achs_nr                   1
kopf.log_achs_name             X
kenngr.achs_typ                1
filter[0].enable               1
filter[0].type                 LOWPASS
filter[0].prototype            BUTTERWORTH
filter[0].order                2
filter[0].fg_f0                42,5
filter_fir.enable              1
filter_fir.type                1
filter_fir.order               20
`;

export class Page {
  readonly program = new Program();
  workspace = new Workspace();
  private readonly editor: Editor;
  private readonly outputs: Outputs;
  private findings: Finding[] = [];
  private shown = '';
  private decoded: Decoded | null = null;
  private isChecking = false;
  private isStale = false;
  private readonly pages = new Map<string, string>();

  constructor() {
    this.editor = new Editor(byId('editor'), {
      changed: (text) => this.edited(text),
      fix: (finding) => this.fix(finding),
      meaning: (parameter) => this.explained(parameter),
    });
    this.outputs = new Outputs(this);
  }

  async begin(): Promise<void> {
    this.tell(say('loading'));
    const shared = await fromFragment(location.hash);
    if (shared) {
      byId<HTMLInputElement>('cycle-time').value = shared.cycleTime;
      this.open([[shared.name, new TextEncoder().encode(shared.text)]]);
    } else {
      this.open([['x.lis', new TextEncoder().encode(first)]]);
    }
    try {
      await this.program.ready;
    } catch (failure) {
      this.tell(say('failed', { reason: failure instanceof Error ? failure.message : String(failure) }));
    }
  }

  /** Words of every command: language and cycle time. */
  words(command: string, ...more: string[]): string[] {
    const cycleTime = byId<HTMLInputElement>('cycle-time').value.trim();
    const input = this.workspace.inputs.machine;
    const isList = /\.(lis|xml)$/i.test(input);
    const asked = command === 'lint' ? this.workspace.inputs.checked.some((path) => /\.(lis|nc)$/i.test(path)) : isList;
    return [command, '--lang', currentLanguage(), ...(asked && cycleTime !== '' ? ['--cycle-time', cycleTime] : []), ...more];
  }

  open(files: Incoming): void {
    if (files.length === 0) return;
    const old = this.workspace.paths.flatMap((path) => [path, `/before/${path}`]);
    this.workspace = new Workspace(files);
    this.program.update(
      files.flatMap(([path, bytes]) => [[path, bytes], [`/before/${path}`, bytes]] as [string, Uint8Array][]),
      old,
    );
    const named = this.workspace.inputs.checked;
    this.findings = [];
    this.show(this.workspace.paths.find((path) => named.includes(path)) ?? this.workspace.paths[0] ?? '');
    void this.check(true);
  }

  /** A file in the editor. */
  show(path: string): void {
    this.shown = path;
    this.decoded = this.workspace.text(path);
    byId('file-name').textContent = path;
    byId('download').textContent = say('download', { file: path.slice(path.lastIndexOf('/') + 1) });
    byId('editor').hidden = this.decoded === null;
    byId('hidden-text').hidden = this.decoded !== null;
    byId('hidden-text').textContent = say('notShown', { file: path });
    this.editor.open(this.decoded?.text ?? '');
    this.render();
  }

  private edited(text: string): void {
    if (!this.decoded) return;
    this.decoded.text = text;
    this.program.update([[this.shown, this.workspace.write(this.shown, this.decoded)]]);
    void this.check(false);
  }

  /** Checks until what was checked is what is there. */
  async check(isNew: boolean): Promise<void> {
    this.isStale = true;
    if (this.isChecking) return;
    this.isChecking = true;
    if (isNew) this.tell(say('checking'));
    while (this.isStale) {
      this.isStale = false;
      await this.checkOnce();
    }
    this.isChecking = false;
  }

  private async checkOnce(): Promise<void> {
    const workspace = this.workspace;
    try {
      const outcome = await this.program.run({ words: this.words('lint', '--format', 'json', ...workspace.inputs.checked) });
      if (workspace !== this.workspace) return;
      this.findings = outcome.out.startsWith('{') ? findingsIn(outcome.out) : [];
      document.body.dataset['checked'] = String(Number(document.body.dataset['checked'] ?? 0) + 1);
      document.body.dataset['time'] = outcome.time.toFixed(1);
      this.render();
      if (!outcome.out.startsWith('{')) this.tell(outcome.err);
    } catch (failure) {
      this.tell(say('failed', { reason: failure instanceof Error ? failure.message : String(failure) }));
    }
    this.outputs.refresh();
  }

  tell(text: string): void {
    byId('counts').textContent = text.trim();
  }

  private render(): void {
    showFindings(byId('finding-list'), this.findings, {
      go: (finding) => this.go(finding),
      fix: (finding) => this.fix(finding),
      explain: (code) => void this.explain(code),
    });
    this.tell(countsOf(this.findings));
    this.editor.show(this.findings.filter((finding) => finding.file === this.shown));
    this.outputs.listFiles(this.findings, this.shown);
  }

  private go(finding: Finding): void {
    if (finding.file !== this.shown && this.workspace.files.has(finding.file)) this.show(finding.file);
    const { line, column, end_line, end_column } = finding;
    if (!line || !column || !end_line || !end_column) return;
    this.editor.go({ file: finding.file, line, column, end_line, end_column });
  }

  /** The edits of one finding, in the editor where it shows the file. */
  private fix(finding: Finding): void {
    const edits = finding.fix?.edits ?? [];
    const file = edits[0]?.file;
    if (file === undefined || edits.some((edit) => edit.file !== file)) return;
    if (file !== this.shown) this.show(file);
    this.editor.apply(edits);
  }

  /** As `lint --fix` writes the files. */
  async fixAll(): Promise<void> {
    const paths = this.workspace.paths;
    const outcome = await this.program.run({ words: this.words('lint', '--fix', ...this.workspace.inputs.checked), wanted: paths });
    const changed = paths.filter((path) => {
      const now = outcome.written.get(path);
      const before = this.workspace.files.get(path)?.bytes;
      return now && before && (now.length !== before.length || now.some((byte, i) => byte !== before[i]));
    });
    for (const path of changed) {
      const bytes = this.workspace.put(path, outcome.written.get(path) as Uint8Array);
      this.program.update([[path, bytes]]);
    }
    if (changed.includes(this.shown)) {
      this.decoded = this.workspace.text(this.shown);
      this.editor.replace(this.decoded?.text ?? '');
    }
    await this.check(false);
    this.tell(changed.length === 0 ? say('nothingToFix') : say('fixed', { files: changed.join(', ') }));
  }

  download(): void {
    const file = this.workspace.files.get(this.shown);
    if (file) save(this.shown.slice(this.shown.lastIndexOf('/') + 1), file.bytes);
  }

  async compile(): Promise<Outcome> {
    const image = '/image.axim';
    const outcome = await this.program.run({
      words: this.words('compile', '--quiet', '-o', image, this.workspace.inputs.machine),
      wanted: [image],
    });
    const bytes = outcome.written.get(image);
    if (bytes) save(`${this.workspace.inputs.machine.replace(/^.*\//, '').replace(/\.\w+$/, '') || 'machine'}.axim`, bytes);
    else this.outputs.open(outcome.err);
    return outcome;
  }

  async share(): Promise<void> {
    if (!this.decoded) return;
    const fragment = await toFragment({
      name: this.shown.slice(this.shown.lastIndexOf('/') + 1),
      cycleTime: byId<HTMLInputElement>('cycle-time').value,
      text: this.decoded.text,
    });
    if (fragment === null) {
      this.tell(say('tooLong'));
      return;
    }
    history.replaceState(null, '', fragment);
    await navigator.clipboard?.writeText(location.href).catch(() => undefined);
    this.tell(say('shared'));
  }

  private async explained(word: string): Promise<string> {
    const key = `${currentLanguage()} ${word}`;
    let text = this.pages.get(key);
    if (text === undefined) {
      const outcome = await this.program.run({ words: ['explain', '--lang', currentLanguage(), word] });
      text = outcome.status === 0 ? outcome.out.trim() : '';
      this.pages.set(key, text);
    }
    return text;
  }

  async explain(code: string): Promise<void> {
    this.outputs.open(await this.explained(code));
  }

  /** After a change of language or cycle time. */
  again(): void {
    if (this.shown !== '') this.show(this.shown);
    void this.check(true);
  }
}
