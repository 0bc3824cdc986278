"""Single segments and their surroundings: edges, corners, the band around a segment, warped quads, triangles, beams."""

import math

from .deck import Deck, unit

UP = [0.0, 0.0, 1.0]


def on_fins(deck, thickness=2.0):
    deck.part(2, "fins", thickness=thickness)
    deck.contact("AUTOMATIC_NODES_TO_SURFACE", 1, 2, 1, "fins on plate")


def free_edge_node():
    deck = Deck("free_edge_node", """Fins stand beside the free edges of a plate of elements of 4; all are 2 thick, so
        the contact distance is 2. The band around a segment is a quarter of its length: 1. Nodes 0.6 beyond the edge
        and 0.8 above it are in the band, 1 from the edge. Nodes 1.2 beyond and 0.5 above are 1.3 from the edge,
        nearer than 2, but outside the band: the solver does not list them at the start.""")
    deck.part(1, "plate", thickness=2.0)
    deck.plate(1, (2, 2), 4.0, (0.0, 0.0, 0.0))
    on_fins(deck)
    for node in deck.fin(2, (8.6, 1.0, 0.8), (8.6, 5.0, 0.8), 1):
        deck.expect(1, node, 2.0, 1.0, [0.6, 0.0, 0.8], feature="edge")
    for node in deck.fin(2, (-1.2, 1.0, 0.5), (-1.2, 5.0, 0.5), 2):
        deck.expect_edge_zone(1, node, 2.0, 1.3, "edge")
    return deck


def corner_node():
    deck = Deck("corner_node", """As free_edge_node, with nodes beyond a corner. (0.6, 0.2, 0.3) from it: in the band
        in both directions, at distance 0.7. (1.2, 0.4, 0.6) from it: outside the band in one direction, at distance
        1.4.""")
    deck.part(1, "plate", thickness=2.0)
    deck.plate(1, (2, 2), 4.0, (0.0, 0.0, 0.0))
    on_fins(deck)
    near, _ = deck.fin(2, (8.6, 8.2, 0.3), (14.0, 14.0, 0.3), 1)
    deck.expect(1, near, 2.0, 0.7, unit([0.6, 0.2, 0.3]), feature="corner")
    beyond, _ = deck.fin(2, (-1.2, -0.4, 0.6), (-6.0, -6.0, 0.6), 2)
    deck.expect_edge_zone(1, beyond, 2.0, 1.4, "corner")
    deck.expect_others(fine_reference=1)
    return deck


def warped_quad():
    deck = Deck("warped_quad", """One quad whose third corner is lifted by 1: the bilinear patch z = x y / 16. The
        nodes stand on its normals (-y/16, -x/16, 1) above (2, 2) and (1, 3), at half that vector: distance 0.5 sqrt(1
        + (x^2 + y^2)/256). Two flat triangles in place of the patch would give other depths.""")
    deck.part(1, "warped quad")
    quad = [deck.node(1001 + k, *point) for k, point in enumerate(((0, 0, 0), (4, 0, 0), (4, 4, 1), (0, 4, 0)))]
    deck.shell(1, quad)
    on_fins(deck, 1.0)
    feet = [(x - y / 32, y - x / 32, x * y / 16 + 0.5) for x, y in ((2.0, 2.0), (1.0, 3.0))]
    for node, (x, y) in zip(deck.fin(2, *feet, 1), ((2.0, 2.0), (1.0, 3.0))):
        distance = 0.5 * math.sqrt(1 + (x * x + y * y) / 256)
        deck.expect(1, node, 1.0, distance, unit([-y / 16, -x / 16, 1.0]))
    return deck


def triangle():
    deck = Deck("triangle", """One triangle with legs of 4; all shells are 2 thick. Over the face: 0.9. Beside an edge
        in the band: (0, -0.6, 0.8), distance 1. Beyond a corner in the band: (-0.3, -0.6, 0.2), distance 0.7. Beside
        an edge beyond the band: (0, -1.2, 0.5), distance 1.3.""")
    deck.part(1, "triangle", thickness=2.0)
    corners = [deck.node(1001 + k, *point) for k, point in enumerate(((0, 0, 0), (4, 0, 0), (0, 4, 0)))]
    deck.shell(1, corners + [corners[2]])
    on_fins(deck)
    face, edge = deck.fin(2, (1.0, 1.0, 0.9), (1.5, -0.6, 0.8), 1)
    deck.expect(1, face, 2.0, 0.9, UP)
    deck.expect(1, edge, 2.0, 1.0, [0.0, -0.6, 0.8], feature="edge")
    corner, beyond = deck.fin(2, (-0.3, -0.6, 0.2), (1.5, -1.2, 0.5), 2)
    deck.expect(1, corner, 2.0, 0.7, unit([-0.3, -0.6, 0.2]), feature="corner")
    deck.expect_edge_zone(1, beyond, 2.0, 1.3, "edge")
    return deck


def beam_on_shell():
    deck = Deck("beam_on_shell", """Beams of a tube with outer diameter 2 run 1.2 above a plate 1 thick, in a contact
        that treats beams too. Contact distance 1 + 0.5; the beam nodes penetrate by 0.3. The plate's nodes are 2.77
        from the beam axis.""")
    deck.part(1, "plate")
    deck.part(2, "beams", kind="beam", diameter=2.0)
    deck.plate(1, (3, 3), 5.0, (0.0, 0.0, 0.0))
    line = [deck.node(2001 + k, 7.5, y, 1.2) for k, y in enumerate((2.0, 7.0, 12.0))]
    orientation = deck.node(2010, 50.0, 7.0, 1.2)
    deck.beams += [(2001 + k, 2, (line[k], line[k + 1], orientation)) for k in (0, 1)]
    deck.contact("AUTOMATIC_GENERAL", 1, 0, title="all parts", a_type=5)
    for node in line:
        deck.expect(1, node, 1.5, 1.2, UP)
    return deck


DECKS = [free_edge_node, corner_node, warped_quad, triangle, beam_on_shell]
