#!/bin/sh
# Fetches packages by name and lays their shaders out in folders: fetch.sh FOLDER NAME...
# Nothing says here where packages come from: that is what npm and apt are configured for.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
mkdir -p "$1"
cd "$1"
shift

npm_package() {
    archive=$(npm pack --silent "$1" | tail -n 1)
    rm -rf package && tar -xzf "$archive"
}

for name; do
    [ ! -d "$name" ] || continue
    rm -rf "$name.new"
    mkdir "$name.new"
    case $name in
    three)
        npm_package three
        node "$here/three_programs.mjs" package "$name.new"
        ;;
    gl-transitions)
        npm_package gl-transitions
        node "$here/transitions.mjs" package "$here/hosts" "$name.new"
        ;;
    piglit)
        apt-get download piglit
        dpkg-deb -x piglit_*.deb package.piglit
        tests=$(dirname "$(find package.piglit -name generated_tests -print -quit)")
        target=$PWD/$name.new
        (cd "$tests" && find . -type f \( -name '*.vert' -o -name '*.frag' -o -name '*.shader_test' \) \
            -exec cp --parents -t "$target" {} +)
        # A shader that includes another by ARB_shading_language_include is not whole.
        grep -rl --include='*.shader_test' '^\[shader include\]' "$target" | xargs -r rm
        find "$target" -name '*.shader_test' -exec awk -f "$here/sections.awk" {} +
        find "$target" -name '*.shader_test' -delete
        ;;
    esac
    mv "$name.new" "$name"
done
