"""The C++ interface of gapcheck as the package sees it. Attributes cannot be set."""
from os import PathLike
from typing import Any

from numpy import float64, int64, ndarray, uint64
from numpy.typing import NDArray

_Path = str | bytes | PathLike[str] | PathLike[bytes]

version: str
names: dict[str, tuple[str, ...]]

class Diagnostic:
    _fields: tuple[str, ...]
    severity: str
    file: str
    line: int
    message: str

class Totals:
    _fields: tuple[str, ...]
    errors: int
    warnings: int
    notes: int

class ModelCounts:
    _fields: tuple[str, ...]
    nodes: int
    shells: int
    solids: int
    beams: int
    thick_shells: int
    discrete: int
    masses: int
    particles: int
    parts: int
    contacts: int

class Contact:
    _fields: tuple[str, ...]
    id: int
    order: int
    title: str
    keyword: str
    type: str
    tracked_nodes: int
    segments: int
    penetrations: int
    max_penetration: float
    released: int
    edge_zone: int
    segment_penetrations: int
    mortar_penetrations: int
    edge_penetrations: int
    ties: int
    untied: int
    out_of_reach: int
    reported_penetrations: int
    judged_nearest: int
    not_checked: str
    file: str
    line: int

class Finding:
    _fields: tuple[str, ...]
    id: str
    rule: str
    severity: str
    message: str
    contact: int
    node: int
    part: int
    element: int
    element_part: int
    penetration: float
    contact_distance: float
    point: list[float] | None
    count: int
    file: str
    line: int

class SurfaceTimestep:
    _fields: tuple[str, ...]
    contact: int
    side: str
    type: str
    timestep: float
    node: int
    part: int

class Timesteps:
    _fields: tuple[str, ...]
    contact: float
    element: float
    surfaces: tuple[SurfaceTimestep, ...]

class SolverMessage:
    _fields: tuple[str, ...]
    severity: str
    code: int
    kind: str
    text: str
    count: int
    file: int
    line: int

class RigidwallPenetration:
    _fields: tuple[str, ...]
    node: int
    wall: int
    depth: float
    file: int
    line: int

class SolverRun:
    _fields: tuple[str, ...]
    version: str
    revision: str
    precision: str
    platform: str
    title: str
    mpp: bool
    ranks: int
    termination: str
    problem_time: float
    end_time: float
    cycles: int
    timesteps: Timesteps
    rigidwalls: tuple[RigidwallPenetration, ...]
    messages: tuple[SolverMessage, ...]
    counts_may_be_cut: bool

class PartHistory:
    _fields: tuple[str, ...]
    part: NDArray[int64]
    title: tuple[str, ...]
    times: NDArray[float64]
    internal: NDArray[float64]
    kinetic: NDArray[float64]
    hourglass: NDArray[float64]
    eroded_internal: NDArray[float64]
    eroded_hourglass: NDArray[float64]
    momentum: NDArray[float64]
    velocity: NDArray[float64]

class Report:
    _fields: tuple[str, ...]
    source: str
    input: str
    model: ModelCounts
    files: tuple[str, ...]
    contacts: tuple[Contact, ...]
    findings: tuple[Finding, ...]
    totals: Totals
    ignored: int
    predicted: Timesteps | None
    run: SolverRun | None
    parts: PartHistory | None
    complete: bool
    diagnostics: tuple[Diagnostic, ...]
    diagnostics_left_out: int

class Rule:
    _fields: tuple[str, ...]
    id: str
    name: str
    severity: str
    summary: str
    page: str
    of_runs: bool

class Curve:
    _fields: tuple[str, ...]
    name: str
    file: str
    quantity: str
    contact: int
    times: NDArray[float64]
    values: NDArray[float64]
    not_numbers: int

class Motion:
    _fields: tuple[str, ...]
    node: NDArray[int64]
    start: NDArray[float64]
    times: NDArray[float64]
    positions: NDArray[float64]
    velocities: NDArray[float64]

class Curves:
    _fields: tuple[str, ...]
    curves: tuple[Curve, ...]
    complete: bool
    diagnostics: tuple[Diagnostic, ...]

class ContactComparison:
    _fields: tuple[str, ...]
    id: int
    title: str
    type: str
    agree: int
    depth_differs: int
    only_first: int
    only_second: int
    largest_difference: float
    missing_in_first: bool
    missing_in_second: bool
    not_checked: bool
    counts_only: bool
    ties_compared: bool
    ties_agree: int
    ties_other_reason: int
    ties_only_first: int
    ties_only_second: int

class DepthDifference:
    _fields: tuple[str, ...]
    contact: int
    node: int
    first: float | None
    second: float | None

