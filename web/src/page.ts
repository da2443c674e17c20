// The open files, and the program's answers about them.
import { Checks, reasonOf } from './checks';
import { reasonIn } from './desk';
import { Editor } from './editor';
import { byId, element } from './elements';
import type { Decoded } from './encoding';
import { showFiles } from './files';
import { findingsIn, showFilters, showFindings, type Actions, type Finding, type Severity } from './findings';
import { isRecording, type Incoming } from './incoming';
import { Outputs, type Panel } from './outputs';
import type { Parts } from './parts';
import { Program, type Repair, type Timed } from './program';
import { Server } from './server';
import { Survey } from './survey';
import { currentLanguage, say } from './texts';
import { showVerdict, stateOf, type Checked } from './verdict';
import { Workspace } from './workspace';

export interface Opening {
  isSample?: boolean;
  /** Kept on the start page. */
  isExample?: boolean;
  /** Compared at once. */
  recording?: string;
}

export class Page {
  readonly program: Program;
  workspace = new Workspace();
  shown = '';
  decoded: Decoded | null = null;
  cycleTime = '1ms';
  findings: Finding[] = [];
  private readonly server: Server;
  private readonly editor: Editor;
  private readonly outputs: Outputs;
  private readonly survey: Survey;
  private checkedFiles: number | null = null;
  /** Why not everything could be checked. */
  private trouble: string | null = null;
  private severity: Severity | null = null;
  private isChosen = false;
  /** The files are those of the start page. */
  isExample = false;
  private recording: string | undefined;
  private toldUntil = 0;
  private readonly checks = new Checks(
    () => this.checkOnce(),
    (failure) => this.checkFailed(failure),
  );

  readonly actions: Actions = {
    go: (finding) => this.go(finding),
    fix: (findings) => this.fix(findings),
    explain: (code) => void this.explain(code),
  };

  constructor(
    parts: Parts,
    private readonly open_: (text: string) => void,
  ) {
    this.program = new Program(parts, () => ({ language: currentLanguage(), cycle_time: this.cycleTime }));
    this.server = new Server(this.program, () => this.decoded && { path: this.shown, text: this.decoded.text });
    const events = { changed: (text: string) => this.edited(text), fix: (finding: Finding) => this.fix([finding]) };
    this.editor = new Editor(byId('editor'), events, this.server);
    this.outputs = new Outputs(this);
    this.survey = new Survey(this, () => this.renderFacts(), (failure) => this.fail(say('failed', { reason: reasonOf(failure) })));
    byId('compare').addEventListener('click', () => {
      byId<HTMLInputElement>('before').checked = true;
      this.outputs.choose('pictures');
    });
    byId('machines').addEventListener('change', () => this.choose(byId<HTMLSelectElement>('machines').value, 'machine'));
  }

  /** New files take the place of those before; recordings are added to them. */
  open(files: Incoming, { isSample = false, isExample = false, recording }: Opening = {}): void {
    if (files.length === 0) return;
    if (files.every(([path, bytes]) => isRecording(path, bytes))) {
      if (this.isExample) this.tell(say('listsFirst'));
      else this.add(files);
      return;
    }
    const unsaved = this.workspace.unsaved.map(({ path }) => path);
    if (unsaved.length > 0 && !confirm(say('unsaved', { files: unsaved.join(', ') }))) return;
    this.isExample = isExample;
    this.showStart(isExample);
    byId('sample-mark').hidden = !isSample;
    this.program.interrupt();
    const old = this.workspace.paths.flatMap((path) => [path, `/before/${path}`]);
    this.workspace = new Workspace(files);
    this.program.update(files.flatMap(([path, bytes]) => [[path, bytes], [`/before/${path}`, bytes]] as [string, Uint8Array][]), old);
    this.findings = [];
    [this.checkedFiles, this.trouble] = [null, null];
    this.survey.forget();
    this.severity = null;
    this.editor.forget();
    for (const id of ['machine-text', 'contour-text', 'picture-text']) byId(id).replaceChildren();
    this.isChosen = false;
    this.recording = recording;
    const paths = this.workspace.paths;
    this.outputs.choose('findings');
    this.show(paths.find((path) => path.endsWith('.lis')) ?? (paths[0] as string));
    void this.check(true);
  }

