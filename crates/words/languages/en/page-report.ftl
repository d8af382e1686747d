# The laboratory report.
lab-title = Report of the laboratory work: { $part }
lab-part = { $number }. { $name }
lab-aim = Name and aim of the work
lab-task = Task
lab-equipment = Machine and control in brief
lab-possible = Whether the surfaces can be machined on this equipment
lab-blank = Blank
lab-steps = Steps of machining of each surface, and how they are made
lab-route = Route
lab-tools = Cutting tools and holders
lab-conditions = Cutting conditions and allowances
lab-fixture = Fixture and clamping
lab-setting = Setting of the tools
lab-zeros = Zeros of the machine
lab-change = Position of table and quill at a tool change
lab-charts = Calculation-and-technology charts of the tools
lab-program = The program on its encoding sheet
lab-conclusions = Conclusions
# The title block.
lab-institution = Institution
lab-department = Department
lab-author = Author
lab-group = Group
lab-variant = Variant
lab-lecturer = Accepted by
lab-date = Date
# What only the author can write.
lab-place = [ To be written: { $what } ]
lab-write-aim = name and aim of the work
lab-write-fixture = the fixture and its locating elements, if they are not chosen above
lab-write-conclusions = your own conclusions
# The task.
lab-count = Count
lab-size = Size
lab-depth = Depth
lab-through = through
lab-roughness = Roughness
lab-places = Centres [X; Y], mm
lab-from-above = The part from above: the surfaces to be machined, overall sizes, the zero of the drawing
# The machine, and whether the part can be made on it.
lab-characteristic = Characteristic
lab-figure = Value
lab-unit = Unit
lab-limit = What is compared
lab-needed = Needed
lab-available = Available
lab-enough = Enough
lab-yes = yes
lab-no = no
lab-span-x = distance of the outermost holes along X, and travel of the table
lab-span-y = distance of the outermost holes along Y, and travel of the table
lab-tool-length = length of the longest assembly, and greatest overhang
lab-tool-diameter = diameter of the largest tool
lab-power = greatest cutting power, and power of the main drive
lab-torque = greatest torque
lab-thrust = greatest axial force
lab-mass = mass of the blank
lab-can-be-made = Every surface of the task can be machined on this equipment: the plan has no error.
lab-cannot-be-made = Not all of the task can be done on this equipment as it stands:
# The blank and the steps.
lab-of-hole = { $hole }: { $size }
lab-not-planned = There is no route for this surface: parts 4 and 16 say why.
lab-step = { $what } Ø{ $diameter }{ $reached }{ $elsewhere }
lab-reaches = {" "}– reaches { $reached }
lab-elsewhere = , on another machine
# Tool change, charts, program, conclusions.
lab-change-at = Tools are changed at X { $x }, Y { $y }, Z { $z } mm in the frame of the machine.
lab-change-apart = It has to be no nearer to a clamp than { $distance } mm (textbook, 1.11).
lab-chart = Cycles of tool T{ $tool }. { $does }
lab-program-form = The sheet follows GOST 3.1404-86, form 5a, as in Appendix Г of the textbook. Appendix В (programs of plants) is lost, so nothing refers to it.
lab-not-to-run = This program must not be run: { $why }.
lab-made = Holes machined: { $holes } of { $all }. Tools: { $tools }, transitions: { $transitions }, set-ups: { $setups }. Time by the plan: { $time } min.
lab-slowest = Group { $hole } takes longest: { $time } min.
lab-nothing-wrong = The checks found no error in plan and program.
# The file of the title block.
lab-no-such-part = a report has no part { $text }
lab-parts-are = parts have numbers from 1 to { $most }
lab-blank-mass = Mass of the blank { $mass } kg.
lab-more = Also, sizes in mm
lab-step-of = { $size } to depth { $depth }
lab-counterbore = counterbore Ø{ $diameter } to depth { $depth }
lab-countersink = countersink Ø{ $diameter } × { $angle }°
lab-cone = cone to Ø{ $diameter }, { $angle }°
lab-face = face Ø{ $diameter }
lab-groove = groove Ø{ $diameter } × { $width }
lab-chamfer = chamfer { $chamfer }
lab-centre = tolerance of centres { $width }
lab-centre-of-grade = tolerance of centres IT{ $it }
lab-allowances = Allowances on the diameter
lab-before = Ø before
lab-after = Ø after
lab-allowance = Allowance
lab-can-be-made-but = On this equipment everything can be made but for:
lab-left = The program does not do everything: { $what }.
lab-unconfirmed = Rows of tables that the plan rests on and nothing confirms: { $count }. The plan itself lists them.
form-tool-list = Tools and holders: { $part }
lab-path-of = The path of tools over the holes: { $tools }
lab-clamping-scheme = How the part is clamped: the clamps, the hole that needs the largest force, and its arm d
lab-clamping-arm = d = { $distance }
lab-clamping-force = Q = { $force } N on each
lab-clamping-torque = M = { $torque } N·m
lab-clamping-side = P = { $side } N
lab-assemblies = Tool assemblies: length of the holder, overhang, length of the assembly L; mm
lab-assembly-holder = holder { $length }
lab-assembly-overhang = overhang { $length }
lab-assembly-length = L { $length }
lab-assembly-offset = offset { $offset }
lab-zone = The working zone: table, supports, part, and the longest tool T{ $tool } over the zero of the part, the quill retracted; mm
lab-zone-table = table { $length }
lab-zone-nose = spindle nose to table { $height }
lab-zone-tool = L { $length }
lab-zone-part = part { $height }
lab-zone-supports = supports { $height }
lab-zone-vice = vice { $height }
lab-zone-gap = to the part { $height }
