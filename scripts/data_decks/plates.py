"""Pairs of shell plates: the basic scenes, release, outcomes, order of contacts."""

import math

from .deck import Deck, SHOOT, card, unit

UP, DOWN = [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]


def stacked(deck, gap, thickness=1.0, cells=3, size=5.0, shift=(1.5, 2.0), first=1, z=0.0):
    """Two equal plates `gap` apart, the upper one shifted by less than an element. Returns the upper nodes above the
    lower plate and the lower nodes below the upper plate; all others project beyond the other plate's band."""
    deck.part(first, "lower plate", thickness=thickness)
    deck.part(first + 1, "upper plate", thickness=thickness)
    lower = deck.plate(first, (cells, cells), size, (0.0, 0.0, z))
    upper = deck.plate(first + 1, (cells, cells), size, (*shift, z + gap), flip=True)
    above = [n for (i, j), n in upper.items() if i < cells and j < cells]
    below = [n for (i, j), n in lower.items() if i > 0 and j > 0]
    return above, below


def inside(deck, gap, thickness=1.0, size=5.0):
    """A 2 x 2 plate `gap` above a 3 x 3 plate, every node of it above the larger one. Returns its nodes."""
    deck.part(1, "lower plate", thickness=thickness)
    deck.part(2, "upper plate", thickness=thickness)
    deck.plate(1, (3, 3), size, (0.0, 0.0, 0.0))
    return list(deck.plate(2, (2, 2), size, (0.3 * size, 0.4 * size, gap), flip=True).values())


def expect_both(deck, contact, above, below, h, gap, outcome="moved"):
    for node in above:
        deck.expect(contact, node, h, gap, UP, outcome)
    for node in below:
        deck.expect(contact, node, h, gap, DOWN, outcome)


def two_plates():
    deck = Deck("two_plates", """Two parallel plates, 1 thick, mid-surfaces 0.7 apart in one single-surface contact.
        The contact distance is 0.5 + 0.5, so every node over the other plate penetrates by 0.3. Both sides are judged
        on the coordinates of the deck and moved by 1.002 x 0.3.""")
    above, below = stacked(deck, 0.7)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    expect_both(deck, 1, above, below, 1.0, 0.7)
    return deck


def tilted(deck, start, slope, cells=4):
    """A plate at z = start + slope x over a flat one. Returns [(node, distance, direction)] of the nodes of both that
    project into the other plate."""
    size, shift = 5.0, (1.5, 2.0)
    deck.part(1, "flat plate")
    deck.part(2, "tilted plate")
    lower = deck.plate(1, (cells, cells), size, (0.0, 0.0, 0.0))
    upper = deck.plate(2, (cells, cells), size, (*shift, 0.0), height=lambda x, y: start + slope * x)
    cosine, near = 1.0 / math.sqrt(1.0 + slope * slope), []
    for (i, j), node in upper.items():
        z = deck.nodes[node][2]
        if i < cells and j < cells:
            near.append((node, abs(z), UP if z > 0 else DOWN))
    for (i, j), node in lower.items():
        height = start + slope * deck.nodes[node][0]
        if i > 0 and j > 0:
            # The normal of the tilted plate, towards the node.
            normal = unit([slope, 0.0, -1.0])
            near.append((node, abs(height) * cosine, normal if height > 0 else [-n for n in normal]))
    return near


def two_plates_tilted():
    deck = Deck("two_plates_tilted", """A plate that rises by 0.06 per unit of length over a flat one, both 1 thick.
        Nodes of the tilted plate: distance = their height. Nodes of the flat plate: distance to the tilted plane,
        height of that plane above them x cos(atan 0.06).""")
    for node, distance, direction in tilted(deck, 0.3, 0.06):
        if distance < 1.0:
            deck.expect(1, node, 1.0, distance, direction)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    return deck


def two_plates_crossing():
    deck = Deck("two_plates_crossing", """The mid-surfaces of two plates, 1 thick, cross. Nodes that penetrate by more
        than 0.4 x (1 + 1) are released: no contact until they have left both sides. The others are pushed out on the
        side of the mid-surface on which they lie, the wrong one for half of them.""")
    for node, distance, direction in tilted(deck, -0.65, 0.06):
        if 1.0 - distance > 0.8:
            deck.expect_released(1, node, 1.0, distance)
        elif distance < 1.0:
            deck.expect(1, node, 1.0, distance, direction)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    deck.expect_others(crossed_elements=7)
    return deck


