//! Random scenes and what must not change their answer: each is solved beside a twin, mirrored, scaled, in other units, ..
//!
//! `WEARSHAPE_CAMPAIGN_SCENES` and `WEARSHAPE_CAMPAIGN_SEED` choose others than the usual ones (`cargo xtask campaign`).

mod blocks;
mod case;
mod compare;
mod draw;
mod gmsh;
mod numbers;
mod tally;
mod text;
mod twin;
mod warm;

use draw::Random;
use tally::Tally;
use twin::Property;

/// A whole number of the environment.
fn asked(name: &str, usual: u64) -> u64 {
    let text = std::env::var(name).ok();
    text.map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{name} needs a whole number, not {text}")))
}

#[test]
fn random_scenes_have_the_answer_of_their_twins() {
    let (scenes, seed) = (asked("WEARSHAPE_CAMPAIGN_SCENES", 200), asked("WEARSHAPE_CAMPAIGN_SEED", 1));
    let mut tally = Tally::default();
    for number in 0..scenes {
        // A scene has a seed of its own, which tells its property too, so that it can be drawn again without those before it.
        let seed = seed.wrapping_add(number);
        let mut random = Random::new(seed);
        let property = Property::TURNS[(seed % Property::TURNS.len() as u64) as usize];
        let case = draw::case(&mut random, property);
        tally.add(property, seed, twin::tried(&case, property, &mut random));
    }
    println!("seed {seed}, {scenes} scenes\n\n{}", tally.table());
    let texts: Vec<&str> = tally.failures.iter().map(|(_, text)| text.as_str()).collect();
    assert!(texts.is_empty(), "{}", texts.join("\n"));
    assert!(tally.refused() * 4 <= scenes, "{} of {scenes} scenes are refused: too few are tried", tally.refused());
}
