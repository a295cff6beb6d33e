//! Which file of a crate imports which: read from the words of its sources, without a compiler.
//!
//! An import is a path to an item, in a `use` or in code. It leads to two files: that of the module which the path
//! names, and through re-exports that which defines the item. A `mod` line and a re-export import nothing; what a module
//! takes from those that it lies in is left out, since a room may be told apart into files; and so are tests, which
//! stand at a file's end or in a file `tests.rs`.

use super::words::words;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::path::Path;

/// The names from the crate's root to a module.
type Module<'s> = Vec<&'s str>;

/// Files that each file imports, and by which paths. Files are named from the crate's `src` on.
#[derive(Debug, Default)]
pub struct Imports(BTreeMap<String, BTreeMap<String, BTreeSet<String>>>);

/// Files that import each other round about, with the imports between them.
pub struct Circle<'i> {
    pub files: BTreeSet<&'i str>,
    imports: &'i Imports,
}

/// What a name in a module stands for.
#[derive(Clone)]
enum Meaning<'s> {
    Module(Module<'s>),
    /// In that file.
    Item(&'s str),
    Other(Module<'s>),
}

/// Everything that the sources of a crate say about names.
#[derive(Default)]
struct Names<'s> {
    files: BTreeMap<Module<'s>, &'s str>,
    known: BTreeMap<(Module<'s>, &'s str), Meaning<'s>>,
    globs: BTreeMap<Module<'s>, Vec<Module<'s>>>,
    /// Module, file, path, and whether all of it is taken.
    paths: Vec<(Module<'s>, &'s str, Module<'s>, bool)>,
}

impl Imports {
    /// Of the crate whose sources lie in `src`.
    pub fn of(src: &Path) -> Self {
        let mut sources = Vec::new();
        gather(src, "", &mut sources);
        let mut names = Names::default();
        for (file, _) in &sources {
            names.files.insert(module_of(file), file);
        }
        for (file, text) in &sources {
            names.read(module_of(file), file, &words(text));
        }
        let mut imports = Self::default();
        for (module, file, path, takes_all) in &names.paths {
            let found = names.resolve(module, path, 0);
            let defines = match &found {
                Some(Meaning::Item(file)) => Some(*file),
                Some(Meaning::Module(all)) if *takes_all => names.file_of(all),
                _ => continue,
            };
            for to in [names.module_named(module, path), defines].into_iter().flatten() {
                imports.add(file, to, path.join("::"));
            }
        }
        imports
    }

    fn add(&mut self, from: &str, to: &str, path: String) {
        let (own, other) = (module_of(from), module_of(to));
        if from != to && !(own.starts_with(&other) && own.len() > other.len()) {
            self.0.entry(from.into()).or_default().entry(to.into()).or_default().insert(path);
        }
    }

    /// The same from room to room: a room is a folder or file at the top. What the crate's root names is left out.
    pub fn of_rooms(&self) -> Self {
        let mut rooms = Self::default();
        for (from, to, path) in self.iter() {
            let [own, other] = [from, to].map(room);
            if own != other && ![own, other].contains(&"lib") {
                rooms.0.entry(own.into()).or_default().entry(other.into()).or_default().insert(path.into());
            }
        }
        rooms
    }

    /// From file to file, with one of the paths.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str, &str)> {
        self.0.iter().flat_map(|(from, all)| {
            all.iter().filter_map(move |(to, paths)| Some((from.as_str(), to.as_str(), paths.first()?.as_str())))
        })
    }

    /// The largest first.
    pub fn circles(&self) -> Vec<Circle<'_>> {
        let reach: BTreeMap<&str, BTreeSet<&str>> =
            self.0.keys().map(|file| (file.as_str(), self.reach(file))).collect();
        let mut circles: BTreeSet<BTreeSet<&str>> = BTreeSet::new();
        for (file, reached) in &reach {
            let back = |other: &&&str| reach.get(**other).is_some_and(|from| from.contains(file));
            circles.insert(reached.iter().filter(back).copied().collect());
        }
        let mut circles: Vec<_> = circles.into_iter().filter(|files| files.len() > 1).collect();
        circles.sort_by_key(|files| std::cmp::Reverse(files.len()));
        circles.into_iter().map(|files| Circle { files, imports: self }).collect()
    }

    /// All files that `file` imports, also by way of others.
    fn reach(&self, file: &str) -> BTreeSet<&str> {
        let (mut reached, mut ahead) = (BTreeSet::new(), vec![file]);
        while let Some(from) = ahead.pop() {
            for to in self.0.get(from).into_iter().flat_map(BTreeMap::keys) {
                if reached.insert(to.as_str()) {
                    ahead.push(to);
                }
            }
        }
        reached
    }
}

