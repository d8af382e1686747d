"""Our reader of programs for lathes beside LinuxCNC's own interpreter, rs274 of the Debian package linuxcnc-uspace (2.9).

    cargo build --bin technolog --example lathe_programs
    python3 tests/oracles/lathe_read.py target/debug/technolog target/debug/examples/lathe_programs 200 1
    python3 tests/oracles/lathe_read.py target/debug/technolog a.ngc folder     # these programs
    python3 tests/oracles/lathe_read.py target/debug/technolog --random 200 1   # contours and threads of this script

The motions of `technolog check --control linuxcnc-lathe` are compared with those of rs274, one by one: kind, end, feed, of
arcs centre and sense, of threads the lead, to 0.001 mm. Motions that do not move are left out on both sides, and so is the
first way of rs274 as long as we do not know where it begins. Ways to a reference point are taken out of the program. What we refuse and rs274 carries out is counted and named.

Programs of the writer with single moves are held against the moves of the way, too, which rs274 has no part in.

Where rs274 is not installed the script says so and ends with 0.
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

NEAR = 0.0011


def of_rs274(program):
    """Motions as (kind, radius, z, feed or lead, centre, sense), or why it refuses."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "program.ngc").write_text(program)
        zero = [5161 + i for i in range(9)] + [5181 + i for i in range(9)] + [5211 + i for i in range(9)]
        zero += [5221 + 20 * system + i for system in range(9) for i in range(10)]
        lines = sorted([f"{number} 0" for number in zero] + ["5220 1"], key=lambda line: int(line.split()[0]))
        (folder / "rs274.var").write_text("\n".join(lines) + "\n")
        (folder / "tool.tbl").write_text("".join(f"T{tool} P{tool} X0 Z0 D0\n" for tool in range(1, 30)))
        command = ["rs274", "-g", "-n", "2", "-t", "tool.tbl", "-v", "rs274.var", "program.ngc"]
        try:
            answer = subprocess.run(command, capture_output=True, text=True, cwd=folder, timeout=20)
        except subprocess.TimeoutExpired:
            return [], "it does not end in 20 s"
    found, feed, lead, at = [], 0.0, None, None
    for line in answer.stdout.splitlines():
        match = re.match(r"\s*\d+ N\S+\s+(\w+)\((.*)\)", line)
        if not match:
            continue
        name, text = match.groups()
        values = [float(number) for number in re.findall(r"-?\d+\.?\d*", text)]
        end = None
        if name == "SET_FEED_RATE":
            feed = values[0]
        elif name == "START_SPEED_FEED_SYNC":
            lead = values[0]
        elif name == "STOP_SPEED_FEED_SYNCH":
            lead = None
        elif name == "DWELL":
            found.append(("dwell", None, None, values[0], None, 0))
        elif name == "STRAIGHT_TRAVERSE":
            end = ("rapid", values[0], values[2], None, None, 0)
        elif name == "STRAIGHT_FEED" and lead is not None:
            end = ("thread", values[0], values[2], lead, None, 0)
        elif name == "STRAIGHT_FEED":
            end = ("feed", values[0], values[2], feed, None, 0)
        elif name == "ARC_FEED":
            # In the plane ZX the first axis is Z, the second X.
            end = ("arc", values[1], values[0], feed, (values[3], values[2]), 1 if values[4] > 0 else -1)
        if end:
            moved = at is None or math.hypot(end[1] - at[0], end[2] - at[1]) > NEAR or end[0] == "arc"
            at = end[1:3]
            if moved:
                found.append(end)
    if answer.returncode:
        lines = [line for line in answer.stderr.splitlines() if line.strip() and line.strip() != "executing"]
        return found, lines[0].strip() if lines else "refused"
    return found, None


