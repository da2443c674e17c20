// The field that looks codes, messages, parameters and words up, and the pages that it finds.
import { button, byId } from './elements';
import { markdown } from './markdown';

/** What a page refers to in the first column of a table, or in its text. */
const topic = /^(AX\d{4}|P-AXIS-\d+|[a-z_]\w*(\[\w*\])?(\.\w+(\[\w*\])?)+|[A-Z][A-Z0-9_]{2,})$/;

export class Lookup {
  private find: (word: string) => void = () => undefined;

  connect(find: (word: string) => void): void {
    this.find = find;
    byId('look-up').addEventListener('submit', (event) => {
      event.preventDefault();
      const word = byId<HTMLInputElement>('word').value.trim();
      if (word !== '') find(word);
    });
    byId('close-page').addEventListener('click', () => byId<HTMLDialogElement>('page').close());
  }

  /** A page of Markdown over the others. */
  open(text: string): void {
    const page = markdown(text);
    for (const cell of page.querySelectorAll<HTMLElement>('td:first-child')) {
      const word = cell.textContent ?? '';
      if (topic.test(word)) cell.replaceChildren(button(word, () => this.find(word), { class: 'link' }));
    }
    byId('page-text').replaceChildren(page);
    byId('page-text').scrollTop = 0;
    const dialog = byId<HTMLDialogElement>('page');
    if (!dialog.open) dialog.showModal();
  }
}
