"""How functions of the package fail."""


class Error(Exception):
    """A deck, file or option that cannot be worked with.

    message: what is wrong, and what to do; file: path, empty if about no file; line: from 1, 0 for the whole file;
    diagnostics: further ones about the input, errors first. As text: "file:line: message".
    """

    def __init__(self, message, file="", line=0, diagnostics=()):
        super().__init__(message, file, line)
        self.message, self.file, self.line, self.diagnostics = message, file, line, tuple(diagnostics)

    def __str__(self):
        place = f"{self.file}:{self.line}: " if self.file and self.line else f"{self.file}: " if self.file else ""
        return place + self.message

    def __reduce__(self):
        """Other processes get it without the diagnostics."""
        return Error, self.args
