#!/usr/bin/env bash
# Compares whole runs, for docs/beyond_one_machine.md: this program on 1 and 2 threads against LAMMPS on 1
# and 2 processes, from the same states; and measures what the files cost. Needs lmp and mpirun (Debian: lammps,
# openmpi-bin), a quiet machine, and a minute or two.
set -euo pipefail
program=$(realpath "${1:-build/release/bin/05_ball_collision}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
law=(--method velocity-verlet --dt 1e-4 --set scene=drop --set stiffness=1e5 --set floor_stiffness=1e5
  --set damping=100 --set floor_damping=100)

seconds() { # seconds COMMAND...: on the clock
  local begin=$EPOCHREALTIME
  "$@" >/dev/null 2>log || { cat log >&2; return 1; }
  awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.2f", b - a }'
}
size() { awk -v bytes="$(stat -c %s "$1")" 'BEGIN { printf "%.1f MB", bytes / 1e6 }'; }

compare() { # compare COUNT DROPPED_S STEPS REPEATS
  local count=$1 end n ns
  "$program" "${law[@]}" --threads 2 --set count="$count" --headless --duration "$2" --save state 2>log
  end=$(awk -v t="$2" -v n="$3" 'BEGIN { print t + n * 1e-4 }')
  "$program" --load state --duration "$end" --export-lammps "lammps_$count" 2>log
  for _ in $(seq "$4"); do
    for n in 1 2; do
      "$program" --load state --threads "$n" --headless --duration "$end" 2>log
      ns=$(sed -n 's/.*ns_per_step_and_ball=\([^ ]*\).*/\1/p' log)
      echo "$count balls, this program, $n threads: $ns ns a ball and step"
      (cd "lammps_$count" && mpirun -np "$n" lmp -in in.bounce >log 2>&1)
      awk -v n="$n" -v count="$count" -v steps="$3" '/^Loop time of/ {
        printf "%s balls, LAMMPS, %d processes: %.4g ns a ball and step\n", count, n, $4 / count / steps * 1e9 }
        /^Per MPI rank memory/ { memory = $(NF - 1) }
        END { printf "   (LAMMPS says that each process holds %s MB)\n", memory }' "lammps_$count/log"
    done
  done
}

compare 10000 1.5 1000 3
compare 100000 0.5 200 2
echo "lammps_100000/balls.data $(size lammps_100000/balls.data), balls.dump $(size lammps_100000/balls.dump)"
one=(--method velocity-verlet --dt 1e-4 --set scene=drop --headless)
echo "1e5: a step from the scene $(seconds "$program" "${one[@]}" --set count=1e5 --duration 1e-4) s," \
  "from a dump $(seconds "$program" "${one[@]}" --set count=1e5 --duration 0.5201 \
    --import-lammps lammps_100000/balls.dump) s"
million=("${one[@]}" --set count=1e6 --duration 1e-4)
echo "1e6: a step $(seconds "$program" "${million[@]}") s, and saved $(seconds "$program" "${million[@]}" \
  --save state) s, $(size state)"
echo "1e6: loaded, and a step $(seconds "$program" --load state --headless --duration 2e-4) s;" \
  "loaded and exported $(seconds "$program" --load state --duration 2e-4 --export-lammps big) s," \
  "$(size big/balls.data)"
