//! The families among coordinates, parameters, inputs and multipliers: their members have an index.

use std::collections::{BTreeMap, BTreeSet};

use crate::print::names::Names;
use crate::{Expression, Graph, Node, Symbol};

/// The members of families among coordinates, parameters, inputs and multipliers, which are accelerations of further coordinates.
pub(crate) struct Families {
    /// How many coordinates there are.
    coordinates: u32,
    /// Of each family the member at an index.
    members: Vec<BTreeMap<i64, Symbol>>,
    /// The family and the index of a member.
    places: BTreeMap<Symbol, (usize, i64)>,
    /// Symbols with several indices.
    with_several_indices: BTreeSet<Symbol>,
}

impl Families {
    pub(crate) fn of(names: &Names) -> Self {
        let coordinates = u32::try_from(names.coordinates.len()).unwrap_or(u32::MAX);
        let mut families = Self {
            coordinates,
            members: Vec::new(),
            places: BTreeMap::new(),
            with_several_indices: BTreeSet::new(),
        };
        let mut numbers = BTreeMap::new();
        let symbols: [fn(u32) -> Symbol; 4] = [
            Symbol::Coordinate,
            Symbol::Parameter,
            Symbol::Input,
            Symbol::Coordinate,
        ];
        let names = [
            (&names.coordinates, 0),
            (&names.parameters, 0),
            (&names.inputs, 0),
            (&names.multipliers, coordinates),
        ];
        for (kind, (symbol, (names, first))) in symbols.into_iter().zip(names).enumerate() {
            for (i, name) in (first..).zip(names) {
                let Some((stem, index, rest)) = taken_apart(name) else {
                    if name.contains('[') {
                        families.with_several_indices.insert(symbol(i));
                    }
                    continue;
                };
                let count = numbers.len();
                let family = *numbers.entry((kind, stem, rest)).or_insert(count);
                families.members.resize(numbers.len(), BTreeMap::new());
                families.members[family].insert(index, symbol(i));
                families.places.insert(symbol(i), (family, index));
            }
        }
        families
    }

    /// The longest run of coordinates that are members of one family and counted without gaps: the place of the first one,
    /// and the first and the last index.
    pub(crate) fn longest_run(&self, coordinates: u32) -> Option<(usize, [i64; 2])> {
        let mut longest: Option<(usize, [i64; 2])> = None;
        let mut place = 0;
        while place < coordinates {
            let run = self.run(place, coordinates);
            let count = |run: &[i64; 2]| run[1] - run[0];
            if let Some(run) = run {
                if longest.is_none_or(|(_, before)| count(&run) > count(&before)) {
                    longest = Some((place as usize, run));
                }
                place += u32::try_from(count(&run)).unwrap_or(0);
            }
            place += 1;
        }
        longest
    }

    /// The first and the last index of the members of a family that begin at a place.
    fn run(&self, place: u32, coordinates: u32) -> Option<[i64; 2]> {
        let (family, first) = *self.places.get(&Symbol::Coordinate(place))?;
        let in_order = (first..).zip(place..coordinates);
        let in_order = in_order
            .take_while(|(index, i)| self.member(family, *index) == Some(Symbol::Coordinate(*i)));
        let (last, _) = in_order.last()?;
        Some([first, last])
    }

    /// The symbol of another member, or the same one if it is of none that moves.
    pub(crate) fn moved(&self, symbol: Symbol, moves: &[(i64, i64)]) -> Option<Symbol> {
        let Some((family, index)) = self.place(symbol) else {
            return Some(symbol);
        };
        let back: fn(u32) -> Symbol = match symbol {
            Symbol::Velocity(_) => Symbol::Velocity,
            Symbol::Acceleration(_) => Symbol::Acceleration,
            Symbol::Parameter(_) => Symbol::Parameter,
            Symbol::Input(_) => Symbol::Input,
            _ => Symbol::Coordinate,
        };
        let Some((_, to)) = moves.iter().find(|(from, _)| *from == index) else {
            return Some(symbol);
        };
        match self.members[family].get(to)? {
            Symbol::Coordinate(i) | Symbol::Parameter(i) | Symbol::Input(i) => Some(back(*i)),
            _ => None,
        }
    }

    /// The family and the index of a symbol, of a velocity or an acceleration those of the coordinate.
    pub(crate) fn place(&self, symbol: Symbol) -> Option<(usize, i64)> {
        self.places.get(&base(symbol)).copied()
    }

    /// The member of a family at an index.
    pub(crate) fn member(&self, family: usize, index: i64) -> Option<Symbol> {
        self.members[family].get(&index).copied()
    }

    /// The members of a family from one index to another.
    pub(crate) fn members(
        &self,
        family: usize,
        [first, last]: [i64; 2],
    ) -> impl Iterator<Item = Symbol> {
        let members = self.members[family].iter();
        let within = members.filter(move |(index, _)| (first..=last).contains(*index));
        within.map(|(_, member)| *member)
    }

    /// The families of coordinates of which all members are counted without gaps: the positions of these, from the first
    /// index on.
    pub(crate) fn of_coordinates(&self) -> impl Iterator<Item = (i64, Vec<usize>)> {
        self.members.iter().filter_map(|members| {
            let (first, _) = members.first_key_value()?;
            let in_order = (*first..).zip(members).map(|(expected, (index, member))| {
                let Symbol::Coordinate(i) = member else {
                    return None;
                };
                let is_coordinate = *i < self.coordinates;
                (is_coordinate && *index == expected).then_some(*i as usize)
            });
            Some((*first, in_order.collect::<Option<_>>()?))
        })
    }

    /// Whether each symbol of an expression has one index or none.
    pub(crate) fn have_single_indices(&self, graph: &Graph, x: Expression) -> bool {
        let several = &self.with_several_indices;
        let mut symbols = graph.symbols(&[x]).into_iter();
        several.is_empty() || !symbols.any(|symbol| several.contains(&base(symbol)))
    }

    /// The family, first and last index of a sum of consecutive parameters.
    pub(crate) fn range(&self, graph: &Graph, x: Expression) -> Option<(usize, i64, i64)> {
        let Node::Sum(terms) = graph.node(x) else {
            return None;
        };
        let mut indices = Vec::new();
        let mut family = None;
        for (term, coefficient) in terms {
            let Node::Symbol(symbol @ Symbol::Parameter(_)) = graph.node(*term) else {
                return None;
            };
            let (of, index) = *self.places.get(symbol)?;
            if !coefficient.is_one() || *family.get_or_insert(of) != of {
                return None;
            }
            indices.push(index);
        }
        indices.sort_unstable();
        let consecutive = indices.windows(2).all(|pair| pair[1] == pair[0] + 1);
        let (first, last) = (*indices.first()?, *indices.last()?);
        (consecutive && first < last).then_some((family?, first, last))
    }
}

/// The coordinate of a velocity or an acceleration; other symbols themselves.
const fn base(symbol: Symbol) -> Symbol {
    match symbol {
        Symbol::Velocity(i) | Symbol::Acceleration(i) => Symbol::Coordinate(i),
        other => other,
    }
}

/// `m[3]` as m, 3 and what follows, unless that is another index.
fn taken_apart(name: &str) -> Option<(&str, i64, &str)> {
    let (stem, rest) = name.split_once('[')?;
    let (index, rest) = rest.split_once(']')?;
    let single = !rest.contains('[');
    Some((stem, index.parse().ok()?, rest)).filter(|_| single)
}
