"""Our interpreter of LinuxCNC beside LinuxCNC's own, rs274 of the Debian package linuxcnc-uspace.

    cargo build
    python3 tests/oracles/linuxcnc.py target/debug/technolog                 # tests/programs-linuxcnc, examples/*.yaml
    python3 tests/oracles/linuxcnc.py target/debug/technolog a.ngc folder    # these files, and the .ngc of this folder
    python3 tests/oracles/linuxcnc.py target/debug/technolog --write         # writes `rs274` beside every test program
    python3 tests/oracles/linuxcnc.py target/debug/technolog --random 500    # programs of random words, by --seed
    python3 tests/oracles/linuxcnc.py target/debug/technolog --survey folder # a table: which of these we trace as rs274 does
    python3 tests/oracles/linuxcnc.py target/debug/technolog --survey        # of those of the package, where it is installed

Options: --setting FILE.yaml and --machine ID for programs that have none beside them.

Every motion, dwell and change of tool that rs274 makes is compared with the step that `technolog check --control
linuxcnc` makes of the same program: kind, position on the machine and centre within 1 micrometre, turns, feed, and what
spindle, coolant and tool are then. Motions that do not move are left out on both sides. What rs274 refuses must be an
error of ours; we may refuse more (a feed with the spindle stopped, travel beyond the machine): that is said and counted.

Zeros and the fixed point of a setting go to rs274 by its file of parameters, correctors by its tool table. Both are in
inches in this package, with as many places as it takes, so that a micrometre stays one. Where rs274 is not installed the
script says so and ends with 0.
"""

import json
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

NEAR = 0.0011  # mm: a micrometre, and the rounding of the fourth place that rs274 prints


def read_setting(file):
    """The part of YAML that settings are written in: keys, and maps in braces, one level deep."""
    setting, above = {}, None
    for line in file.read_text().splitlines() if file else []:
        line = line.split("#")[0].rstrip()
        found = re.match(r"( *)([\w]+): *(.*)", line)
        if not found:
            continue
        indent, key, text = found.groups()
        if text.startswith("{"):
            value = dict(re.findall(r"(\w+): *([-+.\d]+)", text))
            value = {name: float(number) for name, number in value.items()}
            if re.search(r"\w+: *\{", text):
                value = {k: {n: float(v) for n, v in re.findall(r"(\w+): *([-+.\d]+)", inner)}
                         for k, inner in re.findall(r"(\w+): *\{([^}]*)\}", text)}
        else:
            value = text if text else {}
        (above if indent and above is not None else setting)[key] = value
        if not indent:
            above = value if isinstance(value, dict) and not text else None
    return setting


def write_tables(setting, folder):
    """The parameters and the tool table of rs274."""
    inch = lambda mm: f"{mm / 25.4:.9f}"
    parameters = {number: 0.0 for number in range(5161, 5170)}
    parameters |= {number: 0.0 for number in range(5181, 5190)}
    parameters |= {5220: 25.4}
    for system in range(6):
        zero = setting.get("zeros", {}).get(f"G{54 + system}", {})
        for axis, letter in enumerate("xyz"):
            parameters[5221 + 20 * system + axis] = zero.get(letter, 0.0)
    for axis, letter in enumerate("xyz"):
        parameters[5181 + axis] = setting.get("fixed_point", {}).get(letter, 0.0)
    lines = [f"{number} {inch(value)}" for number, value in sorted(parameters.items())]
    (folder / "rs274.var").write_text("\n".join(lines) + "\n")
    correctors = {int(number): value for number, value in setting.get("correctors", {}).items()}
    # A tool without a corrector is there too: our check says that its corrector is not given, and takes 0.
    tools = [f"T{n} P{n} Z{inch(correctors.get(n, 0.0))} D0.4" for n in range(1, 100)]
    (folder / "tool.tbl").write_text("\n".join(tools) + "\n")


