// Buttons, menus, drop, language and theme.
import { button, byId, element } from './elements';
import { chosen, dropped, type Incoming } from './incoming';
import type { Lookup } from './lookup';
import type { Page } from './page';
import { isOneFile, textOfPart } from './parts';
import { say, setLanguage, type Key, type Language } from './texts';
import { showSamples } from './welcome';

/** What the browser remembers of this page; nothing where it may not. */
const memory = {
  read(name: string): string | null {
    try {
      return localStorage.getItem(`axisc.${name}`);
    } catch {
      return null;
    }
  },
  write(name: string, value: string): void {
    try {
      localStorage.setItem(`axisc.${name}`, value);
    } catch {
      // Private windows and some policies refuse.
    }
  },
};

const licences = ['LICENSE.txt', 'NOTICE.txt', 'third-party-licences.txt'];

export class Controls {
  constructor(
    private readonly page: Page,
    private readonly lookup: Lookup,
  ) {}

  connect(): void {
    const language = (memory.read('language') ?? (navigator.language.startsWith('de') ? 'de' : 'en')) as Language;
    byId<HTMLSelectElement>('language').value = language;
    this.speak(language);
    this.dress(memory.read('theme') ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));
    this.connectFiles();
    byId('language').addEventListener('change', () => {
      const chosenOne = byId<HTMLSelectElement>('language').value as Language;
      memory.write('language', chosenOne);
      this.speak(chosenOne);
      this.page.again();
    });
    byId('theme').addEventListener('click', () => {
      const theme = document.documentElement.dataset['theme'] === 'dark' ? 'light' : 'dark';
      memory.write('theme', theme);
      this.dress(theme);
      this.page.dress();
    });
    byId('cycle-time').addEventListener('change', () => this.time());
    byId('new').addEventListener('click', () => this.page.begun(''));
    for (const id of ['home', 'other']) byId(id).addEventListener('click', () => this.page.showStart(byId('start').hidden !== false || this.page.isExample));
    document.addEventListener('paste', (event) => {
      const text = event.clipboardData?.getData('text/plain') ?? '';
      const isElsewhere = event.target instanceof Element && event.target.closest('.cm-editor, input') === null;
      if (isElsewhere && text !== '') this.page.begun(text);
    });
    addEventListener('beforeunload', (event) => {
      if (this.page.workspace.unsaved.length > 0) event.preventDefault();
    });
  }

  private time(): void {
    const field = byId<HTMLInputElement>('cycle-time');
    const text = field.value.trim().replace(',', '.');
    const isTime = /^\d+(\.\d+)?\s*(us|µs|ms|s)?$/.test(text) && Number.parseFloat(text) > 0;
    field.setCustomValidity(isTime ? '' : say('badCycleTime'));
    field.setAttribute('aria-invalid', String(!isTime));
    if (!isTime) {
      field.reportValidity();
      return;
    }
    this.page.cycleTime = text.replace(/\s/g, '').replace('µ', 'u');
    this.page.again();
  }

  private connectFiles(): void {
    for (const [opener, input] of [['open', 'files'], ['open-folder', 'folder']] as const) {
      const field = byId<HTMLInputElement>(input);
      byId(opener).addEventListener('click', () => field.click());
      field.addEventListener('change', () => {
        if (field.files) this.take(chosen(field.files));
        field.value = '';
      });
    }
    document.addEventListener('dragover', (event) => {
      event.preventDefault();
      document.body.classList.add('dropping');
    });
    document.addEventListener('dragleave', (event) => {
      if (event.relatedTarget === null) document.body.classList.remove('dropping');
    });
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      document.body.classList.remove('dropping');
      if (event.dataTransfer) this.take(dropped(event.dataTransfer));
    });
  }

  private readonly failed = (failure: unknown): void =>
    this.page.tell(failure instanceof RangeError ? say('tooLarge', { size: failure.message }) : say('failed', { reason: String(failure) }));

  private take(files: Promise<Incoming>): void {
    files.then((incoming) => this.page.open(incoming), this.failed);
  }

  private dress(theme: string): void {
    document.documentElement.dataset['theme'] = theme;
  }

  private speak(language: Language): void {
    setLanguage(language);
    document.documentElement.lang = language;
    document.title = `axisc – ${say('title')}`;
    const texts: Record<string, Key> = {
      open: 'open', 'open-folder': 'openFolder', new: 'new', align: 'align', compile: 'compile', fmu: 'fmu', share: 'share',
      'tab-findings': 'findings', 'tab-machine': 'machine', 'tab-pictures': 'pictures', 'tab-report': 'report', 'tab-text': 'text', 'tab-side': 'side',
    };
    for (const [id, key] of Object.entries(texts)) byId(id).textContent = say(key);
    for (const one of document.querySelectorAll<HTMLElement>('[data-text]')) {
      if (!one.closest('.tools')) one.textContent = say(one.dataset['text'] as Key);
    }
    const labels: Record<string, Key> = { language: 'language', theme: 'theme', word: 'lookUp', side: 'side', filters: 'findings', home: 'home' };
    for (const [id, key] of Object.entries(labels)) {
      byId(id).setAttribute('aria-label', id === 'home' ? `axisc – ${say(key)}` : say(key));
      byId(id).title = say(key);
    }
    byId<HTMLInputElement>('word').placeholder = say('lookUpHint');
    showSamples(this.page, this.failed);
    byId('about').replaceChildren(
      ...(isOneFile ? [] : [element('a', { href: 'axisc.html', download: 'axisc.html' }, say('oneFile')), ' · ']),
      button(say('licences'), () => void this.showLicences(), { class: 'link' }),
    );
    this.page.speak();
  }

  private async showLicences(): Promise<void> {
    const texts = await Promise.all(licences.map(textOfPart));
    this.lookup.open(texts.map((text) => `\`\`\`\n${text.trim()}\n\`\`\``).join('\n\n'));
  }
}
