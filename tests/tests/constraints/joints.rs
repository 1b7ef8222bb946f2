//! The joints of the chapter on constraints, between a body and an inclined frame: what they leave free, and that the forces and
//! moments of their bearings balance the change of the momenta.

use lagrangian::nalgebra::Vector3;
use lagrangian::prelude::*;
use lagrangian::rigid_body::PrincipalBody;
use lagrangian_tests::assert_close;

/// A joint with so many degrees of freedom, by its constraints, and its force and moment on the body.
macro_rules! joint {
    ($test:ident, $free:literal, [$($constraint:tt)+], $force:expr, $moment:expr) => {
        #[test]
        fn $test() {
            #[derive(Lagrangian)]
            #[lagrangian(
                coordinates(x, y, z, a, b, c),
                define(
                    q = [0.1, 0.2, 0.3],
                    s = rotation_x(0.4),
                    p = [x, y, z],
                    r = rotation_xyz(a, b, c),
                    end = p + r * arm,
                ),
                kinetic = kinetic_energy(body, r, p),
                potential = potential_energy(body, r, p, [0.0, 0.0, -9.81]),
                force(end = push),
                constraint($($constraint)+),
                output(
                    end = end,
                    axle = r * axle,
                    force = $force,
                    moment = $moment,
                    change_of_momentum = body.mass * (dot(dot(p)) - [0.0, 0.0, -9.81]) - push,
                    change_of_angular_momentum =
                        dot(r * (body.inertia * angular_velocity(r))) - (end - p).cross(push),
                ),
            )]
            struct Held {
                body: PrincipalBody<f64>,
                arm: Vector3<f64>,
                axle: Vector3<f64>,
                push: Vector3<f64>,
            }
            let model = Held {
                body: PrincipalBody::new(2.0, [0.3, 0.4, 0.5]).expect("it is a body"),
                arm: Vector3::new(0.2, -0.1, 0.4),
                axle: Vector3::new(0.6, 0.0, 0.8),
                push: Vector3::new(1.0, 2.0, -0.5),
            };
            let guess = State::new(
                0.0,
                [0.2, 0.1, 0.4, 0.42, -0.03, 0.01],
                [0.3, 0.1, -0.2, 1.5, -0.4, 2.3],
            );
            let found = model.assemble(guess).solve().expect("the joint is near");
            let freedom = model.degrees_of_freedom(&found.state);
            assert_eq!((freedom.velocities, freedom.coordinates), ($free, $free));
            let seen = model.outputs(&found.state);
            assert!(seen.moment.norm() > 0.05, "{}", seen.moment);
            for (what, found, expected) in [
                ("force", seen.force, seen.change_of_momentum),
                ("moment", seen.moment, seen.change_of_angular_momentum),
            ] {
                assert_close(what, found.as_slice(), expected.as_slice(), 1e-12);
            }
        }
    };
}

joint!(
    spherical,
    3,
    [pin = end - q],
    reaction(pin, p),
    reaction(pin, r)
);
joint!(
    revolute,
    1,
    [
        pin = end - q,
        axis = [s.column(0).dot((r * axle)), s.column(1).dot((r * axle))]
    ],
    reaction(pin, p),
    reaction(pin, r) + reaction(axis, r)
);
joint!(
    universal,
    2,
    [pin = end - q, cross = r.column(0).dot(s.column(1))],
    reaction(pin, p),
    reaction(pin, r) + reaction(cross, r)
);
joint!(
    cylindrical,
    2,
    [
        axis = [s.column(0).dot((r * axle)), s.column(1).dot((r * axle))],
        guide = [s.column(0).dot(p - q), s.column(1).dot(p - q)]
    ],
    reaction(guide, p),
    reaction(axis, r)
);
joint!(
    prismatic,
    1,
    [
        axis = [s.column(0).dot((r * axle)), s.column(1).dot((r * axle))],
        guide = [s.column(0).dot(p - q), s.column(1).dot(p - q)],
        lock = s.column(0).dot(r.column(1))
    ],
    reaction(guide, p),
    reaction(axis, r) + reaction(lock, r)
);
joint!(
    planar,
    3,
    [
        axis = [s.column(0).dot((r * axle)), s.column(1).dot((r * axle))],
        plane = s.column(2).dot(p - q)
    ],
    reaction(plane, p),
    reaction(axis, r)
);
joint!(
    rod,
    5,
    [rod = (end - q).norm() - 0.5],
    reaction(rod, p),
    reaction(rod, r)
);
