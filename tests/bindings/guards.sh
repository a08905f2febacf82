#!/bin/sh
# The guards that SECURITY.md promises, looked for in a library and programs that were built: guards.sh [-t PREFIX-] [-d DEBUG_FOLDER] FILE ...
# PREFIX- is that of the binutils of another machine. With DEBUG_FOLDER each file must name a file of it that has its
# build id, names and lines, and have none of its own.
set -eu
tools=
debug=
while getopts t:d: option; do
    case $option in
    t) tools=$OPTARG ;;
    d) debug=$OPTARG ;;
    *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))
[ $# != 0 ] || { echo "usage: guards.sh [-t PREFIX-] [-d DEBUG_FOLDER] FILE ..." >&2; exit 2; }
failed=0
wrong() {
    echo "FAILED: $1" >&2
    failed=1
}
build_id() {
    "${tools}readelf" -nW "$1" | sed -n 's/.*Build ID: //p'
}

for file in "$@"; do
    name=$(basename "$file")
    dynamic=$("${tools}readelf" -dW "$file")
    segments=$("${tools}readelf" -lW "$file")
    # Names that the file takes from the C library and its loader.
    taken=$("${tools}readelf" -sW "$file" | awk '$7 == "UND" {print $8}')
    echo "$dynamic" | grep -qE '\((FLAGS|FLAGS_1)\).*NOW' || wrong "$name binds names late (no BIND_NOW)"
    echo "$segments" | grep -q GNU_RELRO || wrong "$name leaves its relocations writable (no RELRO)"
    echo "$segments" | grep GNU_STACK | grep -q RWE && wrong "$name has an executable stack"
    echo "$taken" | grep -q '^__stack_chk_fail' || wrong "$name has no stack protector"
    echo "$taken" | grep -q '_chk@' || wrong "$name calls nothing that FORTIFY_SOURCE checks"
    # Whole files are marked only where the C++ runtime is too, which Debian's is not; so each public function (each
    # function of a program) that jumps can reach must begin as CET or pointer authentication has it.
    machine=$("${tools}readelf" -hW "$file" | sed -n 's/ *Machine: *//p')
    case $machine in
    *X86-64*) landing='endbr64' ;;
    *AArch64*) landing='paciasp|bti' ;;
    *) landing= ;;
    esac
    if [ -n "$landing" ]; then
        starts=$("${tools}objdump" -d --no-show-raw-insn "$file" | grep -A1 '^[0-9a-f]* <\(mien_[a-z0-9_]*\|main\)>:$' |
            grep -vE '^--$|>:$' || true)
        count=$(echo "$starts" | grep -c . || true)
        bare=$(echo "$starts" | grep -vcE "$landing" || true)
        if [ "$count" = 0 ]; then
            # A stripped program: it is enough that it has landing places at all.
            "${tools}objdump" -d --no-show-raw-insn "$file" | grep -qE "$landing" || wrong "$name is compiled without CET or its like"
        elif [ "$machine" != AArch64 ]; then
            [ "$bare" = 0 ] || wrong "$name: $bare of $count public functions begin without $landing"
        else
            # Functions that call nothing keep no return address to sign.
            [ "$bare" -lt "$count" ] || wrong "$name signs no return addresses"
        fi
    fi
    if [ -n "$debug" ]; then
        link=$("${tools}readelf" --string-dump=.gnu_debuglink "$file" 2>/dev/null | sed -n 's/.*\] *//p' | head -1)
        if [ -z "$link" ] || [ ! -f "$debug/$link" ]; then
            wrong "$name does not lead to its debug file (${link:-none})"
        else
            [ "$(build_id "$file")" = "$(build_id "$debug/$link")" ] || wrong "$link is of another build than $name"
            sections=$("${tools}readelf" -SW "$debug/$link")
            echo "$sections" | grep -q '\.debug_line' || wrong "$link has no lines"
            echo "$sections" | grep -q '\.symtab' || wrong "$link has no names"
            "${tools}readelf" -SW "$file" | grep -q '\.debug_info' && wrong "$name was not stripped of its debug information"
        fi
    fi
    [ "$failed" = 1 ] || echo "$name: bound at load, RELRO, stack protector, FORTIFY, ${landing:-no landing marks}${debug:+, debug file}"
done
exit "$failed"
