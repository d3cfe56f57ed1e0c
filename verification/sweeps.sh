#!/usr/bin/env bash
# Moves, turns and draws at random the cracks of verification/hard, and draws the reactions: verification/sweeps.sh [FOLDER]
# FOLDER (default results/sweeps) then holds a CSV file a sweep and the figure. CLEFT_RANDOM_CRACKS (default 1000) says how many
# are drawn, CLEFT_RANDOM_ENERGIES (default 200) of how many scenes the balance of energies is held against 16 times the increments.
source "$(dirname "${BASH_SOURCE[0]}")/../tools/setup.sh"
build test_verification

out=${1:-results/sweeps}
mkdir -p "$out"
export CLEFT_SWEEPS_TO=$out CLEFT_RANDOM_CRACKS=${CLEFT_RANDOM_CRACKS:-1000} CLEFT_RANDOM_ENERGIES=${CLEFT_RANDOM_ENERGIES:-200} TEST_TMPDIR=$PWD/build/release/tests/scratch
build/release/tests/test_verification --gtest_brief=1 --gtest_filter='*HardSweep*:*HardRandom*:EnergyAccount.IsFoundOpen*'
gnuplot -e "folder='$out'" verification/hard/sweeps.gp
say "the figure is $(realpath "$out")/sweeps.svg"
