"""Solids: the contact surface is the facet itself."""

import math

from .deck import Deck

UP, DOWN = [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]


def lower_block(deck):
    deck.part(1, "lower block", kind="solid")
    return deck.block(1, (2, 2, 1), 4.0, (0.0, 0.0, 0.0))


def solid_on_solid():
    deck = Deck("solid_on_solid", """The lower face of a block lies 0.1 inside another block, in a two-way contact.
        Solids have no contact thickness: the contact distance is 0 and the penetration is the depth in the volume.
        Nodes move along the normal of the face, out of the volume.""")
    lower_block(deck)
    deck.part(2, "upper block", kind="solid")
    upper = deck.block(2, (2, 2, 1), 3.0, (0.7, 1.1, 3.9))
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "upper on lower")
    for (_, _, k), node in upper.items():
        if k == 0:
            deck.expect(1, node, 0.0, 3.9 - 4.0, UP)
    deck.expect_others(crossed_elements=8)
    return deck


def solid_single_surface():
    deck = Deck("solid_single_surface", """solid_on_solid in a single-surface contact: the nodes of both blocks are
        judged on the coordinates of the deck. Nine nodes of the upper block, and the one node of the lower block that
        lies in the upper one.""")
    lower = lower_block(deck)
    deck.part(2, "upper block", kind="solid")
    upper = deck.block(2, (2, 2, 1), 3.0, (0.7, 1.1, 3.9))
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    for (_, _, k), node in upper.items():
        if k == 0:
            deck.expect(1, node, 0.0, 3.9 - 4.0, UP)
    deck.expect(1, lower[1, 1, 1], 0.0, 3.9 - 4.0, DOWN)
    deck.expect_others(crossed_elements=8)
    return deck


def solid_deep_released():
    deck = Deck("solid_deep_released", """A block 1 deep in another one, in a single-surface contact. A node is
        released where it is deeper than 0.5 t with t = 0.4 V/A: 0.8 in the lower block with elements of 4, 0.52 in
        the upper one with elements of 2.6.""")
    lower = lower_block(deck)
    deck.part(2, "upper block", kind="solid")
    upper = deck.block(2, (2, 2, 1), 2.6, (1.1, 1.3, 3.0))
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    for (_, _, k), node in upper.items():
        if k == 0:
            deck.expect_released(1, node, 0.0, 3.0 - 4.0)
    deck.expect_released(1, lower[1, 1, 1], 0.0, 3.0 - 4.0)
    deck.expect_others(crossed_elements=8)
    return deck


def plate_on_block(deck):
    lower_block(deck)
    deck.part(2, "plate")
    return deck.plate(2, (2, 2), 3.0, (0.7, 1.1, 4.3)).values()


def shell_on_solid():
    deck = Deck("shell_on_solid", """A plate 1 thick lies 0.3 above a block: contact distance 0.5 + 0, penetration
        0.2. The nodes of the plate go first; the nodes of the block then find a gap.""")
    plate = plate_on_block(deck)
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "plate on block")
    for node in plate:
        deck.expect(1, node, 0.5, 4.3 - 4.0, UP)
    return deck


def shell_on_solid_sldthk():
    deck = Deck("shell_on_solid_sldthk", """shell_on_solid with SLDTHK = 0.4: the facets of the block are coated with
        a shell of that thickness. Contact distance 0.5 + 0.2, penetration 0.4.""")
    plate = plate_on_block(deck)
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 1, 2, 1, "plate on block", card_b=(0.0, 0, 0, 0, 0, 0, 0.4))
    for node in plate:
        deck.expect(1, node, 0.5 + 0.2, 4.3 - 4.0, UP)
    deck.expect_others(thickness_too_thin=1)
    return deck


def solid_tapered():
    deck = Deck("solid_tapered", """A wedge-like brick, 4 high at one end and 1 at the other. Two nodes of a thin
        shell stand 0.3 above its slanted face where it is 1.75 high: outside, and clear of it. They are 2.05 above
        the lower face, less than that face's V/A = 2.5: a node counts as inside a solid only where it lies behind the
        nearest facet.""")
    deck.part(1, "wedge", kind="solid")
    deck.block(1, (1, 1, 1), 4.0, (0.0, 0.0, 0.0),
               lambda p: (p[0], p[1], p[2] / 4.0 * (4.0 - 0.75 * p[0])))
    deck.part(2, "fin", thickness=0.2)
    deck.fin(2, (3.0, 1.5, 2.05), (3.0, 2.5, 2.05), 1)
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 1, 2, 1, "fin on wedge")
    deck.expect_others(thickness_too_thin=1)
    return deck


def solid_row():
    deck = Deck("solid_row", """A row of flat bricks, 1 long and 4 wide and high, turned in space so that their side
        faces are coplanar but for the last digits. In single-surface contact no node of the row lies inside it,
        however the rounding falls.""")
    deck.part(1, "row", kind="solid")

    def turn(point):
        x, y, z = point
        x, y = math.cos(0.5) * x - math.sin(0.5) * y, math.sin(0.5) * x + math.cos(0.5) * y
        y, z = math.cos(0.7) * y - math.sin(0.7) * z, math.sin(0.7) * y + math.cos(0.7) * z
        return x, y, z

    deck.block(1, (8, 1, 1), (1.0, 4.0, 4.0), (0.3, 0.2, 0.1), turn)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    deck.expect_others(solid_early_release=1)
    return deck


DECKS = [solid_on_solid, solid_single_surface, solid_deep_released, shell_on_solid, shell_on_solid_sldthk,
         solid_tapered, solid_row]
