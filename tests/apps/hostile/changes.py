"""Changes of decks, logs and binary files. Each takes bytes, a random.Random that chooses the place, and a value of the
table (inputs.py), and gives the changed bytes."""

import gzip
import struct

WIDTHS = {b"*NODE": (8, 16, 16, 16, 8, 8), b"*ELEMENT": (8,) * 10}


def lines_of(data):
    return data.split(b"\n")


def is_card(line):
    return bool(line.strip()) and line[:1] not in (b"*", b"$")


def blocks_of(lines):
    """First and last line of each keyword, which is lines[first]."""
    starts = [i for i, line in enumerate(lines) if line.startswith(b"*")]
    return list(zip(starts, starts[1:] + [len(lines)]))


def some_card(lines, chance, more=0):
    """The number of a card, each keyword equally often, and of its keyword; `more`: so many cards follow it."""
    blocks = blocks_of(lines)
    chance.shuffle(blocks)
    for first, last in blocks:
        cards = [i for i in range(first + 1, last) if is_card(lines[i])]
        if len(cards) > more:
            return chance.choice(cards[:len(cards) - more]), first
    return None, None


def widths_of(keyword, line):
    """Where the fields of a line begin and end."""
    if b"," in line:
        ends = [i for i, byte in enumerate(line) if byte == 44] + [len(line)]
        return list(zip([0] + [end + 1 for end in ends[:-1]], ends))
    widths = next((w for name, w in WIDTHS.items() if keyword.startswith(name)), (10,) * 8)
    spans, at = [], 0
    for width in widths:
        if at < len(line):
            spans.append((at, min(at + width, len(line))))
        at += width
    return spans


def field(data, chance, text):
    """One field has another text; too long for its columns, the card gets commas."""
    lines = lines_of(data)
    at, keyword = some_card(lines, chance)
    if at is None:
        return data
    line = lines[at]
    begin, end = chance.choice(widths_of(lines[keyword], line))
    text = text.encode()
    if b"," in line or len(text) > end - begin:
        spans = widths_of(lines[keyword], line)
        lines[at] = b",".join(text if span[0] == begin else line[span[0]:span[1]].strip() for span in spans)
    else:
        lines[at] = line[:begin] + text.rjust(end - begin) + line[end:]
    return b"\n".join(lines)


def all_fields(data, chance, text):
    """The same field of every card of a keyword."""
    lines = lines_of(data)
    at, keyword = some_card(lines, chance)
    if at is None:
        return data
    number = chance.randrange(len(widths_of(lines[keyword], lines[at])))
    last = next(end for first, end in blocks_of(lines) if first == keyword)
    for i in range(keyword + 1, last):
        spans = widths_of(lines[keyword], lines[i])
        if is_card(lines[i]) and number < len(spans):
            begin, end = spans[number]
            lines[i] = lines[i][:begin] + text.encode()[:end - begin].rjust(end - begin) + lines[i][end:]
    return b"\n".join(lines)


def other_id(data, chance, number):
    """An id of the deck becomes another wherever it stands."""
    lines = lines_of(data)
    at, keyword = some_card(lines, chance)
    if at is None:
        return data
    begin, end = widths_of(lines[keyword], lines[at])[0]
    old, new = lines[at][begin:end], str(number).encode()
    if not old.strip() or len(new) > len(old):
        return data
    return data.replace(old, new.rjust(len(old)))


