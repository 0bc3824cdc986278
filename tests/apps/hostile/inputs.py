"""What is tried: the table of hostile inputs. check_inputs.py makes files of it, gives them to the programs and holds
the answers against what docs/reliability.md promises.

A row of DECKS, LOGS and BINARIES is a change (a function of changes.py), the values that it takes, and how many files
are changed with each value, where the place in the file is chosen by lot. A row of TEXTS is a deck with these keywords
added; a row of ARGUMENTS is a call.
"""

from typing import NamedTuple

import changes


class Row(NamedTuple):
    name: str
    change: object
    values: list
    files: int  # how many files are changed with each value
    answer: str = ""  # "refused": exit code 2; "said": a message or exit code 2; "same": the findings of the good file


# ---- Decks: every deck of data/, its includes and the corpus of the fuzzers in turn.

FIELD_TEXTS = ["", "-1", "0", "1e30", "-1e30", "1e308", "1e-320", "1e400", "nan", "-inf", "2147483648", "4294967296",
               "9223372036854775807", "9223372036854775808", "letters", "x" * 200, "&nothing", "<1/0>", "1.5.5", "0x10",
               "1d5", "+", "1e", "1 2", "\u0663"]
CARDS = ["dropped", "doubled", "swapped", "blank", "half", "repeated", "comma", "tabs", "commas only", "commented",
         "keyword", "long", "shifted", "moved"]
BLOCKS = ["dropped", "doubled", "without cards", "backwards", "1000 times", "first", "last"]
ENDINGS = ["_ID", "_TITLE", "_MPP", "_THERMAL", "_SMOOTH", "_LIST", "_GENERATE", "_GENERAL", "_OFFSET", "_BEAM_OFFSET",
           "_MORTAR", "_ORTHO_FRICTION", "_COLLECT", "_TITLE_TITLE", "+", "-", "%", " LONG=S", "_" * 300, "_\x01", ",1",
           "_ID_ID_MPP_MPP", "_INTERFERENCE"]
OTHER_KEYWORDS = ["*", "**", "*NODE", "*ELEMENT_SOLID", "*ELEMENT_BEAM", "*ELEMENT_SHELL_THICKNESS_OFFSET",
                  "*ELEMENT_TSHELL", "*SET_NODE_GENERAL", "*SET_SEGMENT", "*SET_PART_ADD", "*SECTION_BEAM",
                  "*MAT_RIGID", "*MAT_PIECEWISE_LINEAR_PLASTICITY", "*PARAMETER_EXPRESSION", "*DEFINE_CURVE",
                  "*DEFINE_TRANSFORMATION", "*INCLUDE", "*INCLUDE_TRANSFORM", "*CONTACT_ENTITY", "*KEYWORD", "*END",
                  "*BOUNDARY_SPC_SET", "*CONSTRAINED_NODAL_RIGID_BODY", "*CONTROL_CONTACT", "*CONTROL_TIMESTEP",
                  "*PART_CONTACT", "*RIGIDWALL_PLANAR", "*COMMENT", "*TITLE"]
NO_DECKS = ["UTF-16 with mark", "UTF-16 BE", "UTF-32", "CR", "next line", "line separator", "one line", "all NULs",
    "gzip",
            "garbage", "high bit", "reversed", "empty", "one byte", "one line end"]
SAME = ["UTF-8 mark", "CR LF", "CR CR LF", "no line end", "lower case keywords", "comments between",
    "blanks at line ends",
        "text behind *END"]
ENCODINGS = ["two marks", "LF CR", "one CR", "empty lines between", "NULs at the end", "NULs in the middle",
             "NULs for blanks", "tabs for blanks", "gzip magic", "garbage inside", "lower case", "twice",
                 "a million blanks",
             "a line of 10 MB", "10^5 empty lines", "escapes", "PGP", "control-Z"]
SHARES = [0.01, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.97, 0.999]

