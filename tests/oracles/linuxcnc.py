"""Our interpreter of LinuxCNC beside LinuxCNC's own, rs274 of the Debian package linuxcnc-uspace.

    cargo build
    python3 tests/oracles/linuxcnc.py target/debug/technolog                 # tests/programs-linuxcnc, examples/*.yaml
    python3 tests/oracles/linuxcnc.py target/debug/technolog a.ngc folder    # these files, and the .ngc of this folder
    python3 tests/oracles/linuxcnc.py target/debug/technolog --write         # writes `rs274` beside every test program
    python3 tests/oracles/linuxcnc.py target/debug/technolog --random 500    # programs of random words, by --seed

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
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_tables(setting, folder)
        command = ["rs274", "-g", "-n", "2", "-t", "tool.tbl", "-v", "rs274.var"] + (["-b"] if skip else [])
        # Under its own folder: rs274 writes beside itself.
        (folder / "program.ngc").write_text(program.read_text())
        try:
            answer = subprocess.run(command + ["program.ngc"], capture_output=True, text=True, cwd=folder, timeout=5)
        except subprocess.TimeoutExpired:
            return [], "it does not end in 5 s"
    machine = Machine()
    start = setting.get("start", {})
    machine.at = tuple(start.get(letter, 0.0) for letter in "xyz")
    scale, g5x, g92, length = 1.0, [0.0] * 3, [0.0] * 3, [0.0] * 3
    plane, feed, ended = "XY", 0.0, False
    numbers = lambda text: [float(number) for number in re.findall(r"-?\d+\.?\d*", text)]
    for line in answer.stdout.splitlines():
        found = re.match(r"\s*\d+ N\S+\s+(\w+)\((.*)\)", line)
        if not found:
            continue
        name, text = found.groups()
        values = numbers(text)
        on_machine = lambda three: tuple(
            value * scale + a + b + c for value, a, b, c in zip(three, g5x, g92, length))
        if name == "USE_LENGTH_UNITS":
            scale = 25.4 if "INCHES" in text else 1.0
        elif name == "SET_G5X_OFFSET":
            g5x = [value * scale for value in values[1:4]]
        elif name == "SET_G92_OFFSET":
            g92 = [value * scale for value in values[:3]]
        elif name == "USE_TOOL_LENGTH_OFFSET":
            length = [value * scale for value in values[:3]]
        elif name == "SET_FEED_RATE":
            feed = values[0] * scale
        elif name == "SELECT_PLANE":
            plane = {"XY": "XY", "XZ": "ZX", "YZ": "YZ"}[text[-2:]]
        elif name == "STRAIGHT_TRAVERSE":
            machine.go("rapid", on_machine(values[:3]))
        elif name == "STRAIGHT_FEED":
            machine.go("feed", on_machine(values[:3]), feed=feed)
        elif name == "ARC_FEED":
            axes = [0, 1, 2] if plane == "XY" else [2, 0, 1] if plane == "ZX" else [1, 2, 0]
            end, middle = [0.0] * 3, [0.0] * 3
            for axis, value, centre in zip(axes, [values[0], values[1], values[5]], [values[2], values[3], 0.0]):
                end[axis], middle[axis] = value, centre
            turn = int(values[4])
            middle = on_machine(middle)
            machine.go("arc", on_machine(end), feed=feed, plane=plane, turns=abs(turn) - 1,
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
    command = [technolog, "check", str(program), "--control", "linuxcnc", "--machine", machine_id, "--format", "json"]
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
        for record in machine.records[before:]:
            record["line"] = step["line"]
    return machine.records, [f"{it['code']} line {it['line']}" for it in answer["findings"] if it["severity"] == "error"]


def close(a, b):
    if isinstance(a, float) or isinstance(b, float):
        return math.isclose(a, b, abs_tol=NEAR)
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(close(float(x), float(y)) for x, y in zip(a, b))
    return a == b


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
        keys = (a.keys() | b.keys()) - {"line"}
        if not all(key in a and key in b and close(a[key], b[key]) for key in keys):
            return f"motion {index + 1}\n    rs274: {line_of(a)}\n    ours:  {line_of(b)}", index, ""
    if len(theirs) != len(ours):
        return f"rs274 makes {len(theirs)} motions, we {len(ours)}", 0, ""
    return None, len(theirs), ""


def written(technolog, part, folder):
    """The program that we write for a part, where the command is there and the part can be made."""
    program = folder / f"{part.stem}.ngc"
    command = [technolog, "program", str(part), "--control", "linuxcnc", "-o", str(program)]
    answer = subprocess.run(command, capture_output=True, text=True)
    return program if answer.returncode == 0 and program.exists() else None


SETTING = """zeros:
  G54: {x: 10, y: -20, z: -250}
  G55: {x: 30, y: 0, z: -240.5}
