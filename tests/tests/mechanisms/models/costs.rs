//! What accelerations cost in vectors, beside the scalars of the references, which are expanded by
//! hand.

use lagrangian::OperationCount;
use lagrangian_tests::trajectory;

/// The cost of a model here, and of the same in scalars.
macro_rules! rows {
    ($($here:path, $scalars:path;)*) => {
        [$((stringify!($here), [
            cost(<$here>::OPERATIONS.accelerations),
            cost(<$scalars>::OPERATIONS.accelerations),
        ])),*]
    };
}

/// In additions, as the derivation reckons them: in vectors fewer angles may occur, and more products.
fn cost(count: OperationCount) -> usize {
    count.total() + 4 * count.divisions + 6 * count.square_roots + 11 * count.sines_and_cosines
}

#[test]
fn vectors_cost_no_more_than_scalars() {
    assert_cost_no_more(&rows!(
        super::cart_pole::CartPole, trajectory::CartPole;
        super::double_pendulum::DoublePendulum, trajectory::DoublePendulum;
        super::gyroscope::Gyroscope, trajectory::GimbalGyroscope;
        super::kapitza_pendulum::KapitzaPendulum, trajectory::KapitzaPendulum;
        super::satellite::OneWheel, trajectory::SatelliteReactionWheel321;
        super::spherical_pendulum::SphericalPendulum, trajectory::SphericalPendulum;
    ));
}

#[test]
#[ignore = "the angle of the elbow alone takes less than the sum of two angles"]
fn an_arm_in_vectors_costs_no_more_than_in_scalars() {
    assert_cost_no_more(&rows!(super::robot_arm::RobotArm, trajectory::RobotArm3dof;));
}

/// By a tenth at most.
fn assert_cost_no_more(rows: &[(&str, [usize; 2])]) {
    for (name, [here, scalars]) in rows {
        println!("{here:>4}, and {scalars:>4} in scalars: {name}");
    }
    for (name, [here, scalars]) in rows {
        assert!(
            10 * here <= 11 * scalars,
            "{name} costs {here}, and {scalars} in scalars"
        );
    }
}
