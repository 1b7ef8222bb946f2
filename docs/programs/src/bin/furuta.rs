//! Furuta's pendulum: the results, and in how many digits other tools agree with them.

use lagrangian_guide::furuta::results;

/// What the programs in `peers/` printed.
const PEERS: [(&str, &str); 3] = [
    ("SymPy", include_str!("../../peers/furuta_sympy.txt")),
    ("heyoka", include_str!("../../peers/furuta_heyoka.txt")),
    ("CasADi", include_str!("../../peers/furuta_casadi.txt")),
];

/// The numbers after a name.
fn numbers(text: &str, name: &str) -> Vec<f64> {
    let lines = text.lines().map(|line| line.split(' '));
    let named = lines.filter(|words| words.clone().next() == Some(name));
    let words = named.flat_map(|words| words.skip(1));
    words.filter_map(|word| word.parse().ok()).collect()
}

/// The largest difference, relative to the largest number.
fn difference(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    let largest = |numbers: &mut dyn Iterator<Item = f64>| numbers.fold(0.0, f64::max);
    let scale = largest(&mut ours.iter().map(|x| x.abs()));
    largest(&mut ours.iter().zip(theirs).map(|(x, y)| (x - y).abs())) / scale
}

/// The numbers of a vector.
fn line<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> String {
    let words: Vec<String> = numbers.into_iter().map(|x| format!("{x:14.9}")).collect();
    words.join(" ")
}

/// The least of some bounds.
fn bound(difference: f64) -> &'static str {
    match difference {
        d if d < 1e-12 => "<1e-12",
        d if d < 1e-9 => "<1e-9",
        d if d < 1e-6 => "<1e-6",
        _ => "large",
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let found = results()?;
    println!("motor off at   {:.9} s", found.switch);
    println!("state at 10 s  {}", line(&found.end));
    for row in found.a.row_iter() {
        println!("A              {}", line(row.iter()));
    }
    println!("B              {}", line(&found.b));
    println!("K              {}", line(&found.k));
    println!();
    let a = found.a.transpose();
    let values = [
        ("switch", &[found.switch][..]),
        ("end", found.end.as_slice()),
        ("a", a.as_slice()),
        ("b", found.b.as_slice()),
        ("k", found.k.as_slice()),
    ];
    println!("difference     motor off  state at 10 s  A       B       K");
    for (peer, text) in PEERS {
        let bounds = values.map(|(name, ours)| bound(difference(ours, &numbers(text, name))));
        let [switch, end, a, b, k] = bounds;
        println!("{peer:14} {switch:10} {end:14} {a:7} {b:7} {k}");
    }
    Ok(())
}
