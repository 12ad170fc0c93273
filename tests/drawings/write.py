"""Drawings written with ezdxf (Python): pip install ezdxf==1.4.5; python write.py."""
import math
import ezdxf
from ezdxf import units


def drawing(version="R2010", unit=units.MM, measurement=1):
    doc = ezdxf.new(version)
    doc.units = unit
    doc.header["$MEASUREMENT"] = measurement
    for layer in ["PUNCH", "DIE", "HOLDER"]:
        doc.layers.add(layer)
    return doc, doc.modelspace()


def on(layer):
    return {"layer": layer}


def save(doc, name):
    doc.saveas(name)


# The quickstart's tools, a punch of 30 mm with a nose of 6 mm in a die of 31.25 mm, drawn 20 mm open.
def cup(space, scale=1.0, dx=0.0):
    def p(x, y):
        return ((x + dx) / scale, y / scale)

    # Random order, lines from either end, the arcs always counter-clockwise as ARC has it.
    space.add_line(p(30, 200), p(30, 26), on("PUNCH"))
    space.add_line(p(24, 20), p(0, 20), on("PUNCH"))
    space.add_arc(p(24, 26), 6 / scale, 270, 360, dxfattribs=on("PUNCH"))
    space.add_arc(p(37.25, -6.5), 6 / scale, 90, 180, dxfattribs=on("DIE"))
    space.add_line(p(31.25, -6.5), p(31.25, -120), on("DIE"))
    space.add_line(p(37.25, -0.5), p(90, -0.5), on("DIE"))
    space.add_line(p(32, 40), p(32, 10), on("HOLDER"))
    space.add_line(p(90, 10), p(32, 10), on("HOLDER"))


# 1: lines and arcs in any order and direction, with texts, dimensions and a centre line on layers of their own.
doc, space = drawing()
cup(space)
space.add_text("Stempel", dxfattribs={**on("PUNCH"), "height": 3}).set_placement((5, 30))
space.add_linear_dim(base=(0, 210), p1=(0, 200), p2=(30, 200), dxfattribs=on("Bemaßung")).render()
space.add_line((0, -150), (0, 250), on("Mittellinie"))
space.add_circle((60, -40), 4, on("Stiftbohrung"))
save(doc, "ezdxf_lines_and_arcs.dxf")

# 2: the same in inches.
doc, space = drawing("R2000", units.IN, 0)
cup(space, 25.4)
save(doc, "ezdxf_inches.dxf")

# 3: both halves of every tool, polylines with bulges; the die and holder are two lines each.
doc, space = drawing()
quarter = math.tan(math.pi / 8)
space.add_lwpolyline(
    [(-30, 80, 0), (-30, 6, quarter), (-24, 0, 0), (24, 0, quarter), (30, 6, 0), (30, 80, 0)],
    format="xyb", dxfattribs=on("PUNCH"))
for side in (1, -1):
    space.add_lwpolyline(
        [(side * 31.25, -90, 0), (side * 31.25, -7, -side * quarter), (side * 37.25, -1, 0), (side * 90, -1, 0)],
        format="xyb", dxfattribs=on("DIE"))
    space.add_lwpolyline([(side * 90, 0), (side * 32, 0), (side * 32, 30)], dxfattribs=on("HOLDER"))
save(doc, "ezdxf_both_halves.dxf")

# 4: a rational spline that is a quarter of a circle of 25 mm, and a free one that goes on from it.
doc, space = drawing("R2018")
w = math.sqrt(0.5)
spline = space.add_spline(dxfattribs=on("PUNCH"))
spline.set_open_rational([(0, 0, 0), (25, 0, 0), (25, 25, 0)], weights=[1, w, 1], degree=2)
spline = space.add_spline(dxfattribs=on("PUNCH"))
spline.set_open_uniform([(25, 25, 0), (25, 40, 0), (27, 50, 0), (27, 70, 0)], degree=3)
space.add_spline(dxfattribs=on("DIE")).set_open_uniform(
    [(80, -1, 0), (60, -1, 0), (40, -1, 0), (30, -6, 0), (29, -16, 0), (29, -60, 0)], degree=3)
save(doc, "ezdxf_splines.dxf")

# 5: R12 with old polylines, seen from behind (normal 0, 0, -1), as CAD programs leave after mirroring. R12 headers
# have no unit.
doc, space = drawing("R12", units.MM)
poly = space.add_polyline2d(
    [(0, 0, 0), (-24, 0, -quarter), (-30, 6, 0), (-30, 100, 0)], format="xyb", dxfattribs=on("PUNCH"))
