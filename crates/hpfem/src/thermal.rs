//! Thermal strains of a temperature that was computed on the same mesh.

use crate::error::Error;
use crate::field::Field;
use crate::kinematics::Kinematics;
use crate::load_case::{Eigenstrain, StrainInModes};
use std::sync::Arc;

impl Eigenstrain {
    /// Thermal strain by the field of a potential on the same mesh, a temperature: `expansion` has one coefficient a material, 1/K, and at
    /// the temperature `reference` there is no strain.
    ///
    /// The degrees of the two problems may differ; cells are told by their index. A place whose material has no coefficient does not expand.
    ///
    /// # Errors
    /// [`Error::NoMeaning`] for a field that is no potential. A body of other cells refuses the load ([`Error::OtherMesh`]), and so does one whose heat is not
    /// conducted so: of revolution by the field of a plane problem, or the other way round ([`Error::NoMeaning`]).
    pub fn of_temperature(expansion: &[f64], temperature: Field, reference: f64) -> Result<Eigenstrain, Error> {
        let kinematics = temperature.kinematics();
        match kinematics {
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => {}
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } | Kinematics::Axisymmetric | Kinematics::Torsion => {
                return Err(Error::NoMeaning { what: "a temperature".to_string(), kinematics: kinematics.words() });
            }
        }
        let (of_mesh, temperature) = ((Arc::clone(temperature.mesh()), kinematics), Arc::new(temperature));
        let (own, of_material) = (Arc::clone(&temperature), expansion.to_vec());
        let in_modes: StrainInModes = Arc::new(move |cell, material, modes| {
            let expansion = of_material.get(material).copied().unwrap_or(0.0);
            let mut strains = own.coefficients(cell, modes)?;
            strains.iter_mut().for_each(|strain| *strain *= expansion);
            Some((strains, -expansion * reference))
        });
        let thermal = Eigenstrain::thermal(expansion, move |place| {
            let [xi, eta] = place.reference;
            // Every cell is there: the body that takes the load has as many.
            temperature.at(place.cell, xi, eta).map_or(f64::NAN, |state| state.displacement[0] - reference)
        });
        Ok(Eigenstrain { temperature: Some(of_mesh), in_modes: Some(in_modes), ..thermal })
    }
}
