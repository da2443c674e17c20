// What a browser makes of a picture: its labels must not overlap, and none may leave the picture. Writes one line per
// mistake into the page, which the browser prints.
"use strict";

/// How far boxes of two labels may run into each other: a font's box is higher than its letters.
const tolerance = 1.5;

function boxOf(element, picture) {
  const box = element.getBoundingClientRect();
  const frame = picture.getBoundingClientRect();
  return { left: box.left - frame.left, top: box.top - frame.top, right: box.right - frame.left, bottom: box.bottom - frame.top };
}

function overlap(a, b) {
  return Math.min(a.right, b.right) - Math.max(a.left, b.left) > tolerance &&
         Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > tolerance;
}

function mistakesOf(name, picture) {
  const mistakes = [];
  const frame = picture.getBoundingClientRect();
  const labels = [...picture.querySelectorAll("text")].filter((text) => text.textContent.trim() !== "");
  const boxes = labels.map((text) => boxOf(text, picture));
  if (labels.length === 0) mistakes.push(`${name}: no text at all`);
  boxes.forEach((box, i) => {
    const words = labels[i].textContent;
    if (box.left < -tolerance || box.top < -tolerance || box.right > frame.width + tolerance ||
        box.bottom > frame.height + tolerance) {
      mistakes.push(`${name}: "${words}" leaves the picture`);
    }
    for (let j = 0; j < i; ++j) {
      if (overlap(box, boxes[j])) mistakes.push(`${name}: "${words}" overlaps "${labels[j].textContent}"`);
    }
  });
  return mistakes;
}

const found = [];
let pictures = 0;
for (const section of document.querySelectorAll("section")) {
  for (const picture of section.shadowRoot.querySelectorAll("svg")) {
    ++pictures;
    found.push(...mistakesOf(section.dataset.name, picture));
  }
}
document.body.replaceChildren();
const result = document.createElement("pre");
result.id = "result";
result.textContent = [`pictures: ${pictures}`, ...found].join("\n");
document.body.append(result);