DECKS = [
    Row("the file is cut at this share", changes.cut, SHARES, 6, "said"),
    Row("a field is", changes.field, FIELD_TEXTS, 16),
    Row("a field of all cards of a keyword is", changes.all_fields, FIELD_TEXTS, 6),
    Row("an id everywhere becomes", changes.other_id, [0, -1, 1, 2, 1001, 99999999], 10),
    Row("a card is", changes.card, CARDS, 10),
    Row("a keyword with its cards is", changes.block, BLOCKS, 8),
    Row("a keyword ends with", changes.keyword_text, ENDINGS, 4),
    Row("a keyword becomes", changes.keyword_text, OTHER_KEYWORDS, 5),
    Row("the file is in a form without keywords:", changes.encoded, NO_DECKS, 8, "refused"),
    Row("the file is in another form of the same:", changes.encoded, SAME, 24, "same"),
    Row("the file is", changes.encoded, ENCODINGS, 4),
    Row("so many bytes change", changes.some_bytes, [1, 3, 30, 300], 10),
]
CONTACT_TYPES = 1  # files per contact type of docs/contact.md


# ---- Keywords that are added to data/two_plates.k; other files of the folder are in FILES.

def includes(*names):
    return "".join(f"*INCLUDE\n{name}\n" for name in names)


TEXTS = {
    "includes itself": includes("deck.k"),
    "includes itself by other names": includes("./deck.k", "../in/deck.k", "link.k"),
    "includes a folder": includes("."),
    "includes the root": includes("/"),
    "includes /dev/null": includes("/dev/null"),
    "includes /dev/zero": includes("/dev/zero"),
    "includes /proc/self/mem": includes("/proc/self/mem"),
    "includes the terminal": includes("/dev/stdin", "/dev/tty"),
    "includes nothing": "*INCLUDE\n\n*INCLUDE\n",
    "includes a long name": includes("n" * 300),
    "includes a very long name": includes("d/" * 5000 + "n"),
    "includes a name with NUL": includes("a\0b"),
    "includes a name with escapes": includes("\x1b[31m::error::x"),
    "includes what is missing, 10^4 times": lambda: includes(*(f"missing{i}.k" for i in range(10_000))),
    "includes two that include each other": includes("a.k"),
    "includes a chain of 200": includes("chain000.k"),
    "includes one file 300 times": includes(*["small.k"] * 300),
    "includes with endless continuation": "*INCLUDE\n" + "part/ +\n" * 3000,
    "includes a link to itself": includes("round.k"),
    "includes a binary file": includes("binary.k"),
    "includes with offsets beyond all numbers":
        "*INCLUDE_TRANSFORM\nsmall.k\n" + "9223372036854775807," * 7 + "\n\n\n1\n" + "4611686018427387904," * 7 + "\n",
    "includes with offsets, ids that meet": "*INCLUDE_TRANSFORM\nsmall.k\n\n\n\n\n" * 2,
    "includes with units of nothing": "*INCLUDE_TRANSFORM\nsmall.k\n\n\n0.,0.,0.,0.\n\n",
    "include path of 10^4 folders": lambda: "*INCLUDE_PATH\n" + "".join(f"/nowhere/{i}\n" for i in range(10_000)),
    "include path to the root": "*INCLUDE_PATH\n/\n*INCLUDE\nproc/self/environ\n",
    "a parameter of itself": "*PARAMETER_EXPRESSION\nRa      a+1\n*SECTION_SHELL\n9,2\n&a\n",
    "parameters in a circle": "*PARAMETER_EXPRESSION\nRa      b\nRb      a\n*SECTION_SHELL\n9,2\n&a\n",
    "a parameter with 10^5 brackets": "*PARAMETER_EXPRESSION\nRa      " + "(" * 100_000 + "1" + ")" * 100_000 + "\n",
    "a parameter with 10^5 signs": "*PARAMETER_EXPRESSION\nRa      " + "-" * 100_000 + "1\n",
    "a parameter with 10^4 powers": "*PARAMETER_EXPRESSION\nRa      2" + "**2" * 10_000 + "\n",
    "a parameter of functions in functions": "*PARAMETER_EXPRESSION\nRa      " + "sin(" * 5000 + "1" + ")" * 5000
        + "\n",
    "a parameter of nothing": "*PARAMETER_EXPRESSION\nRa      \nRb      1/0\nRc      0**-1\nId      1e300*1e300\n",
    "parameters without names": "*PARAMETER\nR       1.0\n,2\n&&,3\nR&a,&a\n",
    "10^5 parameters": lambda: "*PARAMETER\n" + "".join(f"Rp{i:07d}1.0\n" for i in range(100_000)),
    "a parameter is a number of all digits": "*PARAMETER\nRa      " + "1" * 5000 + "\n*SECTION_SHELL\n9,2\n&a\n",
    "a set of itself": "*SET_PART_ADD\n77\n77\n*SET_NODE_ADD\n77\n77\n",
    "sets of sets in a circle": "*SET_PART_ADD\n77\n78\n*SET_PART_ADD\n78\n77\n"
        + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n77,0,2\n\n\n",
    "sets of sets, 3000 deep":
        lambda: "".join(f"*SET_PART_ADD\n{i}\n{i + 1}\n" for i in range(100, 3100))
            + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n100,0,2\n\n\n",
    "sets of sets that double":
        lambda: "".join(f"*SET_NODE_ADD\n{i}\n{i + 1},{i + 1}\n" for i in range(100, 150))
            + "*SET_NODE_LIST\n150\n1001\n"
        + "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n100,1,4,3\n\n\n",
    "a set of all numbers": "*SET_NODE_LIST_GENERATE\n77\n1,9223372036854775807\n*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n"
        "77,1,4,3\n\n\n",
    "a set of ranges in steps of nothing": "*SET_NODE_LIST_GENERATE_INCREMENT\n77\n1,1000000000,0\n2,1,-1\n",
    "a set of parts of all numbers": "*SET_PART_LIST_GENERATE\n77\n-5,4000000000\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n"
        "77,0,2\n\n\n",
    "a set by columns that end early": "*SET_PART_COLUMN\n77\n1,1,1,1,1,1,1,1,1,1,1\n*SET_SEGMENT\n78\n1001\n"
        "1001,1001,1001,1001\n",
    "a set in general of everything": "*SET_SEGMENT_GENERAL\n77\nALL\nPART,1\nBOX,99\nSEG,1,2,3,4\nDPART,1\n"
        "NOTHING,1\n",
    "a set with an id of nothing": "*SET_NODE_LIST\n\n1001\n*SET_NODE_LIST\n0\n1001\n*SET_NODE_LIST\n-7\n1001\n",
    "a box inside out": "*DEFINE_BOX\n5,10.,-10.,10.,-10.,10.,-10.\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0,5,5\n\n"
        "\n",
    "10^5 keywords": lambda: "*TITLE\nx\n" * 100_000,
    "10^5 keywords that nobody knows": lambda: "".join(f"*NOBODY_{i}\n1,2,3\n" for i in range(100_000)),
    "10^5 times the same keyword, misspelt": lambda: "*CONTCT_AUTOMATIC_SINGLE_SURFACE\n1,2,3\n" * 100_000,
    "10^5 cards too many": lambda: "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + "0,0,5,0\n" * 100_000,
    "10^5 sections of one id": lambda: "*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n" * 100_000,
    "3000 contacts": lambda: "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0\n\n\n" * 3000,
    "10^5 ends": lambda: "*END\n" * 100_000 + "*NODE\n1,0.,0.,0.\n",
    "10^5 comments": lambda: "$ gapcheck: ignore GC101\n" * 100_000,
    "ignores of everything": "$ gapcheck: ignore\n$ gapcheck: ignore GC\n$ gapcheck: ignore " + "x" * 10_000
        + "\n$ gapcheck: ignore GC101 until 99999-99-99\n",
    "a curve of 10^5 points": lambda: "*DEFINE_CURVE\n5\n" + "".join(f"{i}.,{i}.\n" for i in range(100_000)),
    "a curve backwards, of one point, of none": "*DEFINE_CURVE\n5\n2.,1.\n1.,1.\n*DEFINE_CURVE\n6\n1.,1.\n"
        "*DEFINE_CURVE\n7\n",
    "a curve of infinities": "*DEFINE_CURVE\n5\n-1e308,-1e308\n1e308,1e308\nnan,nan\n",
    "a table of itself": "*DEFINE_TABLE\n5\n1.,5\n2.,5\n*DEFINE_TABLE_2D\n6\n1.,6\n",
    "a transformation of 10^4 steps": lambda: "*DEFINE_TRANSFORMATION\n1\n" + "SCALE,1e10,1e10,1e10\n" * 10_000
        + "*INCLUDE_TRANSFORM\nsmall.k\n\n\n\n1\n",
    "a transformation to nothing": "*DEFINE_TRANSFORMATION\n1\nSCALE,0.,0.,0.\nROTATE,0.,0.,0.,0.,0.,0.,90.\n"
        "NOWHERE,1.\nSCALE,nan\n*INCLUDE_TRANSFORM\nsmall.k\n\n\n\n1\n",
    "a coordinate system of one point": "*DEFINE_COORDINATE_NODES\n1,1001,1001,1001\n*DEFINE_COORDINATE_SYSTEM\n2\n\n"
        "*DEFINE_COORDINATE_VECTOR\n3\n",
    "elements of nodes that are one": "*ELEMENT_SHELL\n9001,1,1001,1001,1001,1001\n*ELEMENT_SOLID\n"
        "9002,1,1001,1001,1001,1001,1001,1001,1001,1001\n*ELEMENT_BEAM\n9003,1,1001,1001\n",
    "elements that share all nodes": lambda: "*ELEMENT_SHELL\n" + "".join(f"{i},1,1001,1002,1006,1005\n"
        for i in range(9000, 14_000)),
    "an element of nodes far apart": "*NODE\n9001,1e30,0.,0.\n9002,-1e30,0.,0.\n9003,0.,1e30,1e30\n*ELEMENT_SHELL\n"
        "9001,1,9001,9002,9003,1001\n",
    "nodes of infinity": "*NODE\n9001,inf,nan,0.\n9002,1e999,0.,0.\n9003,-1e999,0.,0.\n*ELEMENT_SHELL\n"
        "9001,1,9001,9002,9003,1001\n",
    "nodes beside each other by the last bit": "*NODE\n9001,1.0000000000000002,0.,0.\n9002,1.,0.,0.\n"
        "9003,1.,5e-324,0.\n*ELEMENT_SHELL\n9001,1,9001,9002,9003\n",
    "a mesh that is far away": "*NODE\n9001,1e15,1e15,1e15\n9002,1.000000000000001e15,1e15,1e15\n"
        "9003,1e15,1.000000000000001e15,1e15\n*ELEMENT_SHELL\n9001,1,9001,9002,9003\n",
    "parts without anything": "*PART\n\n\n*PART\na\n*PART\n\n0\n*PART\n\n-1,-1,-1\n*PART\nb\n99999999999,7,7\n",
    "sections of the wrong kind": "*SECTION_SOLID\n1,1\n*SECTION_BEAM\n2,1\n0.,0.\n",
    "thickness of nothing and of everything": "*SECTION_SHELL\n1,2\n0.,0.,0.,0.\n*SECTION_SHELL\n2,2\n"
        "1e30,-1e30,nan,1e-300\n",
    "materials of nothing": "*MAT_ELASTIC\n1,0.,0.,0.5\n*MAT_ELASTIC\n2,-1.,-1.,-1.\n*MAT_RIGID\n3\n*MAT_NULL\n",
    "materials with curves that are missing": "*MAT_PIECEWISE_LINEAR_PLASTICITY\n5,7.8e-9,2.1e5,0.3\n0.,0.,999,-999\n\n"
        "\n*PART\nc\n3,1,5\n",
    "a contact of nothing": "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n*CONTACT_TIED_NODES_TO_SURFACE\n\n\n\n*CONTACT_\n"
        "*CONTACT\n",
    "a contact of what is missing": "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n777,778,2,2\n\n\n"
        "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n-1,-2,99,-99\n\n\n",
    "a contact thicker than the world": "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0\n\n,,,1e30,1e30\n"
        "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0\n\n1e30,1e30,1e30,nan\n",
    "a contact of the same twice": "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,1,3,3\n\n\n"
        "*CONTACT_TIED_SURFACE_TO_SURFACE\n1,1,3,3\n\n\n",
    "optional cards of infinities": "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0\n\n\n"
        + "1e30,-1e30,nan,inf,1e30,-1,99999999999,-7\n" * 5,
    "controls of infinities": "*CONTROL_CONTACT\n1e30,1e30,99,-99,99,99,99,nan\n" + "99,99,99,99,99,99,99,99\n" * 5
        + "*CONTROL_SHELL\n-1,-1,-1,-1\n*CONTROL_TIMESTEP\n1e30,-1e30,99,-1e30,-1e30\n*CONTROL_TERMINATION\n1e30\n",
    "rigid bodies of everything": "*CONSTRAINED_NODAL_RIGID_BODY\n77,0,999\n*CONSTRAINED_RIGID_BODIES\n1,1\n1,2\n2,1\n"
        "*CONSTRAINED_EXTRA_NODES_NODE\n1,1001\n1,-5\n",
    "rigid walls of nothing": "*RIGIDWALL_PLANAR\n0,0,0\n1.,1.,1.,1.,1.,1.,0.\n*RIGIDWALL_GEOMETRIC_SPHERE\n\n\n\n",
    "conditions on what is missing": "*BOUNDARY_SPC_SET\n777,0,1,1,1\n*LOAD_NODE_POINT\n777,9,9,1e30\n"
        "*INITIAL_VELOCITY\n777\n1e30,1e30,1e30\n*BOUNDARY_PRESCRIBED_MOTION_SET\n777,9,9,9\n",
    "velocities beyond light": "*INITIAL_VELOCITY\n0\n1e30,-1e30,1e30\n",
    "a title of a megabyte": "*TITLE\n" + "t" * 1_000_000 + "\n",
    "a title of commands": "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n9,</script><script>alert(1)</script>]]>&\"'\n"
        "0,0,5,0\n\n\n",
    "a comment block without end": "*COMMENT\n" + "text\n" * 1000,
    "a keyword of a megabyte": "*" + "K" * 1_000_000 + "\n1,2\n",
    "case, blanks and tabs before keywords": " *NODE\n1,0.,0.,0.\n\t*NODE\n*node\n9001,0.,0.,0.\n*Node +\n"
        "9002,0.,0.,0.\n",
    "long and short in one file": "*KEYWORD LONG=Y\n*NODE\n9001,0.,0.,0.\n*NODE -\n9002,0.,0.,0.\n*NODE +\n9003\n"
        "*NODE %\n9004,0.,0.,0.\n*KEYWORD LONG=NO I10=Y\n*NODE\n9005,0.,0.,0.\n",
    "Fortran's numbers": "*NODE\n9001,1.5-345,1+5,1d0\n9002,.,-.,+.\n9003,1.e,1e+,--1\n",
}
# Beside the deck.
FILES = {
    "small.k": "*KEYWORD\n*NODE\n8001,0.,0.,9.\n8002,5.,0.,9.\n8003,5.,5.,9.\n*ELEMENT_SHELL\n8001,1,8001,8002,8003\n"
        "*END\n",
    "a.k": "*KEYWORD\n*INCLUDE\nb.k\n*END\n", "b.k": "*KEYWORD\n*INCLUDE\na.k\n*END\n",
    "binary.k": bytes(range(256)) * 20,
    **{f"chain{i:03d}.k": f"*KEYWORD\n*INCLUDE\nchain{i + 1:03d}.k\n*END\n" for i in range(200)},
    "chain200.k": "*KEYWORD\n*END\n",
}
LINKS = {"link.k": "deck.k", "round.k": "round.k"}


