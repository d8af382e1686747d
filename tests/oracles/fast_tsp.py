"""Our tours beside those of the PyPI package fast-tsp, on the patterns of benches/order.rs.

    cargo bench --bench order -- csv /tmp/patterns
    cargo build --release
    python3 tests/oracles/fast_tsp.py /tmp/patterns target/release/technolog

Both get about the same time on one core: our effort (counted in tries) is raised until a run takes the seconds
asked for, and fast-tsp is told the seconds. Lengths are of the closed Euclidean tour, mm; the bound is ours.
Where fast-tsp is not installed the script says so and ends with 0.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import time

try:
    import fast_tsp
except ImportError:
    print("fast-tsp is not installed (pip install fast-tsp): nothing compared")
    sys.exit(0)


def ours(program, file, seconds):
    """Our tour with the largest effort that fits: length, bound, seconds of the whole command."""
    effort, best = 1, None
    while True:
        start = time.perf_counter()
        command = [program, "order", str(file), "--closed", "--effort", str(effort), "--format", "json"]
        answer = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        spent = time.perf_counter() - start
        if best is None or spent <= seconds:
            best = (answer["length_mm"], answer["bound_mm"], spent, effort)
        if spent > seconds / 1.6 or effort >= 3000:
            return best
        effort *= 2


def theirs(points, seconds):
    """The tour of fast-tsp; its distances are whole numbers up to 65535, so the longest is made nearly that."""
    longest = max(math.dist(a, b) for a in points for b in points)
    distances = [[round(math.dist(a, b) * 65000 / longest) for b in points] for a in points]
    tour = fast_tsp.find_tour(distances, duration_seconds=seconds)
    return sum(math.dist(points[a], points[b]) for a, b in zip(tour, tour[1:] + tour[:1]))


def main(folder, program):
    print(f"{'pattern':<14}{'s':>4}{'ours mm':>12}{'(time, effort)':>18}{'fast-tsp mm':>14}{'best of both +':>18}{'bound mm':>12}")
    for file in sorted(pathlib.Path(folder).glob("*.csv")):
        with open(file, newline="") as rows:
            points = [(float(row["x"]), float(row["y"])) for row in csv.DictReader(rows)]
        for seconds in (1, 5):
            length, bound, spent, effort = ours(program, file, seconds)
            other = theirs(points, seconds)
            best = min(length, other)
            over = f"{(length / best - 1) * 100:.2f}/{(other / best - 1) * 100:.2f} %"
            print(f"{file.stem:<14}{seconds:>4}{length:>12.1f}{f'({spent:.1f}, {effort})':>18}{other:>14.1f}{over:>18}{bound:>12.1f}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:3])
