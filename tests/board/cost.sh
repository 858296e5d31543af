#!/usr/bin/env bash
# What the firmware costs on one processor, one `figure value` a line:
#   cost.sh LOOP.elf COST.elf NM COUNTER.so EMULATOR...
# Memory is that of LOOP.elf: bss with the frame, without the stack. Instructions and the stack that was really used are
# those of COST.elf under qemu; a count repeats to the instruction.
set -euo pipefail
loop=$1 cost=$2 nm=$3 counter=$4
shift 4
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

address() { "$nm" "$1" | awk -v name="articam_$2" '$3 == name { print "0x" $1 }'; }
span() { echo $(($(address "$loop" "$2") - $(address "$loop" "$1"))); }
echo "text_bytes $(($(address "$loop" data_image)))"
echo "data_bytes $(span data_begin data_end)"
echo "bss_bytes $(span bss_begin bss_end)"

begin=$(address "$cost" measure_begin) end=$(address "$cost" measure_end)
# The emulator's last word, -kernel, belongs to the program.
timeout 300 "${@:1:$#-1}" -plugin "$counter,begin=$begin,end=$end,out=$out/counts" "${@: -1}" "$cost" >"$out/pieces"
paste -d' ' "$out/pieces" "$out/counts" >"$out/both"
awk '{ print "instructions/" $1, $3; if ($2 > most) most = $2 } END { print "used_stack_bytes", most }' "$out/both"
