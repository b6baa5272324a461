//! Mean wear of body 2 along its closed tracks, from the pressure on them.

use std::f64::consts::TAU;

use crate::bracket::Bracket;
use crate::pressure_law::Node;
use crate::recession::Recession;
use crate::stage::Stage;

impl Stage<'_> {
    /// Solves W2' = (1/2pi) int w2'(p(W2')) d(angle) on every track for the present multipliers.
    pub(crate) fn settle_recession(&mut self, nodes: &mut Vec<Node>) {
        match self.law.recession.radii {
            None => {
                let turn = self.problem.surface.track_area().unwrap_or(f64::INFINITY);
                self.solve_track(
                    &mut |stage, nodes| {
                        stage.collect(nodes);
                        stage.worn_by_body2(nodes) / turn
                    },
                    nodes,
                    None,
                );
            }
            Some(radii) => {
                for (i, outer) in self.law.recession.tracks().into_iter().enumerate() {
                    self.solve_track(
                        &mut |stage, nodes| {
                            nodes.clear();
                            stage.collect_line(outer, nodes);
                            // Line nodes carry r^2 d(angle).
                            let r = radii[0] * outer.exp();
                            stage.worn_by_body2(nodes) / (TAU * r * r)
                        },
                        nodes,
                        Some(i),
                    );
                }
            }
        }
    }

    /// W2' on every track under a pressure that is already known.
    pub(crate) fn measured_recession(&mut self) -> Recession {
        let mut recession = Recession::none(&self.problem.surface);
        let mut nodes = Vec::new();
        match recession.radii {
            None => {
                self.collect(&mut nodes);
                recession.values[0] = self.worn_by_body2(&nodes) / self.problem.surface.track_area().unwrap_or(f64::INFINITY);
            }
            Some(radii) => {
                for (i, outer) in recession.tracks().into_iter().enumerate() {
                    nodes.clear();
                    self.collect_line(outer, &mut nodes);
                    let r = radii[0] * outer.exp();
                    recession.values[i] = self.worn_by_body2(&nodes) / (TAU * r * r);
                }
            }
        }
        recession
    }

    fn worn_by_body2(&self, nodes: &[Node]) -> f64 {
        let rule = &self.problem.wear.rules[1];
        nodes
            .iter()
            .map(|node| node.point.weight * rule.log_rate(self.law.log_pressure(node), node.point.sliding_speed).exp())
            .sum()
    }

    /// Root of W - mean(W), increasing in W: bracketed by 0 and the mean at W = 0, or where no pressure is left.
    fn solve_track(&mut self, mean: &mut dyn FnMut(&Self, &mut Vec<Node>) -> f64, nodes: &mut Vec<Node>, track: Option<usize>) {
        let mut defect = |stage: &mut Self, value: f64, nodes: &mut Vec<Node>| {
            match track {
                Some(_) => stage.law.recession.values.fill(value),
                None => stage.law.recession.values[0] = value,
            }
            value - mean(stage, nodes)
        };
        let saved = self.law.recession.values;
        let at_zero = defect(self, 0.0, nodes);
        // Body 2 recedes by less than the rigid motion closes: what it takes with it carries nothing.
        let most = nodes.iter().map(|node| node.f).fold(0.0, f64::max) * self.law.log_scale.exp();
        let mut root = Bracket { a: 0.0, value_a: at_zero, b: most.min(-at_zero), value_b: 0.0 };
        if at_zero < 0.0 {
            root.value_b = defect(self, root.b, nodes);
        }
        for _ in 0..100 {
            if root.value_b == 0.0 || (root.b - root.a).abs() <= 4.0 * f64::EPSILON * root.b.abs() {
                break;
            }
            let c = root.next();
            let value = defect(self, c, nodes);
            root.take(c, value);
            if value.abs() <= 1e-16 * c.abs() {
                break;
            }
        }
        self.law.recession.values = saved;
        self.law.recession.values[track.unwrap_or(0)] = root.b;
    }
}
