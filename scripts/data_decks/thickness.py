"""Where the contact thickness comes from."""

from .deck import Deck
from .plates import DOWN, UP, expect_both, inside, stacked


def thickness_sst():
    deck = Deck("thickness_sst", """Plates 0.25 thick, 0.5 apart: no penetration with their own thickness (contact 1).
        SST = MST = 1 replaces it (contact 2): contact distance 1, penetration 0.5.""")
    upper = inside(deck, 0.5, thickness=0.25)
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "own thickness")
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 2, 2, 1, "SST and MST", card3=(1.0, 1.0, 1.0, 1.0))
    for node in upper:
        deck.expect(2, node, 1.0, 0.5, UP)
    deck.expect_others(thickness_override=2, thickness_too_thin=2, contact_timestep=4, overlapping_contacts=1)
    return deck


def thickness_sfst():
    deck = Deck("thickness_sfst", """Plates 0.5 thick, 0.7 apart: clear in contact 1. SFST = SFMT = 2 doubles the
        thickness in contact 2: contact distance 1, penetration 0.3.""")
    upper = inside(deck, 0.7, thickness=0.5)
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "unscaled")
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 2, 2, 1, "scaled", card3=(1.0, 1.0, 0.0, 0.0, 2.0, 2.0))
    for node in upper:
        deck.expect(2, node, 1.0, 0.7, UP)
    deck.expect_others(overlapping_contacts=1)
    return deck


def thickness_optt():
    deck = Deck("thickness_optt", """Plates 0.2 thick, 0.5 apart. OPTT = 1 of *PART_CONTACT replaces every other
        thickness of the lower one. Contact 1: 0.1 + 0.5 = 0.6, penetration 0.1. Contact 2 with SST = MST = 0.1: 0.05
        + 0.5, OPTT still wins: 0.05.""")
    deck.part(1, "lower plate", thickness=0.2, optt=1.0)
    deck.part(2, "upper plate", thickness=0.2)
    deck.plate(1, (3, 3), 5.0, (0.0, 0.0, 0.0))
    upper = deck.plate(2, (2, 2), 5.0, (1.5, 2.0, 0.5)).values()
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 1, 2, 1, "OPTT", card_c=(1, 1))
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 2, 2, 1, "OPTT over SST", card3=(1.0, 1.0, 0.1, 0.1), card_c=(1, 1))
    for contact, h in ((1, 0.1 + 0.5), (2, 0.05 + 0.5)):
        for node in upper:
            deck.expect(contact, node, h, 0.5, outcome="kept")
    deck.expect_others(thickness_override=2, thickness_too_thin=2, contact_timestep=4, overlapping_contacts=1)
    return deck


def thickness_th():
    deck = Deck("thickness_th", """Plates 0.25 thick, 0.5 apart. TH = 1 of *CONTROL_CONTACT is the thickness of both
        sides: penetration 0.5.""")
    upper = inside(deck, 0.5, thickness=0.25)
    deck.control_contact(th=1.0)
    deck.contact("AUTOMATIC_SURFACE_TO_SURFACE", 1, 2, 1, "TH")
    for node in upper:
        deck.expect(1, node, 1.0, 0.5, UP)
    deck.expect_others(thickness_override=1, contact_timestep=2)
    return deck


def ssthk(value, h):
    what = "the thickness is limited to 0.4 x 2 = 0.8" if value == 0 else "the full thickness counts"
    deck = Deck(f"thickness_ssthk_{value}", f"""Plates 1 thick with elements of 2, 0.7 apart, in single-surface contact
        with SSTHK = {value}: {what}, contact distance {h:g}.""")
    above, below = stacked(deck, 0.7, size=2.0, shift=(1.0, 1.0))
    deck.control_contact(ssthk=value)
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    expect_both(deck, 1, above, below, h, 0.7)
    if value == 0:
        deck.expect_others(thickness_limited=2)
    return deck


def thickness_ssthk_0():
    return ssthk(0, 0.8)


def thickness_ssthk_1():
    return ssthk(1, 1.0)


def thickness_shlthk_0():
    deck = Deck("thickness_shlthk_0", """An old two-way contact ignores shell thickness unless SHLTHK asks for it:
        plates 1 thick, 0.7 apart, and nothing is found.""")
    inside(deck, 0.7)
    deck.contact("SURFACE_TO_SURFACE", 1, 2, 1, "no thickness")
    deck.expect_others(thickness_ignored=1)
    return deck


def thickness_shlthk_1():
    deck = Deck("thickness_shlthk_1", """thickness_shlthk_0 with THKOPT = SHLTHK = 1 on optional card B: contact distance 1,
        penetration 0.3 along the normal of the lower plate.""")
    upper = inside(deck, 0.7)
    deck.contact("SURFACE_TO_SURFACE", 1, 2, 1, "with thickness", card_b=(0.0, 1, 1))
    for node in upper:
        deck.expect(1, node, 1.0, 0.7, UP)
    return deck


def element_thickness():
    deck = Deck("element_thickness", """The section says 0.2, *ELEMENT_SHELL_THICKNESS says 1.2 for the elements of
        the lower plate. Contact distance 0.6 + 0.1 to the upper plate, mid-surfaces 0.6 apart: penetration 0.1.""")
    above, below = stacked(deck, 0.6, thickness=0.2)
    for element, pid, _ in deck.shells:
        if pid == 1:
            deck.shell_thickness[element] = 1.2
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    for node in above:
        deck.expect(1, node, 0.6 + 0.1, 0.6, UP)
    for node in below:
        deck.expect(1, node, 0.6 + 0.1, 0.6, DOWN)
    deck.expect_others(thickness_too_thin=1, contact_timestep=1)
    return deck


def include_parameter():
    deck = Deck("include_parameter", """two_plates with the mesh in an include file and the thickness from
        *PARAMETER.""")
    above, below = stacked(deck, 0.7, thickness="&thick")
    deck.mesh_file = "include/plates_mesh.k"
    deck.controls.append("*PARAMETER\nRthick           1.0")
    deck.contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, title="all parts", a_type=5)
    expect_both(deck, 1, above, below, 1.0, 0.7)
    return deck


DECKS = [thickness_sst, thickness_sfst, thickness_optt, thickness_th, thickness_ssthk_0, thickness_ssthk_1,
         thickness_shlthk_0, thickness_shlthk_1, element_thickness, include_parameter]
