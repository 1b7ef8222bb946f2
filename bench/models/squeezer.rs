//! Andrews' squeezing mechanism as a user declares it, as a contestant.

use lagrangian::prelude::*;

/// Andrews' squeezing mechanism: seven bodies in a plane that close three loops.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(be, th, ga, ph, de, om, ep),
    define(
        // The crank turns about the origin; the coupler leads from its end to the point that all loops share.
        crank = [cos(be), sin(be)],
        coupler = [cos(be + th), sin(be + th)],
        joint = rr * crank - d * coupler,
        // The levers at the fixed points a and b.
        a = [xa, ya],
        b = [xb, yb],
        along3 = [cos(ga), sin(ga)],
        across3 = [sin(ga), -cos(ga)],
        along5 = [cos(de), sin(de)],
        across5 = [sin(de), -cos(de)],
        along7 = [sin(ep), -cos(ep)],
        across7 = [cos(ep), sin(ep)],
        // The rods between levers and the joint.
        along4 = [sin(ph + de), -cos(ph + de)],
        along6 = [cos(om + ep), sin(om + ep)],
        c1 = ra * crank,
        c2 = rr * crank - da * coupler,
        c3 = b + sa * along3 + sb * [-sin(ga), cos(ga)],
        c4 = a + zt * along5 + (e - ea) * along4,
        c5 = a + ta * along5 - tb * across5,
        c6 = a + u * along7 + (zf - fa) * along6,
        c7 = a + ua * along7 - ub * across7,
        anchor = b + sd * along3 + sc * across3,
        stretch = (anchor - [xc, yc]).norm() - l0,
    ),
    kinetic = 0.5 * (m1 * dot(c1).norm_squared() + i1 * dot(be).powi(2)),
    kinetic = 0.5 * (m2 * dot(c2).norm_squared() + i2 * dot(be + th).powi(2)),
    kinetic = 0.5 * (m3 * dot(c3).norm_squared() + i3 * dot(ga).powi(2)),
    kinetic = 0.5 * (m4 * dot(c4).norm_squared() + i4 * dot(ph + de).powi(2)),
    kinetic = 0.5 * (m5 * dot(c5).norm_squared() + i5 * dot(de).powi(2)),
    kinetic = 0.5 * (m6 * dot(c6).norm_squared() + i6 * dot(om + ep).powi(2)),
    kinetic = 0.5 * (m7 * dot(c7).norm_squared() + i7 * dot(ep).powi(2)),
    potential = 0.5 * c0 * stretch.powi(2),
    force(be = mom),
    constraint(
        third = joint - b - ss * [sin(ga), -cos(ga)],
        fourth = joint - a - zt * along5 - e * along4,
        sixth = joint - a - u * along7 - zf * along6,
    ),
)]
#[rustfmt::skip]
struct Squeezer {
    m1: f64, m2: f64, m3: f64, m4: f64, m5: f64, m6: f64, m7: f64,
    i1: f64, i2: f64, i3: f64, i4: f64, i5: f64, i6: f64, i7: f64,
    xa: f64, ya: f64, xb: f64, yb: f64, xc: f64, yc: f64,
    c0: f64, l0: f64, mom: f64,
    d: f64, da: f64, e: f64, ea: f64, rr: f64, ra: f64,
    ss: f64, sa: f64, sb: f64, sc: f64, sd: f64, ta: f64, tb: f64,
    u: f64, ua: f64, ub: f64, zf: f64, zt: f64, fa: f64,
}

fn main() -> std::process::ExitCode {
    #[rustfmt::skip]
    let model = Squeezer {
        m1: 0.04325, m2: 0.00365, m3: 0.02373, m4: 0.00706, m5: 0.07050, m6: 0.00706, m7: 0.05498,
        i1: 2.194e-6, i2: 4.410e-7, i3: 5.255e-6, i4: 5.667e-7, i5: 1.169e-5, i6: 5.667e-7, i7: 1.912e-5,
        xa: -0.06934, ya: -0.00227, xb: -0.03635, yb: 0.03273, xc: 0.014, yc: 0.072,
        c0: 4530.0, l0: 0.07785, mom: 0.033,
        d: 0.028, da: 0.0115, e: 0.02, ea: 0.01421, rr: 0.007, ra: 0.00092,
        ss: 0.035, sa: 0.01874, sb: 0.01043, sc: 0.018, sd: 0.02, ta: 0.02308,
        tb: 0.00916, u: 0.04, ua: 0.01228, ub: 0.00449, zf: 0.02, zt: 0.04, fa: 0.01421,
    };
    let operations = Squeezer::OPERATIONS.accelerations;
    lagrangian_bench::integrate_alone::<7, Squeezer>(&model, operations)
}
