//! The declarations of the whole workspace: in sources, in documentation and in pages.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A declaration and where it is.
pub(super) struct Found {
    pub(super) place: String,
    pub(super) declaration: TokenStream,
}

/// All declarations that stand in files as they are derived; those that macros make from arguments are not there.
pub(super) fn declarations() -> Vec<Found> {
    declarations_below("")
}

/// Those in a folder of the workspace.
pub(super) fn declarations_below(folder: &str) -> Vec<Found> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    collect(&root.join(folder), &mut files);
    files.sort();
    let mut found = Vec::new();
    for file in files {
        let Ok(text) = fs::read_to_string(&file) else {
            continue;
        };
        let place = file.strip_prefix(&root).unwrap_or(&file);
        let place = place.display().to_string();
        let is_source = file.extension().is_some_and(|extension| extension == "rs");
        let whole = is_source.then(|| text.clone());
        // Most files have no declaration, and it takes long to parse them.
        let codes = whole.into_iter().chain(code_blocks(&text));
        for code in codes.filter(|code| code.contains("[lagrangian(")) {
            if let Ok(tokens) = code.parse::<TokenStream>() {
                structs(tokens, &place, &mut found);
            }
        }
    }
    found
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.unwrap_or_default();
        if path.is_dir() {
            if !name.starts_with('.') && name != "target" {
                collect(&path, files);
            }
        } else if path
            .extension()
            .is_some_and(|extension| extension == "rs" || extension == "md")
        {
            files.push(path);
        }
    }
}

/// Blocks of Rust in documentation or on a page.
fn code_blocks(text: &str) -> Vec<String> {
    let mut blocks = Vec::new();
    let mut block: Option<String> = None;
    for line in text.lines() {
        let line = line.trim_start();
        let line = ["///", "//!"]
            .iter()
            .find_map(|comment| line.strip_prefix(comment))
            .unwrap_or(line);
        let line = line.trim_start();
        if line.starts_with("```") {
            match block.take() {
                Some(whole) => blocks.push(whole),
                None => block = Some(String::new()),
            }
        } else if let Some(block) = &mut block {
            let shown = line.strip_prefix("# ").unwrap_or(line);
            block.push_str(shown);
            block.push('\n');
        }
    }
    blocks
}

/// The structs that derive `Lagrangian`, or would if they were not in a file of their own, wherever they stand among the tokens.
fn structs(tokens: TokenStream, place: &str, found: &mut Vec<Found>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut position = 0;
    while position < trees.len() {
        if let Some(end) = item(&trees[position..]) {
            let item = &trees[position..position + end];
            if is_derived(item) && !has_dollar(item) {
                found.push(Found {
                    place: place.to_owned(),
                    declaration: item.iter().cloned().collect(),
                });
            }
            position += end;
            continue;
        }
        if let TokenTree::Group(group) = &trees[position] {
            structs(group.stream(), place, found);
        }
        position += 1;
    }
}

/// How many tokens a struct has that begins here with its attributes.
fn item(trees: &[TokenTree]) -> Option<usize> {
    let mut position = 0;
    while is_punct(trees.get(position)?, '#') {
        let Some(TokenTree::Group(_)) = trees.get(position + 1) else {
            return None;
        };
        position += 2;
    }
    if position == 0 {
        return None;
    }
    let keyword = trees[position..].iter().take(3);
    let keyword = keyword
        .enumerate()
        .find(|(_, tree)| matches!(tree, TokenTree::Ident(ident) if ident == "struct"));
    position += keyword?.0;
    let rest = &trees[position..];
    let end = rest.iter().position(|tree| match tree {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        other => is_punct(other, ';'),
    });
    Some(position + end? + 1)
}

fn is_punct(tree: &TokenTree, c: char) -> bool {
    matches!(tree, TokenTree::Punct(punct) if punct.as_char() == c)
}

fn is_derived(item: &[TokenTree]) -> bool {
    item.iter().any(|tree| {
        let TokenTree::Group(group) = tree else {
            return false;
        };
        let text = group.stream().to_string();
        text.starts_with("lagrangian") || text.starts_with("derive") && text.contains("Lagrangian")
    })
}

fn has_dollar(trees: &[TokenTree]) -> bool {
    trees.iter().any(|tree| match tree {
        TokenTree::Group(group) => has_dollar(&group.stream().into_iter().collect::<Vec<_>>()),
        other => is_punct(other, '$'),
    })
}
