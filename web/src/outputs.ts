// The panels next to the findings: files, machine, pictures, report. A panel is computed only while it is
// visible.
import { button, byId, element, save } from './elements';
import type { Finding } from './findings';
import type { Desk } from './desk';
import { markdown } from './markdown';
import { Pictures } from './pictures';
import { Interrupted } from './program';
import { say } from './texts';

const panels = ['findings', 'machine', 'pictures', 'report'] as const;
export type Panel = (typeof panels)[number];

export class Outputs {
  private panel: Panel = 'findings';
  private readonly pictures: Pictures;
  private html = '';
  private round = 0;
  private reportUrl: string | null = null;

  constructor(private readonly page: Desk) {
    this.pictures = new Pictures(page, () => this.refresh());
    for (const panel of panels) {
      const tab = byId(`tab-${panel}`);
      tab.addEventListener('click', () => this.choose(panel));
      tab.addEventListener('keydown', (event) => this.key(event, panel));
    }
    byId('save-report').addEventListener('click', () => save('report.html', this.html, 'text/html'));
    byId('close-page').addEventListener('click', () => byId<HTMLDialogElement>('page').close());
    this.choose('findings');
  }

  private key(event: KeyboardEvent, panel: Panel): void {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    const next = panels[(panels.indexOf(panel) + step + panels.length) % panels.length] as Panel;
    this.choose(next);
    byId(`tab-${next}`).focus();
  }

  choose(panel: Panel): void {
    this.panel = panel;
    for (const one of panels) {
      byId(one).hidden = one !== panel;
      byId(`tab-${one}`).setAttribute('aria-selected', String(one === panel));
      byId(`tab-${one}`).tabIndex = one === panel ? 0 : -1;
    }
    this.refresh();
  }

  speak(): void {
    this.pictures.speak();
  }

  refresh(): void {
    const round = ++this.round;
    const isLast = (): boolean => round === this.round;
    const compute = { findings: null, machine: () => this.machine(isLast), pictures: () => this.pictures.draw(isLast), report: () => this.report(isLast) };
    compute[this.panel]?.().catch((failure: unknown) => {
      if (!(failure instanceof Interrupted)) this.page.tell(say('failed', { reason: String(failure) }));
    });
  }

  listFiles(findings: readonly Finding[], shown: string): void {
    let folder = '';
    const folderOf = (path: string): string => path.slice(0, path.lastIndexOf('/') + 1);
    const paths = this.page.workspace.paths.sort((a, b) => folderOf(a).localeCompare(folderOf(b)) || a.localeCompare(b));
    const rows = paths.flatMap((path) => {
      const above = folderOf(path);
      const heading = above === folder ? [] : [element('li', { class: 'folder' }, above)];
      folder = above;
      const here = findings.filter((finding) => finding.file === path && finding.severity !== 'note');
      const worst = here.some((finding) => finding.severity === 'error') ? 'error' : 'warning';
      const row = button(path.slice(above.length), () => this.page.choose(path), { 'aria-current': String(path === shown), title: path });
      if (here.length > 0) row.append(element('span', { class: `count ${worst}` }, String(here.length)));
      return [...heading, element('li', {}, row)];
    });
    byId('file-list').replaceChildren(...rows);
  }

  /** A page of Markdown over the others. */
  open(text: string): void {
    byId('page-text').replaceChildren(markdown(text));
    const dialog = byId<HTMLDialogElement>('page');
    if (!dialog.open) dialog.showModal();
  }

  private async machine(isLast: () => boolean): Promise<void> {
    const input = this.page.shown;
    const outcome = await this.page.program.answer({ question: 'machine', input });
    const contour = outcome.status === 0 ? await this.page.program.answer({ question: 'contour', input }) : null;
    if (!isLast()) return;
    byId('machine-text').replaceChildren(...this.linked(outcome.result || outcome.error));
    byId('contour').hidden = !contour?.result;
    byId('contour-text').textContent = contour?.result ?? '';
  }

  /** Names of files lead to them. */
  private linked(text: string): (Node | string)[] {
    const paths = this.page.workspace.paths;
    return text.split(/([^\s()"]+\.(?:lis|xml|json|tsproj|nc)\b)/i).map((part, i) => {
      const path = i % 2 === 1 ? paths.find((one) => one === part || one.endsWith(`/${part.replace(/^(\.\.?\/)+/, '')}`)) : undefined;
      return path === undefined ? part : button(part, () => this.page.choose(path), { class: 'link' });
    });
  }

  private async report(isLast: () => boolean): Promise<void> {
    const outcome = await this.page.program.answer({ question: 'report', input: this.page.shown });
    if (!isLast()) return;
    this.html = outcome.result;
    const trouble = byId('report-trouble');
    trouble.hidden = this.html !== '';
    trouble.textContent = outcome.error;
    byId<HTMLButtonElement>('save-report').disabled = this.html === '';
    if (this.reportUrl) URL.revokeObjectURL(this.reportUrl);
    this.reportUrl = URL.createObjectURL(new Blob([this.html], { type: 'text/html' }));
    byId<HTMLIFrameElement>('report-page').src = this.reportUrl;
  }
}
