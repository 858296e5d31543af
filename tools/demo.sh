#!/usr/bin/env bash
# Installs what is missing, builds, tracks a simulated printer and a real plate, and says how well it went.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -gt 0 ]; then
  cat <<'END'
Usage: tools/demo.sh

Installs missing packages (root or sudo), builds preset host-release, and runs the firmware's tracker
  - on the scenario `paper`: a simulated printer whose drawer opens and closes, 60 s   -> out/paper
  - on 250 real frames of a hand-held plate with four dots (package visp-images-data)  -> out/mire
  - on the same frames, the spacing of the dots taken as unknown                -> out/mire_distance
Then prints a short table. Open out/paper/report.html in a browser.

Exit codes: 0 done, 1 something failed, 2 wrong usage.
END
  case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
fi

bin=build/host-release/bin
frames=/usr/share/visp-images-data/ViSP-images/mire-2
frame_budget_ms=33

tools/install_packages.sh
# The demo does without the packages of the tests, but leaves a folder as it is that has them.
tests=(--tests OFF)
if [ -e build/host-release/CMakeCache.txt ]; then tests=(); fi
CXX=g++ tools/quietly.sh "Building" tools/build_preset.sh host-release "${tests[@]}" \
  --target articam-sim --target articam-replay

echo "Simulating the printer of the paper"
mkdir -p out/paper out/mire out/mire_distance
"$bin/articam-sim" paper --out out/paper >out/paper/summary.txt
for model in mire mire_distance; do
  echo "Tracking the real plate: $model"
  "$bin/articam-replay" "$model" --camera static_models/cameras/mire_384x288.yaml --frames "$frames" \
    --max-frames 250 -o "out/$model/estimates.csv" >"out/$model/summary.txt"
done

# column FILE NAME: one column of a CSV file, without its empty fields.
column() {
  awk -F, -v name="$2" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
    c && $c != "" { print $c }' "$1"
}
median() { sort -g | awk '{ x[NR] = $1 } END { if (NR) print (x[int((NR + 1) / 2)] + x[int(NR / 2) + 1]) / 2 }'; }
tracked() {
  local frames=$(($(wc -l <"$1") - 1))
  echo "$(column "$1" status | grep -cx tracking || true) of $frames"
}
# word FILE PATTERN N: the Nth word of the first line that matches.
word() { awk -v pattern="$2" -v n="$3" '$0 ~ pattern { print $n; exit }' "$1"; }
row() { printf '  %-37s %s\n' "$1" "$2"; }

joint=$(head -n 1 out/mire_distance/estimates.csv | cut -d, -f12)
spacing_m=$(column out/mire_distance/estimates.csv "$joint" | median)
spacing_error=$(awk -v d="$spacing_m" 'BEGIN { printf "%+.2f mm (%+.2f %%)", 1e3 * (d - 0.14), 100 * (d / 0.14 - 1) }')

echo
echo "Simulated printer, 60 s"
row "drawer error, RMS" "$(word out/paper/summary.txt drawer_slide 3) mm"
row "marker distance error, RMS" "$(word out/paper/summary.txt marker_distance 3) mm"
row "frames tracked" "$(tracked out/paper/estimates.csv)"
row "time a frame, median" "$(word out/paper/summary.txt 'image to estimate' 4) ms of $frame_budget_ms ms"
echo "Real plate, 250 frames"
row "spacing of the dots (140 mm), error" "$spacing_error"
row "frames tracked" "$(tracked out/mire/estimates.csv)"
row "image residual, median" "$(column out/mire/estimates.csv rms_px | median) px"
row "time a frame, median" "$(word out/mire/summary.txt '^step' 3) ms of $frame_budget_ms ms"
echo
echo "Report: $PWD/out/paper/report.html"
