//! Messages for functions that the declaration language does not have, or not by the name that was written.

use super::builtins::{functions, of_scalars};
use crate::diagnostics::similar;
use crate::syntax::other_notation::NO_CASES;

/// For an unknown function.
pub(crate) fn unknown_function(name: &str) -> String {
    if name == "dot" {
        return "the time derivative is written as a function: `dot(x)`".to_owned();
    }
    // `Heaviside`, `unit_step` and `unitStep` are written in other languages.
    let plain = name.to_lowercase().replace('_', "");
    let same = functions().find(|function| function.replace('_', "") == plain);
    let hint = if let Some(hint) = of_numbers(&plain).or_else(|| of_vectors(&plain)) {
        hint.to_owned()
    } else if let Some(meant) = same {
        format!("did you mean `{meant}`?")
    } else if let Some(axis) = rotation_about(&plain) {
        format!("write `rotation_{axis}(a)`")
    } else if let Some(meant) = similar(name, functions()) {
        format!("did you mean `{meant}`?")
    } else {
        format!(
            "write one of `{}`, or one of vectors and matrices such as `cross`, `norm` and `rotation_zxz`, or declare it, \
             `function({name}(x) = …)`",
            of_scalars().collect::<Vec<_>>().join("`, `")
        )
    };
    format!("unknown function `{name}`: {hint}")
}

/// The axis of `rotx` and its like.
fn rotation_about(plain: &str) -> Option<char> {
    let axis = plain.chars().last()?;
    let stem = plain.strip_suffix(['x', 'y', 'z'])?;
    let stems = ["r", "rot", "rotate", "rotmat", "rotationmatrix"];
    stems.contains(&stem).then_some(axis)
}

/// What to write for a function of numbers, or of time, whose name in small letters is that of another language.
fn of_numbers(plain: &str) -> Option<&'static str> {
    of_powers(plain)
        .or_else(|| of_angles(plain))
        .or_else(|| of_pieces(plain))
        .or_else(|| of_time(plain))
}

/// Powers, exponentials and logarithms.
fn of_powers(plain: &str) -> Option<&'static str> {
    let hint = match plain {
        "pow" | "power" => "write `x.powi(2)` or `x.powf(1.5)`",
        "sqr" | "sq" | "square" | "squared" | "pow2" | "abs2" => "write `x.powi(2)`",
        "cube" | "cubed" | "pow3" => "write `x.powi(3)`",
        "log" | "loge" => "the natural logarithm is `ln(x)`",
        "log2" => "write it through the natural logarithm, `ln(x) / ln(2.0)`",
        "log10" | "lg" => "write it through the natural logarithm, `ln(x) / ln(10.0)`",
        "log1p" | "ln1p" => "write `ln(1.0 + x)`",
        "expm1" => "write `exp(x) - 1.0`",
        "exp2" => "write `exp(x * ln(2.0))`",
        "exp10" => "write `exp(x * ln(10.0))`",
        _ => return None,
    };
    Some(hint)
}

/// Trigonometric and hyperbolic functions, and their inverses.
fn of_angles(plain: &str) -> Option<&'static str> {
    let hint = match plain {
        "arcsin" => "write `asin(x)`",
        "arccos" => "write `acos(x)`",
        "arctan" | "arctg" => "write `atan(x)`",
        "arctan2" | "tan2" => "write `atan2(y, x)`",
        "arcsinh" | "arsinh" => "write `asinh(x)`",
        "arccosh" | "arcosh" => "write `acosh(x)`",
        "arctanh" | "artanh" => "write `atanh(x)`",
        "sine" => "write `sin(x)`",
        "cosine" => "write `cos(x)`",
        "tangent" | "tg" => "write `tan(x)`",
        "sec" => "write `1.0 / cos(x)`",
        "csc" | "cosec" => "write `1.0 / sin(x)`",
        "cot" | "cotan" | "ctg" => "write `1.0 / tan(x)`",
        "sech" => "write `1.0 / cosh(x)`",
        "csch" => "write `1.0 / sinh(x)`",
        "coth" => "write `1.0 / tanh(x)`",
        "asec" => "write `acos(1.0 / x)`",
        "acsc" => "write `asin(1.0 / x)`",
        "acot" => "write `atan(1.0 / x)`",
        "sind" | "cosd" | "tand" => "angles are in radians: write `sin(x * PI / 180.0)`",
        "toradians" | "radians" | "deg2rad" => "write `x * PI / 180.0`",
        "todegrees" | "degrees" | "rad2deg" => "write `x * 180.0 / PI`",
        "sincos" => "write `sin(x)` and `cos(x)`; they are computed together",
        _ => return None,
    };
    Some(hint)
}

