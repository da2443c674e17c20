// The theme's search takes signs of names such as `filter[0].order` and `#FILTER` for its own, knows no phrases, and forgives no
// slip. What is typed becomes words, neighbours also joined, long ones also with one letter wrong, before the worker sees it.
(() => {
  const forgiving = (typed) => {
    const words = typed.split(/[^\p{L}\p{N}_]+/u).filter((word, _, all) => word.length > 1 || all.length === 1).slice(0, 8);
    const slips = words.filter((word) => word.length > 4 && !/^\d+$/.test(word)).map((word) => `${word}~1`);
    const phrases = words.flatMap((_, begin) => [2, 3, 4].map((count) => words.slice(begin, begin + count).join('').replaceAll('_', '')).filter(Boolean));
    const numbers = words.filter((word) => /^\d{5,}$/.test(word)).flatMap((word) => Array(9).fill(word));
    const names = typed.split(/\s+/).filter((name) => /^\w[\w[\]]*([.-][\w[\]]+)+$/.test(name));
    // What is said more often counts more. Tags count most: one word of several must not find a page by its tag alone.
    const single = words.length > 1 ? words.flatMap((word) => [`title:${word}`, `text:${word}`]) : words;
    return [...new Set(slips), ...[...new Set(phrases)].map((phrase) => `${phrase}^8`), ...numbers, ...names, ...single].join(' ');
  };
  const query = 2;
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message, ...more) {
    const asked = message?.type === query && typeof message.data === 'string';
    return post.call(this, asked ? { ...message, data: forgiving(message.data) } : message, ...more);
  };
})();
