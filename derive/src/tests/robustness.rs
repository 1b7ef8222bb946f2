//! No declaration makes the macro panic: declarations with tokens removed, doubled, exchanged and
//! replaced end in items, which are errors or impls.

use std::str::FromStr as _;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use crate::expand::expand;

const DECLARATION: &str = r"
    #[lagrangian(
        coordinates(x, theta, r#type, q[3], p: Vector2, b[2][2]: Vector3<f64>),
        function(stribeck(v, load) = self.label(v) * load, derivative(v) = slope(v) * load, derivative(load) = stribeck(v, 1.0)),
        function(slope(v) = { let w = v; outside::slope(w) }),
        define(
            height = l * cos(theta), speed = dot(height),
            r = rotation_zxz(q[0], q[1], q[2]), w = angular_velocity(r),
            s[0] = x, s[i] = s[i - 1] + list[i] * [q[i], 1.0][0] for i in 1..3,
        ),
        kinetic = 0.5 * m * (dot(x).powi(2) + speed.powi(2)) + dot(theta) * dot(r#type),
        kinetic = 0.5 * w.dot(inertia * w) + (0..3).map(|i| dot(s[i]).powi(2)).sum(),
        kinetic = dot(p).norm_squared() + (0..2).map(|i| (0..2).map(|j| dot(b[i][j]).norm_squared()).sum()).sum(),
        potential = -m * g * height + atan2(x, 2.0).powf(1.5) + (r * [0, 0, l]).z,
        dissipation = 0.5 * friction * dot(x).powi(2) / PI,
        force(x = push - sin(t) - stribeck(dot(x), m), theta = r#type, p.x = m, b[1][0] = [m, g, l], q[i] = -list[i] for i in 0..3),
        output(height = height, sensed = dot(dot(height)), tip = inertia[(0, 1)] * r.transpose()),
        scalar = f64,
    )]
    struct Model { m: f64, g: f64, l: f32, friction: f64, inertia: Matrix3<f64>, list: [f64; 3],
        #[lagrangian(input)] push: f64,
        #[lagrangian(skip)] label: &'static str }
";

const COUNT: usize = 400;

/// What tokens are replaced with.
const WORDS: &str = "x theta m push label dot self t PI _ r#loop r#type_dot 0 1e400 -1 2u8 \"text\" 'c' true [] () {} {x} (x) \
                     coordinates kinetic lagrangian define function derivative scalar slope output skip input crate f64 T K Scalar Vector2 SVector p b , = + ^ . :: & ; ! # |";

/// A sequence that is the same on each run.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let bound = u64::try_from(bound).unwrap_or(u64::MAX);
        usize::try_from((self.0 >> 33) % bound).unwrap_or(0)
    }
}

/// How many tokens there are, in groups and outside.
fn count(tokens: &TokenStream) -> usize {
    let inner = |token: TokenTree| match token {
        TokenTree::Group(group) => 1 + count(&group.stream()),
        _ => 1,
    };
    tokens.clone().into_iter().map(inner).sum()
}

/// The same tokens but for the one at `index`, which is altered.
fn altered(
    tokens: TokenStream,
    index: &mut usize,
    alter: &mut impl FnMut(TokenTree) -> Vec<TokenTree>,
) -> TokenStream {
    let mut result = Vec::new();
    for token in tokens {
        let here = *index == 0;
        *index = index.wrapping_sub(1);
        match token {
            token if here => result.extend(alter(token)),
            TokenTree::Group(group) => {
                let stream = altered(group.stream(), index, alter);
                result.push(Group::new(group.delimiter(), stream).into());
            }
            token => result.push(token),
        }
    }
    result.into_iter().collect()
}

fn alter_one(tokens: TokenStream, numbers: &mut Numbers, words: &[TokenTree]) -> TokenStream {
    let mut index = numbers.below(count(&tokens));
    let kind = numbers.below(5);
    let word = words[numbers.below(words.len())].clone();
    altered(tokens, &mut index, &mut |token| match (kind, token) {
        (0, _) => Vec::new(),
        (1, token) => vec![token.clone(), token],
        (2, token) => vec![token, word.clone()],
        (3, TokenTree::Group(group)) => {
            vec![Group::new(Delimiter::None, group.stream()).into()]
        }
        _ => vec![word.clone()],
    })
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn altered_declarations_end_in_items() {
    alter(COUNT);
}

#[test]
fn some_altered_declarations_end_in_items() {
    alter(COUNT / 8);
}

/// Alters the declaration so many times.
fn alter(count: usize) {
    let words: Vec<TokenTree> = TokenStream::from_str(WORDS)
        .expect("words are tokens")
        .into_iter()
        .collect();
    let declaration = TokenStream::from_str(DECLARATION).expect("the declaration is of tokens");
    let mut numbers = Numbers(1);
    let mut derived = 0;
    for _ in 0..count {
        let mut tokens = declaration.clone();
        for _ in 0..=numbers.below(3) {
            tokens = alter_one(tokens, &mut numbers, &words);
        }
        let written = tokens.to_string();
        let items = std::panic::catch_unwind(|| expand(tokens).to_string())
            .unwrap_or_else(|_| panic!("a panic on {written}"));
        let parsed = syn::parse_str::<syn::File>(&items);
        assert!(parsed.is_ok(), "no items from {written}:\n{items}");
        derived += usize::from(!items.contains("compile_error"));
    }
    // Some alterations leave a declaration that is correct, and most do not.
    assert!(
        (count / 100..count / 2).contains(&derived),
        "{derived} of {count}"
    );
}

/// The expansion of a declaration with this potential, with the stack that the compiler has.
fn expansion_with(potential: &str) -> String {
    let declaration = format!(
        "#[lagrangian(coordinates(q), kinetic = 0.5 * m * dot(q).powi(2), potential = {potential})]
         struct Model {{ m: f64 }}"
    );
    let expansion = move || {
        let tokens = TokenStream::from_str(&declaration).expect("tokens");
        expand(tokens).to_string()
    };
    let thread = std::thread::Builder::new().stack_size(8 << 20);
    let thread = thread.spawn(expansion).expect("a thread");
    thread.join().expect("no panic")
}

#[test]
fn what_is_too_deep_for_the_stack_is_refused_and_no_more() {
    let nested = |depth: usize| "(".repeat(depth) + "q" + &")".repeat(depth);
    let repeated = |part: &str, times: usize| "q".to_owned() + &part.repeat(times);
    let negated = |times: usize| "- ".repeat(times) + "q";
    for (within, beyond) in [
        (nested(200), nested(5000)),
        (repeated(" + q", 4000), repeated(" + q", 50_000)),
        (repeated(" * q", 4000), repeated(" * q", 50_000)),
        (repeated(".sin()", 1000), repeated(".sin()", 10_000)),
        (negated(200), negated(50_000)),
    ] {
        let expansion = expansion_with(&within);
        assert!(!expansion.contains("compile_error"), "{expansion:.300}");
        let expansion = expansion_with(&beyond);
        assert!(expansion.contains("compile_error"));
        assert!(expansion.contains("under `define`"), "{expansion:.300}");
    }
}
