//! Writes random states of ready models with their accelerations, as lines of a table: the name of the model, the numbers of its fields,
//! of the state (t, q, q̇), and the accelerations, each list separated by spaces.
//!
//! `cargo run -p lagrangian-models --example accelerations -- 1000` writes a thousand lines for each model, with which programs in other
//! languages compare theirs.

use lagrangian::State;
use lagrangian::quantities::{FieldElement, InvalidNumbers, Reflect};
use lagrangian_models::{
    Acrobot, Bicycle, CartPole, CartWithTwoPoles, DoublePendulum, FreeBody, FurutaPendulum,
    GantryCrane, GeneralTop, Gyrocompass, Gyroscope, KapitzaPendulum, SimplePendulum,
    SphericalPendulum, SymmetricTop,
};

/// Random numbers in the unit interval (Vigna, `SplitMix64`, 2015), the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        #[allow(clippy::cast_precision_loss)] // 53 bits.
        let numerator = (bits >> 11) as f64;
        numerator / 9_007_199_254_740_992.0
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Random numbers for an element of a field.
fn element(element: FieldElement, random: &mut Random, numbers: &mut Vec<f64>) {
    let mut positive = || random.within(0.5, 1.5);
    match element {
        FieldElement::RigidBody => {
            numbers.extend([
                positive(),
                0.1 * positive(),
                -0.1 * positive(),
                0.2 * positive(),
            ]);
            let (diagonal, product) = (
                [1.0, 1.1, 1.2].map(|moment| moment * 0.1),
                0.01 * positive(),
            );
            let [first, second, third] = diagonal;
            numbers.extend([first, product, 0.0, product, second, 0.0, 0.0, 0.0, third]);
        }
        FieldElement::PrincipalBody => numbers.extend([positive(), 0.1, 0.12, 0.14]),
        FieldElement::SymmetricBody => numbers.extend([positive(), 0.3 * positive(), 0.1, 0.05]),
        _ => numbers.push(positive()),
    }
}

fn write<M: Reflect<N>, const N: usize>(count: usize) -> Result<(), InvalidNumbers> {
    let mut random = Random(M::NAME.bytes().fold(N as u64, |seed, byte| {
        seed.wrapping_mul(31).wrapping_add(byte.into())
    }));
    for _ in 0..count {
        let mut numbers = Vec::new();
        for field in M::FIELDS {
            for _ in 0..field.count() / field.element.count() {
                element(field.element, &mut random, &mut numbers);
            }
        }
        let model = M::from_numbers(&numbers)?;
        let t = random.within(0.0, 10.0);
        let q: [f64; N] = std::array::from_fn(|_| random.within(0.2, 1.2));
        let v: [f64; N] = std::array::from_fn(|_| random.within(-1.0, 1.0));
        let accelerations = model.accelerations(&State::new(t, q, v));
        let line = |numbers: &[f64]| {
            let words: Vec<_> = numbers.iter().map(|number| format!("{number:?}")).collect();
            words.join(" ")
        };
        println!(
            "{}\t{}\t{t:?}\t{}\t{}\t{}",
            M::NAME,
            line(&numbers),
            line(&q),
            line(&v),
            line(accelerations.as_slice())
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = std::env::args()
        .nth(1)
        .map_or(Ok(10), |count| count.parse())?;
    write::<Acrobot, _>(count)?;
    write::<CartPole, _>(count)?;
    write::<CartWithTwoPoles, _>(count)?;
    write::<DoublePendulum, _>(count)?;
    write::<FreeBody, _>(count)?;
    write::<FurutaPendulum, _>(count)?;
    write::<GantryCrane, _>(count)?;
    write::<GeneralTop, _>(count)?;
    write::<Gyrocompass, _>(count)?;
    write::<Gyroscope, _>(count)?;
    write::<KapitzaPendulum, _>(count)?;
    write::<SimplePendulum, _>(count)?;
    write::<SphericalPendulum, _>(count)?;
    write::<SymmetricTop, _>(count)?;
    write::<Bicycle, _>(count)?;
    Ok(())
}
