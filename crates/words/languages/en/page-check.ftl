# A program that was run.
check-title = Check of the program { $program }
check-made = What the plan requires, and what the program makes of it
check-not-compared = the program was not compared with the part: a program with an error in its text is not run
check-mend-first = fix the errors above, then check again
check-trace = Motions: line, block, motion, machine position in mm
trace-rapid = rapid
trace-feed = feed
trace-arc-cw = arc-cw
trace-arc-ccw = arc-ccw
trace-dwell = dwell
trace-spindle = spindle
trace-coolant = coolant
trace-tool = tool
trace-length = length
trace-radius = radius
trace-machine = machine
trace-stop = stop
trace-end = end
trace-centre = centre
trace-turns = turns
trace-s = s
trace-stopped = stopped
trace-clockwise = clockwise
trace-counterclockwise = counterclockwise
trace-on = on
trace-off = off
trace-left = left
trace-right = right
trace-min = min
trace-lead = lead
trace-away = away
trace-thread = thread
trace-optional = optional
check-errors = { $count } { $count ->
        [one] error
       *[other] errors
    }
check-warnings = { $count } { $count ->
        [one] warning
       *[other] warnings
    }
check-notes = { $count } { $count ->
        [one] note
       *[other] notes
    }
check-times = Time, min
check-times-of = { $total } (feed { $feed }, rapid { $rapid }, dwell { $dwell }, tool change { $change })
check-times-alone = feed { $feed }, dwell { $dwell }; rapids and tool changes are not counted: name a machine with --machine
check-machine-assumed = no machine is named: { $machine } is taken, on which the language of { $control } is described; its limits are not checked
check-name-machine = name the machine with --machine, this one or another: then its limits are checked
check-lathe-times = feed { $feed }, dwell { $dwell }; rapids and tool changes are not counted: name a lathe with --machine
check-lathe-times-of = { $total } (feed { $feed }, rapid { $rapid }, dwell { $dwell }); tool changes and { $left } rapids of unknown length are not counted
check-lathe-trace = Motions: line, motion, position (diameter, Z) in mm
# The knowledge base that was checked.
lint-title = Check of the knowledge base
lint-documentation = Columns and rows for readers only
lint-summary = { $tables }, { $rows }, { $findings }