def of_ours(technolog, program):
    """The same of ours, and the codes of what is wrong."""
    with tempfile.TemporaryDirectory() as name:
        file = pathlib.Path(name) / "program.ngc"
        file.write_text(program)
        command = [technolog, "check", str(file), "--control", "linuxcnc-lathe", "--format", "json", "--lang", "en"]
        answer = subprocess.run(command, capture_output=True, text=True)
    if not answer.stdout.startswith("{"):
        return [], [answer.stderr.strip().splitlines()[0] if answer.stderr.strip() else "no answer"]
    told, found, at = json.loads(answer.stdout), [], None
    for motion in told["trace"]:
        kind, to = motion["kind"], motion["to"]
        if kind == "dwell":
            found.append(("dwell", None, None, motion["seconds"], None, 0))
        if kind not in ("rapid", "feed", "arc", "thread"):
            continue
        end = (to["radius_mm"], to["z_mm"])
        if None in end:
            at = None
            continue
        value, centre, sense = None, None, 0
        if kind == "thread":
            value = motion["lead"]
        elif kind != "rapid":
            value = next(iter(motion["feed"].values()))
        if kind == "arc":
            centre = (motion["centre"]["radius_mm"], motion["centre"]["z_mm"])
            sense = 1 if motion["sense"] == "counterclockwise" else -1
        moved = at is None or math.hypot(end[0] - at[0], end[1] - at[1]) > NEAR or kind == "arc"
        at = end
        if moved:
            found.append((kind, *end, value, centre, sense))
    wrong = [f["code"] for f in told["findings"] if f["severity"] in ("error",)]
    return found, wrong


def same(ours, theirs):
    """Whether two motions are one."""
    near = lambda a, b: (a is None and b is None) or (a is not None and b is not None and abs(a - b) <= NEAR)
    if ours[0] != theirs[0] or ours[5] != theirs[5] or not all(near(a, b) for a, b in zip(ours[1:4], theirs[1:4])):
        return False
    return ours[4] is None or all(near(a, b) for a, b in zip(ours[4], theirs[4]))


def compare(technolog, program):
    """What differs, or None; how many motions; whether it was refused by one side."""
    # Where a reference point lies in the system of the part is not known to us: the ways there are left out.
    program = re.sub(r"(?m)^.*\bG(28|30|53)\b.*$", "", program)
    theirs, refused = of_rs274(program)
    ours, wrong = of_ours(technolog, program)
    if refused and wrong:
        return None, 0, "both refuse"
    if wrong:
        return None, 0, "only we refuse: " + " ".join(sorted(set(wrong)))
    if refused:
        return f"rs274 refuses, we do not: {refused}", 0, None
    # Our position is known as soon as both axes are.
    if len(theirs) > len(ours) and ours:
        theirs = theirs[len(theirs) - len(ours):]
    for number, (a, b) in enumerate(zip(ours, theirs), 1):
        if not same(a, b):
            return f"motion {number}: ours {a}, theirs {b}", number, None
    if len(ours) != len(theirs):
        return f"we make {len(ours)} motions, rs274 {len(theirs)}", 0, None
    return None, len(ours), None


def moves_of_way(technolog, told):
    """What differs between our reading and the moves that the writer was given."""
    ours, wrong = of_ours(technolog, told["program"])
    if wrong:
        return "refused: " + " ".join(wrong)
    at, moves = told["from"], []
    for move in told["moves"]:
        kind = "rapid" if move["feed"] is None else "arc" if "radius" in move else "feed"
        moved = math.hypot(move["to"][0] - at[0], move["to"][1] - at[1]) > NEAR or kind == "arc"
        at = move["to"]
        centre = (move["centre"][0], -move["centre"][1]) if kind == "arc" else None
        sense = 0 if kind != "arc" else (-1 if move["left"] else 1)
        if moved:
            moves.append((kind, at[0], -at[1], move["feed"], centre, sense))
    if len(ours) != len(moves) + 1:
        return f"{len(ours)} motions, the way has {len(moves)} moves"
    for number, (a, b) in enumerate(zip(ours[1:], moves), 1):
        if not same(a, b):
            return f"move {number}: read {a}, written {b}"
    return None


START = "G18 G21 G7 G40 G90 G95\nG54 G61\nT1 M6 G43\nG97 S800 M3\n"


