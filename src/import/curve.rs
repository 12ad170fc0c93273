//! The entities that tools are drawn with, as the file's groups give them: in drawing units and degrees.

pub(super) type Place = [f64; 3];

#[derive(Clone, Debug)]
pub(super) enum Curve {
    Line([Place; 2]),
    Arc(Arc),
    /// LWPOLYLINE.
    Light(Polyline),
    /// POLYLINE, whose vertices are entities that follow it.
    Old(Polyline),
    Spline(Spline),
}

/// Circular arc, counter-clockwise as seen along its normal.
#[derive(Clone, Debug)]
pub(super) struct Arc {
    pub center: Place,
    pub radius: f64,
    /// Start and end \[degrees\].
    pub angles: [f64; 2],
    pub normal: Place,
}

#[derive(Clone, Debug)]
pub(super) struct Polyline {
    pub vertices: Vec<Vertex>,
    flags: f64,
    pub normal: Place,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Vertex {
    pub at: Place,
    /// Tangent of a quarter of the arc's angle to the next vertex, positive to the left; 0 for a line.
    pub bulge: f64,
    flags: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Spline {
    pub degree: f64,
    pub knots: Vec<f64>,
    /// Weights of the control points, or none.
    pub weights: Vec<f64>,
    pub control: Vec<Place>,
}

/// Target of a group's value.
pub(super) enum Group<'a> {
    Number(&'a mut f64),
    /// Coordinate of a point without x.
    NoPoint,
    Other,
}

pub(super) const UP: Place = [0.0, 0.0, 1.0];

impl Curve {
    pub fn new(kind: &str) -> Option<Self> {
        let polyline = || Polyline { vertices: Vec::new(), flags: 0.0, normal: UP };
        Some(match kind {
            "LINE" => Self::Line([[0.0; 3]; 2]),
            "ARC" => Self::Arc(Arc { center: [0.0; 3], radius: 0.0, angles: [0.0, 360.0], normal: UP }),
            "LWPOLYLINE" => Self::Light(polyline()),
            "POLYLINE" => Self::Old(polyline()),
            "SPLINE" => {
                Self::Spline(Spline { degree: 1.0, knots: Vec::new(), weights: Vec::new(), control: Vec::new() })
            }
            _ => return None,
        })
    }

    pub fn group(&mut self, code: i32) -> Group<'_> {
        // 10, 20, 30; 11, 21, 31; 210, 220, 230
        let axis = (code / 10 % 10 - 1).clamp(0, 2) as usize;
        match (self, code) {
            (Self::Line([from, _]), 10 | 20 | 30) => Group::Number(&mut from[axis]),
            (Self::Line([_, to]), 11 | 21 | 31) => Group::Number(&mut to[axis]),
            (Self::Arc(arc), 10 | 20 | 30) => Group::Number(&mut arc.center[axis]),
            (Self::Arc(arc), 40) => Group::Number(&mut arc.radius),
            (Self::Arc(arc), 50 | 51) => Group::Number(&mut arc.angles[usize::from(code == 51)]),
            (Self::Arc(Arc { normal, .. }), 210 | 220 | 230) => Group::Number(&mut normal[axis]),
            (Self::Light(line) | Self::Old(line), 210 | 220 | 230) => Group::Number(&mut line.normal[axis]),
            (Self::Light(line) | Self::Old(line), 70) => Group::Number(&mut line.flags),
            (Self::Light(line), 10) => Group::Number(&mut added(&mut line.vertices).at[0]),
            (Self::Light(line), 20 | 42) => match line.vertices.last_mut() {
                Some(vertex) => vertex.group(code),
                None => Group::NoPoint,
            },
            (Self::Spline(spline), 10) => Group::Number(&mut added(&mut spline.control)[0]),
            (Self::Spline(spline), 20 | 30) => {
                spline.control.last_mut().map_or(Group::NoPoint, |point| Group::Number(&mut point[axis]))
            }
            (Self::Spline(spline), 40) => Group::Number(added(&mut spline.knots)),
            (Self::Spline(spline), 41) => Group::Number(added(&mut spline.weights)),
            (Self::Spline(spline), 71) => Group::Number(&mut spline.degree),
            _ => Group::Other,
        }
    }
}

impl Polyline {
    pub fn is_closed(&self) -> bool {
        self.flags as i64 & 1 != 0
    }

    pub fn is_mesh(&self) -> bool {
        self.flags as i64 & (16 | 64) != 0
    }
}

impl Vertex {
    pub fn group(&mut self, code: i32) -> Group<'_> {
        match code {
            10 | 20 | 30 => Group::Number(&mut self.at[code as usize / 10 - 1]),
            42 => Group::Number(&mut self.bulge),
            70 => Group::Number(&mut self.flags),
            _ => Group::Other,
        }
    }

    pub fn is_off_the_curve(&self) -> bool {
        self.flags as i64 & 16 != 0
    }
}

fn added<T: Default>(list: &mut Vec<T>) -> &mut T {
    list.push(T::default());
    list.last_mut().expect("it was just added")
}
