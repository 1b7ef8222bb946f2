//! The picture: bands of the tilt over time, the histogram of its maximum, and which parameter matters.

use std::error::Error;
use std::path::Path;

use lagrangian_ensembles::{Histogram, Summary};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

/// The width and height of the picture in pixels.
const SIZE: (u32, u32) = (1000, 900);

const BLUE: RGBColor = RGBColor(38, 88, 160);

/// The size of the letters.
const TEXT: (&str, u32) = ("sans-serif", 18);

type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;

/// Draws what a summary tells of the tilts at times of a spacing, and the part of the variance that is due to each
/// parameter.
pub(crate) fn draw(
    summary: &Summary,
    spacing: f64,
    parts: &[(&str, f64)],
    path: &Path,
) -> Result<(), Box<dyn Error>> {
    register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular())
        .map_err(|_| "the font cannot be read")?;
    let root = BitMapBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let (bands, below) = root.split_vertically(SIZE.1 / 2);
    let (left, right) = below.split_horizontally(SIZE.0 / 2);
    draw_bands(&bands, summary, spacing)?;
    let largest = summary.column("largest tilt");
    let histogram = largest.and_then(|column| column.histogram());
    draw_histogram(&left, histogram.ok_or("the summary has no histogram")?)?;
    draw_parts(&right, parts)?;
    root.present()?;
    Ok(())
}

/// Draws the quantiles of the tilt at each time.
fn draw_bands(area: &Area<'_>, summary: &Summary, spacing: f64) -> Result<(), Box<dyn Error>> {
    let tilts = summary
        .columns()
        .iter()
        .filter(|column| column.name().starts_with("tilt "));
    let quantiles: Vec<(f64, [f64; 5])> = tilts
        .zip(1..)
        .map(|(tilt, time)| {
            let quantile = |probability| tilt.quantile(probability).unwrap_or(f64::NAN);
            (
                f64::from(time) * spacing,
                [0.05, 0.25, 0.5, 0.75, 0.95].map(quantile),
            )
        })
        .collect();
    let end = quantiles.last().map_or(1.0, |(time, _)| *time);
    let greatest = quantiles
        .iter()
        .map(|(_, [.., quantile])| *quantile)
        .fold(0.5, f64::max);
    let mut chart = ChartBuilder::on(area)
        .margin(15)
        .caption(
            "tilt of the top: the median, and bands with 50 and 90 % of the tops",
            ("sans-serif", 22),
        )
        .x_label_area_size(45)
        .y_label_area_size(75)
        .build_cartesian_2d(0.0..end, 0.495..greatest + 0.005)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("t [s]")
        .y_desc("θ [rad]")
        .label_style(TEXT)
        .draw()?;
    for (low, high, opacity) in [(0, 4, 0.2), (1, 3, 0.35)] {
        let there = quantiles.iter().map(|(time, values)| (*time, values[low]));
        let back = quantiles
            .iter()
            .rev()
            .map(|(time, values)| (*time, values[high]));
        let band = Polygon::new(there.chain(back).collect::<Vec<_>>(), BLUE.mix(opacity));
        chart.draw_series([band])?;
    }
    let median = quantiles.iter().map(|(time, values)| (*time, values[2]));
    chart.draw_series(LineSeries::new(median, BLUE.stroke_width(2)))?;
    Ok(())
}

/// Draws the numbers of tops in the bins of a histogram.
fn draw_histogram(area: &Area<'_>, histogram: &Histogram) -> Result<(), Box<dyn Error>> {
    let (edges, counts) = (histogram.edges(), histogram.counts());
    let most = counts.iter().copied().max().unwrap_or(0);
    let mut chart = ChartBuilder::on(area)
        .margin(15)
        .x_label_area_size(45)
        .y_label_area_size(75)
        .build_cartesian_2d(edges[0]..edges[edges.len() - 1], 0..most + most / 10 + 1)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(6)
        .x_desc("largest tilt [rad]")
        .y_desc("tops")
        .label_style(TEXT)
        .draw()?;
    let bins = edges.windows(2).zip(counts);
    chart.draw_series(
        bins.map(|(edge, count)| Rectangle::new([(edge[0], 0), (edge[1], *count)], BLUE.filled())),
    )?;
    Ok(())
}

/// Draws the part of the variance that is due to each parameter.
fn draw_parts(area: &Area<'_>, parts: &[(&str, f64)]) -> Result<(), Box<dyn Error>> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)] // There are five.
    let count = parts.len() as i32;
    let mut chart = ChartBuilder::on(area)
        .margin(15)
        .x_label_area_size(45)
        .y_label_area_size(75)
        .build_cartesian_2d((0..count).into_segmented(), 0.0..100.0)?;
    let name = |place: &SegmentValue<i32>| match place {
        SegmentValue::CenterOf(place) => {
            let part = usize::try_from(*place)
                .ok()
                .and_then(|place| parts.get(place));
            part.map_or(String::new(), |(name, _)| (*name).to_owned())
        }
        _ => String::new(),
    };
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .x_label_formatter(&name)
        .y_desc("part of the variance [%]")
        .label_style(TEXT)
        .draw()?;
    chart.draw_series((0..).zip(parts).map(|(place, (_, part))| {
        let corners = [
            (SegmentValue::Exact(place), 0.0),
            (SegmentValue::Exact(place + 1), 100.0 * part),
        ];
        let mut bar = Rectangle::new(corners, BLUE.filled());
        bar.set_margin(0, 0, 15, 15);
        bar
    }))?;
    Ok(())
}
