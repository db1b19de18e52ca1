# completion.bash - completion of de1sim's command line; what it offers is what --help says

_de1sim() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=run choices=
    case ${COMP_WORDS[1]} in
        run | test | live | build | check | link | check-board | compare | merge) command=${COMP_WORDS[1]} ;;
    esac
    COMPREPLY=()
    # "--cpu TEXT:{auto,native,arm}=auto"
    if [[ $before == --* ]]; then
        choices=$("$1" "$command" --help 2> /dev/null |
            sed -n "s/^ *$before [A-Z]*:{\([^}]*\)}.*/\1/p" | tr , ' ')
    fi
    if [[ $before == --frames ]]; then
        choices="new all every: last none"
    fi
    if [[ $choices ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
    elif [[ $word == -* ]]; then
        choices=$("$1" "$command" --help 2> /dev/null | grep -o -E '^ +(-h,)?--[a-z-]+' |
            sed 's/^ *\(-h,\)\?//')
        mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
    elif [[ $COMP_CWORD -eq 1 ]]; then
        mapfile -t COMPREPLY < <(compgen -W "run test live build check link check-board compare merge" -- "$word"; compgen -f -- "$word")
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _de1sim de1sim
