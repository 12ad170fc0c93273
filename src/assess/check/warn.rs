//! What should be known before a result is trusted.

use super::{mm, sharp};
use crate::model::{Edge, Model, Motion, Theory};
use crate::rules::design::{LIMITING_RATIO, THIN};
use crate::rules::estimate;

/// Elements per 90° below which the load ticks as nodes pass a corner.
const FINE: f64 = 8.0;
/// Friction above that of dry steel on steel, or a slip of the decimal point [–].
const DRY: f64 = 0.3;

/// Tensile strength above that of any cold-formed sheet, or a wrong unit \[MPa\].
const STRONGEST: f64 = 3000.0;

/// Tensile strength below that of any cold-formed sheet, or a wrong unit \[MPa\]. Hot sheet, whose stress comes from the
/// rate, may well have less.
const WEAKEST: f64 = 10.0;

/// Rounded sums of decimals may miss by this share [–].
const ROUNDED: f64 = 1e-6;

pub(super) fn all(model: &Model) -> Vec<String> {
    let mut warnings = Vec::new();
    let strength = estimate::tensile_strength(&model.material.hardening);
    if strength > STRONGEST {
        warnings
            .push(format!("a tensile strength of {strength:.0} MPa is that of no sheet metal: check the law's units"));
    }
    let weak = strength < WEAKEST && model.material.rate.is_none();
    if weak {
        warnings.push(format!(
            "a tensile strength of {} MPa, below {WEAKEST} MPa, is that of no sheet metal: check the unit of the law's \
             stresses",
            mm(strength)
        ));
    }
    if model.tools.iter().any(|tool| matches!(&tool.motion, Motion::Pressed(press) if press.is_idle())) {
        warnings.push(
            "the holder has no force and takes no part: the flange may swing up through where it is drawn".into(),
        );
    }
    if let Some(pressure) = estimate::holder_pressure(model).filter(|pressure| !weak && *pressure > strength) {
        warnings.push(format!(
            "the holder presses with {pressure:.0} MPa, more than the sheet's tensile strength of {strength:.0} MPa: check \
             its force"
        ));
    }
    let t = model.blank.thickness;
    for tool in &model.tools {
        let name = tool.role.name();
        let smallest = tool.profile.corners().min_by(|a, b| a.radius.total_cmp(&b.radius));
        if let Some(arc) = smallest.filter(|arc| arc.radius < THIN * t) {
            let what = match model.blank.theory {
                Theory::Bending | Theory::Selective => "beyond thin-shell theory",
                Theory::Membrane => "bending, which membrane theory leaves out, matters there",
            };
            warnings.push(format!(
                "the {name}'s radius of {} mm is {:.1} thicknesses (below {THIN}): {what}",
                mm(arc.radius),
                arc.radius / t
            ));
        }
        let friction = tool.friction.largest_coefficient();
        if friction > DRY && !tool.friction.needs_shear_yield() {
            warnings.push(format!("the {name}'s friction of {friction} is above that of dry steel, {DRY}"));
        }
    }
    warnings.extend(sharp::warnings(model));
    if let Some(gap) = estimate::clearance(model).filter(|gap| *gap < t * (1.0 - ROUNDED)) {
        warnings.push(format!(
            "at the full travel punch and die are {} mm apart, less than the thickness of {} mm: sheet that does not thin \
             to that is squeezed, which a shell does not feel as a solid does",
            mm(gap),
            mm(t)
        ));
    }
    if let Some(fit) = estimate::coarsest_corner(model).filter(|fit| fit.per_quarter < FINE) {
        let needed = (model.blank.elements as f64 * 10.0 / fit.per_quarter).ceil();
        warnings.push(format!(
            "{:.1} elements per 90° at the {}'s radius of {} mm (below {FINE}): the load will tick as nodes pass it; \
             about {needed:.0} elements give 10",
            fit.per_quarter,
            fit.role.name(),
            mm(fit.radius)
        ));
    }
    if let Some(ratio) = estimate::draw_ratio(model).filter(|ratio| *ratio > LIMITING_RATIO) {
        warnings.push(format!("the draw ratio of {ratio:.2} is above {LIMITING_RATIO}: one draw will hardly reach it"));
    }
    let free = model.blank.edge == Edge::Free;
    if let Some(share) = estimate::drawn_share(model).filter(|share| free && *share >= 1.0) {
        warnings.push(format!(
            "at the full travel the part needs {:.0} % of the blank's area: the blank will be drawn through the die",
            100.0 * share
        ));
    }
    if let Some(strain) = model.material.hardening.valid_up_to().filter(|strain| *strain < 0.5) {
        warnings.push(format!("the hardening table ends at a strain of {strain}; beyond it the law is extrapolated"));
    }
    warnings
}
