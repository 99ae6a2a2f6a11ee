#!/bin/sh
# Runs clang-tidy, with the checks of .clang-tidy, on the sources that differ from a commit (default: origin/main), such
# as `scripts/check_tidy.sh HEAD~3`. It takes about twenty seconds per source, so it checks changed sources only.
set -eu
cd "$(dirname "$0")/.."
command -v clang-tidy > /dev/null || { echo "check_tidy: clang-tidy is missing (Debian: clang-tidy)" >&2; exit 1; }
since=${1:-origin/main}
sources=$(git diff --name-only --diff-filter=d "$since" -- 'src/*.cpp' 'apps/*.cpp' 'tests/*.cpp' 'bench/*.cpp')
[ -n "$sources" ] || { echo "check_tidy: no source differs from $since"; exit 0; }
# The dev preset compiles each source alone, as clang-tidy needs it.
cmake --preset dev -Wno-dev > /dev/null
echo "$sources" | xargs -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet
