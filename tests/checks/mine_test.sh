#!/usr/bin/env bash
# `./course play N --mine` runs on the learner's lines, and on nothing else: a difference that is planted in
# them must show in the trace, and the course's own lines must give the course's own trace.
# usage: mine_test.sh TOP
set -uo pipefail
top=$1
folder=$(mktemp -d)
export BOUNCE_MINE="$folder/mine"
trap 'rm -rf "$folder"' EXIT
export BOUNCE_LANG=en # what is said is compared
failures=0
fails() { printf 'FAILED: %s\n' "$1"; failures=$((failures + 1)); }

header_of() { sed -n 's|^#define BOUNCE_STAGE_HEADER "\(.*\)"|\1|p' "$top/tests/checks/subjects/$1.cpp"; }

write() { # write STAGE [SED]: the stage's own header as a learner's file, with a change
  local header change=${2:-}; header="$top/stages/$(header_of "$1")"
  mkdir -p "$BOUNCE_MINE/$1"
  sed -e "$change" "$header" >"$BOUNCE_MINE/$1/mine.hpp"
  [ -z "$change" ] || ! cmp -s "$header" "$BOUNCE_MINE/$1/mine.hpp" || fails "$1: '$change' changes nothing"
}

mine() { # mine STAGE [WORDS...]: the rows of the learner's program
  local stage=$1; shift
  "$top/course" play "${stage%%_*}" --mine --headless --duration 2 --sample 0.1 --csv - "$@" 2>"$folder/said"
}
own() { # own STAGE [WORDS...]: the rows of the course's program
  local stage=$1; shift
  "$top/build/release/bin/$stage" --headless --duration 2 --sample 0.1 --csv - "$@" 2>/dev/null
}
equal() { # equal STAGE [WORDS...]
  cmp -s <(mine "$@") <(own "$@") || { fails "$*: the same lines give another trace"; tail -n 3 "$folder/said"; }
}
differ() { # differ STAGE [WORDS...]
  local rows; rows=$(mine "$@")
  [ "$(wc -l <<<"$rows")" -gt 10 ] || { fails "$*: it does not run"; tail -n 5 "$folder/said"; }
  ! cmp -s <(printf '%s\n' "$rows") <(own "$@") || fails "$*: the planted difference does not show"
}
more() { grep -q 'you changed more than the gaps' "$folder/said"; }
filled() { ! more || fails "$*: gaps were filled, and all is compiled"; }
differ_by_more() { # differ_by_more STAGE SED: a change that is not in what a gap's function does shows, too
  write "$1" "$2"; differ "$1"
  more || fails "$1, $2: it passes for a gap that was filled"
}
says() { grep -qF -- "$1" "$folder/said" || { fails "it does not say '$1'"; tail -n 3 "$folder/said"; }; }

half='s/-mass \* gravity/-mass * gravity \/ 2/'
first='s/^  state.velocity += acceleration \* dt;.*/  state.position += state.velocity * dt;/
s/^  state.position += state.velocity \* dt;  *\/\/.*/  state.velocity += acceleration * dt;/'

# Before there is a loop of the learner's own, the course's moves his force.
write 02_spring_floor
equal 02_spring_floor
says "your force, the course's loop"
write 02_spring_floor "$half"; differ 02_spring_floor; filled half of the weight
for change in 's/mass = 1.0/mass = 2.0/' 's/double force(/float force(/' \
  's/^  double force(/  double less = 5;\n&/;s/-mass \* gravity/&+ less/' \
  's/^  double force(/  SpringFloor() { gravity = 5; }\n&/' \
  's/^  double force(/  double half(double x) const { return x \/ 2; }\n&/;s/-mass \* gravity/half(&)/'; do
  differ_by_more 02_spring_floor "$change"
done

write 01_free_fall; equal 01_free_fall
says "your force, your loop"
says "method=mine"
write 01_free_fall "$half"; differ 01_free_fall
write 01_free_fall "$first"; differ 01_free_fall # and this loop moves the stages that follow:
for stage in 03_damping 04_three_dimensions; do write $stage; differ $stage; filled $stage; done
write 01_free_fall
equal 03_damping

# A method of the learner's own comes first then, and the loop stays beside it.
method="$BOUNCE_MINE/02_spring_floor/mine_method.hpp"
cmake -DBASE="$top/stages/02_spring_floor/own_method/my_method.hpp" -DPIECES="$top/tests/mistakes/right_loops/velocity_verlet.hpp" \
  -DOUT="$method" -P "$top/tests/checks/splice.cmake"
verlet() { own 02_spring_floor --method velocity-verlet; }
write 02_spring_floor "$half"
! cmp -s <(mine 02_spring_floor) <(verlet) || fails "with your method your force does not act"
says "your force, your method"
filled your method
says "method=mine"
rm "$BOUNCE_MINE/02_spring_floor/mine.hpp"
cmp -s <(mine 02_spring_floor) <(verlet) || fails "your velocity Verlet is another one"
says "the course's force, your method"
says "force_evaluations=2001" # counted: one more than steps
cmp -s <(mine 02_spring_floor --method my-loop) <(own 02_spring_floor) || fails "my-loop is not your loop of stage 1"
rm "$method"

write 05_ball_collision
equal 05_ball_collision --set scene=drop --set count=300
write 05_ball_collision 's/return contact.force(meeting.overlap/return 0 * contact.force(meeting.overlap/'
differ 05_ball_collision
differ 05_ball_collision --set scene=drop --set count=300
filled 05_ball_collision

write 06_oscillating_floor 's/return v - floor_speed(t);/return v;/'; differ 06_oscillating_floor; filled 06_oscillating_floor
write 07_tilted_plane 's/force += push \* n;/force -= push * n;/'; differ 07_tilted_plane; filled 07_tilted_plane

# Stage 8 flies by formula and sees the racket at rest; on a learner's lines it does neither, so that these
# are compared with the right lines there.
eight=(--player none --set "racket_velocity=0.1,0.3,0")
beside=("${eight[@]}" --set "position=0.45,1,0") # it misses a disc of the right size
game=(--player autopilot)
write 08_racket_game
right=$(mine 08_racket_game "${eight[@]}") right_beside=$(mine 08_racket_game "${beside[@]}") right_game=$(mine 08_racket_game "${game[@]}")
[ "$(wc -l <<<"$right")" -gt 10 ] && [ "$(wc -l <<<"$right_game")" -gt 10 ] || fails "stage 8 does not run"
wrong_eight() { # wrong_eight SED
  write 08_racket_game "$1"
  [ "$(mine 08_racket_game "${eight[@]}")" != "$right" ] || fails "stage 8, $1: the planted difference does not show"
}
write 08_racket_game 's/lateral < racket.radius/lateral < 2 * racket.radius/'
[ "$(mine 08_racket_game "${beside[@]}")" != "$right_beside" ] || fails "stage 8: a disc twice as large changes nothing"
wrong_eight 's/const Disc racket = disc_at(t);/const Disc racket = disc;/'
wrong_eight 's/state.velocity - racket.velocity_of(point)/state.velocity/'
wrong_eight 's/(0, -mass \* gravity, 0)/(0, -mass * gravity * 0.1, 0)/'
[ "$(mine 08_racket_game "${game[@]}")" != "$right_game" ] || fails "stage 8: gravity changes nothing in the game"
filled 08_racket_game

[ "$failures" -eq 0 ] && echo "your lines, and nothing else"
exit "$((failures > 0))"
