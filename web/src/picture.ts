// A picture of the program, shown as an image: scripts in it never run. Zooms by button, by key and by wheel;
// moves by pointer.
import { button, element } from './elements';
import { say } from './texts';

const largest = 12;

export class Picture {
  private readonly image = element('img', { alt: '', draggable: 'false' });
  private readonly frame: HTMLElement;
  private url: string | null = null;
  private scale = 1;
  private x = 0;
  private y = 0;

  constructor(
    parent: HTMLElement,
    private readonly tools: HTMLElement,
  ) {
    this.frame = element('div', { class: 'frame', tabindex: '0', role: 'group' }, this.image);
    tools.append(
      button('+', () => this.zoom(1.5), { 'data-text': 'larger' }),
      button('−', () => this.zoom(1 / 1.5), { 'data-text': 'smaller' }),
      button('1:1', () => this.reset(), { 'data-text': 'whole' }),
    );
    parent.append(this.frame);
    this.frame.addEventListener('keydown', (event) => this.key(event));
    this.frame.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    this.frame.addEventListener('pointerdown', (event) => this.drag(event));
    this.speak();
  }

  speak(): void {
    for (const tool of this.tools.querySelectorAll<HTMLElement>('[data-text]')) {
      const text = say(tool.dataset['text'] as 'larger' | 'smaller' | 'whole');
      tool.title = text;
      tool.setAttribute('aria-label', `${tool.textContent} ${text}`);
    }
  }

  show(svg: string, title: string): void {
    if (this.url) URL.revokeObjectURL(this.url);
    this.url = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    this.image.src = this.url;
    this.image.alt = title;
    this.frame.setAttribute('aria-label', title);
  }

  clear(): void {
    this.image.removeAttribute('src');
    this.image.alt = '';
  }

  private reset(): void {
    this.scale = 1;
    this.x = this.y = 0;
    this.place();
  }

  private zoom(factor: number): void {
    const scale = Math.min(largest, Math.max(1, this.scale * factor));
    this.x *= scale / this.scale;
    this.y *= scale / this.scale;
    this.scale = scale;
    this.place();
  }

  private place(): void {
    if (this.scale === 1) this.x = this.y = 0;
    this.image.style.transform = `translate(${this.x}px, ${this.y}px) scale(${this.scale})`;
  }

  private key(event: KeyboardEvent): void {
    const moves: Record<string, [number, number]> = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] };
    const move = moves[event.key];
    if (event.key === '+') this.zoom(1.5);
    else if (event.key === '-') this.zoom(1 / 1.5);
    else if (event.key === '0') this.reset();
    else if (move && this.scale > 1) {
      this.x += move[0];
      this.y += move[1];
      this.place();
    } else return;
    event.preventDefault();
  }

  private wheel(event: WheelEvent): void {
    if (!event.ctrlKey && this.scale === 1) return;
    event.preventDefault();
    this.zoom(event.deltaY < 0 ? 1.2 : 1 / 1.2);
  }

  private drag(down: PointerEvent): void {
    if (this.scale === 1) return;
    const [x, y] = [this.x - down.clientX, this.y - down.clientY];
    this.frame.setPointerCapture(down.pointerId);
    const move = (event: PointerEvent): void => {
      this.x = x + event.clientX;
      this.y = y + event.clientY;
      this.place();
    };
    this.frame.addEventListener('pointermove', move);
    this.frame.addEventListener('pointerup', () => this.frame.removeEventListener('pointermove', move), { once: true });
  }
}
