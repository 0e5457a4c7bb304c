#!/bin/sh
# Makes the pictures of the lessons anew, from the programs of the release build.
set -e
cd "$(dirname "$0")"
bin=../../build/release/bin
$bin/01_free_fall --screenshot 01_free_fall.png --dt 0.1 --duration 0.9
$bin/02_spring_floor --screenshot 02_spring_floor.png --set stiffness=2000 --duration 2.34
$bin/02_spring_floor --screenshot 02_explicit_euler.png --method explicit-euler --duration 2.8
$bin/03_damping --screenshot 03_damping.png --set damping=18 --duration 2.2
$bin/03_damping --screenshot 03_pull.png --set damping=43 --dt 0.0001 --duration 0.458
$bin/04_three_dimensions --screenshot 04_three_dimensions.png --duration 2.05
$bin/05_ball_collision --screenshot 05_ball_collision.png --set scene=break --duration 1.3
$bin/05_ball_collision --screenshot 05_tower.png --set scene=tower --set gap=0.1 --duration 1.53
$bin/05_ball_collision --screenshot 05_drop.png --set scene=drop --set count=1000 --duration 0.62
$bin/07_tilted_plane --screenshot 07_tilted_plane.png --duration 2.95 --method exact --set damping=0 --set stiffness=1e6
# 04_from_above.png is taken in the window: T for the view from above, at about 2.2 s F12.
$bin/06_oscillating_floor --screenshot 06_oscillating_floor.png --dt 0.0001 --duration 9.2
$bin/06_oscillating_floor --screenshot 06_switch.png --set floor_law=fixed-switch --dt 0.0001 --duration 0.385
$bin/06_oscillating_floor --screenshot 06_bifurcation.png --sweep amplitude=0.05,0.09,800 \
  --set contact=push-only --set angular_frequency=12.566370614359172
