#!/usr/bin/env bash
# icon.png from icon.svg, after a change of the drawing.
set -euo pipefail
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/icon.html" <<PAGE
<!doctype html><pre></pre><script>
const drawing = new Image();
drawing.onload = () => {
  const canvas = Object.assign(document.createElement('canvas'), {width: 128, height: 128});
  canvas.getContext('2d').drawImage(drawing, 0, 0);
  document.querySelector('pre').textContent = canvas.toDataURL('image/png').split(',')[1];
};
drawing.src = 'data:image/svg+xml;base64,$(base64 -w0 icon.svg)';
</script>
PAGE
timeout 120 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" --virtual-time-budget=5000 \
  --dump-dom "file://$work/icon.html" 2>/dev/null | sed -n 's/.*<pre>\(.*\)<\/pre>.*/\1/p' | base64 -d >"$work/icon.png"
[ -s "$work/icon.png" ]
cp "$work/icon.png" icon.png