  /** The start page, or the open files. */
  showStart(isShown: boolean): void {
    byId('start').hidden = !isShown;
    byId('example').hidden = !this.isExample;
    byId('other').hidden = this.isExample;
    byId('other').textContent = isShown ? say('back', { file: this.shown.replace(/^.*\//, '') }) : say('other');
    for (const id of ['verdict', 'head', 'desk']) byId(id).hidden = isShown;
  }

  private add(files: Incoming): void {
    this.showStart(false);
    this.workspace.add(files);
    this.program.update(files);
    this.render();
    this.outputs.compare(files[0]?.[0] ?? '');
  }

  /** An empty list, to type or to paste into. */
  begun(text: string): void {
    this.open([['x.lis', new TextEncoder().encode(text)]]);
    this.outputs.choose('text');
    this.editor.focus();
  }

  /** Shows a requested file. */
  choose(path: string, panel: Panel = 'text'): void {
    this.isChosen = true;
    this.show(path);
    if (panel !== 'text' || this.outputs.panel !== 'pictures') this.outputs.choose(panel);
    else this.outputs.refresh();
    this.survey.soon();
  }

  turn(panel: Panel): void {
    this.outputs.choose(panel);
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
    if (isNew) {
      this.checkedFiles = null;
      this.renderFacts();
    }
    return this.checks.again();
  }

  private async checkOnce(): Promise<Timed<string> | null> {
    const workspace = this.workspace;
    const isFirst = !this.isChosen;
    const outcome = await this.program.check(workspace.whole);
    if (workspace !== this.workspace) return null;
    const { findings, files } = outcome.result === '' ? { findings: [], files: 0 } : findingsIn(outcome.result);
    this.findings = findings;
    this.checkedFiles = files;
    this.trouble = outcome.status === 0 || outcome.status === 1 ? null : reasonIn(outcome.error);
    const worst = findings.find((finding) => finding.severity === 'error') ?? findings[0];
    if (!this.isChosen && worst && workspace.files.has(worst.file) && worst.file !== this.shown) this.show(worst.file);
    else this.render();
    this.isChosen = true;
    this.outputs.refresh();
    if (isFirst) void this.begin(workspace);
    else this.survey.soon();
    return outcome;
  }

  /** Nothing is known about the files as they are now. */
  private checkFailed(failure: unknown): void {
    [this.findings, this.checkedFiles] = [[], 0];
    this.survey.forget();
    this.fail(say('checkFailed', { reason: reasonOf(failure) }));
  }

  private fail(trouble: string): void {
    this.trouble = trouble;
    this.render();
  }

  /** After the first check of new files: where nothing is wrong, their machine comes first. */
  private async begin(workspace: Workspace): Promise<void> {
    const first = await this.survey.begin();
    if (workspace !== this.workspace) return;
    if (this.recording !== undefined) this.outputs.compare(this.recording);
    else if (first !== undefined && stateOf(this.verdict) === 'sound' && this.outputs.panel === 'findings') this.choose(first, 'machine');
  }

  /** For a while; what could not be done stays longer. */
  tell(text: string): void {
    const told = byId('told');
    told.textContent = text.trim();
    told.hidden = text.trim() === '';
    clearTimeout(this.toldUntil);
    this.toldUntil = window.setTimeout(() => (told.hidden = true), 4000 + 60 * text.length);
  }

  /** What the program knows of a code, a message, a parameter or a word. */
  async explain(word: string): Promise<void> {
    const outcome = await this.program.answer({ question: 'explain', word, format: 'markdown' });
    this.open_(outcome.result || reasonIn(outcome.error));
  }

  render(): void {
    byId('file-name').textContent = byId('file-name').title = this.shown;
    byId('download').textContent = say('download', { file: this.shown.slice(this.shown.lastIndexOf('/') + 1) });
    byId('hidden-text').textContent = say('notShown', { file: this.shown });
    const changed = this.workspace.changed.length;
    byId('compare').hidden = changed === 0;
    byId('download-all').hidden = changed < 2;
    byId('download-all').textContent = say('downloadAll', { files: changed });
    byId('before-line').classList.toggle('unchanged', changed === 0);
    this.renderFindings();
    this.editor.show(this.findings.filter((finding) => finding.file === this.shown));
    this.renderFacts();
  }

  private renderFindings(): void {
    const { findings } = this;
    if (this.severity && !findings.some(({ severity }) => severity === this.severity)) this.severity = null;
    showFilters(byId('filters'), findings, this.severity, (severity) => {
      this.severity = severity;
      this.renderFindings();
    });
    byId('no-findings').hidden = stateOf(this.verdict) !== 'sound';
    const shown = findings.filter(({ severity }) => this.severity === null || severity === this.severity);
    showFindings(byId(this.isExample ? 'example-findings' : 'finding-list'), shown, this.actions);
    // The start page has no verdict.
    if (this.isExample && this.trouble !== null) byId('example-findings').replaceChildren(element('li', { class: 'trouble' }, this.trouble));
  }

  private renderFacts(): void {
    const { facts, machines, safe } = this.survey;
    showVerdict({ ...this.verdict, facts, safe, shown: this.shown });
    byId('machines-line').hidden = machines.size < 2;
    byId('machines').replaceChildren(...[...machines.keys()].map((path) => new Option(path, path, false, path === facts?.described.path)));
    showFiles(byId('file-list'), this.workspace, facts ? [[facts.described.path, facts.machine], ...machines] : [...machines], this.findings, this.shown, (path) => this.choose(path));
  }

  private get verdict(): Checked {
    return { findings: this.findings, files: this.checkedFiles, trouble: this.trouble };
  }

  /** Whether a file describes a machine. */
  isMachine(path: string): boolean {
    return this.survey.machines.has(path);
  }

  private go(finding: Finding): void {
    if (this.isExample) byId('open-example').click();
    if (this.workspace.files.has(finding.file)) this.choose(finding.file);
    const { line, column, end_line, end_column } = finding;
    if (!line || !column || !end_line || !end_column) return;
    this.editor.go({ file: finding.file, line, column, end_line, end_column });
  }

  /** The edits of findings: in the editor those of the shown file, in other files at once. */
  private fix(findings: readonly Finding[]): void {
    if (this.isExample) byId('open-example').click();
    const all = findings.flatMap((finding) => finding.fix?.edits ?? []);
    const edits = [...new Map(all.map((edit) => [JSON.stringify(edit), edit])).values()];
    const here = edits.some((edit) => edit.file === this.shown) ? this.shown : edits[0]?.file;
    if (here === undefined) return;
    if (here !== this.shown) this.choose(here);
    for (const [path, bytes] of this.workspace.repaired(edits.filter((edit) => edit.file !== here))) this.program.update([[path, bytes]]);
    this.editor.apply(edits.filter((edit) => edit.file === here));
  }

  /** Files that the program wrote. */
  replaced(written: Repair['changed']): void {
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

  /** In other colours. */
  dress(): void {
    if (this.outputs.panel === 'report') this.outputs.refresh();
  }

  /** After a change of language or cycle time. */
  again(): void {
    this.showStart(byId('start').hidden === false);
    this.render();
    void this.check(true);
  }
}
