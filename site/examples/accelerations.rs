//! Writes the accelerations of all models at random states as JSON, to be compared with those of the page in the browser.

use lagrangian_exhibits::exhibits;

const STATES: usize = 1000;

/// Random numbers between −1 and 1 (S. Vigna, `SplitMix64`, 2015).
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *seed;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    f64::from(u32::try_from(z >> 32).unwrap_or_default()) / f64::from(u32::MAX) * 2.0 - 1.0
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut seed = 1;
    let mut models = Vec::new();
    for exhibit in exhibits() {
        let motion = exhibit.begin(&[])?;
        let start = motion.state();
        let (q, v) = start.split_at(start.len() / 2);
        let (mut states, mut accelerations) = (Vec::new(), Vec::new());
        for _ in 0..STATES {
            let t = random(&mut seed);
            let q: Vec<_> = q.iter().map(|q| q + 0.4 * random(&mut seed)).collect();
            let v: Vec<_> = v.iter().map(|v| v + 2.0 * random(&mut seed)).collect();
            let found = motion
                .evaluate(t, &q, &v)
                .ok_or("another number of coordinates")?;
            states.push(t);
            states.extend(q.into_iter().chain(v));
            accelerations.extend(found.accelerations);
        }
        models.push(format!(
            "{{\"slug\":\"{}\",\"coordinates\":{},\"states\":{states:?},\"accelerations\":{accelerations:?}}}",
            exhibit.about().slug,
            q.len()
        ));
    }
    println!("[{}]", models.join(",\n"));
    Ok(())
}
