//! What can be wrong with the numbers of a material.

use scene::{Axes, Fault, Material, missing, positive};

use crate::couple::elastic;

/// Checks a linear elastic material at a dotted key: `E > 0` and `-1 < nu < 0.5`; of an orthotropic one all moduli and that its compliance is
/// positive definite.
///
/// # Errors
/// The fault of the number out of range, or of the one that is missing or too many.
pub fn sound_material(key: &str, material: Material) -> Result<(), Fault> {
    match (material.young, material.poisson) {
        (Axes::One(young), Axes::One(poisson)) => isotropic(key, young.0, poisson, &material),
        (Axes::Three(young), Axes::Three(poisson)) => orthotropic(key, young.map(|young| young.0), poisson, &material),
        (Axes::Three(_), Axes::One(_)) => {
            let message = "Young's modulus is given by three axes, and Poisson's ratio by one number";
            let remedy = "write poisson = [nu12, nu13, nu23], the contraction along the second axis under a pull along the first";
            Err(Fault::at(format!("{key}.poisson"), "wrong-value", message, remedy))
        }
        (Axes::One(_), Axes::Three(_)) => {
            let message = "Poisson's ratio is given by three axes, and Young's modulus by one number";
            Err(Fault::at(format!("{key}.young"), "wrong-value", message, "write young = [E1, E2, E3]"))
        }
    }
}

fn isotropic(key: &str, young: f64, nu: f64, material: &Material) -> Result<(), Fault> {
    positive(&format!("{key}.young"), young, "Young's modulus", " MPa")?;
    if !(nu > -1.0 && nu < 0.5) {
        let message = format!("Poisson's ratio {nu} is not between -1 and 0.5");
        let remedy = "give a ratio from 0 to 0.49999, as in poisson = 0.3";
        return Err(Fault::at(format!("{key}.poisson"), "wrong-value", message, remedy));
    }
    for (name, given) in [("shear", material.shear.is_some()), ("angle", material.angle.is_some())] {
        if given {
            let message = format!("an isotropic material has no `{name}`");
            let remedy = format!("remove {name}, or give young = [E1, E2, E3] and poisson = [nu12, nu13, nu23]");
            return Err(Fault::at(format!("{key}.{name}"), "wrong-key", message, remedy));
        }
    }
    Ok(())
}

fn orthotropic(key: &str, young: [f64; 3], poisson: [f64; 3], material: &Material) -> Result<(), Fault> {
    for (place, modulus) in young.into_iter().enumerate() {
        positive(&format!("{key}.young.{place}"), modulus, "Young's modulus", " MPa")?;
    }
    let Some(shear) = material.shear else {
        let why = "an orthotropic material has a shear modulus of its own";
        return Err(missing(&format!("{key}.shear"), why, "shear = \"0.5 GPa\""));
    };
    match shear {
        Axes::One(shear) => positive(&format!("{key}.shear"), shear.0, "shear modulus", " MPa")?,
        Axes::Three(shear) => shear
            .into_iter()
            .enumerate()
            .try_for_each(|(place, modulus)| positive(&format!("{key}.shear.{place}"), modulus.0, "shear modulus", " MPa"))?,
    }
    // Energy is positive under a pull along two axes: nu_ij^2 < E_i / E_j.
    for (place, (i, j)) in [(0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
        let (nu, most) = (poisson[place], (young[i] / young[j]).sqrt());
        if !(nu.is_finite() && nu.abs() < most) {
            let (first, second) = (i + 1, j + 1);
            let message = format!("nu{first}{second} = {nu} is not below sqrt(E{first}/E{second}) = {most:.6}");
            let remedy = format!(
                "nu{first}{second} is the contraction along axis {second} under a pull along axis {first}; the other way it is nu{first}{second} E{second}/E{first}"
            );
            return Err(Fault::at(format!("{key}.poisson.{place}"), "wrong-value", message, remedy));
        }
    }
    elastic(material).map(|_| ()).map_err(|_| {
        let message =
            "the three Poisson's ratios together make the material give energy away: its compliance is not positive definite";
        Fault::at(format!("{key}.poisson"), "wrong-value", message, "give smaller ratios")
    })
}