poly.dxf.extrusion = (0, 0, -1)
arc = space.add_arc((-37.25, -7), 6, 0, 90, dxfattribs=on("DIE"))
arc.dxf.extrusion = (0, 0, -1)
space.add_line((31.25, -7), (31.25, -100), on("DIE"))
space.add_line((37.25, -1), (90, -1), on("DIE"))
save(doc, "ezdxf_r12_mirrored.dxf")

# 6: untidy. The wall is drawn twice and ends 0.004 mm beside the nose, the centre line is on the punch's layer, the die is
# drawn on the left only, and the axis is at x = 200.
doc, space = drawing()
space.add_line((200, 0), (224, 0), on("PUNCH"))
space.add_line((200, -50), (200, 150), on("PUNCH"))
space.add_arc((224, 6), 6, 270, 360, dxfattribs=on("PUNCH"))
space.add_line((230, 6.004), (230, 100), on("PUNCH"))
space.add_line((230, 100), (230, 6.004), on("PUNCH"))
space.add_lwpolyline([(110, -1, 0), (162.75, -1, -quarter), (168.75, -7, 0), (168.75, -100, 0)], format="xyb",
                     dxfattribs=on("DIE"))
save(doc, "ezdxf_untidy.dxf")

# 7: the same tools from blocks. The punch is half a block in half size, placed twice as large, and its mirror image; the die's
# corner is a block inside a block, turned by 90 degrees; the holder's face is two columns of one line, its wall lies in a block
# on a layer of its own.
doc, space = drawing()
block = doc.blocks.new("HALF", base_point=(5, 5))
block.add_lwpolyline([(5, 15, 0), (17, 15, quarter), (20, 18, 0), (20, 105, 0)], format="xyb")
for side in (1, -1):
    space.add_blockref("HALF", (0, 0), dxfattribs={**on("PUNCH"), "xscale": 2 * side, "yscale": 2})
doc.blocks.new("CORNER").add_arc((0, 0), 6, 0, 90)
block = doc.blocks.new("RING")
block.add_blockref("CORNER", (37.25, -6), dxfattribs={"rotation": 90})
block.add_line((31.25, -6), (31.25, -119.5))
block.add_line((37.25, 0), (90, 0))
space.add_blockref("RING", (0, -0.5), dxfattribs=on("DIE"))
doc.blocks.new("PIECE").add_line((0, 0), (29, 0))
space.add_blockref("PIECE", (32, 10), dxfattribs={**on("HOLDER"), "column_count": 2, "column_spacing": 29})
doc.blocks.new("Blechhalter").add_line((0, 0), (0, 30))
space.add_blockref("Blechhalter", (32, 10))
save(doc, "ezdxf_blocks.dxf")

# 8: outlines all round, layers in German: the punch with its left half, the die and the holder as rings.
doc, space = drawing()
space.add_lwpolyline(
    [(30, 200, 0), (-30, 200, 0), (-30, 26, quarter), (-24, 20, 0), (24, 20, quarter), (30, 26, 0)],
    format="xyb", close=True, dxfattribs=on("Stempel"))
space.add_lwpolyline(
    [(90, -120, 0), (90, -0.5, 0), (37.25, -0.5, quarter), (31.25, -6.5, 0), (31.25, -120, 0)],
    format="xyb", close=True, dxfattribs=on("Ziehring"))
for a, b in [((32, 40), (90, 40)), ((90, 10), (90, 40)), ((32, 10), (32, 40)), ((32, 10), (90, 10))]:
    space.add_line(a, b, on("Nieder-Halter"))
save(doc, "ezdxf_outlines.dxf")

