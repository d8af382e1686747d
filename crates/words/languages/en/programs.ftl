unknown-character = the language has no character `{ $letter }`
    .help = write the block without it: addresses are Latin capitals, numbers have `.` and `-`, lines end with LF or CR LF
cyrillic-letter = `{ $letter }` is a Cyrillic letter, not the Latin { $latin }
    .help = type it in Latin
unknown-address = there is no address { $letter }
    .help = `technolog table 2c42-65-addresses` lists them
comma-for-point = `{ $written }` has a comma where the decimal point belongs
    .help = write { $meant }
number-missing = no number follows the address { $address }
    .help = write the number or remove the address
number-too-fine = the number of { $address } is finer than 0.001
    .help = keep at most three places after the decimal point
number-not-whole = the number of { $address } must be whole
    .help = remove the point and the fraction
number-out-of-range = the number of { $address } is outside { $low } … { $high }
    .help = give a number within them
block-too-long = the block has { $length } characters with its end, { $limit } are allowed
    .help = split it into two blocks
memory-full = { $bytes } bytes do not fit a memory of { $memory }
    .help = put what repeats into subprograms
empty-program = the program is empty
    .help = name a file with blocks
no-block-number = the block has no number N ({ $count } such blocks in all)
    .help = begin the block with N and a number up to 9999
block-number-gap = { $missing } is missing after { $before }, and the numbers go by { $step }
    .help = check whether a block is missing
word-twice = the address { $address } appears twice in the block
    .help = keep one of the two
unknown-function = there is no function G{ $code }
    .help = `technolog table 2c42-65-g-functions` lists them
group-twice = { $first } and { $second } are of one group: only { $second } acts
    .help = keep one of them
too-many-m = { $count } M functions in a block, { $limit } are allowed
    .help = move the rest to another block
exclusive-m-twice = { $first } and { $second } in one block
    .help = keep one of them or split it into two blocks
machine-function = { $code } is the machine's own: here it does nothing
    .help = see the description of the machine
return-with-call = { $address } stands in a block with M99
    .help = write M99 in a block of its own
subprogram-one-digit = the number of subprogram { $number } has not two digits
    .help = write two digits, as in P05
program-one-digit = the number of the program has not two digits
    .help = write two digits, as in :05
subprogram-missing = there is no subprogram { $number }
    .help = add it to the file, from its number to its end
program-number-twice = this program number is already at line { $line }
    .help = give one of them another number
too-many-programs = { $count } programs, { $limit } are allowed
    .help = remove some
program-without-end = the program ends neither with M02, M30 nor with M99
    .help = end a program with M02, a subprogram with M99
word-after-cycle = { $address } after G{ $cycle } is taken for a parameter that the cycle does not have: it does nothing
    .help = write it before the G function of the cycle
parameter-outside-cycle = { $address } does not stand after the G function of a cycle
    .help = write it after G81…G86
word-unused = { $word } does nothing here
    .help = remove it
fourth-axis = the machine has no axis { $address }
    .help = keep to X, Y, Z
offset-with-radius-correction = { $function } while G41 or G42 acts
    .help = cancel the correction first: G40
corrector-with-offset = H together with { $function }
    .help = give H in another block
return-without-call = M99 and no subprogram was called
    .help = end the main program with M02 or M30
calls-too-deep = calls deeper than { $limit }
    .help = nest them less; does one call itself?
run-too-long = the program runs longer than { $budget } blocks and motions: the rest is not checked
    .help = repeat less or make the step of the cycle larger
feed-beyond-machine = the feed is above the machine's { $limit } mm/min
    .help = give a smaller F
speed-beyond-machine = the speed is above the machine's { $limit } rpm
    .help = give a smaller S
no-spindle-step = { $speed } rpm is not a spindle speed of this machine; the nearest are { $near }
    .help = give a step
finer-than-machine = the dimension is finer than the machine's step of { $step } mm
    .help = round the dimension
tool-beyond-magazine = tool T{ $tool }, but the magazine has { $places } places
    .help = check the number of the tool
no-tool = M06, and no tool T is named
    .help = name T in this block or before it
