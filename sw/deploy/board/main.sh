# main.sh - last part of board.sh: one command per call
#
# In a function, so that a truncated script does nothing.

main() {
    case ${1:-} in
    check) check "$2" "$3" "$4" ;;
    has) is_whole "$opt/versions/$2" "$2" ;;
    receive) receive "$2" ;;
    activate) activate "$2" "$3" </dev/null ;;
    rollback) rollback "$2" </dev/null ;;
    systemd) has_systemd ;;
    boot) boot </dev/null ;;
    foreground) foreground ;;
    *) die "board.sh: unknown command \"${1:-}\"" ;;
    esac
}

main "$@"
