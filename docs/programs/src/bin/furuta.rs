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

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let found = results()?;
    println!("motor off at   {:.9} s", found.switch);
    println!("state at 10 s  {:.9}", found.end.transpose());
    println!("A  {:.6}", found.a);
    println!("B  {:.6}", found.b.transpose());
    println!("K  {:.6}", found.k);
    let a = found.a.transpose();
    let values = [
        ("switch", &[found.switch][..]),
        ("end", found.end.as_slice()),
        ("a", a.as_slice()),
        ("b", found.b.as_slice()),
        ("k", found.k.as_slice()),
    ];
    for (peer, text) in PEERS {
        for (name, ours) in values {
            println!("{peer} {name} {:.1e}", difference(ours, &numbers(text, name)));
        }
    }
    Ok(())
}
