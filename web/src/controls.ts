// Buttons, menus, drop, language and theme.
import { byId, element } from './elements';
import { chosen, dropped, sample, type Incoming } from './incoming';
import type { Page } from './page';
import { say, setLanguage, type Key, type Language } from './texts';

const samples: [string, string][] = [
  ['typing', 'mistakes/typing.lis'],
  ['unsuitable', 'mistakes/unsuitable.lis'],
  ['mill', 'mill'],
  ['rack', 'rack'],
  ['controller', 'controller'],
  ['controller-project', 'controller-project'],
];

export class Controls {
  constructor(private readonly page: Page) {}

  connect(): void {
    const language: Language = navigator.language.startsWith('de') ? 'de' : 'en';
    byId<HTMLSelectElement>('language').value = language;
    this.speak(language);
    this.dress(matchMedia('(prefers-color-scheme: dark)').matches);
    this.connectFiles();
    byId('language').addEventListener('change', () => {
      this.speak(byId<HTMLSelectElement>('language').value as Language);
      this.page.again();
    });
    byId('theme').addEventListener('click', () => this.dress(document.documentElement.dataset['theme'] !== 'dark'));
    byId('cycle-time').addEventListener('change', () => this.page.again());
    byId('new').addEventListener('click', () => this.page.begun(''));
    document.addEventListener('paste', (event) => {
      const text = event.clipboardData?.getData('text/plain') ?? '';
      const isElsewhere = event.target instanceof Element && event.target.closest('.cm-editor, input') === null;
      if (isElsewhere && text !== '') this.page.begun(text);
    });
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
    const menu = byId<HTMLSelectElement>('samples');
    menu.addEventListener('change', () => {
      if (menu.value !== '') this.take(sample(menu.value));
      menu.value = '';
    });
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

  private take(files: Promise<Incoming>): void {
    files.then(
      (incoming) => this.page.open(incoming),
      (failure: unknown) =>
        this.page.tell(
          failure instanceof RangeError ? say('tooLarge', { size: failure.message }) : say('failed', { reason: String(failure) }),
        ),
    );
  }

  private dress(dark: boolean): void {
    document.documentElement.dataset['theme'] = dark ? 'dark' : 'light';
  }

  private speak(language: Language): void {
    setLanguage(language);
    document.documentElement.lang = language;
    document.title = `axisc – ${say('title')}`;
    byId('subtitle').textContent = say('drop');
    const texts: Record<string, Key> = {
      open: 'open', 'open-folder': 'openFolder', new: 'new', 'fix-all': 'fixAll', align: 'align', compile: 'compile', share: 'share',
      'tab-findings': 'findings', 'tab-machine': 'machine', 'tab-pictures': 'pictures', 'tab-report': 'report',
    };
    for (const [id, key] of Object.entries(texts)) byId(id).textContent = say(key);
    for (const one of document.querySelectorAll<HTMLElement>('[data-text]')) {
      if (!one.closest('.tools')) one.textContent = say(one.dataset['text'] as Key);
    }
    const labels: Record<string, Key> = { language: 'language', theme: 'theme', samples: 'samples' };
    for (const [id, key] of Object.entries(labels)) {
      byId(id).setAttribute('aria-label', say(key));
      byId(id).title = say(key);
    }
    byId('samples').replaceChildren(
      element('option', { value: '' }, say('samples')),
      ...samples.map(([value, text]) => element('option', { value }, text)),
    );
    this.page.speak();
  }
}
