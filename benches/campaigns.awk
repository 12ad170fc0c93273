# Table of campaigns from what `benches/measured.sh` has kept, one row each: awk -f campaigns.awk FILE...
function row() { if (words) print "| " words " | " dies " | " travel " | " stop " | " none " | " panic " | " iterations " | " penetration " | " balance " |" }
BEGIN {
    print "| options | dies | full travel | physical stop | no equilibrium | panic | iterations a step | penetration, t | error of the power balance |"
    print "|---|---|---|---|---|---|---|---|---|"
}
FNR == 1 { row(); words = "none"; if (match($0, /--(elastoplastic|sheets|work) 1/)) words = "`" substr($0, RSTART, RLENGTH) "`" }
/ random dies, seed / { dies = $1 }
/^full travel / { travel = $4 " %" }
/^physical stop / { stop = $4 " %" }
/^no equilibrium / { none = $4 " %" }
/^    [A-Z][A-Za-z]*: [0-9]+$/ { none = none ", " $1 " " $2 }
/^panic / { panic = $2 }
/^iterations a step / { iterations = sprintf("%.1f, %.1f", $4, $5) }
/^penetration over t / { penetration = sprintf("%.3f, %.3f", $4, $5) }
/^power balance error / { balance = $4 ", " $5 }
END { row() }
