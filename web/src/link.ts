// A small list in the address of the page, after its "#", which browsers do not send.
export interface Shared {
  name: string;
  text: string;
  cycleTime: string;
}

export const longestLink = 8000;

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const readable = new Blob([bytes as BlobPart]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array, Uint8Array>);
  return new Uint8Array(await new Response(readable).arrayBuffer());
}

/** Null where the list is too long. */
export async function toFragment(shared: Shared): Promise<string | null> {
  const bytes = new TextEncoder().encode(JSON.stringify([shared.name, shared.cycleTime, shared.text]));
  const packed = await through(bytes, new CompressionStream('deflate-raw'));
  const text = btoa(String.fromCharCode(...packed)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
  return text.length > longestLink ? null : `#list=${text}`;
}

/** Null for anything that toFragment() did not make. */
export async function fromFragment(fragment: string): Promise<Shared | null> {
  const packed = /^#list=([\w-]{1,8000})$/.exec(fragment)?.[1];
  if (packed === undefined) return null;
  try {
    const binary = atob(packed.replace(/-/g, '+').replace(/_/g, '/'));
    const bytes = await through(Uint8Array.from(binary, (character) => character.charCodeAt(0)), new DecompressionStream('deflate-raw'));
    const parts: unknown = JSON.parse(new TextDecoder().decode(bytes));
    if (!Array.isArray(parts) || parts.length !== 3 || !parts.every((part) => typeof part === 'string')) return null;
    const [name, cycleTime, text] = parts as [string, string, string];
    return { name: name.replace(/[^\w .-]/g, '_') || 'x.lis', cycleTime, text };
  } catch {
    return null;
  }
}
