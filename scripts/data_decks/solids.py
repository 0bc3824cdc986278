"""Solids: the contact surface is the facet itself."""

from .deck import Deck

UP, DOWN = [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]


def lower_block(deck):
    deck.part(1, "lower block", kind="solid")
    return deck.block(1, (2, 2, 1), 4.0, (0.0, 0.0, 0.0))


def solid_on_solid():
    deck = Deck("solid_on_solid", """The lower face of a block lies 0.1 inside another block, in a two-way contact. Solids have no contact
        thickness: the contact distance is 0 and the penetration is the depth in the volume. Nodes move along the normal
        of the face, out of the volume.""")
    lower_block(deck)
    deck.part(2, "upper block", kind="solid")
    upper = deck.block(2, (2, 2, 1), 3.0, (0.7, 1.1, 3.9))
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "upper on lower")
    for (_, _, k), node in upper.items():
        if k == 0:
            deck.expect(1, node, 0.0, 3.9 - 4.0, UP)
    return deck


def solid_single_surface():
    deck = Deck("solid_single_surface", """solid_on_solid in a single-surface contact: the nodes of both blocks are judged on the coordinates of the
        deck. Nine nodes of the upper block, and the one node of the lower block that lies in the upper one.""")
    lower = lower_block(deck)
    deck.part(2, "upper block", kind="solid")
    upper = deck.block(2, (2, 2, 1), 3.0, (0.7, 1.1, 3.9))
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    for (_, _, k), node in upper.items():
        if k == 0:
            deck.expect(1, node, 0.0, 3.9 - 4.0, UP)
    deck.expect(1, lower[1, 1, 1], 0.0, 3.9 - 4.0, DOWN)
    return deck


def solid_deep_released():
    deck = Deck("solid_deep_released", """A block 1 deep in another one, in a single-surface contact. A node is released where it is deeper than 0.5 t
        with t = 0.4 V/A: 0.8 in the lower block with elements of 4, 0.52 in the upper one with elements of 2.6.""")
    lower = lower_block(deck)
    deck.part(2, "upper block", kind="solid")
    upper = deck.block(2, (2, 2, 1), 2.6, (1.1, 1.3, 3.0))
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    for (_, _, k), node in upper.items():
        if k == 0:
            deck.expect_released(1, node, 0.0, 3.0 - 4.0)
    deck.expect_released(1, lower[1, 1, 1], 0.0, 3.0 - 4.0)
    return deck


def plate_on_block(deck):
    lower_block(deck)
    deck.part(2, "plate")
    return deck.plate(2, (2, 2), 3.0, (0.7, 1.1, 4.3)).values()


def shell_on_solid():
    deck = Deck("shell_on_solid", """A plate 1 thick lies 0.3 above a block: contact distance 0.5 + 0, penetration 0.2. The nodes of the plate go
        first; the nodes of the block then find a gap.""")
    plate = plate_on_block(deck)
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "plate on block")
    for node in plate:
        deck.expect(1, node, 0.5, 4.3 - 4.0, UP)
    return deck


def shell_on_solid_sldthk():
    deck = Deck("shell_on_solid_sldthk", """shell_on_solid with SLDTHK = 0.4: the facets of the block are coated with a shell of that thickness. Contact
        distance 0.5 + 0.2, penetration 0.4.""")
    plate = plate_on_block(deck)
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 1, 2, 1, "plate on block", card_b=(0.0, 0, 0, 0, 0, 0, 0.4))
    for node in plate:
        deck.expect(1, node, 0.5 + 0.2, 4.3 - 4.0, UP)
    return deck


DECKS = [solid_on_solid, solid_single_surface, solid_deep_released, shell_on_solid, shell_on_solid_sldthk]
