//! What the cases of a chain share, and the buffers of the solver.

use std::sync::Arc;

use super::displacement::Displacement;
use super::mesh::Mesh;
use super::newton::Corrector;
use super::reference::ReferencePanel;
use super::refine::Refiner;
use super::timings::{Timings, timed};
use super::two_level::{Tables, TwoLevel};
use crate::continuation::Effort;
use crate::exact;
use crate::model::{DisplacementKernel, Parameters};

/// The displacement on the present mesh, with panels of the degree of the solution and of that of the estimate, and the
/// buffers of Newton's method on both.
pub struct Workspace {
    /// Panels of the solution.
    pub(super) coarse: Level,
    /// The same panels, of a higher degree, for the estimate.
    pub(super) fine: Level,
    two_level: TwoLevel,
    /// f, α and substrate of `kernel` and `half_width`; β does not count.
    substrate: Parameters,
    kernel: DisplacementKernel,
    half_width: f64,
}

/// One degree: displacement on the present mesh, and Newton's method with its buffers.
pub(super) struct Level {
    corrector: Corrector,
    displacement: Displacement,
    prepared: bool,
    timings: Timings,
}

impl Level {
    fn new(reference: &Arc<ReferencePanel>) -> Self {
        Self {
            corrector: Corrector::default(),
            displacement: Displacement::new(reference),
            prepared: false,
            timings: Timings::default(),
        }
    }

    /// Computes the displacement for a mesh, unless it is there already; tells whether it was not.
    fn prepare(&mut self, mesh: &Arc<Mesh>, kernel: &DisplacementKernel) -> bool {
        let discretisation = &self.displacement.discretisation;
        let degree = discretisation.reference.degree;
        if self.prepared && discretisation.mesh.film == mesh.film {
            return false;
        }
        let of_degree =
            if mesh.degree == degree { Arc::clone(mesh) } else { Arc::new(Mesh { degree, ..(**mesh).clone() }) };
        self.displacement.set_mesh(&of_degree, kernel, &mut self.timings);
        self.prepared = true;
        true
    }

    /// Forgets all but its memory.
    fn renew(&mut self) {
        self.corrector.renew();
        self.prepared = false;
        self.timings = Timings::default();
    }

    /// The same mesh, another substrate.
    fn change(&mut self, kernel: &DisplacementKernel) {
        if self.prepared {
            timed(&mut self.timings.filter, || self.displacement.set_substrate(kernel));
        }
    }

    /// Where the time went.
    fn timings(&self) -> Timings {
        self.timings.and(self.corrector.timings)
    }

    /// The corrector and the displacement that was prepared.
    pub fn parts(&mut self) -> (&mut Corrector, &Displacement) {
        (&mut self.corrector, &self.displacement)
    }

    /// The displacement that was prepared.
    pub fn displacement(&self) -> &Displacement {
        &self.displacement
    }
}

impl Workspace {
    /// An empty workspace for a chain that begins with a case.
    pub(super) fn new(
        [coarse, fine]: [&Arc<ReferencePanel>; 2],
        two_level: &Arc<Tables>,
        parameters: &Parameters,
    ) -> Self {
        let (substrate, kernel, half_width) = substrate_of(parameters);
        Self {
            coarse: Level::new(coarse),
            fine: Level::new(fine),
            two_level: TwoLevel::new(two_level),
            substrate,
            kernel,
            half_width,
        }
    }

    /// The same for the next chain: nothing is left of the last one but the memory, which is faster than new memory.
    pub(super) fn renewed(mut self, parameters: &Parameters) -> Self {
        self.coarse.renew();
        self.fine.renew();
        let (substrate, kernel, half_width) = substrate_of(parameters);
        Self { substrate, kernel, half_width, ..self }
    }

    /// Makes all that follows be about a case.
    pub(super) fn enter(&mut self, parameters: &Parameters) {
        let known = &self.substrate;
        if known.alpha == parameters.alpha && known.f == parameters.f && known.substrate == parameters.substrate {
            return;
        }
        (self.substrate, self.kernel, self.half_width) = substrate_of(parameters);
        self.coarse.change(&self.kernel);
        self.fine.change(&self.kernel);
    }

    /// Computes the displacement for a mesh, if it is not there.
    pub(super) fn prepare_coarse(&mut self, mesh: &Arc<Mesh>, effort: &mut Effort) {
        effort.meshes += u64::from(self.coarse.prepare(mesh, &self.kernel));
    }

    /// The same for the estimate.
    pub(super) fn prepare_fine(&mut self, mesh: &Arc<Mesh>, effort: &mut Effort) {
        effort.meshes += u64::from(self.fine.prepare(mesh, &self.kernel));
    }

    /// The displacement of the solution, that of the estimate, and what refines a solution on the mesh that was solved
    /// on last.
    pub(super) fn estimating(&mut self) -> (&Displacement, &Displacement, Refiner<'_>) {
        let Self { coarse, fine, two_level, .. } = self;
        let plain_factors = &mut coarse.corrector.factorisation;
        let refiner = Refiner { corrector: &mut fine.corrector, two_level, plain_factors };
        (&coarse.displacement, &fine.displacement, refiner)
    }

    /// Where the time went so far: for the solutions, and for their error estimates.
    pub fn timings(&self) -> [Timings; 2] {
        [self.coarse.timings(), self.fine.timings()]
    }

    /// Half the width of the dry contact of the case.
    pub(super) fn half_width(&self) -> f64 {
        self.half_width
    }
}

/// Half the width of the dry contact of a case.
pub fn half_width(parameters: &Parameters) -> f64 {
    exact::contact_bounds(parameters).2
}

/// What a workspace keeps of the substrate of a case.
fn substrate_of(parameters: &Parameters) -> (Parameters, DisplacementKernel, f64) {
    (parameters.clone(), DisplacementKernel::new(parameters), half_width(parameters))
}
