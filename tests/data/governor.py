"""The motion of a flyball governor with a spring and a damper between each ball and the sleeve, with 24 digits.

Written by `python3 governor.py > governor.json`, with mpmath. The equations are written by hand, by Newton's law in the turning
plane of the arms and the moment of momentum about the spindle. A ball of mass m hangs on an arm of length l without mass, at the
angle a from the vertical; the spindle with everything else that turns has the moment of inertia i and is driven by a torque; the
sleeve of mass s is at the height z above the pivot of the arms, at the distance d from the ball. With the angular velocity w of
the spindle and N = k (d - rest) + c dd/dt

    m l² a'' = m l² sin a cos a w² - m g l sin a + N l z sin a/d,
    ((i + m l² (sin² a1 + sin² a2)) w)' = torque,
    s z'' = -s g - sum of N (z + l cos a)/d,

and the tension of an arm is m l (a'² + w² sin² a) + m g cos a - N (l + z cos a)/d. The steps are taken by the extrapolated midpoint
rule with 45 digits. Shorter steps give the same 24 digits.
"""

import json

import mpmath as mp

mp.mp.dps = 45

PARAMETERS = {
    "m": "1.25", "s": "0.75", "i": "0.0625", "l": "0.5", "g": "9.8125",
    "k": "120", "rest": "0.5", "c": "1.5", "torque": "0.25",
}
# The angle of the spindle, the angles of the arms, the height of the sleeve, and their rates.
START = ["0.25", "0.5", "0.75", "-0.8125", "6.5", "0.25", "-0.5", "0.125"]
TIMES = ["0", "0.25", "0.5", "1", "2"]


def spring(p, a, rate, z, speed):
    """The distance of a ball from the sleeve, and the force that draws them together."""
    x, y = p["l"] * mp.sin(a), z + p["l"] * mp.cos(a)
    distance = mp.sqrt(x * x + y * y)
    stretching = (x * p["l"] * mp.cos(a) * rate + y * (speed - p["l"] * mp.sin(a) * rate)) / distance
    return distance, p["k"] * (distance - p["rest"]) + p["c"] * stretching


def accelerations(p, state):
    """The accelerations of the angles and of the sleeve, and the tensions of the arms."""
    _, *angles, z, w, first, second, speed = state
    m, s, l, g = (p[name] for name in "mslg")
    inertia, braking, lift = p["i"], mp.mpf(0), -s * g
    swings, tensions = [], []
    for a, rate in zip(angles, (first, second)):
        sine, cosine = mp.sin(a), mp.cos(a)
        distance, force = spring(p, a, rate, z, speed)
        swings.append(sine * cosine * w * w - g / l * sine + force * z * sine / (distance * m * l))
        tensions.append(m * l * (rate * rate + w * w * sine * sine) + m * g * cosine - force * (l + z * cosine) / distance)
        inertia += m * l * l * sine * sine
        braking += 2 * m * l * l * sine * cosine * rate * w
        lift -= force * (z + l * cosine) / distance
    return [(p["torque"] - braking) / inertia, *swings, lift / s], tensions


def step(p, state, h, order):
    """Gragg's extrapolation of the midpoint rule, without smoothing."""
    rate = lambda state: [*state[4:], *accelerations(p, state)[0]]
    table = []
    first = rate(state)
    for row in range(1, order // 2 + 1):
        count = 2 * row
        part = h / count
        before, now = state, [x + part * r for x, r in zip(state, first)]
        for _ in range(1, count):
            before, now = now, [x + 2 * part * r for x, r in zip(before, rate(now))]
        line = [now]
        for back in range(1, row):
            ratio = (mp.mpf(row) / (row - back)) ** 2 - 1
            line.append([x + (x - y) / ratio for x, y in zip(line[-1], table[-1][back - 1])])
        table.append(line)
    return table[-1][-1]


def motion(steps, order):
    """The states at the times, with so many steps a second, and the parameters."""
    p = {name: mp.mpf(text) for name, text in PARAMETERS.items()}
    states, t = [[mp.mpf(text) for text in START]], mp.mpf(0)
    for end in TIMES[1:]:
        count = max(1, int(mp.ceil((mp.mpf(end) - t) * steps)))
        state = states[-1]
        for _ in range(count):
            state = step(p, state, (mp.mpf(end) - t) / count, order)
        t = mp.mpf(end)
        states.append(state)
    return p, states


def main():
    p, states = motion(24, 32)
    _, others = motion(31, 32)
    difference = max(abs(x - y) for state, other in zip(states, others) for x, y in zip(state, other))
    assert difference < mp.mpf(10) ** -24, difference
    found = [accelerations(p, state) for state in states]
    text = lambda values: [mp.nstr(x, 24) for x in values]
    samples = [
        {"t": t, "q": text(state[:4]), "qd": text(state[4:]), "qdd": text(rates), "tensions": text(tensions)}
        for t, state, (rates, tensions) in zip(TIMES, states, found)
    ]
    print(json.dumps({"params": PARAMETERS, "coords": ["phi", "first", "second", "z"], "samples": samples}, indent=1))


main()
