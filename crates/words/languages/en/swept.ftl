# What a program of a lathe does to the stock that it must not do, or leaves.
swept-gouge = { $surface }: cut { $depth } mm too deep at Z{ $z } Ø{ $diameter }; { $count } { $count ->
        [one] place
       *[other] places
    } in all
swept-rapid = { $tool } goes through metal at rapid at Z{ $z } Ø{ $diameter }: they overlap by { $width } mm; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-holder = the holder of { $tool } goes into metal at feed at Z{ $z } Ø{ $diameter }: they overlap by { $width } mm; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-holder-rapid = the holder of { $tool } goes into metal at rapid at Z{ $z } Ø{ $diameter }: they overlap by { $width } mm; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-struck = { $tool } strikes { $body } at Z{ $z } Ø{ $diameter }: they overlap by { $width } mm; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-off-axis = { $tool } cuts beside the axis at Z{ $z } Ø{ $diameter }: a drill is fed along the axis only; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-stands = { $surface }: up to { $thickness } mm of metal is left between Z{ $from } and Z{ $to }, most at Z{ $z } Ø{ $diameter }
swept-size-left = { $surface }: Ø{ $measured } at Z{ $z } is outside of its limits with metal left on it: { $least } ≤ Ø ≤ { $most } mm
swept-size-lost = { $surface }: Ø{ $measured } at Z{ $z } is outside of its limits, and the metal is gone: { $least } ≤ Ø ≤ { $most } mm
swept-length-left = { $surface }: its face lies at { $measured } mm with metal left on it, outside of its limits: { $least } ≤ L ≤ { $most } mm
swept-length-lost = { $surface }: its face lies at { $measured } mm, outside of its limits, and the metal is gone: { $least } ≤ L ≤ { $most } mm
swept-corner = { $surface }: an inner corner keeps the round of the nose, r = { $radius } mm, { $left } mm from its sides at Z{ $z } Ø{ $diameter }; { $count } { $count ->
        [one] corner
       *[other] corners
    } in all
swept-thread-shallow = { $surface }: the deepest pass of the thread ends { $left } mm short of the pitch diameter that its tolerance allows
swept-thread-part = { $surface }: no pass cuts the thread to its depth from Z{ $from } to Z{ $to }, { $left } mm of its length
swept-tap-blocked = { $tool } meets metal at Z{ $z } Ø{ $diameter }, { $width } mm where it is narrowest: no hole, a hole narrower than its core, or the bottom; { $count } { $count ->
        [one] place
       *[other] places
    } in all
swept-tap-out-of-step = { $tool } cuts to Z{ $z } and is not fed by its pitch: { $lead } mm per turn in place of { $pitch } mm; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-tap-hole-wide = { $surface }: the hole before the tap is wider than the minor diameter may be, by { $width } mm a side at Z{ $z } Ø{ $diameter }; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-thread-lead = { $surface }: a pass of the thread to Z{ $z } is not fed by its pitch: { $lead } mm per turn in place of { $pitch } mm; { $count } { $count ->
        [one] pass
       *[other] passes
    } in all
swept-buried = { $tool } goes { $depth } mm deeper than its cutting part is long: at Z{ $z } the hole closes round its shank, and chips have no way out; { $count } { $count ->
        [one] motion
       *[other] motions
    } in all
swept-thread-phase = { $surface }: a pass of the thread that starts at Z{ $z } cuts { $shift } mm beside the groove of the deepest pass: it starts at another angle of the spindle, off by other than whole pitches of { $pitch } mm; { $count } { $count ->
        [one] pass
       *[other] passes
    } in all
    .help = start every pass at the same Z and spindle angle, or whole pitches away; along a flank no farther off than the depth that is left · tan of half the angle
swept-thread-short = { $surface }: the full thread behind the lead of the tap ends { $left } mm before that of the drawing
# What cannot be followed at all.
swept-no-contour = the proof of the program has no outer contour of the part
swept-no-tool = block { $block } moves a tool that the set-up does not have
swept-far = a place is farther than { $limit } mm from zero, or is no number: such a set-up is not proven
swept-tool = { $tool }: no tool has such lengths or angles
word-body-jaws = a jaw of the chuck
word-body-chuck = the chuck
word-body-centre = the tailstock centre
word-body-rest = the steady rest
word-body-quill = the quill of the tailstock