# ---- Logs and tables of a run: the logs of tests/apps/fixtures and of the fuzzers, and what a run writes.

LOG_NUMBERS = ["", "-1", "0", "1e30", "nan", "inf", "2147483648", "9223372036854775808", "letters", "*******",
    "1.5-345",
               "x" * 200]
LOG_LINES = ["dropped", "doubled", "swapped", "half", "blank", "long", "1000 times"]
LOG_ENCODINGS = ["UTF-16 with mark", "UTF-8 mark", "CR", "CR LF", "NULs at the end", "NULs in the middle", "all NULs",
    "gzip",
                 "garbage", "garbage inside", "high bit", "reversed", "twice", "empty", "a line of 10 MB",
                 "a million blanks", "one line", "escapes"]
LOGS = [
    Row("the file is cut at this share", changes.cut, SHARES, 8),
    Row("a number is", changes.log_number, LOG_NUMBERS, 12),
    Row("a line is", changes.log_line, LOG_LINES, 12),
    Row("the file is", changes.encoded, LOG_ENCODINGS, 6),
    Row("so many bytes change", changes.some_bytes, [1, 3, 30, 300], 8),
]

# ---- d3plot of runs and of the fuzzers.

BINARIES = [
    Row("the file is cut at this share", changes.cut, SHARES, 4),
    Row("a word is", changes.word, [0, 1, -1, 2, 7, 100, 2147483647, -2147483648, 0.0, 1e30, float("nan"),
        float("inf")], 8),
    Row("so many bytes change", changes.some_bytes, [1, 3, 30, 300], 8),
    Row("the file is", changes.encoded, ["all NULs", "garbage", "empty", "one byte", "twice", "reversed", "gzip",
                                         "NULs at the end", "one line end"], 3),
]