def card(data, chance, what):
    """dropped, doubled, swapped, blank, half, repeated, comma, tabs, colons, moved: what happens to a card."""
    lines = lines_of(data)
    at, keyword = some_card(lines, chance, more=1 if what == "swapped" else 0)
    if at is None:
        return data
    line = lines[at]
    new = {"dropped": [], "doubled": [line, line], "blank": [b""], "half": [line[:len(line) // 2]],
           "repeated": [line] * 3000, "comma": [b",".join(line.split())], "tabs": [b"\t".join(line.split())],
           "commas only": [b"," * 40], "commented": [b"$" + line], "keyword": [b"*" + line],
           "long": [b"".join(part.rjust(20) for part in line.split())], "shifted": [b"   " + line],
           "swapped": [], "moved": []}[what]
    lines[at:at + 1] = new
    if what in ("swapped", "moved"):
        lines.insert(at + 1 if what == "swapped" else chance.randrange(len(lines)), line)
    return b"\n".join(lines)


def block(data, chance, what):
    """What happens to a keyword with its cards."""
    lines = lines_of(data)
    blocks = blocks_of(lines)
    if not blocks:
        return data
    first, last = chance.choice(blocks)
    own = lines[first:last]
    new = {"dropped": [], "doubled": own * 2, "without cards": own[:1], "backwards": own[:1] + own[:0:-1],
           "1000 times": own * 1000, "first": own, "last": own}[what]
    lines[first:last] = new if what not in ("first", "last") else []
    if what in ("first", "last"):
        lines = own + lines if what == "first" else lines + own
    return b"\n".join(lines)


def keyword_text(data, chance, text):
    """A keyword gets an ending; one that begins with a star takes its place."""
    lines = lines_of(data)
    blocks = blocks_of(lines)
    if not blocks:
        return data
    first, _ = chance.choice(blocks)
    text = text.encode()
    lines[first] = text if text.startswith(b"*") else lines[first].rstrip() + text
    return b"\n".join(lines)


def contact_type(data, chance, name):
    """Every contact is of another type, with the cards of the old one."""
    lines = [b"*CONTACT_" + name.encode() + (b"_ID" if b"_ID" in line else b"") if line.startswith(b"*CONTACT_")
        else line
             for line in lines_of(data)]
    return b"\n".join(lines)


def before_end(data, chance, text):
    """More keywords before *END; a function is called first, since the text is long."""
    text = text() if callable(text) else text
    text = text if isinstance(text, bytes) else text.encode()
    at = data.rfind(b"*END")
    return data + text if at < 0 else data[:at] + text + data[at:]


def cut(data, chance, share):
    """The file ends after a share of its bytes."""
    return data[:int(len(data) * share)]


def encoded(data, chance, how):
    """The whole file in another form."""
    text = data.decode("latin-1")
    at = chance.randrange(len(data) + 1)
    return {
        "UTF-16 with mark": lambda: text.encode("utf-16"), "UTF-16 BE": lambda: text.encode("utf-16-be"),
        "UTF-32": lambda: text.encode("utf-32"), "UTF-8 mark": lambda: b"\xef\xbb\xbf" + data,
        "two marks": lambda: b"\xef\xbb\xbf" * 2 + data, "CR": lambda: data.replace(b"\n", b"\r"),
        "CR LF": lambda: data.replace(b"\n", b"\r\n"), "CR CR LF": lambda: data.replace(b"\n", b"\r\r\n"),
        "LF CR": lambda: data.replace(b"\n", b"\n\r"), "next line": lambda: data.replace(b"\n", "\u0085".encode()),
        "line separator": lambda: data.replace(b"\n", "\u2028".encode()),
        "one CR": lambda: data.replace(b"\n", b"\r", 1), "one line": lambda: data.replace(b"\n", b" "),
        "empty lines between": lambda: data.replace(b"\n", b"\n\n"), "NULs at the end": lambda: data + bytes(5000),
        "NULs in the middle": lambda: data[:at] + bytes(300) + data[at:], "all NULs": lambda: bytes(len(data)),
        "NULs for blanks": lambda: data.replace(b" ", b"\0"), "tabs for blanks": lambda: data.replace(b"  ", b"\t"),
        "gzip": lambda: gzip.compress(data, mtime=0), "gzip magic": lambda: b"\x1f\x8b\x08" + data,
        "garbage": lambda: chance.randbytes(4000), "garbage inside": lambda: data[:at] + chance.randbytes(500)
            + data[at:],
        "lower case keywords": lambda: b"\n".join(
            line.lower() if line.startswith(b"*") else line for line in lines_of(data)),
        "comments between": lambda: data.replace(b"\n", b"\n$ a comment\n") if b"$ gapcheck:" not in data else data,
        "blanks at line ends": lambda: data.replace(b"\n", b"   \n"),
        "text behind *END": lambda: data + b"\nhello\n*NODE\n1,2,3\n",
        "lower case": lambda: data.lower(), "high bit": lambda: bytes(byte | 128 for byte in data),
        "reversed": lambda: data[::-1], "twice": lambda: data + data, "empty": lambda: b"", "one byte": lambda: b"*",
        "one line end": lambda: b"\n", "a million blanks": lambda: data[:at] + b" " * 1_000_000 + data[at:],
        "a line of 10 MB": lambda: data[:at] + b"1234567890" * 1_000_000 + data[at:],
        "10^5 empty lines": lambda: data[:at] + b"\n" * 100_000 + data[at:],
        "escapes": lambda: data.replace(b"plate", b"\x1b[2J\xc2\x9b31m\x9b0m\x07"),
        "PGP": lambda: data.replace(b"*NODE", b"-----BEGIN PGP MESSAGE-----\nabc=\n-----END PGP MESSAGE-----\n*NODE",
            1),
        "no line end": lambda: data.rstrip(b"\n"), "control-Z": lambda: data[:at] + b"\x1a" + data[at:],
    }[how]()


def some_bytes(data, chance, count):
    """So many bytes are others."""
    data = bytearray(data)
    for _ in range(min(count, len(data))):
        data[chance.randrange(len(data))] = chance.randrange(256)
    return bytes(data)


def word(data, chance, value):
    """A word of four or eight bytes of a binary file has another value, in the first 1000 bytes more often."""
    kind = {int: "<i", float: "<f"}[type(value)]
    if len(data) < 8:
        return data
    at = chance.randrange(min(len(data), 1000) if chance.random() < 0.7 else len(data)) // 4 * 4
    packed = struct.pack(kind, value)
    return data[:at] + packed + data[at + 4:]


def log_number(data, chance, text):
    """A number of a log is another text."""
    lines = lines_of(data)
    places = [i for i, line in enumerate(lines) if any(48 <= byte <= 57 for byte in line)]
    if not places:
        return data
    at = chance.choice(places)
    words = lines[at].split(b" ")
    numbers = [i for i, one in enumerate(words) if any(48 <= byte <= 57 for byte in one)]
    words[chance.choice(numbers)] = text.encode()
    lines[at] = b" ".join(words)
    return b"\n".join(lines)


def log_line(data, chance, what):
    """What happens to a line of a log."""
    lines = lines_of(data)
    at = chance.randrange(len(lines))
    line = lines[at]
    lines[at:at + 1] = {"dropped": [], "doubled": [line, line], "half": [line[:len(line) // 2]], "blank": [b""],
                        "1000 times": [line] * 1000, "swapped": [],
                        "long": [line * (1 + 100_000 // (len(line) + 1))]}[what]
    if what == "swapped":
        lines.insert(at + 1, line)
    return b"\n".join(lines)
