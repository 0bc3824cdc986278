"""What goes wrong outside the programs: the table of injected faults. check_faults.py makes a row of each combination,
injects the fault and holds what is left against docs/reliability.md.

Calls: G is gapcheck, C is check-c. p.k is a deck of two plates that penetrate, D is data/two_plates.k, messag a log.
"""

# ---- Standard output that is full, closed, or a pipe that nobody reads: every call that prints.
PRINTING = ["G --help", "G --version", "G audit --help", "G rules", "G rules --quiet", "G explain GC101", "G audit D",
            "G audit D --quiet", "G audit D --format json", "G audit D --format sarif", "G audit D --format junit",
            "G audit D --format csv", "G audit D --format gitlab", "G audit D --format github",
            "G audit D --output /dev/stdout", "G audit D p.k", "G messag messag", "G messag messag --format json",
            "G compare D messag", "G compare D messag --format json", "G fix D --dry-run",
                "G fix D --dry-run --format json",
            "G run D -o out --cycles 1", "G run D -o out --cycles 1 --quiet --stats", "C messag", "C -help",
                "C -version",
            "C -list messag", "C -key -top 1 messag", "C"]
ENDS_OF_OUTPUT = ["full", "closed", "pipe"]

# ---- A disk that is full after this share of what the call writes. F is the file that the call writes.
WRITING = ["G audit p.k --output F", "G audit p.k --format json --output F", "G audit p.k --format sarif --output F",
           "G audit p.k --format junit --output F", "G audit p.k --format csv --output F",
               "G audit p.k --format gitlab --output F",
           "G audit p.k --html F", "G audit p.k --key F", "G audit p.k --ani F", "G audit p.k --a4sel F",
               "G audit p.k --vtu F",
           "G audit p.k --sets F", "G audit p.k --medina F", "G audit p.k --write-baseline F",
               "G messag messag --html F",
           "G messag messag --format json --output F", "G messag messag --key F", "G compare p.k messag --output F",
           "G compare p.k messag --format json --output F", "G fix p.k --dry-run --output F", "G fix p.k -o fixed",
           "G run p.k -o out --cycles 3", "G run p.k -o out --cycles 3 --vtu", "C -key messag", "C -a4sel messag",
           "C -medina messag"]
WRITTEN = {"-o fixed": ["fixed/p.k"], "C -key": ["check-c.key"], "C -a4sel": ["check-c.ses"],
    "C -medina": ["check-c.prt"]}
SHARES = [0.0, 0.4, 0.9]

# ---- Signals at this many moments, from the start to the end of the call and around its writing.
MOMENTS = 20
SIGNALS = ["SIGTERM", "SIGINT", "SIGHUP"]
INTERRUPTED = {
    "audit": ["audit", "p.k", "--html", "page", "--vtu", "grid", "--sets", "sets", "--key", "key", "--write-baseline",
        "known",
              "--format", "csv", "--output", "table", "--quiet"],
    "fix": ["fix", "p.k", "-o", "fixed", "--quiet", "--output", "report"],
    "run": ["run", "small.k", "-o", "out", "--quiet"],
}

# ---- Memory (RLIMIT_AS) in MB, and open files (RLIMIT_NOFILE).
LIMITED = ["G audit p.k --quiet --jobs 1", "G audit p.k --jobs 4 --format json --html F --vtu F2",
    "G fix p.k -o fixed --jobs 2",
           "G run p.k -o out --cycles 2 --jobs 2", "G compare p.k messag --jobs 2", "G messag messag --format json",
               "C -key messag"]
MEMORY = [20, 22, 24, 28, 32, 40, 48, 64, 96]  # with 18 gapcheck is not even loaded
DESCRIPTORS = list(range(3, 13))

# ---- Inputs that are not what they should be. WHAT: the name that the call reads.
INPUTS = {"deck": ("G audit WHAT", "x.k"), "include": ("G audit main.k", "x.k"), "deck to fix": ("G fix WHAT -o fixed",
    "x.k"),
          "deck to run": ("G run WHAT -o out --cycles 1", "x.k"), "log": ("G messag WHAT", "x"),
              "log of check-c": ("C WHAT", "x"),
          "compared": ("G compare D WHAT", "x.k"), "d3hsp": ("G messag messag --d3hsp WHAT", "x"),
          "d3plot": ("G messag messag -g WHAT", "x"), "settings": ("G audit D --config WHAT", "x.toml"),
          "baseline": ("G audit D --baseline WHAT", "x"), "table of messages": ("G messag messag --messages WHAT", "x"),
          "mesh of check-c": ("C --deck WHAT -pid messag", "x.k"), "d3hsp of check-c": ("C -hsp WHAT messag", "x")}
INSTEAD = ["missing", "folder", "pipe", "socket", "link to itself", "link to nothing", "device",
    "file without permission",
           "below a file", "name too long"]

# ---- Outputs that cannot be written. F: the name.
OUTPUTS = ["G audit p.k --output F", "G audit p.k --html F", "G audit p.k --key F", "G audit p.k --vtu F",
    "G audit p.k --sets F",
           "G audit p.k --write-baseline F", "G audit p.k --medina F", "G messag messag --ani F",
               "G compare p.k messag --output F",
           "G fix p.k -o F", "G run p.k -o F --cycles 1", "G run p.k -o F --cycles 1 --vtu"]
PLACES = ["a folder", "below a file", "in a missing folder", "link to itself", "/dev/full", "name too long",
    "empty name",
          "folder without permission"]
# Commands that make the folder themselves, or take it.
FOLDERS = {"a folder", "in a missing folder"}

# ---- Inputs that change while they are read, at this many moments each.
CHANGES = ["grows", "shrinks", "is replaced", "is removed", "becomes a folder"]
READING = {"audit": ("G audit p.k --format json", "p.k"), "fix": ("G fix p.k -o fixed", "p.k"),
           "fix --dry-run": ("G fix p.k --dry-run", "p.k"), "compare": ("G compare p.k messag", "p.k"),
           "messag": ("G messag long --format json", "long"), "check-c": ("C -list long", "long")}
CHANGE_MOMENTS = 6

# ---- The folder for results is moved or removed, at this many moments each.
VANISH = ["moved", "removed"]
VANISHING = {"run": "G run small.k -o out --cycles 3000 --quiet", "fix": "G fix p.k -o fixed",
    "audit": "G audit p.k --html out/page"}
VANISH_MOMENTS = 6

# ---- No more processes or threads may start; for another user than root, whom no limit binds.
THREADLESS = ["G audit p.k --quiet", "G audit D --format json", "G fix D --dry-run",
    "G run p.k -o /dev/null/x --cycles 1",
              "G compare p.k D", "G messag messag", "C messag"]

# ---- Moments are by lot. So many rows with these beginnings must have been met by their fault: a signal, or exit code 2.
LEAST = {"signals: audit": 20, "signals: fix": 20, "signals: run": 20, "inputs that change: fix,": 4,
         "inputs that change: fix --dry-run": 4, "folders that vanish: run": 4}