# ---- Other files: settings, baselines, tables of messages. Each is one file with each text.

SETTINGS = ["", "\0", "top = ", "top = -1", "top = 9223372036854775808", "top = 1e30", "top = nan", "unknown = 1",
            "select = [", "select = " + "[" * 10_000, "select = ['GC101', 7]", "select = 'GC999'", "a." * 10_000
                + "b = 1",
            "units = 'furlongs'", "[[ignore]]\n" * 5000, "[[ignore]]\nrule = 'GC101'\nuntil = 9999-99-99",
                "top = 3\ntop = 4",
            "\xff\xfe", "{" * 5000, "'" * 5000, "select = '''", "[limits]\nGC301 = nan", "jobs = 99999999999",
            "format = 'pdf'", "output = '/dev/full'", "\ufeff", "# " + "x" * 1_000_000, "top = 0x", "top = 1979-05-27",
            "ptol = -inf"]
BASELINES = ["", "{}", "[]", "null", "{\"schema\": \"gapcheck-baseline/1\"}", "{" * 100_000, "[" * 100_000, "\"",
             "{\"schema\": 7}", "{\"findings\": [{}]}", "nan", "\0", "1e999",
                 "{\"schema\": \"gapcheck/1\", \"findings\": 5}",
             "\ufeff{}", "[" + "{}," * 50_000 + "{}]", "\"" + "\\ud800" * 1000 + "\"", "{\"a\":" * 3000 + "1"
                 + "}" * 3000]