class Machine:
    """What is true between the motions: the same for both sides."""

    def __init__(self):
        self.records, self.at = [], (0.0, 0.0, 0.0)
        self.turning, self.speed, self.coolant, self.tool = "stopped", 0.0, False, 0

    def put(self, kind, **more):
        state = {"spindle": self.turning, "coolant": self.coolant, "tool": self.tool}
        if self.turning != "stopped":
            state["speed"] = self.speed
        self.records.append({"kind": kind, "at": self.at} | more | state)

    def go(self, kind, at, **more):
        still = kind != "arc" and all(abs(a - b) < NEAR for a, b in zip(at, self.at))
        self.at = at
        if not still:
            self.put(kind, **more)


def of_rs274(program, setting, skip):
    """The records of rs274, or what it refuses."""
    return of_rs274_text(program.read_text(errors="replace"), setting, skip)


def of_rs274_text(program, setting, skip):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_tables(setting, folder)
        command = ["rs274", "-g", "-n", "2", "-t", "tool.tbl", "-v", "rs274.var"] + (["-b"] if skip else [])
        # Under its own folder: rs274 writes beside itself.
        (folder / "program.ngc").write_text(program)
        try:
            answer = subprocess.run(command + ["program.ngc"], capture_output=True, text=True, cwd=folder, timeout=5)
        except subprocess.TimeoutExpired:
            return [], "it does not end in 5 s"
    machine = Machine()
    start = setting.get("start", {})
    machine.at = tuple(start.get(letter, 0.0) for letter in "xyz")
    scale, g5x, g92, length = 1.0, [0.0] * 3, [0.0] * 3, [0.0] * 3
    plane, feed, per_turn, pitch, turned = "XY", 0.0, False, None, 0.0
    numbers = lambda text: [float(number) for number in re.findall(r"-?\d+\.?\d*", text)]
    for line in answer.stdout.splitlines():
        found = re.match(r"\s*\d+ N\S+\s+(\w+)\((.*)\)", line)
        if not found:
            continue
        name, text = found.groups()
        values = numbers(text)
        def on_machine(three):
            x, y, z = (value * scale + shift for value, shift in zip(three, g92))
            x, y = x * math.cos(turned) - y * math.sin(turned), x * math.sin(turned) + y * math.cos(turned)
            return tuple(value + a + b for value, a, b in zip((x, y, z), g5x, length))

        def pace():
            return pitch * machine.speed if pitch is not None else feed * machine.speed if per_turn else feed

        if name == "USE_LENGTH_UNITS":
            scale = 25.4 if "INCHES" in text else 1.0
        elif name == "SET_G5X_OFFSET":
            g5x = [value * scale for value in values[1:4]]
        elif name == "SET_G92_OFFSET":
            g92 = [value * scale for value in values[:3]]
        elif name == "USE_TOOL_LENGTH_OFFSET":
            length = [value * scale for value in values[:3]]
        elif name == "SET_XY_ROTATION":
            turned = math.radians(values[0])
        elif name == "SET_FEED_MODE":
            per_turn = values[1] == 1
        elif name == "START_SPEED_FEED_SYNC":
            pitch = values[0] * scale
        elif name == "STOP_SPEED_FEED_SYNCH":
            pitch = None
        elif name == "CHANGE_TOOL_NUMBER":
            machine.tool = int(values[0])
        elif name == "SET_FEED_RATE":
            feed = values[0] * scale
        elif name == "SELECT_PLANE":
            plane = {"XY": "XY", "XZ": "ZX", "YZ": "YZ"}[text[-2:]]
        elif name == "STRAIGHT_TRAVERSE":
            machine.go("rapid", on_machine(values[:3]))
        elif name == "STRAIGHT_FEED":
            machine.go("feed", on_machine(values[:3]), feed=pace())
        elif name == "RIGID_TAP":
            start, way = machine.at, machine.turning
            machine.go("feed", on_machine(values[:3]), feed=pace())
            machine.turning = "counterclockwise" if way == "clockwise" else "clockwise"
            machine.go("feed", start, feed=pace())
            machine.turning = way
        elif name == "STRAIGHT_PROBE":
            machine.go("feed", on_machine(values[:3]), feed=feed)
        elif name == "ARC_FEED":
            axes = [0, 1, 2] if plane == "XY" else [2, 0, 1] if plane == "ZX" else [1, 2, 0]
            end, middle = [0.0] * 3, [0.0] * 3
            for axis, value, centre in zip(axes, [values[0], values[1], values[5]], [values[2], values[3], 0.0]):
                end[axis], middle[axis] = value, centre
            turn = int(values[4])
            middle = on_machine(middle)
            machine.go("arc", on_machine(end), feed=pace(), plane=plane, turns=abs(turn) - 1,
                       sense="counterclockwise" if turn > 0 else "clockwise",
                       centre=[middle[axes[0]], middle[axes[1]]])
        elif name == "DWELL":
            if values[0] > 0:
                machine.put("dwell", seconds=values[0])
        elif name == "SET_SPINDLE_SPEED":
            machine.speed = values[1]
        elif name.startswith("START_SPINDLE_"):
            machine.turning = name.removeprefix("START_SPINDLE_").lower()
        elif name == "STOP_SPINDLE_TURNING":
            machine.turning = "stopped"
        elif name in ("MIST_ON", "FLOOD_ON"):
            machine.coolant = True
        elif name in ("MIST_OFF", "FLOOD_OFF"):
            machine.coolant = False
        elif name == "CHANGE_TOOL":
            machine.tool = int(values[0])
            machine.put("tool-change")
    if answer.returncode:
        lines = [line for line in answer.stderr.splitlines() if line.strip() and line.strip() != "executing"]
        return machine.records, lines[0].strip() if lines else "refused"
    return machine.records, None