# 9: two draws: the cup of 39 mm is drawn on to 30 mm through a die with a cone of 40 degrees.
doc, space = drawing()
space.add_lwpolyline([(0, 0, 0), (33, 0, quarter), (39, 6, 0), (39, 120, 0)], format="xyb", dxfattribs=on("OP20_PUNCH"))
space.add_lwpolyline([(90, -1, 0), (47, -1, quarter), (40.5, -7.5, 0), (40.5, -120, 0)], format="xyb", dxfattribs=on("OP20_DIE"))
space.add_lwpolyline([(90, 0), (47.5, 0), (47.5, 40)], dxfattribs=on("OP20_BINDER"))
space.add_lwpolyline([(0, 0, 0), (24, 0, quarter), (30, 6, 0), (30, 160, 0)], format="xyb", dxfattribs=on("OP30_PUNCH"))
cone = math.radians(40)
start = (31.5 + 6.8 * (1 - math.sin(cone)), 6.8 * math.cos(cone))
space.add_line((57.5, start[1] + (57.5 - start[0]) * math.tan(cone)), start, on("OP30_DIE"))
space.add_arc((38.3, 0), 6.8, 130, 180, dxfattribs=on("OP30_DIE"))
space.add_line((31.5, 0), (31.5, -160), on("OP30_DIE"))
end = (38.5 - 6 * (1 - math.sin(cone)), -6 * math.cos(cone))
round = (32.5 + math.sin(cone), end[1] + (end[0] - 32.5 - math.sin(cone)) * -math.tan(cone))
level = round[1] + math.cos(cone)
up = 15  # The sleeve is drawn open.
space.add_line((38.5, 160), (38.5, up), on("OP30_BINDER"))
space.add_arc((32.5, up), 6, 310, 360, dxfattribs=on("OP30_BINDER"))
space.add_line((end[0], end[1] + up), (round[0], round[1] + up), on("OP30_BINDER"))
space.add_arc((32.5, level + up), 1, 180, 310, dxfattribs=on("OP30_BINDER"))
space.add_line((31.5, level + up), (31.5, 160), on("OP30_BINDER"))
save(doc, "ezdxf_operations.dxf")

# Faulty ones.
def faulty(name, draw, unit=units.MM, measurement=1):
    doc, space = drawing("R2010", unit, measurement)
    draw(doc, space)
    save(doc, f"faulty/{name}.dxf")


def punch(space):
    space.add_lwpolyline([(0, 0, 0), (24, 0, quarter), (30, 6, 0), (30, 100, 0)], format="xyb", dxfattribs=on("PUNCH"))


def gap(doc, space):
    space.add_line((0, 0), (24, 0), on("PUNCH"))
    space.add_arc((24, 6), 6, 270, 360, dxfattribs=on("PUNCH"))
    space.add_line((30, 6.25), (30, 100), on("PUNCH"))


def overlap(doc, space):
    punch(space)
    space.add_line((30, 50), (30, 150), on("PUNCH"))


def branch(doc, space):
    punch(space)
    space.add_line((12, 0), (12, 40), on("PUNCH"))


def branch_at_end(doc, space):
    gap_free = [((0, 0), (30, 0)), ((30, 0), (30, 100)), ((30, 0), (70, 0))]
    for a, b in gap_free:
        space.add_line(a, b, on("PUNCH"))


def halves(doc, space):
    space.add_lwpolyline([(-30, 100), (-30, 6), (-24, 0), (24, 0), (30.5, 6), (30.5, 100)], dxfattribs=on("PUNCH"))


def unknown(doc, space):
    space.add_line((0, 0), (30, 0), on("Teil 1"))
    space.add_line((40, 0), (90, 0), on("Teil 2"))


def circle(doc, space):
    space.add_circle((0, 25), 25, on("PUNCH"))


def closed(doc, space):
    space.add_lwpolyline([(31, -1), (90, -1), (90, -50), (31, -50)], close=True, dxfattribs=on("DIE"))


def no_length(doc, space):
    punch(space)
    space.add_line((30, 100), (30, 100), on("PUNCH"))


def crosses(doc, space):
    space.add_lwpolyline([(0, 0), (30, 0), (30, 40), (15, 40), (15, -20)], dxfattribs=on("PUNCH"))


def no_side(doc, space):
    space.add_line((30, 0), (30, 100), on("PUNCH"))


def two_names(doc, space):
    space.add_line((0, 0), (30, 0), on("punch_and_die"))


def disagree(doc, space):
    punch(space)
    space.add_lwpolyline([(31, 40), (31, -1), (90, -1)], dxfattribs=on("DIE"))


def fit_points(doc, space):
    space.add_spline(fit_points=[(0, 0), (20, 2), (30, 20)], dxfattribs=on("PUNCH"))


def out_of_plane(doc, space):
    space.add_line((0, 0, 0), (30, 0, 12), on("PUNCH"))


def block(doc, space):
    space.add_blockref("ANOTHER FILE", (0, 0), dxfattribs=on("PUNCH"))


