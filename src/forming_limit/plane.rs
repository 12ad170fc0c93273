//! The yield condition in the plane of the sheet, in which it is isotropic: in-plane shear only turns principal directions.

use crate::material::flow::YieldCondition;
use crate::material::{Material, YieldCriterion};

/// The yield condition of a sheet, of in-plane strains.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane(YieldCriterion);

impl Plane {
    pub fn of(material: &Material) -> Self {
        Self(material.yield_criterion)
    }

    /// Equivalent strain increment of principal ones \[–\].
    pub fn equivalent_increment(&self, [e1, e2]: [f64; 2]) -> f64 {
        self.0.equivalent_increment([e1, e2, 0.0])
    }

    /// Principal stresses over the yield stress, of principal strain increments of any size \[–\].
    pub fn stress(&self, [e1, e2]: [f64; 2]) -> [f64; 2] {
        let [s1, s2, _] = self.0.stress([e1, e2, 0.0]);
        [s1, s2]
    }

    /// Equivalent strain increment \[–\], and the stresses σ_nn and σ_nt over the yield stress \[–\], of the increments Δε_nn,
    /// Δε_tt and Δγ_nt.
    pub fn turned(&self, nn: f64, tt: f64, shear: f64) -> (f64, [f64; 2]) {
        let (mean, half, slip) = (0.5 * (nn + tt), 0.5 * (nn - tt), 0.5 * shear);
        let radius = half.hypot(slip);
        let principal = [mean + radius, mean - radius];
        let [s1, s2] = self.stress(principal);
        // Where both strains are alike, so are the stresses, and no direction stands out.
        let (cos, sin) = if radius > 0.0 { (half / radius, slip / radius) } else { (1.0, 0.0) };
        let (middle, apart) = (0.5 * (s1 + s2), 0.5 * (s1 - s2));
        (self.equivalent_increment(principal), [middle + apart * cos, apart * sin])
    }

    /// r̄ \[–\].
    pub fn ratio(&self) -> f64 {
        self.0.ratio()
    }

    /// Whether limits of biaxial stretching come out too high: Hill 1948 with r̄ below 1 yields in equi-biaxial tension at
    /// √((1 + r̄)/2) of the yield stress, where aluminium is as strong or stronger, on a curve that is far too blunt.
    ///
    /// # References
    /// That aluminium is stronger: J. Woodthorpe, R. Pearce, The anomalous behaviour of aluminium sheet under balanced
    /// biaxial tension, Int. J. Mech. Sci. 12 (1970) 341–347. That the limit follows the bluntness of the curve: A. Graf,
    /// W. F. Hosford, Calculations of forming limit diagrams, Metall. Trans. A 21 (1990) 87–94; J. Lian, F. Barlat,
    /// B. Baudelet, Plastic behaviour and stretchability of sheet metals, Int. J. Plasticity 5 (1989) 131–147 (all not
    /// read).
    pub fn overrates_biaxial(&self) -> bool {
        matches!(self.0, YieldCriterion::Hill48(hill) if hill.ratio < 1.0)
    }
}