def of_technolog(technolog, program, setting_file, machine_id):
    """Our records, and the codes of our errors."""
    command = [technolog, "check", str(program), "--control", "linuxcnc", "--format", "json"]
    if machine_id:
        command += ["--machine", machine_id]
    if setting_file:
        command += ["--setting", str(setting_file)]
    answer = subprocess.run(command, capture_output=True, text=True)
    if answer.returncode not in (0, 1):
        return [], [answer.stderr.strip() or "technolog failed"]
    answer = json.loads(answer.stdout)
    machine = Machine()
    start = read_setting(setting_file).get("start", {})
    machine.at = tuple(start.get(letter, 0.0) for letter in "xyz")
    for step in answer["trace"]:
        before = len(machine.records)
        at = tuple(step["at"][letter] for letter in "xyz")
        kind = step["motion"]
        if kind == "rapid":
            machine.go(kind, at)
        elif kind == "feed":
            machine.go(kind, at, feed=step["feed_mm_per_min"])
        elif kind == "arc":
            machine.go(kind, at, feed=step["feed_mm_per_min"], plane=step["plane"], turns=step["turns"],
                       sense=step["sense"], centre=step["centre"])
        elif kind == "dwell":
            if step["seconds"] > 0:
                machine.put(kind, seconds=step["seconds"])
        elif kind == "spindle":
            machine.turning, machine.speed = step["turning"], step["speed_rpm"]
        elif kind == "coolant":
            machine.coolant = step["on"]
        elif kind == "tool-change":
            machine.tool = step["tool"]
            machine.put(kind)
        elif kind == "auxiliary" and step["word"].startswith("M61 Q"):
            machine.tool = int(step["word"].removeprefix("M61 Q"))
        for record in machine.records[before:]:
            record["line"] = step["line"]
    # What is not carried out is told, and the rest is traced without it.
    named = ("not-carried-out", "traced-as-written")
    refused = [it for it in answer["findings"] if it["severity"] == "error" or it["code"] in named]
    word = lambda it: str(it.get("params", {}).get("word", "")) if it["code"] in named else ""
    return machine.records, [" ".join(filter(None, [it["code"], word(it), f"line {it['line']}"])) for it in refused]


def close(a, b, near=NEAR):
    if isinstance(a, float) or isinstance(b, float):
        return math.isclose(a, b, abs_tol=near)
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(close(float(x), float(y), near) for x, y in zip(a, b))
    return a == b


def alike(a, b, near=NEAR):
    """Whether two records say the same; a feed by time depends on lengths, which are rounded."""
    far = lambda key: max(near, abs(a[key]) * 5e-5) if key == "feed" else near
    return all(key in a and key in b and close(a[key], b[key], far(key)) for key in (a.keys() | b.keys()) - {"line"})


