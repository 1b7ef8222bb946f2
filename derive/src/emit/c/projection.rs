//! The functions that project states onto the constraints, like `runtime/src/model/saddle_point.rs`.

use super::Export;

impl Export<'_> {
    /// The functions of a model with constraints.
    pub(super) fn projection(&self) -> String {
        let (n, c, k) = (
            self.emitter.coordinates(),
            self.emitter.constraint_count(),
            self.emitter.unknowns(),
        );
        let of_positions = if self.emitter.lowered.constraints.holonomic() > 0 {
            "    for (sweep = 0; sweep < 3; ++sweep) {\n        \
             $_constraint_positions_at(&projected, residuals);\n        \
             $_correct(&factors, residuals, q);\n    }\n"
        } else {
            ""
        };
        format!(
            "/* Adds the smallest change in the metric of M that takes residuals away to first order. */\n\
             static void $_correct(const $_factors *factors, const double *residuals, double *x)\n\
             {{\n    double change[{k}] = {{0.0}};\n    int i;\n    for (i = 0; i < {c}; ++i) {{\n        \
             change[{n} + i] = residuals[i];\n    }}\n    $_solve(factors, change);\n    for (i = 0; i < {n}; ++i) {{\n        \
             x[i] += change[i];\n    }}\n}}\n\n\
             /* Projects coordinates by Newton's method with the factors at the state, then velocities with the constraints at the\n   \
             projected coordinates (E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration, 2nd edition, 2006, IV.4). */\n\
             static void $_project_at(const $_point *at, double *q, double *v)\n\
             {{\n    $_point projected = *at;\n    $_factors factors;\n    double residuals[{c}];\n    int sweep;\n    \
             projected.q = q;\n    projected.v = v;\n    $_factor_at(&projected, NULL, &factors);\n{of_positions}    \
             for (sweep = 0; sweep < 3; ++sweep) {{\n        $_constraint_velocities_at(&projected, residuals);\n        \
             $_correct(&factors, residuals, v);\n    }}\n}}\n\n\
             /* Projects the end of a step. */\n\
             static void $_project_step(const $_point *at, double t, double *q, double *v)\n\
             {{\n    $_point end = *at;\n    double q_on[{n}], v_on[{n}];\n    int i;\n    end.t = t;\n    \
             for (i = 0; i < {n}; ++i) {{\n        q_on[i] = q[i];\n        v_on[i] = v[i];\n    }}\n    \
             $_project_at(&end, q_on, v_on);\n    \
             /* The change is added, as to a compensated sum. */\n    \
             for (i = 0; i < {n}; ++i) {{\n        q[i] += q_on[i] - q[i];\n        v[i] += v_on[i] - v[i];\n    }}\n}}\n"
        )
    }
}