turning-at-change = M06 while the spindle turns
    .help = stop the spindle in a block before: M05
stop-turning = M0 leaves the spindle turning while the program waits for the operator
    .help = stop the spindle before it: M5
stop-turning-maybe = the spindle turns at M0, and not every machine of this control stops it there
    .help = stop the spindle before it: M5
machine-needed = a program of this control is checked only together with a machine
    .help = name it with --machine
change-low = the tool is changed no higher than where its feed began
    .help = withdraw it before the change, so that neither tool meets part or clamps
change-low-maybe = the tool is changed where its feed began, and it has not stood higher
    .help = look whether the next tool clears part and clamps there
change-not-withdrawn = the tool is changed where Z stands by a zero of the operator, and another change of the program at a position of the machine
    .help = withdraw Z as before the other change
ends-in-cut = the program ends while the tool stands in what it has cut
    .help = withdraw it along Z before
rapid-from-hole = at rapid sideways while the tool stands in what it has just cut straight down
    .help = bring it out along Z first
rapid-at-depth = at rapid sideways as low as the tool has just cut
    .help = look whether this way is free, or bring the tool up first
change-elsewhere = the tool is changed at { $at }, and the place for it is { $place }
    .help = bring table and quill there first
spindle-without-speed = the spindle is started without a speed S
    .help = give S before it or in the same block
feed-without-spindle = a feed while the spindle is stopped
    .help = start it with S and M03 or M04; after M06 it is stopped
feed-zero = the feed is 0
    .help = give F; the feed switch must not be at 0
limit-not-checked = { $why ->
        [machine] { $what ->
            [travel] travels
            [feed] the greatest feed
            [speed] spindle speeds
            [tap] tapping
           *[magazine] places of the magazine
        }: not checked, because no machine is named
       *[zeros] axis { $what }: whether it stays in its travel is not checked, because zeros and lengths of tools are those that the plan assumes
    }
    .help = { $why ->
        [machine] name it with --machine
       *[zeros] give `zeros` and `correctors` in the file of --setting
    }
change-by-zero = the tool is changed where Z stands by the zero of the operator, and the place for it is one of the machine
    .help = bring Z to its place before M06
both-length-signs = G43 and G44 in one program: the registers of the tools count in one direction
    .help = look whether both are meant
change-turning-maybe = M6 while the spindle turns: whether M6 stops it is a matter of the machine's builder; put M5 before it
    .help = look it up, or write M5 before every M6
distances-left-over = G91 of the return still acts: these positions are taken as distances
    .help = give G90 behind the return
radius-not-cancelled = G41 or G42 still acts here
    .help = give G40 on the way off the contour
lead-in-through-part = the way to the contour leads through the side of the metal
    .help = come from the side of the tool: check G41 or G42, G2 or G3, and where the way begins
lead-out-through-part = the way off the contour leads through the side of the metal
    .help = leave to the side of the tool: check G2 or G3, and where the way ends
rapid-into-pocket = T{ $tool }: at rapid down to Z{ $z } mm of the zero, and then around this place: the program has cut nothing here before
    .help = go down at feed, or drill the place first
rapid-below-zero = T{ $tool }: at rapid down to Z{ $z } mm of the zero, where the program has cut nothing before
    .help = look whether the tool comes down beside the part
rapid-through-wall = T{ $tool }: at rapid sideways at Z{ $z } mm of the zero, out of a hole that the program has cut, through what stands around it
    .help = retract over the face before the next place: G98, or a higher R
rapid-under-begin = T{ $tool }: at rapid from the side at Z{ $z } mm of the zero to a place where the feed begins only at Z{ $other } mm
    .help = go up before the way sideways
rapid-under-begin-maybe = T{ $tool }: at rapid from the side at Z{ $z } mm of the zero to a place where the feed begins only at Z{ $other } mm
    .help = right only where the metal there is lower than the tool comes
rapid-into-floor = T{ $tool }: at rapid down to Z{ $z } mm of the zero, into the floor that the program has cut here at Z{ $other } mm
    .help = go down at feed