def line_of(record):
    """A record as tests/programs-linuxcnc/*/rs274 has it: numbers to the micrometre."""
    number = lambda value: f"{round(value, 3) + 0.0:.3f}"
    words = [record["kind"]] + [f"{letter}{number(value)}" for letter, value in zip("XYZ", record["at"])]
    if record["kind"] == "arc":
        words += [record["sense"], record["plane"], *map(number, record["centre"]), f"turns {record['turns']}"]
    if "feed" in record:
        words.append(f"F{number(record['feed'])}")
    if "seconds" in record:
        words.append(f"seconds {number(record['seconds'])}")
    words.append(f"spindle {record['spindle']}" + (f" {number(record['speed'])}" if "speed" in record else ""))
    words.append("coolant on" if record["coolant"] else "coolant off")
    words.append(f"T{record['tool']}")
    return " ".join(words)


def compare(technolog, program, setting_file, machine_id, write):
    """What is wrong with a program, or nothing; and how many records were compared."""
    setting = read_setting(setting_file)
    theirs, refused = of_rs274(program, setting, setting.get("skip") == "true")
    if write:
        lines = [f"refused: {refused}"] if refused else [line_of(record) for record in theirs]
        (program.parent / "rs274").write_text("\n".join(lines) + "\n")
    ours, errors = of_technolog(technolog, program, setting_file, machine_id)
    if refused:
        return (None, 0, "both refuse") if errors else (f"rs274 refuses ({refused}), we do not", 0, "")
    if errors:
        return None, 0, "we alone refuse: " + ", ".join(errors)
    for index, (a, b) in enumerate(zip(theirs, ours)):
        if not alike(a, b):
            return f"motion {index + 1}\n    rs274: {line_of(a)}\n    ours:  {line_of(b)}", index, ""
    if len(theirs) != len(ours):
        return f"rs274 makes {len(theirs)} motions, we {len(ours)}", 0, ""
    return None, len(theirs), ""


def written(technolog, part, folder):
    """The program that we write for a part, its setting and its machine beside it; None where the part has none."""
    own = folder / part.stem
    own.mkdir()
    program = own / f"{part.stem}.ngc"
    command = [technolog, "program", str(part), "--control", "linuxcnc"]
    for more in (["-o", str(program)], ["--show", "setting", "-o", str(own / "setting.yaml")]):
        # Code 1: something was found wrong with the part, such as a clamp near a hole; its program is there all the same.
        if subprocess.run(command + more, capture_output=True, text=True).returncode == 2:
            return None
    found = re.search(r"^machine: *(\S+)", part.read_text(), re.M)
    (own / "machine").write_text(found.group(1) if found else "gf2171")
    return program


def parts_of(root):
    """The example parts, and the part of the tests that needs every cycle. Shafts have no holes."""
    files = sorted((root / "examples").glob("*.yaml")) + [root / "tests/written/every-cycle.yaml"]
    return [file for file in files if re.search(r"^part:", file.read_text(), re.M)]


# Before a call: what the user interfaces that make such calls write first.
PREAMBLE = "G17 G21 G40 G49 G54 G80 G90 G94 F100 S500 M3\n"


def subprogram(text, name):
    """Whether a file holds the subprogram of its own name, without what ends the file."""
    if not re.search(r"^[^(;]*?o<" + re.escape(name) + r">\s*sub\b", text, re.M | re.I):
        return None
    return re.sub(r"^\s*(m0*2|m30|%)\s*$", "", text, flags=re.M | re.I)


def called(name, subprograms):
    """A program that calls a subprogram by the defaults its comments give, `#<x> = #1 (=0.5)`, all that it calls before it."""
    needed, texts = {name: None}, []
    while len(texts) < len(needed):
        text = subprograms[list(needed)[len(texts)]]
        texts.append(text)
        calls = [call.lower() for call in re.findall(r"o<([^>]+)>\s*call", text, re.I)]
        needed |= {call: None for call in calls if call in subprograms}
    given = dict(re.findall(r"=\s*#(\d+)\s*\(=\s*([-+.\d]+)", subprograms[name]))
    last = max(map(int, given), default=0)
    arguments = " ".join(f"[{given.get(str(number), '0')}]" for number in range(1, last + 1))
    return "\n".join(texts) + f"\n{PREAMBLE}o<{name}> call {arguments}\nM2\n"