def block_in_itself(doc, space):
    block = doc.blocks.new("TOOL")
    block.add_line((0, 0), (30, 0))
    block.add_blockref("TOOL", (30, 0))
    space.add_blockref("TOOL", (0, 0), dxfattribs=on("PUNCH"))


def block_stretched(doc, space):
    doc.blocks.new("TOOL").add_lwpolyline([(0, 0, 0), (24, 0, quarter), (30, 6, 0), (30, 100, 0)], format="xyb")
    space.add_blockref("TOOL", (0, 0), dxfattribs={**on("PUNCH"), "xscale": 1.5})


def off_the_axis(doc, space):
    cup(space, dx=100)


def off_the_axis_with_a_centre_line(doc, space):
    doc.linetypes.add("CENTER", [2.0, 1.25, -0.25, 0.25, -0.25])
    cup(space, dx=-100)
    space.add_line((-100, -150), (-100, 250), {**on("Hilfslinien"), "linetype": "CENTER"})


def whole_off_the_axis(doc, space):
    space.add_lwpolyline(
        [(0, 80, 0), (0, 6, quarter), (6, 0, 0), (54, 0, quarter), (60, 6, 0), (60, 80, 0)],
        format="xyb", dxfattribs=on("PUNCH"))


def two_outlines(doc, space):
    punch(space)
    closed(doc, space)
    space.add_lwpolyline([(40, -60), (80, -60), (80, -90), (40, -90)], close=True, dxfattribs=on("DIE"))


def no_punch_in_an_operation(doc, space):
    space.add_lwpolyline([(0, 0), (30, 0), (30, 100)], dxfattribs=on("OP20_PUNCH"))
    for layer in ["OP20_DIE", "OP30_DIE"]:
        space.add_lwpolyline([(90, -1), (31, -1), (31, -50)], dxfattribs=on(layer))


def no_die_in_an_operation(doc, space):
    for layer in ["OP20_PUNCH", "OP30_PUNCH"]:
        space.add_lwpolyline([(0, 0), (30, 0), (30, 100)], dxfattribs=on(layer))
    for layer in ["OP20_DIE", "OP30_Zihering"]:
        space.add_lwpolyline([(90, -1), (31, -1), (31, -50)], dxfattribs=on(layer))


for name, draw in [
    ("gap", gap), ("overlap", overlap), ("branch", branch), ("branch_at_a_corner", branch_at_end),
    ("halves_differ", halves), ("unknown_layers", unknown), ("circle", circle), ("closed", closed),
    ("no_length", no_length), ("crosses_itself", crosses), ("sheet_on_no_side", no_side),
    ("two_tools_in_one_name", two_names), ("walls_disagree", disagree), ("fit_points_only", fit_points),
    ("out_of_plane", out_of_plane), ("block", block),
    ("block_in_itself", block_in_itself), ("block_stretched", block_stretched), ("off_the_axis", off_the_axis),
    ("off_the_axis_with_a_centre_line", off_the_axis_with_a_centre_line), ("whole_off_the_axis", whole_off_the_axis),
    ("two_outlines", two_outlines), ("no_punch_in_an_operation", no_punch_in_an_operation),
    ("no_die_in_an_operation", no_die_in_an_operation), ("empty", lambda doc, space: None),
]:
    faulty(name, draw)
faulty("no_units", lambda doc, space: punch(space), 0, 0)

# A cone in inches, as its maker draws it: wider at its top than the die, which it never gets to.
doc, space = drawing("R2000", units.IN, 0)
space.add_lwpolyline([(0, 0), (0.95, 0)], dxfattribs=on("PUNCH"))
slope = math.atan(0.36)
space.add_arc((0.95, 0.25), 0.25, 270, 360 - math.degrees(slope), dxfattribs=on("PUNCH"))
start = (0.95 + 0.25 * math.cos(slope), 0.25 - 0.25 * math.sin(slope))
space.add_line(start, (start[0] + (2.0 - start[1]) * math.tan(slope), 2.0), on("PUNCH"))
space.add_lwpolyline([(3.6, -0.04), (2.0, -0.04, math.tan(math.pi / 8)), (1.75, -0.29), (1.75, -3)], format="xyb", dxfattribs=on("DIE"))
space.add_line((1.85, 0), (3.6, 0), on("HOLDER"))
space.add_line((1.85, 0), (1.85, 1), on("HOLDER"))
save(doc, "ezdxf_cone_inches.dxf")
