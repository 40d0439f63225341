//! What a block is, by itself: its text, its M functions, whether the program ends with it, the parameters that it reads.
use crate::base::diag::Span;
use crate::base::expr::{Node, Op, QRef};
use crate::program::syntax::{
    Amount, Block, BlockKind, CallForm, CycleKeyword, Feed, FeedKind, FnOp, Label, MFunction, Motion, Operand, Path,
    Program, Relation, StatementKind, ToolRef, ValueKind,
};

/// What the first line of a block says, without its number and the blanks around it.
pub(in crate::check) fn content(program: &Program, block: &Block) -> Span {
    let text = program.slice(block.span);
    let line = text.split(['\n', '\r']).next().unwrap_or_default();
    let mut from = line.len() - line.trim_start_matches(['/', ' ', '\t']).len();
    if block.number.is_some() {
        let rest = line.get(from..).unwrap_or_default();
        let rest = rest.trim_start_matches(['N', 'n']).trim_start_matches(|c: char| c.is_ascii_digit());
        from = line.len() - rest.trim_start_matches(['/', ' ', '\t']).len();
    }
    let end = line.trim_end().len().max(from);
    Span::new(block.span.start + from, block.span.start + end)
}

/// Whether a block is a comment or blank.
pub(in crate::check) fn is_silent(block: &Block) -> bool {
    matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_))
}

/// The numbers of a block's M functions, in the order written.
pub(in crate::check) fn each_function(block: &Block, mut each: impl FnMut(u16)) {
    match &block.kind {
        BlockKind::Motion(motion) => motion.each_function(each),
        BlockKind::Functions(list) | BlockKind::Stop(list) => list.iter().for_each(|own| each(own.number)),
        BlockKind::CyclCall(call) => call.functions.iter().for_each(|own| each(own.number)),
        _ => {}
    }
}

/// Whether the program ends with the block.
pub(in crate::check) fn stops(block: &Block) -> bool {
    if matches!(&block.kind, BlockKind::Motion(motion) if !motion.has_functions()) {
        return false;
    }
    let mut ends = matches!(block.kind, BlockKind::EndPgm(_));
    each_function(block, |number| ends |= matches!(number, 2 | 30));
    ends
}

/// Whether a block moves at the feed that was programmed before it.
pub(in crate::check) fn needs_feed(block: &Block) -> bool {
    let BlockKind::Motion(motion) = &block.kind else { return false };
    let moves = !matches!(motion.path(), Path::Cc | Path::Fpol) && motion.outline().has_coords();
    moves && !motion.outline().has_feed() && !motion.outline().is_rapid()
}

/// The parameter that a block calculates, and its place.
pub(in crate::check) fn assigned(block: &Block) -> Option<(QRef, Span)> {
    match &block.kind {
        BlockKind::FnAssign(own) => Some((own.target, own.target_span)),
        BlockKind::Formula(own) => Some((own.target, own.target_span)),
        _ => None,
    }
}

