//! What accelerations cost in vectors, beside the scalars of the references, which are multiplied out by
//! hand.

use lagrangian_tests::trajectory;

/// The operations of a model here, and of the same in scalars.
macro_rules! rows {
    ($($here:path, $scalars:path;)*) => {
        [$((stringify!($here), [
            <$here>::OPERATIONS.accelerations.total(),
            <$scalars>::OPERATIONS.accelerations.total(),
        ])),*]
    };
}

#[test]
fn vectors_cost_no_more_than_scalars() {
    assert_cost_no_more(&rows!(
        crate::cart_pole::CartPole, trajectory::CartPole;
        crate::kapitza_pendulum::KapitzaPendulum, trajectory::KapitzaPendulum;
        crate::spherical_pendulum::SphericalPendulum, trajectory::SphericalPendulum;
    ));
}

#[test]
#[ignore = "where there are more squares than coordinates, angles that cancel in M stay in the forms"]
fn vectors_cost_no_more_than_what_is_multiplied_out() {
    assert_cost_no_more(&rows!(
        crate::double_pendulum::DoublePendulum, trajectory::DoublePendulum;
        crate::gyroscope::Gyroscope, trajectory::GimbalGyroscope;
        crate::robot_arm::RobotArm, trajectory::RobotArm3dof;
        crate::satellite::OneWheel, trajectory::SatelliteReactionWheel321;
    ));
}

/// By a tenth at most.
fn assert_cost_no_more(rows: &[(&str, [usize; 2])]) {
    for (name, [here, scalars]) in rows {
        println!("{here:>4} operations, and {scalars:>4} in scalars: {name}");
    }
    for (name, [here, scalars]) in rows {
        assert!(
            10 * here <= 11 * scalars,
            "{name} costs {here} operations, and {scalars} in scalars"
        );
    }
}
