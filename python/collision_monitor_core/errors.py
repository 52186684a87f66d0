# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the library raises. Each exception carries all faults, not only the first."""
from typing import Iterable, List, NamedTuple, Tuple


class Problem(NamedTuple):
    """One fault of the user's input."""
    where: str  #: "robot.urdf line 42, link 'arm', collision 2"
    found: str  #: "box size '0.1 -0.2 0.3'"
    accepted: str  #: "three numbers greater than 0, in metres"; "" if it does not apply
    advice: str  #: what was done, or what the user can do; "" if there is none

    def __str__(self) -> str:
        text = ": ".join(filter(None, (self.where, self.found)))
        accepted = self.accepted and f"accepted: {self.accepted}"
        return "; ".join(filter(None, (text, accepted, self.advice)))


class SetupError(ValueError):
    """Robots or options cannot be used."""

    def __init__(self, problems: Iterable[Tuple[str, str, str, str]]) -> None:
        self.problems: List[Problem] = [Problem(*problem) for problem in problems]
        super().__init__(self.problems)

    def __str__(self) -> str:
        return "\n".join(map(str, self.problems))


class ArgumentError(ValueError):
    """A call cannot be answered: an array of a wrong shape, a joint that is not there, a number
    out of range. Nothing has changed."""

    def __init__(self, faults: Iterable[str]) -> None:
        self.faults: List[str] = list(faults)
        super().__init__(self.faults)

    def __str__(self) -> str:
        return "\n".join(self.faults)