class TieDifference:
    _fields: tuple[str, ...]
    contact: int
    node: int
    first: str | None
    second: str | None

class CurveRating:
    _fields: tuple[str, ...]
    overall: float
    corridor: float
    phase: float
    magnitude: float
    slope: float

class CurvePair:
    _fields: tuple[str, ...]
    name: str
    verdict: str
    largest_first: float
    largest_second: float
    largest_difference: float
    time: float
    relative_difference: float
    l2_difference: float
    rating: CurveRating | None

class CurveComparison:
    _fields: tuple[str, ...]
    pairs: tuple[CurvePair, ...]
    only_first: tuple[str, ...]
    only_second: tuple[str, ...]
    agree: int
    differ: int
    without_common_times: int

class PartMotion:
    _fields: tuple[str, ...]
    part: int
    nodes: int
    largest_distance: float
    time: float
    node: int
    largest: NDArray[float64]
    mean: NDArray[float64]
    differs: bool

class MotionComparison:
    _fields: tuple[str, ...]
    times: NDArray[float64]
    largest_displacement: float
    parts: tuple[PartMotion, ...]
    differ: int

class Comparison:
    _fields: tuple[str, ...]
    equal: bool
    complete: bool
    first: Report
    second: Report
    contacts: tuple[ContactComparison, ...]
    differences: tuple[DepthDifference, ...]
    tie_differences: tuple[TieDifference, ...]
    curves: CurveComparison | None
    motion: MotionComparison | None
    def text(self, top: int) -> str: ...
    def json(self) -> str: ...

class FixState:
    _fields: tuple[str, ...]
    penetrations: int
    released: int
    deepest: float

class FixContact:
    _fields: tuple[str, ...]
    id: int
    keyword: str
    title: str
    not_checked: str
    before: FixState
    after: FixState
    by_segments: bool
    edges_before: int
    edges_after: int

class MovedNode:
    _fields: tuple[str, ...]
    node: int
    start: NDArray[float64]
    end: NDArray[float64]
    onto_tie: bool
    file: int
    line: int

class UnfixedNode:
    _fields: tuple[str, ...]
    contact: int
    node: int
    part: int
    element: int
    element_part: int
    depth: float
    contact_distance: float
    released: bool
    reason: str

class FixWall:
    _fields: tuple[str, ...]
    id: int
    title: str
    nodes_before: int
    nodes_after: int
    deepest_before: float
    deepest_after: float
    unfixed: tuple[UnfixedNode, ...]

class FixAlternative:
    _fields: tuple[str, ...]
    text: str
    card: str

class FixProposal:
    _fields: tuple[str, ...]
    contact: int
    part: int
    other_part: int
    penetrations: int
    deepest: float
    thickness: float
    alternatives: tuple[FixAlternative, ...]

class ChangedFile:
    _fields: tuple[str, ...]
    path: str
    place: str
    lines: int
    content: bytes

class Fix:
    _fields: tuple[str, ...]
    solved: bool
    files: tuple[str, ...]
    contacts: tuple[FixContact, ...]
    walls: tuple[FixWall, ...]
    moved: tuple[MovedNode, ...]
    unfixed: tuple[UnfixedNode, ...]
    proposals: tuple[FixProposal, ...]
    changed: tuple[ChangedFile, ...]
    largest_move: float
    total_move: float
    elements_touched: int
    elements_worsened: int
    cut_short: bool
    notes: tuple[str, ...]
    diagnostics: tuple[Diagnostic, ...]
    def text(self, top: int) -> str: ...
    def json(self) -> str: ...

class RunContact:
    _fields: tuple[str, ...]
    id: int
    touching: int
    released: int
    moved: int
    force_a: NDArray[float64]
    force_b: NDArray[float64]
    energy_a: float
    energy_b: float
    friction: float

class RunState:
    _fields: tuple[str, ...]
    time: float
    end_time: float
    step: float
    cycle: int
    kinetic: float
    internal: float
    hourglass: float
    sliding: float
    external: float
    total: float
    energy_ratio: float
    seconds: float
    contacts: tuple[RunContact, ...]

class RunEnergy:
    _fields: tuple[str, ...]
    name: str
    work: float
    state: float
    covered: bool

class RunSummary:
    _fields: tuple[str, ...]
    end: str
    failure: str
    state: RunState
    state_energy_ratio: float
    energies: tuple[RunEnergy, ...]
    files: tuple[str, ...]
    plotted_states: int
    diagnostics: tuple[Diagnostic, ...]

