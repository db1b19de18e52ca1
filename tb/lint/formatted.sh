#!/bin/sh
# formatted.sh - whether clang-format 14 would leave all C++ as it is; other releases lay out
# otherwise.  To be started in the project's folder.  Exit code 77: it is another release.
if ! clang-format --version | grep -q ' 14[.]'; then
    echo 'clang-format is not of release 14'
    exit 77
fi
find sw sim tb rtl -name .de1sim -prune -o '(' -name '*.h' -o -name '*.cpp' ')' -print0 |
    xargs -0 clang-format --dry-run -Werror
