"""What a benchmark consists of."""
import dataclasses
import typing


@dataclasses.dataclass
class Value:
    """A measured quantity beside its reference."""
    name: str
    measured: float
    reference: float

    def error(self):
        return self.measured / self.reference - 1


@dataclasses.dataclass
class Problem:
    """`deck(level, variant)`: the text; each level halves the edges. `measure(run, level, variant)`: Values, the same
    names for all. `text`: what it is, with the reference; `cause`: why errors remain, below the table."""
    name: str
    title: str
    text: str
    deck: typing.Callable
    measure: typing.Callable
    variants: tuple
    levels: tuple = (0, 1, 2)
    column: str = "contact"  # what the variants are
    cause: str = ""
    finest: dict = dataclasses.field(default_factory=dict)  # {variant: level}, where finer meshes take too long
    small: tuple = (0, 0)  # level and position of the variant of the deck in data/benchmarks

    def levels_of(self, variant):
        return [level for level in self.levels if level <= self.finest.get(variant, level)]
