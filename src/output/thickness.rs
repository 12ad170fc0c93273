//! Thickness over the blank, one curve per kept frame.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::{Subject, profile, shown, travel};

pub(super) fn plot(subject: &Subject) -> Chart {
    let table = profile::last(&subject.run.frames);
    let series = shown(&subject.run.frames)
        .enumerate()
        .map(|(i, frame)| {
            let points = profile::table(std::slice::from_ref(frame)).pairs("s0", "thickness");
            Series::new(travel(frame), points, Look::curve(i))
        })
        .collect();
    Chart {
        title: format!("{}: thickness", subject.model.title),
        legend: "Punch travel",
        panels: vec![Panel {
            x: table.column("s0").axis(),
            y: table.column("thickness").axis(),
            series,
            scale: Scale::Fit { height: 350.0 },
        }],
        notes: subject.notes_of_frames(),
    }
}
