# Completion of quadrille's programs in bash: the program itself says how its line may go on.
_quadrille() {
  local IFS=$'\n'
  COMPREPLY=($(QUADRILLE_DESCRIBE=complete "${COMP_WORDS[@]:0:COMP_CWORD+1}" 2>/dev/null | cut -f 1))
}
# Where it has nothing to say, files may follow.
complete -o bashdefault -o default -F _quadrille quadrille quadrille-detector quadrille-grasp-planner
