// The open files, and the program's answers about them.
import { Checks, reasonOf } from './checks';
import { Editor } from './editor';
import { byId } from './elements';
import type { Decoded } from './encoding';
import { countsOf, findingsIn, showFindings, type Finding } from './findings';
import { firstFiles } from './first';
import type { Incoming } from './incoming';
import { fromFragment } from './link';
import { Outputs } from './outputs';
import { Program, type Changed, type Started, type Timed } from './program';
import { Server } from './server';
import { currentLanguage, say } from './texts';
import { Workspace } from './workspace';

export class Page {
  readonly program: Program;
  workspace = new Workspace();
  shown = '';
  decoded: Decoded | null = null;
  private readonly server: Server;
  private readonly editor: Editor;
  private readonly outputs: Outputs;
  private findings: Finding[] = [];
  private isChosen = false;
  private readonly checks = new Checks(
    () => this.checkOnce(),
    (failure) => this.tell(say('failed', { reason: reasonOf(failure) })),
  );

  constructor(started: Started) {
    this.program = new Program(started, () => ({ language: currentLanguage(), cycle_time: this.cycleTime }));
    this.server = new Server(this.program, () => this.decoded && { path: this.shown, text: this.decoded.text });
    const events = { changed: (text: string) => this.edited(text), fix: (finding: Finding) => this.fix(finding) };
    this.editor = new Editor(byId('editor'), events, this.server);
    this.outputs = new Outputs(this);
  }

  /** Where no file says one. */
  get cycleTime(): string {
    return byId<HTMLInputElement>('cycle-time').value.trim();
  }

  async begin(): Promise<void> {
    this.tell(say('loading'));
    const shared = await fromFragment(location.hash);
    if (shared) byId<HTMLInputElement>('cycle-time').value = shared.cycleTime;
    this.open(firstFiles(shared));
    await this.program.ready.catch((failure: unknown) => this.tell(say('failed', { reason: reasonOf(failure) })));
  }

  open(files: Incoming): void {
    if (files.length === 0) return;
    this.program.interrupt();
    const old = this.workspace.paths.flatMap((path) => [path, `/before/${path}`]);
    this.workspace = new Workspace(files);
    this.program.update(
      files.flatMap(([path, bytes]) => [[path, bytes], [`/before/${path}`, bytes]] as [string, Uint8Array][]),
      old,
    );
    this.findings = [];
    this.editor.forget();
    this.isChosen = false;
    const paths = this.workspace.paths;
    this.show(paths.find((path) => path.endsWith('.lis')) ?? (paths[0] as string));
    void this.check(true);
  }

  /** An empty list, to type or to paste into. */
  begun(text: string): void {
    this.open([['x.lis', new TextEncoder().encode(text)]]);
    this.editor.focus();
  }

  /** Shows a requested file. */
  choose(path: string): void {
    this.isChosen = true;
    this.show(path);
    this.outputs.refresh();
  }

  private show(path: string): void {
    this.shown = path;
    this.decoded = this.workspace.text(path);
    byId('editor').hidden = this.decoded === null;
    byId('hidden-text').hidden = this.decoded !== null;
    this.editor.open(path, this.decoded?.text ?? '');
    this.render();
  }

  private edited(text: string): void {
    if (!this.decoded) return;
    this.isChosen = true;
    this.decoded.text = text;
    this.program.update([[this.shown, this.workspace.write(this.shown, this.decoded)]]);
    void this.check(false);
  }

  /** Checks the open files; resolves when the findings match their present state. */
  check(isNew: boolean): Promise<void> {
    if (isNew) this.tell(say('checking'));
    return this.checks.again();
  }

  private async checkOnce(): Promise<Timed<string> | null> {
    const workspace = this.workspace;
    const outcome = await this.program.check(workspace.whole);
    if (workspace !== this.workspace) return null;
    this.findings = outcome.result === '' ? [] : findingsIn(outcome.result);
    const worst = this.findings.find((finding) => finding.severity === 'error') ?? this.findings[0];
    if (!this.isChosen && worst && this.workspace.files.has(worst.file) && worst.file !== this.shown) this.show(worst.file);
    else this.render();
    this.isChosen = true;
    if (outcome.status === 2) this.tell(outcome.error);
    this.outputs.refresh();
    return outcome;
  }

  tell(text: string): void {
    byId('counts').textContent = text.trim();
  }

  /** A page of Markdown, or the output of a command, over the others. */
  async explain(code: string): Promise<void> {
    const outcome = await this.program.answer({ question: 'explain', word: code, format: 'markdown' });
    this.outputs.open(outcome.result || outcome.error);
  }

  said(text: string): void {
    this.outputs.open(`\`\`\`\n${text.trim()}\n\`\`\``);
  }

  private render(): void {
    byId('file-name').textContent = byId('file-name').title = this.shown;
    byId('download').textContent = say('download', { file: this.shown.slice(this.shown.lastIndexOf('/') + 1) });
    byId('hidden-text').textContent = say('notShown', { file: this.shown });
    const changed = this.workspace.changed.length;
    byId('download-all').hidden = changed < 2;
    byId('download-all').textContent = say('downloadAll', { files: changed });
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
    if (finding.file !== this.shown && this.workspace.files.has(finding.file)) this.choose(finding.file);
    const { line, column, end_line, end_column } = finding;
    if (!line || !column || !end_line || !end_column) return;
    this.editor.go({ file: finding.file, line, column, end_line, end_column });
  }

  /** The edits of one finding: in the editor those of the shown file, in other files at once. */
  private fix(finding: Finding): void {
    const edits = finding.fix?.edits ?? [];
    const here = edits.some((edit) => edit.file === this.shown) ? this.shown : edits[0]?.file;
    if (here === undefined) return;
    if (here !== this.shown) this.choose(here);
    for (const [path, bytes] of this.workspace.repaired(edits.filter((edit) => edit.file !== here))) this.program.update([[path, bytes]]);
    this.editor.apply(edits.filter((edit) => edit.file === here));
  }

  /** Files that the program wrote. */
  replaced(written: Changed): void {
    for (const [path, bytes] of written) this.program.update([[path, this.workspace.put(path, bytes)]]);
    if (written.every(([path]) => path !== this.shown)) return;
    this.decoded = this.workspace.text(this.shown);
    this.editor.replace(this.decoded?.text ?? '');
  }

  /** The shown list, aligned; false where it was already. */
  async align(): Promise<boolean> {
    const edits = await this.server.format();
    if (edits.length > 0) this.editor.change(edits);
    return edits.length > 0;
  }

  /** In another language. */
  speak(): void {
    this.outputs.speak();
  }

  /** After a change of language or cycle time. */
  again(): void {
    this.render();
    void this.check(true);
  }
}
