//! The operations of the declarations of the repository, method by method, in `derive/operations.txt`.
//!
//! The difference of this table shows what a change of the derivation costs. The test fails if the count of a method differs
//! from the table, or if a declaration of the table is missing; new declarations are not compared. It prints what differs, and
//! the sums of all counts. To write the table anew, run
//!
//! ```text
//! OPERATIONS=overwrite cargo test -p lagrangian-derive operations -- --ignored --nocapture
//! ```
//!
//! `series` counts the operations of one order of the Taylor series without the products of its `convolutions`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{env, fmt::Write as _, fs};

use quote::ToTokens as _;
use syn::{DeriveInput, Item, ItemStruct, Stmt};

use crate::check::check;
use crate::derived::Derived;
use crate::diagnostics::Diagnostics;
use crate::limits::MethodLimits;
use crate::lower::lower;
use crate::reduce::{ReducedDeclaration, Split, reduce};
use crate::syntax::declaration::Declaration;

const TABLE: &str = "operations.txt";

const LIMITS: MethodLimits = MethodLimits::OF_EXPANSIONS;

/// The folders with declarations of models; declarations with mistakes are in others.
pub(super) const FOLDERS: [&str; 9] = [
    "bench/models",
    "derive/golden",
    "ensembles",
    "examples",
    "models",
    "runtime/src",
    "runtime/tests",
    "tests/src",
    "tests/tests",
];

/// The operations of the methods of each declaration.
type Table = BTreeMap<String, BTreeMap<String, usize>>;

#[test]
#[ignore = "for changes of the derivation: it derives all models of the repository"]
fn operations_of_all_declarations_are_those_of_the_table() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut table = Table::new();
    for (name, declaration) in declarations(repository, &FOLDERS) {
        let all = operations(declaration).unwrap_or_default().into_iter();
        let names = [name.clone(), format!("{name}/reduced")];
        table.extend(names.into_iter().zip(all));
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(TABLE);
    let committed = fs::read_to_string(&path).unwrap_or_default();
    let changed = compare(&read(&committed), &table);
    if env::var("OPERATIONS").as_deref() == Ok("overwrite") {
        fs::write(&path, written(&table)).unwrap();
        return;
    }
    assert!(
        changed == 0,
        "{changed} differences from {TABLE}: see {}",
        file!()
    );
}

/// The declarations of some folders, each with a name of its own.
pub(super) fn declarations(repository: &Path, folders: &[&str]) -> Vec<(String, ItemStruct)> {
    let mut declarations: Vec<(String, ItemStruct)> = Vec::new();
    let mut taken = BTreeSet::new();
    for file in folders
        .iter()
        .flat_map(|folder| files(&repository.join(folder)))
    {
        let name = file.strip_prefix(repository).unwrap().display().to_string();
        let source = fs::read_to_string(&file).unwrap();
        let mut structs = Vec::new();
        collect(&syn::parse_file(&source).unwrap().items, &mut structs);
        for declaration in structs {
            let ident = declaration.ident.to_string();
            let mut names = (1..).map(|k| match k {
                1 => format!("{name} {ident}"),
                k => format!("{name} {ident}#{k}"),
            });
            let name = names.find(|name| taken.insert(name.clone())).unwrap();
            declarations.push((name, declaration));
        }
    }
    declarations
}

/// The Rust files of a folder, in order.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<_> = fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .collect();
    entries.sort();
    let files = entries.into_iter().flat_map(|path| {
        if path.is_dir() {
            files(&path)
        } else {
            vec![path]
        }
    });
    files
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

/// The declarations among items, in modules and in the bodies of functions, too.
fn collect(items: &[Item], structs: &mut Vec<ItemStruct>) {
    for item in items {
        match item {
            Item::Struct(item) if item.attrs.iter().any(|it| it.path().is_ident("lagrangian")) => {
                structs.push(item.clone());
            }
            Item::Mod(module) => {
                let items = module.content.as_ref().map(|(_, items)| items.as_slice());
                collect(items.unwrap_or_default(), structs);
            }
            Item::Fn(function) => {
                let statements = function.block.stmts.iter();
                let items = statements.filter_map(|statement| match statement {
                    Stmt::Item(item) => Some(item.clone()),
                    _ => None,
                });
                collect(&items.collect::<Vec<_>>(), structs);
            }
            _ => (),
        }
    }
}

