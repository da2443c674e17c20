// The panel of pictures: the kind, its subject, and the picture itself.
import { byId, element, save } from './elements';
import type { Desk } from './desk';
import { Picture } from './picture';
import { say } from './texts';

/** The subject of a kind, in addition to the machine. */
interface Kind {
  of: 'axes' | 'contour' | 'program' | 'plant';
}

export const kinds = {
  response: { of: 'axes' },
  step: { of: 'axes' },
  delay: { of: 'axes' },
  corner: { of: 'contour' },
  circle: { of: 'contour' },
  dynamics: { of: 'axes' },
  robustness: { of: 'axes' },
  path: { of: 'program' },
  plant: { of: 'plant' },
} as const satisfies Record<string, Kind>;
type KindName = keyof typeof kinds;

/** Puts choices into a menu; the selected one stays if it is still there. */
function fill(menu: HTMLSelectElement, choices: readonly (readonly [string, string])[]): void {
  const wanted = menu.value;
  menu.replaceChildren(...choices.map(([value, text]) => element('option', { value }, text)));
  if (choices.some(([value]) => value === wanted)) menu.value = wanted;
}

const same = (name: string): [string, string] => [name, name];

export class Pictures {
  private readonly picture = new Picture(byId('picture'));
  private readonly kind = byId<HTMLSelectElement>('kind');
  private readonly axis = byId<HTMLSelectElement>('axis');
  private readonly program = byId<HTMLSelectElement>('program');
  private readonly plant = byId<HTMLSelectElement>('plant');
  private readonly before = byId<HTMLInputElement>('before');
  private svg = '';

  constructor(
    private readonly page: Desk,
    refresh: () => void,
  ) {
    byId('save-picture').addEventListener('click', () => save('picture.svg', this.svg, 'image/svg+xml'));
    for (const id of ['kind', 'axis', 'program', 'plant', 'travel', 'feed', 'before']) byId(id).addEventListener('change', refresh);
  }

  speak(): void {
    this.picture.speak();
    fill(this.kind, (Object.keys(kinds) as KindName[]).map((name) => [name, say(name)] as const));
  }

  async draw(isLast: () => boolean): Promise<void> {
    const name = this.kind.value as KindName;
    const { of } = kinds[name];
    const axes = await this.axes();
    const { result: machine } = await this.page.program.answer({ question: 'machine_of', input: this.page.shown });
    if (!isLast()) return;
    this.offer(of, axes, machine);
    const question = { question: 'picture', kind: name, input: this.page.shown, ...this.subject(of) };
    const outcome = await this.page.program.answer(question);
    if (!isLast()) return;
    this.svg = outcome.result;
    const trouble = byId('picture-trouble');
    trouble.hidden = this.svg !== '';
    trouble.textContent = outcome.error.trim();
    byId<HTMLButtonElement>('save-picture').disabled = this.svg === '';
    if (this.svg === '') this.picture.clear();
    else this.picture.show(this.svg, say(name));
  }

  private async axes(): Promise<string[]> {
    const outcome = await this.page.program.answer({ question: 'machine', input: this.page.shown, format: 'json' });
    if (outcome.result === '') return [];
    return ((JSON.parse(outcome.result) as { axes?: { name: string }[] }).axes ?? []).map((axis) => axis.name);
  }

  /** The choices that a kind has. */
  private offer(of: Kind['of'], axes: readonly string[], machine: string): void {
    const { paths } = this.page.workspace;
    // One axis moves with its plant; all may be drawn over one another.
    fill(this.axis, [...(of === 'plant' ? [] : [['', say('everyAxis')] as const]), ...axes.map(same)]);
    fill(this.program, paths.filter((path) => /\.nc$/i.test(path)).map(same));
    fill(this.plant, paths.filter((path) => /\.json$/i.test(path) && path !== machine).map(same));
    byId('axis-line').hidden = of === 'contour' || of === 'program';
    byId('program-line').hidden = of !== 'program';
    for (const id of ['plant-line', 'travel-line', 'feed-line']) byId(id).hidden = of !== 'plant';
    byId('before-line').hidden = of === 'program' || of === 'plant';
  }

  private subject(of: Kind['of']): Record<string, string | undefined> {
    const named = (value: string): string | undefined => (value === '' ? undefined : value);
    if (of === 'program') return { program: named(this.program.value) };
    if (of === 'plant') return { plant: named(this.plant.value), move: named(this.move) };
    const before = this.before.checked ? `/before/${this.page.shown}` : undefined;
    return of === 'axes' ? { axis: named(this.axis.value), before } : { before };
  }

  /** There and back, as fast as the axis may without a feed rate. */
  private get move(): string {
    const [travel, feed] = ['travel', 'feed'].map((id) => byId<HTMLInputElement>(id).value.trim());
    return [this.axis.value, travel, feed].filter((part) => part !== '').join(':');
  }
}
