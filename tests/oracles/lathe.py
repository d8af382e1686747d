"""Our programs for lathes beside LinuxCNC's own interpreter, rs274 of the Debian package linuxcnc-uspace (2.9).

    cargo build --example lathe_programs
    python3 tests/oracles/lathe.py target/debug/examples/lathe_programs              # 200 of each kind, seed 1
    python3 tests/oracles/lathe.py target/debug/examples/lathe_programs 1000 7       # so many, by this seed
    python3 tests/oracles/lathe.py program.ngc                                       # the motions of one program
    CASES=100 OUT=/tmp/parts.jsonl cargo test --test turning operation::programs_for_rs274 -- --ignored
    python3 tests/oracles/lathe.py /tmp/parts.jsonl                                  # programs of whole operations

Programs of single moves: every STRAIGHT_TRAVERSE, STRAIGHT_FEED and ARC_FEED is compared with the move of the way: its end,
for arcs its centre and its sense, and the feed, to 0.001 mm. The sense is held twice: by the sign of ARC_FEED, and by
the way that an arc of that sign takes about its centre, which must be at most half a circle on the side that the way says.

Programs of set-ups: rs274 runs them to their end. What they do is held by the proof, which reads them back; the passes
that rs274 makes of threads, G33 or G76, begin where the planned ones do, to 0.005 mm.

Programs of several ways: the same for each way in its order, and between two ways nothing but rapids;
feeds that are not those of the work are counted by themselves.

Programs with G71 and G72: the motions of the cycle are cut out of the blank on paper, and then:
  below      how far the tool went below the contour, at most;
  left       how much stock is left over it, at most;
  rapid      how deep a rapid went through stock, at most;
  depth      the deepest pass beyond the stated depth, at most (passes across: along Z).
Each must be at most 0.002 mm: arcs are cut into chords here. The first two are measured square to the way, so that half a
micrometre along a steep place stays one.

Where rs274 is not installed the script says so and ends with 0.
"""

import collections
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

NEAR = 0.001 + 1e-4  # mm, and the rounding of the fourth place that rs274 prints
CUT = 0.002  # mm, for what is cut: chords of arcs and the printed places
STEP = 0.05  # mm between the places where the cut is looked at


