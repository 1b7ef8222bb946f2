//! What is said about an exhibit: its names, its sliders and its curves.

/// What a slider sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// A parameter of the model.
    Parameter,
    /// A part of the initial state.
    Start,
    /// A setting of the control law, which may change while the motion goes on.
    Control,
}

/// A number that a slider sets.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// What it sets.
    pub group: Group,
    /// Its name, under which a model finds its value.
    pub name: &'static str,
    /// Its unit; values in ° and °/s become radians where a model reads them. Empty for a pure number.
    pub unit: &'static str,
    /// The value with which the exhibit opens.
    pub value: f64,
    /// The ends of the slider.
    pub range: [f64; 2],
}

/// A parameter with its unit, its value and the ends of its slider.
pub(crate) const fn parameter(
    name: &'static str,
    unit: &'static str,
    value: f64,
    range: [f64; 2],
) -> Quantity {
    Quantity {
        group: Group::Parameter,
        name,
        unit,
        value,
        range,
    }
}

/// A part of the initial state.
pub(crate) const fn start(
    name: &'static str,
    unit: &'static str,
    value: f64,
    range: [f64; 2],
) -> Quantity {
    Quantity {
        group: Group::Start,
        name,
        unit,
        value,
        range,
    }
}

/// A setting of the control law.
pub(crate) const fn control(
    name: &'static str,
    unit: &'static str,
    value: f64,
    range: [f64; 2],
) -> Quantity {
    Quantity {
        group: Group::Control,
        name,
        unit,
        value,
        range,
    }
}

impl Quantity {
    /// Whether it is a switch: off at 0, on at 1.
    #[must_use]
    pub fn is_switch(&self) -> bool {
        self.group == Group::Control && self.unit == SWITCH
    }
}

/// The unit of a switch.
pub(crate) const SWITCH: &str = "on or off";

/// A curve of the time plot.
#[derive(Clone, Copy, Debug)]
pub struct Curve {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
}

/// What is said about an exhibit.
#[derive(Clone, Copy, Debug)]
pub struct About {
    /// Its name in addresses.
    pub slug: &'static str,
    /// Its title.
    pub title: &'static str,
    /// One sentence on what it is and does.
    pub sentence: &'static str,
    /// The source text of its declaration, with its documentation.
    pub source: &'static str,
    /// Its sliders.
    pub quantities: &'static [Quantity],
    /// The curves of its time plot.
    pub curves: &'static [Curve],
    /// How long the gallery shows its motion, in units of its time.
    pub seconds: f64,
    /// How many units of its time pass in a second of the page.
    pub pace: f64,
    /// From where it is seen: the azimuth and the height of the eye in rad.
    pub view: [f64; 2],
}
