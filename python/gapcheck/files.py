"""Files are written complete or not at all, and never over what was read."""
import os

from .errors import Error


def _same(path, other):
    try:
        return os.path.samefile(path, other)
    except (OSError, ValueError):
        return False


def refuse_inputs(path, inputs):
    """Raises Error if the path is one of the files that were read."""
    for read in inputs:
        if _same(path, read):
            raise Error("is a file that was read, and is not written over; give another name", os.fsdecode(path))


def write(path, content, inputs=()):
    """Writes bytes to a path. Raises Error if it is one of `inputs`, OSError if it cannot be written."""
    path = os.fsdecode(path)
    refuse_inputs(path, inputs)
    if os.path.exists(path) and not os.path.isfile(path):
        with open(path, "wb") as file:  # a pipe, or a folder, which raises
            file.write(content)
        return
    path = os.path.realpath(path)
    part = f"{path}.{os.getpid()}.part"
    try:
        with open(part, "xb") as file:
            file.write(content)
        os.replace(part, path)
    except BaseException:
        if os.path.exists(part):
            os.unlink(part)
        raise
