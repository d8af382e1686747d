"""Our programs for lathes, cut out of the blank by shapely: beside the proof, with nothing of it.

    cargo build
    python3 tests/oracles/lathe_shapely.py target/debug/technolog examples/turned-*.yaml tests/turned-whole/*.yaml
    python3 tests/oracles/lathe_shapely.py target/debug/technolog --control fanuc examples/turned-nose.yaml

The contour is drawn here from the items of the file, nominal diameters; the programs are read here as text. Of our own answer
only the tools are taken (angles, nose, edge, width), and the zero of a second set-up: the length of the part. Each insert is a
polygon that is swept along each block: at feed it is cut out of the stock, at rapid it must meet none. Then

  gouge   how much of the part is gone, as the radius of the largest disc of it;
  rapid   the same, of what a rapid went through;
  stands  the same, of what is left over the part in the stretches that were finished.

A program whose plan has an error is not held to `stands`. Fields make a part up to a tenth thinner or thicker than it is drawn,
noses leave their round: a disc of more than LIMIT is told. Where shapely is not installed the script says so and ends with 0.
"""

import json
import math
import pathlib
import re
import subprocess
import sys

try:
    import yaml
    from shapely import affinity
    from shapely.geometry import LineString, MultiPoint, Polygon, box
    from shapely.ops import unary_union
except ImportError:
    print("shapely or yaml is not installed (pip install shapely pyyaml): nothing compared")
    sys.exit(0)

GOUGE, RAPID, STANDS = 0.03, 0.02, 0.15
STEP = math.radians(2)


def arc(a, b, centre, left):
    """Points after the first of an arc in the plane (z, r)."""
    begin = math.atan2(a[1] - centre[1], a[0] - centre[0])
    turn = math.atan2(b[1] - centre[1], b[0] - centre[0]) - begin
    turn = turn % (2 * math.pi) if left else -(-turn % (2 * math.pi))
    radius = math.dist(a, centre)
    count = max(2, math.ceil(abs(turn) / STEP))
    angles = [begin + turn * i / count for i in range(1, count)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles] + [b]


def by_radius(a, b, radius, bulge, inner):
    """The arc of a contour: its centre on the side of the metal if it bulges out."""
    middle, half = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), math.dist(a, b) / 2
    off = math.sqrt(max(radius * radius - half * half, 0))
    along = ((b[0] - a[0]) / (2 * half), (b[1] - a[1]) / (2 * half))
    # Towards the chuck the metal of an outside is to the left, that of a bore to the right.
    metal = (-along[1], along[0]) if not inner else (along[1], -along[0])
    sign = 1 if bulge == "out" else -1
    centre = (middle[0] + sign * off * metal[0], middle[1] + sign * off * metal[1])
    cross = along[0] * (centre[1] - a[1]) - along[1] * (centre[0] - a[0])
    left = cross > 0 if off > 1e-9 else (sign > 0) != inner
    return arc(a, b, centre, left)


RELIEFS = {1: (3, 1), 1.25: (4, 1), 1.5: (4, 1), 1.75: (4, 1.5), 2: (5, 1.5), 2.5: (6, 1.5), 3: (6, 2)}


