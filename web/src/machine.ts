// The panel of the machine: what it consists of, its filters, their delays, and what they do to contours.
import type { Desk } from './desk';
import { reasonIn, showTrouble } from './desk';
import { button, byId, element } from './elements';
import { markdown } from './markdown';

/** Names of files, with or without a line, lead to them. */
function link(page: HTMLElement, desk: Desk): void {
  const { paths } = desk.workspace;
  for (const cell of page.querySelectorAll<HTMLElement>('td, li')) {
    const [, before = '', text = '', after = ''] = /^(.*[ (])?([^\s()"]+\.(?:lis|xml|json|tsproj|nc)(?::\d+)?)(\)?)$/i.exec(cell.textContent ?? '') ?? [];
    const path = text.replace(/^(\.\.?\/)+/, '').replace(/:\d+$/, '');
    const found = path && paths.find((one) => one === path || one.endsWith(`/${path}`));
    if (found && cell.childElementCount === 0) cell.replaceChildren(before, button(text, () => desk.choose(found), { class: 'link' }), after);
  }
}

export async function showMachine(desk: Desk, isLast: () => boolean): Promise<void> {
  const [place, contours] = [byId('machine-text'), byId('contour-text')];
  const input = desk.shown;
  const machine = await desk.program.answer({ question: 'machine', input, format: 'markdown' });
  if (!isLast()) return;
  showTrouble(place, machine, desk);
  place.hidden = false;
  contours.replaceChildren();
  if (machine.result === '') return;
  const page = markdown(machine.result);
  link(page, desk);
  place.replaceChildren(page);
  const filters = await desk.program.answer({ question: 'filters', input, format: 'markdown' });
  if (!isLast()) return;
  showTrouble(contours, filters, desk);
  contours.hidden = false;
  if (filters.result === '') return;
  contours.append(markdown(filters.result));
  const contour = await desk.program.answer({ question: 'contour', input, format: 'markdown' });
  if (!isLast()) return;
  if (contour.status === 0) contours.append(markdown(contour.result));
  else contours.append(element('p', { class: 'trouble' }, reasonIn(contour.error)));
}