correctors: {1: 20, 2: -5.5, 3: 10.25}
fixed_point: {x: 0, y: 50, z: 0}
"""


def of_random(seed):
    """A program of random words, most of which LinuxCNC carries out."""
    chance = random.Random(seed)
    number = lambda low, high: f"{chance.randint(low * 100, high * 100) / 100:g}"
    maybe = lambda text, odds=0.5: text if chance.random() < odds else ""
    axes = lambda: " ".join(maybe(f"{letter}{number(-30, 30)}") for letter in "XY")

    def cycle():
        code = chance.choice([73, 81, 82, 83, 84, 85, 86, 89])
        words = f"G{code} {axes()} " + maybe(f"Z{number(-20, -8)} ", 0.85) + maybe(f"R{number(-6, 12)} ", 0.85)
        words += maybe(f"P0.{chance.randint(1, 9)} ", 0.95 if code in (82, 86, 89) else 0.1)
        return words + maybe(f"Q{number(1, 9)} ", 0.95 if code in (73, 83) else 0.02) + maybe(f"L{chance.randint(1, 3)}", 0.2)

    kinds = [
        lambda: f"G0 {axes()} " + maybe(f"Z{number(0, 40)}"),
        lambda: f"G1 {axes()} " + maybe(f"Z{number(-20, 40)} ") + maybe(f"F{chance.randint(50, 500)}"),
        lambda: f"G{chance.choice([2, 3])} X{number(-30, 30)} Y{number(-30, 30)} " + maybe(f"Z{number(0, 20)} ", 0.2)
        + f"R{chance.choice(['', '-'])}{number(25, 90)} " + maybe(f"P{chance.randint(1, 3)}", 0.2),
        lambda: f"G{chance.choice([2, 3])} I{number(-9, 9)} J{number(-9, 9)}",
        cycle, cycle, cycle,
        axes, axes, axes,
        lambda: maybe(f"Z{number(-20, -8)} ") + maybe(f"R{number(-6, 12)} ", 0.3) + axes() + maybe(f" L{chance.randint(1, 3)}", 0.1),
        lambda: chance.choice(["G90", "G91", "G98", "G99", "G98", "G99", "G80", "G54", "G55", "G49", "G17", "G0 Z30", "G90 G0 Z30"]),
        lambda: f"G43 H{chance.randint(1, 3)} " + maybe("G0 Z30"),
        lambda: chance.choice(["M3", "M4", "M5", "M3", "M8", "M9", "M7", "G4 P0.5", f"S{chance.choice([475, 600])}"]),
        # At M6 rs274 takes the position of its last motion for the one in force, whatever offset has changed since: a
        # fault of the interpreter without a machine. A motion before it keeps that out.
        lambda: f"G90 G53 G0 Z0\nT{chance.randint(1, 5)} M6 M3",
        lambda: f"G53 G0 {axes()} " + maybe("Z0"),
        lambda: f"G{chance.choice([28, 30])} " + maybe(axes()) + maybe("Z30", 0.2),
    ]
    blocks = ["G21 G90 G17 G40 G49 G80 G54 G94", "T1 M6", "S475 M3 F120", "G0 X0 Y0 Z25"]
    blocks += [chance.choice(kinds)() for _ in range(chance.randint(5, 25))]
    return "\n".join(blocks) + "\nM2\n"


def compare_random(technolog, count, seed):
    """Random programs: rs274 reads them up to its first error, and up to there the motions must agree."""
    wrong, motions, whole, names = 0, 0, 0, {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        setting = folder / "setting.yaml"
        setting.write_text(SETTING)
        for index in range(seed, seed + count):
            program = folder / "random.ngc"
            program.write_text(of_random(index))
            theirs, refused = of_rs274(program, read_setting(setting), False)
            ours, errors = of_technolog(technolog, program, setting, "ir500pmf4")
            if not refused and not errors:
                whole += 1
            for error in errors:
                names[error.split()[0]] = names.get(error.split()[0], 0) + 1
            problem = ""
            if refused and not errors:
                problem = f"rs274 refuses ({refused}), we do not"
            # A block of ours with an error makes no motions, and theirs may have begun it.
            until = min(len(theirs), len(ours)) if errors or refused else max(len(theirs), len(ours))
            lines = [int(error.rsplit(" ", 1)[1]) for error in errors]
            for place, (a, b) in enumerate(zip(theirs[:until], ours[:until])):
                if lines and b["line"] >= min(lines):
                    break
                a, b = dict(a), dict(b)
                a.pop("line", None), b.pop("line", None)
                motions += 1
                if not all(key in a and key in b and close(a[key], b[key]) for key in a.keys() | b.keys()):
                    problem = problem or f"motion {place + 1}\n    rs274: {line_of(a)}\n    ours:  {line_of(b)}"
                    break
            if not refused and not errors and len(theirs) != len(ours):
                problem = problem or f"rs274 makes {len(theirs)} motions, we {len(ours)}"
            if problem:
                wrong += 1
                print(f"seed {index}: {problem}\n{program.read_text()}")
    print(f"{count} random programs, {whole} without error, {motions} motions compared, {wrong} differ")
    print("our errors:", ", ".join(f"{name} {count}" for name, count in sorted(names.items())))
    return 1 if wrong else 0


def main(arguments):
    if not shutil.which("rs274"):
        print("rs274 is not installed (Debian package linuxcnc-uspace): nothing compared")
        return 0
    write = "--write" in arguments
    options = {"--setting": None, "--machine": None, "--random": None, "--seed": "1"}
    names = []
    rest = iter(argument for argument in arguments if argument != "--write")
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
    root = pathlib.Path(__file__).resolve().parents[2]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        programs = []
        for path in map(pathlib.Path, names or [root / "tests/programs-linuxcnc"]):
            programs += sorted(path.rglob("*.ngc")) if path.is_dir() else [path]
        if not names:
            parts = [written(technolog, part, folder) for part in sorted((root / "examples").glob("*.yaml"))]
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
