//! What acts in a contact solve: load factors, motions of the rigid edge, friction.

use faer::Mat;

/// One motion (`t_x`, `t_z` or `theta`) of the shaped body's rigid edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Free, with a force (or a moment about the edge's reference point) that acts along it. Where neither pressure, stick nor a spring resists the
    /// motion, it stays at rest: a load along it has no balance unless the drag of sliding balances it; drag without such a load is taken by a guide.
    Free {
        /// Force or moment, positive along the motion.
        resultant: f64,
    },
    /// Prescribed: an approach or a tilt.
    Prescribed {
        /// Length or angle.
        value: f64,
    },
    /// On a linear spring.
    Sprung {
        /// Force per length or moment per angle.
        stiffness: f64,
        /// Position of the unloaded spring.
        rest: f64,
    },
}

impl Motion {
    /// Free without a resultant.
    pub const FREE: Motion = Motion::Free { resultant: 0.0 };

    pub(crate) fn is_finite(self) -> bool {
        match self {
            Motion::Free { resultant: value } | Motion::Prescribed { value } => value.is_finite(),
            Motion::Sprung { stiffness, rest } => stiffness.is_finite() && rest.is_finite(),
        }
    }
}

/// Friction law.
#[derive(Clone, Debug, PartialEq)]
pub enum Friction {
    /// No shear.
    None,
    /// Steady sliding in a known direction: shear `coefficient * drag * pressure` along the tangent on body 1.
    Sliding {
        /// Coefficient of friction, at least 0.
        coefficient: f64,
        /// For each point +1 where the counter-face moves along the point's tangent relative to body 1, -1 where it moves against it, 0
        /// where it does not slide.
        drag: Vec<f64>,
    },
    /// Stick and slip within one load step.
    Coulomb {
        /// Coefficient of friction, at least 0.
        coefficient: f64,
        /// [`ContactSolution::slip`](crate::ContactSolution::slip) at the end of the last step; zeros for bodies that never touched.
        slip_before: Vec<f64>,
    },
}

/// Which moment the moment of the rigid edge balances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MomentBalance {
    /// That of the whole contact traction.
    #[default]
    Traction,
    /// That of the pressure alone; the guide takes the moment of the shear.
    Pressure,
}

/// Everything that acts besides the gap.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactLoad {
    /// Load-case factors of the shaped body and of the counter-face.
    pub factors: [Vec<f64>; 2],
    /// Motions `t_x`, `t_z`, `theta` of the shaped body's rigid edge; ignored where the edge is not free or there is none.
    pub motions: [Motion; 3],
    /// Friction law.
    pub friction: Friction,
    /// Meaning of the moment on the rigid edge.
    pub moment: MomentBalance,
    /// Load-case factors of the shaped body and of the counter-face that follow the pressure, as those of its frictional heat do: for every load
    /// case (row) what a unit normal force at each contact point (column) adds to its factor, `cases x points`; none where nothing does.
    pub following: [Option<Mat<f64>>; 2],
}

impl ContactLoad {
    /// Load-case factors only: no friction, rigid edge free of forces.
    pub fn factors(shaped: &[f64], counter: &[f64]) -> ContactLoad {
        ContactLoad {
            factors: [shaped.to_vec(), counter.to_vec()],
            motions: [Motion::FREE; 3],
            friction: Friction::None,
            moment: MomentBalance::Traction,
            following: [None, None],
        }
    }

    /// Whether there is shear.
    pub fn has_friction(&self) -> bool {
        match &self.friction {
            Friction::None => false,
            Friction::Sliding { coefficient, .. } => *coefficient != 0.0,
            Friction::Coulomb { .. } => true,
        }
    }

    /// The same load with steady sliding.
    pub fn sliding(self, coefficient: f64, drag: Vec<f64>) -> ContactLoad {
        ContactLoad { friction: Friction::Sliding { coefficient, drag }, ..self }
    }
}
