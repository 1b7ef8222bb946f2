//! The equations of models in print, read back line by line: energies and momenta have the values of their expressions,
//! and the equations of motion hold for the accelerations that are solved for.

use std::collections::BTreeMap;

use lagrangian_symbolic::{
    Declared, Energies, Equations, Expression, Kinetics, Listing, Model, Names, Symbol,
};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::reader::Reader;
use lagrangian_symbolic_testing::systems::{self, Chain, Spelling};
use lagrangian_symbolic_testing::{Draft, Quantity};

const COORDINATES: [&str; 5] = ["x", "y", "z", "r", "s"];
const PARAMETERS: [&str; 8] = ["a", "b", "c", "d", "e", "f", "g", "s"];

/// A listing, and what its symbols are worth.
struct Page {
    model: Model,
    equations: Equations,
    kinetics: Kinetics,
    listing: Listing,
}

impl Page {
    fn of(mut model: Model, definitions: &[(&str, Expression)]) -> Self {
        let equations = Equations::derive(&mut model).expect("there are equations of motion");
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let solved = kinetics.solved_form(&mut model, &equations);
        let coordinates = &COORDINATES[..model.coordinates as usize];
        let declared = Declared {
            names: Names {
                coordinates: coordinates.iter().map(ToString::to_string).collect(),
                parameters: PARAMETERS.map(String::from).into(),
                ..Names::default()
            },
            definitions: definitions
                .iter()
                .map(|(name, x)| ((*name).to_owned(), *x))
                .collect(),
            ..Declared::default()
        };
        let listing = Listing::of(&mut model, &equations, &solved, &declared);
        Self {
            model,
            equations,
            kinetics,
            listing,
        }
    }

    /// The state at a time s after a moment, when velocities and accelerations are constant in turn.
    fn at(s: f64, accelerations: &[f64]) -> impl Fn(Symbol) -> f64 {
        let position = |i: u32| 0.9 - 0.35 * f64::from(i);
        let velocity = |i: u32| 0.7 + 0.45 * f64::from(i);
        let accelerations = accelerations.to_vec();
        move |symbol| match symbol {
            Symbol::Coordinate(i) => position(i) + velocity(i) * s,
            Symbol::Velocity(i) => {
                velocity(i) + accelerations.get(i as usize).map_or(0.0, |a| a * s)
            }
            Symbol::Acceleration(i) => accelerations[i as usize],
            Symbol::Parameter(i) => 1.3 + 0.37 * f64::from(i),
            Symbol::Time => 0.4 + s,
            Symbol::Input(_) => 0.6,
            _ => panic!("{symbol:?}"),
        }
    }

    fn accelerations(&self) -> Vec<f64> {
        let solution = self
            .kinetics
            .solution
            .as_ref()
            .expect("they are solved for");
        let at = Self::at(0.0, &[]);
        self.model.graph.evaluate(&solution.accelerations, at)
    }

    /// Reads all lines in both notations and says how many equations of motion were compared.
    fn check(&self) -> usize {
        let unicode = self.listing.unicode.lines();
        let unicode = unicode.filter(|line| !line.ends_with(':'));
        let unicode: Vec<_> = unicode.filter_map(|line| line.split_once(" = ")).collect();
        // Rows that go on in the next one are aligned at their beginning.
        let latex = self.listing.latex.replace(" \\\\\n&\\quad ", " ");
        let latex = latex.replace(" \\\\\n", "\n");
        let latex = latex
            .replace("\\bigl", "\\left")
            .replace("\\bigr", "\\right");
        let latex: Vec<_> = latex
            .lines()
            .filter_map(|line| match line.strip_prefix('&') {
                Some(line) => line.split_once(" = "),
                None => line.split_once(" &= "),
            })
            .collect();
        assert_eq!(unicode.len(), latex.len(), "{}", self.listing.unicode);
        let [compared, again] = [unicode, latex].map(|lines| self.check_lines(&lines));
        assert_eq!(compared, again);
        compared
    }