def random_program(dice):
    """A program of threads, expressions, subprograms, arcs by I and K, G70."""
    lines, r3 = [START + "F0.2"], lambda value: round(value, 3)
    for _ in range(dice.randint(1, 4)):
        kind = dice.choice(["thread", "thread", "g33", "moves", "finish", "sub"])
        x, z = r3(dice.uniform(20, 60)), r3(dice.uniform(2, 6))
        lines.append(f"G0 X{x} Z{z}")
        if kind == "thread":
            crest = r3(dice.choice([-1, 1]) * dice.uniform(0.5, 3))
            depth = r3(dice.uniform(0.5, 2))
            first = r3(depth * dice.uniform(0.1, 0.9))
            text = f"G76 P{r3(dice.uniform(0.5, 3))} Z{r3(-dice.uniform(5, 30))} I{crest} J{first} K{depth}"
            if dice.random() < 0.7:
                text += f" R{r3(dice.uniform(1, 2.5))}"
            if dice.random() < 0.7:
                text += f" Q{dice.choice([29, 29.5, 30])}"
            if dice.random() < 0.5:
                text += f" H{dice.randint(0, 3)}"
            if dice.random() < 0.5:
                text += f" E{r3(dice.uniform(0.5, 2))} L{dice.randint(0, 3)}"
            lines.append(text)
        elif kind == "g33":
            lines += [f"G33 Z{r3(-dice.uniform(5, 20))} K{r3(dice.uniform(0.5, 3))}", f"G0 X{x + 5}"]
        elif kind == "moves":
            lines += [f"#1=[{x}/2 + 1]", "G1 X[#1*2] F[0.1+0.05]", "G91", "G1 X-4 Z-3", "G3 X4 Z-2 I0 K-2" if False else "G1 Z-2",
                      "G90", "G4 P0.5"]
            radius = r3(dice.uniform(1, 5))
            lines += [f"G0 X{x} Z0", f"G2 X{r3(x + 2 * radius)} Z{-radius} I{radius} K0", f"G3 X{r3(x + 4 * radius)} Z{r3(-2 * radius)} I0 K{-radius}"]
        elif kind == "finish":
            number = dice.randint(100, 999)
            lines += [f"o{number} sub", f"G0 X{x} Z{z}", "G1 Z-5", f"X{x + 10} Z-12", f"G2 X{x + 14} Z-14 R2", "G1 Z-20", f"o{number} endsub",
                      f"G70 Q{number} X{x + 20} Z{z + 1}", "G0 X80"]
        else:
            number = dice.randint(1000, 1999)
            lines += [f"o{number} sub", "G91", "G1 X-1 Z-1", "G90", f"o{number} endsub", f"o{number} call", f"o{number} call"]
    return "\n".join(lines + ["G0 X100 Z100", "M5", "M2"]) + "\n"


def main(arguments):
    if not shutil.which("rs274"):
        print("rs274 is not installed (Debian package linuxcnc-uspace): nothing compared")
        return 0
    if len(arguments) < 2:
        print(__doc__)
        return 2
    technolog = str(pathlib.Path(arguments[0]).resolve())
    programs, ways = [], []
    if arguments[1] == "--random":
        dice = random.Random(int(arguments[3]) if len(arguments) > 3 else 1)
        programs = [(f"random {number}", random_program(dice)) for number in range(int(arguments[2]))]
    elif pathlib.Path(arguments[1]).suffix in (".ngc", "") and pathlib.Path(arguments[1]).is_dir() or arguments[1].endswith(".ngc"):
        for name in arguments[1:]:
            path = pathlib.Path(name)
            files = sorted(path.rglob("*.ngc")) if path.is_dir() else [path]
            programs += [(str(file), file.read_text()) for file in files]
    else:
        command = [str(pathlib.Path(arguments[1]).resolve()), *arguments[2:]]
        told = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
        told = [json.loads(line) for line in told]
        programs = [(f"{line['kind']} {number}", line["program"]) for number, line in enumerate(told, 1) if "program" in line]
        ways = [(f"way {number}", line) for number, line in enumerate(told, 1) if line["kind"] == "plain"]
    wrong, motions, counts = 0, 0, {}
    for name, program in programs:
        problem, count, refused = compare(technolog, program)
        motions += count
        kind = refused or ("differ" if problem else "agree")
        counts[kind] = counts.get(kind, 0) + 1
        if problem:
            wrong += 1
            print(f"{name}: {problem}")
            folder = pathlib.Path(tempfile.gettempdir()) / "lathe-read"
            folder.mkdir(exist_ok=True)
            (folder / f"{name.replace('/', '_').replace(' ', '-')}.ngc").write_text(program)
    read_back = 0
    for name, line in ways:
        problem = moves_of_way(technolog, line)
        read_back += 1
        if problem:
            wrong += 1
            print(f"{name}: {problem}")
    print(", ".join(f"{count} {kind}" for kind, count in sorted(counts.items())) + f"; {motions} motions; {read_back} ways read back")
    print(f"{wrong} differ" + (", see /tmp/lathe-read" if wrong else ""))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