def programs_of(folders):
    """Every program of the folders; of a file that is a subprogram, a call of it instead."""
    for folder in folders:
        files = sorted(folder.rglob("*.ngc")) if folder.is_dir() else [folder]
        texts = {file: file.read_text(errors="replace") for file in files}
        found = {file: subprogram(text, file.stem) for file, text in texts.items()}
        subprograms = {file.stem.lower(): text for file, text in found.items() if text}
        for file, text in texts.items():
            name = str(file.relative_to(folder)) if folder.is_dir() else str(file)
            if found[file]:
                yield f"{name} (called)", called(file.stem.lower(), subprograms | {file.stem.lower(): found[file]})
            else:
                yield name, text


def survey(technolog, folders):
    """Which of the programs that rs274 accepts are traced with its motions, and of the others why not."""
    rows, known = [], set()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "program.ngc"
        for name, text in programs_of(folders):
            # The package has some files twice.
            if text in known:
                continue
            known.add(text)
            theirs, refused = of_rs274_text(text, {}, False)
            if refused:
                rows.append(("rs274 refuses", name, refused))
                continue
            file.write_text(text)
            begin = time.monotonic()
            ours, errors = of_technolog(technolog, file, None, None)
            took = time.monotonic() - begin
            inches = re.search(r"G20", text, re.I)
            differ = next((f"motion {index + 1} line {b.get('line')}: rs274 {line_of(a)} | we {line_of(b)}"
                           for index, (a, b) in enumerate(zip(theirs, ours)) if not alike(a, b, 0.0031 if inches else NEAR)), None)
            if not differ and len(theirs) != len(ours):
                differ = f"rs274 makes {len(theirs)} motions, we {len(ours)}"
            named = [error for error in errors if error.startswith(("not-carried-out", "traced-as-written"))]
            others = [error for error in errors if error not in named]
            about = f"{len(theirs)} motions, {took:.1f} s"
            if others:
                rows.append(("refused", name, f"{', '.join(others[:3])} ({about})"))
            elif named:
                rows.append(("named", name, f"{', '.join(named)} ({about}{'' if differ else ', the same'})"))
            elif differ:
                rows.append(("different", name, differ))
            else:
                rows.append(("same" if theirs else "same, nothing moves", name, about))
    for row in sorted(rows):
        print(": ".join(row))
    for kind in sorted({row[0] for row in rows}):
        print(f"{sum(row[0] == kind for row in rows):4} {kind}")
    accepted = sum(row[0] != "rs274 refuses" for row in rows)
    # A word that is told and moves none of X, Y, Z there leaves the motions the same; a further axis would move.
    told = lambda row: row[0] == "named" and row[2].endswith(", the same)") and not re.search(r"out [A-CU-W] ", row[2])
    same = sum(row[0].startswith("same") or told(row) for row in rows)
    print(f"{same} of {accepted} programs that rs274 accepts are traced with its motions: {100 * same / max(accepted, 1):.1f} %")
    return 1 if any(row[0] == "different" for row in rows) or same * 194 < accepted * 150 else 0


SETTING = """start: {x: 0, y: 0, z: 0}
zeros:
  G54: {x: 10, y: -20, z: -100}
  G55: {x: 20, y: 10, z: -150.5}
correctors: {1: 20, 2: 15.5, 3: -10.25, 4: 0}
"""


