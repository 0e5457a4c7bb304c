#!/bin/sh
# Makes all pictures and clips of the pages anew, from the programs of the release build. Needs ffmpeg
# and gnuplot. They are cropped to what the text speaks of: look at each.
set -e
cd "$(dirname "$0")"
bin=../../build/release/bin
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture FILE.png FILTER PROGRAM [OPTIONS]: the window, cut by the filter, with colours in a palette
picture() {
  file=$1 filter=$2 program=$3
  shift 3
  "$bin/$program" --screenshot "$work/window.png" "$@"
  ffmpeg -loglevel error -y -i "$work/window.png" \
    -filter_complex "[0]${filter},split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none" "$file"
}
scene=crop=748:540:0:0
side=crop=580:508:16:10 # without what is still to come
energy='split[s][e];[s]crop=580:532:16:4[s];[e]crop=92:532:750:4[e];[s][e]hstack'
plot="split[w][p];[w]${energy}[w];[p]crop=420:178:420:540,pad=672:178:126:0:0xfafaf7[p];[w][p]vstack"

picture 01_free_fall.png "$side" 01_free_fall --dt 0.1 --duration 0.9
picture 02_spring_floor.png "$energy" 02_spring_floor --set stiffness=2000 --dt 0.0001 --duration 0.45
picture 02_explicit_euler.png "$energy" 02_spring_floor --method explicit-euler --duration 2.8
picture 03_damping.png "$plot" 03_damping --set damping=18 --dt 0.0001 --duration 2.2
picture 03_pull.png "$energy" 03_damping --set damping=43 --dt 0.0001 --duration 0.458
picture 04_three_dimensions.png "$scene" 04_three_dimensions --duration 2.05
picture 04_from_above.png "$scene" 04_three_dimensions --duration 2.05 --from-above
picture 05_ball_collision.png "$scene" 05_ball_collision --set scene=break --duration 0.95
picture 05_tower.png "$scene" 05_ball_collision --set scene=tower --set gap=0.1 --duration 1.53
picture 05_drop.png "$scene" 05_ball_collision --set scene=drop --set count=1000 --duration 0.62
picture 06_oscillating_floor.png "$energy" 06_oscillating_floor --method exact --duration 26.1
picture 06_switch.png "$energy" 06_oscillating_floor --set floor_law=fixed-switch --dt 0.0001 --duration 0.385
picture 07_first_hop.png "$scene" 07_tilted_plane --duration 0.95 --method exact \
  --set damping=0 --set stiffness=1e6
picture 07_tilted_plane.png "$scene" 07_tilted_plane --duration 2.95 --method exact \
  --set damping=0 --set stiffness=1e6
picture 06_bifurcation.png null 06_oscillating_floor --sweep amplitude=0.05,0.09,800 \
  --set contact=push-only --set angular_frequency=12.566370614359172

# Recorded inputs: a hand (a program moved it) that sends the ball from side to side.
"$bin/08_racket_game" --replay 08_racket_game.txt --duration 7.2 --record "$work/clip.gif"
ffmpeg -loglevel error -y -i "$work/clip.gif" -vf "fps=10,crop=570:510:282:0,scale=500:-1:flags=area,
  split[a][b];[a]palettegen=max_colors=32:stats_mode=diff[p];
  [b][p]paletteuse=dither=none:diff_mode=rectangle" 08_racket_game.gif

# The figures, from the numbers that are kept beside the pages, and from runs
"$bin/speed_vs_error" figures
"$bin/many_balls_speed" figure
"$bin/stability_map"
"$bin/hard_case_pictures"
