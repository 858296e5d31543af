#!/usr/bin/env bash
# What the firmware costs on Cortex-M, measured anew and held against tests/board/ceilings.txt.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -gt 0 ]; then
  cat <<'END'
Usage: tools/size_table.sh

Builds the presets cortex-m7, cortex-m4f and cortex-m3, measures printer_drawer with float under qemu, and prints a
table; it is also written to build/size_table.md. tools/setup_cross.sh installs what this needs.

Exit codes: 0 every figure is under its ceiling, 1 one is not, or a build failed, 2 wrong usage.
END
  case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
fi

presets=(cortex-m7 cortex-m4f cortex-m3)
for preset in "${presets[@]}"; do
  tools/quietly.sh "Building $preset" tools/build_preset.sh "$preset"
  log=build/$preset/ceilings.log
  ctest --preset "$preset" -R Ceiling --no-tests=error >"$log" 2>&1 || { cat "$log" && exit 1; }
done

# Flash is code, constants and the first values of data; memory includes the frame of 307,200 bytes, not the stack.
{
  echo "| printer_drawer, float | flash, B | memory, B | worst stack, B | tracked step, instructions | of it solve |"
  echo "|---|---|---|---|---|---|"
  for preset in "${presets[@]}"; do
    cat "build/$preset"/{Board,Stack}_*.txt | awk -v preset="$preset" '
      { value[$2] = $3 }
      END {
        print "| " preset " | " value["text_bytes"] + value["data_bytes"] " | " \
          value["data_bytes"] + value["bss_bytes"] " | " value["loop_stack_bytes/PrinterDrawer/float"] " | " \
          value["instructions/tracked_step"] " | " value["instructions/tracked_solve"] " |"
      }'
  done
} | tee build/size_table.md