def random_block(draw):
    """A block as programs have them; most of them are right."""
    number = lambda low, high: f"{draw.choice([draw.randint(low, high), round(draw.uniform(low, high), 3)])}"
    axes = lambda low=-20, high=20: " ".join(
        letter + number(low, high) for letter in draw.sample("XYZ", draw.randint(1, 3)))
    cycle = lambda: draw.choice(["G81", "G82 P0.5", "G83 Q3", "G73 Q4.5", "G85", "G86 P0.2", "G89 P0.1", "G84"])
    # LinuxCNC 2.9 exchanges the axes of G84 outside G17, and we refuse it.
    flat = lambda word: "G81" if word == "G84" else word
    return draw.choice([
        lambda: f"G0 {axes()}",
        lambda: f"G1 {axes()}",
        axes,
        lambda: f"G{draw.choice([2, 3])} X{number(-20, 20)} Y{number(-20, 20)} R{number(30, 60)}",
        lambda: f"G91 G{draw.choice([2, 3])} X4 I2 J0 {draw.choice(['', 'Z-1', 'P2'])}\nG90",
        lambda: f"{draw.choice(['G90', 'G91'])} {axes()}",
        lambda: draw.choice(["G17", "G17", "G18", "G19"]),
        lambda: draw.choice(["G54", "G55", "G98", "G99", "G80", "G90", "G91", "M8", "M9", "M3", "M4", "M5"]),
        lambda: f"{cycle()} X{number(-9, 9)} Y{number(-9, 9)} Z{number(-30, -5)} R{number(0, 9)}",
        lambda: f"G91 {cycle()} X{number(-9, 9)} Y2 Z-4 R{number(-3, 3)} L2\nG90 G80",
        lambda: f"G18 {flat(cycle())} X{number(-9, 9)} Z{number(-9, 9)} Y{number(-30, -5)} R{number(0, 9)}\nG80 G17",
        lambda: f"G19 {flat(cycle())} Y{number(-9, 9)} Z{number(-9, 9)} X{number(-30, -5)} R{number(0, 9)}\nG80 G17",
        lambda: f"G10 L{draw.choice([2, 20])} P{draw.randint(0, 2)} {axes()}",
        lambda: f"G10 L{draw.choice([1, 10, 11])} P{draw.randint(1, 3)} Z{number(-9, 20)}",
        lambda: f"{draw.choice(['G92', 'G52'])} {axes()}",
        lambda: draw.choice(["G92.1", "G92.2", "G92.3"]),
        lambda: draw.choice(["G43 H1", "G43 H2", "G49", "G43.1 Z5.5", "G43.2 H3", "T2 M6", "T1 M6\\nG43"]),
        lambda: f"{draw.choice(['', 'G0 ', 'G91 '])}@{number(1, 20)} ^{number(-180, 180)}\nG90",
        lambda: f"{draw.choice(['@', '^'])}{number(1, 20)}",
        lambda: f"G7 X{number(-20, 20)}\nG8",
        lambda: f"G93 G1 {axes()} F{draw.randint(1, 9)}\nG94 F100",
        lambda: f"G95 G1 {axes()} F0.2\nG94 F100",
        lambda: f"G33 Z{number(-9, 9)} K1.5\nG0",
        lambda: f"G33.1 Z-9 K1\nG0",
        lambda: f"#{draw.randint(1, 3)}=[#{draw.randint(1, 3)}{draw.choice(['+2', '*3', ' MOD 4', '-5', '/2'])}]",
        lambda: f"X#{draw.randint(1, 3)} Y[#5421+1]",
        lambda: f"o{draw.randint(10, 99)} call [{number(0, 3)}]",
        lambda: "M70",
        lambda: "M72",
        lambda: f"G28 {axes()}",
        lambda: f"G53 G0 {axes(-50, -1)}",
        lambda: f"G4 P{number(0, 2)}",
        lambda: f"G91.1 G90.1 " if draw.random() < 0.1 else "G64",
    ])()


