#!/bin/sh
# Lists the sources that clang-format would change; fails if there are any. `--fix` rewrites them.
set -eu
cd "$(dirname "$0")/.."
files=$(git ls-files --cached --others --exclude-standard '*.cpp' '*.h')
[ -n "$files" ] || { echo "check_format: git lists no sources here"; exit 2; }
if [ "${1:-}" = "--fix" ]; then
    echo "$files" | xargs clang-format -i
else
    echo "$files" | xargs clang-format --dry-run --Werror
fi