    fn check_lines(&self, lines: &[(&str, &str)]) -> usize {
        let accelerations = self.accelerations();
        let mut definitions: BTreeMap<String, String> = BTreeMap::new();
        let mut compared = 0;
        for (left, right) in lines {
            let value = |text: &str| self.value(text, 0.0, &accelerations, &definitions);
            let plain = left.replace(['{', '}'], "");
            let expected = match (&*plain, self.model.energies) {
                ("q", _) => continue,
                ("T", Energies::Natural { kinetic, .. }) => Some(kinetic),
                ("V", Energies::Natural { potential, .. }) => Some(potential),
                ("L", _) => Some(self.equations.lagrangian),
                ("h", _) if *right != "T + V" => Some(self.equations.energy),
                ("h", Energies::Natural { kinetic, potential }) => {
                    let roots = [self.equations.energy, kinetic, potential];
                    let at = Self::at(0.0, &accelerations);
                    let values = self.model.graph.evaluate(&roots, at);
                    assert_near(values[1] + values[2], values[0], 1e-12, right);
                    continue;
                }
                ("dh/dt" | "\\fracdhdt", _) => {
                    assert_near(
                        value(right),
                        self.rate_of_energy(&accelerations),
                        1e-7,
                        right,
                    );
                    compared += 1;
                    continue;
                }
                _ => plain.strip_prefix("p_").map(|name| {
                    let i = COORDINATES.iter().position(|x| *x == name);
                    self.equations.momenta[i.expect("a coordinate")]
                }),
            };
            if let Some(expected) = expected {
                let expected = self
                    .model
                    .graph
                    .evaluate(&[expected], Self::at(0.0, &accelerations));
                assert_near(value(right), expected[0], 1e-12, right);
            } else if is_definition(&plain) {
                definitions.insert(plain, (*right).to_owned());
            } else {
                assert_near(
                    value(left),
                    value(right),
                    1e-7,
                    &format!("{left} = {right}"),
                );
                compared += 1;
            }
        }
        compared
    }

    /// dh/dt by central differences along the motion.
    fn rate_of_energy(&self, accelerations: &[f64]) -> f64 {
        let step = 1e-5;
        let [before, after] = [-step, step].map(|s| {
            let at = Self::at(s, accelerations);
            self.model.graph.evaluate(&[self.equations.energy], at)[0]
        });
        (after - before) / (2.0 * step)
    }

    /// The value of a formula at a time s; that of a rate by central differences of what is defined.
    fn value(
        &self,
        text: &str,
        s: f64,
        accelerations: &[f64],
        definitions: &BTreeMap<String, String>,
    ) -> f64 {
        let at = Self::at(s, accelerations);
        let symbols =
            |name: &str| Bounded::exact(self.symbol(name, s, accelerations, definitions, &at));
        Reader::read(text, &symbols).value
    }

    fn symbol(
        &self,
        name: &str,
        s: f64,
        accelerations: &[f64],
        definitions: &BTreeMap<String, String>,
        at: &dyn Fn(Symbol) -> f64,
    ) -> f64 {
        let letter = name
            .replace("ddot ", "")
            .replace("dot ", "")
            .replace(['\u{307}', '\u{308}'], "");
        let dots = match name {
            _ if name.contains('\u{308}') || name.starts_with("ddot") => 2,
            _ if name.contains('\u{307}') || name.starts_with("dot") => 1,
            _ => 0,
        };
        let place = |list: &[&str]| {
            let place = list.iter().position(|x| *x == letter)?;
            u32::try_from(place).ok()
        };
        if let Some(i) = place(&COORDINATES) {
            return at([Symbol::Coordinate, Symbol::Velocity, Symbol::Acceleration][dots](i));
        }
        if let Some(i) = place(&PARAMETERS) {
            return at(Symbol::Parameter(i));
        }
        let digits = letter.trim_start_matches(['p', '_']);
        let digits = digits.chars().map(|c| match c {
            '₀'..='₉' => char::from_digit(c as u32 - '₀' as u32, 10).unwrap_or(c),
            _ => c,
        });
        if let ("p", Ok(number)) = (
            letter.get(..1).unwrap_or(""),
            digits.collect::<String>().parse::<u32>(),
        ) {
            return at(Symbol::Parameter(number - 1));
        }
        match &*letter {
            "t" => return at(Symbol::Time),
            "u₁" | "u_1" => return at(Symbol::Input(0)),
            _ => {}
        }
        let body = definitions
            .get(&letter)
            .unwrap_or_else(|| panic!("{name} is not defined before it is used"));
        let step = 1e-5;
        if dots == 0 {
            self.value(body, s, accelerations, definitions)
        } else {
            let [before, after] =
                [-step, step].map(|step| self.value(body, s + step, accelerations, definitions));
            (after - before) / (2.0 * step)
        }
    }
}

/// Whether this is the name of a quasi-velocity.
fn is_definition(left: &str) -> bool {
    let is_name = ["w", "ω", "\\omega"]
        .iter()
        .any(|name| left.starts_with(name));
    is_name && !left.contains([' ', '\u{307}'])
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64, line: &str) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error <= tolerance, "{found} in place of {expected}: {line}");
}

#[test]
fn equations_of_tops_hold_as_they_are_printed() {
    for inertias in [[0, 1, 2], [0, 0, 1]] {
        for rates in [
            systems::euler_rates,
            systems::cardan_rates,
            systems::node_rates,
        ] {
            let page = Page::of(systems::top(rates, inertias), &[]);
            assert!(page.check() >= 3, "{}", page.listing.unicode);
        }
    }
    let page = Page::of(systems::general_top(Spelling::Squares), &[]);
    assert!(page.check() >= 6, "{}", page.listing.unicode);
}

