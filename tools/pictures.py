"""How alike two pictures are: PSNR, its classes, and an amplified difference to look at."""

import math

from png import Picture

# Names from best to worst, each with the least PSNR that earns it, in dB.
CLASSES = (("exact", 50.0), ("match", 38.0), ("near", 28.0), ("wrong", -math.inf))

_SQUARES = [d * d for d in range(256)]


def psnr(a: Picture, b: Picture) -> float:
    """10·log10(255² / MSE) over all RGB bytes, in dB; infinite for identical pictures.

    Both pictures must have the same size.
    """
    if a.rgb == b.rgb:
        return math.inf
    squares = _SQUARES
    total = sum(squares[abs(x - y)] for x, y in zip(a.rgb, b.rgb, strict=True))
    return 10 * math.log10(255 * 255 * len(a.rgb) / total)


def class_of(decibels: float) -> str:
    """exact, match, near or wrong."""
    return next(name for name, least in CLASSES if decibels >= least)


def difference(a: Picture, b: Picture, gain: int = 8) -> Picture:
    """|a − b| · gain, clipped: black where the pictures agree."""
    table = [min(255, gain * d) for d in range(256)]
    rgb = bytes(table[abs(x - y)] for x, y in zip(a.rgb, b.rgb, strict=True))
    return Picture(a.width, a.height, rgb)


def part(p: Picture, x: int, y: int, width: int, height: int) -> Picture:
    """What a picture shows in a window of it."""
    rows = (3 * (row * p.width + x) for row in range(y, y + height))
    return Picture(width, height, b"".join(p.rgb[start : start + 3 * width] for start in rows))


def text(decibels: float) -> str:
    """A PSNR for tables: `inf` or one decimal."""
    return "inf" if math.isinf(decibels) else f"{decibels:.1f}"
