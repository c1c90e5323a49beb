#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A failing seed is shortened and written as a scene that compiles. The seed fails because no pixel may differ.
# Usage: source_test.sh path/to/random_test compiler top-of-the-checkout folder-for-the-results
set -euo pipefail
program=$1 compiler=$2 source=$3 folder=$4
rm -rf "$folder"
mkdir -p "$folder"
CLEARPIPE_OUTPUT=$folder "$program" --seeds 0-31 --limit 0 >"$folder/log" && { echo "no seed fails without a limit"; exit 1; }
found=$(find "$folder" -name 'seed_*.cpp' | sort)
[ -n "$found" ] || { cat "$folder/log"; echo "no scene was written"; exit 1; }
for file in $found; do
  grep -q '^SCENE(random, seed_[0-9]*, ' "$file"
  "$compiler" -std=c++20 -Wall -Werror -fsyntax-only -I "$source" "$file"
  echo "$(grep -c '^  gl\.' "$file") commands are left in $(basename "$file")"
done
