"""Penetrations and ties as parallel arrays."""
import enum

import numpy

from . import _core


def _enumeration(name, words, text):
    """Codes of an array by their words: Outcome.MOVED == 0."""
    members = {word.upper().replace("-", "_"): code for code, word in enumerate(words)}
    made = enum.IntEnum(name, members, module=__name__)
    made.__doc__ = text
    return made


PenetrationKind = _enumeration("PenetrationKind", _core.names["kind"], "Which finding a penetration is: GC101, …")
Outcome = _enumeration("Outcome", _core.names["outcome"], "What the solver does with a penetrating node at the start.")
Feature = _enumeration("Feature", _core.names["feature"], "The part of a segment that is closest to a node.")
ThicknessRule = _enumeration("ThicknessRule", _core.names["thickness_rule"], "The input that gave a contact thickness.")
TieReason = _enumeration("TieReason", _core.names["reason"], "Why a node of a tied contact needs attention.")

AXES = ("x", "y", "z")


class Columns:
    """n records as parallel arrays: entry i of each belongs to record i; arrays of n × k have a row per record.

    The arrays belong to the library: they are read-only, and each keeps the report alive.
    """

    _words = {}  # column: words of its codes
    _parts = {}  # column: names of its parts, for frames
    _rule = ""  # column whose codes lead to a rule, and the words of these; empty: none does

    def __init__(self, arrays, contacts, files):
        self._arrays, self._contacts, self._files = arrays, contacts, files
        self.__dict__.update(arrays)

    def __len__(self):
        return len(self._arrays["node"])

    def __repr__(self):
        return f"<{type(self).__name__}: {len(self)}>"

    @property
    def columns(self):
        """Names of the arrays."""
        return tuple(self._arrays)

    @property
    def contact_id(self):
        """n ids of contacts; `contact` has their positions in Report.contacts."""
        ids = numpy.array([contact.id for contact in self._contacts], dtype=numpy.int64)
        return ids[self._arrays["contact"]] if len(self) else ids[:0]

    def words(self, column):
        """n words of a column of codes: words("outcome") has "moved", "kept", …; words("rule") has "GC101", …"""
        if column == "rule" and self._rule:
            return numpy.array(_core.names[self._rule + "_rule"])[self._arrays[self._rule]]
        if column not in self._words:
            listed = sorted(self._words) + ["rule"] * bool(self._rule)
            raise KeyError(f"{column!r} is no column of codes; there are {', '.join(listed)}")
        return numpy.array(_core.names[self._words[column]])[self._arrays[column]]

    def to_numpy(self):
        """A structured array of n records with all columns: a copy."""
        fields = [(name, array.dtype, array.shape[1:]) for name, array in self._arrays.items()]
        records = numpy.empty(len(self), dtype=fields)
        for name, array in self._arrays.items():
            records[name] = array
        return records

    def to_frame(self):
        """A pandas.DataFrame of n rows: codes are categories, contacts are ids, files are paths, and arrays of n × k
        are k columns (position_x, position_y, position_z). Needs pandas."""
        import pandas
        series = {}
        if self._rule:
            series["rule"] = pandas.Categorical.from_codes(*_distinct(self._arrays[self._rule],
                                                                      _core.names[self._rule + "_rule"]))
        for name, array in self._arrays.items():
            if name in self._words:
                series[name] = pandas.Categorical.from_codes(array.astype(numpy.int8),
                                                             list(_core.names[self._words[name]]))
            elif name == "contact":
                series["contact_id"] = self.contact_id
            elif name == "file":
                series["path"] = pandas.Categorical.from_codes(*_distinct(array, self._files))
            elif name == "by_node_set":
                series[name] = array.astype(bool)
            elif array.ndim == 2:
                series.update({f"{name}_{part}": array[:, i] for i, part in enumerate(self._parts[name])})
            else:
                series[name] = array
        return pandas.DataFrame(series)


def _distinct(codes, words):
    """Codes and categories without repeated words; a code without a word becomes -1."""
    distinct = list(dict.fromkeys(words))
    position = {word: i for i, word in enumerate(distinct)}
    table = numpy.array([position[word] for word in words] + [-1], dtype=numpy.int64)
    return table[numpy.minimum(codes, len(words))], distinct


class Penetrations(Columns):
    """n penetrations by contact, deepest first, then by node id. A record read from a solver's file has zeros for what
    the file does not give, and NaN for `local`."""

    _words = {"kind": "kind", "outcome": "outcome", "feature": "feature", "node_rule": "thickness_rule",
              "segment_rule": "thickness_rule"}
    _parts = {"segment": ("1", "2", "3", "4"), "local": ("s", "t"), "position": AXES, "closest": AXES, "moved_to": AXES}
    _rule = "kind"

    kind: numpy.ndarray  # n codes of PenetrationKind
    contact: numpy.ndarray  # n positions in Report.contacts
    node: numpy.ndarray  # n ids; edges: of the end nearest to the other edge
    part: numpy.ndarray  # n ids, of the node; 0: unknown
    segment: numpy.ndarray  # n × 4 node ids; triangles and edges repeat the last one
    segment_number: numpy.ndarray  # n, in the contact's reference surface, from 1
    element: numpy.ndarray  # n ids, of the segment's element; 0: unknown
    element_part: numpy.ndarray  # n ids; 0: unknown
    depth: numpy.ndarray  # n lengths, positive
    contact_distance: numpy.ndarray  # n lengths; contact_distance - depth remains
    local: numpy.ndarray  # n × 2: s and t of the closest point on the segment, -1 to 1
    position: numpy.ndarray  # n × 3: the node before the contact was initialised
    closest: numpy.ndarray  # n × 3: the closest point of the segment or of the other edge
    moved_to: numpy.ndarray  # n × 3: where the solver puts the node, or recommends to
    outcome: numpy.ndarray  # n codes of Outcome
    feature: numpy.ndarray  # n codes of Feature
    node_rule: numpy.ndarray  # n codes of ThicknessRule
    segment_rule: numpy.ndarray  # n codes of ThicknessRule
    file: numpy.ndarray  # n positions in Report.files
    line: numpy.ndarray  # n, from 1; 0: unknown

    def __repr__(self):
        return f"<Penetrations: {len(self)}{f', deepest {self.depth.max():g}' if len(self) else ''}>"


class Ties(Columns):
    """n nodes of tied contacts that did not tie, or tied with a distance; by contact, reason and node id."""

    _words = {"reason": "reason"}
    _parts = {"position": AXES}
    _rule = "reason"

    reason: numpy.ndarray  # n codes of TieReason
    contact: numpy.ndarray  # n positions in Report.contacts
    node: numpy.ndarray  # n ids
    part: numpy.ndarray  # n ids; 0: unknown
    segment_number: numpy.ndarray  # n, from 1; 0: unknown
    distance: numpy.ndarray  # n lengths, from the segment; negative: unknown
    allowed: numpy.ndarray  # n lengths, within which the node would tie; negative: unknown
    position: numpy.ndarray  # n × 3, of the node in the deck; NaN: unknown
    by_node_set: numpy.ndarray  # n, 1: a node set names the node
    file: numpy.ndarray  # n positions in Report.files
    line: numpy.ndarray  # n, from 1; 0: unknown