/// The operations of the methods of a declaration, and of its reduced model, if it has one; `None` if there is an error.
fn operations(declaration: ItemStruct) -> Option<Vec<BTreeMap<String, usize>>> {
    let input: DeriveInput = syn::parse2(declaration.into_token_stream()).unwrap();
    let mut diagnostics = Diagnostics::default();
    let declaration = Declaration::parse(input, &mut diagnostics);
    check(&declaration, &mut diagnostics);
    let mut lowered = lower(&declaration, &mut diagnostics);
    let model = lowered.model.take().filter(|_| diagnostics.is_empty())?;
    let derived = Derived::of(&declaration, &lowered, model, LIMITS, &mut diagnostics)?;
    let mut all = vec![counts(&derived)];
    if let Some(clause) = &declaration.clauses.routhian {
        let full = derived.emitter(&declaration, &lowered, LIMITS);
        let split = Split::of(full.equations, full.model.coordinates as usize);
        let reduced = ReducedDeclaration::of(&declaration, &lowered, split, clause);
        let (declared, model) = ((&declaration, &lowered), (full.model, full.equations));
        let reduction = reduce(declared, model, clause, &reduced, &mut diagnostics)?;
        let (declaration, lowered) = (&reduced.declaration, &reduced.lowered);
        let derived = Derived::of(
            declaration,
            lowered,
            reduction.model,
            LIMITS,
            &mut diagnostics,
        )?;
        all.push(counts(&derived));
    }
    Some(all)
}

/// The operations of each method that has some.
fn counts(derived: &Derived) -> BTreeMap<String, usize> {
    let counted = derived.methods.counted();
    let counted = counted.filter_map(|(method, found)| Some((method, found?.count.total())));
    let mut counts: BTreeMap<_, _> = counted
        .map(|(method, count)| (method.to_owned(), count))
        .collect();
    if let Some(series) = &derived.series {
        let program = &series.motion.program;
        counts.insert("series".to_owned(), program.recurrence.count().total());
        counts.insert("convolutions".to_owned(), program.convolutions.len());
    }
    counts.retain(|_, count| *count > 0);
    counts
}

fn written(table: &Table) -> String {
    let mut text = String::new();
    for (declaration, operations) in table {
        text.push_str(declaration);
        for (method, count) in operations {
            write!(text, " {method}={count}").unwrap();
        }
        text.push('\n');
    }
    text
}

fn read(text: &str) -> Table {
    let lines = text.lines().map(|line| {
        let words: Vec<_> = line.split(' ').collect();
        let (declaration, operations) = words.split_at(words.len().min(2));
        let operations = operations.iter().filter_map(|word| word.split_once('='));
        let operations =
            operations.map(|(method, count)| (method.to_owned(), count.parse().unwrap()));
        (declaration.join(" "), operations.collect())
    });
    lines.collect()
}

/// Prints how the operations of the declarations of the table differ, and returns the number of differences.
fn compare(before: &Table, now: &Table) -> usize {
    println!("{} declarations, {} in the table", now.len(), before.len());
    let (mut sum_before, mut sum_now, mut changed) = (0, 0, 0);
    for declaration in before.keys().filter(|name| !now.contains_key(*name)) {
        changed += 1;
        println!("{declaration}: missing");
    }
    for (declaration, now) in now {
        let Some(before) = before.get(declaration) else {
            continue;
        };
        sum_before += before.values().sum::<usize>();
        sum_now += now.values().sum::<usize>();
        let methods: BTreeSet<_> = before.keys().chain(now.keys()).collect();
        for method in methods {
            let [before, now] = [before, now].map(|of| of.get(method).copied().unwrap_or(0));
            if before != now {
                changed += 1;
                println!("{declaration}, {method}: {now}, {before} in the table");
            }
        }
    }
    println!("operations: {sum_now}, {sum_before} in the table");
    changed
}
