// Drawings written with @tarikjabiri/dxf 2.9.0, makerjs 0.19 and dxf-writer 1.18 (JavaScript):
// npm install @tarikjabiri/dxf makerjs dxf-writer; node write.mjs
import { writeFileSync } from "node:fs";
import tarik from "@tarikjabiri/dxf";
import makerjs from "makerjs";
import Writer from "dxf-writer";

const { DxfWriter, Units, point2d, point3d, Colors, SplineFlags } = tarik;
const quarter = Math.tan(Math.PI / 8);

// @tarikjabiri/dxf: light polylines with bulges and a spline, lines from right to left.
{
  const dxf = new DxfWriter();
  dxf.setUnits(Units.Millimeters);
  dxf.addLayer("upper punch", Colors.Red, "CONTINUOUS");
  dxf.addLayer("Die 1", Colors.Blue, "CONTINUOUS");
  dxf.addLWPolyline(
    [
      { point: point2d(30, 100) },
      { point: point2d(30, 6), bulge: -quarter },
      { point: point2d(24, 0) },
      { point: point2d(0, 0) },
    ],
    { layerName: "upper punch" },
  );
  dxf.addArc(point3d(37.25, -7, 0), 6, 90, 180, { layerName: "Die 1" });
  dxf.addLine(point3d(90, -1, 0), point3d(37.25, -1, 0), { layerName: "Die 1" });
  dxf.addLine(point3d(31.25, -100, 0), point3d(31.25, -7, 0), { layerName: "Die 1" });
  writeFileSync("tarikjabiri_bulges.dxf", dxf.stringify());
}
{
  const dxf = new DxfWriter();
  dxf.setUnits(Units.Centimeters);
  dxf.addLayer("PUNCH", Colors.Red, "CONTINUOUS");
  // A parabola of degree 2 on one span, y = x²/10 up to x = 2 cm.
  dxf.addSpline(
    { controlPoints: [point3d(0, 0), point3d(1, 0), point3d(2, 0.4)], degreeCurve: 2, flags: SplineFlags.Planar },
    { layerName: "PUNCH" },
  );
  dxf.addLine(point3d(2, 0.4, 0), point3d(2, 8, 0), { layerName: "PUNCH" });
  writeFileSync("tarikjabiri_spline_cm.dxf", dxf.stringify());
}

// makerjs: a model of lines and arcs, both halves of the punch as paths, exported in inches.
{
  const { paths } = makerjs;
  const model = {
    units: makerjs.unitType.Inch,
    paths: {
      faceRight: new paths.Line([0, 0], [1, 0]),
      noseRight: new paths.Arc([1, 0.25], 0.25, 270, 360),
      wallRight: new paths.Line([1.25, 4], [1.25, 0.25]),
      faceLeft: new paths.Line([-1, 0], [0, 0]),
      noseLeft: new paths.Arc([-1, 0.25], 0.25, 180, 270),
      wallLeft: new paths.Line([-1.25, 0.25], [-1.25, 4]),
    },
  };
  for (const path of Object.values(model.paths)) path.layer = "punch";
  const dieRight = { paths: { shoulder: new paths.Arc([1.55, -0.29], 0.25, 90, 180), face: new paths.Line([1.55, -0.04], [3.5, -0.04]), wall: new paths.Line([1.3, -0.29], [1.3, -4]) } };
  for (const path of Object.values(dieRight.paths)) path.layer = "die";
  model.models = { dieRight };
  writeFileSync("makerjs_inches_both_halves.dxf", makerjs.exporter.toDXF(model, { units: makerjs.unitType.Inch }));
}

// dxf-writer: old polylines with bulges (POLYLINE, VERTEX, SEQEND), a punch that moves up.
{
  const dxf = new Writer();
  dxf.setUnits("Millimeters");
  dxf.addLayer("PUNCH", Writer.ACI.RED, "CONTINUOUS");
  dxf.addLayer("DIE", Writer.ACI.BLUE, "CONTINUOUS");
  dxf.addLayer("HOLDER", Writer.ACI.GREEN, "CONTINUOUS");
  dxf.setActiveLayer("PUNCH");
  dxf.drawPolyline([[0, 0], [24, 0, -quarter], [30, -6], [30, -100]]);
  dxf.setActiveLayer("DIE");
  dxf.drawPolyline([[90, 1], [37.25, 1, -quarter], [31.25, 7], [31.25, 100]]);
  dxf.setActiveLayer("HOLDER");
  dxf.drawLine(32, 0, 90, 0);
  dxf.drawLine(32, -20, 32, 0);
  dxf.drawText(40, -10, 3, 0, "holder");
  writeFileSync("dxfwriter_polylines_punch_below.dxf", dxf.toDxfString());
}
