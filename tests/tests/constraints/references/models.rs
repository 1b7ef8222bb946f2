//! The mechanisms of the reference values with constraints, as they are naturally declared.

use lagrangian::prelude::*;
use lagrangian::rigid_body::InertiaTensor;
use lagrangian_tests::Motion;
use nalgebra::{Matrix3, Vector3};

use crate::closed_forms::RollingDisc;

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
pub(super) struct Squeezer {
    pub(super) m1: f64, pub(super) m2: f64, pub(super) m3: f64, pub(super) m4: f64, pub(super) m5: f64, pub(super) m6: f64, pub(super) m7: f64,
    pub(super) i1: f64, pub(super) i2: f64, pub(super) i3: f64, pub(super) i4: f64, pub(super) i5: f64, pub(super) i6: f64, pub(super) i7: f64,
    pub(super) xa: f64, pub(super) ya: f64, pub(super) xb: f64, pub(super) yb: f64, pub(super) xc: f64, pub(super) yc: f64,
    pub(super) c0: f64, pub(super) l0: f64, pub(super) mom: f64,
    pub(super) d: f64, pub(super) da: f64, pub(super) e: f64, pub(super) ea: f64, pub(super) rr: f64, pub(super) ra: f64,
    pub(super) ss: f64, pub(super) sa: f64, pub(super) sb: f64, pub(super) sc: f64, pub(super) sd: f64, pub(super) ta: f64, pub(super) tb: f64,
    pub(super) u: f64, pub(super) ua: f64, pub(super) ub: f64, pub(super) zf: f64, pub(super) zt: f64, pub(super) fa: f64,
}

/// Two weights on a rope over a pulley that does not slip.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x1, x2, alpha),
    kinetic = 0.5 * (m1 * dot(x1).powi(2) + m2 * dot(x2).powi(2) + jp * dot(alpha).powi(2)),
    potential = -g * (m1 * x1 + m2 * x2),
    constraint(rope = x1 + x2 - len, grip = x1 - rp * alpha),
)]
pub(super) struct Atwood {
    pub(super) m1: f64,
    pub(super) m2: f64,
    pub(super) jp: f64,
    pub(super) rp: f64,
    pub(super) len: f64,
    pub(super) g: f64,
}

/// A sleigh on a knife edge at (x, y), with its centre of gravity ahead of the edge.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p: Vector2, th),
    define(
        forward = [cos(th), sin(th)],
        left = [-sin(th), cos(th)],
        center = p + a * forward,
    ),
    kinetic = 0.5 * (m * dot(center).norm_squared() + j * dot(th).powi(2)),
    nonholonomic(edge = dot(p).dot(left)),
)]
pub(super) struct Sleigh {
    pub(super) m: f64,
    pub(super) j: f64,
    pub(super) a: f64,
}

/// Bricard's mechanism: five of the six edges of a chain on a cube, whose joints are orthogonal. By its symmetry every other joint
/// turns by the same angle.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(a, b),
    define(
        r[0] = rotation_y(a),
        r[1] = r[0] * rotation_z(b),
        r[2] = r[1] * rotation_x(a),
        r[3] = r[2] * rotation_y(b),
        r[4] = r[3] * rotation_z(a),
        p[0] = [0.0, 0.0, 0.0],
        p[i] = p[i - 1] + r[i - 1] * edges[i - 1] for i in 1..5,
    ),
    body(rods[i] = (r[i], p[i]) for i in 0..5),
    gravity = [0.0, -g, 0.0],
    constraint(closure = sin(a) * sin(b) + sin(a) + sin(b)),
    output(third = p[3]),
)]
pub(super) struct Bricard {
    pub(super) rods: [RigidBody; 5],
    pub(super) edges: [Vector3<f64>; 5],
    pub(super) g: f64,
}

/// A bob that a rod keeps at a distance.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p: Vector2),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.y,
    constraint(rod = 0.5 * (p.norm_squared() - l.powi(2))),
)]
pub(super) struct Pendulum {
    pub(super) m: f64,
    pub(super) l: f64,
    pub(super) g: f64,
}

impl Squeezer {
    pub(super) fn of(motion: &Motion) -> Self {
        let [m1, m2, m3, m4, m5, m6, m7] =
            motion.parameters(["m1", "m2", "m3", "m4", "m5", "m6", "m7"]);
        let [i1, i2, i3, i4, i5, i6, i7] =
            motion.parameters(["i1", "i2", "i3", "i4", "i5", "i6", "i7"]);
        let [xa, ya, xb, yb, xc, yc] = motion.parameters(["xa", "ya", "xb", "yb", "xc", "yc"]);
        let [c0, l0, mom] = motion.parameters(["c0", "l0", "mom"]);
        let [d, da, e, ea, rr, ra] = motion.parameters(["d", "da", "e", "ea", "rr", "ra"]);
        let [ss, sa, sb, sc, sd, ta, tb] =
            motion.parameters(["ss", "sa", "sb", "sc", "sd", "ta", "tb"]);
        let [u, ua, ub, zf, zt, fa] = motion.parameters(["u", "ua", "ub", "zf", "zt", "fa"]);
        #[rustfmt::skip]
        return Self {
            m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, xa, ya, xb, yb, xc, yc, c0, l0, mom,
            d, da, e, ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, zf, zt, fa,
        };
    }
}

impl Atwood {
    pub(super) fn of(motion: &Motion) -> Self {
        let [m1, m2, jp, rp, len, g] = motion.parameters(["m1", "m2", "jp", "rp", "len", "g"]);
        Self {
            m1,
            m2,
            jp,
            rp,
            len,
            g,
        }
    }
}

impl Sleigh {
    pub(super) fn of(motion: &Motion) -> Self {
        let [m, j, a] = motion.parameters(["m", "j", "a"]);
        Self { m, j, a }
    }
}

impl Bricard {
    pub(super) fn of(motion: &Motion) -> Self {
        let [m, across, along, g] = motion.parameters(["m", "it", "ia", "g"]);
        let edges = [
            Vector3::x(),
            -Vector3::y(),
            Vector3::z(),
            -Vector3::x(),
            Vector3::y(),
        ];
        let rods = edges.map(|edge| {
            let axial = edge * edge.transpose();
            let inertia = across * (Matrix3::identity() - axial) + along * axial;
            let inertia = InertiaTensor::from_matrix(&inertia).unwrap();
            RigidBody::new(m, 0.5 * edge, inertia).unwrap()
        });
        Self { rods, edges, g }
    }
}

impl Pendulum {
    pub(super) fn of(motion: &Motion) -> Self {
        let [m, l, g] = motion.parameters(["m", "l", "g"]);
        Self { m, l, g }
    }
}

/// The rolling disc.
pub(super) fn disc(motion: &Motion) -> RollingDisc {
    let [m, radius, i1, i3, g] = motion.parameters(["m", "r", "i1", "i3", "g"]);
    let disc = SymmetricBody::new(m, 0.0, i1, i3).unwrap();
    RollingDisc { disc, radius, g }
}
