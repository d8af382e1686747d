no-lathe-to-compare = no lathe is named: there is nothing to compare the accuracy and roughness of the surfaces with
no-grade-to-compare = { $surface }: neither grade nor roughness is given, so it cannot be compared with what the lathe reaches
finished-elsewhere = { $surface }: the lathe does not hold its accuracy or roughness; the later operation is { $operation }
finished-elsewhere-unknown = { $surface }: the lathe does not hold its accuracy or roughness, and what finishes it is not known; no intermediate allowance is left
elsewhere-allowance = { $surface }: intermediate allowance { $allowance } mm on one side
no-allowance-for-elsewhere = { $surface }: the table has no allowance of this size for the later operation; none is left
finishing-allowance = finishing allowance by the table ({ $place }): { $allowance } mm on one side
analytic-allowance = finishing allowance by the errors ({ $place }): { $allowance } mm on one side
no-finishing-allowance = { $surface }: there is no finishing allowance in the table or the file; state it (`allowance`)
# Why there is no equidistant.
equidistant-empty = the contour has no pieces; give it at least one
equidistant-count = the contour has { $pieces } pieces and { $distances } distances; give one distance for each piece
equidistant-broken = the contour is broken: each piece must begin where the one before it ends
equidistant-leads-back = the contour leads back towards the free end; bridge what is undercut before adding allowances
equidistant-negative = the distance of piece { $piece } is negative; an allowance is at least 0
equidistant-vanished = nothing is left of the contour at this distance; it is larger than the radii of its hollow arcs
equidistant-not-joined = the strips over the contour did not join into one outline; report the contour, it is a defect of the program