rapid-into-narrower = T{ $tool }: at rapid to Z{ $z } mm of the zero in a hole of { $other } mm, by the comments, with a tool of { $diameter } mm
    .help = let the feed begin over the face
drill-feed = T{ $tool }: { $feed } mm for a turn of a drill of { $diameter } mm; no table gives it as much as { $most } mm
    .help = correct F or S
drill-at-rapid = T{ $tool }: a drill at rapid down to Z{ $z } mm of the zero, where no hole is yet
    .help = end the rapid over the face and go on at feed
begins-in-metal = T{ $tool }: the feed begins at Z{ $z } mm of the zero, in metal: { $why ->
        [sign] others of this tool begin at Z{ $other } mm and end as deep
       *[touched] here the program has cut to Z{ $other } mm before
    }
    .help = correct R, or the level where the rapid ends
depth-tenfold = T{ $tool }: a hole down to Z{ $z } mm of the zero, and the others that begin there go to Z{ $other } mm
    .help = look whether Z has a digit too many
feed-of-turn = G95 acts, and F is { $feed } mm for each turn
    .help = correct F, or give G94
feed-of-minute = G94 acts, and F is { $feed } mm in a minute
    .help = look whether F was meant for a turn, with G95
return-goes-down = the return first goes down at rapid to a point on the face of the part or below it: its Z is a position of the program
    .help = write the return in distances, G91 G28 Z0, or go up before it
home-in-cut = on the way to a place of the machine the tool goes sideways at rapid out of what it has cut
    .help = bring Z up first
distances-of-call = G91 of the subprogram still acts: these positions are taken as distances
    .help = give G90 at the end of the subprogram or behind the call
radius-register-missing = G41 or G42 comes without a register D: which radius it takes is left to what acted before
    .help = name D of this tool
radius-of-other-tool = T{ $tool } goes beside a contour by the radius D{ $corrector }, that of T{ $other }
    .help = name D of this tool
two-lengths = T{ $tool } comes again and cuts with the length offset H{ $corrector }; before it had H{ $other }
    .help = name the register of this tool
tap-hole-narrow = T{ $tool }: { $thread } in a hole of { $diameter } mm, by the comments; its drill has about { $needed } mm
    .help = take the drill of this thread
tap-hole-wide = T{ $tool }: { $thread } in a hole of { $diameter } mm, by the comments; its drill has about { $needed } mm
    .help = right only for an insert or another thread than the comment says
widens-beyond-hole = T{ $tool }: it goes to Z{ $z } mm of the zero, and the hole was drilled to Z{ $other } mm
    .help = stop over the floor of the hole, or drill deeper
widens-beyond-hole-maybe = T{ $tool }: it goes to Z{ $z } mm of the zero, farther than the hole was drilled, to Z{ $other } mm
    .help = right only where the hole goes through
tap-hole-no-thread = T{ $tool }: { $thread } in a hole of { $diameter } mm, by the comments: no thread is left; its drill has about { $needed } mm
    .help = correct the drill or the tap
tap-turns-wrong = T{ $tool }: a comment names a left-hand tap, and it is fed down while the spindle turns clockwise
    .help = let the spindle turn counterclockwise
ream-hole-wide = T{ $tool }: a reamer of { $diameter } mm in a hole of { $other } mm, by the comments: it touches nothing
    .help = correct the drill or the reamer
ream-hole-narrow = T{ $tool }: a reamer of { $diameter } mm in a hole of { $other } mm, by the comments; no reamer takes more than { $most } mm on the diameter
    .help = drill wider before it
widens-no-hole = T{ $tool } only widens holes, and none was made here
    .help = correct the place, or make the hole first
hole-made-later = T{ $tool } only widens holes, and this one is drilled after it, by T{ $other }
    .help = drill first
hole-made-later-maybe = T{ $tool } counterbores a place that is drilled only after it, by T{ $other }
    .help = right only where the tool cuts to its middle
tap-beyond-hole = T{ $tool }: the tap goes to Z{ $z } mm of the zero, and the hole was made to Z{ $other } mm
    .help = tap less deep, or make the hole deeper
