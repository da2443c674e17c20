// The panel of pictures: the kind, its subject, and the picture itself.
import type { Outcome } from '../interface/axisc.mjs';
import { showTrouble, type Desk } from './desk';
import { byId, element, save } from './elements';
import { isProgram } from './files';
import { markdown } from './markdown';
import { Picture } from './picture';
import { say } from './texts';

/** The subject of a kind, in addition to the machine. */
interface Kind {
  of: 'axes' | 'contour' | 'program' | 'plant' | 'recording';
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
  compare: { of: 'recording' },
} as const satisfies Record<string, Kind>;
type KindName = keyof typeof kinds;

/** Puts choices into a menu; the selected one stays if it is still there. */
function fill(menu: HTMLSelectElement, choices: readonly (readonly [string, string])[]): void {
  const wanted = menu.value;
  menu.replaceChildren(...choices.map(([value, text]) => element('option', { value }, text)));
  if (choices.some(([value]) => value === wanted)) menu.value = wanted;
}

const isPlant = (path: string): boolean => /\.json$/i.test(path) && !/(^|\/)(machine|axisc)\.json$/i.test(path);
const same = (name: string): [string, string] => [name, name];

export class Pictures {
  private readonly picture = new Picture(byId('picture'), byId('tools'));
  private readonly kind = byId<HTMLSelectElement>('kind');
  private readonly axis = byId<HTMLSelectElement>('axis');
  private readonly program = byId<HTMLSelectElement>('program');
  private readonly recording = byId<HTMLSelectElement>('recording');
  private readonly plant = byId<HTMLSelectElement>('plant');
  private readonly before = byId<HTMLInputElement>('before');
  private svg = '';

  constructor(
    private readonly page: Desk,
    refresh: () => void,
  ) {
    byId('save-picture').addEventListener('click', () => save('picture.svg', this.svg, 'image/svg+xml'));
    for (const id of ['kind', 'axis', 'program', 'recording', 'in', 'out', 'plant', 'travel', 'feed', 'before']) byId(id).addEventListener('change', refresh);
  }

  speak(): void {
    this.picture.speak();
    for (const id of ['in', 'out']) byId<HTMLInputElement>(id).placeholder = say('foundByItself');
    this.fillKinds();
  }

  /** Chooses a recording. */
  compare(path: string): void {
    this.fillKinds();
    this.kind.value = 'compare';
    fill(this.recording, [same(path)]);
  }

  /** Kinds without a subject among the files are left out. */
  private fillKinds(): void {
    const { paths, recordings } = this.page.workspace;
    const isThere = { axes: true, contour: true, program: paths.some(isProgram), plant: paths.some(isPlant), recording: recordings.length > 0 };
    const names = (Object.keys(kinds) as KindName[]).filter((name) => isThere[kinds[name].of]);
    fill(this.kind, names.map((name) => [name, say(name)] as const));
  }

  async draw(isLast: () => boolean): Promise<void> {
    this.fillKinds();
    const name = this.kind.value as KindName;
    const { of } = kinds[name];
    const axes = await this.axes();
    if (!isLast()) return;
    this.offer(of, axes);
    const outcome = await (of === 'recording' ? this.compared(axes, isLast) : this.page.program.answer({ question: 'picture', kind: name, input: this.page.shown, ...this.subject(of) }));
    if (!isLast()) return;
    this.svg = outcome.result;
    if (of !== 'recording') byId('picture-text').replaceChildren();
    showTrouble(byId('picture-trouble'), outcome, this.page);
    byId('picture-trouble').hidden = this.svg !== '';
    byId('picture').hidden = this.svg === '';
    byId<HTMLButtonElement>('save-picture').disabled = this.svg === '';
    if (this.svg === '') this.picture.clear();
    else this.picture.show(this.svg, say(name));
  }

  /** The picture of a comparison with a recording; its words go below it. */
  private async compared(axes: readonly string[], isLast: () => boolean): Promise<Outcome<string>> {
    const { program, shown } = this.page;
    const [input, output] = (['in', 'out'] as const).map((id) => byId<HTMLInputElement>(id).value.trim() || undefined);
    const question = { input: shown, recording: this.recording.value, axis: axes.length > 1 ? this.axis.value : undefined, in: input, out: output };
    const answer = await program.answer({ question: 'compare', ...question, format: 'markdown' });
    if (isLast()) byId('picture-text').replaceChildren(markdown(answer.result));
    if (answer.result === '') return answer;
    return program.answer({ question: 'picture', kind: 'compare', ...question });
  }

  private async axes(): Promise<string[]> {
    const outcome = await this.page.program.answer({ question: 'machine', input: this.page.shown, format: 'json' });
    if (outcome.result === '') return [];
    return ((JSON.parse(outcome.result) as { axes?: { name: string }[] }).axes ?? []).map((axis) => axis.name);
  }

  /** The choices that a kind has. */
  private offer(of: Kind['of'], axes: readonly string[]): void {
    const { paths, recordings } = this.page.workspace;
    // One axis moves with its plant; all may be drawn over one another.
    fill(this.axis, [...(of === 'plant' || of === 'recording' ? [] : [['', say('everyAxis')] as const]), ...axes.map(same)]);
    fill(this.program, paths.filter(isProgram).map(same));
    fill(this.recording, recordings.map(same));
    fill(this.plant, paths.filter((path) => isPlant(path) && !this.page.isMachine(path)).map(same));
    byId('axis-line').hidden = of === 'contour' || of === 'program';
    byId('program-line').hidden = of !== 'program';
    for (const id of ['recording-line', 'in-line', 'out-line']) byId(id).hidden = of !== 'recording';
    for (const id of ['plant-line', 'travel-line', 'feed-line']) byId(id).hidden = of !== 'plant';
    byId('before-line').hidden = of === 'program' || of === 'plant' || of === 'recording';
  }

  private subject(of: Exclude<Kind['of'], 'recording'>): Record<string, string | undefined> {
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
