//! The statements of the recursion of Newton and Euler in print.

use std::collections::BTreeMap;

use crate::Rational;
use crate::print::index::Index;
use crate::print::names::Names;
use crate::print::notation::Notation;
use crate::print::printed::{Part, Printed};
use crate::print::spelling::Spelling;

/// What occurs in the statements: a letter for it, and how it may be called, the first that no name of the model has.
const QUANTITIES: [(char, &[&str]); 11] = [
    ('R', &["R", "A", "Q"]),
    ('D', &["s", "d", "b", "place"]),
    ('S', &["sigma", "nu", "eta", "rate"]),
    ('W', &["omega", "Omega", "w", "angular_velocity"]),
    ('A', &["a", "alpha", "acceleration"]),
    ('M', &["m", "mu", "M", "mass"]),
    ('C', &["c", "rho", "e", "center"]),
    ('I', &["I", "J", "Theta", "inertia"]),
    ('F', &["F", "K", "inertial_force"]),
    ('P', &["f", "phi", "force"]),
    ('N', &["n", "N", "tau", "moment"]),
];

const TRANSPOSED: [&str; 2] = ["ᵀ", "^{T}"];
const CROSS: [&str; 2] = [" × ", " \\times "];

/// How the quantities of links are called.
#[derive(Clone, Debug)]
pub(crate) struct LinkLetters(BTreeMap<char, Spelling>);

impl LinkLetters {
    /// Letters that no name of the model has, nor one of its definitions.
    pub(crate) fn free(names: &Names, definitions: &[(String, crate::Expression)]) -> Self {
        let defined = definitions.iter().map(|(name, _)| name.as_str());
        let printed = |name: &str| {
            let spellings = [Spelling::of(name), Spelling::of_parameter(name)];
            spellings.map(|spelling| spelling.print(Notation::Unicode))
        };
        let taken: Vec<_> = names.all().chain(defined).flat_map(printed).collect();
        let is_free = |letter: &Spelling| {
            let letter = letter.print(Notation::Unicode);
            taken.iter().all(|name| match name.strip_prefix(&*letter) {
                Some(rest) => rest.starts_with(char::is_alphabetic),
                None => true,
            })
        };
        let letters = QUANTITIES.iter().map(|(quantity, candidates)| {
            let mut spellings = candidates.iter().map(|name| Spelling::of(name));
            let last = candidates.last().copied().unwrap_or_default();
            let free = spellings.find(is_free);
            (*quantity, free.unwrap_or_else(|| Spelling::verbatim(last)))
        });
        Self(letters.collect())
    }

    /// Calls a quantity by a name of the model.
    pub(crate) fn call(&mut self, quantity: char, spelling: Spelling) {
        self.0.insert(quantity, spelling);
    }

    /// A quantity of a link, with dots above it.
    pub(crate) fn quantity(&self, quantity: char, dots: usize, link: Index) -> Printed {
        let spelling = self.0.get(&quantity).cloned();
        let spelling = spelling.unwrap_or_else(|| Spelling::verbatim(""));
        Printed(Part::Name(spelling.with_dots(dots).with_indices([link])))
    }

    /// The statements for link i, each as its left and its right side. Of a chain, the link before is i − 1 and the one behind
    /// i + 1; else these are called p and j.
    pub(crate) fn statements(&self, is_chain: bool, slides: bool) -> Vec<[Printed; 2]> {
        let link = |name: &str, offset| Index::Variable(name.to_owned(), offset);
        let (before, behind) = if is_chain {
            (link("i", -1), link("i", 1))
        } else {
            (link("p", 0), link("j", 0))
        };
        let own = |quantity, dots| self.quantity(quantity, dots, link("i", 0));
        let before = |quantity, dots| self.quantity(quantity, dots, before.clone());
        let behind = |quantity| self.quantity(quantity, 0, behind.clone());
        let cross = |x: Printed, y| x.vector_product(y, CROSS);
        let turned = |x| own('R', 0).followed_by(TRANSPOSED).times(x);
        // What moves a point that turns with a link.
        let turning = |rate: Printed, acceleration, arm: Printed| {
            let towards_axis = cross(rate.clone(), cross(rate, arm.clone()));
            [cross(acceleration, arm), towards_axis]
        };
        let of_those_behind = |x: Printed| {
            if is_chain {
                x
            } else {
                x.summed_over(["ⱼ", "j"])
            }
        };

        let rate = [turned(before('W', 0)), own('S', 0)];
        let rate_of_rate = [
            turned(before('W', 1)),
            cross(turned(before('W', 0)), own('S', 0)),
            own('S', 1),
        ];
        let moved = turning(before('W', 0), before('W', 1), own('D', 0));
        let mut acceleration = Printed::sum([before('A', 0)].into_iter().chain(moved));
        if slides {
            let two = Printed::number(&Rational::integer(2));
            let sliding = [cross(two.times(before('W', 0)), own('D', 1)), own('D', 2)];
            acceleration = Printed::sum([acceleration].into_iter().chain(sliding));
        }
        let of_center = turning(own('W', 0), own('W', 1), own('C', 0));
        let of_center = Printed::sum([own('A', 0)].into_iter().chain(of_center));
        let force = of_those_behind(behind('R').times(behind('P')));
        let lever = cross(behind('D'), behind('R').times(behind('P')));
        let moment = Printed::sum([behind('R').times(behind('N')), lever]);
        let moments = [
            own('I', 0).times(own('W', 1)),
            cross(own('W', 0), own('I', 0).times(own('W', 0))),
            cross(own('C', 0), own('F', 0)),
            of_those_behind(moment),
        ];
        vec![
            // From the root to the leaves,
            [own('W', 0), Printed::sum(rate)],
            [own('W', 1), Printed::sum(rate_of_rate)],
            [own('A', 0), turned(acceleration)],
            [own('F', 0), own('M', 0).times(of_center)],
            // and back.
            [own('P', 0), Printed::sum([own('F', 0), force])],
            [own('N', 0), Printed::sum(moments)],
        ]
    }
}
