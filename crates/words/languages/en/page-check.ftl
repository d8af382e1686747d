# A program that was run.
check-title = Check of the program { $program }
check-made = Made of what the plan requires
check-trace = Motions: line, block, motion, machine position in mm
check-times = Time, min
check-times-of = { $total } (feed { $feed }, rapid { $rapid }, dwell { $dwell }, tool change { $change })
# The knowledge base that was checked.
lint-title = Check of the knowledge base
lint-documentation = Columns and rows for readers only
lint-summary = { $tables }, { $rows }, { $findings }
