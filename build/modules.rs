//! Joins the ES modules of the page into one script for each kind of page.
//!
//! A module begins with its imports, `import { a, b } from "./x.js";` or, of the folder above, `"../x.js"`, and exports constants and functions where it
//! declares them, `export const` or `export function`. No other line of a module begins with one of these words.
//!
//! In the script each module is a function that runs once, after the modules that it imports. So a name that a module
//! does not export is its own, as it is where a browser loads the modules one by one.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Why modules cannot be joined.
#[derive(Debug, PartialEq)]
pub struct Mistake {
    file: String,
    line: usize,
    words: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{}:{}: {}", self.file, self.line, self.words)
    }
}

/// Names that a module imports from another one.
struct Import {
    from: String,
    names: Vec<String>,
    line: usize,
}

/// A module in parts.
struct Module {
    imports: Vec<Import>,
    exports: BTreeSet<String>,
    /// All lines but the imports, without the word `export`.
    body: String,
}

/// Joins modules, given as texts by the names of their files, into a script for each entry: that module with all that it
/// imports.
///
/// # Errors
/// [`Mistake`] if a module or a name is unknown or declared twice, if modules import each other in a circle, if no
/// module imports one, or if an import or an export is written in another way than this file says.
pub fn join(files: &BTreeMap<String, String>, entries: &[&str]) -> Result<Vec<String>, Mistake> {
    let mut modules = BTreeMap::new();
    for (file, text) in files {
        modules.insert(file.as_str(), Module::of(file, text)?);
    }
    let mut unused: BTreeSet<&str> = modules.keys().copied().collect();
    let mut scripts = Vec::new();
    for entry in entries {
        let mut order = Order { modules: &modules, begun: Vec::new(), done: Vec::new() };
        order.visit(entry)?;
        scripts.push(order.done.iter().map(|file| modules[file].script(file)).collect());
        unused.retain(|file| !order.done.contains(file));
    }
    match unused.first() {
        Some(file) => Err(mistake(file, 1, "no module imports this one")),
        None => Ok(scripts),
    }
}

fn mistake(file: &str, line: usize, words: impl Into<String>) -> Mistake {
    Mistake { file: file.to_owned(), line, words: words.into() }
}

/// Modules in the order in which they run: each after those that it imports.
struct Order<'a> {
    modules: &'a BTreeMap<&'a str, Module>,
    /// Modules whose imports are being visited, from the entry on.
    begun: Vec<&'a str>,
    done: Vec<&'a str>,
}

impl<'a> Order<'a> {
    fn visit(&mut self, file: &'a str) -> Result<(), Mistake> {
        if self.done.contains(&file) {
            return Ok(());
        }
        self.begun.push(file);
        for Import { from, names, line } in &self.modules[file].imports {
            let Some(module) = self.modules.get(from.as_str()) else {
                return Err(mistake(file, *line, format!("there is no module {from}")));
            };
            if let Some(name) = names.iter().find(|name| !module.exports.contains(*name)) {
                return Err(mistake(file, *line, format!("{from} exports no `{name}`")));
            }
            if let Some(start) = self.begun.iter().position(|begun| begun == from) {
                let circle = self.begun[start..].join(" imports ");
                return Err(mistake(file, *line, format!("a circle: {circle} imports {from}")));
            }
            self.visit(from)?;
        }
        self.begun.pop();
        self.done.push(file);
        Ok(())
    }
}

impl Module {
    fn of(file: &str, text: &str) -> Result<Self, Mistake> {
        let mut module = Self { imports: Vec::new(), exports: BTreeSet::new(), body: String::new() };
        let mut declared = BTreeSet::new();
        let mut lines = (1..).zip(text.lines());
        while let Some((number, line)) = lines.next() {
            let mut names = Vec::new();
            if line.starts_with("import") {
                let mut import = line.to_owned();
                while !import.ends_with(';') {
                    let Some((_, more)) = lines.next() else { break };
                    import += more;
                }
                let Some((found, from)) = parse_import(&import) else {
                    return Err(mistake(file, number, "an import is `import { a, b } from \"./x.js\";`"));
                };
                names.clone_from(&found);
                module.imports.push(Import { from, names: found, line: number });
            } else if let Some(declaration) = line.strip_prefix("export") {
                let declaration = declaration.trim_start();
                names = declared_names(declaration);
                let kind = declaration.split(' ').next().unwrap_or_default();
                if names.len() != 1 || !["const", "function"].contains(&kind) {
                    return Err(mistake(file, number, "an export is `export const a` or `export function a`"));
                }
                module.exports.extend(names.iter().cloned());
                module.body += &format!("{declaration}\n");
            } else {
                names = declared_names(line);
                module.body += &format!("{line}\n");
            }
            if let Some(name) = names.into_iter().find(|name| !declared.insert(name.clone())) {
                return Err(mistake(file, number, format!("`{name}` is declared twice")));
            }
        }
        Ok(module)
    }

    /// The module as a part of the script.
    fn script(&self, file: &str) -> String {
        let listed = |names: Vec<&str>| format!("{{ {} }}", names.join(", "));
        let imports = self.imports.iter().map(|Import { from, names, .. }| {
            let names = names.iter().map(String::as_str).collect();
            format!("const {} = {};\n", listed(names), variable(from))
        });
        let imports: String = imports.collect();
        let exports = listed(self.exports.iter().map(String::as_str).collect());
        format!("const {} = (() => {{\n{imports}{}return {exports};\n}})();\n", variable(file), self.body)
    }
}

/// The variable of the script that holds what a module exports.
fn variable(file: &str) -> String {
    format!("${}", file.trim_end_matches(".js"))
}

