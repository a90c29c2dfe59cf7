#!/bin/sh
# Formatter and lint, as .ci/run wants them: clang-format-19 over every C++ file of src and tests, clang-tidy-19
# (.clang-tidy) over the Qt-free modules. Prints what is wrong and exits with 1; changes no file.
#   cmake/check-format.sh           both
#   cmake/check-format.sh --fix     formats in place instead of checking, no lint
set -eu
cd "$(dirname "$0")/.."

# The architecture test's bad tree is wrong on purpose.
sources() { find src tests \( -name '*.h' -o -name '*.cpp' \) -not -path '*/fixtures/*' -print0; }

if [ "${1:-}" = --fix ]; then
    sources | xargs -0 clang-format-19 -i
    exit 0
fi

failed=0
sources | xargs -0 clang-format-19 --dry-run --Werror || failed=1

# A compile database of its own: no Qt, no tests, and clang's own view of the flags. In batches: reading the headers
# of each source anew takes most of the time. What is found in a source of a batch is told with its own place.
build=build/lint
mkdir -p build
cmake -S . -B "$build" -G Ninja -DAGV_CORE_ONLY=ON -DAGV_TESTS=OFF -DAGV_UNITY=ON -DCMAKE_CXX_COMPILER=clang++-19 \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$build.log" 2>&1 || {
    cat "$build.log" >&2
    exit 1
}
# Without the path-sensitive analyzer, which takes three quarters of the time: the sanitizers and fuzzers look there.
# The files of the batches include sources on purpose.
if ! run-clang-tidy-19 -p "$build" -quiet -j2 -checks='-clang-analyzer-*,-bugprone-suspicious-include' >"$build/clang-tidy.log" 2>&1; then
    grep -E '(warning|error):|^ +[0-9]+ \||note:' "$build/clang-tidy.log" >&2 || cat "$build/clang-tidy.log" >&2
    failed=1
fi

[ "$failed" = 0 ] || {
    echo "cmake/check-format.sh: see above; cmake/check-format.sh --fix formats." >&2
    exit 1
}
echo "formatter and clang-tidy: clean"
