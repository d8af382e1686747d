"""Our tours beside those of the PyPI package fast-tsp, on the patterns of benches/order.rs.

    cargo bench --bench order -- csv /tmp/patterns
    cargo build --release
    python3 tests/oracles/fast_tsp.py /tmp/patterns target/release/technolog

Ours runs as it does by default and for five seconds, its processor time taken from the whole command, reading and
bound and all; fast-tsp is told 1 and 5 seconds. Lengths are of the closed Euclidean tour, mm; the bound is ours.
Where fast-tsp is not installed the script says so and ends with 0.
"""

import csv
import json
import math
import pathlib
import resource
import subprocess
import sys

# This file bears the name of the package: without its own folder the package is found.
sys.path.pop(0)
try:
    import fast_tsp
except ImportError:
    print("fast-tsp is not installed (pip install fast-tsp): nothing compared")
    sys.exit(0)


def ours(program, file, effort):
    """Our tour: length, bound, processor seconds of the whole command."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    command = [program, "order", str(file), "--closed", "--format", "json"] + effort
    answer = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    return answer["length_mm"], answer["bound_mm"], resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def theirs(points, seconds):
    """The tour of fast-tsp; its distances are whole numbers up to 65535, so the longest is made nearly that."""
    longest = max(math.dist(a, b) for a in points for b in points)
    distances = [[round(math.dist(a, b) * 65000 / longest) for b in points] for a in points]
    tour = fast_tsp.find_tour(distances, duration_seconds=seconds)
    return sum(math.dist(points[a], points[b]) for a, b in zip(tour, tour[1:] + tour[:1]))


def main(folder, program):
    print(f"{'pattern':<14}{'ours mm':>12}{'user s':>8}{'fast-tsp mm':>14}{'s':>4}{'over the best':>18}{'bound mm':>12}{'over it':>9}")
    for file in sorted(pathlib.Path(folder).glob("*.csv")):
        with open(file, newline="") as rows:
            points = [(float(row["x"]), float(row["y"])) for row in csv.DictReader(rows)]
        runs = [(*ours(program, file, effort), theirs(points, seconds), seconds) for effort, seconds in (([], 1), (["--time", "5s"], 5))]
        best = min(min(length, other) for length, _, _, other, _ in runs)
        for length, bound, spent, other, seconds in runs:
            over = f"{(length / best - 1) * 100:.2f}/{(other / best - 1) * 100:.2f} %"
            gap = f"{(length / bound - 1) * 100:.2f} %"
            print(f"{file.stem:<14}{length:>12.1f}{spent:>8.2f}{other:>14.1f}{seconds:>4}{over:>18}{bound:>12.1f}{gap:>9}", flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
