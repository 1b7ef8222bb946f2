//! The picture: a pixel for each start, coloured by the time of its flip.

use std::error::Error;
use std::path::Path;

use lagrangian_ensembles::Table;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

/// The width and height of the picture in pixels.
const SIZE: (u32, u32) = (1000, 860);

/// The size of the letters.
const TEXT: (&str, u32) = ("sans-serif", 20);

type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;

/// The largest angle of a start in rad.
pub(crate) const LARGEST: f64 = 3.1;

/// Draws the times of the flips over the starts.
pub(crate) fn draw(table: &Table, size: usize, path: &Path) -> Result<(), Box<dyn Error>> {
    let missing = || "the table has no such column";
    let [first, second, flips] =
        ["theta1", "theta2", "flip"].map(|name| table.column(name).ok_or_else(missing));
    let (first, second, flips) = (first?, second?, flips?);
    register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular())
        .map_err(|_| "the font cannot be read")?;
    // Starts near the unstable equilibria flip at once, and would take most of the scale.
    let summary = table.summary();
    let quantile = |probability| summary.column("flip")?.quantile(probability);
    let (low, high) = quantile(0.1)
        .zip(quantile(1.0))
        .ok_or("no pendulum flips")?;
    let colour = |time: f64| {
        let part = (time / low).ln() / (high / low).ln().max(f64::MIN_POSITIVE);
        ViridisRGB.get_color(1.0 - part.clamp(0.0, 1.0))
    };

    let root = BitMapBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let (map, bar) = root.split_horizontally(SIZE.0 - 130);
    let starts = first.iter().zip(second).zip(flips);
    let starts: Vec<[f64; 3]> = starts.map(|((x, y), flip)| [*x, *y, *flip]).collect();
    draw_map(&map, &starts, size, colour)?;
    draw_scale(&bar, (low, high), colour)?;
    root.present()?;
    Ok(())
}

/// Draws a rectangle for each start, and for its mirror image.
fn draw_map(
    area: &Area<'_>,
    starts: &[[f64; 3]],
    size: usize,
    colour: impl Fn(f64) -> RGBColor,
) -> Result<(), Box<dyn Error>> {
    let mut chart = ChartBuilder::on(area)
        .margin(15)
        .caption(
            "time until a double pendulum flips, from rest",
            ("sans-serif", 24),
        )
        .x_label_area_size(50)
        .y_label_area_size(70)
        .build_cartesian_2d(-LARGEST..LARGEST, -LARGEST..LARGEST)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc("θ₁ [rad]")
        .y_desc("θ₂ [rad]")
        .label_style(TEXT)
        .draw()?;
    #[allow(clippy::cast_precision_loss)] // There are few.
    let spacing = 0.5 * LARGEST / (size.max(2) - 1) as f64;
    chart.draw_series(
        starts
            .iter()
            .filter(|[.., flip]| flip.is_finite())
            .flat_map(|[x, y, flip]| {
                let style = colour(*flip).filled();
                [1.0, -1.0].map(|sign| {
                    let (x, y) = (sign * x, sign * y);
                    Rectangle::new(
                        [
                            (x - spacing, y - 2.0 * spacing),
                            (x + spacing, y + 2.0 * spacing),
                        ],
                        style,
                    )
                })
            }),
    )?;
    Ok(())
}

/// Draws the colours of the times between two.
fn draw_scale(
    area: &Area<'_>,
    (low, high): (f64, f64),
    colour: impl Fn(f64) -> RGBColor,
) -> Result<(), Box<dyn Error>> {
    let mut scale = ChartBuilder::on(area)
        .margin_top(60)
        .margin_bottom(75)
        .margin_right(15)
        .y_label_area_size(70)
        .build_cartesian_2d(0.0..1.0, (low..high).log_scale())?;
    scale
        .configure_mesh()
        .disable_mesh()
        .disable_x_axis()
        .y_desc("time of the flip [s]; white: none")
        .y_label_formatter(&|time| format!("{time}"))
        .label_style(TEXT)
        .draw()?;
    let steps = 200;
    scale.draw_series((0..steps).map(|step| {
        let edge = |step: i32| low * (high / low).powf(f64::from(step) / f64::from(steps));
        Rectangle::new(
            [(0.0, edge(step)), (1.0, edge(step + 1))],
            colour(edge(step)).filled(),
        )
    }))?;
    Ok(())
}
