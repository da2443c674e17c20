// The cover of a report as printed: A4 less its margins is 180 mm wide and 264 mm high.
'use strict';
{
  const pixels = (millimetres) => (millimetres * 96) / 25.4;
  document.body.style.width = '180mm';
  document.body.style.margin = '0';
  const cover = document.querySelector('.cover');
  cover.style.minHeight = '0';
  const {height} = cover.getBoundingClientRect();
  const isWide = cover.scrollWidth > pixels(180) + 1;
  const result = document.createElement('pre');
  result.id = 'result';
  const fits = height <= pixels(262) && !isWide;
  result.textContent = fits ? 'covers: 1' : `covers: 0\nheight ${(height * 25.4) / 96} mm, wide: ${isWide}`;
  document.body.replaceChildren(result);
}
