# versions.sh - third part of board.sh: versions in /opt/de1sim/versions, and from one to the next
#
# A version is a folder named by the first 12 digits of the SHA-256 of its SHA256SUMS.  `current` is
# a link to one of them; the file `previous` in a folder names the version that ran before it.

current() {
    id=$(readlink "$opt/current") && echo "${id##*/}"
}

# previous ID: what ran before it, if it is still there
previous() {
    before=$(cat "$opt/versions/$1/previous" 2>/dev/null) && [ -n "$before" ] &&
        [ -d "$opt/versions/$before" ] && echo "$before"
}

# is_whole FOLDER ID: every file is what it was when the version was made
is_whole() {
    [ -f "$1/SHA256SUMS" ] && [ "$(sha256sum <"$1/SHA256SUMS" | cut -c1-12)" = "$2" ] &&
        (cd "$1" && sha256sum -c SHA256SUMS >/dev/null 2>&1)
}

# receive ID: a tar on stdin becomes the version, if its sums are right
receive() {
    folder=$opt/versions/$1
    part=$folder.part.$$
    mkdir -p "$part" || die "cannot write to $opt"
    trap 'rm -rf "$part"; exit 1' HUP INT PIPE TERM
    tar -C "$part" -xf - || {
        rm -rf "$part"
        die "not all has arrived (no space, or the connection was cut); nothing was changed"
    }
    is_whole "$part" "$1" || {
        rm -rf "$part"
        die "a checksum is wrong: what arrived is not what was sent; nothing was changed"
    }
    sync
    [ ! -e "$folder" ] || mv "$folder" "$folder.part.broken.$$"
    mv "$part" "$folder" || die "cannot write to $opt"
    say "version $1 arrived whole"
}

# One deployment at a time; the lock ends with its process.
lock() {
    mkdir -p "$run" || die "cannot write to $run"
    exec 9>"$run/lock"
    tries=0
    until flock -n 9; do
        [ $tries -gt 0 ] || say "another deployment is at work: waiting"
        tries=$((tries + 1))
        [ $tries -le 60 ] || die "another deployment is still at work after 60 s"
        sleep 1
    done
}

# switch ID [BEFORE]: changes the board's version, atomically
switch() {
    if [ -n "${2:-}" ]; then
        echo "$2" >"$opt/versions/$1/previous" || return 1
    fi
    sync
    point "$opt/current" "versions/$1" || return 1
    sync
}

# All versions but these two, and what was left half copied.
prune() {
    for folder in "$opt/versions"/*; do
        case ${folder##*/} in "$1" | "${2:-$1}") ;; *) rm -rf "$folder" ;; esac
    done
}

# activate ID service|foreground: returns with ID running, or with the version before and an error.
# Goes on to its end when the connection is cut.
activate() {
    trap '' HUP INT PIPE TERM
    lock
    old=$(current) || old=
    is_whole "$opt/versions/$1" "$1" ||
        die "version $1 is not there whole; nothing was changed"
    before=$old
    [ "$old" != "$1" ] || before=$(previous "$1") || before=
    say "stops the program"
    stop || die "the program does not stop; nothing was changed"
    if load "$1" && say "switches to $1" && switch "$1" "$before"; then
        if [ "$2" = foreground ] || ! has_systemd; then
            prune "$1" "$before"
            say "version $1 is loaded"
            return 0
        fi
        if start; then
            prune "$1" "$before"
            say "version $1 runs"
            return 0
        fi
        say "the program does not run"
    fi
    go_back "$1" "$before"
}

go_back() {
    [ -n "$2" ] || die "version $1 failed, and there was none before it"
    say "version $1 failed: back to $2"
    if ! switch "$2" || ! load "$2"; then
        die "version $2 cannot be loaded either: look at the board"
    fi
    if has_systemd; then
        start || die "version $2 is loaded, but its program does not run: look at the board"
        die "version $1 failed; version $2 runs again"
    fi
    die "version $1 failed; version $2 is loaded again, its program is yours to start"
}

rollback() {
    old=$(current) || die "no version is installed: nothing to go back from"
    back=$(previous "$old") || die "there is no version before $old: nothing was changed"
    activate "$back" "$1"
}
