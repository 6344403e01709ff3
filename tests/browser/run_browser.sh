#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Opens a report in a headless browser; fails on console errors, charts not drawn, or a page that is wider than its window.
#   run_browser.sh write DIRECTORY COMMAND…                      the command writes DIRECTORY/report.html, which is new
#   run_browser.sh desktop|phone DIRECTORY BROWSER EXPECTED      EXPECTED is what the probe below must find in it
set -eu

mode=$1 out=$2
shift 2
if [ "$mode" = write ]; then
  rm -rf "$out"
  mkdir -p "$out"
  exec "$@"
fi
browser=$1 expected="PROBE $2"
if [ ! -x "$browser" ]; then
  echo "no browser: install chromium" >&2
  exit 77
fi

# A script of the test's own, in a copy of the page: it looks, chooses every axis, hides a line, points at one, and
# writes what happened where --dump-dom shows it.
probe='<script>
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const lines = () => document.querySelectorAll(".chart .mark-line path").length;
addEventListener("load", async () => {
  await wait(300);
  const races = document.querySelectorAll("figure.race").length;
  const drawn = [...document.querySelectorAll(".chart")].filter((c) => c.querySelectorAll("svg").length === 1).length;
  const before = lines();
  for (const input of document.querySelectorAll(".controls input")) { input.click(); await wait(50); }
  const chosen = lines();
  document.querySelector(".keys button").click();
  await wait(50);
  const hidden = lines();
  const point = async (hit) => {
    const box = hit.getBoundingClientRect();
    for (const kind of ["mouseover", "mousemove", "pointerover", "pointermove"])
      hit.dispatchEvent(new MouseEvent(kind, { bubbles: true, clientX: box.x + box.width / 2,
                                               clientY: box.y + box.height / 2 }));
    await wait(50);
  };
  await point(document.querySelector(".chart .mark-symbol path"));
  const tip = document.querySelector(".chart .tip");
  const said = !tip.hidden && /quartiles/.test(tip.textContent);
  const thick = document.querySelectorAll(".mark-line path[stroke-width=\"3\"]").length;
  const wide = document.documentElement.scrollWidth > document.documentElement.clientWidth ? "wide" : "fits";
  const plates = document.querySelectorAll(".plates svg").length;
  const panels = [...document.querySelectorAll(".panel")];
  const filled = panels.filter((p) => p.querySelectorAll("svg").length === 1).length;
  const curves = document.querySelectorAll(".panel .mark-line path").length;
  let told = false;
  if (filled > 0) {
    await point(panels[0].querySelector(".hits path"));
    told = /after 0 iterations: 0[.]5/.test(panels[0].querySelector(".tip").textContent);
  }
  document.title = `PROBE races ${drawn} of ${races}, page ${wide}, plates ${plates}, ` +
    `lines ${before} ${chosen} ${hidden}, tip ${said}, thick ${thick}, ` +
    `panels ${filled} of ${panels.length}, curves ${curves}, told ${told}`;
});
</script>'
{ cat "$out/report.html"; printf '%s\n' "$probe"; } > "$out/$mode.probed.html"

# A headless window can't be narrower than 500 pixels, so the phone is a frame in a page.
printf '%s\n' '<!DOCTYPE html><title>phone</title><style>body{margin:0}iframe{border:0;display:block}</style>
<iframe src="report.html" width="390" height="5200"></iframe>' > "$out/phone.html"
printf '%s\n' '<!DOCTYPE html><title>phone</title><iframe src="phone.probed.html" width="390" height="800"></iframe><script>
addEventListener("load", () => setInterval(() => { document.title = frames[0].document.title; }, 200));
</script>' > "$out/phone_probed.html"

flags="--headless --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars --allow-file-access-from-files
       --user-data-dir=$out/$mode.profile --no-first-run --enable-logging=stderr --v=0"

run() {  # name, window size, page, what to do
  # shellcheck disable=SC2086
  timeout 60 "$browser" $flags --window-size="$2" --virtual-time-budget=6000 $4 "file://$out/$3" \
    > "$out/$1.dom" 2> "$out/$1.log" || {
    echo "the browser failed ($1):" >&2
    tail -5 "$out/$1.log" >&2
    exit 1
  }
  if grep -q 'CONSOLE' "$out/$1.log"; then
    echo "the page wrote to its console ($1):" >&2
    grep 'CONSOLE' "$out/$1.log" >&2
    exit 1
  fi
}

expect() {
  if ! grep -q "$expected" "$out/$1.dom"; then
    echo "expected ($1): $expected" >&2
    echo "found: $(grep -o '<title>[^<]*' "$out/$1.dom" | head -1)" >&2
    exit 1
  fi
}

if [ "$mode" = desktop ]; then
  probed=1280,900,desktop.probed.html shown=1280,4400,report.html
else
  probed=800,900,phone_probed.html shown=390,5200,phone.html
fi
run "${mode}_probe" "${probed%,*}" "${probed##*,}" --dump-dom
expect "${mode}_probe"
run "$mode" "${shown%,*}" "${shown##*,}" "--screenshot=$out/$mode.png"
rm -rf "$out/$mode.profile"
echo "screenshot: $out/$mode.png"
