//! Figures of the guide: curves in one pair of axes.

use std::error::Error;
use std::path::PathBuf;

use plotters::coord::Shift;
use plotters::prelude::*;

/// A curve of a figure: its name and its points.
#[derive(Clone, Debug)]
pub struct Curve<'a> {
    /// What the legend calls it; empty for a figure of one curve.
    pub name: &'a str,
    /// The points (x, y).
    pub points: Vec<[f64; 2]>,
}

/// A figure with one pair of axes.
#[derive(Clone, Copy, Debug)]
pub struct Figure<'a> {
    /// The name of the file without its ending.
    pub file: &'a str,
    /// The label of the horizontal axis, with its unit.
    pub x: &'a str,
    /// The label of the vertical axis, with its unit.
    pub y: &'a str,
}

impl<'a> Curve<'a> {
    /// A curve with this name through points (x, y).
    #[must_use]
    pub fn new(name: &'a str, points: Vec<[f64; 2]>) -> Self {
        Self { name, points }
    }
}

impl<'a> Figure<'a> {
    /// A figure in the file `NAME.svg` with the labels of its axes.
    #[must_use]
    pub fn new(file: &'a str, x: &'a str, y: &'a str) -> Self {
        Self { file, x, y }
    }
}

impl Figure<'_> {
    /// Draws curves into the file `NAME.svg` of the folder that is the first argument of the program; without arguments,
    /// nothing is drawn.
    ///
    /// # Errors
    ///
    /// The file cannot be written.
    pub fn draw(&self, curves: &[Curve<'_>]) -> Result<(), Box<dyn Error>> {
        let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
            return Ok(());
        };
        let path = folder.join(self.file).with_extension("svg");
        let area = SVGBackend::new(&path, (720, 360)).into_drawing_area();
        let points = || curves.iter().flat_map(|curve| &curve.points);
        let (x, y) = (
            extent(points().map(|p| p[0])),
            extent(points().map(|p| p[1])),
        );
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .margin_top(if curves.iter().all(|curve| curve.name.is_empty()) {
                12
            } else {
                28
            })
            .x_label_area_size(44)
            .y_label_area_size(64)
            .build_cartesian_2d(x[0]..x[1], y[0]..y[1])?;
        chart
            .configure_mesh()
            .x_desc(self.x)
            .y_desc(self.y)
            .axis_desc_style(("sans-serif", 15))
            .label_style(("sans-serif", 13))
            .light_line_style(TRANSPARENT)
            .draw()?;
        for (index, curve) in curves.iter().enumerate() {
            let color = COLORS[index % COLORS.len()];
            let series = LineSeries::new(
                curve.points.iter().map(|&[x, y]| (x, y)),
                color.stroke_width(2),
            );
            chart.draw_series(series)?;
        }
        legend(&area, curves)?;
        area.present()?;
        Ok(())
    }
}

/// Draws the names of curves in a line above the axes.
fn legend<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    curves: &[Curve<'_>],
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let mut x = 76;
    for (index, curve) in curves.iter().enumerate() {
        if curve.name.is_empty() {
            continue;
        }
        let color = COLORS[index % COLORS.len()].stroke_width(2);
        area.draw(&PathElement::new([(x, LEGEND), (x + 18, LEGEND)], color))?;
        let font = ("sans-serif", 14).into_font().color(&BLACK);
        area.draw(&Text::new(curve.name, (x + 24, LEGEND - 7), font))?;
        // A letter is about 8 wide.
        x += 48 + 8 * i32::try_from(curve.name.chars().count()).unwrap_or(0);
    }
    Ok(())
}

/// The height of the legend.
const LEGEND: i32 = 14;

/// Blue, vermilion, green, purple: told apart by most readers (M. Okabe, K. Ito, Color universal design, 2008).
const COLORS: [RGBColor; 4] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
];

/// The least and the largest value, with a margin.
fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    let margin = 0.04 * (high - low).max(f64::MIN_POSITIVE);
    [low - margin, high + margin]
}