def run(program):
    """What rs274 answers; None if it does not end."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "program.ngc").write_text(program)
        zero = [5161 + i for i in range(9)] + [5181 + i for i in range(9)] + [5211 + i for i in range(9)]
        zero += [5221 + 20 * system + i for system in range(9) for i in range(10)]
        lines = [f"{number} 0" for number in zero] + ["5220 1"]
        key = lambda line: int(line.split()[0])
        (folder / "rs274.var").write_text("\n".join(sorted(lines, key=key)) + "\n")
        (folder / "tool.tbl").write_text("".join(f"T{tool} P{tool} X0 Z0 D0\n" for tool in range(1, 21)))
        command = ["rs274", "-g", "-n", "2", "-t", "tool.tbl", "-v", "rs274.var", "program.ngc"]
        try:
            return subprocess.run(command, capture_output=True, text=True, cwd=folder, timeout=20)
        except subprocess.TimeoutExpired:
            return None


def calls(answer):
    """The canonical calls of an answer: name and figures."""
    for line in answer.stdout.splitlines():
        match = re.match(r"\s*\d+ N\S+\s+(\w+)\((.*)\)", line)
        if match:
            yield match.group(1), [float(number) for number in re.findall(r"-?\d+\.?\d*", match.group(2))]


def motions(program):
    """The motions of rs274 as (kind, radius, z, feed, centre, sign), or why it refuses."""
    answer = run(program)
    if answer is None:
        return [], "it does not end in 20 s"
    found, feed = [], 0.0
    for name, values in calls(answer):
        if name == "SET_FEED_RATE":
            feed = values[0]
        elif name == "STRAIGHT_TRAVERSE":
            found.append(("rapid", values[0], values[2], None, None, 0))
        elif name == "STRAIGHT_FEED":
            found.append(("feed", values[0], values[2], feed, None, 0))
        elif name == "ARC_FEED":
            # In the plane ZX the first axis is Z, the second X.
            found.append(("arc", values[1], values[0], feed, (values[3], values[2]), int(values[4])))
    if answer.returncode:
        lines = [line for line in answer.stderr.splitlines() if line.strip() and line.strip() != "executing"]
        return found, lines[0].strip() if lines else "refused"
    return found, None


def compare_threads(told):
    """Whether the passes of threads, which go in step with the spindle, begin where they are planned; and how many."""
    place, synchronous, passes = None, False, []
    for name, values in calls(run(told["program"])):
        if name == "START_SPEED_FEED_SYNC":
            synchronous = True
        elif name == "STOP_SPEED_FEED_SYNCH":
            synchronous = False
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            if synchronous and name == "STRAIGHT_FEED":
                passes.append(place)
            place = (values[0], values[2])
    if len(passes) != len(told["threads"]):
        return f"rs274 makes {len(passes)} passes of threads, {len(told['threads'])} are planned", 0
    for number, (theirs, ours) in enumerate(zip(passes, told["threads"]), 1):
        if max(abs(theirs[0] - ours[0]), abs(theirs[1] - ours[1])) > 0.005:
            return f"pass {number} of threads begins at {theirs}, not {ours}", number
    return None, len(passes)


def near(a, b):
    return abs(a - b) <= NEAR


def compare_plain(told):
    """What is wrong with a program of single moves, or None; and how many moves, and how many of them arcs."""
    theirs, refused = motions(told["program"])
    if refused:
        return f"rs274 refuses: {refused}", 0, 0
    if not theirs or theirs[0][0] != "rapid" or not (near(theirs[0][1], told["from"][0]) and near(theirs[0][2], -told["from"][1])):
        return "it does not begin with a rapid to where the way begins", 0, 0
    theirs, arcs = theirs[1:], 0
    if len(theirs) != len(told["moves"]):
        return f"rs274 makes {len(theirs)} motions, the way has {len(told['moves'])}", 0, 0
    for number, (motion, move) in enumerate(zip(theirs, told["moves"]), 1):
        kind, radius, z, feed, centre, sign = motion
        wanted = "rapid" if move["feed"] is None else "arc" if "radius" in move else "feed"
        if kind != wanted:
            return f"move {number} is {kind}, not {wanted}", number, arcs
        if not (near(radius, move["to"][0]) and near(z, -move["to"][1])):
            return f"move {number} ends at {radius} {z}, not {move['to']}", number, arcs
        if move["feed"] is not None and abs(feed - move["feed"]) > 1e-4:
            return f"move {number} has the feed {feed}, not {move['feed']}", number, arcs
        if kind != "arc":
            continue
        arcs += 1
        if not (near(centre[0], move["centre"][0]) and near(centre[1], -move["centre"][1])):
            return f"move {number} turns about {centre}, not {move['centre']}", number, arcs
        # Mirrored in Z, what bends left in the way goes clockwise, a negative turn from Z to X.
        if (sign < 0) != move["left"]:
            return f"move {number} turns by {sign}, left is {move['left']}", number, arcs
        begin = math.atan2(move["from"][0] - centre[0], -move["from"][1] - centre[1])
        end = math.atan2(radius - centre[0], z - centre[1])
        sweep = ((end - begin) * (1 if sign > 0 else -1)) % (2 * math.pi)
        if sweep > math.pi + 0.05 and abs(sweep - 2 * math.pi) > 0.05:
            return f"move {number} sweeps {math.degrees(sweep):.1f} degrees", number, arcs
    return None, len(theirs), arcs


def compare_ways(told):
    """The same for the program of several ways, one after the other, with rapids alone between them; then also how many
    feeds differ, which is no matter of the geometry."""
    theirs, refused = motions(told["program"])
    if refused:
        return f"rs274 refuses: {refused}", 0, 0, 0
    place, moves, arcs, feeds = 0, 0, 0, 0
    for index, way in enumerate(told["ways"], 1):
        first = way["moves"]
        # Links: rapids until one from which the way follows whole.
        for skip in range(4):
            begin = place + skip
            if begin and any(motion[0] != "rapid" for motion in theirs[place:begin]):
                return f"way {index}: something else than rapids leads to it", moves, arcs, feeds
            if first and begin >= len(theirs):
                return f"way {index} is not there", moves, arcs, feeds
            tail = theirs[begin : begin + len(first)]
            ends = lambda motion, move: near(motion[1], move["to"][0]) and near(motion[2], -move["to"][1])
            if begin and len(tail) == len(first) and all(ends(motion, move) for motion, move in zip(tail, first)):
                break
        else:
            return f"way {index} is not found", moves, arcs, feeds
        for number, (motion, move) in enumerate(zip(tail, first), 1):
            kind, radius, z, feed, centre, sign = motion
            wanted = "rapid" if move["feed"] is None else "arc" if "radius" in move else "feed"
            if kind != wanted:
                return f"way {index} move {number} is {kind}, not {wanted}", moves, arcs, feeds
            if move["feed"] is not None and abs(feed - move["feed"]) > 1e-4:
                feeds += 1
            moves += 1
            if kind != "arc":
                continue
            arcs += 1
            # A centre is as exact as its ends are: of a short arc it moves far without moving the arc.
            size, bow = move["radius"], math.hypot(motion[1] - move["from"][0], motion[2] + move["from"][1])
            slack = NEAR * max(1.0, 2 * size / max(bow, 1e-3))
            if math.hypot(centre[0] - move["centre"][0], centre[1] + move["centre"][1]) > slack:
                return f"way {index} move {number} turns about {centre}, not {move['centre']}", moves, arcs, feeds
            if (sign < 0) != move["left"]:
                return f"way {index} move {number} turns by {sign}, left is {move['left']}", moves, arcs, feeds
            begin_at = math.atan2(move["from"][0] - centre[0], -move["from"][1] - centre[1])
            end_at = math.atan2(radius - centre[0], z - centre[1])
            sweep = ((end_at - begin_at) * (1 if sign > 0 else -1)) % (2 * math.pi)
            if sweep > math.pi + 0.05 and abs(sweep - 2 * math.pi) > 0.05:
                return f"way {index} move {number} sweeps {math.degrees(sweep):.1f} degrees", moves, arcs, feeds
        place = begin + len(first)
    if any(motion[0] != "rapid" for motion in theirs[place:]):
        return "it cuts on after the last way", moves, arcs, feeds
    return None, moves, arcs, feeds


def chords(start, motion):
    """Points of a motion as (radius, z), from behind its start to its end."""
    kind, radius, z, _, centre, sign = motion
    if kind != "arc":
        return [(radius, z)]
    size = math.hypot(start[0] - centre[0], start[1] - centre[1])
    begin = math.atan2(start[0] - centre[0], start[1] - centre[1])
    end = math.atan2(radius - centre[0], z - centre[1])
    sweep = ((end - begin) * sign) % (2 * math.pi) * sign
    # The sagitta of a chord is size (1 - cos(angle / 2)): below a tenth of a micrometre.
    parts = max(2, math.ceil(abs(sweep) / (2 * math.acos(max(-1.0, 1 - 1e-4 / max(size, 1e-3))))))
    inner = [begin + sweep * part / parts for part in range(1, parts)]
    return [(centre[0] + size * math.sin(a), centre[1] + size * math.cos(a)) for a in inner] + [(radius, z)]


class Ground:
    """What is left of the stock, as heights over places. Along: the radius over each Z; across: the reach over each radius.

    Both are turned so that the stock lies below its height and the tool comes from above."""

    def __init__(self, low, high, height):
        count = max(1, round((high - low) / STEP))
        self.low, self.step = low, (high - low) / count
        # In the middles, so that no place lies on a face.
        self.places = [low + self.step * (index + 0.5) for index in range(count)]
        self.heights = [height] * count
        # The cosine of the slope of the motion that made the height.
        self.slopes = [1.0] * count

    def under(self, a, b):
        """The places under a line from a to b, (place, height), each with the height of the line and the cosine of its slope."""
        if abs(b[0] - a[0]) < 1e-9:
            return
        low, high = sorted((a[0], b[0]))
        cosine = (high - low) / math.hypot(b[0] - a[0], b[1] - a[1])
        first = max(0, math.ceil((low - self.low) / self.step - 0.5))
        for index in range(first, len(self.places)):
            place = self.places[index]
            if place > high:
                return
            share = (place - a[0]) / (b[0] - a[0])
            yield index, a[1] + share * (b[1] - a[1]), cosine


def surface(ground, pieces, turned):
    """The height of the contour at each place of a ground: the highest of its pieces there."""
    heights = [-math.inf] * len(ground.places)
    for piece in pieces:
        start = (piece["from"][0], -piece["from"][1])
        kind = "arc" if "radius" in piece else "feed"
        centre = (piece["centre"][0], -piece["centre"][1]) if kind == "arc" else None
        motion = (kind, piece["to"][0], -piece["to"][1], 0.0, centre, -1 if piece.get("left") else 1)
        last = start
        for point in chords(start, motion):
            for index, height, _ in ground.under(turned(last), turned(point)):
                heights[index] = max(heights[index], height)
            last = point
    return heights


def compare_cycle(told):
    """What is wrong with a program with a cycle, or None; and the four figures."""
    theirs, refused = motions(told["program"])
    if refused:
        return f"rs274 refuses: {refused}", {}
    along = told["direction"] == "longitudinal"
    sign = 1 if told["outer"] else -1
    corner, face = told["corner"][0], -told["corner"][1]
    pieces = told["pieces"]
    ends = [(piece["to"][0], -piece["to"][1]) for piece in pieces]
    begin = (pieces[0]["from"][0], -pieces[0]["from"][1])
    # Along: places are Z towards the chuck, heights the radius outwards (of a bore inwards).
    # Across: places are the radius from the surface of the blank inwards, heights are Z.
    turned = (lambda p: (-p[1], sign * p[0])) if along else (lambda p: (-sign * p[0], p[1]))
    if along:
        ground = Ground(-face, -ends[-1][1], sign * corner)
    else:
        ground = Ground(-sign * corner, -sign * begin[0], face)
    if along:
        # Before the contour there is stock down to where it begins.
        lead = [{"from": [begin[0], -face], "to": [begin[0], -begin[1]]}]
        target = surface(ground, lead + pieces, turned)
    else:
        lead = [{"from": [corner, -ends[-1][1]], "to": [ends[-1][0], -ends[-1][1]]}]
        target = surface(ground, pieces + lead, turned)
    below = rapid = deep = 0.0
    start = None
    for motion in theirs:
        if start is None:
            start = (motion[1], motion[2])
            continue
        last = start
        for point in chords(start, motion):
            for index, height, cosine in ground.under(turned(last), turned(point)):
                if motion[0] == "rapid":
                    rapid = max(rapid, ground.heights[index] - height)
                else:
                    below = max(below, (target[index] - height) * cosine)
                    if height < ground.heights[index]:
                        deep = max(deep, ground.heights[index] - height - told["depth"])
                        ground.heights[index], ground.slopes[index] = height, cosine
            last = point
        start = (motion[1], motion[2])
        if motion[0] != "rapid" and abs(motion[3] - told["feed"]) > 1e-4:
            return f"a motion has the feed {motion[3]}", {}
    over = zip(ground.heights, target, ground.slopes)
    left = max(((height - wanted) * cosine for height, wanted, cosine in over), default=0.0)
    figures = {"below": below, "left": left, "rapid": rapid, "depth": deep}
    wrong = [f"{name} {value:.4f}" for name, value in figures.items() if value > CUT]
    return ", ".join(wrong) or None, figures


def main(arguments):
    if not shutil.which("rs274"):
        print("rs274 is not installed (Debian package linuxcnc-uspace): nothing compared")
        return 0
    if not arguments:
        print(__doc__)
        return 2
    if arguments[0].endswith(".ngc"):
        found, refused = motions(pathlib.Path(arguments[0]).read_text())
        for kind, radius, z, feed, centre, sign in found:
            print(kind, f"r{radius:.4f} z{z:.4f}", feed or "", centre or "", sign or "")
        print(refused or "done")
        return 1 if refused else 0
    if arguments[0].endswith(".jsonl"):
        lines = pathlib.Path(arguments[0]).read_text().splitlines()
    else:
        command = [str(pathlib.Path(arguments[0]).resolve()), *arguments[1:]]
        lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    counts, worst, wrong = collections.Counter(), collections.Counter(), 0
    for number, line in enumerate(lines, 1):
        told = json.loads(line)
        if "refused" in told:
            counts["refused by us: " + told["refused"].split(" ")[0]] += 1
            continue
        if told["kind"] == "plain":
            problem, moves, arcs = compare_plain(told)
            counts["plain programs"] += 1
            counts["moves"] += moves
            counts["arcs"] += arcs
        elif told["kind"] == "whole":
            theirs, problem = motions(told["program"])
            if not problem:
                problem, passes = compare_threads(told)
                counts["passes of threads"] += passes
            counts["programs of set-ups"] += 1
            counts["motions"] += len(theirs)
        elif told["kind"] == "ways":
            problem, moves, arcs, feeds = compare_ways(told)
            counts["programs of ways"] += 1
            counts["ways"] += len(told["ways"])
            counts["moves"] += moves
            counts["arcs"] += arcs
            counts["feeds that are not those of their work"] += feeds
        else:
            problem, figures = compare_cycle(told)
            counts[f"cycles {told['direction']} {'outer' if told['outer'] else 'inner'}"] += 1
            for name, value in figures.items():
                worst[name] = max(worst[name], value)
        if problem:
            wrong += 1
            print(f"program {number}: {problem}" + (f", {told['name']}" if "name" in told else ""))
            folder = pathlib.Path(tempfile.gettempdir()) / "lathe-programs"
            folder.mkdir(exist_ok=True)
            (folder / f"{number}.ngc").write_text(told["program"])
            (folder / f"{number}.json").write_text(json.dumps(told, indent=1))
    print(", ".join(f"{value} {name}" for name, value in sorted(counts.items())))
    print("at most, mm: " + ", ".join(f"{name} {value:.4f}" for name, value in worst.items()))
    print(f"{wrong} differ" + (", see /tmp/lathe-programs" if wrong else ""))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
