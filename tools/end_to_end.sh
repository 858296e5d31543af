#!/usr/bin/env bash
# Recorded frames -> articam-board -> UDP -> articam-listen, held against articam-replay bit for bit.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<'END'
Usage: tools/end_to_end.sh [--frames N] [--rate HZ] [--preset PRESET] [--flood]

Renders 500 frames of the moving drawer, lets articam-board of the PRESET (host-release, aarch64, armhf) play N of them
(1000) in a circle at HZ frames a second (200), hears its packets with articam-listen over loopback, and compares the
rows with those of articam-replay: they must be the same bytes. Prints loss, latency, page faults and heap growth.
With --flood the run is repeated while 100,000 packets a second are sent to the board's own port: the period of the
estimates must not move by more than 5 %, neither its mean nor its deviation from tick to tick.

    tools/end_to_end.sh --frames 100000 --rate 500
    tools/end_to_end.sh --preset aarch64 --frames 1000 --rate 20

Needs built presets: host-release, and PRESET. Files are left in build/end_to_end.
Exit codes: 0 equal and complete, 1 not, 2 wrong usage.
END
}

frames=1000 rate=200 preset=host-release flood=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --flood) flood=yes; shift ;;
    --frames | --rate | --preset)
      [ $# -ge 2 ] || { echo "tools/end_to_end.sh: $1 needs a value" >&2; exit 2; }
      declare "${1#--}=$2"; shift 2 ;;
    *) echo "tools/end_to_end.sh: what is '$1'?" >&2; usage >&2; exit 2 ;;
  esac
done
[[ $frames =~ ^[1-9][0-9]{0,6}$ && $rate =~ ^[1-9][0-9]{0,2}$ ]] ||
  { echo "tools/end_to_end.sh: --frames is 1 to 9999999, --rate 1 to 999" >&2; exit 2; }
case $preset in
  host-release) emulator=() ;;
  aarch64) emulator=(qemu-aarch64 -L build/sysroot-aarch64) ;;
  armhf) emulator=(qemu-arm -L build/sysroot-armhf) ;;
  *) echo "tools/end_to_end.sh: '$preset' has no board with Linux" >&2; exit 2 ;;
esac

host=build/host-release/bin
board=build/$preset/bin/articam-board
for program in "$host"/articam-{sim,replay,listen,flood} "$board"; do
  [ -x "$program" ] || { echo "tools/end_to_end.sh: $program is not built" >&2; exit 1; }
done
out=build/end_to_end
port=47147
frame_folder=$out/frames
mkdir -p "$frame_folder"
if [ "$(find "$frame_folder" -name '*.pgm' | wc -l)" -ne 500 ]; then
  tools/quietly.sh "Rendering 500 frames" \
    "$host/articam-sim" drawer --duration 16.67 --frames-out "$frame_folder" --out "$out"
  find "$frame_folder" -name '*.pgm' | sort | tail -n +501 | xargs -r rm
fi

# The board's own port, by the peer that it is connected to.
board_port() {
  awk -v peer="$(printf '0100007F:%04X' "$port")" '$3 == peer { split($2, own, ":"); print own[2] }' /proc/net/udp
}

# run NAME: board and listener; leaves NAME.csv, NAME.board, NAME.listen.
run() {
  "$host/articam-listen" --udp "127.0.0.1:$port" --quiet --csv "$out/$1.csv" --t0 first --overwrite --count "$frames" \
    --timeout 30 >"$out/$1.listen" 2>&1 &
  local listener=$!
  sleep 0.5
  "${emulator[@]}" "$board" --camera "replay:$frame_folder" --frames "$frames" --rate "$rate" \
    --link "udp://127.0.0.1:$port" 2>"$out/$1.board" &
  local program=$!
  if [ "$1" = flood ]; then
    local own
    until own=$(board_port) && [ -n "$own" ]; do
      kill -0 "$program" 2>/dev/null || break
      sleep 0.1
    done
    (while kill -0 "$program" 2>/dev/null; do
      "$host/articam-flood" --to "127.0.0.1:$((16#$own))" --rate 100000 --seconds 2
    done) >"$out/flood.flood" &
  fi
  local failed=0
  wait "$program" || failed=1
  wait "$listener" || failed=1
  wait  # for the flood, where there is one
  if [ $failed -ne 0 ]; then tail -n 5 "$out/$1.board" "$out/$1.listen" >&2; fi
  return $failed
}

# Mean period and its deviation, ms.
period_of() { sed -n 's/^total .* period \([0-9.]*\) ms (jitter \([0-9.]*\),.*/\1 \2/p' "$out/$1.board"; }

echo "Board ($preset): $frames frames at $rate a second, about $((frames / rate)) s"
run plain
tools/quietly.sh "Replaying the same frames" "$host/articam-replay" printer_drawer \
  --camera static_models/cameras/xtion_vga.yaml --frames "$frame_folder" --repeat $((frames / 500 + 1)) \
  --max-frames "$frames" --fps "$rate" -o "$out/replay.csv"

failed=0
if cmp "$out/plain.csv" "$out/replay.csv"; then
  echo "estimates   $(($(wc -l <"$out/plain.csv") - 1)) rows, equal to articam-replay's byte for byte"
else
  echo "estimates   NOT equal to articam-replay's"
  failed=1
fi
sed -n '/^total/p;/^since/p' "$out/plain.board"
cat "$out/plain.listen"
grep -q 'heap growth 0 bytes' "$out/plain.board" || { echo "the heap has grown"; failed=1; }
# Under an emulator the pages are the emulator's: it translates as it goes.
if [ "$preset" = host-release ] && ! grep -q 'page faults 0 ' "$out/plain.board"; then
  echo "pages were faulted in after the start"
  failed=1
fi

if [ -n "$flood" ]; then
  run flood
  awk -v plain="$(period_of plain)" -v flooded="$(period_of flood)" '
    / a second$/ { rate += $(NF - 2); ++runs }
    END {
      split(plain, alone, " "); split(flooded, wet, " ")
      rate = runs > 0 ? rate / runs : 0
      printf "flood       %.0f packets a second to the board\n", rate
      printf "period      %.3f +- %.3f ms alone, %.3f +- %.3f ms in the flood\n", alone[1], alone[2], wet[1], wet[2]
      moved = wet[1] / alone[1] - 1
      exit rate < 90000 || moved > 0.05 || moved < -0.05 || wet[2] > alone[2] + 0.05 * alone[1]
    }' "$out/flood.flood" || { echo "the flood has moved the period, or was none"; failed=1; }
  cmp "$out/flood.csv" "$out/replay.csv" || failed=1
fi
exit $failed