#[test]
fn equations_of_other_systems_hold_as_they_are_printed() {
    for (model, equations) in [
        (systems::driven_pendulum(), 1),
        (systems::cart_pole(), 2),
        (systems::polar(), 2),
        (systems::charged(), 2),
        (Chain::of(2).model(), 2),
        (Chain::of(3).model(), 2),
    ] {
        let page = Page::of(model, &[]);
        let compared = page.check();
        assert!(
            compared >= equations,
            "{compared}: {}",
            page.listing.unicode
        );
    }
}

#[test]
fn the_energy_function_is_listed_with_its_rate() {
    let sentence = "h is constant.";
    let has = |page: &Page, line: &str| page.listing.unicode.lines().any(|found| found == line);
    let top = Page::of(systems::general_top(Spelling::Squares), &[]);
    assert!(has(&top, "h = T + V") && has(&top, sentence));
    // A force that an input sets does work; a driven support changes L.
    let page = Page::of(systems::cart_pole(), &[]);
    assert!(has(&page, "h = T + V") && !has(&page, sentence));
    let page = Page::of(systems::driven_pendulum(), &[]);
    assert!(!has(&page, sentence), "{}", page.listing.unicode);
    assert!(
        page.listing.unicode.contains("\ndh/dt = "),
        "{}",
        page.listing.unicode
    );
    // Of a charge in a field, V has terms with velocities, which are not in h.
    let page = Page::of(systems::charged(), &[]);
    assert!(!has(&page, "h = T + V") && page.listing.unicode.contains("\nh = "));
    page.check();
}

/// The listing of a chain of links with masses and lengths of their own.
fn chain(chain: Chain) -> String {
    let links = chain.links;
    let mut model = chain.model();
    let equations = Equations::derive(&mut model).expect("there are equations of motion");
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    let solved = kinetics.solved_form(&mut model, &equations);
    let own = (0..links).flat_map(|i| [format!("m[{i}]"), format!("l[{i}]")]);
    let others = (2 * links..100).map(|i| format!("other{i}"));
    let parameters = own.chain(others);
    let parameters = parameters.chain(["g", "a", "w"].map(String::from));
    let declared = Declared {
        names: Names {
            coordinates: (0..links).map(|i| format!("theta[{i}]")).collect(),
            parameters: parameters.collect(),
            ..Names::default()
        },
        ..Declared::default()
    };
    Listing::of(&mut model, &equations, &solved, &declared).unicode
}

#[test]
fn equations_of_a_chain_are_one() {
    let different = |links| Chain {
        different: true,
        ..Chain::of(links)
    };
    let page = chain(different(12));
    let inertial =
        "Σⱼ₌₀¹¹ lᵢ lⱼ (Σ_(k=max(i,j))^(11) mₖ) (θ\u{308}ⱼ cos(θᵢ − θⱼ) + θ\u{307}ⱼ² sin(θᵢ − θⱼ))";
    let weight = "lᵢ g (Σₖ₌ᵢ¹¹ mₖ) sin θᵢ";
    let line = format!("\n{inertial} + {weight} = 0  (i = 0, …, 11)\n");
    assert!(page.contains(&line), "{page}");
    let momenta =
        "p_θᵢ = Σⱼ₌₀¹¹ lᵢ lⱼ θ\u{307}ⱼ (Σ_(k=max(i,j))^(11) mₖ) cos(θᵢ − θⱼ)  (i = 0, …, 11)";
    assert!(page.contains(momenta), "{page}");
    // Where the pivot moves, too.
    let driven = Chain {
        driven: true,
        ..different(12)
    };
    let page = chain(driven);
    assert!(
        page.contains(inertial) && page.contains("= 0  (i = 0, …, 11)"),
        "{page}"
    );
    // In angles from link to link there is no such pattern.
    let relative = Chain {
        relative: true,
        ..different(12)
    };
    let page = chain(relative);
    assert!(!page.contains("Σⱼ₌₀¹¹ l"), "{page}");
}

#[test]
fn eulers_equations_are_in_terms_of_the_declared_angular_velocity() {
    let draft = Draft::new(3);
    let rates = systems::euler_rates(&draft);
    let kinetic = systems::kinetic(&draft, &rates, &[0, 1, 2]);
    let potential = draft.p(3) * draft.q(1).cos();
    let rates = rates.map(Quantity::expression);
    let names = ["omega_1", "omega_2", "omega_3"];
    let definitions: Vec<_> = names.into_iter().zip(rates).collect();
    let page = Page::of(draft.natural(kinetic, potential), &definitions);
    assert!(page.check() >= 9, "{}", page.listing.unicode);
    for line in [
        "a ω\u{307}₁ = (b − c) ω₂ ω₃ + d sin y cos z",
        "b ω\u{307}₂ = (c − a) ω₁ ω₃ − d sin y sin z",
        "c ω\u{307}₃ = (a − b) ω₁ ω₂",
        "y\u{307} = ω₁ cos z − ω₂ sin z",
    ] {
        assert!(
            page.listing.unicode.contains(&format!("\n{line}\n")),
            "{}",
            page.listing.unicode
        );
    }
}