def deep_node_released():
    deck = Deck("deep_node_released", """Two plates, 1 thick, only 0.15 apart: the penetration 0.85 exceeds 0.4 x (1 +
        1), so the nodes of both plates are released.""")
    above, below = stacked(deck, 0.15)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    for node in above + below:
        deck.expect_released(1, node, 1.0, 0.15)
    return deck


def t_joint():
    deck = Deck("t_joint", """A web stands on a flange and shares nodes with it; both are 4 thick with elements of 5.
        In single-surface contact the thickness is limited to 0.4 x 5 = 2, so no node is nearer than 2 to a segment
        that it does not belong to.""")
    deck.part(1, "flange", thickness=4.0)
    deck.part(2, "web", thickness=4.0)
    flange = deck.plate(1, (4, 4), 5.0, (0.0, 0.0, 0.0))
    rows = [[flange[2, j] for j in range(5)]]
    for level in (1, 2, 3):
        rows.append([deck.node(2000 + 10 * level + j, 10.0, 5.0 * j, 5.0 * level) for j in range(5)])
    for below, above in zip(rows, rows[1:]):
        for j in range(4):
            deck.shell(2, [below[j], below[j + 1], above[j + 1], above[j]])
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    deck.expect_others(thickness_limited=2)
    return deck


def clean():
    deck = Deck("clean", """Plates that touch and no more: thicknesses 0.6 and 1, mid-surfaces 0.8 apart. In binary
        the distance is 7.9999999999999982e-01, below the contact distance; the tolerance keeps such a node out.""")
    deck.part(1, "lower plate", thickness=0.6)
    deck.part(2, "upper plate", thickness=1.0)
    assert 1.9 - 1.1 < 0.3 + 0.5
    deck.plate(1, (3, 3), 5.0, (0.0, 0.0, 1.1))
    deck.plate(2, (3, 3), 5.0, (1.5, 2.0, 1.9))
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    return deck


def stray_part():
    deck = Deck("stray_part", """two_plates with a third part 150000 away in the same contact: it costs time in a
        naive search and must not change the findings.""")
    above, below = stacked(deck, 0.7)
    deck.part(3, "stray")
    deck.plate(3, (1, 1), 5.0, (150000.0, 0.0, 0.0))
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    expect_both(deck, 1, above, below, 1.0, 0.7)
    return deck


def outcome_deck(name, text, outcome, control_ignore=None, **contact):
    deck = Deck(name, text)
    above, below = stacked(deck, 0.7)
    if control_ignore is not None:
        deck.control_contact(ignore=control_ignore)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5, **contact)
    expect_both(deck, 1, above, below, 1.0, 0.7, outcome)
    return deck


def ignore_0():
    return outcome_deck("ignore_0", "IGNORE = 0, SNLOG = 0: penetrating nodes are moved to the contact surface.",
                        "moved", card_b=(0.0, 0, 0, 0), card_c=(1, 0))


def ignore_1():
    return outcome_deck("ignore_1", "IGNORE = 1 on optional card C: the penetration is kept and gives no force.",
                        "kept", card_c=(1, 1))


def ignore_2():
    return outcome_deck("ignore_2", "IGNORE = 2 in *CONTROL_CONTACT, nothing in the contact: kept, with warnings.",
                        "kept", control_ignore=2)


def ignore_mpp():
    return outcome_deck("ignore_mpp", "IGNORE = 1 on the MPP card.", "kept", mpp_ignore=1)


def snlog_1():
    return outcome_deck("snlog_1", "SNLOG = 1: no move; the full contact force acts at once.", "forced",
                        card_b=(0.0, 0, 0, 1))


def two_way_order():
    deck = Deck("two_way_order", """A two-way contact treats the nodes of SURFA first and moves them. The small upper
        plate lies over the larger one with all its nodes, so when the nodes of SURFB have their turn, the gap is
        1.0006 and nothing is found.""")
    upper = inside(deck, 0.7)
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "upper on lower")
    for node in upper:
        deck.expect(1, node, 1.0, 0.7, UP)
    return deck