/// The names of an import and the file of its module.
fn parse_import(import: &str) -> Option<(Vec<String>, String)> {
    let (names, from) = import.strip_prefix("import {")?.split_once("} from \".")?;
    let from = from.strip_prefix("./").or_else(|| from.strip_prefix('/'))?;
    let names: Vec<String> = names.trim().trim_end_matches(',').split(',').map(|name| name.trim().to_owned()).collect();
    names.iter().all(|name| is_name(name)).then_some((names, from.strip_suffix("\";")?.to_owned()))
}

/// The names that a line declares for its whole module, several where it takes something apart.
fn declared_names(line: &str) -> Vec<String> {
    let Some((kind, rest)) = line.split_once(' ') else { return Vec::new() };
    if !["const", "let", "function", "class"].contains(&kind) {
        return Vec::new();
    }
    let pattern = rest.split(['=', '(', ';']).next().unwrap_or_default();
    let parts = pattern.split(['[', ']', '{', '}', ',']);
    // In `{ key: name }` the name follows its key.
    let names = parts.filter_map(|part| part.split(':').next_back()).map(str::trim);
    names.filter(|name| is_name(name)).map(str::to_owned).collect()
}

fn is_name(text: &str) -> bool {
    let is_letter = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '$';
    !text.is_empty() && text.chars().all(is_letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined(files: &[(&str, &str)]) -> Result<String, Mistake> {
        let files = files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        join(&files, &["page.js"]).map(|mut scripts| scripts.remove(0))
    }

    const A: &str = "export const a = 1;\n";
    const IMPORT_A: &str = "import { a } from \"./a.js\";\n";

    /// Modules run after those that they import, each once; `own` is in two of them.
    #[test]
    fn modules_are_joined_in_the_order_of_their_imports() {
        let a = "// First.\nconst own = 1;\nexport const a = own;\n";
        let b = [IMPORT_A, "\nconst own = a;\nexport function b() {\n  return own;\n}\nexport const c = 2;\n"].concat();
        let page = ["import {\n  b,\n  c,\n} from \"./b.js\";\n", IMPORT_A, "\nb(a, c);\n"].concat();
        let expected = r"const $a = (() => {
// First.
const own = 1;
const a = own;
return { a };
})();
const $b = (() => {
const { a } = $a;

const own = a;
function b() {
  return own;
}
const c = 2;
return { b, c };
})();
const $page = (() => {
const { b, c } = $b;
const { a } = $a;

b(a, c);
return {  };
})();
";
        assert_eq!(joined(&[("a.js", a), ("b.js", &b), ("page.js", &page)]).unwrap(), expected);
    }

    /// Each page has what it imports and nothing else; a module may be in the folder above.
    #[test]
    fn every_entry_has_its_own_script() {
        let other = "import { b } from \"../b.js\";\n\nb();\n";
        let all = [("a.js", A), ("b.js", "export const b = 2;\n"), ("page.js", IMPORT_A), ("other.js", other)];
        let files = all.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        let scripts = join(&files, &["page.js", "other.js"]).unwrap();
        let has = |script: usize, name: &str| scripts[script].contains(&format!("const ${name} ="));
        assert!(has(0, "a") && has(0, "page") && !has(0, "b") && has(1, "b") && has(1, "other") && !has(1, "a"));
        assert!(scripts[1].contains("const { b } = $b;"), "{}", scripts[1]);
    }

    #[track_caller]
    fn expect_mistake(files: &[(&str, &str)], expected: &str) {
        assert_eq!(joined(files).unwrap_err().to_string(), expected);
    }

    #[test]
    fn what_is_unknown_or_in_a_circle_or_not_imported_is_named_with_file_and_line() {
        expect_mistake(&[("page.js", IMPORT_A)], "page.js:1: there is no module a.js");
        expect_mistake(&[("a.js", "const a = 1;\n"), ("page.js", IMPORT_A)], "page.js:1: a.js exports no `a`");
        expect_mistake(&[("a.js", A), ("page.js", "run();\n")], "a.js:1: no module imports this one");
        let a = "\nimport { b } from \"./b.js\";\nexport const a = b;\n";
        let b = [IMPORT_A, "export const b = a;\n"].concat();
        let files = [("a.js", a), ("b.js", &b), ("page.js", IMPORT_A)];
        expect_mistake(&files, "b.js:1: a circle: a.js imports b.js imports a.js");
    }

    #[test]
    fn what_is_declared_twice_is_named_with_file_and_line() {
        let twice = |text: &str, expected: &str| expect_mistake(&[("a.js", A), ("page.js", text)], expected);
        twice("const a = 1;\nfunction a() {}\n", "page.js:2: `a` is declared twice");
        twice("const [, a] = x;\nlet a;\n", "page.js:2: `a` is declared twice");
        twice("const { key: a, b } = x;\nexport const key = 1;\nclass b {}\n", "page.js:3: `b` is declared twice");
        twice("import { a } from \"./a.js\";\n\nconst a = 1;\n", "page.js:3: `a` is declared twice");
        twice("import { a, a } from \"./a.js\";\n", "page.js:1: `a` is declared twice");
    }

    #[test]
    fn imports_and_exports_of_other_forms_are_refused() {
        for text in ["import a from \"./a.js\";", "import { a as b } from \"./a.js\";", "import { a } from \"./a.js\""]
        {
            let text = format!("\n{text}\n");
            expect_mistake(&[("page.js", &text)], "page.js:2: an import is `import { a, b } from \"./x.js\";`");
        }
        for text in ["export let a = 1;", "export { a };", "export default a;", "export const [a, b] = x;"] {
            expect_mistake(&[("page.js", text)], "page.js:1: an export is `export const a` or `export function a`");
        }
    }
}
