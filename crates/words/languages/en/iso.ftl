unknown-word = the word { $word } is not run here
    .help = `technolog table iso-addresses`, `iso-g-functions` and `iso-m-functions` list the words that are run
not-carried-out = { $word } is not carried out here{ $count ->
        [one] {""}
       *[other] {" "}({ $count } places)
    }: what it changes is missing in the motions shown
    .help = prove that part of the program by other means; the rest is traced: `technolog table iso-not-carried-out`
passed-over = { $word } changes no motion and is passed over{ $count ->
        [one] {""}
       *[other] {" "}({ $count } places)
    }
    .help = nothing need be done
macro-not-run = macros are not run here: `{ $word }` decides which blocks are run{ $count ->
        [one] {""}
       *[other] {" "}({ $count } such words)
    }
    .help = prove the program by the control's own graphics, or write it out without branches and loops
number-too-long = the number of { $address } has more than six places after the decimal point
    .help = round the number
number-without-point = the number of { $address } has no point: taken as millimetres (calculator-type input)
    .help = write the point: X10.
point-missing = the number of { $address } has no point, and other lengths of the program have one: it may count micrometres
    .help = write the point, or say in the setting what it counts: decimal: calculator
comment-open = the comment is not closed
    .help = write the )
active-comment = the comment { $word } is run: it writes a file, runs Python or ends the program
    .help = take it out, or find out what it does: `technolog table iso-active-comments`
message-comment = the comment { $word } is run: it shows a message
    .help = nothing need be done where the message is meant
group-exclusive = { $first } and { $second } of one group in one block
    .help = split it into two blocks or keep one of them
branch-unknown = the run ends here: what `{ $word }` decides depends on a value that only the control knows
    .help = give the parameter a value in the program, or prove what follows by other means
modes-not-kept = M72 where no modes are kept
    .help = write M70 before it in the same subprogram
polar-plane = polar words outside the plane G17
    .help = write G17 before them, or X, Y and Z
sub-without-pair = the o-word stands without the one it belongs to
    .help = end o… sub with o… endsub, o… if with o… endif, o… while with o… endwhile, o… do with o… while, o… repeat with o… endrepeat, of the same name and in the same subprogram
call-without-number = M98 without a number P
    .help = give P
motion-missing = there is a dimension and no function of motion for it
    .help = give G0, G1, G2 or G3; with G53 G0 or G1
machine-position-with-g91 = G53 while G91 acts
    .help = give G90 before it
axes-missing = { $function } names no axis
    .help = name the axes, as in G91 G28 Z0
axes-taken-twice = { $first } and { $second } both take the axes of the block
    .help = split it into two blocks
dwell-time-missing = G4 without a time: { $words }
    .help = give the time
corrector-missing = G43 without H
    .help = give H
arc-radius-alone = the radius R makes no arc: its end is its start, or R is 0
    .help = give a full circle by I, J, K
arc-radius-short = the radius { $radius } mm does not reach the end of the arc: at least { $needed } mm are needed
    .help = check end and radius
cycle-levels = the bottom of the cycle Z{ $z } is above its plane R{ $r }
    .help = give a Z below R
cycle-plane = a fixed cycle outside the plane G17
    .help = give G17 before the cycle
tap-without-spindle = tapping with the spindle stopped
    .help = start it with S and M3 before the cycle
tap-counterclockwise = tapping while the spindle turns counterclockwise
    .help = give M3
too-many-blocks = the program has more than { $most } blocks: it is not run
    .help = put what repeats into subprograms, or make several programs of it
change-turning = the tool is changed by hand at this stop while the spindle turns
    .help = give M5 before it
offset-of-no-tool = the length offset { $value } mm is that of no tool
    .help = write the measured offset of the tool that is in the spindle, as the offset registers of the setting have it
arc-without-end = an arc that names no axis of its plane
    .help = give the end of the arc, of a full circle too
change-stops-spindle = the spindle turns until M6, which stops it
    .help = nothing need be changed; M5 before it says the same
offset-of-tool-before = T{ $tool } cuts with the length offset { $value } mm that was set for the tool before
    .help = give the offset of this tool
tap-not-rigid = a tapping cycle without { $word } before it: the spindle does not follow the feed
    .help = give { $word } with S before the cycle, or use a chuck that lets the tap float
machine-not-named = no machine is named: travels, speeds, feeds, places of the magazine and of the change, and tapping are not checked
    .help = name one with --machine (`technolog table` lists them as machine-…)
traced-as-written = { $word } is not carried out here, at { $count } { $count ->
        [one] place
       *[other] places
    }: the ways are traced as they are written, the axes go beside them by the radius of the tool
    .help = look at the contour in the graphics of the control
shift-not-traced = the way of the bar off the wall before it goes out is not traced: the control is set to its direction
shift-missing = the bar goes out along the wall it has bored: nothing draws it off
    .help = give Q
shift-too-large = the bar is drawn off the wall by { $shift } mm, and its back meets the other wall
    .help = look whether Q is that of a drilling cycle before
rigid-without-tap = rigid tapping is prepared, and no tapping cycle comes
    .help = write G84, or take the preparation away
fixed-point-not-given = neither the second reference point is given nor the machine: its zero is shown in its place
    .help = give `fixed_point` in the setting, or name the machine with --machine
fixed-point-assumed = the second reference point is not given: that of the tool change, { $place }, is taken
    .help = give `fixed_point` in the setting
main-begins-anew = M99 in the main program begins it anew: it never ends by itself
    .help = give M30 where it is to end
peck-in-increments = Q without a point counts increments here: { $step } mm
    .help = write it with a point if the control takes one
feed-of-tool-before = no F since the tool change: that of the tool before acts
    .help = give F for this tool
speed-of-tool-before = no S since the tool change: that of the tool before acts
    .help = give S for this tool
