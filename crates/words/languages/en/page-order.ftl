# The order of tools and their paths over the holes of a part.
order-title = Order of tools and paths over the holes: { $part }
order-there-and-back = Each tool goes from the tool-change position { $home } and back to it.
order-stops = Stops
order-path = Path
order-rapids = Rapids
order-nearest = By the textbook's rule
order-saved = Saved
order-bound = Lower bound
order-visiting = Visiting method by 1.3.1 (the plan visits in parallel)
order-methods = In parallel: a tool goes to all holes of the group before it is changed; in sequence: a hole is finished with all tools before the next one. K_T by section 1.3.1 is the time in parallel over that in sequence: above 1 the sequence is quicker.
order-method = { $hole }: { $why }
order-times-of-methods = in parallel { $parallel } min, in sequence { $sequential } min, on this machine in sequence { $here } min
order-mixture-quicker = { $tools ->
    [one] quickest combination: the last tool in sequence ({ $tools }); { $time } min, quicker than either method
   *[other] quickest combination: the last { $tools } tools in sequence; { $time } min, quicker than either method
}
order-mixture-not-quicker = { $tools ->
    [one] quickest combination: the last tool in sequence ({ $tools }); { $time } min, not quicker than one of the two methods
   *[other] quickest combination: the last { $tools } tools in sequence; { $time } min, not quicker than one of the two methods
}
# The path over a list of points.
order-list-title = Path over a list of points
order-points = Points
order-nearest-path = Path by the textbook's rule
order-of-slower-axis = Lengths are summed by the axis that moves farther in each move, as the time of rapids goes by it.
order-bound-path = Lower bound of the path
order-tries = Tries
order-points-in-order = Points in order
# Titles of drawings.
order-of-tool = T{ $tool }, set-up { $setup }: { $time } min
order-of-list = { $count } points, path { $length } mm
