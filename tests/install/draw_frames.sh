#!/usr/bin/env bash
# Runs the example, which checks itself, and leaves its frames in FOLDER/frames.
#   draw_frames.sh FOLDER
set -euo pipefail
rm -rf "$1/frames"
mkdir "$1/frames"
"$1/cupboard_opens" "$1/frames"
