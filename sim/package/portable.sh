#!/usr/bin/env bash
# portable.sh BUILD - BUILD/package/de1sim-VERSION-linux-ARCH.tar.xz, which runs on every Linux
# whose glibc is not older than this machine's.
#
# In it are what `cmake --install` installs and the libraries that this needs, with their licences,
# found from the program's own place; not glibc and GCC's libraries, which are on every machine.
set -euo pipefail
build=$(realpath "$1")
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=de1sim-$version-linux-$(uname -m)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/$name" --strip > "$work/log" ||
    { cat "$work/log"; exit 1; }
cd "$work/$name"
licences=share/doc/de1sim/licences
mkdir -p $licences
ldd bin/* lib/de1sim/*.so* | awk '$2 == "=>" && $3 ~ "^/" {print $3}' | sort -u |
    while read -r library; do
        [[ $library == "$PWD"/* ]] && continue
        case ${library##*/} in
            libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | libresolv.so.*) ;;
            libstdc++.so.* | libgcc_s.so.* | ld-linux*) ;;
            *)
                cp "$library" lib/de1sim/
                patchelf --remove-rpath "lib/de1sim/${library##*/}"  # LLVM's would count alone
                package=$(dpkg -S "*/$(basename "$(realpath "$library")")" | sed 's/:.*//;q')
                cp "/usr/share/doc/$package/copyright" "$licences/$package"
                ;;
        esac
    done
cd ..
mkdir -p "$build/package"
XZ_OPT=-T0 tar --sort=name --owner=0 --group=0 --numeric-owner -cJf "$name.tar.xz" "$name"
mv "$name.tar.xz" "$build/package/"
echo "$build/package/$name.tar.xz"
