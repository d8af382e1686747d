# Why a program is not compared with its plan.
audit-program-not-run = the program was not compared with the plan: a program with an error in its text is not run; fix it first
audit-program-no-route = the program was not compared with the plan: the plan states no route (`route`)
audit-program-row-hole = the program was not compared with the plan: row { $row } names no group of holes (`hole`)
audit-program-row-tool = the program was not compared with the plan: row { $row } ({ $operation }) names no tool (`tool`); if it is done on another machine, write `elsewhere: true`
audit-program-row-diameter = the program was not compared with the plan: row { $row } ({ $operation }) has no diameter (`diameter`)
audit-program-row-depth = the program was not compared with the plan: row { $row } ({ $operation }) has no depth (`depth`)
audit-program-row-thread = the program was not compared with the plan: row { $row } taps a hole that has no thread on the drawing
audit-program-row-mill = the program was not compared with the plan: row { $row } ({ $operation }) does not say from what diameter (`from`) and with which mill
audit-program-row-conditions = the program was not compared with the plan: row { $row } ({ $operation }) has no conditions (`rpm` and `feed` or `minute_feed`)
audit-setting-correction = the setting has H{ $corrector } = { $value }, and by the plan the correction of T{ $tool } is { $needed }
audit-program-derived = the program does not say what these tools are; by their motions they are taken as: { $tools }
    .help = name each tool in a comment beside its change, or give a list of tools: `--tools tools.csv`
audit-program-untold = { $tools }: neither the program nor a list says what it is, and its motion may be several things: its holes and their route cannot be checked
    .help = name each tool in a comment beside its change, or give a list of tools: `--tools tools.csv`
audit-program-unsized = { $tools }: neither a diameter nor a designation is told: size, reach and speed of the tool cannot be checked
    .help = name the diameter in a comment beside the tool change, or give a list of tools: `--tools tools.csv`
audit-program-elsewhere = at { $count } points where the drawing has no hole the program goes down, too: what it makes there cannot be checked
audit-program-shifted = the zero of the program is another than the drawing's: X{ $x } Y{ $y } Z{ $z } was added to its coordinates
audit-program-not-compared = depths, heights and points of the program were not held against the drawing: not every cut is known
audit-program-without-part = no part is named: designations, arithmetic and the order of each hole were judged; sizes, depths, feeds and speeds were not
    .help = name the part: `--part PART.yaml`
audit-program-no-holes = no hole of this program could be read
audit-program-no-holes-help = see what the control says of it: `technolog check`
audit-program-pace = { $speed } m/min is { $share } % of the speed that a tool of high-speed steel has here
    .help = say in the comment or the list what tool it is; with a tool of high-speed steel take S { $rpm }
audit-program-nowhere = none of the { $count } points at which the program goes down is a hole of the drawing: nothing of it can be checked
    .help = name the part of this program, and the zero that it counts from
