"""The program being written: its lines, and what is declared at this point."""

import random


class Writer:
    """Appends lines and hands out names. `names` maps a kind to the names in force.

    Kinds: `f` float, `v2` `v3` `v4` vectors, `c` colour, `s` string, and those that a subject adds.
    """

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.lines: list[str] = []
        self.names: dict[str, list[str]] = {}
        self.prefix = ""
        self._count = 0
        self._shown = 0

    # Names -------------------------------------------------------------------------------------

    def fresh(self, stem: str) -> str:
        """A name that nothing has yet."""
        self._count += 1
        return f"{stem}{self._count}"

    def known(self, kind: str) -> list[str]:
        return self.names.get(kind, [])

    def declare(self, kind: str, name: str) -> None:
        """`name` now has this kind, whatever it had before."""
        self.forget(name)
        self.names.setdefault(kind, []).append(name)

    def forget(self, name: str) -> None:
        for names in self.names.values():
            if name in names:
                names.remove(name)

    def snapshot(self) -> dict[str, list[str]]:
        return {kind: list(names) for kind, names in self.names.items()}

    # Text --------------------------------------------------------------------------------------

    def line(self, text: str) -> None:
        self.lines.append(self.prefix + text)

    def chance(self, probability: float) -> bool:
        return self.rng.random() < probability

    def pick(self, choices):
        return self.rng.choice(choices)

    def show(self, kind: str, text: str, digits: int | None = None) -> None:
        """Prints the value of an additive expression of this kind."""
        self._shown += 1
        self.line(f'#debug concat("{self._shown}: ", {self.as_text(kind, text, digits)}, "\\n")')

    def as_text(self, kind: str, text: str, digits: int | None = None) -> str:
        """A string expression that prints the value; as many `digits` as the two programs should share."""
        if kind == "s":
            return f'"[", {text}, "]"'
        if kind == "f":
            return f"str({text}, 0, {self.pick((9, 6, 12, 16)) if digits is None else digits})"
        length = {"v2": 2, "v3": 3, "v4": 4, "c": 5}[kind]
        if digits is None:
            digits = self.pick((6, 8, 15)) if length < 5 else 6
        return f'vstr({length}, {text}, ",", 0, {digits})'