def drawn(items, inner):
    """A contour as points (z, r), and the stretches (z) of its threads."""
    if isinstance(items, dict):
        if not isinstance(items.get("points"), list):
            raise NotImplementedError("a table or a drawing")
        return [(z, d / 2) for d, z in items["points"]], []
    sign = 1 if inner else -1
    points, threads, pitch = [], [], None
    for index, item in enumerate(items):
        item = dict(item)
        z, r = points[-1] if points else (0.0, 0.0)
        before = items[index - 1] if index else {}
        after = items[index + 1] if index + 1 < len(items) else {}
        if "from" in item:
            points.append((item["from"]["z"], item["from"]["d"] / 2))
        elif "face" in item:
            points.append((z, item["face"] / 2))
        elif "cylinder" in item:
            to = item["cylinder"]
            points.append((z - to["length"] if isinstance(to, dict) else to, r))
        elif "thread" in item:
            name = str(item["thread"]).split("-")[0]
            pitch = float(name.split("x")[1]) if "x" in name else COARSE[float(name[1:])]
            to = item["to"] if "to" in item else z - item["length"]
            threads.append((to - 4 * pitch, z + 2 * pitch))
            points.append((to, r))
        elif "cone" in item:
            points.append((item["cone"]["z"], item["cone"]["d"] / 2))
        elif "chamfer" in item:
            size = item["chamfer"]
            face = before if "face" in before else after if "face" in after else None
            if face is None:
                up = -1 if inner else 1
            elif face is before:
                start = points[-2][1] if len(points) > 1 else 0.0
                up = 1 if r > start or (r == start and not inner) else -1
            else:
                up = 1 if after["face"] / 2 > r else -1
            points.append((z - size, r + up * size))
        elif "arc" in item:
            to = (item["arc"]["z"], item["arc"]["d"] / 2)
            points += by_radius((z, r), to, item["radius"], item["bulge"], inner)
        elif "groove" in item:
            kind, deep = item["groove"], item.get("depth")
            if kind == "thread-relief" and deep is None:
                item["width"], deep = RELIEFS[pitch]
            if item.get("width") is None or deep is None or kind in ("face", "corner", "pulley", "trapezoid"):
                raise NotImplementedError(f"groove {kind}")
            width, floor = item["width"], r + sign * deep
            if kind == "rectangular":
                points += [(z, floor), (z - width, floor), (z - width, r)]
            elif "face" in after and "face" not in before:
                points += [(z - deep, floor), (z - width, floor), (z - width, r)]
            else:
                points += [(z, floor), (z - width + deep, floor), (z - width, r)]
        else:
            raise NotImplementedError(str(item))
    return points, threads


COARSE = {6: 1, 8: 1.25, 10: 1.5, 12: 1.75, 14: 2, 16: 2, 18: 2.5, 20: 2.5, 22: 2.5, 24: 3, 27: 3, 30: 3.5, 36: 4}


def between(outer, inner):
    """The half-section between two chains towards the chuck, the axis where there is no bore."""
    chain = list(outer)
    end = outer[-1][0]
    if inner:
        if inner[-1][1] <= 0:
            chain += [(end, 0.0)]
        chain += list(reversed(inner))
    else:
        chain += [(end, 0.0), (outer[0][0], 0.0)]
    return Polygon(chain).buffer(0)


def blank_of(blank, length):
    front = blank.get("face", 0)
    if blank["kind"] in ("bar", "tube") or "outer" not in blank:
        if "steps" in blank:
            raise NotImplementedError("a blank in steps")
        bore = blank.get("bore", 0) / 2
        return box(front - blank["length"], bore, front, blank["diameter"] / 2)
    outer, inner = drawn(blank["outer"], False)[0], drawn(blank["inner"], True)[0] if "inner" in blank else None
    if outer[0][1] > 0 and not inner:
        outer = [(outer[0][0], 0.0)] + outer
    return between(outer, inner)


def insert(tool):
    """The cutting part round its programmed point, as a right-hand tool outside has it."""
    kind, r = tool["kind"], tool["nose_radius_mm"] or 0.0
    if "width_mm" in tool and tool["width_mm"]:
        wide, deep = tool["width_mm"], tool["blade_depth_mm"] or 10
        shape = box(r, r, wide - r, deep).buffer(r) if r else box(0, 0, wide, deep)
        return shape.intersection(box(0, 0, wide, deep))
    lead, trail = math.radians(tool["lead_angle_deg"]), math.radians(tool["trail_angle_deg"])
    centre = (r, r)
    # The sharp point that both edges run from lies where their lines, r from the centre, meet.
    main, second = (-math.cos(lead), math.sin(lead)), (math.cos(trail), math.sin(trail))
    ahead, below = (-main[1], main[0]), (second[1], -second[0])
    share = r / (1 + ahead[0] * below[0] + ahead[1] * below[1])
    sharp = tuple(centre[i] + share * (ahead[i] + below[i]) for i in (0, 1))
    edge = tool["edge_mm"] or 10
    ends = [tuple(sharp[i] + edge * way[i] for i in (0, 1)) for way in (main, second)]
    nose = [(centre[0] + r * math.cos(t * STEP / 2), centre[1] + r * math.sin(t * STEP / 2)) for t in range(360)]
    return MultiPoint(nose + ends).convex_hull


