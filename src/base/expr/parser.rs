//! Expressions as trees with places.
use super::QRef;
use super::code::Op;
use super::func::Func;
use super::lexer::{Token, lex};
use crate::base::diag::Span;

/// Nesting deeper than this is refused; no formula of a control comes near it.
const MAX_DEPTH: usize = 64;
/// Longer texts are refused, in bytes: the tree of a chain such as `1+1+1` is as deep as the chain is long. Controls
/// allow a few hundred characters.
const MAX_LENGTH: usize = 4096;
/// A chain of operators is a tree as deep as it is long, so its length is limited too.
const MAX_TOKENS: usize = 384;

/// Which language is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// Formulas of NC programs: no comparisons, no names; functions may be written without brackets; decimal comma allowed.
    Program,
    /// Expressions of specifications: the same with names, comparisons, `AND`, `OR`, `NOT`, `IF`, `MIN`, `MAX`.
    Spec,
}

/// An expression and its place in the text it was read from.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub node: Node,
    /// Its place.
    pub span: Span,
}

/// The kinds of expressions.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A number.
    Number(f64),
    /// A text in quotation marks.
    Text(String),
    /// A Q parameter.
    Q(QRef),
    /// A name with its fields: `cut.to` is `["cut", "to"]`.
    Name(Vec<String>),
    /// A sign or `NOT`.
    Unary(Op, Box<Expr>),
    /// Two operands.
    Binary(Op, Box<Expr>, Box<Expr>),
    /// A function.
    Call(Func, Vec<Expr>),
}

/// Why a text is no expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExprError {
    /// Where in the text.
    pub span: Span,
    /// A kebab-case key for what was expected: `operand`, `operator`, `closing-bracket`, `known-function`,
    /// `less-nesting`, `character`, `arguments`, `in-spec-only`.
    pub expected: &'static str,
    /// What is there.
    pub found: String,
}

/// Reads one expression; the whole text must belong to it.
pub fn parse(text: &str, dialect: Dialect) -> Result<Expr, ExprError> {
    if text.len() > MAX_LENGTH {
        return Err(ExprError { span: Span::new(0, text.len()), expected: "less-nesting", found: String::new() });
    }
    let tokens = lex(text, dialect == Dialect::Program).map_err(|span| ExprError {
        span,
        expected: "character",
        found: text.get(span.start..span.end).unwrap_or_default().to_owned(),
    })?;
    let mut parser = Parser { text, tokens, at: 0, depth: 0, dialect };
    if parser.tokens.len() > MAX_TOKENS {
        return Err(parser.expected("less-nesting"));
    }
    let expr = parser.binary(0)?;
    if parser.at < parser.tokens.len() {
        return Err(parser.expected("operator"));
    }
    Ok(expr)
}