def contact_chain():
    deck = Deck("contact_chain", """Contacts start one after the other, each on the coordinates that the earlier ones
        left. The middle plate is 0.8 above the lower one: contact 10 moves it up by 1.002 x 0.2. In the deck it is
        1.1 below the upper plate, clear of it; after the move 0.8996, so contact 20 finds it.""")
    for pid, title in ((1, "lower plate"), (2, "middle plate"), (3, "upper plate")):
        deck.part(pid, title)
    deck.plate(1, (3, 3), 5.0, (0.0, 0.0, 0.0))
    middle = deck.plate(2, (2, 2), 5.0, (1.5, 2.0, 0.8))
    deck.plate(3, (3, 3), 5.0, (0.5, 0.5, 1.9))
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 10, 2, 1, "middle on lower")
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 20, 2, 3, "middle on upper")
    for node in middle.values():
        deck.expect(10, node, 1.0, 0.8, UP)
    after = 0.8 + SHOOT * (1.0 - 0.8)
    for node in middle.values():
        deck.expect(20, node, 1.0, 1.9 - after, DOWN)
    return deck


def soft2_not_checked():
    deck = Deck("soft2_not_checked", """SOFT = 2: segment-based contact lists no nodes at the start, so
        initial-penetration does not apply although the plates are 0.3 too close.""")
    stacked(deck, 0.7)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5, soft=2)
    deck.not_checked.append(1)
    deck.expect_others(segment_penetration=18)
    return deck


def mortar_not_checked():
    deck = Deck("mortar_not_checked", """A mortar contact works segment on segment and lists no nodes at the start, so
        initial-penetration does not apply although the plates are 0.3 too close.""")
    stacked(deck, 0.7)
    deck.contact("AUTOMATIC_SINGLE_SURFACE_MORTAR", 1, 0, title="all parts", a_type=5)
    deck.not_checked.append(1)
    deck.expect_others(mortar_penetration=18)
    return deck


def three_plates(deck, gaps):
    """Three equal plates, each shifted against the one below. Returns for both gaps (nodes above, nodes below)."""
    grids = []
    for pid, title in ((1, "lower plate"), (2, "middle plate"), (3, "upper plate")):
        deck.part(pid, title)
        grids.append(deck.plate(pid, (3, 3), 5.0, (1.5 * (pid - 1), 2.0 * (pid - 1), round(sum(gaps[:pid - 1]), 9))))
    return [([n for (i, j), n in above.items() if i < 3 and j < 3],
             [n for (i, j), n in below.items() if i > 0 and j > 0]) for below, above in zip(grids, grids[1:])]


def tied_then_contact():
    deck = Deck("tied_then_contact", """The lower two plates touch and are tied with an offset; a tied contact gives
        no initial-penetration. The upper plate is 0.3 too close to the middle one: the single-surface contact finds
        it.""")
    _, (above, below) = three_plates(deck, (1.0, 0.7))
    deck.contact("TIED_SURFACE_TO_SURFACE_OFFSET", 1, 2, 1, "tie")
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 2, 0, title="all parts", a_type=5, card_c=(1, 1))
    expect_both(deck, 2, above, below, 1.0, 0.7, "kept")
    # Seven nodes project beyond the lower plate; the corner is too far from it to be meant.
    deck.expect_others(tie_offset=9, tie_by_part=1, untied_node=6)
    return deck


def excluded_interaction():
    deck = Deck("excluded_interaction", """Three plates 0.7 and 0.8 apart. The pair of the lower two is taken out with
        *CONTACT_EXCLUDE_INTERACTION; the pair of the upper two is found.""")
    _, (above, below) = three_plates(deck, (0.7, 0.8))
    deck.part_set(1, [1])
    deck.part_set(2, [2])
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5, card_c=(1, 1))
    deck.contacts.append("\n".join(["*CONTACT_EXCLUDE_INTERACTION", card(1, 1), card(1, 2, 2, 2)]))
    expect_both(deck, 1, above, below, 1.0, 1.5 - 0.7, "kept")
    return deck


DECKS = [two_plates, two_plates_tilted, two_plates_crossing, deep_node_released, t_joint, clean, stray_part, ignore_0,
         ignore_1, ignore_2, ignore_mpp, snlog_1, two_way_order, contact_chain, soft2_not_checked, mortar_not_checked,
         tied_then_contact, excluded_interaction]
