//! Statements and comments.

/// A line number from 1 on, and what was found there.
type Found = (usize, String);

/// The statements of a file, each with the line of its first character, without comments and `testcase … { }`.
///
/// # Errors
/// The line and the reason, if a comment, a text or a statement does not end.
pub fn statements(text: &str) -> Result<Vec<Found>, Found> {
    let text = without_comments(text)?;
    let mut found = Vec::new();
    let mut line = 1;
    let (mut start, mut statement, mut quoted) = (1, String::new(), false);
    for c in text.chars() {
        quoted ^= c == '"';
        let heads = statement.trim_start().starts_with("testcase");
        match c {
            _ if quoted => statement.push(c),
            ';' => found.push((start, std::mem::take(&mut statement).trim().to_owned())),
            '{' if heads => statement.clear(),
            '}' if statement.trim().is_empty() => {}
            _ => {
                if statement.trim().is_empty() && !c.is_whitespace() {
                    statement.clear();
                    start = line;
                }
                statement.push(c);
            }
        }
        line += usize::from(c == '\n');
    }
    let rest = statement.trim();
    if rest.is_empty() {
        Ok(found)
    } else {
        Err((start, format!("`{rest}` does not end in `;`")))
    }
}

/// The text with blanks for comments; line breaks stay.
fn without_comments(text: &str) -> Result<String, Found> {
    let mut out = String::with_capacity(text.len());
    let mut line = 1;
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let (length, keep) = if let Some(inner) = rest.strip_prefix("/*") {
            let end = inner
                .find("*/")
                .ok_or_else(|| (line, "a comment does not end".to_owned()))?;
            (end + 4, false)
        } else if rest.starts_with("//") {
            (rest.find('\n').unwrap_or(rest.len()), false)
        } else if let Some(inner) = rest.strip_prefix('"') {
            let end = inner
                .find('"')
                .ok_or_else(|| (line, "a text does not end".to_owned()))?;
            (end + 2, true)
        } else {
            (c.len_utf8(), true)
        };
        let (piece, after) = rest.split_at(length);
        if keep {
            out.push_str(piece);
        } else {
            out.push(' ');
            out.extend(piece.chars().filter(|&c| c == '\n'));
        }
        line += piece.matches('\n').count();
        rest = after;
    }
    Ok(out)
}

/// The parts before and after the first `mark` that is in no text.
pub fn split_outside(text: &str, mark: char) -> Option<(&str, &str)> {
    let mut quoted = false;
    for (i, c) in text.char_indices() {
        quoted ^= c == '"';
        if c == mark && !quoted {
            return Some((&text[..i], &text[i + c.len_utf8()..]));
        }
    }
    None
}