struct Parser<'t> {
    text: &'t str,
    tokens: Vec<(Token, Span)>,
    at: usize,
    depth: usize,
    dialect: Dialect,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at).map(|(token, _)| token)
    }

    fn span(&self) -> Span {
        self.tokens.get(self.at).map_or(Span::new(self.text.len(), self.text.len()), |(_, span)| *span)
    }

    fn expected(&self, expected: &'static str) -> ExprError {
        let span = self.span();
        ExprError { span, expected, found: self.text.get(span.start..span.end).unwrap_or_default().to_owned() }
    }

    fn mark(&mut self, mark: &str) -> bool {
        let hit = matches!(self.peek(), Some(Token::Mark(found)) if *found == mark);
        self.at += usize::from(hit);
        hit
    }

    fn operator(&self) -> Option<(Op, u8)> {
        let op = match self.peek()? {
            Token::Mark(mark) => match *mark {
                "+" => (Op::Add, 4),
                "-" => (Op::Sub, 4),
                "*" => (Op::Mul, 5),
                "/" => (Op::Div, 5),
                "%" => (Op::Rem, 5),
                "^" => (Op::Pow, 7),
                "=" => (Op::Eq, 3),
                "<>" => (Op::Ne, 3),
                "<" => (Op::Lt, 3),
                "<=" => (Op::Le, 3),
                ">" => (Op::Gt, 3),
                ">=" => (Op::Ge, 3),
                "||" => (Op::Join, 4),
                _ => return None,
            },
            Token::Word(word) => match word.as_str() {
                "AND" => (Op::And, 2),
                "OR" => (Op::Or, 1),
                _ => return None,
            },
            _ => return None,
        };
        Some(op)
    }

    fn binary(&mut self, least: u8) -> Result<Expr, ExprError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.expected("less-nesting"));
        }
        let mut left = self.unary()?;
        while let Some((op, level)) = self.operator() {
            if level < least {
                break;
            }
            if self.dialect == Dialect::Program && op.spec_only() {
                return Err(self.expected("in-spec-only"));
            }
            self.at += 1;
            let right = self.binary(level + 1)?;
            let span = Span::new(left.span.start, right.span.end);
            left = Expr { node: Node::Binary(op, Box::new(left), Box::new(right)), span };
        }
        self.depth -= 1;
        Ok(left)
    }

    fn unary(&mut self) -> Result<Expr, ExprError> {
        let start = self.span().start;
        if self.mark("+") {
            return self.nested(start, 6, |inner| inner.node);
        }
        if self.mark("-") {
            return self.nested(start, 6, |inner| match inner.node {
                Node::Number(n) => Node::Number(-n),
                node => Node::Unary(Op::Sub, Box::new(Expr { node, span: inner.span })),
            });
        }
        if self.dialect == Dialect::Spec && matches!(self.peek(), Some(Token::Word(w)) if w == "NOT") {
            self.at += 1;
            return self.nested(start, 3, |inner| Node::Unary(Op::Not, Box::new(inner)));
        }
        self.operand()
    }

    /// An operand after a sign or `NOT`: a sign binds weaker than a power and stronger than a product,
    /// `NOT` weaker than a comparison.
    fn nested(&mut self, start: usize, level: u8, wrap: impl FnOnce(Expr) -> Node) -> Result<Expr, ExprError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.expected("less-nesting"));
        }
        let inner = self.binary(level)?;
        self.depth -= 1;
        let span = Span::new(start, inner.span.end);
        Ok(Expr { node: wrap(inner), span })
    }

    fn operand(&mut self) -> Result<Expr, ExprError> {
        let span = self.span();
        let Some(token) = self.peek().cloned() else {
            return Err(self.expected("operand"));
        };
        let node = match token {
            Token::Number(n) => Node::Number(n),
            Token::Text(text) => Node::Text(text),
            Token::Q(q) => Node::Q(q),
            Token::Mark("(") => {
                self.at += 1;
                let inner = self.binary(0)?;
                if !self.mark(")") {
                    return Err(self.expected("closing-bracket"));
                }
                return Ok(inner);
            }
            Token::Word(word) => return self.word(&word, span),
            Token::Mark(_) => return Err(self.expected("operand")),
        };
        self.at += 1;
        Ok(Expr { node, span })
    }

    fn word(&mut self, word: &str, span: Span) -> Result<Expr, ExprError> {
        if word.eq_ignore_ascii_case("PI") {
            self.at += 1;
            return Ok(Expr { node: Node::Number(std::f64::consts::PI), span });
        }
        let is_name = word.starts_with(|c: char| c.is_ascii_lowercase());
        if self.dialect == Dialect::Spec && is_name {
            return self.name(word, span);
        }
        let Some(func) = Func::by_name(&word.to_ascii_uppercase()) else {
            return Err(self.expected("known-function"));
        };
        if self.dialect == Dialect::Program && func.spec_only() {
            return Err(self.expected("in-spec-only"));
        }
        self.at += 1;
        self.call(func, span)
    }

    fn name(&mut self, first: &str, span: Span) -> Result<Expr, ExprError> {
        self.at += 1;
        let mut path = vec![first.to_owned()];
        let mut end = span.end;
        while self.mark(".") {
            end = self.span().end;
            let Some(Token::Word(field)) = self.peek().cloned() else {
                return Err(self.expected("operand"));
            };
            self.at += 1;
            path.push(field);
        }
        Ok(Expr { node: Node::Name(path), span: Span::new(span.start, end) })
    }

    fn call(&mut self, func: Func, span: Span) -> Result<Expr, ExprError> {
        if func.arity() == (1, 1) && !matches!(self.peek(), Some(Token::Mark("("))) {
            // `SIN 30`, `SQRT SQ Q1`: the function takes the next operand, sign included.
            let inner = self.prefix_operand()?;
            let span = Span::new(span.start, inner.span.end);
            return Ok(Expr { node: Node::Call(func, vec![inner]), span });
        }
        if !self.mark("(") {
            return Err(self.expected("operand"));
        }
        let mut args = Vec::new();
        if !self.mark(")") {
            loop {
                args.push(self.binary(0)?);
                if self.mark(",") {
                    continue;
                }
                if self.mark(")") {
                    break;
                }
                return Err(self.expected("closing-bracket"));
            }
        }
        let end = self.tokens.get(self.at.saturating_sub(1)).map_or(span.end, |(_, s)| s.end);
        let span = Span::new(span.start, end);
        let (least, most) = func.arity();
        if args.len() < least || args.len() > most {
            let found = self.text.get(span.start..span.end).unwrap_or_default().to_owned();
            return Err(ExprError { span, expected: "arguments", found });
        }
        Ok(Expr { node: Node::Call(func, args), span })
    }

    fn prefix_operand(&mut self) -> Result<Expr, ExprError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.expected("less-nesting"));
        }
        let start = self.span().start;
        let negative = self.mark("-");
        if !negative {
            self.mark("+");
        }
        let inner = self.operand()?;
        self.depth -= 1;
        if !negative {
            return Ok(inner);
        }
        let span = Span::new(start, inner.span.end);
        Ok(Expr { node: Node::Unary(Op::Sub, Box::new(inner)), span })
    }
}

impl Expr {
    /// Calls `visit` for the expression and all in it.
    pub fn walk(&self, visit: &mut dyn FnMut(&Expr)) {
        visit(self);
        match &self.node {
            Node::Unary(_, a) => a.walk(visit),
            Node::Binary(_, a, b) => {
                a.walk(visit);
                b.walk(visit);
            }
            Node::Call(_, args) => args.iter().for_each(|arg| arg.walk(visit)),
            Node::Number(_) | Node::Text(_) | Node::Q(_) | Node::Name(_) => {}
        }
    }

    /// The Q parameters in it, in reading order, with repetitions.
    pub fn q_refs(&self) -> Vec<QRef> {
        let mut found = Vec::new();
        self.walk(&mut |expr| {
            if let Node::Q(q) = expr.node {
                found.push(q);
            }
        });
        found
    }
}
