// Bytes that the program writes one by one.
export class Stream {
  private bytes = new Uint8Array(4096);
  private size = 0;

  write(byte: number | null): void {
    if (byte === null) return;
    if (this.size === this.bytes.length) {
      const longer = new Uint8Array(2 * this.size);
      longer.set(this.bytes);
      this.bytes = longer;
    }
    this.bytes[this.size++] = byte;
  }

  written(): Uint8Array {
    return this.bytes.slice(0, this.size);
  }
}