tap-beyond-hole-maybe = T{ $tool }: the tap goes to Z{ $z } mm of the zero, a little farther than the hole that was made, to Z{ $other } mm
    .help = right only where the hole goes through
tap-without-hole = T{ $tool }: a tap where the program has made no hole, and for others of this tap it has
    .help = correct the place, or make the hole first
tap-hole-not-cut = T{ $tool }: a tap where the tool before it was fed up from over the part and made no hole
    .help = look whether the depth of the hole has lost its sign
tap-beside-hole = T{ $tool }: a tap { $distance } mm beside a hole that the program made, and in none
    .help = correct the place of the tap or of the hole
hole-again = T{ $tool }: a hole is made once more at the same place, to Z{ $z } mm of the zero
    .help = look whether the cycle is repeated in absolute positions
tap-again = T{ $tool }: a thread is cut once more at the same place, to Z{ $z } mm of the zero
    .help = look whether the cycle is repeated in absolute positions
tap-begins-in-hole = T{ $tool }: the tap comes at rapid to Z{ $z } mm of the zero, into a hole made by one drill
    .help = end the rapid over the face: a tap needs its feed from there on
tap-in-drill-cycle = T{ $tool }: a comment names a tap of pitch { $pitch } mm and it is fed so, but a cycle of drilling pulls it out at rapid
    .help = use the cycle of tapping
feed-tenfold = T{ $tool }: the feed { $feed } mm/min, and { $other } mm/min in the cuts beside it
    .help = look whether F has a digit too many
tap-pitch-named = T{ $tool }: F over S makes { $pitch } mm for each turn, and a comment names { $thread }, whose pitch is { $needed } mm
    .help = correct F or S, or the comment
beyond-travel-of = axis { $axis } moves to { $value } mm, its travel is { $low } … { $high } mm
    .help = check the dimension, the zero and the offset register
span-beyond-travel = in { $system } axis { $axis } needs { $needed } mm of travel and has { $travel } mm
    .help = check the dimensions along this axis
not-homed = axis { $axis } has not been homed to the machine zero
    .help = home it first: G27
arc-without-centre = an arc without a centre in its plane
    .help = give I, J or K from the start of the arc
arc-without-radius = the centre of the arc is its start
    .help = give an I, J or K that is not zero
arc-radius = the radius is { $start } mm at the start of the arc and { $end } mm at its end
    .help = check end and centre; the centre always counts from the start
helix-without-function = an arc with a motion across its plane and no G10
    .help = add G10 and a pitch, or remove the motion across
helix-without-arc = G10 without G02 or G03
    .help = give G02 or G03
helix-pitch-missing = a helix without a pitch
    .help = give the pitch per turn: K, J or I by the plane
helix-pitch-sign = the sign of the pitch is not that of the motion
    .help = change the sign of the pitch
helix-pitch = with this pitch the arc climbs { $made } mm, and { $climb } mm are given
    .help = make pitch, arc and climb agree
dwell-without-time = G04 without a time E
    .help = give E in tenths of a second
time-without-dwell = a time E, and neither G04 nor a cycle before it that waits
    .help = write G04 before E, or put E behind the function of the cycle
mode-left-over = the block relies on a mode that the program never sets ({ $words }): { $before ->
        [unsaid] what another program, one that was broken off, or a block by hand has left may act
       *[programs] what the program before left acts
    }
    .help = set it in the first block: { $words }{ $before ->
        [unsaid] {" "}(or, where the control is always switched on just before, say as_powered_on: true in the file of --setting)
       *[programs] {""}
    }
habit-left-over = the block relies on what the program never sets ({ $words }): what is usual here is taken, but another program may have left something else
    .help = set it in the first block: { $words }
height-unknown = a way along X or Y before the program has brought Z anywhere: the quill may be down
    .help = raise the quill in a block before: G53 G0 Z0
until-signal = when the outside signal comes is not known: the whole motion is run
    .help = note that the motion may be shorter
one-sided = from which side the machine comes is not known: run as positioning
    .help = note that the machine may overrun the point
fixed-point-unknown = the fixed point of { $function } is not known
    .help = give `fixed_point` in the setting file