class StartContact:
    _fields: tuple[str, ...]
    id: int
    title: str
    keyword: str
    score: str
    not_known: str
    no_energy: str
    moved: int
    largest_move: float
    total_move: float
    histogram: NDArray[uint64]
    kept: int
    deepest_kept: float
    least_share: float | None
    forced: int
    deepest_forced: float
    energy: float
    released: int
    way_out: float
    to_release: float | None
    touched: int
    changed: int
    collapsed: int

class StartPair:
    _fields: tuple[str, ...]
    contact: int
    part: int
    other_part: int
    moved: int
    largest_move: float
    total_move: float
    histogram: NDArray[uint64]
    kept: int
    deepest_kept: float
    least_share: float | None
    forced: int
    deepest_forced: float
    energy: float
    released: int
    way_out: float
    to_release: float | None
    touched: int
    changed: int
    collapsed: int

class StartRepeat:
    _fields: tuple[str, ...]
    node: int
    contacts: list[int]
    path: float
    net: float
    back: bool

class StartShape:
    _fields: tuple[str, ...]
    edge_ratio: float
    warp: float
    size: float
    step: float

class StartElement:
    _fields: tuple[str, ...]
    kind: str
    id: int
    part: int
    contact: int
    before: StartShape
    after: StartShape
    inverted: bool
    flat: bool

class StartCrossing:
    _fields: tuple[str, ...]
    kind: str
    id: int
    part: int
    other_kind: str
    other_id: int
    other_part: int
    contact: int
    moved_by: int
    depth: float

class StartRefusal:
    _fields: tuple[str, ...]
    keyword: str
    file: str
    line: int
    why: str

class ExpectedContact:
    _fields: tuple[str, ...]
    contact: int
    part: int
    other_part: int
    nodes: int
    node: int
    time: float
    speed: float
    in_step: float | None
    crossing: int
    margin: float | None
    alone: float | None
    low: float | None
    high: float | None
    reason: str
    lost: bool
    held: bool
    never_released: bool

class ExpectedWall:
    _fields: tuple[str, ...]
    wall: int
    part: int
    nodes: int
    node: int
    time: float
    speed: float

class ExpectedContacts:
    _fields: tuple[str, ...]
    until: float
    end: float
    step: float
    contacts: tuple[ExpectedContact, ...]
    walls: tuple[ExpectedWall, ...]
    not_looked_at: tuple[str, ...]

class Start:
    _fields: tuple[str, ...]
    input: str
    clean: bool
    files: tuple[str, ...]
    contacts: tuple[StartContact, ...]
    pairs: tuple[StartPair, ...]
    moves: dict[str, ndarray]
    nodes: dict[str, ndarray]
    node: NDArray[int64]
    deck_points: NDArray[float64]
    points: NDArray[float64]
    repeats: tuple[StartRepeat, ...]
    elements: tuple[StartElement, ...]
    crossings: tuple[StartCrossing, ...]
    expected: ExpectedContacts | None
    moved: int
    largest_move: float
    energy: float
    touched: int
    changed: int
    collapsed: int
    kinetic: float | None
    first_step: float | None
    step_before: float
    step_after: float
    first_cycle: bool
    refused: tuple[StartRefusal, ...]
    notes: tuple[str, ...]
    diagnostics: tuple[Diagnostic, ...]
    def text(self, top: int) -> str: ...
    def json(self) -> str: ...
    def html(self) -> str | None: ...
    def vtu(self) -> str | None: ...

def rules() -> tuple[Rule, ...]: ...
def audit_deck(path: _Path, options: dict[str, Any]) -> Report: ...
def audit_text(deck: bytes, name: _Path, options: dict[str, Any]) -> Report: ...
def audit_arrays(points: NDArray[float64], shells: NDArray[int64], parts: NDArray[int64], mesh: dict[str, Any],
                 options: dict[str, Any]) -> Report: ...
def shell_deck(points: NDArray[float64], shells: NDArray[int64], parts: NDArray[int64], mesh: dict[str, Any]) -> str: ...
def penetration_columns(report: Report) -> dict[str, ndarray]: ...
def tie_columns(report: Report) -> dict[str, ndarray]: ...
def mesh_columns(report: Report) -> dict[str, ndarray | int] | None: ...
def write(report: Report, format: str, options: dict[str, Any]) -> bytes: ...
def read_run(paths: Any, options: dict[str, Any]) -> Report: ...
def read_motion(path: _Path, options: dict[str, Any]) -> Motion: ...
def read_curves(directory: _Path) -> Curves: ...
def compare(first: _Path, second: _Path, options: dict[str, Any]) -> Comparison: ...
def fix_deck(path: _Path, options: dict[str, Any]) -> Fix: ...
def run_deck(deck: _Path, directory: _Path, options: dict[str, Any]) -> RunSummary: ...
def start_deck(path: _Path, options: dict[str, Any]) -> Start: ...
