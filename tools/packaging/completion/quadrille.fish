# Completion of quadrille's programs in fish: the program itself says how its line may go on.
function __quadrille_complete
    set -lx QUADRILLE_DESCRIBE complete
    set -l words (commandline -opc) (commandline -ct)
    $words 2>/dev/null
end
for program in quadrille quadrille-detector quadrille-grasp-planner
    complete -c $program -a '(__quadrille_complete)'
end