impl fmt::Display for Circle<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} import each other:", self.files.len())?;
        for (from, to, path) in self.imports.iter() {
            if self.files.contains(from) && self.files.contains(to) {
                writeln!(f, "    {from} -> {to}: {path}")?;
            }
        }
        Ok(())
    }
}

fn gather(folder: &Path, inside: &str, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("a folder of sources").flatten() {
        let (path, name) = (entry.path(), format!("{inside}{}", entry.file_name().display()));
        if path.is_dir() {
            gather(&path, &format!("{name}/"), found);
        } else if name.ends_with(".rs") && name != "main.rs" && !name.ends_with("/tests.rs") {
            found.push((name, fs::read_to_string(&path).expect("a source")));
        }
    }
}

/// The room that a file lies in.
pub fn room(file: &str) -> &str {
    file.split(['/', '.']).next().unwrap_or_default()
}

fn module_of(file: &str) -> Module<'_> {
    let mut names: Module<'_> = file.trim_end_matches(".rs").split('/').collect();
    if matches!(names.last(), Some(&("mod" | "lib"))) {
        names.pop();
    }
    names
}

impl<'s> Names<'s> {
    /// Takes in what a file says. Names count where a module declares them; paths count everywhere.
    fn read(&mut self, module: Module<'s>, file: &'s str, words: &[&'s str]) {
        // Modules that are open here, with the depth of braces inside them.
        let mut open = vec![(module, 0)];
        let (mut depth, mut at) = (0, 0);
        let word = |at: usize| words.get(at).copied().unwrap_or_default();
        while at < words.len() {
            let (module, own_depth) = open.last().cloned().unwrap_or_default();
            let before = if at > 0 { word(at - 1) } else { "" };
            let is_declared = depth == own_depth && before != "::" && before != ".";
            match word(at) {
                "{" => depth += 1,
                "}" => {
                    depth -= 1;
                    if open.len() > 1 && depth < own_depth {
                        open.pop();
                    }
                }
                "mod" if is_declared => {
                    let name = word(at + 1);
                    let inner: Module<'s> = module.iter().copied().chain([name]).collect();
                    self.known.insert((module, name), Meaning::Module(inner.clone()));
                    let is_test = words[..at].ends_with(&["#", "[", "cfg", "(", "test", ")", "]"]);
                    if word(at + 2) == "{" && is_test {
                        return;
                    }
                    if word(at + 2) == "{" {
                        depth += 1;
                        open.push((inner, depth));
                    }
                    at += 2;
                }
                "use" if matches!(before, "" | "{" | "}" | ";" | "]" | ")" | "pub") => {
                    let is_public = before == "pub" || before == ")";
                    at = self.read_use(&module, file, is_public, words, at + 1, &mut Vec::new());
                }
                "fn" | "struct" | "enum" | "union" | "trait" | "type" | "const" | "static" | "macro_rules"
                    if is_declared =>
                {
                    let skipped = usize::from(matches!(word(at + 1), "!" | "mut"));
                    self.known.insert((module, word(at + 1 + skipped)), Meaning::Item(file));
                    at += skipped;
                }
                name if is_name(name) && before != "::" && word(at + 1) == "::" && is_name(word(at + 2)) => {
                    let mut path = vec![name];
                    while word(at + 1) == "::" && is_name(word(at + 2)) {
                        path.push(word(at + 2));
                        at += 2;
                    }
                    self.paths.push((module, file, path, false));
                }
                _ => {}
            }
            at += 1;
        }
    }

    /// Takes in the tree of a `use` that begins at `at`, below `path`. Where it ends.
    fn read_use(
        &mut self,
        module: &Module<'s>,
        file: &'s str,
        is_public: bool,
        words: &[&'s str],
        mut at: usize,
        path: &mut Module<'s>,
    ) -> usize {
        let depth = path.len();
        while at < words.len() {
            match words[at] {
                "{" => {
                    at += 1;
                    while words[at] != "}" {
                        at = self.read_use(module, file, is_public, words, at, path);
                        at += usize::from(words[at] == ",");
                    }
                    path.truncate(depth);
                    return at + 1;
                }
                "*" => {
                    self.globs.entry(module.clone()).or_default().push(path.clone());
                    if !is_public {
                        self.paths.push((module.clone(), file, path.clone(), true));
                    }
                    path.truncate(depth);
                    return at + 1;
                }
                "::" => {}
                // In braces: what they belong to.
                "self" if depth > 0 && path.len() == depth => {}
                name if is_name(name) && name != "as" => path.push(name),
                _ => break,
            }
            at += 1;
        }
        let mut name = path.last().copied().unwrap_or_default();
        if words.get(at) == Some(&"as") {
            name = words[at + 1];
            at += 2;
        }
        if path.len() > 1 || path.first() != Some(&name) {
            self.known.entry((module.clone(), name)).or_insert(Meaning::Other(path.clone()));
        }
        if !is_public {
            self.paths.push((module.clone(), file, path.clone(), false));
        }
        path.truncate(depth);
        at
    }

    /// Where a path leads from a module; none if out of the crate. After that many steps, names go round in circles.
    fn resolve(&self, module: &[&'s str], path: &[&'s str], steps: usize) -> Option<Meaning<'s>> {
        if steps > 20 {
            return None;
        }
        let (mut found, rest) = self.start(module, path, steps)?;
        for name in rest {
            let Meaning::Module(inside) = &found else { break };
            found = self.look_up(inside, name, steps)?;
        }
        Some(found)
    }

    /// What a path begins with, and what is left of it.
    fn start<'p>(&self, module: &[&'s str], path: &'p [&'s str], steps: usize) -> Option<(Meaning<'s>, &'p [&'s str])> {
        let (first, mut rest) = path.split_first()?;
        let mut module = module;
        match *first {
            "crate" => module = &[],
            "self" => {}
            "super" => {
                module = module.split_last()?.1;
                while let Some((&"super", after)) = rest.split_first() {
                    (module, rest) = (module.split_last()?.1, after);
                }
            }
            name => return Some((self.look_up(module, name, steps)?, rest)),
        }
        Some((Meaning::Module(module.to_vec()), rest))
    }

    fn look_up(&self, module: &[&'s str], name: &'s str, steps: usize) -> Option<Meaning<'s>> {
        match self.known.get(&(module.to_vec(), name)) {
            Some(Meaning::Other(path)) => self.resolve(module, path, steps + 1),
            Some(known) => Some(known.clone()),
            None => self.globs.get(module)?.iter().find_map(|glob| {
                let Meaning::Module(other) = self.resolve(module, glob, steps + 1)? else { return None };
                self.look_up(&other, name, steps + 1).filter(|_| other != module && steps < 20)
            }),
        }
    }

    /// The file of the innermost module that a path names on its way.
    fn module_named(&self, module: &[&'s str], path: &[&'s str]) -> Option<&'s str> {
        let (start, rest) = self.start(module, path, 0)?;
        let Meaning::Module(mut inside) = start else { return None };
        for name in rest {
            inside.push(name);
            if !self.known_module(&inside) {
                inside.pop();
                break;
            }
        }
        self.file_of(&inside)
    }

    fn known_module(&self, module: &[&'s str]) -> bool {
        module
            .split_last()
            .is_some_and(|(name, outer)| matches!(self.known.get(&(outer.to_vec(), *name)), Some(Meaning::Module(_))))
    }

    /// Of a module, or of the one that it is written in.
    fn file_of(&self, module: &[&'s str]) -> Option<&'s str> {
        (0..=module.len()).rev().find_map(|length| self.files.get(&module[..length]).copied())
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}
