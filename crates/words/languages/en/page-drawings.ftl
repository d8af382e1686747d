# Lines of drawings.
drawing-set-up = set-up { $setup }
drawing-rapid = rapid
drawing-feed = feed
# The backplot.
backplot-empty = The program cuts nothing.
backplot-points = points: { $count }
backplot-plunge = down along Z, in this order
backplot-tool-change = tool change
backplot-zero = zero of the part
backplot-clamp = clamp or obstacle
backplot-scale-of-drawing = { $length } mm; coordinates of the drawing
backplot-scale-of-machine = { $length } mm; coordinates of the machine
# Diagrams of cycles.
cycles-operation = { $operation } of { $holes }
cycles-holes = { $count } { $count ->
    [one] hole
   *[other] holes
} { $size } ({ $hole })
cycles-holes-to = { $count } { $count ->
    [one] hole
   *[other] holes
} { $size } to Ø{ $diameter } ({ $hole })
cycles-load-tool = Put tool { $tool } into place { $place } of the magazine
cycles-turn-over = Turn the part { $part } over about Y
cycles-set-bar = Set the boring bar to Ø{ $diameter }
cycles-speed = S { $speed } rpm
cycles-feed = F { $feed } mm/min
cycles-plunge = F { $feed } mm/min down
cycles-arcs = F { $feed } mm/min on the arcs
cycles-arcs-between = F { $slow } to { $fast } mm/min on the arcs
cycles-pocket = pocket { $size } ({ $hole }) to a width of { $width }
cycles-slot = slot { $size } ({ $hole }) to a width of { $width }
cycles-slot-ways = { $count ->
        [0] along the middle of the slot
        [1] the mill's centre { $radii } mm from the middle line
       *[other] the mill's centre { $radii } mm from the middle line, one way round each
    }
cycles-dwell = dwell { $seconds } s
cycles-step = step V { $step } mm
cycles-clearance = clearance W { $clearance } mm
cycles-retreat = retreat W { $retreat } mm
cycles-pitch = pitch { $pitch } mm
cycles-out-stopped = exit with the spindle stopped
cycles-out-at-feed = exit at feed
cycles-coolant = with coolant
cycles-not-to-scale = Z as on the drawing, mm; not to scale
cycles-before = before: { $size }
cycles-top = top { $z }
cycles-full-diameter = full Ø { $z }
cycles-bottom = bottom { $z }
cycles-radii = { $count ->
        [1] radius
       *[other] radii
    } of the mill's centre { $radii } mm
