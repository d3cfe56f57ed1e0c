# completes.sh SCRIPT LINE: what bash offers for the last word of the line, by that script of completion.
source "$1"
read -ra COMP_WORDS <<< "$2"
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_cleft
echo "${COMPREPLY[*]}"
