//! The colours of drawings, for light and dark pages.

use std::fmt::Write as _;

/// How many brightnesses each colour has.
pub const SHADES: usize = 12;

/// The colours at full light, in the order of [`Tone`](crate::scene::Tone): on a light page, and on a dark one. Blue, vermilion
/// and green are told apart by most readers (M. Okabe, K. Ito, Color universal design, 2008).
const COLORS: [[[f64; 3]; 2]; 7] = [
    [[52.0, 134.0, 214.0], [92.0, 168.0, 240.0]],
    [[224.0, 104.0, 38.0], [244.0, 136.0, 72.0]],
    [[22.0, 158.0, 122.0], [58.0, 196.0, 158.0]],
    [[112.0, 122.0, 136.0], [160.0, 170.0, 184.0]],
    [[158.0, 164.0, 172.0], [110.0, 118.0, 130.0]],
    [[206.0, 211.0, 218.0], [52.0, 60.0, 72.0]],
    [[206.0, 80.0, 120.0], [240.0, 130.0, 164.0]],
];

/// What a drawing stands on: the background of a light page, and of a dark one.
pub const BACKGROUNDS: [[f64; 3]; 2] = [[250.0, 251.0, 252.0], [19.0, 24.0, 31.0]];

/// The colour of a tone at a brightness below [`SHADES`], as `#rrggbb`.
///
/// Bodies get darker with less light; the trail and the ground, which no light shades, fade into the background.
#[must_use]
pub fn color(is_dark: bool, tone: usize, shade: usize) -> String {
    let theme = usize::from(is_dark);
    #[allow(clippy::cast_precision_loss)] // Below 12.
    let light = shade.min(SHADES - 1) as f64 / (SHADES - 1) as f64;
    let full = COLORS[tone.min(COLORS.len() - 1)][theme];
    let fades = tone >= 5;
    let (from, share) = if fades {
        (BACKGROUNDS[theme], light)
    } else {
        ([24.0, 28.0, 44.0], 0.34 + 0.66 * light)
    };
    let mut text = String::from("#");
    for (a, b) in from.iter().zip(full) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // Between two colours.
        let value = (a + (b - a) * share).round() as u8;
        let _ = write!(text, "{value:02x}");
    }
    text
}
