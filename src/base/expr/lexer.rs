//! The lexemes of expressions.
use nom::branch::alt;
use nom::bytes::complete::{tag, take_while, take_while1};
use nom::character::complete::{char, one_of};
use nom::combinator::{map, opt, recognize};
use nom::{IResult, Parser};

use super::{Func, QRef};
use crate::base::diag::Span;

/// A lexeme.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Number(f64),
    Text(String),
    Q(QRef),
    /// A word: function, constant, keyword or name.
    Word(String),
    /// An operator or a punctuation mark.
    Mark(&'static str),
}

const MARKS: [&str; 17] = ["<>", "<=", ">=", "||", "+", "-", "*", "/", "^", "%", "(", ")", ",", "=", "<", ">", "."];

fn number(input: &str) -> IResult<&str, Token> {
    let digits = || take_while(|c: char| c.is_ascii_digit());
    let whole = recognize((take_while1(|c: char| c.is_ascii_digit()), opt((one_of(".,"), digits()))));
    let fraction = recognize((one_of(".,"), take_while1(|c: char| c.is_ascii_digit())));
    map(alt((whole, fraction)), |text: &str| Token::Number(text.replace(',', ".").parse().unwrap_or(f64::NAN)))
        .parse(input)
}

/// In specifications a comma separates arguments, so numbers there take a point only.
fn point_number(input: &str) -> IResult<&str, Token> {
    let whole = recognize((
        take_while1(|c: char| c.is_ascii_digit()),
        opt((char('.'), take_while(|c: char| c.is_ascii_digit()))),
    ));
    map(whole, |text: &str| Token::Number(text.parse().unwrap_or(f64::NAN))).parse(input)
}

fn text(input: &str) -> IResult<&str, Token> {
    let (rest, (_, inside, _)) = (char('"'), take_while(|c| c != '"'), char('"')).parse(input)?;
    Ok((rest, Token::Text(inside.to_owned())))
}

fn word(input: &str) -> IResult<&str, Token> {
    let (rest, found) = take_while1(|c: char| c.is_ascii_alphanumeric() || c == '_').parse(input)?;
    Ok((rest, QRef::parse(found).map_or_else(|| Token::Word(found.to_owned()), Token::Q)))
}

/// A function with its operand directly after it, `SIN30` or `COSQ2`: the function.
fn closed_up(input: &str) -> IResult<&str, Token> {
    let (_, letters) = take_while1(|c: char| c.is_ascii_alphabetic()).parse(input)?;
    let digit = input.get(letters.len()..).is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    let kinds = ["", "Q", "QL", "QR", "q", "ql", "qr"];
    let function = |kind: &str| {
        let name = letters.strip_suffix(kind)?;
        let takes_one = |func: &Func| func.arity() == (1, 1) && !func.spec_only();
        Func::by_name(&name.to_ascii_uppercase()).filter(takes_one).map(|_| name)
    };
    match kinds.into_iter().find_map(function).filter(|_| digit && QRef::parse(input).is_none()) {
        Some(name) => Ok((input.get(name.len()..).unwrap_or_default(), Token::Word(name.to_owned()))),
        None => Err(nom::Err::Error(nom::error::Error::new(input, nom::error::ErrorKind::Alpha))),
    }
}

fn mark(input: &str) -> IResult<&str, Token> {
    for candidate in MARKS {
        if let Ok((rest, _)) = tag::<_, _, nom::error::Error<&str>>(candidate)(input) {
            return Ok((rest, Token::Mark(candidate)));
        }
    }
    Err(nom::Err::Error(nom::error::Error::new(input, nom::error::ErrorKind::Tag)))
}

/// All lexemes with their places; on failure the place of the character that starts none.
pub(super) fn lex(input: &str, comma_decimal: bool) -> Result<Vec<(Token, Span)>, Span> {
    let mut tokens = Vec::new();
    let mut rest = input.trim_start();
    while !rest.is_empty() {
        let start = input.len() - rest.len();
        let one = if comma_decimal {
            alt((number, text, closed_up, word, mark)).parse(rest)
        } else {
            alt((point_number, text, word, mark)).parse(rest)
        };
        let Ok((after, token)) = one else {
            let width = rest.chars().next().map_or(1, char::len_utf8);
            return Err(Span::new(start, start + width));
        };
        tokens.push((token, Span::new(start, input.len() - after.len())));
        rest = after.trim_start();
    }
    Ok(tokens)
}
