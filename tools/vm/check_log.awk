# Judges the console of a virtual board: one output a frame, each with the sequence and the time of a real camera.
#   awk -v wanted=FRAMES -f tools/vm/check_log.awk LOG
# Reads the rows of articam-board --link stdout (columns by name) between the `vm: ` lines of tools/vm/init. Prints what
# was seen; exit code 1 after a line for each thing that is wrong.
function wrong(text) { print "wrong: " text; failed = 1 }
function least(a, b) { return a == "" || b < a ? b : a }
function most(a, b) { return a == "" || b > a ? b : a }

BEGIN { FS = ","; kSlowest_s = 1; kFastest_s = 0.005 }  # mean period of frames: emulation is slow, vimc has no 200 Hz
{ sub(/\r$/, "") }
/^vm: starts / { split($0, word, " "); t_start = word[3] }
/^vm: ended / { split($0, word, " "); t_end = word[3]; exit_code = word[7] }
/^frame,t_s,status,reason,/ { num_columns = NF; next }
!num_columns || NF != num_columns || !/^[0-9]+,[0-9.e+-]+,[a-z]+,[a-z_]+,/ { next }

$3 != "lost" && $3 != "initialising" { wrong("status " $3 " where no marker is to be seen: " $0) }
$4 ~ /^(no_frame|camera_stalled)$/ { ++num_silent; next }  # a tick that says that no frame came
{
  if (num_frames > 0 && $1 == frame) wrong("a second output for frame " $1)
  else if (num_frames > 0 && $1 < frame) wrong("frame " $1 " came after frame " frame)
  else if (num_frames > 0) {
    if ($2 <= t_s) wrong("frame " $1 " at " $2 " s is not later than the one before, at " t_s " s")
    period_s = ($2 - t_s) / ($1 - frame)
    shortest_s = least(shortest_s, period_s)
    longest_s = most(longest_s, period_s)
    num_missed += $1 - frame - 1
  } else {
    first_frame = $1
    first_s = $2
  }
  if (t_start != "" && $2 < t_start) wrong("frame " $1 " is older than the program")
  frame = $1
  t_s = $2
  ++num_frames
}

END {
  if (t_start == "") wrong("the board did not come as far as its program")
  else if (t_end == "") wrong("the program did not end in time")
  else if (exit_code != 0) wrong("the program ended with exit code " exit_code)
  if (t_end != "" && num_frames > 0 && t_s > t_end) wrong("a frame is of the future: not the monotonic clock")
  if (num_frames < wanted) wrong(num_frames + 0 " frames came, " wanted " were wanted")
  if (frame > first_frame) {
    period_s = (t_s - first_s) / (frame - first_frame)
    if (period_s < kFastest_s || period_s > kSlowest_s) wrong("a frame every " period_s " s is not to be believed")
    printf "%d frames through libcamera, one output each; period %.1f ms (%.1f to %.1f), %d overtaken, %d silent\n",
      num_frames, 1e3 * period_s, 1e3 * shortest_s, 1e3 * longest_s, num_missed, num_silent
    printf "the board's program started %.1f s after the kernel and ran for %.1f s\n", t_start, t_end - t_start
  }
  exit failed
}
