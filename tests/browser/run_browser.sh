#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Opens a report in a headless browser; fails on console errors, charts not drawn, a page that is wider than its window,
# or what an accessibility audit would name (probe.js). Screenshots stay in DIRECTORY.
#   run_browser.sh write DIRECTORY COMMAND…                      the command writes DIRECTORY/report.html, which is new
#   run_browser.sh MODE DIRECTORY BROWSER EXPECTED               EXPECTED is what probe.js must find in it
# MODE   desktop (1280 pixels), dark (the same), phone (390 pixels), print (as wide as A4; a PDF as well), still (without
#        scripts). The last two are looked at by short probes of their own: EXPECTED is not looked for.
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
here=$(dirname "$0")

flags="--headless --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars --allow-file-access-from-files
       --user-data-dir=$out/$mode.profile --no-first-run --enable-logging=stderr --v=0"
[ "$mode" = dark ] && flags="$flags --blink-settings=preferredColorScheme=0"

run() {  # name, window size, page, what to do
  # shellcheck disable=SC2086
  timeout 120 "$browser" $flags --window-size="$2" --virtual-time-budget=9000 $4 "file://$out/$3" \
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

# A headless window can't be narrower than 500 pixels, so the phone is a frame in a page.
frame() {  # file, page, width, height
  printf '%s\n' "<!DOCTYPE html><title>frame</title><style>body{margin:0}iframe{border:0;display:block}</style>
<iframe src=\"$2\" width=\"$3\" height=\"$4\"></iframe><script>
addEventListener('load', () => setInterval(() => { document.title = frames[0].document.title; }, 200));
</script>" > "$out/$1"
}

expect() {  # name, what its title must say
  if ! grep -qF "$2" "$out/$1.dom"; then
    echo "expected ($1): $2" >&2
    echo "found: $(grep -o '<title>[^<]*' "$out/$1.dom" | head -1)" >&2
    exit 1
  fi
}

probe() {  # into a copy of the page: page, copy, script
  { cat "$out/$1"; printf '<script>\n'; cat "$3"; printf '</script>\n'; } > "$out/$2"
}

case "$mode" in
  desktop | dark)
    probe report.html "$mode.probed.html" "$here/probe.js"
    run "${mode}_probe" 1280,900 "$mode.probed.html" --dump-dom
    expect "${mode}_probe" "$expected"
    run "$mode" 1280,5200 report.html "--screenshot=$out/$mode.png"
    ;;
  phone)
    probe report.html phone.probed.html "$here/probe.js"
    frame phone_probed.html phone.probed.html 390 800
    frame phone.html report.html 390 6400
    run phone_probe 800,900 phone_probed.html --dump-dom
    expect phone_probe "$expected"
    run phone 390,6400 phone.html "--screenshot=$out/phone.png"
    ;;
  print)
    # What a printer gets, on a screen: its rules for all, none of the screen's.
    sed -e 's/@media print/@media all/; s/@media screen and ([^)]*)/@media not all/; s/@media screen {/@media not all {/' \
      "$out/report.html" > "$out/print.html"
    printf '%s\n' 'addEventListener("load", () => setTimeout(() => {
      for (const folded of document.querySelectorAll("details")) folded.open = true;
      const page = document.documentElement, out = [...document.querySelectorAll("table, svg, pre, dl")].filter((e) =>
        e.getClientRects().length > 0 && e.getBoundingClientRect().right > page.clientWidth + 1);
      const seen = document.querySelectorAll(".still svg").length;
      const controls = [...document.querySelectorAll("input, .keys, .save")].filter((e) => e.getClientRects().length > 0);
      document.title = `PRINTED cut ${out.map((e) => `${e.tagName}.${e.className.baseVal ?? e.className}`)
        .join(" ") || "nothing"}, controls ${controls.length}, pictures ${seen > 0}`;
    }, 500));' > "$out/print_probe.js"
    probe print.html print.probed.html "$out/print_probe.js"
    run print_probe 703,1000 print.probed.html --dump-dom
    expect print_probe "PRINTED cut nothing, controls 0, pictures true"
    run print 703,6000 print.probed.html "--screenshot=$out/print.png"
    run print_pdf 1280,900 report.html "--no-pdf-header-footer --print-to-pdf=$out/print.pdf"
    [ -s "$out/print.pdf" ] || { echo "no PDF" >&2; exit 1; }
    ;;
  still)
    sed '/^<script>$/,$d' "$out/report.html" > "$out/still.html"
    printf '%s\n' 'addEventListener("load", () => {
      const seen = (selector) => [...document.querySelectorAll(selector)].filter((e) => e.getClientRects().length > 0);
      document.title = `STILL without ${document.querySelectorAll("figure.race").length - seen("figure.race .still svg.lines").length}` +
        ` pictures, controls ${seen("input, .keys, .save, .chart").length}`;
    });' > "$out/still_probe.js"
    probe still.html still.probed.html "$out/still_probe.js"
    run still_probe 1280,900 still.probed.html --dump-dom
    expect still_probe "STILL without 0 pictures, controls 0"
    run still 1280,5200 still.html "--screenshot=$out/still.png"
    ;;
  *)
    echo "no such mode: $mode" >&2
    exit 2
    ;;
esac
rm -rf "$out/$mode.profile"
echo "looked at: $out/$mode"
