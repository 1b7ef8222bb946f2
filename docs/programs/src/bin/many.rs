//! Parcels that are dropped by parachute: where they land.

// ANCHOR: model
use lagrangian::prelude::*;
use lagrangian_ensembles::{Column, Parameter, Sample, Study};
use lagrangian_guide::{Curve, Figure};

/// A parcel with air drag, in a wind; x is the direction of the flight.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p: Vector3),
    define(air = dot(p) - wind),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.z,
    force(p = -0.5 * density * area * air.norm() * air),
    event(opening = t - delay, ground = p.z),
)]
struct Parcel {
    m: f64,
    g: f64,
    /// The density of the air in kg/m³.
    density: f64,
    /// The area times the drag coefficient in m².
    area: f64,
    wind: Vector3<f64>,
    /// When the parachute opens, in s.
    delay: f64,
}
// ANCHOR_END: model

// ANCHOR: study
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let drops = Sample::new(
        1024,
        [
            Parameter::normal("delay", 3.0, 0.2).unit("s"),
            Parameter::normal("speed", 60.0, 2.0).unit("m/s"),
            Parameter::normal("head wind", 4.0, 1.5).unit("m/s"),
            Parameter::normal("cross wind", 0.0, 1.5).unit("m/s"),
            Parameter::uniform("canopy", 18.0, 22.0).unit("m²"),
        ],
    )
    .sobol()
    .seed(1);
    let problem = |[delay, speed, head, cross, canopy]: [f64; 5]| {
        let parcel = Parcel {
            m: 80.0,
            g: 9.81,
            density: 1.2,
            area: 0.5,
            wind: Vector3::new(-head, cross, 0.0),
            delay,
        };
        let start = State::new(0.0, [0.0, 0.0, 250.0], [speed, 0.0, 0.0]);
        Problem::new(parcel, start)
            .on(Parcel::OPENING)
            .rising()
            .then_with(move |_, parcel| parcel.change(|parcel| parcel.area = canopy))
            .on(Parcel::GROUND)
            .falling()
            .stop()
    };
    let study = Study::new(drops, problem, 200.0, Taylor::new());
    // ANCHOR_END: study

    // ANCHOR: results
    let columns = [
        Column::new("x").unit("m").histogram(-150.0, 250.0, 40),
        Column::new("y").unit("m").histogram(-150.0, 250.0, 40),
        Column::new("impact").unit("m/s"),
    ];
    let summary = study.summary(columns, |motion| {
        [motion.q[0], motion.q[1], motion.v.norm()]
    })?;

    println!("             mean   std. dev.     5 %    95 %");
    for name in ["x", "y", "impact"] {
        let column = summary.column(name).ok_or("no such column")?;
        let [low, high] = [0.05, 0.95].map(|p| column.quantile(p).unwrap_or(f64::NAN));
        let (mean, deviation) = (column.mean(), column.standard_deviation());
        println!("{name:7} {mean:9.2} {deviation:11.2} {low:7.1} {high:7.1}");
    }
    println!("\nCorrelation of x with");
    for name in ["delay", "speed", "head wind", "canopy"] {
        let correlation = summary.correlation(name, "x").ok_or("no such column")?;
        println!("{name:10} {correlation:6.2}");
    }
    println!("Failed: {} of {}", summary.failures(), summary.members());

    // The outlines of the histograms.
    let outline = |name| {
        let histogram = summary.column(name)?.histogram()?;
        let edges = histogram.edges();
        let bars = edges.windows(2).zip(histogram.counts());
        #[allow(clippy::cast_precision_loss)] // There are 1024 members.
        let points = bars.flat_map(|(edge, count)| [edge[0], edge[1]].map(|x| [x, *count as f64]));
        Some(Curve::new(name, points.collect()))
    };
    let curves: Vec<_> = ["x", "y"].into_iter().filter_map(outline).collect();
    Figure::new("many", "place of landing in m", "parcels in 10 m").draw(&curves)
}
// ANCHOR_END: results
