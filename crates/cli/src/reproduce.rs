//! The figures and tables of Paczelt and Mroz 2007, recomputed: one item a figure, each a function from nothing to curves, pictures
//! and rows "the paper says, we get".
//!
//! Curves come from built-in scenes with `--set` pairs through the same `setup` and `solve` as every run, so that a reader can
//! repeat each of them; what they are compared with is in [`closed_form`], which shares nothing with the solver.

use scene::Fault;

mod annulus;
mod brakes;
mod closed_form;
mod conformal;
mod drum;
mod errata;
mod made;
mod near_singular;
mod page;
mod punch;
mod ring;
mod row;
mod run;
mod section;
mod stress;
mod wear_ratio;

pub(crate) use made::Made;
pub(crate) use page::page;
pub(crate) use row::{Row, rows_csv, rows_json, rows_table};

/// One figure or table.
pub(crate) struct Item {
    /// Its name on the command line.
    pub(crate) name: &'static str,
    /// What it shows, as the paper's number and words of our own.
    pub(crate) sentence: &'static str,
    /// Computes it.
    pub(crate) make: fn() -> Result<Made, Fault>,
}

macro_rules! items {
    ($($name:literal: $sentence:literal => $make:path),* $(,)?) => {
        &[$(Item { name: $name, sentence: $sentence, make: $make }),*]
    };
}

/// All items, in the order of the paper.
pub(crate) const ITEMS: &[Item] = items![
    "fig4": "Drum: pressure of the stationary wear volume over the angle, by q" => drum::pressure_of_wear_volume,
    "fig5": "Drum: wear rate of the stationary wear volume over the angle, by q" => drum::wear_rate_of_wear_volume,
    "fig6": "Drum: pressure of the stationary friction power over the angle, by q" => drum::pressure_of_friction_power,
    "fig7": "Drum: wear rate of the stationary wear power over the angle, by q" => drum::wear_rate_of_wear_power,
    "fig8": "Drum: gap for uniform pressure, by friction" => drum::gap_by_friction,
    "fig9": "Ring shoe: our mesh" => ring::mesh,
    "fig10": "Ring shoe: contact pressure before any wear" => ring::initial_pressure,
    "fig11": "Ring shoe: gap for uniform pressure, by friction and by support" => ring::gaps,
    "fig12": "Punch: our mesh" => punch::mesh,
    "fig13": "Punch: multipliers over the moment" => punch::multipliers,
    "fig14": "Punch: shapes by displacement factor, moments -5 and 5 kN mm" => punch::shapes_with_moment,
    "fig15": "Punch: shapes without moment, by displacement factor and by friction" => punch::shapes_without_moment,
    "fig16": "Punch: vertical stress before any wear" => stress::punch_before,
    "fig17": "Punch: vertical stress when worn in, moments 5, 0 and -5 kN mm" => stress::punch_after,
    "fig18": "Annular punch: geometry" => annulus::geometry,
    "fig19": "Annular punch: singular pressures near s = 1" => annulus::singular_pressures,
    "fig20": "Annular punch: pressures of the stationary wear volume and wear power, by b" => annulus::pressure_by_exponent,
    "fig21": "Annular punch: wear rates of the stationary wear volume and wear power, by b" => annulus::wear_rate_by_exponent,
    "table-wr": "Annular punch: ratio of the wear volume rates, by b (section 7.4)" => wear_ratio::table,
    "fig22": "Annular punch: pressure of the stationary wear power, q of 0.5 and more" => annulus::pressure_by_q,
    "fig23": "Annular punch: pressure of the stationary wear power, q below 0.5" => annulus::pressure_by_small_q,
    "fig24": "Annular punch: mesh and shape for q = 0.505" => near_singular::inner,
    "fig25": "Annular punch: mesh and shape for q = 0.495" => near_singular::outer,
    "fig26": "Annular punch: stresses for q = 1" => stress::ring,
    "fig27": "Annular punch: shape of uniform wear" => annulus::steady_shape,
    "brakes": "Textbook brakes: clutch, pinned and pivoted long shoe" => brakes::brakes,
    "conformal": "Shaft in a housing: arc of contact and largest pressure, after Persson" => conformal::conformal,
    "errata": "What of the paper does not hold: maxima, the drum's steady state, the force that is missed" => errata::errata,
];
