//! What the cases of a chain share, and the buffers of the solver.

use std::sync::Arc;

use super::discretisation::Discretisation;
use super::displacement::Displacement;
use super::mesh::Mesh;
use super::newton::Corrector;
use super::reference::ReferencePanel;
use crate::exact;
use crate::model::{DisplacementKernel, Parameters};

/// The displacement on the present mesh, with panels of the degree of the solution and of that of the estimate, and the
/// buffers of Newton's method on both.
pub struct Workspace {
    /// Panels of the solution.
    pub coarse: Level,
    /// The same panels, of a higher degree, for the estimate.
    pub fine: Level,
    /// f, α and substrate of `kernel` and `half_width`; β does not count.
    substrate: Parameters,
    kernel: DisplacementKernel,
    half_width: f64,
}

/// One degree: reference panel, displacement on the present mesh, buffers.
pub struct Level {
    /// Tables of the degree.
    pub reference: Arc<ReferencePanel>,
    /// Newton's method, with its buffers.
    pub corrector: Corrector,
    displacement: Option<Displacement>,
}

impl Level {
    fn new(reference: &Arc<ReferencePanel>) -> Self {
        Self { reference: Arc::clone(reference), corrector: Corrector::default(), displacement: None }
    }

    /// The displacement for a mesh: the one that is there if it is for these panels.
    fn prepare(&mut self, mesh: &Arc<Mesh>, kernel: &DisplacementKernel) {
        let present = self.displacement.take();
        let degree = self.reference.degree;
        self.displacement = Some(match present {
            Some(displacement) if displacement.discretisation.mesh.film == mesh.film => displacement,
            _ => {
                let mesh = if mesh.degree == degree {
                    Arc::clone(mesh)
                } else {
                    Arc::new(Mesh { degree, ..(**mesh).clone() })
                };
                Displacement::new(Arc::new(Discretisation::new(&self.reference, mesh)), kernel)
            }
        });
    }

    /// The same mesh, another substrate.
    fn change(&mut self, kernel: &DisplacementKernel) {
        if let Some(displacement) = self.displacement.take() {
            self.displacement = Some(Displacement::new(displacement.discretisation, kernel));
        }
    }

    /// The corrector and the displacement that was prepared.
    pub fn parts(&mut self) -> (&mut Corrector, &Displacement) {
        (&mut self.corrector, self.displacement.as_ref().expect("prepared before"))
    }

    /// The displacement that was prepared.
    pub fn displacement(&self) -> &Displacement {
        self.displacement.as_ref().expect("prepared before")
    }
}

impl Workspace {
    /// An empty workspace for a chain that begins with a case.
    pub fn new(coarse: &Arc<ReferencePanel>, fine: &Arc<ReferencePanel>, parameters: &Parameters) -> Self {
        Self {
            coarse: Level::new(coarse),
            fine: Level::new(fine),
            substrate: parameters.clone(),
            kernel: DisplacementKernel::new(parameters),
            half_width: half_width(parameters),
        }
    }

    /// Makes all that follows be about a case.
    pub fn enter(&mut self, parameters: &Parameters) {
        let known = &self.substrate;
        if known.alpha == parameters.alpha && known.f == parameters.f && known.substrate == parameters.substrate {
            return;
        }
        self.substrate = parameters.clone();
        self.kernel = DisplacementKernel::new(parameters);
        self.half_width = half_width(parameters);
        self.coarse.change(&self.kernel);
        self.fine.change(&self.kernel);
    }

    /// Computes the displacement for a mesh, if it is not there.
    pub fn prepare_coarse(&mut self, mesh: &Arc<Mesh>) {
        self.coarse.prepare(mesh, &self.kernel);
    }

    /// The same for the estimate.
    pub fn prepare_fine(&mut self, mesh: &Arc<Mesh>) {
        self.fine.prepare(mesh, &self.kernel);
    }

    /// Half the width of the dry contact of the case.
    pub fn half_width(&self) -> f64 {
        self.half_width
    }
}

/// Half the width of the dry contact of a case.
pub fn half_width(parameters: &Parameters) -> f64 {
    exact::contact_bounds(parameters).2
}
