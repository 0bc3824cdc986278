"""Lists of records with the same attributes, and their tables."""


def record_repr(record):
    """Contact(id=1, title='all parts', …) with what is not empty."""
    shown = []
    for name in record._fields:
        value = getattr(record, name)
        if hasattr(value, "shape"):
            shown.append(f"{name}=<{' × '.join(map(str, value.shape))}>")
        elif isinstance(value, (bool, int, float, str)) and value != "":
            shown.append(f"{name}={value!r}")
    return f"{type(record).__name__}({', '.join(shown[:8])}{', …' if len(shown) > 8 else ''})"


class Records(tuple):
    """A tuple of records of one kind."""

    __slots__ = ()

    def to_frame(self):
        """The records as a pandas.DataFrame, one column per attribute. Needs pandas."""
        import pandas
        columns = self[0]._fields if self else ()
        return pandas.DataFrame({name: [getattr(record, name) for record in self] for name in columns})
