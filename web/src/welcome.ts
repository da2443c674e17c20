// The page as it begins: what it is for, samples, and the result of one.
import { button, byId, element } from './elements';
import { sample } from './incoming';
import { fromFragment } from './link';
import type { Page } from './page';
import { say, type Key } from './texts';

const example = `kopf.achs_nr                   1
kopf.log_achs_name             X
kenngr.achs_typ                1
filter[0].enable               1
filter[0].type                 LOWPASS
filter[0].prototype            BUTTERWORTH
filter[0].order                2
filter[0].fg_f0                42,5
filter_fir.enable              1
filter_fir.type                1
filter_fir.order               20
`;

const samples: [string, Key, Key][] = [
  ['controller', 'sampleController', 'sampleControllerIs'],
  ['mill', 'sampleMill', 'sampleMillIs'],
  ['typing', 'sampleTyping', 'sampleTypingIs'],
  ['unsuitable', 'sampleUnsuitable', 'sampleUnsuitableIs'],
  ['rack', 'sampleRack', 'sampleRackIs'],
  ['recording', 'sampleRecording', 'sampleRecordingIs'],
];

const files = (name: string, text: string): [string, Uint8Array][] => [[name, new TextEncoder().encode(text)]];

export async function begin(page: Page): Promise<void> {
  byId('open-example').addEventListener('click', () => page.open(files('x.lis', example), { isSample: true }));
  const shared = await fromFragment(location.hash);
  if (shared) {
    page.cycleTime = byId<HTMLInputElement>('cycle-time').value = shared.cycleTime;
    page.open(files(shared.name, shared.text));
  } else page.open(files('x.lis', example), { isExample: true });
}

/** Cards of the samples, in the page's language. */
export function showSamples(page: Page, failed: (failure: unknown) => void): void {
  const card = ([name, title, text]: (typeof samples)[number]): HTMLElement => {
    const made = button('', () => sample(name).then((incoming) => page.open(incoming, { isSample: true, ...(name === 'recording' ? { recording: 'recording/scope.csv' } : {}) }), failed), { 'data-sample': name });
    made.append(element('b', {}, say(title)), element('span', {}, say(text)));
    return element('li', {}, made);
  };
  byId('samples').replaceChildren(...samples.map(card));
  byId('example-title').textContent = 'x.lis';
}