/// Functions that are put together from others, most of them in pieces.
fn of_pieces(plain: &str) -> Option<&'static str> {
    let hint = match plain {
        "sinc" => "write `sin(x) / x`, which has no value at 0",
        "sign" | "sgn" => "write `signum(x)`",
        "copysign" => "write `abs(x) * signum(y)`",
        "fabs" => "write `abs(x)`",
        "cbrt" | "root" | "nthroot" => {
            "write `x.powf(1.0 / 3.0)` where x is positive, and `signum(x) * abs(x).powf(1.0 / 3.0)` elsewhere"
        }
        "rsqrt" => "write `1.0 / sqrt(x)`",
        "hypot" => "write `(x.powi(2) + y.powi(2)).sqrt()`",
        "muladd" | "fma" => "write `a * b + c`",
        "lerp" => "write `a + (b - a) * s`",
        "fmin" | "minimum" => "write `min(x, y)`",
        "fmax" | "maximum" => "write `max(x, y)`",
        "clamp" | "clip" | "saturate" | "sat" => "write `x.max(lowest).min(highest)`",
        "relu" | "ramp" => "write `x.max(0.0)`",
        "heaviside" | "step" | "unitstep" => "write `0.5 * (1.0 + signum(x))`",
        "logistic" | "sigmoid" | "expit" => "write `1.0 / (1.0 + exp(-x))`",
        "softplus" => "write `ln(1.0 + exp(x))`",
        "diracdelta" | "dirac" => {
            "an impulse is no force here: change the velocities in a reaction to an event"
        }
        "piecewise" | "ifelse" | "select" | "cond" | "iif" => NO_CASES,
        "floor" | "ceil" | "round" | "trunc" | "rint" | "fract" => {
            "declare it as a function of Rust, `function(steps(x) = x.floor(), derivative(x) = 0.0)`"
        }
        "fmod" | "mod" | "rem" | "modulo" | "remainder" | "wrap" | "wraptopi" | "remeuclid" => {
            "angles need no reduction: write the angle itself, or declare a function of Rust, \
             `function(remainder(x) = x.rem_euclid(1.0), derivative(x) = 1.0)`"
        }
        _ => return None,
    };
    Some(hint)
}

/// Derivatives, integrals, the time, and conversions.
fn of_time(plain: &str) -> Option<&'static str> {
    let hint = match plain {
        "ddt" | "dt" | "diff" | "der" | "deriv" | "derivative" | "velocity" | "vel" | "d" => {
            "the time derivative is `dot(x)`"
        }
        "ddot" | "acceleration" | "acc" | "accel" => {
            "the second time derivative is `dot(dot(x))`, under `output` only"
        }
        "grad" | "gradient" | "jacobian" | "hessian" | "partial" => {
            "energies are written without derivatives but `dot(x)`: their gradients are what is derived"
        }
        "integral" | "integrate" => {
            "there are no integrals here: write the antiderivative, or declare a function, `function(f(x) = …)`"
        }
        "time" => "the time is `t`",
        "into" | "clone" | "tofloat" | "float" => "leave it out: all numbers here are real",
        _ => return None,
    };
    Some(hint)
}

/// What to write for a function of vectors, matrices or families.
fn of_vectors(plain: &str) -> Option<&'static str> {
    let hint = match plain {
        "magnitude" | "length" | "mag" | "modulus" => "the length of a vector is `v.norm()`",
        "squarednorm" | "norm2" | "magnitudesquared" | "normsq" | "lengthsquared" => {
            "write `v.norm_squared()`"
        }
        "unit" | "unitvector" | "normalized" => "write `v.normalize()`",
        "inner" | "dotproduct" | "vdot" => "write `a.dot(b)`",
        "crossproduct" => "write `a.cross(b)`",
        "kron" | "outerproduct" => "write `a.outer(b)`",
        "hadamard" => "write `a.component_mul(b)`",
        "skew" | "hat" | "skewsymmetric" | "tilde" => "write `v.cross_matrix()`",
        "transposed" | "adjoint" => "write `m.transpose()`",
        "tryinverse" | "inv" | "invert" => "write `m.inverse()`",
        "solve" | "linsolve" => "write `m.inverse() * v`",
        "det" => "write `m.determinant()`",
        "tr" => "write `m.trace()`",
        "eye" => "write `identity(3)`",
        "diag" => "write `diagonal([a, b, c])`",
        "matrix" | "mat" | "array" | "vec" | "vec2" | "vec3" | "vector" | "vector2" | "vector3"
        | "vstack" | "hstack" => "write `[x, y, z]`, and a matrix `[[a, b], [c, d]]` row by row",
        "zeros" | "ones" => "write `[0.0; 3]`, and `identity(3)` for the unit matrix",
        "rotation" | "rotationmatrix" | "euler" | "eulerangles" | "fromeulerangles" | "rpy"
        | "quaternion" | "quat" => {
            "write `rotation_zxz(phi, theta, psi)`, or another sequence of axes, or `rotation_x(a)` about one"
        }
        "fold" | "reduce" | "iter" | "intoiter" | "zip" | "enumerate" | "filter" | "rev" => {
            "repeat by an index, as in `(0..5).map(|i| m[i] * x[i]).sum()`"
        }
        "range" | "linspace" => {
            "a range is written `0..5`, as in `(0..5).map(|i| m[i] * x[i]).sum()`"
        }
        "fixedview" | "fixedslice" | "slice" | "block" => {
            "a block of a matrix is `m.view((0, 0), (3, 3))`: the first element and the size"
        }
        "fixedrows" => "write `m.rows(0, 3)`",
        "fixedcolumns" => "write `m.columns(0, 3)`",
        "tohomogeneous" => {
            "a homogeneous matrix is `homogeneous(r, p)`, and homogeneous coordinates are `p.push(1.0)`"
        }
        "angularvelocitybody" => "`angular_velocity(r)` is in body axes already",
        _ => return None,
    };
    Some(hint)
}
