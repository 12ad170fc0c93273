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
    gap_free = [((0, 0), (30, 0)), ((30, 0), (30, 100)), ((30, 0), (60, 0))]
    for a, b in gap_free:
        space.add_line(a, b, on("PUNCH"))


def halves(doc, space):
    space.add_lwpolyline([(-30, 100), (-30, 6), (-24, 0), (24, 0), (30.5, 6), (30.5, 100)], dxfattribs=on("PUNCH"))


def unknown(doc, space):
    space.add_line((0, 0), (30, 0), on("Stempel"))
    space.add_line((40, 0), (90, 0), on("Matrize"))


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
    doc.blocks.new("TOOL").add_line((0, 0), (30, 0))
    space.add_blockref("TOOL", (0, 0), dxfattribs=on("PUNCH"))


for name, draw in [
    ("gap", gap), ("overlap", overlap), ("branch", branch), ("branch_at_a_corner", branch_at_end),
    ("halves_differ", halves), ("unknown_layers", unknown), ("circle", circle), ("closed", closed),
    ("no_length", no_length), ("crosses_itself", crosses), ("sheet_on_no_side", no_side),
    ("two_tools_in_one_name", two_names), ("walls_disagree", disagree), ("fit_points_only", fit_points),
    ("out_of_plane", out_of_plane), ("block", block), ("empty", lambda doc, space: None),
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
