"""Recomputes tests/data/worked-problems.yaml by the formulas named there: `python3 tests/oracles/worked_problems.py`.

Each line is a problem with what the page prints and what its own formula gives; `!` marks a difference beyond `within`, `?` a
figure that was recomputed by hand.
Fails where a `recomputed` of the file does not follow from its inputs.
"""
from math import pi, prod, sqrt
from pathlib import Path

import yaml

DATA = Path(__file__).parent.parent / "data" / "worked-problems.yaml"


def given(problem):
    flat = dict(problem.get("inputs") or {}) if isinstance(problem.get("inputs"), dict) else {}
    return problem | flat | problem.get("coefficients", {}) | {"k": problem.get("factors", {}).get("k", 1)} | problem.get("with", {})


def spindle(g):
    return g.get("spindle_rpm") or 1000 * g["speed_m_per_min"] / (pi * g["diameter_mm"])


def figures(problem):
    """Every figure that follows from the inputs, by its name."""
    g, out = given(problem), {}
    formula = problem.get("formula")
    if formula == "drilling-torque":
        out["torque_n_m"] = g.get("newtons", 10) * g["cm"] * g["diameter_mm"] ** g["q"] * g["feed_mm_per_rev"] ** g["y"] * g["k"]
    elif formula in ("drilling-speed", "hole-speed", None) and "cv" in g and "diameter_mm" in g:
        depth = g["depth_of_cut_mm"] ** g["x"] if "x" in g else 1
        out["speed_m_per_min"] = g["cv"] * g["diameter_mm"] ** g["q"] / (
            g["tool_life_min"] ** g["m"] * depth * g["feed_mm_per_rev"] ** g["y"]) * g["k"]
        if "cm" in g:
            out["torque_n_m"] = 10 * g["cm"] * g["diameter_mm"] ** g["qm"] * g["depth_of_cut_mm"] ** g["xm"] * g["feed_mm_per_rev"] ** g["ym"]
    elif formula == "turning-force":
        force = 10 * g["cp"] * g["depth_of_cut_mm"] ** g["x"] * g["feed_mm_per_rev"] ** g["y"] * g["speed_m_per_min"] ** g["n"] * g["k"]
        out["thrust_n"] = force
        if "spindle_rpm" in g:
            out["speed_m_per_min"] = pi * g["diameter_mm"] * g["spindle_rpm"] / 1000
            out["power_kw"] = force * out["speed_m_per_min"] / 61200
    elif formula == "spindle":
        if "spindle_rpm" in g or "diameter_mm" in g:
            out["spindle_rpm"] = spindle(g)
        if "diameter_mm" in g:
            out["speed_m_per_min"] = pi * g["diameter_mm"] * spindle(g) / 1000
        if "feed_mm_per_rev" in g:
            out["feed_mm_per_min"] = g["feed_mm_per_rev"] * spindle(g)
    elif formula == "time":
        out["spindle_rpm"] = spindle(g)
        travel = g.get("travel_mm") or "length_mm" in g and g["length_mm"] + g.get("approach_mm", 0) + g.get("overrun_mm", 0)
        if travel and ("feed_mm_per_rev" in g or "feed_mm_per_min" in g):
            rate = g.get("feed_mm_per_min") or spindle(g) * g["feed_mm_per_rev"]
            out |= {"travel_mm": travel, "time_min": travel / rate * g.get("holes", 1)}
        if "diameter_mm" in g:
            out["speed_m_per_min"] = pi * g["diameter_mm"] * spindle(g) / 1000
            if "speed_m_per_min" in g:
                out["spindle_rpm_computed"] = 1000 * g["speed_m_per_min"] / (pi * g["diameter_mm"])
        out["spindle_rps"] = out["spindle_rpm"] / 60
        if "time_min" in out:
            out["time_s"] = 60 * out["time_min"]
    elif formula == "nose-feed":
        out["feed_mm_per_rev"] = sqrt(31.2 * g["roughness_um"] * g["nose_radius_mm"] / 1000)
    elif formula == "tap-drill":
        out["tap_drill_mm"] = g["diameter_mm"] - g["pitch_mm"]
    elif formula == "thread-passes":
        out |= {f"pass_{i}_mm": g["thread_depth_mm"] * sqrt(i / g["passes"]) for i in range(1, g["passes"] + 1)}
    elif formula == "makers-passes":
        reached = [g["thread_depth_mm"] * sqrt(phi / (g["passes"] - 1)) for phi in [0.3, *range(1, g["passes"])]]
        out |= {"first_pass_mm": reached[0], "last_pass_mm": reached[-1] - reached[-2]}
    elif formula == "norms" and isinstance(problem["inputs"], list):
        products = [row["table"] * prod(row["factors"]) for row in problem["inputs"]]
        out |= {"speeds_m_per_min": products, "forces_n": products}
        out |= {row["what"]: value for row, value in zip(problem["inputs"], products) if "what" in row}
        if "spindle_rpm" in problem["results"] and "feed_mm_per_rev" in problem["results"]:
            out["feed_mm_per_min"] = problem["results"]["spindle_rpm"] * problem["results"]["feed_mm_per_rev"]
    elif formula == "norms":
        out["power_w"] = g["force_n"] * g["speed_m_per_s"]
        out["available_kw"] = g["machine_kw"] * g["efficiency"]
        out["travel_mm"] = g["length_mm"] + g["approach_mm"] + g["overrun_mm"]
    return out


def near(one, other, share):
    pairs = zip(one, other) if isinstance(one, list) else [(one, other)]
    return all(abs(a - b) <= share * abs(b) + 1e-9 for a, b in pairs)


def main():
    data, wrong = yaml.safe_load(DATA.read_text()), []
    for problem in data["problems"] + data["without_results"]:
        own, within = figures(problem), float(problem.get("within", "0.1%").rstrip("%")) / 100
        for name, value in (problem.get("results") or {}).items():
            if name in own:
                mark = " " if near(value, own[name], max(within, 0.001)) else "!"
                print(f"{mark} {problem['id']}: {name} printed {value}, by the formula {own[name]}")
        for name, value in (problem.get("recomputed") or {}).items():
            if name not in own:
                print(f"? {problem['id']}: {name} {value} by hand, no formula of it here")
            elif not near(value, own[name], 0.002):
                wrong.append(f"{problem['id']}: {name} {value}, by the formula {own.get(name)}")
    print(*wrong, sep="\n")
    raise SystemExit(bool(wrong))


if __name__ == "__main__":
    main()
