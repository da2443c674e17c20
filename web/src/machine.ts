// The panel of the machine: what it consists of, its filters in words, their delays, and what they do to contours.
import type { Desk } from './desk';
import { showTrouble } from './desk';
import { button, byId, element } from './elements';
import { markdown } from './markdown';
import { figure, say, type Key } from './texts';

interface Filter {
  type: string;
  order: number | null;
  frequency_hz: number | null;
  time_constant_us?: number | null;
}

interface Image {
  axes: {
    name: string;
    delay_ms: number;
    chain: { settling_ms: number | null; overshoot_percent: number | null; corner_frequency_hz: number | null } | null;
    filters: Filter[];
    linear_phase_filter: { on_at_start: boolean; kernel: number | null } | null;
  }[];
  kernels: Filter[];
}

function words({ type, order, frequency_hz: frequency, time_constant_us: time }: Filter): string {
  const size = frequency ? `${figure(frequency, 4)} Hz` : time ? `${figure(time / 1000, 4)} ms` : order ? say('order', { order }) : '';
  const name = /^(LOW|HIGH|BAND|ALL)|^PT\d$|^TIME|^(moving|Gauss|windowed|time)/.test(type) ? say(type as Key) : type;
  return [name, size].filter((part) => part !== '').join(frequency || time ? ' ' : ', ');
}

function filtersOf({ filters, linear_phase_filter: last }: Image['axes'][number], kernels: readonly Filter[]): string {
  const kernel = last?.kernel == null ? undefined : kernels[last.kernel];
  const linear = kernel && (last?.on_at_start ? words(kernel) : say('onCommand', { filter: words(kernel) }));
  return [...filters.map(words), ...(linear ? [linear] : [])].join(' → ') || say('noFilter');
}

function filters(json: string): HTMLElement {
  const { axes, kernels } = JSON.parse(json) as Image;
  const number = (value: number | null | undefined): HTMLElement => element('td', { class: 'number' }, value == null ? '' : figure(value, 4));
  const heads = (['axis', 'filtersOf', 'delayMs', 'cornerHz', 'overshoot', 'settles'] as const).map((key, i) => element('th', { scope: 'col', class: ['', 'filters'][i] ?? 'number' }, say(key)));
  const rows = axes.map((axis) =>
    element(
      'tr',
      {},
      element('th', { scope: 'row' }, axis.name),
      element('td', {}, filtersOf(axis, kernels)),
      ...[axis.delay_ms, axis.chain?.corner_frequency_hz, axis.chain?.overshoot_percent, axis.chain?.settling_ms].map(number),
    ),
  );
  const table = element('table', { tabindex: '0' }, element('thead', {}, element('tr', {}, ...heads)), element('tbody', {}, ...rows));
  return element('div', { class: 'markdown' }, element('h4', {}, say('filters')), table);
}

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
  const image = await desk.program.inspect(input);
  if (!isLast()) return;
  if (image.result === '') showTrouble(contours, image, desk);
  else contours.replaceChildren(filters(image.result));
  const contour = image.result === '' ? null : await desk.program.answer({ question: 'contour', input, format: 'markdown' });
  if (isLast() && contour?.result) contours.append(markdown(contour.result));
}
