// The panels beside the findings: files, machine, pictures, report. A panel is computed while it is looked at.
import { button, byId, element, save } from './elements';
import type { Finding } from './findings';
import type { Page } from './page';
import { Picture } from './picture';
import { say } from './texts';

const panels = ['findings', 'machine', 'pictures', 'report'] as const;
export type Panel = (typeof panels)[number];
export const kinds = ['response', 'step', 'delay', 'corner', 'circle'] as const;

export class Outputs {
  private panel: Panel = 'findings';
  private readonly picture = new Picture(byId('picture'));
  private svg = '';
  private html = '';
  private round = 0;
  private reportUrl: string | null = null;

  constructor(private readonly page: Page) {
    for (const panel of panels) {
      const tab = byId(`tab-${panel}`);
      tab.addEventListener('click', () => this.choose(panel));
      tab.addEventListener('keydown', (event) => this.key(event, panel));
    }
    byId('save-picture').addEventListener('click', () => save('picture.svg', this.svg, 'image/svg+xml'));
    byId('save-report').addEventListener('click', () => save('report.html', this.html, 'text/html'));
    byId('close-page').addEventListener('click', () => byId<HTMLDialogElement>('page').close());
    for (const id of ['kind', 'axis', 'before']) byId(id).addEventListener('change', () => this.refresh());
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
    this.picture.speak();
  }

  refresh(): void {
    const round = ++this.round;
    const isLast = (): boolean => round === this.round;
    if (this.panel === 'machine') void this.machine(isLast);
    if (this.panel === 'pictures') void this.draw(isLast);
    if (this.panel === 'report') void this.report(isLast);
  }

  listFiles(findings: readonly Finding[], shown: string): void {
    const rows = this.page.workspace.paths.map((path) => {
      const here = findings.filter((finding) => finding.file === path && finding.severity !== 'note');
      const worst = here.some((finding) => finding.severity === 'error') ? 'error' : 'warning';
      const row = button(path, () => this.page.show(path), { 'aria-current': String(path === shown) });
      if (here.length > 0) row.append(element('span', { class: `count ${worst}` }, String(here.length)));
      return element('li', {}, row);
    });
    byId('file-list').replaceChildren(...rows);
  }

  /** A page of text over the others. */
  open(text: string): void {
    byId('page-text').textContent = text;
    const dialog = byId<HTMLDialogElement>('page');
    if (!dialog.open) dialog.showModal();
  }

  private async machine(isLast: () => boolean): Promise<void> {
    const outcome = await this.page.program.run({ words: this.page.words('machine', this.page.workspace.inputs.machine) });
    if (isLast()) byId('machine-text').textContent = outcome.out || outcome.err;
  }

  private async axes(): Promise<string[]> {
    const outcome = await this.page.program.run({
      words: this.page.words('machine', '--format', 'json', this.page.workspace.inputs.machine),
    });
    try {
      const machine = JSON.parse(outcome.out) as { axes?: { name: string }[] };
      return (machine.axes ?? []).map((axis) => axis.name);
    } catch {
      return [];
    }
  }

  private async draw(isLast: () => boolean): Promise<void> {
    const names = await this.axes();
    const axis = byId<HTMLSelectElement>('axis');
    const wanted = axis.value;
    axis.replaceChildren(element('option', { value: '' }, say('everyAxis')), ...names.map((name) => element('option', { value: name }, name)));
    if (names.includes(wanted)) axis.value = wanted;
    const kind = byId<HTMLSelectElement>('kind').value;
    const input = this.page.workspace.inputs.machine;
    const more = kind === 'corner' || kind === 'circle' || axis.value === '' ? [] : ['--axis', axis.value];
    if (byId<HTMLInputElement>('before').checked) more.push('--before', `/before/${input}`);
    const outcome = await this.page.program.run({ words: this.page.words('plot', '--kind', kind, '--format', 'svg', '-o', '-', ...more, input) });
    if (!isLast()) return;
    this.svg = outcome.out;
    const trouble = byId('picture-trouble');
    trouble.hidden = this.svg !== '';
    trouble.textContent = outcome.err;
    byId<HTMLButtonElement>('save-picture').disabled = this.svg === '';
    if (this.svg === '') this.picture.clear();
    else this.picture.show(this.svg, say(kind as (typeof kinds)[number]));
  }

  private async report(isLast: () => boolean): Promise<void> {
    const outcome = await this.page.program.run({ words: this.page.words('report', '-o', '-', this.page.workspace.inputs.machine) });
    if (!isLast()) return;
    this.html = outcome.out;
    const trouble = byId('report-trouble');
    trouble.hidden = this.html !== '';
    trouble.textContent = outcome.err;
    byId<HTMLButtonElement>('save-report').disabled = this.html === '';
    if (this.reportUrl) URL.revokeObjectURL(this.reportUrl);
    this.reportUrl = URL.createObjectURL(new Blob([this.html], { type: 'text/html' }));
    byId<HTMLIFrameElement>('report-page').src = this.reportUrl;
  }
}
