//! What is said about all exhibits, as JSON for the page in the browser.

use crate::about::{About, Curve, Group, Quantity};
use crate::exhibit::Exhibit;

/// Describes exhibits in JSON.
#[must_use]
pub fn description(exhibits: &[&dyn Exhibit]) -> String {
    array(exhibits.iter().map(|exhibit| about(exhibit.about())))
}

fn about(about: &About) -> String {
    object(&[
        ("slug", string(about.slug)),
        ("title", string(about.title)),
        ("sentence", string(about.sentence)),
        ("pace", about.pace.to_string()),
        ("view", array(about.view.iter().map(f64::to_string))),
        ("quantities", array(about.quantities.iter().map(quantity))),
        ("curves", array(about.curves.iter().map(curve))),
    ])
}

fn quantity(quantity: &Quantity) -> String {
    let group = match quantity.group {
        Group::Parameter => "parameter",
        Group::Start => "start",
        Group::Control => "control",
    };
    object(&[
        ("group", string(group)),
        ("name", string(quantity.name)),
        ("unit", string(quantity.unit)),
        ("value", quantity.value.to_string()),
        ("range", array(quantity.range.iter().map(f64::to_string))),
        ("isSwitch", quantity.is_switch().to_string()),
    ])
}

fn curve(curve: &Curve) -> String {
    object(&[("name", string(curve.name)), ("unit", string(curve.unit))])
}

fn object(members: &[(&str, String)]) -> String {
    let members: Vec<_> = members
        .iter()
        .map(|(name, value)| format!("{}:{value}", string(name)))
        .collect();
    format!("{{{}}}", members.join(","))
}

fn array(items: impl Iterator<Item = String>) -> String {
    format!("[{}]", items.collect::<Vec<_>>().join(","))
}

/// A text in quotation marks. The texts of exhibits contain no control characters.
fn string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
