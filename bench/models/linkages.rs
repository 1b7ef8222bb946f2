
four_bars!(FortyFourBars, 41, 40);

/// Prints the greatest error of the first crank's end over ten seconds, of so many motions, which differ in the first step.
macro_rules! measure {
    ($linkages:ident, $cranks:literal, $couplers:literal, $tolerance:ident, $motions:ident) => {
        let start = upright::<$cranks, { 2 * $cranks }>(1.0);
        let expected = expected(f64::from($couplers), 1.0, 10.0);
        let taylor = Taylor::new().relative_tolerance($tolerance).pass_singular_configurations();
        let (mut worst, mut steps): (f64, _) = (0.0, 0);
        for i in 0..$motions {
            let mut motion = Problem::new(&$linkages::NEW, start).start(taylor)?;
            motion.advance(0.01 + 0.003 * f64::from(i))?;
            let end = motion.advance(10.0)?;
            worst = worst.max((end.q[0] - expected).abs());
            steps = steps.max(end.statistics.steps);
        }
        println!("{} {:e} {worst:e} {steps}", $couplers, $tolerance);
    };
}

fn main() -> Result<(), IntegrationError> {
    let motions = std::env::args().nth(1).and_then(|count| count.parse().ok());
    let motions: u32 = motions.unwrap_or(20);
    for tolerance in [1e-11, 1e-12, 1e-13, 1e-14] {
        measure!(OneFourBar, 2, 1, tolerance, motions);
        measure!(TwoFourBars, 3, 2, tolerance, motions);
        measure!(FortyFourBars, 41, 40, tolerance, motions);
    }
    Ok(())
}
