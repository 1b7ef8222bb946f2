//! What the macros name.

pub use std::marker::PhantomData;

pub use lagrangian::quantities::Reflect;
pub use lagrangian::{GeneralizedCoordinates, Problem};

pub use crate::ability::*;
pub use crate::class::{add, add_shared};
pub use crate::description::Description;
pub use crate::ensemble::{Ensemble, EnsembleMotions};
pub use crate::evaluator::{Evaluator, Of};
pub use crate::integrated::Integrated;
pub use crate::method::Method;
pub use crate::request::{Law, Request};

/// The description of a model, with the functions that create and integrate it.
#[doc(hidden)]
#[macro_export]
macro_rules! description {
    ($model:ty) => {{
        #[allow(unused_imports)] // Of each pair of traits, one is used.
        use $crate::emitted::*;

        type Model = $model;
        const N: usize = <Model>::COORDINATES.len();
        const U: usize = <Model as Reflect<N>>::INPUTS.len();
        const E: usize = <Model as Reflect<N>>::EVENTS.len();
        const C: usize = <Model as Reflect<N>>::CONSTRAINTS.len();
        const PROBE: Probe<Model, N, U, E, C> = Probe(PhantomData);

        fn integrate(model: &Model, request: &Request) -> Option<Integrated> {
            let problem = Problem::new(model, request.start().state::<N>());
            let (dop853, runge_kutta) = (request.settings.dop853(), request.settings.runge_kutta());
            match (&request.law, request.settings.method) {
                (Law::Held, Method::Taylor) => {
                    (&&PROBE).by_taylor((&&PROBE).watch(problem), request)
                }
                (Law::Held, Method::Dop853) => {
                    Some(request.solve((&&PROBE).watch(problem), dop853))
                }
                (Law::Held, Method::RungeKutta) => {
                    Some(request.solve((&&PROBE).watch(problem), runge_kutta))
                }
                (Law::Feedback(_), Method::Taylor) => None,
                (Law::Feedback(_), Method::Dop853) => {
                    let problem = (&&PROBE).feedback(problem, request)?;
                    Some(request.solve((&&PROBE).watch(problem), dop853))
                }
                (Law::Feedback(_), Method::RungeKutta) => {
                    let problem = (&&PROBE).feedback(problem, request)?;
                    Some(request.solve((&&PROBE).watch(problem), runge_kutta))
                }
                (Law::Sampled(..), Method::Taylor) => {
                    let problem = (&&PROBE).sampled_feedback(problem, request)?;
                    (&&PROBE).by_taylor((&&PROBE).watch(problem), request)
                }
                (Law::Sampled(..), Method::Dop853) => {
                    let problem = (&&PROBE).sampled_feedback(problem, request)?;
                    Some(request.solve((&&PROBE).watch(problem), dop853))
                }
                (Law::Sampled(..), Method::RungeKutta) => {
                    let problem = (&&PROBE).sampled_feedback(problem, request)?;
                    Some(request.solve((&&PROBE).watch(problem), runge_kutta))
                }
            }
        }

        fn ensemble(ensemble: &Ensemble) -> Option<Result<EnsembleMotions, String>> {
            let models: Vec<Model> = match ensemble.models() {
                Ok(models) => models,
                Err(message) => return Some(Err(message)),
            };
            let problem = |member: usize| {
                let problem = Problem::new(&models[member], ensemble.start::<N>(member));
                (&&PROBE)
                    .watch(problem)
                    .save(ensemble.samples.clone())
                    .each_step(|progress| ensemble.flow(progress))
            };
            match ensemble.settings.method {
                Method::Taylor => (&&PROBE).ensemble_by_taylor(problem, ensemble),
                Method::Dop853 => Some(ensemble.solve(problem, ensemble.settings.dop853())),
                Method::RungeKutta => {
                    Some(ensemble.solve(problem, ensemble.settings.runge_kutta()))
                }
            }
        }

        Description {
            name: <Model as Reflect<N>>::NAME,
            documentation: <Model as Reflect<N>>::DOCUMENTATION,
            fields: <Model as Reflect<N>>::FIELDS,
            outputs: <Model as Reflect<N>>::OUTPUTS,
            coordinates: &<Model as GeneralizedCoordinates<N>>::COORDINATES,
            inputs: <Model as Reflect<N>>::INPUTS,
            events: <Model as Reflect<N>>::EVENTS,
            constraints: <Model as Reflect<N>>::CONSTRAINTS,
            equations: <Model>::EQUATIONS,
            latex: <Model>::LATEX,
            has_taylor: (&&PROBE).has_taylor(),
            build: |numbers| {
                let abilities = Abilities {
                    energies: (&&PROBE).energies(),
                    event_functions: (&&PROBE).event_functions(),
                    state_matrix: (&&PROBE).state_matrix(),
                    input_matrix: (&&PROBE).input_matrix(),
                    assemble: (&&PROBE).assemble(),
                    integrate,
                    ensemble,
                };
                let model = <Model as Reflect<N>>::from_numbers(numbers)?;
                Ok(Box::new(Of { model, abilities }))
            },
        }
    }};
}
