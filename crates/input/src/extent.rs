//! How much a file may hold. Its parts are counted before they are parsed.

use toml_parser::Source;
use toml_parser::lexer::TokenKind;

use super::error::Fault;

/// Most keys, tables and lists of a file, every part of a dotted key counted. The largest files that make sense have
/// long lists of numbers, but few lists.
const MOST_PARTS: usize = 20_000;

/// Checks that a text does not hold so many parts that parsing them takes much memory: the two bytes of `a.` can become
/// a table of a kilobyte.
///
/// The count looks at brackets, dots and signs alone, not at the grammar. It may count a little too much (the dot of a
/// number before a bracket), never too little.
pub(super) fn check(text: &str) -> Result<(), Fault> {
    let (mut parts, mut dots) = (0, 0);
    for token in Source::new(text).lex() {
        match token.kind() {
            TokenKind::Dot => dots += 1,
            TokenKind::Equals | TokenKind::RightSquareBracket => parts += 1 + std::mem::take(&mut dots),
            TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => parts += 1,
            TokenKind::Comma | TokenKind::Newline => dots = 0,
            _ => {}
        }
        if parts + dots > MOST_PARTS {
            let span = token.span().start()..token.span().end();
            let what = format!("a file may have at most {MOST_PARTS} keys, tables and lists");
            let help = "is it the right file? A list of numbers counts as one, however long";
            return Err(Fault::new(span, what, "one too many", help).unquoted());
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_counted_wherever_they_stand_and_values_are_not() {
        let (many, few) = (MOST_PARTS + 1, MOST_PARTS / 8);
        for part in ["a = 1\n", "[a]\n", "[[a]]\n", "a.", "a.b = 1\n", "[", "{", "a = [[], {}]\n", "= ", "] "] {
            assert!(check(&part.repeat(many)).is_err(), "{part:?}");
            assert!(check(&part.repeat(few)).is_ok(), "{part:?}");
        }
        for value in ["1.5, ", "1.5,\n", "'a = [', ", "# [a] = { a.b.c }\n", "\n", "x", "\"\\\"=\""] {
            let text = format!("a = [{}]\n", value.repeat(many));
            assert!(check(&text).is_ok(), "{value:?}");
        }
    }

    #[test]
    fn the_first_part_too_many_is_named() {
        let text = "[a]\n".repeat(MOST_PARTS);
        let error = check(&text).unwrap_err().located("many.toml", &text).to_string();
        assert_eq!(
            error,
            format!("many.toml:{}:1: a file may have at most 20000 keys, tables and lists", MOST_PARTS / 2 + 1)
        );
    }
}
