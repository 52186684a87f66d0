# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Words of answers. Columns of answers hold their numbers, so `answers.verdict == Verdict.contact`
is an array of bool."""
import enum


class Verdict(enum.IntEnum):
    """What is said of a pair of links, or of all pairs; ordered by urgency."""
    clear = 0
    warning = 1  #: at or below warning_distance
    unknown = 2  #: joint values are missing: never read it as clear
    contact = 3  #: at or below contact_distance


class Quality(enum.IntEnum):
    """What a distance says about the geometries of the URDF."""
    exact = 0  #: it is theirs
    lower_bound = 1  #: theirs is at least this
    unknown = 2  #: it means nothing: joint values are missing
    estimate = 3  #: they overlap, at least this deep


class PathState(enum.IntEnum):
    """What is said of a pair of links on a path."""
    clear = 0  #: proven: no contact on the whole path
    contact = 1  #: proven: first contact at `time`, clear before
    undecided = 2  #: the budget ended the search; clear up to `time`
    unknown = 3  #: joint values are missing