/// The number that a block gives a parameter.
pub(in crate::check) fn constant(block: &Block) -> Option<(QRef, f64)> {
    match &block.kind {
        BlockKind::FnAssign(own) => match (own.op, own.a.amount) {
            (FnOp::Set, Amount::Number(number)) => Some((own.target, number)),
            _ => None,
        },
        BlockKind::Formula(own) => match &own.expr.node {
            Node::Number(number) => Some((own.target, *number)),
            Node::Unary(Op::Sub, inner) => match inner.node {
                Node::Number(number) => Some((own.target, -number)),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}

/// The words that a block says beside its code: its comment, or all of a heading.
pub(in crate::check) fn remark(block: &Block) -> Option<Span> {
    match block.kind {
        BlockKind::Structure(_) => Some(block.comment().unwrap_or(block.span)),
        _ => block.comment(),
    }
}

/// The parameter that a block does nothing with but copy it.
pub(in crate::check) fn copied(block: &Block) -> Option<QRef> {
    match &block.kind {
        BlockKind::FnAssign(own) if own.op == FnOp::Set => match own.a.amount {
            Amount::Q { q, negative: false } => Some(q),
            _ => None,
        },
        BlockKind::Formula(own) => match own.expr.node {
            Node::Q(q) => Some(q),
            _ => None,
        },
        _ => None,
    }
}

/// The parameters that a block reads, with their places.
pub(in crate::check) fn reads(block: &Block, found: &mut Vec<(QRef, Span)>) {
    let operand = |operand: &Operand, found: &mut Vec<_>| {
        if let Amount::Q { q, .. } = operand.amount {
            found.push((q, operand.span));
        }
    };
    match &block.kind {
        BlockKind::Motion(motion) if motion.outline().has_parameters() => {
            let motion = motion.words();
            motion.coords.iter().for_each(|coord| operand(&coord.value, found));
            motion.radius.iter().for_each(|radius| operand(radius, found));
            motion.feed.iter().for_each(|feed| feed_reads(feed, found));
        }
        BlockKind::CyclCall(call) => {
            if let CallForm::Position(coords) = &call.form {
                coords.iter().for_each(|coord| operand(&coord.value, found));
            }
        }
        BlockKind::FnAssign(assign) => {
            operand(&assign.a, found);
            assign.b.iter().for_each(|b| operand(b, found));
        }
        BlockKind::FnJump(jump) if !matches!(jump.relation, Relation::Undefined | Relation::Defined) => {
            operand(&jump.a, found);
            operand(&jump.b, found);
        }
        BlockKind::Formula(formula) => {
            formula.expr.walk(&mut |expr| {
                if let Node::Q(q) = expr.node {
                    let start = formula.text.start;
                    found.push((q, Span::new(start + expr.span.start, start + expr.span.end)));
                }
            });
        }
        BlockKind::TextFormula(formula) => {
            for word in formula.calls.iter().flat_map(|call| &call.words) {
                if let ValueKind::Q { q, .. } = word.value.kind {
                    found.push((q, word.value.span));
                }
            }
        }
        BlockKind::CallLbl(call) => {
            if let Label::Q(q) = call.label.target {
                found.push((q, call.label.span));
            }
            call.repeat.iter().for_each(|times| operand(times, found));
        }
        BlockKind::ToolCall(call) => {
            if let Some(ToolRef::Number(number)) = &call.tool {
                operand(number, found);
            }
            [&call.speed, &call.cutting_speed, &call.dl, &call.dr]
                .into_iter()
                .flatten()
                .for_each(|own| operand(own, found));
            call.feed.iter().for_each(|feed| feed_reads(feed, found));
        }
        BlockKind::CycleDef(cycle) => {
            let mut any = false;
            cycle.parameters.each_value(|_, value| any |= matches!(value, ValueKind::Q { .. }));
            for parameter in cycle.parameters.iter().take_while(|_| any) {
                if let ValueKind::Q { q, .. } = parameter.value.kind {
                    found.push((q, parameter.value.span));
                }
            }
        }
        BlockKind::OldCycleLine(line) if line.keyword == CycleKeyword::CyclDef => {
            for word in &line.words {
                if let ValueKind::Q { q, .. } = word.value.kind {
                    found.push((q, word.value.span));
                }
            }
        }
        BlockKind::Statement(own) if matches!(own.kind, StatementKind::Plane | StatementKind::Trans) => {
            for word in &own.words {
                if let ValueKind::Q { q, .. } = word.value.kind {
                    found.push((q, word.value.span));
                }
            }
        }
        BlockKind::PatternDef(pattern) => {
            for word in pattern.items.iter().flat_map(|item| &item.words) {
                if let ValueKind::Q { q, .. } = word.value.kind {
                    found.push((q, word.value.span));
                }
            }
        }
        _ => {}
    }
}

fn feed_reads(feed: &Feed, found: &mut Vec<(QRef, Span)>) {
    if let FeedKind::Value(operand) | FeedKind::PerRevolution(operand) | FeedKind::PerTooth(operand) = &feed.kind
        && let Amount::Q { q, .. } = operand.amount
    {
        found.push((q, operand.span));
    }
}

/// The places where a block calls a cycle.
pub(in crate::check) fn calls_in(block: &Block, words: &mut Motion, found: &mut Vec<Span>) {
    let calls = |own: &MFunction| matches!(own.number, 89 | 99);
    let mut any = false;
    each_function(block, |number| any |= matches!(number, 89 | 99));
    if let BlockKind::CyclCall(call) = &block.kind {
        found.push(call.head);
    }
    match &block.kind {
        _ if !any => {}
        BlockKind::Motion(motion) => {
            if let Some((_, span)) = motion.last_function() {
                found.push(span);
                return;
            }
            motion.read_into(words);
            found.extend(words.functions.iter().filter(|own| calls(own)).map(|own| own.span));
        }
        BlockKind::Functions(list) | BlockKind::Stop(list) => {
            found.extend(list.iter().filter(|own| calls(own)).map(|own| own.span));
        }
        BlockKind::CyclCall(call) => {
            found.extend(call.functions.iter().filter(|own| calls(own)).map(|own| own.span));
        }
        _ => {}
    }
}
