#!/bin/sh
# Lists the sources that clang-format would change; fails if there are any. `--fix` rewrites them.
cd "$(dirname "$0")/.." || exit 2
files=$(git ls-files --cached --others --exclude-standard '*.cpp' '*.h')
if [ "$1" = "--fix" ]; then
    echo "$files" | xargs clang-format -i
else
    echo "$files" | xargs clang-format --dry-run --Werror
fi