def random_program(draw):
    lines, subs, serial = ["G21 G90 G17 F100 S475 M3"], [], 100
    for _ in range(draw.randint(2, 6)):
        serial += 10
        inner = "\n".join(random_block(draw) for _ in range(draw.randint(1, 2)))
        compare_ = draw.choice(["LT", "GT", "EQ", "NE", "LE", "GE"])
        lines.append(draw.choice([
            inner, inner, inner, inner,
            f"o{serial} if [#{draw.randint(1, 3)} {compare_} {draw.randint(0, 4)}]\n{inner}\no{serial} else\nY1\no{serial} endif",
            f"o{serial} repeat [{draw.randint(0, 3)}]\n{inner}\no{serial} endrepeat",
            f"#9=0\no{serial} while [#9 LT 3]\n#9=[#9+1]\n{inner}\no{serial} endwhile",
            f"#9=0\no{serial} do\n#9=[#9+1]\n{inner}\no{serial} while [#9 LT 2]",
        ]))
    text = "\n".join(lines)
    for name in sorted(set(re.findall(r"o(\d+) call", text))):
        keeps = draw.choice(["", "M73\n"])
        inner = "\n".join(block for block in (random_block(draw) for _ in range(2)) if "call" not in block)
        subs.append(f"o{name} sub\n{keeps}{inner}\nX#1\no{name} endsub [#1+1]")
    return "\n".join(subs + [text, "X[#<_value>/10]" if subs and "call" in text else "G80", "M2"]) + "\n"


def compare_random(technolog, count, seed):
    """Programs of random words: where both carry them out, the motions are the same; what rs274 refuses is an error."""
    draw, wrong, compared, alone, both = random.Random(seed), 0, 0, {}, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "setting.yaml").write_text(SETTING)
        for index in range(count):
            (folder / "program.ngc").write_text(random_program(draw))
            problem, motions, note = compare(technolog, folder / "program.ngc", folder / "setting.yaml", "ir500pmf4", False)
            compared += motions
            both += note == "both refuse"
            if note.startswith("we alone"):
                code = note.split(": ")[1].split(" line")[0]
                alone[code] = alone.get(code, 0) + 1
            if problem:
                wrong += 1
                print(f"--- program {index}: {problem}\n{(folder / 'program.ngc').read_text()}")
    print(f"{count} programs, {compared} motions compared, {both} refused by both, {wrong} differ; we alone refuse {alone}")
    return 1 if wrong else 0


def main(arguments):
    if not shutil.which("rs274"):
        print("rs274 is not installed (Debian package linuxcnc-uspace): nothing compared")
        return 0
    write, survey_only = "--write" in arguments, "--survey" in arguments
    options = {"--setting": None, "--machine": None, "--random": None, "--seed": "1"}
    names = []
    rest = iter(argument for argument in arguments if argument not in ("--write", "--survey"))
    for argument in rest:
        if argument in options:
            options[argument] = next(rest)
        else:
            names.append(argument)
    if not names:
        print(__doc__)
        return 2
    technolog, names = str(pathlib.Path(names[0]).resolve()), names[1:]
    if options["--random"]:
        return compare_random(technolog, int(options["--random"]), int(options["--seed"]))
    if survey_only:
        package = [pathlib.Path("/usr/share/linuxcnc/ncfiles"), pathlib.Path("/usr/share/doc/linuxcnc/examples")]
        folders = [pathlib.Path(name) for name in names] or [folder for folder in package if folder.is_dir()]
        if not folders:
            print("no programs of the package linuxcnc-uspace are installed: nothing surveyed")
            return 0
        return survey(technolog, folders)
    root = pathlib.Path(__file__).resolve().parents[2]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        programs = []
        for path in map(pathlib.Path, names or [root / "tests/programs-linuxcnc"]):
            programs += sorted(path.rglob("*.ngc")) if path.is_dir() else [path]
        if not names:
            parts = [written(technolog, part, folder) for part in parts_of(root)]
            programs += [program for program in parts if program]
            print(f"{sum(program is not None for program in parts)} of {len(parts)} example parts have a program")
        wrong, motions, refused = 0, 0, 0
        for program in programs:
            beside = program.parent / "setting.yaml"
            setting = beside if beside.exists() else options["--setting"] and pathlib.Path(options["--setting"])
            machine = program.parent / "machine"
            machine = machine.read_text().strip() if machine.exists() else options["--machine"] or "ir500pmf4"
            problem, compared, note = compare(technolog, program, setting, machine, write)
            motions += compared
            refused += bool(note)
            label = program.parent.name if program.name == "program.ngc" else program.name
            if problem:
                wrong += 1
                print(f"{label}: {problem}")
            elif note:
                print(f"{label}: {note}")
        print(f"{len(programs)} programs, {motions} motions compared, {refused} refused, {wrong} differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
