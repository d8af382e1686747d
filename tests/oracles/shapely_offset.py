"""Our equidistants beside those of shapely (GEOS), which makes arcs of many short lines.

    CONTOURS=/tmp/contours.json cargo test --test turning contours_for_shapely -- --ignored
    python3 tests/oracles/shapely_offset.py /tmp/contours.json

The test writes random contours, one distance over each, and our answer. The part is what lies under a contour; its offset
is the part and a capsule over each short line of the contour, joined by GEOS. (GEOS's own buffer of the part will not do:
over finely divided arcs it was up to 0.8 mm too large.) Between its ends ours must hold all of that, and what it holds
beyond may lie only within two distances of a corner of the part. Without arcs ours must be GEOS's offset with extended
corners (limit 2, as ours) itself. Where shapely is not installed the script says so and ends with 0.
"""

import json
import math
import sys

try:
    from shapely.geometry import LineString, Point, Polygon, box
    from shapely.ops import unary_union
except ImportError:
    print("shapely is not installed (pip install shapely): nothing compared")
    sys.exit(0)

STEPS = 40  # lines for a quarter of a circle
DEEP = 200.0


def points(pieces):
    """The contour as points; an arc as lines whose ends lie on it."""
    found = [tuple(pieces[0]["from"])]
    for piece in pieces:
        (z0, r0), (z1, r1) = piece["from"], piece["to"]
        if piece["sweep"]:
            sweep = piece["sweep"]
            half = math.hypot(z1 - z0, r1 - r0) / 2
            height = half / math.tan(sweep / 2) if abs(abs(sweep) - math.pi) > 1e-12 else 0.0
            dz, dr = (z1 - z0) / (2 * half), (r1 - r0) / (2 * half)
            cz, cr = (z0 + z1) / 2 - dr * height, (r0 + r1) / 2 + dz * height
            count = max(8, math.ceil(abs(sweep) / (math.pi / 2) * STEPS))
            for k in range(1, count):
                c, s = math.cos(sweep * k / count), math.sin(sweep * k / count)
                found.append((cz + (z0 - cz) * c - (r0 - cr) * s, cr + (z0 - cz) * s + (r0 - cr) * c))
        found.append((z1, r1))
    return found


def under(pieces):
    line = points(pieces)
    return Polygon(line + [(line[-1][0], -DEEP), (line[0][0], -DEEP)]).buffer(0)


def main(path):
    worst, most, compared, same = 0.0, 0.0, 0, 0
    for case in json.load(open(path)):
        part, ours, distance = under(case["contour"]), under(case["rough"]), case["distance"]
        left, right = case["contour"][0]["from"][0] + 3 * distance, case["contour"][-1]["to"][0] - 3 * distance
        if right <= left or distance == 0:
            continue
        window = box(left, -DEEP / 2, right, 10 * DEEP)
        slack = 0.02  # the sagitta of the largest arc, and roundings
        line = points(case["contour"])
        capsules = [LineString(pair).buffer(distance, quad_segs=32) for pair in zip(line, line[1:])]
        offset = unary_union([part, *capsules]).intersection(window)
        corners = [Point(piece["from"]).buffer(2 * distance + slack) for piece in case["contour"][1:]]
        lacks = offset.difference(ours.buffer(slack)).area
        beyond = ours.intersection(window).difference(offset.buffer(slack)).difference(unary_union(corners)).area
        worst, most, compared = max(worst, lacks), max(most, beyond), compared + 1
        if not any(piece["sweep"] for piece in case["contour"] + case["rough"]):
            mitre = part.buffer(distance, join_style="mitre", mitre_limit=2.0).intersection(window)
            off = ours.intersection(window).symmetric_difference(mitre).area / (right - left)
            assert off < slack, (off, case)
            same += 1
    print(f"{compared} contours compared; of the offset by capsules ours lacks at most {worst:.2e} mm2,")
    print(f"beyond it and its corners ours has at most {most:.2e} mm2; {same} without arcs are GEOS's extended one")
    return worst > 1e-6 or most > 1e-6


sys.exit(main(sys.argv[1]))
