// The panels: which one is seen, and what it shows. A panel is computed only while it is visible.
import type { Desk } from './desk';
import { showTrouble } from './desk';
import { byId, save } from './elements';
import { showMachine } from './machine';
import { Pictures } from './pictures';
import { Interrupted } from './program';
import { say } from './texts';

// Text and files are panels only where the page is narrow.
const panels = ['findings', 'machine', 'pictures', 'report', 'text', 'side'] as const;
export type Panel = (typeof panels)[number];

export class Outputs {
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
    this.choose('findings');
  }

  get panel(): Panel {
    return document.body.dataset['panel'] as Panel;
  }

  private key(event: KeyboardEvent, panel: Panel): void {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    const there = panels.filter((one) => byId(`tab-${one}`).offsetParent !== null);
    const next = there[(there.indexOf(panel) + step + there.length) % there.length] ?? 'findings';
    this.choose(next);
    byId(`tab-${next}`).focus();
  }

  choose(panel: Panel): void {
    document.body.dataset['panel'] = panel;
    // Where the page is wide, text and files are next to the findings.
    const shown = panel === 'text' || panel === 'side' ? 'findings' : panel;
    for (const one of panels) {
      if (one !== 'text' && one !== 'side') byId(one).hidden = one !== shown;
      byId(`tab-${one}`).setAttribute('aria-selected', String(one === panel));
      byId(`tab-${one}`).tabIndex = one === panel ? 0 : -1;
    }
    this.refresh();
  }

  /** Shows a recording next to what the program computes. */
  compare(recording: string): void {
    this.pictures.compare(recording);
    this.choose('pictures');
  }

  speak(): void {
    this.pictures.speak();
  }

  refresh(): void {
    const round = ++this.round;
    const isLast = (): boolean => round === this.round;
    const compute: Partial<Record<Panel, () => Promise<void>>> = {
      machine: () => showMachine(this.page, isLast),
      pictures: () => this.pictures.draw(isLast),
      report: () => this.report(isLast),
    };
    const busy = (isBusy: boolean): void => byId('results').setAttribute('aria-busy', String(isBusy));
    busy(true);
    Promise.resolve(compute[this.panel]?.())
      .catch((failure: unknown) => {
        if (!(failure instanceof Interrupted)) this.page.tell(say('failed', { reason: String(failure) }));
      })
      .finally(() => isLast() && busy(false));
  }

  private async report(isLast: () => boolean): Promise<void> {
    const outcome = await this.page.program.answer({ question: 'report', input: this.page.shown });
    if (!isLast()) return;
    this.html = outcome.result;
    showTrouble(byId('report-trouble'), outcome, this.page);
    byId('report-trouble').hidden = this.html !== '';
    byId<HTMLButtonElement>('save-report').disabled = byId('report-page').hidden = this.html === '';
    if (this.reportUrl) URL.revokeObjectURL(this.reportUrl);
    this.reportUrl = URL.createObjectURL(new Blob([preview(this.html)], { type: 'text/html' }));
    byId<HTMLIFrameElement>('report-page').src = this.reportUrl;
  }
}

/** The report without its scripts, which may not run here, in the page's colours, and no wider than its frame. */
function preview(html: string): string {
  const isDark = document.documentElement.dataset['theme'] === 'dark';
  const style = `<style>:root{color-scheme:${isDark ? 'dark' : 'light'} !important}td,h1,h2,h3{overflow-wrap:anywhere}</style></head>`;
  return html
    .replace(/<script\b[^]*?<\/script>/gi, '')
    .replace(/\(prefers-color-scheme: ?dark\)/g, isDark ? 'screen' : 'not all')
    .replace('</head>', style);
}
