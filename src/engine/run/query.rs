//! `SELECT` statements of SQL blocks: which columns of which rows, in which order.
//!
//! `SELECT A, B FROM TAB WHERE A > 3 AND NOT B = 'x' ORDER BY A DESC FOR UPDATE`. Values of parameters are put in before
//! (`:'Q2'`). Invariant: a statement that is not of this form is a mistake with the word at which reading ended; rows are
//! not known here.
use std::cmp::Ordering;

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Query {
    /// The names of the columns; none for all of them (`*`).
    pub(super) columns: Vec<String>,
    /// The table as it is written.
    pub(super) table: String,
    pub(super) condition: Option<Condition>,
    /// Columns by which rows are ordered, and whether downwards.
    pub(super) order: Vec<(String, bool)>,
}

/// What a row must fulfil.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Condition {
    Compared(String, Relation, Operand),
    IsEmpty(String),
    Not(Box<Self>),
    All(Vec<Self>),
    Any(Vec<Self>),
}

/// How a cell is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Relation {
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

impl Relation {
    /// Whether it holds for that order.
    pub(super) fn holds(self, order: Ordering) -> bool {
        match self {
            Self::Equal => order == Ordering::Equal,
            Self::NotEqual => order != Ordering::Equal,
            Self::Less => order == Ordering::Less,
            Self::LessOrEqual => order != Ordering::Greater,
            Self::Greater => order == Ordering::Greater,
            Self::GreaterOrEqual => order != Ordering::Less,
        }
    }
}

/// With what a cell is compared.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Operand {
    Number(f64),
    Text(String),
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Word(String),
    Number(f64),
    Text(String),
    Sign(&'static str),
}

const SIGNS: [&str; 12] = ["<=", ">=", "<>", "!=", "==", "=", "<", ">", ",", "(", ")", "*"];

/// How deep conditions may be nested.
const DEEPEST: usize = 20;

/// Reads a statement.
///
/// # Errors
/// The word at which it is no such statement any more.
pub(super) fn read(text: &str) -> Result<Query, String> {
    let mut reader = Reader { tokens: tokens(text)?, at: 0 };
    reader.word("SELECT")?;
    let mut columns = Vec::new();
    if !reader.opt_sign("*") {
        columns = reader.names()?;
    }
    reader.word("FROM")?;
    let table = match reader.next() {
        Some(Token::Word(name) | Token::Text(name)) => name,
        other => return Err(shown(other.as_ref())),
    };
    let condition = if reader.opt_word("WHERE") { Some(reader.any(0)?) } else { None };
    let mut order = Vec::new();
    if reader.opt_word("ORDER") {
        reader.word("BY")?;
        loop {
            let name = reader.name()?;
            let down = reader.opt_word("DESC");
            if !down {
                reader.opt_word("ASC");
            }
            order.push((name, down));
            if !reader.opt_sign(",") {
                break;
            }
        }
    }
    if reader.opt_word("FOR") {
        reader.word("UPDATE")?;
    }
    match reader.next() {
        None => Ok(Query { columns, table, condition, order }),
        rest => Err(shown(rest.as_ref())),
    }
}

fn shown(token: Option<&Token>) -> String {
    match token {
        None => String::new(),
        Some(Token::Word(word)) => word.clone(),
        Some(Token::Number(number)) => number.to_string(),
        Some(Token::Text(text)) => format!("'{text}'"),
        Some(Token::Sign(sign)) => (*sign).to_owned(),
    }
}

fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let (mut tokens, mut rest) = (Vec::new(), text.trim_start());
    while let Some(first) = rest.chars().next() {
        let (token, length) = if let Some(inner) = rest.strip_prefix('\'') {
            let end = inner.find('\'').ok_or_else(|| rest.to_owned())?;
            (Token::Text(inner.get(..end).unwrap_or_default().to_owned()), end + 2)
        } else if let Some(sign) = SIGNS.iter().find(|sign| rest.starts_with(**sign)) {
            (Token::Sign(sign), sign.len())
        } else {
            // Names of tables have points, those of columns and files hyphens, numbers both.
            let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '-' | '+' | '\\' | ':');
            let length = rest.find(|c: char| !is_part(c)).unwrap_or(rest.len());
            if length == 0 {
                return Err(first.to_string());
            }
            let word = rest.get(..length).unwrap_or_default();
            let number = word.parse::<f64>().ok().filter(|_| !word.starts_with(char::is_alphabetic));
            (number.map_or_else(|| Token::Word(word.to_owned()), Token::Number), length)
        };
        tokens.push(token);
        rest = rest.get(length..).unwrap_or_default().trim_start();
    }
    Ok(tokens)
}

struct Reader {
    tokens: Vec<Token>,
    at: usize,
}

impl Reader {
    fn next(&mut self) -> Option<Token> {
        let token = self.tokens.get(self.at).cloned();
        self.at += 1;
        token
    }

    fn opt_word(&mut self, word: &str) -> bool {
        let found = matches!(self.tokens.get(self.at), Some(Token::Word(own)) if own.eq_ignore_ascii_case(word));
        self.at += usize::from(found);
        found
    }

    fn opt_sign(&mut self, sign: &str) -> bool {
        let found = matches!(self.tokens.get(self.at), Some(Token::Sign(own)) if *own == sign);
        self.at += usize::from(found);
        found
    }

    fn word(&mut self, word: &str) -> Result<(), String> {
        if self.opt_word(word) { Ok(()) } else { Err(shown(self.tokens.get(self.at))) }
    }

    /// The name of a column, without that of its table.
    fn name(&mut self) -> Result<String, String> {
        match self.next() {
            Some(Token::Word(name)) => Ok(name.rsplit('.').next().unwrap_or_default().to_owned()),
            other => Err(shown(other.as_ref())),
        }
    }

    fn names(&mut self) -> Result<Vec<String>, String> {
        let mut names = vec![self.name()?];
        while self.opt_sign(",") {
            names.push(self.name()?);
        }
        Ok(names)
    }

    fn any(&mut self, depth: usize) -> Result<Condition, String> {
        let mut parts = vec![self.all(depth)?];
        while self.opt_word("OR") {
            parts.push(self.all(depth)?);
        }
        Ok(Condition::Any(parts))
    }

    fn all(&mut self, depth: usize) -> Result<Condition, String> {
        let mut parts = vec![self.one(depth)?];
        while self.opt_word("AND") {
            parts.push(self.one(depth)?);
        }
        Ok(Condition::All(parts))
    }

    fn one(&mut self, depth: usize) -> Result<Condition, String> {
        if depth > DEEPEST {
            return Err(shown(self.tokens.get(self.at)));
        }
        if self.opt_word("NOT") {
            return Ok(Condition::Not(Box::new(self.one(depth + 1)?)));
        }
        if self.opt_sign("(") {
            let inner = self.any(depth + 1)?;
            return if self.opt_sign(")") { Ok(inner) } else { Err(shown(self.tokens.get(self.at))) };
        }
        let column = self.name()?;
        if self.opt_word("IS") {
            let not = self.opt_word("NOT");
            self.word("NULL")?;
            let empty = Condition::IsEmpty(column);
            return Ok(if not { Condition::Not(Box::new(empty)) } else { empty });
        }
        let relation = match self.next() {
            Some(Token::Sign("=" | "==")) => Relation::Equal,
            Some(Token::Sign("<>" | "!=")) => Relation::NotEqual,
            Some(Token::Sign("<")) => Relation::Less,
            Some(Token::Sign("<=")) => Relation::LessOrEqual,
            Some(Token::Sign(">")) => Relation::Greater,
            Some(Token::Sign(">=")) => Relation::GreaterOrEqual,
            other => return Err(shown(other.as_ref())),
        };
        match self.next() {
            Some(Token::Number(number)) => Ok(Condition::Compared(column, relation, Operand::Number(number))),
            Some(Token::Text(text)) => Ok(Condition::Compared(column, relation, Operand::Text(text))),
            other => Err(shown(other.as_ref())),
        }
    }
}