def drill_of(tool):
    text = json.dumps(tool)
    found = re.search(r'"diameter_mm": ([0-9.]+)', text)
    angle = re.search(r'"point_angle_deg": ([0-9.]+)', text)
    if not found:
        raise NotImplementedError(text)
    radius = float(found[1]) / 2
    point = radius / math.tan(math.radians(float(angle[1]) / 2)) if angle else 0.0
    return Polygon([(0, 0), (point, radius), (200, radius), (200, 0)])


def swept(shape, path):
    """The hull of a convex shape along each line of a path, folded over the axis."""
    parts = []
    for a, b in zip(path, path[1:]):
        corners = [(x + p[0], y + p[1]) for p in (a, b) for x, y in shape.exterior.coords]
        hull = MultiPoint(corners).convex_hull
        if hull.area > 0:
            parts.append(hull)
    whole = unary_union(parts)
    return unary_union([whole, affinity.scale(whole, 1, -1, origin=(0, 0))]) if parts else whole


def motions(text, control):
    """(kind, tool comment, tool number, [points z r]) of a program; X is a diameter."""
    at, mode, tool, name = (None, None), 0, None, ""
    for number, line in enumerate(text.splitlines(), 1):
        for comment in re.findall(r"\(([^)]*)\)", line):
            name = comment
        line = re.sub(r"\([^)]*\)", "", line).replace(" ", "")
        words = [(letter, float(value)) for letter, value in re.findall(r"([A-Z])([-+]?[0-9.]+)", line)]
        codes = [value for letter, value in words if letter == "G"]
        have = {letter: value for letter, value in words if letter != "G"}
        if "T" in have:
            tool = int(have["T"]) // (100 if control == "fanuc" else 1)
            at = (None, None)
        if any(code in (28, 53, 4, 10) for code in codes) or 91 in codes:
            at = (None, None)
            continue
        if any(code in (76, 71, 72, 70, 32, 92, 33.1, 84) for code in codes) and ("X" in have or "Z" in have):
            if 92 in codes:
                continue
            yield number, "thread", tool, name, []
            at = (None, None)
            continue
        for code in codes:
            if code in (0, 1, 2, 3, 33):
                mode = code
        if "X" not in have and "Z" not in have:
            continue
        to = (have.get("Z", at[0]), have["X"] / 2 if "X" in have else at[1])
        if None in at or None in to:
            at = to
            continue
        path = [at, to]
        if mode in (2, 3):
            centre = (at[0] + have.get("K", 0), at[1] + have.get("I", 0))
            # Seen with X up and Z to the right the tool behind the axis turns as the words say.
            path = [at] + arc(at, to, centre, mode == 3)
        kind = "rapid" if mode == 0 else "thread" if mode == 33 else "feed"
        yield number, kind, tool, name, path
        at = to


def thick(shape):
    """The radius of about the largest disc inside, by halving."""
    low, high = 0.0, 50.0
    if shape.is_empty or shape.area < 1e-7:
        return 0.0
    while high - low > 0.002:
        middle = (low + high) / 2
        low, high = (low, middle) if shape.buffer(-middle).is_empty else (middle, high)
    return low


def place(shape):
    point = shape.representative_point()
    return f"Z{point.x:.2f} X{2 * point.y:.2f}"


