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