MESSAGES = ["", "kind\n", "kind nonsense\ncodes 1\n", "codes 1\n", "kind soft2-intersection\ncodes -1\n",
            "kind soft2-intersection\ncodes 99999999999999999999\n", "\0", "x" * 1_000_000,
                "kind soft2-intersection\n" * 10_000,
            "kind soft2-intersection\ntext " + "%s%n{}" * 100 + "\n", "# only a comment",
                "kind soft2-intersection\ncodes 1 - 5\n"]

# ---- Arguments. D: a deck that is good, L: a log, O: the folder to write into.

NUMBERS = ["", "-1", "nan", "inf", "1e400", "letters", "9223372036854775808", "0x10", "1,", "--", " 1"]
ARGUMENTS = [
    *(["gapcheck", "audit", "D", option, text] for option in ("--ptol", "--rtol", "--ratio", "--top", "--jobs",
        "--set-id",
                                                              "--contact", "--part") for text in NUMBERS),
    *(["gapcheck", "run", "D", "-o", "O", "--until", "1e-6", option, text] for option in ("--cycles",)
        for text in NUMBERS),
    *(["gapcheck", "run", "D", "-o", "O", "--cycles", "2", "--until", text] for text in NUMBERS),
    *(["gapcheck", "fix", "D", "-o", "O", option, text] for option in ("--lock", "--priority", "--top")
      for text in [*NUMBERS, "1=0", "1=1e9", "node:", "node:5-1", "5-", "-", "=", "1-9223372036854775807"]),
    *(["gapcheck", "audit", "D", "--as-if", text] for text in ("", "=", "SST", "SST=", "SST=nan", "SST=1e400",
        "NOTHING=1",
                                                               "OPTT=-1e308", "SST=1=2", "thickness=", "IGNORE=1e10")),
    *(["gapcheck", "explain", text] for text in ("", "GC", "GC1", "gc101", "GC99999999999", "../../etc/passwd",
        "\x1b[31m",
                                                 "x" * 10_000, "%s%n", "initial-penetration ")),
    *(["gapcheck", "audit", "D", "--select", text] for text in ("", "GC", "GC9", "none", ",", "GC101,,GC102", "*")),
    *(["gapcheck", "audit", text] for text in ("", ".", "/", "/dev/null", "/dev/zero", "/dev/stdin", "/proc/self/mem",
        "[", "**",
                                               "{", "\\", "***/**/*.k", "x" * 300, "x/" * 3000, "nothing*.k",
                                                   "\x1b[31m.k",
                                               "/proc/*", "--", "-")),
    *(["gapcheck", "messag", text] for text in ("", ".", "/", "/dev/null", "/dev/zero", "/dev/stdin", "D", "x" * 300,
                                                "/proc/self/mem", "nothing")),
    *(["gapcheck", "compare", *texts] for texts in (("D", "/"), ("/dev/null", "L"), ("L", ""), ("D", "nothing"), (".",
        "."),
                                                    ("/dev/zero", "D"), ("D", "D", "D"), ("D",))),
    *(["check-c", *texts] for texts in (("",), (".",), ("/dev/null",), ("/dev/zero",), ("D",), ("-top", "-1", "L"),
        ("-ptol", "nan", "L"),
                                        ("-sid", ",,", "L"), ("-sid", "9" * 30, "L"), ("-sel", "", "L"), ("-mnode",
                                            "0", "L"),
                                        ("-hsp", "/dev/zero", "L"), ("-g", "L", "L"), ("-g", "/dev/null", "-pid", "L"),
                                        ("--deck", "L", "-pid", "L"), ("--deck", "/", "-pid", "L"), ("--messages", "L",
                                            "L"),
                                        ("-typ",) * 50, ("x" * 5000,), ("-" + "x" * 5000,), ("L",) * 500)),
    *(["gapcheck", *texts] for texts in ((), ("",), ("nothing",), ("audit",), ("run", "D"), ("fix", "D"), ("audit",
        "--"),
                                         ("audit", "D", "--format", "pdf"), ("audit", "D", "--config", "/dev/zero"),
                                         ("audit", "D", "--config", "L"), ("audit", "D", "--baseline", "L"),
                                         ("audit", "D", "--baseline", "/dev/null"), ("audit", "D", "-I", "/dev/null"),
                                         ("audit", "D", "D"), ("audit", *("D",) * 500), ("audit", "D", "-I",
                                             *["/"] * 1000))),
]