def held(program, file, control):
    text = pathlib.Path(file).read_text()
    spec = yaml.safe_load(text)
    if "outer" not in spec:
        raise NotImplementedError("a file of steps")
    outer, threads = drawn(spec["outer"], False)
    inner, more = drawn(spec["inner"], True) if "inner" in spec else (None, [])
    if outer[0][1] > 0 and not inner:
        outer = [(outer[0][0], 0.0)] + outer
    threads += more
    part = between(outer, inner)
    length = -min(z for z, _ in outer)
    stock = blank_of(spec["blank"], length)
    if spec.get("holding") == "centres":
        # Both faces are made before.
        stock = stock.intersection(box(-length, 0, 0, 999))
    answer = subprocess.run([program, "turn", file, "--format", "json", "--lang", "en"], capture_output=True, text=True)
    plan = json.loads(answer.stdout)
    tools = {job["tool"]["designation"]: job["tool"] for one in plan["set_ups"] for job in one["jobs"]}
    found, over = [], False
    for number, one in enumerate([one for one in plan["set_ups"] if one["jobs"]], 1):
        if one["turned_over"] != over:
            stock = affinity.scale(stock, -1, 1, origin=(-length / 2, 0))
            part = affinity.scale(part, -1, 1, origin=(-length / 2, 0))
            threads = [(-length - b, -length - a) for a, b in threads]
            over = one["turned_over"]
        command = [program, "turn", file, "--show", "program", "--control", control, "--number", str(one["number"])]
        run = subprocess.run(command + ["--force"], capture_output=True, text=True)
        if run.returncode == 2:
            raise NotImplementedError(run.stderr.strip()[:200])
        keep = part.buffer(-GOUGE)
        for zone in threads:
            keep = keep.difference(box(zone[0], 0, zone[1], 999))
        for block, kind, tool, name, path in motions(run.stdout, control):
            if kind == "thread":
                continue
            told = re.sub(r"^T\d+ ", "", name).rsplit(", ", 1)
            used = tools.get(told[0])
            if used is None:
                raise NotImplementedError(f"tool {name}")
            if used["kind"] in ("threading",) or used.get("shape") == "tap":
                continue
            if used["shape"] == "insert":
                shape = insert(used)
                if used["works"] == "inner":
                    shape = affinity.scale(shape, 1, -1, origin=(0, 0))
                if used["hand"] == "L":
                    shape = affinity.scale(shape, -1, 1, origin=(0, 0))
            else:
                shape = drill_of(used)
            way = swept(shape, path)
            if kind == "rapid":
                hit = thick(way.intersection(stock)) if way.intersects(stock) else 0.0
                if hit > RAPID:
                    found.append(f"set-up {number} block {block}: rapid through {2 * hit:.3f} mm at {place(way.intersection(stock))}")
                continue
            bad = way.intersection(keep)
            if not bad.is_empty and bad.area > 1e-6 and thick(bad) > 0.003:
                found.append(f"set-up {number} block {block} {name}: gouge {2 * thick(bad) + GOUGE:.3f} mm at {place(bad)}")
            stock = stock.difference(way)
        if one.get("parted_mm") is not None:
            stock = stock.intersection(box(-length - 5, 0, 999, 999))
    # What the largest nose leaves in inner corners is not told.
    nose = max(tool["nose_radius_mm"] or 0.0 for tool in tools.values() if "nose_radius_mm" in tool)
    left = stock.difference(part.buffer(nose).buffer(-nose).buffer(STANDS))
    for zone in threads:
        left = left.difference(box(zone[0], 0, zone[1], 999))
    wrong = [one.get("code", "") for one in plan["findings"] if one["severity"] in ("wrong", "error", "impossible")]
    pieces = left.geoms if hasattr(left, "geoms") else [left]
    for piece in pieces:
        if thick(piece) > 0.02:
            found.append(f"stands {2 * thick(piece) + STANDS:.3f} mm at {place(piece)} (plan: exit {answer.returncode}, {wrong})")
    return answer.returncode, found


def main():
    arguments = sys.argv[1:]
    control = "linuxcnc"
    if "--control" in arguments:
        at = arguments.index("--control")
        control = arguments[at + 1]
        del arguments[at : at + 2]
    program, files = arguments[0], arguments[1:]
    bad = 0
    for file in files:
        try:
            code, found = held(program, file, control)
        except NotImplementedError as why:
            print(f"{file}: not compared: {why}")
            continue
        bad += bool(found) and code == 0
        print(f"{file}: exit {code}, {len(found)} found")
        for one in found[:8]:
            print("   ", one)
    sys.exit(1 if bad else 0)


main()
