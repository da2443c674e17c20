// What two builds of the program compute, where their mathematical functions differ in the last digits.
const number = /-?\d+\.?\d*(?:e[-+]?\d+)?/g;
const close = (a, b, rounding) => Math.abs(a - b) <= Math.max(1e-9 * Math.abs(a), rounding ? 0.0101 : 1e-12) + (rounding ? 1e-3 * Math.abs(a) : 0);

/** The texts are equal but for numbers, and those nearly so. Figures of reports have four digits, pictures two decimals. */
export function equalAsNumbers(a, b, rounding) {
  if (a === b) return true;
  const left = a.match(number) ?? [];
  const right = b.match(number) ?? [];
  return (
    a.replace(number, "#") === b.replace(number, "#") &&
    left.length === right.length &&
    left.every((text, i) => text === right[i] || close(Number(text), Number(right[i]), rounding))
  );
}
