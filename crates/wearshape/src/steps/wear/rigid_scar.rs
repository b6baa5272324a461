//! How far the scar of a ball or cylinder has grown after a time if the bodies are rigid: a first guess of the end of contact, never a result.

use hpfem::Kinematics;
use wear::{Counterface, WearPair};

use crate::problem::End;

/// Ratio of successive squares of the end of contact.
const GROWTH: f64 = 1.02;
/// Most of them: contacts that grow further are longer than any body.
const MOST: usize = 4000;

/// What wears.
pub(super) struct RigidScar<'a> {
    pub radius: f64,
    pub kinematics: Kinematics,
    /// Force (N).
    pub force: f64,
    /// Sliding speed (mm/s).
    pub speed: f64,
    pub laws: &'a WearPair,
    pub counterface: Counterface,
}

impl RigidScar<'_> {
    /// Half the width, or the radius, of the scar (mm) at the end of a run: worn to a flat that ends at `a`, a ball has lost `pi a^4 / 4R`, a cylinder
    /// `2 a^3 t / 3R`, each less that of the contact at the start.
    pub(super) fn at(&self, end: End, start: f64) -> f64 {
        let power = |power: i32, factor: f64, volume: f64| (start.powi(power) + volume / factor).powf(1.0 / f64::from(power));
        match (end, self.kinematics) {
            (End::Time(time), _) => self.after(time, start),
            (End::Depth(depth), _) => (start * start + 2.0 * self.radius * depth).sqrt(),
            (End::Volume(volume), Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness }) => {
                power(3, 2.0 * thickness / (3.0 * self.radius), volume)
            }
            (
                End::Volume(volume),
                Kinematics::Axisymmetric | Kinematics::Torsion | Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential,
            ) => power(4, std::f64::consts::PI / (4.0 * self.radius), volume),
        }
    }

    /// Half the width, or the radius, of the scar (mm) after a time (s), from that of the contact at the start. Worn to a flat that ends at `a`, a
    /// body of radius `R` has lost the depth `h = (a^2 - a_0^2)/2R` in its middle and wears by `dh/dt = w'(F/A)`, with `A = pi a^2` of a ball and
    /// `2 a t` of a cylinder.
    fn after(&self, time: f64, start: f64) -> f64 {
        let (mut square, mut passed) = (start * start, 0.0);
        for _ in 0..MOST {
            let next = GROWTH * square;
            let end = (0.5 * (square + next)).sqrt();
            let rate = self.rate(self.force / self.area(end));
            let taken = (next - square) / (2.0 * self.radius) / rate;
            if passed + taken >= time {
                return (square + (next - square) * (time - passed) / taken).sqrt();
            }
            passed += taken;
            square = next;
        }
        square.sqrt()
    }

    fn area(&self, end: f64) -> f64 {
        match self.kinematics {
            Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness } => 2.0 * end * thickness,
            Kinematics::Axisymmetric | Kinematics::Torsion | Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => {
                std::f64::consts::PI * end * end
            }
        }
    }

    fn rate(&self, pressure: f64) -> f64 {
        let bodies = if self.counterface == Counterface::Congruent { 0..2 } else { 0..1 };
        bodies.filter(|body| self.laws.wears(*body)).map(|body| self.laws.rules[body].rate(pressure, self.speed)).sum()
    }
}
