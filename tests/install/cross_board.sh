#!/usr/bin/env bash
# Builds the outside project's board program for another processor, with the generator of this one, and runs it under
# the emulator over the frames that the native project drew.
#   cross_board.sh NATIVE_TESTS EMULATOR CMAKE SOURCE FOLDER CONFIGURE_OPTION...
# Exit code 77 (skipped) when the native tests have left no prefix and no frames.
set -euo pipefail
native=$1 emulator=$2 cmake=$3 source=$4 folder=$5
generator=$native/prefix/bin/articam-modelgen
if [ ! -x "$generator" ] || [ ! -e "$native/outside/frames/0059.pgm" ]; then
  echo "skipped: no installed articam of this machine in $native (ctest --preset host-release -R Outside makes it)"
  exit 77
fi
"$cmake" -S "$source" -B "$folder" -DARTICAM_MODELGEN="$generator" "${@:6}"
"$cmake" --build "$folder" --target cupboard_board
"$cmake" --build "$folder" --target cupboard_board | grep -q 'no work to do'  # nothing is compiled anew without need

read -ra emulate <<<"$emulator"
run() { "${emulate[@]}" "$folder/cupboard_board" "$@"; }
run --help | grep -q "'Cupboard' from the camera 'Front'"
run --camera "replay:$native/outside/frames" --rate 30 --frames 60 --priority 0 --quiet --link stdout \
  >"$folder/rows.csv"
grep -qE '^[0-9]+,[^,]*,tracking,none,' "$folder/rows.csv" || { tail -n 1 "$folder/rows.csv"; exit 1; }