nothing-stored = G30, and no point has been stored
    .help = G27, G28, G29 or G31 must come first
corrector-unknown = offset register { $number } is not set: 0 is taken
    .help = give it under `correctors` in the setting file
offset-in-cycle = { $function } does not act in a fixed cycle
    .help = cancel the cycle with G80 or remove the function
zero-not-set = the zero of { $system } is not given: positions along { $axes } count from it, not from the machine zero
    .help = give it under `zeros` in the setting file
correction-by-arc = radius compensation comes in and goes out on a straight line, not on an arc
    .help = put a G01 before the arc
arc-smaller-than-tool = the arc is no larger than the tool
    .help = take a smaller tool, or the other side of the arc
contour-too-tight = the tool does not fit between the neighbours of this element
    .help = take a smaller tool
cycle-parameter-missing = the cycle { $cycle } lacks parameters: { $words }
    .help = give them after the G function of the cycle
cycle-step-not-positive = { $address } of a cycle must be positive
    .help = give it without a minus
cycle-clearance-over-step = W of a cycle is larger than its step V: the tool comes out further than it went in
    .help = give a W smaller than V
cycle-upside-down = the cycle feeds upwards: its bottom Z{ $z } lies over U{ $u }, and to U the tool goes at rapid
    .help = exchange U and Z, or check their signs
cycle-ends-deeper = the way out of the cycle ends at I{ $i }, deeper than its bottom Z{ $z }
    .help = give an I above the hole
cannot-tap = the machine cannot tap: G84 is not run
    .help = cut the thread on another machine
hole-twice = { $cycle } makes the same hole with the same tool again: first in { $first }
    .help = remove one of the two, or put G80 before the motion
cycle-at-tool-change = { $cycle } is still in force and runs on the way to the tool change
    .help = put G80 before going away
tool-not-brought = T{ $tool } is named and its length offset acts, but no change has brought it: another tool is in the spindle
    .help = change the tool with T{ $tool }, or give the offset of the tool in the spindle
no-length-offset = T{ $tool } cuts and no length offset acts
    .help = give G43 with the offset register of this tool before it goes down; the tool that the others are measured by has one too
length-by-hand = T{ $tool } cuts and no length offset acts: the operator has to set its zero at the stop before
    .help = give every tool its offset register, G43 H
offset-of-other-tool = T{ $tool } cuts with the length offset H{ $corrector }, that of T{ $other }
    .help = give G43 with the offset register of this tool
offset-of-other-number = T{ $tool } cuts with the length offset H{ $corrector }, and there is a tool T{ $other }
    .help = make sure that H{ $corrector } holds the length of T{ $tool }
offset-of-strange-number = T{ $tool } cuts with the length offset H{ $corrector }
    .help = make sure that H{ $corrector } holds the length of T{ $tool }
drilling-backwards = { $tool ->
        [0] the tool
       *[other] T{ $tool }
    } is fed straight down while the spindle turns counterclockwise
    .help = give M3; only a left-hand drill needs M4
milling-backwards = { $tool ->
        [0] the tool
       *[other] T{ $tool }
    } is fed while the spindle turns counterclockwise
    .help = give M3; only a left-hand tool, or a laser, needs M4
tap-feed = the feed F{ $feed } at S{ $speed } makes { $pitch } mm for each turn: no thread has that pitch
    .help = give F = S · pitch where F counts mm/min, the pitch itself only where it counts mm for each turn
tap-feed-odd = the feed F{ $feed } at S{ $speed } makes { $pitch } mm for each turn, which is the pitch of no metric and no inch thread
    .help = make sure that F is S · pitch
dwell-unit = a dwell of { $seconds } s in the hole; { $limit ->
        [least] a tenth of a turn takes { $needed } s
       *[most] more than { $needed } s
    }: likely another unit of time
    .help = write the time in the unit of this control
dwell-odd = a dwell of { $seconds } s; { $limit ->
        [least] less than { $needed } s
       *[most] more than { $needed } s
    }: perhaps another unit of time
    .help = make sure that the time is written in the unit of this control
